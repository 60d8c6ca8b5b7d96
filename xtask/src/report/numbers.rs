//! How the templates print numbers. A number with a point has no other way into the report.
//!
//! Print at least one digit behind the point: what is printed without one counts as an integer, and integers are compared
//! exactly. Do not print what is only rounding (`1.1·10⁻¹⁶`); print the bound that it stays below.

use std::fmt;

use minijinja::{Environment, Error, ErrorKind};

/// Makes the filters known to the templates.
pub(super) fn add_filters(environment: &mut Environment<'_>) {
    environment.add_filter("fixed", fixed);
    environment.add_filter("digits", digits);
    environment.add_filter("sci", sci);
    environment.add_filter("percent", percent);
    environment.add_filter("thousands", thousands);
}

/// `{{ x | fixed(3) }}`: digits behind the point, `1.182`.
fn fixed(value: f64, places: usize) -> Result<String, Error> {
    finite(value).map(|value| unsigned_zero(format!("{value:.places$}")))
}

/// `{{ x | digits(3) }}`: significant digits, `1.18` and `610`; as [`sci`] below 10⁻⁴ and from 10⁶ on.
fn digits(value: f64, significant: usize) -> Result<String, Error> {
    let behind = significant.saturating_sub(1);
    let scientific = format!("{:.behind$e}", finite(value)?);
    // Rust prints `d.ddde-5`; zero has exponent 0.
    let exponent: i32 = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    let places = i32::try_from(behind).unwrap_or(i32::MAX).saturating_sub(exponent);
    match usize::try_from(places) {
        Ok(places) if -4 <= exponent => fixed(value, places),
        Err(_) if exponent < 6 => {
            let rounded: f64 = scientific.parse().unwrap_or(value);
            Ok(grouped(&format!("{rounded:.0}")))
        }
        _ => sci(value, behind),
    }
}

/// A number of a table, as [`digits`]; a dash for one that is not there or is none.
pub(super) fn cell(value: Option<f64>, significant: usize) -> String {
    value.and_then(|value| digits(value, significant).ok()).unwrap_or_else(|| "–".to_owned())
}

/// An error of a table, to one digit; a dash for one that is not there.
pub(super) fn error_cell(value: Option<f64>) -> String {
    value.and_then(|value| sci(value, 0).ok()).unwrap_or_else(|| "–".to_owned())
}

/// `{{ x | sci(1) }}`: digits behind the point and a power of ten, `1.2·10⁻⁹`; zero is `0`.
fn sci(value: f64, places: usize) -> Result<String, Error> {
    let printed = format!("{:.places$e}", finite(value)?);
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((&printed, "0"));
    if mantissa.chars().all(|c| matches!(c, '-' | '0' | '.')) {
        return Ok("0".to_owned());
    }
    Ok(format!("{mantissa}·10{}", Superscript(exponent)))
}

/// `10ⁿ`
pub(super) fn power(exponent: i32) -> String {
    format!("10{}", Superscript(&exponent.to_string()))
}

/// What a number of rounding size stays below: the power of ten that is at least three times as large, so that another
/// machine says the same; `0` for zero. A power of ten that was chosen and not computed is itself.
pub(super) fn bound(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let printed = format!("{:e}", value.abs());
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((&printed, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let mantissa: f64 = mantissa.parse().unwrap_or(1.0);
    power(
        exponent
            + if mantissa <= 1.0 {
                0
            } else if mantissa <= 10.0 / 3.0 {
                1
            } else {
                2
            },
    )
}

/// `{{ x | percent(1) }}`: a fraction in percent, `3.4 %`.
fn percent(value: f64, places: usize) -> Result<String, Error> {
    fixed(100.0 * value, places).map(|number| format!("{number} %"))
}

/// `{{ n | thousands }}`: an integer in groups, `20 000`.
pub(super) fn thousands(value: i64) -> String {
    grouped(&value.to_string())
}

/// A count as text, in groups.
pub(super) fn count(number: usize) -> String {
    grouped(&number.to_string())
}

/// A count to calculate with.
pub(super) fn as_number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}

/// Digits in groups of three from five digits on.
fn grouped(number: &str) -> String {
    let (sign, digits) = number.strip_prefix('-').map_or(("", number), |digits| ("-", digits));
    if digits.len() < 5 {
        return number.to_owned();
    }
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|group| std::str::from_utf8(group).ok()).collect();
    format!("{sign}{}", groups.join(" "))
}

/// `value`, or an error that stops the report: a number that is none must not look like a result.
fn finite(value: f64) -> Result<f64, Error> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::new(ErrorKind::InvalidOperation, format!("a number of the report must be finite, but is {value}")))
    }
}

/// Takes the sign off a printed zero: `-0.0` is `0.0`.
fn unsigned_zero(printed: String) -> String {
    match printed.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => printed,
    }
}

/// An integer in raised digits.
struct Superscript<'a>(&'a str);

impl fmt::Display for Superscript<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        self.0.chars().try_for_each(|c| {
            match c.to_digit(10).and_then(|digit| RAISED.get(usize::try_from(digit).ok()?)) {
                Some(raised) => write!(f, "{raised}"),
                None => write!(f, "⁻"),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(printed: Result<String, Error>, expected: &str) {
        assert_eq!(printed.expect("the number is finite"), expected);
    }

    #[test]
    fn fixed_digits() {
        check(fixed(1.182_177, 3), "1.182");
        check(fixed(-0.04, 1), "0.0");
        check(fixed(-0.0, 2), "0.00");
        check(fixed(-0.06, 1), "-0.1");
    }

    #[test]
    fn significant_digits() {
        check(digits(1.182_177, 3), "1.18");
        check(digits(9.9996, 4), "10.00");
        check(digits(0.001_234_5, 2), "0.0012");
        check(digits(0.000_012_34, 2), "1.2·10⁻⁵");
        check(digits(123_456.0, 3), "123 000");
        check(digits(612.0, 2), "610");
        check(digits(2.5e6, 2), "2.5·10⁶");
        check(digits(-123.4, 3), "-123");
        check(digits(0.0, 3), "0.00");
    }

    #[test]
    fn scientific() {
        check(sci(1.23e-9, 1), "1.2·10⁻⁹");
        check(sci(-4.0e12, 0), "-4·10¹²");
        check(sci(1.0, 1), "1.0·10⁰");
        check(sci(-0.0, 1), "0");
        assert_eq!([power(6), power(-11)], ["10⁶", "10⁻¹¹"]);
    }

    #[test]
    fn bounds_hold_with_a_margin() {
        assert_eq!([2e-12, 4e-12, 1e-4, 0.3, 0.0].map(bound), ["10⁻¹¹", "10⁻¹⁰", "10⁻⁴", "10⁰", "0"]);
    }

    #[test]
    fn percentages_and_groups() {
        check(percent(0.034, 1), "3.4 %");
        assert_eq!(
            [0, 999, -1000, 20_000, 1_234_567].map(thousands),
            ["0", "999", "-1000", "20 000", "1 234 567"],
            "groups of three"
        );
    }

    #[test]
    fn what_is_no_number_stops_the_report() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(fixed(value, 1).is_err() && digits(value, 3).is_err() && sci(value, 1).is_err(), "{value}");
        }
    }
}
