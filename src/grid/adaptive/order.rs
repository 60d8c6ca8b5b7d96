//! The observed order of convergence.

/// The observed order of convergence: the slope of `ln e` over `ln h`, fitted to all pairs `(h, e)` by least squares.
///
/// ```text
/// e ≈ c hᵖ,    p = Σ (ln hᵢ − m_h)(ln eᵢ − m_e) / Σ (ln hᵢ − m_h)²,    m: mean
/// ```
///
/// The sign of an error is ignored. The result is NaN if there is no slope to fit: fewer than two different `h`, an `h` that is not
/// positive, or an error that is zero or not finite. Every comparison with NaN is false, so such a series passes no test.
#[must_use]
pub fn observed_order(errors: &[(f64, f64)]) -> f64 {
    // libm, because the logarithm of the standard library differs between platforms in its last digit.
    let points: Vec<(f64, f64)> = errors.iter().map(|&(h, e)| (libm::log(h), libm::log(e.abs()))).collect();
    if points.iter().any(|(h, e)| !h.is_finite() || !e.is_finite()) {
        return f64::NAN;
    }
    let count = points.len() as f64;
    let (mean_h, mean_e) =
        (points.iter().map(|(h, _)| h).sum::<f64>() / count, points.iter().map(|(_, e)| e).sum::<f64>() / count);
    let (covariance, variance) = points.iter().fold((0.0, 0.0), |(covariance, variance), (h, e)| {
        let step = h - mean_h;
        (covariance + step * (e - mean_e), variance + step * step)
    });
    // A single `h` gives 0/0, or, if the mean is rounded, a variance of the size of rounding. Neither is a slope.
    let same = points.iter().all(|(h, _)| h.total_cmp(&points[0].0).is_eq());
    if same { f64::NAN } else { covariance / variance }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The fit of an exact power law is limited by rounding of a few logarithms of size 10.
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn a_power_law_gives_its_exponent() {
        for order in [0.5, 1.0, 2.0, 4.0] {
            let errors: Vec<_> =
                (1..6).map(|k| f64::from(1 << k).recip()).map(|h| (h, -3.0 * libm::pow(h, order))).collect();
            let observed = observed_order(&errors);
            assert!((observed - order).abs() < ROUNDING, "order {order}, observed {observed}");
        }
    }

    #[test]
    fn the_fit_is_least_squares() {
        // ln h = 0, 1, 2 and ln e = 0, 0, 3: slope 3/2.
        let e = std::f64::consts::E;
        let observed = observed_order(&[(1.0, 1.0), (e, 1.0), (e * e, e * e * e)]);
        assert!((observed - 1.5).abs() < ROUNDING, "observed {observed}");
    }

    #[test]
    fn no_slope_is_nan() {
        let series: [&[(f64, f64)]; 6] = [
            &[],
            &[(0.1, 1.0)],
            &[(0.1, 1.0), (0.1, 2.0), (0.1, 3.0)],
            &[(0.1, 1.0), (0.2, 0.0)],
            &[(0.1, 1.0), (0.2, f64::NAN)],
            &[(-0.1, 1.0), (0.2, 2.0)],
        ];
        for errors in series {
            assert!(observed_order(errors).is_nan(), "{errors:?}");
        }
    }
}
