//! Hostile input, and libraries at the edge: rendered from the files of `cargo xtask fuzz` and `cargo xtask hostile`, which
//! take minutes, and from the situations of the acceptance suite, which are run again.

use palkki_evidence::libraries;

use super::prelude::*;
use crate::fuzz::Target;
use crate::hostile::Family;
use crate::{data, fuzz, hostile};

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (fuzzing, targets): (_, Vec<Target>) = data::read(study.root, fuzz::PATH)?;
    let (hostile, families): (_, Vec<Family>) = data::read(study.root, hostile::PATH)?;
    let (situations, libraries) = at_the_edge()?;
    let sum = |of: fn(&Family) -> usize| families.iter().map(of).sum::<usize>();
    let values = context! {
        fuzzing => context! {
            targets => targets.len(),
            executions => targets.iter().map(|target| target.executions).sum::<u64>(),
            failures => targets.iter().map(|target| target.failures).sum::<usize>(),
        },
        runs => sum(|family| family.runs),
        accepted => sum(|family| family.runs - family.refused - family.panics),
        wrong => sum(|family| family.wrong),
        panics => sum(|family| family.panics),
        contradicted => sum(|family| family.contradicted),
        families => of_families(&families),
        libraries => situations,
    };
    Ok(Evidence::new(values).file("fuzzing", fuzzing).file("hostile", hostile).data("libraries", libraries))
}

/// How many answers are certified, family by family of random scenes.
fn of_families(families: &[Family]) -> Table {
    let header =
        ["scenes", "runs", "refused", "beam theory certified", "active set certified", "other routes certified"];
    let share = |certified: usize, not: usize| format!("{} of {}", count(certified), count(certified + not));
    Table::new(header).rows(families.iter().map(|family| {
        row![
            family.family,
            count(family.runs),
            count(family.refused),
            share(family.theory_certified, family.theory_not_certified),
            share(family.active_set_certified, family.active_set_not_certified),
            share(family.route_certified, family.route_not_certified),
        ]
    }))
}

/// Libraries at the edge: the file, and a table of the situations in which a library that was asked did not solve the problem
/// or gave an answer that fails our check.
fn at_the_edge() -> Result<(Value, Table), Cause> {
    let header = ["situation", "clarabel says", "our check of it", "osqp says", "our check of that"];
    let (mut data, mut table) = (Table::new(["situation", "library", "answer", "our_check"]), Table::new(header));
    let (mut asked, mut solved, mut failed, mut good) = (0, 0, 0, 0);
    for situation in libraries::ALL {
        let (mut row, mut all_good, mut any_asked) = (row![situation.name].to_vec(), true, false);
        for library in [Solver::Clarabel, Solver::Osqp] {
            let outcome = situation.run(library)?;
            let passes = outcome.solved;
            let is_asked = !outcome.word.starts_with(NOT_ASKED);
            any_asked |= is_asked;
            all_good &= outcome.claims && passes;
            asked += usize::from(is_asked);
            solved += usize::from(outcome.claims);
            failed += usize::from(outcome.claims && !passes);
            let check = if passes { "certified" } else { "not certified" };
            data.push(row![situation.name, library, outcome.word, check]);
            row.extend([outcome.word, check.to_owned()]);
        }
        good += usize::from(all_good);
        if any_asked && !all_good {
            table.push(row);
        }
    }
    let values = context! {
        table,
        situations => libraries::ALL.len(),
        runs => data.len(),
        asked, solved, failed, good,
    };
    Ok((values, data))
}

/// How the words begin that stand for those of a library to which a quadratic program was not given.
const NOT_ASKED: &str = "not tried";
