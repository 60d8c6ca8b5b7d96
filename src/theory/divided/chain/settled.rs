//! States at the ends of short parts.

use super::{Chain, Part, Place};

/// `h, n, h'`, the quantity in equilibrium where parts meet, and `N` at both ends of a part.
#[derive(Clone, Copy)]
pub(super) struct State {
    pub(super) h: [f64; 2],
    pub(super) n: [f64; 2],
    pub(super) slope: [f64; 2],
    pub(super) shear: [f64; 2],
    pub(super) third: [f64; 2],
}

impl State {
    /// Takes slope and shear force from the neighbour beyond the position at the end `near` of the part.
    fn follow(&mut self, part: &Part, place: &Place, [near, far]: [usize; 2], beside: Self) {
        // On a level chord nothing is divided by the length but the moments, whose difference cancels.
        let [a, b] = part.ends([0.0; 2], self.n);
        let sign = if near == 0 { 1.0 } else { -1.0 };
        let right = if near == 0 { self.h[near] } else { beside.h[far] };
        self.shear[near] = beside.shear[far] + sign * (place.shear - place.spring * right);
        self.shear[far] = self.shear[near] + sign * part.loaded();
        if place.joint == 0.0 {
            self.slope[near] = beside.slope[far] + sign * place.kink;
            self.slope[far] = self.slope[near] + sign * (b[0] - a[0]);
        }
        let force = part.tense.map_or(0.0, |tense| tense.force);
        self.third = [0, 1].map(|end| self.shear[end] + force * self.slope[end]);
    }
}

impl Chain<'_> {
    /// Computes slope and shear force of short parts from their longer neighbours. In a short part both are small differences over its
    /// length: a contact that is one rounding away from a division would have any force. Without an axial force few positions are divisions.
    pub(super) fn settled(&self, mut states: Vec<State>) -> Vec<State> {
        /// A part is short if it has less than this share of the longest part: three digits would be lost.
        const SHORT: f64 = 1e-3;
        let length = |i: usize| self.parts[i].length();
        let Some(longest) = (0..states.len()).max_by(|&i, &j| length(i).total_cmp(&length(j))) else { return states };
        let is_short = |i: &usize| self.parts[*i].tense.is_some() && length(*i) < SHORT * length(longest);
        for i in (longest + 1..states.len()).filter(is_short) {
            let beside = states[i - 1];
            states[i].follow(&self.parts[i], &self.places[i], [0, 1], beside);
        }
        for i in (0..longest).rev().filter(is_short) {
            let beside = states[i + 1];
            states[i].follow(&self.parts[i], &self.places[i + 1], [1, 0], beside);
        }
        states
    }
}
