//! Time and memory over the points of a survey: rendered from the file of `cargo xtask measure --scale`. Only solved runs
//! count as results.

use palkki::plot::{Axis, Color, Dash, Figure, Layer, Marker, Panel, PlotError, Style};
use palkki_evidence::extremes::Ground;

use super::prelude::*;
use crate::measure::plan::Route;
use crate::measure::scale::{LOADS, Line, ROUTES, Scale, patience};

const EXACT: Route = ROUTES[0];
const ACTIVE_SET: Route = ROUTES[1];
const INTERIOR_POINT: Route = ROUTES[2];

/// A route in tables and figures: its name, and its look; the exact solution is blue, as everything is that is computed.
fn look(route: Route) -> (&'static str, Style) {
    let (name, color, marker, dash) = match route {
        EXACT => ("exact", Color::BLUE, Marker::Circle, Dash::Solid),
        INTERIOR_POINT => ("clarabel", Color::GREEN, Marker::Triangle, Dash::DashDot),
        _ => ("active set", Color::VERMILLION, Marker::Square, Dash::Dashed),
    };
    (name, Style { color, dash: Some(dash), marker: Some(marker), width: 5 })
}

/// All routes on one survey.
struct Survey<'a> {
    ground: Ground,
    load: f64,
    points: u32,
    /// In the order of [`ROUTES`].
    lines: [Option<&'a Line>; 3],
}

impl<'a> Survey<'a> {
    fn of(scale: &'a Scale, ground: Ground, load: f64, points: u32) -> Self {
        let same = move |line: &&Line| {
            line.ground == ground.name() && line.load.total_cmp(&load).is_eq() && line.points == points
        };
        let line = |route: Route| scale.lines.iter().filter(same).find(|line| line.route == route.name());
        Self { ground, load, points, lines: ROUTES.map(line) }
    }

    /// `smooth, q = 10⁴`; the loads are powers of ten.
    fn name(&self) -> String {
        let load = match exponent_of(self.load) {
            Some(0) | None => format!("{}", self.load),
            Some(exponent) => power_of_ten(exponent),
        };
        format!("{}, q = {load}", self.ground.name())
    }

    fn solved(&self, route: Route) -> Option<&'a Line> {
        let place = ROUTES.iter().position(|other| *other == route)?;
        self.lines[place].filter(|line| line.is_solved())
    }

    fn seconds(&self, route: Route) -> Option<f64> {
        self.solved(route)?.median_s
    }

    /// Seconds by a route over those by another.
    fn ratio(&self, of: Route, over: Route) -> Option<f64> {
        Some(self.seconds(of)? / self.seconds(over)?)
    }

    /// By how much the energy on the grid of the active set differs from that of the exact solution, over the latter.
    fn grid_off(&self) -> Option<f64> {
        let exact = self.solved(EXACT)?.energy?;
        Some(((self.solved(ACTIVE_SET)?.energy? - exact) / exact).abs())
    }
}

/// Surveys that are measured and not refused, in the order of the table.
fn surveys(scale: &Scale) -> Vec<Survey<'_>> {
    let mut sizes: Vec<u32> = scale.lines.iter().filter(|line| !line.is_refused()).map(|line| line.points).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut surveys = Vec::new();
    for ground in Ground::ALL {
        for load in LOADS {
            surveys.extend(sizes.iter().map(|points| Survey::of(scale, ground, load, *points)));
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
    let exact = || scale.lines.iter().filter(|line| line.route == EXACT.name() && line.is_solved());
    let most = surveys.iter().map(|survey| survey.points).max().ok_or("no survey is measured")?;
    let largest = || surveys.iter().filter(|survey| survey.points == most);
    let interior = || surveys.iter().filter_map(|survey| Some((survey, survey.ratio(INTERIOR_POINT, EXACT)?)));
    let largest_interior = interior().map(|(survey, _)| survey.points).max().unwrap_or(0);
    let beside_grid = || surveys.iter().filter_map(|survey| Some((survey, survey.ratio(EXACT, ACTIVE_SET)?)));
    let slowest = beside_grid().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(survey, _)| survey);
    let (title, figure) = drawn(&surveys)?;
    // Of the largest surveys that the interior point solves: all that it was tried on, and how it fared on the others.
    let tried_by_interior = || {
        let tried = surveys.iter().filter(|survey| survey.points == largest_interior);
        tried.filter_map(|survey| {
            let line = survey.lines[2].filter(|line| !line.is_solved())?;
            Some(line.median_s? / survey.seconds(EXACT)?)
        })
    };
    let refused = scale.lines.iter().find(|line| line.is_refused());
    let values = context! {
        made => scale.provenance(),
        patience => [EXACT, INTERIOR_POINT].map(patience),
        most,
        surveys => largest().count(),
        solved => largest().filter(|survey| survey.solved(EXACT).is_some()).count(),
        seconds => least_most(largest().filter_map(|survey| survey.seconds(EXACT))),
        lists => exact().filter_map(|line| line.lists).max(),
        residual => exact().filter_map(|line| line.residual).max_by(f64::total_cmp),
        ten_times => least_most(surveys.iter().flat_map(|small| largest().filter_map(|large| ten_times(small, large)))),
        exact_over_grid => least_most(beside_grid().map(|(_, ratio)| ratio)),
        slowest_beside_grid => slowest.map(|survey| format!("{}, {} points", survey.name(), count(survey.points))),
        interior_over_exact =>
            least_most(interior().filter(|(survey, _)| survey.points == largest_interior).map(|(_, ratio)| ratio)),
        largest_interior,
        interior_solved => interior().filter(|(survey, _)| survey.points == largest_interior).count(),
        interior_failed => tried_by_interior().count(),
        interior_failed_after => least_most(tried_by_interior()),
        grid_off => least_most(surveys.iter().filter_map(Survey::grid_off)),
        refused => refused.map(|line| line.points),
        most_points => refused.and_then(|line| first_number(&line.why)),
        tenth => most / 10,
        single => scale.lines.iter().filter(|line| line.runs == Some(1)).count(),
        title,
        table => table(surveys.iter().filter(|survey| [most, largest_interior].contains(&survey.points))),
    };
    Evidence::new(values).file("scale", file).figures([figure])
}

