//! Everything that can be wrong with a scene file, a survey or contact forces: one thing wrong in each case, and all messages, as a
//! person reads them, in `snapshots/messages.snap`.

use palkki::scene::file::{Problem, ReadProblem, parse};
use palkki::scene::{Beam, Foundation, Grid, LinearLoad, Load, Scene, Support};

use crate::scenes::EVERY_KEY;
use crate::support::assert_text;

/// What is replaced in the valid scene, and by what.
const CHANGED: &[(&str, &str)] = &[
    ("length = 10.0", "length = 10.0.0"),
    ("length = 10.0", "length = 10.0\nlength = 11.0"),
    ("[units]", "[beam]"),
    ("length = 10.0", "lenght = 10.0"),
    ("[units]", "[unit]"),
    ("force = 3.0", "moment = 3.0"),
    ("length = 10.0", "\"\\u001b[31m\" = 10.0"),
    ("bending_stiffness = 1.3\n", ""),
    ("at = 5.0, ", ""),
    ("length = 10.0", "length = 'ten'"),
    ("\"m\"", "1"),
    ("[{ at = 5.0, force = 3.0 }]", "{ at = 5.0, force = 3.0 }"),
    ("depth = 1.0", "points = [[0, 1], [10, 1, 1]]"),
    ("depth = 1.0", "polynomial = [1.0, true]"),
    ("\"A valid scene\"", "\"A valid\\nscene\""),
    ("length = 10.0", "length = 1e999"),
    ("depth = 1.0\n", ""),
    ("depth = 1.0", "depth = 1.0\nsurvey = 'levels.csv'"),
    ("length = 10.0", "length = -10"),
    ("length = 10.0", "length = -1e300"),
    ("bending_stiffness = 1.3", "bending_stiffness = 0"),
    ("length = 10.0", "length = nan"),
    ("depth = 1.0", "cosine = { mean = 1.0, amplitude = 0.3, wavelength = 0.0 }"),
    ("uniform = 1.0", "uniform = nan"),
    ("depth = 1.0", "points = [[0, 1], [5, -inf], [10, 1]]"),
    ("at = 5.0", "at = 10.5"),
    ("from = 2.0, to = 5.0", "from = 5.0, to = 2.0"),
    ("depth = 1.0", "polynomial = []"),
    ("depth = 1.0", "polynomial = [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1e-9, 0]"),
    ("depth = 1.0", "points = [[0, 1]]"),
    ("depth = 1.0", "points = [[0, 1], [6, 1], [5, 1], [10, 1]]"),
    ("depth = 1.0", "points = [[0, 1], [5, 1], [5, 2], [5.0, 3], [10, 1]]"),
    ("depth = 1.0", "points = [[0.5, 1], [10, 1]]"),
    ("depth = 1.0", "polynomial = [1.0, -0.2]"),
    ("depth = 1.0", "points = [[0, 1],\n  [10, -1]]"),
    ("uniform = 1.0", "uniform = 1e308"),
    ("depth = 1.0", "polynomial = [1, 1e308, 1e308]"),
    ("bending_stiffness = 1.3", "bending_stiffness = 1e-307"),
    ("depth = 1.0", "depth = 1.0\nstiffness = 0"),
    ("depth = 1.0", "depth = 1.0\nstiffness = -2.5"),
    ("depth = 1.0", "depth = 1.0\nstiffness = 'soft'"),
    ("depth = 1.0", "depth = 1.0\nstiffness = inf"),
    ("depth = 1.0", "stiffness = 100.0"),
    ("depth = 1.0", "depth = 1.0\nstiffness = 1e306"),
];

/// One line more, or two, in `[beam]`.
const OF_THE_BEAM: &[&str] = &[
    "supports = [{ at = 4 }, { at = 10 }, { at = 4.0, level = 0.1 }]",
    "supports = [{ at = 4.000000001, level = 0.1 }, { at = 10 }, { at = 4 }]",
    "supports = [{ at = 0 }, { at = 10.5 }]",
    "supports = [{ at = 0, level = nan }, { at = 10 }]",
    "supports = [{ at = 0, slope = 0.1 }, { at = 10 }]",
    "supports = [{ at = 0, built_in = 1 }]",
    "supports = [{ at = 0, depth = 0.1 }]",
    "supports = [{ level = 0.1 }]",
    "supports = { at = 0 }",
    "supports = [{ at = 0 }, { at = 4, level = 1.5 }, { at = 10 }]",
    "supports = [{ at = 0, built_in = true, level = 1.0, slope = 0.1 }]",
    "supports = [{ at = 10, built_in = true, level = 1.0, slope = -0.1 }]",
    "supports = [{ at = 0 }, { at = 4, pushes_only = true, built_in = true }]",
    "supports = [{ at = 0 }, { at = 4, pushes_only = true, slope = 0.1 }]",
    "supports = [{ at = 0 }, { at = 4, pushes_only = 'yes' }]",
    "supports = [{ at = 0 }, { at = 4, pushes_only = true, level = 1.5 }, { at = 10 }]",
    "supports = [{ at = 0, pushes_only = true }, { at = 0 }, { at = 10 }]",
    "shape = { points = [[0, 0.0], [9, 0.1]] }",
    "shape = { points = [[0, 0.0]] }",
    "shape = { points = [[0, 0.0], [4, 0.1], [4, 0.2], [10, 0.0]] }",
    "shape = { polynomial = [] }",
    "shape = { cosine = { mean = 0, amplitude = 1, wavelength = 0 } }",
    "shape = { }",
    "shape = { depth = 0, polynomial = [0.0] }",
    "shape = { points = [[0, 0.0], [4, 0.5], [10, 0.0]] }\nsupports = [{ at = 4, built_in = true }]",
];

