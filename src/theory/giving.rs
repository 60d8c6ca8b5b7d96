//! Elastic supports: their forces on the beam, and which compression-only ones are pressed.
//!
//! An active spring is a division point of a chain ([`super::divided`]). A loop on the set of active compression-only springs finds the
//! pressed ones:
//!
//! ```text
//! B ← all;    repeat  v ← the beam on B and the two-way springs;  B ← B − { R < 0 } + { v > d },    until B stays
//! ```
//!
//! Starting with all of them, the beam has more supports than it needs. All springs on the wrong side are exchanged at once as long as
//! their number falls. After that they are exchanged one at a time, the last one first, which terminates for a linear problem (Murty
//! 1974). With contact the problem is only piecewise linear, so the work is limited.

use super::check::{Check, TOLERANCE};
use super::exact::Exact;
use super::list::List;
use super::piece::derivatives;
use super::piecewise::{AtSpring, Breakpoint, PiecewiseScene};
use super::search::Candidate;
use super::solve::TheoryError;
use super::span::Span;
use super::violation::Violation;
use crate::scene::Scene;
use crate::state::Contact;

/// Number of exchanges of all wrong springs at once without a better set than before. *Tuned*: any small number will do, since single
/// exchanges follow.
const PATIENCE: usize = 3;

/// Force and couple of an elastic support on the beam.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpringState {
    /// `R`, upwards.
    pub(super) force: f64,
    /// The jump of `M` that the support causes.
    pub(super) couple: f64,
    /// `M` just to the left and just to the right of it.
    pub(super) moments: [f64; 2],
}

/// The state of each elastic support; `spans` are the spans of the list.
pub(super) fn spring_states(given: &PiecewiseScene, list: &List, spans: &[(usize, Span)]) -> Vec<SpringState> {
    let most = |order: usize| {
        let ends = spans.iter().flat_map(|(_, span)| [span.beam_a[order], span.beam_b[order]]);
        ends.fold(0.0, |most: f64, value| most.max(value.abs()))
    };
    let most = if given.springs.is_empty() { [0.0; 2] } else { [most(0), most(1)] };
    given.springs.iter().map(|spring| state(given, list, spans, spring, most)).collect()
}

/// The state of one elastic support; `most` are the largest deflection and slope, of which rounding is a share.
fn state(
    given: &PiecewiseScene,
    list: &List,
    spans: &[(usize, Span)],
    spring: &AtSpring,
    most: [f64; 2],
) -> SpringState {
    if !spring.acts {
        return SpringState::default();
    }
    let at = &given.breakpoints[spring.breakpoint];
    let is_here = |x: f64| x.total_cmp(&at.x).is_eq();
    let span = |i: usize| spans.get(i).map(|(_, span)| span);
    let before = span(spans.partition_point(|(_, span)| span.b.x < at.x)).filter(|span| is_here(span.b.x));
    let after = span(spans.partition_point(|(_, span)| span.a.x < at.x)).filter(|span| is_here(span.a.x));
    let nodes = &list.nodes;
    let next = nodes.partition_point(|node| node.x < at.x);
    let node = nodes.get(next).filter(|node| is_here(node.x)).map(|_| next);
    let zone = node.is_none() && list.in_zone_before(next);
    let (left, right) = (before.map(|span| span.beam_b), after.map(|span| span.beam_a));
    // Where the beam is in contact on a side, its deflection is the gap.
    let cells = given.cells_beside(spring.breakpoint);
    let on_ground = [0, 1].map(|side| {
        let lies = zone || node.is_some_and(|node| list.in_zone_before(node + side));
        lies.then(|| given.derivatives(cells[side], at.x))
    });
    let sides = [left.or(on_ground[0]), right.or(on_ground[1])];
    let Some([v, slope, ..]) = sides[1].or(sides[0]) else { return SpringState::default() };
    let moments = sides.map(|side| side.map_or(0.0, |beam| -beam[2]));
    let shears = vertical(given, at, sides);
    let touches = zone || node.is_some();
    let v = if touches { at.depth } else { v };
    let jump = shears[1] - shears[0] + at.acts.force();
    let size = if touches { f64::INFINITY } else { shears[0].abs() + shears[1].abs() + at.acts.force().abs() };
    let size = if given.tension == 0.0 { size } else { size + (given.tension * slope).abs() };
    let force = spring_force(spring.stiffness, [v, spring.level], jump, [most[0], size]);
    let couple = spring.turning.map_or(0.0, |[k, without]| {
        let jump = moments[1] - moments[0] + at.acts.couple();
        let size = moments[0].abs() + moments[1].abs() + at.acts.couple().abs();
        match node {
            // This includes the low-order part of a free slope.
            Some(node) => at.acts.couple() - nodes[node].couple(given),
            None => spring_force(-k, [slope, without], jump, [most[1], if zone { f64::INFINITY } else { size }]),
        }
    });
    SpringState { force, couple, moments }
}

