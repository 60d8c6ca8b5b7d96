//! What a scene is up to rounding, decided here and nowhere else, so that beam theory and certificate solve the same one.
//!
//! The numbers of a scene are decimals, and known no better than their rounding. Taken to the last bit, a point on a straight
//! line would be a kink, the same depth computed twice a step, and a foundation that starts at a support a gap of `10⁻¹⁷`.

use super::Foundation;

/// A depth at a support is zero but for rounding if it is at most this share of the numbers that add up to it there. With a
/// depth of `−10⁻¹⁷` the scene would have no solution, with `10⁻¹⁷` the beam would lift off just beside the support.
pub(super) const LEVEL: f64 = 16.0 * f64::EPSILON;

/// How far off the line a point may be, as a share of its depth and of what its neighbours add to that of the line there: the
/// rounding of a decimal depth, twice, and that of the interpolation.
const ON_THE_LINE: f64 = 8.0 * f64::EPSILON;
/// Of the points between two that are kept, at most so many are compared anew with every longer line, and at least half as many.
const MOST_BETWEEN: usize = 64;

/// A place of a load or a support on a dimensionless beam, the length of which is at least 1 and less than 2: numbers there are
/// `ε/2` apart at the least but for those beside zero, which no length of a beam needs. A place nearer to the left end is at it.
pub(super) fn place(x: f64) -> f64 {
    if x < 0.5 * f64::EPSILON { 0.0 } else { x }
}

impl Foundation {
    /// The numbers that add up to its depth at a place of a beam of this length, where they may be rounded: at `x = 0` a
    /// polynomial is its first coefficient, however large the others. The depths of points and of a plane are given, and
    /// nothing is added up.
    pub(crate) fn rounded_size(&self, x: f64, length: f64) -> f64 {
        match self {
            Self::Flat { .. } => 0.0,
            Self::Polyline { points } if points.binary_search_by(|p| p[0].total_cmp(&x)).is_ok() => 0.0,
            smooth => smooth.magnitude_at(x).min(smooth.magnitude(length)),
        }
    }

    /// A depth at a support `x` that is no larger cannot be told from zero: the foundation starts at the level of the support.
    pub(crate) fn level_within(&self, x: f64, length: f64) -> f64 {
        LEVEL * self.rounded_size(x, length)
    }

    /// The same foundation, if it is a polyline that can do without some of its points. A beam that lies across a corner of the
    /// size of rounding could not be told from one that hangs on it.
    pub(crate) fn without_collinear_points(&self) -> Option<Self> {
        let Self::Polyline { points } = self else { return None };
        let kept = without_collinear_points(points);
        (kept.len() < points.len()).then_some(Self::Polyline { points: kept })
    }
}

/// A polyline without the points that make no corner: points that are off the line of their neighbours by rounding, points
/// that are given twice, and steps of the size of rounding.
pub(crate) fn without_collinear_points(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let mut between: Vec<[f64; 2]> = Vec::new();
    for (i, &point) in points.iter().enumerate() {
        let Some(&last) = kept.last() else {
            kept.push(point);
            continue;
        };
        let next = points.get(i + 1);
        if between.len() == MOST_BETWEEN {
            let mut every_other = false;
            between.retain(|_| {
                every_other = !every_other;
                every_other
            });
        }
        between.push(point);
        if next.is_none_or(|&next| !between.iter().all(|p| lies_between(last, *p, next))) {
            kept.push(point);
            between.clear();
        }
    }
    kept
}

