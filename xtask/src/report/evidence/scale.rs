//! Time and memory over the points of a survey: rendered from the file of `cargo xtask measure`. Only solved runs count as
//! results.

use palkki::plot::{Axis, Color, Dash, Layer, Marker, Panel, Style};

use super::prelude::*;
use crate::measure::line::{Line, Store};
use crate::measure::plan::{PATIENCE, ROUTES, Route, Survey, TOO_MANY, is_survey, on_survey, surveys};

const EXACT: Route = ROUTES[0];
const ACTIVE_SET: Route = ROUTES[1];
const INTERIOR_POINT: Route = ROUTES[2];

/// A route in tables and figures: its name, and its look; the grid-free solution is blue, as everything is that is computed.
fn look(route: Route) -> (&'static str, Style) {
    let (name, color, marker, dash) = match route {
        EXACT => ("grid-free", Color::BLUE, Marker::Circle, Dash::Solid),
        INTERIOR_POINT => ("clarabel", Color::GREEN, Marker::Triangle, Dash::DashDot),
        _ => ("active set", Color::VERMILLION, Marker::Square, Dash::Dashed),
    };
    (name, Style { color, dash: Some(dash), marker: Some(marker), width: 5 })
}

/// All routes on one survey.
struct Measured<'a> {
    survey: Survey,
    /// In the order of [`ROUTES`].
    lines: [Option<&'a Line>; 3],
}

impl<'a> Measured<'a> {
    /// `smooth, q = 10⁴`; the loads are powers of ten.
    fn name(&self) -> String {
        let load = match exponent_of(self.survey.load) {
            Some(0) | None => format!("{}", self.survey.load),
            Some(exponent) => power_of_ten(exponent),
        };
        format!("{}, q = {load}", self.survey.ground.name())
    }

    fn solved(&self, route: Route) -> Option<&'a Line> {
        let place = ROUTES.iter().position(|other| *other == route)?;
        self.lines[place].filter(|line| line.succeeded())
    }

    fn seconds(&self, route: Route) -> Option<f64> {
        self.solved(route)?.median_s
    }

    /// Seconds of a run that ended, and whose answer does not pass our check.
    fn failed_after(&self, route: Route) -> Option<f64> {
        let place = ROUTES.iter().position(|other| *other == route)?;
        self.lines[place].filter(|line| !line.succeeded())?.median_s
    }

    /// Seconds by a route over those by another.
    fn ratio(&self, of: Route, over: Route) -> Option<f64> {
        Some(self.seconds(of)? / self.seconds(over)?)
    }
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (_, store) = Store::read(study.root)?;
    let line = |survey, route| store.lines.iter().find(|line| line.name() == on_survey(survey, route).name());
    let all: Vec<Measured<'_>> =
        surveys().map(|survey| Measured { survey, lines: ROUTES.map(|route| line(survey, route)) }).collect();
    let most = all.iter().map(|survey| survey.survey.points).max().ok_or("no survey is in the plan")?;
    let largest: Vec<&Measured<'_>> = all.iter().filter(|survey| survey.survey.points == most).collect();
    let seconds = least_most(largest.iter().filter_map(|survey| survey.seconds(EXACT)));
    let solved = largest.iter().filter(|survey| survey.solved(EXACT).is_some()).count();
    let interior =
        || all.iter().filter_map(|survey| Some((survey.survey.points, survey.ratio(INTERIOR_POINT, EXACT)?)));
    // Of the largest surveys that the interior point solves: how it fared on these, and on the others that it was tried on.
    let largest_interior = interior().map(|(points, _)| points).max().unwrap_or(0);
    let by_interior: Vec<f64> =
        interior().filter(|(points, _)| *points == largest_interior).map(|(_, ratio)| ratio).collect();
    let failed = all.iter().filter(|survey| survey.survey.points == largest_interior);
    let failed = failed.filter(|survey| survey.failed_after(INTERIOR_POINT).is_some()).count();
    let values = context! { solved, surveys => largest.len(), most, seconds };
    let (panels, data) = panels(&all);
    let figure = study.drawn("scale-time", values.clone(), 2, panels, data)?;
    let mut of_surveys = store.lines.iter().filter(|line| is_survey(&line.scene));
    let refused = of_surveys.any(|line| line.method == "exact" && line.is_refused());
    let values = context! {
        patience => PATIENCE,
        exact_over_grid => least_most(all.iter().filter_map(|survey| survey.ratio(EXACT, ACTIVE_SET))),
        interior_over_exact => least_most(by_interior.iter().copied()),
        largest_interior,
        interior_solved => by_interior.len(),
        interior_failed => failed,
        grid_off => all.iter().filter_map(|survey| survey.solved(ACTIVE_SET)?.energy_total).reduce(f64::max),
        refused => refused.then_some(TOO_MANY),
        table => table(all.iter().filter(|survey| [most, largest_interior].contains(&survey.survey.points))),
        title => study.words("scale-time", values.clone())?.title,
        ..values
    };
    Evidence::new(values).figures([figure])
}

