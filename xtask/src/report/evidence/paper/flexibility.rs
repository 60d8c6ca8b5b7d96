//! Figures 5c and 6 of the paper, drawn again: the forces that its flexibility matrix takes, and what one entry of it means.

// Discrepancy: figures-5c-and-6
//
// By the text Figure 5c has the forces of the flexibility matrix, and Figure 6 the meaning of an entry. We draw the nodal forces
// t = q − p with the deflection C t, and the beam under a unit force at a node.

use palkki::methods::Discrete;
use palkki::plot::{Arrow, Arrows, Axis, Color, Dash, Layer, LoadSketch, Marker, Panel, Place, Style, significant};
use palkki::scene::{Beam, Load, PointLoad};
use palkki_evidence::paper::example;

use crate::report::evidence::prelude::*;

/// Intervals of the grid, few enough to be told apart.
const INTERVALS: usize = 10;
/// The node with the force, and the one with the deflection.
const J: usize = 6;
const I: usize = 3;
/// Nodal forces on a beam are solved by the matrix and by beam theory without any other error, as a share of the largest deflection.
const ROUNDING: f64 = 1e-12;

pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let beam = scene.beam();
    let discrete = Discrete::new(&scene, INTERVALS)?;
    let flexibility = Method::Force.qp(&discrete).matrix();
    let n = discrete.interior();
    let x: Vec<f64> = (1..=n).map(|i| discrete.grid.place(i)).collect();
    let deflection = |forces: &[f64]| -> Vec<Place> {
        (0..n).map(|i| [x[i], (0..n).map(|j| flexibility.entry(i, j) * forces[j]).sum()]).collect()
    };

    let state = on_grid(&scene, Method::Force, Solver::ActiveSet, INTERVALS)?.state;
    let nodal_load = scene.load().uniform() * discrete.spacing;
    let forces: Vec<f64> = nodes_of(&state)?.contact_force.iter().map(|p| nodal_load - p).collect();
    let unit: Vec<f64> = (1..=n).map(|j| if j == J { 1.0 } else { 0.0 }).collect();
    let [all, one] = [&forces, &unit].map(|forces| deflection(forces));
    let [under_all, under_one] = [theory_of(beam, &x, &forces)?, theory_of(beam, &x, &unit)?];

    let sides = [(&all, &under_all), (&one, &under_one)];
    let off = sides.map(|(nodes, exact)| {
        largest(nodes.iter().map(|[x, v]| v - exact.deflection(*x))) / largest(nodes.iter().map(|[_, v]| *v))
    });
    if !off.iter().all(|off| *off <= ROUNDING) {
        return Err(format!(
            "the flexibility is off beam theory by {} and {} of the largest deflection",
            off[0], off[1]
        )
        .into());
    }
    let entry = flexibility.entry(I - 1, J - 1);
    let values = context! {
        intervals => INTERVALS, i => I, j => J, entry,
    };
    let columns = ["node", "x", "force", "deflection", "deflection_under_one"];
    let rows = (0..n).map(|i| row![i + 1, x[i], fixed(forces[i], 6), fixed(all[i][1], 6), fixed(one[i][1], 6)]);
    let data = Table::new(columns).rows(rows);

    let l = beam.length();
    let above = sketch("5c: nodal forces t = q − p, and the deflection C t [length]", l, &all, &under_all)
        .with(arrows(&all, &forces));
    let below = sketch("6: a unit force at node j, the deflection of node i [length]", l, &one, &under_one)
        .with(Layer::Load(LoadSketch {
            level: 0.0,
            intensity: Vec::new(),
            values: Vec::new(),
            points: vec![(x[J - 1], 1.0, format!("1 at j = {J}"))],
            couples: Vec::new(),
        }))
        .with(Layer::line(vec![[x[I - 1], 0.0], one[I - 1]], Style { width: 5, ..Style::solid(Color::VERMILLION) }))
        .with(Layer::Note {
            at: one[I - 1],
            text: format!("c with i = {I}, j = {J}: {}", significant(entry, 4)),
            color: Color::VERMILLION,
            dot: true,
        });
    Evidence::new(values.clone()).figures([study.drawn("figure-5c-6", values, 1, vec![above, below], data)?])
}

/// The beam of the example under forces at nodes, without ground.
fn theory_of(beam: &Beam, x: &[f64], forces: &[f64]) -> Result<theory::Exact, Cause> {
    let points = x.iter().zip(forces).filter(|(_, force)| **force != 0.0);
    let points = points.map(|(&at, &force)| PointLoad { at, force }).collect();
    let load = Load::new(beam, 0.0, Vec::new(), points)?;
    Ok(theory::solve(&Scene::new(beam.clone(), load, None)?)?)
}

/// The beam with its supports: deflections of the nodes, and beam theory between.
fn sketch(name: &str, length: f64, nodes: &[Place], exact: &theory::Exact) -> Panel {
    /// Where beam theory is evaluated.
    const SAMPLES: u32 = 400;
    let places = (0..=SAMPLES).map(|i| length * f64::from(i) / f64::from(SAMPLES));
    let line = places.map(|x| [x, exact.deflection(x)]).collect();
    Panel::new(Axis::along("x [length]", [0.0, length]), Axis::new(name).down().including(&[0.0]))
        .tall(560.0)
        .room(150.0, 60.0)
        .forces(Axis::new("").bare())
        .with(Layer::zero_line([0.0, length]))
        .with(Layer::simple_supports(length))
        .with(Layer::line(line, Style::theory()))
        .with(Layer::line(nodes.to_vec(), Style::marks(Color::BLUE, Marker::Circle)))
}

/// Forces on the beam, downwards, from the line of the supports.
fn arrows(nodes: &[Place], forces: &[f64]) -> Layer {
    let arrow = |(node, force): (&Place, &f64)| Arrow {
        at: [node[0], 0.0],
        force: -force,
        text: String::new(),
        optional: false,
    };
    let arrows = nodes.iter().zip(forces).map(arrow).collect();
    Layer::Arrows(Arrows { arrows, color: Color::BLACK, dash: Dash::Solid })
}
