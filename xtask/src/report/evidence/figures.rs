//! Figures 4, 7 and 8 of the paper, drawn again.

use palkki::methods::Method;
use palkki::plot::PlotError;
use palkki::plot::paper::{Nodal, Theory, contact as contact_forces, shape};
use palkki::solvers::Solver;
use palkki::state::{ContactState, Nodes};
use palkki::theory::FlatSolution;
use palkki::{Settings, solve};
use palkki_evidence::paper::convergence::Quantity;
use palkki_evidence::paper::{INTERVALS, Pressures, example, figure_4, figure_7, figure_8, theory};
use serde::Serialize;

use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::table::Table;

/// Where the deflection of beam theory is evaluated for its dashed line.
const SAMPLES: u32 = 400;

#[derive(Debug, Serialize)]
struct Values {
    intervals: usize,
    nodes: usize,
    length: f64,
    spacing: f64,
    nodal_load: f64,
    lift_off: f64,
    reaction: f64,
    figure_4: Contact,
    figure_7: Contact,
    figure_8: Shape,
    table_4: Table,
    table_7: Table,
    table_8: Table,
}

/// The left end of the contact by one method.
#[derive(Debug, Serialize)]
struct Contact {
    /// Place of the first node in contact.
    x: f64,
    /// Contact forces of the first three nodes.
    forces: [f64; 3],
    /// The first of them over the point force of beam theory, minus one.
    error: f64,
    /// How many nodes are in contact.
    count: usize,
    /// Largest deviation from the nodal load behind the second node, over the nodal load.
    swing: f64,
    /// Factor from one such deviation to the next; zero where there is none.
    decay: f64,
}

#[derive(Debug, Serialize)]
struct Shape {
    /// Largest difference of a nodal deflection from beam theory, over the depth.
    error: f64,
    /// Where it is, in the left half.
    at: f64,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let exact = theory();
    let printed = &study.ledger()?.printed;
    let length = palkki_evidence::paper::beam()?.length();
    let lift_off = exact.lift_off.unwrap_or(0.0);
    let line: Vec<[f64; 2]> =
        (0..=SAMPLES).map(|i| length * f64::from(i) / f64::from(SAMPLES)).map(|x| [x, exact.deflection(x)]).collect();
    let drawn = Theory {
        length,
        lift_off,
        pressure: exact.pressure(0.5 * length),
        end_force: exact.end_force,
        depth: 1.0,
        deflection: &line,
    };
    let (four, seven, eight) = (figure_4()?, figure_7()?, figure_8()?);
    let nodal_load = drawn.pressure * four.spacing;
    let (contact_4, contact_7) = (contact(&four, nodal_load), contact(&seven, nodal_load));
    let shape_8 = deviation(&eight.nodes, &exact, length);

    let [svg_4, svg_7, svg_8] = drawings(&drawn, [&four.nodes, &seven.nodes, &eight.nodes], shape_8.error)?;
    let state = |method| -> Result<ContactState, Cause> {
        Ok(solve(&example()?, &Settings::new(method, Solver::ActiveSet, INTERVALS))?.state)
    };
    let [differences, force, displacement] =
        [state(Method::Complementarity)?, state(Method::Force)?, state(Method::Displacement)?];
    let values = Values {
        intervals: INTERVALS,
        nodes: INTERVALS - 1,
        length,
        spacing: four.spacing,
        nodal_load,
        lift_off,
        reaction: printed.reaction_by_theory,
        figure_4: contact_4,
        figure_7: contact_7,
        figure_8: shape_8,
        table_4: contact_table("finite differences", &differences, &exact),
        table_7: contact_table("force method", &force, &exact),
        table_8: shape_table("displacement method", &displacement, &exact),
    };
    Ok(Evidence::new(values)
        .figure("figure-4", svg_4, data(&four.nodes, &exact, four.spacing))
        .figure("figure-7", svg_7, data(&seven.nodes, &exact, seven.spacing))
        .figure("figure-8", svg_8, data(&eight.nodes, &exact, four.spacing)))
}

