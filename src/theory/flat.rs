//! The paper's own reference solution: a uniform load `q₀` on a beam above a flat foundation at depth `u₀`, in closed form.
//!
//! Derivation. Let `s` be the distance from a lift-off point towards its support and `h = u₀ − v` the clearance, so that
//! `EI h'''' = −q₀` over the length `a` that is lifted off. At the lift-off point `h = h' = h'' = 0` (the foundation is
//! flat and a beam has no concentrated moments); at the support `h'' = 0`. Hence
//!
//! ```text
//! h(s) = q₀ s³ (2a − s) / (24 EI),     h(a) = u₀:   a⁴ = 24 EI u₀ / q₀,     M = q₀ x (a − x) / 2,     T = q₀ a / 2
//! J    = 2 (q₀² a⁵ / 240 EI − 7 q₀² a⁵ / 240 EI) − q₀ u₀ (l − 2a) = −q₀ u₀ (l − 4a/5)
//! ```
//!
//! It needs `a ≤ l/2`, that is `u₀ ≤ q₀ l⁴ / (384 EI)`. Above that the beam touches at mid-span only, with the force that
//! brings the free beam back to `u₀`; it vanishes at `u₀ = 5 q₀ l⁴ / (384 EI)`, beyond which the beam is free:
//!
//! ```text
//! F = 5 q₀ l / 8 − 48 EI u₀ / l³,     T = (q₀ l − F) / 2,     J = −q₀² l⁵ / (240 EI) + F² l³ / (96 EI)
//! ```

use crate::state::Regime;

/// Beam theory for a flat foundation and a uniform load; made by [`flat`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatSolution {
    length: f64,
    bending_stiffness: f64,
    depth: f64,
    load: f64,
    /// Which of the three regimes.
    pub regime: Regime,
    /// Length `a` that is lifted off at each end; `l/2` with contact at mid-span, [`None`] without contact \[length\].
    pub lift_off: Option<f64>,
    /// Reaction `T` of each support, upwards \[force\].
    pub reaction: f64,
    /// Resultant of the contact, upwards \[force\].
    pub contact_force: f64,
    /// Concentrated force at each lift-off point, `T`; zero unless the regime is [`Regime::Zone`] \[force\].
    pub end_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// The exact solution for a beam of `length` \[length\] and `bending_stiffness` \[force · length²\], both positive, above a
/// flat foundation at `depth` ≥ 0 \[length\], under a uniform load \[force / length\], positive downwards.
#[must_use]
pub fn flat(length: f64, bending_stiffness: f64, depth: f64, load: f64) -> FlatSolution {
    let (l, ei) = (length, bending_stiffness);
    // u₀ in units of q₀ l⁴ / EI, multiplied out so that a beam without load needs no division.
    let (needed, unit) = (384.0 * ei * depth, load * l * l * l * l);
    let free = FlatSolution {
        length,
        bending_stiffness,
        depth,
        load,
        regime: Regime::None,
        lift_off: None,
        reaction: 0.5 * load * l,
        contact_force: 0.0,
        end_force: 0.0,
        energy: -load * load * l * l * l * l * l / (240.0 * ei),
    };
    if load <= 0.0 || 5.0 * unit <= needed {
        free
    } else if needed <= unit {
        let a = (24.0 * ei * depth / load).sqrt().sqrt();
        let reaction = 0.5 * load * a;
        FlatSolution {
            regime: Regime::Zone,
            lift_off: Some(a),
            reaction,
            contact_force: load * (l - a),
            end_force: reaction,
            energy: -load * depth * (l - 0.8 * a),
            ..free
        }
    } else {
        // Factored so that the force fades out without cancellation at the border to the free beam.
        let force = (5.0 * unit - needed) / (8.0 * l * l * l);
        FlatSolution {
            regime: Regime::Points,
            lift_off: Some(0.5 * l),
            reaction: 0.5 * (load * l - force),
            contact_force: force,
            energy: free.energy + force * force * l * l * l / (96.0 * ei),
            ..free
        }
    }
}

impl FlatSolution {
    /// `v(x)`, positive downwards \[length\].
    #[must_use]
    pub fn deflection(&self, x: f64) -> f64 {
        let x = self.nearer_support(x);
        if self.regime == Regime::Zone {
            return self.depth - self.clearance_of_zone(x);
        }
        // From M = T x − q₀ x²/2 and v'(l/2) = 0.
        let (l, t, q) = (self.length, self.reaction, self.load);
        let slope = t * l * l / 8.0 - q * l * l * l / 48.0;
        x * (slope - x * x * (t / 6.0 - q * x / 24.0)) / self.bending_stiffness
    }

