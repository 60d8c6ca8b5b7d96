//! Figures 4, 7 and 8: numbers, not pictures. What is drawn of them is the business of [`palkki::plot`].

// Discrepancy: lost-figures
//
// All drawings are lost, and the captions of Figures 7 and 8. We draw the contact forces in Figure 7 and the deflection in Figure 8.

// Discrepancy: figure-4-intervals
//
// Figure 4 is labelled n = 30; in the text n = 29 means 30 intervals, which we use.

use super::{INTERVALS, example, theory};
use crate::closed::FlatSolution;
use palkki::methods::Method;
use palkki::scene::SceneError;
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki::{Settings, solve_raw};

/// Contact pressure of a method beside beam theory: Figures 4 and 7.
#[derive(Debug, Clone)]
pub struct Pressures {
    /// Which method.
    pub method: Method,
    /// Its nodal values, in the units of the example.
    pub nodes: Nodes,
    /// Spacing of the nodes, by which a nodal force becomes a pressure.
    pub spacing: f64,
    /// Beam theory.
    pub theory: FlatSolution,
}

/// Deflection of a method beside beam theory: Figure 8.
#[derive(Debug, Clone)]
pub struct Deflections {
    /// Which method.
    pub method: Method,
    /// Its nodal values, in the units of the example.
    pub nodes: Nodes,
    /// Beam theory.
    pub theory: FlatSolution,
}

/// Figure 4: contact pressure of the example by finite differences, 30 intervals.
///
/// # Errors
///
/// None for the data of the paper; the type is that of [`solve_raw`].
pub fn figure_4() -> Result<Pressures, SceneError> {
    pressures(Method::Complementarity)
}

/// Figure 7: contact pressure by the energy methods, 30 intervals.
///
/// # Errors
///
/// As [`figure_4`].
pub fn figure_7() -> Result<Pressures, SceneError> {
    pressures(Method::Force)
}

/// Figure 8: deflection by the energy methods, 30 intervals.
///
/// # Errors
///
/// As [`figure_4`].
pub fn figure_8() -> Result<Deflections, SceneError> {
    Ok(Deflections { method: Method::Displacement, nodes: nodes(Method::Displacement)?, theory: theory() })
}

#[expect(clippy::cast_precision_loss, reason = "30 intervals")]
fn pressures(method: Method) -> Result<Pressures, SceneError> {
    let spacing = example()?.beam().length() / INTERVALS as f64;
    Ok(Pressures { method, nodes: nodes(method)?, spacing, theory: theory() })
}

fn nodes(method: Method) -> Result<Nodes, SceneError> {
    let raw = solve_raw(&example()?, &Settings::new(method, Solver::ActiveSet, INTERVALS))?;
    Ok(raw.state.nodes.unwrap_or_default())
}
