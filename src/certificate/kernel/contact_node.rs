//! Contact nodes: the supports of a scene and the contacts of a candidate contact list, as positions in an enclosed scene.
//!
//! Between two neighbouring nodes the beam either hangs free or is in contact with the foundation. Beyond the outermost nodes it hangs
//! free.
//!
//! | node | `v` | `v'` | `M` | force |
//! |---|---|---|---|---|
//! | corner, compression-only support | `g` | free | continuous | upwards |
//! | touch | `g` | `g'` | continuous | upwards |
//! | start, end of a zone | `g` | `g'` | `−EI g''` | upwards |
//! | support | `d` | free, or `g'` if level with the foundation | continuous, or any jump that the foundation beside it can cause | any |
//! | built-in support | `d` | `φ` | any jump | any |
//! | elastic support | `d + R/k`, with `R` from the list | free | continuous; any jump if it has a rotational spring | any |
//!
//! A node stores its slope and whether the beam is in contact with the foundation from there to the next node. Whether a support is at
//! its position follows from the scene. `M = 0` at the ends of the beam, and beyond the outermost nodes `M` follows from the loads.

use super::gap::EnclosedGap;
use super::giving::{Giving, SaidSpring};
use super::interval::Interval;
use super::load::{EnclosedLoad, cells};
use super::span::Span;
use super::tension::Hung;
use crate::scene::{Beam, Scene};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Slope {
    /// The slope of the beam, a number independent of the foundation.
    Free(f64),
    /// The slope of the gap, on one of its sides.
    OfGround { from_the_left: bool },
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactNode {
    pub(crate) x: f64,
    /// Slope of the beam; at a built-in support the slope of the support replaces it.
    pub(crate) slope: Slope,
    /// True if the beam is in contact with the foundation from here to the next node.
    pub(crate) lies: bool,
}

/// A support: the conditions that it sets on the deflection.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedSupport {
    pub(crate) x: f64,
    /// `d`; if the foundation is level with the support up to rounding, this includes the gap there.
    pub(crate) deflection: Interval,
    /// `φ` of a built-in support; if the foundation has the same slope up to rounding, the slope of the gap.
    pub(crate) slope: Option<Interval>,
    /// Whether the foundation on its left and on its right side starts at its level.
    pub(crate) at_level: [bool; 2],
    /// Whether the foundation also starts in its direction, for a built-in support.
    pub(crate) tangent: [bool; 2],
    /// Whether every admissible deflection has the same slope there. The beam is built in, or the foundation starts at the level of
    /// the support on both sides and is smooth, so that `v ≤ g` allows no slope except `g'`.
    pub(crate) is_fixed: bool,
    /// The springs of the support, if it has any.
    pub(crate) gives: Option<Giving>,
}

/// A dimensionless scene with all its data as intervals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedScene<'a> {
    pub(crate) gap: EnclosedGap<'a>,
    pub(crate) load: &'a EnclosedLoad,
    /// From left to right.
    pub(crate) supports: &'a [EnclosedSupport],
    /// The position of the resultant of the loads, if it is exactly above the only contact that can carry them. The couple of the loads
    /// about it is zero, whatever rounding leaves of it.
    pub(crate) balanced_at: Option<f64>,
    /// The least bending stiffness, and the greatest one.
    pub(crate) stiffness: f64,
    pub(crate) stiffest: f64,
    pub(crate) length: f64,
    pub(crate) beam: &'a Beam,
    /// Parts of an elastic foundation with one stiffness `k` each, from end to end; `k` is zero where there is no elastic foundation.
    pub(crate) ground: &'a [([f64; 2], f64)],
    /// Positions where the bending stiffness changes, and joints with their stiffness; from left to right.
    pub(crate) changes: &'a [f64],
    pub(crate) joints: &'a [(f64, f64)],
    /// Elastic supports that are treated as loads.
    pub(crate) said: &'a [SaidSpring],
    /// `N`, and under an axial force the proposed deflection between contacts, from left to right, from any source.
    pub(crate) tension: f64,
    pub(crate) hung: &'a [Hung],
}

