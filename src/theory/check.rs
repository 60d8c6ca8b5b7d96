//! The check of all conditions, everywhere: no penetration, no pull, and the equations of the list.

use super::forces::{force_beside, forces, moments, pulling_couple, unbalanced};
use super::giving::{self, SpringState};
use super::list::{List, Node, Unknown, Zone};
use super::newton;
use super::penetration::deepest;
use super::piece::{Piece, all_pieces, derivatives};
use super::piecewise::PiecewiseScene;
use super::pull::mean_pull;
use super::sensitivity::ends;
use super::span::{EndCondition, Span};
use super::violation::Violation;
use crate::certificate::CERTIFIED_RESIDUAL;

/// No deflection or moment of a dimensionless beam with a hinge is larger: a mechanism that only rounding holds moves by far more.
pub(super) const MOST: f64 = 1e12;

/// A list with everything that follows from it.
#[derive(Debug, Clone)]
pub(super) struct Check {
    /// The beam by pieces, from end to end.
    pub(super) pieces: Vec<Piece>,
    /// The spans and overhangs, each with the index of the node to its right.
    pub(super) spans: Vec<(usize, Span)>,
    /// Concentrated forces at the nodes; of a support without the load that stands on it.
    pub(super) forces: Vec<f64>,
    /// Moments `−e v''` just to the left and just to the right of the nodes.
    pub(super) moments: Vec<[f64; 2]>,
    /// What the supports that give do.
    pub(super) springs: Vec<SpringState>,
    /// Conditions that fail, each with the index of its node, or of the node to the right of its stretch.
    pub(super) faults: Vec<(usize, Violation)>,
    /// Worst violation of any condition, scaled; what the tolerance is compared with.
    pub(super) worst: f64,
    /// What violations were measured against.
    scale: Scale,
}

impl Check {
    /// By how much a span may penetrate the ground at a place.
    pub(super) fn allowed(&self, given: &PiecewiseScene, span: &Span, at: f64) -> f64 {
        TOLERANCE * self.scale.depth_in(given, span, at)
    }

    /// What deflection and curvature have no digits below, wherever the profile has as many.
    pub(super) fn nothing(&self) -> Nothing {
        Nothing { depth: TOLERANCE * self.scale.deflection, bend: TOLERANCE * self.scale.moment }
    }

    /// Largest of all forces.
    pub(super) fn largest_force(&self) -> f64 {
        self.scale.force
    }

    /// The length of the shorter span beside a node.
    pub(super) fn shortest_beside(&self, node: usize) -> f64 {
        ends(&self.spans, node).into_iter().flatten().fold(f64::INFINITY, |least, span| span.length().min(least))
    }
}

/// A clearance and a bend that are rounding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nothing {
    pub(super) depth: f64,
    pub(super) bend: f64,
}

/// A violation below this is rounding: conditions are met to 12 digits of the largest deflection and moment, and of the forces and
/// bends beside a contact that may not pull or be bent too much. Forces elsewhere say nothing of its rounding: between two supports
/// that all but meet they may be 10¹⁷ times as large.
pub(super) const TOLERANCE: f64 = 1e-12;

/// Deflections, forces and moments are measured against these, but at least against this part of what the loads
/// do to a free beam: `TOLERANCE · AT_REST` is the rounding of an addition.
pub(super) const AT_REST: f64 = 1e-3;

/// Places of a piece of many cells at which the largest deflection and moment are looked for.
const PARTS: u32 = 8;

/// A contact that would have to move by less than this fraction of the beam is where it should be: a few units of the last
/// place of its position, which for steep profiles may be a jump of the moment above its tolerance.
pub(super) const PLACE: f64 = 4e-15;

/// A contact that would have to move by more than this fraction of a span beside it leaves that span without a correct
/// digit or two: what is in it, the lift-off beside a support for example, is rounding, however small its forces are beside
/// the load.
const UNRESOLVED: f64 = 1e-3;

