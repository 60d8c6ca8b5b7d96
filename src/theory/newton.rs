//! Newton's method for the positions and slopes of the nodes: a tridiagonal system with one equation for each node.
//!
//! Moving a contact with `h = h' = 0` by `δx` rotates the end of the span by `δh' = −h'' δx` and moves the position at which `h''` is
//! evaluated. Rotating the beam on an edge by `δv'` rotates the end by `δh' = −δv'`. The response of the other end follows from the
//! slope-deflection equations of [`super::span`].

use super::list::{List, Node, Unknown};
use super::piecewise::{Breakpoint, PiecewiseScene};
use super::span::{EndCondition, Span};

/// The outcome of Newton's method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Run {
    /// Number of steps.
    pub(super) steps: usize,
    /// Whether the last step was at the level of rounding.
    pub(super) converged: bool,
}

/// Maximum number of steps. Quadratic convergence needs 5 from a good start, and bisection 50 from a start next to a point load.
const STEPS: usize = 60;
/// Number of steps for quadratic convergence before brackets are used.
const QUADRATIC: usize = 8;
/// Number of steps at the level of rounding that refine slopes at edges and the low-order parts of positions.
const REFINED: usize = 1;
/// Step size that counts as rounding, as a share of the beam.
const ROUNDING: f64 = 1e-15;
/// Step size below which a step that no longer shrinks counts as rounding too.
const NEARLY: f64 = 1e-12;
/// Under an axial force a contact that is nearer to a division of the beam than this share of the beam is at the division: the part
/// between them would be as short as the rounding of its ends. It is the rounding of a position that [`super::check`] accepts.
const RESOLVED: f64 = super::check::PLACE;
/// The largest movement in one step towards a neighbour across a span, as a share of their distance.
const APPROACH: f64 = 0.45;

/// Moves the nodes of `list` until all equations are satisfied.
pub(super) fn solve(given: &PiecewiseScene, list: &mut List) -> Run {
    if list.unknowns(given) == 0 {
        return Run { steps: 0, converged: true };
    }
    let mut last = f64::INFINITY;
    let mut brackets = vec![Bracket::EVERYWHERE; list.nodes.len()];
    let mut rests = 0;
    for steps in 0..STEPS {
        // Row i: the jump of h'' at contact i, and its derivatives with respect to the positions of contacts i − 1, i and i + 1.
        let rows = equations(given, list, |row| list.each_span(given, row));
        if QUADRATIC <= steps {
            brackets.iter_mut().zip(&list.nodes).zip(&rows).for_each(|((b, node), row)| b.narrow(node.x, row.jump));
        }
        // Derivatives · step = −jumps: a tridiagonal system.
        let Some(rows) = newton_step(rows) else {
            return Run { steps, converged: false };
        };
        // At most to the end of a smooth piece of the foundation, or to the next contact.
        let Applied { size, limited } = apply(given, list, &rows, &mut brackets);
        let at_rest = !limited && (size <= ROUNDING || (size <= NEARLY && 0.5 * last <= size));
        rests = if at_rest { rests + 1 } else { 0 };
        if REFINED < rests {
            return Run { steps: steps + 1, converged: true };
        }
        last = size;
    }
    Run { steps: STEPS, converged: false }
}

/// The derivatives of `e h''` at the two ends of a span with respect to the unknowns of the two neighbouring nodes: `[end][node]`. The
/// span reaches from its first to its last part.
fn response([left, right]: [Option<Unknown>; 2], [first, last]: [&Span; 2]) -> [[f64; 2]; 2] {
    // δh' of each end for a unit of its unknown, and the change of e h'' under a moving end.
    let turn = |unknown: Option<Unknown>, end: &[f64; 4], e: f64| match unknown {
        None => (0.0, 0.0),
        Some(Unknown::Slope) => (-1.0, 0.0),
        Some(Unknown::Place) => (-end[2] / e, end[3]),
    };
    let (turn_a, carry_a) = turn(left, &first.at_a, first.stiffness);
    let (turn_b, carry_b) = turn(right, &last.at_b, last.stiffness);
    if let Some([[aa, ab], [ba, bb]]) = first.answer {
        return [[carry_a + aa * turn_a, ab * turn_b], [ba * turn_a, carry_b + bb * turn_b]];
    }
    if first.is_overhang() || last.is_overhang() {
        // The moment of an overhang follows from its loads.
        return [[carry_a, 0.0], [0.0, carry_b]];
    }
    let l = first.length() / first.stiffness;
    match (first.a.hold.is_hinged(), first.b.hold.is_hinged()) {
        (false, false) => {
            [[carry_a - 4.0 * turn_a / l, -2.0 * turn_b / l], [2.0 * turn_a / l, carry_b + 4.0 * turn_b / l]]
        }
        (true, false) => [[0.0, 0.0], [0.0, carry_b + 3.0 * turn_b / l]],
        (false, true) => [[carry_a - 3.0 * turn_a / l, 0.0], [0.0, 0.0]],
        (true, true) => [[0.0; 2]; 2],
    }
}

