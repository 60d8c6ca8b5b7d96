//! The adaptive grid: an error that is demanded, the grid that it takes, and the error that is true, on every scene.

use palkki::adaptive::{Adapted, End, Request, adapt};
use palkki::plot::{Axis, Color, Layer, Marker, Panel, Style};
use palkki::theory::Exact;

use super::prelude::*;
use crate::measure::plan::EXAMPLE;

/// Powers of ten that are demanded on the scenes of the figure, and on every scene.
const STEPS: [i32; 8] = [-1, -2, -3, -4, -5, -6, -7, -8];
const EVERYWHERE: [i32; 3] = [-2, -4, -6];

/// Scenes of the figure: flat ground and smooth crests, both demanded in the same steps.
const DRAWN: [&str; 2] = [EXAMPLE, "wave"];

/// At most so many intervals: a second for all scenes.
const MOST: usize = 20_000;

/// True errors below this are rounding, and are printed as this.
const FLOOR: f64 = 1e-13;

/// One demand on one scene, by the force method with the active set.
struct Run {
    exponent: i32,
    found: Adapted,
    /// The largest difference of a nodal deflection from the exact solution, over the largest deflection.
    truth: f64,
}

impl Run {
    fn of(scene: &Scene, exact: &Exact, exponent: i32) -> Result<Self, Cause> {
        let request = Request::new(Method::Force, Solver::ActiveSet, ten_to(exponent));
        let found = adapt(scene, &Request { most_intervals: MOST, ..request })?;
        let nodes = nodes_of(&found.solution.state)?;
        let apart = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| v - exact.deflection(x));
        // The same size as that of the certified error.
        let truth = largest(apart) / found.solution.state.deflection.magnitude();
        Ok(Self { exponent, found, truth })
    }

    fn certified(&self) -> f64 {
        self.found.solution.verdict.error
    }

    fn reached(&self) -> bool {
        self.found.end == End::Reached
    }

    /// Unknowns that all solves went through, over all grids.
    fn work(&self) -> usize {
        self.found.trials.iter().map(|tried| tried.work).sum()
    }
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    // For each demand: the intervals that reach it, scene by scene, and the scenes that do not.
    let mut everywhere = EVERYWHERE.map(|exponent| (exponent, Vec::new(), Vec::new()));
    let mut scenes = 0;
    let header = ["EPS", "grids tried, intervals", "certified error", "true error", "unknowns gone through"];
    let mut steps = Table::new(header);
    let mut data =
        Table::new(["scene", "demanded", "end", "intervals", "certified_error", "true_error", "unknowns_gone_through"]);
    let (mut truthful, mut of_figure) = (0, Vec::new());
    for (name, scene) in scenes::all(study.root)? {
        let exact = theory::solve(&scene)?;
        let demanded = if DRAWN.contains(&name.as_str()) { &STEPS[..] } else { &EVERYWHERE };
        let runs = demanded.iter().map(|&exponent| Run::of(&scene, &exact, exponent)).collect::<Result<Vec<_>, _>>()?;
        if name == EXAMPLE {
            steps = steps.rows(runs.iter().filter(|run| run.exponent % 2 == 0).map(step));
        }
        scenes += 1;
        for (exponent, reached, missed) in &mut everywhere {
            for run in runs.iter().filter(|run| run.exponent == *exponent) {
                if run.reached() {
                    reached.push(run.found.settings.intervals);
                } else {
                    missed.push(format!("{name} ({})", error_cell(Some(run.certified()))));
                }
            }
        }
        for run in &runs {
            truthful += usize::from(run.truth <= run.certified());
            let end = if run.reached() { "reached" } else { "not reached" };
            let certified = if run.certified().is_finite() { scientific(run.certified(), 2) } else { String::new() };
            let truth = scientific(run.truth.max(FLOOR), 2);
            let intervals = run.found.settings.intervals;
            data.push(row![name, format!("1e{}", run.exponent), end, intervals, certified, truth, run.work()]);
        }
        if DRAWN.contains(&name.as_str()) {
            of_figure.push((name, runs));
        }
    }
    let header = ["EPS", "scenes that reach it", "fewest intervals", "most", "not reached (certified error)"];
    let everywhere = Table::new(header).rows(everywhere.iter().map(|(exponent, reached, missed)| {
        let [fewest, most] = [reached.iter().min(), reached.iter().max()].map(|n| n.map_or("–".to_owned(), count));
        let missed = if missed.is_empty() { "–".to_owned() } else { missed.join(", ") };
        row![power_of_ten(*exponent), reached.len(), fewest, most, missed]
    }));
    let values = context! { steps, everywhere, scenes, most => MOST, runs => data.len(), truthful };
    Evidence::new(values).figures([study.drawn("adaptive", context! {}, 2, panels(&of_figure), data)?])
}

/// The grids of one demand.
fn step(run: &Run) -> [String; 5] {
    let grids: Vec<String> = run.found.trials.iter().map(|tried| tried.intervals.to_string()).collect();
    let [certified, truth] = [run.certified(), run.truth].map(|error| cell(Some(error), 2));
    [power_of_ten(run.exponent), grids.join(", "), certified, truth, count(run.work())]
}

/// Certified and true errors over what is demanded, a panel for each scene.
fn panels(scenes: &[(String, Vec<Run>)]) -> Vec<Panel> {
    let marks = Style::marks(Color::VERMILLION, Marker::Plus);
    let demanded = [1e-8, 1e-1].map(|error| [error, error]).to_vec();
    let panel = |(name, runs): &(String, Vec<Run>)| {
        // From small errors to large ones: names stand at the right.
        let reached = runs.iter().rev().filter(|run| run.reached());
        let places = |error: fn(&Run) -> f64| reached.clone().map(|run| [ten_to(run.exponent), error(run)]).collect();
        let y = Axis::new(format!("{name}: error")).log().including(&[1e-9, 1e-1]);
        Panel::new(Axis::new("error that is demanded, EPS").log(), y)
            .tall(620.0)
            .with(Layer::named(demanded.clone(), Style::theory(), "demanded"))
            .with(Layer::named(places(Run::certified), Style::of_series(0), "certified"))
            .with(Layer::named(places(|run| run.truth.max(FLOOR)), marks, "true"))
    };
    scenes.iter().map(panel).collect()
}
