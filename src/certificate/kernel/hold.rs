//! What holds the beam: two places at which a deflection is known. From a gap follows how far a deflection is off elsewhere,
//! and from a force that has to be carried the bending that this takes.
//!
//! The flexibility `c(x, x)` of a beam on two supports at a distance `L`, at `x`, is
//!
//! ```text
//! 3 EI c = s² r²/L        between them, s + r = L being the distances from both
//! 3 EI c = a² (L + a)     beyond one of them by a
//! ```
//!
//! Built in, a beam is held by two supports at one place: `L = 0`. Any two of several supports will do, since dropping supports
//! only makes a beam more flexible.
//!
//! Where the beam is held by contact forces, a place is a part of the beam on which they have a resultant `P`. Somewhere on it
//! the true clearance is at most `gap/P`, and that of `v̂` is known, so that the two differ there by at most the larger one, `ε`:
//!
//! ```text
//! |v̂ − v*|(x) ≤ |1 − t| ε₁ + |t| ε₂ + √(2 gap c(x, x)),     t = (x − y₁)/(y₂ − y₁)
//! ```
//!
//! with the worst `y₁`, `y₂` of the two parts.

/// More than a dozen roundings of a sum of products without cancellation.
pub(crate) const OUTWARDS: f64 = 1.0 + 32.0 * f64::EPSILON;

/// A part of the beam, mostly a single place, somewhere on which `|v̂ − v*|` is at most `off`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) off: f64,
}

impl Place {
    /// Where the deflection is known.
    pub(crate) fn at(x: f64) -> Self {
        Self { from: x, to: x, off: 0.0 }
    }
}

/// The left and the right place, the same one where the beam cannot turn.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hold(pub(crate) Place, pub(crate) Place);

impl Hold {
    /// At least `√(3 EI c(x, x))` for `a ≤ x ≤ b`.
    pub(crate) fn lever(&self, [a, b]: [f64; 2]) -> f64 {
        let Self(left, right) = self;
        let mut most = 0.0_f64;
        if left.from < b && a < right.to {
            // s r is concave with a second derivative of two.
            let ends = ((a - left.from) * (right.to - a)).max((b - left.from) * (right.to - b)).max(0.0);
            most = (ends + 0.25 * (b - a) * (b - a)) / (right.to - left.from).sqrt();
        }
        let beyond = |by: f64, from_other: f64| if 0.0 < by { by * from_other.sqrt() } else { 0.0 };
        most.max(beyond(b - right.from, b - left.from)).max(beyond(left.to - a, right.to - a)) * OUTWARDS
    }

    /// At least `|1 − t| ε₁ + |t| ε₂` for `a ≤ x ≤ b`.
    pub(crate) fn shift(&self, part: [f64; 2]) -> f64 {
        let Self(left, right) = self;
        if left.off.max(right.off) <= 0.0 {
            return 0.0;
        }
        let far = |x: f64, place: &Place| (x - place.from).abs().max((x - place.to).abs());
        let most = part.map(|x| far(x, right) * left.off + far(x, left) * right.off);
        most[0].max(most[1]) / (right.from - left.to).max(0.0) * OUTWARDS
    }

    /// How far a part reaches beyond the two places.
    fn beyond(&self, [a, b]: [f64; 2]) -> f64 {
        (b - self.1.from).max(self.0.to - a).max(0.0)
    }

    /// A couple of one at a place on a part takes moments `m` with `3 EI ∫ m²/EI dx ≤ L + 3 a`; at least the root of it.
    pub(crate) fn lever_of_couple(&self, part: [f64; 2]) -> f64 {
        ((self.1.to - self.0.from) + 3.0 * self.beyond(part)).sqrt() * OUTWARDS
    }

    /// At least the force at each of the two places that a force and a couple on a part take. One place that holds the beam
    /// against turning takes the force alone.
    pub(crate) fn share(&self, part: [f64; 2], force: f64, couple: f64) -> f64 {
        let length = self.1.from - self.0.to;
        let turned = force * self.beyond(part) + couple;
        (force + if self.0.from < self.1.to { turned / length.max(0.0) } else { 0.0 }) * OUTWARDS
    }
}
