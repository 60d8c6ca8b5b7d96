//! Surveys on soil, rendered from the file of `cargo xtask measure`: the grid-free solution beside finite elements.

use super::prelude::*;
use crate::data;
use crate::measure::instruments;
use crate::measure::soil::{Line, PATH};

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (text, lines): (String, Vec<Line>) = data::read(study.root, PATH)?;
    let header = [
        "soil, N/m²",
        "readings",
        "contacts",
        "grid-free, s",
        "with bounds, s",
        "proven error",
        "elements, s",
        "systems",
        "deflection error",
        "moment error",
    ];
    let rows = lines.iter().map(|line| {
        let proven = if line.is_certified() { error_cell(line.proven) } else { "not certified".to_owned() };
        let systems = if line.settled { count(line.steps) } else { format!("not settled in {}", line.steps) };
        [
            times_ten(line.soil, 0),
            count(line.readings),
            count(line.contacts),
            cell(line.exact_s, 2),
            cell(line.certified_s, 2),
            proven,
            cell(line.elements_s, 2),
            systems,
            error_cell(line.deflection_off),
            error_cell(line.moment_off),
        ]
    });
    let ratio = |line: &Line| Some(line.certified_s? / line.elements_s?).filter(|_| line.settled);
    let certified = lines.iter().filter(|line| line.is_certified());
    let values = context! {
        made => instruments::provenance(&instruments::described(&text)),
        pipes => lines.len(),
        certified => certified.clone().count(),
        proven => certified.filter_map(|line| line.proven).reduce(f64::max),
        settled => lines.iter().filter(|line| line.settled).count(),
        over_elements => least_most(lines.iter().filter_map(ratio)),
        moment_off => least_most(lines.iter().filter_map(|line| line.moment_off)),
        table => Table::new(header.map(str::to_owned)).rows(rows),
    };
    Ok(Evidence::new(values).file("soil-surveys", text))
}
