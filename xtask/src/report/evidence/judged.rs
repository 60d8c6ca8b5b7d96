//! The judge is judged: rendered from the files of `cargo xtask judge`, part of which is computed again each time.

mod faults;
mod ratios;

use std::fs;

use serde::Serialize;

use crate::judge::answers::{self, Row};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::scenes;
use crate::report::study::Study;

/// A bound that is larger than the true error by a tenth at most is called sharp.
const SHARP: f64 = 0.9;

#[derive(Debug, Serialize)]
struct Values {
    scenes: usize,
    grids: [usize; 5],
    again: [usize; 2],
    /// All answers, those with a finite bound, with an infinite one, with numbers that are none.
    answers: usize,
    bounded: usize,
    unbounded: usize,
    refused: usize,
    /// Answers that failed the check of their discrete problem or did not converge, and have a true finite bound.
    failed: usize,
    failed_bounded: usize,
    /// Answers whose true error is rounding; they have no ratio.
    rounding: usize,
    rows: Vec<ratios::Route>,
    loosest: Vec<ratios::Place>,
    /// Ratios: how many, how many of at least [`SHARP`], the largest, and the median.
    ratios: usize,
    sharp: f64,
    sharp_ones: usize,
    largest: f64,
    median: f64,
    faults: faults::Summary,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let rows = answers(study)?;
    if let Some(row) = rows.iter().find(|row| row.outcome.starts_with(answers::EXCEPTION)) {
        return Err(format!("the judge guaranteed what is not so: {row:?}").into());
    }
    let (faults, faults_file) = faults::summary(study)?;
    let bounded = |row: &&Row| row.outcome == answers::BOUNDED && row.certified.is_finite();
    let failed = || rows.iter().filter(|row| row.status != "certified");
    let mut ratios: Vec<f64> = rows.iter().filter_map(Row::ratio).collect();
    let values = Values {
        scenes: scenes::all(study.root)?.len(),
        grids: answers::GRIDS,
        again: answers::AGAIN,
        answers: rows.len(),
        bounded: rows.iter().filter(bounded).count(),
        unbounded: rows.iter().filter(|row| row.outcome == answers::BOUNDED && row.certified.is_infinite()).count(),
        refused: rows.iter().filter(|row| row.outcome == answers::REFUSED).count(),
        failed: failed().count(),
        failed_bounded: failed().filter(bounded).count(),
        rounding: rows.iter().filter(|row| row.outcome == answers::BOUNDED && row.truth <= 0.0).count(),
        rows: ratios::routes(&rows),
        loosest: ratios::loosest(&rows),
        ratios: ratios.len(),
        sharp: SHARP,
        sharp_ones: ratios.iter().filter(|ratio| SHARP <= **ratio).count(),
        largest: ratios.iter().copied().fold(0.0, f64::max),
        median: ratios::median(&mut ratios),
        faults,
    };
    Ok(Evidence::new(values).data("judged", answers::text(&rows)).data("faults", faults_file))
}

/// The rows of the file, those of the coarse grids computed again.
fn answers(study: &Study<'_>) -> Result<Vec<Row>, Cause> {
    let mut rows = answers::parse(&fs::read_to_string(study.root.join(answers::PATH))?)?;
    let mut expected = 0;
    for (name, scene) in scenes::all(study.root)? {
        for row in answers::rows(&name, &scene, &answers::AGAIN)? {
            let stored = rows.iter_mut().find(|stored| stored.key() == row.key());
            let stored =
                stored.ok_or_else(|| format!("{} lacks {:?}: `cargo xtask judge`", answers::PATH, row.key()))?;
            *stored = row;
            expected += 1;
        }
    }
    let expected = expected / answers::AGAIN.len() * answers::GRIDS.len();
    if rows.len() != expected {
        let path = answers::PATH;
        return Err(format!("{path} has {} rows instead of {expected}: `cargo xtask judge`", rows.len()).into());
    }
    Ok(rows)
}
