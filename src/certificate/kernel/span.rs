//! A part of the beam that hangs free between two nodes: the exact beam under the true load, given deflection and slope
//! at both ends. At a free end of the beam nothing is given, and moment and shear force vanish beyond it.
//!
//! ```text
//! v = v₀ + θ₀ s + κ₀ s²/2 + τ₀ s³/6 + v_q,     EI v_q'''' = q,  v_q = v_q' = v_q'' = v_q''' = 0 at s = 0
//! κ₀ =  6 (Δv − θ₀ L)/L² − 2 Δθ/L,    τ₀ = −12 (Δv − θ₀ L)/L³ + 6 Δθ/L²,    Δv = v₁ − v_q(L) − v₀,  Δθ = θ₁ − v_q'(L) − θ₀
//! free on the left    κ₀ = 0,  τ₀ = P/EI                              with a point load P at the free end
//! free on the right   κ₀ = −v_q''(L) − τ₀ L,  τ₀ = −v_q'''(L) − P/EI
//! ```

use super::interval::Interval;
use super::load::{EnclosedLoad, cells};
use super::polynomial::{Polynomial, number};

/// `v, v', v'', v'''` at a place.
pub(crate) type Jet = [Interval; 4];

/// The deflection between two places, about each of them.
pub(crate) type Curve = ([f64; 2], [Polynomial; 2]);

/// A span with its deflection.
#[derive(Debug, Clone)]
pub(crate) struct Span {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// At its left end.
    pub(crate) start: Jet,
    /// At its right end.
    pub(crate) end: Jet,
    /// `∫ (L − s) q ds` and `∫ q ds`: the moment of its load about its right end, and its load.
    pub(crate) loaded: [Interval; 2],
}

/// Deflection on all cells from `from` to `to`, starting with `jet`, and `v, …, v'''` just before the end.
fn march(
    mut jet: Jet,
    from: f64,
    to: f64,
    breaks: Vec<f64>,
    load: &EnclosedLoad,
    stiffness: f64,
) -> (Vec<([f64; 2], Polynomial)>, Jet) {
    let mut curve = Vec::new();
    for cell in cells(from, to, breaks) {
        if from < cell[0]
            && let Some(force) = load.point(cell[0])
        {
            jet[3] = jet[3] + force / Interval::exact(stiffness);
        }
        let q = load.cell(cell[0], cell[1]).times(Interval::exact(1.0) / Interval::exact(stiffness));
        let [q, rise] = [0, 1].map(|j| q.coefficients().get(j).copied().unwrap_or(Interval::ZERO));
        let [v, slope, curvature, third] = jet;
        let deflection =
            Polynomial::new(&[v, slope, curvature / number(2), third / number(6), q / number(24), rise / number(120)]);
        let width = Interval::exact(cell[1]) - Interval::exact(cell[0]);
        let first = deflection.derivative();
        let second = first.derivative();
        jet = [deflection.at(width), first.at(width), second.at(width), second.derivative().at(width)];
        curve.push((cell, deflection));
    }
    (curve, jet)
}

impl Span {
    /// The beam between two places with deflection and slope `[v, v']` at both, or at the one that is not free; `rise` is
    /// `v₁ − v₀ − θ₀ L` if that is known in another way, too.
    pub(crate) fn new(
        [from, to]: [f64; 2],
        ends: [Option<[Interval; 2]>; 2],
        load: &EnclosedLoad,
        stiffness: f64,
        rise: Option<Interval>,
    ) -> Self {
        let (_, own) = march([Interval::ZERO; 4], from, to, load.breaks(from, to), load, stiffness);
        let length = Interval::exact(to) - Interval::exact(from);
        let at_tip = |x: f64| load.point(x).unwrap_or(Interval::ZERO) / Interval::exact(stiffness);
        let [half, sixth] = [length * length / number(2), length * length * length / number(6)];
        let (left, right, [curvature, third]) = match ends {
            [Some(left), Some(right)] => {
                let straight = right[0] - left[0] - left[1] * length;
                let rise = rise.map_or(straight, |rise| rise.meet(straight)) - own[0];
                let turn = right[1] - left[1] - own[1];
                let curvature = (number(6) * rise / length - number(2) * turn) / length;
                (left, right, [curvature, (number(6) * turn - number(12) * rise / length) / (length * length)])
            }
            [Some(left), None] => {
                let third = -(own[3] + at_tip(to));
                let curvature = -own[2] - third * length;
                let v = left[0] + left[1] * length + curvature * half + third * sixth + own[0];
                (left, [v, left[1] + curvature * length + third * half + own[1]], [curvature, third])
            }
            [None, right] => {
                let right = right.unwrap_or([Interval::ZERO; 2]);
                let third = at_tip(from);
                let slope = right[1] - third * half - own[1];
                ([right[0] - slope * length - third * sixth - own[0], slope], right, [Interval::ZERO, third])
            }
        };
        Self {
            from,
            to,
            start: [left[0], left[1], curvature, third],
            end: [right[0], right[1], curvature + third * length + own[2], third + own[3]],
            loaded: [own[2], own[3]].map(|v| v * Interval::exact(stiffness)),
        }
    }

