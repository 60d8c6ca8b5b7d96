//! The scenes that the numerical evidence is taken from: those of the report, and small ones made on the spot.

use std::fs;
use std::path::{Path, PathBuf};

use palkki::route::{Method, Solution, Solver};
use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Beam, Foundation, Load, Scene, Support};
use palkki::state::Nodes;
use palkki::{Settings, solve_raw};
pub(crate) use palkki_evidence::compare::apart;
use palkki_evidence::draft::Draft;

/// A valid scene with every key of the contract, and one of the kinds of foundation.
pub(crate) const EVERY_KEY: &str = r#"
title = "A valid scene"

[beam]
length = 10.0
bending_stiffness = 1.3

[load]
uniform = 1.0
linear = [{ from = 2.0, to = 5.0, start = 0.0, end = 1.0 }]
point = [{ at = 5.0, force = 3.0 }]

[foundation]
depth = 1.0

[units]
length = "m"
force = "kN"
"#;

/// The directory of the report's scenes.
fn directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("report/scenes")
}

/// The text of `report/scenes/<name>.toml`.
#[track_caller]
pub(crate) fn text(name: &str) -> String {
    let path = directory().join(name).with_extension("toml");
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("cannot read {name}: {e}"))
}

/// The scene `report/scenes/<name>.toml`.
#[track_caller]
pub(crate) fn scene(name: &str) -> Scene {
    let beside = |survey: &str| fs::read_to_string(directory().join(name).with_file_name(survey));
    parse(name, &text(name), |survey| beside(survey).map_err(|_| ReadProblem::Missing))
        .unwrap_or_else(|e| panic!("{e}"))
}

/// All scenes of the gallery by name, in the order of the alphabet.
pub(crate) fn report() -> Vec<(String, Scene)> {
    in_folder("")
}

/// The scenes of a folder of the report by name, in the order of the alphabet.
pub(crate) fn in_folder(folder: &str) -> Vec<(String, Scene)> {
    let entries = fs::read_dir(directory().join(folder)).expect("the scenes of the report are there");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("the directory can be listed").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned()))
        .map(|name| if folder.is_empty() { name } else { format!("{folder}/{name}") })
        .collect();
    names.sort();
    names.into_iter().map(|name| (name.clone(), scene(&name))).collect()
}

/// The example of the paper.
pub(crate) fn example() -> Scene {
    palkki_evidence::paper::example().expect("the example is well posed")
}

/// A beam of length `l` and stiffness `ei` under a uniform load.
pub(crate) fn uniform(l: f64, ei: f64, load: f64, foundation: Foundation) -> Scene {
    let beam = Beam::new(l, ei).expect("length and stiffness are positive");
    let load = Load::uniform_on(&beam, load).expect("the load is finite");
    Scene::new(beam, load, Some(foundation)).expect("the scene is well posed")
}

/// A beam of some length and stiffness on supports, under a uniform load and point loads `(place, force)`.
#[track_caller]
pub(crate) fn on_supports(
    [length, stiffness]: [f64; 2],
    supports: &[Support],
    (uniform, points): (f64, &[(f64, f64)]),
    ground: Option<Foundation>,
) -> Scene {
    let draft = Draft { length, stiffness, uniform, ground, supports: Some(supports.to_vec()), ..Draft::default() };
    draft.with_points(points).scene().expect("the scene is well posed")
}

/// The supports of the paper.
pub(crate) fn ends(l: f64) -> [Support; 2] {
    [Support::simple(0.0), Support::simple(l)]
}

/// Solves by one route with the default tolerance.
#[track_caller]
pub(crate) fn run(scene: &Scene, method: Method, solver: Solver, intervals: usize) -> Solution<()> {
    solve_raw(scene, &Settings::new(method, solver, intervals)).unwrap_or_else(|e| panic!("{method} {solver}: {e}"))
}

/// The nodal values of a raw solution.
#[track_caller]
pub(crate) fn nodes(raw: &Solution<()>) -> &Nodes {
    raw.state.nodes.as_ref().expect("a discretised method has nodes")
}

/// The largest magnitude in a list, by which differences are measured; what is no number does not count.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, v| most.max(v.abs()))
}
