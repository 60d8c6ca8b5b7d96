//! Profile, supports and load by pieces: between breakpoints ("cells"), and at the breakpoints. The profile is the gap `g = u − w0`
//! between the foundation and the undeflected beam; for a straight beam it is the foundation itself.
//!
//! Everything is dimensionless, and forces and moments are divided by `EI₀`, the least bending stiffness. With `e(x) = EI/EI₀ ≥ 1`,
//! which is constant between breakpoints,
//!
//! ```text
//! state      v, v', e v'', e v'''          minus the latter two are moment and shear force: continuous wherever nothing acts
//! beam       e v'''' = q − p
//! joint      [v'] = w e v''                with its flexibility w = EI₀/k_j; infinite for a hinge
//! clearance  h = g − v with h, h', e h'', e h''': if e changes over a curved foundation a couple [e] g'' and a load −[e] g''' act on it
//! ```

mod along;
mod giving;
mod joint;

pub(super) use giving::AtSpring;

use super::acts::Acts;
use super::gauss::Gauss;
use super::shape::Shape;

/// The part between two neighbouring breakpoints: profile and load are smooth here.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell {
    /// Left end.
    pub(super) lo: f64,
    /// Right end.
    pub(super) hi: f64,
    /// The smooth piece of the profile: index into [`PiecewiseScene::shapes`].
    pub(super) shape: usize,
    /// Load at `lo`.
    pub(super) load: f64,
    /// Derivative of the load.
    pub(super) load_slope: f64,
    /// `e`, the bending stiffness divided by the least one.
    pub(super) stiffness: f64,
    /// Stiffness of an elastic foundation divided by the greatest one, zero where there is none; one on a rigid foundation.
    pub(super) ground: f64,
}

/// A breakpoint, or an end of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Breakpoint {
    /// Position.
    pub(super) x: f64,
    /// Depth of the profile; at a step the smaller one, and at a rigid compression-only support the depth of the support.
    pub(super) depth: f64,
    /// What acts there.
    pub(super) acts: Acts,
    /// `w`, the flexibility of a joint; zero where there is none.
    pub(super) joint: f64,
    /// Jump `u(x+) − u(x−)` of the depth.
    pub(super) step: f64,
    /// Jump `u'(x+) − u'(x−)` of the slope.
    pub(super) kink: f64,
}

/// A support, and the foundation next to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct AtSupport {
    /// Its breakpoint.
    pub(super) breakpoint: usize,
    /// The prescribed `v`.
    pub(super) level: f64,
    /// The prescribed `v'`: of a built-in support, or where a foundation at its level on both sides leaves no other slope.
    pub(super) slope: Option<f64>,
    /// Whether the support is built in.
    pub(super) built_in: bool,
    /// A rotational spring: its stiffness over `EI₀`, and the slope at which its moment is zero.
    pub(super) turning: Option<[f64; 2]>,
    /// Clearance on its left and on its right.
    pub(super) clearance: [f64; 2],
    /// [`Held::tangent`](crate::scene::Held::tangent): whether the beam can follow the foundation from its level on each side.
    pub(super) tangent: [bool; 2],
    /// The size of the numbers that add up to the depth of the foundation there: at the left end a polynomial is its first coefficient.
    pub(super) size: f64,
}

/// Profile and load of a scene by pieces.
#[derive(Debug, Clone)]
pub(super) struct PiecewiseScene {
    /// Length of the beam.
    pub(super) length: f64,
    /// From end to end.
    pub(super) cells: Vec<Cell>,
    /// One more than cells: breakpoint `i` is the left end of cell `i`.
    pub(super) breakpoints: Vec<Breakpoint>,
    /// The ends of runs of cells over which the beam is one polynomial: breakpoints where the line of load changes, a force acts or the
    /// beam changes, and on a curved foundation all breakpoints; from left to right.
    pub(super) run_ends: Vec<usize>,
    /// The largest kink of the profile, and its largest step.
    pub(super) roughest: [f64; 2],
    /// The breakpoints at which a span is divided: the stiffness changes, or a joint or an active spring is there, or with an axial
    /// force all; from left to right.
    pub(super) divisions: Vec<usize>,
    /// The smooth pieces of the profile.
    pub(super) shapes: Vec<Shape>,
    /// The ends of all smooth pieces except the last.
    pub(super) ends: Vec<f64>,
    /// Number of Taylor coefficients that describe profile and beam.
    pub(super) terms: usize,
    /// Exact for the load and `u''''` times a cubic.
    pub(super) load_rule: Gauss,
    /// Exact for energies.
    pub(super) energy_rule: Gauss,
    /// Resultant of all loads, including loads at supports.
    pub(super) resultant: f64,
    /// Sum of the magnitudes of all loads, without forces directly on supports.
    pub(super) total_load: f64,
    /// The size of depths whose rounding affects contact positions.
    pub(super) magnitude: f64,
    /// Whether there is a foundation below the beam. If not, clearances are measured from the line at depth 0 and are not checked.
    pub(super) founded: bool,
    /// The breakpoints with a rigid compression-only support, each an isolated point of the profile above its two sides; from left to
    /// right.
    pub(super) bearings: Vec<usize>,
    /// From left to right.
    pub(super) supports: Vec<AtSupport>,
    /// The elastic supports, from left to right.
    pub(super) springs: Vec<AtSpring>,
    /// Whether any support is a rotational spring.
    pub(super) turns: bool,
    /// Whether each end of the beam, left and right, has no support.
    pub(super) free_ends: [bool; 2],
    /// Stretches in which a contact zone would be in tension, from left to right; an upward point load is a stretch without length.
    pub(super) pulling: Vec<(f64, f64)>,
    /// `N`, the axial force. With an axial force a span is divided at all breakpoints, and every cell is short enough for
    /// [`super::tension`].
    pub(super) tension: f64,
}

