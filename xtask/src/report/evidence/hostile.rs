//! Hostile input, and libraries at the edge: rendered from the files of `cargo xtask fuzz` and `cargo xtask hostile`, which
//! take minutes, and from the situations of the acceptance suite, which are run again.

#[path = "../../../../tests/acceptance/libraries/situations.rs"]
mod situations;

use std::fs;
use std::path::Path;

use palkki::route::{Solver, Status};
use serde::Serialize;

use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

#[derive(Debug, Serialize)]
struct Values {
    targets: Vec<Target>,
    executions: u64,
    failures: u64,
    families: Vec<Family>,
    runs: u64,
    accepted: u64,
    wrong: u64,
    panics: u64,
    contradicted: u64,
    theory_certified: u64,
    theory_answers: u64,
    active_set_certified: u64,
    active_set_answers: u64,
    situations: Vec<Situation>,
    /// Library and situation of the successes that our judge does not see.
    overruled: usize,
    asked: usize,
}

/// A fuzz target.
#[derive(Debug, Serialize)]
struct Target {
    name: String,
    executions: u64,
    edges: u64,
    corpus: u64,
    failures: u64,
}

/// A family of random scenes.
#[derive(Debug, Serialize)]
struct Family {
    name: String,
    runs: u64,
    refused: u64,
    theory: u64,
    theory_answers: u64,
    active_set: u64,
    active_set_answers: u64,
    route: u64,
    route_answers: u64,
    contradicted: u64,
    wrong: u64,
    panics: u64,
}

#[derive(Debug, Serialize)]
struct Situation {
    name: &'static str,
    cells: Vec<Cell>,
}

#[derive(Debug, Serialize)]
struct Cell {
    library: &'static str,
    word: String,
    verdict: &'static str,
    overruled: bool,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (fuzzing, fuzzed) = table(study.root, crate::fuzz::PATH)?;
    let targets: Vec<Target> = fuzzed
        .iter()
        .map(|row| {
            Ok(Target {
                name: row.word("target")?.to_owned(),
                executions: row.count("executions")?,
                edges: row.count("edges")?,
                corpus: row.count("corpus_files")?,
                failures: row.count("failures")?,
            })
        })
        .collect::<Result<_, Cause>>()?;
    let (hostile, rows) = table(study.root, crate::hostile::PATH)?;
    let families = rows.iter().map(family).collect::<Result<Vec<_>, Cause>>()?;
    let situations = situations::ALL.iter().map(situation).collect::<Result<Vec<_>, Cause>>()?;
    let sum = |of: fn(&Family) -> u64| families.iter().map(of).sum();
    let cells = || situations.iter().flat_map(|s| &s.cells);
    let data = situations.iter().flat_map(|s| {
        let name = s.name.replace(',', ";");
        s.cells
            .iter()
            .map(move |c| vec![name.clone(), c.library.to_owned(), c.word.replace(',', ";"), c.verdict.to_owned()])
    });
    let libraries = csv(&["situation", "library", "word", "verdict"], data);
    let values = Values {
        executions: targets.iter().map(|t| t.executions).sum(),
        failures: targets.iter().map(|t| t.failures).sum(),
        runs: sum(|f| f.runs),
        accepted: sum(|f| f.runs - f.refused - f.panics),
        wrong: sum(|f| f.wrong),
        panics: sum(|f| f.panics),
        contradicted: sum(|f| f.contradicted),
        theory_certified: sum(|f| f.theory),
        theory_answers: sum(|f| f.theory_answers),
        active_set_certified: sum(|f| f.active_set),
        active_set_answers: sum(|f| f.active_set_answers),
        overruled: cells().filter(|c| c.overruled).count(),
        asked: cells().count(),
        targets,
        families,
        situations,
    };
    Ok(Evidence::new(values).data("fuzzing", fuzzing).data("hostile", hostile).data("libraries", libraries))
}

fn family(row: &Row) -> Result<Family, Cause> {
    let answers = |kind: &str| -> Result<(u64, u64), Cause> {
        let certified = row.count(&format!("{kind}_certified"))?;
        Ok((certified, certified + row.count(&format!("{kind}_not_certified"))?))
    };
    let ((theory, theory_answers), (active_set, active_set_answers), (route, route_answers)) =
        (answers("theory")?, answers("active_set")?, answers("route")?);
    Ok(Family {
        name: row.word("family")?.to_owned(),
        runs: row.count("runs")?,
        refused: row.count("refused")?,
        theory,
        theory_answers,
        active_set,
        active_set_answers,
        route,
        route_answers,
        contradicted: row.count("contradicted")?,
        wrong: row.count("wrong")?,
        panics: row.count("panics")?,
    })
}

fn situation(situation: &situations::Situation) -> Result<Situation, Cause> {
    let cells = [Solver::Clarabel, Solver::Osqp].map(|library| -> Result<Cell, Cause> {
        let outcome = situation.run(library)?;
        Ok(Cell {
            library: library.word(),
            verdict: outcome.status.word(),
            overruled: outcome.claims && outcome.status != Status::Certified,
            word: outcome.word,
        })
    });
    Ok(Situation { name: situation.name, cells: cells.into_iter().collect::<Result<_, _>>()? })
}

/// A row of a file of counts, by the names of its columns.
struct Row(Vec<(String, String)>);

impl Row {
    fn word(&self, column: &str) -> Result<&str, Cause> {
        let found = self.0.iter().find(|(name, _)| name == column).map(|(_, field)| field.as_str());
        found.ok_or_else(|| format!("there is no column {column}").into())
    }

    fn count(&self, column: &str) -> Result<u64, Cause> {
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
