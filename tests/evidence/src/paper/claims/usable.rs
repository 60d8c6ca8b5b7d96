//! "The estimates of the contact pressure distribution and of the deflected shape are entirely usable. Usable results were
//! obtained when the beam was divided into 20 equal intervals."

use super::{Claim, Verdict};
use crate::paper::{INTERVALS, PRINTED_USEFUL_INTERVALS, example, theory};
use palkki::methods::Method;
use palkki::scene::SceneError;
use palkki::solvers::Solver;
use palkki::{Settings, solve};

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
    /// Largest deviation of a contact force from `q₀Δ`, over `q₀Δ`, without the first and last node in contact.
    pub pressure: f64,
    /// Open intervals inside the contact, where beam theory has none.
    pub holes: usize,
}

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// The paper's grid, the coarser one that it calls usable, and a fine one.
    pub grids: [Errors; 3],
    /// Grids from 20 to 400 intervals in steps of 20 that were looked at for holes.
    pub grids_looked_at: usize,
    /// How many of them have a hole in the contact.
    pub grids_with_holes: usize,
    /// The largest deviation of a contact force on any of them, as in [`Errors::pressure`], and its number of intervals.
    pub worst_pressure: (usize, f64),
}

/// What we call usable: one per cent.
const USABLE: f64 = 0.01;

/// A grid that nobody could afford in 1984.
const FINE: usize = 300;

/// Measures on the example.
///
/// # Errors
///
/// None for the example; the type is that of [`solve`].
pub fn measure() -> Result<Evidence, SceneError> {
    let grids = [errors(INTERVALS)?, errors(PRINTED_USEFUL_INTERVALS)?, errors(FINE)?];
    let looked_at: Vec<Errors> = (1..=20).map(|k| errors(20 * k)).collect::<Result<_, _>>()?;
    let grids_with_holes = looked_at.iter().filter(|e| 0 < e.holes).count();
    let worst_pressure = looked_at
        .iter()
        .fold((0, 0.0), |worst: (usize, f64), e| if worst.1 < e.pressure { (e.intervals, e.pressure) } else { worst });
    Ok(Evidence { grids, grids_looked_at: looked_at.len(), grids_with_holes, worst_pressure })
}

/// Errors on one grid.
///
/// # Errors
///
/// None for the example with at least 12 intervals; the type is that of [`solve`].
#[expect(clippy::cast_precision_loss, reason = "a few hundred intervals")]
pub fn errors(intervals: usize) -> Result<Errors, SceneError> {
    let scene = example()?;
    let exact = theory();
    let state = solve(&scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals))?.state;
    let nodes = state.nodes.clone().unwrap_or_default();
    let nodal_load = scene.load().uniform() * scene.beam().length() / intervals as f64;
    let touching: Vec<f64> = nodes.contact_force.iter().copied().filter(|p| 0.0 < *p).collect();
    let inner = &touching[1.min(touching.len())..touching.len().saturating_sub(1)];
    let worst = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |worst, e| worst.max(e.abs()));
    let exact_moment = exact.reaction * exact.reaction / (2.0 * scene.load().uniform());
    Ok(Errors {
        intervals,
        end_reaction: state.reactions.left / exact.reaction - 1.0,
        first_force: touching.first().map_or(f64::NAN, |p| p / exact.end_force - 1.0),
        deflection: worst(&mut nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| v - exact.deflection(x))),
        moment: state.moment.max / exact_moment - 1.0,
        pressure: worst(&mut inner.iter().map(|p| p / nodal_load - 1.0)),
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

impl Evidence {
    /// Deflected shape, moment and end reaction on the two grids of the paper.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let good = |e: &Errors| e.worst() <= USABLE;
        match (good(&self.grids[0]), good(&self.grids[1])) {
            (true, true) => Verdict::Confirmed,
            (false, false) => Verdict::Refuted,
            _ => Verdict::Qualified,
        }
    }

    /// Pressure distribution: usable only if no finer grid is worse than that of the paper.
    #[must_use]
    pub fn pressure_verdict(&self) -> Verdict {
        let [paper, ..] = &self.grids;
        if self.worst_pressure.1 <= paper.pressure && self.grids_with_holes == 0 {
            Verdict::Confirmed
        } else if paper.pressure <= 1.0 {
            Verdict::Qualified
        } else {
            Verdict::Refuted
        }
    }

    pub(super) fn claims(&self) -> [Claim; 2] {
        let [paper, coarse, fine] = &self.grids;
        let percent = |e: f64| format!("{:+.2} %", 100.0 * e);
        let line = |e: &Errors| {
            format!(
                "On {} intervals the end reaction is off by {}, the largest moment by {} and the deflection of the nodes by at most {:.2} % of u₀",
                e.intervals,
                percent(e.end_reaction),
                percent(e.moment),
                100.0 * e.deflection
            )
        };
        let shape = Claim {
            name: "usable_shape",
            statement: "The deflected shape is entirely usable on 30 intervals, and usable on 20.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "deflection, end reaction and moment within {:.2} % on {} intervals, {:.2} % on {}",
                100.0 * paper.worst(),
                paper.intervals,
                100.0 * coarse.worst(),
                coarse.intervals,
            ),
            evidence: format!("We call usable what is within one per cent. {}. {}.", line(paper), line(coarse)),
        };
        let pressure = Claim {
            name: "usable_pressure",
            statement: "The contact pressure distribution is entirely usable on 30 intervals, and usable on 20.",
            verdict: self.pressure_verdict(),
            reading: None,
            summary: format!(
                "nodal forces are off by up to {:.0} % of the load of one interval on {} intervals and {:.0} % on {}; their sum converges",
                100.0 * paper.pressure,
                paper.intervals,
                100.0 * self.worst_pressure.1,
                self.worst_pressure.0,
            ),
            evidence: format!(
                "The first contact force differs from the point force at lift-off by {} on 30 intervals, {} on 20 and {} on {}. \
                 It does not converge, because neighbouring nodes share that force. The nodal forces between the first and the last \
                 one, the second one included, differ from q₀Δ by up to {:.0} % on 30, {:.0} % on 20 and {:.0} % on {} intervals, and \
                 by {:.0} % on {} intervals, the worst of {} grids from 20 to 400 intervals. {} of these grids have an open interval inside the \
                 contact, where beam theory has none. Resultants converge, nodal pressures do not.",
                percent(paper.first_force),
                percent(coarse.first_force),
                percent(fine.first_force),
                fine.intervals,
                100.0 * paper.pressure,
                100.0 * coarse.pressure,
                100.0 * fine.pressure,
                fine.intervals,
                100.0 * self.worst_pressure.1,
                self.worst_pressure.0,
                self.grids_looked_at,
                self.grids_with_holes,
            ),
        };
        [shape, pressure]
    }
}
