//! What is given, by pieces: profile and load between breakpoints ("cells"), and what happens at the breakpoints ("joints").
//!
//! Everything is dimensionless and divided by `EI`, so that the beam's equation is `v'''' = q − p` and a moment is `−v''`.

use super::gauss::Gauss;
use super::profile::shapes_of;
use super::shape::Shape;
use crate::scene::{Foundation, Scene};

/// A cosine is cut into cells of at most this angle \[rad\]: 22 terms of its Taylor series are then exact to
/// `0.8²²/22! < 10⁻²³`, and its fourth derivative to `0.8¹⁸/18! < 10⁻¹⁷`.
const CELL_ANGLE: f64 = 0.8;
/// Terms of the Taylor series of a cosine.
const COSINE_TERMS: usize = 22;
/// Ten-point Gauss quadrature over such a cell is exact to rounding.
const COSINE_DEGREE: usize = 19;
/// A beam by pieces is a polynomial of degree 5 between joints: load of degree 1, integrated four times.
const BEAM_TERMS: usize = 6;

/// Between two neighbouring breakpoints: profile and load are smooth here.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell {
    /// Left end.
    pub(super) lo: f64,
    /// Right end.
    pub(super) hi: f64,
    /// Which smooth piece of the profile: index into [`Given::shapes`].
    pub(super) shape: usize,
    /// Load at `lo`.
    pub(super) load: f64,
    /// Load per length.
    pub(super) load_slope: f64,
}

/// A breakpoint, and the two ends of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Joint {
    /// Where.
    pub(super) x: f64,
    /// Point load.
    pub(super) force: f64,
    /// Jump `u(x+) − u(x−)` of the depth.
    pub(super) step: f64,
    /// Jump `u'(x+) − u'(x−)` of the slope.
    pub(super) kink: f64,
}

/// The foundation at a support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct AtEnd {
    /// The numbers that add up to its depth there: at the left support a polynomial is its first coefficient.
    pub(super) size: f64,
    /// True if it starts at the level of the support: a point exactly, a formula up to the rounding of these numbers.
    pub(super) level: bool,
}

impl AtEnd {
    fn of(foundation: &Foundation, x: f64, length: f64) -> Self {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let size = match foundation {
            Foundation::Polyline { .. } | Foundation::Flat { .. } => 0.0,
            smooth => smooth.magnitude_at(x).min(smooth.magnitude(length)),
        };
        Self { size, level: foundation.depth(x) <= ROUNDING * size }
    }
}

/// Profile and load of a scene by pieces.
#[derive(Debug, Clone)]
pub(super) struct Given {
    /// Length of the beam.
    pub(super) length: f64,
    /// From support to support.
    pub(super) cells: Vec<Cell>,
    /// One more than cells: joint `i` is the left end of cell `i`.
    pub(super) joints: Vec<Joint>,
    /// The smooth pieces of the profile.
    pub(super) shapes: Vec<Shape>,
    /// Number of Taylor coefficients that describe profile and beam.
    pub(super) terms: usize,
    /// Exact for the load and `u''''` times a cubic.
    pub(super) load_rule: Gauss,
    /// Exact for energies.
    pub(super) energy_rule: Gauss,
    /// Magnitudes of all loads together.
    pub(super) total_load: f64,
    /// The size of depths that carries their rounding where a beam may touch.
    pub(super) magnitude: f64,
    /// The foundation at the left and the right support.
    pub(super) supports: [AtEnd; 2],
}

