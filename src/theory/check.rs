//! The check of all conditions along the whole beam: no penetration, no tension at contacts, and the equations of the list.

use super::forces::{force_beside, forces, moments, pulling_couple, unbalanced};
use super::giving::{self, SpringState};
use super::list::{List, Node, Unknown, Zone};
use super::newton;
use super::penetration::deepest;
use super::piece::{Piece, all_pieces};
use super::piecewise::PiecewiseScene;
use super::pull::mean_pull;
use super::span::{EndCondition, Span};
use super::violation::Violation;
use crate::certificate::CERTIFIED_RESIDUAL;

/// Upper limit of deflection and moment of a dimensionless beam with a hinge. A mechanism restrained only by rounding moves much farther.
pub(super) const MOST: f64 = 1e12;

/// A list with all results that follow from it.
#[derive(Debug, Clone)]
pub(super) struct Check {
    /// The beam by pieces, from end to end.
    pub(super) pieces: Vec<Piece>,
    /// The spans and overhangs, each with the index of the node to its right.
    pub(super) spans: Vec<(usize, Span)>,
    /// Concentrated forces at the nodes; at a support without the load directly on it.
    pub(super) forces: Vec<f64>,
    /// Moments `−e v''` just to the left and just to the right of the nodes.
    pub(super) moments: Vec<[f64; 2]>,
    /// The states of the elastic supports.
    pub(super) springs: Vec<SpringState>,
    /// Violated conditions, each with the index of its node, or of the node to the right of its stretch.
    pub(super) faults: Vec<(usize, Violation)>,
    /// Largest violation of any condition, scaled; it is compared with the tolerance.
    pub(super) worst: f64,
    /// The scales of the violations.
    scale: Scale,
}

impl Check {
    /// The penetration that a span may have at a position.
    pub(super) fn allowed(&self, given: &PiecewiseScene, span: &Span, at: f64) -> f64 {
        TOLERANCE * self.scale.depth_in(given, span, at)
    }

    /// The rounding of clearance and curvature, where the profile is known as precisely.
    pub(super) fn nothing(&self) -> Nothing {
        Nothing { depth: TOLERANCE * self.scale.deflection, bend: TOLERANCE * self.scale.moment }
    }

    /// Largest of all forces.
    pub(super) fn largest_force(&self) -> f64 {
        self.scale.force
    }
}

/// A clearance and a curvature that are only rounding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nothing {
    pub(super) depth: f64,
    pub(super) bend: f64,
}

/// A smaller violation is rounding. Conditions are satisfied to 12 digits of the largest deflection and moment. For a contact in tension
/// or with too much curvature, the scale is the forces and curvatures next to it. Forces elsewhere do not determine its rounding: between
/// two supports that are almost at one position they may be 10¹⁷ times as large.
pub(super) const TOLERANCE: f64 = 1e-12;

/// Lower limit of the scales of deflections, forces and moments, as a share of the effect of the loads on a free beam.
/// `TOLERANCE · AT_REST` is the rounding of an addition.
pub(super) const AT_REST: f64 = 1e-3;

/// Number of positions in a piece of many cells at which the largest deflection and moment are sought.
const PARTS: u32 = 8;

/// A contact that would have to move by less than this fraction of the beam is at the right position. This is a few units in the last
/// place of the position, and for steep profiles it can cause a jump of the moment above its tolerance.
pub(super) const PLACE: f64 = 4e-15;

/// If a contact would have to move by more than this fraction of a span next to it, that span does not have even one or two correct
/// digits. Its results, for example the lift-off next to a support, are then rounding, however small its forces are compared with the
/// load.
const UNRESOLVED: f64 = 1e-3;

/// Factor for an unbalanced force: a billionth of the forces is allowed, as [`CERTIFIED_RESIDUAL`] allows it for a discretised answer. A
/// force between contacts that are close together is the difference of much larger forces, and has fewer digits than the moments. The
/// loss is up to 8·10⁻¹⁰ on saw-like surveys with a hundred contacts.
const BALANCE: f64 = TOLERANCE / CERTIFIED_RESIDUAL;