/// The equation of a node, `h''(x−) − h''(x+) = C` with the couple `C` at the node and zero on the side of a zone. At an edge it is
/// equivalent to the same equation for `v''`, because the profile jumps in depth and slope and in no higher derivative. A node without
/// unknown does not move.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// The unknown of the node.
    unknown: Option<Unknown>,
    /// Derivatives of the jump with respect to the left node, this node and the right node.
    derivative: [f64; 3],
    /// `h''(x−) − h''(x+) − C`.
    jump: f64,
    /// Newton's step.
    step: f64,
}

/// The equations of all nodes.
///
/// At the solution the middle derivative is about `−R − 4 h'' Σ 1/ℓ` with the contact force `R ≥ 0` and `h'' ≥ 0`, so it is negative.
fn equations(given: &PiecewiseScene, list: &List, each: impl FnOnce(&mut dyn FnMut(usize, &Span))) -> Vec<Row> {
    let row = |(i, node): (usize, &Node)| {
        let unknown = list.unknown(given, i);
        let middle = match unknown {
            None => 1.0,
            Some(Unknown::Slope) => node.turning(given).map_or(0.0, |[k, _]| -k),
            // A load exactly here belongs to neither span, but moving in either direction would put it into one of them.
            Some(Unknown::Place) => -given.force_at(node.x, node.cell).max(0.0),
        };
        let couple = if unknown.is_some() { node.couple(given) } else { 0.0 };
        Row { unknown, derivative: [0.0, middle, 0.0], jump: 0.0 - couple, step: 0.0 }
    };
    let mut rows: Vec<Row> = list.nodes.iter().enumerate().map(row).collect();
    // The first part of a divided span.
    let mut first: Option<Span> = None;
    each(&mut |right, span| {
        if span.b.hold == EndCondition::Within {
            first.get_or_insert(*span);
            return;
        }
        let start = first.as_ref().unwrap_or(span);
        let left = right.checked_sub(1);
        let unknown = [left, Some(right)].map(|i| rows.get(i?).and_then(|row| row.unknown));
        let [at_a, at_b] = response(unknown, [start, span]);
        if let ([Some(_), _], Some(i)) = (unknown, left) {
            rows[i].derivative[1] -= at_a[0];
            rows[i].derivative[2] -= at_a[1];
            rows[i].jump -= side(given, list, i, &start.at_a, &start.beam_a);
        }
        if unknown[1].is_some() {
            rows[right].derivative[0] += at_b[0];
            rows[right].derivative[1] += at_b[1];
            rows[right].jump += side(given, list, right, &span.at_b, &span.beam_b);
        }
        first = None;
    });
    rows
}

/// `e h''` on a side of node `i`. At an edge where the stiffness changes it is `−e v''`, because the moment of a beam along the
/// foundation jumps there too. The same holds at an outermost node, which moves only along the foundation or has no beam on its other
/// side.
fn side(given: &PiecewiseScene, list: &List, i: usize, at: &[f64; 4], beam: &[f64; 4]) -> f64 {
    let stands = || list.nodes[i].breakpoint.or_else(|| given.breakpoint_at(list.nodes[i].x));
    let is_changed = !given.is_undivided() && stands().is_some_and(|breakpoint| given.is_step(breakpoint));
    let is_outer = !list.nodes[i].can_move() && (i == 0 || i + 1 == list.nodes.len());
    if is_changed || is_outer { -beam[2] } else { at[2] }
}

/// The residual of the equations.
pub(super) struct Residual {
    /// The largest jump of `v''`.
    pub(super) jump: f64,
    /// The largest movement that a contact still needs, as a share of the beam. For steep profiles this is rounding of the position
    /// long before the jump is small.
    pub(super) step: f64,
    /// The largest movement that a contact still needs as a share of a neighbouring span, and the node to the right of that span.
    pub(super) unresolved: (f64, usize),
}

