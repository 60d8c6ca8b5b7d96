//! Comparison of two texts that contain numbers.
//!
//! Words and integers must be the same. Decimals may differ by one unit of the last printed place, which is what two
//! processors that round differently can make of the same computation. Blanks only separate words, except before the first
//! word of a line, where they are structure (an indented list or code block).

/// The first place at which two texts differ.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: `{was}` became `{is}`\n  expected: {expected}\n  actual:   {actual}")]
pub struct Difference {
    /// Number of the line, from 1.
    pub line: usize,
    /// The word or number that was expected; empty if the line or the text has ended.
    pub was: String,
    /// What is there instead; empty if the line or the text has ended.
    pub is: String,
    /// The whole line of the expected text; empty if it has ended.
    pub expected: String,
    /// The whole line of the actual text; empty if it has ended.
    pub actual: String,
}

/// Compares two texts; `Ok` if they say the same.
///
/// # Errors
///
/// The first [`Difference`].
pub fn numdiff(expected: &str, actual: &str) -> Result<(), Difference> {
    compare(expected, actual, false)
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
    compare(&with_spaced_paths(expected), &with_spaced_paths(actual), true)
}

/// A drawing with blanks around the commands of its paths: `M10,20L30,40` would be two words.
fn with_spaced_paths(svg: &str) -> String {
    const COMMANDS: &str = "MLHVCSQTAZmlhvcsqtaz";
    let mut spaced = String::with_capacity(svg.len());
    for (i, part) in svg.split(" d=\"").enumerate() {
        let (path, rest) = if i == 0 { ("", part) } else { part.split_once('"').unwrap_or((part, "")) };
        for c in path.chars() {
            if COMMANDS.contains(c) { spaced.extend([' ', c, ' ']) } else { spaced.push(c) }
        }
        spaced.push_str(rest);
    }
    spaced
}

fn compare(expected: &str, actual: &str, svg: bool) -> Result<(), Difference> {
    let (mut expected, mut actual) = (expected.lines(), actual.lines());
    // A tag may span lines, so whether a line begins inside one is carried along, for each text.
    let mut in_tag = [false; 2];
    for line in 1.. {
        let (a, b) = (expected.next(), actual.next());
        let [was, is] = match (a, b) {
            (None, None) => break,
            (Some(a), Some(b)) => {
                let [a, b] = [tokens(a, svg, &mut in_tag[0]), tokens(b, svg, &mut in_tag[1])];
                let differs = |i: &usize| !token(&a, *i).is_like(token(&b, *i));
                let Some(i) = (0..a.len().max(b.len())).find(differs) else { continue };
                [token(&a, i).text, token(&b, i).text].map(str::to_owned)
            }
            (a, b) => [a, b].map(|line| line.unwrap_or_default().to_owned()),
        };
        let [expected, actual] = [a, b].map(|line| line.unwrap_or_default().to_owned());
        return Err(Difference { line, was, is, expected, actual });
    }
    Ok(())
}

/// A word, a number, a single sign, or the blanks that a line begins with.
#[derive(Debug, Clone, Copy, Default)]
struct Token<'a> {
    text: &'a str,
    /// Inside a tag of a drawing.
    in_tag: bool,
}

impl Token<'_> {
    fn is_like(self, other: Self) -> bool {
        self.text == other.text
            || Number::of(self.text)
                .zip(Number::of(other.text))
                .is_some_and(|(a, b)| (self.in_tag || !(a.integer && b.integer)) && a.is_like(&b))
    }
}

/// The token of some number, or nothing behind the last.
fn token<'a>(tokens: &[Token<'a>], i: usize) -> Token<'a> {
    tokens.get(i).copied().unwrap_or_default()
}

