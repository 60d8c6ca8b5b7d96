//! The contacts of an answer in a neighbouring scene: its contact list is carried over and is right there, or it violates a condition
//! that can be named.

use super::check::{Check, check};
use super::exact::Exact;
use super::giving::faults_of_springs;
use super::list::{List, Node};
use super::margin::{Condition, all, stopped, violated_conditions};
use super::newton;
use super::piecewise::PiecewiseScene;
use super::search::Candidate;
use super::solve::solve_near;
use super::springs::Springs;
use crate::certificate::Slope;
use crate::scene::{Scale, Scene};

/// Work of an answer on two supports, however small its scene is.
const START: u64 = 50;

/// Work of each further support. *Tuned* on 500 to 4,000 of them: an answer and its bounds take 48 microseconds for each, and three
/// times as many units keep a sweep over thousands of supports within 20 seconds.
const OF_A_SUPPORT: usize = 150;

/// Work of each compression-only support. *Tuned* on 1,500 of them: a row and its bounds take 0.1 s.
const OF_A_BEARING: usize = 40;

/// Work of each sample of a chain that was solved to find the answer. *Tuned* on waves next to a force of 10¹³, where a search through
/// 38,000 samples takes 0.11 s: as much as the units of 2,300 point loads do.
const OF_A_SAMPLE: u64 = 15;

/// Work of a contact on waves, in pieces of straight foundation. *Tuned* on 1,000 waves that all touch: a row and its bounds take 0.15
/// s, thirty times as much as on a survey of 2,500 points, and a search for events on them has to end as soon.
const ON_A_WAVE: usize = 16;

/// Work of a part of the beam on an elastic foundation, in pieces of rigid foundation. *Tuned* on level foundations of stiffness 1 to
/// 10²⁰ and on polynomials: a solve takes 0.9 to 1.6 microseconds for each of its parts, and a sweep has 0.2 for a unit.
const OF_A_PART: usize = 5;

/// Work of the bounds, in multiples of the work of the lists.
const JUDGED: u64 = 7;

/// Work of the bounds of a part on an elastic foundation. *Tuned* on a level foundation of stiffness 10¹²: 5 ms for 103 parts.
const BOUNDS_OF_A_PART: usize = 250;

/// Newton steps for contacts that only move: close to the solution two steps double the digits up to the last one, and two more confirm
/// it.
const STEPS: usize = 4;

/// Work of making the scene and its spans and checking them once, in lists of a search. *Tuned* on 2,300 point loads: with this value
/// the work of a search for events, which is mostly of this kind, takes the same time per unit as other work.
const MOVED: usize = 4;

impl Exact {
    /// The conditions that the contacts of this solution violate in `scene` if they move but keep their kinds, as far as a condition
    /// can be followed from one scene to the other. If a contact cannot be continued, its condition is the only one. [`None`] if the
    /// contacts do not exist there for another reason.
    #[must_use]
    pub(crate) fn violated_conditions(&self, scene: &Scene) -> Option<Vec<Condition>> {
        let Carried { given, list, converged, .. } = self.carried_to(scene)?;
        if !converged {
            return stopped(&given, &list).map(|condition| vec![condition]);
        }
        let checked = check(&given, &list);
        // An elastic stop in tension, or an inactive one that the beam penetrates, is not a condition that can be followed.
        faults_of_springs(&given, &checked).is_empty().then_some(())?;
        Some(violated_conditions(&given, &list, &checked, &self.pattern().pulls))
    }

    /// This solution with its contacts moved to their positions in `scene`, if that is an answer there in which each support has a
    /// reaction of the same sign. If contacts carry nothing, or too little to count, one answer has several contact lists, and this one
    /// may differ from the list that [`solve_near`](super::solve_near) finds.
    #[must_use]
    pub fn moved(&self, scene: &Scene) -> Option<Self> {
        let carried = self.converged_in(scene)?;
        let checked = check(&carried.given, &carried.list);
        let violated = violated_conditions(&carried.given, &carried.list, &checked, &self.pattern().pulls);
        violated.is_empty().then(|| carried.answer(checked)).filter(|there| there.solved)
    }

