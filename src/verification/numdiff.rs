//! Comparison of two texts that contain numbers.
//!
//! Words and integers must be the same; decimals may differ by one unit of the last printed place, which is what two
//! processors that round differently can make of the same computation. Blanks only separate, except before the first
//! word of a line, where they are structure (an indented list or code block).

use std::fmt;

use super::numeral::Numeral;

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

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rule {
    Text,
    Svg,
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

/// A word, a number or a single sign of a line.
#[derive(Debug, Clone, Copy)]
struct Token<'a> {
    text: &'a str,
    number: Option<Numeral>,
}

impl Token<'_> {
    /// What stands in for a token behind the end of a line.
    const END: Self = Self { text: "", number: None };
}

/// Cuts a line into tokens.
struct Tokens<'a> {
    line: &'a str,
    /// Where the rest begins.
    at: usize,
    rule: Rule,
    /// Between `<` and `>`; only kept up to date for SVG.
    inside_tag: bool,
}

impl<'a> Tokens<'a> {
    fn of(line: &'a str, inside_tag: bool, rule: Rule) -> Self {
        Self { line, at: 0, rule, inside_tag }
    }

    /// Length of the word or number at the start of `rest`; 0 if there is none.
    fn chunk(&self, rest: &str) -> usize {
        let glued = self.line[..self.at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let sign = match rest.chars().next() {
            Some(c @ ('-' | '+' | '−')) if !glued && rest[c.len_utf8()..].starts_with(|d: char| d.is_ascii_digit()) => {
                c.len_utf8()
            }
            _ => 0,
        };
        // A command letter of an SVG path is a token of its own: `M10,20L30,40`.
        let path_letter = |c: char| "MLHVCSQTAZmlhvcsqtaz".contains(c);
        let digit_or_sign = |c: char| c.is_ascii_digit() || c == '-' || c == '.';
        if self.inside_tag && !glued && rest.starts_with(path_letter) && rest[1..].starts_with(digit_or_sign) {
            return 1;
        }
        let mut end = sign;
        let mut previous = ' ';
        for c in rest[sign..].chars() {
            let exponent_sign = matches!(c, '-' | '+')
                && matches!(previous, 'e' | 'E')
                && Numeral::parse(&rest[..end - 1]).is_some()
                && rest[end + 1..].starts_with(|d: char| d.is_ascii_digit());
            let path_letter_behind_number = self.inside_tag && path_letter(c) && Numeral::parse(&rest[..end]).is_some();
            if path_letter_behind_number || !(c.is_alphanumeric() || c == '_' || c == '.' || exponent_sign) {
                break;
            }
            end += c.len_utf8();
            previous = c;
        }
        rest[..end].trim_end_matches('.').len()
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        self.at = self.line.len() - self.line[self.at..].trim_start().len();
        let rest = &self.line[self.at..];
        let first = rest.chars().next()?;
        // A colour such as #1f77b4 is a word.
        let length = match (first, self.chunk(rest)) {
            ('#', _) => 1 + self.chunk(&rest[1..]),
            (_, 0) => first.len_utf8(),
            (_, length) => length,
        };
        let mut text = &rest[..length];
        let mut number = Numeral::parse(text);
        if let (Some(mantissa), Some((power, exponent))) = (number, power_of_ten(&rest[length..])) {
            text = &rest[..length + power];
            number = Some(mantissa.times_ten_to(exponent));
        }
        if self.rule == Rule::Svg {
            self.inside_tag = match text {
                "<" => true,
                ">" => false,
                _ => self.inside_tag,
            };
        }
        self.at += text.len();
        Some(Token { text, number })
    }
}

/// Reads `·10⁻⁹`: its length in bytes and the exponent.
fn power_of_ten(rest: &str) -> Option<(usize, i32)> {
    const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = rest.strip_prefix("·10")?;
    let (sign, digits) = raised.strip_prefix('⁻').map_or((1, raised), |digits| (-1, digits));
    let end = digits.find(|c| !SUPERSCRIPTS.contains(&c)).unwrap_or(digits.len());
    if end == 0 {
        return None;
    }
    let value = digits[..end].chars().try_fold(0_i32, |value, c| {
        let digit = SUPERSCRIPTS.iter().position(|&s| s == c)?;
        value.checked_mul(10)?.checked_add(i32::try_from(digit).ok()?)
    })?;
    Some((rest.len() - digits.len() + end, sign * value))
}

#[cfg(test)]
mod tests;
