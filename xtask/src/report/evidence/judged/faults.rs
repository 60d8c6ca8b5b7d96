//! Fault injection: how many broken answers our check noticed, what passed, and what was guaranteed about it.

use std::fs;

use minijinja::{Value, context};
use palkki::theory;
use palkki_evidence::faults::SIZES;

use crate::certificates::faults::{self, Row};
use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::scenes;
use crate::report::study::Study;

/// The values, the file with the rows of one scene computed again, and its sums over scenes.
pub(super) fn summary(study: &Study<'_>) -> Result<(Value, String, String), Cause> {
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
            let stored =
                stored.ok_or_else(|| format!("{} lacks {}: `cargo xtask certificates`", faults::PATH, row.fault))?;
            *stored = row;
        }
    }
    if let Some(row) = rows.iter().find(|row| 0 < row.exceptions) {
        return Err(format!("a certificate guaranteed what is not so: {row:?}").into());
    }
    let mut names: Vec<&str> = Vec::new();
    for row in &rows {
        if !names.contains(&row.fault.as_str()) {
            names.push(&row.fault);
        }
    }
    let lines: Vec<Line> = names.into_iter().map(|name| Line::of(name, &rows, &touching)).collect();
    let sum = |of: fn(&Line) -> usize| lines.iter().map(of).sum::<usize>();
    let discrete = || lines.iter().filter(|line| !line.fault.starts_with(faults::EXACT));
    let sensitivities = || discrete().filter_map(|line| line.refused_from);
    let values = context! {
        intervals => faults::INTERVALS,
        again => faults::AGAIN,
        kinds => lines.len(),
        sized => lines.iter().filter(|line| !faults::sizes(&line.fault).is_empty()).count(),
        sizes => SIZES.len(),
        smallest => SIZES[0],
        answers => sum(|line| line.refused + line.passed),
        refused => sum(|line| line.refused),
        passed => sum(|line| line.passed),
        off_by => discrete().map(|line| line.off_by).fold(0.0, f64::max),
        most_sensitive => sensitivities().fold(f64::INFINITY, f64::min),
        least_sensitive => sensitivities().fold(0.0, f64::max),
        never => discrete().filter(|line| !faults::sizes(&line.fault).is_empty() && line.refused_from.is_none()).count(),
        bounded => sum(|line| line.bounded),
        unbounded => sum(|line| line.unbounded),
        no_numbers => sum(|line| line.no_numbers),
    };
    let header =
        ["fault", "answers", "refused", "passed", "all_refused_from", "off_by", "bounded", "unbounded", "no_numbers"];
    Ok((values, faults::text(&rows), csv(&header, lines.iter().map(Line::data))))
}

/// A kind of fault over all scenes and routes.
#[derive(Debug)]
struct Line {
    fault: String,
    refused: usize,
    passed: usize,
    /// The smallest size from which on all are refused where there is contact; none if something of the largest size passed.
    refused_from: Option<f64>,
    off_by: f64,
    bounded: usize,
    unbounded: usize,
    no_numbers: usize,
}

impl Line {
    fn of(name: &str, rows: &[Row], touching: &[&str]) -> Self {
        let of_fault = || rows.iter().filter(|row| row.fault == name);
        let sum = |count: fn(&Row) -> usize| of_fault().map(count).sum();
        let with_contact = of_fault().filter(|row| touching.contains(&row.scene.as_str()));
        let largest_passed = with_contact.map(|row| row.largest_passed).fold(0.0, f64::max);
        Self {
            fault: name.to_owned(),
            refused: sum(|row| row.refused),
            passed: sum(|row| row.passed),
            refused_from: faults::sizes(name).into_iter().find(|size| largest_passed < *size),
            off_by: of_fault().map(|row| row.off_by).fold(0.0, f64::max),
            bounded: sum(|row| row.bounded),
            unbounded: sum(|row| row.unbounded),
            no_numbers: sum(|row| row.no_numbers),
        }
    }

    fn data(&self) -> Vec<String> {
        let Self { refused, passed, bounded, unbounded, no_numbers, .. } = self;
        let from = self.refused_from.map_or_else(String::new, |size| scientific(size, 0));
        let off_by = if *passed == 0 { String::new() } else { scientific(self.off_by, 0) };
        let counts = [refused + passed, *refused, *passed].map(|n| n.to_string());
        let bounds = [bounded, unbounded, no_numbers].map(|n| n.to_string());
        std::iter::once(self.fault.replace(',', ";")).chain(counts).chain([from, off_by]).chain(bounds).collect()
    }
}
