//! A close look at a list that is solved: what is nothing beside the largest deflection is much between two points of a survey.
//!
//! A contact that is missing there costs next to nothing in deflection or energy. But an admissible deflection has to be lifted over
//! it, by as much as the beam is too deep, and what that costs is of the size of the bend of so short a span.

use super::check::{Check, check};
use super::list::{List, Node};
use super::newton;
use super::normal::merged;
use super::penetration::deepest;
use super::piece::NEAR;
use super::piecewise::PiecewiseScene;
use super::repair::repaired;
use super::room;
use super::search::Candidate;
use super::sensitivity::part_at;
use super::span::Span;
use super::violation::Violation;

/// Lists at most that come from a close look. Each has one contact more in a span: it takes four at a hundred thousand points of smooth
/// ground, and more where many contacts lie close together that a coarse guess took for one.
const ROUNDS: usize = 16;
/// What a span may penetrate by at the distance `d` from its nearer end, as a share of `v'' d²`, and its slope beside an edge may be
/// beyond, as a share of its turn `v'' ℓ`. The bound on the deflection is a few times the largest share: with this one it is a
/// hundredth of the millionth of the deflection that is asked for.
const SHARE: f64 = 1e-9;
/// Of fewer equal cells the shortest span has so large a bow that no more than this share of it escapes the check: of `n` of them
/// `n²/32` times [`TOLERANCE`](super::check::TOLERANCE).
const MANY: usize = 150;
/// Rounding of a clearance that is carried over a few breaks, as a share of what the ground rises by there, and of one that is the
/// difference of two depths, as a share of these.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// The list, or the last one of those that follow from a close look at it that is solved; with the work of all.
pub(super) fn closer(given: &PiecewiseScene, mut found: Candidate) -> Candidate {
    let mut faults = closely(given, &found.list, &found.checked);
    let mut last = None;
    for _ in 0..ROUNDS {
        if faults.is_empty() {
            break;
        }
        let Candidate { list, checked, .. } = last.as_ref().unwrap_or(&found);
        let mut list =
            tangent(given, list, checked, &faults).unwrap_or_else(|| repaired(given, list, checked, &faults));
        if room::for_contacts(given, list.nodes.len()).is_err() {
            break;
        }
        let run = newton::solve(given, &mut list);
        let normal = merged(given, &list.nodes);
        let converged = run.converged && normal == list;
        let checked = check(given, &normal);
        faults = closely(given, &normal, &checked);
        found.steps += run.steps;
        found.lists += 1;
        let next = Candidate { list: normal, checked, converged, ..found };
        if next.solved() {
            found = next;
            last = None;
        } else {
            faults.extend_from_slice(&next.checked.faults);
            last = Some(next);
        }
    }
    found
}

/// The list without the two edges of one straight cell between which the beam sags into it: it touches that cell in one point between
/// them, which its two neighbours so close by would keep Newton's method from finding. [`None`] where no fault is of that kind.
fn tangent(given: &PiecewiseScene, list: &List, checked: &Check, faults: &[(usize, Violation)]) -> Option<List> {
    let mut nodes = list.nodes.clone();
    for (i, fault) in faults.iter().rev() {
        let (Violation::Penetration { at, .. }, Some(left)) = (fault, i.checked_sub(1)) else { continue };
        let Some(span) = part_at(&checked.spans, *i, *at) else { continue };
        // A support that only pushes is no edge of the ground beside it.
        let is_edge = |node: &Node| node.is_edge(given) && node.is_ground(given);
        let both = nodes.get(left..=*i).is_some_and(|two| two.iter().all(is_edge));
        if both && span.a.cell == span.b.cell {
            nodes.splice(left..=*i, [Node::touch(*at, span.a.cell)]);
        }
    }
    (nodes.len() < list.nodes.len()).then(|| merged(given, &nodes))
}

