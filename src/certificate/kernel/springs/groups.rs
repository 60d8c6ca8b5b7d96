//! Groups of pressed parts: what holds a beam on an elastic foundation near each of its places, as zones do on a rigid one.
//!
//! Two carriers far apart prove a bound that grows with `l^1.5 √gap`. The parts of a group lie within `(4 EI/k)^¼`, and a line through two
//! neighbouring groups, or through a group and a support, bounds the error over the distance between these two only.
//!
//! *Proof.* Let `I` be one part or several that are apart, and `w > e = √(2 gap/∫k)` on all of `I`, with the integral over `I`. If
//! `|w₊ − w*₊| > e` on all of `I`, then `½ ∫ k (w₊ − w*₊)² > ½ e² ∫k = gap`, which the theorem at the head of [`springs`](super) excludes.
//! So some place of `I` has `|w₊ − w*₊| ≤ e < w`; there `w*₊ > 0`, hence `w* = w*₊` and `|v̂ − v*| = |w − w*| ≤ e`. Of a group the deepest
//! parts are taken, as many as satisfy this. They carry nothing of the pulls that are cut off: any two carriers do that.

use super::{Carrier, OnSprings};
use crate::certificate::kernel::interval::Interval;
use crate::certificate::kernel::polynomial::number;
use crate::certificate::kernel::reference::{Datum, Line};

impl OnSprings<'_> {
    /// Lines through groups of pressed parts and supports: each with the next one and with the one behind it.
    pub(super) fn held_by_groups(&self, carriers: &[Carrier], gap: f64) -> Vec<Line> {
        let mut groups: Vec<Vec<&Carrier>> = Vec::new();
        for carrier in carriers.iter().filter(|carrier| 0.0 < carrier.sunk) {
            match groups.last_mut() {
                Some(group) if carrier.place.to - group[0].place.from <= carrier.length => group.push(carrier),
                _ => groups.push(vec![carrier]),
            }
        }
        let mut places: Vec<Datum> = groups.into_iter().filter_map(|group| known_in(group, gap)).collect();
        places.extend(self.enclosed.supports.iter().map(|s| Datum::at(s.x)));
        places.sort_by(|a, b| a.from.total_cmp(&b.from));
        let pairs = (0..places.len()).flat_map(|i| [(i, i + 1), (i, i + 2)]);
        let line = |(i, j): (usize, usize)| Some(Line(*places.get(i)?, *places.get(j)?));
        pairs.filter_map(line).filter(|Line(a, b)| a.to < b.from).collect()
    }
}

/// What is known of the deflection somewhere in a group.
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

/// `e = √(2 gap/∫k)`, at least.
pub(super) fn uncertainty(gap: f64, stiffness: Interval) -> f64 {
    (number(2) * Interval::exact(gap) / stiffness).sqrt().hi()
}