impl EnclosedSupport {
    /// The supports of a dimensionless scene, with the given gap.
    pub(crate) fn of(scene: &Scene, gap: &EnclosedGap<'_>) -> Vec<Self> {
        let enclosed = scene.beam().supports().iter().zip(scene.held()).map(|(given, held)| {
            let x = given.at;
            let own = gap.shape.jet(x, false);
            let [at_level, tangent] = [held.at_level, held.tangent].map(|[left, right]| {
                // Past a downward step there is no foundation at the level of the support.
                [left && gap.ground.is_upper(x, true), right && gap.ground.is_upper(x, false)]
            });
            let slope = given.slope.filter(|_| given.is_built_in()).map(|slope| {
                let side = [0, 1].into_iter().find(|side| tangent[*side]);
                side.map_or(Interval::exact(slope) - own[1], |side| gap.jet(x, side == 0)[1])
            });
            let level = Interval::exact(given.level) - own[0];
            // A foundation at the level of the support can differ from it by rounding, so the deflection encloses both levels.
            let deflection = if at_level[0] || at_level[1] { level.hull(gap.depth(x)) } else { level };
            let is_fixed = slope.is_some() || (tangent == [true; 2] && gap.is_smooth_at(x));
            let gives = given.turning_stiffness.map(|_| Giving::of(given, own));
            Self { x, deflection, slope, at_level, tangent, is_fixed, gives }
        });
        enclosed.collect()
    }

    /// An elastic support as one at the level to which it settles under a given force.
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

    /// Whether it is a compression-only support.
    pub(crate) fn pushes(&self) -> bool {
        self.gives.is_some_and(|gives| gives.pushes)
    }

    /// Whether `M` may jump there without the foundation.
    pub(crate) fn holds_slope(&self) -> bool {
        self.slope.is_some() || self.gives.is_some_and(|gives| gives.turning.is_some())
    }
}

