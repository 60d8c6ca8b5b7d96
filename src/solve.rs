//! One way through: scene → method and grid → programme (32) → solver → state → verdict.

use crate::certificate::Kkt;
use crate::methods::{self, Discrete, Nodal};
use crate::multigrid;
use crate::route::{Method, Outcome, Solver, Status};
use crate::scene::{Scale, Scene, SceneError};
use crate::solvers::Answer;
use crate::state::{Contact, ContactState, Extremes, Nodes, Reactions};

/// What a discretised solution is asked to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Which of the paper's methods sets up the programme.
    pub method: Method,
    /// Which solver solves it.
    pub solver: Solver,
    /// Number `N` of equal intervals, at least 2.
    pub intervals: usize,
    /// Scaled KKT residual at which an iterative solver may stop. It does not loosen the verdict.
    pub tolerance: f64,
}

/// Default of [`Settings::tolerance`]: a tenth of what the judge demands.
pub const DEFAULT_TOLERANCE: f64 = 1e-10;

impl Settings {
    /// A route on a grid, with the default tolerance.
    #[must_use]
    pub fn new(method: Method, solver: Solver, intervals: usize) -> Self {
        Self { method, solver, intervals, tolerance: DEFAULT_TOLERANCE }
    }
}

/// Solves `scene` by one route.
///
/// A scene without a foundation needs no programme and no solver: the beam is a simple beam.
///
/// # Errors
///
/// A [`SceneError`] if the grid is too coarse or the scene leaves the range of `f64`. A solver that fails is no error:
/// its answer comes back with a [`Status`] that says so.
pub fn solve(scene: &Scene, settings: &Settings) -> Result<Outcome, SceneError> {
    let Settings { method, solver, intervals, tolerance } = *settings;
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, intervals)?;

    let (nodal, claims_success, words, own_residual, unknowns, iterations, work) = if scene.foundation().is_none() {
        (
            methods::free_beam(&discrete, method.bending()),
            true,
            "no foundation, nothing to solve".to_owned(),
            None,
            0,
            0,
            0,
        )
    } else {
        let programme = method.programme(&discrete);
        let answer = match solver {
            Solver::ActiveSet => multigrid::solve(&scaled.scene, method, &discrete)?,
            Solver::FourStep | Solver::Nsor | Solver::Clarabel | Solver::Osqp => {
                solver.run(programme.as_ref(), tolerance)
            }
        };
        let Answer { x, gradient, claims_success, words, own_residual, iterations, work } = answer;
        let nodal = match solver {
            // Contact forces and clearances, by all methods.
            Solver::ActiveSet => Nodal::new(&discrete, method.bending(), gradient, x),
            Solver::FourStep | Solver::Nsor | Solver::Clarabel | Solver::Osqp => method.nodal(&discrete, x, gradient),
        };
        (nodal, claims_success, words, own_residual, programme.dimension(), iterations, work)
    };
    let state = methods::contact_state(discrete, nodal);

    let verdict = Kkt::of(&scaled.scene, &state);
    let state = state.in_units_of(&scaled.scale);
    let status = match verdict {
        Some(kkt) if kkt.holds() && state.is_finite() => Status::Certified,
        _ if claims_success => Status::NotCertified,
        _ => Status::NotConverged,
    };
    Ok(Outcome {
        state,
        status,
        solver_status: words,
        solver_claims_success: claims_success,
        own_residual,
        residual: verdict.map_or(f64::INFINITY, |kkt| kkt.residual()),
        unknowns,
        iterations,
        work,
    })
}

impl ContactState {
    /// A dimensionless state in the units of its scene. All factors are powers of two: only exponents change.
    #[must_use]
    pub fn in_units_of(self, scale: &Scale) -> Self {
        let Scale { length, depth, force } = *scale;
        // A unit of one is frequent, and a million products are not free.
        let times = |values: Vec<f64>, unit: f64| match unit {
            1.0 => values,
            _ => values.into_iter().map(|v| v * unit).collect(),
        };
        let extremes = |e: Extremes, unit: f64| Extremes {
            max: e.max * unit,
            max_at: e.max_at * length,
            min: e.min * unit,
            min_at: e.min_at * length,
        };
        let contact = |c: Contact| Contact {
            from: c.from * length,
            to: c.to * length,
            force: c.force * force,
            end_forces: c.end_forces.map(|ends| ends.map(|f| f * force)),
        };
        Self {
            regime: self.regime,
            reactions: Reactions { left: self.reactions.left * force, right: self.reactions.right * force },
            contacts: self.contacts.into_iter().map(contact).collect(),
            deflection: extremes(self.deflection, depth),
            moment: extremes(self.moment, scale.moment()),
            energy: self.energy * scale.energy(),
            nodes: self.nodes.map(|nodes| Nodes {
                bending: nodes.bending,
                x: times(nodes.x, length),
                deflection: times(nodes.deflection, depth),
                clearance: times(nodes.clearance, depth),
                contact_force: times(nodes.contact_force, force),
                moment: times(nodes.moment, scale.moment()),
            }),
        }
    }
}
