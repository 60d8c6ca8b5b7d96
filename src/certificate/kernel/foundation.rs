//! The enclosed foundation: Taylor polynomials on cells, for every kind of profile.

use super::interval::Interval;
use super::polynomial::{Polynomial, TERMS, expanded, number};
use crate::scene::Foundation;
use crate::scene::polynomial::used;

/// The foundation of a scene or the initial shape of its beam, from which enclosures can be computed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedFoundation<'a> {
    pub(crate) given: &'a Foundation,
    pub(crate) length: f64,
    /// Compression-only supports above the profile, from left to right. Each is stored as three points of a polyline at one position:
    /// the middle one is the support, and the two others are infinitely deep. They are not part of any cell.
    pub(crate) bearings: &'a [[f64; 2]],
}

/// Largest number of cells on the whole beam, for cosine profiles; shorter waves get wider enclosures instead.
const MOST_CELLS: f64 = 1e5;
/// Cells in a wave: Taylor's remainder is then `(2π/32)^10 / 10! < 3e-14` of the amplitude.
const CELLS_IN_A_WAVE: f64 = 32.0;
/// The points strictly between two positions; `points` is sorted from left to right.
pub(crate) fn inside(points: &[[f64; 2]], from: f64, to: f64) -> &[[f64; 2]] {
    points.get(points.partition_point(|p| p[0] <= from)..points.partition_point(|p| p[0] < to)).unwrap_or_default()
}

impl<'a> EnclosedFoundation<'a> {
    /// Ends of cells strictly between two positions; the position of a step occurs twice.
    pub(crate) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        match self.given {
            Foundation::Flat { .. } | Foundation::Polynomial { .. } => Vec::new(),
            Foundation::Cosine { wavelength, .. } => {
                let step = (wavelength / CELLS_IN_A_WAVE).max(self.length / MOST_CELLS);
                let steps = (0..).map(|k| ((from / step).floor() + f64::from(k)) * step);
                steps.skip_while(|x| *x <= from).take_while(|x| *x < to).collect()
            }
            Foundation::Polyline { points } => inside(points, from, to).iter().map(|p| p[0]).collect(),
        }
    }

    /// A lower bound of the depth between two positions, found without examining each cell; minus infinity for a cosine or polynomial.
    pub(crate) fn least(&self, from: f64, to: f64) -> f64 {
        let [bearings, points] = self.points();
        // The selection includes the far ends of the segments that contain the two positions.
        let first = points.partition_point(|p| p[0] <= from).saturating_sub(1);
        let about = points.get(first..points.len().min(points.partition_point(|p| p[0] < to) + 1)).unwrap_or_default();
        let depths = about.iter().chain(inside(bearings, from.next_down(), to.next_up())).map(|p| p[1]);
        let ground = if points.is_empty() { self.level().unwrap_or(f64::NEG_INFINITY) } else { f64::INFINITY };
        depths.fold(ground, f64::min)
    }

    /// The depth, if it is the same everywhere.
    pub(crate) fn level(&self) -> Option<f64> {
        if let Foundation::Flat { depth } = self.given { Some(*depth) } else { None }
    }

    /// `u(origin + s)` from a position up to the next break; the origin is within this interval.
    pub(crate) fn about(&self, origin: f64, from: f64) -> Polynomial {
        match self.given {
            Foundation::Flat { depth } => Polynomial::new(&[Interval::exact(*depth)]),
            Foundation::Polynomial { coefficients } => Polynomial::new(&expanded(used(coefficients), origin)),
            Foundation::Cosine { mean, amplitude, wavelength, phase } => {
                of_cosine([*mean, *amplitude, *wavelength, *phase], origin)
            }
            Foundation::Polyline { points } => segment(points, from, origin),
        }
    }

    /// The depth and its first three derivatives at a position; at a point of a polyline on the given side.
    pub(crate) fn jet(&self, x: f64, from_the_left: bool) -> [Interval; 4] {
        // At a smooth position both sides give the same result, to the last bit.
        let beside = if from_the_left && !self.is_smooth_at(x) { x.next_down() } else { x };
        let cell = self.about(x, beside);
        let c = |j: usize| cell.coefficients().get(j).copied().unwrap_or(Interval::ZERO);
        [c(0), c(1), c(2) * number(2), c(3) * number(6)]
    }

    /// `u(x)`, at a step the smaller of the two depths.
    pub(crate) fn depth(&self, x: f64) -> Interval {
        let higher = self.points_at(x).iter().min_by(|a, b| a[1].total_cmp(&b[1]));
        higher.map_or_else(|| self.jet(x, false)[0], |point| Interval::exact(point[1]))
    }

    /// False at the points of a polyline, and at a support that stands alone.
    pub(crate) fn is_smooth_at(&self, x: f64) -> bool {
        self.points_at(x).is_empty()
    }

    /// True if the foundation is one smooth curve between two positions: it contains no point of a polyline and no support that stands
    /// alone.
    pub(crate) fn is_smooth_between(&self, from: f64, to: f64) -> bool {
        // A wrong candidate contact list may contain positions that are not in order.
        from < to && self.points().iter().all(|points| inside(points, from, to).is_empty())
    }

    /// False next to a position that is the foot of a step.
    pub(crate) fn is_upper(&self, x: f64, from_the_left: bool) -> bool {
        let here = self.points_at(x);
        let beside = if from_the_left { here.first() } else { here.last() };
        beside.is_none_or(|beside| here.iter().all(|point| beside[1] <= point[1]))
    }

    /// The supports that stand alone, and the points of a polyline.
    fn points(&self) -> [&'a [[f64; 2]]; 2] {
        [self.bearings, if let Foundation::Polyline { points } = self.given { points } else { &[] }]
    }

    /// The points at a position: one at a vertex of a polyline, two at a step, three at a support that stands alone.
    pub(crate) fn points_at(&self, x: f64) -> &'a [[f64; 2]] {
        let here = self.points().map(|points| inside(points, x.next_down(), x.next_up()));
        here.into_iter().find(|here| !here.is_empty()).unwrap_or_default()
    }
}

