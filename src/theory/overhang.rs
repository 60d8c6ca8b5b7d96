//! The beam beyond its outermost support or contact, by statics.

use super::piecewise::PiecewiseScene;

/// The effect of the loads beyond a position on the beam, if nothing else acts there.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Overhang {
    /// `∫q`.
    pub(super) force: f64,
    /// `∫q r`: `v''` at the position.
    pub(super) moment: f64,
    /// `∫q r²/2`: the rotation of the free end.
    pub(super) turn: f64,
    /// `∫q r² (3ℓ − r)/6`: the deflection of the free end.
    pub(super) sag: f64,
}

impl Overhang {
    /// The loads between `x` and the left or the right end of the beam, without a load exactly at `x`.
    pub(super) fn of(given: &PiecewiseScene, x: f64, at_left: bool) -> Self {
        let [from, to] = if at_left { [0.0, x] } else { [x, given.length] };
        let mut sum = Self::default();
        let length = to - from;
        if length <= 0.0 {
            return sum;
        }
        let mut add = |at: f64, force: f64| {
            let r = (x - at).abs();
            sum.force += force;
            sum.moment += force * r;
            sum.turn += force * r * r / 2.0;
            sum.sag += force * r * r * (3.0 * length - r) / 6.0;
        };
        for (cell, [lo, hi]) in given.loaded([from, to], [given.cell_from(from), given.cell_to(to)]) {
            for (t, weight) in given.load_rule.points(0.0, hi - lo) {
                add(lo + t, weight * given.load_beyond(cell, lo, t));
            }
        }
        let beyond = || given.forces().filter(|at| if at_left { at.x < x } else { x < at.x });
        beyond().for_each(|at| add(at.x, at.acts.force()));
        // The effect of a couple is the derivative of the effect of a force with respect to its position.
        for at in beyond() {
            let (r, couple) = ((x - at.x).abs(), if at_left { at.acts.couple() } else { -at.acts.couple() });
            sum.moment += couple;
            sum.turn += couple * r;
            sum.sag += couple * r * (2.0 * length - r) / 2.0;
        }
        sum
    }
}
