//! A number as it is printed: exact decimal arithmetic on digits, no floating point.

/// A printed number, `mantissa · 10^(exponent − places)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Numeral {
    /// All digits as one integer, with the sign; `-0.0` becomes 0 like `0.0`.
    mantissa: i128,
    /// Power of ten that is printed, 0 if none is.
    exponent: i32,
    /// Digits behind the point.
    places: i32,
    /// Digits from the first that is not zero.
    significant: i32,
    /// Printed without a point and without an exponent.
    integer: bool,
}

impl Numeral {
    /// Reads `[+-]digits[.digits][e[+-]digits]`, with `−` as well as `-`; `None` for anything else and for numbers
    /// of more digits than exact arithmetic holds, which are then compared as words.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let (negative, unsigned) = match text.strip_prefix(['-', '−']) {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (digits, exponent) = match unsigned.split_once(['e', 'E']) {
            Some((digits, exponent)) => (digits, Some(exponent.parse::<i32>().ok()?)),
            None => (unsigned, None),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let all_digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
        if whole.is_empty() || !all_digits(whole) || !all_digits(fraction) || digits.ends_with('.') {
            return None;
        }
        let joined = [whole, fraction].concat();
        let magnitude: i128 = joined.parse().ok()?;
        let significant = joined.trim_start_matches('0').len().max(1);
        Some(Self {
            mantissa: if negative { -magnitude } else { magnitude },
            exponent: exponent.unwrap_or(0),
            places: i32::try_from(fraction.len()).ok()?,
            significant: i32::try_from(significant).ok()?,
            integer: exponent.is_none() && fraction.is_empty(),
        })
    }

    /// The same number times a power of ten, printed as such (`1.2·10⁻⁹`).
    pub(super) fn times_ten_to(self, exponent: i32) -> Self {
        Self { exponent: self.exponent.saturating_add(exponent), integer: false, ..self }
    }

    /// True if the number is printed as an integer.
    pub(super) fn is_integer(&self) -> bool {
        self.integer
    }

    /// Power of ten of the last printed place.
    fn last_place(&self) -> i32 {
        self.exponent.saturating_sub(self.places)
    }

    /// True if both have the same format: as many places, or as many significant digits, so that `9.9996` may become
    /// `10.000`, but a number that lost a digit is not the same print.
    fn printed_alike(&self, other: &Self) -> bool {
        self.integer == other.integer && (self.places == other.places || self.significant == other.significant)
    }

    /// True if both are printed alike and differ by at most one unit of the last printed place, the coarser one if
    /// they end at different places.
    pub(super) fn within_one_unit(&self, other: &Self) -> bool {
        if self.mantissa == 0 && other.mantissa == 0 {
            return self.integer == other.integer && self.places == other.places;
        }
        self.printed_alike(other) && self.distance_in_units(other).is_some_and(|(distance, unit)| distance <= unit)
    }

    /// Distance and unit, both as multiples of the finer of the two last places; `None` beyond the range of `i128`.
    fn distance_in_units(&self, other: &Self) -> Option<(u128, u128)> {
        let (fine, coarse) = if self.last_place() <= other.last_place() { (self, other) } else { (other, self) };
        let steps = coarse.last_place().checked_sub(fine.last_place())?;
        let unit = 10_i128.checked_pow(u32::try_from(steps).ok()?)?;
        let distance = coarse.mantissa.checked_mul(unit)?.checked_sub(fine.mantissa)?;
        Some((distance.unsigned_abs(), unit.unsigned_abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(a: &str, b: &str, equal: bool) {
        let parse = |text| Numeral::parse(text).unwrap_or_else(|| panic!("`{text}` is a number"));
        assert_eq!(parse(a).within_one_unit(&parse(b)), equal, "{a} and {b}");
        assert_eq!(parse(b).within_one_unit(&parse(a)), equal, "{b} and {a}");
    }

    #[test]
    fn one_unit_of_the_last_place_is_allowed_and_two_are_not() {
        check("1.25", "1.26", true);
        check("1.25", "1.27", false);
        check("-0.01", "0.00", true);
        check("-0.01", "0.01", false);
        check("1.0e-9", "1.1e-9", true);
        check("1.0e-9", "1.2e-9", false);
    }

    #[test]
    fn a_carry_may_move_the_point() {
        check("9.99e-9", "1.00e-8", true);
        check("9.9996", "10.000", true);
        check("0.99996", "1.0000", true);
        check("9.9996", "10.02", false);
    }

    #[test]
    fn a_lost_digit_is_a_difference() {
        check("1.25", "1.2", false);
        check("1.0", "1.00", false);
        check("3", "3.0", false);
    }

    #[test]
    fn zero_has_no_sign() {
        check("-0.0", "0.0", true);
        check("0.0e0", "-0.0e-7", true);
    }

    #[test]
    fn words_are_not_numbers() {
        for text in ["", "-", ".", "1.", ".5", "1e", "1e1.5", "0x1f", "nan", "0.11.1", "--1"] {
            assert_eq!(Numeral::parse(text), None, "`{text}`");
        }
    }

    #[test]
    fn too_many_digits_are_a_word() {
        assert_eq!(Numeral::parse(&"9".repeat(60)), None, "sixty digits");
    }
}