/// The segment of a polyline that begins at a position or contains it, about an origin on the segment.
#[expect(clippy::float_cmp, reason = "the depth of a given point is known without rounding, and at no other place")]
fn segment(points: &[[f64; 2]], from: f64, origin: f64) -> Polynomial {
    let after = points.partition_point(|p| p[0] <= from).clamp(1, points.len() - 1);
    let [left, right] = [points[after - 1], points[after]];
    let [[x, u], [end, depth]] = [left, right].map(|p| p.map(Interval::exact));
    let slope = (depth - u) / (end - x);
    // Given data are known without rounding: the two end points, and a level segment.
    let value = if origin == right[0] { depth } else { u + slope * (Interval::exact(origin) - x) };
    Polynomial::new(&[value, slope])
}

/// Derivatives of a cosine at `x`, over factorials; the last one encloses its values at any position.
fn of_cosine([mean, amplitude, wavelength, phase]: [f64; 4], x: f64) -> Polynomial {
    let [cos, sin] = Interval::cos_sin(Interval::exact(x) / Interval::exact(wavelength), Interval::exact(phase));
    let wave_number = Interval::TAU / Interval::exact(wavelength);
    let derivatives = [cos, -sin, -cos, sin].into_iter().cycle().take(TERMS - 1).chain([Interval::around_zero(1.0)]);
    let mut factor = Interval::exact(amplitude);
    let terms = derivatives.enumerate().map(|(j, derivative)| {
        let term = factor * derivative;
        factor = factor * wave_number / number(j + 1);
        term
    });
    Polynomial::new(&[Interval::exact(mean)]).plus(&Polynomial::of(terms))
}

#[cfg(test)]
pub(super) mod tests;