/// The vertical forces `V + N v'` next to a breakpoint, zero beyond the ends of the beam; without `N v'` where the slope is continuous.
fn vertical(given: &PiecewiseScene, at: &Breakpoint, sides: [Option<[f64; 4]>; 2]) -> [f64; 2] {
    let turns = given.tension != 0.0 && (at.x <= 0.0 || given.length <= at.x || at.is_jointed());
    sides.map(|side| side.map_or(0.0, |beam| if turns { given.tension * beam[1] - beam[3] } else { -beam[3] }))
}

/// The force of a spring, from its displacement or from the jump of the shear force. The displacement of a stiff spring has no digits,
/// nor has the jump at a soft one, which is the difference of numbers of this `size`. Rounding of the displacement is a share of
/// `most`.
pub(super) fn spring_force(k: f64, [given, without]: [f64; 2], jump: f64, [most, size]: [f64; 2]) -> f64 {
    if k.abs() * (most + without.abs()) <= size { k * (given - without) } else { jump }
}

/// The compression-only springs that would be in tension, and the inactive ones that the beam would penetrate, each with its index.
pub(super) fn faults_of_springs(given: &PiecewiseScene, checked: &Check) -> Vec<(usize, Violation)> {
    let (nothing, force) = (checked.nothing().depth, checked.largest_force());
    let fault = |(i, spring): (usize, &AtSpring)| {
        let x = given.breakpoints[spring.breakpoint].x;
        if spring.acts {
            let pull = -checked.springs[i].force;
            let is_wrong = spring.pushes_only && (pull.is_nan() || TOLERANCE * force < pull);
            return is_wrong.then_some((i, Violation::Pull { at: x, force: pull }));
        }
        let piece = &checked.pieces[checked.pieces.partition_point(|p| p.hi < x).min(checked.pieces.len() - 1)];
        let part = piece.part_in(given, given.cell_to(x));
        let mut taylor = vec![0.0; given.terms];
        part.deflection(given, &mut taylor);
        let depth = derivatives(&taylor, x - part.anchor)[0] - spring.level;
        let allowed = nothing.max(TOLERANCE * spring.level.abs());
        (depth.is_nan() || allowed < depth).then_some((i, Violation::Penetration { at: x, depth }))
    };
    given.springs.iter().enumerate().filter_map(fault).collect()
}

/// Finds the pressed compression-only springs: returns the scene with them, and the answer of `find` for it. `find` starts from the
/// list of the previous set, if there is one; `acts` is the first set.
///
/// # Errors
///
/// The errors of `find`.
pub(super) fn search_with(
    scene: &Scene,
    acts: Option<Vec<bool>>,
    mut find: impl FnMut(&PiecewiseScene, Option<&List>) -> Result<Candidate, TheoryError>,
) -> Result<(PiecewiseScene, Candidate), TheoryError> {
    /// Maximum number of sets: per compression-only spring, and in addition.
    const MOST: [usize; 2] = [3, 20];
    let mut given = PiecewiseScene::new(scene);
    if let Some(acts) = acts.filter(|acts| acts.len() == given.springs.len()) {
        given = PiecewiseScene::with(scene, |i| acts[i] || !given.springs[i].pushes_only);
    }
    let mut sets = Sets { fewest: usize::MAX, patience: PATIENCE, last: None };
    let mut acts: Vec<bool> = given.springs.iter().map(|spring| spring.acts).collect();
    let mut left = MOST[0] * given.springs.iter().filter(|spring| spring.pushes_only).count() + MOST[1];
    let mut before: Option<Candidate> = None;
    let mut here = given;
    loop {
        let found = find(&here, before.as_ref().map(|found| &found.list))?;
        let work = before.as_ref().map_or([0; 3], |found| [found.steps, found.lists, found.samples]);
        let found = Candidate {
            steps: found.steps + work[0],
            lists: found.lists + work[1],
            samples: found.samples + work[2],
            ..found
        };
        let wrong = faults_of_springs(&here, &found.checked);
        left -= 1;
        if wrong.is_empty() || left == 0 || !sets.next(&mut acts, &wrong, found.solved()) {
            return Ok((here, found.with(wrong)));
        }
        here = PiecewiseScene::with(scene, |i| acts[i]);
        before = Some(found);
    }
}

