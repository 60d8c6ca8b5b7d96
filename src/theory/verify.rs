//! The check of all conditions, everywhere: no penetration, no tension, and the equations of the list.

use super::bernstein::lowest_below;
use super::forces::{forces, zone_force};
use super::given::Given;
use super::list::{AtSupport, Kind, List};
use super::measure::Scale;
use super::newton;
use super::piece::{Piece, derivatives, pieces_of, pieces_of_zone};
use super::span::Span;

/// A condition that does not hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fault {
    /// `v > u` in the stretch before node `span`.
    Penetration {
        /// Index of the node to the right.
        span: usize,
        /// Where it is worst.
        at: f64,
        /// `v − u`.
        depth: f64,
    },
    /// A node whose concentrated force pulls.
    Tension {
        /// Index of the node.
        node: usize,
        /// The force, negative.
        force: f64,
    },
    /// A point at which the profile is bent less than the beam, `u'' < v''`: beside it the beam would lie below.
    Bulge {
        /// Index of the node.
        node: usize,
        /// `h''`, negative.
        bend: f64,
    },
    /// A zone that would have to pull at the beam.
    Pull {
        /// Index of the node to the right of the zone.
        zone: usize,
        /// From where it pulls.
        from: f64,
        /// To where.
        to: f64,
    },
    /// A zone that goes over a kink or a step, which no beam can follow.
    Broken {
        /// Index of the node to the right of the zone.
        zone: usize,
        /// The joint.
        joint: usize,
    },
    /// A zone that ends before it starts.
    Inverted {
        /// Index of the node at which it starts.
        start: usize,
    },
    /// A support (0: left, 1: right) at which foundation and support would pull at each other.
    Couple {
        /// Which.
        support: usize,
        /// The moment there, over `EI`.
        moment: f64,
    },
    /// A contact that is not on the piece of the foundation that it was computed for.
    Astray {
        /// Index of the node.
        node: usize,
    },
    /// A span that is too short for its ends to be told apart.
    Unresolved {
        /// Index of the node to its right.
        span: usize,
    },
    /// Reactions and contacts do not carry the load.
    Unbalanced {
        /// What is left over.
        force: f64,
    },
    /// The equations of the list do not hold.
    Residual {
        /// Largest jump of the curvature.
        jump: f64,
    },
}

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

/// A violation below this is rounding: conditions are met to 12 digits of the largest deflection, force and moment.
pub(super) const TOLERANCE: f64 = 1e-12;

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
    let mut faults = Vec::new();
    let mut worst = 0.0_f64;
    let zones = list.zones(given);
    for (i, pair) in list.nodes.windows(2).enumerate() {
        if pair[0].kind == Kind::ZoneStart && pair[1].x < pair[0].x {
            faults.push(Fault::Inverted { start: i });
            worst = f64::INFINITY;
        }
    }
    for (i, node) in list.nodes.iter().enumerate().filter(|(_, n)| !matches!(n.kind, Kind::Edge(_))) {
        let (from, to) = given.reach(node.cell);
        if node.x < from || to < node.x {
            faults.push(Fault::Astray { node: i });
            worst = f64::INFINITY;
        }
    }
    for (i, &(from, to)) in (0..=list.nodes.len()).filter(|&i| list.in_zone_before(i)).zip(&zones) {
        let broken =
            (0..given.joints.len()).find(|&j| given.breaks_at(j) && from < given.joints[j].x && given.joints[j].x < to);
        if let Some(joint) = broken {
            faults.push(Fault::Broken { zone: i, joint });
            worst = f64::INFINITY;
        }
    }
    let spans = list.spans(given);
    let mut pieces = Vec::with_capacity(2 * given.cells.len());
    let (mut next_span, mut next_zone) = (spans.iter(), zones.iter());
    for i in 0..=list.nodes.len() {
        if list.in_zone_before(i) {
            if let Some(&(from, to)) = next_zone.next() {
                pieces_of_zone(given, from, to, &mut pieces);
            }
        } else if let Some((_, span)) = next_span.next() {
            pieces_of(given, span, &mut pieces);
        }
    }

    if pieces.is_empty() {
        // Nothing but zones that end before they start.
        pieces_of_zone(given, 0.0, given.length, &mut pieces);
    }
    let (forces, shear) = forces(given, list, &spans);
    let scale = Scale::of(given, &pieces, &forces, &shear);
    let mut judge = |violation: f64, scale: f64, fault: Fault| {
        // A NaN is a violation.
        if violation.is_nan() || TOLERANCE * scale < violation {
            faults.push(fault);
        }
        let scaled = if 0.0 < scale { violation / scale } else { violation };
        worst = worst.max(if scaled.is_nan() { f64::INFINITY } else { scaled });
    };
    for (&force, node) in forces.iter().zip(0..) {
        judge(-force, scale.force, Fault::Tension { node, force });
    }
    for (i, span) in &spans {
        for (node, bend) in [(i.checked_sub(1), span.at_a[2]), (Some(*i), span.at_b[2])] {
            if let Some(node) = node.filter(|&node| list.nodes.get(node).is_some_and(|n| n.kind == Kind::Smooth)) {
                judge(-bend, scale.moment, Fault::Bulge { node, bend });
            }
        }
        let (at, depth) = penetration(given, &pieces, span, &scale).unwrap_or((span.a.x, 0.0));
        judge(depth, scale.depth_at(given, at), Fault::Penetration { span: *i, at, depth });
        // Beside a support that the foundation starts at, the slope decides: how deep the beam is in a foundation that falls
        // off steeply may be next to nothing, and what holds its slope is not.
        for (support, end, at, outer) in
            [(0, &span.a, &span.at_a, *i == 0), (1, &span.b, &span.at_b, *i == list.nodes.len())]
        {
            let turn = if support == 0 { -at[1] } else { at[1] };
            if outer && list.supports[support] == AtSupport::Free && given.starts_at_zero(support) {
                // As deep as the parabola `h = −turn t + h'' t²/2` goes.
                let depth = turn * (turn / (2.0 * at[2].abs())).min(0.5 * span.length());
                judge(turn * given.length, scale.beside[support], Fault::Penetration { span: *i, at: end.x, depth });
            }
        }
    }
    for (i, &(from, to)) in (0..=list.nodes.len()).filter(|&i| list.in_zone_before(i)).zip(&zones) {
        for &(lo, hi) in lifting.iter().filter(|l| l.0 < to && (from < l.1 || from < l.0)) {
            let (lo, hi) = (lo.max(from), hi.min(to));
            let pull = mean_pull(given, lo, hi);
            judge(pull, scale.force / given.length, Fault::Pull { zone: i, from: lo, to: hi });
        }
    }
    for support in 0..2 {
        if let Some(moment) = couple(given, list, &spans, support) {
            judge(moment, scale.moment, Fault::Couple { support, moment });
        }
    }
    let force = unbalanced(given, list, &forces, &shear);
    judge(BALANCE * force.abs(), scale.force, Fault::Unbalanced { force });
    let newton::Residual { jump, step, crowded } = newton::residual(given, list);
    let fixed = list.nodes.iter().all(|n| matches!(n.kind, Kind::Edge(_)));
    let rounded = if fixed { jump } else { jump.min(step / PLACE * TOLERANCE * scale.moment) };
    judge(rounded, scale.moment, Fault::Residual { jump });
    let (part, span) = crowded;
    if CROWDED < part {
        faults.push(Fault::Unresolved { span });
        worst = worst.max(part);
    }
    Checked { pieces, spans, forces, shear, faults, worst }
}

