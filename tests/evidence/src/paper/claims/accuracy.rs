//! What the paper says of the numbers of its example: the two that it prints, which grids are usable, when cubic elements are
//! exact.

use palkki::methods::Method;
use palkki::scene::{Foundation, Load, PointLoad, Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};
use serde_json::json;

use super::{Claim, Verdict};
use crate::compare::largest;
use crate::paper::{INTERVALS, PRINTED_FORCE, PRINTED_REACTION, PRINTED_USEFUL_INTERVALS, beam, example, theory};

/// "The reaction became approximately 1,14 (n = 29), beam theory gives 1,18": the two printed numbers, computed again.
pub(super) fn printed_numbers() -> Result<Claim, SceneError> {
    let first = |method| -> Result<(f64, f64, f64), SceneError> {
        let state = solve_raw(&example()?, &Settings::new(method, Solver::ActiveSet, INTERVALS))?.state;
        let nodes = state.nodes.unwrap_or_default();
        let index = nodes.contact_force.iter().position(|p| 0.0 < *p).unwrap_or(0);
        Ok((nodes.x[index], nodes.contact_force[index], state.reactions.left))
    };
    // The reaction of the left support has the load of half an interval on the support.
    let (place, force, end_reaction) = first(Method::Force)?;
    let (_, by_differences, _) = first(Method::Complementarity)?;
    let reaction = theory().reaction;
    // Half a unit of the last printed digit.
    let rounds = |value: f64, printed: f64| (value - printed).abs() <= 0.005;
    // The other two candidates for what "the reaction" may be do not round to what is printed.
    assert!(!rounds(end_reaction, PRINTED_FORCE) && !rounds(by_differences, PRINTED_FORCE));
    assert!((place - 7.0 / 3.0).abs() < 1e-12, "the first node in contact, up to rounding: {place}");
    let verdict = Verdict::of(rounds(reaction, PRINTED_REACTION) && rounds(force, PRINTED_FORCE));
    let numbers = json!({
        "reaction": reaction, "force": force, "place": place, "end_reaction": end_reaction, "by_differences": by_differences,
    });
    Ok(Claim { name: "printed_numbers", verdict, numbers })
}

/// "As is well known, cubic shape functions lead to the exact solution of a beam if load and contact pressure are point-like."
///
/// Errors under a single point load on a node, against the textbook formula: on grids of 2 to 40 intervals with the load on every
/// fourth node; the foundation is out of reach.
#[expect(clippy::cast_precision_loss, reason = "40 intervals")]
pub(super) fn exact_for_point_forces() -> Result<Claim, SceneError> {
    let beam = beam()?;
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let (mut deflection, mut moment, mut by_differences) = (0.0_f64, 0.0_f64, 0.0_f64);
    for intervals in [2_usize, 5, 10, 20, 40] {
        for node in (1..intervals).step_by(4) {
            let at = l * node as f64 / intervals as f64;
            let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at, force: 1.0 }])?;
            let scene = Scene::new(beam.clone(), load, Some(Foundation::Flat { depth: 1e3 }))?;
            // v = b x (l² − b² − x²) / (6 EI l) for x ≤ a, with b = l − a; M = a b / l under the load.
            let exact = |x: f64| {
                let (x, b) = if x <= at { (x, l - at) } else { (l - x, at) };
                b * x * (l * l - b * b - x * x) / (6.0 * ei * l)
            };
            for method in [Method::Displacement, Method::Complementarity] {
                let state = solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, intervals))?.state;
                let nodes = state.nodes.unwrap_or_default();
                let error = largest(nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| v / exact(x) - 1.0));
                if method == Method::Displacement {
                    deflection = deflection.max(error);
                    moment = moment.max((state.moment.max / (at * (l - at) / l) - 1.0).abs());
                } else {
                    by_differences = by_differences.max(error);
                }
            }
        }
    }
    let worst = deflection.max(moment);
    assert!(1e6 * worst < by_differences, "finite differences are not exact, so that the comparison means something");
    // What rounding may make of it on these grids.
    let verdict = Verdict::of(worst <= 1e-10);
    let numbers = json!({ "deflection": deflection, "moment": moment, "by_differences": by_differences });
    Ok(Claim { name: "exact_for_point_forces", verdict, numbers })
}

/// Errors of the energy methods on one grid of the example, relative to beam theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Number of intervals.
    pub intervals: usize,
    /// Of the reaction of a support.
    pub end_reaction: f64,
    /// Of the contact force at the first node in contact, taken for the point force at lift-off.
    pub first_force: f64,
    /// Largest error of a nodal deflection, over `u₀`.
    pub deflection: f64,
    /// Of the largest bending moment.
    pub moment: f64,
    /// Largest deviation of a contact force from `q₀Δ`, over `q₀Δ`, of the interior nodes: without the first two and the last two nodes
    /// in contact, which share the concentrated forces at lift-off.
    pub pressure: f64,
    /// Open intervals inside the contact, where beam theory has none.
    pub holes: usize,
}

/// What we call usable: one per cent.
const USABLE: f64 = 0.01;

