//! Beam theory at the extremes: right to twelve digits, or not certified.

use palkki::extremes::deep;
use palkki::route::Status;
use palkki::theory::{Violation, solve};

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
        if exact.status != Status::Certified && unresolved && extreme.name.contains("EI u₀/(q l⁴)") {
            continue;
        }
        let error = extreme.error(&exact.state).max(extreme.energy_error(exact.state.energy));
        // A NaN is wrong.
        let right = error <= DIGITS;
        if exact.status != Status::Certified || !right {
            wrong.push(format!("{}: {:?}, off by {error:e}, {:?}", extreme.name, exact.status, exact.violations));
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
        let certified = exact.status == Status::Certified;
        assert_eq!(certified, SHALLOWEST <= power, "1e{power}: {:?}", exact.violations);
        if certified {
            assert!(extreme.error(&exact.state) <= DIGITS, "1e{power}: off by {:e}", extreme.error(&exact.state));
        }
    }
}
