//! Against the closed form of flat ground: every method with every solver, right or wrong, is bounded truthfully.

use palkki::route::{Method, Solver};
use palkki::scene::{Foundation, Scene};
use palkki::theory::{FlatSolution, flat};

use super::{of_nodes, true_error};
use crate::scenes::{nodes, run, uniform};

/// Depths over the free deflection `5 q l⁴ / 384 EI` of the beam: two zones, mid-span only, out of reach.
const DEPTHS: [f64; 4] = [1e-4, 0.01, 0.5, 1.2];

/// The closed form is rounded, too: a few units in the last place of the largest deflection and of the energy.
const ROUNDING: f64 = 1e-14;

fn scene(share: f64) -> (Scene, FlatSolution) {
    let (l, ei, q) = (7.0, 3.0, 2.0);
    let depth = share * 5.0 * q * l * l * l * l / (384.0 * ei);
    (uniform(l, ei, q, Foundation::Flat { depth }), flat(l, ei, depth, q))
}

/// Every answer on a grid, with the truth; the energies bracket that of the closed form, the error bounds the true one.
#[track_caller]
fn check(intervals: usize, solvers: &[Solver]) {
    for share in DEPTHS {
        let (scene, truth) = scene(share);
        for method in Method::ALL {
            for &solver in solvers {
                let raw = run(&scene, method, solver, intervals);
                let what = format!("depth {share}, {method} {solver}, {intervals} intervals");
                let nodes = nodes(&raw);
                let certificate = of_nodes(&scene, nodes);
                let slack = ROUNDING * truth.energy.abs();
                assert!(certificate.energy_lower <= truth.energy + slack, "{what}: {certificate:?}, {}", truth.energy);
                assert!(truth.energy - slack <= certificate.energy_upper, "{what}: {certificate:?}, {}", truth.energy);
                assert!(
                    certificate.energy_upper - certificate.energy_lower <= certificate.gap + 1e3 * slack,
                    "{what}: the gap is that of the energies, {certificate:?}"
                );
                let error = true_error(&scene, nodes, |x| truth.deflection(x));
                let slack = ROUNDING * truth.deflection(3.5);
                assert!(error <= certificate.deflection_error + slack, "{what}: {error} for {certificate:?}");
                for reaction in certificate.reactions.into_iter().flatten() {
                    let slack = ROUNDING * truth.reaction;
                    assert!(
                        reaction[0] <= truth.reaction + slack && truth.reaction - slack <= reaction[1],
                        "{what}: {} in {reaction:?}",
                        truth.reaction
                    );
                }
            }
        }
    }
}

#[test]
fn every_route_on_coarse_grids() {
    check(10, &Solver::ALL);
    check(30, &Solver::ALL);
}

#[test]
fn every_route_on_finer_grids() {
    check(60, &Solver::ALL);
    check(300, &[Solver::ActiveSet, Solver::FourStep, Solver::Clarabel]);
}
