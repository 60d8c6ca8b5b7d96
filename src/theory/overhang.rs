//! The beam beyond the last place that holds it, by statics.

use super::piecewise::PiecewiseScene;

/// What the loads beyond a place do to the beam, if nothing else acts there.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Overhang {
    /// `∫q`.
    pub(super) force: f64,
    /// `∫q r`: `v''` at the place.
    pub(super) moment: f64,
    /// `∫q r²/2`: by how much the free end turns.
    pub(super) turn: f64,
    /// `∫q r² (3ℓ − r)/6`: how far it sags.
    pub(super) sag: f64,
}

impl Overhang {
    /// The loads between `x` and the left or the right end of the beam, without one just at `x`.
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
        // What a couple does is what a force does, differentiated by its place.
        for at in beyond() {
            let (r, couple) = ((x - at.x).abs(), if at_left { at.acts.couple() } else { -at.acts.couple() });
            sum.moment += couple;
            sum.turn += couple * r;
            sum.sag += couple * r * (2.0 * length - r) / 2.0;
        }
        sum
    }
}
