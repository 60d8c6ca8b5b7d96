//! Scenes at the ends of sizes, borders between regimes, and units: every route on each of them.

use minijinja::{Value, context};
use palkki::route::{Method, Solver};
use palkki_evidence::extremes::Extreme;

use super::{Count, NSOR, Verdict, checked, exact, reference};
use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::numbers;
use crate::report::table::Table;

/// Errors below this differ between machines.
const ROUNDING: f64 = 1e-13;

/// Everything that was tried.
pub(super) struct Tried {
    pub(super) count: Count,
    pub(super) values: Value,
    pub(super) csv: String,
}

/// What became of one scene: by beam theory, by the force method with the active set, by the other routes.
struct Case {
    theory: Verdict,
    theory_error: f64,
    force: Verdict,
    others: Count,
    /// The other routes whose answers are not certified.
    not_certified: Vec<String>,
}

/// Runs every route on every scene.
pub(super) fn tried(groups: Vec<(&'static str, Vec<Extreme>)>) -> Result<Tried, Cause> {
    let header = [
        "group",
        "scenes",
        "beam theory: right",
        "its worst error",
        "force, active set: right",
        "other routes: right",
        "not certified",
    ];
    let mut table = Table::new(header);
    let (mut rows, mut force_limits, mut cases) = (Vec::new(), Vec::new(), 0);
    let (mut all, mut all_theory, mut all_force) = (Count::default(), Count::default(), Count::default());
    for (name, extremes) in groups {
        let (mut theory, mut force, mut others) = (Count::default(), Count::default(), Count::default());
        let mut worst = 0.0_f64;
        cases += extremes.len();
        let scenes = extremes.len().to_string();
        for extreme in extremes {
            let case = run(&extreme)?;
            worst = worst.max(case.theory_error);
            theory.add(case.theory);
            force.add(case.force);
            others.join(case.others);
            rows.push(line(name, &extreme, &case));
            if case.force == Verdict::NotCertified {
                force_limits.push(extreme.name);
            }
        }
        let error = numbers::bound(worst.max(ROUNDING));
        let [theories, forces, right, not] =
            [theory.right, force.right, others.right, others.not_certified].map(|n| n.to_string());
        table = table.row([name.to_owned(), scenes, theories, error, forces, right, not]);
        [theory, force, others].into_iter().for_each(|count| all.join(count));
        all_theory.join(theory);
        all_force.join(force);
    }
    let values = context! {
        table => table.to_string(),
        scenes => cases,
        theory => context! { right => all_theory.right, not_certified => all_theory.not_certified },
        force => context! { right => all_force.right, not_certified => all_force.not_certified },
        force_limits,
    };
    Ok(Tried { count: all, values, csv: csv(&HEADER, rows) })
}

/// Runs every route on one scene.
fn run(extreme: &Extreme) -> Result<Case, Cause> {
    let (theory, theory_error) = exact(extreme)?;
    let (mut force, mut others, mut not_certified) = (Verdict::NotCertified, Count::default(), Vec::new());
    for method in Method::ALL {
        let active = reference(extreme, method)?;
        for solver in Solver::ALL {
            let verdict = if solver == Solver::Nsor && NSOR < extreme.intervals {
                let coarse = Extreme { intervals: NSOR, ..extreme.clone() };
                checked(&coarse, method, solver, &reference(&coarse, method)?)?
            } else {
                checked(extreme, method, solver, &active)?
            };
            if method == Method::Force && solver == Solver::ActiveSet {
                force = verdict;
                continue;
            }
            others.add(verdict);
            if verdict == Verdict::NotCertified {
                not_certified.push(format!("{method}/{solver}"));
            }
        }
    }
    Ok(Case { theory, theory_error, force, others, not_certified })
}

const HEADER: [&str; 9] = [
    "scene",
    "group",
    "reference",
    "exact",
    "force_active_set",
    "others_right",
    "others_not_certified",
    "others_wrong_and_certified",
    "which_are_not_certified",
];

/// A line of the CSV.
fn line(group: &str, extreme: &Extreme, case: &Case) -> Vec<String> {
    let words = [group, extreme.authority, case.theory.word(), case.force.word()].map(str::to_owned);
    let Count { right, not_certified, wrong } = case.others;
    let counts = [right, not_certified, wrong].map(|n| n.to_string());
    [vec![extreme.name.replace(',', ";")], words.to_vec(), counts.to_vec(), vec![case.not_certified.join(" ")]].concat()
}
