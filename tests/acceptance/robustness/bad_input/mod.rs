//! Everything that can be wrong with a scene file or a survey: one valid scene, one thing wrong in each test, and the
//! message as a person reads it.

mod file;
mod scene;
mod supports;
mod survey;

use palkki::scene::file::{ReadProblem, parse};

use crate::scenes::EVERY_KEY;

const SURVEY: &str = "x,depth\n0,1\n5,0.5\n10,1\n";

/// The message for a valid scene with `from` replaced by `to`.
#[track_caller]
fn message(from: &str, to: &str) -> String {
    assert!(EVERY_KEY.contains(from), "the valid scene does not contain {from:?}");
    message_of(&EVERY_KEY.replacen(from, to, 1))
}

#[track_caller]
fn message_of(text: &str) -> String {
    let error = parse("scene.toml", text, |_| Ok(SURVEY.to_owned())).expect_err("this scene is not valid");
    error.to_string()
}

/// The message for a scene with the survey `text`.
#[track_caller]
fn survey(text: &str) -> String {
    let scene = EVERY_KEY.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    let error = parse("site/scene.toml", &scene, |_| Ok(text.to_owned())).expect_err("this survey is not valid");
    error.to_string()
}

/// The message for a scene whose survey is not there to read.
#[track_caller]
fn unreadable(problem: ReadProblem) -> String {
    let scene = EVERY_KEY.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    let error = parse("site/scene.toml", &scene, |_| Err(problem.clone())).expect_err("there is no survey");
    error.to_string()
}

#[test]
fn the_valid_scene_is_valid() {
    assert!(
        parse("scene.toml", EVERY_KEY, |_| Ok(SURVEY.to_owned())).is_ok(),
        "each test below changes one thing in it"
    );
    let scene = EVERY_KEY.replacen("depth = 1.0", "survey = 'levels.csv'", 1);
    assert!(parse("scene.toml", &scene, |_| Ok(SURVEY.to_owned())).is_ok(), "and so with a survey");
}
