//! Benchmarks: every method with every solver on the example with 30, 100 and 300 intervals, the active set on a million, and
//! beam theory on the example and on random scenes, with its unknowns and Newton steps beside the time.

use std::fmt;

use divan::Bencher;
use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::{Settings, solve_raw};
use palkki_evidence::paper::{example, theory};
use palkki_evidence::random;

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
    bencher.bench(|| solve_raw(divan::black_box(&scene), &settings));
}

#[divan::bench(args = routes(|solver| !slow(solver)), consts = INTERIOR, sample_count = 20, max_time = 1)]
fn direct<const N: usize>(bencher: Bencher<'_, '_>, route: Route) {
    measure::<N>(bencher, route);
}

#[divan::bench(args = routes(slow), consts = INTERIOR, sample_count = 2, sample_size = 1)]
fn iterative<const N: usize>(bencher: Bencher<'_, '_>, route: Route) {
    measure::<N>(bencher, route);
}

/// The paper's example, and dense contact: surveys of so many segments under so much load.
#[divan::bench(args = Method::ALL, consts = [0, 1000, 30_000, 100_000], sample_count = 3, sample_size = 1)]
fn a_million_intervals<const SEGMENTS: u32>(bencher: Bencher<'_, '_>, method: Method) {
    let example = example().expect("the example is well posed");
    let scene = if SEGMENTS == 0 { example } else { random::smooth(SEGMENTS, 1e4, 1) };
    bencher.bench(|| solve_raw(divan::black_box(&scene), &Settings::new(method, Solver::ActiveSet, 1_000_000)));
}

#[divan::bench]
fn beam_theory_in_closed_form() -> palkki_evidence::closed::FlatSolution {
    theory()
}

/// A scene with what beam theory needs for it, as a row of the table.
#[derive(Debug, Clone)]
struct Solved(Scene, String);

impl fmt::Display for Solved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.1)
    }
}

impl Solved {
    fn new(scene: Scene) -> Self {
        let exact = palkki::theory::solve(&scene).expect("the scene is well posed");
        let words = format!("{}: {} unknowns, {} steps", scene.title(), exact.unknowns, exact.iterations);
        Self(scene, words)
    }
}

/// The example, and of 101 random scenes those that take the least, the median and the most Newton steps.
fn scenes() -> Vec<Solved> {
    let example = example().expect("the example is well posed").labelled("the example", Default::default());
    let mut random: Vec<Scene> = (0..101).map(random::scene).collect();
    random.sort_by_key(|scene| palkki::theory::solve(scene).map_or(0, |exact| exact.iterations * (1 + exact.unknowns)));
    let chosen = [0, 50, 100].map(|i| random[i].clone());
    std::iter::once(example).chain(chosen).map(Solved::new).collect()
}

#[divan::bench(args = scenes())]
fn beam_theory(bencher: Bencher<'_, '_>, scene: &Solved) {
    bencher.bench(|| palkki::theory::solve(divan::black_box(&scene.0)));
}

/// The whole series of 101 random scenes: the mean is a hundredth of it.
#[divan::bench(sample_count = 10)]
fn beam_theory_on_101_random_scenes(bencher: Bencher<'_, '_>) {
    let scenes: Vec<Scene> = (0..101).map(random::scene).collect();
    bencher.bench(|| scenes.iter().filter(|scene| palkki::theory::solve(divan::black_box(scene)).is_ok()).count());
}
