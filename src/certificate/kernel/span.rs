//! A part of the beam that hangs free between two nodes: the exact beam under the true load, with given deflection and slope at both
//! ends. At a free end of the beam nothing is given, and moment and shear force are zero beyond it.
//!
//! With fixed ends, the load at the distances `a` and `b` from the two ends, `a + b = L`, causes values of `EI v''` there of
//! `E₀ = ∫ a b² q / L²` and `E₁ = ∫ a² b q / L²`. With `Δv = v₁ − v₀ − θ₀ L`, `Δθ = θ₁ − θ₀` and a point load `P` at a free end
//!
//! ```text
//! EI v''(0) = EI (6 Δv/L − 2 Δθ)/L + E₀,        EI v''(L) = EI (4 Δθ − 6 Δv/L)/L + E₁
//! EI v'''(0) = EI (v''(L) − v''(0))/L − ∫ b q / L,        EI v'''(L) = EI (v''(L) − v''(0))/L + ∫ a q / L
//! free on the right   EI v''(0) = ∫ a q + P L,  v''(L) = 0,       on the left the mirror image
//! ```
//!
//! A couple enters these integrals like a force, differentiated with respect to its position. Each of these integrals keeps all digits
//! for a load near one of the ends.

use std::rc::Rc;

use super::contact_node::EnclosedScene;
use super::flexibility::Flexible;
use super::interval::Interval;
use super::load::{EnclosedLoad, cells};
use super::polynomial::{Polynomial, number};
use super::tension::Parts;

/// `v, v', v'', v'''` at a position.
pub(crate) type Jet = [Interval; 4];

/// `[v, v']` at the ends that are not free.
type Ends = [Option<[Interval; 2]>; 2];

/// The deflection between two positions, as a polynomial about each of them.
pub(crate) type Curve = ([f64; 2], [Polynomial; 2]);

/// A span with its deflection.
#[derive(Debug, Clone)]
pub(crate) struct Span {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// The state at its left end.
    pub(crate) start: Jet,
    /// The state at its right end.
    pub(crate) end: Jet,
    /// The forces of its load on its ends, if the span is simply supported there.
    pub(crate) loaded: [Interval; 2],
    /// If the beam changes on the span: its flexibility, and the jumps of its slope in joints.
    pub(super) flexible: Option<Rc<Flexible>>,
    pub(super) kinks: Vec<(f64, Interval)>,
    /// Its parts, under an axial force.
    pub(super) hung: Option<Parts>,
}

/// `∫ b q`, `∫ a q`, `∫ a b² q` and `∫ a² b q` of the loads between two positions, at the distances `a` and `b` from them.
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

/// The deflection on neighbouring cells, each about its first end in the direction of travel, starting there with `jet`. The cells run
/// from left to right, or all in the opposite direction.
fn march(enclosed: &EnclosedScene<'_>, mut jet: Jet, cells: &[[f64; 2]], kinks: &[(f64, Interval)]) -> Vec<Polynomial> {
    let march = |&[near, far]: &[f64; 2]| {
        let stiffness = Interval::exact(enclosed.stiffness_between([near.min(far), near.max(far)]));
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
        if enclosed.changes.contains(&far) {
            let ratio = stiffness / enclosed.stiffness_beside(far, far < near);
            jet = [jet[0], jet[1], jet[2] * ratio, jet[3] * ratio];
        }
        let kink =
            kinks.iter().filter(|(x, _)| x.total_cmp(&far).is_eq()).fold(Interval::ZERO, |sum, kink| sum + kink.1);
        jet[1] = if near < far { jet[1] + kink } else { jet[1] - kink };
        deflection
    };
    cells.iter().map(march).collect()
}

