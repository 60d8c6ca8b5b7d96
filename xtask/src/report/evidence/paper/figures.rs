//! Figures 4, 7 and 8 of the paper, drawn again, and the first nodal contact force, which jumps from grid to grid.

use palkki::methods::Method;
use palkki::plot::{Axis, Color, Layer, Marker, Panel, Place, Style};
use palkki::state::{ContactState, Nodes};
use palkki_evidence::closed::FlatSolution;
use palkki_evidence::paper::convergence::Quantity;
use palkki_evidence::paper::{INTERVALS, Pressures, example, figure_4, figure_7, figure_8, theory};

use super::drawings::{self, Theory};
use crate::report::evidence::prelude::*;

/// Figures 4, 7 and 8.
pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let exact = theory();
    let length = palkki_evidence::paper::beam()?.length();
    let drawn = Theory::new(length, exact);
    let (four, seven, eight) = (figure_4()?, figure_7()?, figure_8()?);
    let nodal_load = drawn.pressure * four.spacing;
    let error = deviation(&eight.nodes, &exact);
    let drawn_contact = |name, method, found: &Pressures, data| {
        let values = context! {
            intervals => INTERVALS, level => nodal_load, force => exact.end_force, at => drawn.lift_off, method,
        };
        study.drawn(name, values, 2, drawings::contact(&drawn, (method, &found.nodes)), data)
    };
    let state = |method| -> Result<ContactState, Cause> {
        Ok(on_grid(&example()?, method, Solver::ActiveSet, INTERVALS)?.state)
    };
    let values = context! {
        intervals => INTERVALS,
        lift_off => drawn.lift_off,
        reaction => exact.reaction,
        first_force => seven.nodes.contact_force.iter().find(|force| 0.0 < **force),
        sums_off => [&four, &seven].map(|found| sums_off(found, &exact, length)).into_iter().fold(0.0, f64::max),
        // Largest difference of a nodal deflection from beam theory, over the depth.
        deflection_error => error,
        table_4 => contact_table("finite differences", &state(Method::Complementarity)?, &exact),
        table_7 => contact_table("force method", &state(Method::Force)?, &exact),
        table_8 => shape_table("displacement method", &state(Method::Displacement)?, &exact),
    };
    let shapes = [("displacement method", &eight.nodes), ("force method", &seven.nodes)];
    let of_shape = context! { off => error, intervals => INTERVALS };
    Evidence::new(values).figures([
        drawn_contact("figure-4", "finite differences", &four, data(&four.nodes, &exact, four.spacing))?,
        drawn_contact("figure-7", "force method", &seven, data(&seven.nodes, &exact, seven.spacing))?,
        study.drawn(
            "figure-8",
            of_shape,
            1,
            drawings::shape(&drawn, &shapes),
            data(&eight.nodes, &exact, four.spacing),
        )?,
    ])
}

/// Beam theory, a method, and the difference, to five decimals.
fn compared(first: &str, method: &str, columns: &[(&str, f64, f64)]) -> Table {
    let row = |name: &str, of: fn(&(&str, f64, f64)) -> f64| -> Vec<String> {
        let cells = columns.iter().map(|column| fixed(of(column), 5));
        std::iter::once(name.to_owned()).chain(cells).collect()
    };
    let header = std::iter::once(first).chain(columns.iter().map(|column| column.0));
    Table::new(header).rows([row("beam theory", |c| c.1), row(method, |c| c.2), row("difference", |c| c.2 - c.1)])
}

/// Contact at the left end, and the resultants.
fn contact_table(method: &str, state: &ContactState, exact: &FlatSolution) -> Table {
    let first = state.nodes.iter().flat_map(|nodes| &nodes.contact_force).copied().find(|p| 0.0 < *p);
    let of = |name, quantity: Quantity| (name, quantity.exact(), quantity.of(state));
    let columns = [
        of("contact begins at x", Quantity::LiftOff),
        ("first contact force", exact.end_force, first.unwrap_or(f64::NAN)),
        of("concentrated force at lift-off", Quantity::PointForce),
        ("total contact force", exact.contact_force, state.contact_force()),
        of("end reaction", Quantity::EndReaction),
    ];
    compared("contact", method, &columns)
}

/// What the deflected shape gives.
fn shape_table(method: &str, state: &ContactState, exact: &FlatSolution) -> Table {
    let [tenth, fifth] = [0.1, 0.2].map(|part| {
        let node = state.nodes.as_ref().and_then(|nodes| {
            let k = nodes.x.partition_point(|x| *x < part * 10.0 - 1e-9);
            Some((*nodes.x.get(k)?, *nodes.deflection.get(k)?))
        });
        node.map_or([f64::NAN; 2], |(x, v)| [exact.deflection(x), v])
    });
    let columns = [
        ("deflection at l/10", tenth[0], tenth[1]),
        ("deflection at l/5", fifth[0], fifth[1]),
        ("largest deflection", exact.deflection(exact.lift_off.unwrap_or_default()), state.deflection.max),
        ("largest moment", exact.end_force * exact.end_force / 2.0, state.moment.max),
        ("energy J", Quantity::Energy.exact(), Quantity::Energy.of(state)),
    ];
    compared("shape", method, &columns)
}