/// Seconds of a solve and of the whole program, and its megabytes, of every route on some surveys.
fn table<'a>(surveys: impl Iterator<Item = &'a Measured<'a>>) -> Table {
    let header = ["foundation and load", "points", "contacts"].map(str::to_owned);
    let routes = ROUTES.map(|route| format!("{}, s; whole process, s (MB)", look(route).0));
    let rows = surveys.map(|survey| {
        let shown = survey.lines.map(|line| match line {
            Some(line) if line.succeeded() => {
                let megabytes =
                    line.peak_kb.and_then(|kilobytes| u32::try_from(kilobytes).ok()).map(|kb| 1e-3 * f64::from(kb));
                format!("{}; {} ({})", cell(line.median_s, 2), cell(line.process_s, 2), cell(megabytes, 2))
            }
            Some(line) if line.median_s.is_some() => line.status.clone(),
            _ => "–".to_owned(),
        });
        let contacts = survey.solved(EXACT).and_then(|line| line.contacts).map_or_else(|| "–".to_owned(), count);
        let off = error_cell(survey.solved(ACTIVE_SET).and_then(|line| line.energy_total));
        [survey.name(), count(survey.survey.points), contacts].into_iter().chain(shown).chain([off]).collect::<Vec<_>>()
    });
    Table::new(header.into_iter().chain(routes).chain(["energy difference".to_owned()])).rows(rows)
}

/// Seconds over points, both logarithmic, with a panel for each ground and load.
fn panels(surveys: &[Measured<'_>]) -> (Vec<Panel>, Table) {
    let points_of = |survey: &Measured<'_>| f64::from(survey.survey.points);
    let all = || surveys.iter().flat_map(|survey| ROUTES.map(|route| (survey, route)));
    let points: Vec<f64> = surveys.iter().map(points_of).collect();
    let times: Vec<f64> = all().filter_map(|(survey, route)| survey.seconds(route)).collect();
    let panels = surveys.chunk_by(|a, b| a.name() == b.name()).map(|of_panel| {
        let x = Axis::new("points of the survey").log().including(&points);
        let y = Axis::new(format!("{}: time", of_panel[0].name())).unit(Some("s".to_owned())).log().including(&times);
        let mut panel = Panel::new(x, y).tall(520.0).room(30.0, 30.0);
        for route in ROUTES {
            let place = |survey: &Measured<'_>| Some([points_of(survey), survey.seconds(route)?]);
            let places: Vec<_> = of_panel.iter().filter_map(place).collect();
            let (label, style) = look(route);
            if !places.is_empty() {
                panel = panel.with(Layer::named(places, style, label));
            }
            // A run that ended without an answer took its time all the same.
            let failed = of_panel.iter().filter_map(|survey| Some([points_of(survey), survey.failed_after(route)?]));
            panel = panel.with(Layer::line(failed.collect(), Style::marks(style.color, Marker::OpenCircle)));
        }
        panel
    });
    let panels = panels.collect();
    let data =
        Table::new(["survey", "route", "points", "seconds", "solved"]).rows(all().filter_map(|(survey, route)| {
            let seconds = survey.seconds(route);
            let shown = scientific(seconds.or_else(|| survey.failed_after(route))?, 3);
            let name = survey.name().replace(", ", " ");
            Some(row![name, look(route).0, survey.survey.points, shown, yes_no(seconds.is_some())])
        }));
    (panels, data)
}
