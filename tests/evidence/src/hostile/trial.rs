//! One run of the whole program: text → scene → beam theory and one discretised route → certificates, all of them held to
//! their laws.

use crate::brackets::outside;
use crate::definition::violated;
use crate::draft::Draft;
use crate::random::Random;
use palkki::certificate::Certificate;
use palkki::route::{Method, Solution, Solver};
use palkki::scene::file::{FileError, ReadProblem, parse};
use palkki::scene::{Grid, Scene, SceneError};
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Refusal, Verdict};
use palkki::{Settings, Witness, solve_raw};

use super::alike::{continuous, mirror, near};
use super::derivatives::derivatives;
use super::energies::{backed, castigliano, in_balance, locally, stands};
use super::fractions::by_moments;
use super::laws::{THEORY, balanced, judge, lies_on_ground, name, overlap, presses, same, turns_above_ground, within};
use super::moving::{sweep, tolerance};
use super::refusals::{accepted, refused};
use super::scenes::Family;
use super::units::in_other_units;
use super::{FIFTH, FOURTH, SECOND, THIRD, general};

/// Intervals of the finest grid.
const MOST_INTERVALS: usize = 60;

/// What became of one run.
#[derive(Debug, Default)]
pub(crate) struct Trial {
    /// True if the text is a scene.
    pub(crate) accepted: bool,
    /// Whether beam theory solved it, if it has an answer.
    pub(crate) exact: Option<bool>,
    /// Whether there is a bound on how far it may be off: its bounds are finite, and its deflection is that of its contacts.
    pub(crate) bounded: bool,
    /// Whether the program calls it certified in the end: the bound is a millionth of the deflection or less.
    pub(crate) certified: bool,
    /// Whether the beam all but turns over: see [`all_but_turns`].
    pub(crate) all_but_turns: bool,
    /// Whether the reference on the same grid, force method or finite differences with the active set, solved its problem.
    pub(crate) reference: Option<bool>,
    /// Whether another route on that grid solved its problem.
    pub(crate) route: Option<bool>,
    /// True if the route's solver says that it succeeded, or almost, and the judge does not.
    pub(crate) contradicted: bool,
    /// True if an answer was compared with that in other units.
    pub(crate) rescaled: bool,
    /// True if derivatives were compared with differences.
    pub(crate) derived: bool,
    /// True if a sweep was compared with its rows.
    pub(crate) swept: bool,
    /// Sets of contact forces that were brought and judged.
    pub(crate) brought: usize,
    /// Lists of contacts that theory tried, and iterations of the routes: the most.
    pub(crate) work: [usize; 2],
    /// What is wrong. Empty, or the program is.
    pub(crate) wrong: Vec<String>,
}

/// The draft of a run.
pub(crate) fn draft(seed: u64) -> (Family, Draft, Random) {
    /// Seeds beside each other are spread over all 64 bits.
    const SPREAD: u64 = 0x2545_f491_4f6c_dd1d;
    let mut random = Random::new(seed.wrapping_mul(SPREAD));
    let family = match seed {
        seed if seed < SECOND => random.pick(&Family::FIRST),
        seed if seed < THIRD => random.pick(&Family::SECOND),
        seed if seed < FOURTH => random.pick(&Family::THIRD),
        seed if seed < FIFTH => random.pick(&Family::FOURTH),
        _ => Family::General,
    };
    let draft = family.draft(&mut random);
    (family, draft, random)
}

pub(super) fn read(text: &str) -> Result<Scene, Box<FileError>> {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing))
}

/// Run number `seed`.
pub(crate) fn run(seed: u64) -> (Family, Trial) {
    let (family, draft, random) = draft(seed);
    (family, of_draft(family, &draft, random))
}

/// All laws asked of a scene.
fn of_draft(family: Family, draft: &Draft, mut random: Random) -> Trial {
    let mut trial = Trial::default();
    let scene = match read(&draft.text()) {
        Ok(scene) => scene,
        Err(error) if family == Family::General => {
            general::refused(&mut trial, &error);
            return trial;
        }
        Err(error) => {
            refused(&mut trial, draft, &error);
            return trial;
        }
    };
    trial.accepted = true;
    if family == Family::General {
        general::laws(&mut trial, draft, &scene, &mut random);
        return trial;
    }
    accepted(&mut trial, draft, &scene);

    let exact = theory::solve(&scene).ok();
    let verdict = exact.as_ref().map(|exact| by_theory(&mut trial, family, &scene, exact));
    if Family::FOURTH.contains(&family) {
        at_length(&mut trial, draft, &scene, exact.as_ref().zip(verdict.as_ref()), &mut random);
        // Grids have had their turn with the other dice.
        if !random.once_in(4) {
            return trial;
        }
    }
    let bounds = verdict.and_then(|verdict| verdict.certificate);
    let settings = on_fitting_grid(&scene, settings(&mut random));
    let reference = Settings { solver: Solver::ActiveSet, method: same_optimum(settings.method), ..settings };
    let mut on_grid = |settings: &Settings| {
        let (outcome, certificate) = on_grid(&mut trial, family, draft, &scene, settings, exact.as_ref())?;
        if let (Some(a), Some(b)) = (&bounds, &certificate) {
            overlap(&mut trial, settings, a, b);
        }
        Some(outcome)
    };
    let other = on_grid(&reference);
    let outcome = if settings == reference { None } else { on_grid(&settings) };
    trial.reference = other.as_ref().map(|outcome| outcome.solved);
    trial.route = outcome.as_ref().map(|outcome| outcome.solved);
    if let (Some(outcome), Some(other)) = (outcome.filter(|outcome| outcome.solved), &other) {
        same(&mut trial, &settings, &scene, &outcome.state, other);
    }
    if random.once_in(8) {
        in_other_units(&mut trial, draft, &scene, exact.as_ref(), &reference, &mut random);
    }
    trial
}

