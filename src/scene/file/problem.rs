//! Errors in a scene file or a survey, apart from errors in the numbers of the scene.

use std::fmt;

use super::instead::instead;
use super::remedy;
use super::survey_problem::{MARKS, SurveyProblem};
use crate::body::BodyProblem;
use crate::scene::written::against;
use crate::scene::{Profile, SceneError};

/// The reason why a file could not be read as text. The function that the caller passes for reading returns it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ReadProblem {
    /// The file does not exist.
    #[error("there is no such file")]
    Missing,
    /// The path is a directory.
    #[error("it is a directory, not a file")]
    Directory,
    /// The path is a named pipe.
    #[error("it is a named pipe, which may wait forever; standard input is `-`")]
    NamedPipe,
    /// The scene file names a device, a pipe or a socket.
    #[error("it is not a regular file; a scene can name only regular files")]
    NotRegular,
    /// The operating system returned an error.
    #[error("it cannot be read ({reason})")]
    Refused {
        /// The message of the operating system.
        reason: String,
    },
    /// The file exceeds the limit for files of this kind.
    #[error("it is larger than {limit} bytes, the most that is read")]
    TooLarge {
        /// The limit in bytes.
        limit: u64,
    },
    /// A line exceeds the limit for files of this kind.
    #[error("line {line} is longer than {limit} bytes, the most that is read")]
    LongLine {
        /// The line, from 1.
        line: usize,
        /// The limit in bytes.
        limit: u64,
    },
    /// The file is not UTF-8 text.
    #[error("it is not a text file: the byte at line {line}, column {column} is not UTF-8")]
    NotText {
        /// Line of the first byte that is not UTF-8, from 1.
        line: usize,
        /// Column of this byte, in characters, from 1.
        column: usize,
    },
}

