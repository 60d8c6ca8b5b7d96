//! Exact-set repair: the contact set of a library, solved by the three-moment equations and judged again.

use serde::Serialize;

use super::lines::{Lines, SOLVER, finite, intervals, verdict, worst};
use super::{LIBRARIES, tolerance};
use crate::measure::plan::{EXAMPLE, OTHERS};
use crate::measure::store::Store;

/// Coarser grids say nothing new: there the set is right.
const FROM: usize = 300;

#[derive(Debug, Serialize)]
pub(super) struct Row {
    scene: &'static str,
    library: &'static str,
    tolerance: String,
    intervals: usize,
    /// Verdict and residual before and after.
    before: String,
    after: String,
    residual: [Option<f64>; 2],
    /// Largest solver error of the four observables, before and after.
    error: [Option<f64>; 2],
    /// Microseconds that it adds, and their share of the time of the library.
    added: Option<f64>,
    share: Option<f64>,
    /// Whether our judge changed its mind for the better.
    repaired: bool,
    /// Or for the worse.
    spoiled: bool,
    /// Whether there was nothing to change.
    kept: bool,
}

/// Every repair that was measured, scene by scene.
pub(super) fn of(store: &Store) -> Vec<Row> {
    let mut rows = Vec::new();
    for scene in std::iter::once(EXAMPLE).chain(OTHERS) {
        let lines = Lines::of(store, scene);
        for library in LIBRARIES {
            let route = format!("repair/{library}");
            for after in lines.of_route(&route).filter(|line| FROM <= intervals(line)) {
                let Some(asked) = after.field("tolerance") else { continue };
                let Some(before) = lines.find(&format!("force/{library}"), intervals(after), asked) else { continue };
                if before.seconds().is_none() || after.seconds().is_none() {
                    continue;
                }
                let added = after.number("added_s");
                let certified = [before, after].map(|line| line.field("status") == Some("certified"));
                rows.push(Row {
                    scene,
                    library,
                    tolerance: tolerance(asked),
                    intervals: intervals(after),
                    before: verdict(before),
                    after: after.field("status").unwrap_or("–").to_owned(),
                    residual: [finite(before, "residual"), finite(after, "residual")],
                    error: [worst(before, &SOLVER), worst(after, &SOLVER)],
                    added: added.map(|seconds| 1e6 * seconds),
                    share: added.zip(before.seconds()).map(|(added, seconds)| added / seconds),
                    repaired: certified == [false, true],
                    spoiled: certified == [true, false],
                    kept: certified == [true, true],
                });
            }
        }
    }
    rows
}
