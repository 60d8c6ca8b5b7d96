//! Benchmarks: every method with every solver on the example with 30, 100 and 300 intervals, and beam theory.

use std::fmt;

use divan::Bencher;
use palkki::paper::{example, theory};
use palkki::route::{Method, Solver};
use palkki::{Settings, solve};

fn main() {
    divan::main();
}

/// Interior nodes `n`: 29, 99, 299.
const INTERIOR: [usize; 3] = [29, 99, 299];

/// A method and a solver, as a row of the table.
#[derive(Debug, Clone, Copy)]
struct Route(Method, Solver);

impl fmt::Display for Route {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} by {}", self.0, self.1)
    }
}

/// Every method with the solvers that pass.
fn routes(chosen: impl Fn(Solver) -> bool) -> Vec<Route> {
    let all = Method::ALL.into_iter().flat_map(|method| Solver::ALL.map(|solver| Route(method, solver)));
    all.filter(|route| chosen(route.1)).collect()
}

/// Solvers that stop at an iteration limit after seconds: a few samples say enough.
fn slow(solver: Solver) -> bool {
    matches!(solver, Solver::Nsor | Solver::Osqp)
}

fn measure<const N: usize>(bencher: Bencher<'_, '_>, Route(method, solver): Route) {
    let scene = example().expect("the example is well posed");
    let settings = Settings::new(method, solver, N + 1);
    bencher.bench(|| solve(divan::black_box(&scene), &settings));
}

#[divan::bench(args = routes(|solver| !slow(solver)), consts = INTERIOR, sample_count = 20, max_time = 1)]
fn direct<const N: usize>(bencher: Bencher<'_, '_>, route: Route) {
    measure::<N>(bencher, route);
}

#[divan::bench(args = routes(slow), consts = INTERIOR, sample_count = 2, sample_size = 1)]
fn iterative<const N: usize>(bencher: Bencher<'_, '_>, route: Route) {
    measure::<N>(bencher, route);
}

#[divan::bench]
fn beam_theory() -> palkki::theory::FlatSolution {
    theory()
}
