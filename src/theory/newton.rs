//! Newton's method for the lift-off positions: a tridiagonal system, one equation for each node.
//!
//! Moving a contact at which `h = h' = 0` by `δx` turns the end of the span by `δh' = −h'' δx` and moves the place at which
//! `h''` is read; turning an edge by `δv'` turns the end by `δh' = −δv'`. The other end answers by the slope-deflection
//! equations of [`super::span`].

use super::given::Given;
use super::list::{Kind, List, Node};
use super::span::{Hold, Span};

/// How it went.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Run {
    /// Steps taken.
    pub(super) steps: usize,
    /// True if the last step was at the level of rounding.
    pub(super) converged: bool,
}

/// Quadratic convergence needs 5 steps from a good start, and bisection 50 from one beside a point load; more is no start.
const STEPS: usize = 60;
/// Steps that quadratic convergence has before brackets are kept.
const QUADRATIC: usize = 8;
/// Steps at the level of rounding that refine the solution: slopes at edges, and digits of places beyond their last one.
const REFINED: usize = 1;
/// A step below this fraction of the beam is rounding.
const ROUNDING: f64 = 1e-15;
/// A step below this one that shrinks no more is rounding too.
const NEARLY: f64 = 1e-12;
/// Where no node moves by this part of what some of them should, and these are at most one in `FEW`, the check decides.
const STUCK: f64 = 1e-6;
const FEW: usize = 100;
/// Two neighbours that share a span may come this much closer in one step.
const APPROACH: f64 = 0.45;

/// Moves the nodes of `list` until all equations hold.
pub(super) fn solve(given: &Given, list: &mut List) -> Run {
    if list.nodes.is_empty() {
        return Run { steps: 0, converged: true };
    }
    let mut last = f64::INFINITY;
    let mut brackets = vec![Bracket::EVERYWHERE; list.nodes.len()];
    let mut answers = answers(given, list);
    let mut settled = vec![0; list.nodes.len()];
    let mut rests = 0;
    // Report: newton
    for steps in 0..STEPS {
        // Row i: the jump of h'' at contact i, and its derivatives by the places of contacts i − 1, i and i + 1.
        let rows = equations(given, list, &answers);
        if QUADRATIC <= steps {
            brackets.iter_mut().zip(&list.nodes).zip(&rows).for_each(|((b, node), (_, jump))| b.narrow(node.x, *jump));
        }
        // Derivatives · step = −jumps: a tridiagonal system.
        let Some(mut step) = newton_step(list, rows, given.length) else {
            return Run { steps, converged: false };
        };
        settle(given, list, &mut step, &mut settled);
        // No further than to the end of a smooth piece of the ground, or to the next contact.
        let Applied { size, moved, limited } = apply(given, list, &step, &mut brackets);
        // Report: end
        update(given, list, &step, &mut answers);
        let at_rest = limited == 0 && (size <= ROUNDING || (size <= NEARLY && 0.5 * last <= size));
        rests = if at_rest { rests + 1 } else { 0 };
        if REFINED < rests {
            return Run { steps: steps + 1, converged: true };
        }
        if 0 < limited && FEW * limited <= list.nodes.len() && moved <= STUCK * size {
            return Run { steps: steps + 1, converged: false };
        }
        last = size;
    }
    Run { steps: STEPS, converged: false }
}

/// How `h''` at the two ends of a span answers to the two nodes beside it: `[end][node]`.
fn response(list: &List, left: Option<usize>, right: Option<usize>, span: &Span) -> [[f64; 2]; 2] {
    let l = span.length();
    // δh' of each end for a unit of its unknown, and how fast h'' changes under a moving end.
    let turn = |node: Option<usize>, end: &[f64; 4]| match node.map(|i| list.nodes[i].kind) {
        None => (0.0, 0.0),
        Some(Kind::Edge(_)) => (-1.0, 0.0),
        Some(_) => (-end[2], end[3]),
    };
    let (turn_a, carry_a) = turn(left, &span.at_a);
    let (turn_b, carry_b) = turn(right, &span.at_b);
    let hinged = |hold: Hold| hold == Hold::Support;
    match (hinged(span.a.hold), hinged(span.b.hold)) {
        (false, false) => {
            [[carry_a - 4.0 * turn_a / l, -2.0 * turn_b / l], [2.0 * turn_a / l, carry_b + 4.0 * turn_b / l]]
        }
        (true, false) => [[0.0, 0.0], [0.0, carry_b + 3.0 * turn_b / l]],
        (false, true) => [[carry_a - 3.0 * turn_a / l, 0.0], [0.0, 0.0]],
        (true, true) => [[0.0; 2]; 2],
    }
}

/// What a span says to the equations of the nodes at its ends.
#[derive(Debug, Clone, Copy)]
struct Answer {
    /// `h''` at both ends; beside an edge `−v''`.
    bend: [f64; 2],
    /// `v''` at both ends, if it was solved in `v`.
    beam: Option<[f64; 2]>,
    /// How `bend` depends on the nodes at both ends: `[end][node]`.
    response: [[f64; 2]; 2],
}

