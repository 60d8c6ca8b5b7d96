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
        let (mut theory, mut force, mut others, mut worst) =
            (Count::default(), Count::default(), Count::default(), 0.0_f64);
        let scenes = extremes.len();
        for extreme in extremes {
            let (by_theory, error) = exact(&extreme)?;
            worst = worst.max(error);
            theory.add(by_theory);
            let (mut own, mut here, mut which) = (Verdict::Labelled, Count::default(), Vec::new());
            for method in Method::ALL {
                let active = reference(&extreme, method)?;
                for solver in Solver::ALL {
                    let verdict = if solver == Solver::Nsor && NSOR < extreme.intervals {
                        let coarse = Extreme { intervals: NSOR, ..extreme.clone() };
                        judged(&coarse, method, solver, &reference(&coarse, method)?)?
                    } else {
                        judged(&extreme, method, solver, &active)?
                    };
                    if method == Method::Force && solver == Solver::ActiveSet {
                        own = verdict;
                        continue;
                    }
                    here.add(verdict);
                    if verdict == Verdict::Labelled {
                        which.push(format!("{method}/{solver}"));
                    }
                }
            }
            force.add(own);
            if own == Verdict::Labelled {
                all.force_limits.push(extreme.name.clone());
            }
            let line = [name, extreme.authority, by_theory.word(), own.word()].map(str::to_owned);
            let counts = [here.right, here.labelled, here.wrong].map(|n| n.to_string());
            rows.push([vec![extreme.name.replace(',', ";")], line.to_vec(), counts.to_vec()].concat());
            others = Count {
                right: others.right + here.right,
                labelled: others.labelled + here.labelled,
                wrong: others.wrong + here.wrong,
            };
            all.hardest.push(Row {
                name: extreme.name,
                authority: extreme.authority,
                right: here.right,
                labelled: here.labelled,
                which: which.join(", "),
            });
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
        for (sum, part) in [(&mut all.exact, theory), (&mut all.force, force)] {
            *sum = Count {
                right: sum.right + part.right,
                labelled: sum.labelled + part.labelled,
                wrong: sum.wrong + part.wrong,
            };
        }
    }
    all.hardest.retain(|row| 0 < row.labelled);
    all.hardest.sort_by_key(|row| Reverse(row.labelled));
    all.hardest.truncate(HARDEST);
    let header = [
        "scene",
        "group",
        "authority",
        "exact",
        "force_active_set",
        "others_right",
        "others_labelled",
        "others_wrong_and_certified",
    ];
    all.csv = csv(&header, rows);
    Ok(all)
}
