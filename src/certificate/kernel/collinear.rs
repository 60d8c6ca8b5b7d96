//! A polyline without the points that make no corner.
//!
//! Points that lie on one line in a drawing do not in 64-bit numbers, and the corner between them, of the size of rounding,
//! would be one: a beam that lies across it could not be told from one that hangs on it. A point that is off the line of its
//! neighbours by rounding is taken to lie on it, as a survey in decimals means it. So is a point that is given twice, and a step
//! of the size of rounding is none.

use crate::scene::Foundation;

/// How far off the line a point may be, as a share of its depth and of what its neighbours add to that of the line there.
const ON_THE_LINE: f64 = 8.0 * f64::EPSILON;
/// Points between two that are kept, at most: each is compared anew with every longer line.
const MOST_BETWEEN: usize = 64;

/// The foundation, if it is a polyline that can do without some of its points.
pub(crate) fn without_collinear_points(foundation: &Foundation) -> Option<Foundation> {
    let Foundation::Polyline { points } = foundation else { return None };
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let mut between: Vec<[f64; 2]> = Vec::new();
    for (i, &point) in points.iter().enumerate() {
        let Some(&last) = kept.last() else {
            kept.push(point);
            continue;
        };
        let next = points.get(i + 1);
        between.push(point);
        let skips = next
            .is_some_and(|&next| between.len() < MOST_BETWEEN && between.iter().all(|p| lies_between(last, *p, next)));
        if !skips {
            kept.push(point);
            between.clear();
        }
    }
    (kept.len() < points.len()).then_some(Foundation::Polyline { points: kept })
}

