//! Access to the keys of one table of a scene file: only known keys, with type checks, paths and locations.

use std::num::IntErrorKind;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::Problem;
use super::problem::excerpt;
use super::problem::is_forbidden;

/// A range of bytes in the file.
pub(super) type Span = std::ops::Range<usize>;

/// A problem with its location.
#[derive(Debug)]
pub(super) struct Error {
    pub(super) span: Span,
    pub(super) problem: Problem,
}

/// A table that contains only known keys.
#[derive(Debug)]
pub(super) struct Keys<'a> {
    /// Path of the table, for example `load.point[2]`; empty for the whole file.
    path: String,
    span: Span,
    table: &'a DeTable<'a>,
}

/// A value of a scene file with its path.
#[derive(Debug)]
pub(super) struct Value<'a> {
    pub(super) path: String,
    pub(super) value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Keys<'a> {
    /// The top-level table of the file.
    pub(super) fn of_file(table: &'a DeTable<'a>, known: &'static [&'static str]) -> Result<Self, Error> {
        Self { path: String::new(), span: 0..0, table }.checked(known)
    }

    fn checked(self, known: &'static [&'static str]) -> Result<Self, Error> {
        // The table is sorted by name, but the error must name the first unknown key in the file.
        match self.table.keys().filter(|key| !known.contains(&&**key.get_ref())).min_by_key(|key| key.span().start) {
            None => Ok(self),
            Some(key) => Err(Error {
                span: key.span(),
                problem: Problem::UnknownKey { key: key.get_ref().to_string(), table: self.path, known },
            }),
        }
    }

    /// The location of the table; its header for `[name]`.
    pub(super) fn span(&self) -> Span {
        self.span.clone()
    }

    /// The value of `key`, if it exists.
    pub(super) fn get(&self, key: &str) -> Option<Value<'a>> {
        let value = self.table.get(key)?;
        let path = if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) };
        Some(Value { path, value })
    }

    pub(super) fn required<T>(&self, key: &str, expected: &'static str, value: Option<T>) -> Result<T, Error> {
        value.ok_or_else(|| Error {
            span: self.span(),
            problem: Problem::MissingKey { key: key.to_owned(), table: self.path.clone(), expected },
        })
    }

    pub(super) fn number(&self, key: &str) -> Result<Option<f64>, Error> {
        self.get(key).map(|value| value.number()).transpose()
    }

    /// The Boolean value of `key`, if it exists.
    pub(super) fn truth(&self, key: &str) -> Result<Option<bool>, Error> {
        let truth = |value: Value<'_>| match value.value.get_ref() {
            DeValue::Boolean(truth) => Ok(*truth),
            _ => Err(value.wrong_type("true or false")),
        };
        self.get(key).map(truth).transpose()
    }

    /// The value of a required key.
    pub(super) fn required_value(&self, key: &str, expected: &'static str) -> Result<Value<'a>, Error> {
        self.required(key, expected, self.get(key))
    }

    pub(super) fn required_number(&self, key: &str) -> Result<f64, Error> {
        self.required(key, "a number", self.number(key)?)
    }

    pub(super) fn table(&self, key: &str, known: &'static [&'static str]) -> Result<Option<Keys<'a>>, Error> {
        self.get(key).map(|value| value.table(known)).transpose()
    }

    pub(super) fn required_table(&self, key: &str, known: &'static [&'static str]) -> Result<Keys<'a>, Error> {
        self.required(key, "a table", self.table(key, known)?)
    }

    /// The elements of an array; empty if the key is missing.
    pub(super) fn elements(&self, key: &str) -> Result<Vec<Value<'a>>, Error> {
        self.get(key).map_or(Ok(Vec::new()), |value| value.elements("an array of tables [{ at = …, … }]"))
    }

    pub(super) fn line_of_text(&self, key: &str) -> Result<Option<String>, Error> {
        self.get(key).map(|value| value.line_of_text()).transpose()
    }
}

impl<'a> Value<'a> {
    pub(super) fn span(&self) -> Span {
        self.value.span()
    }

    /// A number, written as an integer or with a decimal point. `nan` and `inf` are accepted here and rejected by the scene.
    pub(super) fn number(&self) -> Result<f64, Error> {
        self.number_or("a number")
    }