/// Whole files.
const FILES: &[&str] = &[
    "",
    "# to be done\n",
    "[beam]\nlength = [1, 2",
    "[beam]\nlength = \u{0}\n",
    "[load]\nuniform = 1.0\n",
    "beam = [10.0, 1.3]\n",
];

/// Surveys of the ground.
const SURVEYS: &[&str] = &[
    "0,1\n10,1\n",
    "\n# nothing yet\n",
    "x,depth\n0,1\n5;0.5\n10,1\n",
    "x,depth\n0,1\n5,0,5\n10,1\n",
    "x;depth\n0;1,5\n5;1.000\n10;1\n",
    "x,depth\n0,1\n5, half\n10,1\n",
    "x,depth\n0,1\n5,\n10,1\n",
    "x,depth\n0,1\n5,1e999\n10,1\n",
    "\u{feff}x, depth\r\n# west\r\n0,1\r\n\r\n6,1\r\n  5 ,1\r\n10,1\r\n",
    "x,depth\n0,1\n9.5,1\n",
    "x,depth\n0,-0.125\n10,1\n",
    "x,depth\n0,1\n10,-1\n\n",
    "x,depth\n0,1\n",
    "x,depth\n",
];

const STIFFNESS: &str = "bending_stiffness = 1.3";
const DEPTH: [&str; 2] = ["depth = 1.0", "survey = 'levels.csv'"];

/// The valid scene with one thing replaced.
fn changed(from: &str, to: &str) -> String {
    assert!(EVERY_KEY.contains(from), "the valid scene does not contain {from:?}");
    EVERY_KEY.replacen(from, to, 1)
}

/// The message for a scene with a survey.
fn message(text: &str, survey: Result<&str, ReadProblem>) -> String {
    let read = |_: &str| survey.clone().map(str::to_owned);
    parse("site/scene.toml", text, read).expect_err("one thing is wrong in it").to_string()
}

#[test]
fn every_message_of_a_file() {
    let surveyed = changed(DEPTH[0], DEPTH[1]);
    let axis = changed(STIFFNESS, &format!("{STIFFNESS}\nshape = {{ survey = 'axis.csv' }}"));
    let unbalanced = changed(STIFFNESS, &format!("{STIFFNESS}\nsupports = []")).replace("uniform = 1", "uniform = -1");
    let pushing = changed(STIFFNESS, &format!("{STIFFNESS}\nsupports = [{{ at = 2, pushes_only = true }}]"));
    let alone = pushing.replace("[foundation]\ndepth = 1.0", "");
    let changes = CHANGED.iter().map(|(from, to)| changed(from, to));
    let of_the_beam = OF_THE_BEAM.iter().map(|line| changed(STIFFNESS, &format!("{STIFFNESS}\n{line}")));
    let texts =
        changes.chain(of_the_beam).chain(FILES.iter().map(|text| (*text).to_owned())).chain([unbalanced, alone]);
    let mut messages: Vec<String> = texts.map(|text| message(&text, Err(ReadProblem::Missing))).collect();
    messages.extend(SURVEYS.iter().map(|survey| message(&surveyed, Ok(survey))));
    messages.push(message(&axis, Ok("x,depth\n0,0\n4,0.1\n11,0\n")));
    let unreadable = [ReadProblem::Missing, ReadProblem::Directory, ReadProblem::NotText { line: 3, column: 7 }];
    messages.extend(unreadable.map(|problem| message(&surveyed, Err(problem))));
    assert_text!("messages", "Every message about a file", messages.join("\n\n"));
}

#[test]
fn without_the_fault_the_scene_is_valid() {
    for text in [EVERY_KEY, &changed(DEPTH[0], DEPTH[1])] {
        assert!(parse("scene.toml", text, |_| Ok("x,depth\n0,1\n5,0.5\n10,1\n".to_owned())).is_ok(), "{text}");
    }
}

/// Every character that a figure could not hold or that would turn the direction of its text, in a title and in a unit.
#[test]
fn forbidden_characters() {
    let turning = ('\u{202a}'..='\u{202e}').chain('\u{2066}'..='\u{2069}');
    for character in turning.chain(['\u{fffe}', '\u{ffff}']) {
        let scene = changed("\"A valid scene\"", &format!("\"A v{character}lid scene\""));
        let found = message(&scene, Err(ReadProblem::Missing));
        let expected = format!("`title` must not have the character U+{:04X}, its character 4: ", u32::from(character));
        assert!(found.contains(&expected), "{found}");
        assert!(!found.lines().next().unwrap_or_default().contains(character), "it is not repeated");
    }
    let scene = changed("\"A valid scene\"", "\"A \\u202evalid scene\"");
    let escaped = message(&scene, Err(ReadProblem::Missing));
    assert!(escaped.contains("U+202E, its character 3: it turns the direction of writing"), "{escaped}");
}

