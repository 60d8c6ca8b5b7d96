//! Beams that change on grids, by steps of the bending stiffness and by joints: the way to the exact solution, what is nothing, and where
//! nodes have to be.

use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::solve_exactly;
use palkki::state::ContactState;

use crate::scenes::run;

/// A scene file on a beam of 10.
fn scene(beam: &str, load: &str, ground: &str) -> Scene {
    let text = format!("[beam]\nlength = 10.0\n{beam}\n[load]\nuniform = 1.0\n{load}\n{ground}");
    parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Three stiffnesses with a joint, and a couple where one begins; a wall with both overhangs; a beam that merely lies there; and hinges, of
/// a Gerber beam and above ground.
fn scenes() -> [(&'static str, Scene); 6] {
    const STEPS: &str = "bending_stiffness = { steps = [[0, 1.3], [4, 2.6], [7, 1.5]] }\n";
    const CREST: &str = "[foundation]\npolynomial = [0.8, -0.08, 0.008]\n";
    let with = |more: &str| format!("{STEPS}{more}\n");
    let joint = "joints = [{ at = 3.0, stiffness = 2.0 }]";
    let couple = "couple = [{ at = 4.0, moment = 0.3 }]\n";
    let wall = "supports = [{ at = 4.0, level = 0.1, built_in = true, slope = 0.02 }]\njoints = [{ at = 8.0, stiffness = 3.0 }]";
    let gerber = "joints = [{ at = 6.0 }]\nsupports = [{ at = 0.0 }, { at = 4.0 }, { at = 10.0 }]";
    [
        ("steps and a joint", scene(&with(joint), couple, CREST)),
        ("flat", scene(&with(joint), "", "[foundation]\ndepth = 0.7\n")),
        ("wall", scene(&with(wall), "point = [{ at = 9.0, force = 0.5 }]", "[foundation]\ndepth = 3.0\n")),
        ("lying", scene(&with("supports = []"), "point = [{ at = 8.0, force = 2.0 }]", CREST)),
        ("Gerber", scene(&with(gerber), couple, "")),
        (
            "hinge above ground",
            scene(
                &with("joints = [{ at = 6.0 }]\nsupports = [{ at = 0.0 }, { at = 4.0 }, { at = 10.0 }]"),
                "",
                "[foundation]\npoints = [[0, 2], [4, 2], [5, 0.3], [10, 0.3]]\n",
            ),
        ),
    ]
}

/// Largest deflection and forces, and of a beam without couples energy and largest moment: a couple acts on a grid as two forces, between
/// which the moment rises over two intervals.
fn numbers(scene: &Scene, state: &ContactState) -> Vec<f64> {
    let mut numbers = vec![state.deflection.max, state.contact_force()];
    if scene.load().couple().is_empty() {
        numbers.extend([state.energy, state.moment.max]);
    }
    numbers.extend(state.supports.iter().map(|support| support.force));
    numbers
}

/// Second order, by each method, in means over ten grids: from one grid to the next errors go up and down with the place of lift-off
/// between two nodes.
#[test]
fn grids_approach_the_exact_solution_of_a_beam_that_changes() {
    /// From so many intervals on to a tenth less than twice as many, and the same times so many.
    const COARSE: usize = 100;
    const FINER: usize = 8;
    /// Of the logarithm of errors summed over all numbers, each over the largest of its kind.
    const ORDER: [f64; 2] = [1.85, 2.3];
    for (name, scene) in scenes() {
        let exact = solve_exactly(&scene).expect("an answer").exact.expect("functions");
        let expected = numbers(&scene, &exact.state);
        for method in Method::ALL {
            let errors = |from: usize| {
                let mut sum = 0.0;
                for intervals in (from..2 * from).step_by(from / 10) {
                    let solution = run(&scene, method, Solver::ActiveSet, intervals);
                    assert!(solution.solved && solution.residual < 1e-11, "{name}, {method}: {:e}", solution.residual);
                    let off = numbers(&scene, &solution.state).into_iter().zip(&expected);
                    sum += off.map(|(found, expected)| (found - expected).abs() / (1.0 + expected.abs())).sum::<f64>();
                }
                sum
            };
            let order = libm::log(errors(COARSE) / errors(FINER * COARSE)) / libm::log(8.0);
            assert!((ORDER[0]..=ORDER[1]).contains(&order), "{name}, {method}: {order}");
        }
    }
}

/// Steps of no height and the beam without them: the same bits. A joint of 10¹² of the beam: the same to ten digits.
#[test]
fn what_changes_nothing_changes_no_number() {
    const GROUND: &str = "[foundation]\npolynomial = [0.8, -0.08, 0.008]\n";
    let of = |beam: &str, method| {
        let scene = scene(beam, "", GROUND);
        numbers(&scene, &run(&scene, method, Solver::ActiveSet, 60).state)
    };
    for method in Method::ALL {
        let one = of("bending_stiffness = 1.3", method);
        let same = of("bending_stiffness = { steps = [[0, 1.3], [4, 1.3]] }", method);
        assert!(one.iter().zip(&same).all(|(a, b)| a.to_bits() == b.to_bits()), "{method}: {one:?} and {same:?}");
        let joined = of("bending_stiffness = 1.3\njoints = [{ at = 3.0, stiffness = 1e12 }]", method);
        for (a, b) in one.into_iter().zip(joined) {
            assert!((a - b).abs() <= 1e-10 * (1.0 + a.abs()), "{method}: {a} and {b}");
        }
    }
}

/// A fine grid loses no digits where the beam changes in contact and off it.
#[test]
fn fine_grids_of_a_beam_that_changes_are_solved() {
    for (name, scene) in scenes() {
        for method in Method::ALL {
            let solution = run(&scene, method, Solver::ActiveSet, 20_000);
            assert!(solution.solved, "{name}, {method}: {:e}, {}", solution.residual, solution.run.message);
        }
    }
}

/// A joint and a change of the stiffness between the nodes of a grid, with the least number of intervals that has both.
#[test]
fn changes_have_to_be_nodes() {
    for (beam, words) in [
        (
            "bending_stiffness = { steps = [[0, 1.3], [2.5, 2.6]] }",
            ["the change of the bending stiffness at x = 2.5", "--intervals 4"],
        ),
        (
            "bending_stiffness = 1.3\njoints = [{ at = 3.75, stiffness = 2.0 }]",
            ["the joint at x = 3.75", "--intervals 8"],
        ),
    ] {
        let scene = scene(beam, "", "[foundation]\ndepth = 1.0\n");
        let settings = palkki::Settings::new(Method::Force, Solver::ActiveSet, 30);
        let message = palkki::solve(&scene, &settings).expect_err("no node").to_string();
        assert!(words.iter().all(|word| message.contains(word)), "{message}");
    }
}
