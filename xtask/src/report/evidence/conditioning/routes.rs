//! Every route on finer and finer grids of the example, and the matrix of each method itself: how far they are from the optimum
//! of their discrete problem.
//!
//! Sizes of rounding differ between machines in their digits, not in their powers of ten: an exponent is kept, rounded up with a
//! margin of three.

use palkki::certificate::Kkt;
use palkki::methods::{Discrete, contact_state};
use palkki::qp::{Band, Dense, FreeSet, Matrix, Qp, Row};
use palkki::state::ContactState;
use palkki_evidence::paper::example;

use crate::report::evidence::prelude::*;
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
        let problem = given::problem(scene, guess.len() + 1, method.discretisation())?;
        let (solution, touches, _) = problem.optimum(guess)?;
        Some(Self {
            contact_force: solution.contact_force[1..=touches.len()].iter().map(Number::to_double).collect(),
            left_reaction: solution.left_reaction(&problem.loads[0]).to_double(),
            deflection: (1..=touches.len()).map(|node| solution.deflection(node).to_double()).collect(),
            touches,
        })
    }

    /// How far an answer is from it, with its residual and whether it passes our check.
    fn beside(
        &self,
        scene: &Scene,
        name: &'static str,
        state: &ContactState,
        check: (f64, bool),
    ) -> Result<Run, Cause> {
        let (nodes, load) = (nodes_of(state)?, load(scene));
        let depth = scene.depth(0.5 * scene.beam().length());
        Ok(Run {
            name,
            certified: check.1,
            residual: exponent(check.0),
            reaction: exponent((state.reactions.left - self.left_reaction).abs() / load),
            deflection: exponent(worst_difference(&nodes.deflection, &self.deflection) / depth),
            contact_force: exponent(worst_difference(&nodes.contact_force, &self.contact_force) / load),
        })
    }
}

pub(super) fn measured(method: Method) -> Result<Vec<Grid>, Cause> {
    let scene = example()?;
    GRIDS.iter().map(|&intervals| grid(&scene, method, intervals)).collect()
}

/// All routes of a method that are quick enough on a grid.
pub(super) fn grid(scene: &Scene, method: Method, intervals: usize) -> Result<Grid, Cause> {
    let guess = on_grid(scene, method, Solver::ActiveSet, intervals)?.state;
    let guess: Vec<bool> = nodes_of(&guess)?.contact_force.iter().map(|p| 0.0 < *p).collect();
    let reference = Reference::of(scene, method, guess).ok_or("the exchanges with eighty digits do not end")?;
    let mut runs = Vec::new();
    if let Some(state) = solved_by_matrix(scene, method, &reference.touches)? {
        let kkt = Kkt::of(scene, &state).ok_or("a discretised state has nodes")?;
        runs.push(reference.beside(scene, MATRIX, &state, (kkt.residual(), kkt.holds()))?);
    }
    for solver in Solver::ALL.into_iter().filter(|&solver| intervals <= finest(method, solver)) {
        let outcome = on_grid(scene, method, solver, intervals)?;
        let certified = outcome.solved;
        runs.push(reference.beside(scene, solver.name(), &outcome.state, (outcome.residual, certified))?);
    }
    Ok(Grid { intervals, condition: exponent(method.condition(intervals) / 3.0), runs })
}

/// Finest grid for a matrix that is full.
const FULL: usize = 300;

/// The answer of the matrix itself, `A`, `K` or `C` factorised on the optimal contact set, with contact forces from (33); none where it is too large, or where rounding has destroyed its definiteness.
fn solved_by_matrix(scene: &Scene, method: Method, touches: &[bool]) -> Result<Option<ContactState>, Cause> {
    let intervals = touches.len() + 1;
    if method != Method::Complementarity && FULL < intervals {
        return Ok(None);
    }
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let qp = method.qp(&discrete);
    let free: FreeSet = touches.iter().map(|&touches| touches == method.is_free_in_contact()).collect();
    let point = match qp.matrix() {
        Matrix::Dense(matrix) => {
            let dense = Dense { matrix, linear: qp.linear().into(), sizes: qp.sizes() };
            dense.stationary(&free).ok().map(|point| (point.x, point.gradient))
        }
        banded @ Matrix::Pentadiagonal(_) => on_band(qp.as_ref(), &banded, &free).map(|x| {
            let gradient = qp.gradient(&x);
            (x, gradient)
        }),
    };
    Ok(point.map(|(x, gradient)| {
        contact_state(discrete.clone(), method.nodal(&discrete, x, gradient)).in_units_of(&scaled.scale)
    }))
}

/// `A_ff x_f = b_f` by a banded factorisation.
fn on_band(qp: &dyn Qp, matrix: &Matrix, free: &FreeSet) -> Option<Vec<f64>> {
    let chosen: Vec<usize> = free.variables().collect();
    let linear = qp.linear();
    let mut equations = Band::with_capacity(chosen.len());
    for (k, &i) in chosen.iter().enumerate() {
        let above = [k + 1, k + 2].map(|l| chosen.get(l).map_or(0.0, |&j| matrix.entry(i, j)));
        equations.push(Row { diagonal: matrix.entry(i, i), above, right: linear[i] }).ok()?;
    }
    let mut x = vec![0.0; free.dimension()];
    chosen.iter().zip(equations.solve()).for_each(|(&i, value)| x[i] = value);
    Some(x)
}
