//! The general beam: couples, steps, joints, springs and axial forces put onto scenes of other families, with numbers of all sizes, and now and then with one
//! that has to be refused. What is certified is compared with a proof in fractions, with the mirror image and with another route.

use palkki::proof::prove;
use palkki::scene::file::FileError;
use palkki::scene::{CoupleLoad, Joint, Scene, Support};
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Verdict};
use palkki::{Witness, solve_raw};

use crate::authority::check;
use crate::draft::Draft;
use crate::random::Random;

use super::brought::forces;
use super::held::{shaped, supported};
use super::laws::overlap;
use super::near::beside;
use super::scenes::{ordinary, power, rough, sag, ties};
use super::trial::{Trial, on_fitting_grid, read, settings};

/// A place of the draft, one beside it, or any; seldom one beyond the beam.
fn place(random: &mut Random, draft: &Draft) -> f64 {
    let places = draft.places();
    let given = places[random.below(places.len())];
    match random.below(24) {
        0 => random.pick(&[-1e-9, f64::NAN, draft.length.next_up(), 2.0 * draft.length]),
        1..=5 => given,
        6 | 7 => beside(random, given, draft.length),
        _ => random.between(0.0, draft.length),
    }
}

/// A stiffness of all sizes, in a unit; seldom none.
fn stiffness(random: &mut Random, unit: f64) -> f64 {
    if random.once_in(40) {
        random.pick(&[0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320])
    } else {
        unit * power(random, -6.0, 8.0)
    }
}

/// A scene of another family with one to three more things.
pub(super) fn general(random: &mut Random) -> Draft {
    let mut draft = match random.below(5) {
        0 => rough(random),
        1 => ties(random),
        2 => supported(random),
        3 => shaped(random),
        _ => ordinary(random),
    };
    let (l, bending) = (draft.length, draft.stiffness);
    for _ in 0..1 + random.below(3) {
        match random.below(6) {
            0 => {
                let moment =
                    bending * sag(&draft) / (l * l) * power(random, -9.0, 1.0) * random.pick(&[0.0, 1.0, -1.0]);
                draft.couple.push(CoupleLoad { at: place(random, &draft), moment });
            }
            1 => {
                let mut steps = vec![[0.0, stiffness(random, bending)]];
                for _ in 0..1 + random.below(4) {
                    let factor = if random.once_in(2) { power(random, -1.0, 1.0) } else { 1.0 };
                    steps.push([place(random, &draft), factor * bending]);
                }
                if !random.once_in(12) {
                    steps[1..].sort_by(|a, b| a[0].total_cmp(&b[0]));
                    steps.dedup_by(|b, a| b[0] <= a[0]);
                }
                draft.steps = steps;
            }
            2 => {
                let stiffness = (!random.once_in(4)).then(|| stiffness(random, bending / l));
                draft.joints.push(Joint { at: place(random, &draft), stiffness });
            }
            3 => {
                let mut supports = draft.all_supports();
                let k = stiffness(random, bending / (l * l * l));
                let spring = Support { pushes_only: random.once_in(3), ..Support::spring(place(random, &draft), k) };
                let unit = sag(&draft) * random.between(-0.2, 0.5);
                supports.push(if random.once_in(2) { spring } else { spring.at_level(unit) });
                if random.once_in(3) && !supports.is_empty() {
                    let (i, k) = (random.below(supports.len()), stiffness(random, bending / l));
                    supports[i] = supports[i].turning(k, 0.0);
                }
                draft.supports = Some(supports);
            }
            4 => {
                let sign = random.pick(&[1.0, 1.0, 1.0, -1.0]);
                let unit = bending / (l * l);
                draft.tension = if random.once_in(40) { f64::NAN } else { sign * unit * power(random, -6.0, 4.0) };
            }
            _ => {
                let unit = bending / (l * l * l * l) * 1e3;
                draft.soil = vec![[0.0, stiffness(random, unit)]];
                for _ in 0..random.below(3) {
                    let (x, k) = (place(random, &draft), stiffness(random, unit));
                    draft.soil.push([x, if random.once_in(4) { 0.0 } else { k }]);
                }
            }
        }
    }
    draft
}

/// Whether one of the numbers that only a general beam has must be refused.
fn is_bad(draft: &Draft) -> bool {
    let (l, positive) = (draft.length, |k: f64| 0.0 < k && k.is_finite());
    let on_beam = |x: f64| (0.0..=l).contains(&x);
    let in_order = |steps: &[[f64; 2]]| {
        let ascend = steps.windows(2).all(|two| two[0][0] < two[1][0]) && steps.iter().all(|step| on_beam(step[0]));
        ascend && steps.first().is_none_or(|step| step[0] == 0.0) && steps.iter().skip(1).all(|step| step[0] < l)
    };
    let steps = &draft.steps;
    let soil = draft.soil.iter().all(|step| 0.0 <= step[1] && step[1].is_finite())
        && (draft.soil.is_empty() || draft.soil.iter().any(|step| 0.0 < step[1]))
        && in_order(&draft.soil);
    let joints =
        draft.joints.iter().all(|joint| 0.0 < joint.at && joint.at < l && joint.stiffness.is_none_or(positive));
    let couples = draft.couple.iter().all(|couple| on_beam(couple.at) && couple.moment.is_finite());
    let supports = draft.all_supports();
    let springs = supports.iter().flat_map(|support| [support.stiffness, support.turning_stiffness]).flatten();
    let all_positive = steps.iter().all(|step| positive(step[1])) && springs.into_iter().all(positive);
    !(in_order(steps) && joints && couples && all_positive && draft.tension.is_finite())
        || draft.ground.is_some() && !soil
}

