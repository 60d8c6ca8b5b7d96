//! A part of the beam that hangs free between two nodes: the exact beam under the true load, given deflection and slope
//! at both ends. At a free end of the beam nothing is given, and moment and shear force vanish beyond it.
//!
//! The load at the distances `a` and `b` from the two ends, `a + b = L`, turns the beam at fixed ends by `E₀ = ∫ a b² q / L²` and
//! `E₁ = ∫ a² b q / L²`. With `Δv = v₁ − v₀ − θ₀ L`, `Δθ = θ₁ − θ₀` and a point load `P` at a free end
//!
//! ```text
//! EI v''(0) = EI (6 Δv/L − 2 Δθ)/L + E₀,        EI v''(L) = EI (4 Δθ − 6 Δv/L)/L + E₁
//! EI v'''(0) = EI (v''(L) − v''(0))/L − ∫ b q / L,        EI v'''(L) = EI (v''(L) − v''(0))/L + ∫ a q / L
//! free on the right   EI v''(0) = ∫ a q + P L,  v''(L) = 0,       on the left the mirror image
//! ```
//!
//! A couple is in these integrals what a force is, differentiated by its place.
//! A load near one of the ends has all its digits in each of these integrals.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::load::{EnclosedLoad, cells};
use super::polynomial::{Polynomial, number};

/// `v, v', v'', v'''` at a place.
pub(crate) type Jet = [Interval; 4];

/// `[v, v']` at the ends that are not free.
type Ends = [Option<[Interval; 2]>; 2];

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
    /// What its load presses with on its ends if the beam is cut there.
    pub(crate) loaded: [Interval; 2],
}

/// `∫ b q`, `∫ a q`, `∫ a b² q` and `∫ a² b q` of what stands between two places, at the distances `a` and `b` from them.
fn integrals(load: &EnclosedLoad, [from, to]: [f64; 2]) -> [Interval; 4] {
    let mut sums = [Interval::ZERO; 4];
    for &(x, couple) in load.couples.iter().filter(|(x, _)| from < *x && *x < to) {
        let (a, b) = (Interval::length(from, x), Interval::length(x, to));
        let turned = [-number(1), number(1), b * (b - number(2) * a), a * (number(2) * b - a)];
        sums = [0, 1, 2, 3].map(|k| sums[k] + turned[k] * couple);
    }
    let mut add = |a: Interval, b: Interval, force: Interval| {
        let both = a * b * force;
        sums = [sums[0] + b * force, sums[1] + a * force, sums[2] + both * b, sums[3] + both * a];
    };
    for [start, end] in cells(from, to, load.breaks(from, to)) {
        let (before, behind) = (Interval::length(from, start), Interval::length(end, to));
        if from < start {
            add(before, Interval::length(start, to), load.point(start));
        }
        let ([q, rise], width) = (load.line(start, [start, end]), Interval::length(start, end));
        // Boole's rule is exact up to the fifth degree.
        for (k, weight) in [7, 32, 12, 32, 7].into_iter().enumerate() {
            let [s, rest] = [k, 4 - k].map(|k| width * number(k) / number(4));
            add(before + s, rest + behind, (q + rise * s) * width * number(weight) / number(90));
        }
    }
    sums
}

/// Deflection on neighbouring cells, each about the end that comes first, starting with `jet` there: from left to right, or all the
/// other way.
fn march(enclosed: &EnclosedScene<'_>, mut jet: Jet, cells: &[[f64; 2]]) -> Vec<Polynomial> {
    let stiffness = Interval::exact(enclosed.stiffness);
    let march = |&[near, far]: &[f64; 2]| {
        let [q, rise] = enclosed.load.line(near, [near.min(far), near.max(far)]).map(|q| q / stiffness);
        let [v, slope, curvature, third] = jet;
        let deflection =
            Polynomial::new(&[v, slope, curvature / number(2), third / number(6), q / number(24), rise / number(120)]);
        let there = deflection.shifted(Interval::length(near, far));
        let [force, couple] = [enclosed.load.point(far), enclosed.load.couple(far)].map(|acts| {
            let acts = acts / stiffness;
            if near < far { acts } else { -acts }
        });
        let c = there.coefficients();
        jet = [c[0], c[1], c[2] * number(2) - couple, c[3] * number(6) + force];
        deflection
    };
    cells.iter().map(march).collect()
}

