//! The check of all conditions, everywhere: no penetration, no tension, and the equations of the list.

use super::fault::Fault;
use super::forces::{couple, forces, unbalanced};
use super::given::Given;
use super::list::{AtSupport, Kind, List};
use super::measure::{Scale, TOLERANCE};
use super::newton;
use super::penetration::penetration;
use super::piece::{Piece, pieces_of, pieces_of_zone};
use super::pressure::mean_pull;
use super::span::Span;

/// A list with everything that follows from it.
#[derive(Debug, Clone)]
pub(super) struct Checked {
    /// The beam by pieces, from support to support.
    pub(super) pieces: Vec<Piece>,
    /// The spans, each with the index of the node to its right.
    pub(super) spans: Vec<(usize, Span)>,
    /// Concentrated forces at the nodes.
    pub(super) forces: Vec<f64>,
    /// Shear force beside the left and the right support.
    pub(super) shear: [f64; 2],
    /// Conditions that fail.
    pub(super) faults: Vec<Fault>,
    /// Worst violation of any condition, scaled; what the tolerance is compared with.
    pub(super) worst: f64,
}

/// A contact that would have to move by less than this fraction of the beam is where it should be: a few units of the last
/// place of its position, which for steep profiles may be a jump of the moment above its tolerance.
const PLACE: f64 = 4e-15;

/// A contact that would have to move by more than this fraction of a span beside it leaves that span without a correct
/// digit or two: what is in it, the lift-off beside a support for example, is rounding, however small its forces are beside
/// the load.
const CROWDED: f64 = 1e-3;

/// What a force out of balance counts as a violation: a thousand-millionth of the forces may be, which is what the judge of a
/// discretised answer allows. A force between contacts that are close together is the difference of far larger ones, and has
/// fewer digits than the moments: up to 8·10⁻¹⁰ is lost on surveys like saws with a hundred contacts.
const BALANCE: f64 = TOLERANCE / 1e-9;

/// Checks `list`.
pub(super) fn check(given: &Given, lifting: &[(f64, f64)], list: &List) -> Checked {
    let mut judge = Judge { faults: Vec::new(), worst: 0.0 };
    let zones: Vec<Zone> = (0..=list.nodes.len())
        .filter(|&i| list.in_zone_before(i))
        .zip(list.zones(given))
        .map(|(node, (from, to))| Zone { node, from, to })
        .collect();
    judge.places(given, list, &zones);
    let spans = list.spans(given);
    let pieces = all_pieces(given, list, &spans, &zones);
    let (forces, shear) = forces(given, list, &spans);
    let scale = Scale::of(given, &pieces, &forces, &shear);
    for (&force, node) in forces.iter().zip(0..) {
        judge.measure(-force, scale.force, Fault::Tension { node, force });
    }
    for (i, span) in &spans {
        judge.bends(list, *i, span, &scale);
        let (at, depth) = penetration(given, &pieces, span, &scale).unwrap_or((span.a.x, 0.0));
        judge.measure(depth, scale.depth_at(given, at), Fault::Penetration { span: *i, at, depth });
        judge.turns_at_supports(given, list, *i, span, &scale);
    }
    for zone in &zones {
        judge.pulls(given, lifting, zone, &scale);
    }
    for support in 0..2 {
        if let Some(moment) = couple(given, list, &spans, support) {
            judge.measure(moment, scale.moment, Fault::Couple { support, moment });
        }
    }
    let force = unbalanced(given, list, &forces, &shear);
    judge.measure(BALANCE * force.abs(), scale.force, Fault::Unbalanced { force });
    judge.equations(given, list, &scale);
    let Judge { faults, worst } = judge;
    Checked { pieces, spans, forces, shear, faults, worst }
}

/// A zone of the list.
struct Zone {
    /// Index of the node to its right.
    node: usize,
    from: f64,
    to: f64,
}

/// The beam by pieces, from support to support.
fn all_pieces(given: &Given, list: &List, spans: &[(usize, Span)], zones: &[Zone]) -> Vec<Piece> {
    let mut pieces = Vec::with_capacity(2 * given.cells.len());
    let (mut next_span, mut next_zone) = (spans.iter(), zones.iter());
    for i in 0..=list.nodes.len() {
        if list.in_zone_before(i) {
            if let Some(zone) = next_zone.next() {
                pieces_of_zone(given, zone.from, zone.to, &mut pieces);
            }
        } else if let Some((_, span)) = next_span.next() {
            pieces_of(given, span, &mut pieces);
        }
    }
    if pieces.is_empty() {
        // Nothing but zones that end before they start.
        pieces_of_zone(given, 0.0, given.length, &mut pieces);
    }
    pieces
}