impl Given {
    /// Profile and load of a dimensionless scene with a foundation.
    pub(super) fn new(scene: &Scene, foundation: &Foundation) -> Self {
        let length = scene.beam().length();
        let stiffness = scene.beam().bending_stiffness();
        let (shapes, mut ends) = shapes_of(foundation, length);
        let load = scene.load();
        // (place, what): breakpoints of profile and load.
        let mut places: Vec<f64> = ends.clone();
        places.extend(load.linear().iter().flat_map(|q| [q.from, q.to]));
        places.extend(load.point().iter().map(|p| p.at));
        places.extend([0.0, length]);
        if let Foundation::Cosine { wavelength, .. } = foundation {
            let most = CELL_ANGLE * wavelength / (2.0 * std::f64::consts::PI);
            places.sort_by(f64::total_cmp);
            places.dedup();
            let cuts: Vec<f64> = places.windows(2).flat_map(|w| cuts(w[0], w[1], most)).collect();
            places.extend(cuts);
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        ends.push(f64::INFINITY);

        let cells: Vec<Cell> = places
            .windows(2)
            .map(|w| {
                let (lo, hi) = (w[0], w[1]);
                let shape = ends.partition_point(|&end| end <= lo);
                let covering = load.linear().iter().filter(|q| q.from <= lo && hi <= q.to);
                let (mut at_lo, mut slope) = (load.uniform(), 0.0);
                for q in covering {
                    at_lo += q.intensity(lo);
                    slope += (q.end - q.start) / (q.to - q.from);
                }
                Cell { lo, hi, shape, load: at_lo / stiffness, load_slope: slope / stiffness }
            })
            .collect();
        let mut joints: Vec<Joint> = places.iter().map(|&x| Joint { x, ..Joint::default() }).collect();
        for i in 1..cells.len() {
            let (left, right) = (cells[i - 1].shape, cells[i].shape);
            if left != right {
                let (mut a, mut b) = ([0.0; 2], [0.0; 2]);
                shapes[left].taylor(places[i], &mut a);
                shapes[right].taylor(places[i], &mut b);
                (joints[i].step, joints[i].kink) =
                    (snapped(b[0] - a[0], shapes[left].start().abs().max(b[0].abs())), b[1] - a[1]);
            }
        }
        for p in load.point() {
            let i = places.partition_point(|&x| x < p.at).min(joints.len() - 1);
            joints[i].force += p.force / stiffness;
        }
        let degree = shapes.iter().map(Shape::degree).try_fold(0, |most, d| d.map(|d| d.max(most)));
        let (terms, profile) = degree.map_or((COSINE_TERMS, COSINE_DEGREE), |d| ((d + 1).max(BEAM_TERMS), d));
        Self {
            length,
            cells,
            joints,
            shapes,
            terms,
            load_rule: Gauss::exact_to(if degree.is_some() { profile.saturating_sub(4).max(1) + 3 } else { profile }),
            energy_rule: Gauss::exact_to(if degree.is_some() { (2 * profile).max(6) } else { profile }),
            total_load: load.magnitude(length) / stiffness,
            magnitude: within_reach(foundation, length),
            supports: [0.0, length].map(|x| AtEnd::of(foundation, x, length)),
        }
    }

    /// Taylor coefficients of the profile of `cell` at `x`.
    pub(super) fn profile(&self, cell: usize, x: f64, out: &mut [f64]) {
        self.shapes[self.cells[cell].shape].taylor(x, out);
    }

    /// `u, u', u'', u'''` at `x` in `cell`.
    pub(super) fn derivatives(&self, cell: usize, x: f64) -> [f64; 4] {
        let mut taylor = [0.0; 4];
        self.profile(cell, x, &mut taylor);
        let [u, u1, u2, u3] = taylor;
        [u, u1, 2.0 * u2, 6.0 * u3]
    }

    /// `u^{(order)}(x)` in `cell`, for an order up to 4.
    pub(super) fn derivative(&self, cell: usize, x: f64, order: usize) -> f64 {
        const FACTORIAL: [f64; 5] = [1.0, 1.0, 2.0, 6.0, 24.0];
        let mut taylor = [0.0; 5];
        self.profile(cell, x, &mut taylor);
        taylor[order] * FACTORIAL[order]
    }

    /// Load `q(x)` in `cell`.
    pub(super) fn load(&self, cell: usize, x: f64) -> f64 {
        let c = &self.cells[cell];
        c.load + c.load_slope * (x - c.lo)
    }

    /// `u'''' − q` in `cell`: what drives the clearance where nothing touches, and minus the pressure where it does.
    pub(super) fn drive(&self, cell: usize, x: f64) -> f64 {
        let curved = self.shapes[self.cells[cell].shape].degree().is_none_or(|d| 4 <= d);
        let profile = if curved { self.derivative(cell, x, 4) } else { 0.0 };
        profile - self.load(cell, x)
    }

    /// The cell in which `x` lies; at a joint the one to its right, at the right support the last one.
    pub(super) fn cell_from(&self, x: f64) -> usize {
        self.joints.partition_point(|j| j.x <= x).saturating_sub(1).min(self.cells.len() - 1)
    }

    /// The cell in which `x` lies; at a joint the one to its left, at the left support the first one.
    pub(super) fn cell_to(&self, x: f64) -> usize {
        self.joints.partition_point(|j| j.x < x).saturating_sub(1).min(self.cells.len() - 1)
    }

    /// Depth at `x`; at a step the smaller one.
    pub(super) fn depth(&self, x: f64) -> f64 {
        let (left, right) = (self.cell_to(x), self.cell_from(x));
        let depth = self.derivative(left, x, 0);
        if left == right { depth } else { depth.min(self.derivative(right, x, 0)) }
    }

    /// From where to where the smooth piece of the profile reaches that `cell` belongs to.
    pub(super) fn reach(&self, cell: usize) -> (f64, f64) {
        let shape = self.cells[cell].shape;
        let first = self.cells[..cell].iter().rposition(|c| c.shape != shape).map_or(0, |i| i + 1);
        let last = self.cells[cell..].iter().position(|c| c.shape != shape).map_or(self.cells.len(), |i| cell + i);
        (self.cells[first].lo, self.cells[last - 1].hi)
    }

    /// The size of depths that carries their rounding at `x`: of one polynomial what adds up to it there.
    pub(super) fn magnitude_at(&self, x: f64) -> f64 {
        match self.shapes.as_slice() {
            [Shape::Polynomial { origin, coefficients }] => {
                coefficients.iter().rev().fold(0.0, |sum, c| sum * (x - origin).abs() + c.abs()).min(self.magnitude)
            }
            _ => self.magnitude,
        }
    }

    /// The joint at `x`, if there is one.
    pub(super) fn joint_at(&self, x: f64) -> Option<usize> {
        let joint = self.joints.partition_point(|j| j.x < x);
        self.joints.get(joint).filter(|j| j.x <= x).map(|_| joint)
    }

    /// True if the foundation starts at the level of a support (0: left, 1: right), up to the rounding of its depth.
    pub(super) fn starts_at_zero(&self, support: usize) -> bool {
        self.supports[support].level
    }

    /// Point load exactly at `x`.
    pub(super) fn force_at(&self, x: f64) -> f64 {
        self.joint_at(x).map_or(0.0, |joint| self.joints[joint].force)
    }

    /// The joints between cell `first` and cell `last`.
    pub(super) fn joints_between(&self, first: usize, last: usize) -> &[Joint] {
        self.joints.get(first + 1..=last).unwrap_or_default()
    }

    /// True if the smooth piece of the profile ends at joint `i`.
    pub(super) fn breaks_at(&self, i: usize) -> bool {
        0 < i && i < self.cells.len() && self.cells[i - 1].shape != self.cells[i].shape
    }

    /// True if the beam can rest on joint `i`: an edge, or a kink that points upwards.
    pub(super) fn is_edge(&self, i: usize) -> bool {
        self.breaks_at(i) && (self.joints[i].step != 0.0 || 0.0 < self.joints[i].kink)
    }
}

/// Cuts between `lo` and `hi` into equal parts no longer than `most`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "the number of parts is limited just before"
)]
fn cuts(lo: f64, hi: f64, most: f64) -> impl Iterator<Item = f64> {
    let parts = ((hi - lo) / most).ceil().clamp(1.0, MOST_CELLS);
    (1..parts as usize).map(move |i| lo + (hi - lo) * (i as f64 / parts))
}