/// As spreadsheets write them where the comma is the decimal mark: the same scene, to the bit.
#[test]
fn surveys_with_semicolons_and_decimal_commas_are_read() {
    let scene = EVERY_KEY.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    let read = |text: &str| parse("scene.toml", &scene, |_| Ok(text.to_owned())).expect("a survey");
    let plain = "x,depth\n0,1\n2.5,0.75\n 7.25 ,1e-1\n10,1.125\n";
    let semicolons = plain.replace(',', ";");
    let commas = semicolons.replace('.', ",");
    for text in
        [&semicolons, &commas, &commas.replace('\n', "\r\n"), &format!("\u{feff}# made by hand, in a hurry\n{commas}")]
    {
        assert_eq!(read(text), read(plain), "{text}");
    }
}

/// What is read is what was written.
#[test]
fn supports_and_shape_are_read() {
    let lines = "supports = [{ at = 7.0, level = 0.2, pushes_only = true }, { at = 10, pushes_only = false }, \
                 { at = 0.0, built_in = true, slope = 0.05 }, { at = 4.0, level = 0.3 }]\n\
                 shape = { polynomial = [0.0, -0.051, 0.03] }";
    let text = EVERY_KEY.replacen(STIFFNESS, &format!("{STIFFNESS}\n{lines}"), 1).replacen("depth = 1", "depth = 9", 1);
    let scene = parse("scene.toml", &text, |_| Ok(String::new())).expect("a scene");
    let expected = [
        Support { level: 0.0, slope: Some(0.05), ..Support::simple(0.0) },
        Support::simple(4.0).at_level(0.3),
        Support::simple(10.0),
    ];
    assert_eq!(scene.beam().supports(), expected);
    assert_eq!(scene.beam().bearings(), [Support::pushing(7.0).at_level(0.2)]);
    let held = scene.held();
    let asked: Vec<(f64, Option<f64>)> = held.iter().map(|held| (held.deflection, held.slope)).collect();
    let own = |x: f64| (0.03 * x - 0.051) * x;
    let close = |a: f64, b: f64| (a - b).abs() < 1e-15;
    assert!(close(asked[0].0, 0.0) && asked[0].1.is_some_and(|slope| close(slope, 0.05 + 0.051)), "{asked:?}");
    assert!(close(asked[1].0, 0.3 - own(4.0)) && close(asked[2].0, -own(10.0)), "{asked:?}");
    assert!(close(scene.gap(2.0), 9.0 - own(2.0)) && close(scene.gap(7.0), 0.2 - own(7.0)));
    assert!(!scene.beam().is_simple());
}

/// What no scene file can say: a grid, and numbers that come from a program.
#[test]
fn every_message_of_a_constructor() {
    let beam = Beam::new(10.0, 1.3).expect("a valid beam");
    let scene = Scene::new(beam.clone(), Load::default(), None).expect("a valid scene");
    let backwards = LinearLoad { from: 3.0, to: 3.0, start: 1.0, end: 1.0 };
    let messages = [
        Grid::uniform(&scene, 0).expect_err("no intervals"),
        Grid::uniform(&scene, 1).expect_err("no interior node"),
        Beam::new(f64::INFINITY, 1.3).expect_err("infinite length"),
        Load::new(&beam, 0.0, vec![backwards], vec![]).expect_err("no length"),
        Foundation::Flat { depth: -0.5 }.checked(&beam).expect_err("above the supports"),
    ];
    let refused = ReadProblem::Refused { reason: "permission denied".to_owned() };
    let unreadable =
        [refused, ReadProblem::TooLarge { limit: 1000 }].map(|problem| Problem::Unreadable(problem).to_string());
    let messages: Vec<String> = messages.iter().map(ToString::to_string).chain(unreadable).collect();
    assert_text!("constructors", "Messages that no scene file shows", messages.join("\n"));
}

#[test]
fn supports_are_a_distance_apart() {
    let beam = |distance: f64| {
        let supports = vec![Support::simple(4.0), Support::simple(4.0 + distance)];
        Beam::new(10.0, 1.3).and_then(|beam| beam.with_supports(supports))
    };
    assert!(beam(2.2e-9).is_err() && beam(2.3e-9).is_ok());
}

/// On the level of a built-in support, and the ground falls off: well posed.
#[test]
fn ground_may_fall_off_at_a_built_in_support() {
    for slope in [0.0, -0.1] {
        let supports = vec![Support { level: 1.0, slope: Some(slope), ..Support::simple(0.0) }];
        let beam = Beam::new(10.0, 1.3).and_then(|beam| beam.with_supports(supports)).expect("a beam");
        assert!(Foundation::Flat { depth: 1.0 }.checked(&beam).is_ok(), "{slope}");
    }
}
