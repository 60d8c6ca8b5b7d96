//! What `certified` means: each way to lose the word, and what does not lose it.

use palkki::route::{Method, Solver, Status};
use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::text::share_at_most;
use palkki::verdict::{Demand, Number, Refusal, USABLE, Verdict};
use palkki::{Settings, Witness, solve_raw, theory};
use palkki_evidence::paper::example;
use palkki_evidence::random;

fn raw(intervals: usize) -> palkki::Solution<()> {
    let scene = example().expect("the example is well posed");
    solve_raw(&scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals)).expect("an answer")
}

fn of_raw(raw: &palkki::Solution<()>, demand: &Demand) -> Verdict {
    Verdict::of_raw(raw, &Witness::of(&example().expect("the example is well posed")), demand)
}

/// The rule at its border, on the paper's example: whatever is demanded, an answer is certified if and only if its error is at
/// most a tenth and at most what is demanded.
#[test]
fn certified_is_what_is_certain_to_a_tenth_or_to_what_is_demanded() {
    let [mut certified, mut refused] = [0, 0];
    for intervals in 2..=40 {
        let answer = raw(intervals);
        for demanded in [f64::INFINITY, 0.5, USABLE, 1e-2, 2e-3] {
            let verdict = of_raw(&answer, &Demand::of_error(demanded));
            let most = demanded.min(0.1);
            if verdict.largest_error() <= most {
                assert_eq!((verdict.status, verdict.refusal), (Status::Certified, None), "{intervals}: {verdict}");
                certified += 1;
            } else {
                let of_number = |(of, share): (Number, f64)| Refusal::Number { of, share, most };
                let refusal = if verdict.error <= most {
                    verdict.worst.map(of_number)
                } else {
                    Some(Refusal::Error { share: verdict.error, most })
                };
                assert_eq!(
                    (verdict.status, verdict.refusal),
                    (Status::NotCertified, refusal),
                    "{intervals}: {verdict}"
                );
                assert!(verdict.solves_its_problem(), "{intervals}: {verdict}");
                refused += 1;
            }
        }
        assert_eq!(
            of_raw(&answer, &Demand::default()),
            of_raw(&answer, &Demand::of_error(USABLE)).clone(),
            "{intervals}"
        );
    }
    assert!(20 < certified && 20 < refused, "both sides of the border: {certified} and {refused}");
}

/// A beam that does not move has no error, and one whose witness was not the list of contacts says that the bound is coarse.
#[test]
fn the_words_say_how_far() {
    let verdict = of_raw(&raw(30), &Demand::default());
    let [share, worst] = [verdict.error, verdict.worst.expect("a summary").1].map(share_at_most);
    let words = format!(
        "the deflection error is at most {share} of the largest deflection, the error of each number of the summary at most {worst} of the largest of its kind"
    );
    assert_eq!(verdict.to_string(), words);

    let mut coarse = verdict.clone();
    coarse.certificate.as_mut().expect("numbers").contacts_proven = false;
    assert!(coarse.to_string().starts_with(&verdict.to_string()) && coarse.to_string().contains("coarse"), "{coarse}");

    let beam = Beam::new(10.0, 1.3).expect("positive");
    for foundation in [None, Some(Foundation::Flat { depth: 1.0 }), Some(Foundation::Flat { depth: 0.0 })] {
        let scene = Scene::new(beam.clone(), Load::new(&beam, 0.0, vec![], vec![]).expect("no load"), foundation)
            .expect("a scene");
        let solution = palkki::solve_exactly(&scene).expect("an answer");
        let words = (solution.verdict.status, solution.verdict.to_string());
        assert_eq!(
            words,
            (Status::Certified, "the deflection error is 0".to_owned()),
            "exact, {:?}",
            scene.foundation()
        );
        for method in Method::ALL {
            let solution = palkki::solve(&scene, &Settings::new(method, Solver::ActiveSet, 30)).expect("an answer");
            let words = (solution.verdict.status, solution.verdict.to_string());
            assert_eq!(words, (Status::Certified, "the deflection error is 0".to_owned()), "{method}");
        }
    }
}

/// Of random scenes: an answer of beam theory that is certified is certain to a millionth, and as a rule to twelve digits.
#[test]
fn exact_answers_are_certain_to_a_millionth() {
    const COUNT: u64 = 400;
    let mut errors: Vec<f64> = Vec::new();
    for i in 0..COUNT {
        let scene = match i % 3 {
            0 => random::scene(i),
            1 => random::on_lattice(i),
            _ => random::rough(i),
        };
        let Ok(exact) = theory::solve(&scene) else { continue };
        let verdict = Verdict::of_exact(&scene, &exact, &Demand::default());
        if verdict.status == Status::Certified {
            assert!(verdict.error <= 1e-6, "{}: {verdict}", scene.title());
            let size = exact.state.deflection.magnitude();
            let certificate = verdict.certificate.expect("certified");
            let bound = certificate.deflection_error;
            assert!(bound <= 1e-6 * size || certificate.at_rest && size == 0.0, "{}: {bound} of {size}", scene.title());
            errors.push(verdict.error);
        }
    }
    errors.sort_by(f64::total_cmp);
    assert!(360 < errors.len(), "{} of {COUNT} are certified", errors.len());
    let median = errors[errors.len() / 2];
    assert!(median < 1e-12, "the median is {median:e}");
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

/// A beam without load lies as it was built, also where the depth of its shape at a support is nothing but the rounding of its terms; with a
/// support that is off by more it does not.
#[test]
fn a_shape_without_load_is_certified() {
    let of = |level: f64| {
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = 1.3\nsupports = [{{ at = 0.0 }}, {{ at = 10.0, level = {level:?} }}]\n\
             shape = {{ polynomial = [0.0, 0.1, -0.01] }}\n[load]\nuniform = 0.0\n"
        );
        let scene = palkki::scene::file::parse("scene.toml", &text, |_| Err(palkki::scene::file::ReadProblem::Missing));
        let scene = scene.expect("a scene");
        palkki::solve_exactly(&scene).expect("an answer")
    };
    let solution = of(0.0);
    assert_eq!(solution.verdict.status, Status::Certified, "{}", solution.verdict);
    assert!(solution.state.deflection.magnitude() <= 1e-16);
    let turned = of(1e-6);
    assert!((turned.state.deflection.magnitude() / 1e-6 - 1.0).abs() < 1e-9);
}
