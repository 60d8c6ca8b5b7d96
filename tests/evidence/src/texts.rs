//! What holds for every text that somebody may hand over as scene, survey or contact forces. Used by the fuzz targets and by
//! the acceptance suite, which replays what the fuzzer found.
//!
//! - No panic. No hang is what the time limit of the fuzzer is for, and `command_line/hostile.rs` of the acceptance suite.
//! - What is accepted is well posed: finite where it has to be, supports above the foundation, dimensionless numbers of order 1.
//! - What is refused is refused with line and column inside the text, in a message of bounded length that a terminal can show.

use std::ops::ControlFlow;

use palkki::body::matrix_market;
use palkki::scene::file::{self, FileError, Problem, ReadProblem, parse, parse_forces};
use palkki::scene::{Foundation, Scene};

/// The files beside a scene, by their names; no others are there.
#[derive(Debug)]
pub struct Files<'a>(pub &'a [(&'a str, &'a str)]);

impl file::Beside for Files<'_> {
    fn text(&mut self, path: &str) -> Result<String, ReadProblem> {
        let found = self.0.iter().find(|(name, _)| *name == path);
        found.map(|(_, text)| (*text).to_owned()).ok_or(ReadProblem::Missing)
    }

    fn lines(&mut self, path: &str, each: &mut dyn FnMut(&str) -> ControlFlow<()>) -> Result<(), ReadProblem> {
        let _ = self.text(path)?.lines().try_for_each(each);
        Ok(())
    }
}

/// Length of the beam that surveys and forces are read for.
const LENGTH: f64 = 10.0;

/// The scene that a survey is read for.
const SURVEYED: &str =
    "[beam]\nlength = 10\nbending_stiffness = 1\n[load]\nuniform = 1\n[foundation]\nsurvey = 'levels.csv'\n";

/// The same with columns that are declared in several ways.
const DECLARED: [&str; 4] = [
    "{ file = 'levels.csv', x = 'x', depth = 'depth' }",
    "{ file = 'levels.csv', x = 1, depth = 2, no_data = -9999 }",
    "{ file = 'levels.csv', x = 2, elevation = 1, datum = 3.5, origin = -1 }",
    "{ file = 'levels.csv', x = 1, elevation = 'depth', datum = 1, origin = 20, direction = 'down', no_data = '' }",
];

/// The survey that a scene finds when it names one.
const LEVELS: &str = "x,depth\n0,1\n4,0.5\n10,1\n";

/// Bytes of the longest message: a picture of the longest line that gets one, coloured and with its caret below it, and the
/// words around it.
const LONGEST_MESSAGE: usize = 24_000;

/// Reads bytes as a scene; true if it is one. What is not UTF-8 is refused before it gets here.
pub fn scene(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    accepted(text, parse("scene.toml", text, |_| Ok(LEVELS.to_owned())))
}

/// Reads bytes as the survey of a scene; true if it is one.
pub fn survey(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    for declared in DECLARED {
        let scene = SURVEYED.replace("'levels.csv'", declared);
        accepted(text, parse("scene.toml", &scene, |_| Ok::<_, ReadProblem>(text.to_owned())));
    }
    accepted(text, parse("scene.toml", SURVEYED, |_| Ok::<_, ReadProblem>(text.to_owned())))
}

/// Reads bytes as contact forces; true if that is what they are.
pub fn forces(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    match parse_forces("forces.csv", text, LENGTH) {
        Ok(forces) => {
            assert!(forces.len() <= text.split(['\n', '\r']).count(), "a force for each row at most");
            assert!(
                forces.iter().all(|(x, force)| (0.0..=LENGTH).contains(x) && force.is_finite()),
                "on the beam, finite"
            );
            true
        }
        Err(error) => {
            refused(text, &error);
            false
        }
    }
}

/// The scene that a matrix is read for.
const BODY: &str = "[body]\nstiffness = 'K.mtx'\n";

/// One file beside the scene of a body.
struct Beside<'a>(&'a str);

impl file::Beside for Beside<'_> {
    fn text(&mut self, _: &str) -> Result<String, ReadProblem> {
        Err(ReadProblem::Missing)
    }

    fn lines(&mut self, _: &str, each: &mut dyn FnMut(&str) -> ControlFlow<()>) -> Result<(), ReadProblem> {
        let _ = self.0.split('\n').try_for_each(each);
        Ok(())
    }
}

