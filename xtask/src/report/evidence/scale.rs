//! Time and memory over the points of a survey: rendered from the file of `cargo xtask measure --scale`. Only certified runs
//! count as results.

mod drawn;

use palkki_evidence::extremes::Ground;

use super::prelude::*;
use crate::measure::scale::{LOADS, Line, Route, Scale};

const EXACT: Route = Route::Exact;
const ACTIVE_SET: Route = Route::Force(Solver::ActiveSet);
const INTERIOR_POINT: Route = Route::Force(Solver::Clarabel);

/// The name of a route in tables and figures.
fn label(route: Route) -> &'static str {
    match route {
        EXACT => "exact",
        INTERIOR_POINT => "clarabel",
        Route::Force(_) => "active set",
    }
}

/// `1` and `10⁴`: the loads are powers of ten.
fn load_name(load: f64) -> String {
    match exponent_of(load) {
        Some(0) | None => format!("{load}"),
        Some(exponent) => power_of_ten(exponent),
    }
}

/// A survey: ground, load and points.
type Survey = (Ground, f64, u32);

/// The line of a survey by a route.
fn line(scale: &Scale, (ground, load, points): Survey, route: Route) -> Option<&Line> {
    let wanted = route.name();
    scale.lines.iter().find(|line| {
        line.ground == ground.name()
            && line.load.total_cmp(&load).is_eq()
            && line.points == points
            && line.route == wanted
    })
}

/// The same, if it is certified.
fn certified(scale: &Scale, survey: Survey, route: Route) -> Option<&Line> {
    line(scale, survey, route).filter(|line| line.is_solved())
}

/// Surveys that are measured and not refused, in the order of the table.
fn surveys(scale: &Scale) -> Vec<Survey> {
    let mut sizes: Vec<u32> = scale.lines.iter().filter(|line| !line.is_refused()).map(|line| line.points).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut surveys = Vec::new();
    for ground in Ground::ALL {
        for load in LOADS {
            surveys.extend(sizes.iter().map(|points| (ground, load, *points)));
        }
    }
    surveys
}

/// The least and the greatest of some numbers, for a template.
fn least_most(numbers: impl IntoIterator<Item = f64>) -> Option<Value> {
    range(numbers).map(|[least, most]| context! { least, most })
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (file, scale) = Scale::read(study.root)?;
    let surveys = surveys(&scale);
    let exact = || scale.lines.iter().filter(|line| line.route == EXACT.name());
    let most = surveys.iter().map(|(.., points)| *points).max().ok_or("no survey is measured")?;
    let of_most = || surveys.iter().filter(|(.., points)| *points == most);
    let seconds = |survey: &Survey, route| certified(&scale, *survey, route)?.median_s;
    let ratio = |of: Route, over: Route| {
        let pairs =
            surveys.iter().filter_map(move |survey| Some((survey.2, seconds(survey, of)?, seconds(survey, over)?)));
        pairs.map(|(points, a, b)| (points, a / b)).collect::<Vec<_>>()
    };
    let interior = ratio(INTERIOR_POINT, EXACT);
    let largest_interior = interior.iter().map(|(points, _)| *points).max().unwrap_or(0);
    let [(time, time_figure), (memory, memory_figure)] =
        [drawn::time(&scale, &surveys)?, drawn::memory(&scale, &surveys)?];
    let values = context! {
        commit => scale.description("commit"),
        date => scale.description("date"),
        processor => scale.description("machine"),
        compiler => scale.description("compiler"),
        patience => [EXACT.patience(), INTERIOR_POINT.patience()],
        most,
        surveys => of_most().count(),
        solved => of_most().filter(|survey| certified(&scale, **survey, EXACT).is_some()).count(),
        seconds => least_most(of_most().filter_map(|survey| seconds(survey, EXACT))),
        grid_seconds => least_most(of_most().filter_map(|survey| seconds(survey, ACTIVE_SET))),
        lists => exact().filter(|line| line.is_solved()).filter_map(|line| line.lists).max(),
        residual => exact().filter(|line| line.is_solved()).filter_map(|line| line.residual).max_by(f64::total_cmp),
        ten_times => least_most(ten_times(&scale, &surveys)),
        exact_over_grid => least_most(ratio(EXACT, ACTIVE_SET).into_iter().map(|(_, ratio)| ratio)),
        slowest_beside_grid => slowest_beside_grid(&scale, &surveys),
        interior_over_exact => least_most(interior.iter().filter(|(p, _)| *p == largest_interior).map(|(_, ratio)| *ratio)),
        largest_interior,
        grid_off => least_most(surveys.iter().filter_map(|survey| grid_off(&scale, *survey))),
        refused => scale.lines.iter().find(|line| line.is_refused()).map(|line| line.why.clone()),
        without_result => without_result(&scale),
        single => scale.lines.iter().filter(|line| line.runs == Some(1)).count(),
        titles => [time, memory],
        table => table(&scale, &surveys),
    };
    Ok(Evidence::new(values).file("scale", file).figures([time_figure, memory_figure]))
}

