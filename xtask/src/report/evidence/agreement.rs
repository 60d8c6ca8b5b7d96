//! All routes on the example with 30 intervals, against each other and against exact rationals.

mod tolerance;

use dashu_ratio::RBig;
use palkki::paper::{INTERVALS, example, theory};
use palkki::route::{Method, Outcome, Solver};
use palkki::scene::Scene;
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, solve};
use serde::Serialize;

use self::tolerance::Tolerances;
use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::rational::Example;
use crate::report::study::Study;

#[derive(Debug, Serialize)]
struct Values {
    intervals: usize,
    energy: Authority,
    differences: Authority,
    theory: Theory,
    rows: Vec<Row>,
    /// Norm of the stiffness, from which the tolerances of iterative solvers follow.
    norm: f64,
    tolerances: Vec<tolerance::Reason>,
    /// Whether every route agrees with the authority, and with every other route of the same model.
    all_agree: bool,
    /// Whether every route keeps to a tenth of its tolerance.
    margin: bool,
    pairs: usize,
    pairs_agree: usize,
}

/// Exact results of one discrete model.
#[derive(Debug, Serialize)]
struct Authority {
    first_force: String,
    first_force_value: f64,
    left_reaction: String,
    left_reaction_value: f64,
    #[serde(skip)]
    forces: Vec<f64>,
}

#[derive(Debug, Serialize)]
struct Theory {
    end_force: f64,
    reaction: f64,
}

#[derive(Debug, Serialize)]
struct Row {
    method: &'static str,
    solver: &'static str,
    status: &'static str,
    /// Guaranteed error of the deflection over the largest deflection, if there is one.
    certified: Option<f64>,
    /// With as many digits as the tolerance of the solver promises.
    first_force: String,
    left_reaction: String,
    tolerance: String,
    agrees: &'static str,
    /// The largest difference from the authority, over the tolerance.
    #[serde(skip)]
    share: f64,
}

/// A route with what is compared.
struct Run {
    method: Method,
    solver: Solver,
    outcome: Outcome,
    forces: Vec<f64>,
}

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let tolerances = Tolerances::new()?;
    let mut runs = Vec::new();
    for method in Method::ALL {
        for solver in Solver::ALL {
            let outcome = solve(&scene, &Settings::new(method, solver, INTERVALS))?;
            let forces = outcome.state.nodes.as_ref().map_or_else(Vec::new, |nodes| nodes.contact_force.clone());
            runs.push(Run { method, solver, outcome, forces });
        }
    }
    let (energy, differences) = (authority(&runs, Method::Force)?, authority(&runs, Method::Complementarity)?);
    let of = |run: &Run| if run.method == Method::Complementarity { &differences } else { &energy };
    let rows: Vec<Row> = runs.iter().map(|run| row(&scene, run, of(run), &tolerances)).collect();

    let (mut pairs, mut pairs_agree) = (0, 0);
    for (i, a) in runs.iter().enumerate() {
        let same_model = |b: &&Run| (a.method == Method::Complementarity) == (b.method == Method::Complementarity);
        for b in runs[i + 1..].iter().filter(same_model) {
            pairs += 1;
            let allowed = tolerances.of(a.solver) + tolerances.of(b.solver);
            pairs_agree += usize::from(largest_difference(&a.forces, &b.forces) <= allowed);
        }
    }
    let exact = theory();
    let table = rows.iter().map(|r| {
        [r.method, r.solver, r.status, &r.first_force, &r.left_reaction, r.agrees].map(str::to_owned).to_vec()
    });
    let table = csv(&["method", "solver", "status", "first_contact_force", "left_reaction", "agrees"], table);
    let values = Values {
        intervals: INTERVALS,
        theory: Theory { end_force: exact.end_force, reaction: exact.reaction },
        all_agree: rows.iter().all(|row| row.agrees == "yes"),
        norm: tolerances.norm,
        margin: rows.iter().all(|row| row.share <= 0.1),
        tolerances: tolerances.reasons(),
        energy,
        differences,
        rows,
        pairs,
        pairs_agree,
    };
    Ok(Evidence::new(values).data("agreement", table))
}

/// The exact optimum. The contact set is read from a computed answer; the check in rationals does not rely on it.
fn authority(runs: &[Run], method: Method) -> Result<Authority, Cause> {
    let run = runs.iter().find(|run| run.method == method && run.solver == Solver::ActiveSet);
    let touches: Vec<bool> = run.map_or_else(Vec::new, |run| run.forces.iter().map(|p| 0.0 < *p).collect());
    let example = Example::new(u16::try_from(INTERVALS)?);
    let optimum = if method == Method::Complementarity {
        example.by_differences(&touches)?
    } else {
        example.by_energy(&touches)?
    };
    let nearest = |value: &RBig| value.to_f64().value();
    let first = optimum.contact_force.iter().find(|p| !p.is_zero()).cloned().unwrap_or(RBig::ZERO);
    Ok(Authority {
        first_force: first.to_string(),
        first_force_value: nearest(&first),
        left_reaction: optimum.left_reaction.to_string(),
        left_reaction_value: nearest(&optimum.left_reaction),
        forces: optimum.contact_force.iter().map(nearest).collect(),
    })
}

fn row(scene: &Scene, run: &Run, authority: &Authority, tolerances: &Tolerances) -> Row {
    let verdict = Verdict::of_outcome(scene, &run.outcome, &Demand::default());
    let allowed = tolerances.of(run.solver);
    let places = tolerances.places(run.solver);
    let first = authority.forces.iter().position(|p| 0.0 < *p).unwrap_or(0);
    let reaction = run.outcome.state.reactions.left;
    let error =
        largest_difference(&run.forces, &authority.forces).max((reaction - authority.left_reaction_value).abs());
    Row {
        method: run.method.word(),
        solver: run.solver.word(),
        status: verdict.status.word(),
        certified: verdict.error.is_finite().then_some(verdict.error),
        first_force: fixed(run.forces.get(first).copied().unwrap_or(f64::NAN), places),
        left_reaction: fixed(reaction, places),
        tolerance: tolerances.printed(run.solver),
        agrees: if error <= allowed { "yes" } else { "no" },
        share: error / allowed,
    }
}

/// Infinite if there is nothing to compare, or NaN in it.
fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() || a.is_empty() {
        return f64::INFINITY;
    }
    let worst = |worst: f64, e: f64| if e.is_nan() { f64::INFINITY } else { worst.max(e) };
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, worst)
}
