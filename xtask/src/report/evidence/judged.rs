//! Certificates beside true errors, and fault injection: rendered from the files of `cargo xtask certificates`, part of which
//! is computed again each time.

use std::collections::BTreeSet;

use palkki_evidence::faults::SIZES;

use super::prelude::*;
use crate::certificates::answers::{self, Row};
use crate::certificates::faults;
use crate::data;

/// A bound that is larger than the true error by a tenth at most is called sharp.
const SHARP: f64 = 0.9;

/// Rows of the table of the loosest bounds.
const LOOSEST: usize = 5;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let rows = answers(study)?;
    if let Some(row) = rows.iter().find(|row| row.outcome.starts_with(answers::EXCEPTION)) {
        return Err(format!("a certificate guaranteed what is not so: {row:?}").into());
    }
    let (faults, faults_file, kinds) = broken(study)?;
    let count = |is: &dyn Fn(&Row) -> bool| rows.iter().filter(|row| is(row)).count();
    let bounded = |row: &Row| row.outcome == answers::BOUNDED && row.certified.is_finite();
    let failed = |row: &Row| row.status != "solved";
    let mut ratios: Vec<(f64, &Row)> = rows.iter().filter_map(|row| Some((row.ratio()?, row))).collect();
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    let values = context! {
        scenes => scenes::all(study.root)?.len(),
        grids => answers::GRIDS.to_vec(),
        again => answers::AGAIN.to_vec(),
        answers => rows.len(),
        bounded => count(&bounded),
        unbounded => count(&|row| row.outcome == answers::BOUNDED && !bounded(row)),
        refused => count(&|row| row.outcome == answers::REFUSED),
        failed => count(&failed),
        failed_bounded => count(&|row| failed(row) && bounded(row)),
        rounding => count(&|row| bounded(row) && row.truth <= 0.0),
        ratios => ratios.len(),
        sharp => SHARP,
        sharp_ones => ratios.iter().filter(|(ratio, _)| SHARP <= *ratio).count(),
        largest => ratios.last().map_or(0.0, |(ratio, _)| *ratio),
        median => ratios.get(ratios.len() / 2).map_or(0.0, |(ratio, _)| *ratio),
        loosest => loosest(&ratios),
        faults,
    };
    let evidence = Evidence::new(values).file("certificates", data::text(&rows)?);
    Ok(evidence.file("faults", faults_file).data("fault-kinds", kinds))
}

/// The answers with the loosest bounds, one of a scene.
fn loosest(ratios: &[(f64, &Row)]) -> Table {
    let mut seen = BTreeSet::new();
    let of_scenes = ratios.iter().filter(|(_, row)| seen.insert(&row.scene)).take(LOOSEST);
    let header = ["scene", "route", "intervals", "our check", "true", "certified", "true over certified"];
    Table::new(header).rows(of_scenes.map(|(ratio, row)| {
        let [truth, certified, ratio] = [row.truth, row.certified, *ratio].map(|number| cell(Some(number), 2));
        let route = format!("{}, {}", row.method, row.solver);
        row![row.scene, route, row.intervals, row.status, truth, certified, ratio]
    }))
}

/// The rows of the file, those of the coarse grids computed again.
fn answers(study: &Study<'_>) -> Result<Vec<Row>, Cause> {
    let (_, mut rows): (_, Vec<Row>) = data::read(study.root, answers::PATH)?;
    let mut expected = 0;
    for (name, scene) in scenes::all(study.root)? {
        for row in answers::rows(&name, &scene, &answers::AGAIN)? {
            let stored = rows.iter_mut().find(|stored| stored.key() == row.key());
            let stored =
                stored.ok_or_else(|| format!("{} lacks {:?}: `cargo xtask certificates`", answers::PATH, row.key()))?;
            *stored = row;
            expected += 1;
        }
    }
    let expected = expected / answers::AGAIN.len() * answers::GRIDS.len();
    if rows.len() != expected {
        let path = answers::PATH;
        return Err(format!("{path} has {} rows instead of {expected}: `cargo xtask certificates`", rows.len()).into());
    }
    Ok(rows)
}

/// The values, the file with the rows of one scene computed again, and its sums over scenes.
fn broken(study: &Study<'_>) -> Result<(Value, String, Table), Cause> {
    let all = scenes::all(study.root)?;
    let mut touching = Vec::new();
    for (name, scene) in &all {
        if !theory::solve(scene)?.state.contacts.is_empty() {
            touching.push(name.as_str());
        }
    }
    let (_, mut rows): (_, Vec<faults::Row>) = data::read(study.root, faults::PATH)?;
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
    let lines: Vec<Kind> = names.into_iter().map(|name| Kind::of(name, &rows, &touching)).collect();
    let sum = |of: fn(&Kind) -> usize| lines.iter().map(of).sum::<usize>();
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
    Ok((values, data::text(&rows)?, Table::new(header).rows(lines.iter().map(Kind::data))))
}

/// A kind of fault over all scenes and routes.
#[derive(Debug)]
struct Kind {
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

impl Kind {
    fn of(name: &str, rows: &[faults::Row], touching: &[&str]) -> Self {
        let of_fault = || rows.iter().filter(|row| row.fault == name);
        let sum = |count: fn(&faults::Row) -> usize| of_fault().map(count).sum();
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

    fn data(&self) -> [String; 9] {
        let Self { fault, refused, passed, bounded, unbounded, no_numbers, .. } = self;
        let from = self.refused_from.map_or_else(String::new, |size| scientific(size, 0));
        let off_by = if *passed == 0 { String::new() } else { scientific(self.off_by, 0) };
        row![fault, refused + passed, refused, passed, from, off_by, bounded, unbounded, no_numbers]
    }
}
