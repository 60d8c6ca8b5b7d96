//! The gap that a change of the bending stiffness opens in contact, beside its closed form; the couple has its own in `general`.

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::state::Contact;
use palkki::verdict::Status;
use palkki_evidence::closed::opened;

use crate::scenes;

/// The gap at mid-span, and the forces at its ends.
#[track_caller]
fn gap(scene: &Scene) -> ([f64; 2], [f64; 2]) {
    let solution = palkki::solve_exactly(scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}", scene.title());
    let [Contact { to, end_forces: Some([_, before]), .. }, Contact { from, end_forces: Some([behind, _]), .. }] =
        solution.state.contacts[..]
    else {
        panic!("two zones: {:?}", solution.state.contacts)
    };
    ([5.0 - to, from - 5.0], [before, behind])
}

/// For one stiffness the parts of the gap are `(3 ± √3)/6` and `p̄ ℓ² = 2√3 D`.
#[test]
fn the_closed_form_of_the_gap_has_that_of_a_couple_as_its_limit() {
    let root = 3.0_f64.sqrt();
    let law = opened(1.0);
    assert!((law.before - (3.0 + root) / 6.0).abs() < 1e-14 && (law.square - 2.0 * root).abs() < 1e-13, "{law:?}");
    // To the first order in a small change the length is that at the mean of the two.
    for small in [1e-2, 1e-3, 1e-4] {
        let [more, less] = [1.0 + small, 1.0 - small].map(|ratio| opened(ratio).before);
        assert!(
            (more + less - 2.0 * law.before).abs() < small * small && less < law.before && law.before < more,
            "{small}"
        );
    }
}

/// On a crest `D = ΔEI u''` is positive where the beam becomes stiffer, in a dish negative; then the gap is its mirror image.
#[test]
fn a_change_of_stiffness_opens_a_gap_by_its_law() {
    for (ground, curvature) in [("[1.1, -0.08, 0.008]", 0.016), ("[0.6, 0.08, -0.008]", -0.016)] {
        for stiffness in [4.04, 6.0, 8.0, 16.0, 2.0, 1.0] {
            for load in [1.0, 2.5] {
                let beam = format!(
                    "[beam]\nlength = 10.0\nbending_stiffness = {{ steps = [[0, 4.0], [5, {stiffness:?}]] }}\n"
                );
                let text = format!("{beam}[load]\nuniform = {load:?}\n[foundation]\npolynomial = {ground}\n");
                let scene = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).expect("a scene");
                let (parts, forces) = gap(&scene);
                let jump = (stiffness - 4.0) * curvature;
                let ratio = if jump > 0.0 { 4.0 / stiffness } else { stiffness / 4.0 };
                let law = opened(ratio);
                let length = law.length(jump.abs(), load);
                let (force, share) = (load * length, 1.0 / law.square);
                let (mut expected, mut carried) = (
                    [law.before * length, (1.0 - law.before) * length],
                    [(0.5 - share) * force, (0.5 + share) * force],
                );
                if jump < 0.0 {
                    expected.reverse();
                    carried.reverse();
                }
                // Places have the digits of the beam, forces those of the whole load.
                for (found, expected) in parts.into_iter().chain(forces).zip(expected.into_iter().chain(carried)) {
                    assert!((found - expected).abs() < 1e-12 * 10.0 * load, "{text}: {found}, not {expected}");
                }
            }
        }
    }
}

/// The scenes of the exercise.
#[test]
fn the_gaps_of_the_exercise_are_those_of_their_laws() {
    for (name, discontinuity, ratio) in [("taught/couple", 0.2, 1.0), ("taught/stiffer", 0.064, 0.5)] {
        let ([before, behind], _) = gap(&scenes::scene(name));
        let (law, length) = (opened(ratio), before + behind);
        assert!((length - law.length(discontinuity, 1.0)).abs() < 1e-12, "{name}: {length}");
        assert!((before / length - law.before).abs() < 1e-11, "{name}: {before} of {length}");
    }
}
