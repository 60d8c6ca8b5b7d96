//! The margin of an answer before a condition fails: a small change of a number that reaches no condition needs no second answer.
//!
//! To the first order, module `sensitivity` gives the changes of nodes and beam. A condition is still satisfied if its margin is more
//! than twice the change. This module covers the simple conditions: supports, which always hold; contacts that press at a fixed
//! position; and spans that are clear of everything below them. Where a contact can move, or a span begins on the foundation, the
//! change must be rounding, as it is at a distance of a few dozen supports. All other cases need a second answer, as do numbers that
//! change the whole beam.

use super::exact::Exact;
use super::list::Node;
use super::margin::lowest;
use super::piecewise::PiecewiseScene;
use super::sensitivity::{Change, NodeChange};
use super::span::Span;
use crate::scene::Scene;

/// Safety factor of a change: terms beyond the first order are far smaller than the change itself.
const SAFE: f64 = 2.0;

/// Rounding as a share of the largest deflection, moment, force or length: a millionth of the tolerance of a condition.
const ROUNDING: f64 = 1e-6 * super::check::TOLERANCE;

/// Largest movement for which the first order is enough, as a share of the distance to the next position.
const NEAR: f64 = 1e-2;

/// Smallest overturning margin that no small change can use up, as a share of the distance between the positions that carry the beam.
const STANDS: f64 = 1e-2;

/// The condition at a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// None: a support that holds the beam.
    Holds,
    /// The node presses, at its fixed position.
    Presses,
    /// More than that: the node can move, or the foundation fixes the slope of the beam.
    Rests,
}

impl Kind {
    fn of(given: &PiecewiseScene, node: &Node) -> Self {
        match node.support(given) {
            _ if node.can_move() || node.is_held() || node.rests_at_support(given) => Self::Rests,
            Some(_) => Self::Holds,
            None => Self::Presses,
        }
    }
}

/// A span, or an overhang.
#[derive(Debug)]
struct Free {
    /// Index of the node to its right.
    node: usize,
    /// Both ends.
    ends: [f64; 2],
    overhangs: bool,
    /// The least clearance in it, zero if it begins or ends on the foundation.
    clearance: f64,
}

/// The margins of all conditions of an answer; all numbers are dimensionless.
#[derive(Debug)]
pub(super) struct Leeway<'a> {
    exact: &'a Exact,
    kinds: Vec<Kind>,
    spans: Vec<Free>,
    /// Positions of the supports and of the ends of the beam, from left to right.
    places: Vec<f64>,
    /// For each rigid compression-only support that is not in contact: the clearance to the support, and the slope of the beam.
    lifted: Vec<Option<[f64; 2]>>,
    deflection: f64,
    moment: f64,
    force: f64,
}

impl<'a> Leeway<'a> {
    /// The margins of an answer of `scene`. [`None`] if a second answer is always needed: for an answer that is not solved, for a beam
    /// with an initial shape or on an elastic foundation, and close to overturning.
    pub(super) fn of(exact: &'a Exact, scene: &Scene) -> Option<Self> {
        let (given, units) = (&exact.given, &exact.units);
        let stands = exact.state.standing.is_none_or(|standing| standing.motion.is_none() && STANDS <= standing.margin);
        if !exact.solved || exact.springs.is_some() || !stands || scene.beam().shape().is_some() {
            return None;
        }
        let supports = given.supports.iter().map(|support| support.breakpoint).chain(given.bearings.iter().copied());
        let mut places: Vec<f64> = supports.map(|i| given.breakpoints[i].x).chain([0.0, given.length]).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut pressing: Vec<usize> = exact.list.nodes.iter().filter_map(|node| node.breakpoint).collect();
        pressing.sort_unstable();
        let lifted = |&i: &usize| {
            let at = given.breakpoints[i].x * units.length;
            let clearance = given.breakpoints[i].depth - exact.deflection(at) / units.depth;
            pressing.binary_search(&i).is_err().then(|| [clearance, exact.slope(at) / units.slope()])
        };
        let forces = exact.state.supports.iter().map(|support| support.force.abs());
        let contacts =
            exact.listed.iter().flat_map(|c| [c.force.abs()].into_iter().chain(c.end_forces.unwrap_or_default()));
        Some(Self {
            exact,
            kinds: exact.list.nodes.iter().map(|node| Kind::of(given, node)).collect(),
            spans: exact.spans.iter().map(|(node, span)| Free::of(exact, *node, span)).collect(),
            places,
            lifted: given.bearings.iter().map(lifted).collect(),
            deflection: exact.state.deflection.magnitude() / units.depth,
            moment: exact.state.moment.magnitude() / units.moment(),
            force: forces.chain(contacts).fold(0.0, f64::max) / units.force,
        })
    }

