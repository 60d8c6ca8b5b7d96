//! Scenes that differ by next to nothing, or by the side from which they are seen, have answers that do so too.

use palkki::scene::{Foundation, Quantity, Scene, Support};
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Verdict};

use super::laws::{CERTAIN, certified, exceeds, flexibility, sizes};
use super::trial::Trial;
use crate::definition::FIVE;
use crate::draft::Draft;

/// The same with loads at supports and ends that were next to them, and the sum of the forces by what they were moved.
fn snapped(draft: &Draft, supports: &[Support]) -> (Draft, f64) {
    const NEAR: f64 = 2e-6;
    let mut other = draft.clone();
    let (length, mut off) = (draft.length, 0.0);
    let nearest = |x: f64| {
        let places = supports.iter().map(|s| s.at).chain([0.0, length]);
        places.min_by(|a, b| (a - x).abs().total_cmp(&(b - x).abs())).filter(|at| (at - x).abs() <= NEAR * length)
    };
    for (load, at) in other.point.iter_mut().filter_map(|load| nearest(load.at).map(|at| (load, at))) {
        off += load.force.abs() * (load.at - at).abs();
        load.at = at;
    }
    for q in &mut other.linear {
        let [from, to] = [q.from, q.to].map(|x| nearest(x).unwrap_or(x));
        if from < to {
            // A strip at each end, and the stretch of what is between.
            let moved = (q.from - from).abs() + (q.to - to).abs();
            off += 3.0 * q.start.abs().max(q.end.abs()) * moved * length;
            (q.from, q.to) = (from, to);
        }
    }
    (other, off)
}

/// A beam on two supports at least moves by little if a load does, whatever it touches: the deflection is a projection in the norm of
/// the bending energy, which brings nothing farther apart.
pub(super) fn near(trial: &mut Trial, draft: &Draft, exact: &Exact) {
    let supports = draft.all_supports();
    let [first, last] = [
        supports.iter().map(|s| s.at).fold(f64::INFINITY, f64::min),
        supports.iter().map(|s| s.at).fold(0.0, f64::max),
    ];
    if supports.len() < 2 || last - first < 0.1 * draft.length {
        return;
    }
    let (length, levers) = (draft.length, draft.length / (last - first));
    let (other, off) = snapped(draft, &supports);
    if off == 0.0 {
        return;
    }
    let Some(beside) = other.scene().ok().as_ref().and_then(certified) else { return };
    // Slope by a couple of one and deflection by a force of one, in the energy norm: of a beam on two supports with overhangs.
    let bound = levers * levers * off * length * length / draft.stiffness;
    let [moved, own] = apart(draft, exact, &beside);
    if exceeds(moved, 4.0 * (levers * off) * (levers * off) * length + 1e-10 * own) {
        let share = (moved / own).sqrt();
        trial.wrong.push(format!("theory: a load moved by next to nothing changes its moments by {share:e}"));
    }
    let size = exact.state.deflection.magnitude();
    for k in 0..=64 {
        let x = length * f64::from(k) / 64.0;
        let apart = (exact.deflection(x) - beside.deflection(x)).abs();
        if exceeds(apart, bound + 2.0 * CERTAIN * size) {
            trial.wrong.push(format!(
                "theory: a load moved by next to nothing moves the beam at {x} by {apart:e} of {size:e}"
            ));
            return;
        }
    }
}

/// The integral of the squared difference of two moments, and that of the one.
fn apart(draft: &Draft, a: &Exact, b: &Exact) -> [f64; 2] {
    let length = draft.length;
    let mut places: Vec<f64> = (0..=200).map(|k| length * f64::from(k) / 200.0).chain(draft.places()).collect();
    for state in [&a.state, &b.state] {
        places.extend(state.contacts.iter().flat_map(|c| [c.from, c.to]));
        places.extend(state.supports.iter().map(|s| s.at));
    }
    places.sort_by(f64::total_cmp);
    places.windows(2).fold([0.0; 2], |sums, pair| {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        FIVE.iter().fold(sums, |[sum, own], [place, weight]| {
            let x = middle + half * place;
            let ([a, b], unit) = ([a.moment(x), b.moment(x)], half * weight);
            [sum + (a - b) * (a - b) * unit, own + a * a * unit]
        })
    })
}

