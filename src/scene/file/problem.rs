//! What can be wrong with a scene file or a survey, besides what it describes.

use std::fmt;

use super::instead::instead;
use super::survey_problem::{MARKS, SurveyProblem};
use crate::body::BodyProblem;
use crate::scene::written::against;
use crate::scene::{Profile, SceneError};

/// Why a file could not be read as text: the error of the function that the caller passes for reading.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ReadProblem {
    /// There is no such file.
    #[error("there is no such file")]
    Missing,
    /// It is a directory.
    #[error("it is a directory, not a file")]
    Directory,
    /// It is a named pipe.
    #[error("it is a named pipe, which may wait forever; standard input is `-`")]
    NamedPipe,
    /// It is a device, a pipe or a socket, and the scene file names it.
    #[error("it is not a regular file; a scene can name only regular files")]
    NotRegular,
    /// The operating system refused.
    #[error("it cannot be read ({reason})")]
    Refused {
        /// In the words of the operating system.
        reason: String,
    },
    /// It is larger than any file of this kind should be.
    #[error("it is larger than {limit} bytes, the most that is read")]
    TooLarge {
        /// The limit.
        limit: u64,
    },
    /// A line that no file of this kind has.
    #[error("line {line} is longer than {limit} bytes, the most that is read")]
    LongLine {
        /// Which line, from 1.
        line: usize,
        /// The limit.
        limit: u64,
    },
    /// It is not text in UTF-8, perhaps not text at all.
    #[error("it is not a text file: the byte at line {line}, column {column} is not UTF-8")]
    NotText {
        /// Line of the first byte that is not UTF-8, from 1.
        line: usize,
        /// Its column, in characters, from 1.
        column: usize,
    },
}

