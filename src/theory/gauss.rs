//! Gauss–Legendre quadrature: exact for polynomials of degree `2n − 1`, with positive weights, so nothing cancels.

/// Nodes and weights on `[0, 1]`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gauss {
    rule: Vec<(f64, f64)>,
}

impl Gauss {
    /// The rule that is exact up to `degree`.
    pub(crate) fn exact_to(degree: usize) -> Self {
        let n = degree / 2 + 1;
        Self { rule: (0..n).map(|i| node(n, i)).collect() }
    }

    /// `∫ f dx` from `lo` to `hi`.
    pub(super) fn integral(&self, lo: f64, hi: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
        let width = hi - lo;
        self.rule.iter().map(|&(t, w)| w * f(lo + t * width)).sum::<f64>() * width
    }

    /// The points and weights for an integral from `lo` to `hi`.
    pub(crate) fn points(&self, lo: f64, hi: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        let width = hi - lo;
        self.rule.iter().map(move |&(t, w)| (lo + t * width, w * width))
    }
}

/// Node `i` of `n` and its weight: a root of the Legendre polynomial, by Newton's method from Tricomi's estimate.
#[expect(clippy::cast_precision_loss, reason = "a rule has few nodes")]
fn node(n: usize, i: usize) -> (f64, f64) {
    /// Each step doubles the two correct digits of the estimate: 4, 8, 16, and one step more.
    const STEPS: usize = 5;
    let order = n as f64;
    let mut x = -libm::cos(std::f64::consts::PI * (i as f64 + 0.75) / (order + 0.5));
    let mut derivative = 1.0;
    for _ in 0..STEPS {
        let (mut last, mut value) = (1.0, x);
        for k in 2..=n {
            let k = k as f64;
            (last, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k);
        }
        if n == 1 {
            (last, value) = (1.0, x);
        }
        derivative = order * (last - x * value) / ((1.0 - x) * (1.0 + x));
        x -= value / derivative;
    }
    (0.5 * (1.0 + x), 1.0 / ((1.0 - x) * (1.0 + x) * derivative * derivative))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_integrated_exactly() {
        const ROUNDING: f64 = 1e-14;
        for degree in 0..24_u8 {
            let rule = Gauss::exact_to(usize::from(degree));
            for power in 0..=degree {
                let found = rule.integral(0.5, 2.0, |x| libm::pow(x, f64::from(power)));
                let next = f64::from(power) + 1.0;
                let exact = (libm::pow(2.0, next) - libm::pow(0.5, next)) / next;
                assert!((found / exact - 1.0).abs() < ROUNDING, "x^{power} by a rule for {degree}: {found}, {exact}");
            }
        }
    }
}
