//! Everything that can be wrong with a scene file or a survey: one valid scene, one thing wrong in each test, and the
//! message as a person reads it.

use palkki::scene::file::{Problem, ReadProblem, parse};
use palkki::scene::{Beam, Foundation, Grid, LinearLoad, Load, Scene};

const VALID: &str = r#"
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
"#;

const SURVEY: &str = "x,depth\n0,1\n5,0.5\n10,1\n";

/// The message for `VALID` with `from` replaced by `to`.
#[track_caller]
fn message(from: &str, to: &str) -> String {
    assert!(VALID.contains(from), "the valid scene does not contain {from:?}");
    message_of(&VALID.replacen(from, to, 1))
}

#[track_caller]
fn message_of(text: &str) -> String {
    let error = parse("scene.toml", text, |_| Ok(SURVEY.to_owned())).expect_err("this scene is not valid");
    error.to_string()
}

/// The message for a scene with the survey `text`.
#[track_caller]
fn survey(text: &str) -> String {
    let scene = VALID.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    let error = parse("site/scene.toml", &scene, |_| Ok(text.to_owned())).expect_err("this survey is not valid");
    error.to_string()
}

/// The message for a scene whose survey is not there to read.
#[track_caller]
fn unreadable(problem: ReadProblem) -> String {
    let scene = VALID.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    let error = parse("site/scene.toml", &scene, |_| Err(problem)).expect_err("there is no survey");
    error.to_string()
}

#[test]
fn the_valid_scene_is_valid() {
    assert!(parse("scene.toml", VALID, |_| Ok(SURVEY.to_owned())).is_ok(), "each test below changes one thing in it");
    let scene = VALID.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    assert!(parse("scene.toml", &scene, |_| Ok(SURVEY.to_owned())).is_ok(), "and so with a survey");
}

// One test for every variant of `SceneError`.

#[test]
fn not_positive() {
    insta::assert_snapshot!(message("length = 10.0", "length = -10"), @"
    error: `beam.length` must be positive and finite, but is -10
     --> scene.toml:5:10
      |
    5 | length = -10
      |          ^^^
    ");
}

#[test]
fn not_positive_because_zero() {
    insta::assert_snapshot!(message("bending_stiffness = 1.3", "bending_stiffness = 0"), @"
    error: `beam.bending_stiffness` must be positive and finite, but is 0
     --> scene.toml:6:21
      |
    6 | bending_stiffness = 0
      |                     ^
    ");
}

#[test]
fn not_positive_because_nan() {
    insta::assert_snapshot!(message("length = 10.0", "length = nan"), @"
    error: `beam.length` must be positive and finite, but is NaN
     --> scene.toml:5:10
      |
    5 | length = nan
      |          ^^^
    ");
}

#[test]
fn not_positive_wavelength() {
    let cosine = "cosine = { mean = 1.0, amplitude = 0.3, wavelength = 0.0 }";
    insta::assert_snapshot!(message("depth = 1.0", cosine), @"
    error: `foundation.cosine.wavelength` must be positive and finite, but is 0
      --> scene.toml:14:54
       |
    14 | cosine = { mean = 1.0, amplitude = 0.3, wavelength = 0.0 }
       |                                                      ^^^
    ");
}

#[test]
fn not_finite() {
    insta::assert_snapshot!(message("uniform = 1.0", "uniform = nan"), @"
    error: `load.uniform` must be finite, but is NaN
     --> scene.toml:9:11
      |
    9 | uniform = nan
      |           ^^^
    ");
}

#[test]
fn not_finite_deep_inside() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [5, -inf], [10, 1]]"), @"
    error: `foundation.points[1][1]` must be finite, but is -inf
      --> scene.toml:14:23
       |
    14 | points = [[0, 1], [5, -inf], [10, 1]]
       |                       ^^^^
    ");
}

#[test]
fn outside_the_beam() {
    insta::assert_snapshot!(message("at = 5.0", "at = 10.5"), @"
    error: `load.point[0].at` must lie on the beam, between 0 and 10, but is 10.5
      --> scene.toml:11:17
       |
    11 | point = [{ at = 10.5, force = 3.0 }]
       |                 ^^^^
    ");
}

#[test]
fn empty_load() {
    insta::assert_snapshot!(message("from = 2.0, to = 5.0", "from = 5.0, to = 2.0"), @"
    error: `load.linear[0].to` must be greater than the start of the load, 5, but is 2
      --> scene.toml:10:30
       |
    10 | linear = [{ from = 5.0, to = 2.0, start = 0.0, end = 1.0 }]
       |                              ^^^
    ");
}

#[test]
fn no_coefficients() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = []"), @"
    error: `foundation.polynomial` needs at least one coefficient, but has none
      --> scene.toml:14:14
       |
    14 | polynomial = []
       |              ^^
    ");
}

#[test]
fn too_few_points() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1]]"), @"
    error: a foundation given by points needs at least 2 of them, but has 1
      --> scene.toml:14:10
       |
    14 | points = [[0, 1]]
       |          ^^^^^^^^
    ");
}

#[test]
fn points_run_back() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [6, 1], [5, 1], [10, 1]]"), @"
    error: `foundation.points[2][0]` must not be less than the place of the point before it, 6, but is 5
      --> scene.toml:14:28
       |
    14 | points = [[0, 1], [6, 1], [5, 1], [10, 1]]
       |                            ^
    ");
}