/// Checks `list`.
pub(super) fn check(given: &PiecewiseScene, list: &List) -> Check {
    let mut judge = Judge { faults: Vec::new(), worst: 0.0 };
    judge.places(given, list);
    let spans = list.spans(given);
    let pieces = all_pieces(given, list, &spans);
    let forces = forces(given, list, &spans);
    let moments = moments(given, list, &spans);
    let scale = Scale::of(given, &pieces, &forces);
    // Near a span that is too short to be resolved no digit is correct: only tension that is large among all forces is a violation.
    let resolved = judge.equations(given, list, &spans, &scale);
    // NaN does not count as compression.
    let presses = |node: &Node, force: f64| node.support(given).is_some() || 0.0 <= force;
    for (i, (node, &force)) in list.nodes.iter().zip(&forces).enumerate().filter(|(_, (n, f))| !presses(n, **f)) {
        let pulls = Violation::Pull { at: node.x, force: -force };
        let most = if resolved { force_beside(given, &spans, i).max(AT_REST * given.total_load) } else { scale.force };
        judge.measure(-force, most, i, pulls);
    }
    for (i, span) in &spans {
        judge.known(given, *i, span);
        judge.bends(given, list, *i, span);
        if !given.has_obstacle() {
            continue;
        }
        let allowed = |x: f64| TOLERANCE * scale.depth_in(given, span, x);
        let (at, depth) = deepest(given, &pieces, span, allowed).unwrap_or((span.a.x, 0.0));
        judge.measure(depth, scale.depth_in(given, span, at), *i, Violation::Penetration { at, depth });
        judge.turns_at_supports(given, list, *i, span, &scale);
    }
    for zone in list.zones() {
        judge.pulls(given, zone);
    }
    for (i, (node, [left, right])) in list.nodes.iter().zip(&moments).enumerate() {
        let (at, jump) = (node.x, right - left + node.couple(given));
        if let Some(index) = node.support(given) {
            let rests = list.follows_foundation(i);
            if let Some(moment) = pulling_couple(given, index, rests, jump) {
                judge.measure(moment, scale.moment, i, Violation::Couple { at, moment });
            }
            // A beam that follows the foundation on both sides of a support has one slope there, so the foundation must too.
            if rests == [true; 2] {
                let kink = given.breakpoints[given.supports[index].breakpoint].kink.abs();
                judge.measure(kink * given.length, scale.beside(given, index), i, Violation::Broken { at });
            }
        }
        // Without a couple, a zone reaches a free end only on a foundation without curvature there, and the beam rests on one hinge only
        // if its loads are balanced.
        let alone = list.nodes.len() == 1 && !node.can_move() && node.held_slope(given).is_none();
        if node.is_tip(given) || alone {
            judge.measure(jump.abs(), scale.moment, i, Violation::Jump { jump });
        }
    }
    let springs = giving::spring_states(given, list, &spans);
    let force = springs.iter().fold(unbalanced(given, list, &forces), |rest, spring| rest - spring.force);
    // A load directly on a support counts only here, however large it is.
    let carried = scale.force.max(AT_REST * given.resultant.abs());
    judge.measure(BALANCE * force.abs(), carried, 0, Violation::Unbalanced { force });
    let Judge { faults, worst } = judge;
    Check { pieces, spans, forces, moments, springs, faults, worst, scale }
}

/// Collects the violated conditions.
struct Judge {
    faults: Vec<(usize, Violation)>,
    worst: f64,
}

