//! Fixed-end moments and shear forces of a cosine profile, in closed form.
//!
//! Over a span of length `ℓ`, let `ψ` be the phase of `u = A cos(ωx + φ)` at midspan and `k = ωℓ/2`. Partial integration of
//! `∫ u'''' w_a` with the weights of [`super::span`] gives, with the spherical Bessel functions `j₁` and `j₂`,
//!
//! ```text
//! G_a = A ω² k (cosψ j₁(k) + sinψ j₂(k)),       ∫ u'''' (ℓ − t)/ℓ = A ω³ (cosψ sin k + sinψ k j₁(k))
//! G_b = A ω² k (cosψ j₁(k) − sinψ j₂(k)),       ∫ u''''      t /ℓ = A ω³ (cosψ sin k − sinψ k j₁(k))
//! ```
//!
//! For long spans over many waves this does not sum over the waves. For short spans the series of `j` do not cancel.

/// `([G_a, G_b], [shear_a, shear_b])` of `A cos` with the phase `psi` at the middle of a span of length `l`.
pub(super) fn fixed_end(amplitude: f64, wave: f64, psi: f64, l: f64) -> ([f64; 2], [f64; 2]) {
    let k = 0.5 * wave * l;
    let (j1, j2) = bessel(k);
    let (even, odd) = (libm::cos(psi), libm::sin(psi));
    let moment = amplitude * wave * wave * k;
    let shear = amplitude * wave * wave * wave;
    let through = even * libm::sin(k);
    (
        [moment * (even * j1 + odd * j2), moment * (even * j1 - odd * j2)],
        [shear * (through + odd * k * j1), shear * (through - odd * k * j1)],
    )
}

/// Spherical Bessel functions `j₁(k)` and `j₂(k)` for `k ≥ 0`.
fn bessel(k: f64) -> (f64, f64) {
    /// Argument below which the closed forms lose digits (one in `j₁`, three in `j₂`); the series needs at most 14 terms there.
    const SERIES: f64 = 2.0;
    if k < SERIES {
        // j_n = k^n Σ (−k²/2)^m / (m! (2n + 2m + 1)!!)
        let series = |n: f64, first: f64| {
            let (mut term, mut sum) = (first, first);
            let mut m = 1.0;
            while m < 16.0 {
                term *= -0.5 * k * k / (m * (2.0 * n + 2.0 * m + 1.0));
                sum += term;
                m += 1.0;
            }
            sum
        };
        (series(1.0, k / 3.0), series(2.0, k * k / 15.0))
    } else {
        let (sine, cosine) = (libm::sin(k), libm::cos(k));
        let j1 = (sine / k - cosine) / k;
        (j1, 3.0 * j1 / k - sine / k)
    }
}

#[cfg(test)]
mod tests {
    use super::super::gauss::Gauss;
    use super::*;

    #[test]
    fn closed_form_is_the_integral() {
        // Quadrature with fifty points over up to three waves, in sums of order 1.
        const ROUNDING: f64 = 1e-12;
        let rule = Gauss::exact_to(99);
        for wave in [0.01, 0.5, 1.9, 2.1, 7.0, 20.0] {
            let (amplitude, phase, a, b) = (0.7, 0.4, 0.3, 1.3);
            let l = b - a;
            let fourth = |x: f64| amplitude * libm::pow(wave, 4.0) * libm::cos(wave * x + phase);
            let (g, q) = fixed_end(amplitude, wave, wave * 0.5 * (a + b) + phase, l);
            let integral = |w: &dyn Fn(f64) -> f64| rule.integral(a, b, |x| fourth(x) * w(x - a));
            let found = [g[0], g[1], q[0], q[1]];
            let exact = [
                integral(&|t| t * (l - t) * (l - t) / (l * l)),
                integral(&|t| t * t * (l - t) / (l * l)),
                integral(&|t| (l - t) / l),
                integral(&|t| t / l),
            ];
            for (found, exact) in found.iter().zip(exact) {
                let scale = amplitude * libm::pow(wave, 4.0).min(wave * wave * wave);
                assert!((found - exact).abs() <= ROUNDING * scale, "{found} instead of {exact} for wave number {wave}");
            }
        }
    }
}
