//! The gap `g = u − w0` below the undeflected beam: the depth of the foundation minus the initial shape, both enclosed.

use super::foundation::{EnclosedFoundation, inside};
use super::interval::Interval;
use super::polynomial::Polynomial;

/// The gap. The shape of a straight beam is zero, which is subtracted without rounding.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedGap<'a> {
    pub(crate) ground: EnclosedFoundation<'a>,
    pub(crate) shape: EnclosedFoundation<'a>,
}

impl EnclosedGap<'_> {
    /// Ends of cells strictly between two positions, from foundation and shape, unsorted and possibly with duplicates.
    pub(crate) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let bearings = inside(self.ground.bearings, from, to).iter().map(|p| p[0]).collect();
        [self.ground.breaks(from, to), self.shape.breaks(from, to), bearings].concat()
    }

    /// `g(origin + s)` between two positions without a break between them; the origin is within this interval.
    pub(crate) fn about(&self, origin: f64, cell: [f64; 2]) -> Polynomial {
        self.ground.about(origin, cell[0]).minus(&self.shape.about(origin, cell[0]))
    }

    /// A lower bound of the gap between two positions; minus infinity where examining each cell would be necessary.
    pub(crate) fn least(&self, from: f64, to: f64) -> f64 {
        Interval::length(self.shape.level().unwrap_or(f64::INFINITY), self.ground.least(from, to)).lo()
    }

    /// The gap and its first three derivatives at a position, on one of its sides.
    pub(crate) fn jet(&self, x: f64, from_the_left: bool) -> [Interval; 4] {
        let [ground, own] = [self.ground, self.shape].map(|profile| profile.jet(x, from_the_left));
        [0, 1, 2, 3].map(|order| ground[order] - own[order])
    }

    /// `g(x)`, at a step the smaller of the two.
    pub(crate) fn depth(&self, x: f64) -> Interval {
        self.ground.depth(x) - self.shape.depth(x)
    }

    /// False at the points of a polyline.
    pub(crate) fn is_smooth_at(&self, x: f64) -> bool {
        self.ground.is_smooth_at(x) && self.shape.is_smooth_at(x)
    }

    /// True if the gap is one smooth curve between two positions.
    pub(crate) fn is_smooth_between(&self, from: f64, to: f64) -> bool {
        self.ground.is_smooth_between(from, to) && self.shape.is_smooth_between(from, to)
    }

    /// The slope on the right side of a position minus the slope on the left; [`None`] at a step.
    pub(crate) fn kink(&self, x: f64) -> Option<Interval> {
        let kink = |of: EnclosedFoundation<'_>| of.jet(x, false)[1] - of.jet(x, true)[1];
        let [ground, own] = [self.ground, self.shape].map(|u| if u.is_smooth_at(x) { Interval::ZERO } else { kink(u) });
        self.is_continuous_at(x).then(|| ground - own)
    }

    /// False at a step.
    pub(crate) fn is_continuous_at(&self, x: f64) -> bool {
        self.ground.points_at(x).len().max(self.shape.points_at(x).len()) < 2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Foundation;

    /// Foundation `1 + x/2`, initial shape `x/4 + x²/8`, checked with each function of the gap.
    #[test]
    fn the_own_shape_is_taken_off_the_depth() {
        const LENGTH: f64 = 4.0;
        let ground = Foundation::Polynomial { coefficients: vec![1.0, 0.5] };
        let shape = Foundation::Polynomial { coefficients: vec![0.0, 0.25, 0.125] };
        let [ground, shape] = [&ground, &shape].map(|profile| EnclosedFoundation::on(profile, LENGTH));
        let gap = EnclosedGap { ground, shape };
        let close = |found: Interval, expected: f64| {
            assert!(found.lo() <= expected && expected <= found.hi(), "{found:?} for {expected}");
            assert!(found.hi() - found.lo() <= 1e-13, "{found:?}");
        };
        for x in [0.5, 1.0, 3.0] {
            let expected = 1.0 + 0.25 * x - 0.125 * x * x;
            close(gap.depth(x), expected);
            close(gap.about(0.5, [0.5, 3.5]).at(Interval::exact(x - 0.5)), expected);
            close(gap.about(3.5, [0.5, 3.5]).at(Interval::exact(x - 3.5)), expected);
            for from_the_left in [false, true] {
                let [value, slope, bend, third] = gap.jet(x, from_the_left);
                close(value, expected);
                close(slope, 0.25 - 0.25 * x);
                close(bend, -0.25);
                close(third, 0.0);
            }
        }
        let straight = Foundation::Flat { depth: 0.0 };
        let straight = EnclosedGap { ground, shape: EnclosedFoundation::on(&straight, LENGTH) };
        assert_eq!(straight.depth(2.0), ground.depth(2.0), "nothing is rounded");
        assert_eq!(straight.about(0.5, [0.5, 3.5]).coefficients(), ground.about(0.5, 0.5).coefficients());
    }
    /// Foundation and initial shape with a kink and a step each: the kink of the gap is the difference of both, and at a step there is
    /// none. A lower bound of the gap exists only if the shape is level.
    #[test]
    fn both_profiles_turn_the_gap() {
        let line = |points: &[[f64; 2]]| Foundation::Polyline { points: points.to_vec() };
        let ground = line(&[[0.0, 1.0], [1.0, 2.0], [3.0, 2.0], [3.0, 3.0], [4.0, 3.0]]);
        let shape = line(&[[0.0, 0.0], [1.0, 0.5], [2.0, 0.5], [2.0, 0.25], [4.0, 0.25]]);
        let level = Foundation::Flat { depth: 0.25 };
        let [ground, shape, level] = [&ground, &shape, &level].map(|profile| EnclosedFoundation::on(profile, 4.0));
        let gap = EnclosedGap { ground, shape };
        let kink = |x: f64| gap.kink(x).map(|kink| [kink.lo(), kink.hi()]);
        assert_eq!([kink(0.5), kink(2.0), kink(3.0)], [Some([0.0; 2]), None, None]);
        assert!(kink(1.0).is_some_and(|[lo, hi]| lo <= -0.5 && -0.5 <= hi && hi - lo < 1e-15), "{:?}", kink(1.0));
        assert!(gap.least(0.0, 4.0) < f64::MIN, "{}", gap.least(0.0, 4.0));
        let least = EnclosedGap { ground, shape: level }.least(0.5, 4.0);
        assert!(0.75 - 1e-15 < least && least <= 0.75, "{least}");
    }
}