/// An error in a file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The scene file could not be read.
    #[error("cannot read the scene: {0}")]
    Unreadable(ReadProblem),
    /// The survey could not be read.
    #[error("cannot read the survey {:?}: {problem}", excerpt(path))]
    UnreadableSurvey {
        /// The path as written in the scene file.
        path: String,
        /// The reason.
        problem: ReadProblem,
    },
    /// A file of contact forces could not be read.
    #[error("cannot read the contact forces: {0}")]
    UnreadableForces(ReadProblem),
    /// The file is empty.
    #[error("the file is empty")]
    Empty,
    /// The text is not TOML.
    #[error("not valid TOML: {message}")]
    Syntax {
        /// The message of the TOML parser, which also says what it expected.
        message: String,
    },
    /// A duplicate key or table.
    #[error("the key `{}` is there twice", excerpt(key))]
    KeyTwice {
        /// The key.
        key: String,
    },
    /// A key that is not allowed in this table.
    #[error("unknown key {:?} {}", excerpt(key), in_table(table))]
    UnknownKey {
        /// The key.
        key: String,
        /// Path of the table that contains it.
        table: String,
        /// The keys that are allowed.
        known: &'static [&'static str],
    },
    /// A required key is missing.
    #[error("the key `{key}` is missing {}", in_table(table))]
    MissingKey {
        /// The key.
        key: String,
        /// Path of the table in which it is missing.
        table: String,
        /// The kind of value that the key needs.
        expected: &'static str,
    },
    /// A value of the wrong type.
    #[error("`{path}` must be {expected}, but is {found}")]
    WrongType {
        /// Path of the value.
        path: String,
        /// The value in the file.
        found: String,
        /// The required value.
        expected: &'static str,
    },
    /// A number outside the range of `f64`.
    #[error("`{path}` is beyond the range of 64-bit floating point")]
    BeyondRange {
        /// Path of the number.
        path: String,
    },
    /// The table of a profile has no key that gives the profile.
    #[error("{} has none of the keys {}", table_of(*of), list(known))]
    NoProfileKind {
        /// The profile.
        of: Profile,
        /// The keys that give a profile.
        known: &'static [&'static str],
    },
    /// The table of a profile has more than one key that gives the profile.
    #[error("{} has {} keys that each give {of}: {}", table_of(*of), found.len(), list(found))]
    SeveralProfileKinds {
        /// The profile.
        of: Profile,
        /// The keys in the file.
        found: Vec<&'static str>,
    },
    /// A slope of a support that does not restrain rotation.
    #[error(
        "`{path}` must not be there: a support holds a slope only with `built_in = true` or with `turning_stiffness`"
    )]
    SlopeWithoutBuiltIn {
        /// Path of the slope.
        path: String,
    },
    /// A compression-only support with a key that restrains rotation.
    #[error(
        "`{path}` must not be there: a support that only pushes lets the beam turn and lift off, and holds no slope"
    )]
    PushesBuiltIn {
        /// Path of that key.
        path: String,
    },
    /// A built-in support that is also elastic.
    #[error(
        "`{path}` must not be there: a support with `built_in = true` holds level and slope, and gives nothing; one that is held by \
         springs has `stiffness`, `turning_stiffness` or both, without `built_in`"
    )]
    GivesBuiltIn {
        /// Path of the stiffness.
        path: String,
    },
    /// The numbers of the file are not a valid scene. In a survey, `quantity` is the name of the number.
    #[error("{}", in_words_of_the_file(error, *quantity))]
    Scene {
        /// The error of the scene.
        error: SceneError,
        /// `x` or `depth` in a survey.
        quantity: Option<&'static str>,
    },
    /// An error in a body.
    #[error(transparent)]
    Body(#[from] BodyProblem),
    /// An error in a survey.
    #[error(transparent)]
    Survey(#[from] SurveyProblem),
    /// Contact forces without the required header.
    #[error("contact forces must begin with the header `x,force`, but begin with {found}")]
    ForcesHeader {
        /// The first row of the file.
        found: Found,
    },
    /// A file of contact forces without any row.
    #[error("the file of contact forces has neither header nor forces")]
    ForcesWithoutHeader,
    /// A row that does not have the two fields of a force.
    #[error("a row of contact forces must have 2 fields, x and force, but this one has {found}")]
    ForcesFields {
        /// The number of fields.
        found: usize,
    },
    /// A force outside the beam.
    #[error("`x` must lie on the beam, between 0 and {}, but is {}", against(*length, *x), against(*x, *length))]
    ForceOutsideBeam {
        /// Its position.
        x: f64,
        /// Length of the beam.
        length: f64,
    },
    /// A field of a survey or of contact forces that is not a finite number.
    #[error("`{quantity}` must be a finite number, but is {found}")]
    SurveyNumber {
        /// `x`, `depth` or `force`.
        quantity: &'static str,
        /// The text of the field.
        found: Found,
    },
    /// A decimal point in a file with decimal commas, or vice versa.
    #[error("`{quantity}` is {found}, but other numbers of this file have a decimal {}", if *mark == ',' { "comma" } else { "point" })]
    BothDecimalMarks {
        /// The decimal mark of the other numbers, a comma or a point.
        mark: char,
        /// `x`, `depth` or `force`.
        quantity: &'static str,
        /// The text of the field.
        found: Found,
    },
    /// A character that would make a figure invalid, or would make its text look different from the text written.
    #[error("`{path}` must not have the character U+{:04X}, its character {place}: {}", u32::from(*character), why_forbidden(*character))]
    ForbiddenCharacter {
        /// Path of the text.
        path: String,
        /// The character.
        character: char,
        /// Its position in the text, in characters, from 1.
        place: usize,
    },
}

/// Characters that are not allowed in the text of a figure. Noncharacters are not allowed in XML 1.0, and bidirectional controls
/// can make a text look like another one.
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
    /// The same problem with a message that contains no text of the file.
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

    /// The remedy for frequent mistakes.
    #[must_use]
    pub fn help(&self) -> Option<String> {
        match self {
            Self::UnknownKey { key, table, known } => {
                let lower = known.iter().find(|known| known.eq_ignore_ascii_case(key));
                let help = instead(key, table, known).map(str::to_owned);
                help.or_else(|| lower.map(|lower| format!("write it in lower case: `{lower}`")))
            }
            Self::WrongType { found, expected, .. } => remedy::of_type(found, expected),
            Self::Scene { error, quantity } => remedy::of_number(error, quantity.is_some()).map(str::to_owned),
            Self::SurveyNumber { quantity, found } => {
                remedy::of_field(found, ["depth", "elevation"].contains(quantity))
            }
            Self::Survey(problem) => problem.help(),
            _ => None,
        }
    }

    /// The value expected at the marked location, if the message does not name it yet.
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

/// The name of the table of a profile in messages.
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

/// The message of a [`SceneError`]. A number from a survey is called by its name in the survey.
fn in_words_of_the_file(error: &SceneError, quantity: Option<&'static str>) -> String {
    let message = error.to_string();
    match (error.quantity(), quantity) {
        (Some(from), Some(to)) => message.replacen(&from.to_string(), to, 1),
        _ => message,
    }
}

/// The text found in a file in place of the expected text, as a message prints it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// The beginning of the text.
    Text(String),
    /// Text of a file whose contents must not be printed.
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

/// A field or a key, shortened for messages.
pub(super) fn excerpt(text: &str) -> String {
    /// Greatest number of characters, so that a message fits on one or two lines of a terminal.
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