    /// Its deflection by parts without a break of the load, each known from both of its ends: `v(from + s)` and `v(to + s)`. No
    /// break of the foundation is gone over, at which its rounding would grow.
    pub(crate) fn curves(&self, load: &EnclosedLoad, stiffness: f64) -> Vec<Curve> {
        let (parts, _) = march(self.start, self.from, self.to, load.breaks(self.from, self.to), load, stiffness);
        let [v, slope, curvature, third] = self.end;
        let at_end = [v, slope, curvature / number(2), third / number(6)];
        let both = |(part, start): ([f64; 2], Polynomial)| {
            let there = start.shifted(Interval::exact(part[1]) - Interval::exact(part[0]));
            // At its end the span is known better.
            (part, [start, if self.to <= part[1] { there.known(&at_end) } else { there }])
        };
        parts.into_iter().map(both).collect()
    }

    /// Its deflection by cells; `breaks` besides those of the load.
    pub(crate) fn curve(&self, breaks: Vec<f64>, load: &EnclosedLoad, stiffness: f64) -> Vec<([f64; 2], Polynomial)> {
        let mut all = load.breaks(self.from, self.to);
        all.extend(breaks);
        march(self.start, self.from, self.to, all, load, stiffness).0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, LinearLoad, Load, PointLoad, Scene};

    /// An overhang of length `a` under `q + r s` with a force `P` at its tip, from the textbook: with `s` from the support,
    /// `EI v''(0) = q a²/2 + r a³/3 + P a`, `EI v'(a) = EI v'(0) + q a³/6 + r a⁴/8 + P a²/2` and
    /// `EI v(a) = EI (v(0) + v'(0) a) + q a⁴/8 + 11 r a⁵/120 + P a³/3`. To the left all of it is the mirror image.
    #[test]
    fn overhangs_bend_by_their_closed_form() {
        const ROUNDING: f64 = 1e-13;
        let (stiffness, a, q, r, force, v, slope) = (70.0, 3.0, 2.0, 0.5, 4.0, 0.3, -0.2);
        let beam = Beam::new(20.0, stiffness).expect("positive");
        for (tip, support, sign) in [(20.0, 17.0, 1.0), (0.0, 3.0, -1.0)] {
            let to_the_left = sign < 0.0;
            let [start, end] = if to_the_left { [r * a, 0.0] } else { [0.0, r * a] };
            let (from, to) = (f64::min(tip, support), f64::max(tip, support));
            let growing = LinearLoad { from, to, start, end };
            let load = Load::new(&beam, q, vec![growing], vec![PointLoad { at: tip, force }]).expect("finite");
            let load = EnclosedLoad::of(&Scene::new(beam.clone(), load, None).expect("well posed"));
            let held = Some([v, sign * slope].map(Interval::exact));
            let span =
                Span::new([from, to], if to_the_left { [None, held] } else { [held, None] }, &load, stiffness, None);
            let (at_support, at_tip) = if to_the_left { (span.end, span.start) } else { (span.start, span.end) };
            let bent = a * a * a * (q * a / 8.0 + 11.0 * r * a * a / 120.0 + force / 3.0) / stiffness;
            let expected = [
                (at_support[0], v),
                (at_support[1], sign * slope),
                (at_support[2], a * (q * a / 2.0 + r * a * a / 3.0 + force) / stiffness),
                (at_support[3], -sign * (q * a + r * a * a / 2.0 + force) / stiffness),
                (at_tip[0], v + slope * a + bent),
                (at_tip[1], sign * (slope + a * a * (q * a / 6.0 + r * a * a / 8.0 + force / 2.0) / stiffness)),
                (at_tip[2], 0.0),
                (at_tip[3], -sign * force / stiffness),
            ];
            for (i, (found, expected)) in expected.into_iter().enumerate() {
                let off = found.lo() - ROUNDING <= expected && expected <= found.hi() + ROUNDING;
                assert!(off && found.hi() - found.lo() <= ROUNDING, "{i} at {tip}: {found:?} for {expected}");
            }
        }
    }
}