    /// The answer in a neighbouring scene, if this one continues there: with its contacts moved but of the same kinds. If the contacts
    /// cannot be carried over, the answer is solved anew from this one.
    pub(super) fn continued_in(&self, scene: &Scene) -> Option<Self> {
        let there = match self.carried_to(scene) {
            Some(carried) if carried.converged => Some(carried.checked()),
            Some(_) => None,
            None => solve_near(scene, &[self]).ok(),
        };
        there.filter(|there| there.solved)
    }

    /// This answer with its contacts and its pressed stops in another scene, whether their conditions are satisfied there or not. On an
    /// elastic foundation the scene is solved anew.
    pub(super) fn kept_in(&self, scene: &Scene) -> Option<Self> {
        if self.is_rigid() {
            return self.converged_in(scene).map(Carried::checked);
        }
        solve_near(scene, &[self]).ok().filter(|there| there.solved)
    }

    /// The margin of a condition in `scene` for the contacts of this solution, moved but of the same kinds: a smooth function of the
    /// numbers of the scene, negative where the condition is violated. [`None`] where it is undefined.
    #[must_use]
    pub(crate) fn margin(&self, scene: &Scene, condition: Condition) -> Option<f64> {
        let Some(Carried { given, list, .. }) = self.converged_in(scene) else { return condition.without_list() };
        condition.value(&given, &list)
    }

    /// The margins in `scene` of all conditions that can be evaluated before they fail, for the contacts of this solution, moved but of
    /// the same kinds. [`None`] if there are no such contacts.
    #[must_use]
    pub(crate) fn margins(&self, scene: &Scene) -> Option<Vec<(Condition, f64)>> {
        let Carried { given, list, .. } = self.converged_in(scene)?;
        Some(all(&given, &list, &self.pattern().pulls))
    }

    /// The work to find this solution: a constant, plus the pieces of the scene and the nodes that are processed. A unit is about a
    /// microsecond.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.work_of_lists() + OF_A_SAMPLE * u64::try_from(self.samples).unwrap_or(u64::MAX)
    }

    /// The work to prove bounds for it, in the same units.
    #[must_use]
    pub(crate) fn work_of_bounds(&self) -> u64 {
        let parts = self.springs.as_ref().map_or(0, Springs::size);
        let lists = if self.springs.is_some() { 0 } else { JUDGED * self.work_of_lists() };
        lists + u64::try_from(parts * BOUNDS_OF_A_PART).unwrap_or(u64::MAX)
    }

    /// The work to find this solution without the chains from which its first lists came.
    fn work_of_lists(&self) -> u64 {
        self.work_of(self.lists, self.iterations)
    }

    /// The work to move its contacts to their positions in another scene, in the same units.
    pub(crate) fn work_to_move(&self) -> u64 {
        self.work_of(MOVED, STEPS)
    }

    fn work_of(&self, lists: usize, steps: usize) -> u64 {
        let on_waves = self.given.shapes.iter().any(|shape| shape.waves()[0].is_some());
        let nodes = self.list.nodes.len() * if on_waves { ON_A_WAVE } else { 1 };
        // Reading, scaling and adding up a point load takes as much again as the piece of the beam that it starts.
        let sunk = OF_A_PART * self.springs.as_ref().map_or(0, Springs::size);
        let pieces = self.given.cells.len() + sunk + self.given.forces().count();
        let passes = (lists + 1) * (pieces + nodes) + steps * nodes;
        // With thousands of supports this is nearly all of the work.
        let many =
            OF_A_SUPPORT * self.given.supports.len().saturating_sub(2) + OF_A_BEARING * self.given.bearings.len();
        START + u64::try_from(passes + many).unwrap_or(u64::MAX)
    }

    /// The list of this solution in `scene`, if Newton's method converged.
    fn converged_in(&self, scene: &Scene) -> Option<Carried> {
        self.carried_to(scene).filter(|carried| carried.converged)
    }

    /// The list of this solution with its positions in `scene`, on the elastic stops that are pressed here.
    fn carried_to(&self, scene: &Scene) -> Option<Carried> {
        scene.on_rigid_ground("a list of contacts").ok()?;
        let scaled = scene.scaled().ok()?;
        let acts = self.acting();
        let given = PiecewiseScene::with(&scaled.scene, |i| acts.get(i).copied().unwrap_or(true));
        let mut list = self.list_in(&given, &scaled.scale)?;
        let converged = newton::solve(&given, &mut list).converged;
        Some(Carried { units: scaled.units_over_stiffness(), given, list, converged })
    }

    /// The list of this solution in a neighbouring scene as a starting point; [`None`] if its nodes do not exist there.
    pub(super) fn list_in(&self, to: &PiecewiseScene, units: &Scale) -> Option<List> {
        let from = &self.given;
        if self.springs.is_some()
            || from.shapes.len() != to.shapes.len()
            || from.supports.len() != to.supports.len()
            || from.bearings.len() != to.bearings.len()
            || from.free_ends != to.free_ends
        {
            return None;
        }
        let unit = self.units.length / units.length;
        // v' is measured in U/L.
        let slope = self.units.depth / units.depth / unit;
        let nodes = (0..self.list.nodes.len()).map(|i| carried(&self.list, i, from, to, [unit, slope]));
        let list = List { nodes: nodes.collect::<Option<_>>()? };
        let ordered = list.nodes.windows(2).all(|pair| pair[0].x < pair[1].x);
        ordered.then_some(list)
    }
}