impl Judge {
    /// Adds a condition that may be violated within rounding, as a share of `scale`.
    fn measure(&mut self, violation: f64, scale: f64, index: usize, fault: Violation) {
        // NaN is a violation.
        if violation.is_nan() || TOLERANCE * scale < violation {
            self.faults.push((index, fault));
        }
        let scaled = if 0.0 < scale { violation / scale } else { violation };
        self.worst = self.worst.max(if scaled.is_nan() { f64::INFINITY } else { scaled });
    }

    /// Adds a condition that is violated without a measure.
    fn refuse(&mut self, index: usize, fault: Violation) {
        self.faults.push((index, fault));
        self.worst = f64::INFINITY;
    }

    /// Zones have a length and contain no break; contacts are on their piece of the profile.
    fn places(&mut self, given: &PiecewiseScene, list: &List) {
        for (start, pair) in list.nodes.windows(2).enumerate() {
            if pair[0].starts_zone() && pair[1].x < pair[0].x {
                self.refuse(start, Violation::Inverted { from: pair[0].x, to: pair[1].x });
            }
        }
        for (i, node) in list.nodes.iter().enumerate().filter(|(_, n)| n.can_move()) {
            let (from, to) = given.reach(node.cell);
            if node.x < from || to < node.x {
                self.refuse(i, Violation::OffPiece { at: node.x });
            }
        }
        for zone in list.zones() {
            if let Some(breakpoint) =
                given.breakpoints_inside(zone.from, zone.to).find(|&breakpoint| given.breaks_at(breakpoint))
            {
                self.refuse(zone.node, Violation::Broken { at: given.breakpoints[breakpoint].x });
            }
            // A compression-only support at an end of the beam may be above the foundation there.
            let stands = |i: &usize| {
                let (x, [cell, _]) = (given.breakpoints[*i].x, given.cells_beside(*i));
                zone.from <= x && x <= zone.to && given.is_bearing(*i) && 0.0 < given.height(*i, cell)
            };
            if let Some(end) = [0, given.cells.len()].into_iter().find(stands) {
                self.refuse(zone.node, Violation::Broken { at: given.breakpoints[end].x });
            }
        }
    }

    /// The values of a span are finite, and next to hinges also below the limit: the values of a mechanism are kept finite only by
    /// rounding.
    fn known(&mut self, given: &PiecewiseScene, index: usize, span: &Span) {
        let numbers = || span.beam_a.iter().chain(&span.beam_b);
        let known = numbers().all(|value| value.is_finite());
        if !known || numbers().any(|value| MOST < value.abs()) && given.has_hinge() {
            self.refuse(index, Violation::Overflow);
        }
    }

    /// At the smooth contact points next to span `i`, the curvature of the beam does not exceed the curvature of the profile.
    fn bends(&mut self, given: &PiecewiseScene, list: &List, i: usize, span: &Span) {
        let most = most_bent(given, span);
        for (node, end, bend) in [(i.checked_sub(1), &span.a, span.at_a[2]), (Some(i), &span.b, span.at_b[2])] {
            let node = node.filter(|_| end.hold != EndCondition::Within);
            let point = node.and_then(|i| list.nodes.get(i).map(|node| (i, node))).filter(|(_, n)| n.is_smooth());
            if let Some((i, node)) = point {
                self.measure(-bend, most, i, Violation::CurvatureGap { at: node.x, moment: -bend });
            }
        }
    }

