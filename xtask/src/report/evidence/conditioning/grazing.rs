//! Contact without pressure: a foundation that is the free deflection of the beam, node by node, and clarabel on it.
//!
//! At the optimum clearance and contact force are both zero at every node. On the central path their products are all equal
//! to `μ`, and `p = K h` ties the two together, so that both go to zero like `√μ`, where at a contact with pressure or a node
//! with clearance the error goes like `μ`.

use palkki::adaptive::observed_order;
use palkki::methods::{Discrete, free_beam};
use palkki::plot::{Axis, Figure, Layer, Panel, Style};
use palkki_evidence::paper::{INTERVALS, beam, example, scene_over};

use super::routes::exponent;
use crate::report::evidence::prelude::*;

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
    pub(super) data: Table,
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
    let nodal = free_beam(&Discrete::new(&free, INTERVALS)?, method.discretisation());
    let discrete = Discrete::new(&free, INTERVALS)?;
    let inner = discrete.grid.interior_places().into_iter().zip(nodal.deflection).map(|(x, v)| [x, v]);
    let points = std::iter::once([0.0, 0.0]).chain(inner).chain([[free.beam().length(), 0.0]]).collect();
    Ok(scene_over(Foundation::Polyline { points })?)
}

/// Contact forces of the active set there, and the whole load.
#[cfg(test)]
pub(super) fn reference(method: Method) -> Result<(Vec<f64>, f64), Cause> {
    let scene = grazing(method)?;
    let state = on_grid(&scene, method, Solver::ActiveSet, INTERVALS)?.state;
    Ok((nodes_of(&state)?.contact_force.clone(), load(&scene)))
}

/// Clarabel for each tolerance against the active set.
fn errors(scene: &Scene, method: Method) -> Result<Vec<Errors>, Cause> {
    let run = |solver, tolerance| -> Result<_, Cause> {
        let settings = Settings { tolerance, ..Settings::new(method, solver, INTERVALS) };
        let mut outcome = solve_raw(scene, &settings)?;
        let nodes = outcome.state.nodes.take().ok_or("a discretised state has nodes")?;
        Ok((outcome, nodes))
    };
    let (_, exact) = run(Solver::ActiveSet, 0.0)?;
    let load = load(scene);
    let largest = exact.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    ASKED
        .map(|asked| {
            let (outcome, found) = run(Solver::Clarabel, ten_to(-asked))?;
            let force = worst_difference(&found.contact_force, &exact.contact_force) / load;
            let deflection = worst_difference(&found.deflection, &exact.deflection) / largest;
            let met = outcome.own_residual.is_some_and(|own| own.is_met());
            Ok(Errors { asked, force, deflection, met, certified: outcome.solved })
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
    let mut data = Table::new(["method", "scene", "tolerance", "contact_force_error", "deflection_error"]);
    let (mut fitted, mut panels) = (Vec::new(), Vec::new());
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
            data = data.rows(errors.iter().map(|e| {
                let numbers = [ten_to(-e.asked), shown(e, e.force), shown(e, e.deflection)].map(|x| scientific(x, 1));
                row![method, words].into_iter().chain(numbers)
            }));
            if i == 0 {
                beyond.extend(errors.into_iter().filter(|e| FITTED < e.asked));
            }
        }
        panels.push(panel);
        fitted.push((method, [exponents[0], exponents[1]]));
    }
    let header = ["method", "force, no pressure", "deflection, no pressure", "force, example", "deflection, example"];
    let table = Table::new(header).rows(fitted.iter().map(|(method, exponents)| {
        row![method].into_iter().chain(exponents.as_flattened().iter().map(|k| cell(Some(*k), 2)))
    }));
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
        table,
        asked => power_of_ten(-ASKED.start()),
        fitted => power_of_ten(-FITTED),
        beyond => beyond.len(),
        met => count(|e| e.met),
        certified => count(|e| e.certified),
        error => power_of_ten(beyond.iter().map(|e| exponent(e.force)).max().unwrap_or_default()),
    };
    Ok(Grazing { values, svg, data, fitted })
}
