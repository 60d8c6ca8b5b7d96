//! Forces that somebody brought: springs, libraries, the paper. What `palkki certify` says about them.

use palkki::certificate::bounds::{Violation, ViolationKind, violations};
use palkki::certificate::{ACCEPTED_ERROR, ContactLoad, Judged, certify};
use palkki::methods::Method;
use palkki::paper::{example, figure_4, figure_7, theory};
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki::{Settings, solve};
use serde::Serialize;

use super::springs;
use crate::report::error::Cause;
use crate::report::numbers::power;
use crate::report::scenes;
use crate::report::study::Study;

/// Intervals between springs.
pub(super) const SPACED: usize = 60;
/// Stiffness of a spring over that of the beam, powers of ten.
const STIFFNESSES: [i32; 7] = [0, 1, 2, 3, 4, 6, 8];
/// Runs of libraries that were stopped early: method, solver, tolerance. For clarabel it becomes a gap of 10⁻⁷.
const EARLY: [(Method, Solver, f64); 2] =
    [(Method::Displacement, Solver::Clarabel, 1e-2), (Method::Force, Solver::Osqp, 1e-3)];
/// Their intervals.
const EARLY_INTERVALS: usize = 256;

/// What is said about some forces.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Row {
    /// Whose they are.
    pub(super) who: String,
    /// What that program says of itself.
    pub(super) says: String,
    /// End reaction against beam theory, as a share; none where the scene is not the example.
    pub(super) reaction: Option<f64>,
    /// Guaranteed error of the deflection over its largest value; none if nothing could be shown.
    pub(super) certified: Option<f64>,
    /// Whether `palkki certify` accepts them.
    pub(super) accepted: bool,
    /// What is violated worst, in words.
    pub(super) condition: &'static str,
    /// As a share.
    pub(super) relative: f64,
    /// Where.
    pub(super) at: f64,
}

/// Springs of several stiffnesses: the power of ten of each, and what is said of its forces.
pub(super) fn of_springs() -> Result<Vec<(i32, Row)>, Cause> {
    let scene = example()?;
    let row = |&exponent: &i32| {
        let forces = springs::forces(&scene, SPACED, 10_f64.powi(exponent))?;
        let who = format!("springs, {} × the beam", power(exponent));
        Ok((exponent, judged(&scene, who, "equilibrium", forces, true)?))
    };
    STIFFNESSES.iter().map(row).collect()
}

/// Libraries at a setting at which they say that they solved the problem, on the cosine wave.
pub(super) fn of_libraries(study: &Study<'_>) -> Result<Vec<Row>, Cause> {
    let wave = scenes::read(study.root, "wave")?;
    let row = |&(method, solver, tolerance): &(Method, Solver, f64)| {
        let settings = Settings { tolerance, ..Settings::new(method, solver, EARLY_INTERVALS) };
        let outcome = solve(&wave, &settings)?;
        let forces = of_nodes(&outcome.state.nodes.unwrap_or_default());
        let who = format!("{solver}, {method} method, {EARLY_INTERVALS} intervals, cosine wave");
        judged(&wave, who, &outcome.solver_status, forces, false)
    };
    EARLY.iter().map(row).collect()
}

/// The paper's own.
pub(super) fn of_the_paper() -> Result<Vec<Row>, Cause> {
    let scene = example()?;
    let differences = of_nodes(&figure_4()?.nodes);
    let energy = of_nodes(&figure_7()?.nodes);
    Ok(vec![
        judged(&scene, "the paper's Figure 4, finite differences".to_owned(), "–", differences, true)?,
        judged(&scene, "the paper's Figure 7, force method".to_owned(), "–", energy, true)?,
    ])
}

fn of_nodes(nodes: &Nodes) -> Vec<(f64, f64)> {
    nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect()
}

/// What `palkki certify` says. For the example, which is symmetrical, the end reaction is half of what the forces leave.
fn judged(scene: &Scene, who: String, says: &str, forces: Vec<(f64, f64)>, is_example: bool) -> Result<Row, Cause> {
    let length = scene.beam().length();
    let reaction = is_example.then(|| {
        let carried: f64 = forces.iter().map(|f| f.1).sum();
        (0.5 * (scene.load().resultant(length) - carried) / theory().reaction - 1.0).abs()
    });
    let load = ContactLoad::new(length, forces)?;
    let certificate = certify(scene, &load, Judged::Caused)?;
    let share = certificate.deflection_error / certificate.deflection;
    let worst = violations(scene, &load)?.into_iter().next();
    Ok(Row {
        who,
        says: says.to_owned(),
        reaction,
        certified: share.is_finite().then_some(share),
        accepted: share <= ACCEPTED_ERROR,
        condition: worst.map_or("none", words),
        relative: worst.map_or(0.0, |v| v.relative),
        at: worst.map_or(0.0, |v| v.at),
    })
}

fn words(violation: Violation) -> &'static str {
    match violation.kind {
        ViolationKind::Tension => "a force pulls",
        ViolationKind::Penetration => "the beam is in the foundation",
        ViolationKind::Complementarity => "a force acts across a clearance",
    }
}
