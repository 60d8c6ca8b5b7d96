//! Hostile input, and libraries at the edge: rendered from the files of `cargo xtask fuzz` and `cargo xtask hostile`, which
//! take minutes, and from the situations of the acceptance suite, which are run again.

use std::fs;
use std::path::Path;

use minijinja::{Value, context};
use palkki::route::{Solver, Status};
use palkki_evidence::libraries::ALL;

use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::thousands;
use crate::report::study::Study;
use crate::report::table::Table;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (fuzzing, targets) = table(study.root, crate::fuzz::PATH)?;
    let (hostile, families) = table(study.root, crate::hostile::PATH)?;
    let (libraries, situations) = libraries()?;
    let values = context! {
        fuzzing => context! {
            targets => targets.len(),
            executions => sum(&targets, &["executions"])?,
            failures => sum(&targets, &["failures"])?,
        },
        runs => sum(&families, &["runs"])?,
        accepted => sum(&families, &["runs"])? - sum(&families, &["refused", "panics"])?,
        wrong => sum(&families, &["wrong"])?,
        panics => sum(&families, &["panics"])?,
        contradicted => sum(&families, &["contradicted"])?,
        families => of_families(&families)?.to_string(),
        libraries => situations,
    };
    Ok(Evidence::new(values).data("fuzzing", fuzzing).data("hostile", hostile).data("libraries", libraries))
}

/// How many answers are certified, family by family of random scenes.
fn of_families(families: &[Row]) -> Result<Table, Cause> {
    let header =
        ["scenes", "runs", "refused", "beam theory certified", "active set certified", "other routes certified"];
    families.iter().try_fold(Table::new(header), |table, row| {
        let count = |column: &str| row.count(column).map(thousands);
        let share = |kind: &str| -> Result<String, Cause> {
            let certified = row.count(&format!("{kind}_certified"))?;
            let all = certified + row.count(&format!("{kind}_not_certified"))?;
            Ok(format!("{} of {}", thousands(certified), thousands(all)))
        };
        let shares = [share("theory")?, share("active_set")?, share("route")?];
        let first = [row.word("family")?.to_owned(), count("runs")?, count("refused")?];
        Ok(table.row(first.into_iter().chain(shares)))
    })
}

/// Libraries at the edge: the file, and a table of the situations in which a library that was asked did not solve the problem
/// or gave an answer that fails our check.
fn libraries() -> Result<(String, Value), Cause> {
    let header = ["situation", "clarabel says", "our check of it", "osqp says", "our check of that"];
    let (mut data, mut table) = (Vec::new(), Table::new(header));
    let (mut asked, mut solved, mut failed, mut good) = (0, 0, 0, 0);
    for situation in ALL {
        let (mut row, mut all_good, mut any_asked) = (vec![situation.name.to_owned()], true, false);
        for library in [Solver::Clarabel, Solver::Osqp] {
            let outcome = situation.run(library)?;
            let passes = outcome.status == Status::Certified;
            let is_asked = !outcome.word.starts_with(NOT_ASKED);
            any_asked |= is_asked;
            all_good &= outcome.claims && passes;
            asked += usize::from(is_asked);
            solved += usize::from(outcome.claims);
            failed += usize::from(outcome.claims && !passes);
            let check = if passes { "certified" } else { "not certified" };
            let name = situation.name.replace(',', ";");
            data.push(vec![name, library.word().to_owned(), outcome.word.replace(',', ";"), check.to_owned()]);
            row.extend([outcome.word, check.to_owned()]);
        }
        good += usize::from(all_good);
        if any_asked && !all_good {
            table = table.row(row);
        }
    }
    let values = context! {
        table => table.to_string(),
        situations => ALL.len(),
        runs => data.len(),
        asked, solved, failed, good,
    };
    Ok((csv(&["situation", "library", "answer", "our_check"], data), values))
}

/// How the words begin that stand for those of a library to which a quadratic program was not given.
const NOT_ASKED: &str = "not tried";

/// The sum of some columns.
fn sum(rows: &[Row], columns: &[&str]) -> Result<i64, Cause> {
    let counts = rows.iter().flat_map(|row| columns.iter().map(|column| row.count(column)));
    counts.sum()
}

/// A row of a file of counts, by the names of its columns.
struct Row(Vec<(String, String)>);

impl Row {
    fn word(&self, column: &str) -> Result<&str, Cause> {
        let found = self.0.iter().find(|(name, _)| name == column).map(|(_, field)| field.as_str());
        found.ok_or_else(|| format!("there is no column {column}").into())
    }

    fn count(&self, column: &str) -> Result<i64, Cause> {
        Ok(self.word(column)?.parse()?)
    }
}

/// A file of counts, as it is and by rows.
fn table(root: &Path, path: &str) -> Result<(String, Vec<Row>), Cause> {
    let text = fs::read_to_string(root.join(path))?;
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let row =
        |line: &str| Row(header.iter().zip(line.split(',')).map(|(n, f)| ((*n).to_owned(), f.to_owned())).collect());
    let rows = lines.map(row).collect();
    Ok((text, rows))
}