/// The laws of one answer of beam theory, and its verdict.
fn by_theory(trial: &mut Trial, family: Family, scene: &Scene, exact: &Exact) -> Verdict {
    trial.exact = Some(exact.solved);
    trial.work[0] = exact.lists;
    let verdict = Verdict::of_exact(scene, exact, &Demand::default());
    trial.certified = verdict.refusal.is_none();
    trial.bounded = trial.certified || matches!(verdict.refusal, Some(Refusal::Error { .. } | Refusal::Number { .. }));
    trial.all_but_turns = all_but_turns(scene, exact);
    if exact.solved {
        balanced(trial, "theory", scene, &exact.state);
        presses(trial, "theory", scene, exact);
        turns_above_ground(trial, "theory", scene, exact);
        if !Family::FIRST.contains(&family) && !Family::SECOND.contains(&family) && trial.certified {
            let violated = violated(scene, exact, THEORY).into_iter();
            trial.wrong.extend(violated.map(|what| format!("theory: certified, but {what}")));
        }
        if let Some(bounds) = &verdict.certificate {
            within(trial, "theory", exact, bounds, scene);
        }
    }
    verdict
}

/// The laws of one answer on a grid; none where there is no answer.
fn on_grid(
    trial: &mut Trial,
    family: Family,
    draft: &Draft,
    scene: &Scene,
    settings: &Settings,
    exact: Option<&Exact>,
) -> Option<(Solution<()>, Option<Certificate>)> {
    let outcome = match solve_raw(scene, settings) {
        Ok(outcome) => outcome,
        Err(SceneError::BetweenNodes { .. } | SceneError::Overflow { .. }) => return None,
        Err(error) => {
            trial.wrong.push(format!("{}: {error}", name(settings)));
            return None;
        }
    };
    if outcome.solved {
        lies_on_ground(trial, &name(settings), draft, scene, &outcome.state);
    }
    let certificate = judge(trial, scene, settings, &outcome, exact);
    if Family::FOURTH.contains(&family) {
        let witness = exact.map_or_else(|| Witness::of(scene), |exact| Witness::known(scene, exact));
        let verdict = Verdict::of_raw(&outcome, &witness, &Demand::default());
        backed(trial, &name(settings), scene, &outcome.state, &verdict);
    }
    let reports_an_answer = outcome.run.reports_success || outcome.run.reports_almost;
    trial.contradicted |= reports_an_answer && !outcome.solved;
    trial.work[1] = trial.work[1].max(outcome.run.iterations);
    Some((outcome, certificate))
}

/// The laws of beam theory that take more solves than one: of proven energies, and one of those of scenes beside each other.
fn at_length(trial: &mut Trial, draft: &Draft, scene: &Scene, answer: Option<(&Exact, &Verdict)>, random: &mut Random) {
    let certified = trial.certified;
    in_balance(trial, draft, answer.map(|(exact, _)| exact), certified);
    if let Some((exact, verdict)) = answer.filter(|_| trial.certified) {
        backed(trial, "theory", scene, &exact.state, verdict);
        stands(trial, &exact.state);
        locally(trial, draft, scene, exact);
        if let Some(certificate) = &verdict.certificate {
            let outside = outside(scene, &exact.state, certificate).into_iter();
            trial.wrong.extend(outside.map(|what| format!("theory: {what}")));
        }
        near(trial, draft, exact);
        by_moments(trial, draft, scene, exact);
        match random.below(3) {
            0 => continuous(trial, draft, scene, exact),
            1 => mirror(trial, draft, exact),
            _ => {}
        }
        match random.below(8) {
            0 | 1 => castigliano(trial, scene, exact),
            2..=4 => derivatives(trial, draft, scene, exact, random),
            5 => sweep(trial, draft, scene, random),
            _ => tolerance(trial, draft, scene, exact, random),
        }
    }
}

/// Whether the resultant of the loads is nearer than this share of the beam to the place over which the beam would turn, its one support
/// or an end: where the beam then touches besides is said by the last digits of the loads.
fn all_but_turns(scene: &Scene, exact: &Exact) -> bool {
    const SHARE: f64 = 1e-12;
    let length = scene.beam().length();
    let places = match scene.beam().supports() {
        [] => vec![0.0, length],
        supports => supports.iter().map(|support| support.at).collect(),
    };
    let beside = |at: f64| places.iter().any(|place| (at - place).abs() <= SHARE * length);
    exact.state.standing.is_some_and(|standing| beside(standing.resultant.at))
}

