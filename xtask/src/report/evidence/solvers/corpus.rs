//! What the four steps, plain full exchanges and the active set do on the instances that are hard for exchanges.

use minijinja::{Value, context};
use palkki::methods::Discrete;
use palkki::route::{Solver, Status};
use palkki::{Settings, solve};

use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::table::Table;
use palkki_evidence::exchanges::{End, Instance, corpus, full_exchange};

/// Runs all three on all instances: a summary, and every run as data.
pub(super) fn evidence() -> Result<(Value, String), Cause> {
    let instances = corpus().map_err(|line| format!("tests/corpus/exchanges.csv: no instance: {line}"))?;
    // For each algorithm: how often it ends at the optimum, and the most solves that it takes.
    let mut ends = [("four steps", 0, 0), ("full exchanges alone", 0, 0), ("active set", 0, 0)];
    let (mut periods, mut data) = (Vec::new(), Vec::new());
    for instance in &instances {
        let (exchange, solves) = match exchanged(instance)? {
            End::Optimum { solves } => (true, solves),
            End::Circle { solves, period } => {
                periods.push(period);
                (false, solves)
            }
        };
        let runs = [ended(instance, Solver::FourStep)?, (exchange, solves), ended(instance, Solver::ActiveSet)?];
        let foundation = instance.line.rsplit(',').next().unwrap_or_default();
        let mut row = [instance.method.word(), &instance.intervals.to_string(), foundation].map(str::to_owned).to_vec();
        for ((_, right, most), (is_right, solves)) in ends.iter_mut().zip(runs) {
            *right += usize::from(is_right);
            *most = solves.max(*most);
            row.extend([if is_right { "optimum" } else { "no optimum" }.to_owned(), solves.to_string()]);
        }
        data.push(row);
    }
    let rows = ends.map(|(name, right, most)| [name.to_owned(), right.to_string(), most.to_string()]);
    let values = context! {
        table => Table::new(["algorithm", "ends at the optimum", "most solves"]).rows(rows),
        count => instances.len(),
        circles => periods.iter().min().zip(periods.iter().max()),
        active_set => ends[2].1,
    };
    let header = [
        "method",
        "intervals",
        "foundation",
        "four_steps",
        "solves",
        "full_exchanges",
        "solves",
        "active_set",
        "solves",
    ];
    Ok((values, csv(&header, data)))
}

fn exchanged(instance: &Instance) -> Result<End, Cause> {
    let scaled = instance.scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, instance.intervals)?;
    let programme = instance.method.programme(&discrete);
    full_exchange(programme.as_ref()).map_err(|error| error.to_string().into())
}

/// Whether the answer passes our check, and the solves that it took.
fn ended(instance: &Instance, solver: Solver) -> Result<(bool, usize), Cause> {
    let outcome = solve(&instance.scene, &Settings::new(instance.method, solver, instance.intervals))?;
    Ok((outcome.status == Status::Certified, outcome.iterations))
}
