//! Supports that give, and holes of an elastic foundation, on grids: random beams beside beam theory, and limits of stiffness.

use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::state::ContactState;
use palkki::{Settings, Solution, solve, solve_exactly};
use palkki_evidence::random::Feature::{Joint, SoilSteps, Spring, Steps, Stop, Turning};
use palkki_evidence::random::{Feature, general_on_grid, sample_of};

use crate::scenes::run;

pub(super) fn read(text: &str) -> Scene {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Intervals of the coarsest grid, at whose nodes all places are.
pub(super) const COARSE: usize = 60;

/// Intervals where solvers are compared: the condition number of a matrix, and with it the sweeps of NSOR, grow with the fourth power.
pub(super) const FEW: usize = 30;

/// Features of random beams, and whether they lie on an elastic foundation.
const GROUPS: [(&str, &[Feature], bool); 4] = [
    ("springs", &[Spring, Turning, Stop], false),
    ("springs on soil", &[Spring, Turning, Stop], true),
    ("springs of beams that change", &[Spring, Turning, Stop, Steps, Joint], false),
    ("holes", &[SoilSteps, Spring, Stop], true),
];

/// The scenes of a group that beam theory certifies, with its answers.
fn drawn(
    of: &'static [Feature],
    on_soil: bool,
    intervals: usize,
    cases: u32,
) -> impl Iterator<Item = (u32, Scene, Solution)> {
    let text = move |i: u32| general_on_grid(u64::from(i), of, on_soil, intervals as f64).text;
    (0..sample_of(cases)).filter_map(move |i| known(i, &text(i)))
}

/// The scene of a number, if beam theory certifies it, with its answer.
pub(super) fn known(i: u32, text: &str) -> Option<(u32, Scene, Solution)> {
    let scene = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).ok()?;
    let exact = solve_exactly(&scene).ok()?;
    (exact.verdict.status == Status::Certified).then_some((i, scene, exact))
}

/// The largest error of deflections, energy and forces, each over the largest of its kind.
pub(super) fn error(found: &ContactState, exact: &ContactState) -> f64 {
    let force = exact.supports.iter().map(|support| support.force.abs()).fold(exact.contact_force(), f64::max);
    let deflection = exact.deflection.magnitude();
    let mut shares = vec![
        (found.deflection.max - exact.deflection.max) / deflection,
        (found.deflection.min - exact.deflection.min) / deflection,
        (found.energy - exact.energy) / exact.energy,
        (found.contact_force() - exact.contact_force()) / force,
    ];
    shares.extend(found.supports.iter().zip(&exact.supports).map(|(found, exact)| (found.force - exact.force) / force));
    shares.into_iter().fold(0.0, |most: f64, share| most.max(share.abs()))
}

/// Each answer of the active set is certified, no certified deflection is farther off than it says, and errors fall with the square of the
/// spacing: the median order, since single ones go up and down with the place of lift-off between two nodes.
#[test]
fn random_beams_on_grids_approach_beam_theory() {
    for (name, of, on_soil) in GROUPS {
        approach(name, drawn(of, on_soil, COARSE, 80));
    }
}

/// The same of some scenes with their numbers and exact answers.
#[track_caller]
pub(super) fn approach(name: &str, drawn: impl Iterator<Item = (u32, Scene, Solution)>) {
    const ORDER: [f64; 2] = [1.85, 2.15];
    /// Below it an error is rounding.
    const ROUNDING: f64 = 1e-11;
    let (mut orders, mut answers, mut certified) = (Vec::new(), 0_u32, 0_u32);
    for (i, scene, exact) in drawn {
        for method in Method::ALL {
            let errors = [COARSE, 8 * COARSE].map(|intervals| {
                let found = solve(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).expect("a grid");
                let told = format!("{name} {i}, {method}, {intervals}: {}", found.verdict);
                assert!(found.verdict.solves_its_problem(), "{told}");
                let certificate = found.verdict.certificate.as_ref().expect("bounds");
                let nodes = found.state.nodes.as_ref().expect("nodes");
                let curve = exact.exact.as_ref().expect("functions");
                let off = nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| (v - curve.deflection(*x)).abs());
                let off = off.fold(0.0, f64::max);
                let rounding = ROUNDING * exact.state.deflection.magnitude();
                assert!(off <= certificate.deflection_error + rounding, "{told}: {off}");
                answers += 1;
                certified += u32::from(found.verdict.status == Status::Certified);
                error(&found.state, &exact.state)
            });
            if ROUNDING < errors[1] {
                orders.push(libm::log(errors[0] / errors[1]) / libm::log(8.0));
            }
        }
    }
    // One in a hundred may be too coarse, or one.
    assert!(99 * answers <= 100 * (certified + 1), "{name}: {certified} of {answers}");
    orders.sort_by(f64::total_cmp);
    let order = orders[orders.len() / 2];
    assert!((ORDER[0]..=ORDER[1]).contains(&order), "{name}: {order}");
}

