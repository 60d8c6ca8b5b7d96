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
    };
    Ok(Evidence::new(values).file("hostile", hostile))
}