impl EnclosedScene<'_> {
    /// The support at a position.
    pub(crate) fn support(&self, x: f64) -> Option<&EnclosedSupport> {
        self.supports.binary_search_by(|s| s.x.total_cmp(&x)).ok().map(|i| &self.supports[i])
    }

    /// Cells between two positions, on each of which gap, load and beam have one formula. The given `ends` are ends of cells too.
    pub(crate) fn cells(&self, from: f64, to: f64, ends: Vec<f64>) -> Vec<[f64; 2]> {
        cells(from, to, [ends, self.gap.breaks(from, to), self.breaks(from, to)].concat())
    }

    /// Positions strictly between two others where load, beam or foundation stiffness change their formula.
    pub(crate) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let mut breaks = self.load.breaks(from, to);
        let changes = self.changes.iter().copied().chain(self.joints.iter().map(|joint| joint.0));
        let changes = changes.chain(self.ground.iter().map(|(part, _)| part[0]));
        breaks.extend(changes.filter(|x| from < *x && *x < to));
        breaks
    }

    /// Whether a joint, elastic or a hinge, is at a position.
    pub(crate) fn is_joint(&self, x: f64) -> bool {
        self.joints.iter().any(|joint| joint.0.total_cmp(&x).is_eq())
    }

    /// `EI` between two positions without a change between them.
    pub(crate) fn stiffness_between(&self, [from, to]: [f64; 2]) -> f64 {
        if self.changes.is_empty() { self.stiffness } else { self.beam.stiffness_between(from, to) }
    }

    /// `k` between two positions without a change between them; zero where there is no elastic foundation.
    pub(crate) fn ground_between(&self, [from, to]: [f64; 2]) -> f64 {
        let middle = 0.5 * (from + to);
        let next = self.ground.partition_point(|(part, _)| part[0] <= middle);
        next.checked_sub(1).map_or(0.0, |i| self.ground[i].1)
    }

    /// The greatest `k`.
    pub(crate) fn stiffest_ground(&self) -> f64 {
        self.ground.iter().fold(0.0, |most, (_, k)| k.max(most))
    }

    /// The stiffness of the joint at a position, zero for a hinge.
    pub(crate) fn joint(&self, x: f64) -> Option<f64> {
        let here = self.joints.get(self.joints.partition_point(|joint| joint.0 < x));
        here.filter(|joint| joint.0 <= x).map(|joint| joint.1)
    }

    /// The unit of moments in the system of equations for the slopes: `EI` if the beam is uniform, otherwise 1.
    pub(crate) fn unit(&self) -> f64 {
        if self.changes.is_empty() && self.joints.is_empty() { self.stiffness } else { 1.0 }
    }

    /// `EI` just to one side of a position.
    pub(crate) fn stiffness_beside(&self, x: f64, left: bool) -> Interval {
        let x = if left { x.next_down() } else { x.next_up() };
        Interval::exact(self.stiffness_between([x, x]))
    }

    /// `3 EI Σ 1/k` of all joints: the most that they add to the square of a lever ([`super::reference`]) for a unit moment in each.
    pub(crate) fn soft(&self) -> f64 {
        let joints = self.joints.iter().filter(|joint| 0.0 < joint.1);
        let soft = joints.map(|joint| Interval::exact(3.0 * self.stiffness) / Interval::exact(joint.1));
        soft.fold(Interval::ZERO, |sum, one| sum + one).hi()
    }

    /// How the beam meets the gap at a node, on one of its sides. 2: deflection and slope are equal, so that the gap opens with the
    /// square of the distance or the beam follows it. 1: only the deflection is equal. 0: neither is, as at the foot of a step.
    pub(crate) fn order(&self, node: &ContactNode, from_the_left: bool) -> usize {
        let support = self.support(node.x);
        let at_level = support.is_none_or(|s| s.at_level[usize::from(!from_the_left)]);
        let tangent = match (support.and_then(|s| s.slope), node.slope) {
            (Some(slope), _) => slope == self.gap.jet(node.x, from_the_left)[1],
            // Beyond a joint the slope is a different one.
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

    /// The part between two nodes, or beyond an outermost one; [`None`] where the beam is in contact with the foundation, or where the
    /// part has no length.
    pub(crate) fn span(&self, left: Option<&ContactNode>, right: Option<&ContactNode>) -> Option<Span> {
        let place = |node: Option<&ContactNode>, end: f64| node.map_or(end, |node| node.x);
        let ends = [place(left, 0.0), place(right, self.length)];
        let hangs = ends[0] < ends[1] && !left.is_some_and(|node| node.lies);
        let known = || [left, right].map(|node| node.map(|node| self.end(node)));
        hangs.then(|| Span::new(self, ends, known(), self.rise(left, right)))
    }

    /// `v₁ − v₀ − θ₀ L` between two contacts, from the rise of the gap on each cell, so that the rounding has the size of slopes and not
    /// of depths; [`None`] across a step.
    pub(crate) fn rise(&self, left: Option<&ContactNode>, right: Option<&ContactNode>) -> Option<Interval> {
        let on_ground = |node: &&ContactNode| self.support(node.x).is_none();
        let (node, to) = (left.filter(on_ground)?, right.filter(on_ground)?.x);
        let risen = self.risen([node.x, to], self.end(node)[1]);
        risen.filter(|_| self.gap.is_continuous_at(node.x) && self.gap.is_continuous_at(to))
    }

    /// `g₁ − g₀ − θ L` between two positions, each on its inner side, from the rise of the gap on each cell; [`None`] across a step.
    pub(crate) fn risen(&self, [from, to]: [f64; 2], slope: Interval) -> Option<Interval> {
        /// For more lines the sum is no more accurate: *tuned* on smooth surveys of up to 10⁶ points. Cells of a curve are expensive:
        /// *tuned* on the scene of three waves, which needs 3 % more instructions than without.
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
