//! Ground that gives on grids: the way to the exact solution, every route to one optimum, the way to rigid ground.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Beam, Foundation, Grid, Load, PointLoad, Scene, Support};
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, Solution, Witness, solve, solve_exactly};
use palkki_evidence::compare::largest;
use palkki_evidence::random::{self, Random};

use crate::scenes::{nodes, run};

fn scene(supports: Option<Vec<Support>>, point: Vec<PointLoad>, foundation: Foundation, stiffness: f64) -> Scene {
    let mut beam = Beam::new(10.0, 500.0 / 384.0).expect("a beam");
    if let Some(supports) = supports {
        beam = beam.with_supports(supports).expect("supports");
    }
    let load = Load::new(&beam, 1.0, Vec::new(), point).expect("a load");
    Scene::new(beam, load, Some(foundation)).and_then(|scene| scene.on_springs(stiffness)).expect("a scene")
}

/// A simple beam, a wall inside with both overhangs, three supports, a beam that merely lies there, and one of which two supports only
/// push: it lifts off one of them.
fn scenes() -> [(&'static str, Scene); 5] {
    let support = |at: f64, level: f64, slope: Option<f64>| Support { slope, ..Support::simple(at).at_level(level) };
    let wall = vec![support(4.0, 0.1, Some(0.02))];
    let three = vec![support(0.0, 0.0, None), support(6.0, 0.4, None), support(10.0, 0.0, None)];
    let push = |at: f64, level: f64| Support { pushes_only: true, ..support(at, level, None) };
    let pushed = vec![push(0.0, 0.0), support(4.0, 0.1, None), push(8.0, 0.3)];
    let load = |at: f64| vec![PointLoad { at, force: 2.0 }];
    let waves = Foundation::Cosine { mean: 0.6, amplitude: 0.1, wavelength: 7.0, phase: 0.4 };
    [
        ("simple", scene(None, Vec::new(), Foundation::Flat { depth: 1.0 }, 100.0)),
        ("wall", scene(Some(wall), load(9.0), Foundation::Polynomial { coefficients: vec![0.5, 0.05] }, 30.0)),
        ("three", scene(Some(three), Vec::new(), Foundation::Flat { depth: 0.5 }, 10.0)),
        ("lying", scene(Some(Vec::new()), load(8.0), waves, 5.0)),
        ("pushed", scene(Some(pushed), load(6.0), Foundation::Flat { depth: 0.5 }, 20.0)),
    ]
}

#[track_caller]
fn on_grid(scene: &Scene, method: Method, solver: Solver, intervals: usize) -> Solution {
    solve(scene, &Settings::new(method, solver, intervals)).expect("an answer")
}

/// Second order, by each method, of energy, largest deflection and moment, pressure and forces. From one grid to the next errors go
/// up and down with the place of lift-off between two nodes: they are means over grids.
#[test]
fn grids_approach_the_exact_solution() {
    /// From so many intervals on to a tenth less than twice as many, and the same times so many.
    const COARSE: usize = 100;
    const FINER: usize = 8;
    /// Of means over ten grids and a handful of numbers, of which single ones have orders from 1.4 to 2.8.
    const ORDER: [f64; 2] = [1.9, 2.25];
    for (name, scene) in scenes() {
        let exact = solve_exactly(&scene).expect("an answer");
        assert_eq!(exact.verdict.status, Status::Certified, "{name}: {}", exact.verdict);
        let expected = numbers(&exact);
        for method in Method::ALL {
            let errors = |from: usize| {
                let mut sums = vec![0.0; expected.len()];
                for intervals in (from..2 * from).step_by(from / 10) {
                    let solution = on_grid(&scene, method, Solver::ActiveSet, intervals);
                    assert_eq!(solution.verdict.status, Status::Certified, "{name}, {method}: {}", solution.verdict);
                    let off =
                        numbers(&solution).into_iter().zip(&expected).map(|(found, expected)| (found - expected).abs());
                    sums.iter_mut().zip(off).for_each(|(sum, off)| *sum += off);
                }
                sums
            };
            let orders: Vec<f64> = errors(COARSE)
                .iter()
                .zip(errors(FINER * COARSE))
                .filter(|(coarse, _)| 1e-9 < **coarse)
                .map(|(coarse, fine)| libm::log(coarse / fine) / libm::log(8.0))
                .collect();
            #[expect(clippy::cast_precision_loss, reason = "a handful")]
            let mean = orders.iter().sum::<f64>() / orders.len() as f64;
            assert!((ORDER[0]..=ORDER[1]).contains(&mean), "{name}, {method}: {orders:?}");
        }
    }
}

fn numbers(solution: &Solution) -> Vec<f64> {
    let state = &solution.state;
    let pressure = state.pressure.expect("of ground that gives").max;
    let mut numbers =
        vec![state.energy, state.deflection.max, state.moment.max, state.moment.min, pressure, state.contact_force()];
    numbers.extend(state.supports.iter().map(|support| support.force));
    numbers
}

/// The solvers that reach the optimum come to it by every method, on ground soft and stiff; projection (NSOR) not in forces, whose
/// matrix has too large a condition number for it on rigid ground as well.
#[test]
fn every_route_comes_to_one_optimum() {
    /// A solver stops at this residual; energy is of second order in it.
    const STOPPED: f64 = 1e-9;
    for (name, scene) in scenes() {
        for factor in [1e-3, 1.0, 1e5] {
            let stiffness = scene.ground_stiffness().expect("it gives") * factor;
            let scene = scene.on_springs(stiffness).expect("positive");
            for method in Method::ALL {
                let expected = run(&scene, method, Solver::ActiveSet, 40);
                assert!(expected.residual <= 1e-12, "{name}, {method}, {stiffness}: {}", expected.residual);
                for solver in Solver::OPTIMAL {
                    if solver == Solver::Nsor && method.is_free_in_contact() {
                        continue;
                    }
                    let found = run(&scene, method, solver, 40);
                    let off = (found.state.energy - expected.state.energy).abs();
                    let within = STOPPED * expected.state.energy.abs();
                    assert!(off <= within, "{name}, {method}, {solver}, {stiffness}: {off:e}, {}", found.run.message);
                }
            }
        }
    }
}

/// On a grid rigid ground is approached with the first power of `1/k`: nodes sink by `p/kΔ`.
#[test]
fn stiff_ground_comes_to_rigid_ground() {
    for method in Method::ALL {
        let (_, soft) = &scenes()[0];
        let rigid = Scene::new(soft.beam().clone(), soft.load().clone(), soft.foundation().cloned()).expect("a scene");
        let expected = run(&rigid, method, Solver::ActiveSet, 60).state;
        let off = |stiffness: f64| {
            let scene = soft.on_springs(stiffness).expect("positive");
            let state = run(&scene, method, Solver::ActiveSet, 60).state;
            (state.reactions.left - expected.reactions.left).abs()
        };
        let order = libm::log10(off(1e6) / off(1e9)) / 3.0;
        assert!((order - 1.0).abs() <= 0.01, "{method}: {order}");
        assert!(off(1e14) <= 1e-12 * expected.reactions.left, "{method}: {:e}", off(1e14));
    }
}

/// On random ground of a random stiffness the active set solves its discrete problem by every method, and no bound is untrue.
#[test]
fn random_scenes_are_solved_on_grids() {
    let scenes = random::sample_of(150);
    let mut tried = 0;
    for seed in 0.. {
        let scene = if seed % 2 == 0 { random::held(seed) } else { random::scene(seed) };
        let scene = scene.on_springs(libm::pow(10.0, Random::new(seed).between(-3.0, 9.0))).expect("positive");
        let Some(step) = Grid::least_fitting(&scene).filter(|step| scene.scaled().is_ok() && *step <= 1000) else {
            continue;
        };
        if scene.ground_stiffness().is_none() {
            continue;
        }
        let intervals = step * 200_usize.div_ceil(step);
        let exact = solve_exactly(&scene).expect("an answer").exact.expect("functions");
        let witness = Witness::known(&scene, &exact);
        for method in Method::ALL {
            let raw = run(&scene, method, Solver::ActiveSet, intervals);
            let residual = raw.residual;
            assert!(residual <= CERTIFIED_RESIDUAL, "{seed}, {method}, {intervals}: {residual:e}, {}", raw.ended());
            assert!(raw.run.reports_success, "{seed}, {method}, {intervals}: {}", raw.ended());
            let verdict = Verdict::of_raw(&raw, &witness, &Demand::default());
            if verdict.status == Status::Certified {
                let nodes = nodes(&raw);
                let off = largest(nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| v - exact.deflection(*x)));
                let most = verdict.certificate.expect("bounds").deflection_error;
                assert!(off <= most * (1.0 + 1e-9), "{seed}, {method}: off by {off:e}, at most {most:e}");
            }
        }
        tried += 1;
        if tried == scenes {
            break;
        }
    }
}
