//! Contact without pressure: a foundation that is the free deflection of the beam, node by node, and clarabel on it.
//!
//! At the optimum clearance and contact force are both zero at every node. On the central path their products are all equal
//! to `μ`, and `p = K h` ties the two together, so that both go to zero like `√μ`, where at a contact with pressure or a node
//! with clearance the error goes like `μ`.

use minijinja::{Value, context};
use palkki::adaptive::observed_order;
use palkki::methods::{Discrete, Method, free_beam};
use palkki::plot::{Axis, Figure, Layer, Panel, Style};
use palkki::route::{Solver, Status};
use palkki::scene::{Foundation, Scene};
use palkki::{Settings, solve};
use palkki_evidence::paper::{INTERVALS, beam, example, scene_over};

use super::routes::exponent;
use super::ten_to;
use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::numbers::{cell, power};
use crate::report::table::Table;

/// What clarabel is asked for: powers of ten.
const ASKED: std::ops::RangeInclusive<i32> = 2..=13;

/// The last power of ten to which exponents are fitted; below, the smallest gap that the library reaches is the limit.
const FITTED: i32 = 9;

/// Exponents of the errors in the tolerance: contact force, deflection.
type Exponents = [f64; 2];

/// What is measured.
pub(super) struct Grazing {
    pub(super) values: Value,
    pub(super) svg: String,
    pub(super) csv: String,
    /// Of each method: without pressure, and on the example, whose contact has pressure.
    #[cfg_attr(not(test), expect(dead_code, reason = "the page has a table of them; a test asks for the numbers"))]
    pub(super) fitted: Vec<(Method, [Exponents; 2])>,
}

/// Errors for one tolerance: contact force over the load, deflection over the largest one; whether clarabel did what it was
/// asked, in its own norm, and whether its answer passes our check.
struct Errors {
    asked: i32,
    force: f64,
    deflection: f64,
    met: bool,
    certified: bool,
}

/// The beam of the example on a foundation that it touches everywhere and does not press.
fn grazing(method: Method) -> Result<Scene, Cause> {
    let free = Scene::new(beam()?, example()?.load().clone(), None)?;
    let nodal = free_beam(&Discrete::new(&free, INTERVALS)?, method.bending());
    let discrete = Discrete::new(&free, INTERVALS)?;
    let inner = discrete.grid.interior_places().into_iter().zip(nodal.deflection).map(|(x, v)| [x, v]);
    let points = std::iter::once([0.0, 0.0]).chain(inner).chain([[free.beam().length(), 0.0]]).collect();
    Ok(scene_over(Foundation::Polyline { points })?)
}

/// Contact forces of the active set there, and the whole load.
#[cfg(test)]
pub(super) fn reference(method: Method) -> Result<(Vec<f64>, f64), Cause> {
    let scene = grazing(method)?;
    let state = solve(&scene, &Settings::new(method, Solver::ActiveSet, INTERVALS))?.state;
    let load = scene.load().magnitude(scene.beam().length());
    Ok((state.nodes.ok_or("a discretised state has nodes")?.contact_force, load))
}

/// Clarabel for each tolerance against the active set.
fn errors(scene: &Scene, method: Method) -> Result<Vec<Errors>, Cause> {
    let run = |solver, tolerance| -> Result<_, Cause> {
        let settings = Settings { tolerance, ..Settings::new(method, solver, INTERVALS) };
        let mut outcome = solve(scene, &settings)?;
        let nodes = outcome.state.nodes.take().ok_or("a discretised state has nodes")?;
        Ok((outcome, nodes))
    };
    let (_, exact) = run(Solver::ActiveSet, 0.0)?;
    let load = scene.load().magnitude(scene.beam().length());
    let largest = exact.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    ASKED
        .map(|asked| {
            let (outcome, found) = run(Solver::Clarabel, ten_to(-asked))?;
            let force = apart(&found.contact_force, &exact.contact_force) / load;
            let deflection = apart(&found.deflection, &exact.deflection) / largest;
            let met = outcome.own_residual.is_some_and(|own| own.is_met());
            Ok(Errors { asked, force, deflection, met, certified: outcome.status == Status::Certified })
        })
        .collect()
}

/// Slope of the errors over the tolerance.
fn slope(errors: &[Errors], of: fn(&Errors) -> f64) -> f64 {
    let points: Vec<(f64, f64)> =
        errors.iter().filter(|e| e.asked <= FITTED).map(|e| (ten_to(-e.asked), of(e))).collect();
    observed_order(&points)
}

/// What has digits that another machine has as well; otherwise its power of ten.
fn shown(errors: &Errors, error: f64) -> f64 {
    if errors.asked <= FITTED && 1e-10 < error { error } else { ten_to(exponent(error)) }
}

/// Values, figure, numbers.
pub(super) fn measured() -> Result<Grazing, Cause> {
    let (mut fitted, mut data, mut panels) = (Vec::new(), Vec::new(), Vec::new());
    let mut beyond: Vec<Errors> = Vec::new();
    for method in Method::ALL {
        let mut panel = Panel::new(
            Axis::new("tolerance asked for").log(),
            Axis::new(format!("{method} method, error of a contact force over the load")).log(),
        )
        .tall(520.0);
        let mut exponents = Vec::new();
        for (i, (words, scene)) in
            [("without pressure", grazing(method)?), ("the example", example()?)].into_iter().enumerate()
        {
            let errors = errors(&scene, method)?;
            exponents.push([slope(&errors, |e| e.force), slope(&errors, |e| e.deflection)]);
            let points = errors.iter().map(|e| [ten_to(-e.asked), shown(e, e.force)]).collect();
            panel = panel.with(Layer::Series { points, style: Style::of_series(i), label: words.to_owned() });
            data.extend(errors.iter().map(|e| {
                let numbers = [ten_to(-e.asked), shown(e, e.force), shown(e, e.deflection)].map(|x| scientific(x, 1));
                [vec![method.word().to_owned(), words.to_owned()], numbers.to_vec()].concat()
            }));
            if i == 0 {
                beyond.extend(errors.into_iter().filter(|e| FITTED < e.asked));
            }
        }
        panels.push(panel);
        fitted.push((method, [exponents[0], exponents[1]]));
    }
    let header = ["method", "force, no pressure", "deflection, no pressure", "force, example", "deflection, example"];
    let table = fitted.iter().fold(Table::new(header), |table, (method, exponents)| {
        let exponents = exponents.iter().flatten().map(|k| cell(Some(*k), 2));
        table.row(std::iter::once(method.word().to_owned()).chain(exponents))
    });
    let svg = Figure::new(
        "Where the contact has no pressure, the error falls only with the root of the tolerance",
        "Three panels, one for each method: error of the worst contact force over the tolerance that clarabel is asked for, both \
         axes logarithmic. On the foundation that is touched without pressure the error falls with the square root of the \
         tolerance, on the example of the paper with the tolerance itself.",
        panels,
    )
    .svg()?;
    let count = |of: fn(&Errors) -> bool| beyond.iter().filter(|e| of(e)).count();
    let values = context! {
        intervals => INTERVALS,
        table => table.to_string(),
        asked => power(-ASKED.start()),
        fitted => power(-FITTED),
        beyond => beyond.len(),
        met => count(|e| e.met),
        certified => count(|e| e.certified),
        error => power(beyond.iter().map(|e| exponent(e.force)).max().unwrap_or_default()),
    };
    let csv = csv(&["method", "scene", "tolerance", "contact_force_error", "deflection_error"], data);
    Ok(Grazing { values, svg, csv, fitted })
}