    /// Whether the contacts of the answer are certain to remain, with changes of forces up to `near` of the largest, when a number
    /// changes by `step` to either side; `changes` are the changes of the nodes per unit of the number.
    pub(super) fn contacts_remain(&self, of: Change, changes: &[NodeChange], step: f64, near: f64) -> bool {
        self.has_room(of, step)
            && changes.iter().enumerate().all(|(i, change)| {
                SAFE * (change.force * step).abs() <= near * self.force && self.node_holds(of, i, change, step)
            })
            && self.spans.iter().all(|free| self.stays_clear(of, free, changes, step))
    }

    /// Whether the changed load or support has room to move, so that there are scenes on both sides.
    fn has_room(&self, of: Change, step: f64) -> bool {
        let given = &self.exact.given;
        let index = match of {
            Change::Force(..) => return true,
            Change::Move(at, _) => return step < at && at + step < given.length,
            Change::Level(index) | Change::Support(index, _) => index,
            // These change the whole beam.
            Change::Ground | Change::GroundUnder(..) | Change::Unload | Change::Stiffen | Change::Uniform(_) => {
                return false;
            }
        };
        let moves = matches!(of, Change::Support(..));
        let bearing = index.checked_sub(given.supports.len());
        let breakpoint = bearing.map_or_else(|| given.supports[index].breakpoint, |bearing| given.bearings[bearing]);
        let x = given.breakpoints[breakpoint].x;
        let i = self.places.partition_point(|place| *place < x);
        let beside = [i.checked_sub(1), Some(i + 1)].map(|i| i.and_then(|i| self.places.get(i)));
        let is_inside = beside.iter().all(|other| other.is_some_and(|other| step <= NEAR * (other - x).abs()));
        if moves && !is_inside {
            return false;
        }
        // The foundation has to remain below the support, and a beam without contact above it.
        let Some(bearing) = bearing else { return true };
        let above = !given.founded
            || given.cells_beside(breakpoint).iter().all(|&cell| {
                let slope = given.derivative(cell, x, 1).abs();
                SAFE * step * if moves { slope } else { 1.0 } < given.height(breakpoint, cell)
            });
        above
            && self.lifted[bearing]
                .is_none_or(|[clearance, slope]| SAFE * step * if moves { slope.abs() } else { 1.0 } < clearance)
    }

    /// Whether the condition at a node remains satisfied.
    #[expect(clippy::float_cmp, reason = "a load at a node is exactly there")]
    fn node_holds(&self, of: Change, i: usize, change: &NodeChange, step: f64) -> bool {
        let (given, x) = (&self.exact.given, self.exact.list.nodes[i].x);
        match self.kinds[i] {
            Kind::Holds => true,
            Kind::Presses => SAFE * step * change.force.abs() < self.exact.forces[i],
            Kind::Rests => {
                let passes = matches!(of, Change::Move(at, _) if x != at && (x - at).abs() <= SAFE * step);
                let [left, right] = change.slopes.map(f64::abs);
                !passes
                    && step * change.place.abs() <= ROUNDING * given.length
                    && step * change.force.abs() <= ROUNDING * self.force
                    && step * change.value.abs().max(given.length * left.max(right)) <= ROUNDING * self.deflection
            }
        }
    }

    /// Whether a span remains clear of everything below it.
    fn stays_clear(&self, of: Change, free: &Free, changes: &[NodeChange], step: f64) -> bool {
        if free.clearance == f64::INFINITY {
            return true;
        }
        let sag = step * free.most(of, changes);
        let l = free.ends[1] - free.ends[0];
        SAFE * sag <= free.clearance || sag <= ROUNDING * self.deflection && sag / (l * l) <= ROUNDING * self.moment
    }
}

impl Free {
    fn of(exact: &Exact, node: usize, span: &Span) -> Self {
        let given = &exact.given;
        let ends = [(0.0 < span.a.x || node > 0, span.at_a[0]), (node < exact.list.nodes.len(), span.at_b[0])];
        let held = ends.into_iter().filter(|(held, _)| *held && given.founded).map(|(_, height)| height);
        let inside = if given.has_obstacle() { lowest(given, span) } else { None };
        let clearance = held.chain(inside).fold(f64::INFINITY, f64::min).max(0.0);
        Self { node, ends: [span.a.x, span.b.x], overhangs: span.is_overhang(), clearance }
    }