/// A profile that needs more cells than this is refused: [`super::TheoryError::TooManyPieces`].
pub(super) const MOST_CELLS: f64 = 20_000.0;

/// The size of depths, the rounding of which reaches the place where a beam touches: of polynomials and waves what adds up to
/// the depth, of straight lines only that of their shallowest point, which is given.
fn within_reach(foundation: &Foundation, length: f64) -> f64 {
    match foundation {
        Foundation::Polyline { points } => points.iter().fold(f64::INFINITY, |least, p| least.min(p[1].abs())),
        smooth => smooth.magnitude(length),
    }
}

/// A step of the depth; none if it is the rounding of an interpolation between depths of a `size`, which may meet at zero.
fn snapped(step: f64, size: f64) -> f64 {
    if step.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { step }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, LinearLoad, Load, PointLoad};

    #[test]
    fn cells_carry_profile_and_load() {
        let beam = Beam::new(4.0, 2.0).expect("a beam");
        let linear = vec![LinearLoad { from: 1.0, to: 3.0, start: 2.0, end: 6.0 }];
        let load = Load::new(&beam, 1.0, linear, vec![PointLoad { at: 2.0, force: 5.0 }]).expect("a load");
        let points = vec![[0.0, 1.0], [1.0, 1.0], [2.0, 0.0], [2.0, 0.5], [4.0, 2.5]];
        let foundation = Foundation::Polyline { points };
        let scene = Scene::new(beam, load, Some(foundation.clone())).expect("a scene");
        let given = Given::new(&scene, &foundation);
        let places: Vec<f64> = given.joints.iter().map(|j| j.x).collect();
        assert_eq!(places, [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(given.cells.iter().map(|c| c.shape).collect::<Vec<_>>(), [0, 1, 2, 2]);
        assert_eq!(given.joints[1], Joint { x: 1.0, force: 0.0, step: 0.0, kink: -1.0 });
        assert_eq!(given.joints[2], Joint { x: 2.0, force: 2.5, step: 0.5, kink: 2.0 });
        // q = 1 + 2 + 2 (x − 1), over EI.
        let found = [given.load(1, 1.5), given.load(3, 3.5), given.depth(2.0)];
        assert_eq!(found.map(f64::to_bits), [2.0_f64, 0.5, 0.0].map(f64::to_bits));
        assert_eq!(given.reach(3), (2.0, 4.0));
        assert!(given.is_edge(2) && !given.is_edge(1));
    }
}
