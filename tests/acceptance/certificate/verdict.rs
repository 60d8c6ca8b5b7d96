//! What `certified` means: each way to lose the word, and what does not lose it.

use palkki::route::{Method, Solver, Status};
use palkki::verdict::{Demand, Refusal, Verdict};
use palkki::{Settings, Witness, solve_raw, theory};
use palkki_evidence::paper::example;

fn outcome(intervals: usize) -> palkki::route::RawSolution {
    let scene = example().expect("the example is well posed");
    solve_raw(&scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals)).expect("an answer")
}

fn of_raw(outcome: &palkki::route::RawSolution, demand: &Demand) -> Verdict {
    Verdict::of_raw(outcome, &Witness::of(&example().expect("the example is well posed")), demand)
}

#[test]
fn a_coarse_grid_is_not_punished_unless_an_error_is_demanded() {
    let coarse = outcome(4);
    let verdict = of_raw(&coarse, &Demand::default());
    assert_eq!((verdict.status, verdict.refusal), (Status::Certified, None));
    assert!(0.1 < verdict.error, "the error of four intervals stands beside it: {}", verdict.error);
    let verdict = of_raw(&coarse, &Demand::of_error(0.1));
    assert_eq!(verdict.status, Status::NotCertified);
    assert!(matches!(verdict.refusal, Some(Refusal::Error { .. })), "{:?}", verdict.refusal);
}

#[test]
fn an_answer_to_another_question_is_refused() {
    let mut wrong = outcome(30);
    wrong.residual = 1e-8;
    let refusal = of_raw(&wrong, &Demand::default()).refusal;
    assert!(matches!(refusal, Some(Refusal::Residual { .. })), "{refusal:?}");
    assert_eq!(of_raw(&wrong, &Demand::of_error(1e-2)).refusal, None, "the guaranteed error has it in it");
    wrong.residual = f64::NAN;
    assert_ne!(of_raw(&wrong, &Demand::of_error(1e-2)).refusal, None, "NaN is not small");
}

#[test]
fn no_numbers_no_certificate() {
    let mut wrong = outcome(30);
    wrong.state.nodes.as_mut().expect("nodes").contact_force[3] = f64::NAN;
    let verdict = of_raw(&wrong, &Demand::default());
    assert_eq!((verdict.status, verdict.refusal), (Status::NotCertified, Some(Refusal::NoNumbers)));
    wrong.solver_reports_success = false;
    assert_eq!(of_raw(&wrong, &Demand::default()).status, Status::NotConverged);
}

#[test]
fn beam_theory_is_judged_like_everybody() {
    let scene = example().expect("the example is well posed");
    let right = theory::solve(&scene).expect("the example has an exact solution");
    let verdict = Verdict::of_exact(&scene, &right, &Demand::of_error(1e-10));
    assert_eq!((verdict.status, verdict.refusal), (Status::Certified, None), "{}", verdict.error);

    let mut wrong = right.clone();
    wrong.state.deflection.max = 1.001;
    let refusal = Verdict::of_exact(&scene, &wrong, &Demand::default()).refusal;
    assert!(
        matches!(refusal, Some(Refusal::Deflection { .. })),
        "a deflection that is not that of the contacts: {refusal:?}"
    );

    let mut wrong = right.clone();
    wrong.state.contacts.clear();
    let verdict = Verdict::of_exact(&scene, &wrong, &Demand::default());
    assert_ne!(verdict.status, Status::Certified, "another scene's contacts: {verdict:?}");

    let mut wrong = right;
    wrong.status = Status::NotCertified;
    let refusal = Verdict::of_exact(&scene, &wrong, &Demand::default()).refusal;
    assert!(matches!(refusal, Some(Refusal::Theory { .. })), "{refusal:?}");
}

#[test]
fn beam_theory_is_certified_on_every_scene_of_the_gallery() {
    let gallery = crate::scenes::report();
    assert!(10 < gallery.len(), "{} scenes", gallery.len());
    for (name, scene) in gallery {
        let exact = theory::solve(&scene).expect("beam theory has an answer");
        let verdict = Verdict::of_exact(&scene, &exact, &Demand::of_error(1e-10));
        assert_eq!((verdict.status, verdict.refusal), (Status::Certified, None), "{name}: {}", verdict.error);
    }
}