/// What is wrong with a file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The scene file could not be read.
    #[error("cannot read the scene: {0}")]
    Unreadable(ReadProblem),
    /// The survey could not be read.
    #[error("cannot read the survey {:?}: {problem}", excerpt(path))]
    UnreadableSurvey {
        /// As the scene file has it.
        path: String,
        /// Why not.
        problem: ReadProblem,
    },
    /// A file of contact forces could not be read.
    #[error("cannot read the contact forces: {0}")]
    UnreadableForces(ReadProblem),
    /// A file without a single byte.
    #[error("the file is empty")]
    Empty,
    /// Not TOML.
    #[error("not valid TOML: {message}")]
    Syntax {
        /// In the words of the TOML parser, which also says what it expected.
        message: String,
    },
    /// A key or a table for the second time.
    #[error("the key `{}` is there twice", excerpt(key))]
    KeyTwice {
        /// The key.
        key: String,
    },
    /// A key that means nothing here.
    #[error("unknown key {:?} {}", excerpt(key), in_table(table))]
    UnknownKey {
        /// The key.
        key: String,
        /// Path of the table that it is in.
        table: String,
        /// What could be there.
        known: &'static [&'static str],
    },
    /// A key that has to be there.
    #[error("the key `{key}` is missing {}", in_table(table))]
    MissingKey {
        /// The key.
        key: String,
        /// Path of the table that it is missing in.
        table: String,
        /// What kind of value it takes.
        expected: &'static str,
    },
    /// A value of another type.
    #[error("`{path}` must be {expected}, but is {found}")]
    WrongType {
        /// Path of the value.
        path: String,
        /// What is there.
        found: String,
        /// What should be.
        expected: &'static str,
    },
    /// A number that no `f64` can hold.
    #[error("`{path}` is beyond the range of 64-bit floating point")]
    BeyondRange {
        /// Path of the number.
        path: String,
    },
    /// A table of a profile without one.
    #[error("{} has none of the keys {}", table_of(*of), list(known))]
    NoProfileKind {
        /// Which profile.
        of: Profile,
        /// What could be there.
        known: &'static [&'static str],
    },
    /// A table of a profile with more than one.
    #[error("{} has {} keys that each give {of}: {}", table_of(*of), found.len(), list(found))]
    SeveralProfileKinds {
        /// Which profile.
        of: Profile,
        /// What is there.
        found: Vec<&'static str>,
    },
    /// The slope of a support that holds none.
    #[error(
        "`{path}` must not be there: a support holds a slope only with `built_in = true` or with `turning_stiffness`"
    )]
    SlopeWithoutBuiltIn {
        /// Path of the slope.
        path: String,
    },
    /// A support in which the beam is built in and that only pushes.
    #[error(
        "`{path}` must not be there: a support that only pushes lets the beam turn and lift off, and holds no slope"
    )]
    PushesBuiltIn {
        /// Path of the key that asks for more.
        path: String,
    },
    /// A support in which the beam is built in and that gives.
    #[error(
        "`{path}` must not be there: a support with `built_in = true` holds level and slope, and gives nothing; one that is held by \
         springs has `stiffness`, `turning_stiffness` or both, without `built_in`"
    )]
    GivesBuiltIn {
        /// Path of the stiffness.
        path: String,
    },
    /// The numbers of the file make no scene. In a survey, `quantity` says how the survey calls the number.
    #[error("{}", in_words_of_the_file(error, *quantity))]
    Scene {
        /// Why not.
        error: SceneError,
        /// `x` or `depth` in a survey.
        quantity: Option<&'static str>,
    },
    /// A body is none.
    #[error(transparent)]
    Body(#[from] BodyProblem),
    /// A survey is none.
    #[error(transparent)]
    Survey(#[from] SurveyProblem),
    /// Contact forces without their header.
    #[error("contact forces must begin with the header `x,force`, but begin with {found}")]
    ForcesHeader {
        /// What is there.
        found: Found,
    },
    /// A file of contact forces without anything in it.
    #[error("the file of contact forces has neither header nor forces")]
    ForcesWithoutHeader,
    /// A row that is not a force.
    #[error("a row of contact forces must have 2 fields, x and force, but this one has {found}")]
    ForcesFields {
        /// How many it has.
        found: usize,
    },
    /// A force that does not act on the beam.
    #[error("`x` must lie on the beam, between 0 and {}, but is {}", against(*length, *x), against(*x, *length))]
    ForceOutsideBeam {
        /// Where it acts.
        x: f64,
        /// Length of the beam.
        length: f64,
    },
    /// A field of a survey, or of contact forces, that is not a number.
    #[error("`{quantity}` must be a finite number, but is {found}")]
    SurveyNumber {
        /// `x`, `depth` or `force`.
        quantity: &'static str,
        /// What is there.
        found: Found,
    },
    /// A decimal point in a file that has decimal commas, or the other way round.
    #[error("`{quantity}` is {found}, but other numbers of this file have a decimal {}", if *mark == ',' { "comma" } else { "point" })]
    BothDecimalMarks {
        /// The mark of the others, a comma or a point.
        mark: char,
        /// `x`, `depth` or `force`.
        quantity: &'static str,
        /// What is there.
        found: Found,
    },
    /// A character that would make a figure unreadable, or its text another one than is written.
    #[error("`{path}` must not have the character U+{:04X}, its character {place}: {}", u32::from(*character), why_forbidden(*character))]
    ForbiddenCharacter {
        /// Path of the text.
        path: String,
        /// Which character.
        character: char,
        /// Which of the characters of the text it is, from 1.
        place: usize,
    },
}

/// Characters of the text of a figure that are refused: noncharacters are not allowed in XML 1.0, and controls of the direction
/// of writing make a text look as if it were another.
pub(super) fn is_forbidden(character: char) -> bool {
    matches!(character, '\u{fffe}' | '\u{ffff}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn why_forbidden(character: char) -> &'static str {
    match character {
        '\u{fffe}' | '\u{ffff}' => "it is no character of XML, in which figures are written",
        _ => "it turns the direction of writing, so that the text looks like another one",
    }
}

impl Problem {
    /// The same problem; the message repeats no text of the file.
    pub(super) fn without_text(mut self) -> Self {
        match &mut self {
            Self::ForcesHeader { found } | Self::SurveyNumber { found, .. } | Self::BothDecimalMarks { found, .. } => {
                *found = Found::NotShown
            }
            Self::Body(problem) => problem.hide_text(),
            Self::Survey(problem) => problem.hide_text(),
            _ => {}
        }
        self
    }

    /// What to do instead, of mistakes that are made often.
    #[must_use]
    pub fn help(&self) -> Option<String> {
        match self {
            Self::UnknownKey { key, table, known } => instead(key, table, known).map(str::to_owned),
            Self::Survey(problem) => problem.help(),
            _ => None,
        }
    }

    /// What is expected at the place that the message points at, where the message does not say it yet.
    #[must_use]
    pub(crate) fn expected(&self) -> Option<String> {
        match self {
            Self::UnknownKey { known: [only], .. } => Some(format!("expected `{only}`")),
            Self::UnknownKey { known, .. } => Some(format!("expected one of {}", list(known))),
            Self::MissingKey { key, expected: "a table", .. } => Some(format!("expected a table `[{key}]`")),
            Self::MissingKey { key, expected, .. } => Some(format!("expected `{key} = …`, {expected}")),
            Self::BeyondRange { .. } => Some(format!("expected a magnitude of at most {:e}", f64::MAX)),
            Self::BothDecimalMarks { .. } => {
                Some("expected one decimal mark in all numbers, and nothing between thousands".to_owned())
            }
            Self::ForcesFields { found: 3.. } => Some(MARKS.to_owned()),
            Self::Survey(problem) => problem.expected(),
            Self::KeyTwice { .. } => Some("expected only once".to_owned()),
            Self::NoProfileKind { of, .. } => {
                Some(format!("expected exactly one of them, or no {} at all", table_of(*of)))
            }
            Self::SeveralProfileKinds { .. } => Some("expected exactly one of them".to_owned()),
            Self::SlopeWithoutBuiltIn { .. } => {
                Some("expected `built_in = true` or `turning_stiffness` beside it, or no slope".to_owned())
            }
            Self::GivesBuiltIn { .. } => Some("expected it without `built_in = true`, or neither".to_owned()),
            Self::PushesBuiltIn { .. } => Some("expected `pushes_only = true` without it, or neither".to_owned()),
            Self::Empty => Some("expected a scene in TOML, with at least a table [beam]".to_owned()),
            Self::ForcesHeader { .. } | Self::ForcesWithoutHeader => {
                Some("expected `x,force`, then one force in each row".to_owned())
            }
            _ => None,
        }
    }
}

fn in_table(path: &str) -> String {
    if path.is_empty() { "in the scene".to_owned() } else { format!("in `{path}`") }
}

/// The table of a profile, as a message calls it.
fn table_of(profile: Profile) -> &'static str {
    match profile {
        Profile::Foundation => "[foundation]",
        Profile::Shape => "`beam.shape`",
    }
}

pub(super) fn list(keys: &[&str]) -> String {
    let keys: Vec<_> = keys.iter().map(|key| format!("`{key}`")).collect();
    keys.join(", ")
}

/// The message of a [`SceneError`], with the name that a number has in a survey where it comes from one.
fn in_words_of_the_file(error: &SceneError, quantity: Option<&'static str>) -> String {
    let message = error.to_string();
    match (error.quantity(), quantity) {
        (Some(from), Some(to)) => message.replacen(&from.to_string(), to, 1),
        _ => message,
    }
}

/// What a file has in the place of what is expected, as a message repeats it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// The beginning of the text.
    Text(String),
    /// Text of a file whose text no message repeats.
    NotShown,
}

impl Found {
    /// The beginning of `text`.
    pub(crate) fn of(text: &str) -> Self {
        Self::Text(excerpt(text))
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => write!(f, "{text:?}"),
            Self::NotShown => f.write_str("text that is not shown"),
        }
    }
}

/// A field, or a key, as a message repeats it.
pub(super) fn excerpt(text: &str) -> String {
    /// Characters, so that a message stays on a line of a terminal or two.
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
