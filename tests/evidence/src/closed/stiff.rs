//! Level ground that gives below a simple beam under a uniform load, with a zone so long that its two ends do not feel each other.
//!
//! ```text
//! λ⁴ = k/4EI,   a⁴ = 24 EI u/q of rigid ground
//!
//! on the zone, at t = λ (x − s) from lift-off   p = q (1 − e^{−t} (cos t − λs sin t)),  which decays to q
//! moment and shear at s                         R s − q s²/2 = (q s/2)/λ,   R − q s = −(q/2)(s − 1/λ)
//!                                               so R = q σ/2  with  σ = s + 1/λ
//! deflection and slope at s                     σ⁴ + 2 σ/λ³ − 3/λ⁴ = a⁴
//! ```
//!
//! so that `R` differs from that of rigid ground by `−q/(4 a² λ³)` in the first order, and lift-off by `−1/λ`. All of it holds while
//! the pressure is nowhere negative: beyond, the beam lifts off behind a strip ([`gap_opens`]).

use super::bisected;

/// What the closed form says.
#[derive(Debug, Clone, Copy)]
pub struct Stiff {
    /// `λ`.
    pub decay: f64,
    /// The end reaction \[force\].
    pub reaction: f64,
    /// Where the beam lifts off, from the nearer support.
    pub lift_off: f64,
    /// The largest pressure, and its place.
    pub pressure: f64,
    /// Its place.
    pub at: f64,
}

/// For a bending stiffness, a depth, a load and a stiffness of the ground.
#[must_use]
pub fn stiff(ei: f64, depth: f64, load: f64, ground: f64) -> Stiff {
    let (rigid, decay) = (24.0 * ei * depth / load, (0.25 * ground / ei).sqrt().sqrt());
    let cube = decay * decay * decay;
    let most = rigid.sqrt().sqrt() + 3.0 / decay;
    let span = bisected(0.0, most, |s| s * s * s * s + 2.0 * s / cube - 3.0 / (cube * decay) - rigid);
    let lift_off = span - 1.0 / decay;
    let lever = decay * lift_off;
    // p' = 0: tan t = (λs + 1)/(λs − 1).
    let t = libm::atan2(lever + 1.0, lever - 1.0);
    let pressure = load * pressed(lever, t);
    Stiff { decay, reaction: 0.5 * load * span, lift_off, pressure, at: lift_off + t / decay }
}

/// `p/q` at `t` for `λs`.
fn pressed(lever: f64, t: f64) -> f64 {
    1.0 - libm::exp(-t) * (libm::cos(t) - lever * libm::sin(t))
}

/// From this `λa` on the least pressure, half a wave behind the largest, would be negative, and a gap opens; `λs` there is the root of
/// that, about `√2 e^{5π/4}`.
#[must_use]
pub fn gap_opens() -> f64 {
    let least = |lever: f64| pressed(lever, std::f64::consts::PI + libm::atan2(lever + 1.0, lever - 1.0));
    let lever = bisected(2.0, 1e3, |lever| -least(lever));
    let span = lever + 1.0;
    (span * span * span * span + 2.0 * span - 3.0).sqrt().sqrt()
}

/// The strip that is left of the concentrated force `F` of rigid ground, without weight and free behind: with `t` from its end
/// `w = A (sin t cosh t + cos t sinh t)`, zero again where `tan t = −tanh t`. Behind it the beam rises by `2λA` and lies down after the gap
/// `g` without slope and moment: `q g³/24EI = 2λA`, `F = 4EIλ³ A sin t sinh t`.
#[derive(Debug, Clone, Copy)]
pub struct Strip {
    /// Its length times `λ`.
    pub length: f64,
    /// `g (λ²/a)^{1/3}`.
    pub gap: f64,
}

/// See [`Strip`]; all of it is the limit of ever stiffer ground.
#[must_use]
pub fn strip() -> Strip {
    let length = bisected(2.0, 3.0, |t| libm::tan(t) + libm::tanh(t));
    let carried = libm::sin(length) * libm::sinh(length);
    Strip { length, gap: libm::cbrt(6.0 / carried) }
}
