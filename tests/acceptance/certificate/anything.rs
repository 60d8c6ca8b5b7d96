//! Any forces on any scene: no panic, and what is said is true.

use palkki::certificate::bounds::violations;
use palkki::certificate::{ContactLoad, Judged, certify};
use palkki::route::Status;
use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};
use palkki::theory;
use proptest::prelude::*;

/// As in `uneven`, with loads of both signs: theory is certified to twelve digits of its largest numbers.
const THEORY: f64 = 1e-10;

/// A polyline with kinks, steps and level stretches.
fn polyline() -> impl Strategy<Value = Foundation> {
    let depth = prop_oneof![0.0..2.0_f64, Just(0.5), Just(1.0)];
    (prop::collection::vec((0.05..1.0_f64, depth.clone(), any::<bool>()), 1..9), depth).prop_map(|(steps, first)| {
        let whole: f64 = steps.iter().map(|s| s.0).sum();
        let mut points = vec![[0.0, first]];
        let mut x = 0.0;
        for (i, (width, depth, step)) in steps.iter().enumerate() {
            x += width / whole * 8.0;
            let x = if i + 1 == steps.len() { 8.0 } else { x.min(7.999) };
            points.push([x, *depth]);
            if *step && x < 8.0 {
                points.push([x, depth + 0.3]);
            }
        }
        Foundation::Polyline { points }
    })
}

fn foundation() -> impl Strategy<Value = Foundation> {
    prop_oneof![
        (0.0..3.0_f64).prop_map(|depth| Foundation::Flat { depth }),
        (0.0..2.0_f64, -0.5..0.5_f64, 0.0..0.2_f64)
            .prop_filter("above the right support", |(a, b, c)| 0.0 <= a + 8.0 * b + 64.0 * c)
            .prop_map(|(a, b, c)| Foundation::Polynomial { coefficients: vec![a, b, c] }),
        (0.5..2.0_f64, 0.0..0.5_f64, 1.0..20.0_f64, 0.0..6.3_f64).prop_map(|(mean, amplitude, wavelength, phase)| {
            Foundation::Cosine { mean, amplitude, wavelength, phase }
        }),
        polyline(),
    ]
}

fn load() -> impl Strategy<Value = (f64, Option<LinearLoad>, Vec<PointLoad>)> {
    let linear = (0.0..4.0_f64, 0.1..4.0_f64, -1.0..3.0_f64, -1.0..3.0_f64)
        .prop_map(|(from, width, start, end)| LinearLoad { from, to: from + width, start, end });
    let point = (0.0..8.0_f64, -1.0..4.0_f64).prop_map(|(at, force)| PointLoad { at, force });
    (prop_oneof![0.0..2.0_f64, Just(0.0), Just(1.0)], prop::option::of(linear), prop::collection::vec(point, 0..3))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_forces_on_any_scene_are_bounded(
        stiffness in 0.5..50.0_f64,
        foundation in foundation(),
        (uniform, linear, point) in load(),
        forces in prop::collection::vec((0.0..8.0_f64, -0.5..3.0_f64), 0..12),
    ) {
        let beam = Beam::new(8.0, stiffness).expect("positive");
        let load = Load::new(&beam, uniform, linear.into_iter().collect(), point).expect("finite");
        let Ok(scene) = Scene::new(beam, load, Some(foundation)) else { return Ok(()) };
        let witness = super::places(&forces);
        let given = ContactLoad::new(8.0, forces).expect("finite forces on the beam");
        let certificate = certify(&scene, Judged::Forces(&given), &witness).expect("the scene can be scaled");
        prop_assert!(violations(&scene, &given).is_ok());
        prop_assert!(certificate.energy_lower <= certificate.energy_upper, "{certificate:?}");
        prop_assert!(0.0 <= certificate.gap, "{certificate:?}");

        let truth = theory::solve(&scene).expect("theory has an answer");
        if truth.status == Status::Certified {
            let energy = truth.state.energy;
            // Without loads the energy is zero, and that of theory a rounding error.
            let size = energy.abs().max(1e-9);
            prop_assert!(certificate.energy_lower <= energy + THEORY * size, "{energy} for {certificate:?}");
            prop_assert!(energy - THEORY * size <= certificate.energy_upper, "{energy} for {certificate:?}");
            let reactions = [truth.state.reactions.left, truth.state.reactions.right];
            for (reaction, bracket) in reactions.into_iter().zip(certificate.reactions) {
                if let Some([least, most]) = bracket {
                    let slack = THEORY * (1.0 + reaction.abs());
                    // Point loads on the supports themselves are not part of the bracket.
                    let on_support: f64 =
                        scene.load().point().iter().filter(|p| p.at <= 0.0 || 8.0 <= p.at).map(|p| p.force.abs()).sum();
                    prop_assert!(least - slack - on_support <= reaction && reaction <= most + slack + on_support,
                        "{reaction} for {certificate:?}");
                }
            }
        }
    }
}
