//! Contact nodes: the supports of a scene and the contacts of a witness as places in an enclosed scene.
//!
//! Between two neighbouring nodes the beam either hangs free or lies on the foundation; beyond the outermost ones it hangs free.
//!
//! | node | `v` | `v'` | `M` | force |
//! |---|---|---|---|---|
//! | corner, support that only pushes | `g` | free | continuous | presses |
//! | touch | `g` | `g'` | continuous | presses |
//! | start, end of a zone | `g` | `g'` | `−EI g''` | presses |
//! | support | `d` | free, or `g'` as one that is level with the ground | continuous, or any jump that ground beside it makes | any |
//! | built in | `d` | `φ` | any jump | any |
//! | spring | `d + R/k`, as the witness says | free | continuous; any jump of one against turning | any |
//!
//! A node is described by what it does to the slope and by whether the beam lies on the ground from there to the next one. What
//! stands at its place, a support or nothing, is said by the scene. `M = 0` at the ends of the beam, and beyond the outermost
//! nodes `M` follows from the loads.

use super::gap::EnclosedGap;
use super::giving::{Giving, SaidSpring};
use super::interval::Interval;
use super::load::{EnclosedLoad, cells};
use super::span::Span;
use super::tension::Hung;
use crate::scene::{Beam, Scene};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Slope {
    /// That of the beam, a number of its own.
    Free(f64),
    /// That of the gap, from one of its sides.
    OfGround { from_the_left: bool },
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactNode {
    pub(crate) x: f64,
    /// Of the beam; where it is built in it is that of the support.
    pub(crate) slope: Slope,
    /// True where the beam lies on the ground from here to the next node.
    pub(crate) lies: bool,
}

/// A support: what it asks of the deflection.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedSupport {
    pub(crate) x: f64,
    /// `d`; where the ground is level with it but for rounding, the gap there.
    pub(crate) deflection: Interval,
    /// `φ`, where the beam is built in; where the ground has the same slope, as far as is known, that of the gap.
    pub(crate) slope: Option<Interval>,
    /// Whether the ground on its left and on its right side starts at its level.
    pub(crate) at_level: [bool; 2],
    /// And in its direction, where the beam is built in.
    pub(crate) tangent: [bool; 2],
    /// Whether no deflection that is admissible can turn there: the beam is built in, or the ground starts at the level of the
    /// support on both sides and is smooth, so that `v ≤ g` leaves no slope but `g'`.
    pub(crate) is_fixed: bool,
    /// What gives there.
    pub(crate) gives: Option<Giving>,
}

/// A dimensionless scene, taken apart: all that is known of it in intervals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedScene<'a> {
    pub(crate) gap: EnclosedGap<'a>,
    pub(crate) load: &'a EnclosedLoad,
    /// From left to right.
    pub(crate) supports: &'a [EnclosedSupport],
    /// The place above which the resultant of the loads is exactly, if it is the only one that can carry them: its couple
    /// vanishes, whatever rounding leaves of it.
    pub(crate) balanced_at: Option<f64>,
    /// The least bending stiffness, and the greatest one.
    pub(crate) stiffness: f64,
    pub(crate) stiffest: f64,
    pub(crate) length: f64,
    pub(crate) beam: &'a Beam,
    /// Of an elastic foundation: parts with one stiffness `k` each, from end to end; zero where there is none.
    pub(crate) ground: &'a [([f64; 2], f64)],
    /// Where the bending stiffness changes, and where joints are, with their stiffness; from left to right.
    pub(crate) changes: &'a [f64],
    pub(crate) joints: &'a [(f64, f64)],
    /// Supports that give, as loads.
    pub(crate) said: &'a [SaidSpring],
    /// `N`, and under it what is given of the deflection between contacts, from left to right, from anybody.
    pub(crate) tension: f64,
    pub(crate) hung: &'a [Hung],
}

