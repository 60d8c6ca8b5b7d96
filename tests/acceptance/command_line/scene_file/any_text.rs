//! No text at all makes the reader of scenes and surveys panic, and every message has its place.

use palkki::scene::file::parse;
use proptest::prelude::*;

use crate::scenes::EVERY_KEY;

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

/// A scene with a survey, whose name is not ASCII, besides every other key.
fn surveyed() -> String {
    EVERY_KEY.replacen("depth = 1.0", "survey = \"é.csv\"", 1)
}

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
        check_message(&surveyed(), &text);
        check_message(&surveyed(), &format!("x,depth\n{text}"));
    }

    #[test]
    fn mutated_scenes_never_panic(edits in edits()) {
        check_message(&mutated(&surveyed(), &edits), SURVEY);
    }

    #[test]
    fn mutated_surveys_never_panic(edits in edits()) {
        check_message(&surveyed(), &mutated(SURVEY, &edits));
    }

    #[test]
    fn any_two_numbers_make_a_beam_or_a_message(length in any::<f64>(), stiffness in any::<f64>(), depth in any::<f64>()) {
        check_message(&format!("[beam]\nlength = {length:e}\nbending_stiffness = {stiffness:e}\n[load]\nuniform = {depth:e}\n[foundation]\ndepth = {depth:e}\n").replace("NaN", "nan"), SURVEY);
    }
}