/// How many times as long the exact solution takes of the largest survey as of one with a tenth of its points.
fn ten_times(scale: &Scale, surveys: &[Survey]) -> Vec<f64> {
    let most = surveys.iter().map(|(.., points)| *points).max().unwrap_or(0);
    let seconds = |survey: Survey| certified(scale, survey, EXACT)?.median_s;
    let largest = surveys.iter().filter(|(.., points)| *points == most);
    largest
        .filter_map(|&(ground, load, _)| Some(seconds((ground, load, most))? / seconds((ground, load, most / 10))?))
        .collect()
}

/// The survey on which the exact solution takes longest beside the active set.
fn slowest_beside_grid(scale: &Scale, surveys: &[Survey]) -> Option<String> {
    let seconds = |survey, route| certified(scale, survey, route)?.median_s;
    let ratios =
        surveys.iter().filter_map(|&survey| Some((survey, seconds(survey, EXACT)? / seconds(survey, ACTIVE_SET)?)));
    let ((ground, load, points), _) = ratios.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let points = count(points);
    Some(format!("{}, q = {}, {points} points", ground.name(), load_name(load)))
}

/// By how much the energy on the grid of the active set differs from that of the exact solution, over the latter.
fn grid_off(scale: &Scale, survey: Survey) -> Option<f64> {
    let energy = |route| certified(scale, survey, route)?.energy;
    let exact = energy(EXACT)?;
    Some(((energy(ACTIVE_SET)? - exact) / exact).abs())
}

/// What has no certified result, a sentence for each series of points: the first line that says why.
fn without_result(scale: &Scale) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    for route in [EXACT, ACTIVE_SET, INTERIOR_POINT] {
        for ground in Ground::ALL {
            for load in LOADS {
                let lines = scale.lines.iter().filter(|line| {
                    line.route == route.name() && line.ground == ground.name() && line.load.total_cmp(&load).is_eq()
                });
                let first = lines.filter(|line| !line.is_solved()).min_by_key(|line| line.points);
                told.extend(first.map(|line| {
                    let points = count(line.points);
                    let why = if line.why.is_empty() { String::new() } else { format!(" ({})", line.why) };
                    format!(
                        "{}, {}, q = {}: {} at {points} points{why}",
                        label(route),
                        ground.name(),
                        load_name(load),
                        line.status
                    )
                }));
            }
        }
    }
    told
}

/// Seconds of every route on every survey.
fn table(scale: &Scale, surveys: &[Survey]) -> Table {
    let header =
        ["ground", "q", "points", "contacts", "exact, s", "active set, s", "clarabel, s", "energy of the grid off by"];
    let rows = surveys.iter().map(|&survey| {
        let (ground, load, points) = survey;
        let seconds = |route| match line(scale, survey, route) {
            Some(line) if line.is_solved() => cell(line.median_s, 2),
            Some(line) if line.median_s.is_some() => line.status.clone(),
            _ => "–".to_owned(),
        };
        let contacts = certified(scale, survey, EXACT).and_then(|line| line.contacts);
        let contacts = contacts.map_or_else(|| "–".to_owned(), count);
        let [exact, active_set, interior] = [EXACT, ACTIVE_SET, INTERIOR_POINT].map(seconds);
        let off = error_cell(grid_off(scale, survey));
        row![ground.name(), load_name(load), count(points), contacts, exact, active_set, interior, off]
    });
    Table::new(header).rows(rows)
}

#[cfg(test)]
mod tests {
    use super::load_name;

    #[test]
    fn loads_are_powers_of_ten() {
        assert_eq!([1.0, 1e4].map(load_name), ["1", "10⁴"]);
    }
}