/// A beam that is a little stiffer and one whose ground is a little deeper are bent a little otherwise. The deflection is a projection on
/// the set of those that are admissible, in the norm of the bending energy: a share of the loads less moves it by no more than that
/// share of what they would do to the free beam; and in a larger set, `½ ‖v − v'‖² ≤ J* − J'*`.
pub(super) fn continuous(trial: &mut Trial, draft: &Draft, scene: &Scene, exact: &Exact) {
    const SHARE: f64 = 1e-8;
    /// What a certified answer may be off in the square of its moments.
    const SQUARE: f64 = 1e-10;
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let (force, size) = sizes(scene, &exact.state);
    let held = scene.beam().supports();
    let base = held.last().map_or(0.0, |s| s.at) - held.first().map_or(0.0, |s| s.at);
    if 0.1 * length < base
        && let Some(other) =
            scene.with_number(Quantity::BendingStiffness, stiffness * (1.0 + SHARE)).ok().as_ref().and_then(certified)
    {
        let [off, own] = apart(draft, exact, &other);
        // A beam on two supports with overhangs, bent by all forces at the worst place.
        let free = scene.load().magnitude(length) * (length / base);
        let bound = SHARE * SHARE * (free * free * length * length * length + own);
        if exceeds(off, 4.0 * bound + SQUARE * own) {
            let share = (off / own).sqrt();
            trial.wrong.push(format!("theory: stiffer by {SHARE:e}, its moments differ by {share:e}"));
        }
    }
    for share in [1e-12, 1e-6, 1e-2] {
        let Some(other) = scene.with_ground_moved(share * size).ok().as_ref().and_then(certified) else { continue };
        let [off, own] = apart(draft, exact, &other);
        let gained = exact.state.energy - other.state.energy;
        let bound = 2.0 * stiffness * (gained + 1e-12 * force * size);
        if exceeds(off, bound.max(0.0) * (1.0 + 1e-3) + SQUARE * own) {
            let share_off = (off / own).sqrt();
            trial.wrong.push(format!(
                "theory: with the ground deeper by {share:e} its moments differ by {share_off:e}, its energy by {gained:e}"
            ));
        }
    }
}

/// The same from right to left, if no number is rounded on the way.
fn mirrored(draft: &Draft) -> Option<Draft> {
    let exact = |profile: &Option<Foundation>| {
        matches!(profile, None | Some(Foundation::Flat { .. } | Foundation::Polyline { .. }))
    };
    let other = draft.mirrored();
    (exact(&draft.ground) && exact(&draft.shape) && other.mirrored().text() == draft.text()).then_some(other)
}

/// Seen from the other side a beam has the same answer.
pub(super) fn mirror(trial: &mut Trial, draft: &Draft, exact: &Exact) {
    let Some(other) = mirrored(draft).and_then(|draft| draft.scene().ok()) else { return };
    let Ok(there) = theory::solve(&other) else { return };
    if let Some(refusal) = Verdict::of_exact(&other, &there, &Demand::default()).refusal {
        trial.wrong.push(format!("theory: certified, but not seen from the other side: {refusal}"));
        return;
    }
    let size = exact.state.deflection.magnitude();
    let free = flexibility(&other) * other.load().magnitude(draft.length);
    let turns = exact.state.standing.is_some_and(|standing| standing.motion.is_some());
    let off = (size - there.state.deflection.magnitude()).abs();
    if !turns && exceeds(off, CERTAIN * size + 64.0 * f64::EPSILON * f64::EPSILON * free) {
        trial.wrong.push(format!("theory: seen from the other side its deflection of {size:e} is another by {off:e}"));
    }
    let (force, _) = sizes(&other, &there.state);
    for (a, b) in exact.state.supports.iter().zip(there.state.supports.iter().rev()) {
        let off = (a.force - b.force).abs();
        // A force beside one that dwarfs it counts by itself.
        let beside = exact.shear(a.at).into_iter().fold(a.force.abs(), |most: f64, v| most.max(v.abs()));
        if exceeds(off, CERTAIN * beside.max(1e-9 * force)) {
            trial.wrong.push(format!(
                "theory: seen from the other side the force at {} is {:e} for {:e}",
                a.at, b.force, a.force
            ));
            return;
        }
    }
}
