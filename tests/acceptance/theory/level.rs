//! Ground that touches a support: level with it up to the rounding of what adds up to its depth, and above it beyond that.

use palkki::route::{Method, Solver, Status};
use palkki::scene::{Beam, Foundation, Load, Scene, SceneError};
use palkki::solve_exactly;
use palkki::verdict::Refusal;

use crate::scenes::run;

const LENGTHS: [f64; 5] = [10.0, 7.0, 0.1, 1.0 / 3.0, 6e7];

/// A beam under a uniform load that bends it by some 10 without ground.
fn scene(length: f64, foundation: Foundation) -> Result<Scene, SceneError> {
    let beam = Beam::new(length, 1.3).expect("a beam");
    let load = Load::new(&beam, 1000.0 / length.powi(4), Vec::new(), Vec::new()).expect("a load");
    Scene::new(beam, load, Some(foundation))
}

/// Profiles that are 0 at one support or at both, but for rounding, moved down by `lower`.
fn profiles(length: f64, lower: f64) -> Vec<Foundation> {
    let mut profiles = Vec::new();
    for bow in (-3..=4).map(|k| f64::from(k) * 0.26) {
        // (1 − t)(1 + bow t), t (1 + bow (1 − t)) and t (1 − t) (1 + bow t) for t = x/l.
        for c in [[1.0, bow - 1.0, -bow, 0.0], [0.0, 1.0 + bow, -bow, 0.0], [0.0, 1.0, bow - 1.0, -bow]] {
            let mut unit = 1.0;
            let mut coefficients = c.map(|c| {
                let c = c / unit;
                unit *= length;
                c
            });
            coefficients[0] += lower;
            profiles.push(Foundation::Polynomial { coefficients: coefficients.to_vec() });
        }
        let (waves, phase) = (1.0 + bow.abs(), std::f64::consts::PI * (1.0 - 2.0 * (1.0 + bow.abs())));
        let wave = |phase, mean| Foundation::Cosine { mean, amplitude: 0.3, wavelength: length / waves, phase };
        profiles.push(wave(phase, 0.3 + lower));
        profiles.push(wave(bow, -0.3 * bow.cos() + lower));
    }
    profiles
}

#[test]
fn ground_at_a_support_is_level_within_rounding() {
    let (mut above, mut bracketed) = (0, 0);
    for length in LENGTHS {
        for (profile, lower) in profiles(length, 0.0).into_iter().zip(profiles(length, 1e-12)) {
            above += usize::from([0.0, length].iter().any(|x| (-1e-9..0.0).contains(&profile.depth(*x))));
            // Some waves are above the other support.
            if [0.0, length].iter().any(|x| profile.depth(*x) < -1e-9) {
                assert!(matches!(scene(length, profile), Err(SceneError::AboveSupport { .. })));
                continue;
            }
            let name = format!("{length}, {profile:?}");
            let [touching, below] = [profile, lower].map(|profile| scene(length, profile).expect("a scene"));
            let exact = [&touching, &below].map(|scene| solve_exactly(scene).expect("an answer"));
            // Of a support on ground that leaves it as a cubic or a parabola does there may be no bracket.
            let verdict = &exact[0].verdict;
            let has_bracket = !matches!(verdict.refusal, Some(Refusal::Number { share, .. }) if share.is_infinite());
            assert!(verdict.status == Status::Certified || !has_bracket, "{name}: {verdict:?}");
            bracketed += usize::from(has_bracket);
            // On a crest below a support the energy changes with the square root of what the ground is lowered by.
            let close = |energies: [f64; 2]| (energies[0] - energies[1]).abs() <= 1e-4 * energies[1].abs();
            assert!(close([0, 1].map(|i| exact[i].state.energy)), "{name}");
            for method in Method::ALL {
                let energies = [&touching, &below].map(|s| run(s, method, Solver::ActiveSet, 60).state.energy);
                assert!(close(energies), "{name}, {method}: {energies:?}");
            }
        }
    }
    assert!(20 < bracketed, "only {bracketed} have brackets");
    assert!(4 < above, "only {above} profiles are above a support by rounding");
}

#[test]
fn ground_above_a_support_by_more_than_rounding_is_refused() {
    for length in LENGTHS {
        for lower in [-1e-12, -1e-6, -0.1] {
            for profile in profiles(length, lower) {
                let refused = scene(length, profile.clone());
                assert!(matches!(refused, Err(SceneError::AboveSupport { .. })), "{length}, {profile:?}");
            }
        }
    }
}

/// Rounding is that of what adds up there: of the given depth of a plane and of points there is none.
#[test]
fn what_is_given_is_not_rounded() {
    for depth in [-f64::MIN_POSITIVE, -1e-17, -1e-12] {
        let points = |u: [f64; 2]| Foundation::Polyline { points: vec![[0.0, u[0]], [5.0, 1.0], [10.0, u[1]]] };
        for profile in [Foundation::Flat { depth }, points([depth, 1.0]), points([1.0, depth])] {
            assert!(matches!(scene(10.0, profile), Err(SceneError::AboveSupport { .. })), "{depth}");
        }
    }
}

/// Coefficients of high powers count by what they add up to, not by their power of the unit of length.
#[test]
fn powers_beyond_the_range_of_numbers_do_no_harm() {
    for length in [10.0, 0.01] {
        for powers in [10, 330, 400] {
            let mut coefficients = vec![1.0, 0.1 / length];
            let plain = scene(length, Foundation::Polynomial { coefficients: coefficients.clone() }).expect("a scene");
            coefficients.resize(powers, 0.0);
            let long = scene(length, Foundation::Polynomial { coefficients }).expect("a scene");
            let [plain, long] = [plain, long].map(|scene| solve_exactly(&scene).expect("an answer"));
            assert_eq!(long.verdict.status, Status::Certified, "{length}, {powers}");
            assert_eq!(long.state.energy.to_bits(), plain.state.energy.to_bits(), "{length}, {powers}");
        }
    }
}