/// What a close look finds: penetration of straight ground as a share of the bow as far as the next contact, and slopes beside edges.
fn closely(given: &PiecewiseScene, list: &List, checked: &Check) -> Vec<(usize, Violation)> {
    let mut faults = Vec::new();
    if !given.founded || !given.is_straight(0) || given.cells.len() < MANY {
        return faults;
    }
    for (i, span) in &checked.spans {
        let bent = span.beam_a[2].abs().max(span.beam_b[2].abs());
        let rounding = rounding(given, span);
        // Near an end the lift that clears it bends the whole span by as much as if that were so everywhere.
        let allowed = |x: f64| {
            let near = (x - span.a.x).abs().min((span.b.x - x).abs());
            (SHARE * bent * near * near).min(checked.allowed(given, span, x)).max(rounding)
        };
        let found = deepest(given, &checked.pieces, span, allowed);
        match found {
            Some((at, depth)) => faults.push((*i, Violation::Penetration { at, depth })),
            None => faults.extend(turned(given, list, checked, *i, span).map(|fault| (*i, fault))),
        }
    }
    faults
}

/// What the clearance in a span is rounded by.
fn rounding(given: &PiecewiseScene, span: &Span) -> f64 {
    let depth = span.beam_a[0].abs().max(span.beam_b[0].abs());
    let cells = span.a.cell..=span.b.cell;
    let rise = if span.b.cell.abs_diff(span.a.cell) <= NEAR { steepest(given, cells) * span.length() } else { depth };
    ROUNDED * rise.min(depth)
}

/// The steepest slope of some cells of straight ground.
fn steepest(given: &PiecewiseScene, cells: std::ops::RangeInclusive<usize>) -> f64 {
    cells.fold(0.0, |most, cell| given.derivative(cell, given.cells[cell].lo, 1).abs().max(most))
}

/// An edge at an end of span `i` beside which the beam goes below the ground and comes up again at once: it touches the slope there
/// instead.
fn turned(given: &PiecewiseScene, list: &List, checked: &Check, i: usize, span: &Span) -> Option<Violation> {
    let ends = [(i.checked_sub(1), 1.0, &span.a, &span.at_a), (Some(i), -1.0, &span.b, &span.at_b)];
    ends.into_iter().find_map(|(node, side, end, at)| {
        // Beside a support that only pushes the ground is farther down.
        let node = node.filter(|&node| list.nodes.get(node).is_some_and(|node| node.is_edge(given)) && at[0] <= 0.0)?;
        let (turn, bend) = (-side * at[1], at[2]);
        let cell = &given.cells[end.cell];
        let most = 0.5 * span.length().min(cell.hi - cell.lo);
        // The moments of the spans on both sides depend on the error of the slope.
        let allowed = SHARE * bend * checked.shortest_beside(node).min(span.length());
        let is_beyond = 0.0 < bend && allowed.max(ROUNDED * steepest(given, end.cell..=end.cell)) < turn;
        let depth = 0.5 * turn * turn / bend;
        (is_beyond && turn < most * bend).then(|| Violation::Penetration { at: end.x + side * turn / bend, depth })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load, Scene, Support};
    use crate::theory::normal::edge_node;

    /// Between two edges of the ground the beam touches the straight piece that joins them; two supports that only push stay.
    #[test]
    fn supports_that_only_push_stay_where_edges_become_a_tangent() {
        const AT: [f64; 2] = [4.0, 6.0];
        let points = vec![[0.0, 1.0], [AT[0], 0.5], [AT[1], 0.5], [10.0, 1.0]];
        let pushing = AT.map(|at| Support { level: 0.2, ..Support::pushing(at) });
        for (supports, stay) in [(Vec::new(), false), (pushing.to_vec(), true)] {
            let held = [0.0, 10.0].map(Support::simple);
            let beam = Beam::new(10.0, 1.0).and_then(|beam| beam.with_supports([&held[..], &supports].concat()));
            let beam = beam.expect("a beam");
            let load = Load::uniform_on(&beam, 1.0).expect("a load");
            let ground = Foundation::Polyline { points: points.clone() };
            let given = PiecewiseScene::new(&Scene::new(beam, load, Some(ground)).expect("a scene"));
            let edges = AT.map(|x| edge_node(&given, given.breakpoint_at(x).expect("a breakpoint")));
            let mut list = List::free(&given);
            list.nodes.splice(1..1, edges);
            let fault = (2, Violation::Penetration { at: 5.0, depth: 1e-9 });
            let found = tangent(&given, &list, &check(&given, &list), &[fault]);
            assert_eq!(found.map(|list| list.nodes.len()), (!stay).then_some(3), "{supports:?}");
        }
    }
}