/// Reads bytes as the matrix of a body; true if it is one.
pub fn matrix(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    match file::parse_model("body.toml", BODY, &mut Beside(text)) {
        Ok(model) => {
            let file::Model::Body(body) = model else { panic!("it is no beam") };
            let matrix = body.program().profile();
            assert!(matrix.numbers() <= matrix_market::MOST_NUMBERS, "{} numbers", matrix.numbers());
            let rows = 0..matrix.dimension();
            assert!(rows.clone().all(|i| matrix.row(i).iter().all(|a| a.is_finite())), "finite");
            assert!(rows.clone().all(|i| 0.0 < matrix.entry(i, i)), "a positive diagonal");
            true
        }
        Err(error) => {
            if error.place.is_some() {
                refused(text, &error);
            }
            false
        }
    }
}

fn accepted(text: &str, outcome: Result<Scene, Box<FileError>>) -> bool {
    match outcome {
        Ok(scene) => {
            well_posed(&scene);
            true
        }
        Err(error) => {
            refused(text, &error);
            false
        }
    }
}

/// A scene that exists has a solution, and can be computed with.
fn well_posed(scene: &Scene) {
    let (beam, load) = (scene.beam(), scene.load());
    let length = beam.length();
    assert!(0.0 < length && length.is_finite(), "length {length}");
    assert!(0.0 < beam.bending_stiffness() && beam.bending_stiffness().is_finite(), "a stiffness");
    assert!(load.magnitude(length).is_finite() && load.resultant(length).is_finite(), "loads");
    for support in beam.supports() {
        let depth = scene.depth(support.at);
        assert!(support.level <= depth, "the foundation lies above the support at {}: {depth}", support.at);
    }
    if scene.foundation().is_some() {
        for k in 0..=16 {
            let depth = scene.gap(length * (f64::from(k) / 16.0));
            assert!(depth.is_finite(), "depth {depth}");
        }
    }
    if let Some(Foundation::Polyline { points }) = scene.foundation() {
        assert!(2 <= points.len() && points.is_sorted_by(|a, b| a[0] <= b[0]), "points from left to right");
    }
    let printed = scene.title().chars().chain(scene.units().length.iter().flat_map(|label| label.chars()));
    assert!(!printed.into_iter().any(char::is_control), "labels can be printed");

    // Again from its parts, and in dimensionless numbers.
    assert!(Scene::new(beam.clone(), load.clone(), scene.foundation().cloned()).is_ok(), "its parts make a scene");
    match scene.scaled() {
        Ok(scaled) => {
            let beam = scaled.scene.beam();
            let normal = |value: f64, scale: f64| !scale.is_normal() || (1.0..2.0).contains(&value);
            assert!(normal(beam.length(), length), "dimensionless length {}", beam.length());
            assert!(normal(beam.bending_stiffness(), scene.beam().bending_stiffness()), "dimensionless stiffness");
            assert!(scaled.scene.load().magnitude(beam.length()) < 4.0, "dimensionless load");
        }
        Err(error) => panic!("a scene that was accepted cannot be scaled: {error}"),
    }
}

/// A message points at a place in the text, and is one for a person at a terminal.
fn refused(text: &str, error: &FileError) {
    match &error.place {
        // `survey` reads two files; the scene file around it has fewer lines than this allows.
        Some(place) => {
            let lines = text.split(['\n', '\r']).count().max(SURVEYED.split('\n').count());
            assert!((1..=lines).contains(&place.line), "line {} of {lines}", place.line);
            let longest = text.split('\n').map(|line| line.chars().count()).max().unwrap_or(0);
            let longest = longest.max(SURVEYED.len());
            assert!((1..=longest + 1).contains(&place.column), "column {} of {longest}", place.column);
        }
        None => assert!(matches!(error.problem, Problem::Empty), "no place: {}", error.problem),
    }
    let plain = error.to_string();
    assert!(plain.starts_with("error: ") && plain.contains(&error.file), "{plain}");
    assert!(!plain.chars().any(|c| c.is_control() && c != '\n'), "control characters in {plain:?}");
    assert!(plain.len() <= LONGEST_MESSAGE, "a message of {} bytes", plain.len());
    // The same with escape sequences; it takes as long, so not always.
    if text.len().is_multiple_of(16) {
        assert!(error.render(true).len() <= LONGEST_MESSAGE, "a coloured message");
    }
}