/// Whether `p`, at or between the places of `a` and `b`, is on the line from one to the other. Of three points at one place
/// none is: there is no line.
fn lies_between(a: [f64; 2], p: [f64; 2], b: [f64; 2]) -> bool {
    let share = (p[0] - a[0]) / (b[0] - a[0]);
    // Not by the difference of the two depths: beside the shallower point it would be the rounding of the deeper one.
    let [from_a, from_b] = [a[1] * (1.0 - share), b[1] * share];
    (p[1] - (from_a + from_b)).abs() <= ON_THE_LINE * p[1].abs().max(from_a.abs()).max(from_b.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_far_below_does_not_straighten_a_ridge() {
        let points = [[0.0, 1e-16], [1.0, 1e-7], [2.0, -1e-16], [3.0, 1e-16], [4.0, 1e9]];
        assert_eq!(without_collinear_points(&points), points);
    }

    /// Depths in tenths, which are not on a line in 64-bit numbers: what is written as a line is one, and its corners stay.
    #[test]
    fn points_on_a_line_are_taken_out() {
        let tenth = |k: i32| f64::from(k) * 0.1;
        let rising: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), 1.0 + tenth(3 * k)]).collect();
        assert_eq!(without_collinear_points(&rising), [rising[0], rising[30]]);
        let falling: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), 11.0 - tenth(3 * k)]).collect();
        assert_eq!(without_collinear_points(&falling), [falling[0], falling[30]]);
        let mut roof = rising.clone();
        roof.extend((1..=30).map(|k| [tenth(30 + k), 10.0 - tenth(k)]));
        assert_eq!(without_collinear_points(&roof), [roof[0], roof[30], roof[60]]);
        // Through depth zero, where only what is added up says how large rounding may be.
        let through: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), tenth(3 * k) - 4.2]).collect();
        assert_eq!(without_collinear_points(&through), [through[0], through[30]]);
    }

    /// A point that is off by more than rounding is a corner, however near it is to one of its neighbours; and a foundation with
    /// nothing to take out is left alone.
    #[test]
    fn corners_stay() {
        for (x, off) in [(1.0, 1e-14), (5.0, 2e-14), (9.0, -2e-14), (0.001, 1e-14), (9.999, -3e-14), (5.0, 1.0)] {
            let bent = [[0.0, 2.0], [x, 2.0 + 0.3 * x + off], [10.0, 5.0]];
            assert_eq!(without_collinear_points(&bent), bent, "{x}, {off}");
            let straight = [[0.0, 2.0], [x, 2.0 + 0.3 * x], [10.0, 5.0]];
            assert_eq!(without_collinear_points(&straight), [straight[0], straight[2]], "{x}");
        }
        // Through zero depth, and from one that is nearly zero: a neighbour counts by its share.
        let steep = [[0.0, 1e-3], [1.0, 1.0 + 2e-15], [2.0, 2.0 - 1e-3]];
        let mirrored = [steep[2], steep[1], steep[0]].map(|[x, depth]| [2.0 - x, depth]);
        for points in [[[0.0, -1.0], [2.0, 2e-15], [4.0, 1.0]], steep, mirrored] {
            assert_eq!(without_collinear_points(&points), points, "{points:?}");
        }
    }

    /// Steps stay with both of their depths, also where the line goes on behind them; a point that is given twice goes.
    #[test]
    fn steps_stay_and_doubles_go() {
        let step = [[0.0, 1.0], [2.0, 1.0], [2.0, 1.5], [4.0, 1.5]];
        assert_eq!(without_collinear_points(&step), step);
        let spike = [[0.0, 1.0], [2.0, 1.0], [2.0, 1.5], [2.0, 1.0], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&spike), spike);
        let double = [[0.0, 1.0], [2.0, 3.0], [2.0, 3.0], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&double), [double[0], double[1], double[3]]);
        let all = [[0.0, 1.0], [0.0, 1.0], [2.0, 3.0], [2.0, 3.0], [2.0, 3.0], [4.0, 1.0], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&all), [[0.0, 1.0], [2.0, 3.0], [4.0, 1.0]]);
        let through_zero =
            [[0.0, 1.0], [2.0, 1.0], [2.0, 0.0], [3.0, 0.0], [3.0, -1.0], [3.5, -1.0], [3.5, 1.0], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&through_zero), through_zero);
        let beside_a_depth = [[0.0, 1e60], [2.0, 1e-20], [2.0, 1.0], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&beside_a_depth), beside_a_depth);
        let rounding = [[0.0, 1.0], [2.0, 1.0], [2.0, 1.0 + f64::EPSILON], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&rounding), [rounding[0], rounding[3]]);
        let at_the_ends = [[0.0, 1.0], [0.0, 2.0], [2.0, 2.0], [4.0, 2.0], [4.0, 1.0]];
        assert_eq!(without_collinear_points(&at_the_ends), [[0.0, 1.0], [0.0, 2.0], [4.0, 2.0], [4.0, 1.0]]);
    }

    /// A polygon of chords so short that each corner is of rounding size, and the arc is not: what is kept is nowhere off by more
    /// than is said, so that corners of rounding size do not add up to one that counts.
    #[test]
    fn what_is_taken_out_does_not_add_up() {
        let arc: Vec<[f64; 2]> = (0..=1000).map(f64::from).map(|x| [x, 1.0 + 1e-16 * x * (1000.0 - x)]).collect();
        let chords = without_collinear_points(&arc);
        assert!(chords.len() < arc.len() / 2, "{} of {} points are kept", chords.len(), arc.len());
        for [x, depth] in arc {
            let after = chords.partition_point(|p| p[0] < x).max(1);
            let (a, b) = (chords[after - 1], chords[after]);
            let off = depth - (a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])));
            assert!(off.abs() <= (ON_THE_LINE + f64::EPSILON) * depth, "off by {off:e} at {x}");
        }
    }

    /// However many points a line has, it is one.
    #[test]
    fn long_lines_are_one() {
        let line: Vec<[f64; 2]> = (0..=2000).map(f64::from).map(|x| [x, 0.1 + 0.3 * x]).collect();
        assert_eq!(without_collinear_points(&line), [line[0], line[2000]]);
    }
}
