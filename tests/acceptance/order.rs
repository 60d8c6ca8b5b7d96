//! Order of convergence on the example: what converges, how fast, and what does not.

use palkki::route::Method;
use palkki_evidence::paper::claims::accuracy;
use palkki_evidence::paper::convergence::{Quantity, Series, of_the_example};

/// Grids of 24 to 400 intervals: many, because errors scatter with the place of the lift-off point between two nodes.
#[track_caller]
fn measured(method: Method, quantity: Quantity) -> Series {
    let grids: Vec<usize> = (3..=50).map(|k| 8 * k).collect();
    let found = of_the_example(method, &grids).expect("grids of multiples of 8");
    found.into_iter().find(|series| series.quantity == quantity).expect("a quantity of the example")
}

#[track_caller]
fn order(method: Method, quantity: Quantity, expected: f64, slack: f64) {
    let order = measured(method, quantity).order;
    assert!((order - expected).abs() < slack, "{method}, {}: observed order {order:.2}", quantity.word());
}

/// Reactions and deflections scatter: leaving out every second grid moves the slope by this much.
const SCATTER: f64 = 0.3;

/// The energy hardly does: leaving out every second grid moves the slope by 0.02 at most.
const SMOOTH: f64 = 0.05;

#[test]
fn the_end_reaction_is_of_second_order() {
    for method in Method::ALL {
        order(method, Quantity::EndReaction, 2.0, SCATTER);
    }
}

#[test]
fn the_point_force_at_lift_off_is_of_second_order_as_a_resultant() {
    for method in Method::ALL {
        order(method, Quantity::PointForce, 2.0, SCATTER);
    }
}

#[test]
fn the_deflection_is_of_second_order() {
    for method in Method::ALL {
        order(method, Quantity::Deflection, 2.0, SCATTER);
    }
}

/// The energy methods take their loads to the nodes, an error of second order. Finite differences are better than their
/// scheme by one order: the energy is stationary, and for nodal loads on a flat foundation second-order terms cancel.
#[test]
fn the_energy_is_of_second_order_and_of_third_by_differences() {
    order(Method::Displacement, Quantity::Energy, 2.0, SMOOTH);
    order(Method::Force, Quantity::Energy, 2.0, SMOOTH);
    order(Method::Complementarity, Quantity::Energy, 3.0, SMOOTH);
}

/// No grid knows where between two nodes the beam lifts off, and none is further from it than that.
#[test]
fn the_lift_off_point_is_found_within_one_interval() {
    let theory = palkki_evidence::paper::theory();
    let lift_off = theory.lift_off.expect("the example lifts off");
    let length = palkki_evidence::paper::beam().expect("the example has a beam").length();
    for method in Method::ALL {
        for (intervals, error) in measured(method, Quantity::LiftOff).errors {
            let spacing = length / f64::from(u32::try_from(intervals).expect("a few hundred"));
            assert!(error * lift_off <= spacing, "{method}, {intervals} intervals: off by {}", error * lift_off);
        }
    }
}

/// Displacement and force method are the same method: so are their errors, as far as rounding lets them.
#[test]
fn the_energy_methods_have_the_same_errors() {
    /// Rounding with 400 intervals, relative to the quantities themselves: rotations here, moments there.
    const ROUNDING: f64 = 1e-13;
    for quantity in Quantity::OF_THE_EXAMPLE {
        let (a, b) = (measured(Method::Displacement, quantity), measured(Method::Force, quantity));
        for ((n, a), (_, b)) in a.errors.iter().zip(&b.errors) {
            assert!((a - b).abs() <= ROUNDING, "{}, {n} intervals: {a:e} and {b:e}", quantity.word());
        }
    }
}

/// What must not be believed: the first contact force does not approach `T`, and nodal forces do not approach `q₀Δ`.
#[test]
fn nodal_contact_forces_do_not_converge() {
    /// What is off by this much on fine grids does not converge.
    const OFF: f64 = 0.1;
    /// `Δ²/l²` on these grids is 6·10⁻⁶ at most, some ten times over.
    const RIGHT: f64 = 1e-4;
    let fine: Vec<_> = (1..=10).map(|k| accuracy::errors(400 + 10 * k).expect("grids of the example")).collect();
    let off = fine.iter().filter(|e| OFF < e.first_force.abs()).count();
    assert!(fine.len() < 2 * off, "on {off} of {} fine grids the first force is off by ten per cent", fine.len());
    assert!(fine.iter().all(|e| OFF < e.pressure), "a nodal force is off by ten per cent on every fine grid");
    // Beside them, on the same grids, the end reaction is right to four digits.
    assert!(fine.iter().all(|e| e.end_reaction.abs() < RIGHT), "{fine:?}");
}
