//! Scene files: what is written is what is read, whatever way it is written; and no text at all makes the reader panic.

use std::fs;
use std::path::{Path, PathBuf};

use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};
use proptest::prelude::*;

/// A scene without a survey.
#[track_caller]
fn scene(text: &str) -> Scene {
    parse("scene.toml", text, |path| panic!("nothing asks for a survey {path}")).expect("a valid scene")
}

const BEAM: &str = "[beam]\nlength = 10\nbending_stiffness = 1.3\n";

#[track_caller]
fn foundation(text: &str) -> Foundation {
    scene(&format!("{BEAM}[foundation]\n{text}\n")).foundation().expect("there is a foundation").clone()
}

fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("report/scenes");
    let files = fs::read_dir(folder).expect("the scenes of the report").map(|entry| entry.expect("an entry").path());
    let mut scenes: Vec<_> = files.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    scenes.sort();
    scenes
}

fn read(path: &Path) -> Scene {
    let text = fs::read_to_string(path).expect("a scene file");
    let survey = |name: &str| fs::read_to_string(path.with_file_name(name)).map_err(|_| ReadProblem::Missing);
    parse(&path.display().to_string(), &text, survey).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_key_of_the_contract_is_read() {
    let scene = scene(
        r#"
title = "Everything"
[beam]
length = 10.0
bending_stiffness = 1.3020833333333333
[load]
uniform = 1.0
linear = [{ from = 2.0, to = 5.0, start = 0.0, end = 1.0 }]
point  = [{ at = 5.0, force = 3.0 }]
[foundation]
depth = 1.0
[units]
length = "m"
force = "kN"
"#,
    );
    assert_eq!(scene.title(), "Everything");
    assert_eq!(scene.beam(), &Beam::new(10.0, 1.302_083_333_333_333_3).expect("a valid beam"));
    assert_eq!(scene.load().uniform().to_bits(), 1.0_f64.to_bits());
    assert_eq!(scene.load().linear(), [LinearLoad { from: 2.0, to: 5.0, start: 0.0, end: 1.0 }]);
    assert_eq!(scene.load().point(), [PointLoad { at: 5.0, force: 3.0 }]);
    assert_eq!(scene.foundation(), Some(&Foundation::Flat { depth: 1.0 }));
    assert_eq!([scene.units().length.as_deref(), scene.units().force.as_deref()], [Some("m"), Some("kN")]);
}

#[test]
fn what_may_be_left_out_may_be_left_out() {
    let bare = scene(BEAM);
    assert_eq!(bare.title(), "");
    assert_eq!(bare.load(), &Load::default());
    assert_eq!(bare.foundation(), None);
    assert_eq!(bare, scene(&format!("{BEAM}[load]\n[units]\n")), "an empty table says nothing");
}

#[test]
fn five_kinds_of_foundation() {
    assert_eq!(foundation("depth = 1"), Foundation::Flat { depth: 1.0 });
    assert_eq!(
        foundation("polynomial = [1.5, -0.2, 0.02]"),
        Foundation::Polynomial { coefficients: vec![1.5, -0.2, 0.02] }
    );
    assert_eq!(
        foundation("cosine = { mean = 1.0, amplitude = 0.3, wavelength = 5.0, phase = 0.25 }"),
        Foundation::Cosine { mean: 1.0, amplitude: 0.3, wavelength: 5.0, phase: 0.25 }
    );
    let points = vec![[0.0, 1.0], [3.0, 1.0], [4.0, 0.5], [5.0, 1.0], [10.0, 1.0]];
    assert_eq!(
        foundation("points = [[0, 1.0], [3, 1.0], [4, 0.5], [5, 1.0], [10, 1.0]]"),
        Foundation::Polyline { points: points.clone() }
    );
    let text = format!("{BEAM}[foundation]\nsurvey = 'levels.csv'\n");
    let survey = parse("scene.toml", &text, |path| {
        assert_eq!(path, "levels.csv", "the name is handed over as it is written");
        Ok("x,depth\n0,1.0\n3,1.0\n4,0.5\n5,1.0\n10,1.0\n".to_owned())
    });
    assert_eq!(survey.expect("a valid survey").foundation(), Some(&Foundation::Polyline { points }));
}

#[test]
fn a_phase_may_be_left_out() {
    assert_eq!(
        foundation("cosine = { mean = 1, amplitude = 0.3, wavelength = 5 }"),
        Foundation::Cosine { mean: 1.0, amplitude: 0.3, wavelength: 5.0, phase: 0.0 }
    );
}

#[test]
fn a_number_is_a_number_however_it_is_written() {
    let expected = scene("[beam]\nlength = 1000.0\nbending_stiffness = 16.0\n");
    for (length, stiffness) in [("1000", "16"), ("1_000", "0x10"), ("1e3", "0b1_0000"), ("+1.0E+3", "0o20")] {
        let text = format!("[beam]\nlength = {length}\nbending_stiffness = {stiffness}\n");
        assert_eq!(scene(&text), expected, "{text}");
    }
    let huge = format!("[beam]\nlength = 1{}\nbending_stiffness = 16\n", "0".repeat(50));
    assert_eq!(scene(&huge).beam().length().to_bits(), 1e50_f64.to_bits(), "an integer beyond 64 bits");
}

#[test]
fn tables_may_be_written_in_any_way_that_toml_has() {
    let expected = scene(&format!("{BEAM}[load]\npoint = [{{ at = 1, force = 2 }}, {{ at = 3, force = 4 }}]\n"));
    let dotted = "beam.length = 10\nbeam.bending_stiffness = 1.3\nload.point = [{at=1,force=2},{at=3,force=4}]";
    let arrays = format!("{BEAM}[[load.point]]\nat = 1\nforce = 2\n[[load.point]]\nat = 3\nforce = 4\n");
    let windows = arrays.replace('\n', "\r\n");
    for text in [dotted, &arrays, &windows, &format!("\u{feff}{arrays}")] {
        assert_eq!(scene(text), expected, "{text}");
    }
}

#[test]
fn a_survey_may_come_from_a_spreadsheet() {
    let text = format!("{BEAM}[foundation]\nsurvey = 'levels.csv'\n");
    let levels = "\u{feff}# surveyed\r\n\r\n x , depth \r\n0,1\r\n# the edge\r\n5 , 5e-1\r\n5,1\r\n\r\n10,\t1\r\n";
    let scene = parse("scene.toml", &text, |_| Ok(levels.to_owned())).expect("a valid survey");
    let points = vec![[0.0, 1.0], [5.0, 0.5], [5.0, 1.0], [10.0, 1.0]];
    assert_eq!(scene.foundation(), Some(&Foundation::Polyline { points }));
}

#[test]
fn the_example_has_the_numbers_of_the_paper() {
    let example = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("report/scenes/heinisuo-1984.toml"));
    assert_eq!(example.title(), "Heinisuo 1984, the example");
    let beam = Beam::new(10.0, 500.0 / 384.0).expect("a valid beam");
    assert_eq!(example.beam(), &beam);
    assert_eq!(example.load(), &Load::uniform_on(&beam, 1.0).expect("a valid load"), "a uniform load and no other");
    assert_eq!(example.foundation(), Some(&Foundation::Flat { depth: 1.0 }));
}

