//! Solves a scene and adds the verdict: with a method and a solver on a grid ([`solve`]), or by beam theory ([`solve_exactly`]).
//!
//! ```text
//! scene → Discrete → quadratic program (32) → solver → Nodal → ContactState → Solution<()> → Solution
//! scene → Discrete → nested grids, active set        → Nodal → ContactState → Solution<()> → Solution     the default solver
//! scene → Exact                                                                          → Solution
//! ```

use std::mem::take;

use crate::certificate::{CERTIFIED_RESIDUAL, Kkt};
use crate::methods::{self, Discrete, Nodal};
use crate::multigrid;
use crate::route::{Method, Solution, Solver};
use crate::scene::{Scene, SceneError};
use crate::solvers::{Answer, Run};
use crate::state::Standing;
use crate::theory::{self, Exact, TheoryError};
use crate::verdict::{Demand, Verdict};
use crate::witness::Witness;

/// A route (a method and a solver) and its grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// The method of the paper that sets up the quadratic program.
    pub method: Method,
    /// The solver of the quadratic program.
    pub solver: Solver,
    /// Number `N` of equal intervals, at least 2.
    pub intervals: usize,
    /// Scaled KKT residual at which an iterative solver may stop. It has no effect on the limits of the verdict.
    pub tolerance: f64,
}

/// Default of [`Settings::tolerance`]: a tenth of the residual that our check allows.
pub const DEFAULT_TOLERANCE: f64 = 1e-10;

impl Settings {
    /// A route on a grid, with the default tolerance.
    #[must_use]
    pub fn new(method: Method, solver: Solver, intervals: usize) -> Self {
        Self { method, solver, intervals, tolerance: DEFAULT_TOLERANCE }
    }
}

/// Solves `scene` by one route and checks the answer.
///
/// ```
/// use palkki::route::{Method, Solver, Status};
/// use palkki::scene::{Beam, Foundation, Load, Scene};
/// use palkki::{Settings, solve};
///
/// let beam = Beam::new(10.0, 500.0 / 384.0)?;
/// let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
/// for method in Method::ALL {
///     let solution = solve(&scene, &Settings::new(method, Solver::ActiveSet, 30))?;
///     assert_eq!(solution.verdict.status, Status::Certified, "{method}: {:?}", solution.verdict.refusal);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// Those of [`solve_raw`]. An answer that fails our check is not an error: its [`Verdict`] contains the reason.
pub fn solve(scene: &Scene, settings: &Settings) -> Result<Solution, SceneError> {
    let witness = Witness::of(scene);
    Ok(solve_raw_near(&witness, settings)?.judged(&witness, &Demand::default()))
}

/// Solves `scene` by beam theory, without a grid, and checks the answer. The lift-off positions are unknowns.
///
/// ```
/// use palkki::scene::{Beam, Foundation, Load, Scene};
/// use palkki::solve_exactly;
///
/// let beam = Beam::new(10.0, 500.0 / 384.0)?;
/// let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
/// let solution = solve_exactly(&scene)?;
/// // On a flat foundation the beam lifts off at a = ⁴√(24 EI u / q), here 2.364 from the support, with a concentrated force q a / 2.
/// let a = (24.0_f64 * 500.0 / 384.0).sqrt().sqrt();
/// let zone = solution.state.contacts[0];
/// assert!((zone.from - a).abs() < 1e-9 && (a - 2.364_354).abs() < 1e-6);
/// assert!(zone.end_forces.is_some_and(|[left, _]| (left - 0.5 * zone.from).abs() < 1e-9));
/// // The answer as functions of x.
/// let exact = solution.exact.expect("beam theory has functions");
/// assert!((exact.deflection(5.0) - 1.0).abs() < 1e-12, "it lies on the ground");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// Those of [`theory::solve`].
pub fn solve_exactly(scene: &Scene) -> Result<Solution, TheoryError> {
    Ok(theory::solve(scene)?.judged(scene, &Demand::default()))
}

impl Solution<()> {
    /// Adds the verdict to an answer on a grid. One candidate contact list is enough for all answers of a scene.
    #[must_use]
    pub fn judged(self, witness: &Witness<'_>, demand: &Demand) -> Solution {
        let verdict = Verdict::of_raw(&self, witness, demand);
        let Self { state, verdict: (), solved, run, residual, unknowns, exact } = self;
        Solution { state, verdict, solved, run, residual, unknowns, exact }
    }
}

impl Exact {
    /// Adds the verdict.
    #[must_use]
    pub fn judged(self, scene: &Scene, demand: &Demand) -> Solution {
        let message = self.message();
        Solution {
            state: self.state.clone(),
            verdict: Verdict::of_exact(scene, &self, demand),
            solved: self.solved,
            run: Run { reports_success: self.converged, message, iterations: self.iterations, ..Run::default() },
            residual: self.residual,
            unknowns: self.unknowns,
            exact: Some(Box::new(self)),
        }
    }

    /// The message of beam theory about its answer.
    fn message(&self) -> String {
        let lists = match self.lists {
            solves if self.state.pressure.is_some() => format!("{solves} linear problems solved"),
            1 => "1 list of contacts tried".to_owned(),
            lists => format!("{lists} lists of contacts tried"),
        };
        if self.solved {
            return format!("all conditions hold everywhere, {lists}");
        }
        let violations: Vec<String> = self.violations.iter().map(ToString::to_string).collect();
        if violations.is_empty() { lists } else { format!("{}; {lists}", violations.join("; ")) }
    }
}

