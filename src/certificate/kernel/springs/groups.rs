//! Groups of pressed parts: they hold a beam on an elastic foundation locally, like zones on a rigid foundation.
//!
//! Two carriers far apart prove a bound that grows with `l^1.5 √gap`. The parts of a group are within a distance of `(4 EI/k)^¼`. A line
//! through two neighbouring groups, or through a group and a support, bounds the error over the distance between these two only.
//!
//! *Proof.* Let `I` be one part or several separate parts, and `w > e = √(2 gap/∫k)` on all of `I`, with the integral over `I`. If
//! `|w₊ − w*₊| > e` on all of `I`, then `½ ∫ k (w₊ − w*₊)² > ½ e² ∫k = gap`, which the theorem at the head of [`springs`](super)
//! excludes. So `|w₊ − w*₊| ≤ e < w` at some position of `I`. There `w*₊ > 0`, hence `w* = w*₊` and `|v̂ − v*| = |w − w*| ≤ e`. Of each
//! group the deepest parts are used, as many as satisfy this. Groups do not carry the tension that is cut off: any two carriers do.

use super::{Carrier, OnSprings, Sums};
use crate::certificate::kernel::interval::Interval;
use crate::certificate::kernel::polynomial::number;
use crate::certificate::kernel::reference::{Datum, Line};

impl OnSprings<'_> {
    /// The groups from left to right.
    fn groups<'a>(&self, sums: &'a Sums) -> Vec<Vec<&'a Carrier>> {
        let mut groups: Vec<Vec<&Carrier>> = Vec::new();
        for carrier in sums.carriers.iter().filter(|carrier| 0.0 < carrier.sunk) {
            match groups.last_mut() {
                Some(group)
                    if self.is_one([group[0].place.from, carrier.place.to])
                        && carrier.place.to - group[0].place.from <= carrier.length =>
                {
                    group.push(carrier)
                }
                _ => groups.push(vec![carrier]),
            }
        }
        groups
    }

    /// Lines through the parts with the largest contact forces of neighbouring groups. Only parts that are pressed for every pair with
    /// this gap are used. [`None`] if the beam has supports or hinges.
    pub(super) fn neighbours(&self, sums: &Sums, gap: f64) -> Option<Vec<Line>> {
        let is_whole = self.enclosed.supports.is_empty() && self.is_one([0.0, self.enclosed.length]);
        let strongest = |group: Vec<&Carrier>| {
            let pressed = group.into_iter().filter(|part| uncertainty(gap, part.stiffness) < part.sunk);
            let place = pressed.max_by(|a, b| a.place.presses.total_cmp(&b.place.presses))?.place;
            (0.0 < place.presses).then_some(place)
        };
        let places: Vec<Datum> = is_whole.then(|| self.groups(sums))?.into_iter().filter_map(strongest).collect();
        let lines = places.windows(2).map(|w| Line(w[0], w[1])).filter(|Line(a, b)| a.to < b.from);
        Some(lines.collect())
    }

    /// Lines through groups of pressed parts and supports: each with the next one and with the one after it.
    pub(super) fn held_by_groups(&self, sums: &Sums, gap: f64) -> Vec<Line> {
        // A line is not valid beyond a hinge.
        let within = |place: Datum| {
            let reach = self.reach([place.from, place.to])?;
            Some(Datum { reach, ..place })
        };
        let mut places: Vec<Datum> = self.groups(sums).into_iter().filter_map(|group| known_in(group, gap)).collect();
        places.extend(self.supports(sums).into_iter().filter(|place| place.presses.is_infinite()));
        let mut places: Vec<Datum> = places.into_iter().filter_map(within).collect();
        places.sort_by(|a, b| a.from.total_cmp(&b.from));
        let pairs = (0..places.len()).flat_map(|i| [(i, i + 1), (i, i + 2)]);
        let line = |(i, j): (usize, usize)| Some(Line(*places.get(i)?, *places.get(j)?));
        let is_line = |Line(a, b): &Line| a.to < b.from && self.is_one([a.from, b.to]);
        pairs.filter_map(line).filter(is_line).collect()
    }

    /// Whether no hinge is strictly between two positions.
    fn is_one(&self, [from, to]: [f64; 2]) -> bool {
        !self.enclosed.joints.iter().any(|(x, k)| *k <= 0.0 && from < *x && *x < to)
    }

    /// The hinges that bound a part without a hinge inside; [`None`] if the part is a single position at a hinge.
    fn reach(&self, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let hinges = || self.enclosed.joints.iter().filter(|joint| joint.1 <= 0.0).map(|joint| joint.0);
        let before = hinges().filter(|x| *x <= from).fold(f64::NEG_INFINITY, f64::max);
        let behind = hinges().filter(|x| to <= *x).fold(f64::INFINITY, f64::min);
        (before < behind).then_some([before, behind])
    }
}

/// A bound of the deflection error somewhere in a group; [`None`] if no number of its deepest parts gives one.
fn known_in(mut group: Vec<&Carrier>, gap: f64) -> Option<Datum> {
    group.sort_by(|a, b| b.sunk.total_cmp(&a.sunk));
    let (mut together, mut known) = (Interval::ZERO, None);
    let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
    for Carrier { place, sunk, stiffness, .. } in group {
        together = together + *stiffness;
        (from, to) = (from.min(place.from), to.max(place.to));
        let uncertainty = uncertainty(gap, together);
        if uncertainty < *sunk {
            known = Some(Datum { to, presses: 0.0, uncertainty, ..Datum::at(from) });
        }
    }
    known
}

/// An upper bound of `e = √(2 gap/∫k)`.
pub(super) fn uncertainty(gap: f64, stiffness: Interval) -> f64 {
    (number(2) * Interval::exact(gap) / stiffness).sqrt().hi()
}
