//! Multigrid is a matter of speed: without it every method with every solver comes to the same answer.

use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::methods::Discrete;
use palkki::qp::{FreeSet, residual};
use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::solvers::active_set_from;
use palkki_evidence::paper::uneven::{Unevenness, scenes};
use palkki_evidence::random;

use crate::scenes::{apart, largest, nodes, report, run};

/// Largest differences of contact forces over the load, and of deflections over the largest one. The same contact set gives the
/// same digits; where a node is at the border of contact two sets give the same point to rounding, a few thousand units in the
/// last place.
const SAME_POINT: f64 = 1e-12;

/// Of another solver on 10 intervals: condition numbers are about 10³, and a residual of 1e-9 passes the check. Contact forces
/// may differ by their product over the load, deflections by little more than the residual itself.
const CERTIFIED: [f64; 2] = [1e-6, 1e-7];

/// Scenes of the report, random waves and polylines, and random scenes of all kinds.
fn all() -> Vec<Scene> {
    let mut all: Vec<Scene> = report().into_iter().map(|(_, scene)| scene).collect();
    for kind in Unevenness::ALL {
        all.extend(scenes(kind, 5, 11).expect("depths are positive"));
    }
    all.extend((0..2000).step_by(200).flat_map(|i| [random::scene(i), random::rough(i)]));
    all
}

/// `solve` starts the active set from the contact of a coarser grid and lets it work in windows; a solver that is asked by itself
/// knows nothing of either.
#[test]
fn every_method_and_solver_comes_to_the_same_answer_without_it() {
    let (mut compared, mut asked) = (0, 0);
    for (k, scene) in all().iter().enumerate().filter(|(_, scene)| scene.foundation().is_some()) {
        let scaled = scene.scaled().expect("numbers in range");
        // On a thousand intervals the start takes all unknowns for free, which is slow: on every second scene.
        let grids = if k.is_multiple_of(2) { [10, 170, 1000].as_slice() } else { &[10, 170] };
        for &intervals in grids {
            let discrete = Discrete::new(&scaled.scene, intervals).expect("enough intervals");
            for method in Method::ALL {
                let qp = method.qp(&discrete);
                let with = run(scene, method, Solver::ActiveSet, intervals);
                let with = nodes(&with);
                let few = if intervals == 10 { Solver::ALL.as_slice() } else { &[Solver::ActiveSet] };
                for &solver in few {
                    let answer = solver.run(qp.as_ref(), DEFAULT_TOLERANCE);
                    let found = residual(qp.sizes(), &answer.x, &qp.gradient(&answer.x));
                    asked += usize::from(solver != Solver::ActiveSet);
                    let allowed = if solver == Solver::ActiveSet {
                        assert!(answer.run.reports_success, "{k}, {method}, {intervals}: {}", answer.run.message);
                        [SAME_POINT; 2]
                    } else if found <= CERTIFIED_RESIDUAL {
                        CERTIFIED
                    } else {
                        continue;
                    };
                    let without = method.nodal(&discrete, answer.x, answer.gradient);
                    let in_units = |values: &[f64], unit: f64| values.iter().map(|v| v * unit).collect::<Vec<_>>();
                    let forces = in_units(&without.contact_force, scaled.scale.force);
                    let deflections = in_units(&without.deflection, scaled.scale.depth);
                    let load = scene.load().magnitude(scene.beam().length());
                    let differences = [
                        apart(&with.contact_force, &forces) / load.max(largest(&forces)),
                        apart(&with.deflection, &deflections) / largest(&deflections),
                    ];
                    assert!(
                        differences[0] <= allowed[0] && differences[1] <= allowed[1],
                        "{k}, {method}, {solver}, {intervals}: {:.1e} and {:.1e}",
                        differences[0],
                        differences[1]
                    );
                    compared += usize::from(solver != Solver::ActiveSet);
                }
            }
        }
    }
    assert!(asked < 2 * compared, "only {compared} of {asked} answers of other solvers are certified");
}

/// The optimum is unique, whatever it is found from.
#[test]
fn the_start_does_not_change_the_answer() {
    for scene in all().iter().step_by(5) {
        let scaled = scene.scaled().expect("numbers in range");
        let discrete = Discrete::new(&scaled.scene, 170).expect("enough intervals");
        for method in Method::ALL {
            let qp = method.qp(&discrete);
            let all_free = Solver::ActiveSet.run(qp.as_ref(), 0.0);
            let none_free = active_set_from(qp.as_ref(), FreeSet::none(qp.dimension()));
            assert!(all_free.run.reports_success && none_free.run.reports_success, "{method}");
            let size = qp.sizes().x.max(largest(&all_free.x));
            assert!(apart(&all_free.x, &none_free.x) <= SAME_POINT * size, "{method}, {}", scene.title());
        }
    }
}
