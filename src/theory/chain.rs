//! A first idea of where the beam touches: a chain of stiff links with elastic hinges above the sampled profile.
//!
//! The chain (Hencky's) has links of length `Δ_i` and at each hinge the curvature `κ_i = (v_{i+1} − v_i)/Δ_i − (v_i −
//! v_{i−1})/Δ_{i−1}`, energy `½ κ_i²/Δ̂_i` with the mean `Δ̂_i` of the two links. Unlike beams between samples it does not
//! share the force at a lift-off point with its neighbours, so its contacts are runs of samples without holes. With the
//! clearance `s = u − v ≥ 0` and the contact forces `p ≥ 0`, `K s − p = K u − f` and `s p = 0`; Mehrotra's predictor–corrector
//! method solves it in a dozen pentadiagonal systems and never cycles. What comes out is a guess and is treated as one.

/// Symmetric pentadiagonal matrix: diagonal and the two bands beside it.
struct Penta {
    main: Vec<f64>,
    first: Vec<f64>,
    second: Vec<f64>,
}

/// The chain: sample places with both supports, and depth and load at the samples between them.
#[derive(Debug)]
pub(super) struct Chain<'a> {
    /// Places `x_0 … x_{n+1}`.
    pub(super) x: &'a [f64],
    /// Depths `u_1 … u_n`.
    pub(super) depth: &'a [f64],
    /// Loads `f_1 … f_n`.
    pub(super) load: &'a [f64],
}

/// Clearances and contact forces of the chain.
#[derive(Debug)]
pub(super) struct Guess {
    /// `s_1 … s_n`, in units of its scale.
    pub(super) clearance: Vec<f64>,
    /// `p_1 … p_n`, in units of its scale.
    pub(super) force: Vec<f64>,
}

impl Guess {
    /// True if sample `i` is more in contact than not, and not by a force that is rounding.
    pub(super) fn touches(&self, i: usize) -> bool {
        /// Of the mean force of a sample.
        const ROUNDING: f64 = 1e-5;
        self.clearance[i] < self.force[i] && ROUNDING < self.force[i]
    }
}

/// Steps of the predictor–corrector method; a dozen or two is what it takes.
const STEPS: usize = 40;
/// Complementarity at which contact and lift-off are told apart by many powers of ten.
const ENOUGH: f64 = 1e-15;

impl Chain<'_> {
    /// Solves the chain.
    pub(super) fn solve(&self) -> Guess {
        let n = self.depth.len();
        let stiffness = self.stiffness();
        let mut free = self.load.to_vec();
        stiffness.factored(&vec![0.0; n]).solve(&mut free);
        let (length, count) = (self.x[n + 1] - self.x[0], as_float(n));
        let reach = self.depth.iter().zip(&free).fold(0.0_f64, |most, (u, v)| most.max((u - v).abs()));
        let unit_clearance = if 0.0 < reach { reach } else { 1.0 };
        let total: f64 = self.load.iter().map(|f| f.abs()).sum();
        let unit_force = total.max(48.0 * unit_clearance / (length * length * length)) / count;

        let mut s: Vec<f64> = (0..n).map(|i| (self.depth[i] - free[i]).max(0.1 * unit_clearance)).collect();
        let mut p = vec![unit_force; n];
        let mut right = stiffness.times(self.depth);
        right.iter_mut().zip(self.load).for_each(|(b, f)| *b -= f);

        let complementarity = |s: &[f64], p: &[f64]| s.iter().zip(p).map(|(s, p)| s * p).sum::<f64>() / count;
        for _ in 0..STEPS {
            let mu = complementarity(&s, &p);
            let product = stiffness.times(&s);
            let rest: Vec<f64> = (0..n).map(|i| right[i] + p[i] - product[i]).collect();
            let off = rest.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
            if mu <= ENOUGH * unit_clearance * unit_force && off <= 1e-6 * unit_force {
                break;
            }
            let ratio: Vec<f64> = p.iter().zip(&s).map(|(p, s)| p / s).collect();
            let factored = stiffness.factored(&ratio);
            let mut ds: Vec<f64> = (0..n).map(|i| rest[i] - p[i]).collect();
            factored.solve(&mut ds);
            let mut dp: Vec<f64> = (0..n).map(|i| -p[i] - ratio[i] * ds[i]).collect();
            let step = longest(&s, &ds).min(longest(&p, &dp));
            let ahead: f64 = (0..n).map(|i| (s[i] + step * ds[i]) * (p[i] + step * dp[i])).sum::<f64>() / count;
            let sigma = (ahead / mu) * (ahead / mu) * (ahead / mu);
            let aim: Vec<f64> = (0..n).map(|i| (sigma * mu - ds[i] * dp[i]) / s[i]).collect();
            ds = (0..n).map(|i| rest[i] - p[i] + aim[i]).collect();
            factored.solve(&mut ds);
            dp = (0..n).map(|i| aim[i] - p[i] - ratio[i] * ds[i]).collect();
            // Short of the border, where the next system would be singular.
            let step = 0.995 * longest(&s, &ds).min(longest(&p, &dp));
            if !step.is_finite() || ds.iter().chain(&dp).any(|d| !d.is_finite()) {
                break;
            }
            s.iter_mut().zip(&ds).for_each(|(s, d)| *s += step * d);
            p.iter_mut().zip(&dp).for_each(|(p, d)| *p += step * d);
        }
        s.iter_mut().for_each(|s| *s /= unit_clearance);
        p.iter_mut().for_each(|p| *p /= unit_force);
        Guess { clearance: s, force: p }
    }

    /// `K = Σ κ_i κ_iᵀ / Δ̂_i` for `EI = 1`.
    fn stiffness(&self) -> Penta {
        let n = self.depth.len();
        let mut k = Penta { main: vec![0.0; n], first: vec![0.0; n], second: vec![0.0; n] };
        for i in 0..n {
            let (left, right) = (self.x[i + 1] - self.x[i], self.x[i + 2] - self.x[i + 1]);
            let weight = 2.0 / (left + right);
            let (a, c) = (1.0 / left, 1.0 / right);
            let b = -a - c;
            k.main[i] += weight * b * b;
            if 0 < i {
                k.main[i - 1] += weight * a * a;
                k.first[i - 1] += weight * a * b;
            }
            if i + 1 < n {
                k.main[i + 1] += weight * c * c;
                k.first[i] += weight * b * c;
            }
            if 0 < i && i + 1 < n {
                k.second[i - 1] += weight * a * c;
            }
        }
        k
    }
}