/// The sequence of sets of pressed springs.
struct Sets {
    fewest: usize,
    patience: usize,
    /// The last set that has an answer, its wrong springs, and how many of these were exchanged alone.
    last: Option<(Vec<bool>, Vec<usize>, usize)>,
}

impl Sets {
    /// The next set; false if there is none.
    fn next(&mut self, acts: &mut Vec<bool>, wrong: &[(usize, Violation)], solved: bool) -> bool {
        if let Some((last, wrong, alone)) = self.last.as_mut().filter(|_| !solved) {
            // Without the removed springs the beam is not supported: exchange only one of them.
            acts.clone_from(last);
            *alone += 1;
            return wrong.len().checked_sub(*alone).map(|i| acts[wrong[i]] = !acts[wrong[i]]).is_some();
        }
        let all: Vec<usize> = wrong.iter().map(|(i, _)| *i).collect();
        (self.fewest, self.patience) = if all.len() < self.fewest {
            (all.len(), PATIENCE)
        } else {
            (self.fewest, self.patience.saturating_sub(1))
        };
        let alone = usize::from(self.patience == 0);
        self.last = Some((acts.clone(), all.clone(), alone));
        let exchanged = if alone == 0 { &all[..] } else { &all[all.len() - 1..] };
        exchanged.iter().for_each(|i| acts[*i] = !acts[*i]);
        true
    }
}

impl Exact {
    /// For each elastic support, whether it acts.
    pub(super) fn acting(&self) -> Vec<bool> {
        self.given.springs.iter().map(|spring| spring.acts).collect()
    }

    /// Whether there is an elastic support at a position \[length\].
    pub(super) fn gives(&self, x: f64) -> bool {
        let next = self.given.springs.partition_point(|spring| self.place(spring.breakpoint) < x);
        self.given.springs.get(next).is_some_and(|spring| self.place(spring.breakpoint).total_cmp(&x).is_eq())
    }

    /// Number of elastic compression-only supports before breakpoint `i`.
    pub(super) fn stops_before(&self, i: usize) -> usize {
        self.given.springs.iter().filter(|spring| spring.pushes_only && spring.breakpoint < i).count()
    }

    /// Position of breakpoint `i` \[length\].
    pub(super) fn place(&self, i: usize) -> f64 {
        self.given.breakpoints[i].x * self.units.length
    }

    /// For each elastic support its force and the jump of the moment that it causes \[force, force · length\].
    pub(crate) fn sprung(&self) -> Vec<[f64; 2]> {
        let at = |spring: &AtSpring| {
            let place = self.place(spring.breakpoint);
            let next = self.state.supports.partition_point(|support| support.at < place);
            let state = self.state.supports.get(next).filter(|support| support.at.total_cmp(&place).is_eq());
            state.map_or([0.0; 2], |support| [support.force, support.couple])
        };
        self.given.springs.iter().map(at).collect()
    }

    /// The candidate contact list for a certificate: the contacts and the pressed supports, and the contacts of the list that do not
    /// press.
    pub(crate) fn witness(&self) -> Vec<Contact> {
        let is_in = |c: &Contact| self.idle.iter().any(|idle| idle.from <= c.from && c.to <= idle.to);
        let is_contact = |c: &Contact| !is_in(c) && (!self.gives(c.from) || self.state.contacts.contains(c));
        let mut all: Vec<Contact> = self.state.touched().into_iter().filter(is_contact).collect();
        all.extend_from_slice(&self.idle);
        all.sort_by(|a, b| a.from.total_cmp(&b.from));
        all
    }
}
