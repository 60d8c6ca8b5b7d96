//! Units: the same bits by our own solvers where units are powers of two, the same twelve digits where they are not.

use palkki::Settings;
use palkki::route::{Method, Solver};
use palkki::state::ContactState;
use palkki_evidence::compare::apart;
use palkki_evidence::draft::Units;
use palkki_evidence::extremes::units;

/// Data that are rounded in new units, by half a unit in the last place each, times what 30 intervals amplify.
const DIGITS: f64 = 1e-12;
/// What a library is asked for, and its own scaling of rounded data.
const LIBRARY: f64 = 1e-6;

const GRID: usize = 30;

/// Forces and energy in the original units.
fn undone(state: &ContactState, units: Units) -> Vec<f64> {
    let nodes = state.nodes.as_ref().expect("nodes");
    let forces = [state.reactions.left, state.reactions.right].into_iter().chain(nodes.contact_force.iter().copied());
    let depths = nodes.deflection.iter().map(|v| v / units.depth);
    forces.map(|f| f / units.force).chain(depths).collect()
}

#[test]
fn units_do_not_matter() {
    let mut wrong = Vec::new();
    for method in Method::ALL {
        for solver in [Solver::FourStep, Solver::ActiveSet, Solver::Clarabel, Solver::Osqp] {
            let mut reference: Option<(Vec<f64>, bool)> = None;
            for (factors, extreme) in units().expect("scenes in range") {
                let raw =
                    palkki::solve_raw(&extreme.scene, &Settings::new(method, solver, GRID)).expect("numbers in range");
                let found = undone(&raw.state, factors);
                if factors == Units::SAME {
                    reference = Some((found, raw.solved));
                    continue;
                }
                let (expected, solved) = reference.as_ref().expect("the first is in the original units");
                let own = matches!(solver, Solver::FourStep | Solver::ActiveSet);
                let size = expected.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
                let error = apart(&found, expected) / size;
                let same = found.iter().zip(expected).all(|(a, b)| a.to_bits() == b.to_bits());
                let digits = if own { DIGITS } else { LIBRARY };
                if raw.solved != *solved || (own && factors.exact() && !same) || (*solved && digits < error) {
                    wrong.push(format!("{} by {method}/{solver}: {:?}, off by {error:e}", extreme.name, raw.solved));
                }
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}
