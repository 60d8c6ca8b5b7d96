//! Supports that give, among the breakpoints.
//!
//! ```text
//! spring            R = k (v − d)              what is left of a load P on a beam that lies at v = g there: P − k (g − d)
//! turning spring    M jumps by −k (v' − φ)
//! ```

use super::PiecewiseScene;
use crate::scene::Spring;

/// A support that gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::theory) struct AtSpring {
    /// The breakpoint where it is.
    pub(in crate::theory) breakpoint: usize,
    /// `k`, over `EI₀`.
    pub(in crate::theory) stiffness: f64,
    /// `d`, the deflection without force.
    pub(in crate::theory) level: f64,
    /// A spring against turning besides, as at an [`AtSupport`](super::AtSupport).
    pub(in crate::theory) turning: Option<[f64; 2]>,
    /// True if it lets the beam lift off.
    pub(in crate::theory) pushes_only: bool,
    /// True if it acts: one that only pushes does so where it is pressed.
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
    /// True if no support gives.
    pub(in crate::theory) fn is_firm(&self) -> bool {
        self.springs.is_empty() && !self.turns
    }

    /// The supports that give and act, from left to right.
    pub(in crate::theory) fn acting(&self) -> impl DoubleEndedIterator<Item = &AtSpring> {
        self.springs.iter().filter(|spring| spring.acts)
    }

    /// The one of them at breakpoint `i`.
    pub(in crate::theory) fn spring_at(&self, i: usize) -> Option<&AtSpring> {
        self.giving_at(i).filter(|spring| spring.acts)
    }

    /// The support at breakpoint `i` that gives and only pushes, pressed or not.
    pub(in crate::theory) fn stop_at(&self, i: usize) -> Option<&AtSpring> {
        self.giving_at(i).filter(|spring| spring.pushes_only)
    }

    fn giving_at(&self, i: usize) -> Option<&AtSpring> {
        self.springs.binary_search_by_key(&i, |spring| spring.breakpoint).ok().map(|at| &self.springs[at])
    }

    /// The spring against turning at breakpoint `i`: its stiffness, and the slope without moment.
    pub(in crate::theory) fn turning_at(&self, i: usize) -> Option<[f64; 2]> {
        if !self.turns {
            return None;
        }
        match self.support_at(i) {
            Some(support) => self.supports[support].turning,
            None => self.spring_at(i)?.turning,
        }
    }

    /// The outermost one beyond `x`, to the left of it or to the right.
    pub(in crate::theory) fn spring_beyond(&self, x: f64, at_left: bool) -> Option<&AtSpring> {
        let at = |spring: &&AtSpring| self.breakpoints[spring.breakpoint].x;
        match at_left {
            true => self.acting().next().filter(|spring| at(spring) < x),
            false => self.acting().next_back().filter(|spring| x < at(spring)),
        }
    }

    /// What acts downwards at breakpoint `i` on a beam that touches there.
    pub(in crate::theory) fn force_on(&self, i: usize) -> f64 {
        let (at, spring) = (&self.breakpoints[i], self.spring_at(i));
        let force = at.acts.force();
        spring.map_or(force, |spring| force - spring.stiffness * (at.depth - spring.level))
    }

    /// The same exactly at `x`, which most likely lies in cell `near`.
    pub(in crate::theory) fn force_at(&self, x: f64, near: usize) -> f64 {
        self.exactly_at(x, near).map_or(0.0, |i| self.force_on(i))
    }

    /// The forces, upwards, of the springs strictly between `a` and `b`, where the beam lies on the ground.
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
