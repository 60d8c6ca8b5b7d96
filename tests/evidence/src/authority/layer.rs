//! The layer of pressure at lift-off of a beam that gives in shear, with 256 binary places: another way to the numbers of
//! [`sheared`](crate::closed::sheared).
//!
//! The beam is marched from its left support with `θ₀`, `T` and `a` unknown,
//!
//! ```text
//! θ(x) = θ₀ − (T x²/2 − q x³/6)/EI,   v(x) = θ₀ x − (T x³/6 − q x⁴/24)/EI + (T x − q x²/2)/GA,   v' = θ + V/GA
//! ```
//!
//! `v'(a) = 0` gives `θ₀` for any `T`, `v(a) = u` is linear in `T`, and `a` is where `V` of the decaying moment of the zone is that of the free part.

use super::number::{Fixed, Number};

/// What a beam with a width of its layer has, in the units of the problem.
#[derive(Debug, Clone)]
pub struct Layer {
    /// `a`, where the beam lifts off.
    pub lift_off: Fixed,
    /// `T`, the force of an end support.
    pub reaction: Fixed,
    /// `p` beside lift-off; [`None`] for a beam that is rigid in shear.
    pub pressure: Option<Fixed>,
    /// `∫(p − q)` over half of the zone, or the concentrated force.
    pub resultant: Fixed,
}

/// The beam whose layer is asked for.
#[derive(Debug, Clone)]
pub struct Given {
    /// `l`.
    pub length: Fixed,
    /// `EI`.
    pub stiffness: Fixed,
    /// `u`.
    pub depth: Fixed,
    /// `q`.
    pub load: Fixed,
    /// `s = √(EI/GA)`; zero for a beam that is rigid in shear.
    pub width: Fixed,
}

/// The free part for a lift-off point: `T`, and `M` and `V` at that point.
struct Free {
    reaction: Fixed,
    moment: Fixed,
    shear: Fixed,
}

impl Given {
    /// The example of the paper, `EI = 500/384`, with a width over the length.
    #[must_use]
    pub fn example(width: &Fixed) -> Self {
        let length = Fixed::whole(10);
        Self {
            width: width.times(&length),
            length,
            stiffness: Fixed::fraction(500, 384),
            depth: Fixed::whole(1),
            load: Fixed::whole(1),
        }
    }

    /// The layer by bisection.
    #[must_use]
    pub fn layer(&self) -> Layer {
        /// A length of 10 is known to 10⁻⁴⁷ after so many halvings.
        const HALVINGS: usize = 160;
        let half = self.length.over(&Fixed::whole(2));
        // Far before lift-off the support has to press for ever more: there `V` is still positive.
        let (mut lo, mut hi) = (half.over(&Fixed::whole(1 << 16)), half.clone());
        for _ in 0..HALVINGS {
            let middle = lo.plus(&hi).over(&Fixed::whole(2));
            let end = if self.excess(&half, &middle) < Fixed::zero() { &mut hi } else { &mut lo };
            *end = middle;
        }
        let Free { reaction, moment, shear } = self.free(&lo);
        let square = self.width.times(&self.width);
        let pressure = (Fixed::zero() < square).then(|| self.load.plus(&moment.over(&square)));
        Layer { lift_off: lo, reaction, pressure, resultant: Fixed::zero().minus(&shear) }
    }

    /// `s V cosh z + M sinh z` at a lift-off point, times `2e^{−z}`, `z = (l/2 − a)/s`; `M` where the width is zero.
    fn excess(&self, half: &Fixed, a: &Fixed) -> Fixed {
        let Free { moment, shear, .. } = self.free(a);
        if self.width == Fixed::zero() {
            return moment;
        }
        let decay = a.minus(half).times(&Fixed::whole(2)).over(&self.width).decay();
        let [sum, rest] = [Fixed::whole(1).plus(&decay), Fixed::whole(1).minus(&decay)];
        self.width.times(&shear).times(&sum).plus(&moment.times(&rest))
    }

    /// The free part that has `v = u` and `v' = 0` at its end.
    fn free(&self, a: &Fixed) -> Free {
        let none = self.sunk(a, &Fixed::zero());
        let unit = self.sunk(a, &Fixed::whole(1)).minus(&none);
        let reaction = self.depth.minus(&none).over(&unit);
        let [moment, shear] = self.moment_and_shear(a, &reaction);
        Free { reaction, moment, shear }
    }

    /// `v(a)` for a force `T` of the support and `v'(a) = 0`.
    fn sunk(&self, a: &Fixed, reaction: &Fixed) -> Fixed {
        let [of_reaction, of_load] = [(2, reaction, 2), (3, &self.load, 6)].map(|(power, force, over)| {
            (0..power).fold(force.clone(), |product, _| product.times(a)).over(&Fixed::whole(over))
        });
        let flexibility = self.width.times(&self.width).over(&self.stiffness);
        let [moment, shear] = self.moment_and_shear(a, reaction).map(|value| value.times(&flexibility));
        let bent = of_reaction.minus(&of_load).over(&self.stiffness);
        let start = bent.minus(&shear);
        let [of_reaction, of_load] =
            [of_reaction.over(&Fixed::whole(3)), of_load.over(&Fixed::whole(4))].map(|value| value.times(a));
        start.times(a).minus(&of_reaction.minus(&of_load).over(&self.stiffness)).plus(&moment)
    }

    fn moment_and_shear(&self, a: &Fixed, reaction: &Fixed) -> [Fixed; 2] {
        let weight = self.load.times(a);
        let moment = reaction.times(a).minus(&weight.times(a).over(&Fixed::whole(2)));
        [moment, reaction.minus(&weight)]
    }
}
