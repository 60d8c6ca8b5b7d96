//! A part of the beam under an axial force `N`, over `EI₀`: the relations at its ends, and the beam between them.
//!
//! ```text
//! e v'''' − N v'' = q,     e h'''' − N h'' = e g'''' − N g'' − q           the clearance has the same law
//! T = e h''' − N h'                                                       minus the vertical force; it jumps by loads
//! h'_a = (h_b − h_a)/ℓ − w n_a − ω n_b + E_a,      T_a = (n_b − n_a)/ℓ − N (h_b − h_a)/ℓ − F_a        n = e h''
//! e h'''_a = (n_b − n_a)/ℓ − N (w n_a + ω n_b) − F_a + N E_a
//! ```
//!
//! with `w = ℓ s₁/e` and `ω = ℓ s₂/e` of [`crate::scene::axial`], and the effects of the load `f` alone, `E_a = ∫ f (ℓ²/e) β dx` and
//! `F_a = ∫ f r/ℓ dx`. Every cell of a scene under an axial force is a part and at most [`LONGEST`](axial::LONGEST)`/μ` long,
//! `μ² = N/e`. There a beam of hyperbolic functions is a polynomial to rounding, and so are the integrands.

use super::exact::Exact;
use super::piece::Piece;
use super::piecewise::PiecewiseScene;
use super::shape::shifted;
use super::span::{Drive, End};
use crate::certificate::{Hung, MOST_TERMS};
use crate::scene::axial;

/// Number of Taylor coefficients of a beam in a cell, from one end to the middle: `0.4¹⁶/16!` is less than `10⁻¹⁹`.
pub(super) const TERMS: usize = 18;

/// The law of a part under an axial force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tense {
    /// `N`.
    pub(super) force: f64,
    /// `1/ℓ`, `N/ℓ`, `w`, `ω` and `1/ℓ² − ω N/ℓ`.
    pub(super) law: [f64; 5],
    /// The effect of the load on `h'`, `T` and `e h'''` at both ends.
    pub(super) own: [[f64; 3]; 2],
}

impl Tense {
    /// The law of a part between two ends, under `sign` times its drive; [`None`] without an axial force.
    pub(super) fn of(given: &PiecewiseScene, [a, b]: &[End; 2], of: Drive, sign: f64) -> Option<Self> {
        let force = given.tension;
        (force != 0.0).then_some(())?;
        let (l, e) = (b.x - a.x, given.cells[a.cell].stiffness);
        let z = force * l * l / e;
        let (mut turns, mut shears) = ([0.0; 2], [0.0; 2]);
        for (t, weight) in given.load_rule.points(0.0, l) {
            let shares = [t / l, (l - t) / l];
            let drive = match of {
                Drive::Load => given.load_beyond(a.cell, a.x, t),
                Drive::Clearance => given.drive(a.cell, a.x + t),
            };
            let acts = sign * weight * drive;
            turns[0] += acts * axial::bow(z, shares) * l * l / e;
            turns[1] -= acts * axial::bow(z, [shares[1], shares[0]]) * l * l / e;
            shears[0] -= acts * shares[1];
            shears[1] += acts * shares[0];
        }
        let own = [0, 1].map(|i| [turns[i], shears[i], shears[i] + force * turns[i]]);
        Some(Self { force, law: axial::law(l, e, force), own })
    }

    /// `h'`, `T` and `e h'''` at both ends, from `h` and `n` there, including the load.
    pub(super) fn ends(&self, [h, k]: [f64; 2], [n, m]: [f64; 2]) -> [[f64; 3]; 2] {
        let [c, pull, w, off, _] = self.law;
        let (chord, rise) = (c * (k - h), c * (m - n) - pull * (k - h));
        let [bent_a, bent_b] = [w * n + off * m, off * n + w * m];
        let third = |bent: f64| c * (m - n) + self.force * bent;
        let [a, b] = self.own;
        [
            [chord - bent_a + a[0], rise + a[1], third(-bent_a) + a[2]],
            [chord + bent_b + b[0], rise + b[1], third(bent_b) + b[2]],
        ]
    }
}

impl Piece {
    /// The deflection of the piece, from its coefficients about the anchor, with only as many coefficients as needed.
    pub(super) fn hung(&self, taylor: &[f64]) -> Hung {
        let mut few = vec![0.0; MOST_TERMS.min(taylor.len())];
        shifted(taylor, 0.5 * (self.lo + self.hi) - self.anchor, &mut few);
        let mut deflection = vec![0.0; few.len()];
        shifted(&few, -0.5 * self.width(), &mut deflection);
        Hung { from: self.lo, to: self.hi, deflection }
    }
}

impl Exact {
    /// The deflection between contacts under an axial force, in the units of [`Scene::scaled`](crate::scene::Scene::scaled); a
    /// certificate is proven from it. About its middle a piece of half a cell needs few terms: `0.2¹¹/11!` is `5·10⁻¹⁶`.
    pub(crate) fn hung(&self) -> Vec<Hung> {
        if self.given.tension == 0.0 {
            return Vec::new();
        }
        if let Some(springs) = &self.springs {
            return springs.hanging().map(|part| part.piece.hung(&part.deflection)).collect();
        }
        let mut taylor = vec![0.0; self.given.terms];
        let of = |piece: &Piece| {
            piece.deflection(&self.given, &mut taylor);
            piece.hung(&taylor)
        };
        self.pieces.iter().filter(|piece| piece.state.is_some()).map(of).collect()
    }
}

/// Continues the Taylor coefficients of a deflection in a cell beyond the first four, from `q` and `q'` at its origin.
///
/// ```text
/// e (k + 4)(k + 3)(k + 2)(k + 1) c_{k+4} = q_k + N (k + 2)(k + 1) c_{k+2}
/// ```
#[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
pub(super) fn continued(taylor: &mut [f64], [load, slope]: [f64; 2], stiffness: f64, tension: f64) {
    for k in 0..taylor.len().saturating_sub(4) {
        let j = k as f64;
        let (pair, load) = ((j + 2.0) * (j + 1.0), [load, slope].get(k).copied().unwrap_or(0.0));
        taylor[k + 4] = (load / pair + tension * taylor[k + 2]) / ((j + 4.0) * (j + 3.0) * stiffness);
    }
}
