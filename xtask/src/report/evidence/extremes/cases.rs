//! The table of what was tried.

use std::cmp::Reverse;

use palkki::extremes::Extreme;
use palkki::route::{Method, Solver};
use serde::Serialize;

use super::{Count, NSOR, Verdict, exact, judged, reference};
use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::numbers;

/// Scenes that the table of the hardest shows.
const HARDEST: usize = 12;
/// Errors below this differ between machines.
const ROUNDING: f64 = 1e-13;

/// Everything that was tried.
pub(super) struct Tried {
    pub(super) cases: usize,
    pub(super) runs: usize,
    pub(super) wrong: usize,
    pub(super) exact: Count,
    pub(super) force: Count,
    pub(super) groups: Vec<Group>,
    pub(super) hardest: Vec<Row>,
    pub(super) force_limits: Vec<String>,
    pub(super) csv: String,
}

/// A group of scenes.
#[derive(Debug, Serialize)]
pub(super) struct Group {
    name: &'static str,
    scenes: usize,
    exact_right: usize,
    exact_error: String,
    force_right: usize,
    others_right: usize,
    others_labelled: usize,
    wrong: usize,
}

/// One scene.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    name: String,
    authority: &'static str,
    right: usize,
    labelled: usize,
    which: String,
}

/// What became of one scene: by beam theory, by the force method with the active set, by the other routes.
struct Case {
    theory: Verdict,
    theory_error: f64,
    force: Verdict,
    others: Count,
    /// The other routes whose answers are labelled.
    labelled: Vec<String>,
}

/// Runs every route on every scene.
pub(super) fn tried(groups: Vec<(&'static str, Vec<Extreme>)>) -> Result<Tried, Cause> {
    let mut all = Tried {
        cases: 0,
        runs: 0,
        wrong: 0,
        exact: Count::default(),
        force: Count::default(),
        groups: Vec::new(),
        hardest: Vec::new(),
        force_limits: Vec::new(),
        csv: String::new(),
    };
    let mut rows = Vec::new();
    for (name, extremes) in groups {
        let (mut theory, mut force, mut others) = (Count::default(), Count::default(), Count::default());
        let mut worst = 0.0_f64;
        let scenes = extremes.len();
        for extreme in extremes {
            let case = run(&extreme)?;
            worst = worst.max(case.theory_error);
            theory.add(case.theory);
            force.add(case.force);
            others.join(case.others);
            rows.push(line(name, &extreme, &case));
            if case.force == Verdict::Labelled {
                all.force_limits.push(extreme.name.clone());
            }
            let Count { right, labelled, .. } = case.others;
            let (name, authority, which) = (extreme.name, extreme.authority, case.labelled.join(", "));
            all.hardest.push(Row { name, authority, right, labelled, which });
        }
        let wrong = theory.wrong + force.wrong + others.wrong;
        all.groups.push(Group {
            name,
            scenes,
            exact_right: theory.right,
            exact_error: numbers::bound(worst.max(ROUNDING)),
            force_right: force.right,
            others_right: others.right,
            others_labelled: others.labelled,
            wrong,
        });
        all.cases += scenes;
        all.runs += theory.runs() + force.runs() + others.runs();
        all.wrong += wrong;
        all.exact.join(theory);
        all.force.join(force);
    }
    all.hardest.retain(|row| 0 < row.labelled);
    all.hardest.sort_by_key(|row| Reverse(row.labelled));
    all.hardest.truncate(HARDEST);
    all.csv = csv(&HEADER, rows);
    Ok(all)
}

/// Runs every route on one scene.
fn run(extreme: &Extreme) -> Result<Case, Cause> {
    let (theory, theory_error) = exact(extreme)?;
    let (mut force, mut others, mut labelled) = (Verdict::Labelled, Count::default(), Vec::new());
    for method in Method::ALL {
        let active = reference(extreme, method)?;
        for solver in Solver::ALL {
            let verdict = if solver == Solver::Nsor && NSOR < extreme.intervals {
                let coarse = Extreme { intervals: NSOR, ..extreme.clone() };
                judged(&coarse, method, solver, &reference(&coarse, method)?)?
            } else {
                judged(extreme, method, solver, &active)?
            };
            if method == Method::Force && solver == Solver::ActiveSet {
                force = verdict;
                continue;
            }
            others.add(verdict);
            if verdict == Verdict::Labelled {
                labelled.push(format!("{method}/{solver}"));
            }
        }
    }
    Ok(Case { theory, theory_error, force, others, labelled })
}

const HEADER: [&str; 8] = [
    "scene",
    "group",
    "authority",
    "exact",
    "force_active_set",
    "others_right",
    "others_labelled",
    "others_wrong_and_certified",
];

/// A line of the CSV.
fn line(group: &str, extreme: &Extreme, case: &Case) -> Vec<String> {
    let words = [group, extreme.authority, case.theory.word(), case.force.word()].map(str::to_owned);
    let Count { right, labelled, wrong } = case.others;
    let counts = [right, labelled, wrong].map(|n| n.to_string());
    [vec![extreme.name.replace(',', ";")], words.to_vec(), counts.to_vec()].concat()
}