    /// `h(x) = u₀ − v(x)` \[length\].
    #[must_use]
    pub fn clearance(&self, x: f64) -> f64 {
        if self.regime == Regime::Zone {
            self.clearance_of_zone(self.nearer_support(x))
        } else {
            self.depth - self.deflection(x)
        }
    }

    /// `M(x) = −EI v''`, positive with the underside in tension \[force · length\].
    #[must_use]
    pub fn moment(&self, x: f64) -> f64 {
        let x = self.nearer_support(x);
        match (self.regime, self.lift_off) {
            (Regime::Zone, Some(a)) => 0.5 * self.load * x * (a - x).max(0.0),
            _ => x * (self.reaction - 0.5 * self.load * x),
        }
    }

    /// Contact pressure `p(x)` without the concentrated forces: `q₀` inside the zone \[force / length\].
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        match (self.regime, self.lift_off) {
            (Regime::Zone, Some(a)) if a <= self.nearer_support(x) => self.load,
            _ => 0.0,
        }
    }

    /// Distance of `x` from the nearer support: the solution is symmetric.
    fn nearer_support(&self, x: f64) -> f64 {
        x.min(self.length - x)
    }

    /// `h = q₀ s³ (2a − s) / (24 EI)` at `x` up to mid-span, zero inside the zone.
    fn clearance_of_zone(&self, x: f64) -> f64 {
        let a = self.lift_off.unwrap_or(0.0);
        let s = (a - x).max(0.0);
        self.load * s * s * s * (2.0 * a - s) / (24.0 * self.bending_stiffness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half a unit of the last printed digit of the energy, and a margin.
    const PRINTED: f64 = 1e-9;

    /// Rounding of a handful of multiplications.
    const ROUNDING: f64 = 1e-14;

    #[track_caller]
    fn check(found: f64, expected: f64) {
        assert!((found - expected).abs() <= ROUNDING * expected.abs().max(1.0), "{found} instead of {expected}");
    }

    #[test]
    fn the_example_of_the_paper() {
        let solution = flat(10.0, 500.0 / 384.0, 1.0, 1.0);
        assert_eq!(solution.regime, Regime::Zone);
        check(solution.lift_off.unwrap_or(f64::NAN), 2.364_354_022_507_94);
        check(solution.reaction, 1.182_177_011_253_97);
        assert!((solution.energy - -8.108_516_782).abs() < PRINTED, "{}", solution.energy);
        check(2.0 * solution.reaction + solution.contact_force, 10.0);
    }

    #[test]
    fn the_two_borders_are_the_same_from_both_sides() {
        let (l, ei, q) = (7.0, 3.0, 2.0);
        let unit = q * l * l * l * l / (384.0 * ei);
        for border in [unit, 5.0 * unit] {
            let (below, above) = (flat(l, ei, border * (1.0 - 1e-15), q), flat(l, ei, border * (1.0 + 1e-15), q));
            assert_ne!(below.regime, above.regime);
            check(below.reaction, above.reaction);
            check(below.contact_force, above.contact_force);
            check(below.energy, above.energy);
            for x in [0.5, 1.5, 3.0, 3.5, 6.0] {
                check(below.deflection(x), above.deflection(x));
                check(below.moment(x), above.moment(x));
            }
        }
    }

    #[test]
    fn the_beam_meets_its_conditions_in_every_regime() {
        let (l, ei, q) = (4.0, 2.0, 3.0);
        for share in [0.3, 1.0, 2.5, 7.0] {
            let u = share * q * l * l * l * l / (384.0 * ei);
            let solution = flat(l, ei, u, q);
            check(solution.deflection(0.0), 0.0);
            check(solution.moment(0.0), 0.0);
            check(2.0 * solution.reaction + solution.contact_force, q * l);
            for i in 0..=40 {
                let x = 0.1 * f64::from(i);
                assert!(-ROUNDING <= solution.clearance(x), "penetration at {x}");
                check(solution.deflection(x), solution.deflection(l - x));
            }
        }
    }

    #[test]
    fn energy_is_the_integral_it_is_said_to_be() {
        // J = ½∫M²/EI − ∫qv by the trapezium rule; its error falls with the square of the step.
        const QUADRATURE: f64 = 1e-6;
        let (l, ei, q, n) = (4.0, 2.0, 3.0, 4000_u32);
        for share in [0.3, 2.5, 7.0] {
            let solution = flat(l, ei, share * q * l * l * l * l / (384.0 * ei), q);
            let step = l / f64::from(n);
            let sum: f64 = (1..n)
                .map(|i| step * f64::from(i))
                .map(|x| 0.5 * solution.moment(x) * solution.moment(x) / ei - q * solution.deflection(x))
                .sum();
            let relative = (sum * step / solution.energy - 1.0).abs();
            assert!(relative < QUADRATURE, "energy {} by formula, off by {relative}", solution.energy);
        }
    }
}