/// Takes down what fails.
struct Judge {
    faults: Vec<Fault>,
    worst: f64,
}

impl Judge {
    /// A condition that may be violated by as much as rounding, as a share of `scale`.
    fn measure(&mut self, violation: f64, scale: f64, fault: Fault) {
        // A NaN is a violation.
        if violation.is_nan() || TOLERANCE * scale < violation {
            self.faults.push(fault);
        }
        let scaled = if 0.0 < scale { violation / scale } else { violation };
        self.worst = self.worst.max(if scaled.is_nan() { f64::INFINITY } else { scaled });
    }

    /// A condition that holds or does not.
    fn refuse(&mut self, fault: Fault) {
        self.faults.push(fault);
        self.worst = f64::INFINITY;
    }

    /// Zones have a length and go over no break; contacts are on their piece of the profile.
    fn places(&mut self, given: &Given, list: &List, zones: &[Zone]) {
        for (start, pair) in list.nodes.windows(2).enumerate() {
            if pair[0].kind == Kind::ZoneStart && pair[1].x < pair[0].x {
                self.refuse(Fault::Inverted { start });
            }
        }
        for (i, node) in list.nodes.iter().enumerate().filter(|(_, n)| !matches!(n.kind, Kind::Edge(_))) {
            let (from, to) = given.reach(node.cell);
            if node.x < from || to < node.x {
                self.refuse(Fault::Astray { node: i });
            }
        }
        for zone in zones {
            let inside = |x: f64| zone.from < x && x < zone.to;
            let broken = (0..given.joints.len()).find(|&j| given.breaks_at(j) && inside(given.joints[j].x));
            if let Some(joint) = broken {
                self.refuse(Fault::Broken { zone: zone.node, joint });
            }
        }
    }

    /// At the smooth points beside span `i` the beam is bent no more than the profile.
    fn bends(&mut self, list: &List, i: usize, span: &Span, scale: &Scale) {
        for (node, bend) in [(i.checked_sub(1), span.at_a[2]), (Some(i), span.at_b[2])] {
            if let Some(node) = node.filter(|&node| list.nodes.get(node).is_some_and(|n| n.kind == Kind::Smooth)) {
                self.measure(-bend, scale.moment, Fault::Bulge { node, bend });
            }
        }
    }

    /// Beside a support that the foundation starts at, the slope decides: how deep the beam is in a foundation that falls
    /// off steeply may be next to nothing, and what holds its slope is not.
    fn turns_at_supports(&mut self, given: &Given, list: &List, i: usize, span: &Span, scale: &Scale) {
        for (support, end, at, outer) in
            [(0, &span.a, &span.at_a, i == 0), (1, &span.b, &span.at_b, i == list.nodes.len())]
        {
            let turn = if support == 0 { -at[1] } else { at[1] };
            if outer && list.supports[support] == AtSupport::Free && given.starts_at_zero(support) {
                // As deep as the parabola `h = −turn t + h'' t²/2` goes.
                let depth = turn * (turn / (2.0 * at[2].abs())).min(0.5 * span.length());
                self.measure(
                    turn * given.length,
                    scale.beside[support],
                    Fault::Penetration { span: i, at: end.x, depth },
                );
            }
        }
    }

    /// A zone pulls nowhere; where it might is known (`lifting`).
    fn pulls(&mut self, given: &Given, lifting: &[(f64, f64)], zone: &Zone, scale: &Scale) {
        let &Zone { node, from, to } = zone;
        for &(lo, hi) in lifting.iter().filter(|l| l.0 < to && (from < l.1 || from < l.0)) {
            let (lo, hi) = (lo.max(from), hi.min(to));
            let pull = mean_pull(given, lo, hi);
            self.measure(pull, scale.force / given.length, Fault::Pull { zone: node, from: lo, to: hi });
        }
    }

    /// The equations of the list hold, and its spans are long enough for them to have an answer.
    fn equations(&mut self, given: &Given, list: &List, scale: &Scale) {
        let newton::Residual { jump, step, crowded } = newton::residual(given, list);
        let fixed = list.nodes.iter().all(|n| matches!(n.kind, Kind::Edge(_)));
        let rounded = if fixed { jump } else { jump.min(step / PLACE * TOLERANCE * scale.moment) };
        self.measure(rounded, scale.moment, Fault::Residual { jump });
        let (part, span) = crowded;
        if CROWDED < part {
            self.faults.push(Fault::Unresolved { span });
            self.worst = self.worst.max(part);
        }
    }
}