#[test]
fn three_points_at_one_place() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [5, 1], [5, 2], [5.0, 3], [10, 1]]"), @"
    error: `foundation.points[3][0]` is the third point at x = 5: two points make a step, more have no meaning
      --> scene.toml:14:36
       |
    14 | points = [[0, 1], [5, 1], [5, 2], [5.0, 3], [10, 1]]
       |                                    ^^^
    ");
}

#[test]
fn points_do_not_cover_the_beam() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0.5, 1], [10, 1]]"), @"
    error: a foundation given by points must reach from 0 to 10, but `foundation.points[0][0]` is 0.5
      --> scene.toml:14:12
       |
    14 | points = [[0.5, 1], [10, 1]]
       |            ^^^
    ");
}

#[test]
fn foundation_above_a_support() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = [1.0, -0.2]"), @"
    error: the foundation must not lie above a support, but its depth at the right support (x = 10) is -1; no deflection satisfies the supports and the foundation
      --> scene.toml:14:14
       |
    14 | polynomial = [1.0, -0.2]
       |              ^^^^^^^^^^^
    ");
}

#[test]
fn foundation_above_a_support_by_a_point() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1],\n  [10, -1]]"), @"
    error: the foundation must not lie above a support, but its depth at the right support (x = 10) is -1; no deflection satisfies the supports and the foundation
      --> scene.toml:15:8
       |
    15 |   [10, -1]]
       |        ^^
    ");
}

#[test]
fn overflow_of_all_loads_together() {
    insta::assert_snapshot!(message("uniform = 1.0", "uniform = 1e308"), @"
    error: `load` leads to numbers beyond the range of 64-bit floating point (the sum of all loads is inf)
     --> scene.toml:8:1
      |
    8 | [load]
      | ^^^^^^
    ");
}

#[test]
fn overflow_of_the_foundation() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = [1, 1e308, 1e308]"), @"
    error: `foundation` leads to numbers beyond the range of 64-bit floating point (a bound on its depth is inf)
      --> scene.toml:14:14
       |
    14 | polynomial = [1, 1e308, 1e308]
       |              ^^^^^^^^^^^^^^^^^
    ");
}