impl Span {
    /// The beam between two places with deflection and slope `[v, v']` at both, or at the one that is not free; `rise` is
    /// `v₁ − v₀ − θ₀ L` if that is known in another way, too.
    pub(crate) fn new(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2], ends: Ends, rise: Option<Interval>) -> Self {
        let (stiffness, length) = (Interval::exact(enclosed.stiffness), Interval::length(from, to));
        let [b, a, ab2, a2b] = integrals(enclosed.load, [from, to]);
        let fixed = [ab2, a2b].map(|turned| turned / (length * length) / stiffness);
        // From a node to the free end of an overhang, to the left with a negative length.
        let free = |[v, slope]: [Interval; 2], to: Interval, [arms, near, far]: [Interval; 3], tip: f64| {
            let couple = enclosed.load.couple(tip) / stiffness;
            let couple = if from < tip { couple } else { -couple };
            let bent = (arms + enclosed.load.point(tip) * length) / stiffness + couple;
            let turn = to * (bent - near - far + couple) / number(2);
            let free = [v + to * (slope + (to * (bent - near) + number(2) * turn) / number(6)), slope + turn];
            (free, bent, couple)
        };
        let (left, right, bent) = match ends {
            [Some(left), Some(right)] => {
                let straight = right[0] - left[0] - left[1] * length;
                let rise = number(6) * rise.map_or(straight, |rise| rise.meet(straight)) / length;
                let turn = number(2) * (right[1] - left[1]);
                let bent = [(rise - turn) / length + fixed[0], (number(2) * turn - rise) / length + fixed[1]];
                (left, right, bent)
            }
            [Some(left), None] => {
                let (right, bent, couple) = free(left, length, [a, fixed[0], fixed[1]], to);
                (left, right, [bent, couple])
            }
            [None, right] => {
                let right = right.unwrap_or([Interval::ZERO; 2]);
                let (left, bent, couple) = free(right, -length, [b, fixed[1], fixed[0]], from);
                (left, right, [couple, bent])
            }
        };
        let loaded = [b, a].map(|arms| arms / length);
        let third = (bent[1] - bent[0]) / length;
        let start = [left[0], left[1], bent[0], third - loaded[0] / stiffness];
        let end = [right[0], right[1], bent[1], third + loaded[1] / stiffness];
        Self { from, to, start, end, loaded }
    }

    /// `V` at its two ends from the moments there: not from the third derivative, of which rounding is larger by the square of a
    /// short span.
    pub(crate) fn shears(&self, moments: [Interval; 2]) -> [Interval; 2] {
        let shear = (moments[1] - moments[0]) / Interval::length(self.from, self.to);
        [shear + self.loaded[0], shear - self.loaded[1]]
    }

    /// `6 ∫ (EI v'' + M)² dx` from the moments at its two ends: `EI v'' + M` is linear, also over a couple.
    pub(crate) fn misfit(&self, stiffness: Interval, moments: [Interval; 2]) -> Interval {
        let r = [stiffness * self.start[2] + moments[0], stiffness * self.end[2] + moments[1]];
        Interval::length(self.from, self.to) * (r[0].square() + r[1].square() + (r[0] + r[1]).square())
    }

    /// `M(from + s)` by parts without a break of the load, from the moments at its two ends.
    pub(crate) fn moments(&self, enclosed: &EnclosedScene<'_>, at_ends: [Interval; 2]) -> Vec<([f64; 2], Polynomial)> {
        let load = enclosed.load;
        let [mut moment, mut shear] = [at_ends[0], self.shears(at_ends)[0]];
        let part = |part: [f64; 2]| {
            let [q, rise] = load.line(part[0], part);
            let of = Polynomial::new(&[moment, shear, -q / number(2), -rise / number(6)]);
            let width = Interval::length(part[0], part[1]);
            moment = of.at(width) + load.couple(part[1]);
            shear = of.derivative().at(width) - load.point(part[1]);
            (part, of)
        };
        cells(self.from, self.to, load.breaks(self.from, self.to)).into_iter().map(part).collect()
    }

    /// Its deflection by parts without a break of the load, each known from both of its ends: `v(from + s)` and `v(to + s)`;
    /// `breaks` besides those of the load. Without those of the foundation rounding does not grow there.
    pub(crate) fn curves(&self, enclosed: &EnclosedScene<'_>, mut breaks: Vec<f64>) -> Vec<Curve> {
        breaks.extend(enclosed.load.breaks(self.from, self.to));
        let parts = cells(self.from, self.to, breaks);
        let forwards = march(enclosed, self.start, &parts);
        let from_the_end: Vec<[f64; 2]> = parts.iter().rev().map(|[from, to]| [*to, *from]).collect();
        let backwards = march(enclosed, self.end, &from_the_end);
        let both = |((part, start), end): (([f64; 2], Polynomial), Polynomial)| {
            let width = Interval::length(part[0], part[1]);
            let [there, here] = [start.shifted(width), end.shifted(-width)];
            (part, [start.known(here.coefficients()), end.known(there.coefficients())])
        };
        parts.into_iter().zip(forwards).zip(backwards.into_iter().rev()).map(both).collect()
    }
}

#[cfg(test)]
mod tests;