/// The deepest penetration in a span, if it is deeper than rounding: `(place, depth)`.
fn penetration(given: &Given, pieces: &[Piece], span: &Span, scale: &Scale) -> Option<(f64, f64)> {
    let first = pieces.partition_point(|p| p.hi <= span.a.x);
    let mut taylor = vec![0.0; given.terms];
    let mut worst: Option<(f64, f64)> = None;
    for piece in pieces[first..].iter().take_while(|p| p.lo < span.b.x) {
        let bar =
            |worst: Option<(f64, f64)>| worst.map_or(TOLERANCE * scale.depth_at(given, piece.lo), |(_, depth)| depth);
        piece.clearance(given, &mut taylor);
        piece.outwards(&mut taylor);
        if let Some((s, value)) = lowest_below(&taylor, piece.width(), -bar(worst)) {
            worst = Some((piece.place(s), -value));
        }
        // An edge at the foot of cliffs: along them the clearance is a sum of their heights, at the edge it is what is given.
        let edge = given.joint_at(piece.hi).filter(|&joint| given.is_edge(joint) && piece.hi < span.b.x);
        if edge.is_some() {
            piece.deflection(given, &mut taylor);
            let depth = derivatives(&taylor, piece.hi - piece.anchor)[0] - given.depth(piece.hi);
            if bar(worst) < depth {
                worst = Some((piece.hi, depth));
            }
        }
    }
    worst
}

/// How much a zone would pull on the average between `lo` and `hi`, or at these two; a point load that pulls, spread over
/// the beam, if there is one.
fn mean_pull(given: &Given, lo: f64, hi: f64) -> f64 {
    let (first, last) = (given.cell_from(lo), given.cell_to(hi).max(given.cell_from(lo)));
    let inside = given.joints.iter().filter(|j| lo <= j.x && j.x <= hi);
    let point = -inside.map(|j| j.force.min(0.0)).sum::<f64>() / given.length;
    if hi <= lo {
        return point;
    }
    let mut sum = 0.0;
    for cell in first..=last {
        let c = &given.cells[cell];
        let (from, to) = (c.lo.max(lo), c.hi.min(hi));
        if from < to {
            sum += given.load_rule.integral(from, to, |x| given.drive(cell, x).max(0.0));
        }
    }
    point.max(sum / (hi - lo)).max(given.drive(first, lo)).max(given.drive(last, hi))
}

/// What is left of the load when reactions and contact forces are taken off.
fn unbalanced(given: &Given, list: &List, forces: &[f64], shear: &[f64; 2]) -> f64 {
    let loads = (0..given.cells.len()).map(|cell| {
        let c = &given.cells[cell];
        0.5 * (given.load(cell, c.lo) + given.load(cell, c.hi)) * (c.hi - c.lo)
    });
    let inside = given.joints.get(1..given.cells.len()).unwrap_or_default().iter().map(|j| j.force);
    let zones = list.zones(given).into_iter().map(|(from, to)| zone_force(given, from, to));
    loads.chain(inside).sum::<f64>() - shear[0] + shear[1] - forces.iter().sum::<f64>() - zones.sum::<f64>()
}

/// The moment `−v''` that foundation and support exert on the beam at a support together; it may only be negative.
fn couple(given: &Given, list: &List, spans: &[(usize, Span)], support: usize) -> Option<f64> {
    let (cell, x) = if support == 0 { (0, 0.0) } else { (given.cells.len() - 1, given.length) };
    let bend = given.derivative(cell, x, 2);
    match list.supports[support] {
        AtSupport::Free => None,
        AtSupport::Zone => Some(-bend),
        AtSupport::Clamped => {
            let (_, span) = if support == 0 { spans.first()? } else { spans.last()? };
            Some(if support == 0 { span.at_a[2] } else { span.at_b[2] } - bend)
        }
    }
}
