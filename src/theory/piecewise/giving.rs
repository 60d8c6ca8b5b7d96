//! Elastic supports at the breakpoints.
//!
//! ```text
//! spring             R = k (v − d)              rest of a load P on a beam that is in contact there, with v = g: P − k (g − d)
//! rotational spring  M jumps by −k (v' − φ)
//! ```

use super::PiecewiseScene;
use crate::scene::Spring;

/// An elastic support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::theory) struct AtSpring {
    /// Its breakpoint.
    pub(in crate::theory) breakpoint: usize,
    /// `k`, over `EI₀`.
    pub(in crate::theory) stiffness: f64,
    /// `d`, the deflection at which its force is zero.
    pub(in crate::theory) level: f64,
    /// A rotational spring in addition, as at an [`AtSupport`](super::AtSupport).
    pub(in crate::theory) turning: Option<[f64; 2]>,
    /// Whether it is a compression-only support.
    pub(in crate::theory) pushes_only: bool,
    /// Whether it is active; a compression-only spring is active where it is pressed.
    pub(in crate::theory) acts: bool,
}

impl AtSpring {
    /// Among the breakpoints at `places`, over this stiffness of the beam.
    pub(in crate::theory) fn of(spring: &Spring, places: &[f64], stiffness: f64, acts: bool) -> Self {
        Self {
            breakpoint: places.partition_point(|&x| x < spring.at),
            stiffness: spring.stiffness / stiffness,
            level: spring.deflection,
            turning: spring.turning.map(|[k, slope]| [k / stiffness, slope]),
            pushes_only: spring.pushes_only,
            acts,
        }
    }
}

impl PiecewiseScene {
    /// Whether no support is elastic.
    pub(in crate::theory) fn is_firm(&self) -> bool {
        self.springs.is_empty() && !self.turns
    }

    /// The active elastic supports, from left to right.
    pub(in crate::theory) fn acting(&self) -> impl DoubleEndedIterator<Item = &AtSpring> {
        self.springs.iter().filter(|spring| spring.acts)
    }

    /// The active elastic support at breakpoint `i`.
    pub(in crate::theory) fn spring_at(&self, i: usize) -> Option<&AtSpring> {
        self.giving_at(i).filter(|spring| spring.acts)
    }

    /// The elastic compression-only support at breakpoint `i`, active or not.
    pub(in crate::theory) fn stop_at(&self, i: usize) -> Option<&AtSpring> {
        self.giving_at(i).filter(|spring| spring.pushes_only)
    }

    fn giving_at(&self, i: usize) -> Option<&AtSpring> {
        self.springs.binary_search_by_key(&i, |spring| spring.breakpoint).ok().map(|at| &self.springs[at])
    }

    /// The rotational spring at breakpoint `i`: its stiffness, and the slope at which its moment is zero.
    pub(in crate::theory) fn turning_at(&self, i: usize) -> Option<[f64; 2]> {
        if !self.turns {
            return None;
        }
        match self.support_at(i) {
            Some(support) => self.supports[support].turning,
            None => self.spring_at(i)?.turning,
        }
    }

    /// The outermost active spring beyond `x`, on its left or on its right.
    pub(in crate::theory) fn spring_beyond(&self, x: f64, at_left: bool) -> Option<&AtSpring> {
        let at = |spring: &&AtSpring| self.breakpoints[spring.breakpoint].x;
        match at_left {
            true => self.acting().next().filter(|spring| at(spring) < x),
            false => self.acting().next_back().filter(|spring| x < at(spring)),
        }
    }

    /// The downward force at breakpoint `i` on a beam that touches there.
    pub(in crate::theory) fn force_on(&self, i: usize) -> f64 {
        let (at, spring) = (&self.breakpoints[i], self.spring_at(i));
        let force = at.acts.force();
        spring.map_or(force, |spring| force - spring.stiffness * (at.depth - spring.level))
    }

    /// The downward force exactly at `x`; `near` is the cell that most likely contains `x`.
    pub(in crate::theory) fn force_at(&self, x: f64, near: usize) -> f64 {
        self.exactly_at(x, near).map_or(0.0, |i| self.force_on(i))
    }

    /// The upward forces of the springs strictly between `a` and `b`, where the beam is in contact: `(position, force)`.
    pub(in crate::theory) fn springs_in_zone(&self, a: f64, b: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        let on_ground = |spring: &AtSpring| {
            let at = &self.breakpoints[spring.breakpoint];
            (at.x, spring.stiffness * (at.depth - spring.level))
        };
        let first = self.springs.partition_point(|spring| self.breakpoints[spring.breakpoint].x <= a);
        let acting = self.springs[first..].iter().filter(|spring| spring.acts);
        acting.map(on_ground).take_while(move |(x, _)| *x < b)
    }
}
