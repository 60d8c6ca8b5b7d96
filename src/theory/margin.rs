//! The margins of the conditions of a contact list, which change their sign where the kind of the answer changes.

use super::bernstein::{sign_changes, value};
use super::check::Check;
use super::forces::{forces, moments};
use super::list::{List, Node};
use super::penetration::in_bearings;
use super::piece::{derivatives, pieces_of};
use super::piecewise::PiecewiseScene;
use super::sensitivity::{ends, part_at, parts_before};
use super::span::Span;
use super::violation::Violation;

/// A condition of a contact list that can be followed from scene to scene. Indices are node indices of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Condition {
    /// A contact presses.
    Presses(usize),
    /// At a smooth point the profile is curved more than the beam, `h'' ≥ 0` on both sides.
    Bends(usize),
    /// The zone that starts at this node has a positive length.
    Length(usize),
    /// The zone that ends at this node is not in tension.
    ZonePresses(usize),
    /// The contact remains on its smooth piece of the profile.
    Stays(usize),
    /// Next to an edge or a support the beam is above the foundation: the slope of the clearance to its left (0) or to its right (1).
    Turns(usize, usize),
    /// The same next to a support at which the beam has the slope of the foundation: the curvature of the clearance.
    BendsBeside(usize, usize),
    /// The clearance in the span before this node.
    Clears(usize),
    /// Foundation and support push against each other.
    Couple(usize),
    /// The force of a support keeps its sign; true if it pulled before.
    Support(usize, bool),
}

/// The conditions that a list violates, as far as they can be followed; `pulls` says which supports pulled before.
pub(super) fn violated_conditions(
    given: &PiecewiseScene,
    list: &List,
    checked: &Check,
    pulls: &[bool],
) -> Vec<Condition> {
    let bent = |node: usize| {
        checked.faults.iter().any(|(i, fault)| *i == node && matches!(fault, Violation::CurvatureGap { .. }))
    };
    let mut conditions = Vec::new();
    let mut add = |condition: Condition| {
        if !conditions.contains(&condition) {
            conditions.push(condition);
        }
    };
    for &(i, fault) in &checked.faults {
        match fault {
            Violation::Pull { .. } => add(Condition::Presses(i)),
            Violation::CurvatureGap { .. } => add(Condition::Bends(i)),
            Violation::Inverted { .. } => add(Condition::Length(i)),
            Violation::PullAlong { .. } => add(Condition::ZonePresses(i)),
            Violation::Couple { .. } => add(Condition::Couple(i)),
            Violation::Penetration { at, .. } => {
                let Some(span) = part_at(&checked.spans, i, at) else { continue };
                let near = |x: f64| (at - x).abs() < 0.5 * span.length();
                let fixed =
                    |node: Option<usize>| node.filter(|&node| list.nodes.get(node).is_some_and(|n| !n.can_move()));
                let held = |node: Option<usize>| node.filter(|&node| rests(given, list, node));
                let left = fixed(i.checked_sub(1)).filter(|_| near(span.a.x) && span.at_a[0] <= 0.0);
                let right = fixed(Some(i)).filter(|_| near(span.b.x) && span.at_b[0] <= 0.0);
                match (held(left).filter(|_| span.at_a[2] < 0.0), held(right).filter(|_| span.at_b[2] < 0.0)) {
                    (Some(node), _) => add(Condition::BendsBeside(node, 1)),
                    (_, Some(node)) => add(Condition::BendsBeside(node, 0)),
                    _ => {}
                }
                let turned = |end: Option<usize>, turn: f64| end.filter(|_| turn < 0.0 && held(end).is_none());
                match (turned(left, span.at_a[1]), turned(right, -span.at_b[1])) {
                    (Some(node), _) => add(Condition::Turns(node, 1)),
                    (_, Some(node)) => add(Condition::Turns(node, 0)),
                    // Next to a point at which the beam is bent too much, it is below the foundation as well.
                    _ if bent(i) || i.checked_sub(1).is_some_and(bent) => {}
                    _ => add(Condition::Clears(i)),
                }
            }
            _ => {}
        }
    }
    for (i, (node, force)) in list.nodes.iter().zip(&checked.forces).enumerate() {
        if let Some(support) = node.support(given)
            && let Some(&pulled) = pulls.get(support)
        {
            let force = force + given.breakpoints[given.supports[support].breakpoint].acts.force();
            if (force < 0.0) != pulled {
                add(Condition::Support(i, pulled));
            }
        }
    }
    conditions
}