/// Solves `scene` by one route without checking the answer.
///
/// A scene without an obstacle needs neither a quadratic program nor a solver.
///
/// # Errors
///
/// A [`SceneError`] if the grid has too few intervals or no node at a support, joint or step of the bending stiffness; if nothing
/// balances the loads; if the beam buckles; or if numbers exceed the range of `f64`. A solver failure is not an error:
/// [`Solution::solved`] is then false.
pub fn solve_raw(scene: &Scene, settings: &Settings) -> Result<Solution<()>, SceneError> {
    by_route(scene, settings, Start::Anywhere)
}

/// Solves a scene that has a candidate contact list, like [`solve_raw`]. If a survey has points between the nodes of coarser
/// grids, the active set starts from the contacts of beam theory, and the solver message says so. They are far nearer to the
/// solution and cost nothing extra, because the certificate also needs them.
///
/// # Errors
///
/// Those of [`solve_raw`].
pub fn solve_raw_near(witness: &Witness<'_>, settings: &Settings) -> Result<Solution<()>, SceneError> {
    by_route(witness.scene(), settings, Start::Near(witness))
}

/// An answer without numbers, for a route that is omitted from a comparison: the solver is not run. `why` replaces the solver
/// message.
///
/// # Errors
///
/// Those of [`solve_raw`].
pub fn left_out(scene: &Scene, settings: &Settings, why: String) -> Result<Solution<()>, SceneError> {
    by_route(scene, settings, Start::LeftOut(why))
}

/// The start of a route.
enum Start<'a> {
    Anywhere,
    /// From the contacts of the candidate list, where they are better than those of coarser grids.
    Near(&'a Witness<'a>),
    /// The route is omitted, for this reason.
    LeftOut(String),
}

fn by_route(scene: &Scene, settings: &Settings, start: Start<'_>) -> Result<Solution<()>, SceneError> {
    let Settings { method, solver, intervals, tolerance } = *settings;
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, intervals).map_err(|error| error.in_units_of(&scaled.scale))?;
    let discretisation = method.discretisation();
    discrete.check_compression(discretisation).map_err(|error| error.in_units_of(&scaled.scale))?;
    let (mut nodal, answer, unknowns) = if !scene.has_obstacle() {
        (methods::free_beam(&discrete, discretisation), Answer::empty("no foundation, nothing to solve".to_owned()), 0)
    } else {
        // Nested grids work with contact forces and without the program, whatever the method. They support only obstacles at
        // nodes: without a foundation there are few positions of contact, of which coarser grids have none.
        let at_nodes = !discrete.has_open_nodes() && discrete.supports().stops().is_empty();
        let nested = solver == Solver::ActiveSet && at_nodes;
        let alone = discrete.unknowns() < discrete.supports().lacking();
        let program = method.qp(&discrete);
        let mut answer = match (start, solver) {
            (Start::LeftOut(why), _) => Answer::refused(program.dimension(), why),
            // A single position of contact: it carries the beam if the loads are balanced there.
            _ if alone => Answer { x: vec![0.0], gradient: vec![0.0], ..Answer::empty("nothing to solve".to_owned()) },
            (Start::Near(witness), Solver::ActiveSet) if nested => near(witness, &scaled.scene, method, &discrete)?,
            (Start::Anywhere, Solver::ActiveSet) if nested => multigrid::solve(&scaled.scene, method, &discrete, None)?,
            (_, other) => other.run(program.as_ref(), tolerance),
        };
        let (x, gradient) = (take(&mut answer.x), take(&mut answer.gradient));
        let nodal = if alone {
            Nodal::resting(&discrete, discretisation)
        } else if nested {
            // All methods return contact forces and clearances.
            Nodal::new(&discrete, discretisation, gradient, x)
        } else {
            method.nodal(&discrete, x, gradient)
        };
        (nodal, answer, program.dimension())
    };
    // A beam balanced on one position may have many positions of equilibrium: take the one with the slope nearest to zero.
    let mut motion = None;
    if let Some(node) = methods::single_contact(&discrete, &scaled.balance, &nodal)
        && let Some((nearest, free)) = methods::balanced(&discrete, discretisation, node)
    {
        (nodal, motion) = (nearest, free);
    }
    let mut state = methods::contact_state(discrete, nodal);
    state.standing = scaled.balance.resultant().map(|resultant| Standing::of(&state, resultant, motion));

    let residual = Kkt::of(&scaled.scene, &state).map_or(f64::INFINITY, |kkt| kkt.residual());
    let state = state.in_units_of(&scaled.scale);
    let solved = residual <= CERTIFIED_RESIDUAL && state.is_finite();
    Ok(Solution { state, verdict: (), solved, run: answer.run, residual, unknowns, exact: None })
}

/// Runs the active set, starting from the contacts of the candidate list if they are a useful start.
fn near(witness: &Witness<'_>, scaled: &Scene, method: Method, discrete: &Discrete) -> Result<Answer, SceneError> {
    let length = witness.scene().beam().length();
    let contacts = multigrid::coarser(discrete.intervals).and_then(|coarse| witness.start(discrete.intervals, coarse));
    let free = contacts.map(|contacts| multigrid::nearest(discrete, contacts, length));
    let known = free.is_some();
    let mut answer = multigrid::solve(scaled, method, discrete, free)?;
    if known {
        answer.run.message.push_str(", from the contacts of beam theory");
    }
    Ok(answer)
}
