//! Polynomials with interval coefficients, each on a cell with its own origin.

use super::interval::Interval;

/// Number of coefficients; with this number the Taylor remainder of a cosine over a thirty-second of a wave has the size of rounding.
pub(crate) const TERMS: usize = 11;
/// Number of possibly negative parts examined before the remaining ones are accepted as negative without further halving.
const MOST_PARTS: usize = 400;

/// `Σ c_j s^j` for `0 ≤ s ≤` the width of its cell. The coefficients enclose the coefficients of a true polynomial. The last one may
/// instead, as the remainder of Taylor's formula, enclose a value for every `s`. Sums, products with numbers, derivatives and integrals
/// remain enclosures.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Polynomial {
    coefficients: [Interval; TERMS],
    terms: usize,
}

impl Polynomial {
    pub(crate) const ZERO: Self = Self { coefficients: [Interval::ZERO; TERMS], terms: 0 };

    /// The polynomial with the coefficients `c_0, c_1, …`, at most [`TERMS`] of them.
    pub(crate) fn new(given: &[Interval]) -> Self {
        Self::of(given.iter().copied())
    }

    /// The same from an iterator.
    pub(crate) fn of(given: impl Iterator<Item = Interval>) -> Self {
        let mut polynomial = Self::ZERO;
        for (c, given) in polynomial.coefficients.iter_mut().zip(given) {
            *c = given;
            polynomial.terms += 1;
        }
        polynomial
    }

    pub(crate) fn coefficients(&self) -> &[Interval] {
        &self.coefficients[..self.terms]
    }

    pub(crate) fn at(&self, s: Interval) -> Interval {
        let mut terms = self.coefficients().iter().rev();
        let first = terms.next().copied().unwrap_or(Interval::ZERO);
        terms.fold(first, |sum, &c| sum * s + c)
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        // The coefficients beyond `terms` are zero.
        Self::of((0..self.terms.max(other.terms)).map(|j| self.coefficients[j] + other.coefficients[j]))
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self::of((0..self.terms.max(other.terms)).map(|j| self.coefficients[j] - other.coefficients[j]))
    }

    pub(crate) fn times(&self, factor: Interval) -> Self {
        Self::of(self.coefficients().iter().map(|c| *c * factor))
    }

    pub(crate) fn derivative(&self) -> Self {
        Self::of((1..self.terms).map(|j| self.coefficients[j] * number(j)))
    }

    /// `∫₀^s`; the last coefficient must be unused.
    pub(crate) fn integral(&self) -> Self {
        let terms = (0..self.terms).map(|j| self.coefficients[j] / number(j + 1));
        Self::of(std::iter::once(Interval::ZERO).chain(terms))
    }

    /// The same polynomial, with its first coefficients narrowed by other enclosures of them.
    pub(crate) fn known(mut self, first: &[Interval]) -> Self {
        self.coefficients[..self.terms].iter_mut().zip(first).for_each(|(c, known)| *c = c.meet(*known));
        self
    }

    /// The mirror image about its origin.
    pub(crate) fn mirrored(mut self) -> Self {
        self.coefficients[..self.terms].iter_mut().skip(1).step_by(2).for_each(|c| *c = -*c);
        self
    }

    /// The approximate width of its values for `0 ≤ s ≤ w` caused by the width of its coefficients.
    pub(crate) fn uncertainty(&self, width: f64) -> f64 {
        self.coefficients().iter().rev().fold(0.0, |sum, c| sum * width + (c.hi() - c.lo()))
    }

    /// The quotient by `s^order`, for a polynomial whose lower coefficients are known to vanish.
    pub(crate) fn divided(&self, order: usize) -> Self {
        Self::new(self.coefficients().get(order..).unwrap_or_default())
    }

    /// The same polynomial with its origin moved to `s`.
    pub(crate) fn shifted(&self, s: Interval) -> Self {
        let mut shifted = *self;
        for start in 0..self.terms {
            for j in (start..self.terms - 1).rev() {
                shifted.coefficients[j] = shifted.coefficients[j] + shifted.coefficients[j + 1] * s;
            }
        }
        shifted
    }

    /// The polynomial in `s` that results from replacing `s` by `k s`.
    pub(crate) fn scaled(&self, k: Interval) -> Self {
        let powers = std::iter::successors(Some(Interval::exact(1.0)), |power| Some(*power * k));
        Self::of(self.coefficients().iter().zip(powers).map(|(c, power)| *c * power))
    }