/// Cuts a line into tokens.
fn tokens<'a>(line: &'a str, svg: bool, in_tag: &mut bool) -> Vec<Token<'a>> {
    let mut found = Vec::new();
    let mut at = line.len() - line.trim_start().len();
    while let Some(first) = line[at..].chars().next() {
        // A sign behind a word is a hyphen.
        let number = number_length(&line[at..], !line[..at].ends_with(is_of_word));
        if found.is_empty() && number == 0 {
            found.push(Token { text: &line[..at], in_tag: false });
        }
        let length = if 0 < number { number } else { word_length(&line[at..]).max(first.len_utf8()) };
        found.push(Token { text: &line[at..at + length], in_tag: svg && *in_tag });
        *in_tag = if matches!(first, '<' | '>') { first == '<' } else { *in_tag };
        at += length;
        at += line[at..].len() - line[at..].trim_start().len();
    }
    found
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Length of the word that a text begins with, a version or a colour such as `#1f77b4` included; 0 if there is none.
fn word_length(text: &str) -> usize {
    let behind = usize::from(text.starts_with('#'));
    let end = text[behind..].find(|c| !(is_of_word(c) || c == '.')).map_or(text.len(), |end| behind + end);
    text[..end].trim_end_matches('.').len()
}

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Length of the number that a text begins with, `[+-]digits[.digits][e[+-]digits]` or with `·10⁻⁹` in place of `e-9`; 0 if
/// there is none, or a word goes on behind it.
fn number_length(text: &str, signed: bool) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let skip = |from: usize, signs: &[char]| {
        from + text[from..].chars().next().filter(|c| signs.contains(c)).map_or(0, char::len_utf8)
    };
    let mut end = if signed { skip(0, &['-', '+', '−']) } else { 0 };
    if digits(end) == 0 {
        return 0;
    }
    end += digits(end);
    if text[end..].starts_with('.') && 0 < digits(end + 1) {
        end += 1 + digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) && 0 < digits(skip(end + 1, &['-', '+'])) {
        end = skip(end + 1, &['-', '+']);
        end += digits(end);
    } else if text[end..].starts_with("·10") {
        let from = skip(end + "·10".len(), &['⁻']);
        let raised: usize = text[from..].chars().take_while(|c| SUPERSCRIPTS.contains(c)).map(char::len_utf8).sum();
        end = if 0 < raised { from + raised } else { end };
    }
    if 0 < word_length(&text[end..]) && !text[end..].starts_with('#') { 0 } else { end }
}

/// A printed number.
struct Number {
    value: f64,
    /// One unit of the last printed place.
    unit: f64,
    /// Digits behind the point.
    places: usize,
    /// Digits from the first that is not zero.
    digits: usize,
    /// Printed without a point and without an exponent.
    integer: bool,
}

impl Number {
    /// Digits that the difference of two numbers of 64 bits has to spare.
    const MOST_DIGITS: usize = 15;

