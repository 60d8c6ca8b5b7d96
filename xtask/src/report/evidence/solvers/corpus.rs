//! What the four steps, plain full exchanges and the active set do on the instances that are hard for exchanges.

#[path = "../../../../../tests/corpus/instances.rs"]
#[expect(dead_code, reason = "the acceptance suite asserts what the table shows")]
mod instances;

use palkki::methods::Discrete;
use palkki::route::Solver;
use palkki::{Settings, solve};
use serde::Serialize;

use self::instances::{End, Instance, corpus, full_exchange};
use crate::report::error::Cause;

#[derive(Debug, Serialize)]
pub(super) struct Values {
    rows: Vec<Row>,
    /// How many of them the four steps and full exchanges solve, and the active set.
    four_step: usize,
    exchange: usize,
    active_set: usize,
    /// The most solves that the active set takes.
    most: usize,
    /// The shortest and the longest circle.
    circles: Option<[usize; 2]>,
}

#[derive(Debug, Serialize)]
struct Row {
    method: &'static str,
    intervals: usize,
    foundation: String,
    four_step: Ended,
    exchange: String,
    active_set: Ended,
}

/// The judge's verdict on an answer, and the solves that it took.
#[derive(Debug, Serialize)]
struct Ended {
    verdict: &'static str,
    solves: usize,
    /// Whether it is the optimum.
    right: bool,
}

/// Runs all three on all instances.
pub(super) fn evidence() -> Result<Values, Cause> {
    let instances = corpus().map_err(|line| format!("tests/corpus/exchanges.csv: no instance: {line}"))?;
    let (mut rows, mut exchange, mut circles) = (Vec::new(), 0, Vec::new());
    for instance in &instances {
        let end = exchanged(instance)?;
        exchange += usize::from(matches!(end, End::Optimum { .. }));
        if let End::Circle { period, .. } = end {
            circles.push(period);
        }
        rows.push(Row {
            method: instance.method.word(),
            intervals: instance.intervals,
            foundation: in_words(instance.line.rsplit(',').next().unwrap_or_default()),
            four_step: ended(instance, Solver::FourStep)?,
            exchange: match end {
                End::Optimum { solves } => format!("optimum after {solves}"),
                End::Circle { solves, period } => format!("a circle of {period}, entered after {}", solves - period),
            },
            active_set: ended(instance, Solver::ActiveSet)?,
        });
    }
    Ok(Values {
        four_step: rows.iter().filter(|row| row.four_step.right).count(),
        exchange,
        circles: circles.iter().min().zip(circles.iter().max()).map(|(least, most)| [*least, *most]),
        active_set: rows.iter().filter(|row| row.active_set.right).count(),
        most: rows.iter().map(|row| row.active_set.solves).max().unwrap_or(0),
        rows,
    })
}

fn exchanged(instance: &Instance) -> Result<End, Cause> {
    let scaled = instance.scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, instance.intervals)?;
    let programme = instance.method.programme(&discrete);
    full_exchange(programme.as_ref()).map_err(|error| error.to_string().into())
}

fn ended(instance: &Instance, solver: Solver) -> Result<Ended, Cause> {
    let outcome = solve(&instance.scene, &Settings::new(instance.method, solver, instance.intervals))?;
    let right = outcome.status == palkki::route::Status::Certified;
    Ok(Ended { verdict: if right { "optimum" } else { "no optimum" }, solves: outcome.iterations, right })
}

/// `cosine 0.95 4.2 0.6` for a person.
fn in_words(foundation: &str) -> String {
    let (kind, numbers) = foundation.split_once(' ').unwrap_or((foundation, ""));
    let numbers: Vec<&str> = numbers.split(' ').collect();
    match (kind, &numbers[..]) {
        ("cosine", [amplitude, wavelength, phase]) => {
            format!("u = 1 + {amplitude} cos(2πx/{wavelength} + {phase})")
        }
        _ => format!("polyline through {} equally spaced depths", numbers.len()),
    }
}
