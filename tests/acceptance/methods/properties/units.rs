//! Units are labels: answers in other units are the same answers.

use palkki::Settings;
use palkki::route::{Method, Solver};
use palkki::state::ContactState;

use palkki_evidence::draft::{Draft, Units};

use super::{ROUNDING, scene, some};
use crate::scenes::{apart, largest};

/// Numbers of a state in the old units: places, depths, forces, moments, energy.
fn undone(Units { length, depth, force }: Units, state: &ContactState) -> [Vec<f64>; 5] {
    let nodes = state.nodes.as_ref().expect("nodes");
    let over = |values: &[f64], unit: f64| values.iter().map(|v| v / unit).collect::<Vec<_>>();
    [
        over(&nodes.x, length),
        over(&nodes.deflection, depth),
        over(&[&nodes.contact_force[..], &[state.reactions.left, state.reactions.right]].concat(), force),
        over(&nodes.moment, force * length),
        vec![state.energy / (force * depth)],
    ]
}

/// Our own solvers; the libraries are only given dimensionless numbers, but nobody promises their bits.
const BY_HAND: [Solver; 3] = [Solver::FourStep, Solver::ActiveSet, Solver::Nsor];

fn state(draft: &Draft, method: Method, solver: Solver) -> ContactState {
    // A loose tolerance for NSOR: what is asked here is the same bits, not many digits.
    let settings = Settings { tolerance: 1e-4, ..Settings::new(method, solver, 14) };
    palkki::solve_raw(&scene(draft), &settings).expect("numbers in range").state
}

#[test]
fn powers_of_two_do_not_change_a_bit() {
    let factors = [
        Units { length: 1024.0, depth: 1.0, force: 1.0 },
        Units { length: 1.0, depth: 0.125, force: 1.0 },
        Units { length: 1.0, depth: 1.0, force: 65536.0 },
        Units { length: 0.0625, depth: 512.0, force: 0.5 },
    ];
    for draft in some(6, 3) {
        for method in Method::ALL {
            for solver in BY_HAND {
                let reference = undone(Units::SAME, &state(&draft, method, solver));
                for factors in factors {
                    let other = undone(factors, &state(&draft.in_units(factors), method, solver));
                    let same = reference.iter().flatten().zip(other.iter().flatten());
                    let differs = same.filter(|(a, b)| a.to_bits() != b.to_bits()).count();
                    assert_eq!(differs, 0, "{method} {solver} {factors:?}: bits differ");
                }
            }
        }
    }
}

#[test]
fn other_units_change_rounding_only() {
    // Feet, millimetres, pounds.
    let factors = [
        Units { length: 3.280_839_895, depth: 3.280_839_895, force: 0.224_809 },
        Units { length: 1.0, depth: 1000.0, force: 1.0 },
        Units { length: 1000.0, depth: 1000.0, force: 1e-3 },
    ];
    for draft in some(20, 4) {
        for method in Method::ALL {
            let reference = undone(Units::SAME, &state(&draft, method, Solver::ActiveSet));
            for factors in factors {
                let other = undone(factors, &state(&draft.in_units(factors), method, Solver::ActiveSet));
                for (a, b) in reference.iter().zip(&other) {
                    assert!(apart(a, b) <= ROUNDING * largest(a), "{method} {factors:?}: {:.1e}", apart(a, b));
                }
            }
        }
    }
}

/// Twice the loads on a foundation twice as deep: twice the forces and the deflection, in the same units.
#[test]
fn loads_and_depths_together_scale_the_answer() {
    for draft in some(10, 5) {
        for factor in [2.0, 3.7] {
            let scaled = Units { length: 1.0, depth: factor, force: factor };
            for method in Method::ALL {
                let a = undone(Units::SAME, &state(&draft, method, Solver::ActiveSet));
                // EI stays what it is.
                let bigger = draft.in_units(scaled);
                assert!((bigger.stiffness / draft.stiffness - 1.0).abs() <= 4.0 * f64::EPSILON, "EI is the same");
                let b = undone(scaled, &state(&bigger, method, Solver::ActiveSet));
                for (a, b) in a.iter().zip(&b) {
                    assert!(apart(a, b) <= ROUNDING * largest(a), "{method} × {factor}: {:.1e}", apart(a, b));
                }
            }
        }
    }
}
