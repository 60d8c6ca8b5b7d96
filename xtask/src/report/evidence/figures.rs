//! Figures 4, 7 and 8 of the paper, drawn again.

use palkki::paper::{INTERVALS, Pressures, figure_4, figure_7, figure_8, theory};
use palkki::plot::PlotError;
use palkki::plot::paper::{Nodal, Theory, pressure, pressure_and_shape, shape};
use palkki::state::Nodes;
use palkki::theory::FlatSolution;
use serde::Serialize;

use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::verdict::Row;

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
    verdicts: Vec<Row>,
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
    let length = palkki::paper::beam()?.length();
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
    let verdicts = verdicts([&contact_4, &contact_7], &shape_8, &exact);
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
        verdicts,
    };
    Ok(Evidence::new(values)
        .figure("figure-4", svg_4, table(&four.nodes, &exact, four.spacing))
        .figure("figure-7", svg_7, table(&seven.nodes, &exact, seven.spacing))
        .figure("figure-8", svg_8, table(&eight.nodes, &exact, four.spacing)))
}

/// Figures 4, 7 and 8; the nodes of both energy methods are off by at most `error` in the last of them.
fn drawings(drawn: &Theory<'_>, [four, seven, eight]: [&Nodes; 3], error: f64) -> Result<[String; 3], PlotError> {
    Ok([
        pressure_and_shape(
            &format!("Figure 4: contact pressure by finite differences, {INTERVALS} intervals"),
            "The example of the paper.",
            drawn,
            &nodal("finite differences", four),
        )?,
        pressure(
            &format!("Figure 7: contact pressure by the energy methods, {INTERVALS} intervals"),
            "The example of the paper.",
            drawn,
            &nodal("force method", seven),
        )?,
        shape(
            &format!("Figure 8: deflection by the energy methods, {INTERVALS} intervals"),
            &format!(
                "The example of the paper. The nodes of both energy methods lie on the dashed line of beam theory, within {} % \
                 of the depth.",
                fixed(100.0 * error, 1)
            ),
            drawn,
            &[nodal("displacement method", eight), nodal("force method", seven)],
        )?,
    ])
}

/// What the first screen says of the three figures.
fn verdicts([four, seven]: [&Contact; 2], eight: &Shape, exact: &FlatSolution) -> Vec<Row> {
    let rebuilt = |figure: &str, paper: String, now: String| Row {
        what: figure.to_owned(),
        paper,
        now,
        verdict: "rebuilt",
        section: "figures-4-7-and-8",
    };
    let lift_off = exact.lift_off.unwrap_or(0.0);
    let pressures = |c: &Contact| {
        format!(
            "first contact force {:.4} at x = {:.3}, beam theory {:.4} at {lift_off:.3}",
            c.forces[0], c.x, exact.end_force
        )
    };
    let lost = |what: &str| format!("{what}, {INTERVALS} intervals; the drawing is lost");
    vec![
        rebuilt("Figure 4, finite differences", lost("contact pressure"), pressures(four)),
        rebuilt("Figure 7, energy methods", lost("contact pressure"), pressures(seven)),
        rebuilt(
            "Figure 8, energy methods",
            lost("deflected shape"),
            format!("nodes within {:.2} % of the depth from beam theory", 100.0 * eight.error),
        ),
    ]
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

fn table(nodes: &Nodes, exact: &FlatSolution, spacing: f64) -> String {
    let header =
        ["x", "contact_force", "contact_force_per_interval", "theory_pressure", "deflection", "theory_deflection"];
    let rows = nodes.x.iter().enumerate().map(|(i, &x)| {
        let (p, v) = (nodes.contact_force[i], nodes.deflection[i]);
        [x, p, p / spacing, exact.pressure(x), v, exact.deflection(x)].map(|value| fixed(value, 6)).to_vec()
    });
    csv(&header, rows)
}
