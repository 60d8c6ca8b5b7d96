//! Certificates beside true errors, and fault injection: rendered from the files of `cargo xtask certificates`, part of which
//! is computed again each time.

use std::collections::BTreeSet;
use std::fmt::Debug;

use palkki_evidence::faults::SIZES;

use super::prelude::*;
use crate::certificates::answers::{self, Row};
use crate::certificates::{self, CLOSED, HELD, faults};
use crate::data;

/// A bound that is larger than the true error by a tenth at most is called sharp.
const SHARP: f64 = 0.9;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let rows = answers(study)?;
    // Where there is no number, both are infinite.
    let is_false =
        |row: &&Row| row.outcome.starts_with(answers::EXCEPTION) || row.certified < row.truth || row.certified.is_nan();
    if let Some(row) = rows.iter().find(is_false) {
        return Err(format!("a certificate guaranteed what is not so: {row:?}").into());
    }
    let (faults, faults_file) = broken(study)?;
    let count = |is: &dyn Fn(&Row) -> bool| rows.iter().filter(|row| is(row)).count();
    let bounded = |row: &Row| row.outcome == answers::BOUNDED && row.certified.is_finite();
    let failed = |row: &Row| row.status != "solved";
    let mut ratios: Vec<(f64, &Row)> = rows.iter().filter_map(|row| Some((row.ratio()?, row))).collect();
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    let values = context! {
        scenes => names(&rows, "").len(),
        held => names(&rows, HELD).len(),
        closed => names(&rows, CLOSED).len(),
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
        median => data::median(&ratios.iter().map(|(ratio, _)| *ratio).collect::<Vec<_>>()).unwrap_or_default(),
        faults,
    };
    let evidence = Evidence::new(values).file("certificates", data::text(&rows)?);
    Ok(evidence.file("faults", faults_file))
}

/// The names that begin with something.
fn names<'a>(rows: &'a [Row], prefix: &str) -> BTreeSet<&'a str> {
    rows.iter().map(|row| row.scene.as_str()).filter(|name| name.starts_with(prefix)).collect()
}

/// Puts rows that were computed again into their places.
fn renew<R: Debug>(path: &str, rows: &mut [R], again: Vec<R>, same: impl Fn(&R, &R) -> bool) -> Result<(), Cause> {
    for row in again {
        match rows.iter_mut().find(|stored| same(stored, &row)) {
            Some(stored) => *stored = row,
            None => return Err(format!("{path} lacks {row:?}: `cargo xtask certificates`").into()),
        }
    }
    Ok(())
}

/// The rows of the file, those of the gallery on coarse grids computed again.
fn answers(study: &Study<'_>) -> Result<Vec<Row>, Cause> {
    let (_, mut rows): (_, Vec<Row>) = data::read(study.root, answers::PATH)?;
    for subject in certificates::gallery(study.root)? {
        renew(answers::PATH, &mut rows, answers::rows(&subject, &answers::AGAIN)?, |a, b| a.key() == b.key())?;
    }
    let expected = names(&rows, "").len() * answers::GRIDS.len() * Method::ALL.len() * Solver::ALL.len();
    if rows.len() != expected {
        let path = answers::PATH;
        return Err(format!("{path} has {} rows instead of {expected}: `cargo xtask certificates`", rows.len()).into());
    }
    Ok(rows)
}

/// The values, and the file with the rows of one scene computed again.
fn broken(study: &Study<'_>) -> Result<(Value, String), Cause> {
    let all = certificates::gallery(study.root)?;
    let (_, mut rows): (_, Vec<faults::Row>) = data::read(study.root, faults::PATH)?;
    for subject in all.iter().filter(|subject| subject.name == faults::AGAIN) {
        let same = |a: &faults::Row, b: &faults::Row| a.scene == b.scene && a.fault == b.fault;
        renew(faults::PATH, &mut rows, faults::rows(subject, &all)?, same)?;
    }
    if let Some(subject) = all.iter().find(|subject| rows.iter().all(|row| row.scene != subject.name)) {
        return Err(format!("{} has no faults for {}: `cargo xtask certificates`", faults::PATH, subject.name).into());
    }
    if let Some(row) = rows.iter().find(|row| 0 < row.exceptions) {
        return Err(format!("a certificate guaranteed what is not so: {row:?}").into());
    }
    let sum = |of: fn(&faults::Row) -> usize| rows.iter().map(of).sum::<usize>();
    let kinds: BTreeSet<&str> = rows.iter().map(|row| row.fault.as_str()).collect();
    let turning = certificates::turning(study.root)?;
    let discrete = rows.iter().filter(|row| !row.fault.starts_with(faults::EXACT) && !turning.contains(&row.scene));
    let values = context! {
        intervals => faults::INTERVALS,
        again => faults::AGAIN,
        kinds => kinds.len(),
        sized => kinds.iter().filter(|fault| faults::is_sized(fault)).count(),
        sizes => SIZES.len(),
        smallest => SIZES[0],
        answers => sum(|row| row.refused + row.passed),
        refused => sum(|row| row.refused),
        passed => sum(|row| row.passed),
        turning => turning.len(),
        off_by => largest(discrete.map(|row| row.off_by)),
        bounded => sum(|row| row.bounded),
        unbounded => sum(|row| row.unbounded),
        no_numbers => sum(|row| row.no_numbers),
    };
    Ok((values, data::text(&rows)?))
}
