//! The figures: time and memory over the points of a survey, both logarithmic.

use palkki::plot::{Axis, Color, Dash, Figure, Layer, Marker, Panel, Place, PlotError, Style};
use palkki_evidence::extremes::Ground;

use super::{ACTIVE_SET, EXACT, INTERIOR_POINT, Survey, certified, label, load_name};
use crate::measure::scale::{LOADS, Line, Route, Scale};
use crate::report::evidence::prelude::*;

/// The title, and the figure.
type Titled = (String, Drawn);

const ROUTES: [Route; 3] = [EXACT, ACTIVE_SET, INTERIOR_POINT];

/// From so many points on the memory of a survey is more than that of the program.
const LARGE: f64 = 1e4;

/// The look of a route: the exact solution is blue, as everything is that is computed.
fn style(route: Route) -> Style {
    let (color, marker, dash) = match route {
        EXACT => (Color::BLUE, Marker::Circle, Dash::Solid),
        INTERIOR_POINT => (Color::GREEN, Marker::Triangle, Dash::DashDot),
        Route::Force(_) => (Color::VERMILLION, Marker::Square, Dash::Dashed),
    };
    Style { color, dash: Some(dash), marker: Some(marker), width: 5 }
}

/// One line of a figure: ground and load, route, and points.
type Series = (String, Route, Vec<Place>);

fn data(all: &[Series], quantity: &str) -> Table {
    let rows = all.iter().flat_map(|(what, route, points)| {
        let what = what.replace(", ", " ");
        points.iter().map(move |[points, value]| row![what, label(*route), points, scientific(*value, 3)])
    });
    Table::new(["survey", "route", "points", quantity]).rows(rows)
}

/// What some certified runs have, over the points of their surveys.
fn places(scale: &Scale, surveys: &[Survey], route: Route, of: &dyn Fn(&Line) -> Option<f64>) -> Vec<Place> {
    let place = |survey: &Survey| Some([f64::from(survey.2), of(certified(scale, *survey, route)?)?]);
    surveys.iter().filter_map(place).collect()
}

/// Panels two by two on the same axes.
fn panels(all: &[Series], quantity: &str, unit: &str, height: f64) -> Vec<Panel> {
    let every = |k: usize| all.iter().flat_map(|(.., points)| points).map(|p| p[k]).collect::<Vec<_>>();
    let [points, values] = [every(0), every(1)];
    let of_panel = |series: &[Series]| {
        let x = Axis::new("points of the survey").log().including(&points);
        let y = Axis::new(format!("{}: {quantity}", series[0].0)).unit(Some(unit.to_owned())).log().including(&values);
        series.iter().filter(|(.., points)| !points.is_empty()).fold(
            Panel::new(x, y).tall(height).room(30.0, 30.0),
            |panel, (_, route, points)| {
                let (style, label) = (style(*route), label(*route).to_owned());
                panel.with(Layer::Series { points: points.clone(), style, label })
            },
        )
    };
    all.chunks(ROUTES.len()).map(of_panel).collect()
}

fn svg(title: &str, description: &str, panels: Vec<Panel>) -> Result<String, PlotError> {
    Figure { columns: 2, ..Figure::new(title, description, panels) }.svg()
}

/// Seconds, one panel for each ground and load.
pub(super) fn time(scale: &Scale, surveys: &[Survey]) -> Result<Titled, PlotError> {
    let mut all: Vec<Series> = Vec::new();
    for ground in Ground::ALL {
        for load in LOADS {
            let same = |(g, l, _): &&Survey| *g == ground && l.total_cmp(&load).is_eq();
            let of_panel: Vec<Survey> = surveys.iter().filter(same).copied().collect();
            let what = format!("{}, q = {}", ground.name(), load_name(load));
            let series = |route| (what.clone(), route, places(scale, &of_panel, route, &|line| line.median_s));
            all.extend(ROUTES.map(series));
        }
    }
    let most = surveys.iter().map(|(.., points)| *points).max().unwrap_or(0);
    let largest: Vec<Survey> = surveys.iter().filter(|(.., points)| *points == most).copied().collect();
    let seconds = places(scale, &largest, EXACT, &|line| line.median_s);
    let range = range(seconds.iter().map(|place| place[1]));
    let title = format!(
        "{} of {} surveys of {} points are solved exactly, in {} to {} s",
        seconds.len(),
        largest.len(),
        count(most),
        cell(range.map(|range| range[0]), 2),
        cell(range.map(|range| range[1]), 2)
    );
    let description = "Six panels, three kinds of ground under a light and a heavy load: seconds of a solve over the points of the \
        survey, both logarithmic, by the exact solution, the force method with the active set, and the force method with an \
        interior point. Certified runs only.";
    let svg = svg(&title, description, panels(&all, "time", "s", 520.0))?;
    Ok((title, ("scale-time", svg, data(&all, "seconds"))))
}

/// Megabytes, one panel for each load; the most of the three kinds of ground.
pub(super) fn memory(scale: &Scale, surveys: &[Survey]) -> Result<Titled, PlotError> {
    let megabytes = |line: &Line| Some(1e-3 * f64::from(u32::try_from(line.peak_kb?).unwrap_or(u32::MAX)));
    let mut sizes: Vec<u32> = surveys.iter().map(|(.., points)| *points).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut all: Vec<Series> = Vec::new();
    for load in LOADS {
        let most = |route, points: u32| {
            let same = |(_, l, p): &&Survey| *p == points && l.total_cmp(&load).is_eq();
            let of_size: Vec<Survey> = surveys.iter().filter(same).copied().collect();
            places(scale, &of_size, route, &megabytes).into_iter().max_by(|a, b| a[1].total_cmp(&b[1]))
        };
        let series = |route| {
            let places = sizes.iter().filter_map(|points| most(route, *points)).collect();
            (format!("q = {}", load_name(load)), route, places)
        };
        all.extend(ROUTES.map(series));
    }
    // What the smallest survey takes is the program itself.
    let values = || all.iter().flat_map(|(_, route, places)| places.iter().map(move |place| (*route, *place)));
    let program = range(values().map(|(_, place)| place[1])).map_or(0.0, |range| range[0]);
    let of_point = ROUTES.map(|route| {
        let larger = values().filter(|(r, place)| *r == route && LARGE <= place[0]);
        larger.map(|(_, [points, megabytes])| 1e3 * (megabytes - program) / points).max_by(f64::total_cmp)
    });
    let [exact, grid, interior] = of_point.map(|kilobytes| cell(kilobytes, 2));
    let title = format!(
        "A point takes at most {exact} kB in the exact solution, {grid} kB in the active set and {interior} kB in clarabel"
    );
    let description = "Two panels, a light and a heavy load: megabytes that a process has in use at the most over the points of \
        the survey, both logarithmic, by three routes. The most of three kinds of ground; certified runs only.";
    let svg = svg(&title, description, panels(&all, "memory", "MB", 700.0))?;
    Ok((title, ("scale-memory", svg, data(&all, "megabytes"))))
}
