//! The bending moment on a grid: the number that an engineer designs by, and the one of the observables that is of first order.

use palkki::adaptive::observed_order;
use palkki::plot::{Axis, Color, Divisions, Layer, Marker, Panel, Place, Style};
use palkki::theory::Exact;
use palkki_evidence::paper::example;

use super::prelude::*;

/// Every grid up to 16 times the coarsest, and then so many in each doubling, up to 1,024 times the coarsest.
const COARSEST: usize = 10;
const IN_A_DOUBLING: i32 = 24;
const DOUBLINGS: [i32; 2] = [4, 10];
/// Grids of the words.
const TOLD: [usize; 3] = [20, 100, 320];
/// Grids of the drawing beside lift-off.
const DRAWN: [(usize, Color, Marker); 3] = [
    (20, Color::VERMILLION, Marker::OpenCircle),
    (33, Color::GREEN, Marker::Plus),
    (100, Color::BLUE, Marker::OpenCircle),
];

fn grids() -> Vec<usize> {
    let [all, last] = DOUBLINGS;
    let finer = (IN_A_DOUBLING * all + 1..=IN_A_DOUBLING * last).map(|k| {
        let share = f64::from(k) / f64::from(IN_A_DOUBLING);
        // Positive, and far below 2⁵³.
        (as_number(COARSEST) * share.exp2()).round() as usize
    });
    (COARSEST..=COARSEST << all).chain(finer).collect()
}

/// A grid with the worst error of a nodal moment over the largest moment, and that of the left reaction.
#[derive(Debug, Clone, Copy)]
struct Errors {
    intervals: usize,
    moment: f64,
    reaction: f64,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let exact = theory::solve(&scene)?;
    let grids = grids();
    let found: Vec<Errors> =
        grids.iter().map(|&intervals| errors(&scene, &exact, intervals)).collect::<Result<_, _>>()?;
    let [order, reaction_order] =
        [|e: &Errors| e.moment, |e: &Errors| e.reaction].map(|of| order_of_the_worst(&found, of));
    let told: Vec<Value> = TOLD
        .iter()
        .filter_map(|told| found.iter().find(|errors| errors.intervals == *told))
        .map(|errors| context! { intervals => errors.intervals, worst => errors.moment })
        .collect();
    let worse = |errors: &Errors| errors.moment / errors.reaction;
    let middle = found.iter().find(|errors| errors.intervals == TOLD[1]).map(worse);
    let values = context! {
        order, reaction_order, grids => told, worse => middle, worse_on => TOLD[1],
        coarsest => grids[0], finest => grids[grids.len() - 1], tried => found.len(),
    };
    let rows = found.iter().map(|e| row![e.intervals, scientific(e.moment, 2), scientific(e.reaction, 2)]);
    let data = Table::new(["intervals", "worst_moment", "left_reaction"]).rows(rows);
    let panels = vec![near_lift_off(&scene, &exact)?, over_intervals(&found)];
    let figure = study.drawn("moment", values.clone(), 2, panels, data)?;
    Evidence::new(values).figures([figure])
}

fn errors(scene: &Scene, exact: &Exact, intervals: usize) -> Result<Errors, Cause> {
    let state = on_grid(scene, Method::Force, Solver::ActiveSet, intervals)?.state;
    let nodes = nodes_of(&state)?;
    let off = nodes.x.iter().zip(&nodes.moment).map(|(&x, m)| m - exact.moment(x));
    let left = |state: &palkki::state::ContactState| state.reactions.left;
    let reaction = (left(&state) - left(&exact.state)).abs() / left(&exact.state).abs();
    Ok(Errors { intervals, moment: largest(off) / exact.state.moment.magnitude(), reaction })
}

/// The order of the worst grid in each doubling: on a single one the error depends on where lift-off falls between two nodes.
fn order_of_the_worst(found: &[Errors], of: fn(&Errors) -> f64) -> f64 {
    let doubling = |errors: &Errors| (errors.intervals / COARSEST).ilog2();
    let in_doublings = found.chunk_by(|a, b| doubling(a) == doubling(b)).filter(|grids| 1 < grids.len());
    let worst = in_doublings.filter_map(|grids| grids.iter().max_by(|a, b| of(a).total_cmp(&of(b))));
    observed_order(&worst.map(|errors| (1.0 / as_number(errors.intervals), of(errors))).collect::<Vec<_>>())
}

/// The moments of three grids on both sides of the left lift-off point.
fn near_lift_off(scene: &Scene, exact: &Exact) -> Result<Panel, Cause> {
    const SAMPLES: u32 = 60;
    let lift_off = exact.state.contacts.first().map_or(0.0, |contact| contact.from);
    let [from, to] = [0.7, 1.4].map(|share: f64| share * lift_off);
    let places = (0..=SAMPLES).map(|i| from + (to - from) * f64::from(i) / f64::from(SAMPLES));
    let dashed = places.map(|x| [x, exact.moment(x)]).collect();
    let axis = Axis::new("bending moment M, downwards").down();
    // The names stand one below the other where no moment is.
    let mut name = [0.75 * to + 0.25 * from, 0.2];
    let mut panel = Panel::new(Axis::along("x", [from, to]), axis).tall(800.0).with(Layer::zero_line([from, to]));
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
fn over_intervals(found: &[Errors]) -> Panel {
    let points =
        |of: fn(&Errors) -> f64| found.iter().map(|errors| [as_number(errors.intervals), of(errors)]).collect();
    let (moments, reactions): (Vec<Place>, Vec<Place>) = (points(|e| e.moment), points(|e| e.reaction));
    let x = Axis { padding: 0.02, ..Axis::new("intervals N").log() };
    let mut panel = Panel::new(x, Axis::new("relative error").log()).tall(800.0);
    let ends = [0, found.len() - 1].map(|k| as_number(found[k].intervals));
    for (order, errors) in [(1, &moments), (2, &reactions)] {
        // Through the worst of the points, so that none is above the line.
        let most = errors.iter().map(|[n, error]| error * n.powi(order)).fold(0.0, f64::max);
        let line = ends.map(|n| [n, most / n.powi(order)]).to_vec();
        let style = Style { width: 4, ..Style::solid(Color::GRAY) };
        panel = panel.with(Layer::named(line, style, format!("order {order}")));
    }
    // The names stand where no marks are: above the moments of fine grids, below the reactions of coarse ones.
    let (above, below) = ([0.1 * ends[1], 0.1], [5.0 * ends[0], 1e-6]);
    let marks = |errors, color| Layer::line(errors, Style::marks(color, Marker::OpenCircle));
    panel
        .with(marks(moments, Color::VERMILLION))
        .with(marks(reactions, Color::BLUE))
        .with(Layer::words(above, Color::VERMILLION, "worst nodal moment"))
        .with(Layer::words(below, Color::BLUE, "left reaction"))
}
