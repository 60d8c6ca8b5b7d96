//! The price of a digit: rendered from the file of `cargo xtask measure`, which alone knows times, from whatever rows it has.

mod asked;
mod cost;
mod elsewhere;
mod left_out;
mod lines;
mod needs;
mod peers;
mod precision;
mod repair;
mod two_errors;
mod verdicts;
mod work;

use serde::Serialize;

use crate::measure::plan::{EXAMPLE, LIMIT, OTHERS};
use crate::measure::store::{self, Store};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::study::Study;
use lines::Lines;

/// Solvers in the order of figures and tables, and the methods.
const SOLVERS: [&str; 5] = ["active-set", "four-step", "nsor", "clarabel", "osqp"];
const METHODS: [&str; 3] = ["complementarity", "displacement", "force"];
const LIBRARIES: [&str; 2] = ["clarabel", "osqp"];

/// The route that others are set beside.
const OURS: &str = "force/active-set";

/// What iterative solvers are asked for where a figure or table shows one tolerance, as the file writes it.
const ASKED: &str = "1e-10";

#[derive(Debug, Serialize)]
struct Values {
    machine: Vec<String>,
    limit: f64,
    asked: String,
    measured: usize,
    left_out: left_out::Values,
    exact_microseconds: Option<f64>,
    million: Option<asked::Million>,
    exactness: Vec<asked::Exactness>,
    certificate: Option<asked::Certificate>,
    interior: Option<asked::Interior>,
    peers: peers::Values,
    two_errors: Option<two_errors::Values>,
    repairs: Vec<repair::Row>,
    needs: Vec<needs::Scene>,
    survey: Option<needs::Survey>,
    elsewhere: Vec<elsewhere::Scene>,
    exponents: Vec<cost::Exponent>,
    work: Vec<work::Row>,
    work_grids: Vec<usize>,
    precision: Vec<String>,
    cost_drawn: bool,
    map: Option<verdicts::Counts>,
    others: Option<verdicts::Counts>,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let file = std::fs::read_to_string(study.root.join(store::PATH))?;
    Ok(of(&Store::read(study.root)?, work::rows()?)?.data("measurements", file))
}

/// The chapter without the file itself.
fn of(store: &Store, work: Vec<work::Row>) -> Result<Evidence, Cause> {
    let example = Lines::of(store, EXAMPLE);
    let mut files = Vec::new();
    let (cost, exponents) = cost::drawn(&example)?;
    let cost_drawn = cost.is_some();
    files.extend(cost.map(|drawn| ("trade-cost".to_owned(), drawn)));
    let mut precision = Vec::new();
    let of_example = METHODS.map(|method| (EXAMPLE, method, method));
    let of_others = OTHERS.map(|scene| (scene, "force", scene));
    for (scene, method, name) in of_example.into_iter().chain(of_others) {
        if let Some(drawn) = precision::drawn(scene, method, &Lines::of(store, scene))? {
            precision.push(name.to_owned());
            files.push((format!("trade-{name}"), drawn));
        }
    }
    let map = verdicts::of_example(&example)?;
    let others = verdicts::of_others(store)?;
    let mut counts = [None, None];
    for ((map, name), counts) in
        [(map, "trade-verdicts"), (others, "trade-verdicts-others")].into_iter().zip(&mut counts)
    {
        if let Some((counted, drawn)) = map {
            *counts = Some(counted);
            files.push((name.to_owned(), drawn));
        }
    }
    let [map, others] = counts;
    let two_errors = two_errors::of(&example)?;
    let two_errors = two_errors.map(|(values, drawn)| {
        files.push(("trade-two-errors".to_owned(), drawn));
        values
    });
    let values = Values {
        machine: store.described.clone(),
        limit: LIMIT,
        asked: tolerance(ASKED),
        measured: store.lines.iter().filter(|line| line.seconds().is_some()).count(),
        left_out: left_out::of(store),
        exact_microseconds: example.seconds_of("exact/free-boundary", 0, "0e0").map(|seconds| 1e6 * seconds),
        million: asked::million(&example),
        exactness: asked::exactness(&example),
        certificate: asked::certificate(&example),
        interior: asked::interior(&example),
        peers: peers::of(&example),
        two_errors,
        repairs: repair::of(store),
        needs: needs::of(store),
        survey: needs::survey(store),
        elsewhere: elsewhere::of(store),
        exponents,
        work,
        work_grids: work::GRIDS.to_vec(),
        precision,
        cost_drawn,
        map,
        others,
    };
    let evidence = Evidence::new(values);
    Ok(files.into_iter().fold(evidence, |evidence, (name, (svg, csv))| evidence.figure(&name, svg, csv)))
}

/// `1e-10` of the file as `10⁻¹⁰`.
fn tolerance(text: &str) -> String {
    text.strip_prefix("1e").and_then(|exponent| exponent.parse().ok()).map_or_else(|| text.to_owned(), power)
}
