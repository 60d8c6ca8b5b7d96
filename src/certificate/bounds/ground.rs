//! The foundation as an enclosure: Taylor polynomials on cells, every kind of profile alike.

use super::polynomial::{Polynomial, TERMS, number};
use super::taylor::{of_cosine, of_polynomial};
use crate::certificate::interval::Interval;
use crate::scene::Foundation;

/// The foundation of a scene, ready to be asked for enclosures.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ground<'a> {
    pub(super) foundation: &'a Foundation,
    length: f64,
    /// Depths at the supports where they are zero but for rounding; a straight line through them is taken off the
    /// foundation, which makes it level with these supports.
    level: [Option<Interval>; 2],
}

/// Cells on the whole beam, at most, for foundations that are no polyline: shorter waves get wider enclosures instead.
const MOST_CELLS: f64 = 1e5;
/// Cells in a wave: Taylor's remainder is then `(2π/32)^10 / 10! < 3e-14` of the amplitude.
const CELLS_IN_A_WAVE: f64 = 32.0;
/// Cells on the beam for a polynomial that has more coefficients than are kept.
const CELLS_OF_A_LONG_POLYNOMIAL: f64 = 256.0;

impl<'a> Ground<'a> {
    pub(super) fn on(foundation: &'a Foundation, length: f64) -> Self {
        let given = Self { foundation, length, level: [None; 2] };
        if matches!(foundation, Foundation::Flat { .. } | Foundation::Polyline { .. }) {
            return given;
        }
        let level = [0.0, length].map(|x| {
            let nothing = foundation.level_within(x, length);
            Some(given.cell(x, x).at(Interval::ZERO)).filter(|u| u.lo() <= nothing && -nothing <= u.hi())
        });
        Self { level, ..given }
    }

    /// Takes off the line that makes the foundation level with supports; `taylor` is about `x`.
    fn levelled(&self, taylor: &Polynomial, x: f64) -> Polynomial {
        let [left, right] = self.level;
        if left.is_none() && right.is_none() {
            return *taylor;
        }
        let [a, b] = [left, right].map(|u| u.unwrap_or(Interval::ZERO));
        let slope = (b - a) / Interval::exact(self.length);
        let mut levelled = taylor.minus(&Polynomial::new(&[a + slope * Interval::exact(x), slope]));
        // What is taken off at a support is its own depth.
        if (left.is_some() && x <= 0.0) || (right.is_some() && self.length <= x) {
            levelled = levelled.vanishing(1);
        }
        levelled
    }

