//! A close check of a solved list: a penetration that is negligible next to the largest deflection is large between two points of a
//! survey.
//!
//! A contact that is missing there hardly changes the deflection or the energy. But an admissible deflection has to be lifted over it
//! by the depth of the penetration, and the energy of this lift is as large as the bending energy of so short a span.

// Held by: theory::surveys::surveys_of_smooth_waves_are_certified_under_a_light_load

use super::check::{Check, check};
use super::list::{List, Node};
use super::newton;
use super::normal::normal_form;
use super::penetration::deepest;
use super::piece::NEAR;
use super::piecewise::PiecewiseScene;
use super::repair::repaired;
use super::room;
use super::search::Candidate;
use super::sensitivity::part_at;
use super::span::Span;
use super::violation::Violation;

/// Maximum number of lists from a close check. Each adds one contact to a span. A hundred thousand points of a smooth foundation need
/// four lists. More are needed where a coarse guess replaced many close contacts by one.
const ROUNDS: usize = 16;
/// Penetration allowed at the distance `d` from the nearer end of a span, as a share of `v'' d²`. The bound on the deflection is a few
/// times the largest share. This value keeps it at a hundredth of the required error, which is a millionth of the deflection.
const SHARE: f64 = 1e-9;
/// Smallest number of cells that needs a close check. With `n` equal cells the check misses at most `n²/32` times
/// [`TOLERANCE`](super::check::TOLERANCE) of the bow of the shortest span; below this number that is at most [`SHARE`].
const MANY: usize = 150;
/// Rounding of a clearance: as a share of the rise of the foundation if it is carried over a few breaks, and as a share of the depths
/// if it is the difference of two depths.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// The last solved list of those that follow from a close check, or the given list; its work includes all lists.
pub(super) fn checked_closely(given: &PiecewiseScene, mut found: Candidate) -> Candidate {
    let mut faults = closely(given, &found.checked);
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
        let normal = normal_form(given, &list.nodes);
        let converged = run.converged && normal == list;
        let checked = check(given, &normal);
        faults = closely(given, &checked);
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

/// The list in which one tangent contact replaces two edges of a straight cell, where the beam penetrates the cell between them. With
/// both edges so close Newton's method would not find the tangent contact. [`None`] if there is no such fault.
fn tangent(given: &PiecewiseScene, list: &List, checked: &Check, faults: &[(usize, Violation)]) -> Option<List> {
    let mut nodes = list.nodes.clone();
    for (i, fault) in faults.iter().rev() {
        let (Violation::Penetration { at, .. }, Some(left)) = (fault, i.checked_sub(1)) else { continue };
        let Some(span) = part_at(&checked.spans, *i, *at) else { continue };
        // A compression-only support is not an edge of the foundation next to it.
        let is_edge = |node: &Node| node.is_edge(given) && node.is_ground(given);
        let both = nodes.get(left..=*i).is_some_and(|two| two.iter().all(is_edge));
        if both && span.a.cell == span.b.cell {
            nodes.splice(left..=*i, [Node::touch(*at, span.a.cell)]);
        }
    }
    (nodes.len() < list.nodes.len()).then(|| normal_form(given, &nodes))
}

/// The faults of a close check: penetration of a straight foundation as a share of the bow up to the next contact.
fn closely(given: &PiecewiseScene, checked: &Check) -> Vec<(usize, Violation)> {
    let mut faults = Vec::new();
    if !given.founded || !given.is_straight(0) || given.cells.len() < MANY {
        return faults;
    }
    for (i, span) in &checked.spans {
        let bent = span.beam_a[2].abs().max(span.beam_b[2].abs());
        let rounding = rounding(given, span);
        // Near an end, the lift that removes a penetration bends the whole span as much as if the penetration were everywhere.
        let allowed = |x: f64| {
            let near = (x - span.a.x).abs().min((span.b.x - x).abs());
            (SHARE * bent * near * near).min(checked.allowed(given, span, x)).max(rounding)
        };
        let found = deepest(given, &checked.pieces, span, allowed);
        faults.extend(found.map(|(at, depth)| (*i, Violation::Penetration { at, depth })));
    }
    faults
}

/// The rounding of the clearance in a span.
fn rounding(given: &PiecewiseScene, span: &Span) -> f64 {
    let depth = span.beam_a[0].abs().max(span.beam_b[0].abs());
    let cells = span.a.cell..=span.b.cell;
    let rise = if span.b.cell.abs_diff(span.a.cell) <= NEAR { steepest(given, cells) * span.length() } else { depth };
    ROUNDED * rise.min(depth)
}

/// The largest slope of some cells of a straight foundation.
fn steepest(given: &PiecewiseScene, cells: std::ops::RangeInclusive<usize>) -> f64 {
    cells.fold(0.0, |most, cell| given.derivative(cell, given.cells[cell].lo, 1).abs().max(most))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load, Scene, Support};
    use crate::theory::normal::edge_node;

    /// Between two edges of the foundation the beam touches the straight piece that joins them; two compression-only supports are kept.
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
