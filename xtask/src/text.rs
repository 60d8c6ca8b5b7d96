//! Numbers as text, for documents, tables and data, with the minus sign of [`palkki::text`]; a table as data has hyphens.
//!
//! Print at least one digit behind the point: what is printed without one counts as an integer, and integers are compared
//! exactly. Do not print what is only rounding (`1.1·10⁻¹⁶`); print the [`bound`] that it stays below.

pub(crate) use palkki::text::{fixed, power_of_ten, ten_to};
pub(crate) use palkki_evidence::paper::claims::bound;

/// Digits behind the point and the power of ten as programs read it, `1.18e-9`.
pub(crate) fn scientific(value: f64, places: usize) -> String {
    format!("{value:.places$e}")
}

/// Digits behind the point and a power of ten, `1.2·10⁻⁹`; zero is `0`.
pub(crate) fn times_ten(value: f64, places: usize) -> String {
    let (mantissa, exponent) = split(value, places);
    if mantissa.chars().all(|c| matches!(c, '-' | '0' | '.')) {
        return "0".to_owned();
    }
    format!("{}·{}", mantissa.replace('-', "−"), power_of_ten(exponent))
}

/// Significant digits, `1.18` and `610`; as [`times_ten`] below 10⁻⁴ and from 10⁶ on.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let behind = digits.saturating_sub(1);
    let (_, exponent) = split(value, behind);
    let places = i32::try_from(behind).unwrap_or(i32::MAX).saturating_sub(exponent);
    match usize::try_from(places) {
        Ok(places) if -4 <= exponent => fixed(value, places),
        Err(_) if exponent < 6 => {
            let rounded: f64 = scientific(value, behind).parse().unwrap_or(value);
            grouped(&fixed(rounded, 0))
        }
        _ => times_ten(value, behind),
    }
}

/// Mantissa and exponent of `d.ddde-5`; zero has exponent 0.
fn split(value: f64, places: usize) -> (String, i32) {
    let text = scientific(value, places);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (mantissa.to_owned(), exponent.parse().unwrap_or(0))
}

/// A number of a table, as [`significant`]; a dash for one that is not there or is none.
pub(crate) fn cell(value: Option<f64>, digits: usize) -> String {
    shown(value, |value| significant(value, digits))
}

/// An error of a table, to one digit; a dash for one that is not there.
pub(crate) fn error_cell(value: Option<f64>) -> String {
    shown(value, |value| times_ten(value, 0))
}

fn shown(value: Option<f64>, print: impl Fn(f64) -> String) -> String {
    value.filter(|value| value.is_finite()).map_or_else(|| "–".to_owned(), print)
}

/// The exponent of a number that is a power of ten, as tolerances are that one asks for.
pub(crate) fn exponent_of(value: f64) -> Option<i32> {
    format!("{value:e}").strip_prefix("1e")?.parse().ok()
}

/// A tolerance as `10⁻⁴`; as programs read it if it is no power of ten.
pub(crate) fn tolerance(value: f64) -> String {
    exponent_of(value).map_or_else(|| format!("{value:e}"), power_of_ten)
}

/// An integer in groups of three digits from five digits on, `20 000`.
pub(crate) fn count(number: impl ToString) -> String {
    grouped(&number.to_string())
}

fn grouped(number: &str) -> String {
    let (sign, digits) = number.strip_prefix(['-', '−']).map_or(("", number), |digits| ("−", digits));
    if digits.len() < 5 {
        return format!("{sign}{digits}");
    }
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|group| std::str::from_utf8(group).ok()).collect();
    format!("{sign}{}", groups.join("\u{202f}"))
}

/// The answer to a question.
pub(crate) fn yes_no(is: bool) -> &'static str {
    if is { "yes" } else { "no" }
}

/// A count to calculate with.
pub(crate) fn as_number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fixed_digits() {
        let printed = [fixed(1.182_177, 3), fixed(-0.04, 1), fixed(-0.0, 2), fixed(-0.06, 1)];
        assert_eq!(printed, ["1.182", "0.0", "0.00", "−0.1"]);
    }

    #[test]
    fn significant_digits() {
        for (value, digits, expected) in [
            (1.182_177, 3, "1.18"),
            (9.9996, 4, "10.00"),
            (0.001_234_5, 2, "0.0012"),
            (0.000_012_34, 2, "1.2·10⁻⁵"),
            (123_456.0, 3, "123\u{202f}000"),
            (612.0, 2, "610"),
            (2.5e6, 2, "2.5·10⁶"),
            (-123.4, 3, "−123"),
            (0.0, 3, "0.00"),
        ] {
            assert_eq!(significant(value, digits), expected);
        }
        assert_eq!([cell(Some(f64::NAN), 2), error_cell(None)], ["–", "–"]);
    }

    #[test]
    fn powers_of_ten() {
        let printed = [(1.23e-9, 1), (-4.0e12, 0), (1.0, 1), (-0.0, 1)].map(|(value, places)| times_ten(value, places));
        assert_eq!(printed, ["1.2·10⁻⁹", "−4·10¹²", "1.0·10⁰", "0"]);
        assert_eq!([power_of_ten(6), power_of_ten(-11)], ["10⁶", "10⁻¹¹"]);
        assert_eq!([1e-4, 1.0, 2e-4].map(tolerance), ["10⁻⁴", "10⁰", "2e-4"]);
    }

    #[test]
    fn integers_in_groups() {
        let printed = [0, 999, -1000, 20_000, 1_234_567].map(count);
        assert_eq!(printed, ["0", "999", "−1000", "20\u{202f}000", "1\u{202f}234\u{202f}567"], "groups of three");
    }
}
