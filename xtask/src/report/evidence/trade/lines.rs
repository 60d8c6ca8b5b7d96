//! The lines of one scene, and how they are asked.

use super::ASKED;
use crate::measure::store::{Line, Store};

/// Columns of the errors of the solver alone and of grid and solver together, in the order of the observables.
pub(super) const SOLVER: [&str; 4] = ["reaction_solver", "contact_solver", "deflection_solver", "energy_solver"];
pub(super) const TOTAL: [&str; 4] = ["reaction_total", "contact_total", "deflection_total", "energy_total"];

/// The lines of a scene.
#[derive(Debug)]
pub(super) struct Lines<'a>(Vec<&'a Line>);

impl<'a> Lines<'a> {
    pub(super) fn of(store: &'a Store, scene: &str) -> Self {
        Self(store.lines.iter().filter(|line| line.field("scene") == Some(scene)).collect())
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &'a Line> + '_ {
        self.0.iter().copied()
    }

    /// All lines of a route.
    pub(super) fn of_route<'b>(&'b self, route: &'b str) -> impl Iterator<Item = &'a Line> + 'b {
        self.iter().filter(move |line| line.field("route") == Some(route))
    }

    /// One line.
    pub(super) fn find(&self, route: &str, intervals: usize, tolerance: &str) -> Option<&'a Line> {
        let intervals = intervals.to_string();
        self.of_route(route)
            .find(|line| line.field("intervals") == Some(&intervals) && line.field("tolerance") == Some(tolerance))
    }

    pub(super) fn seconds_of(&self, route: &str, intervals: usize, tolerance: &str) -> Option<f64> {
        self.find(route, intervals, tolerance)?.seconds()
    }

    /// The lines of a route as asked for [`ASKED`], or for nothing where nothing can be asked; coarse grids first.
    pub(super) fn asked(&self, route: &str) -> Vec<&'a Line> {
        let mut found: Vec<&Line> =
            self.of_route(route).filter(|line| matches!(line.field("tolerance"), Some(ASKED | "0e0"))).collect();
        found.sort_by_key(|line| intervals(line));
        found
    }

    /// The tolerances that a route was asked for, loose ones first.
    pub(super) fn tolerances(&self, route: &str) -> Vec<&'a str> {
        let mut found: Vec<&str> = self.of_route(route).filter_map(|line| line.field("tolerance")).collect();
        let value = |text: &str| text.parse().unwrap_or(0.0_f64);
        found.sort_by(|a, b| value(b).total_cmp(&value(a)));
        found.dedup();
        found
    }
}

/// Intervals of a line; 0 for beam theory.
pub(super) fn intervals(line: &Line) -> usize {
    line.field("intervals").and_then(|n| n.parse().ok()).unwrap_or(0)
}

/// Intervals as a number for axes.
pub(super) fn place(line: &Line) -> f64 {
    line.number("intervals").unwrap_or(f64::NAN)
}

/// A finite number of a column.
pub(super) fn finite(line: &Line, column: &str) -> Option<f64> {
    line.number(column).filter(|value| value.is_finite())
}

/// The largest of some errors; none if one of them is no number.
pub(super) fn worst(line: &Line, columns: &[&str]) -> Option<f64> {
    columns.iter().try_fold(0.0, |worst: f64, column| Some(worst.max(finite(line, column)?)))
}

/// The status, with a claim of success that is none.
pub(super) fn verdict(line: &Line) -> String {
    let status = line.field("status").unwrap_or("–");
    let wrong = status == "not-certified" && line.field("claims") == Some("success");
    if wrong { format!("{status}, and says solved") } else { status.to_owned() }
}