/// What a force out of balance counts as a violation: a thousand-millionth of the forces may be, which is what
/// [`CERTIFIED_RESIDUAL`] allows a discretised answer. A force between contacts that are close together is the difference of far
/// larger ones, and has fewer digits than the moments: up to 8·10⁻¹⁰ is lost on surveys like saws with a hundred contacts.
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
    // Where a span is too short to be resolved, what is near it has no digits, and only forces that are large anywhere are faults.
    let resolved = judge.equations(given, list, &spans, &scale);
    // A NaN is no force that presses.
    let presses = |node: &Node, force: f64| node.support(given).is_some() || 0.0 <= force;
    for (i, (node, &force)) in list.nodes.iter().zip(&forces).enumerate().filter(|(_, (n, f))| !presses(n, **f)) {
        let pulls = Violation::Pull { at: node.x, force: -force };
        let most = if resolved { force_beside(&spans, i).max(AT_REST * given.total_load) } else { scale.force };
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
            let rests = list.rests(i);
            if let Some(moment) = pulling_couple(given, index, rests, jump) {
                judge.measure(moment, scale.moment, i, Violation::Couple { at, moment });
            }
            // A beam that the ground holds on both sides of a support has one slope there, and so has the ground.
            if rests == [true; 2] {
                let kink = given.breakpoints[given.supports[index].breakpoint].kink.abs();
                judge.measure(kink * given.length, scale.beside(given, index), i, Violation::Broken { at });
            }
        }
        // Without a couple, a zone reaches a free end only on ground that is not bent there, and the beam rests on one hinge only
        // if its loads are balanced.
        let alone = list.nodes.len() == 1 && !node.can_move() && node.held_slope(given).is_none();
        if node.is_tip(given) || alone {
            judge.measure(jump.abs(), scale.moment, i, Violation::Jump { jump });
        }
    }
    let springs = giving::states(given, list, &spans);
    let force = springs.iter().fold(unbalanced(given, list, &forces), |rest, spring| rest - spring.force);
    // A load on a support counts here, and no matter how large it is nowhere else.
    let carried = scale.force.max(AT_REST * given.resultant.abs());
    judge.measure(BALANCE * force.abs(), carried, 0, Violation::Unbalanced { force });
    let Judge { faults, worst } = judge;
    Check { pieces, spans, forces, moments, springs, faults, worst, scale }
}

/// Takes down what fails.
struct Judge {
    faults: Vec<(usize, Violation)>,
    worst: f64,
}

impl Judge {
    /// A condition that may be violated by as much as rounding, as a share of `scale`.
    fn measure(&mut self, violation: f64, scale: f64, index: usize, fault: Violation) {
        // A NaN is a violation.
        if violation.is_nan() || TOLERANCE * scale < violation {
            self.faults.push((index, fault));
        }
        let scaled = if 0.0 < scale { violation / scale } else { violation };
        self.worst = self.worst.max(if scaled.is_nan() { f64::INFINITY } else { scaled });
    }

    /// A condition that holds or does not.
    fn refuse(&mut self, index: usize, fault: Violation) {
        self.faults.push((index, fault));
        self.worst = f64::INFINITY;
    }