/// Figures 4, 7 and 8; the nodes of both energy methods are off by at most `error` in the last of them.
fn drawings(drawn: &Theory<'_>, [four, seven, eight]: [&Nodes; 3], error: f64) -> Result<[String; 3], PlotError> {
    let words = format!("The example of the paper on {INTERVALS} intervals.");
    Ok([
        contact_forces(
            "Figure 4: finite differences share T between two nodes; the sum of the forces agrees",
            &words,
            drawn,
            &nodal("finite differences", four),
        )?,
        contact_forces(
            "Figure 7: nodal forces of the energy methods swing; the sum of the forces agrees",
            &words,
            drawn,
            &nodal("force method", seven),
        )?,
        shape(
            &format!(
                "Figure 8: both energy methods are within {} % of the depth from beam theory",
                fixed(100.0 * error, 1)
            ),
            &words,
            drawn,
            &[nodal("displacement method", eight), nodal("force method", seven)],
        )?,
    ])
}

/// Beam theory, a method, and the difference, to five decimals.
fn compared(first: &str, method: &str, columns: &[(&str, f64, f64)]) -> Table {
    let row = |name: &str, of: fn(&(&str, f64, f64)) -> f64| -> Vec<String> {
        let cells = columns.iter().map(|column| fixed(of(column), 5).replace('-', "−"));
        std::iter::once(name.to_owned()).chain(cells).collect()
    };
    Table::new(std::iter::once(first).chain(columns.iter().map(|column| column.0)))
        .row(row("beam theory", |c| c.1))
        .row(row(method, |c| c.2))
        .row(row("difference", |c| c.2 - c.1))
}

/// Contact at the left end, and the resultants.
fn contact_table(method: &str, state: &ContactState, exact: &FlatSolution) -> Table {
    let first = state.nodes.iter().flat_map(|nodes| &nodes.contact_force).copied().find(|p| 0.0 < *p);
    let of = |name, quantity: Quantity| (name, quantity.exact(), quantity.of(state));
    let columns = [
        of("contact begins at x", Quantity::LiftOff),
        ("first contact force", exact.end_force, first.unwrap_or(f64::NAN)),
        of("resultant at lift-off", Quantity::PointForce),
        ("whole contact force", exact.contact_force, state.contact_force()),
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

fn nodal<'a>(label: &'a str, nodes: &'a Nodes) -> Nodal<'a> {
    Nodal { label, x: &nodes.x, deflection: &nodes.deflection, contact_force: &nodes.contact_force }
}

fn contact(found: &Pressures, nodal_load: f64) -> Contact {
    let forces = &found.nodes.contact_force;
    let first = forces.iter().position(|p| 0.0 < *p).unwrap_or(0);
    let at = |k: usize| forces.get(first + k).copied().unwrap_or(f64::NAN);
    let middle = forces.len() / 2;
    let behind = forces.iter().take(middle + 1).skip(first + 2);
    // Below this share the deviation is rounding and has no ratio.
    const ROUNDING: f64 = 1e-9;
    let off = |k: usize| at(k) / nodal_load - 1.0;
    Contact {
        x: found.nodes.x[first],
        forces: [at(0), at(1), at(2)],
        error: at(0) / found.theory.end_force - 1.0,
        count: forces.iter().filter(|p| 0.0 < **p).count(),
        swing: behind.fold(0.0_f64, |most, p| most.max((p / nodal_load - 1.0).abs())),
        decay: if off(2).abs() < ROUNDING { 0.0 } else { off(3) / off(2) },
    }
}

fn deviation(nodes: &Nodes, exact: &FlatSolution, length: f64) -> Shape {
    let left = nodes.x.iter().zip(&nodes.deflection).filter(|(x, _)| **x <= 0.5 * length);
    let errors = left.map(|(&x, v)| (x, (v - exact.deflection(x)).abs()));
    let (at, error) = errors.fold((0.0, 0.0), |worst, e| if worst.1 < e.1 { e } else { worst });
    Shape { error, at }
}

fn data(nodes: &Nodes, exact: &FlatSolution, spacing: f64) -> String {
    let header =
        ["x", "contact_force", "contact_force_per_interval", "theory_pressure", "deflection", "theory_deflection"];
    let rows = nodes.x.iter().enumerate().map(|(i, &x)| {
        let (p, v) = (nodes.contact_force[i], nodes.deflection[i]);
        [x, p, p / spacing, exact.pressure(x), v, exact.deflection(x)].map(|value| fixed(value, 6)).to_vec()
    });
    csv(&header, rows)
}
