//! Numbers as people write them and TOML does not: the message says how to write them.

use palkki::scene::file::{ReadProblem, parse};

/// What a line has in the place of `length = 10.5` or `supports = …`, and the suggestion.
const LINES: &[(&str, &str)] = &[
    ("length = 10,5", "write a decimal point instead of a decimal comma: `10.5`"),
    ("length = -10,5 # m", "write a decimal point instead of a decimal comma: `-10.5`"),
    ("length = \"10,5\"", "write a decimal point instead of a decimal comma: `10.5`, without quotation marks"),
    ("length = \"10.5\"", "write it without quotation marks: `10.5`"),
    ("length = 10.5 m", "write the number alone: `10.5`; the table [units]"),
    ("length = 10.5m", "write the number alone: `10.5`; the table [units]"),
    ("length = \"1.5e3 mm\"", "write the number alone: `1.5e3`; the table [units]"),
    ("length = 10 500", "write the number without blanks or marks between thousands: `10500`"),
    ("length = 10'500.0", "write the number without blanks or marks between thousands: `10500`"),
    ("length = 21/2", "write the result as one number"),
    ("length = 2.1e1*0.5", "write the result as one number"),
    ("length = .5", "write a digit on both sides of the decimal point: `0.5`"),
    ("length = -.5", "write a digit on both sides of the decimal point: `-0.5`"),
    ("length = 10.", "write a digit on both sides of the decimal point: `10.0`"),
    ("length = \u{2212}10.5", "write the minus sign as `-`: `-10.5`"),
    ("length =\u{a0}10.5", "replace the character U+00A0"),
    ("length: 10.5", "write `length = 10.5`"),
    ("length = 10.5;", "remove the `;` behind `10.5`"),
    ("length = 10.5 # m, mm\n; a comment", "begin a comment with `#`"),
    ("length = 10.5\n// a comment", "begin a comment with `#`"),
    ("length = 10.5\nsupports = [{ at = 0 }, { at = 7,5 }]", "write a decimal point instead of a decimal comma: `7.5`"),
    ("length = 10.5\nsupports = [{ at = 0 }, { at = 7,5, level = 1 }]", "instead of a decimal comma: `7.5`"),
    ("length = 10.5\nshape = { points = [[0, 0], [10 m, 0]] }", "write the number alone: `10`"),
    ("length = 10.5\nshape = { points = [[0, 0,5], [10, 0,5]] }", "write numbers with a decimal point"),
    ("Length = 10.5", "write it in lower case: `length`"),
];

#[test]
fn mistyped_numbers_are_answered_with_how_to_write_them() {
    for (line, expected) in LINES {
        let text = format!("[beam]\n{line}\nbending_stiffness = 1.3\n");
        let error = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).expect_err("not valid");
        let message = error.to_string();
        assert!(message.contains("help: ") && message.contains(expected), "{line}: {message}");
    }
    for (text, expected) in [
        ("{\"beam\": {\"length\": 10}}", "this looks like JSON"),
        ("beam:\n  length: 10\n", "write `beam = …`; a table begins with its name in brackets"),
        ("length = 10\nbending_stiffness = 1.3\n", "write it below the line [beam]"),
        (
            "[beam]\nlength = 10\nbending_stiffness = 1.3\n[units]\nlength = \u{201c}m\u{201d}\n",
            "write quotation marks as",
        ),
    ] {
        let message = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect_err("not valid").to_string();
        assert!(message.contains("help: ") && message.contains(expected), "{text}: {message}");
    }
}

/// What is not a mistyped number gets no suggestion that does not fit.
#[test]
fn other_errors_get_no_such_suggestion() {
    for line in [
        "length = 10.0.0",
        "length = ",
        "length = abc",
        "length = [1, 2",
        "length = \"10",
        "= 10",
        "length 10",
        "length = 1__0",
    ] {
        let text = format!("[beam]\n{line}\nbending_stiffness = 1.3\n");
        let message = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).expect_err("not valid").to_string();
        assert!(!message.contains("help: "), "{line}: {message}");
    }
}

/// A survey whose rows or fields are out of place: the message says what to do.
#[test]
fn surveys_are_answered_with_what_to_do() {
    const SCENE: &str =
        "[beam]\nlength = 10\nbending_stiffness = 1\n[load]\nuniform = 1\n[foundation]\nsurvey = 'levels.csv'\n";
    for (rows, expected) in [
        ("0,1\n7,1\n3,1\n10,1", Some("sort the rows by x")),
        ("10,1\n5,1\n0,1", Some("the rows may also descend")),
        ("0,1\n5,1\n5,1\n5,1\n10,1", Some("keep one of the rows")),
        ("0,1\n12,1", Some("rows beyond it are left out")),
        ("0,1\n8,1", Some("add a row at each end of the beam")),
        ("0,1\n5,n/a\n10,1", Some("no_data = \"n/a\"")),
        ("0,1\n5,\n10,1", Some("no_data = \"\"")),
        ("0 m,1\n10 m,1", Some("write the number alone")),
        ("0,1\n5,a field that is far too long to be a mark\n10,1", None),
    ] {
        let text = format!("x,depth\n{rows}\n");
        let message = parse("scene.toml", SCENE, |_| Ok(text.clone())).expect_err("not valid").to_string();
        match expected {
            Some(expected) => assert!(message.contains("help: ") && message.contains(expected), "{rows}: {message}"),
            None => assert!(!message.contains("help: "), "{rows}: {message}"),
        }
        // Of a file that must not be shown, no field is repeated.
        let error = parse("scene.toml", SCENE, |_| Ok(text.clone())).expect_err("not valid").without_text();
        assert!(!error.to_string().contains("n/a"), "{error}");
    }
    // What the messages tell to declare is read.
    for (rows, more) in
        [("-2,1\n5,1\n12,1", ", origin = 0"), ("0,1\n5,n/a\n10,1", ", no_data = 'n/a'"), ("10,1\n0,1", "")]
    {
        let declared = format!("survey = {{ file = 'levels.csv', x = 'x', depth = 'depth'{more} }}");
        let scene = SCENE.replace("survey = 'levels.csv'", &declared);
        assert!(parse("scene.toml", &scene, |_| Ok(format!("x,depth\n{rows}\n"))).is_ok(), "{rows}");
    }
}
