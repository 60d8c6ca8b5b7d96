//! Beams under an axial force on grids: closed forms, the way to the exact solution, next to no force, and compression that a grid does not
//! bear.

use std::f64::consts::PI;

use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::{Settings, Solution, solve, solve_exactly};
use palkki_evidence::random::Feature::{Hinge, Joint, SoilSteps, Spring, Steps, Stop, Tension, Turning};
use palkki_evidence::random::{Feature, general_on_grid, sample_of};

use super::giving::{COARSE, FEW, agree, approach, known, read};
use crate::scenes::run;

/// A beam of length 10 and stiffness 30 under this axial force, and more lines of the beam.
fn tied(force: f64, more: &str) -> String {
    format!("[beam]\nlength = 10.0\nbending_stiffness = 30.0\ntension = {force:?}\n{more}\n")
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, share: f64) {
    assert!((found - expected).abs() <= share * expected.abs(), "{what}: {found} and {expected}");
}

/// A force in the middle of a tie rod and of a strut, of which beam elements know the deflection and the moment on any grid:
///
/// ```text
/// v = P (u − tanh u)/(2 N k),   M = P tanh u/(2 k)      k² = |N|/EI, u = k l/2; tan u for tanh u, and −N, under compression
/// ```
#[test]
fn a_force_in_the_middle_is_exact_by_elements_on_every_grid() {
    for share in [-0.999, -0.5, 1.0, 40.0, 3e3, 1e6] {
        let force = if share < 0.0 { share * PI * PI } else { share } * 0.3;
        let k = (force.abs() / 30.0_f64).sqrt();
        let u = 5.0 * k;
        let turned = if share < 0.0 { libm::tan(u) } else { libm::tanh(u) };
        let (sag, moment) = ((u - turned) / (2.0 * force * k), turned / (2.0 * k));
        let scene = read(&format!("{}[load]\npoint = [{{ at = 5.0, force = 1.0 }}]\n", tied(force, "")));
        for intervals in [2, 30, 200] {
            for method in [Method::Displacement, Method::Force] {
                let found = run(&scene, method, Solver::ActiveSet, intervals);
                assert!(found.solved, "{share}, {method}, {intervals}: {:e}", found.residual);
                close(&format!("{share}, {intervals}"), found.state.deflection.max, sag, 1e-10);
                close(&format!("{share}, {intervals}"), found.state.moment.max, moment, 1e-9);
            }
        }
        // Links bend in their joints, and have no layer that is shorter than one of them.
        if 1e4 < share {
            continue;
        }
        let errors = [200, 400].map(|intervals| {
            let state = run(&scene, Method::Complementarity, Solver::ActiveSet, intervals).state;
            (state.deflection.max - sag).abs() / sag
        });
        assert!(errors[1] < 0.27 * errors[0] && errors[1] < 2e-2, "{share}: {errors:?}");
    }
}

/// A cable: the bending stiffness is next to nothing, and the sag under a uniform load `q l²/8N`.
#[test]
fn under_much_tension_a_beam_is_a_cable() {
    for share in [1e6, 1e8, 1e10] {
        let force = share * 0.3;
        let scene = read(&format!("{}[load]\nuniform = 1.0\n", tied(force, "")));
        for method in Method::ALL {
            let state = run(&scene, method, Solver::ActiveSet, 200).state;
            // Of the bending stiffness, and of nodal loads, by the square of the spacing.
            close(&format!("{share}, {method}"), state.deflection.max, 100.0 / 8.0 / force, 8.2 / share + 2.5e-5);
            close(&format!("{share}, {method}"), state.supports[0].force, 5.0, 1e-12);
        }
    }
}

/// Random beams under tension, whose supports, joints and steps are at nodes.
const GROUPS: [(&str, &[Feature], bool); 3] = [
    ("tension", &[Tension, Spring, Turning, Stop], false),
    ("tension of beams that change", &[Tension, Steps, Joint, Hinge], false),
    ("tension on soil", &[Tension, SoilSteps, Spring, Stop], true),
];

