//! Links under an axial force `N`, with `ν = N/e`. `V` is replaced by `T = M' − N h'`, the vertical force less `N` times the slope from
//! which `h'` is measured. A link is in one cell of the scene. It has the stiffness `n` of a string in addition: `T` is larger by
//! `n (h_a − h_b)` at both ends.
//!
//! ```text
//!                   c       η                         w                        ω        a                            σ   n
//! span              1/ℓ     0                         ℓ s₁/e                   ℓ s₂/e   0                            0   N/ℓ
//! pressed link      G₂/Δ    (G₂ (f₀ − 1) + K G G₁)/Δ  (G₁ G₂ − G G₃)/e Δ       G/e Δ    e (K G₁ G₂ + r (f₀ − 1))/Δ   0   e r/Δ
//! deep in a zone    0       √K/s                      1/e s                    0        e √K (√K + ν)/s              0   0
//! ```
//!
//! with `G'''' = ν G'' − K G`, all of `G` zero at the beginning except `G₃ = 1`, `G_j` its derivatives at the end, `f₀ = G₃ − ν G₁`,
//! `f₁ = G₂ − ν G`, `r = ν G₂ − K G`, `Δ = G₂ f₁ + K G²` and `s² = 2 √K + ν`. Deep in a zone `h = F/K + (ν h'' − h'''')/K`.

use super::answer::second;
use super::links::{Beam, Link, fourth};
use crate::theory::piece::derivatives;
use crate::theory::span::Drive;
use crate::theory::tension::Tense;

/// Number of terms of each series: for a link of at most `1/λ` and `0.8/μ` the next terms are less than `10⁻²⁰`.
const TERMS: usize = 28;

impl Beam<'_> {
    /// A part of the beam without pressure.
    pub(super) fn span_under_tension(&self, i: usize) -> Link {
        let link = &self.links[i];
        let ends = [0, 1].map(|side| link.end(side, 0.0, 0.0));
        let Some(tense) = Tense::of(self.given, &ends, Drive::Load, -1.0) else { return link.clone() };
        let ([c, pull, w, off, _], [turn_a, turn_b]) = (tense.law, self.base_rotations(i));
        let [[a, r, _], [b, s, _]] = tense.own;
        let own = [[a - turn_a, r + tense.force * turn_a], [b + turn_b, s - tense.force * turn_b]];
        Link { c, w, off, pull, own, ..link.clone() }
    }

    /// A part of the beam under pressure of the foundation.
    pub(super) fn pressed_under_tension(&self, link: &Link) -> Link {
        let (l, (k, _)) = (link.hi - link.lo, self.rates(link.cells[0]));
        let e = self.stiffness(link);
        let pull = self.given.tension / e;
        let [g, g1, g2, g3] = derivatives(&series(k, pull, [0.0, 0.0, 0.0, 1.0 / 6.0]), l);
        let mut less = series(k, pull, [1.0, 0.0, 0.0, 0.0]);
        less[0] = 0.0;
        let [[less, ..], [f1, ..]] = [less, series(k, pull, [0.0, 1.0, 0.0, 0.0])].map(|of| derivatives(&of, l));
        let (inverse, rises) = (1.0 / (g2 * f1 + k * g * g), pull * g2 - k * g);
        // The beam that begins with depth and slope of the foundation, without moment and vertical force.
        let [h, v] = self.taylor(link, [0.0; 4]);
        let ([h, h1, ..], [_, _, m, n]) = (derivatives(&h, l), derivatives(&v, l));
        let (turn, shear) = (-(g2 * h + g * m) * inverse, (g2 * m + rises * h) * inverse);
        let far = [g3 * turn + g1 * shear + h1, (1.0 + less) * shear - k * g1 * turn - n - pull * h1];
        Link {
            c: g2 * inverse,
            eta: (g2 * less + k * g * g1) * inverse,
            w: (g1 * g2 - g * g3) * inverse / e,
            off: g * inverse / e,
            a: e * ((k * g1 * g2 + rises * less) * inverse),
            pull: e * (rises * inverse),
            own: [[turn, e * shear], [far[0], e * far[1]]],
            ..link.clone()
        }
    }

    /// `η`, `w` and `a` deep in a zone, from `ν`, `λ` and `e`.
    pub(super) fn deep_under_tension(pull: f64, decay: f64, e: f64) -> (f64, f64, f64) {
        let (root, s) = (2.0 * decay * decay, (4.0 * decay * decay + pull).sqrt());
        (root / s, 1.0 / s / e, e * (root * (root + pull) / s))
    }

    /// Converts `h, h', M, V` to `h, h', M, T`.
    pub(super) fn vertical(&self, [h, h1, m, v]: [f64; 4]) -> [f64; 4] {
        if self.given.tension == 0.0 { [h, h1, m, v] } else { [h, h1, m, v - self.given.tension * h1] }
    }

    /// Converts `h, h', M, T` to `h, h', M, V`.
    pub(super) fn sheared(&self, [h, h1, m, t]: [f64; 4]) -> [f64; 4] {
        if self.given.tension == 0.0 { [h, h1, m, t] } else { [h, h1, m, t + self.given.tension * h1] }
    }
}

/// Taylor coefficients of `y'''' = ν y'' − K y` from the first four.
#[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
fn series(k: f64, pull: f64, first: [f64; 4]) -> [f64; TERMS] {
    let mut taylor = [0.0; TERMS];
    taylor[..4].copy_from_slice(&first);
    for n in 0..TERMS - 4 {
        let bent = ((n + 1) * (n + 2)) as f64;
        taylor[n + 4] = (pull * bent * taylor[n + 2] - k * taylor[n]) / (bent * ((n + 3) * (n + 4)) as f64);
    }
    taylor
}

/// The particular `h` deep in a zone, from `g'''' − q/e`, the profile, `ν` and `K`.
pub(super) fn following_under_tension(mut drive: Vec<f64>, profile: &[f64], [pull, springs]: [f64; 2]) -> Vec<f64> {
    let mut clear = vec![0.0; drive.len()];
    drive.iter_mut().zip(second(profile)).for_each(|(sum, c)| *sum -= pull * c);
    while !drive.is_empty() {
        clear.iter_mut().zip(&drive).for_each(|(sum, c)| *sum += c / springs);
        let mut next = second(&drive);
        next.iter_mut().for_each(|c| *c *= pull / springs);
        next.iter_mut().zip(fourth(&drive)).for_each(|(sum, c)| *sum -= c / springs);
        drive = next;
    }
    clear
}