/// The condition that stopped Newton's method: a zone next to a stretch in which it would be in tension, or a contact at the end of its
/// smooth piece of the profile. Each step covers nine tenths of the remaining distance.
pub(super) fn stopped(given: &PiecewiseScene, list: &List) -> Option<Condition> {
    /// The distance that counts as reached, as a share of the beam length.
    const THERE: f64 = 1e-12;
    let nodes = list.nodes.iter().enumerate().filter(|(_, node)| node.can_move());
    let stays = nodes.map(|(i, _)| Condition::Stays(i));
    let conditions = list.zones().map(|zone| Condition::ZonePresses(zone.node)).chain(stays);
    let mut there = conditions.filter(|condition| {
        let far = condition.of(given, list, &[], &[]);
        far.is_some_and(|far| far.abs() <= THERE * given.length)
    });
    there.next()
}

/// Whether the node is a support at which the foundation fixes the slope of the beam.
fn rests(given: &PiecewiseScene, list: &List, node: usize) -> bool {
    list.nodes.get(node).is_some_and(|node| node.rests_at_support(given))
}

impl Condition {
    /// The margin where Newton's method stopped, so that the list belongs to no beam: negative if a zone now includes a load that would
    /// require tension, or if a contact has left its piece of the profile. The other conditions have no margin.
    pub(super) fn without_list(self) -> Option<f64> {
        matches!(self, Condition::ZonePresses(_) | Condition::Stays(_)).then_some(f64::NEG_INFINITY)
    }

    /// The margin for a list whose equations are satisfied; negative where the condition is violated. [`None`] where the condition does
    /// not apply; then it is not violated.
    pub(super) fn value(self, given: &PiecewiseScene, list: &List) -> Option<f64> {
        let spans = list.spans(given);
        let forces = forces(given, list, &spans);
        self.of(given, list, &spans, &forces)
    }

    /// The same, with the spans of the list and the forces of its nodes.
    fn of(self, given: &PiecewiseScene, list: &List, spans: &[(usize, Span)], forces: &[f64]) -> Option<f64> {
        let before = |node: usize| ends(spans, node)[0];
        let behind = |node: usize| ends(spans, node)[1];
        match self {
            Condition::Presses(node) => forces.get(node).copied(),
            Condition::Bends(node) => {
                let sides = [before(node).map(|span| span.at_b[2]), behind(node).map(|span| span.at_a[2])];
                sides.into_iter().flatten().reduce(f64::min)
            }
            Condition::Length(node) => Some(list.nodes.get(node + 1)?.x - list.nodes.get(node)?.x),
            Condition::ZonePresses(node) => {
                let (from, to) = (list.nodes.get(node.checked_sub(1)?)?.x, list.nodes.get(node)?.x);
                // The distance from the zone to the nearest stretch in tension, or the negative length of their overlap. An upward
                // point load is a stretch without length; its distance to the nearer end of the zone counts.
                let outside = |&(lo, hi): &(f64, f64)| {
                    if lo < hi { from.max(lo) - to.min(hi) } else { (from - lo).max(hi - to) }
                };
                given.pulling.iter().map(outside).reduce(f64::min)
            }
            Condition::Stays(node) => {
                let node = list.nodes.get(node)?;
                let (from, to) = given.reach(node.cell);
                Some((node.x - from).min(to - node.x))
            }
            Condition::Turns(node, 0) => before(node).map(|span| -span.at_b[1]),
            Condition::Turns(node, _) => behind(node).map(|span| span.at_a[1]),
            Condition::BendsBeside(node, 0) => before(node).map(|span| span.at_b[2]),
            Condition::BendsBeside(node, _) => behind(node).map(|span| span.at_a[2]),
            Condition::Clears(node) => {
                let parts = parts_before(spans, node).iter();
                parts.filter_map(|(_, span)| lowest(given, span)).reduce(f64::min)
            }
            Condition::Couple(node) => {
                let [left, right] = *moments(given, list, spans).get(node)?;
                list.nodes.get(node)?.support(given)?;
                Some(if list.follows_foundation(node)[1] { left - right } else { right - left })
            }
            Condition::Support(node, pulled) => {
                let support = &given.supports[list.nodes.get(node)?.support(given)?];
                let force = forces.get(node)? + given.breakpoints[support.breakpoint].acts.force();
                Some(if pulled { -force } else { force })
            }
        }
    }
}