    /// Next to a support at which the foundation begins, `h = 0`. The first derivative of `h` that is not zero decides: slope, moment or
    /// shear force, each relative to its own size. The penetration itself may be almost zero while its effect is not: over a length `d`,
    /// a penetration of the order `d³` corresponds to a force that does not depend on `d`.
    fn turns_at_supports(&mut self, given: &PiecewiseScene, list: &List, i: usize, span: &Span, scale: &Scale) {
        // For a node to the left of the span, the foundation to the right of the node counts. Outwards means into the span.
        let ends = [(i.checked_sub(1), 1, 1.0, &span.a, &span.at_a), (Some(i), 0, -1.0, &span.b, &span.at_b)];
        for (node, side, outwards, end, at) in ends {
            let is_node = |node: &usize| *node < list.nodes.len() && end.hold != EndCondition::Within;
            let Some(node) = node.filter(is_node) else { continue };
            let Some(index) = list.nodes[node].support(given) else { continue };
            let support = &given.supports[index];
            if !support.tangent[side] {
                continue;
            }
            let turn = -outwards * at[1];
            let size = scale.beside(given, index);
            if !list.nodes[node].is_held() {
                // The depth of the parabola `h = −turn t + h'' t²/2`.
                let depth = turn * (turn / (2.0 * at[2].abs())).min(0.5 * span.length());
                self.measure(turn * given.length, size, i, Violation::Penetration { at: end.x, depth });
            }
            // If the foundation restrains the slope, the slope of the beam is the slope of the foundation.
            let along = support.slope.is_some() || list.follows_foundation(node)[side];
            if !along && TOLERANCE * size < turn.abs() * given.length {
                continue;
            }
            let [bend, most] = [at[2], most_bent(given, span)];
            self.measure(-bend, most, node, Violation::CurvatureGap { at: end.x, moment: -bend });
            if TOLERANCE * most < bend.abs() {
                continue;
            }
            let shear = -outwards * at[3];
            let drive = given.drive(end.cell, end.x);
            // `h = bend t²/2 − shear t³/6 + drive t⁴/24` has no root: over a short span a curvature that is almost zero is enough.
            if 0.0 < bend && shear * shear <= 3.0 * bend * drive {
                continue;
            }
            let force = [at[3], span.beam_a[3], span.beam_b[3], most / span.length()];
            let force = force.iter().fold(AT_REST * given.total_load, |most, f| most.max(f.abs()));
            // The depth of `h = −shear t³/6 + h'''' t⁴/24`.
            let place = (3.0 * shear / drive.abs()).min(0.5 * span.length());
            let fault =
                Violation::Penetration { at: end.x + outwards * place, depth: shear * place * place * place / 24.0 };
            self.measure(shear, force, i, fault);
        }
    }

    /// No part of a zone is in tension; [`PiecewiseScene::pulling`] has the possible parts. Its scale is the mean load on the beam.
    fn pulls(&mut self, given: &PiecewiseScene, Zone { node, from, to }: Zone) {
        for &(lo, hi) in given.pulling_between(from, to) {
            let (lo, hi) = (lo.max(from), hi.min(to));
            let pull = mean_pull(given, lo, hi);
            self.measure(pull, given.total_load / given.length, node, Violation::PullAlong { from: lo, to: hi });
        }
    }

    /// The equations of the list are satisfied, and its spans are long enough to be resolved: returns false if one is not.
    fn equations(&mut self, given: &PiecewiseScene, list: &List, spans: &[(usize, Span)], scale: &Scale) -> bool {
        let newton::Residual { jump, step, unresolved } = newton::residual(given, list, spans);
        let fixed = (0..list.nodes.len()).all(|i| list.unknown(given, i) != Some(Unknown::Place));
        let rounded = if fixed { jump } else { jump.min(step / PLACE * TOLERANCE * scale.moment) };
        // The violation belongs to no single node.
        self.measure(rounded, scale.moment, list.nodes.len(), Violation::Jump { jump });
        let (part, span) = unresolved;
        if part <= UNRESOLVED {
            return true;
        }
        let from = span.checked_sub(1).map_or(0.0, |i| list.nodes[i].x);
        let to = list.nodes.get(span).map_or(given.length, |n| n.x);
        self.faults.push((span, Violation::Unresolved { from, to }));
        self.worst = self.worst.max(part);
        false
    }
}

/// The largest curvature of beam and profile at the ends of a span: the scale of curvatures there.
fn most_bent(given: &PiecewiseScene, span: &Span) -> f64 {
    let bends = [span.at_a[2], span.at_b[2], span.beam_a[2], span.beam_b[2]];
    bends.iter().fold(moment_at_rest(given), |most, bend| most.max(bend.abs()))
}

