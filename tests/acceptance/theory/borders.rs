//! What must not break the exact solution.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene};
use palkki::state::Regime;
use palkki::theory::{TheoryError, solve};

use palkki_evidence::random::Random;

use crate::scenes::{ends, on_supports, uniform};

#[test]
fn no_foundation_is_a_simple_beam() {
    /// A few dozen roundings of numbers of the size of the answer.
    const ROUNDING: f64 = 1e-14;
    let exact = solve(&on_supports([4.0, 2.0], &ends(4.0), (3.0, &[(0.0, 5.0)]), None)).expect("an answer");
    assert_eq!((exact.solved, exact.state.regime, exact.unknowns), (true, Regime::None, 0));
    // q l/2 and the load on the support itself; 5 q l⁴/(384 EI); q l²/8.
    let found = [exact.state.reactions.left, exact.state.reactions.right, exact.deflection(2.0), exact.moment(2.0)];
    for (found, expected) in found.iter().zip([11.0, 6.0, 5.0, 6.0]) {
        assert!((found - expected).abs() < ROUNDING * expected, "{found} instead of {expected}");
    }
    assert!(exact.clearance(1.0).is_infinite());
    let [left, right] = exact.shear(2.0);
    assert!(left.abs().max(right.abs()) < ROUNDING, "no shear at mid-span: {left}, {right}");
}

#[test]
fn a_beam_that_rests_without_pressure_touches_nothing() {
    let exact = solve(&uniform(4.0, 2.0, 0.0, Foundation::Flat { depth: 0.0 })).expect("an answer");
    assert_eq!((exact.solved, exact.state.regime), (true, Regime::None));
}

#[test]
fn loads_without_resultant_are_loads() {
    /// A few dozen roundings of forces of size one.
    const ROUNDING: f64 = 1e-13;
    // A couple on a beam that lies on a plane: it presses on one side and lifts on the other.
    let flat = Some(Foundation::Flat { depth: 0.1 });
    let couple = on_supports([8.0, 2.0], &ends(8.0), (0.0, &[(3.0, 1.0), (5.0, -1.0)]), flat);
    let exact = solve(&couple).expect("an answer");
    assert_eq!((exact.solved, exact.state.regime), (true, Regime::Points));
    let sum = exact.state.reactions.left + exact.state.reactions.right + exact.state.contact_force();
    assert!(sum.abs() < ROUNDING, "what remains: {sum}");
}

#[test]
fn too_many_waves_are_refused() {
    let waves = Foundation::Cosine { mean: 1.0, amplitude: 1.0, wavelength: 1e-9, phase: 0.0 };
    let error = solve(&uniform(1.0, 1.0, 1.0, waves)).expect_err("too short");
    assert!(matches!(error, TheoryError::TooManyPieces { .. }));
    insta::assert_snapshot!(error, @"`foundation.cosine.wavelength` must be at least 0.0004 for an exact solution, but is 0.000000001");
    // Eight cells for each wave.
    let waves = |wavelength| Foundation::Cosine { mean: 1.0, amplitude: 1.0, wavelength, phase: 0.0 };
    let error = solve(&uniform(12.0, 1.0, 1.0, waves(0.0047))).expect_err("too short");
    assert!(error.to_string().contains("must be at least 0.0048 for"), "{error}");
}

#[test]
fn numbers_of_every_size_are_answered_or_refused() {
    let mut random = Random::new(1);
    let mut answered = 0;
    for i in 0..200 {
        let mut power = |range: f64| 10.0_f64.powf(random.between(-range, range));
        let beam = Beam::new(power(40.0), power(80.0)).expect("a beam");
        let l = beam.length();
        let load = Load::new(&beam, power(60.0), Vec::new(), vec![PointLoad { at: 0.3 * l, force: -power(60.0) }]);
        let depth = power(80.0);
        let points = vec![[0.0, depth], [0.4 * l, power(80.0) - depth], [0.4 * l, depth], [l, power(80.0)]];
        let foundation = match i % 3 {
            0 => Foundation::Polyline { points },
            1 => Foundation::Cosine { mean: depth, amplitude: depth, wavelength: l * power(1.5), phase: power(3.0) },
            _ => Foundation::Polynomial { coefficients: vec![depth, power(20.0), power(20.0), power(20.0)] },
        };
        let Ok(load) = load else { continue };
        let Ok(scene) = Scene::new(beam, load, Some(foundation)) else { continue };
        if let Ok(exact) = solve(&scene) {
            answered += 1;
            for x in [-1.0, 0.0, 0.5 * l, l, 2.0 * l, f64::NAN] {
                let _ = (exact.deflection(x), exact.moment(x), exact.shear(x), exact.clearance(x), exact.pressure(x));
            }
            assert_eq!(exact.solved, exact.violations.is_empty(), "{:?}", exact.violations);
        }
    }
    assert!(100 < answered, "only {answered} of 200 were in range");
}
