//! Decisions on rounding in a scene. They are made only here, so that beam theory and certificate solve the same problem.
//!
//! The numbers of a scene are decimals and known only to their rounding. Taken to the last bit, a point on a straight line would
//! be a kink, the same depth computed twice would be a step, and a foundation that begins at a support would have a gap of
//! `10⁻¹⁷`.

use super::Foundation;

/// A depth at a support counts as zero if it is at most this fraction of the terms that add up to it there. With a depth of
/// `−10⁻¹⁷` the scene would have no solution, and with `10⁻¹⁷` the beam would lift off just beside the support.
pub(super) const LEVEL: f64 = 16.0 * f64::EPSILON;

/// The greatest distance of a point from a line, relative to its depth and to the two terms of the interpolation between its
/// neighbours: twice the rounding of a decimal depth, and the rounding of the interpolation.
const ON_THE_LINE: f64 = 8.0 * f64::EPSILON;
/// The greatest number of omitted points between two kept ones that are compared with each longer line. At least half as many are
/// compared.
const MOST_BETWEEN: usize = 64;

/// A position of a load or a support on a dimensionless beam with a length of at least 1 and less than 2. Numbers in this range
/// are at least `ε/2` apart except near zero, where a beam does not need smaller distances. A position nearer to the left end is
/// moved to it.
pub(super) fn place(x: f64) -> f64 {
    if x < 0.5 * f64::EPSILON { 0.0 } else { x }
}

impl Foundation {
    /// The magnitude of the terms that add up to the depth at a position of a beam of this length, where they may be rounded. At
    /// `x = 0` a polynomial is its first coefficient, however large the others are. The depths of points and of a flat foundation
    /// are given, so that nothing is added up.
    pub(crate) fn rounded_size(&self, x: f64, length: f64) -> f64 {
        match self {
            Self::Flat { .. } => 0.0,
            Self::Polyline { points } if points.binary_search_by(|p| p[0].total_cmp(&x)).is_ok() => 0.0,
            smooth => smooth.magnitude_at(x).min(smooth.magnitude(length)),
        }
    }

    /// The greatest depth relative to a support at `x` that cannot be distinguished from zero: the foundation begins at the level
    /// of the support.
    pub(crate) fn level_within(&self, x: f64, length: f64) -> f64 {
        LEVEL * self.rounded_size(x, length)
    }

    /// The same foundation with fewer points if it is a polyline with collinear points; otherwise [`None`]. A beam that passes
    /// over a corner of the size of rounding could not be distinguished from a beam that touches it.
    pub(crate) fn without_collinear_points(&self) -> Option<Self> {
        let Self::Polyline { points } = self else { return None };
        let kept = without_collinear_points(points);
        (kept.len() < points.len()).then_some(Self::Polyline { points: kept })
    }
}

/// A polyline without points that form no corner: points whose distance from the line through their neighbours is rounding,
/// points given twice, and steps of the size of rounding.
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

/// Whether `p`, at or between the positions of `a` and `b`, is on the line through them. Three points at one position define no
/// line.
fn lies_between(a: [f64; 2], p: [f64; 2], b: [f64; 2]) -> bool {
    let share = (p[0] - a[0]) / (b[0] - a[0]);
    // The difference of the two depths is not used: near the shallower point it would contain the rounding of the deeper one.
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

    /// Depths in tenths, which are not collinear in 64-bit arithmetic. Points written on a line count as collinear, and corners
    /// are kept.
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
        // Through depth zero, where only the terms of the sum limit the rounding.
        let through: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), tenth(3 * k) - 4.2]).collect();
        assert_eq!(without_collinear_points(&through), [through[0], through[30]]);
    }

    /// A point whose distance from the line exceeds rounding is a corner, however near it is to a neighbour. A foundation without
    /// collinear points is not changed.
    #[test]
    fn corners_stay() {
        for (x, off) in [(1.0, 1e-14), (5.0, 2e-14), (9.0, -2e-14), (0.001, 1e-14), (9.999, -3e-14), (5.0, 1.0)] {
            let bent = [[0.0, 2.0], [x, 2.0 + 0.3 * x + off], [10.0, 5.0]];
            assert_eq!(without_collinear_points(&bent), bent, "{x}, {off}");
            let straight = [[0.0, 2.0], [x, 2.0 + 0.3 * x], [10.0, 5.0]];
            assert_eq!(without_collinear_points(&straight), [straight[0], straight[2]], "{x}");
        }
        // Through zero depth, and from a depth of nearly zero: a neighbour counts in proportion to its share.
        let steep = [[0.0, 1e-3], [1.0, 1.0 + 2e-15], [2.0, 2.0 - 1e-3]];
        let mirrored = [steep[2], steep[1], steep[0]].map(|[x, depth]| [2.0 - x, depth]);
        for points in [[[0.0, -1.0], [2.0, 2e-15], [4.0, 1.0]], steep, mirrored] {
            assert_eq!(without_collinear_points(&points), points, "{points:?}");
        }
    }

    /// Steps keep both depths, also if the line continues behind them. A point given twice is removed.
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

    /// A polygon with chords so short that each corner is of the size of rounding, although the arc is not. The simplified
    /// polyline deviates nowhere by more than the tolerance, so that many small corners do not add up to a large error.
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

    /// A line is simplified to its ends, however many points it has.
    #[test]
    fn long_lines_are_one() {
        let line: Vec<[f64; 2]> = (0..=2000).map(f64::from).map(|x| [x, 0.1 + 0.3 * x]).collect();
        assert_eq!(without_collinear_points(&line), [line[0], line[2000]]);
    }
}
