//! Files that are no scene: one test for every variant of `Problem`, and the ways to meet it.

use palkki::scene::file::{Problem, ReadProblem};

use super::{message, message_of};

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
      | ^^^^^^ expected one of `length`, `bending_stiffness`, `shape`, `supports`
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
      | ^^^^^^^^^^^^ expected one of `length`, `bending_stiffness`, `shape`, `supports`
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

/// Every character that a figure could not hold or that would turn the direction of its text, in a title and in a unit.
#[test]
fn forbidden_characters() {
    let turning = ('\u{202a}'..='\u{202e}').chain('\u{2066}'..='\u{2069}');
    for character in turning.chain(['\u{fffe}', '\u{ffff}']) {
        let found = message("\"A valid scene\"", &format!("\"A v{character}lid scene\""));
        let expected = format!("`title` must not have the character U+{:04X}, its character 4: ", u32::from(character));
        assert!(found.contains(&expected), "{found}");
        assert!(!found.lines().next().unwrap_or_default().contains(character), "it is not repeated");
    }
    let escaped = message("\"A valid scene\"", "\"A \\u202evalid scene\"");
    assert!(escaped.contains("U+202E, its character 3: it turns the direction of writing"), "{escaped}");
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

// What can be wrong with a file before it is text; the command line has the tests that meet these on a disk.

#[test]
fn unreadable_scene() {
    let says = |problem| Problem::Unreadable(problem).to_string();
    insta::assert_snapshot!(says(ReadProblem::Refused { reason: "permission denied".to_owned() }), @"cannot read the scene: it cannot be read (permission denied)");
    insta::assert_snapshot!(says(ReadProblem::TooLarge { limit: 1000 }), @"cannot read the scene: it is larger than 1000 bytes, the most that is read");
}
