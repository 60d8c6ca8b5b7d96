//! The bending moment on a grid: the number that an engineer designs by, and the one of the observables that is of first order.

use palkki::plot::{Axis, Color, Divisions, Layer, Marker, Panel, Place, Style};
use palkki::theory::Exact;
use palkki_evidence::paper::example;
use palkki_evidence::random::Family;

use super::population::{self, Spread};
use super::prelude::*;
use crate::measure::population::{GRIDS, Line, SCENES};

/// Of the observables the support forces and the moment.
const OBSERVABLES: [usize; 2] = [0, 3];
/// Grids of the words.
const TOLD: [usize; 3] = [30, 100, 1000];

/// Grids of the drawing beside lift-off.
const DRAWN: [(usize, Color, Marker); 3] = [
    (20, Color::VERMILLION, Marker::OpenCircle),
    (33, Color::GREEN, Marker::Plus),
    (100, Color::BLUE, Marker::OpenCircle),
];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let exact = theory::solve(&scene)?;
    let lines = population::lines(study)?;
    let flat: Vec<&Line> = population::of_family(&lines, Family::Flat, Method::Force).collect();
    let [supports, moments] = OBSERVABLES.map(|of| places(&flat, of));
    let [support_order, order] =
        OBSERVABLES.map(|of| population::orders(&lines, Family::Flat, Method::Force, of).map(|s| s.median));
    let differences_order =
        population::orders(&lines, Family::Flat, Method::Complementarity, OBSERVABLES[1]).map(|s| s.median);
    let on = |grid, of| population::on(&lines, Family::Flat, Method::Force, grid, of);
    let told = TOLD.into_iter().filter_map(|grid| Some((grid, on(grid, OBSERVABLES[1])?)));
    let told: Vec<Value> =
        told.map(|(intervals, s)| context! { intervals, median => s.median, worst => s.worst }).collect();
    let values = context! { order, differences_order, support_order, grids => told, scenes => SCENES[0] };
    let rows = moments
        .iter()
        .zip(&supports)
        .map(|([n, moment], [_, supports])| row![n, scientific(*moment, 2), scientific(*supports, 2)]);
    let data = Table::new(["intervals", "worst_moment", "support_forces"]).rows(rows);
    let panels = vec![near_lift_off(&scene, &exact)?, over_intervals(&moments, &supports)];
    Evidence::new(values.clone()).figures([study.drawn("moment", values, 2, panels, data)?])
}

/// The errors of an observable over the number of intervals, scene by scene.
fn places(flat: &[&Line], of: usize) -> Vec<Place> {
    flat.iter().filter_map(|line| Some([as_number(line.intervals), line.errors()?[of]])).collect()
}

/// The moments of three grids on both sides of the left lift-off point.
fn near_lift_off(scene: &Scene, exact: &Exact) -> Result<Panel, Cause> {
    const SAMPLES: u32 = 60;
    let lift_off = exact.state.contacts.first().map_or(0.0, |contact| contact.from);
    let [from, to] = [0.7, 1.4].map(|share: f64| share * lift_off);
    let places = (0..=SAMPLES).map(|i| from + (to - from) * f64::from(i) / f64::from(SAMPLES));
    let dashed = places.map(|x| [x, exact.moment(x)]).collect();
    let axis = Axis::new("bending moment M [force·length]").down();
    // The names stand one below the other where no moment is.
    let mut name = [0.75 * to + 0.25 * from, 0.2];
    let mut panel =
        Panel::new(Axis::along("x [length]", [from, to]), axis).tall(800.0).with(Layer::zero_line([from, to]));
    for (intervals, color, marker) in DRAWN {
        let state = on_grid(scene, Method::Force, Solver::ActiveSet, intervals)?.state;
        let nodes = nodes_of(&state)?;
        let inside = nodes.x.iter().zip(&nodes.moment).filter(|(x, _)| (from..=to).contains(*x));
        let points: Vec<Place> = inside.map(|(&x, &m)| [x, m]).collect();
        let style = Style { marker: Some(marker), ..Style::solid(color) };
        panel =
            panel.with(Layer::line(points, style)).with(Layer::words(name, color, format!("{intervals} intervals")));
        name[1] += 0.1;
    }
    let theory_name = Layer::words(name, Color::GRAY, "beam theory");
    let divisions = Divisions { lines: vec![(lift_off, "lift-off".to_owned())], between: Vec::new() };
    let headroom = divisions.headroom();
    Ok(panel
        .with(Layer::line(dashed, Style::theory()))
        .with(theory_name)
        .with(Layer::Divisions(divisions))
        .room(headroom, 10.0))
}

/// Both errors over the number of intervals.
fn over_intervals(moments: &[Place], supports: &[Place]) -> Panel {
    let x = Axis { padding: 0.02, ..Axis::new("intervals N").log() };
    let mut panel = Panel::new(x, Axis::new("relative error").log()).tall(800.0);
    let ends = [GRIDS[0], GRIDS[GRIDS.len() - 1]].map(as_number);
    for (order, errors) in [(1, moments), (2, supports)] {
        // Through the middle of the points of the coarsest grid.
        let on_coarsest = errors.iter().filter(|[n, _]| *n <= ends[0]).map(|[_, error]| *error);
        let middle = Spread::of(on_coarsest).map_or(f64::NAN, |s| s.median);
        let line = ends.map(|n| [n, middle * (ends[0] / n).powi(order)]).to_vec();
        let style = Style { width: 4, ..Style::solid(Color::GRAY) };
        panel = panel.with(Layer::named(line, style, format!("order {order}")));
    }
    // The names stand where no marks are: above the moments of fine grids, below the reactions of coarse ones.
    let (above, below) = ([0.15 * ends[1], 0.1], [5.0 * ends[0], 1e-6]);
    let marks = |errors: &[Place], color| Layer::line(errors.to_vec(), Style::marks(color, Marker::OpenCircle));
    panel
        .with(marks(moments, Color::VERMILLION))
        .with(marks(supports, Color::BLUE))
        .with(Layer::words(above, Color::VERMILLION, "nodal moment"))
        .with(Layer::words(below, Color::BLUE, "reactions"))
}