    /// `∫₀^w f g`.
    pub(crate) fn integral_of_product(&self, other: &Self, width: Interval) -> Interval {
        let (f, g) = (self.coefficients(), other.coefficients());
        let mut sum = Interval::ZERO;
        for order in (0..(f.len() + g.len()).saturating_sub(1)).rev() {
            let from = (order + 1).saturating_sub(g.len());
            let c = (from..f.len().min(order + 1)).fold(Interval::ZERO, |c, j| c + f[j] * g[order - j]);
            sum = sum * width + c / number(order + 1);
        }
        sum * width
    }

    /// An enclosure of all values for `0 ≤ s ≤ w`, between the least and the greatest Bernstein coefficient,
    /// `b_i = Σ_{j ≤ i} C(i, j) / C(d, j) c_j w^j`.
    pub(crate) fn range(&self, width: Interval) -> Interval {
        let Some(degree) = self.terms.checked_sub(1) else { return Interval::ZERO };
        // w^j c_j / C(d, j), then sums as in Pascal's triangle.
        let mut row = self.scaled(width).coefficients;
        for (j, c) in row[..self.terms].iter_mut().enumerate() {
            *c = *c / binomial(degree, j);
        }
        let mut range = row[0];
        for left in (1..=degree).rev() {
            // Forward: row[j] ← row[j] + row[j + 1]; after i rounds row[0] = Σ C(i, j) c_j / C(d, j).
            for j in 0..left {
                row[j] = row[j] + row[j + 1];
            }
            range = range.hull(row[0]);
        }
        range
    }

    /// Calls `take`, from left to right, for the parts of `0 ≤ s ≤ w` on which the polynomial may be negative. The arguments are the
    /// largest possible magnitude there; the start and the width of the part; whether halving would not improve the bound; and whether
    /// the part has to be accepted. If `take` returns false, the part is halved.
    pub(crate) fn negative(&self, width: Interval, mut take: impl FnMut(f64, [Interval; 2], [bool; 2]) -> bool) {
        let (mut looks, mut parts, mut next) = (0, Vec::new(), Some((*self, Interval::ZERO, width)));
        while let Some((part, start, width)) = next {
            let range = part.range(width);
            let is_settled = range.hi() <= 0.0 || -range.lo() <= 4.0 * part.uncertainty(width.hi());
            looks += usize::from(range.lo() < 0.0);
            if range.lo() < 0.0 && !take(-range.lo(), [start, width], [is_settled, MOST_PARTS <= looks]) {
                // The halves use the upper bound of the width, so they overlap by rounding and leave no part out.
                let half = Interval::exact(0.5 * width.hi());
                parts.extend([(part.shifted(half), start + half, half), (part, start, half)]);
            }
            next = parts.pop();
        }
    }
}

/// The Taylor coefficients about `x` of the polynomial with these coefficients in powers of the position. Each coefficient is carried as
/// a number and an interval that contains its error, so that the final error has the size of a squared rounding error.
pub(crate) fn expanded(given: &[f64], x: f64) -> Vec<Interval> {
    let mut taylor: Vec<(f64, Interval)> = given.iter().map(|&c| (c, Interval::ZERO)).collect();
    for start in 0..taylor.len() {
        for j in (start..taylor.len() - 1).rev() {
            taylor[j] = carried(taylor[j + 1], x, taylor[j]);
        }
    }
    taylor.into_iter().map(|(c, off)| Interval::exact(c) + off).collect()
}

/// `a x + b`, rounded, with its error. The error is unbounded if the sum overflows, because the rest is then not a number.
fn carried((a, a_off): (f64, Interval), x: f64, (b, b_off): (f64, Interval)) -> (f64, Interval) {
    let product = a * x;
    let sum = product + b;
    // The rounding error of the product is a floating-point number, unless it is below the normal range. The rounding error of a sum
    // always is one (Knuth).
    let lost = libm::fma(a, x, -product);
    let part = sum - product;
    let rest = (product - (sum - part)) + (b - part);
    let exact = Interval::exact(a) * Interval::exact(x) - Interval::exact(product);
    let lost = exact.meet(Interval::between(lost.next_down(), lost.next_up()));
    (sum, a_off * Interval::exact(x) + b_off + lost + Interval::exact(rest))
}

/// A small integer.
#[expect(clippy::cast_precision_loss, reason = "at most a few dozen")]
pub(crate) fn number(value: usize) -> Interval {
    Interval::exact(value as f64)
}

fn binomial(n: usize, k: usize) -> Interval {
    let value = (0..k).fold(1, |product: usize, j| product * (n - j) / (j + 1));
    number(value)
}
