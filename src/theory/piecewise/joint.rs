//! Joints and steps of the bending stiffness as the rest of beam theory asks for them.

use super::{Breakpoint, PiecewiseScene};

impl Breakpoint {
    /// Whether the slope of the beam may jump here.
    pub(in crate::theory) fn is_jointed(&self) -> bool {
        self.joint != 0.0
    }

    /// Whether the beam rotates here without a moment.
    pub(in crate::theory) fn is_hinge(&self) -> bool {
        self.joint.is_infinite()
    }
}

impl PiecewiseScene {
    /// The joints that resist rotation, from left to right: the position and the flexibility of each.
    pub(in crate::theory) fn elastic_joints(&self) -> impl Iterator<Item = (f64, f64)> {
        let joints = self.divisions.iter().map(|&i| &self.breakpoints[i]);
        joints.filter(|at| 0.0 < at.joint && at.joint.is_finite()).map(|at| (at.x, at.joint))
    }

    /// Whether the beam has a hinge.
    pub(in crate::theory) fn has_hinge(&self) -> bool {
        self.divisions.iter().any(|&i| self.breakpoints[i].is_hinge())
    }

    /// Whether breakpoint `i` is a hinge on a straight foundation, which a zone may begin or end with.
    pub(in crate::theory) fn is_hinge_on_a_line(&self, i: usize) -> bool {
        self.breakpoints[i].is_hinge() && self.is_straight(i) && !self.breaks_at(i)
    }

    /// Whether the beam is one part: no step, no joint, no elastic support and no axial force divides it.
    pub(in crate::theory) fn is_undivided(&self) -> bool {
        self.divisions.is_empty()
    }

    /// Whether the bending stiffness changes at breakpoint `i`.
    pub(in crate::theory) fn is_step(&self, i: usize) -> bool {
        let [left, right] = self.cells_beside(i).map(|cell| self.cells[cell].stiffness);
        left.total_cmp(&right).is_ne()
    }

    /// The curvature of a beam with this `e v''` in `cell`.
    pub(in crate::theory) fn curvature(&self, cell: usize, bent: f64) -> f64 {
        bent / self.cells[cell].stiffness
    }
}
