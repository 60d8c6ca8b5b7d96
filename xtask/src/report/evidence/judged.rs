//! Certificates beside true errors, and fault injection: rendered from the files of `cargo xtask certificates`, part of which
//! is computed again each time.

mod faults;

use std::collections::BTreeSet;
use std::fs;

use minijinja::context;

use crate::certificates::answers::{self, Row};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::cell;
use crate::report::scenes;
use crate::report::study::Study;
use crate::report::table::Table;

/// A bound that is larger than the true error by a tenth at most is called sharp.
const SHARP: f64 = 0.9;

/// Rows of the table of the loosest bounds.
const LOOSEST: usize = 5;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let rows = answers(study)?;
    if let Some(row) = rows.iter().find(|row| row.outcome.starts_with(answers::EXCEPTION)) {
        return Err(format!("a certificate guaranteed what is not so: {row:?}").into());
    }
    let (faults, faults_file, kinds) = faults::summary(study)?;
    let count = |is: &dyn Fn(&Row) -> bool| rows.iter().filter(|row| is(row)).count();
    let bounded = |row: &Row| row.outcome == answers::BOUNDED && row.certified.is_finite();
    let failed = |row: &Row| row.status != "certified";
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
        loosest => loosest(&ratios).to_string(),
        faults,
    };
    let evidence = Evidence::new(values).data("certificates", answers::text(&rows));
    Ok(evidence.data("faults", faults_file).data("fault-kinds", kinds))
}

/// The answers with the loosest bounds, one of a scene.
fn loosest(ratios: &[(f64, &Row)]) -> Table {
    let mut seen = BTreeSet::new();
    let of_scenes = ratios.iter().filter(|(_, row)| seen.insert(&row.scene)).take(LOOSEST);
    let header = ["scene", "route", "intervals", "our check", "true", "certified", "true over certified"];
    of_scenes.fold(Table::new(header), |table, (ratio, row)| {
        let [truth, certified, ratio] = [row.truth, row.certified, *ratio].map(|number| cell(Some(number), 2));
        let route = format!("{}, {}", row.method, row.solver);
        let status = row.status.replace('-', " ");
        table.row([row.scene.clone(), route, row.intervals.to_string(), status, truth, certified, ratio])
    })
}

/// The rows of the file, those of the coarse grids computed again.
fn answers(study: &Study<'_>) -> Result<Vec<Row>, Cause> {
    let mut rows = answers::parse(&fs::read_to_string(study.root.join(answers::PATH))?)?;
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
