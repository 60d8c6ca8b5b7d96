//! Exercises with the equations of an answer: what `palkki explain` prints of two scenes, and a figure of each.

use std::collections::BTreeMap;

use palkki::explain::{Explanation, Node};
use palkki::plot::{Arrow, Arrows, Axis, Color, Dash, Layer, Marker, Panel, Place, Style};
use palkki::theory::Exact;

use super::prelude::*;
use crate::report::files;

/// The scenes, each with its directory and the name of its figure.
const SCENES: [(&str, &str, &str); 2] =
    [("spans", scenes::TAUGHT, "taught-spans"), ("hump", scenes::GALLERY, "taught-hump")];

/// The page of the snapshots with what is printed, which a test compares with what the program prints.
const SHOWN: &str = "snapshots/shown@taught.snap";

pub(super) fn evidence(study: &Study<'_>) -> Result<(Value, Vec<Drawn>), Cause> {
    let page = files::text(study.root, SHOWN)?;
    let (mut values, mut figures) = (BTreeMap::new(), Vec::new());
    for (name, directory, figure) in SCENES {
        let scene = scenes::of(study.root, directory, name)?;
        let exact = theory::solve(&scene)?;
        values.insert(name, printed(&page, name)?);
        figures.push(drawn(study, figure, &scene, &exact)?);
    }
    Ok((values.into(), figures))
}

/// What `palkki explain` prints of a scene, from the nodes on.
fn printed(page: &str, name: &str) -> Result<String, Cause> {
    let command = format!("$ palkki explain {name}.toml\n");
    let of_it = page.split_once(&command).and_then(|(_, rest)| rest.split_once("[exit code")).map(|(text, _)| text);
    let from = of_it.and_then(|text| text.find("\nNodes\n").map(|at| text[at..].trim().to_owned()));
    from.ok_or_else(|| format!("{SHOWN} has no explanation of {name}").into())
}

/// The beam with its nodes and their forces; its moments, and the lines between those of the nodes, which a beam has on which no load
/// is between them.
fn drawn(study: &Study<'_>, name: &'static str, scene: &Scene, exact: &Exact) -> Result<Drawn, Cause> {
    const SAMPLES: u32 = 200;
    const PLACES: usize = 5;
    let found = Explanation::of(scene, exact);
    let length = scene.beam().length();
    let samples = exact.samples(scene, SAMPLES);
    let of_nodes = |value: fn(&Node) -> f64| -> Vec<Place> { found.nodes.iter().map(|n| [n.x, value(n)]).collect() };
    let marks = || Style { marker: Some(Marker::Circle), ..Style::marks(Color::BLACK, Marker::Circle) };
    let arrow = |node: &Node| {
        let text = fixed(node.force, 3);
        Arrow { at: [node.x, 0.0], force: node.force, text, optional: false }
    };
    let arrows: Vec<Arrow> = found.nodes.iter().filter(|node| node.force != 0.0).map(arrow).collect();
    let ends = range(arrows.iter().map(|arrow| arrow.force)).unwrap_or_default();
    let along = || Axis::along("x [length]", [0.0, length]);
    let mut shape = Panel::new(along(), Axis::new("deflection v, downwards [length]").down()).tall(500.0);
    if scene.foundation().is_some() {
        shape = shape.with(Layer::Foundation { points: samples.iter().map(|s| [s.x, scene.depth(s.x)]).collect() });
    }
    shape = shape
        .with(Layer::line(samples.iter().map(|s| [s.x, s.deflection]).collect(), Style::solid(Color::BLUE)))
        .with(Layer::line(of_nodes(|node| node.deflection), marks()));
    let forces = Panel::new(along(), Axis::new("forces at the nodes, upwards [force]").including(&ends))
        .tall(500.0)
        .room(80.0, 80.0)
        .with(Layer::zero_line([0.0, length]))
        .with(Layer::Arrows(Arrows { arrows, color: Color::VERMILLION, dash: Dash::Solid }));
    let moment = |node: &Node| node.moments[usize::from(node.x <= 0.0)];
    let mut moments = Panel::new(along(), Axis::new("bending moment M, on the side in tension [force·length]").down())
        .tall(700.0)
        .room(60.0, 60.0)
        .with(Layer::zero_line([0.0, length]))
        .with(Layer::line(samples.iter().map(|s| [s.x, s.moment]).collect(), Style::solid(Color::BLUE)))
        .with(Layer::line(of_nodes(moment), Style::theory()))
        .with(Layer::line(of_nodes(moment), marks()));
    for (i, node) in found.nodes.iter().enumerate().filter(|(_, node)| moment(node).abs() > 0.0) {
        let at = [node.x + 0.01 * length, moment(node)];
        let text = format!("M{} = {}", i + 1, fixed(moment(node), 3));
        moments = moments.with(Layer::words(at, Color::BLACK, text));
    }
    let number = |value: f64| fixed(value, PLACES);
    let rows = samples.iter().map(|s| [number(s.x), number(s.deflection), number(s.moment)]);
    let data = Table::new(["x", "deflection", "moment"]).rows(rows).one_a_place();
    let values = context! { title => scene.title(), nodes => found.nodes.len() };
    study.drawn(name, values, 1, vec![shape, forces, moments], data)
}
