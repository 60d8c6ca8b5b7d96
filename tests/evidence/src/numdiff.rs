//! Comparison of two texts that contain numbers.
//!
//! Words and integers must be the same; decimals may differ by one unit of the last printed place, which is what two
//! processors that round differently can make of the same computation. Blanks only separate, except before the first
//! word of a line, where they are structure (an indented list or code block).

use std::fmt;

use super::token::{Rule, Token, Tokens};

/// The first place at which two texts differ.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {mismatch}\n  expected: {expected}\n  actual:   {actual}")]
pub struct Difference {
    /// Number of the line, from 1.
    pub line: usize,
    /// What differs there.
    pub mismatch: Mismatch,
    /// The whole line of the expected text; empty if it has ended.
    pub expected: String,
    /// The whole line of the actual text; empty if it has ended.
    pub actual: String,
}

/// What can differ between two lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Mismatch {
    /// Two words, signs or integers that are not the same, or a word in place of a number.
    Token {
        /// As expected; empty if the line has ended.
        expected: String,
        /// As found; empty if the line has ended.
        actual: String,
    },
    /// Two decimals further apart than one unit of the last printed place, or printed in different formats.
    Number {
        /// As expected.
        expected: String,
        /// As found.
        actual: String,
    },
    /// The blanks before the first word.
    Indentation,
    /// The actual text has fewer lines.
    MissingLine,
    /// The actual text has more lines.
    ExtraLine,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Token { expected, actual } => write!(f, "`{expected}` became `{actual}`"),
            Self::Number { expected, actual } => {
                write!(f, "{expected} became {actual}, more than one unit of the last printed place")
            }
            Self::Indentation => write!(f, "the indentation changed"),
            Self::MissingLine => write!(f, "the line is missing"),
            Self::ExtraLine => write!(f, "the line is new"),
        }
    }
}

/// Compares two texts; `Ok` if they say the same.
///
/// # Errors
///
/// The first [`Difference`].
pub fn numdiff(expected: &str, actual: &str) -> Result<(), Difference> {
    compare(expected, actual, Rule::Text)
}

/// Compares two SVG drawings; `Ok` if they show the same.
///
/// As [`numdiff`], but integers inside tags may differ by one as well: they are coordinates rounded to whole pixels,
/// and a value next to ½ may round either way. Text between tags, such as the value of a label, follows [`numdiff`].
///
/// # Errors
///
/// The first [`Difference`].
pub fn numdiff_svg(expected: &str, actual: &str) -> Result<(), Difference> {
    compare(expected, actual, Rule::Svg)
}

fn compare(expected: &str, actual: &str, rule: Rule) -> Result<(), Difference> {
    let (mut expected_lines, mut actual_lines) = (expected.lines(), actual.lines());
    // A tag may span lines, so whether we are inside one is carried along.
    let mut inside_tag = false;
    for line in 1.. {
        let (left, right) = (expected_lines.next(), actual_lines.next());
        let found = match (left, right) {
            (None, None) => return Ok(()),
            (Some(_), None) => Some(Mismatch::MissingLine),
            (None, Some(_)) => Some(Mismatch::ExtraLine),
            (Some(left), Some(right)) => compare_lines(left, right, rule, &mut inside_tag),
        };
        if let Some(mismatch) = found {
            let text = |line: Option<&str>| line.unwrap_or_default().to_owned();
            return Err(Difference { line, mismatch, expected: text(left), actual: text(right) });
        }
    }
    Ok(())
}

fn compare_lines(expected: &str, actual: &str, rule: Rule, inside_tag: &mut bool) -> Option<Mismatch> {
    let (mut left, mut right) = (Tokens::of(expected, *inside_tag, rule), Tokens::of(actual, *inside_tag, rule));
    let mut first = true;
    loop {
        let in_tag = left.inside_tag;
        let (a, b) = match (left.next(), right.next()) {
            (None, None) => break,
            (a, b) => (a.unwrap_or(Token::END), b.unwrap_or(Token::END)),
        };
        let pixels = rule == Rule::Svg && in_tag;
        match (a.number, b.number) {
            (Some(x), Some(y)) if pixels || !(x.is_integer() && y.is_integer()) => {
                let same = x.within_one_unit(&y);
                if !same {
                    return Some(Mismatch::Number { expected: a.text.to_owned(), actual: b.text.to_owned() });
                }
            }
            _ if a.text != b.text => {
                return Some(Mismatch::Token { expected: a.text.to_owned(), actual: b.text.to_owned() });
            }
            _ if first && indentation(expected) != indentation(actual) => return Some(Mismatch::Indentation),
            _ => {}
        }
        first = false;
    }
    *inside_tag = left.inside_tag;
    None
}

/// The blanks before the first word.
fn indentation(line: &str) -> &str {
    &line[..line.len() - line.trim_start().len()]
}

#[cfg(test)]
mod tests;