/// The first whole number of a message.
fn first_number(message: &str) -> Option<u64> {
    message.split(|c: char| !c.is_ascii_digit()).find(|digits| !digits.is_empty())?.parse().ok()
}

/// How many times as long the exact solution takes of the large survey as of the small one, if that has a tenth of its points.
fn ten_times(small: &Survey<'_>, large: &Survey<'_>) -> Option<f64> {
    let same = small.name() == large.name() && 10 * small.points == large.points;
    Some(large.seconds(EXACT)? / small.seconds(EXACT)?).filter(|_| same)
}

/// Seconds and megabytes of every route on some surveys.
fn table<'a>(surveys: impl Iterator<Item = &'a Survey<'a>>) -> Table {
    let header = ["ground and load", "points", "contacts"].map(str::to_owned);
    let routes = ROUTES.map(|route| format!("{}, s (MB)", look(route).0));
    let rows = surveys.map(|survey| {
        let shown = survey.lines.map(|line| match line {
            Some(line) if line.is_solved() => {
                let megabytes =
                    line.peak_kb.map(|kilobytes| 1e-3 * f64::from(u32::try_from(kilobytes).unwrap_or(u32::MAX)));
                format!("{} ({})", cell(line.median_s, 2), cell(megabytes, 2))
            }
            Some(line) if line.median_s.is_some() => line.status.clone(),
            _ => "–".to_owned(),
        });
        let contacts = survey.solved(EXACT).and_then(|line| line.contacts);
        let contacts = contacts.map_or_else(|| "–".to_owned(), count);
        let off = error_cell(survey.grid_off());
        [survey.name(), count(survey.points), contacts].into_iter().chain(shown).chain([off]).collect::<Vec<_>>()
    });
    Table::new(header.into_iter().chain(routes).chain(["energy of the grid off by".to_owned()])).rows(rows)
}

/// Seconds over points, both logarithmic: the title, and the figure with a panel for each ground and load.
fn drawn(surveys: &[Survey<'_>]) -> Result<(String, Drawn), PlotError> {
    let points_of = |survey: &Survey<'_>| f64::from(survey.points);
    let all = || surveys.iter().flat_map(|survey| ROUTES.map(|route| (survey, route)));
    let points: Vec<f64> = surveys.iter().map(points_of).collect();
    let times: Vec<f64> = all().filter_map(|(survey, route)| survey.seconds(route)).collect();
    let panels = surveys.chunk_by(|a, b| a.name() == b.name()).map(|of_panel| {
        let x = Axis::new("points of the survey").log().including(&points);
        let y = Axis::new(format!("{}: time", of_panel[0].name())).unit(Some("s".to_owned())).log().including(&times);
        let mut panel = Panel::new(x, y).tall(520.0).room(30.0, 30.0);
        for route in ROUTES {
            let place = |survey: &Survey<'_>| Some([points_of(survey), survey.seconds(route)?]);
            let places: Vec<_> = of_panel.iter().filter_map(place).collect();
            let (label, style) = look(route);
            if !places.is_empty() {
                panel = panel.with(Layer::named(places, style, label));
            }
        }
        panel
    });
    let panels = panels.collect();
    let data = Table::new(["survey", "route", "points", "seconds"]).rows(all().filter_map(|(survey, route)| {
        let seconds = scientific(survey.seconds(route)?, 3);
        Some(row![survey.name().replace(", ", " "), look(route).0, survey.points, seconds])
    }));
    let most = surveys.iter().map(|survey| survey.points).max().unwrap_or(0);
    let largest: Vec<_> = surveys.iter().filter(|survey| survey.points == most).collect();
    let seconds: Vec<f64> = largest.iter().filter_map(|survey| survey.seconds(EXACT)).collect();
    let [least, longest] =
        range(seconds.iter().copied()).unwrap_or([f64::NAN; 2]).map(|seconds| cell(Some(seconds), 2));
    let title = format!(
        "{} of {} surveys of {} points are solved exactly, in {least} to {longest} s",
        seconds.len(),
        largest.len(),
        count(most)
    );
    let description = "Six panels, three kinds of ground under a light and a heavy load: seconds of a solve over the points of the \
        survey, both logarithmic, by the exact solution, the force method with the active set, and the force method with an \
        interior point. Runs that are solved only.";
    let figure = Figure { columns: 2, ..Figure::new(title.as_str(), description, panels) };
    Ok((title, ("scale-time", figure.svg()?, data)))
}
