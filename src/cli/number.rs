//! Numbers as a table shows them.

/// Significant digits of a result in a table.
const DIGITS: usize = 10;

/// A result: ten significant digits, without trailing zeros.
pub(super) fn result(value: f64) -> String {
    significant(value, DIGITS)
}

/// A residual, an error or a time: two digits and its order of magnitude.
pub(super) fn magnitude(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}

/// A lower bound: as [`result`], but never above the number.
pub(super) fn at_least(value: f64) -> String {
    bounding(value, result, -SLACK, |shown, value| shown <= value)
}

/// An upper bound: as [`result`], but never below the number.
pub(super) fn at_most(value: f64) -> String {
    bounding(value, result, SLACK, |shown, value| value <= shown)
}

/// An upper bound of which only the size is of interest: as [`magnitude`], but never below the number.
pub(super) fn magnitude_at_most(value: f64) -> String {
    /// A tenth of a unit in the second digit, or less.
    const SLACK: f64 = 0.01;
    bounding(value, magnitude, SLACK, |shown, value| value <= shown)
}

/// Steps of a tenth of a unit in the last of [`DIGITS`] digits, as a share, or less.
const SLACK: f64 = 1e-10;

/// The text of `value`, or of the next number in steps of `slack` whose text is a bound.
fn bounding(value: f64, text: impl Fn(f64) -> String, slack: f64, bounds: impl Fn(f64, f64) -> bool) -> String {
    /// A unit in the last digit is at most ten steps.
    const STEPS: i32 = 12;
    let mut shown = (0..STEPS).map(|k| text(value + f64::from(k) * slack * value.abs()));
    shown.find(|shown| shown.parse().is_ok_and(|shown| bounds(shown, value))).unwrap_or_else(|| value.to_string())
}

fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        // Also −0, which means nothing to a reader.
        return if value == 0.0 { "0".to_owned() } else { value.to_string() };
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    // Beyond these a row of zeros would have to be counted.
    if !(-4..9).contains(&exponent) {
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    let decimals = i32::try_from(digits).unwrap_or(i32::MAX) - 1 - exponent;
    trimmed(&format!("{value:.*}", usize::try_from(decimals).unwrap_or(0))).to_owned()
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}
