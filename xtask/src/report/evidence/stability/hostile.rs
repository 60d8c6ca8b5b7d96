//! Hostile input: rendered from the file of `cargo xtask hostile`, which takes minutes.

use std::collections::BTreeMap;

use crate::report::evidence::prelude::*;
use crate::{data, hostile};

/// The sum of each column over the families, and how many runs had an answer.
pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (text, families): (_, Vec<BTreeMap<String, String>>) = data::read(study.root, hostile::PATH)?;
    let mut sums: BTreeMap<&str, usize> = BTreeMap::new();
    for (column, count) in families.iter().flatten().filter(|(column, _)| *column != "family") {
        *sums.entry(column).or_default() += count.parse::<usize>()?;
    }
    let sum = |column| sums.get(column).copied().unwrap_or_default();
    let accepted = sum("runs") - sum("refused") - sum("panics");
    let values = context! { accepted, ..Value::from_pairs(sums) };
    Ok(Evidence::new(values).file("hostile", text))
}
