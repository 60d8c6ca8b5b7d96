//! Beam theory at the extremes: right to twelve digits, or not certified.

use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::theory::{Violation, solve};
use palkki_evidence::extremes::deep;
use palkki_evidence::random::Random;

use super::all;

/// What beam theory promises, of the load and of the energy.
const DIGITS: f64 = 1e-12;

/// Below this `EI u₀/(q l⁴)` the lift-off is shorter than 10⁻¹³ of the beam, and the place of a contact has no digits left
/// for it.
const SHALLOWEST: i32 = -54;

#[test]
fn all_extremes_are_right_to_twelve_digits() {
    let mut wrong = Vec::new();
    for extreme in all() {
        let exact = solve(&extreme.scene).expect("numbers in range");
        let unresolved = exact.violations.iter().any(|v| matches!(v, Violation::Unresolved { .. }));
        if !exact.solved && unresolved && extreme.name.contains("EI u₀/(q l⁴)") {
            continue;
        }
        let error = extreme.error(&exact.state).max(extreme.energy_error(exact.state.energy));
        // A NaN is wrong.
        let right = error <= DIGITS;
        if !exact.solved || !right {
            wrong.push(format!("{}: {:?}, off by {error:e}, {:?}", extreme.name, exact.ended(), exact.violations));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

/// From a depth at which theory has digits for the lift-off it is certified, far below it never is.
#[test]
fn a_lift_off_that_cannot_be_resolved_is_not_certified() {
    for power in (-300..=300).step_by(6) {
        let extreme = deep(power).expect("a depth in range");
        let exact = solve(&extreme.scene).expect("numbers in range");
        let certified = exact.solved;
        assert_eq!(certified, SHALLOWEST <= power, "1e{power}: {:?}", exact.violations);
        if certified {
            assert!(extreme.error(&exact.state) <= DIGITS, "1e{power}: off by {:e}", extreme.error(&exact.state));
        }
    }
}

/// A cliff of a width `w` is a step but for its width: contact forces move by `w` over the length of the beam.
#[test]
fn a_narrow_cliff_is_a_step() {
    let mut random = Random::new(77);
    let mut certified = 0;
    for i in 0..260 {
        let (length, power) = (10.0, 9 + i % 7);
        let width = libm::exp10(-f64::from(power));
        let big = libm::exp10(random.between(0.0, 9.0));
        let x = random.between(1.0, 9.0);
        let [first, left, right, last] = [0.0, -1.0, -1.0, 0.0].map(|least| random.between(least, 3.0));
        // A pit behind the cliff, or a cliff that leads up to the contact.
        let depths = if i % 2 == 0 { [first, left, big, last] } else { [first + big, left, right, last] };
        let solved = |width: f64| {
            let beam = Beam::new(length, 1.3).expect("a beam");
            let load = Load::uniform_on(&beam, 1.0).expect("a load");
            let places = [0.0, x, x + width, length];
            let points = places.iter().zip(depths).map(|(&x, depth)| [x, depth]).collect();
            let scene = Scene::new(beam, load, Some(Foundation::Polyline { points })).expect("a scene");
            solve(&scene).expect("numbers in range")
        };
        let (cliff, step) = (solved(width), solved(0.0));
        assert!(step.solved, "a step, {depths:?} at {x}: {:?}", step.violations);
        if cliff.solved {
            certified += 1;
            let size = length.max(cliff.state.contact_force());
            let apart = (cliff.state.reactions.left - step.state.reactions.left)
                .abs()
                .max((cliff.state.contact_force() - step.state.contact_force()).abs());
            assert!(apart <= (width + DIGITS) * size, "{width:e} wide, {depths:?} at {x}: {:e}", apart / size);
        }
    }
    assert!(200 < certified, "few are too narrow: {certified}");
}
