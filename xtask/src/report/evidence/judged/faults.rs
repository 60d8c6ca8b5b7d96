//! Faults in answers: what was refused, what passed, and what was guaranteed about it.

use std::fs;

use palkki::theory;
use palkki::trial::SIZES;
use serde::Serialize;

use crate::judge::faults::{self, Row};
use crate::report::error::Cause;
use crate::report::scenes;
use crate::report::study::Study;

/// What the template shows.
#[derive(Debug, Serialize)]
pub(super) struct Summary {
    intervals: usize,
    again: &'static str,
    smallest: f64,
    answers: usize,
    /// Farthest from the solution that anything was that passed, forces excepted.
    off_by: f64,
    sized: Vec<Line>,
    whole: Vec<Line>,
    exact: Vec<Line>,
}

/// A kind of fault over all scenes and routes.
#[derive(Debug, Serialize)]
struct Line {
    fault: String,
    answers: usize,
    refused: usize,
    passed: usize,
    /// The smallest size from which on all are refused where there is contact; none if something of the largest size passed.
    refused_from: Option<f64>,
    off_by: f64,
    bounded: usize,
    unbounded: usize,
    no_numbers: usize,
}

/// The summary, and the file with the rows of one scene computed again.
pub(super) fn summary(study: &Study<'_>) -> Result<(Summary, String), Cause> {
    let all = scenes::all(study.root)?;
    let mut touching = Vec::new();
    for (name, scene) in &all {
        if !theory::solve(scene)?.state.contacts.is_empty() {
            touching.push(name.as_str());
        }
    }
    let mut rows = faults::parse(&fs::read_to_string(study.root.join(faults::PATH))?)?;
    for (name, scene) in all.iter().filter(|(name, _)| name == faults::AGAIN) {
        for row in faults::rows(name, scene, &all)? {
            let stored = rows.iter_mut().find(|stored| stored.scene == row.scene && stored.fault == row.fault);
            let stored = stored.ok_or_else(|| format!("{} lacks {}: `cargo xtask judge`", faults::PATH, row.fault))?;
            *stored = row;
        }
    }
    if let Some(row) = rows.iter().find(|row| 0 < row.exceptions) {
        return Err(format!("the judge guaranteed what is not so: {row:?}").into());
    }
    let mut names: Vec<&str> = Vec::new();
    for row in &rows {
        if !names.contains(&row.fault.as_str()) {
            names.push(&row.fault);
        }
    }
    let (mut sized, mut whole, mut exact) = (Vec::new(), Vec::new(), Vec::new());
    for name in names {
        let line = line(name, &rows, &touching);
        match line.fault.strip_prefix(faults::EXACT) {
            Some(fault) => exact.push(Line { fault: fault.to_owned(), ..line }),
            None if !faults::sizes(name).is_empty() => sized.push(line),
            None => whole.push(line),
        }
    }
    let discrete = rows.iter().filter(|row| !row.fault.starts_with(faults::EXACT));
    let summary = Summary {
        intervals: faults::INTERVALS,
        again: faults::AGAIN,
        smallest: SIZES[0],
        answers: rows.iter().map(Row::answers).sum(),
        off_by: discrete.map(|row| row.off_by).fold(0.0, f64::max),
        sized,
        whole,
        exact,
    };
    Ok((summary, faults::text(&rows)))
}

fn line(name: &str, rows: &[Row], touching: &[&str]) -> Line {
    let of_fault = || rows.iter().filter(|row| row.fault == name);
    let sum = |count: fn(&Row) -> usize| of_fault().map(count).sum();
    let with_contact = of_fault().filter(|row| touching.contains(&row.scene.as_str()));
    let largest_passed = with_contact.map(|row| row.largest_passed).fold(0.0, f64::max);
    Line {
        fault: name.to_owned(),
        answers: sum(Row::answers),
        refused: sum(|row| row.refused),
        passed: sum(|row| row.passed),
        refused_from: faults::sizes(name).into_iter().find(|size| largest_passed < *size),
        off_by: of_fault().map(|row| row.off_by).fold(0.0, f64::max),
        bounded: sum(|row| row.bounded),
        unbounded: sum(|row| row.unbounded),
        no_numbers: sum(|row| row.no_numbers),
    }
}