    /// Zones have a length and go over no break; contacts are on their piece of the profile.
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
            // A support that only pushes at an end of the beam may stand above the ground there.
            let stands = |i: &usize| {
                let (x, [cell, _]) = (given.breakpoints[*i].x, given.cells_beside(*i));
                zone.from <= x && x <= zone.to && given.is_bearing(*i) && 0.0 < given.height(*i, cell)
            };
            if let Some(end) = [0, given.cells.len()].into_iter().find(stands) {
                self.refuse(zone.node, Violation::Broken { at: given.breakpoints[end].x });
            }
        }
    }

    /// A span has numbers, and beside hinges none that rounding alone keeps finite: not so a mechanism.
    fn known(&mut self, given: &PiecewiseScene, index: usize, span: &Span) {
        let numbers = || span.beam_a.iter().chain(&span.beam_b);
        let is_hinged = || given.divisions.iter().any(|&i| given.breakpoints[i].joint.is_infinite());
        let known = numbers().all(|value| value.is_finite());
        if !known || numbers().any(|value| MOST < value.abs()) && is_hinged() {
            self.refuse(index, Violation::Overflow);
        }
    }

    /// At the smooth points beside span `i` the beam is bent no more than the profile, as a share of how both are bent there.
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

    /// Beside a support that the foundation starts at, `h = 0`, and the first derivative of `h` that is not zero decides: slope,
    /// moment, shear, each as a share of its own size. How deep the beam is may be next to nothing, and what the ground would do
    /// to it is not: over a length `d` a depth of the order `d³` stands for a force that does not depend on `d`.
    fn turns_at_supports(&mut self, given: &PiecewiseScene, list: &List, i: usize, span: &Span, scale: &Scale) {
        // Of a node to the left of the span the ground on its right counts. Outwards is into the span.
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
                // As deep as the parabola `h = −turn t + h'' t²/2` goes.
                let depth = turn * (turn / (2.0 * at[2].abs())).min(0.5 * span.length());
                self.measure(turn * given.length, size, i, Violation::Penetration { at: end.x, depth });
            }
            // Ground that holds the slope holds it at its own.
            let along = support.slope.is_some() || list.rests(node)[side];
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
            // `h = bend t²/2 − shear t³/6 + drive t⁴/24` has no root: a bend that is next to nothing is enough over a short span.
            if 0.0 < bend && shear * shear <= 3.0 * bend * drive {
                continue;
            }
            let force = [at[3], span.beam_a[3], span.beam_b[3], most / span.length()];
            let force = force.iter().fold(AT_REST * given.total_load, |most, f| most.max(f.abs()));
            // As deep as `h = −shear t³/6 + h'''' t⁴/24` goes.
            let place = (3.0 * shear / drive.abs()).min(0.5 * span.length());
            let fault =
                Violation::Penetration { at: end.x + outwards * place, depth: shear * place * place * place / 24.0 };
            self.measure(shear, force, i, fault);
        }
    }

    /// A zone pulls nowhere; where it might is known ([`PiecewiseScene::pulling`]). Pressure is a share of the load on the beam.
    fn pulls(&mut self, given: &PiecewiseScene, Zone { node, from, to }: Zone) {
        for &(lo, hi) in given.pulling_between(from, to) {
            let (lo, hi) = (lo.max(from), hi.min(to));
            let pull = mean_pull(given, lo, hi);
            self.measure(pull, given.total_load / given.length, node, Violation::PullAlong { from: lo, to: hi });
        }
    }

    /// The equations of the list hold, and its spans are long enough for them to have an answer: false if one is not.
    fn equations(&mut self, given: &PiecewiseScene, list: &List, spans: &[(usize, Span)], scale: &Scale) -> bool {
        let newton::Residual { jump, step, unresolved } = newton::residual(given, list, spans);
        let fixed = (0..list.nodes.len()).all(|i| list.unknown(given, i) != Some(Unknown::Place));
        let rounded = if fixed { jump } else { jump.min(step / PLACE * TOLERANCE * scale.moment) };
        // No single node is at fault.
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

/// How much beam and profile are bent at the ends of a span: what bends there are measured against.
fn most_bent(given: &PiecewiseScene, span: &Span) -> f64 {
    let bends = [span.at_a[2], span.at_b[2], span.beam_a[2], span.beam_b[2]];
    bends.iter().fold(moment_at_rest(given), |most, bend| most.max(bend.abs()))
}

/// The least curvature that bends are measured against.
fn moment_at_rest(given: &PiecewiseScene) -> f64 {
    AT_REST * given.total_load * given.length / 8.0
}

/// What violations are measured against that belong to the whole beam.
#[derive(Debug, Clone)]
struct Scale {
    /// Largest deflection.
    depth: f64,
    /// The same, but at least that of a beam at rest.
    deflection: f64,
    /// Largest of all forces.
    force: f64,
    /// Largest curvature: a moment over `EI`.
    moment: f64,
}

impl Scale {
    /// Largest deflection, largest of all forces, and the moment that goes with them.
    fn of(given: &PiecewiseScene, pieces: &[Piece], forces: &[f64]) -> Self {
        let mut taylor = vec![0.0; given.terms];
        let (mut depth, mut moment) = (0.0_f64, 0.0_f64);
        for piece in pieces {
            piece.deflection(given, &mut taylor);
            piece.outwards(&mut taylor);
            // Over many cells it may be largest anywhere.
            let parts = if piece.count() == 1 { 2 } else { PARTS };
            for part in (0..parts).map(f64::from) {
                let [v, _, v2, _] = derivatives(&taylor, piece.width() * (part / f64::from(parts)));
                depth = depth.max(v.abs());
                moment = moment.max((v2 * piece.stiffness(given)).abs());
            }
        }
        let force = forces.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
        // A beam at rest has nothing but rounding: of what its loads could do to it, and of the profile.
        let (l, load) = (given.length, AT_REST * given.total_load);
        let deflection = depth.max(sag_at_rest(given, l));
        Self { depth, deflection, force: force.max(moment / l).max(load), moment: moment.max(moment_at_rest(given)) }
    }

    /// Largest deflection, or the rounding of the profile if that is larger, beside a support, where the profile may be known far
    /// better than elsewhere.
    fn beside(&self, given: &PiecewiseScene, support: usize) -> f64 {
        self.deflection.max(AT_REST * given.supports[support].size)
    }

    /// Largest deflection, and the rounding of the profile at a place: near a support a polynomial is known far better than
    /// where its highest powers have grown. A span is at rest beside what the loads could do to a beam of its own length.
    fn depth_in(&self, given: &PiecewiseScene, span: &Span, x: f64) -> f64 {
        let at_rest = sag_at_rest(given, span.length());
        self.depth.max(at_rest).max(AT_REST * given.magnitude_at(x))
    }
}

/// The least deflection that penetration is measured against, on a length.
fn sag_at_rest(given: &PiecewiseScene, length: f64) -> f64 {
    AT_REST * given.total_load * length * length * length / 384.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load, Scene};

    /// Ground at the level of both supports, and a beam that sags as if there were none: it turns by `q l³/24 EI` into the ground at
    /// each of them.
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
            // No bend holds it up: as far as the middle.
            assert!(depth.is_some_and(|depth| (depth - 0.5 * turn * LENGTH).abs() < 1e-12), "{faults:?}");
        }
    }
}
