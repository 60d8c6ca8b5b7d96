//! Numbers of rounding size in words: a bound that holds, not digits that mean nothing and differ between machines.

/// `10ᵏ` as text, the power of ten that is at least three times `value`; `0` for zero.
pub(in crate::paper::claims) fn bound(value: f64) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = libm::ceil(libm::log10(3.0 * value.abs()));
    let digits = format!("{:.0}", exponent.abs());
    let raised: String = digits.chars().filter_map(|c| c.to_digit(10)).filter_map(|d| RAISED.get(d as usize)).collect();
    format!("10{}{raised}", if exponent < 0.0 { "⁻" } else { "" })
}

#[cfg(test)]
mod tests {
    use super::bound;

    #[test]
    fn bounds_are_above() {
        assert_eq!([2e-12, 0.9e-9, 0.3, 20.0, 0.0].map(bound), ["10⁻¹¹", "10⁻⁸", "10⁰", "10²", "0"]);
    }
}
