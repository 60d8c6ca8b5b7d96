//! Every route on finer and finer grids of the example, and how far it is from the optimum of its discrete problem.
//!
//! Sizes of rounding differ between machines in their digits, not in their powers of ten: an exponent is kept, rounded up with a
//! margin of three.

use palkki::certificate::Kkt;
use palkki::methods::Method;
use palkki::route::Status;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::ContactState;
use palkki::{Settings, solve};
use palkki_evidence::paper::example;

use super::matrix;
use crate::report::error::Cause;
use palkki_evidence::authority::given;
use palkki_evidence::authority::number::Number;

/// Grids of the table.
const GRIDS: [usize; 8] = [10, 30, 100, 300, 1000, 3000, 10_000, 100_000];

/// In the order of figures and tables: the matrix factorised on the optimal contact set, then the solvers.
pub(super) const NAMES: [&str; 6] = [MATRIX, "active-set", "four-step", "nsor", "clarabel", "osqp"];
pub(super) const MATRIX: &str = "matrix";

/// Smallest size that is told from zero.
const NOTHING: f64 = 1e-17;

/// The finest grid that a route solves in a fraction of a second; all of them together make a report of some seconds.
fn finest(method: Method, solver: Solver) -> usize {
    match (solver, method) {
        (Solver::ActiveSet, _) => 100_000,
        (Solver::FourStep, _) => 300,
        (Solver::Clarabel, _) => 3000,
        (Solver::Osqp, _) => 100,
        (Solver::Nsor, Method::Complementarity) => 100,
        (Solver::Nsor, Method::Displacement) => 30,
        (Solver::Nsor, Method::Force) => 10,
    }
}

/// All routes of a method on one grid.
#[derive(Debug)]
pub(super) struct Grid {
    pub(super) intervals: usize,
    /// Power of ten of the condition number.
    pub(super) condition: i32,
    pub(super) runs: Vec<Run>,
}

impl Grid {
    /// The run of a solver, or of the matrix.
    pub(super) fn run(&self, name: &str) -> Option<&Run> {
        self.runs.iter().find(|run| run.name == name)
    }
}

/// Powers of ten.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) name: &'static str,
    pub(super) certified: bool,
    /// The residual of our check.
    pub(super) residual: i32,
    /// End reaction, over the load.
    pub(super) reaction: i32,
    /// Worst deflection of a node, over the depth of the foundation.
    pub(super) deflection: i32,
    /// Worst contact force of a node, over the load.
    pub(super) contact_force: i32,
}

impl Run {
    /// Residual times condition number.
    pub(super) fn promised(&self, grid: &Grid) -> i32 {
        self.residual + grid.condition
    }
}

/// The power of ten that is at least three times a size.
#[expect(clippy::cast_possible_truncation, reason = "between −17 and 308")]
pub(super) fn exponent(size: f64) -> i32 {
    if size.is_finite() { (3.0 * size.max(NOTHING)).log10().ceil() as i32 } else { 0 }
}

/// The optimum of a discrete problem, computed with eighty digits and rounded to 64 bits.
struct Reference {
    contact_force: Vec<f64>,
    left_reaction: f64,
    deflection: Vec<f64>,
    touches: Vec<bool>,
}

impl Reference {
    /// Found from a guess of the contact set; none if the search does not end.
    fn of(scene: &Scene, method: Method, guess: Vec<bool>) -> Option<Self> {
        let problem = given::problem(scene, guess.len() + 1, method.bending())?;
        let (solution, touches, _) = problem.optimum(guess)?;
        Some(Self {
            contact_force: solution.contact_force[1..=touches.len()].iter().map(Number::to_double).collect(),
            left_reaction: solution.left_reaction(&problem.loads[0]).to_double(),
            deflection: (1..=touches.len()).map(|node| solution.deflection(node).to_double()).collect(),
            touches,
        })
    }
}

pub(super) fn measured(method: Method) -> Result<Vec<Grid>, Cause> {
    let scene = example()?;
    GRIDS.iter().map(|&intervals| grid(&scene, method, intervals)).collect()
}

/// All routes of a method that are quick enough on a grid.
pub(super) fn grid(scene: &Scene, method: Method, intervals: usize) -> Result<Grid, Cause> {
    let settings = |solver| Settings::new(method, solver, intervals);
    let guess = solve(scene, &settings(Solver::ActiveSet))?.state.nodes.ok_or("a discretised state has nodes")?;
    let guess: Vec<bool> = guess.contact_force.iter().map(|p| 0.0 < *p).collect();
    let reference = Reference::of(scene, method, guess).ok_or("the exchanges with eighty digits do not end")?;
    let mut runs = Vec::new();
    if let Some(state) = matrix::solved(scene, method, &reference.touches)? {
        let kkt = Kkt::of(scene, &state).ok_or("a discretised state has nodes")?;
        runs.push(run(scene, MATRIX, &state, (kkt.residual(), kkt.holds()), &reference)?);
    }
    for solver in Solver::ALL.into_iter().filter(|&solver| intervals <= finest(method, solver)) {
        let outcome = solve(scene, &settings(solver))?;
        let certified = outcome.status == Status::Certified;
        runs.push(run(scene, solver.word(), &outcome.state, (outcome.residual, certified), &reference)?);
    }
    Ok(Grid { intervals, condition: exponent(method.condition(intervals) / 3.0), runs })
}

fn run(
    scene: &Scene,
    name: &'static str,
    state: &ContactState,
    (residual, certified): (f64, bool),
    reference: &Reference,
) -> Result<Run, Cause> {
    let nodes = state.nodes.as_ref().ok_or("a discretised state has nodes")?;
    let load = scene.load().magnitude(scene.beam().length());
    let worst = |found: &[f64], expected: &[f64]| {
        let errors = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
        errors.fold(0.0, |most: f64, e| if e.is_nan() { f64::INFINITY } else { most.max(e) })
    };
    let depth = scene.depth(0.5 * scene.beam().length());
    Ok(Run {
        name,
        certified,
        residual: exponent(residual),
        reaction: exponent((state.reactions.left - reference.left_reaction).abs() / load),
        deflection: exponent(worst(&nodes.deflection, &reference.deflection) / depth),
        contact_force: exponent(worst(&nodes.contact_force, &reference.contact_force) / load),
    })
}
