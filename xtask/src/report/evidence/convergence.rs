//! How fast the methods converge to the exact solution on the paper's example, with the observed order.

use palkki::plot::{Axis, Color, Layer, Panel, Place, Style};
use palkki_evidence::paper::convergence::{Quantity, Series, of_the_example};

use super::prelude::*;

/// Multiples of 8: deflections are compared at an eighth of the span.
const GRIDS: [usize; 7] = [16, 32, 64, 128, 256, 512, 1024];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    // The force method has the same nodal values as the displacement method.
    let (differences, energy) =
        (of_the_example(Method::Complementarity, &GRIDS)?, of_the_example(Method::Displacement, &GRIDS)?);
    let fast = differences.iter().any(|s| s.quantity == Quantity::Energy && 2.5 < s.order);
    let first_force = study.ledger()?.grids.iter().map(|grid| (grid.intervals, grid.first_force));
    let first_force: Vec<_> = first_force.map(|(intervals, error)| context! { intervals, error }).collect();

    let values = context! {
        coarsest => GRIDS[0], finest => GRIDS[GRIDS.len() - 1], table => example_table(&differences, &energy),
        differences_energy_is_fast => fast, first_force,
    };
    let data = example_data(&[&differences, &energy]);
    Evidence::new(values).figures([example_figure(study, &energy, data)?])
}

fn places(errors: &[(usize, f64)]) -> Vec<[f64; 2]> {
    errors.iter().map(|&(n, error)| [as_number(n), error]).collect()
}

fn last(errors: &[(usize, f64)]) -> f64 {
    errors.last().map_or(f64::NAN, |e| e.1)
}

fn first(errors: &[(usize, f64)]) -> f64 {
    errors.first().map_or(f64::NAN, |e| e.1)
}

fn short(error: f64) -> String {
    palkki::plot::significant(error, 2)
}

/// Observables by finite differences and by the energy methods: error on the coarsest grid, on the finest, order.
fn example_table(differences: &[Series], energy: &[Series]) -> Table {
    let on = |method: &str, n: usize| format!("{method}, {n} intervals");
    let [coarsest, finest] = [GRIDS[0], GRIDS[GRIDS.len() - 1]];
    Table::new([
        "error of the".to_owned(),
        on("differences", coarsest),
        on("differences", finest),
        "order".to_owned(),
        on("energy methods", coarsest),
        on("energy methods", finest),
        "order".to_owned(),
    ])
    .rows(differences.iter().zip(energy).filter(|(a, _)| a.quantity != Quantity::PointForce).map(|(a, b)| {
        let cells = |s: &Series| [short(first(&s.errors)), short(last(&s.errors)), format!("{:.2}", s.order)];
        [&row![a.quantity.name()][..], &cells(a), &cells(b)].concat()
    }))
}

/// Errors over the number of intervals, both axes logarithmic, with grey lines of order 1 and 2 to compare with.
fn example_figure(study: &Study<'_>, energy: &[Series], data: Table) -> Result<Drawn, Cause> {
    let mut panel = Panel::new(Axis::new("intervals N").log(), Axis::new("relative error").log()).tall(1000.0);
    // By equilibrium the concentrated force has the error of the end reaction.
    let drawn = energy.iter().filter(|series| series.quantity != Quantity::PointForce);
    for (k, series) in drawn.enumerate() {
        panel = panel.with(Layer::named(places(&series.errors), Style::of_series(k), series.quantity.name()));
    }
    let all: Vec<Place> = energy.iter().flat_map(|series| places(&series.errors)).collect();
    for order in [1_i32, 2] {
        if let Some(points) = slope(&all, f64::from(order)) {
            let style = Style { width: 4, ..Style::solid(Color::GRAY) };
            panel.layers.insert(0, Layer::named(points, style, format!("order {order}")));
        }
    }
    let listed: Vec<String> =
        energy.iter().map(|s| format!("{} with order {:.1}", s.quantity.name(), s.order)).collect();
    let orders = |of: bool| energy.iter().filter(move |s| (s.quantity == Quantity::LiftOff) == of).map(|s| s.order);
    // The least of the others.
    let (lift_off, rest) = (orders(true).fold(0.0, f64::max), orders(false).fold(f64::INFINITY, f64::min));
    let values = context! { lift_off, rest, listed => listed.join(", ") };
    study.drawn("convergence", values, 1, vec![panel], data)
}

fn example_data(methods: &[&[Series]]) -> Table {
    let rows = methods
        .iter()
        .flat_map(|series| series.iter())
        .flat_map(|s| s.errors.iter().map(|(n, error)| row![s.method, s.quantity.name(), n, scientific(*error, 2)]));
    Table::new(["method", "quantity", "intervals", "relative_error"]).rows(rows)
}

/// A line `error ~ N⁻ᵖ` from above the first errors, over the range of the points; none if they have no range.
fn slope(points: &[Place], order: f64) -> Option<Vec<Place>> {
    /// How far above the largest error on the coarsest grid, as a factor.
    const ABOVE: f64 = 1.6;
    let range = |k: usize| points.iter().fold([f64::INFINITY, 0.0], |r: [f64; 2], p| [r[0].min(p[k]), r[1].max(p[k])]);
    let ([from, to], [least, most]) = (range(0), range(1));
    if !(0.0 < from && from < to && to < f64::INFINITY && 0.0 < least && most < f64::INFINITY) {
        return None;
    }
    let start = ABOVE * most;
    // Not below the least error.
    let end = to.min(from * (start / least).powf(1.0 / order));
    Some(vec![[from, start], [end, start * (from / end).powf(order)]])
}
