//! Exact rationals: the discrete problem solved and its optimality conditions checked without rounding.
//!
//! The data of the paper are rational, and so is the answer. A contact set comes from the solver that is tested; on it the
//! linear equations are solved by elimination in rationals, and all of (34), (35) is checked exactly. If that holds, the
//! exact answer is *the* optimum, whoever proposed the set, and floating-point answers are compared with it.

mod large;

use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::state::Nodes;

use crate::scenes::{example, nodes, run};
use palkki_evidence::authority::rational::{Data, Exact, fraction, number};

/// The example of the paper on 30 intervals: `EI = 500/384 = 125/96`.
fn paper() -> Data {
    Data {
        length: fraction(10, 1),
        stiffness: fraction(125, 96),
        loads: vec![fraction(1, 3); 29],
        depths: vec![fraction(1, 1); 29],
    }
}

/// The exact answer on the contact set that the active set found.
#[track_caller]
fn exact(data: &Data, scene: &Scene, method: Method) -> (Exact, Nodes) {
    let raw = run(scene, method, Solver::ActiveSet, data.loads.len() + 1);
    assert!(raw.solved, "{method}");
    let nodes = nodes(&raw).clone();
    let contact: Vec<bool> = nodes.contact_force.iter().map(|p| 0.0 < *p).collect();
    let exact = if method == Method::Complementarity { data.differences(&contact) } else { data.energy(&contact) };
    assert_eq!(exact.violation(&contact), None, "the node at which (34), (35) fail");
    (exact, nodes)
}

/// Half a unit of the ninth decimal, with which the numbers below are written out.
const PRINTED: f64 = 5e-10;

/// The index of the first node in contact.
#[track_caller]
fn first(exact: &Exact) -> usize {
    exact.contact_force.iter().position(|p| 0.0 < number(p)).expect("the example touches")
}

#[test]
fn the_first_contact_force_of_the_paper_is_a_fraction() {
    let (exact, _) = exact(&paper(), &example(), Method::Force);
    let node = first(&exact);
    assert_eq!(node + 1, 7, "node 7, x = 7/3");
    assert_eq!(exact.contact_force[node], fraction(79_510_997, 69_626_256));
    // Nine decimals are asked for, and two are printed: 1,14.
    assert!((number(&exact.contact_force[node]) - 1.141_968_584).abs() < PRINTED);
}

#[test]
fn the_end_reaction_of_the_paper_grid_is_a_fraction() {
    let data = paper();
    let (exact, nodes) = exact(&data, &example(), Method::Force);
    // By the lever, with the load of half an interval on the support itself: q₀Δ/2 = 1/6.
    let reaction = data.left_reaction(&exact) + fraction(1, 6);
    let value = number(&reaction);
    assert!((value - 1.186_044_111).abs() < PRINTED, "{value}");
    // The rest of the balance, exactly: twice the reaction and the contact forces carry q₀ l = 10.
    let carried = exact.contact_force.iter().fold(fraction(0, 1), |sum, p| sum + p);
    assert_eq!(&reaction + &reaction + carried, fraction(10, 1));

    let found = run(&example(), Method::Force, Solver::ActiveSet, nodes.x.len() + 1).state.reactions;
    assert!((found.left - value).abs() < ROUNDING * value, "{}", found.left);
}

#[test]
fn the_first_contact_force_by_differences_is_what_is_asked() {
    let (exact, _) = exact(&paper(), &example(), Method::Complementarity);
    let node = first(&exact);
    assert_eq!(node + 1, 7);
    assert!((number(&exact.contact_force[node]) - 1.191_071_429).abs() < PRINTED);
}

/// A few hundred units in the last place: sums over some hundred nodes, and one tridiagonal solve of condition number below ten.
const ROUNDING: f64 = 1e-13;

/// What is asked of each solver on the example: a tolerance, or a status that is not certified.
fn asked(solver: Solver) -> f64 {
    match solver {
        Solver::ActiveSet | Solver::FourStep => 1e-8,
        Solver::Clarabel => 1e-5,
        Solver::Osqp | Solver::Nsor => 1e-3,
    }
}

#[test]
fn every_route_finds_the_first_contact_force_or_says_that_it_does_not() {
    let mut certified = 0;
    for method in Method::ALL {
        let (exact, _) = exact(&paper(), &example(), method);
        let node = first(&exact);
        let reference = number(&exact.contact_force[node]);
        for solver in Solver::ALL {
            let raw = run(&example(), method, solver, 30);
            let force = nodes(&raw).contact_force[node];
            let error = (force - reference).abs();
            if raw.solved {
                certified += 1;
                assert!(error <= asked(solver), "{method} {solver}: {force}, off by {error:.1e}");
            } else {
                assert_ne!(solver, Solver::ActiveSet, "{method}: the active set is never without an answer");
            }
        }
    }
    // Four-step and active set on three methods at least, and the libraries where the conditioning lets them.
    assert!(6 <= certified, "{certified} routes are certified");
}
