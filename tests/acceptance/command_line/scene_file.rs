//! Scene files: what is written is what is read, whatever way it is written.

use std::collections::BTreeSet;

use palkki::scene::file::parse;
use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};

use crate::scenes;

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

#[test]
fn every_key_of_the_contract_is_read() {
    let scene = scene(scenes::EVERY_KEY);
    assert_eq!(scene.title(), "A valid scene");
    assert_eq!(scene.beam(), &Beam::new(10.0, 1.3).expect("a valid beam"));
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
    for (written, phase) in [("", 0.0), (", phase = 0.25", 0.25)] {
        let expected = Foundation::Cosine { mean: 1.0, amplitude: 0.3, wavelength: 5.0, phase };
        assert_eq!(foundation(&format!("cosine = {{ mean = 1, amplitude = 0.3, wavelength = 5{written} }}")), expected);
    }
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
    let example = scenes::scene("heinisuo-1984");
    assert_eq!(example.title(), "Heinisuo 1984, the example");
    let beam = Beam::new(10.0, 500.0 / 384.0).expect("a valid beam");
    assert_eq!(example.beam(), &beam);
    assert_eq!(example.load(), &Load::uniform_on(&beam, 1.0).expect("a valid load"), "a uniform load and no other");
    assert_eq!(example.foundation(), Some(&Foundation::Flat { depth: 1.0 }));
}

#[test]
fn every_scene_of_the_report_is_valid_and_says_why_it_is_there() {
    let scenes = scenes::report();
    let titles: BTreeSet<&str> = scenes.iter().map(|(_, scene)| scene.title()).collect();
    assert!(!titles.contains(""), "every scene has a title");
    assert_eq!(titles.len(), scenes.len(), "no two scenes have the same title");
    for (name, _) in &scenes {
        assert!(scenes::text(name).starts_with("# "), "{name} begins with a comment");
    }
    let flat = |scene: &Scene| matches!(scene.foundation(), Some(Foundation::Flat { .. }) | None);
    let uneven = scenes.iter().filter(|(_, scene)| !flat(scene)).count();
    assert!(5 <= uneven, "at least five foundations are truly uneven");
}
