//! Changes of the beam along its length, and the tension in a beam that follows the foundation.

use super::{Breakpoint, Cell, PiecewiseScene};

impl PiecewiseScene {
    /// `e u'''' − N u'' − q` in `cell`: it drives the clearance where nothing touches, and is minus the pressure in a contact zone.
    pub(in crate::theory) fn drive(&self, cell: usize, x: f64) -> f64 {
        let degree = self.shapes[self.cells[cell].shape].degree();
        let profile = if degree.is_none_or(|d| 4 <= d) { self.bent(cell, x, 4) } else { 0.0 };
        let bends = self.tension != 0.0 && degree.is_none_or(|d| 2 <= d);
        let pulled = if bends { self.tension * self.derivative(cell, x, 2) } else { 0.0 };
        profile - pulled - self.load(cell, x)
    }

    /// The same at a distance `t` from `lo`, without the waves of a profile, which have a closed form.
    pub(in crate::theory) fn drive_without_waves(&self, cell: usize, lo: f64, t: f64) -> f64 {
        let Cell { shape, stiffness, .. } = self.cells[cell];
        stiffness * self.shapes[shape].fourth_without_waves(lo + t) - self.load_beyond(cell, lo, t)
    }

    /// The divisions strictly between `a` and `b`.
    pub(in crate::theory) fn divisions_between(&self, a: f64, b: f64) -> &[usize] {
        let x = |i: &usize| self.breakpoints[*i].x;
        let first = self.divisions.partition_point(|i| x(i) <= a);
        let last = self.divisions.partition_point(|i| x(i) < b).max(first);
        &self.divisions[first..last]
    }

    /// The position of the division nearest to `x`, if it is no joint and at most `reach` away.
    pub(in crate::theory) fn division_at(&self, x: f64, reach: f64) -> Option<f64> {
        let at = |i: usize| self.divisions.get(i).map(|i| &self.breakpoints[*i]);
        let place = |i: usize| at(i).filter(|at| !at.is_jointed()).map(|at| at.x);
        let next = self.divisions.partition_point(|i| self.breakpoints[*i].x < x);
        let beside = [next.checked_sub(1).and_then(place), place(next)].into_iter().flatten();
        beside.min_by(|a, b| (a - x).abs().total_cmp(&(b - x).abs())).filter(|at| (at - x).abs() <= reach)
    }

    /// The actions at breakpoint `i` on a beam that follows the foundation on both sides: the missing jump of `e v''`, and the downward
    /// force.
    pub(in crate::theory) fn acts_along_ground(&self, i: usize) -> [f64; 2] {
        let Breakpoint { x, acts, joint, .. } = self.breakpoints[i];
        let mut couple = acts.couple();
        let ([left, right], force) = (self.cells_beside(i), self.force_on(i));
        if let Some([k, slope]) = self.spring_at(i).and_then(|spring| spring.turning) {
            couple += k * (self.derivative(right, x, 1) - slope);
        }
        if self.cells[left].shape != self.cells[right].shape || left == right {
            return [-couple, force];
        }
        let changes = |order| {
            if self.divisions.is_empty() { 0.0 } else { self.bent(right, x, order) - self.bent(left, x, order) }
        };
        // A bent beam rotates in a joint, and the foundation does not.
        let turns = if joint == 0.0 { 0.0 } else { self.bent(right, x, 2) };
        [changes(2) - couple + turns, force - changes(3)]
    }

    /// Whether breakpoint `i` is a support or a division of the beam.
    pub(in crate::theory) fn changes_at(&self, i: usize) -> bool {
        self.support_at(i).is_some() || self.divisions.binary_search(&i).is_ok()
    }

    /// The stretches in tension that overlap the open stretch from `a` to `b`; with `a = b`, those that contain this position.
    pub(in crate::theory) fn pulling_between(&self, a: f64, b: f64) -> impl Iterator<Item = &(f64, f64)> {
        let next = self.pulling.partition_point(|&(_, hi)| hi <= a);
        self.pulling[next..].iter().take_while(move |&&(lo, _)| lo < b)
    }

    /// The limits to which a zone that starts at `x` may be extended to the left, and a zone that ends there to the right: the next
    /// stretch in tension, or no limit if `x` is inside one.
    pub(in crate::theory) fn next_pulling(&self, x: f64) -> [f64; 2] {
        let next = self.pulling.partition_point(|&(_, hi)| hi <= x);
        let lo = next.checked_sub(1).map_or(0.0, |i| self.pulling[i].1);
        let hi = self.pulling.get(next).map_or(self.length, |&(lo, _)| lo);
        if x <= hi { [lo, hi] } else { [0.0, self.length] }
    }

    /// Whether the profile is straight next to the free end at breakpoint `i` and no couple acts there, so that a zone may reach it.
    pub(in crate::theory) fn is_flat_end(&self, i: usize) -> bool {
        let [_, cell] = self.cells_beside(i);
        self.is_free_end(i)
            && !self.is_bearing(i)
            && self.breakpoints[i].acts.couple() == 0.0
            && self.shapes[self.cells[cell].shape].degree().is_some_and(|degree| degree < 2)
    }
}