/// Nodes at each end of the contact that share a concentrated force.
const SHARING: usize = 2;

/// A finer grid than the paper's.
const FINE: usize = 300;

/// The paper's grid, the coarser one that it calls usable, and a fine one.
pub(super) fn grids() -> Result<[Errors; 3], SceneError> {
    Ok([errors(INTERVALS)?, errors(PRINTED_USEFUL_INTERVALS)?, errors(FINE)?])
}

/// Errors on one grid.
///
/// # Errors
///
/// None for the example with at least 12 intervals; the type is that of [`solve_raw`].
#[expect(clippy::cast_precision_loss, reason = "a few hundred intervals")]
pub fn errors(intervals: usize) -> Result<Errors, SceneError> {
    let scene = example()?;
    let exact = theory();
    let state = solve_raw(&scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals))?.state;
    let nodes = state.nodes.clone().unwrap_or_default();
    let nodal_load = scene.load().uniform() * scene.beam().length() / intervals as f64;
    let touching: Vec<f64> = nodes.contact_force.iter().copied().filter(|p| 0.0 < *p).collect();
    let inner = touching.get(SHARING..touching.len().saturating_sub(SHARING)).unwrap_or_default();
    let exact_moment = exact.reaction * exact.reaction / (2.0 * scene.load().uniform());
    Ok(Errors {
        intervals,
        end_reaction: state.reactions.left / exact.reaction - 1.0,
        first_force: touching.first().map_or(f64::NAN, |p| p / exact.end_force - 1.0),
        deflection: largest(nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| v - exact.deflection(x))),
        moment: state.moment.max / exact_moment - 1.0,
        pressure: largest(inner.iter().map(|p| p / nodal_load - 1.0)),
        holes: state.contacts.len().saturating_sub(1),
    })
}

impl Errors {
    /// The worst of the errors that a designer looks at: end reaction, moment, deflection.
    #[must_use]
    pub fn worst(&self) -> f64 {
        self.end_reaction.abs().max(self.deflection).max(self.moment.abs())
    }
}

/// "The estimates of the contact pressure distribution and of the deflected shape are entirely usable. Usable results were
/// obtained when the beam was divided into 20 equal intervals": the verdict is of the deflected shape; moment and end reaction are shown.
pub(super) fn usable_shape(grids: &[Errors; 3]) -> Claim {
    let [paper, coarse, fine] = grids;
    assert_eq!([paper, coarse].map(|grid| grid.intervals), [30, 20], "the grids of the paper");
    assert!(fine.worst() < USABLE, "{fine:?}");
    assert!(coarse.end_reaction < 3.0 * USABLE && coarse.deflection < USABLE, "{coarse:?}");
    // The paper says it of the deflected shape (siirtymätila).
    let verdict = match [paper, coarse].map(|grid| grid.deflection <= USABLE) {
        [true, true] => Verdict::Confirmed,
        [false, false] => Verdict::Refuted,
        _ => Verdict::Qualified,
    };
    let line = |e: &Errors| {
        json!({
            "intervals": e.intervals, "end_reaction": e.end_reaction, "moment": e.moment, "deflection": e.deflection,
            "worst": e.worst(),
        })
    };
    Claim { name: "usable_shape", verdict, numbers: json!({ "grids": [line(paper), line(coarse)] }) }
}

/// What may deviate on the paper's grid if its pressure is to be usable there: the interior nodes from `q₀Δ`, and the first contact force
/// from the concentrated force at lift-off.
const USABLE_PRESSURE: [f64; 2] = [0.2, 0.05];

/// The same of the pressure distribution, of the interior nodes and of the first contact force. Usable on the paper's grid, and on the
/// coarser one or on a finer one not, is qualified.
pub(super) fn usable_pressure([paper, coarse, fine]: &[Errors; 3]) -> Result<Claim, SceneError> {
    let looked_at: Vec<Errors> = (1..=20).map(|k| errors(20 * k)).collect::<Result<_, _>>()?;
    let holes = looked_at.iter().filter(|e| 0 < e.holes).count();
    let most = looked_at.iter().max_by(|a, b| a.pressure.total_cmp(&b.pressure)).unwrap_or(paper);
    let is_usable = |e: &Errors| e.pressure <= USABLE_PRESSURE[0] && e.first_force.abs() <= USABLE_PRESSURE[1];
    let usable = looked_at.iter().filter(|e| is_usable(e)).count();
    let verdict = match (is_usable(paper), is_usable(coarse) && usable == looked_at.len()) {
        (true, true) => Verdict::Confirmed,
        (true, false) => Verdict::Qualified,
        (false, _) => Verdict::Refuted,
    };
    let grid = |e: &Errors| json!({ "intervals": e.intervals, "force": e.first_force, "pressure": e.pressure });
    let numbers = json!({
        "paper": grid(paper), "coarse": grid(coarse), "fine": grid(fine), "most": grid(most),
        "grids": looked_at.len(), "usable": usable, "with_holes": holes,
    });
    Ok(Claim { name: "usable_pressure", verdict, numbers })
}