/// What is refused names its place and a value.
pub(super) fn refused(trial: &mut Trial, error: &FileError) {
    let message = error.problem.to_string();
    if error.place.as_ref().is_none_or(|place| place.line == 0 || place.column == 0) {
        trial.wrong.push(format!("a refusal without a place: {message}"));
    }
}

/// All laws of one scene.
pub(super) fn laws(trial: &mut Trial, draft: &Draft, scene: &Scene, random: &mut Random) {
    if is_bad(draft) {
        trial.wrong.push("a number that must be refused is accepted".to_owned());
    }
    let Ok(exact) = theory::solve(scene) else { return };
    let verdict = Verdict::of_exact(scene, &exact, &Demand::default());
    (trial.exact, trial.certified) = (Some(exact.solved), verdict.refusal.is_none());
    (trial.bounded, trial.work[0]) = (trial.certified, exact.lists);
    if !trial.certified {
        return;
    }
    let bracket = verdict.certificate.as_ref().map(|c| [c.energy_lower, c.energy_upper]);
    proven(trial, draft, scene, &exact, bracket);
    mirrored(trial, draft, &exact);
    let Some(certificate) = &verdict.certificate else { return };
    let settings = on_fitting_grid(scene, settings(random));
    let outcome = solve_raw(scene, &settings);
    let state = outcome.as_ref().ok().filter(|outcome| outcome.solved).map(|outcome| &outcome.state);
    if random.once_in(2) {
        forces(trial, scene, (&exact, certificate), state, random);
    }
    let Ok(outcome) = outcome else { return };
    trial.route = Some(outcome.solved);
    let on_grid = Verdict::of_raw(&outcome, &Witness::known(scene, &exact), &Demand::default());
    if let Some(other) = on_grid.certificate.filter(|_| on_grid.refusal.is_none()) {
        overlap(trial, &settings, certificate, &other);
    }
}

/// A share of the energy, and of what loads and deflection make of it, that a certified answer may be off by.
const CERTIFIED: f64 = 1e-6;

fn size(scene: &Scene, exact: &Exact) -> f64 {
    let state = &exact.state;
    let couples: f64 = scene.load().couple().iter().map(|c| c.moment.abs()).sum::<f64>() / scene.beam().length();
    state.energy.abs().max((scene.load().magnitude(scene.beam().length()) + couples) * state.deflection.magnitude())
}

/// What the checker says of compression that its bound does not cover.
const BUCKLES: &str = "compression may buckle the beam";

/// The proof of a certified answer is accepted, and its bracket overlaps that of the certificate and has the energy.
fn proven(trial: &mut Trial, draft: &Draft, scene: &Scene, exact: &Exact, certified: Option<[f64; 2]>) {
    let Ok(fields) = prove(scene, exact) else { return };
    let read = check::Scene::read(&draft.text(), &|name| Err(format!("there is no {name}")));
    let checked =
        read.and_then(|read| check::check(&read, &serde_json::from_str(&fields.json()).map_err(|e| e.to_string())?));
    let [low, up] = match checked {
        Ok(bracket) => bracket.map(|energy| energy.to_f64().value()),
        // The checker knows what a beam bears to a fiftieth, and refuses what is nearer to it.
        Err(why) if why.contains(BUCKLES) => return,
        Err(why) => return trial.wrong.push(format!("the proof is refused: {why}")),
    };
    let within = CERTIFIED * size(scene, exact);
    if !(low - within <= exact.state.energy && exact.state.energy <= up + within) {
        trial.wrong.push(format!("certified, with an energy of {:e} outside [{low:e}, {up:e}]", exact.state.energy));
    }
    if let Some([least, most]) = certified
        && (most + 1e-12 * within < low || up < least - 1e-12 * within)
    {
        trial.wrong.push(format!("a bracket [{least:e}, {most:e}] of the energy excludes the proof [{low:e}, {up:e}]"));
    }
}

/// From right to left the energy is the same, if that is certified too.
fn mirrored(trial: &mut Trial, draft: &Draft, exact: &Exact) {
    let Ok(scene) = read(&draft.mirrored().text()) else { return };
    let Some(other) = theory::solve(&scene).ok().filter(|exact| exact.solved) else { return };
    if Verdict::of_exact(&scene, &other, &Demand::default()).refusal.is_some() {
        return;
    }
    let off = (other.state.energy - exact.state.energy).abs();
    if CERTIFIED * size(&scene, exact) < off {
        trial
            .wrong
            .push(format!("mirrored it has an energy of {:e}, not {:e}", other.state.energy, exact.state.energy));
    }
}
