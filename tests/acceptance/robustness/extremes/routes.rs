//! Discretised routes at the extremes: the force method with the active set is right at all of them. That no route is wrong and
//! certified is what the report is refused for, which runs them all (`report/data/extremes.csv`).

use palkki::route::{Method, Solution, Solver};
use palkki::{Settings, solve_raw};
use palkki_evidence::extremes::{Extreme, deep};

use super::all;

/// Two certified answers to one discrete problem: a residual of 1e-9 leaves six digits of a nodal force on the grid of the
/// paper ([`palkki::certificate::CERTIFIED_RESIDUAL`]), and reactions and resultants are sums of some.
const SAME: f64 = 1e-6;

fn run(extreme: &Extreme, method: Method, solver: Solver) -> Solution<()> {
    palkki::solve_raw(&extreme.scene, &Settings::new(method, solver, extreme.intervals)).expect("numbers in range")
}

/// How far two answers are apart, over the load.
fn apart(extreme: &Extreme, a: &Solution<()>, b: &Solution<()>) -> f64 {
    let pairs = [
        (a.state.reactions.left, b.state.reactions.left),
        (a.state.reactions.right, b.state.reactions.right),
        (a.state.contact_force(), b.state.contact_force()),
    ];
    let size = extreme.load().max(a.state.contact_force());
    pairs.iter().map(|(a, b)| (a - b).abs() / size).fold(0.0, |most, e| if e <= most { most } else { e })
}

#[test]
fn force_with_the_active_set_is_right_at_every_extreme() {
    let mut wrong = Vec::new();
    for extreme in all() {
        let force = run(&extreme, Method::Force, Solver::ActiveSet);
        let dual = run(&extreme, Method::Displacement, Solver::ActiveSet);
        let error = extreme.error(&force.state);
        let near = error <= extreme.allowance();
        let same = !dual.solved || apart(&extreme, &force, &dual) <= SAME;
        if !force.solved || !near || !same {
            let residual = force.residual;
            wrong.push(format!(
                "{}: {:?}, residual {residual:e}, {error:e} from the truth, same: {same}",
                extreme.name,
                force.ended()
            ));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

/// Over ground 10¹⁶ times as deep as the beam could sag, rounding alone keeps the residual above what NSOR is asked for. It
/// says so once its sweeps have come round, and does not use up a budget of millions.
#[test]
fn nsor_ends_where_its_sweeps_go_in_circles() {
    /// A sweep on one or two unknowns gains a digit or more; sixteen digits, nine factors, and as much again to come round.
    const SWEEPS: usize = 2000;
    let extreme = deep(16).expect("a depth in range");
    for intervals in [2, 3] {
        let raw = run(&Extreme { intervals, ..extreme.clone() }, Method::Displacement, Solver::Nsor);
        assert!(!raw.run.reports_success, "{intervals}: {}", raw.run.message);
        assert!(raw.run.message.ends_with("which go in circles"), "{intervals}: {}", raw.run.message);
        assert!(raw.run.iterations < SWEEPS, "{intervals}: {} sweeps", raw.run.iterations);
    }
}

/// Up to a hundred thousand intervals; the answer goes to the closed form as the square of the spacing at most.
#[test]
fn the_finest_grids_are_right() {
    for intervals in [1_000, 9_973, 100_000] {
        for extreme in [-8, -4, -2].map(|power| deep(power).expect("a depth in range")) {
            let settings = Settings::new(Method::Force, Solver::ActiveSet, intervals);
            let raw = solve_raw(&extreme.scene, &settings).expect("numbers in range");
            assert!(raw.solved, "{} on {intervals}: {:e}", extreme.name, raw.residual);
            let error = extreme.error(&raw.state);
            let expected = Extreme { intervals, ..extreme.clone() }.allowance();
            assert!(error <= expected, "{} on {intervals}: {error:e}", extreme.name);
        }
    }
}
