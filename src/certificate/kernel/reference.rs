//! Reference lines: what holds the beam. A line runs through two data, positions at which a deflection is known. From a gap it bounds
//! the error of a deflection elsewhere, and from a force that has to be carried the bending that this causes.
//!
//! The flexibility `c(x, x)` at `x` of a beam on two supports at a distance `L` is
//!
//! ```text
//! 3 EI c = s² r²/L        between them, s + r = L being the distances from both
//! 3 EI c = a² (L + a)     beyond one of them by a
//! ```
//!
//! A built-in beam has two supports at one position: `L = 0`. If there are more supports, any two of them can be used, since removing
//! supports only makes a beam more flexible.
//!
//! If contact forces hold the beam, a datum is a part of the beam on which their resultant is `P`. Somewhere on this part the true
//! clearance is at most `gap/P`. The clearance of `v̂` is known, so the two differ there by at most the larger one, `ε`:
//!
//! ```text
//! |v̂ − v*|(x) ≤ |1 − t| ε₁ + |t| ε₂ + √(2 gap c(x, x)),     t = (x − y₁)/(y₂ − y₁)
//! ```
//!
//! with the least favourable `y₁`, `y₂` of the two parts.
//!
//! Elastic supports add their displacement under a unit force at `x`. A single one holds the beam with a rotational spring `k_t`:
//!
//! ```text
//! c = … + (1 − t)²/k₁ + t²/k₂,          c = … + 1/k + a²/k_t
//! ```
//!
//! A hinge is a support of the part that it connects to. Its `1/k` is the `c` at the hinge of the beam on the other side. A line through
//! a hinge says nothing about that side.

/// More than the rounding of a dozen operations in a sum of products without cancellation (Higham 2002, section 3.1).
pub(crate) const OUTWARDS: f64 = 1.0 + 32.0 * f64::EPSILON;

/// A datum: a part of the beam, usually a single position, with a contact force of at least `presses`. Somewhere on the part `|v̂ − v*|`
/// is at most `uncertainty`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Datum {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Infinite for a support whose reaction is not limited.
    pub(crate) presses: f64,
    pub(crate) uncertainty: f64,
    /// `3 EI/k` of an elastic support, and `3 EI/k_t` of one that holds the beam alone with a rotational spring.
    pub(crate) soft: [f64; 2],
    /// A lower bound of the energy stored in a compression-only support. The support is pressed if the gap is smaller.
    pub(crate) energy: f64,
    /// The factor by which a force there may increase on its way to positions with contact forces.
    pub(crate) spread: f64,
    /// The interval, between hinges, in which a line through this datum is valid.
    pub(crate) reach: [f64; 2],
}

impl Datum {
    /// A position where the deflection is known.
    pub(crate) fn at(x: f64) -> Self {
        let far = f64::INFINITY;
        Self {
            from: x,
            to: x,
            presses: far,
            uncertainty: 0.0,
            soft: [0.0; 2],
            energy: far,
            spread: 1.0,
            reach: [-far, far],
        }
    }
}

/// A reference line through the left and the right datum; both are the same if the beam cannot rotate there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line(pub(crate) Datum, pub(crate) Datum);

/// The lines near a part of the beam, from lines sorted from left to right, so that the cost of a bound does not increase with their
/// number. Every single line gives a valid bound, so any of them may be omitted.
pub(crate) fn near(lines: &[Line], [a, _]: [f64; 2]) -> &[Line] {
    /// Number of lines on each side. For positions that are known exactly the nearest two are the best (*tuned* for positions in zones).
    const MOST: usize = 64;
    let next = lines.partition_point(|line| line.0.from <= a);
    &lines[next.saturating_sub(MOST)..lines.len().min(next + MOST)]
}

impl Line {
    /// The smaller of the two lower bounds of the contact forces.
    pub(crate) fn presses(&self) -> f64 {
        self.0.presses.min(self.1.presses)
    }

