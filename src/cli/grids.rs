//! What it took to find a grid, for a person.

use super::answer::{Answer, Search};
use super::number::{magnitude, magnitude_at_most};
use super::table::{Row, list, table};

/// What it took to find the grid.
pub(super) fn grids(answer: &Answer, search: &Search) -> String {
    let rows: Vec<Row> = search
        .tries
        .iter()
        .map(|(t, seconds)| {
            vec![
                t.intervals.to_string(),
                magnitude(t.tolerance),
                t.iterations.to_string(),
                magnitude(t.residual),
                magnitude_at_most(t.error),
                magnitude(*seconds),
            ]
        })
        .collect();
    let header = ["intervals", "solver asked for", "iterations", "residual", "error, relative", "seconds"];
    let end = match answer.error {
        error if error.is_finite() => {
            format!("{}, with {} on {} intervals", search.end, magnitude_at_most(error), answer.intervals.unwrap_or(0))
        }
        _ => format!("{}, with no bound on the error", search.end),
    };
    let demanded = format!("an error of the deflection of at most {} of its largest value", magnitude(search.demanded));
    let seconds = format!("{} in all, bounds included", magnitude(search.seconds));
    table("Grids tried", &header, &rows) + "\n" + &list(&[("demanded", demanded), ("end", end), ("seconds", seconds)])
}
