//! What the paper says of the numbers of its example: the two that it prints, which grids are usable, when cubic elements are
//! exact.

use palkki::methods::Method;
use palkki::scene::{Foundation, Load, PointLoad, Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};

use super::{Claim, Verdict, bound};
use crate::paper::{INTERVALS, PRINTED_FORCE, PRINTED_REACTION, PRINTED_USEFUL_INTERVALS, beam, example, theory};

/// "The reaction became approximately 1,14 (n = 29), beam theory gives 1,18": the two printed numbers, computed again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Printed {
    /// `T` by beam theory.
    pub reaction_by_theory: f64,
    /// Contact force at the first node in contact, force method, 30 intervals.
    pub first_force: f64,
    /// Where that node is.
    pub first_place: f64,
    /// Reaction of the left support on the same grid, with the load of half an interval on the support.
    pub end_reaction: f64,
    /// The first contact force by finite differences.
    pub first_force_by_differences: f64,
}

/// Half a unit of the last printed digit.
const HALF_A_UNIT: f64 = 0.005;

/// Measures on the example.
///
/// # Errors
///
/// None for the example; the type is that of [`solve_raw`].
pub fn printed() -> Result<Printed, SceneError> {
    let first = |method| -> Result<(f64, f64, f64), SceneError> {
        let state = solve_raw(&example()?, &Settings::new(method, Solver::ActiveSet, INTERVALS))?.state;
        let nodes = state.nodes.unwrap_or_default();
        let index = nodes.contact_force.iter().position(|p| 0.0 < *p).unwrap_or(0);
        Ok((nodes.x[index], nodes.contact_force[index], state.reactions.left))
    };
    let (first_place, first_force, end_reaction) = first(Method::Force)?;
    let (_, first_force_by_differences, _) = first(Method::Complementarity)?;
    Ok(Printed {
        reaction_by_theory: theory().reaction,
        first_force,
        first_place,
        end_reaction,
        first_force_by_differences,
    })
}

impl Printed {
    /// Whether both numbers round to what is printed.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let rounds = |value: f64, printed: f64| (value - printed).abs() <= HALF_A_UNIT;
        if rounds(self.reaction_by_theory, PRINTED_REACTION) && rounds(self.first_force, PRINTED_FORCE) {
            Verdict::Confirmed
        } else {
            Verdict::Refuted
        }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "printed_numbers",
            statement: "The reaction became 1.14 (n = 29); beam theory gives 1.18.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("{:.5} and {:.5}", self.first_force, self.reaction_by_theory),
            evidence: format!(
                "Beam theory gives {:.5}. The force method on 30 intervals gives {:.5} as the contact force of its first node \
                 in contact, at x = {:.4}, which rounds to the printed number; the end reaction of the same grid, {:.5}, does \
                 not. Finite differences give {:.5} for the first contact force.",
                self.reaction_by_theory,
                self.first_force,
                self.first_place,
                self.end_reaction,
                self.first_force_by_differences,
            ),
        }
    }
}

/// "As is well known, cubic shape functions lead to the exact solution of a beam if load and contact pressure are point-like."
///
/// Errors of the displacement method under a single point load on a node, against the textbook formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointForces {
    /// Largest relative error of a nodal deflection over all grids and places.
    pub deflection: f64,
    /// Largest relative error of the moment under the load.
    pub moment: f64,
    /// The same error of the deflection by finite differences, for comparison.
    pub deflection_by_differences: f64,
}

/// What rounding may make of it on these grids.
const ROUNDING: f64 = 1e-10;

/// Measures on grids of 2 to 40 intervals with the load on every fourth node; the foundation is out of reach.
///
/// # Errors
///
/// None for these scenes; the type is that of [`solve_raw`].
#[expect(clippy::cast_precision_loss, reason = "40 intervals")]
pub fn point_forces() -> Result<PointForces, SceneError> {
    let beam = beam()?;
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let mut evidence = PointForces { deflection: 0.0, moment: 0.0, deflection_by_differences: 0.0 };
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
                let errors = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| (v / exact(x) - 1.0).abs());
                let error = errors.fold(0.0, f64::max);
                if method == Method::Displacement {
                    evidence.deflection = evidence.deflection.max(error);
                    let moment = (state.moment.max / (at * (l - at) / l) - 1.0).abs();
                    evidence.moment = evidence.moment.max(moment);
                } else {
                    evidence.deflection_by_differences = evidence.deflection_by_differences.max(error);
                }
            }
        }
    }
    Ok(evidence)
}

impl PointForces {
    /// Whether only rounding is left.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.deflection.max(self.moment) <= ROUNDING { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "exact_for_point_forces",
            statement: "Cubic shape functions give the exact deflection of a beam whose load and contact pressure are point forces.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "true up to rounding; finite differences are off by up to {:.0} % on the same grids",
                100.0 * self.deflection_by_differences
            ),
            evidence: format!(
                "Against the textbook formula for a point load on a node, with 2 to 40 intervals: deflections at the nodes are off \
                 by less than {}, the moment under the load by less than {}. Finite differences on the same grids are off by up to {:.0} %.",
                bound(self.deflection),
                bound(self.moment),
                100.0 * self.deflection_by_differences,
            ),
        }
    }
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
    /// Largest deviation of a contact force from `q₀Δ`, over `q₀Δ`, without the first and last node in contact.
    pub pressure: f64,
    /// Open intervals inside the contact, where beam theory has none.
    pub holes: usize,
}

/// "The estimates of the contact pressure distribution and of the deflected shape are entirely usable. Usable results were
/// obtained when the beam was divided into 20 equal intervals."
#[derive(Debug, Clone, PartialEq)]
pub struct Usable {
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
/// None for the example; the type is that of [`solve_raw`].
pub fn usable() -> Result<Usable, SceneError> {
    let grids = [errors(INTERVALS)?, errors(PRINTED_USEFUL_INTERVALS)?, errors(FINE)?];
    let looked_at: Vec<Errors> = (1..=20).map(|k| errors(20 * k)).collect::<Result<_, _>>()?;
    let grids_with_holes = looked_at.iter().filter(|e| 0 < e.holes).count();
    let worst_pressure = looked_at
        .iter()
        .fold((0, 0.0), |worst: (usize, f64), e| if worst.1 < e.pressure { (e.intervals, e.pressure) } else { worst });
    Ok(Usable { grids, grids_looked_at: looked_at.len(), grids_with_holes, worst_pressure })
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

impl Usable {
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
