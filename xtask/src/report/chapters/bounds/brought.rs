//! Forces that somebody brought: springs, libraries, the paper. What `palkki certify` says about them.

use nalgebra::{DMatrix, DVector};
use palkki::certificate::bounds::{Violation, ViolationKind, violations};
use palkki::certificate::{ACCEPTED_ERROR, ContactLoad, Judged, certify};
use palkki::methods::{Discrete, Method};
use palkki::paper::{example, figure_4, figure_7, theory};
use palkki::problem::Dense;
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
/// Unknowns of the dense displacement form that a library is given, and the tolerance it is asked for: it becomes a gap and a
/// feasibility of 10⁻⁸, the default of the library.
const DENSE: usize = 400;
const DEFAULT_OF_THE_LIBRARY: f64 = 1e-3;
/// A run of the other library, stopped early: intervals and absolute residual.
const EARLY: (usize, f64) = (256, 1e-3);

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

/// Libraries at a setting at which they say that they solved the problem.
pub(super) fn of_libraries(study: &Study<'_>) -> Result<Vec<Row>, Cause> {
    let scene = example()?;
    let (says, forces) = dense_displacement(&scene)?;
    let who = format!("clarabel, dense displacement form, {} intervals", DENSE + 1);
    let dense = judged(&scene, who, &says, forces, true)?;

    let wave = scenes::read(study.root, "wave")?;
    let (intervals, tolerance) = EARLY;
    let settings = Settings { tolerance, ..Settings::new(Method::Force, Solver::Osqp, intervals) };
    let outcome = solve(&wave, &settings)?;
    let forces = of_nodes(&outcome.state.nodes.unwrap_or_default());
    let who = format!("osqp, force method, {intervals} intervals, loose settings, cosine wave");
    let early = judged(&wave, who, &outcome.solver_status, forces, false)?;
    Ok(vec![dense, early])
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

/// The displacement method with its matrix written out, as the library gets it from whoever has no better form; its own word,
/// and the contact forces, which are the multipliers.
fn dense_displacement(scene: &Scene) -> Result<(String, Vec<(f64, f64)>), Cause> {
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, DENSE + 1)?;
    let programme = Method::Displacement.programme(&discrete);
    let matrix = programme.matrix();
    let dense = Dense {
        matrix: DMatrix::from_fn(DENSE, DENSE, |i, j| matrix.entry(i, j)),
        linear: DVector::from_vec(programme.linear()),
        sizes: programme.sizes(),
    };
    let answer = Solver::Clarabel.run(&dense, DEFAULT_OF_THE_LIBRARY);
    let scale = &scaled.scale;
    let place = |i: usize| discrete.grid.place(i + 1) * scale.length;
    let forces = answer.gradient.iter().enumerate().map(|(i, force)| (place(i), force * scale.force));
    Ok((answer.words, forces.collect()))
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
