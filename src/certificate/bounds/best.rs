//! The best admissible deflection that there is: of the pattern of contact, or of some other deflection, lifted.

use super::curve::Curve;
use super::proof::Pair;
use super::{Inner, admissible, error};
use crate::certificate::interval::Interval;

/// An admissible deflection.
#[derive(Debug, Clone)]
pub(super) struct Best {
    pub(super) curve: Curve,
    /// `J(v̂)`.
    pub(super) energy: Interval,
    /// `J(v̂) − D(p)` with the best contact load that there is beside the given forces.
    pub(super) gap: Interval,
}

impl Inner<'_> {
    /// The admissible deflection with the least energy, which is the nearest to the true one: that of a pair, or, where the
    /// pair had to be amended, one of some others, lifted.
    pub(super) fn best(&self, pair: Option<&Pair>, others: impl FnOnce() -> Vec<Curve>) -> Best {
        let own = pair.map(|pair| Best {
            curve: pair.curve.clone(),
            energy: pair.curve.energy(&self.load, self.stiffness),
            gap: pair.gap,
        });
        if let Some(own) = &own
            && pair.is_some_and(|pair| self.is_sharp(pair))
        {
            return own.clone();
        }
        let lift =
            |curve: &Curve| admissible::lifted(curve, self.ground.as_ref(), &self.load, self.stiffness, self.length);
        let least = own.as_ref().map_or(f64::INFINITY, |own| own.energy.hi());
        let lifted = others().iter().filter_map(lift).min_by(|a, b| a.1.hi().total_cmp(&b.1.hi()));
        match (lifted.filter(|(_, energy)| energy.hi() < least), own) {
            (None, Some(own)) => own,
            (None, None) => Best { curve: Curve::default(), energy: Interval::WHOLE, gap: Interval::WHOLE },
            (Some((curve, energy)), None) => Best { curve, energy, gap: Interval::WHOLE },
            (Some((curve, energy)), Some(own)) => {
                // The moments of the pair go with every admissible deflection: J(v) − D = J(v) − J(v̂) + J(v̂) − D.
                let gap = own.gap + (energy - own.energy);
                Best { curve, energy, gap: Interval::between(gap.lo().max(0.0), gap.hi()) }
            }
        }
    }

    /// Whether what a pair had to be amended by is no more than what rounding explains.
    pub(super) fn is_sharp(&self, pair: &Pair) -> bool {
        /// Of the largest deflection: the bounds are then those of the pattern itself to six digits.
        const SHARP: f64 = 1e-6;
        let size = pair.curve.pieces.iter().fold(0.0, |most: f64, p| {
            let [from, to] = [p.v.at(Interval::ZERO), p.v.at(Interval::exact(p.to) - Interval::exact(p.from))];
            most.max(from.magnitude()).max(to.magnitude())
        });
        error::of_moments(pair.amends, self.stiffness, self.length) <= SHARP * size
    }
}

#[cfg(test)]
mod tests;