    /// Ends of cells strictly between two places.
    pub(super) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let steps = |step: f64| {
            let step = step.max(self.length / MOST_CELLS);
            let first = (from / step).floor() + 1.0;
            (0..)
                .map(move |k| (first + f64::from(k)) * step)
                .skip_while(move |x| *x <= from)
                .take_while(move |x| *x < to)
        };
        match self.foundation {
            Foundation::Flat { .. } => Vec::new(),
            Foundation::Polynomial { coefficients } if coefficients.len() <= TERMS => Vec::new(),
            Foundation::Polynomial { .. } => steps(self.length / CELLS_OF_A_LONG_POLYNOMIAL).collect(),
            Foundation::Cosine { wavelength, .. } => steps(wavelength / CELLS_IN_A_WAVE).collect(),
            Foundation::Polyline { points } => {
                let first = points.partition_point(|p| p[0] <= from);
                let inside = points[first..].iter().map(|p| p[0]).take_while(|x| *x < to);
                let mut breaks: Vec<f64> = inside.collect();
                breaks.dedup();
                breaks
            }
        }
    }

    /// `u(origin + s)` between two places without a break between them.
    fn about(&self, origin: f64, [from, to]: [f64; 2]) -> Polynomial {
        match self.foundation {
            Foundation::Flat { depth } => Polynomial::new(&[Interval::exact(*depth)]),
            Foundation::Polynomial { coefficients } => {
                self.levelled(&of_polynomial(coefficients, origin, [from, to]), origin)
            }
            Foundation::Cosine { mean, amplitude, wavelength, phase } => {
                self.levelled(&of_cosine([*mean, *amplitude, *wavelength, *phase], origin), origin)
            }
            Foundation::Polyline { points } => segment(points, from, origin),
        }
    }

    /// `u(from + s)` for `0 ≤ s ≤ to − from`.
    pub(super) fn cell(&self, from: f64, to: f64) -> Polynomial {
        self.about(from, [from, to])
    }

    /// `u(to − s)` for `0 ≤ s ≤ to − from`.
    pub(super) fn mirrored_cell(&self, from: f64, to: f64) -> Polynomial {
        self.about(to, [from, to]).mirrored()
    }

    /// The depth and its first three derivatives at a place, at a point of a polyline on one of its sides.
    pub(super) fn jet(&self, x: f64, from_the_left: bool) -> [Interval; 4] {
        let cell = self.about(x, [if from_the_left { x.next_down() } else { x }, x]);
        let c = |j: usize| cell.coefficients().get(j).copied().unwrap_or(Interval::ZERO);
        [c(0), c(1), c(2) * number(2), c(3) * number(6)]
    }

    /// `u(x)`, at a step the smaller of the two depths.
    pub(super) fn depth(&self, x: f64) -> Interval {
        if let Foundation::Polyline { points } = self.foundation {
            let (first, beyond) = (points.partition_point(|p| p[0] < x), points.partition_point(|p| p[0] <= x));
            if let Some(&[_, depth]) = points[first..beyond].iter().min_by(|a, b| a[1].total_cmp(&b[1])) {
                return Interval::exact(depth);
            }
        }
        self.jet(x, false)[0]
    }

    /// False at the points of a polyline.
    pub(super) fn is_smooth_at(&self, x: f64) -> bool {
        match self.foundation {
            Foundation::Polyline { points } => points.binary_search_by(|p| p[0].total_cmp(&x)).is_err(),
            _ => true,
        }
    }

    /// True if the foundation is one smooth curve between two places: for a polyline, if it has no point there, or only
    /// points at one level.
    pub(super) fn is_smooth_between(&self, from: f64, to: f64) -> bool {
        let Foundation::Polyline { points } = self.foundation else { return true };
        let first = points.partition_point(|p| p[0] <= from).clamp(1, points.len()) - 1;
        let beyond = (points.partition_point(|p| p[0] < to) + 1).min(points.len());
        // A wrong witness may ask for places that are not in order.
        let Some(part) = points.get(first..beyond) else { return false };
        part.len() <= 2 || part.windows(2).all(|w| (w[0][1] - w[1][1]).abs() <= 0.0)
    }

    /// The depth just beside a point of a polyline; [`None`] where nothing happens.
    pub(super) fn side(&self, x: f64, from_the_left: bool) -> Option<f64> {
        let Foundation::Polyline { points } = self.foundation else { return None };
        let (first, beyond) = (points.partition_point(|p| p[0] < x), points.partition_point(|p| p[0] <= x));
        let here = &points[first..beyond];
        let point = if from_the_left { here.first() } else { here.last() };
        point.map(|p| p[1])
    }
}

/// The segment of a polyline that begins at a place or goes through it, about an origin on it.
#[expect(clippy::float_cmp, reason = "the depth of a given point is known without rounding, and at no other place")]
fn segment(points: &[[f64; 2]], from: f64, origin: f64) -> Polynomial {
    let after = points.partition_point(|p| p[0] <= from).clamp(1, points.len() - 1);
    let [left, right] = [points[after - 1], points[after]];
    let [[x, u], [end, depth]] = [left, right].map(|p| p.map(Interval::exact));
    let slope = (depth - u) / (end - x);
    // What is given is known without rounding: the points, and a level stretch.
    if (right[1] - left[1]).abs() <= 0.0 {
        return Polynomial::new(&[u]);
    }
    let value = if origin == left[0] {
        u
    } else if origin == right[0] {
        depth
    } else {
        u + slope * (Interval::exact(origin) - x)
    };
    Polynomial::new(&[value, slope])
}

#[cfg(test)]
mod tests;
