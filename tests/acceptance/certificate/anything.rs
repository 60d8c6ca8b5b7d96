//! Any forces on any scene: no panic, and what is said is true.

use palkki::certificate::{ContactLoad, Judged, certify, violations};
use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};
use palkki::theory;
use palkki_evidence::random::Random;

/// As in `uneven`, with loads of both signs: theory is certified to twelve digits of its largest numbers.
const THEORY: f64 = 1e-10;

/// A polyline with kinks, steps and level stretches over a beam of length 8.
fn polyline(random: &mut Random) -> Foundation {
    let depth =
        |random: &mut Random| if random.once_in(3) { random.pick(&[0.5, 1.0]) } else { random.between(0.0, 2.0) };
    let mut places: Vec<f64> = (0..random.below(8)).map(|_| random.between(0.0, 7.99)).collect();
    places.sort_by(f64::total_cmp);
    let mut points = vec![[0.0, depth(random)]];
    for x in places {
        points.push([x, depth(random)]);
        if random.once_in(2) {
            points.push([x, depth(random) + 0.3]);
        }
    }
    points.push([8.0, depth(random)]);
    Foundation::Polyline { points }
}

fn foundation(random: &mut Random) -> Foundation {
    match random.below(4) {
        0 => Foundation::Flat { depth: random.between(0.0, 3.0) },
        1 => {
            let coefficients = [[0.0, 2.0], [-0.5, 0.5], [0.0, 0.2]].map(|[from, to]| random.between(from, to));
            Foundation::Polynomial { coefficients: coefficients.to_vec() }
        }
        2 => Foundation::Cosine {
            mean: random.between(0.5, 2.0),
            amplitude: random.between(0.0, 0.5),
            wavelength: random.between(1.0, 20.0),
            phase: random.between(0.0, 6.3),
        },
        _ => polyline(random),
    }
}

/// Loads of both signs, everywhere, on a part and at points.
fn load(random: &mut Random, beam: &Beam) -> Load {
    let uniform = if random.once_in(2) { random.between(0.0, 2.0) } else { random.pick(&[0.0, 1.0]) };
    let linear = (0..random.below(2)).map(|_| {
        let (from, width) = (random.between(0.0, 4.0), random.between(0.1, 4.0));
        LinearLoad { from, to: from + width, start: random.between(-1.0, 3.0), end: random.between(-1.0, 3.0) }
    });
    let linear = linear.collect();
    let point = (0..random.below(3))
        .map(|_| PointLoad { at: random.between(0.0, 8.0), force: random.between(-1.0, 4.0) })
        .collect();
    Load::new(beam, uniform, linear, point).expect("finite loads on the beam")
}

#[test]
fn any_forces_on_any_scene_are_bounded() {
    /// Half of the polynomials lie above the right support.
    const CASES: usize = 340;
    let mut random = Random::new(5);
    let mut compared = 0;
    for case in 0..CASES {
        let beam = Beam::new(8.0, random.between(0.5, 50.0)).expect("positive");
        let load = load(&mut random, &beam);
        let ground = foundation(&mut random);
        let forces: Vec<(f64, f64)> =
            (0..random.below(12)).map(|_| (random.between(0.0, 8.0), random.between(-0.5, 3.0))).collect();
        let Ok(scene) = Scene::new(beam, load, Some(ground)) else { continue };
        let witness = super::places(&forces);
        let given = ContactLoad::new(8.0, forces).expect("finite forces on the beam");
        let certificate = certify(&scene, Judged::Forces(&given), &witness).expect("the scene can be scaled");
        let told = format!("{case}: {certificate:?} for {scene:?}, {given:?}");
        assert!(violations(&scene, &given).is_ok(), "{told}");
        assert!(certificate.energy_lower <= certificate.energy_upper && 0.0 <= certificate.gap, "{told}");

        let truth = theory::solve(&scene).expect("theory has an answer");
        if !truth.solved {
            continue;
        }
        compared += 1;
        let energy = truth.state.energy;
        // Without loads the energy is zero, and that of theory a rounding error.
        let slack = THEORY * energy.abs().max(1e-9);
        assert!(
            certificate.energy_lower <= energy + slack && energy - slack <= certificate.energy_upper,
            "{energy}, {told}"
        );
        // Point loads on the supports themselves are not part of the bracket.
        let on_supports = scene.load().point().iter().filter(|p| p.at <= 0.0 || 8.0 <= p.at);
        let on_supports: f64 = on_supports.map(|p| p.force.abs()).sum();
        let reactions = [truth.state.reactions.left, truth.state.reactions.right];
        for (reaction, bracket) in reactions.into_iter().zip(certificate.reactions) {
            if let Some([least, most]) = bracket {
                let slack = THEORY * (1.0 + reaction.abs()) + on_supports;
                assert!(least - slack <= reaction && reaction <= most + slack, "{reaction}, {told}");
            }
        }
    }
    assert!(CASES < 2 * compared, "theory is certified on {compared} of {CASES} scenes");
}
