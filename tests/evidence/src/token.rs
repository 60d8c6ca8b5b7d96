//! A line of a text as words, numbers and single signs.

use super::numeral::Numeral;

/// What kind of text it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rule {
    /// Prose, tables, CSV.
    Text,
    /// A drawing: tags and paths have signs of their own.
    Svg,
}

/// A word, a number or a single sign of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) text: &'a str,
    pub(super) number: Option<Numeral>,
}

impl Token<'_> {
    /// What stands in for a token behind the end of a line.
    pub(super) const END: Self = Self { text: "", number: None };
}

/// Cuts a line into tokens.
pub(super) struct Tokens<'a> {
    line: &'a str,
    /// Where the rest begins.
    at: usize,
    rule: Rule,
    /// Between `<` and `>`; only kept up to date for SVG.
    pub(super) inside_tag: bool,
}

impl<'a> Tokens<'a> {
    /// The tokens of a line that begins inside a tag or outside.
    pub(super) fn of(line: &'a str, inside_tag: bool, rule: Rule) -> Self {
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
