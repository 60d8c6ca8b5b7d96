//! Digits at size: what is left of sixteen digits on grids on which the matrices of the methods have lost them all.
//!
//! `cond K` and `cond A` grow like `n⁴` and pass 10¹⁶ near 10⁴ intervals. The solves on a contact set never form them.

use palkki::route::{Method, Solver};

use crate::scenes::{apart, example, nodes, report, run};

/// The residual is that of sums in blocks of 64 and of one system of condition number 3, whatever the grid: some hundred
/// units in the last place.
const RESIDUAL: f64 = 1e-13;

/// Two formulations of one discrete problem, by rotations and by moments: some dozen units in the last place.
const SAME: f64 = 1e-14;

/// The residual stays that of rounding, and the model error of the end reaction goes down with `Δ²` for as long as there are grids: no
/// floor of rounding above 10⁻¹⁰.
#[test]
fn every_method_is_certified_on_a_million_intervals() {
    /// On 10⁶ intervals a lift-off point that is some nodes off moves the reaction by some 10⁻¹¹ of it.
    const FLOOR: f64 = 1e-10;
    let exact = palkki::theory::solve(&example()).expect("an exact solution").state.reactions.left;
    for method in Method::ALL {
        for (intervals, spacing) in
            [(1000, 1e-2), (10_000, 1e-3), (30_000, 1e-3 / 3.0), (100_000, 1e-4), (1_000_000, 1e-5)]
        {
            let raw = run(&example(), method, Solver::ActiveSet, intervals);
            assert!(raw.solved, "{method}, {intervals} intervals");
            let (residual, off) = (raw.residual, raw.state.reactions.left - exact);
            assert!(residual <= RESIDUAL, "{method}, {intervals} intervals: residual {residual:.1e}");
            // The constant of the order is below 1/8 on all grids of the report.
            let bound = 0.125 * spacing * spacing + FLOOR;
            assert!(off.abs() <= bound, "{method}, {intervals} intervals: off by {off:.1e}");
        }
    }
}

#[test]
fn rotations_and_moments_agree_to_the_last_digits() {
    // On finer grids the contact sets may differ in a node whose clearance is rounding.
    for intervals in [1000, 3000, 10_000] {
        let [by_rotations, by_moments] =
            [Method::Displacement, Method::Force].map(|method| run(&example(), method, Solver::ActiveSet, intervals));
        let error = apart(&nodes(&by_rotations).deflection, &nodes(&by_moments).deflection);
        assert!(error <= SAME, "{intervals} intervals: deflections differ by {error:.1e} of the depth");
        let error = by_rotations.state.reactions.left - by_moments.state.reactions.left;
        assert!(error.abs() <= SAME, "{intervals} intervals: reactions differ by {error:.1e}");
    }
}

/// Steps are left out: on such a grid the contact set at the foot of a step takes any active set a minute.
#[test]
fn uneven_ground_loses_no_digits_either() {
    for (name, scene) in report().into_iter().filter(|(name, _)| name != "step") {
        for method in [Method::Complementarity, Method::Displacement] {
            let raw = run(&scene, method, Solver::ActiveSet, 20_000);
            assert!(raw.solved, "{name}, {method}: residual {:.1e}", raw.residual);
        }
    }
}