    /// An upper bound of `√(3 EI c(x, x))` for `a ≤ x ≤ b`. Joints with `soft`, that is `3 EI Σ 1/k`, add the squares of their moments
    /// under a unit force at `x`.
    pub(crate) fn lever(&self, [a, b]: [f64; 2], soft: f64) -> f64 {
        let Self(left, right) = self;
        if a < left.reach[0] || left.reach[1] < b {
            return f64::INFINITY;
        }
        let mut most = 0.0_f64;
        if left.from < b && a < right.to {
            // s r is concave with a second derivative of two.
            let ends = ((a - left.from) * (right.to - a)).max((b - left.from) * (right.to - b)).max(0.0);
            most = (ends + 0.25 * (b - a) * (b - a)) / (right.to - left.from).sqrt();
        }
        let beyond = |by: f64, from_other: f64| if 0.0 < by { by * from_other.sqrt() } else { 0.0 };
        let most = most.max(beyond(b - right.from, b - left.from)).max(beyond(left.to - a, right.to - a));
        let gives = self.gives([a, b]);
        if soft <= 0.0 && gives <= 0.0 {
            return most * OUTWARDS;
        }
        let moment = (0.25 * (right.to - left.from)).max(self.beyond([a, b]));
        (most * most + soft * moment * moment + gives).sqrt() * OUTWARDS
    }

    /// The contribution of elastic supports to the square of a lever.
    fn gives(&self, [a, b]: [f64; 2]) -> f64 {
        let Self(left, right) = self;
        let ([soft, turns], [other, _]) = (left.soft, right.soft);
        if soft.max(other).max(turns) <= 0.0 {
            return 0.0;
        }
        let far = |place: &Datum| {
            (a - place.from).abs().max((b - place.from).abs()).max((a - place.to).abs()).max((b - place.to).abs())
        };
        if right.to <= left.from {
            return (soft + turns * far(left) * far(left)) * OUTWARDS;
        }
        let apart = right.from - left.to;
        let [near, behind] = [far(right) / apart, far(left) / apart];
        if 0.0 < apart { (soft * near * near + other * behind * behind) * OUTWARDS } else { f64::INFINITY }
    }

    /// An upper bound of `|1 − t| ε₁ + |t| ε₂` for `a ≤ x ≤ b`; infinite if the two parts are not separate.
    pub(crate) fn shift(&self, [a, b]: [f64; 2]) -> f64 {
        let Self(left, right) = self;
        if left.uncertainty.max(right.uncertainty) <= 0.0 {
            return 0.0;
        }
        let far = |x: f64, place: &Datum| (x - place.from).abs().max((x - place.to).abs());
        let most = |x: f64| far(x, right) * left.uncertainty + far(x, left) * right.uncertainty;
        if left.to < right.from { most(a).max(most(b)) / (right.from - left.to) * OUTWARDS } else { f64::INFINITY }
    }

    /// The distance by which a part extends beyond the two positions.
    fn beyond(&self, [a, b]: [f64; 2]) -> f64 {
        (b - self.1.from).max(self.0.to - a).max(0.0)
    }

    /// An upper bound of `√(3 EI ∫ m²/EI dx)` for the moments `m` of a unit couple somewhere on a part: `3 EI ∫ m²/EI dx ≤ L + 3 a`.
    pub(crate) fn lever_of_couple(&self, part: [f64; 2], soft: f64) -> f64 {
        let (Self(left, right), apart) = (self, self.1.from - self.0.to);
        if part[0] < left.reach[0] || left.reach[1] < part[1] {
            return f64::INFINITY;
        }
        let both = left.soft[0] + right.soft[0];
        let gives = match both.max(left.soft[1]) {
            none if none <= 0.0 => 0.0,
            _ if right.to <= left.from => left.soft[1],
            _ if 0.0 < apart => both / (apart * apart),
            _ => f64::INFINITY,
        };
        ((self.1.to - self.0.from) + 3.0 * self.beyond(part) + soft + gives).sqrt() * OUTWARDS
    }