impl EnclosedSupport {
    /// The supports of a dimensionless scene above a gap.
    pub(crate) fn of(scene: &Scene, gap: &EnclosedGap<'_>) -> Vec<Self> {
        let enclosed = scene.beam().supports().iter().zip(scene.held()).map(|(given, held)| {
            let x = given.at;
            let own = gap.shape.jet(x, false);
            let [at_level, tangent] = [held.at_level, held.tangent].map(|[left, right]| {
                // Behind a step that goes down there is no ground at the level of the support.
                [left && gap.ground.is_upper(x, true), right && gap.ground.is_upper(x, false)]
            });
            let slope = given.slope.filter(|_| given.is_built_in()).map(|slope| {
                let side = [0, 1].into_iter().find(|side| tangent[*side]);
                side.map_or(Interval::exact(slope) - own[1], |side| gap.jet(x, side == 0)[1])
            });
            let level = Interval::exact(given.level) - own[0];
            // Ground at the level of the support may be beside it by a rounding: the beam is at one of them.
            let deflection = if at_level[0] || at_level[1] { level.hull(gap.depth(x)) } else { level };
            let is_fixed = slope.is_some() || (tangent == [true; 2] && gap.is_smooth_at(x));
            let gives = given.turning_stiffness.map(|_| Giving::of(given, own));
            Self { x, deflection, slope, at_level, tangent, is_fixed, gives }
        });
        enclosed.collect()
    }

    /// A support that gives, as one at the level to which it gives under a force that is said.
    pub(crate) fn giving(x: f64, gives: Giving, force: f64) -> Self {
        let sunk = gives.spring.map_or(Interval::ZERO, |[k, d]| d + Interval::exact(force) / k);
        let beside = [false; 2];
        Self {
            x,
            deflection: sunk,
            slope: None,
            at_level: beside,
            tangent: beside,
            is_fixed: false,
            gives: Some(gives),
        }
    }

    /// Whether it only pushes.
    pub(crate) fn pushes(&self) -> bool {
        self.gives.is_some_and(|gives| gives.pushes)
    }

    /// Whether `M` may jump there without the ground.
    pub(crate) fn holds_slope(&self) -> bool {
        self.slope.is_some() || self.gives.is_some_and(|gives| gives.turning.is_some())
    }
}

