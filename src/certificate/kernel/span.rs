//! A part of the beam that hangs free between two nodes: the exact beam under the true load, given deflection and slope
//! at both ends. At a free end of the beam nothing is given, and moment and shear force vanish beyond it.
//!
//! ```text
//! v = v₀ + θ₀ s + κ₀ s²/2 + τ₀ s³/6 + v_q,     EI v_q'''' = q,  v_q = v_q' = v_q'' = v_q''' = 0 at s = 0
//! κ₀ =  6 (Δv − θ₀ L)/L² − 2 Δθ/L,    τ₀ = −12 (Δv − θ₀ L)/L³ + 6 Δθ/L²,    Δv = v₁ − v_q(L) − v₀,  Δθ = θ₁ − v_q'(L) − θ₀
//! free on the left    κ₀ = 0,  τ₀ = P/EI                              with a point load P at the free end
//! free on the right   κ₀ = −v_q''(L) − τ₀ L,  τ₀ = −v_q'''(L) − P/EI
//! ```

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::load::cells;
use super::polynomial::{Polynomial, number};

/// `v, v', v'', v'''` at a place.
pub(crate) type Jet = [Interval; 4];

/// `[v, v']` at the ends that are not free.
type Ends = [Option<[Interval; 2]>; 2];

/// The deflection between two places, about the first one.
type Cell = ([f64; 2], Polynomial);

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

/// Deflection on all cells between two places, starting with `jet`, and `v, …, v'''` just before the end; `breaks` besides those of
/// the load.
fn march(enclosed: &EnclosedScene<'_>, mut jet: Jet, [from, to]: [f64; 2], mut breaks: Vec<f64>) -> (Vec<Cell>, Jet) {
    let (load, stiffness) = (enclosed.load, Interval::exact(enclosed.stiffness));
    breaks.extend(load.breaks(from, to));
    let mut curve = Vec::new();
    for cell in cells(from, to, breaks) {
        if from < cell[0] {
            jet[3] = jet[3] + load.point(cell[0]) / stiffness;
        }
        let q = load.cell(cell[0], cell[1]).times(Interval::exact(1.0) / stiffness);
        let [q, rise] = [0, 1].map(|j| q.coefficients().get(j).copied().unwrap_or(Interval::ZERO));
        let [v, slope, curvature, third] = jet;
        let deflection =
            Polynomial::new(&[v, slope, curvature / number(2), third / number(6), q / number(24), rise / number(120)]);
        let width = Interval::length(cell[0], cell[1]);
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
    pub(crate) fn new(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2], ends: Ends, rise: Option<Interval>) -> Self {
        let stiffness = Interval::exact(enclosed.stiffness);
        let (_, own) = march(enclosed, [Interval::ZERO; 4], [from, to], Vec::new());
        let length = Interval::length(from, to);
        let at_tip = |x: f64| enclosed.load.point(x) / stiffness;
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
            loaded: [own[2], own[3]].map(|v| v * stiffness),
        }
    }

    /// Its deflection by parts without a break of the load, each known from both of its ends: `v(from + s)` and `v(to + s)`. No
    /// break of the foundation is gone over, at which its rounding would grow.
    pub(crate) fn curves(&self, enclosed: &EnclosedScene<'_>) -> Vec<Curve> {
        let [v, slope, curvature, third] = self.end;
        let at_end = [v, slope, curvature / number(2), third / number(6)];
        let both = |(part, start): Cell| {
            let there = start.shifted(Interval::length(part[0], part[1]));
            // At its end the span is known better.
            (part, [start, if self.to <= part[1] { there.known(&at_end) } else { there }])
        };
        self.curve(enclosed, Vec::new()).into_iter().map(both).collect()
    }

    /// Its deflection by cells; `breaks` besides those of the load.
    pub(crate) fn curve(&self, enclosed: &EnclosedScene<'_>, breaks: Vec<f64>) -> Vec<Cell> {
        march(enclosed, self.start, [self.from, self.to], breaks).0
    }
}

#[cfg(test)]
mod tests;
