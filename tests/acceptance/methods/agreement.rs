//! Agreement of the energy methods by their own matrices and without. Every method with every solver is in `multigrid`.

use palkki::methods::Discrete;
use palkki::route::{Method, Solver};
use palkki_evidence::paper::claims::energy_methods::explicit;

use crate::scenes::{apart, largest, nodes, report, run};

/// By the matrices themselves: their condition number is about 10⁶ on the finest of these grids, so that 16 digits leave ten,
/// and nine of the forces, which are differences.
const BY_MATRICES: f64 = 1e-9;

/// Displacement and force method each with the matrix that the paper gives it, and what `solve` makes of either without.
#[test]
fn the_energy_methods_agree_to_rounding() {
    for (name, scene) in report().into_iter().filter(|(_, scene)| scene.foundation().is_some()) {
        let scaled = scene.scaled().expect("numbers in range");
        let load = scaled.scene.load().magnitude(scaled.scene.beam().length());
        for intervals in [7, 20, 61] {
            let discrete = Discrete::new(&scaled.scene, intervals).expect("enough intervals");
            let without = run(&scaled.scene, Method::Force, Solver::ActiveSet, intervals);
            let without = nodes(&without);
            for method in [Method::Displacement, Method::Force] {
                let qp = method.qp(&discrete);
                let answer = Solver::ActiveSet.run(&explicit(qp.as_ref()), 0.0);
                assert!(answer.reports_success, "{name}, {method}, {intervals}: {}", answer.message);
                let with = method.nodal(&discrete, answer.x, answer.gradient);
                let force = apart(&with.contact_force, &without.contact_force) / load;
                let deflection = apart(&with.deflection, &without.deflection) / largest(&without.deflection);
                let error = force.max(deflection);
                assert!(error <= BY_MATRICES, "{name}, {method}, {intervals}: {force:.1e} and {deflection:.1e}");
            }
        }
    }
}