/// The conditions of a list that can be evaluated before they fail, with their values: forces, curvatures, lengths of zones and
/// clearances.
pub(super) fn all(given: &PiecewiseScene, list: &List, pulls: &[bool]) -> Vec<(Condition, f64)> {
    let spans = list.spans(given);
    let forces = forces(given, list, &spans);
    let of_node = |(i, node): (usize, &Node)| match node.support(given) {
        Some(index) => [pulls.get(index).map(|&pulled| Condition::Support(i, pulled)), None],
        None if node.is_smooth() => [Some(Condition::Presses(i)), Some(Condition::Bends(i))],
        None if node.starts_zone() => [Some(Condition::Presses(i)), Some(Condition::Length(i))],
        None => [Some(Condition::Presses(i)), None],
    };
    let nodes = list.nodes.iter().enumerate().flat_map(of_node).flatten();
    let clearances = spans.iter().filter(|_| given.has_obstacle()).map(|(i, _)| Condition::Clears(*i));
    let value = |condition: Condition| Some((condition, condition.of(given, list, &spans, &forces)?));
    nodes.chain(clearances).filter_map(value).collect()
}

/// The least clearance inside a span: at its local minima, at edges of the profile, at a free end of the beam, and above
/// compression-only supports.
pub(super) fn lowest(given: &PiecewiseScene, span: &Span) -> Option<f64> {
    /// Distance from the ends, as a share of the span, below which a position does not count as inside.
    const BESIDE: f64 = 1e-7;
    let near = BESIDE * span.length();
    let inside = |x: f64| span.a.x + near < x && x < span.b.x - near;
    let mut pieces = Vec::new();
    pieces_of(given, span, &mut pieces);
    let mut taylor = vec![0.0; given.terms];
    let mut least: Option<f64> = None;
    let mut add = |h: f64| least = Some(least.map_or(h, |least: f64| least.min(h)));
    in_bearings(given, &pieces, span).for_each(|(_, depth)| add(-depth));
    if !given.founded {
        return least;
    }
    if span.is_overhang() {
        add(if span.a.x <= 0.0 { span.at_a[0] } else { span.at_b[0] });
    }
    for piece in pieces.iter().flat_map(|piece| piece.parts(given)) {
        if let Some(breakpoint) = given.breakpoint_at(piece.hi).filter(|&i| given.is_edge(i) && inside(piece.hi)) {
            piece.deflection(given, &mut taylor);
            let deflection = derivatives(&taylor, piece.hi - piece.anchor)[0];
            add(given.breakpoints[breakpoint].depth - deflection);
        }
        piece.clearance(given, &mut taylor);
        // A minimum may be exactly where two pieces meet.
        if inside(piece.hi) {
            add(derivatives(&taylor, piece.hi - piece.anchor)[0]);
        }
        piece.outwards(&mut taylor);
        #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
        let slope: Vec<f64> = taylor.iter().enumerate().skip(1).map(|(j, c)| c * j as f64).collect();
        for s in sign_changes(&slope, piece.width()).into_iter().filter(|&s| inside(piece.place(s))) {
            // Minima only.
            let [_, _, bend, _] = derivatives(&taylor, s);
            if 0.0 <= bend {
                add(value(&taylor, s));
            }
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::lowest;
    use crate::scene::{Beam, Foundation, Load, Scene};
    use crate::theory;

    /// Above a ridge that the beam nearly touches, in two positions along the beam.
    #[test]
    fn the_least_clearance_is_that_of_many_places() {
        for top in [4.0, 7.5] {
            let beam = Beam::new(10.0, 130.0).expect("a beam");
            let load = Load::uniform_on(&beam, 1.0).expect("a load");
            let points = vec![[0.0, 3.0], [top - 1.0, 2.0], [top, 1.2], [top + 1.0, 2.0], [10.0, 3.0]];
            let scene = Scene::new(beam, load, Some(Foundation::Polyline { points })).expect("a scene");
            let exact = theory::solve(&scene).expect("an answer");
            let [(_, span)] = &exact.spans[..] else { panic!("{:?}", exact.state.contacts) };
            let least = lowest(&exact.given, span).expect("above ground") * exact.units.depth;
            let places = (1..1000).map(|i| exact.clearance(f64::from(i) / 100.0));
            let expected = places.fold(f64::INFINITY, f64::min);
            assert!(0.0 < expected && (least - expected).abs() <= 1e-12, "{least}, not {expected}");
        }
    }
}