/// The residual of the equations of `list` with its `spans`.
pub(super) fn residual(given: &PiecewiseScene, list: &List, spans: &[(usize, Span)]) -> Residual {
    // A NaN never counts as small.
    let most = |most: f64, r: f64| if r.abs() <= most { most } else { r.abs() };
    let rows = equations(given, list, |row| spans.iter().for_each(|(i, span)| row(*i, span)));
    let jump = rows.iter().map(|row| row.jump).fold(0.0, most);
    let Some(rows) = newton_step(rows) else {
        return Residual { jump, step: f64::INFINITY, unresolved: (0.0, 0) };
    };
    let moving = |row: &&Row| row.unknown == Some(Unknown::Place);
    let step = rows.iter().filter(moving).map(|row| row.step / given.length).fold(0.0, most);
    let mut unresolved = (0.0, 0);
    // Under an axial force the parts of a span are resolved as a whole up to a joint, next to which a contact may be at the joint instead.
    let is_joint = |span: &Span| given.breakpoints.get(span.b.cell + 1).is_some_and(Breakpoint::is_jointed);
    let is_whole = |span: &Span| given.tension != 0.0 && !is_joint(span);
    for parts in spans.chunk_by(|(i, span), (j, _)| i == j && is_whole(span)) {
        let i = parts[0].0;
        let length: f64 = parts.iter().map(|(_, span)| span.length()).sum();
        let beside = i.saturating_sub(1)..rows.len().min(i + 1);
        for row in rows[beside].iter().filter(moving) {
            let part = row.step.abs() / length;
            if unresolved.0 < part {
                unresolved = (part, i);
            }
        }
    }
    Residual { jump, step, unresolved }
}

/// The equations with Newton's step; [`None`] if the system is singular.
fn newton_step(mut rows: Vec<Row>) -> Option<Vec<Row>> {
    // Rows and columns of moving nodes have units of h''. Elimination with a check of the pivots is enough, because the
    // slope-deflection equations are diagonally dominant.
    for row in rows.iter_mut().filter(|row| row.unknown == Some(Unknown::Place)) {
        // A derivative of the other sign leads to a root in tension or with penetration: step away from it. Without load it is zero.
        let slope = row.derivative[1].abs();
        row.derivative[1] = if slope == 0.0 { -1.0 } else { -slope };
    }
    for i in 0..rows.len() {
        let Row { derivative: [_, pivot, upper], jump, .. } = rows[i];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        if let Some(next) = rows.get_mut(i + 1) {
            let factor = next.derivative[0] / pivot;
            next.derivative[1] -= factor * upper;
            next.jump -= factor * jump;
        }
    }
    let mut beyond = 0.0;
    for row in rows.iter_mut().rev() {
        let [_, pivot, upper] = row.derivative;
        row.step = -(row.jump + upper * beyond) / pivot;
        if !row.step.is_finite() {
            return None;
        }
        beyond = row.step;
    }
    Some(rows)
}

/// The outcome of a step.
#[derive(Debug, Default)]
struct Applied {
    /// Its largest component, as a share of the beam.
    size: f64,
    /// Whether the movement of a node was limited.
    limited: bool,
}

/// Applies the step as far as every node remains on its piece of the profile and every span keeps a positive length.
fn apply(given: &PiecewiseScene, list: &mut List, rows: &[Row], brackets: &mut [Bracket]) -> Applied {
    let mut applied = Applied::default();
    // The position of the left node before this step.
    let mut left = 0.0;
    for (i, &Row { unknown, step, .. }) in rows.iter().enumerate() {
        let node = list.nodes[i];
        let before = std::mem::replace(&mut left, node.x);
        match unknown {
            None => continue,
            Some(Unknown::Slope) => {
                list.nodes[i].turn_by(step);
                continue;
            }
            Some(Unknown::Place) => {}
        }
        let (mut lo, mut hi) = given.reach(node.cell);
        let x = node.x;
        if node.starts_zone() {
            lo = lo.max(given.next_pulling(x)[0]);
        } else if node.ends_zone() {
            hi = hi.min(given.next_pulling(x)[1]);
        }
        // Most of the way to a break of the profile, where no contact of this kind can be.
        (lo, hi) = (x + 0.9 * (lo - x), x + 0.9 * (hi - x));
        if !list.in_zone_before(i) {
            lo = lo.max(x - APPROACH * (x - before));
        }
        if !list.in_zone_before(i + 1) {
            let right = list.nodes.get(i + 1).map_or(given.length, |next| next.x);
            hi = hi.min(x + APPROACH * (right - x));
        }
        let wanted = x + step;
        let bounded = brackets[i].keep(wanted, ROUNDING * given.length).max(lo.min(x)).min(hi.max(x));
        let short = ROUNDING * given.length < (bounded - wanted).abs();
        applied.limited |= short;
        if short {
            list.nodes[i].move_to(bounded, 0.0);
        } else {
            list.nodes[i].move_to(x, node.low + step);
        }
        let reach = RESOLVED * given.length;
        if given.tension != 0.0
            && let Some(division) = given.division_at(list.nodes[i].x, reach)
        {
            list.nodes[i].move_to(division, 0.0);
        }
        applied.size = applied.size.max(step.abs() / given.length);
    }
    applied
}

/// The interval that contains the root of a node's equation, as long as its neighbours move little.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    lo: f64,
    hi: f64,
}

impl Bracket {
    const EVERYWHERE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Narrows the interval by the value at `x` of an equation that falls from left to right.
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

    /// The position instead of `wanted`: the middle, if `wanted` is outside. Next to a point load Newton's method would otherwise
    /// oscillate from one side to the other forever.
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