impl Penta {
    /// `A x`.
    fn times(&self, x: &[f64]) -> Vec<f64> {
        let n = x.len();
        let mut y: Vec<f64> = (0..n).map(|i| self.main[i] * x[i]).collect();
        for i in 0..n.saturating_sub(1) {
            y[i] += self.first[i] * x[i + 1];
            y[i + 1] += self.first[i] * x[i];
        }
        for i in 0..n.saturating_sub(2) {
            y[i] += self.second[i] * x[i + 2];
            y[i + 2] += self.second[i] * x[i];
        }
        y
    }

    /// `L D Lᵀ` of this matrix with `extra` added to its diagonal; the factors in the same three bands, `1/D` in the main one.
    fn factored(&self, extra: &[f64]) -> Self {
        let n = self.main.len();
        let mut f = Self { main: vec![0.0; n], first: vec![0.0; n], second: vec![0.0; n] };
        // Entry and factor in the row above, and in the row two above, of what stands left of the pivot.
        let (mut one_above, mut above) = (0.0, 0.0);
        let (mut two_above, mut far, mut next_two, mut next_far) = (0.0, 0.0, 0.0, 0.0);
        for (i, extra) in extra.iter().enumerate() {
            let mut d = self.main[i] + extra;
            let mut e = self.first[i];
            // Products of a factor with the pivot above it: the entries that were eliminated.
            d -= one_above * above;
            e -= one_above * f.second[i.saturating_sub(1)];
            d -= two_above * far;
            let inverse = 1.0 / d;
            f.main[i] = inverse;
            f.first[i] = e * inverse;
            f.second[i] = self.second[i] * inverse;
            (two_above, far) = (next_two, next_far);
            (next_two, next_far) = (self.second[i], f.second[i]);
            (one_above, above) = (e, f.first[i]);
        }
        f
    }

    /// Solves with these factors, in place.
    fn solve(&self, x: &mut [f64]) {
        let n = x.len();
        for i in 0..n {
            if 0 < i {
                x[i] -= self.first[i - 1] * x[i - 1];
            }
            if 1 < i {
                x[i] -= self.second[i - 2] * x[i - 2];
            }
        }
        for i in (0..n).rev() {
            x[i] *= self.main[i];
            if i + 1 < n {
                x[i] -= self.first[i] * x[i + 1];
            }
            if i + 2 < n {
                x[i] -= self.second[i] * x[i + 2];
            }
        }
    }
}

/// The longest step, at most 1, that keeps `x + step d` from becoming negative.
fn longest(x: &[f64], d: &[f64]) -> f64 {
    x.iter().zip(d).filter(|(_, d)| **d < 0.0).fold(1.0, |most: f64, (x, d)| most.min(-x / d))
}

#[expect(clippy::cast_precision_loss, reason = "samples are counted in hundreds")]
fn as_float(n: usize) -> f64 {
    n as f64
}
