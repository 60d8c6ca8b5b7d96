//! Numbers and titles as text. Figures and documents use a minus sign and raised powers of ten; tables use a format that other
//! programs can read too.

/// `value` with `digits` significant digits, without trailing zeros; in the form `2.5·10⁻⁷` if it is very small or large.
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    // A number that ends in 5 may be computed slightly below or above; it is rounded up in both cases.
    const TIE: f64 = 1e-12;
    let value = value + TIE * value;
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-3..=5).contains(&exponent) {
        let decimals = usize::try_from(-exponent).map_or_else(
            |_| digits.saturating_sub(1).saturating_sub(exponent.unsigned_abs() as usize),
            |small| digits.saturating_sub(1) + small,
        );
        typeset(trimmed(&format!("{value:.decimals$}")))
    } else {
        format!("{}·{}", typeset(trimmed(mantissa)), power_of_ten(exponent))
    }
}

/// `value` with a fixed number of decimals, as for the labels of an axis.
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> String {
    typeset(&format!("{value:.decimals$}"))
}

/// `10ⁿ` with raised digits.
#[must_use]
pub fn power_of_ten(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).and_then(|digit| RAISED.get(usize::try_from(digit).ok()?));
    let digits = exponent.to_string();
    "10".chars().chain(digits.chars().map(|c| raised(c).copied().unwrap_or('⁻'))).collect()
}

/// `10ⁿ` as the nearest `f64`. Parsing text rounds correctly on every platform, which `powi` does not guarantee.
#[must_use]
pub fn ten_to(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}

/// The largest `n` with `10ⁿ ≤ |value|`, for a finite nonzero value.
#[must_use]
pub fn decade(value: f64) -> i32 {
    let scientific = format!("{value:e}");
    scientific.split_once('e').and_then(|(_, n)| n.parse().ok()).unwrap_or(0)
}

/// The text without trailing zeros after a decimal point.
fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// Replaces the hyphen by a minus sign, and removes the minus before zero.
fn typeset(text: &str) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text.to_owned(),
    }
}

/// A text that Markdown displays literally. Titles and units come from a scene file and may contain tags or links.
#[must_use]
pub fn markdown_text(text: &str) -> String {
    /// Characters with a meaning in Markdown that a backslash removes.
    const MARKS: &str = r"\`*_[]<>&|~$#";
    text.chars().flat_map(|c| MARKS.contains(c).then_some('\\').into_iter().chain([c])).collect()
}

/// Default number of significant digits of [`Results`]: more than the accuracy of any load or depth.
pub const DIGITS: usize = 6;

/// The number of digits that distinguishes any two 64-bit numbers.
pub const MOST_DIGITS: usize = 17;

/// Format of results: a number of significant digits, without trailing zeros.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Results {
    digits: usize,
}

impl Default for Results {
    fn default() -> Self {
        Self { digits: DIGITS }
    }
}

impl Results {
    /// Results with 1 to [`MOST_DIGITS`] digits; other numbers are limited to this range.
    #[must_use]
    pub fn with_digits(digits: usize) -> Self {
        Self { digits: digits.clamp(1, MOST_DIGITS) }
    }

    /// Formats a result.
    #[must_use]
    pub fn number(self, value: f64) -> String {
        plain(value, self.digits)
    }

    /// Formats a lower bound: the text is never above the number.
    #[must_use]
    pub fn at_least(self, value: f64) -> String {
        bounding(value, |value| self.number(value), -self.slack(), |shown, value| shown <= value)
    }

    /// Formats an upper bound: the text is never below the number.
    #[must_use]
    pub fn at_most(self, value: f64) -> String {
        bounding(value, |value| self.number(value), self.slack(), |shown, value| value <= shown)
    }

    /// Relative step of at least a tenth of a unit in the last digit, and at most one unit.
    fn slack(self) -> f64 {
        ten_to(-i32::try_from(self.digits).unwrap_or(i32::MAX)).max(f64::EPSILON)
    }
}

/// A residual, an error or a time with two digits and its order of magnitude; a dash for infinity and NaN.
#[must_use]
pub fn magnitude(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        _ if value.is_finite() => format!("{value:.1e}"),
        _ => "–".to_owned(),
    }
}

/// At most a tenth of a unit in the second digit, relative.
const SLACK: f64 = 0.01;

/// An upper bound of which only the magnitude matters: formatted as by [`magnitude`], but never below the number.
#[must_use]
pub fn magnitude_at_most(value: f64) -> String {
    bounding(value, magnitude, SLACK, |shown, value| value <= shown)
}

