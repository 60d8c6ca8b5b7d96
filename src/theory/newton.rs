//! Newton's method for the lift-off positions: a tridiagonal system, one equation for each node.
//!
//! Moving a contact at which `h = h' = 0` by `δx` turns the end of the span by `δh' = −h'' δx` and moves the place at which
//! `h''` is read; turning an edge by `δv'` turns the end by `δh' = −δv'`. The other end answers by the slope-deflection
//! equations of [`super::span`].

use super::bracket::Bracket;
use super::given::Given;
use super::hold::Hold;
use super::list::{Kind, List};
use super::span::Span;

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
/// A step below this fraction of the beam is rounding.
const ROUNDING: f64 = 1e-15;
/// A step below this one that shrinks no more is rounding too.
const NEARLY: f64 = 1e-12;
/// Two neighbours that share a span may come this much closer in one step.
const APPROACH: f64 = 0.45;

/// Moves the nodes of `list` until all equations hold.
pub(super) fn solve(given: &Given, list: &mut List) -> Run {
    if list.nodes.is_empty() {
        return Run { steps: 0, converged: true };
    }
    let mut last = f64::INFINITY;
    let mut brackets = vec![Bracket::EVERYWHERE; list.nodes.len()];
    // Report: newton
    for steps in 0..STEPS {
        // Row i: the jump of h'' at contact i, and its derivatives by the places of contacts i − 1, i and i + 1.
        let rows = equations(given, list);
        for ((bracket, node), (_, jump)) in brackets.iter_mut().zip(&list.nodes).zip(&rows) {
            bracket.narrow(node.x, *jump);
        }
        // Derivatives · step = −jumps: a tridiagonal system.
        let Some(step) = newton_step(list, rows, given.length) else {
            return Run { steps, converged: false };
        };
        // No further than to the end of a smooth piece of the ground, or to the next contact.
        let (size, limited) = apply(given, list, &step, &mut brackets);
        if !limited && (size <= ROUNDING || (size <= NEARLY && 0.5 * last <= size)) {
            return Run { steps: steps + 1, converged: true };
        }
        last = size;
    }
    // Report: end
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
    let hinged = |hold: Hold| matches!(hold, Hold::Hinged { .. });
    match (hinged(span.a.hold), hinged(span.b.hold)) {
        (false, false) => {
            [[carry_a - 4.0 * turn_a / l, -2.0 * turn_b / l], [2.0 * turn_a / l, carry_b + 4.0 * turn_b / l]]
        }
        (true, false) => [[0.0, 0.0], [0.0, carry_b + 3.0 * turn_b / l]],
        (false, true) => [[carry_a - 3.0 * turn_a / l, 0.0], [0.0, 0.0]],
        (true, true) => [[0.0; 2]; 2],
    }
}

/// The equations of all nodes, `h''(x−) − h''(x+) = 0` with zero for the side of a zone (and `−v''` for `h''` at an edge),
/// and how they depend on the nodes to the left, here, to the right.
///
/// At the solution the middle one is `−R − 4 h'' Σ 1/ℓ` or so, with the contact force `R ≥ 0` and `h'' ≥ 0`: negative.
fn equations(given: &Given, list: &List) -> Vec<([f64; 3], f64)> {
    let n = list.nodes.len();
    let mut rows = vec![([0.0; 3], 0.0); n];
    for (node, (row, _)) in list.nodes.iter().zip(&mut rows) {
        // A load just here is in neither span, but moving on in either direction would put it into one of them.
        if !matches!(node.kind, Kind::Edge(_)) {
            row[1] -= given.force_at(node.x).max(0.0);
        }
    }
    // v'' to the right and to the left of a node, where spans were solved in v.
    let mut in_beam = vec![[None; 2]; n];
    for (i, span) in list.spans(given) {
        let (left, right) = (i.checked_sub(1), (i < n).then_some(i));
        let answer = response(list, left, right, &span);
        if let Some(node) = left {
            let (row, value) = &mut rows[node];
            row[1] -= answer[0][0];
            row[2] -= answer[0][1];
            *value -= span.at_a[2] - profile_curvature(given, list, node, span.a.cell);
            in_beam[node][0] = span.in_beam.then_some(span.beam_a[2]);
        }
        if let Some(node) = right {
            let (row, value) = &mut rows[node];
            row[0] += answer[1][0];
            row[1] += answer[1][1];
            *value += span.at_b[2] - profile_curvature(given, list, node, span.b.cell);
            in_beam[node][1] = span.in_beam.then_some(span.beam_b[2]);
        }
    }
    for ((_, value), sides) in rows.iter_mut().zip(in_beam) {
        if let [Some(right), Some(left)] = sides {
            *value = right - left;
        }
    }
    rows
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
    let jump = equations(given, list).iter().map(|(_, r)| *r).fold(0.0, most);
    let steps = newton_step(list, equations(given, list), given.length).unwrap_or_default();
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

/// Takes the step as far as every node stays on its piece of the profile and spans keep a length. Returns its largest
/// relative size and whether it was limited.
fn apply(given: &Given, list: &mut List, step: &[f64], brackets: &mut [Bracket]) -> (f64, bool) {
    let places: Vec<f64> = list.nodes.iter().map(|n| n.x).collect();
    let (mut size, mut limited) = (0.0_f64, false);
    for (i, &step) in step.iter().enumerate() {
        let node = list.nodes[i];
        if let Kind::Edge(_) = node.kind {
            list.nodes[i].slope += step;
            continue;
        }
        let (mut lo, mut hi) = given.reach(node.cell);
        let x = node.x;
        // Halfway to a break of the profile, which is no place for a contact of this kind.
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
        limited |= short;
        if short {
            list.nodes[i].move_to(bounded, 0.0);
        } else {
            list.nodes[i].move_to(x, node.rest + step);
        }
        size = size.max(step.abs() / given.length);
    }
    (size, limited)
}