impl Answer {
    fn of(given: &Given, list: &List, i: usize) -> Self {
        let span = list.span(given, i);
        let (left, right) = (i.checked_sub(1), (i < list.nodes.len()).then_some(i));
        let curvature = |node: Option<usize>, cell| node.map_or(0.0, |node| profile_curvature(given, list, node, cell));
        Self {
            bend: [span.at_a[2] - curvature(left, span.a.cell), span.at_b[2] - curvature(right, span.b.cell)],
            beam: span.in_beam.then_some([span.beam_a[2], span.beam_b[2]]),
            response: response(list, left, right, &span),
        }
    }
}

/// The answers of all spans, [`None`] for zones.
fn answers(given: &Given, list: &List) -> Vec<Option<Answer>> {
    (0..=list.nodes.len()).map(|i| (!list.in_zone_before(i)).then(|| Answer::of(given, list, i))).collect()
}

/// The equations of all nodes, `h''(x−) − h''(x+) = 0` with zero for the side of a zone (and `−v''` for `h''` at an edge),
/// and how they depend on the nodes to the left, here, to the right.
///
/// At the solution the middle one is `−R − 4 h'' Σ 1/ℓ` or so, with the contact force `R ≥ 0` and `h'' ≥ 0`: negative.
fn equations(given: &Given, list: &List, answers: &[Option<Answer>]) -> Vec<([f64; 3], f64)> {
    let equation = |(i, node): (usize, &Node)| {
        let (mut row, mut value) = ([0.0; 3], 0.0);
        // A load just here is in neither span, but moving on in either direction would put it into one of them.
        if !matches!(node.kind, Kind::Edge(_)) {
            row[1] -= given.force_at(node.x, node.cell).max(0.0);
        }
        if let Some(Answer { bend, response, .. }) = answers[i] {
            row[0] += response[1][0];
            row[1] += response[1][1];
            value += bend[1];
        }
        if let Some(Answer { bend, response, .. }) = answers[i + 1] {
            row[1] -= response[0][0];
            row[2] -= response[0][1];
            value -= bend[0];
        }
        let beam = |answer: &Option<Answer>| answer.and_then(|answer| answer.beam);
        if let (Some(left), Some(right)) = (beam(&answers[i]), beam(&answers[i + 1])) {
            value = right[0] - left[1];
        }
        (row, value)
    };
    list.nodes.iter().enumerate().map(equation).collect()
}

/// `u''` beside an edge, where `v''` has to be compared; elsewhere `h''` will do.
fn profile_curvature(given: &Given, list: &List, node: usize, cell: usize) -> f64 {
    match list.nodes[node].kind {
        Kind::Edge(_) => given.derivative(cell, list.nodes[node].x, 2),
        _ => 0.0,
    }
}

/// How far the equations are from holding.
pub(super) struct Residual {
    /// The largest jump of `v''`.
    pub(super) jump: f64,
    /// The largest fraction of the beam by which a contact would have to move, which for steep profiles is rounding of its
    /// place long before the jump is small.
    pub(super) step: f64,
    /// The largest fraction of a span beside it by which a contact would have to move, and the node to the right of that span.
    pub(super) crowded: (f64, usize),
}

/// The residual of the equations of `list`.
pub(super) fn residual(given: &Given, list: &List) -> Residual {
    // A NaN is never small.
    let most = |most: f64, r: f64| if r.abs() <= most { most } else { r.abs() };
    let rows = equations(given, list, &answers(given, list));
    let jump = rows.iter().map(|(_, r)| *r).fold(0.0, most);
    let steps = newton_step(list, rows, given.length).unwrap_or_default();
    if steps.len() < list.nodes.len() {
        return Residual { jump, step: f64::INFINITY, crowded: (0.0, 0) };
    }
    let moving = |i: &usize| list.nodes.get(*i).is_some_and(|n| !matches!(n.kind, Kind::Edge(_)));
    let step = (0..steps.len()).filter(moving).map(|i| steps[i] / given.length).fold(0.0, most);
    let mut crowded = (0.0, 0);
    for (i, span) in list.spans(given) {
        for node in i.checked_sub(1).into_iter().chain([i]).filter(moving) {
            let part = steps[node].abs() / span.length();
            if crowded.0 < part {
                crowded = (part, i);
            }
        }
    }
    Residual { jump, step, crowded }
}

/// Newton's step; [`None`] if the system is singular.
fn newton_step(list: &List, mut rows: Vec<([f64; 3], f64)>, length: f64) -> Option<Vec<f64>> {
    // Rows and columns of moving nodes carry units of h''; elimination with a check of the pivots is enough, since the
    // slope-deflection equations are diagonally dominant.
    let n = rows.len();
    for ((row, value), _) in rows.iter_mut().zip(&list.nodes).filter(|(_, node)| !matches!(node.kind, Kind::Edge(_))) {
        // The wrong sign leads to a root that pulls or penetrates: uphill from there. Beside a stretch without load the
        // slope may vanish; no step is longer than the beam.
        let slope = row[1].abs().max(value.abs() / length);
        row[1] = if slope == 0.0 { -1.0 } else { -slope };
    }
    for i in 0..n {
        let ([_, pivot, upper], value) = rows[i];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        if i + 1 < n {
            let (row, right) = &mut rows[i + 1];
            let factor = row[0] / pivot;
            row[1] -= factor * upper;
            *right -= factor * value;
        }
    }
    let mut step = vec![0.0; n];
    for i in (0..n).rev() {
        let ([_, pivot, upper], value) = rows[i];
        let beyond = if i + 1 < n { upper * step[i + 1] } else { 0.0 };
        step[i] = -(value + beyond) / pivot;
        if !step[i].is_finite() {
            return None;
        }
    }
    Some(step)
}