/// The smallest scale of curvatures.
fn moment_at_rest(given: &PiecewiseScene) -> f64 {
    AT_REST * given.total_load * given.length / 8.0
}

/// Scales of violations that belong to the whole beam.
#[derive(Debug, Clone)]
struct Scale {
    /// Largest deflection.
    depth: f64,
    /// Largest deflection, but at least the deflection of a beam at rest.
    deflection: f64,
    /// Largest of all forces.
    force: f64,
    /// Largest curvature: a moment over `EI`.
    moment: f64,
}

impl Scale {
    /// Determines largest deflection, force and moment.
    fn of(given: &PiecewiseScene, pieces: &[Piece], forces: &[f64]) -> Self {
        let mut taylor = vec![0.0; given.terms];
        let (mut depth, mut moment) = (0.0_f64, 0.0_f64);
        for piece in pieces {
            piece.deflection(given, &mut taylor);
            piece.outwards(&mut taylor);
            // Over many cells the maximum may be anywhere.
            let parts = if piece.count() == 1 { 2 } else { PARTS };
            for part in (0..parts).map(f64::from) {
                let [v, _, bent, _] = piece.beam(given, &taylor, piece.width() * (part / f64::from(parts)));
                depth = depth.max(v.abs());
                moment = moment.max(bent.abs());
            }
        }
        let force = forces.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
        // A beam at rest has only rounding: the rounding of the effect of its loads, and of the profile.
        let (l, load) = (given.length, AT_REST * given.total_load);
        let deflection = depth.max(sag_at_rest(given, l));
        Self { depth, deflection, force: force.max(moment / l).max(load), moment: moment.max(moment_at_rest(given)) }
    }

    /// Largest deflection next to a support, or the rounding of the profile if that is larger. The profile may be known much better there
    /// than elsewhere.
    fn beside(&self, given: &PiecewiseScene, support: usize) -> f64 {
        self.deflection.max(AT_REST * given.supports[support].size)
    }

    /// Largest deflection, or the rounding of the profile at a position: near a support a polynomial is known much better than where its
    /// highest powers are large. The limit for a span at rest is the effect of the loads on a beam of its own length.
    fn depth_in(&self, given: &PiecewiseScene, span: &Span, x: f64) -> f64 {
        let at_rest = sag_at_rest(given, span.length());
        self.depth.max(at_rest).max(AT_REST * given.magnitude_at(x))
    }
}

/// The smallest scale of penetration, for a span of this length.
fn sag_at_rest(given: &PiecewiseScene, length: f64) -> f64 {
    AT_REST * given.total_load * length * length * length / 384.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load, Scene};

    /// Foundation at the level of both supports: at each of them the sagging beam rotates into the foundation by `q l³/24 EI`.
    #[test]
    fn a_beam_that_turns_into_the_ground_beside_its_supports() {
        const LENGTH: f64 = 1.5;
        let beam = Beam::new(LENGTH, 1.0).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 0.0 })).expect("a scene");
        let given = PiecewiseScene::new(&scene);
        let Check { faults, worst, scale, .. } = check(&given, &List::free(&given));
        let turn = LENGTH * LENGTH * LENGTH / 24.0;
        let expected = turn * LENGTH / scale.deflection;
        assert!((worst / expected - 1.0).abs() < 1e-12, "{worst} instead of {expected}");
        for end in [0.0, LENGTH] {
            let depth = faults.iter().find_map(|(_, fault)| match fault {
                Violation::Penetration { at, depth } if at.to_bits() == end.to_bits() => Some(*depth),
                _ => None,
            });
            // No curvature limits the penetration: it extends to the middle of the span.
            assert!(depth.is_some_and(|depth| (depth - 0.5 * turn * LENGTH).abs() < 1e-12), "{faults:?}");
        }
    }
}