    /// Reads a number; numbers of more digits than can be compared are words.
    fn of(text: &str) -> Option<Self> {
        if text.is_empty() || number_length(text, true) < text.len() {
            return None;
        }
        let plain = text.replace("·10", "e").replace(['−', '⁻'], "-");
        let plain: String =
            (0..10_u8).fold(plain, |text, digit| text.replace(SUPERSCRIPTS[usize::from(digit)], &digit.to_string()));
        let (mantissa, exponent) = plain.split_once(['e', 'E']).unwrap_or((&plain, "0"));
        let places = mantissa.split_once('.').map_or(0, |(_, behind)| behind.len());
        let digits =
            mantissa.trim_start_matches(|c| !matches!(c, '1'..='9')).bytes().filter(u8::is_ascii_digit).count();
        let last = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(places).ok()?)?;
        (digits <= Self::MOST_DIGITS).then_some(Self {
            value: plain.parse().ok()?,
            unit: format!("1e{last}").parse().ok()?,
            places,
            digits,
            integer: places == 0 && mantissa == plain,
        })
    }

    /// True if both are printed alike and differ by at most one unit of the last place, the coarser one of the two. As many
    /// places or as many digits: `9.9996` may become `10.000`, but a number that lost a digit is not the same print.
    fn is_like(&self, other: &Self) -> bool {
        /// One unit and the rounding of numbers of 64 bits; two units are too many.
        const UNITS: f64 = 1.5;
        let alike = self.integer == other.integer && (self.places == other.places || self.digits == other.digits);
        alike && (self.value - other.value).abs() <= UNITS * self.unit.max(other.unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn same(a: &str, b: &str) {
        assert_eq!(numdiff(a, b), Ok(()), "{a:?} and {b:?}");
        assert_eq!(numdiff(b, a), Ok(()), "{b:?} and {a:?}");
    }

    #[track_caller]
    fn different(a: &str, b: &str) {
        assert!(numdiff(a, b).is_err(), "{a:?} and {b:?} must differ");
        assert!(numdiff(b, a).is_err(), "{b:?} and {a:?} must differ");
    }

    #[test]
    fn decimals_may_move_by_one_unit() {
        same("T = 1.182177 (left)", "T = 1.182178 (left)");
        different("T = 1.182177 (left)", "T = 1.182179 (left)");
        same("| 0.10 | -2.50 |", "| 0.11 | -2.49 |");
        same("gap −0.01.", "gap 0.00.");
        different("-0.01", "0.01");
        same("x=2.364,3.5", "x=2.365,3.5");
        same("0.12345678901234", "0.12345678901235");
        different("0.12345678901234", "0.12345678901236");
    }

    #[test]
    fn a_carry_may_move_the_point_and_a_lost_digit_is_a_difference() {
        same("9.99e-9", "1.00e-8");
        same("9.9996", "10.000");
        same("0.99996", "1.0000");
        different("9.9996", "10.02");
        different("1.25", "1.2");
        different("1.0", "1.00");
        different("3", "3.0");
    }

    #[test]
    fn integers_and_words_may_not_move() {
        different("n = 29", "n = 30");
        different("certified", "not-certified");
        different("a b", "ab");
        different("1 2", "12");
        different("figure-4", "figure-5");
        different("nalgebra 0.35.0", "nalgebra 0.35.1");
        different("x86", "x87");
        different("1–16", "1–17");
        different("1.25", "nan");
        different("1.25 m", "1.25");
        // More digits than two numbers of 64 bits can be compared by.
        different("1.0000000000000001", "1.0000000000000002");
    }

    #[test]
    fn powers_of_ten_are_part_of_the_number() {
        same("residual 9.99·10⁻⁹ at 30", "residual 1.00·10⁻⁸ at 30");
        different("residual 1.2·10⁻⁹", "residual 1.2·10⁻⁸");
        different("residual 1.2·10⁻⁹", "residual 1.4·10⁻⁹");
        same("cond 4.0·10¹²", "cond 4.1·10¹²");
        same("3.0e-5,1", "3.1e-5,1");
        different("3.0e-5,1", "3.0e-5,2");
        different("1.0e-9", "1.2e-9");
    }

    #[test]
    fn blanks_before_the_first_word_are_structure() {
        different("- a\n  - b", "- a\n- b");
        different("    code", "code");
        // A sign of zero moves the columns and nothing else.
        same("|  -0.0 |  1 |", "|   0.0 |  1 |");
        same("-0.0   9.99", " 0.0  10.00");
        same("0.0e0", "-0.0e-7");
    }

    #[test]
    fn the_first_difference_is_told() {
        let difference = numdiff("a\nb 1.0\nc", "a\nb 1.5\nc").expect_err("1.0 is not 1.5");
        assert_eq!(difference.to_string(), "line 2: `1.0` became `1.5`\n  expected: b 1.0\n  actual:   b 1.5");
        assert_eq!(numdiff("a\nb", "a").map_err(|d| (d.line, d.was)), Err((2, "b".to_owned())), "a line is missing");
        assert_eq!(numdiff("a", "a\n\nb").map_err(|d| (d.line, d.is)), Err((2, String::new())), "two lines are new");
        same("a\n", "a");
    }

    #[test]
    fn pixels_may_move_by_one_and_labels_may_not() {
        let svg = |x, label, colour| {
            format!("<line x1=\"{x}\" stroke=\"#{colour}\"/>\n<path\n d=\"M{x},20L30,-4\"/><text>n = {label}</text>")
        };
        let drawn = svg(100, 29, "1f77b4");
        assert_eq!(numdiff_svg(&drawn, &svg(101, 29, "1f77b4")), Ok(()), "one pixel");
        assert!(numdiff_svg(&drawn, &svg(102, 29, "1f77b4")).is_err(), "two pixels");
        assert!(numdiff_svg(&drawn, &svg(100, 30, "1f77b4")).is_err(), "another label");
        assert!(numdiff_svg(&drawn, &svg(100, 29, "1f77b5")).is_err(), "another colour");
        assert!(numdiff_svg(&svg(100, 29, "100000"), &svg(100, 29, "100001")).is_err(), "a colour without letters");
        assert!(numdiff_svg(&drawn, &drawn.replace("x1", "x2")).is_err(), "another attribute");
        assert!(numdiff_svg(&drawn, &drawn.replace("20L", "20M")).is_err(), "another command");
        assert!(numdiff(&drawn, &svg(101, 29, "1f77b4")).is_err(), "text has no pixels");
    }

    #[test]
    fn any_text_is_read_without_panic() {
        let texts = "| - | − | e | 1e | 1e- | 1e+ | + | .. | 1..2 | . | 1. | .5 | # | ·10 | ·10⁻ | 1·10 | 1·10⁻ | ä1ö2 | < | M | \
                     1e1.5 | --1 | 0x1f | 1.5·10⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹ | 1e999 | −é | 1é | ·";
        for text in texts.split(" | ") {
            same(text, text);
            assert_eq!(numdiff_svg(text, text), Ok(()), "{text:?}");
            let in_path = format!("<path d=\"{text}");
            assert_eq!(numdiff_svg(&in_path, &in_path), Ok(()), "{text:?} in a tag");
        }
    }
}
