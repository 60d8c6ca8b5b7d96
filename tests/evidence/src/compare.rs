//! Differences, of which none is overlooked: what is no number counts as infinitely far.

/// The largest magnitude; infinite if one of them is no number.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, v| if v.is_nan() { f64::INFINITY } else { most.max(v.abs()) })
}

/// The largest difference of two lists of numbers; infinite if they are not of one length. What is infinite in both is the same.
#[must_use]
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    largest(a.iter().zip(b).map(|(a, b)| if a.total_cmp(b).is_eq() { 0.0 } else { a - b }))
}

/// The same, and infinite also if there is nothing to compare.
#[must_use]
pub fn apart_if_any(a: &[f64], b: &[f64]) -> f64 {
    if a.is_empty() { f64::INFINITY } else { apart(a, b) }
}

#[cfg(test)]
mod tests {
    use super::{apart, apart_if_any, largest};

    #[test]
    fn nothing_is_overlooked() {
        assert!(largest([1.0, f64::NAN, 2.0]).is_infinite() && apart(&[1.0], &[f64::NAN]).is_infinite(), "no number");
        assert!(apart(&[1.0], &[]).is_infinite() && apart_if_any(&[], &[]).is_infinite(), "nothing beside it");
        let found = [largest([1.0, -3.0]), apart(&[], &[]), apart(&[f64::INFINITY, 1.0], &[f64::INFINITY, 1.5])];
        assert_eq!(found.map(f64::to_bits), [3.0, 0.0, 0.5_f64].map(f64::to_bits));
    }
}