#[test]
fn every_scene_of_the_report_is_valid_and_says_why_it_is_there() {
    let scenes = scenes();
    let mut titles: Vec<_> = scenes.iter().map(|path| read(path).title().to_owned()).collect();
    assert!(!titles.contains(&String::new()), "every scene has a title");
    titles.sort();
    titles.dedup();
    assert_eq!(titles.len(), scenes.len(), "no two scenes have the same title");
    for path in &scenes {
        let text = fs::read_to_string(path).expect("a scene file");
        assert!(text.starts_with("# "), "{} begins with a comment", path.display());
    }
    let uneven = scenes.iter().filter(|path| !matches!(read(path).foundation(), Some(Foundation::Flat { .. }) | None));
    assert!(5 <= uneven.count(), "at least five foundations are truly uneven");
}

/// Nesting that would exhaust the stack of a reader that recurses without a limit.
#[test]
fn deep_nesting_is_an_error() {
    const DEPTH: usize = 100_000;
    let dots = format!("{}a = 1\n", "a.".repeat(DEPTH));
    for text in [
        format!("beam = {}", "[".repeat(DEPTH)),
        format!("beam = {}", "{a=".repeat(DEPTH)),
        format!("[{}a]\n", "a.".repeat(DEPTH)),
        dots,
    ] {
        assert!(parse("scene.toml", &text, |_| Ok(String::new())).is_err(), "nested {DEPTH} deep");
    }
}