    /// Upper bound of the change `w` of the deflection in the span. Between two nodes `|w|` is at most the change of the chord plus
    /// `4/27 ℓ (|φ_a| + |φ_b|)` for the slopes relative to it, plus `P ℓ³/192` for a load, or `P ℓ²/27` for a load that moves.
    fn most(&self, of: Change, changes: &[NodeChange]) -> f64 {
        let [from, to] = self.ends;
        let l = to - from;
        let of_load = match of {
            Change::Force(at, p) if from <= at && at <= to => {
                p.abs() * l * l * l / if self.overhangs { 3.0 } else { 192.0 }
            }
            Change::Move(at, p) if from <= at && at <= to => p.abs() * l * l / if self.overhangs { 1.0 } else { 27.0 },
            _ => 0.0,
        };
        if self.overhangs {
            let (node, side) = if self.node == 0 { (0, 0) } else { (self.node - 1, 1) };
            return changes[node].value.abs() + l * changes[node].slopes[side].abs() + of_load;
        }
        let (a, b) = (&changes[self.node - 1], &changes[self.node]);
        let chord = (b.value - a.value) / l;
        let turned = (a.slopes[1] - chord).abs() + (b.slopes[0] - chord).abs();
        a.value.abs().max(b.value.abs()) + 4.0 / 27.0 * l * turned + of_load
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load, PointLoad, Support};
    use crate::theory;

    /// Supports of a few levels at every unit, some of them compression-only, with loads between some of them, and a foundation.
    fn scene(fields: u32, ground: Option<Foundation>) -> Scene {
        let level = |i: u32| 0.004 * f64::from(i * i % 7);
        let support = |i: u32| match i % 9 {
            4 => Support { level: level(i) + 0.02, ..Support::pushing(f64::from(i)) },
            _ => Support { level: level(i), ..Support::simple(f64::from(i)) },
        };
        let beam = Beam::new(f64::from(fields), 1.0).expect("a beam");
        let beam = beam.with_supports((0..=fields).map(support).collect()).expect("supports");
        let points = (2..fields).step_by(10).map(|i| PointLoad { at: f64::from(i) + 0.3, force: 0.5 });
        let load = Load::new(&beam, 1.0, Vec::new(), points.collect()).expect("a load");
        Scene::new(beam, load, ground).expect("a scene")
    }

    /// Without a foundation, with one far below, and with one that reaches the beam at midspan.
    fn scenes(fields: u32) -> [Scene; 3] {
        let middle = f64::from(fields) / 2.0 + 0.45;
        let points =
            vec![[0.0, 1.0], [middle - 0.3, 1.0], [middle, 0.01], [middle + 0.3, 1.0], [f64::from(fields), 1.0]];
        [None, Some(Foundation::Flat { depth: 1.0 }), Some(Foundation::Polyline { points })].map(|g| scene(fields, g))
    }

    /// Numbers of a scene decided without a second answer, and those that need one; checks the decisions against second answers.
    fn decided(scene: &Scene) -> (usize, usize) {
        let exact = theory::solve(scene).expect("an answer");
        assert!(exact.solved, "{:?}", exact.violations);
        let (leeway, linear) = (Leeway::of(&exact, scene).expect("held"), exact.sensitivity().expect("held"));
        let all = exact.variations(scene);
        let of = |variation: &&super::super::variation::Variation| {
            variation.is_certain_to_continue(&leeway, &linear.on_both_sides(variation.change))
        };
        let decided: Vec<_> = all.iter().filter(of).collect();
        for variation in &decided {
            assert_eq!(variation.continues_beside(scene, &exact), [true; 2], "{variation:?}");
        }
        (decided.len(), all.len() - decided.len())
    }

    /// Decisions without a second answer agree with second answers. With many supports, the number of second answers does not grow.
    #[test]
    fn of_many_supports_few_numbers_take_a_second_answer() {
        let counts = [60, 120, 240].map(|fields| scenes(fields).map(|scene| decided(&scene)));
        for kind in 0..3 {
            let second = counts.map(|counts| counts[kind].1);
            assert!(second[2] <= second[0].max(second[1]) && second[0] <= 100, "{counts:?}");
        }
    }
}