impl Span {
    /// The beam between two positions with deflection and slope `[v, v']` at both, or at the one that is not free. `rise` is a second
    /// enclosure of `v₁ − v₀ − θ₀ L`, if there is one.
    pub(crate) fn new(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2], ends: Ends, rise: Option<Interval>) -> Self {
        if enclosed.tension != 0.0 {
            let ([b, a, ..], length) = (integrals(enclosed.load, [from, to]), Interval::length(from, to));
            return Self::under_tension(enclosed, [from, to], ends, [b, a].map(|arms| arms / length));
        }
        if let Some(flexible) = Flexible::of(enclosed, [from, to]) {
            return Self::flexible(enclosed, [from, to], ends, rise, flexible);
        }
        let (stiffness, length) = (Interval::exact(enclosed.stiffness_between([from, to])), Interval::length(from, to));
        let [b, a, ab2, a2b] = integrals(enclosed.load, [from, to]);
        let fixed = [ab2, a2b].map(|turned| turned / (length * length) / stiffness);
        // From a node to the free end of an overhang; if the overhang is to the left, with a negative length.
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
        Self { from, to, start, end, loaded, flexible: None, kinks: Vec::new(), hung: None }
    }

    /// The same for a span on which the beam changes.
    fn flexible(
        enclosed: &EnclosedScene<'_>,
        [from, to]: [f64; 2],
        ends: Ends,
        rise: Option<Interval>,
        flexible: Flexible,
    ) -> Self {
        let (load, length) = (enclosed.load, Interval::length(from, to));
        let [b, a, ..] = integrals(load, [from, to]);
        let loaded = [b, a].map(|arms| arms / length);
        // At a free end, the moments of the loads at the tip; at the other end, the moments of all loads on the overhang.
        let tips = [(from, -number(1)), (to, number(1))]
            .map(|(tip, sign)| (load.point(tip) * length, load.couple(tip) * sign));
        let mut hinges = Vec::new();
        let moments = match ends {
            [Some(left), Some(right)] => {
                let straight = right[0] - left[0] - left[1] * length;
                let chord = rise.map_or(straight, |rise| rise.meet(straight)) / length;
                let slopes = [-chord, right[1] - left[1] - chord];
                hinges = flexible.kinks_of_hinges(slopes);
                flexible.moments(slopes)
            }
            [_, None] => [-(a + tips[1].0 + tips[1].1), -tips[1].1],
            [None, _] => [-tips[0].1, -(b + tips[0].0 + tips[0].1)],
        };
        let mut kinks = flexible.kinks(moments);
        kinks.extend(hinges);
        let turns = flexible.turns(moments);
        // The state of both ends from the known one, with the end slopes relative to the chord.
        let [left, right] = match ends {
            [Some(left), Some(right)] => [left, right],
            [Some(left), None] => {
                let chord = left[1] - turns[0];
                [left, [left[0] + chord * length, chord + turns[1]]]
            }
            [None, right] => {
                let right = right.unwrap_or([Interval::ZERO; 2]);
                let chord = right[1] - turns[1];
                [[right[0] - chord * length, chord + turns[0]], right]
            }
        };
        let (near, far) = (enclosed.stiffness_beside(from, false), enclosed.stiffness_beside(to, true));
        let shear = (moments[1] - moments[0]) / length;
        let start = [left[0], left[1], -(moments[0] / near), -((shear + loaded[0]) / near)];
        let end = [right[0], right[1], -(moments[1] / far), -((shear - loaded[1]) / far)];
        // A joint at the right end is part of the span.
        let at_end =
            kinks.iter().filter(|(x, _)| x.total_cmp(&to).is_eq()).fold(Interval::ZERO, |sum, kink| sum + kink.1);
        let end = [end[0], end[1] - at_end, end[2], end[3]];
        Self { from, to, start, end, loaded, flexible: Some(Rc::new(flexible)), kinks, hung: None }
    }

    /// The derivatives of minus the end moments with respect to the end slopes, in the unit of moments, as midpoints: `[end][slope]`.
    pub(crate) fn answer(&self, enclosed: &EnclosedScene<'_>) -> [[f64; 2]; 2] {
        let stiffness = enclosed.stiffness_between([self.from, self.to]) / enclosed.unit();
        let stiff = 2.0 * stiffness / (self.to - self.from);
        let closed = [[-2.0 * stiff, -stiff], [stiff, 2.0 * stiff]];
        self.flexible.as_ref().map_or(closed, |of| of.answer().map(|row| row.map(|value| -value.middle())))
    }

    /// The jumps of the slope in joints, with their positions.
    pub(crate) fn kinks(&self) -> &[(f64, Interval)] {
        &self.kinks
    }

    /// The moments in the hinges for given end moments, with their positions.
    pub(crate) fn hinges(&self, enclosed: &EnclosedScene<'_>, moments: [Interval; 2]) -> Vec<(f64, Interval)> {
        match (&self.hung, &self.flexible) {
            (Some(parts), _) => self.hinges_under_tension(enclosed, parts, moments),
            (_, Some(flexible)) => flexible.in_hinges(moments).collect(),
            _ => Vec::new(),
        }
    }

    /// `V`, or `H` under an axial force, at its two ends from the moments there. The third derivative is not used, because its rounding
    /// is larger by the square of the inverse length of a short span.
    pub(crate) fn shears(&self, tension: f64, moments: [Interval; 2]) -> [Interval; 2] {
        let length = Interval::length(self.from, self.to);
        let shear = (moments[1] - moments[0]) / length;
        let risen = || Interval::exact(tension) * (self.end[0] - self.start[0]) / length;
        let shear = if tension == 0.0 { shear } else { shear + risen() };
        [shear + self.loaded[0], shear - self.loaded[1]]
    }

    /// An upper bound of `½∫ (EI v'' + M)²/EI dx`, including joints, from the moments at its two ends.
    pub(crate) fn work(&self, enclosed: &EnclosedScene<'_>, moments: [Interval; 2]) -> Interval {
        if let Some(parts) = &self.hung {
            return self.work_under_tension(enclosed, parts, moments);
        }
        let Some(flexible) = &self.flexible else {
            let stiffness = Interval::exact(enclosed.stiffness_between([self.from, self.to]));
            return self.misfit(stiffness, moments) / (number(12) * stiffness);
        };
        let [near, far] = [enclosed.stiffness_beside(self.from, false), enclosed.stiffness_beside(self.to, true)];
        flexible.work([near * self.start[2] + moments[0], far * self.end[2] + moments[1]])
    }

    /// `6 ∫ (EI v'' + M)² dx` from the moments at its two ends; `EI v'' + M` is linear, even across a couple.
    pub(crate) fn misfit(&self, stiffness: Interval, moments: [Interval; 2]) -> Interval {
        let r = [stiffness * self.start[2] + moments[0], stiffness * self.end[2] + moments[1]];
        Interval::length(self.from, self.to) * (r[0].square() + r[1].square() + (r[0] + r[1]).square())
    }

    /// `M(from + s)` by parts without a break of the load, from the moments at its two ends.
    pub(crate) fn moments(&self, enclosed: &EnclosedScene<'_>, at_ends: [Interval; 2]) -> Vec<([f64; 2], Polynomial)> {
        if let Some(parts) = &self.hung {
            return self.moments_under_tension(enclosed, parts, at_ends);
        }
        let load = enclosed.load;
        let [mut moment, mut shear] = [at_ends[0], self.shears(enclosed.tension, at_ends)[0]];
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

    /// The deflection by parts without a break of the load, each known from both of its ends: `v(from + s)` and `v(to + s)`. `breaks`
    /// are added to the breaks of the load. Without the breaks of the foundation, rounding does not increase there.
    pub(crate) fn curves(&self, enclosed: &EnclosedScene<'_>, mut breaks: Vec<f64>) -> Vec<Curve> {
        breaks.extend(enclosed.breaks(self.from, self.to));
        if let Some(parts) = &self.hung {
            return self.curves_of(parts, breaks);
        }
        let parts = cells(self.from, self.to, breaks);
        let forwards = march(enclosed, self.start, &parts, &self.kinks);
        let from_the_end: Vec<[f64; 2]> = parts.iter().rev().map(|[from, to]| [*to, *from]).collect();
        let backwards = march(enclosed, self.end, &from_the_end, &self.kinks);
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