/// The other solvers come to the answer of the active set, or say that they do not; the four steps may stop anywhere.
#[test]
fn other_solvers_come_to_the_same_answer() {
    for (name, of, on_soil) in GROUPS {
        agree(name, drawn(of, on_soil, FEW, 40), 85);
    }
}

/// The same of some scenes with their numbers; of a hundred asked, libraries solve at least so many.
#[track_caller]
pub(super) fn agree(name: &str, drawn: impl Iterator<Item = (u32, Scene, Solution)>, least: u32) {
    let (mut asked, mut solved) = (0_u32, 0_u32);
    for (i, scene, _) in drawn {
        for method in Method::ALL {
            let best = run(&scene, method, Solver::ActiveSet, FEW);
            for solver in Solver::ALL {
                let found = run(&scene, method, solver, FEW);
                if found.solved {
                    let apart = error(&found.state, &best.state);
                    assert!(apart <= 1e-4, "{name} {i}, {method}, {solver}: {apart}");
                }
                let is_library = Solver::OPTIMAL[2..].contains(&solver);
                asked += u32::from(is_library);
                solved += u32::from(is_library && found.solved);
            }
        }
    }
    assert!(least * asked <= 100 * solved, "{name}: {solved} of {asked}");
}

/// A beam of 10 above a dish, with these supports.
fn dish(supports: &str) -> Scene {
    read(&format!(
        "[beam]\nlength = 10.0\nbending_stiffness = 1.3\nsupports = [{supports}]\n[load]\nuniform = 1.0\n\
         [foundation]\npolynomial = [0.8, -0.08, 0.008]\n"
    ))
}

/// Springs of 10¹² are supports, bearings and built-in ends, and of 10⁻¹² nothing.
#[test]
fn stiff_and_soft_springs_are_supports_and_none() {
    let pairs = [
        (
            "{ at = 0 }, { at = 4, level = 0.2, stiffness = 1e12 }, { at = 10 }",
            "{ at = 0 }, { at = 4, level = 0.2 }, { at = 10 }",
        ),
        (
            "{ at = 0 }, { at = 4, level = 0.2, stiffness = 1e12, pushes_only = true }, { at = 10 }",
            "{ at = 0 }, { at = 4, level = 0.2, pushes_only = true }, { at = 10 }",
        ),
        (
            "{ at = 0, turning_stiffness = 1e12, slope = 0.1 }, { at = 10 }",
            "{ at = 0, built_in = true, slope = 0.1 }, { at = 10 }",
        ),
        (
            "{ at = 3, turning_stiffness = 1e12, slope = 0.05, stiffness = 1e12 }",
            "{ at = 3, built_in = true, slope = 0.05 }",
        ),
        (
            "{ at = 0, turning_stiffness = 1e-12 }, { at = 5, stiffness = 1e-12 }, { at = 10 }",
            "{ at = 0 }, { at = 10 }",
        ),
        ("{ at = 0 }, { at = 5, stiffness = 1e-12, pushes_only = true }, { at = 10 }", "{ at = 0 }, { at = 10 }"),
    ];
    for (giving, firm) in pairs.map(|(giving, firm)| (dish(giving), dish(firm))) {
        for method in Method::ALL {
            let [found, limit] = [&giving, &firm].map(|scene| run(scene, method, Solver::ActiveSet, 40));
            let told = format!("{method}, {:?}: {:e}", giving.beam().all_supports(), found.residual);
            assert!(found.solved && limit.solved, "{told}");
            let [found, limit] = [found, limit].map(|solution| {
                let state = solution.state;
                [state.deflection.max, state.deflection.min, state.energy, state.contact_force(), state.moment.min]
            });
            let apart = found.iter().zip(&limit).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            assert!(apart <= 1e-9, "{told}: {found:?} and {limit:?}");
        }
    }
}