impl PiecewiseScene {
    /// Taylor coefficients of the profile of `cell` at `x`.
    pub(super) fn profile(&self, cell: usize, x: f64, out: &mut [f64]) {
        self.shapes[self.cells[cell].shape].taylor(x, out);
    }

    /// `u, u', e u'', e u'''` at `x` in `cell`: the state of a beam that follows the profile.
    pub(super) fn derivatives(&self, cell: usize, x: f64) -> [f64; 4] {
        let mut taylor = [0.0; 4];
        self.profile(cell, x, &mut taylor);
        let [u, u1, u2, u3] = taylor;
        let e = self.cells[cell].stiffness;
        [u, u1, 2.0 * u2 * e, 6.0 * u3 * e]
    }

    /// `e u''` at `x` in `cell`, or `e u'''`: minus the moment or shear force of a beam that follows the profile.
    pub(super) fn bent(&self, cell: usize, x: f64, order: usize) -> f64 {
        self.derivative(cell, x, order) * self.cells[cell].stiffness
    }

    /// `u^{(order)}(x)` in `cell`, for an order up to 4.
    pub(super) fn derivative(&self, cell: usize, x: f64, order: usize) -> f64 {
        /// `j!`.
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

    /// The load at a distance `t` from the position `lo` in `cell`: over a few units in the last place the load may change by its full
    /// size.
    pub(super) fn load_beyond(&self, cell: usize, lo: f64, t: f64) -> f64 {
        let c = &self.cells[cell];
        c.load + c.load_slope * ((lo - c.lo) + t)
    }

    /// The cells from `first` to `last` in runs over a straight foundation under one line of load, each given by its first and its last
    /// cell.
    pub(super) fn runs(&self, first: usize, last: usize) -> impl DoubleEndedIterator<Item = [usize; 2]> {
        let from = self.run_ends.partition_point(|&end| end <= first);
        let to = self.run_ends.partition_point(|&end| end <= last).max(from);
        let ends = &self.run_ends[from..to];
        let start = move |i: usize| i.checked_sub(1).map_or(first, |i| ends[i]);
        (0..=ends.len()).map(move |i| [start(i), ends.get(i).map_or(last, |&end| end - 1)])
    }

    /// The runs of [`Self::runs`] between two positions in cells `first` and `last`, each with its first cell, without runs of zero
    /// length.
    pub(super) fn loaded(
        &self,
        [from, to]: [f64; 2],
        [first, last]: [usize; 2],
    ) -> impl Iterator<Item = (usize, [f64; 2])> {
        let run = move |[start, end]: [usize; 2]| (start, [self.cells[start].lo.max(from), self.cells[end].hi.min(to)]);
        self.runs(first, last).map(run).filter(|(_, [lo, hi])| lo < hi)
    }

    /// The forces at the breakpoints between cells `first` and `last`.
    pub(super) fn forces_between(&self, first: usize, last: usize) -> impl Iterator<Item = &Breakpoint> {
        self.runs(first, last).skip(1).map(|[start, _]| &self.breakpoints[start]).filter(|j| j.acts.is_any())
    }

    /// All breakpoints at which a force acts, from left to right.
    pub(super) fn forces(&self) -> impl Iterator<Item = &Breakpoint> {
        let inside = self.run_ends.iter().map(|&i| &self.breakpoints[i]);
        let all = self.breakpoints.first().into_iter().chain(inside).chain(self.breakpoints.last());
        all.filter(|j| j.acts.is_any())
    }

    /// The resultant of the loads between `from` and `to`, without point loads at these two positions.
    pub(super) fn load_inside(&self, from: f64, to: f64) -> f64 {
        let (first, last) = (self.cell_from(from), self.cell_to(to));
        let mean = |(cell, [lo, hi]): (usize, [f64; 2])| 0.5 * (self.load(cell, lo) + self.load(cell, hi)) * (hi - lo);
        let spread: f64 = self.loaded([from, to], [first, last]).map(mean).sum();
        spread + self.forces_between(first, last).map(|j| j.acts.force()).sum::<f64>()
    }

    /// Whether the profile of a cell is a straight line.
    pub(super) fn is_straight(&self, cell: usize) -> bool {
        self.shapes[self.cells[cell].shape].degree().is_some_and(|degree| degree < 2)
    }

    /// The cell that contains `x`; at a breakpoint the cell to its right, at the right end the last cell.
    pub(super) fn cell_from(&self, x: f64) -> usize {
        self.breakpoints.partition_point(|j| j.x <= x).saturating_sub(1).min(self.cells.len() - 1)
    }

    /// The cell that contains `x`; at a breakpoint the cell to its left, at the left end the first cell.
    pub(super) fn cell_to(&self, x: f64) -> usize {
        self.breakpoints.partition_point(|j| j.x < x).saturating_sub(1).min(self.cells.len() - 1)
    }

    /// The cells to the right and to the left of `x`; `near` is the cell that most likely contains `x`.
    pub(super) fn cells_at(&self, x: f64, near: usize) -> [usize; 2] {
        let c = &self.cells[near];
        if c.lo < x && x < c.hi { [near; 2] } else { [self.cell_from(x), self.cell_to(x)] }
    }

    /// The cell that a position at `x` enters when it moves to the right or, with a negative `change`, to the left; `cell` itself if
    /// the profile breaks in between.
    pub(super) fn cell_ahead(&self, x: f64, cell: usize, change: f64) -> usize {
        let ahead = if change < 0.0 { self.cell_to(x) } else { self.cell_from(x) };
        if self.cells[ahead].shape == self.cells[cell].shape { ahead } else { cell }
    }

    /// The difference of the profile between both ends of a cell, not negative.
    pub(super) fn rise(&self, cell: usize) -> f64 {
        let Cell { lo, hi, .. } = self.cells[cell];
        (self.derivative(cell, hi, 0) - self.derivative(cell, lo, 0)).abs()
    }

    /// Depth at `x`; at a step the smaller one.
    pub(super) fn depth(&self, x: f64) -> f64 {
        let (left, right) = (self.cell_to(x), self.cell_from(x));
        if let Some(bearing) = self.breakpoint_at(x).filter(|&i| self.is_bearing(i)) {
            return self.breakpoints[bearing].depth;
        }
        let depth = self.derivative(left, x, 0);
        if left == right { depth } else { depth.min(self.derivative(right, x, 0)) }
    }

    /// The cells to the left and to the right of breakpoint `i`; at an end of the beam both are the cell inside.
    pub(super) fn cells_beside(&self, i: usize) -> [usize; 2] {
        [i.saturating_sub(1), i.min(self.cells.len() - 1)]
    }

    /// Whether the load is not one straight line across breakpoint `i`; at an end of the beam, whether a point load or a couple acts
    /// there.
    pub(super) fn load_changes_at(&self, i: usize) -> bool {
        /// Rounding of a line evaluated in two cells.
        const ROUNDING: f64 = 1e-9;
        let ([before, beyond], x) = (self.cells_beside(i), self.breakpoints[i].x);
        let (left, right) = (&self.cells[before], &self.cells[beyond]);
        let jump = (self.load(before, x) - self.load(beyond, x)).abs();
        let turn = (left.load_slope - right.load_slope).abs() * self.length;
        self.breakpoints[i].acts.is_any()
            || ROUNDING * (left.load.abs() + right.load.abs() + right.load_slope.abs() * self.length) < jump.max(turn)
    }

    /// The rotation of the profile from its slope at `a` to the chord from `a` to `b`, and from the chord to its slope at `b`. `a` and
    /// `b` are in cells `first` and `last`; at a step the higher side counts.
    pub(super) fn rotations_to_chord(&self, [a, b]: [f64; 2], [first, last]: [usize; 2], even: bool) -> [f64; 2] {
        let stepped = |breakpoint: usize, x: f64| {
            self.breakpoints[breakpoint].x.total_cmp(&x).is_eq()
                && (self.breakpoints[breakpoint].step != 0.0 || self.is_bearing(breakpoint))
        };
        let shape = &self.shapes[self.cells[first].shape];
        if self.cells[first].shape == self.cells[last].shape && !stepped(first, a) && !stepped(last + 1, b) {
            return [shape.bow(a, b - a, even), shape.bow(b, a - b, even)];
        }
        let chord = (self.depth(b) - self.depth(a)) / (b - a);
        [chord - self.derivative(first, a, 1), self.derivative(last, b, 1) - chord]
    }

    /// The extent of the smooth piece of the profile that `cell` belongs to, limited by the next support on each side: no contact
    /// passes a support.
    pub(super) fn reach(&self, cell: usize) -> (f64, f64) {
        let shape = self.cells[cell].shape;
        let end = |shape: usize| self.ends.get(shape).copied().unwrap_or(self.length);
        let next = self.supports.partition_point(|support| support.breakpoint <= cell);
        let at = |support: &AtSupport| self.breakpoints[support.breakpoint].x;
        let from = next.checked_sub(1).map_or(0.0, |i| at(&self.supports[i]));
        let to = self.supports.get(next).map_or(self.length, at);
        (shape.checked_sub(1).map_or(0.0, end).max(from), end(shape).min(to))
    }

    /// The size of depths whose rounding affects `x`: for a single polynomial the sum of its terms there.
    pub(super) fn magnitude_at(&self, x: f64) -> f64 {
        match self.shapes.as_slice() {
            [Shape::Line { origin, depth, slope }] => (depth.abs() + (slope * (x - origin)).abs()).min(self.magnitude),
            [Shape::Polynomial(coefficients)] => {
                coefficients.iter().rev().fold(0.0, |sum, c| sum * x.abs() + c.abs()).min(self.magnitude)
            }
            _ => self.magnitude,
        }
    }

    /// The breakpoints between `a` and `b`, excluding both.
    pub(super) fn breakpoints_inside(&self, a: f64, b: f64) -> std::ops::Range<usize> {
        let first = self.breakpoints.partition_point(|j| j.x <= a);
        first..self.breakpoints.partition_point(|j| j.x < b).max(first)
    }

    /// The breakpoint at `x`, if there is one.
    pub(super) fn breakpoint_at(&self, x: f64) -> Option<usize> {
        let breakpoint = self.breakpoints.partition_point(|j| j.x < x);
        self.breakpoints.get(breakpoint).filter(|j| j.x <= x).map(|_| breakpoint)
    }

    /// The breakpoint exactly at `x`, if there is one; `near` is the cell that most likely contains `x`.
    pub(super) fn exactly_at(&self, x: f64, near: usize) -> Option<usize> {
        let c = &self.cells[near];
        if c.lo < x && x < c.hi { None } else { self.breakpoint_at(x) }
    }

    /// The breakpoints between cell `first` and cell `last`.
    pub(super) fn breakpoints_between(&self, first: usize, last: usize) -> &[Breakpoint] {
        self.breakpoints.get(first + 1..=last).unwrap_or_default()
    }

    /// Whether breakpoint `i` is an end of the beam without a support.
    pub(super) fn is_free_end(&self, i: usize) -> bool {
        self.free_ends[0] && i == 0 || self.free_ends[1] && i == self.cells.len()
    }

    /// The index of the support at breakpoint `i`, if there is one.
    pub(super) fn support_at(&self, i: usize) -> Option<usize> {
        self.supports.binary_search_by_key(&i, |support| support.breakpoint).ok()
    }

    /// Whether a rigid compression-only support is at breakpoint `i`.
    pub(super) fn is_bearing(&self, i: usize) -> bool {
        self.bearings.binary_search(&i).is_ok()
    }

    /// The index of the rigid compression-only support at breakpoint `i`, if there is one; these follow the supports that hold the
    /// beam.
    pub(super) fn bearing_index(&self, i: usize) -> Option<usize> {
        self.bearings.binary_search(&i).ok().map(|bearing| self.supports.len() + bearing)
    }

    /// Whether there is anything that the beam may touch.
    pub(super) fn has_obstacle(&self) -> bool {
        self.founded || !self.bearings.is_empty()
    }

    /// The depth of the profile on the side of `cell` below breakpoint `i`, on which a beam rests.
    pub(super) fn height(&self, i: usize, cell: usize) -> f64 {
        let Breakpoint { x, depth, step, .. } = self.breakpoints[i];
        match cell < i {
            _ if self.is_bearing(i) => self.derivative(cell, x, 0) - depth,
            true => (-step).max(0.0),
            false => step.max(0.0),
        }
    }

    /// Whether a smooth piece of the profile ends at breakpoint `i`.
    pub(super) fn breaks_at(&self, i: usize) -> bool {
        0 < i && i < self.cells.len() && self.cells[i - 1].shape != self.cells[i].shape
    }

    /// Whether the beam can rest on breakpoint `i`: a step, a kink that points upwards, or a rigid compression-only support. Over a
    /// foundation, a free end of the beam and a joint, which is a kink of the beam, count as well.
    pub(super) fn is_edge(&self, i: usize) -> bool {
        let corner = || self.breakpoints[i].step != 0.0 || 0.0 < self.breakpoints[i].kink;
        self.is_bearing(i)
            || self.founded
                && (self.is_free_end(i) || self.breakpoints[i].is_jointed() || self.breaks_at(i) && corner())
    }
}