/// Whether `p`, at or between the places of `a` and `b`, is on the line from one to the other. Of three points at one place
/// none is: there is no line.
fn lies_between(a: [f64; 2], p: [f64; 2], b: [f64; 2]) -> bool {
    let share = (p[0] - a[0]) / (b[0] - a[0]);
    // Not by the difference of the two, in which the deeper one swallows what the other has to say close to itself.
    let [from_a, from_b] = [a[1] * (1.0 - share), b[1] * share];
    (p[1] - (from_a + from_b)).abs() <= ON_THE_LINE * p[1].abs().max(from_a.abs()).max(from_b.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        match without_collinear_points(&Foundation::Polyline { points: points.to_vec() }) {
            Some(Foundation::Polyline { points }) => points,
            _ => points.to_vec(),
        }
    }

    /// Depths in tenths, which are not on a line in 64-bit numbers: what is written as a line is one, and its corners stay.
    #[test]
    fn points_on_a_line_are_taken_out() {
        let tenth = |k: i32| f64::from(k) * 0.1;
        let rising: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), 1.0 + tenth(3 * k)]).collect();
        assert_eq!(kept(&rising), [rising[0], rising[30]]);
        let falling: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), 11.0 - tenth(3 * k)]).collect();
        assert_eq!(kept(&falling), [falling[0], falling[30]]);
        let mut roof = rising.clone();
        roof.extend((1..=30).map(|k| [tenth(30 + k), 10.0 - tenth(k)]));
        assert_eq!(kept(&roof), [roof[0], roof[30], roof[60]]);
        // Through depth zero, where only what is added up says how large rounding may be.
        let through: Vec<[f64; 2]> = (0..=30).map(|k| [tenth(k), tenth(3 * k) - 4.2]).collect();
        assert_eq!(kept(&through), [through[0], through[30]]);
        assert_eq!(without_collinear_points(&Foundation::Flat { depth: 1.0 }), None);
    }

    /// A point that is off by more than rounding is a corner, however near it is to one of its neighbours; and a foundation with
    /// nothing to take out is left alone.
    #[test]
    fn corners_stay() {
        for (x, off) in [(1.0, 1e-14), (5.0, 2e-14), (9.0, -2e-14), (0.001, 1e-14), (9.999, -3e-14), (5.0, 1.0)] {
            let bent = [[0.0, 2.0], [x, 2.0 + 0.3 * x + off], [10.0, 5.0]];
            assert_eq!(without_collinear_points(&Foundation::Polyline { points: bent.to_vec() }), None, "{x}, {off}");
            let straight = [[0.0, 2.0], [x, 2.0 + 0.3 * x], [10.0, 5.0]];
            assert_eq!(kept(&straight), [straight[0], straight[2]], "{x}");
        }
        // Through zero depth, and from one that is nearly zero: a neighbour counts by its share.
        let steep = [[0.0, 1e-3], [1.0, 1.0 + 2e-15], [2.0, 2.0 - 1e-3]];
        let mirrored = [steep[2], steep[1], steep[0]].map(|[x, depth]| [2.0 - x, depth]);
        for points in [[[0.0, -1.0], [2.0, 2e-15], [4.0, 1.0]], steep, mirrored] {
            assert_eq!(without_collinear_points(&Foundation::Polyline { points: points.to_vec() }), None, "{points:?}");
        }
    }

    /// Steps stay with both of their depths, also where the line goes on behind them; a point that is given twice goes.
    #[test]
    fn steps_stay_and_doubles_go() {
        let step = [[0.0, 1.0], [2.0, 1.0], [2.0, 1.5], [4.0, 1.5]];
        assert_eq!(kept(&step), step);
        let spike = [[0.0, 1.0], [2.0, 1.0], [2.0, 1.5], [2.0, 1.0], [4.0, 1.0]];
        assert_eq!(kept(&spike), spike);
        let double = [[0.0, 1.0], [2.0, 3.0], [2.0, 3.0], [4.0, 1.0]];
        assert_eq!(kept(&double), [double[0], double[1], double[3]]);
        let all = [[0.0, 1.0], [0.0, 1.0], [2.0, 3.0], [2.0, 3.0], [2.0, 3.0], [4.0, 1.0], [4.0, 1.0]];
        assert_eq!(kept(&all), [[0.0, 1.0], [2.0, 3.0], [4.0, 1.0]]);
        let through_zero =
            [[0.0, 1.0], [2.0, 1.0], [2.0, 0.0], [3.0, 0.0], [3.0, -1.0], [3.5, -1.0], [3.5, 1.0], [4.0, 1.0]];
        assert_eq!(kept(&through_zero), through_zero);
        let beside_a_depth = [[0.0, 1e60], [2.0, 1e-20], [2.0, 1.0], [4.0, 1.0]];
        assert_eq!(kept(&beside_a_depth), beside_a_depth);
        let rounding = [[0.0, 1.0], [2.0, 1.0], [2.0, 1.0 + f64::EPSILON], [4.0, 1.0]];
        assert_eq!(kept(&rounding), [rounding[0], rounding[3]]);
        let at_the_ends = [[0.0, 1.0], [0.0, 2.0], [2.0, 2.0], [4.0, 2.0], [4.0, 1.0]];
        assert_eq!(kept(&at_the_ends), [[0.0, 1.0], [0.0, 2.0], [4.0, 2.0], [4.0, 1.0]]);
    }

    /// A polygon of chords so short that each corner is of rounding size, and the arc is not: what is kept is nowhere off by more
    /// than is said, so that corners of rounding size do not add up to one that counts.
    #[test]
    fn what_is_taken_out_does_not_add_up() {
        let arc: Vec<[f64; 2]> = (0..=1000).map(f64::from).map(|x| [x, 1.0 + 1e-16 * x * (1000.0 - x)]).collect();
        let chords = kept(&arc);
        assert!(chords.len() < arc.len() / 2, "{} of {} points are kept", chords.len(), arc.len());
        for [x, depth] in arc {
            let after = chords.partition_point(|p| p[0] < x).max(1);
            let (a, b) = (chords[after - 1], chords[after]);
            let off = depth - (a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])));
            assert!(off.abs() <= (ON_THE_LINE + f64::EPSILON) * depth, "off by {off:e} at {x}");
        }
    }

    /// Between two points that are kept there are at most so many others.
    #[test]
    fn long_lines_keep_some_points() {
        let line: Vec<[f64; 2]> = (0..=200).map(f64::from).map(|x| [x, 1.0]).collect();
        let places: Vec<f64> = kept(&line).iter().map(|p| p[0]).collect();
        assert_eq!(places, [0.0, 64.0, 128.0, 192.0, 200.0]);
    }
}
