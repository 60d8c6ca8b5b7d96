//! Level rigid ground below a simple beam that gives in shear as well: the concentrated force at lift-off is the resultant of a layer of
//! pressure.
//!
//! ```text
//! v' = θ + V/GA,   θ' = −M/EI,   M' = V,   V' = p − q,   s² = EI/GA
//!
//! free part, 0 ≤ x ≤ a   M = T x − q x²/2;   at lift-off v = u and v' = 0, which is   EI u = T a³/3 − q a⁴/8 + s² q a²/2
//! contact                v'' = 0, so M − s² M'' = 0 and p = q + M/s²
//! symmetry               M = M_a cosh((l/2 − x)/s)/cosh((l/2 − a)/s), and V is continuous:   s (T − q a) + (T a − q a²/2) tanh((l/2 − a)/s) = 0
//! ```
//!
//! A point force `R` at lift-off would turn the axis by `R/GA` into the ground. So `v`, `v'`, `M` and `V` are continuous there, and the
//! layer carries `∫(p − q) = −V(a) = q a − T` on each side. In a zone whose ends do not feel each other, `σ = a + s` is the root of
//!
//! ```text
//! σ⁴ + 2 σ² s² − 4 σ s³ − 3 s⁴ + 4 s⁵/σ = a₀⁴,   T = q σ/2 − q s²/2σ,   a₀⁴ = 24 EI u/q
//! ```
//!
//! so that `a = a₀ − s − s²/2a₀ + O(s³)` and `T = T₀ (1 − 3 s²/2a₀² + O(s³))`.

use super::bisected;

/// The example of the paper, or one like it, with a beam that gives in shear.
#[derive(Debug, Clone, Copy)]
pub struct Sheared {
    /// Half of the length \[length\].
    half: f64,
    /// The load \[force / length\].
    load: f64,
    /// `s = √(EI/GA)` \[length\].
    pub width: f64,
    /// `a`, where the beam lifts off \[length\].
    pub lift_off: f64,
    /// `T`, the force of an end support \[force\].
    pub reaction: f64,
}

/// For a length, a bending stiffness, a depth, a load and `s`, of a beam that lies on the ground around its middle.
#[must_use]
pub fn sheared(length: f64, ei: f64, depth: f64, load: f64, width: f64) -> Sheared {
    /// Lift-off is farther from the support than this part of the length.
    const LEAST: f64 = 1e-6;
    let half = 0.5 * length;
    let reaction = |a: f64| {
        let layer = 0.5 * width * width * load / a;
        3.0 * (ei * depth / (a * a * a) + load * a / 8.0 - layer)
    };
    let excess = |a: f64| {
        let t = reaction(a);
        (load * a - t) * width - (t - 0.5 * load * a) * a * libm::tanh((half - a) / width)
    };
    let lift_off = bisected(LEAST * length, half, excess);
    Sheared { half, load, width, lift_off, reaction: reaction(lift_off) }
}

impl Sheared {
    /// `∫(p − q)` over half of the zone, the concentrated force of a beam that is rigid in shear \[force\].
    #[must_use]
    pub fn layer(&self) -> f64 {
        self.load * self.lift_off - self.reaction
    }

    /// `M` at lift-off \[force · length\].
    #[must_use]
    pub fn moment(&self) -> f64 {
        (self.reaction - 0.5 * self.load * self.lift_off) * self.lift_off
    }

    /// `p` at a place from the left support to mid-span \[force / length\].
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        if x < self.lift_off {
            return 0.0;
        }
        // cosh((l/2 − x)/s) / cosh((l/2 − a)/s), without large numbers.
        let [at, most] = [x, self.lift_off].map(|x| libm::exp(-2.0 * (self.half - x) / self.width));
        let decay = libm::exp((self.lift_off - x) / self.width) * (1.0 + at) / (1.0 + most);
        self.load + self.moment() * decay / (self.width * self.width)
    }

    /// `∫p` from the left support to a place up to mid-span \[force\].
    #[must_use]
    pub fn force_up_to(&self, x: f64) -> f64 {
        if x < self.lift_off {
            return 0.0;
        }
        // V(x) = V(a) sinh((l/2 − x)/s)/sinh((l/2 − a)/s), and V = T − q x + ∫p.
        let [at, most] = [x, self.lift_off].map(|x| libm::exp(-2.0 * (self.half - x) / self.width));
        let decay = libm::exp((self.lift_off - x) / self.width) * (1.0 - at) / (1.0 - most);
        self.load * x - self.reaction - self.layer() * decay
    }
}

/// The discontinuity `D` of `M + EI g''` that lifts a beam which gives in shear off a long zone, over the pressure \[length²\].
///
/// `D` is a couple, or `|ΔEI g''|` at a change of EI of a beam with one `GA`; `widths` are the `s` of the side that lifts and of the other
/// one. With `M = −EI g'' + A e^{ξ/s₁}` before it and `−EI g'' + B e^{−ξ/s₂}` behind it, `M` (but for a couple) and `V` are continuous if
/// `|A| = D s₁/(s₁ + s₂)` and `|B| = D s₂/(s₁ + s₂)`, of opposite signs, and `p = p̄ + A/s₁²`, `p̄ + B/s₂²` there.
/// One of them is negative beyond `D = s (s₁ + s₂) p̄`, with `s` of that side; for a couple, `D = 2 s² p̄`.
#[must_use]
pub fn lifting_discontinuity(widths: [f64; 2]) -> f64 {
    widths[0] * (widths[0] + widths[1])
}