    /// An upper bound of the force that a force and a couple on a part cause at each of the two positions. A single position that holds
    /// the beam against rotation carries the force alone.
    pub(crate) fn share(&self, part: [f64; 2], force: f64, couple: f64) -> f64 {
        let length = self.1.from - self.0.to;
        let turned = force * self.beyond(part) + couple;
        let own = force + if self.0.from < self.1.to { turned / length.max(0.0) } else { 0.0 };
        own * self.0.spread.max(self.1.spread) * OUTWARDS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each number is a sum of products without cancellation.
    const ROUNDING: f64 = 1e-13;
    /// Number of intervals between the positions tried on a part.
    const TRIED: u32 = 40;

    fn between([from, to]: [f64; 2]) -> impl Iterator<Item = f64> + Clone {
        (0..=TRIED).map(move |k| from + (to - from) * f64::from(k) / f64::from(TRIED))
    }

    /// `3 EI c(x, x)` of a beam supported at `y₁` and `y₂`.
    fn flexibility(x: f64, [left, right]: [f64; 2]) -> f64 {
        let length = right - left;
        if x < left {
            (left - x) * (left - x) * (length + left - x)
        } else if right < x {
            (x - right) * (x - right) * (length + x - right)
        } else if length <= 0.0 {
            0.0
        } else {
            let product = (x - left) * (right - x);
            product * product / length
        }
    }

    /// `|1 − t| ε₁ + |t| ε₂`.
    fn shifted(x: f64, [left, right]: [f64; 2], off: [f64; 2]) -> f64 {
        let t = (x - left) / (right - left);
        (1.0 - t).abs() * off[0] + t.abs() * off[1]
    }

    #[track_caller]
    fn reached(bound: f64, most: f64) {
        assert!(most <= bound && bound <= most * (1.0 + ROUNDING), "{bound} for {most}");
    }

    /// Two positions at which a deflection is known: between the supports, beyond either, and one position where the beam is built in.
    #[test]
    fn at_a_place_the_bounds_are_reached() {
        let pairs = [[2.0, 5.0], [0.0, 10.0], [3.0, 3.0], [4.0, 4.5]];
        for [left, right] in pairs {
            let line = Line(Datum::at(left), Datum::at(right));
            let of = |place: Datum, off: f64| Datum { uncertainty: off, ..place };
            for x in between([0.0, 10.0]) {
                reached(line.lever([x; 2], 0.0), flexibility(x, [left, right]).sqrt());
                assert!(line.shift([x; 2]) <= 0.0, "known places do not move");
                for off in [[0.25, 0.75], [0.0, 0.75], [0.25, 0.0]] {
                    let shift = Line(of(line.0, off[0]), of(line.1, off[1])).shift([x; 2]);
                    if left < right {
                        reached(shift, shifted(x, [left, right], off));
                    } else {
                        assert!(shift == f64::INFINITY, "one place does not say how the beam is turned");
                    }
                }
            }
        }
    }

    /// For a part of the beam, and for data that are somewhere on a part, the least favourable positions count.
    #[test]
    fn over_parts_the_worst_counts() {
        let places = [[1.0, 1.25], [4.0, 4.5]];
        let off = [0.25, 0.75];
        let [left, right] = [0, 1].map(|k| Datum { to: places[k][1], uncertainty: off[k], ..Datum::at(places[k][0]) });
        let line = Line(left, right);
        for part in [[0.0, 0.5], [0.5, 1.5], [1.5, 1.75], [2.5, 2.75], [3.75, 4.25], [4.25, 5.0], [9.0, 10.0]] {
            let (mut lever, mut shift) = (0.0_f64, 0.0_f64);
            for a in between(places[0]) {
                for b in between(places[1]) {
                    for x in between(part) {
                        lever = lever.max(flexibility(x, [a, b]));
                        shift = shift.max(shifted(x, [a, b], off));
                    }
                }
            }
            let lever = lever.sqrt();
            let (of_lever, of_shift) = (line.lever(part, 0.0), line.shift(part));
            assert!(lever <= of_lever && of_lever <= 1.5 * lever, "{part:?}: {of_lever} for {lever}");
            assert!(shift <= of_shift && of_shift <= 1.4 * shift, "{part:?}: {of_shift} for {shift}");
        }
    }

    /// By statics: a couple beyond a support bends the overhang up to the support and decreases linearly beyond it; the supports share a
    /// force by its lever arm.
    #[test]
    fn couples_and_forces_beyond_a_support() {
        let line = Line(Datum::at(2.0), Datum::at(5.0));
        for (part, beyond) in [([6.5, 7.0], 2.0), ([0.5, 0.75], 1.5)] {
            // 3 ∫m² of a unit moment over the overhang, decreasing from one to zero between the supports.
            reached(line.lever_of_couple(part, 0.0), (3.0_f64 * beyond + 3.0).sqrt());
            // The support next to it carries F (L + a)/L + C/L.
            reached(line.share(part, 0.5, 0.125), (0.5 * (3.0 + beyond) + 0.125) / 3.0);
        }
        // Between the supports a couple causes (s³ + r³)/L² ≤ L.
        reached(line.lever_of_couple([2.0, 5.0], 0.0), 3.0_f64.sqrt());
        reached(line.share([3.0, 4.0], 0.5, 0.125), 0.5 + 0.125 / 3.0);
        // A single built-in position carries the force and the couple.
        let built_in = Line(Datum::at(2.0), Datum::at(2.0));
        reached(built_in.share([3.0, 4.0], 0.5, 0.125), 0.5);
        reached(built_in.lever_of_couple([3.0, 4.0], 0.0), 6.0_f64.sqrt());
        let wide = Line(
            Datum { to: 2.0, uncertainty: 0.5, ..Datum::at(1.0) },
            Datum { to: 5.5, uncertainty: 0.5, ..Datum::at(5.0) },
        );
        // The least favourable positions: far apart for a couple, close together for a share.
        reached(wide.lever_of_couple([6.0, 7.0], 0.0), (4.5_f64 + 3.0 * 2.0).sqrt());
        reached(wide.share([6.0, 7.0], 0.5, 0.125), 0.5 + (0.5 * 2.0 + 0.125) / 3.0);
    }

    /// Hundreds of supports, some of them built in: the lines near a part give the same bound as all lines.
    #[test]
    fn the_best_holds_are_near() {
        let count = 400_u32;
        let at = |k: u32| f64::from(k) + 0.9 * f64::from(k * 37 % 101) / 101.0;
        let of = |k: u32| {
            let two = Some(Line(Datum::at(at(k)), Datum::at(at(k + 1))));
            let one = (k.is_multiple_of(7)).then(|| Line(Datum::at(at(k)), Datum::at(at(k))));
            one.into_iter().chain(two)
        };
        // The beam extends beyond its supports.
        let lines: Vec<Line> = (20..count).flat_map(of).collect();
        for part in (0..4 * (count + 30)).map(|k| [0.25 * f64::from(k), 0.25 * f64::from(k + k % 3)]) {
            let least =
                |lines: &[Line], bound: &dyn Fn(&Line) -> f64| lines.iter().map(bound).fold(f64::INFINITY, f64::min);
            let same = |bound: &dyn Fn(&Line) -> f64| least(near(&lines, part), bound) <= least(&lines, bound);
            assert!(same(&|line| line.lever(part, 0.0)) && same(&|line| line.lever_of_couple(part, 0.0)), "{part:?}");
        }
        assert!(near(&lines, [200.0; 2]).len() < lines.len() / 2);
    }
}