    /// A number where other types are also allowed; `expected` names them in the error.
    pub(super) fn number_or(&self, expected: &'static str) -> Result<f64, Error> {
        let not_a_number = || self.wrong_type(expected);
        let number = match self.value.get_ref() {
            DeValue::Float(float) => {
                let number: f64 = float.as_str().parse().map_err(|_| not_a_number())?;
                let finite = number.is_finite() || !float.as_str().contains(|c: char| c.is_ascii_digit());
                Some(number).filter(|_| finite)
            }
            // Rounded to the nearest f64, like a number with a decimal point.
            DeValue::Integer(integer) if integer.radix() == 10 => {
                let number: f64 = integer.as_str().parse().map_err(|_| not_a_number())?;
                Some(number).filter(|number| number.is_finite())
            }
            DeValue::Integer(integer) => match i128::from_str_radix(integer.as_str(), integer.radix()) {
                #[expect(
                    clippy::cast_precision_loss,
                    reason = "rounded to the nearest f64, as a decimal point would be"
                )]
                Ok(number) => Some(number as f64),
                Err(error) if matches!(error.kind(), IntErrorKind::PosOverflow | IntErrorKind::NegOverflow) => None,
                // `0x` without digits.
                Err(_) => return Err(not_a_number()),
            },
            _ => return Err(not_a_number()),
        };
        number.ok_or_else(|| Error { span: self.span(), problem: Problem::BeyondRange { path: self.path.clone() } })
    }

    /// A finite number.
    pub(super) fn finite(&self) -> Result<f64, Error> {
        self.number()
            .and_then(|number| if number.is_finite() { Ok(number) } else { Err(self.wrong_type("a finite number")) })
    }

    /// A non-negative integer, if the value is one.
    pub(super) fn whole(&self) -> Option<usize> {
        match self.value.get_ref() {
            DeValue::Integer(integer) => usize::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        }
    }

    pub(super) fn is_table(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Table(_))
    }

    pub(super) fn table(&self, known: &'static [&'static str]) -> Result<Keys<'a>, Error> {
        match self.value.get_ref() {
            DeValue::Table(table) => Keys { path: self.path.clone(), span: self.span(), table }.checked(known),
            _ => Err(self.wrong_type("a table")),
        }
    }

    pub(super) fn elements(&self, expected: &'static str) -> Result<Vec<Value<'a>>, Error> {
        let DeValue::Array(array) = self.value.get_ref() else {
            return Err(self.wrong_type(expected));
        };
        Ok(array.iter().enumerate().map(|(i, value)| Value { path: format!("{}[{i}]", self.path), value }).collect())
    }

    /// Text without line breaks or other control characters, because it is printed in tables and figures.
    pub(super) fn line_of_text(&self) -> Result<String, Error> {
        match self.value.get_ref() {
            DeValue::String(text) if !text.contains(|c: char| c.is_control()) => {
                let forbidden = (1..).zip(text.chars()).find(|&(_, character)| is_forbidden(character));
                let Some((place, character)) = forbidden else { return Ok(text.to_string()) };
                let problem = Problem::ForbiddenCharacter { path: self.path.clone(), character, place };
                Err(Error { span: self.span(), problem })
            }
            _ => Err(self.wrong_type("one line of text")),
        }
    }

    pub(super) fn wrong_type(&self, expected: &'static str) -> Error {
        let found = match self.value.get_ref() {
            DeValue::String(text) if text.chars().nth(LONGEST_QUOTE).is_some() => "a long text".to_owned(),
            DeValue::String(text) => format!("the text {:?}", &**text),
            DeValue::Integer(number) => format!("the integer {}", excerpt(&number.to_string())),
            DeValue::Float(number) => format!("the number {}", excerpt(&number.to_string())),
            DeValue::Boolean(value) => value.to_string(),
            DeValue::Datetime(_) => "a date or time".to_owned(),
            DeValue::Array(array) => format!("an array of length {}", array.len()),
            DeValue::Table(_) => "a table".to_owned(),
        };
        Error { span: self.span(), problem: Problem::WrongType { path: self.path.clone(), found, expected } }
    }
}

/// Greatest number of characters of a text that a message repeats; a longer text is visible in the excerpt below the message.
const LONGEST_QUOTE: usize = 60;