impl EnclosedScene<'_> {
    /// The support at a place.
    pub(crate) fn support(&self, x: f64) -> Option<&EnclosedSupport> {
        self.supports.binary_search_by(|s| s.x.total_cmp(&x)).ok().map(|i| &self.supports[i])
    }

    /// Cells between two places, on each of which gap, load and beam have one formula, with these ends among others.
    pub(crate) fn cells(&self, from: f64, to: f64, ends: Vec<f64>) -> Vec<[f64; 2]> {
        cells(from, to, [ends, self.gap.breaks(from, to), self.breaks(from, to)].concat())
    }

    /// Where load, beam or stiffness of the foundation change their formula strictly between two places.
    pub(crate) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let mut breaks = self.load.breaks(from, to);
        let changes = self.changes.iter().copied().chain(self.joints.iter().map(|joint| joint.0));
        let changes = changes.chain(self.ground.iter().map(|(part, _)| part[0]));
        breaks.extend(changes.filter(|x| from < *x && *x < to));
        breaks
    }

    /// Whether the beam may turn at a place.
    pub(crate) fn is_joint(&self, x: f64) -> bool {
        self.joints.iter().any(|joint| joint.0.total_cmp(&x).is_eq())
    }

    /// `EI` between two places without a change between them.
    pub(crate) fn stiffness_between(&self, [from, to]: [f64; 2]) -> f64 {
        if self.changes.is_empty() { self.stiffness } else { self.beam.stiffness_between(from, to) }
    }

    /// `k` between two places without a change between them; zero where there is no elastic foundation.
    pub(crate) fn ground_between(&self, [from, to]: [f64; 2]) -> f64 {
        let middle = 0.5 * (from + to);
        let next = self.ground.partition_point(|(part, _)| part[0] <= middle);
        next.checked_sub(1).map_or(0.0, |i| self.ground[i].1)
    }

    /// The greatest `k`.
    pub(crate) fn stiffest_ground(&self) -> f64 {
        self.ground.iter().fold(0.0, |most, (_, k)| k.max(most))
    }

    /// The stiffness of a joint at a place, zero of a hinge.
    pub(crate) fn joint(&self, x: f64) -> Option<f64> {
        let here = self.joints.get(self.joints.partition_point(|joint| joint.0 < x));
        here.filter(|joint| joint.0 <= x).map(|joint| joint.1)
    }

    /// In which moments are counted where slopes are sought: over `EI` of a beam that does not change.
    pub(crate) fn unit(&self) -> f64 {
        if self.changes.is_empty() && self.joints.is_empty() { self.stiffness } else { 1.0 }
    }

    /// `EI` just beside a place.
    pub(crate) fn stiffness_beside(&self, x: f64, left: bool) -> Interval {
        let x = if left { x.next_down() } else { x.next_up() };
        Interval::exact(self.stiffness_between([x, x]))
    }

    /// `3 EI Σ 1/k` of all joints, as much as they may add to the square of a lever ([`super::reference`]) for a moment of one in each.
    pub(crate) fn soft(&self) -> f64 {
        let joints = self.joints.iter().filter(|joint| 0.0 < joint.1);
        let soft = joints.map(|joint| Interval::exact(3.0 * self.stiffness) / Interval::exact(joint.1));
        soft.fold(Interval::ZERO, |sum, one| sum + one).hi()
    }

    /// How the beam meets the gap at a node, on one of its sides: 2 with its deflection and its slope, so that the gap opens with
    /// the square of the distance or the beam follows it; 1 with its deflection alone; 0 not at all, as at the foot of a step.
    pub(crate) fn order(&self, node: &ContactNode, from_the_left: bool) -> usize {
        let support = self.support(node.x);
        let at_level = support.is_none_or(|s| s.at_level[usize::from(!from_the_left)]);
        let tangent = match (support.and_then(|s| s.slope), node.slope) {
            (Some(slope), _) => slope == self.gap.jet(node.x, from_the_left)[1],
            // In a joint the slope on the other side is another one.
            (None, Slope::OfGround { from_the_left: side }) => {
                side == from_the_left || self.gap.is_smooth_at(node.x) && !self.is_joint(node.x)
            }
            (None, Slope::Free(_)) => false,
        };
        if at_level && self.gap.ground.is_upper(node.x, from_the_left) { 1 + usize::from(tangent) } else { 0 }
    }

    /// `v` and `v'` of the beam at a node.
    pub(crate) fn end(&self, node: &ContactNode) -> [Interval; 2] {
        let support = self.support(node.x);
        let v = support.map_or_else(|| self.gap.depth(node.x), |s| s.deflection);
        let slope = match node.slope {
            Slope::Free(slope) => Interval::exact(slope),
            Slope::OfGround { from_the_left } => self.gap.jet(node.x, from_the_left)[1],
        };
        [v, support.and_then(|s| s.slope).unwrap_or(slope)]
    }

    /// The part between two nodes, or beyond an outermost one; [`None`] where the beam lies on the foundation, and where there is
    /// no beam.
    pub(crate) fn span(&self, left: Option<&ContactNode>, right: Option<&ContactNode>) -> Option<Span> {
        let place = |node: Option<&ContactNode>, end: f64| node.map_or(end, |node| node.x);
        let ends = [place(left, 0.0), place(right, self.length)];
        let hangs = ends[0] < ends[1] && !left.is_some_and(|node| node.lies);
        let known = || [left, right].map(|node| node.map(|node| self.end(node)));
        hangs.then(|| Span::new(self, ends, known(), self.rise(left, right)))
    }

    /// `v₁ − v₀ − θ₀ L` between two contacts, from what the gap rises by on each cell, so that rounding is that of slopes, and not that of
    /// depths; [`None`] across a step.
    pub(crate) fn rise(&self, left: Option<&ContactNode>, right: Option<&ContactNode>) -> Option<Interval> {
        let on_ground = |node: &&ContactNode| self.support(node.x).is_none();
        let (node, to) = (left.filter(on_ground)?, right.filter(on_ground)?.x);
        let risen = self.risen([node.x, to], self.end(node)[1]);
        risen.filter(|_| self.gap.is_continuous_at(node.x) && self.gap.is_continuous_at(to))
    }

    /// `g₁ − g₀ − θ L` between two places, each on its inner side, from what the gap rises by on each cell; [`None`] across a step.
    pub(crate) fn risen(&self, [from, to]: [f64; 2], slope: Interval) -> Option<Interval> {
        /// Of more lines the sum is no better known: *tuned* on smooth surveys of up to 10⁶ points. Cells of a curve take time: *tuned* on
        /// the scene of three waves, which takes 3 % more instructions than without.
        const MOST: [usize; 2] = [256, 4];
        let cells = cells(from, to, self.gap.breaks(from, to));
        let rises = |sum: Interval, &[a, b]: &[f64; 2]| {
            let line = self.gap.about(a, [a, b]);
            let is_continuous = to <= b || self.gap.is_continuous_at(b);
            let is_known = is_continuous && cells.len() <= MOST[usize::from(2 < line.coefficients().len())];
            is_known.then(|| sum + Interval::length(a, b) * (line.divided(1).at(Interval::length(a, b)) - slope))
        };
        cells.iter().try_fold(Interval::ZERO, rises)
    }
}

#[cfg(test)]
pub(super) mod tests;