/// How far the sums of the nodal forces up to a node are outside those of beam theory one interval before it and one interval behind
/// it, over the whole contact force.
fn sums_off(found: &Pressures, exact: &FlatSolution, length: f64) -> f64 {
    let lift_off = exact.lift_off.unwrap_or_default();
    let pressed = |x: f64| exact.pressure(0.5 * length) * (x.min(length - lift_off) - lift_off);
    let of_theory = |x: f64| match x {
        x if x < lift_off => 0.0,
        x if x <= length - lift_off => exact.end_force + pressed(x),
        x => 2.0 * exact.end_force + pressed(x),
    };
    let forces = found.nodes.x.iter().zip(&found.nodes.contact_force);
    let sums = forces.scan(0.0, |sum, (x, force)| {
        *sum += force;
        Some((of_theory(x - found.spacing) - *sum).max(*sum - of_theory(x + found.spacing)))
    });
    sums.fold(0.0, f64::max) / exact.contact_force
}

/// The largest difference of a nodal deflection from beam theory.
fn deviation(nodes: &Nodes, exact: &FlatSolution) -> f64 {
    largest(nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| v - exact.deflection(x)))
}

fn data(nodes: &Nodes, exact: &FlatSolution, spacing: f64) -> Table {
    let header =
        ["x", "contact_force", "contact_force_per_interval", "theory_pressure", "deflection", "theory_deflection"];
    Table::new(header).rows(nodes.x.iter().enumerate().map(|(i, &x)| {
        let (p, v) = (nodes.contact_force[i], nodes.deflection[i]);
        [x, p, p / spacing, exact.pressure(x), v, exact.deflection(x)].map(|value| fixed(value, 6))
    }))
}

/// All numbers of intervals from the coarsest to the finest.
const GRIDS: std::ops::RangeInclusive<u32> = 8..=400;
/// From here on the words speak of the range.
const FINE: u32 = 30;

/// The first nodal contact force jumps from grid to grid; the resultant at the lift-off point converges.
pub(crate) fn first_force(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let theory = Quantity::PointForce.exact();
    let (mut first, mut resultant) = (Vec::new(), Vec::new());
    for n in GRIDS {
        let state = on_grid(&scene, Method::Force, Solver::ActiveSet, usize::try_from(n)?)?.state;
        let shared = Quantity::PointForce.of(&state) / theory;
        let first_in_contact = nodes_of(&state)?.contact_force.iter().find(|force| 0.0 < **force);
        let force = first_in_contact.copied().unwrap_or_default() / theory;
        first.push([f64::from(n), force]);
        resultant.push([f64::from(n), shared]);
    }
    let rows = first.iter().zip(&resultant).map(|(a, b)| row![a[0], fixed(a[1], 5), fixed(b[1], 5)]);
    let data = Table::new(["intervals", "first_force_over_t", "resultant_over_t"]).rows(rows);
    let fine = |points: &[[f64; 2]], of: fn(f64) -> f64| {
        range(points.iter().filter(|p| f64::from(FINE) <= p[0]).map(|p| of(p[1]))).ok_or("there are fine grids")
    };
    let ([least, most], [_, worst]) = (fine(&first, |force| force)?, fine(&resultant, |force| (force - 1.0).abs())?);
    let values = context! {
        coarsest => GRIDS.start(), finest => GRIDS.end(), grids => first.len(), fine => FINE,
        least, most, worst, last => resultant.last().map(|p| (p[1] - 1.0).abs()),
    };
    let panel = panel_of_first_force(first, resultant);
    Evidence::new(values).figures([study.drawn("first-force", context! {}, 1, vec![panel], data)?])
}

/// The first nodal contact force of each grid beside the resultant at the lift-off point: `[intervals, force / T]`.
fn panel_of_first_force(first: Vec<Place>, resultant: Vec<Place>) -> Panel {
    let [from, to] = [GRIDS.start(), GRIDS.end()].map(|n| f64::from(*n));
    let y = Axis::new("force / T, with the concentrated force T of beam theory").including(&[0.0]);
    let x = Axis { padding: 0.02, ..Axis::new("intervals N").including(&[0.0]) };
    // The name of the scattered circles stands beside the frame, off them.
    let name = Layer::named(vec![[to, 0.5]], Style::solid(Color::VERMILLION), "first nodal force");
    let circles = Style::marks(Color::VERMILLION, Marker::OpenCircle);
    Panel::new(x, y)
        .tall(900.0)
        .with(Layer::line(first, circles))
        .with(name)
        .with(Layer::named(resultant, Style::solid(Color::BLUE), "resultant"))
        .with(Layer::line(vec![[from, 1.0], [to, 1.0]], Style::theory()))
}
