//! The price of a digit: rendered from the file of `cargo xtask measure`, which alone knows times.

mod cost;
mod precision;
mod verdicts;

use serde::Serialize;

use crate::measure::store::{Line, Store};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

/// The scene that the figures show; the file has others as well.
const SCENE: &str = "heinisuo-1984";

/// Routes in the order of figures and tables.
const SOLVERS: [&str; 5] = ["active-set", "four-step", "nsor", "clarabel", "osqp"];

/// What iterative solvers are asked for where a figure or table shows one tolerance.
const ASKED: &str = "1e-10";

#[derive(Debug, Serialize)]
struct Values {
    machine: Vec<String>,
    asked: &'static str,
    measured: usize,
    left_out: usize,
    exact_microseconds: f64,
    grids: Vec<verdicts::Beside>,
    exponents: Vec<cost::Exponent>,
    wrong: usize,
    judged: usize,
    everywhere: Vec<String>,
    million: Option<Million>,
}

/// The force method with the active set on the finest grid.
#[derive(Debug, Serialize)]
struct Million {
    intervals: usize,
    milliseconds: f64,
    reaction_error: f64,
    certified: bool,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let store = Store::read(study.root)?;
    let shown: Vec<&Line> = store.lines.iter().filter(|line| line.field("scene") == Some(SCENE)).collect();
    let map = verdicts::map(&shown)?;
    let (cost, cost_csv, exponents) = cost::drawn(&shown)?;
    let seconds = |route: &str| shown.iter().find(|line| line.field("route") == Some(route)).and_then(|l| l.seconds());
    let values = Values {
        machine: store.described.clone(),
        asked: "10⁻¹⁰",
        measured: store.lines.iter().filter(|line| line.seconds().is_some()).count(),
        left_out: store.lines.iter().filter(|line| line.seconds().is_none()).count(),
        exact_microseconds: 1e6
            * seconds("exact/free-boundary").ok_or("measurements.csv has no line for beam theory")?,
        grids: verdicts::beside(&shown),
        exponents,
        wrong: map.wrong,
        judged: map.judged,
        everywhere: map.everywhere,
        million: million(&shown),
    };
    let mut evidence = Evidence::new(values)
        .figure("trade-cost", cost, cost_csv)
        .figure("trade-verdicts", map.svg, map.csv)
        .data("measurements", std::fs::read_to_string(study.root.join(crate::measure::store::PATH))?);
    for method in ["complementarity", "displacement", "force"] {
        let (svg, csv) = precision::drawn(method, &shown)?;
        evidence = evidence.figure(&format!("trade-{method}"), svg, csv);
    }
    Ok(evidence)
}

fn million(lines: &[&Line]) -> Option<Million> {
    let of_route =
        lines.iter().filter(|line| line.field("route") == Some("force/active-set") && line.seconds().is_some());
    let finest = of_route.max_by(|a, b| intervals(a).total_cmp(&intervals(b)))?;
    Some(Million {
        intervals: finest.field("intervals")?.parse().ok()?,
        milliseconds: 1e3 * finest.seconds()?,
        reaction_error: finest.number("reaction_total")?,
        certified: finest.field("status") == Some("certified"),
    })
}

/// Intervals of a line, as a number for axes.
fn intervals(line: &Line) -> f64 {
    line.number("intervals").unwrap_or(f64::NAN)
}

/// The lines of a route as asked for [`ASKED`], or for nothing where nothing can be asked; coarse grids first.
fn asked<'a>(lines: &[&'a Line], route: &str) -> Vec<&'a Line> {
    let wanted =
        |line: &&&Line| line.field("route") == Some(route) && matches!(line.field("tolerance"), Some(ASKED | "0e0"));
    let mut found: Vec<&Line> = lines.iter().filter(wanted).copied().collect();
    found.sort_by(|a, b| intervals(a).total_cmp(&intervals(b)));
    found
}