/// The scenes of a group that beam theory certifies, with its answers; under compression up to nine tenths of what they bear.
fn drawn(
    (of, on_soil): (&'static [Feature], bool),
    compressed: bool,
    intervals: usize,
    cases: u32,
) -> impl Iterator<Item = (u32, Scene, Solution)> {
    (0..sample_of(cases)).filter_map(move |i| {
        let drawn = general_on_grid(u64::from(i), of, on_soil, intervals as f64);
        let text = drawn.features.contains(&Tension).then_some(drawn.text)?;
        if !compressed {
            return known(i, &text);
        }
        let line = text.lines().find(|line| line.starts_with("tension"))?;
        // It says where it buckles.
        let refused =
            parse("scene.toml", &text.replace(line, "tension = -1e9"), |_| Err(ReadProblem::Missing)).err()?;
        let message = refused.to_string();
        let at: f64 = message.split("buckles at ").nth(1)?.split(' ').next()?.parse().ok()?;
        known(i, &text.replace(line, &format!("tension = {:?}", at * (0.1 + 0.8 * f64::from(i % 7) / 6.0))))
    })
}

/// As without an axial force.
#[test]
fn random_beams_under_tension_on_grids_approach_beam_theory() {
    for (name, of, on_soil) in GROUPS {
        approach(name, drawn((of, on_soil), false, COARSE, 160));
    }
}

#[test]
fn random_beams_under_compression_on_grids_approach_beam_theory() {
    for (name, of, on_soil) in GROUPS {
        approach(name, drawn((of, on_soil), true, COARSE, 200));
    }
}

#[test]
fn other_solvers_come_to_the_same_answer_under_an_axial_force() {
    for (name, of, on_soil) in GROUPS {
        agree(name, drawn((of, on_soil), false, FEW, 60), 85);
        // Compression leaves the libraries the matrix alone, whose condition number is the square of that of the sparse form.
        agree(name, drawn((of, on_soil), true, FEW, 60), 75);
    }
}

/// Next to no force is none, to rounding: the answers of all methods, also of beams that hang over on both sides, lie on the ground, or have a
/// hinge.
#[test]
fn next_to_no_axial_force_is_none_on_a_grid() {
    for more in [
        "",
        "joints = [{ at = 4.0, stiffness = 9.0 }]",
        "joints = [{ at = 7.0 }]\nsupports = [{ at = 0.0, built_in = true }, { at = 10.0 }]",
        "supports = []",
        "supports = [{ at = 1.0 }, { at = 8.0 }]",
        "supports = [{ at = 3.0, built_in = true }]",
        "supports = [{ at = 3.0, stiffness = 50.0, turning_stiffness = 90.0 }]",
    ] {
        for ground in [
            "",
            "[foundation]\ndepth = 1.0\n",
            "[foundation]\npoints = [[0, 1.5], [4, 0.5], [10, 1.5]]\n",
            "[foundation]\ndepth = 0.2\nstiffness = 30.0\n",
        ] {
            if ground.is_empty() && more.contains("[]") {
                continue;
            }
            for method in Method::ALL {
                let with = |force: f64| {
                    let scene = read(&format!("{}[load]\nuniform = 1.0\n{ground}", tied(force, more)));
                    let found = run(&scene, method, Solver::ActiveSet, 100);
                    assert!(found.solved, "{force}, {method}, {more}, {ground}: {:e}", found.residual);
                    found.state
                };
                let none = with(0.0);
                for force in [1e-14, -1e-14].into_iter().filter(|force| 0.0 < *force || !more.contains("[]")) {
                    let next = with(force);
                    let same = |a: f64, b: f64| {
                        assert!((a - b).abs() <= 1e-10 * (1.0 + a.abs()), "{a} and {b}: {method}, {more} {ground}");
                    };
                    same(next.energy, none.energy);
                    same(next.moment.max, none.moment.max);
                    same(next.moment.min, none.moment.min);
                    same(next.deflection.max, none.deflection.max);
                    same(next.deflection.min, none.deflection.min);
                    assert_eq!(next.contacts.len(), none.contacts.len(), "{method}, {more} {ground}");
                    next.supports.iter().zip(&none.supports).for_each(|(a, b)| same(a.force, b.force));
                    let nodes = |state: &palkki::state::ContactState| state.nodes.clone().expect("nodes").deflection;
                    nodes(&next).into_iter().zip(nodes(&none)).for_each(|(a, b)| same(a, b));
                }
            }
        }
    }
}

/// Tension holds a beam on one support, and one that lies on the ground with its resultant beyond it.
#[test]
fn tension_holds_a_beam_against_turning_on_a_grid() {
    for supports in ["{ at = 2.0 }", "{ at = 3.0, pushes_only = true }, { at = 5.0, pushes_only = true }"] {
        let text = format!(
            "{}[load]\npoint = [{{ at = 7.0, force = 1.0 }}]\n",
            tied(20.0, &format!("supports = [{supports}]"))
        );
        let scene = read(&text);
        let exact = solve_exactly(&scene).expect("an answer");
        for method in Method::ALL {
            for solver in [Solver::ActiveSet, Solver::Clarabel] {
                let found = solve(&scene, &Settings::new(method, solver, 100)).expect("a grid");
                assert_eq!(found.verdict.status, Status::Certified, "{method}: {}", found.verdict);
                close("deflection", found.state.deflection.max, exact.state.deflection.max, 1e-3);
                close("force", found.state.supports.iter().map(|s| s.force).sum(), 1.0, 1e-12);
            }
        }
    }
}

/// On a hundred times as many intervals residuals are those of rounding: forces are not differences of moments at neighbouring nodes.
#[test]
fn fine_grids_under_an_axial_force_lose_no_digits() {
    for force in [-2.0, 1e-3, 50.0_f64] {
        for more in ["", "supports = [{ at = 2.0 }, { at = 9.0 }]"] {
            let force = if more.is_empty() { force } else { force.max(-0.5) };
            let scene = read(&format!("{}[load]\nuniform = 1.0\n[foundation]\ndepth = 0.1\n", tied(force, more)));
            for method in Method::ALL {
                let found = solve(&scene, &Settings::new(method, Solver::ActiveSet, 30_000)).expect("a grid");
                assert_eq!(found.verdict.status, Status::Certified, "{force}, {method}: {}", found.verdict);
                assert!(found.residual < 1e-10, "{force}, {method}, {more}: {:e}", found.residual);
            }
        }
    }
}

/// Links buckle a little before the beam: at `4 (EI/Δ²) sin²(π/2n)`. The message has the number of intervals.
#[test]
fn compression_that_a_grid_does_not_bear_is_refused() {
    let (intervals, square) = (20_u32, |x: f64| x * x);
    let angle = PI / f64::from(2 * intervals);
    let links = -4.0 * 30.0 / square(0.5) * square(libm::sin(angle));
    let of = |force: f64, method: Method| {
        let scene = read(&format!("{}[load]\nuniform = 1e-3\n[foundation]\ndepth = 1.0\n", tied(force, "")));
        solve(&scene, &Settings::new(method, Solver::ActiveSet, 20))
    };
    for method in Method::ALL {
        assert!(of(links * (1.0 - 1e-4), method).is_ok_and(|found| found.solved), "{method}");
    }
    let beyond = links * (1.0 + 1e-9);
    let message = of(beyond, Method::Complementarity).err().map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("on 20 intervals the beam buckles before"), "{message}");
    assert!(of(beyond, Method::Force).is_ok_and(|found| found.solved));
}