const ALL_KINDS: &str = r#"
title = "x"
[beam]
length = 10.0
bending_stiffness = 1.3
[load]
uniform = 1.0
linear = [{ from = 2.0, to = 5.0, start = 0.0, end = 1.0 }]
point = [{ at = 5.0, force = 3.0 }]
[foundation]
survey = "é.csv"
[units]
length = "m"
"#;

const SURVEY: &str = "\u{feff}x,depth\r\n0,1\r\n# é\r\n5,0.5\r\n10,1\r\n";

/// Pieces that a mutation inserts: what has a meaning somewhere in the format.
const PIECES: [&str; 24] = [
    "nan",
    "-inf",
    "1e999",
    "-",
    "[",
    "]",
    "{",
    "}",
    "\"",
    "'",
    "\"\"\"",
    "=",
    ".",
    ",",
    "#",
    "\n",
    "\r",
    "\0",
    "é",
    "\u{feff}",
    "polynomial = []",
    "points = [[0,",
    "[beam]",
    "99999999999999999999",
];

/// `text` with some of its characters replaced: `edits` are (place, characters taken out, piece put in).
fn mutated(text: &str, edits: &[(usize, usize, usize)]) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for &(at, out, piece) in edits {
        let at = at % (text.len() + 1);
        let end = (at + out).min(text.len());
        text.splice(at..end, PIECES[piece % PIECES.len()].chars());
    }
    text.into_iter().collect()
}

/// A message has the file, and a place that lies in it.
fn check_message(text: &str, survey: &str) {
    if let Err(error) = parse("scene.toml", text, |_| Ok(survey.to_owned())) {
        let file = if error.file == "scene.toml" { text } else { survey };
        if let Some(place) = &error.place {
            assert!(place.line <= file.matches('\n').count() + 1, "line {} of {file:?}", place.line);
        }
        assert!(error.to_string().contains(&error.file), "the message names the file");
    }
}

fn edits() -> impl Strategy<Value = Vec<(usize, usize, usize)>> {
    prop::collection::vec((0..1000_usize, 0..6_usize, 0..PIECES.len()), 1..5)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_text_never_panics(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let text = String::from_utf8_lossy(&bytes);
        check_message(&text, SURVEY);
        check_message(ALL_KINDS, &text);
        check_message(ALL_KINDS, &format!("x,depth\n{text}"));
    }

    #[test]
    fn mutated_scenes_never_panic(edits in edits()) {
        check_message(&mutated(ALL_KINDS, &edits), SURVEY);
    }

    #[test]
    fn mutated_surveys_never_panic(edits in edits()) {
        check_message(ALL_KINDS, &mutated(SURVEY, &edits));
    }

    #[test]
    fn any_two_numbers_make_a_beam_or_a_message(length in any::<f64>(), stiffness in any::<f64>(), depth in any::<f64>()) {
        check_message(&format!("[beam]\nlength = {length:e}\nbending_stiffness = {stiffness:e}\n[load]\nuniform = {depth:e}\n[foundation]\ndepth = {depth:e}\n").replace("NaN", "nan"), SURVEY);
    }
}