/// Nodes that have come to rest stay where they are while others still move.
fn settle(given: &Given, list: &List, step: &mut [f64], settled: &mut [u8]) {
    /// Steps at the level of rounding after which a node is at rest.
    const ENOUGH: u8 = 2;
    for ((step, settled), node) in step.iter_mut().zip(settled).zip(&list.nodes) {
        if matches!(node.kind, Kind::Edge(_)) || ROUNDING * given.length < step.abs() {
            *settled = 0;
        } else if *settled == ENOUGH {
            *step = 0.0;
        } else {
            *settled += 1;
        }
    }
}

/// The answers of the spans beside nodes that have moved.
fn update(given: &Given, list: &List, step: &[f64], answers: &mut [Option<Answer>]) {
    let moved = |i: usize| step.get(i).is_some_and(|step| *step != 0.0);
    for (i, answer) in answers.iter_mut().enumerate() {
        if answer.is_some() && (moved(i) || i.checked_sub(1).is_some_and(moved)) {
            *answer = Some(Answer::of(given, list, i));
        }
    }
}

/// What became of a step.
#[derive(Debug, Default)]
struct Applied {
    /// Its largest part, as a share of the beam.
    size: f64,
    /// How far nodes moved at most, as a share of the beam.
    moved: f64,
    /// How many were kept from moving as far as they should.
    limited: usize,
}

/// Takes the step as far as every node stays on its piece of the profile and spans keep a length.
fn apply(given: &Given, list: &mut List, step: &[f64], brackets: &mut [Bracket]) -> Applied {
    let places: Vec<f64> = list.nodes.iter().map(|n| n.x).collect();
    let mut applied = Applied::default();
    for (i, &step) in step.iter().enumerate() {
        let node = list.nodes[i];
        if let Kind::Edge(_) = node.kind {
            list.nodes[i].turn_by(step);
            continue;
        }
        let (mut lo, mut hi) = given.reach(node.cell);
        let x = node.x;
        match node.kind {
            Kind::ZoneStart => lo = lo.max(given.next_tension(x)[0]),
            Kind::ZoneEnd => hi = hi.min(given.next_tension(x)[1]),
            Kind::Smooth | Kind::Edge(_) => {}
        }
        // Most of the way to a break of the profile, which is no place for a contact of this kind.
        (lo, hi) = (x + 0.9 * (lo - x), x + 0.9 * (hi - x));
        if !list.in_zone_before(i) {
            let left = i.checked_sub(1).map_or(0.0, |i| places[i]);
            lo = lo.max(x - APPROACH * (x - left));
        }
        if !list.in_zone_before(i + 1) {
            let right = places.get(i + 1).copied().unwrap_or(given.length);
            hi = hi.min(x + APPROACH * (right - x));
        }
        let wanted = x + step;
        let bounded = brackets[i].keep(wanted, ROUNDING * given.length).max(lo.min(x)).min(hi.max(x));
        let short = ROUNDING * given.length < (bounded - wanted).abs();
        applied.limited += usize::from(short);
        if short {
            list.nodes[i].move_to(bounded, 0.0);
        } else {
            list.nodes[i].move_to(x, node.rest + step);
        }
        applied.size = applied.size.max(step.abs() / given.length);
        applied.moved = applied.moved.max((list.nodes[i].x - x).abs() / given.length);
    }
    applied
}

/// Between which places the root of a node's equation must lie, as long as its neighbours do not move much.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    lo: f64,
    hi: f64,
}

impl Bracket {
    const EVERYWHERE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Takes notice of the value at `x` of an equation that falls from left to right.
    fn narrow(&mut self, x: f64, value: f64) {
        if 0.0 < value {
            self.lo = x;
        } else {
            self.hi = x;
        }
        if self.hi <= self.lo {
            // The neighbours have moved.
            *self = if 0.0 < value { Self { lo: x, ..Self::EVERYWHERE } } else { Self { hi: x, ..Self::EVERYWHERE } };
        }
    }

    /// Where to go instead of `wanted`: the middle, if it lies outside. Beside a point load Newton's method would jump
    /// from one side to the other for ever.
    fn keep(&mut self, wanted: f64, rounding: f64) -> f64 {
        if self.hi - self.lo <= rounding {
            *self = Self::EVERYWHERE;
        }
        if self.lo <= wanted && wanted <= self.hi || !(self.lo.is_finite() && self.hi.is_finite()) {
            wanted
        } else {
            0.5 * (self.lo + self.hi)
        }
    }
}