/// A lower bound of which only the magnitude matters: formatted as by [`magnitude`], but never above the number.
#[must_use]
pub fn magnitude_at_least(value: f64) -> String {
    bounding(value, magnitude, -SLACK, |shown, value| shown <= value)
}

/// An upper bound on a relative quantity: in per cent if readable, such as `0.25 %`, otherwise as by [`magnitude_at_most`].
#[must_use]
pub fn share_at_most(value: f64) -> String {
    if !(1e-4..10.0).contains(&value) {
        return magnitude_at_most(value);
    }
    bounding(100.0 * value, |percent| plain(percent, 2), SLACK, |shown, percent| percent <= shown) + " %"
}

/// The text of `value`, or of the next number in steps of `slack` whose text is a bound.
fn bounding(value: f64, text: impl Fn(f64) -> String, slack: f64, bounds: impl Fn(f64, f64) -> bool) -> String {
    /// A unit in the last digit is at most ten steps.
    const STEPS: i32 = 12;
    let mut shown = (0..STEPS).map(|k| text(value + f64::from(k) * slack * value.abs()));
    shown.find(|shown| shown.parse().is_ok_and(|shown| bounds(shown, value))).unwrap_or_else(|| text(value))
}

/// `value` with `digits` significant digits, without trailing zeros; in the form `2.5e-7` if it is very small or large.
fn plain(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        // Also −0, whose sign means nothing to a reader.
        return if value == 0.0 { "0".to_owned() } else { value.to_string() };
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-4..9).contains(&exponent) {
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    let decimals = i32::try_from(digits).unwrap_or(i32::MAX) - 1 - exponent;
    trimmed(&format!("{value:.*}", usize::try_from(decimals).unwrap_or(0))).to_owned()
}

#[cfg(test)]
mod tests {
    use super::{MOST_DIGITS, Results, decade, fixed, share_at_most, significant, ten_to};

    #[test]
    fn numbers_are_written_for_a_reader() {
        assert_eq!(significant(1.182_177_011, 4), "1.182");
        assert_eq!(significant(-0.5, 4), "−0.5");
        assert_eq!(significant(9.999_96, 4), "10");
        assert_eq!([significant(3.4375, 4), significant(3.4375 - 1e-14, 4)], ["3.438", "3.438"]);
        assert_eq!(significant(123_456.0, 4), "123456");
        assert_eq!(significant(0.0, 4), "0");
        assert_eq!(significant(-1e-300, 3), "−1·10⁻³⁰⁰");
        assert_eq!(significant(0.001_234_5, 3), "0.00123");
        assert_eq!(fixed(-0.0, 1), "0.0");
    }

    #[test]
    fn a_share_is_never_below_its_number() {
        let shown = [0.1, 0.1001, 0.002_41, 0.82, 1.301, 1e-4, 9.9e-5, 3.21e-15, 12.34, 0.0].map(share_at_most);
        assert_eq!(shown, ["10 %", "11 %", "0.25 %", "82 %", "131 %", "0.01 %", "9.9e-5", "3.3e-15", "1.3e1", "0"]);
        assert_eq!(share_at_most(f64::INFINITY), "–");
    }

    #[test]
    fn bounds_hold_with_any_number_of_digits() {
        let value = |text: &str| text.parse::<f64>().expect("a number");
        for digits in 0..=MOST_DIGITS + 1 {
            let results = Results::with_digits(digits);
            for number in
                [1.0, 1.04, 9.6, 9.999_999_999, 1.0 / 3.0, 2.0 / 3.0, 1e-300, 123_456_789.5, 1.302_083_333_333_333_3]
            {
                for number in [number, -number] {
                    let [least, most] = [results.at_least(number), results.at_most(number)].map(|text| value(&text));
                    assert!(least <= number && number <= most, "{number} with {digits} digits: {least} to {most}");
                    // A unit in the last digit is at most this large, and a deviation of more than two units is an error.
                    let unit = number.abs() * 10.0 * ten_to(-i32::try_from(digits.max(1)).expect("few digits"));
                    assert!(
                        most - least <= 2.0 * unit.max(1e-15 * number.abs()),
                        "{number} with {digits} digits: {least} to {most}"
                    );
                }
            }
        }
    }

    #[test]
    fn decades_hold_at_their_borders() {
        assert_eq!([decade(1.0), decade(0.999), decade(10.0), decade(-1e-5), decade(5e-324)], [0, -1, 1, -5, -324]);
        assert_eq!(ten_to(-3).to_bits(), 1e-3_f64.to_bits());
    }
}
