//! A chain of symmetric blocks of two, by elimination in which no digit is lost:
//!
//! ```text
//! B y − W x = r₂        (B y)_i = c_i (y_{i+1} − y_i) − c_{i−1} (y_i − y_{i−1}) − η_i y_i
//! B x + Θ y = r₁        Θ ≥ 0 and W positive definite, tridiagonal with σ and ω beside the diagonal
//! ```
//!
//! Written with `h = c + e`, every pivot is a sum of positive numbers but for differences that are small by construction:
//!
//! ```text
//! d = a g + h²,   a' = Θ' + (a c² + 2 c h σ − g σ²)/d,   g' = w' + (g c² + 2 c h ω − a ω²)/d
//! e' = η' + (c (a (g + ω) + h e) + σ (c g + h ω))/d
//! ```

/// Large enough to fix the variable of its row to all digits: a power of two, so that nothing else is rounded.
pub(crate) const PENALTY: f64 = f64::from_bits(0x52b0_0000_0000_0000);

/// A member of the chain.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Block {
    /// What joins it to the next one: nothing behind the last.
    pub(crate) c: f64,
    /// Diagonal entry of `W`.
    pub(crate) w: f64,
    /// Entry of `W` beside the diagonal, to the right: `ω`.
    pub(crate) off: f64,
    /// The same of `Θ`, `σ`, and what `B` has more on its diagonal, `η`: of a beam on springs.
    sigma: f64,
    eta: f64,
    /// Pivot block `[[a, −h], [−h, −g]]` and `1/(a g + h²)`.
    a: f64,
    h: f64,
    g: f64,
    inverse: f64,
    /// The solution, `y` and `x`.
    pub(crate) step: [f64; 2],
}

impl Block {
    /// A member by what joins it to the next one, and its part of `W`.
    pub(crate) fn new(c: f64, w: f64, off: f64) -> Self {
        Self { c, w, off, ..Self::default() }
    }

    /// The same on springs.
    pub(crate) fn on_springs(self, sigma: f64, eta: f64) -> Self {
        Self { sigma, eta, ..self }
    }

    /// Whether its solution is one.
    pub(crate) fn is_finite(&self) -> bool {
        (self.step[0] + self.step[1]).is_finite()
    }

    /// The pivot, if it is no positive number, or if the solution is none.
    pub(crate) fn failed(&self) -> Option<f64> {
        let sound = 0.0 < self.inverse && (self.inverse + self.step[0] + self.step[1]).is_finite();
        (!sound).then_some(self.a)
    }
}

impl AsMut<Self> for Block {
    fn as_mut(&mut self) -> &mut Self {
        self
    }
}

/// Factors the matrix, with `Θ_i` the `ratio` of a row.
#[inline]
pub(crate) fn factor<R: AsMut<Block>>(rows: &mut [R], ratio: impl Fn(&R) -> f64) {
    let (mut a, mut e, mut g) = (0.0, 0.0, 0.0);
    for row in rows {
        let theta = ratio(row);
        let row = row.as_mut();
        row.a = a + theta;
        e += row.eta;
        row.h = row.c + e;
        row.g = g + row.w;
        row.inverse = 1.0 / (row.a * row.g + row.h * row.h);
        let (c, off) = (row.c, row.off);
        let (scaled, sigma) = (c * row.inverse, row.sigma * row.inverse);
        a = c * scaled * row.a + sigma * (2.0 * c * row.h - row.g * row.sigma);
        e = scaled * (row.a * (row.g + off) + row.h * e) + sigma * (c * row.g + row.h * off);
        g = scaled * (c * row.g + 2.0 * row.h * off) - row.a * off * off * row.inverse;
    }
}

/// The same of a beam under an axial force, where `σ = −n` is the stiffness of a string in each link, and `left`, `c² − n ω`, is known
/// without cancellation. With `a = n + b` no digit is lost under tension:
///
/// ```text
/// b' = Θ' + (b (c² + n g) + n e²)/d,   g' = w' + (c² g + ω (c h + c e + c² − n ω) − b ω²)/d
/// e' = (b c (g + ω) + e (c e + c² − n ω))/d
/// ```
pub(crate) fn factor_under_tension<R: AsMut<Block>>(
    rows: &mut [R],
    ratio: impl Fn(&R) -> f64,
    left: impl Fn(&R) -> f64,
) {
    let (mut b, mut e, mut g) = (0.0, 0.0, 0.0);
    for row in rows {
        let (theta, left) = (ratio(row), left(row));
        let row = row.as_mut();
        let (c, off, n) = (row.c, row.off, -row.sigma);
        b += theta;
        row.a = b + n;
        row.h = c + e;
        row.g = g + row.w;
        row.inverse = 1.0 / (row.a * row.g + row.h * row.h);
        let bent = c * e + left;
        let next = (b * (c * c + n * row.g) + n * e * e) * row.inverse;
        g = (c * c * row.g + off * (c * row.h + bent) - b * off * off) * row.inverse;
        e = (b * c * (row.g + off) + e * bent) * row.inverse;
        b = next;
    }
}

/// Solves with these factors for `step`, with `right`, `r₁` and `r₂`, of each row.
#[inline]
pub(crate) fn solve<R: AsMut<Block>>(rows: &mut [R], right: impl Fn(&R) -> [f64; 2]) {
    let mut carry = [0.0; 2];
    for row in rows.iter_mut() {
        let [r1, r2] = right(row);
        let row = row.as_mut();
        let (y1, y2) = (r1 - carry[0], r2 - carry[1]);
        row.step = [(row.g * y1 - row.h * y2) * row.inverse, -(row.h * y1 + row.a * y2) * row.inverse];
        carry = [row.sigma * row.step[0] + row.c * row.step[1], row.c * row.step[0] - row.off * row.step[1]];
    }
    let mut next = [0.0; 2];
    for row in rows.iter_mut().rev() {
        let row = row.as_mut();
        let (y1, y2) = (row.sigma * next[0] + row.c * next[1], row.c * next[0] - row.off * next[1]);
        row.step[0] -= (row.g * y1 - row.h * y2) * row.inverse;
        row.step[1] += (row.h * y1 + row.a * y2) * row.inverse;
        next = row.step;
    }
}
