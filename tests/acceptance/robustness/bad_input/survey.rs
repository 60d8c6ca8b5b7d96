//! Surveys that are none, or do not fit the beam.

use palkki::scene::file::ReadProblem;

use super::{EVERY_KEY, survey, unreadable};

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
      | ^^^^^ expected decimal points; with decimal commas, `;` between the fields, in the header as well
    ");
}

#[test]
fn survey_with_two_decimal_marks() {
    insta::assert_snapshot!(survey("x;depth\n0;1,5\n5;1.000\n10;1\n"), @r#"
    error: `depth` is "1.000", but other numbers of this file have a decimal comma
     --> site/levels.csv:3:3
      |
    3 | 5;1.000
      |   ^^^^^ expected one decimal mark in all numbers, and nothing between thousands
    "#);
}

/// As spreadsheets write them where the comma is the decimal mark: the same scene, to the bit.
#[test]
fn surveys_with_semicolons_and_decimal_commas_are_read() {
    use palkki::scene::file::parse;
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
    error: the foundation must not lie above a support, but its depth at the support x = 0 is -0.125, above the level 0 of the support; no deflection satisfies the supports and the foundation
     --> site/levels.csv:2:3
      |
    2 | 0,-0.125
      |   ^^^^^^
    ");
    insta::assert_snapshot!(survey("x,depth\n0,1\n10,-1\n\n"), @"
    error: the foundation must not lie above a support, but its depth at the support x = 10 is -1, above the level 0 of the support; no deflection satisfies the supports and the foundation
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