/// The same on the least grid that has a node at every support, if the one that is asked for has none and that one is not too fine.
pub(super) fn on_fitting_grid(scene: &Scene, settings: Settings) -> Settings {
    let supports = scene.beam().supports();
    let fits = Grid::uniform(scene, settings.intervals)
        .is_ok_and(|grid| supports.iter().all(|support| grid.node_at(support.at).is_some()));
    match Grid::least_fitting(scene).filter(|least| !fits && *least <= MOST_INTERVALS) {
        Some(intervals) => Settings { intervals, ..settings },
        None => settings,
    }
}

/// The method that has the same optimum as this one, and the best conditioned quadratic program.
fn same_optimum(method: Method) -> Method {
    if method == Method::Complementarity { method } else { Method::Force }
}

pub(super) fn settings(random: &mut Random) -> Settings {
    let method = random.pick(&Method::ALL);
    let solver = random.pick(&[
        Solver::ActiveSet,
        Solver::ActiveSet,
        Solver::ActiveSet,
        Solver::FourStep,
        Solver::Clarabel,
        Solver::Clarabel,
        Solver::Osqp,
        Solver::Nsor,
    ]);
    // Iterations of these two can be very many.
    let most = if matches!(solver, Solver::Osqp | Solver::Nsor) { 12 } else { MOST_INTERVALS };
    Settings::new(method, solver, 2 + random.below(most - 1))
}

/// What is wrong with the answers to a scene, each law asked of it once.
pub(super) fn wrong(draft: &Draft) -> Vec<String> {
    let mut random = Random::new(1);
    let mut trial = of_draft(Family::AtSupports, draft, random.clone());
    if let Ok(scene) = read(&draft.text())
        && let Some(exact) = theory::solve(&scene).ok().filter(|_| trial.certified)
    {
        castigliano(&mut trial, &scene, &exact);
        continuous(&mut trial, draft, &scene, &exact);
        mirror(&mut trial, draft, &exact);
        for _ in 0..3 {
            derivatives(&mut trial, draft, &scene, &exact, &mut random);
            sweep(&mut trial, draft, &scene, &mut random);
        }
        tolerance(&mut trial, draft, &scene, &exact, &mut random);
    }
    trial.wrong.sort();
    trial.wrong.dedup();
    trial.wrong
}

#[cfg(test)]
mod tests {
    use super::*;
    use palkki::scene::{Foundation, LinearLoad, PointLoad, Support};

    type Law = fn(&mut Trial, &Draft, &Scene, &Exact);

    fn beam(level: f64) -> Draft {
        let held = |at, level| Support { level, ..Support::simple(at) };
        Draft {
            length: 10.0,
            stiffness: 1.3,
            linear: vec![LinearLoad { from: 2.0, to: 10.0, start: 1.0, end: 2.0 }],
            point: vec![PointLoad { at: 5.0, force: 1.0 }, PointLoad { at: 6.000_001, force: 1.0 }],
            ground: Some(Foundation::Polyline { points: vec![[0.0, 9.0], [4.0, 0.5], [10.0, 9.0]] }),
            supports: Some(vec![held(0.0, 0.0), held(6.0, level), held(10.0, 0.0)]),
            ..Draft::default()
        }
    }

    /// Each law that asks for more than one solve is content with the answer of a scene, and complains of that of another one. The answer
    /// of another scene has no derivatives in this one: their law has a test of its own, `a_step_does_not_take_a_contact_past_a_load`.
    #[test]
    fn laws_complain_of_the_answer_of_another_scene() {
        let laws: [(&str, Law); 6] = [
            ("castigliano", |trial, _, scene, exact| castigliano(trial, scene, exact)),
            ("continuous", continuous),
            ("by_moments", by_moments),
            ("near", |trial, draft, _, exact| near(trial, draft, exact)),
            ("mirror", |trial, draft, _, exact| mirror(trial, draft, exact)),
            ("outside", |trial, _, scene, exact| {
                let own = theory::solve(scene).expect("an answer");
                let verdict = Verdict::of_exact(scene, &own, &Demand::default());
                trial.wrong = outside(scene, &exact.state, &verdict.certificate.expect("bounds"));
            }),
        ];
        let [draft, other] = [0.1, 0.11].map(beam);
        let [scene, other] = [&draft, &other].map(|draft| draft.scene().expect("a scene"));
        for (name, law) in laws {
            for (answered, wrong) in [(&scene, false), (&other, true)] {
                let mut trial = Trial::default();
                law(&mut trial, &draft, &scene, &theory::solve(answered).expect("an answer"));
                assert_eq!(!trial.wrong.is_empty(), wrong, "{name}: {:?}", trial.wrong);
            }
        }
    }
}