/// The contacts of an answer in another scene.
struct Carried {
    given: PiecewiseScene,
    list: List,
    units: Scale,
    /// Whether Newton's method converged; otherwise the positions are not those of a solution.
    converged: bool,
}

impl Carried {
    /// The answer with these contacts; it is solved if all conditions are satisfied.
    fn checked(self) -> Exact {
        let checked = check(&self.given, &self.list);
        self.answer(checked)
    }

    /// The same answer, from the check of its contacts.
    fn answer(self, checked: Check) -> Exact {
        let Self { given, list, units, converged } = self;
        let wrong = faults_of_springs(&given, &checked);
        let found = Candidate { list, checked, steps: 0, lists: 1, samples: 0, converged }.with(wrong);
        Exact::new(given, found, units)
    }
}

/// Node `i` of a list in another scene; `unit` and `slope` convert positions and slopes to the units of that scene.
fn carried(list: &List, i: usize, from: &PiecewiseScene, to: &PiecewiseScene, [unit, slope]: [f64; 2]) -> Option<Node> {
    let node = &list.nodes[i];
    let Some(breakpoint) = node.breakpoint else { return moved(node, from, to, unit) };
    let at = match (node.support(from), breakpoint) {
        (Some(index), _) => {
            let support = to.supports.get(index)?;
            let tangent =
                list.follows_foundation(i).into_iter().zip(support.tangent).all(|(rests, tangent)| tangent || !rests);
            tangent.then_some(support.breakpoint)?
        }
        (None, bearing) if from.is_bearing(bearing) => to.bearings[from.bearings.binary_search(&bearing).ok()?],
        (None, 0) => 0,
        (None, last) if last == from.cells.len() => to.cells.len(),
        (None, inner) => to.breakpoint_at(*to.ends.get(from.cells[inner].shape.checked_sub(1)?)?)?,
    };
    let turned = match node.slope {
        Slope::Free(own) => Slope::Free(own * slope),
        of_ground @ Slope::OfGround { .. } => of_ground,
    };
    let carried = Node { slope: turned, lies: node.lies, low: node.low * slope, ..Node::at(to, at) };
    (!node.is_edge(from) || to.is_edge(at)).then_some(carried)
}

/// A node in another scene that moves along a smooth piece of the profile.
// Held by: sweep::events::contacts_move_with_a_joint, for pieces that have moved.
fn moved(node: &Node, from: &PiecewiseScene, to: &PiecewiseScene, unit: f64) -> Option<Node> {
    let shape = from.cells[node.cell].shape;
    // The first cell of that piece to the right of the same support.
    let supports = from.supports.partition_point(|support| support.breakpoint <= node.cell);
    let support = supports.checked_sub(1).map_or(0, |i| to.supports[i].breakpoint);
    let first = to.cells.partition_point(|cell| cell.shape < shape).max(support).min(to.cells.len() - 1);
    let (lo, hi) = to.reach(first);
    // If the piece of the profile has moved, its contacts move with it.
    let was = from.reach(node.cell);
    let x = node.x * unit;
    let inside = lo <= x && x <= hi;
    let x = if inside { x } else { lo + (node.x - was.0) / (was.1 - was.0) * (hi - lo) };
    let cell = [to.cell_from(x), to.cell_to(x)].into_iter().find(|&cell| to.cells[cell].shape == shape)?;
    let low = if inside { node.low * unit } else { 0.0 };
    Some(Node { x, low, cell, ..*node })
}