#[test]
fn overflow_of_the_units() {
    insta::assert_snapshot!(message("bending_stiffness = 1.3", "bending_stiffness = 1e-307"), @"
    error: `beam.bending_stiffness` leads to numbers beyond the range of 64-bit floating point (the unit of depth is inf)
     --> scene.toml:6:21
      |
    6 | bending_stiffness = 1e-307
      |                     ^^^^^^
    ");
}

/// The one error that comes from a grid and not from a file.
#[test]
fn too_few_intervals() {
    let beam = Beam::new(10.0, 1.3).expect("a valid beam");
    let scene = Scene::new(beam, Load::default(), None).expect("a valid scene");
    insta::assert_snapshot!(Grid::uniform(&scene, 0).expect_err("no intervals"), @"the number of intervals must be at least 2, but is 0");
    insta::assert_snapshot!(Grid::uniform(&scene, 1).expect_err("no interior node"), @"the number of intervals must be at least 2, but is 1");
}

// The same rules without a file.

#[test]
fn constructors_name_quantity_value_and_requirement() {
    let beam = Beam::new(10.0, 1.3).expect("a valid beam");
    let backwards = LinearLoad { from: 3.0, to: 3.0, start: 1.0, end: 1.0 };
    insta::assert_snapshot!(Beam::new(f64::INFINITY, 1.3).expect_err("infinite length"), @"`beam.length` must be positive and finite, but is inf");
    insta::assert_snapshot!(Load::new(&beam, 0.0, vec![backwards], vec![]).expect_err("no length"), @"`load.linear[0].to` must be greater than the start of the load, 3, but is 3");
    insta::assert_snapshot!(Foundation::Flat { depth: -0.5 }.checked(&beam).expect_err("above the supports"), @"the foundation must not lie above a support, but its depth at the left support (x = 0) is -0.5; no deflection satisfies the supports and the foundation");
}

// The file: one test for every variant of `Problem`, and the ways to meet it.

#[test]
fn empty_file() {
    insta::assert_snapshot!(message_of(""), @"
    error: the file is empty
    --> scene.toml
     = note: expected a scene in TOML, with at least a table [beam]
    ");
}

#[test]
fn nothing_but_a_comment() {
    insta::assert_snapshot!(message_of("# to be done\n"), @"
    error: the key `beam` is missing in the scene
     --> scene.toml:1:1
      |
    1 | # to be done
      | ^ expected a table `[beam]`
    ");
}

#[test]
fn syntax() {
    insta::assert_snapshot!(message("length = 10.0", "length = 10.0.0"), @"
    error: not valid TOML: invalid float
     --> scene.toml:5:14
      |
    5 | length = 10.0.0
      |              ^^
    ");
}

#[test]
fn syntax_never_closed() {
    insta::assert_snapshot!(message_of("[beam]\nlength = [1, 2"), @"
    error: not valid TOML: unclosed array, expected `]`
     --> scene.toml:2:15
      |
    2 | length = [1, 2
      |               ^
    ");
}

#[test]
fn syntax_control_character() {
    insta::assert_snapshot!(message_of("[beam]\nlength = \u{0}\n"), @"
    error: not valid TOML: string values must be quoted, expected literal string
     --> scene.toml:2:10
      |
    2 | length = ␀
      |          ^
    ");
}

#[test]
fn key_twice() {
    insta::assert_snapshot!(message("length = 10.0", "length = 10.0\nlength = 11.0"), @"
    error: the key `length` is there twice
     --> scene.toml:6:1
      |
    6 | length = 11.0
      | ^^^^^^ expected only once
    ");
}

#[test]
fn table_twice() {
    insta::assert_snapshot!(message("[units]", "[beam]"), @"
    error: the key `beam` is there twice
      --> scene.toml:16:2
       |
    16 | [beam]
       |  ^^^^ expected only once
    ");
}

#[test]
fn unknown_key() {
    insta::assert_snapshot!(message("length = 10.0", "lenght = 10.0"), @r#"
    error: unknown key "lenght" in `beam`
     --> scene.toml:5:1
      |
    5 | lenght = 10.0
      | ^^^^^^ expected one of `length`, `bending_stiffness`
    "#);
}

#[test]
fn unknown_table() {
    insta::assert_snapshot!(message("[units]", "[unit]"), @r#"
    error: unknown key "unit" in the scene
      --> scene.toml:16:2
       |
    16 | [unit]
       |  ^^^^ expected one of `title`, `beam`, `load`, `foundation`, `units`
    "#);
}

#[test]
fn unknown_key_in_a_load() {
    insta::assert_snapshot!(message("force = 3.0", "moment = 3.0"), @r#"
    error: unknown key "moment" in `load.point[0]`
      --> scene.toml:11:22
       |
    11 | point = [{ at = 5.0, moment = 3.0 }]
       |                      ^^^^^^ expected one of `at`, `force`
    "#);
}

#[test]
fn unknown_key_that_would_upset_a_terminal() {
    insta::assert_snapshot!(message("length = 10.0", "\"\\u001b[31m\" = 10.0"), @r#"
    error: unknown key "\u{1b}[31m" in `beam`
     --> scene.toml:5:1
      |
    5 | "\u001b[31m" = 10.0
      | ^^^^^^^^^^^^ expected one of `length`, `bending_stiffness`
    "#);
}

#[test]
fn missing_key() {
    insta::assert_snapshot!(message("bending_stiffness = 1.3\n", ""), @"
    error: the key `bending_stiffness` is missing in `beam`
     --> scene.toml:4:1
      |
    4 | [beam]
      | ^^^^^^ expected `bending_stiffness = …`, a number
    ");
}

#[test]
fn missing_key_of_a_load() {
    insta::assert_snapshot!(message("at = 5.0, ", ""), @"
    error: the key `at` is missing in `load.point[0]`
      --> scene.toml:11:10
       |
    11 | point = [{ force = 3.0 }]
       |          ^^^^^^^^^^^^^^^ expected `at = …`, a number
    ");
}

#[test]
fn missing_beam() {
    insta::assert_snapshot!(message_of("[load]\nuniform = 1.0\n"), @"
    error: the key `beam` is missing in the scene
     --> scene.toml:1:1
      |
    1 | [load]
      | ^ expected a table `[beam]`
    ");
}

#[test]
fn wrong_type_text_for_a_number() {
    insta::assert_snapshot!(message("length = 10.0", "length = 'ten'"), @r#"
    error: `beam.length` must be a number, but is the text "ten"
     --> scene.toml:5:10
      |
    5 | length = 'ten'
      |          ^^^^^
    "#);
}

#[test]
fn wrong_type_number_for_text() {
    insta::assert_snapshot!(message("\"m\"", "1"), @"
    error: `units.length` must be one line of text, but is the integer 1
      --> scene.toml:17:10
       |
    17 | length = 1
       |          ^
    ");
}

#[test]
fn wrong_type_array_for_a_table() {
    insta::assert_snapshot!(message_of("beam = [10.0, 1.3]\n"), @"
    error: `beam` must be a table, but is an array of length 2
     --> scene.toml:1:8
      |
    1 | beam = [10.0, 1.3]
      |        ^^^^^^^^^^^
    ");
}

#[test]
fn wrong_type_table_for_an_array() {
    insta::assert_snapshot!(message("[{ at = 5.0, force = 3.0 }]", "{ at = 5.0, force = 3.0 }"), @"
    error: `load.point` must be an array, but is a table
      --> scene.toml:11:9
       |
    11 | point = { at = 5.0, force = 3.0 }
       |         ^^^^^^^^^^^^^^^^^^^^^^^^^
    ");
}

#[test]
fn wrong_type_point_of_three() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [10, 1, 1]]"), @"
    error: `foundation.points[1]` must be a point [x, depth], but is an array of length 3
      --> scene.toml:14:19
       |
    14 | points = [[0, 1], [10, 1, 1]]
       |                   ^^^^^^^^^^
    ");
}

#[test]
fn wrong_type_coefficient() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = [1.0, true]"), @"
    error: `foundation.polynomial[1]` must be a number, but is true
      --> scene.toml:14:20
       |
    14 | polynomial = [1.0, true]
       |                    ^^^^
    ");
}

#[test]
fn wrong_type_title_of_two_lines() {
    insta::assert_snapshot!(message("\"A valid scene\"", "\"A valid\\nscene\""), @r#"
    error: `title` must be one line of text, but is the text "A valid\nscene"
     --> scene.toml:2:9
      |
    2 | title = "A valid\nscene"
      |         ^^^^^^^^^^^^^^^^
    "#);
}

#[test]
fn beyond_the_range() {
    insta::assert_snapshot!(message("length = 10.0", "length = 1e999"), @"
    error: `beam.length` is beyond the range of 64-bit floating point
     --> scene.toml:5:10
      |
    5 | length = 1e999
      |          ^^^^^ expected a magnitude of at most 1.7976931348623157e308
    ");
}

#[test]
fn no_foundation_kind() {
    insta::assert_snapshot!(message("depth = 1.0\n", ""), @"
    error: [foundation] has none of the keys `depth`, `polynomial`, `cosine`, `points`, `survey`
      --> scene.toml:13:1
       |
    13 | [foundation]
       | ^^^^^^^^^^^^ expected exactly one of them, or no [foundation] at all
    ");
}

#[test]
fn several_foundation_kinds() {
    insta::assert_snapshot!(message("depth = 1.0", "depth = 1.0\nsurvey = 'levels.csv'"), @"
    error: [foundation] has 2 keys that each give a foundation: `depth`, `survey`
      --> scene.toml:15:10
       |
    15 | survey = 'levels.csv'
       |          ^^^^^^^^^^^^ expected exactly one of them
    ");
}

#[test]
fn unreadable_survey() {
    insta::assert_snapshot!(unreadable(ReadProblem::Missing), @r#"
    error: cannot read the survey "levels.csv": there is no such file
      --> site/scene.toml:14:10
       |
    14 | survey = 'levels.csv'
       |          ^^^^^^^^^^^^
    "#);
    insta::assert_snapshot!(unreadable(ReadProblem::Directory), @r#"
    error: cannot read the survey "levels.csv": it is a directory, not a file
      --> site/scene.toml:14:10
       |
    14 | survey = 'levels.csv'
       |          ^^^^^^^^^^^^
    "#);
    insta::assert_snapshot!(unreadable(ReadProblem::NotText { line: 3, column: 7 }), @r#"
    error: cannot read the survey "levels.csv": it is not a text file: the byte at line 3, column 7 is not UTF-8
      --> site/scene.toml:14:10
       |
    14 | survey = 'levels.csv'
       |          ^^^^^^^^^^^^
    "#);
}

#[test]
fn survey_header() {
    insta::assert_snapshot!(survey("0,1\n10,1\n"), @r#"
    error: a survey must begin with the header `x,depth`, but begins with "0,1"
     --> site/levels.csv:1:1
      |
    1 | 0,1
      | ^^^ expected `x,depth`, then one point in each row
    "#);
}

#[test]
fn survey_without_header() {
    insta::assert_snapshot!(survey("\n# nothing yet\n"), @"
    error: the survey has neither header nor points
     --> site/levels.csv:1:1
      |
    1 |
      | ^ expected `x,depth`, then one point in each row
    ");
}

#[test]
fn survey_fields() {
    insta::assert_snapshot!(survey("x,depth\n0,1\n5;0.5\n10,1\n"), @"
    error: a row of a survey must have 2 fields, x and depth, but this one has 1
     --> site/levels.csv:3:1
      |
    3 | 5;0.5
      | ^^^^^
    ");
    insta::assert_snapshot!(survey("x,depth\n0,1\n5,0,5\n10,1\n"), @"
    error: a row of a survey must have 2 fields, x and depth, but this one has 3
     --> site/levels.csv:3:1
      |
    3 | 5,0,5
      | ^^^^^
    ");
}

#[test]
fn survey_number() {
    insta::assert_snapshot!(survey("x,depth\n0,1\n5, half\n10,1\n"), @r#"
    error: `depth` must be a finite number, but is "half"
     --> site/levels.csv:3:4
      |
    3 | 5, half
      |    ^^^^
    "#);
    insta::assert_snapshot!(survey("x,depth\n0,1\n5,\n10,1\n"), @r#"
    error: `depth` must be a finite number, but is ""
     --> site/levels.csv:3:3
      |
    3 | 5,
      |   ^
    "#);
    insta::assert_snapshot!(survey("x,depth\n0,1\n5,1e999\n10,1\n"), @r#"
    error: `depth` must be a finite number, but is "1e999"
     --> site/levels.csv:3:3
      |
    3 | 5,1e999
      |   ^^^^^
    "#);
}

#[test]
fn survey_runs_back() {
    insta::assert_snapshot!(survey("\u{feff}x, depth\r\n# west\r\n0,1\r\n\r\n6,1\r\n  5 ,1\r\n10,1\r\n"), @"
    error: `x` must not be less than the place of the point before it, 6, but is 5
     --> site/levels.csv:6:3
      |
    6 |   5 ,1
      |   ^
    ");
}

#[test]
fn survey_does_not_cover_the_beam() {
    insta::assert_snapshot!(survey("x,depth\n0,1\n9.5,1\n"), @"
    error: a foundation given by points must reach from 0 to 10, but `x` is 9.5
     --> site/levels.csv:3:1
      |
    3 | 9.5,1
      | ^^^
    ");
}

#[test]
fn survey_above_a_support() {
    insta::assert_snapshot!(survey("x,depth\n0,-0.125\n10,1\n"), @"
    error: the foundation must not lie above a support, but its depth at the left support (x = 0) is -0.125; no deflection satisfies the supports and the foundation
     --> site/levels.csv:2:3
      |
    2 | 0,-0.125
      |   ^^^^^^
    ");
    insta::assert_snapshot!(survey("x,depth\n0,1\n10,-1\n\n"), @"
    error: the foundation must not lie above a support, but its depth at the right support (x = 10) is -1; no deflection satisfies the supports and the foundation
     --> site/levels.csv:3:1
      |
    3 | 10,-1
      | ^^^^^
    ");
}

#[test]
fn survey_too_short() {
    insta::assert_snapshot!(survey("x,depth\n0,1\n"), @"
    error: a foundation given by points needs at least 2 of them, but has 1
     --> site/levels.csv:2:1
      |
    2 | 0,1
      | ^^^
    ");
    insta::assert_snapshot!(survey("x,depth\n"), @"
    error: a foundation given by points needs at least 2 of them, but has 0
     --> site/levels.csv:1:1
      |
    1 | x,depth
      | ^^^^^^^
    ");
}

// What can be wrong with a file before it is text; the command line has the tests that meet these on a disk.

#[test]
fn unreadable_scene() {
    let says = |problem| Problem::Unreadable(problem).to_string();
    insta::assert_snapshot!(says(ReadProblem::Refused(std::io::ErrorKind::PermissionDenied)), @"cannot read the scene: it cannot be read (permission denied)");
    insta::assert_snapshot!(says(ReadProblem::TooLarge { limit: 1000 }), @"cannot read the scene: it is larger than 1000 bytes, the most that is read");
}
