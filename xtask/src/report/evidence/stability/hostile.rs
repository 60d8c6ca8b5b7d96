//! Hostile input: rendered from the file of `cargo xtask hostile`, which takes minutes.

use crate::hostile::Family;
use crate::report::evidence::prelude::*;
use crate::{data, hostile};

pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (hostile, families): (_, Vec<Family>) = data::read(study.root, hostile::PATH)?;
    let sum = |of: fn(&Family) -> usize| families.iter().map(of).sum::<usize>();
    let values = context! {
        runs => sum(|family| family.runs),
        accepted => sum(|family| family.runs - family.refused - family.panics),
        wrong => sum(|family| family.wrong),
        panics => sum(|family| family.panics),
        contradicted => sum(|family| family.contradicted),
        derived => sum(|family| family.derived),
        swept => sum(|family| family.swept),
        solved => sum(|family| family.theory_solved),
        bounded => sum(|family| family.theory_bounded),
        certified => sum(|family| family.theory_certified),
        all_but_turns => sum(|family| family.theory_all_but_turns),
        families => of_families(&families),
    };
    Ok(Evidence::new(values).file("hostile", hostile))
}

/// How many answers are solved, family by family of random scenes.
fn of_families(families: &[Family]) -> Table {
    let header = ["scenes", "runs", "refused", "beam theory solved", "active set solved", "other routes solved"];
    let share = |solved: usize, not: usize| format!("{} of {}", count(solved), count(solved + not));
    Table::new(header).rows(families.iter().map(|family| {
        row![
            family.family,
            count(family.runs),
            count(family.refused),
            share(family.theory_solved, family.theory_not_solved),
            share(family.active_set_solved, family.active_set_not_solved),
            share(family.route_solved, family.route_not_solved),
        ]
    }))
}
