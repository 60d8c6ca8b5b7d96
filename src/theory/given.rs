//! What is given, by pieces: profile and load between breakpoints ("cells"), and what happens at the breakpoints ("joints").
//!
//! Everything is dimensionless and divided by `EI`, so that the beam's equation is `v'''' = q − p` and a moment is `−v''`.

use super::gauss::Gauss;
use super::shape::Shape;

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
