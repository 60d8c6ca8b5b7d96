//! A foundation as a sequence of smooth pieces.

use super::shape::Shape;
use crate::scene::Foundation;

/// Smooth pieces of a foundation, and the places where one ends and the next begins.
pub(super) fn shapes_of(foundation: &Foundation, length: f64) -> (Vec<Shape>, Vec<f64>) {
    match foundation {
        Foundation::Flat { depth } => (vec![Shape::Polynomial { origin: 0.0, coefficients: vec![*depth] }], Vec::new()),
        Foundation::Polynomial { coefficients } => {
            let used = coefficients.iter().rposition(|&c| c != 0.0).map_or(1, |i| i + 1);
            (vec![Shape::Polynomial { origin: 0.0, coefficients: coefficients[..used].to_vec() }], Vec::new())
        }
        &Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            (vec![Shape::Cosine { mean, amplitude, wavelength, phase }], Vec::new())
        }
        Foundation::Polyline { points } => lines_of(&without_straight_points(points), length),
    }
}

/// The segments of a polyline; a step is no segment.
fn lines_of(points: &[[f64; 2]], length: f64) -> (Vec<Shape>, Vec<f64>) {
    let segments = || points.windows(2).filter(|w| w[0][0] < w[1][0] && w[0][0] < length && 0.0 < w[1][0]);
    let shapes = segments().map(|w| Shape::line(w[0], w[1])).collect();
    (shapes, segments().skip(1).map(|w| w[0][0]).collect())
}

/// A polyline without the points at which it goes straight on up to rounding: they are no kinks.
fn without_straight_points(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    /// The rounding of a decimal depth, twice, and that of the interpolation.
    const ROUNDING: f64 = 8.0 * f64::EPSILON;
    // A step of no height is no step.
    let mut points = points.to_vec();
    points.dedup();
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        if let (Some(&before), Some(&after)) = (kept.last(), points.get(i + 1))
            && before[0] < p[0]
            && p[0] < after[0]
        {
            let s = (p[0] - before[0]) / (after[0] - before[0]);
            let straight = before[1] + (after[1] - before[1]) * s;
            // Of the numbers that make up the depth at that place: a point far below rounds nothing elsewhere.
            let magnitude = p[1].abs().max((before[1] * (1.0 - s)).abs()).max((after[1] * s).abs());
            if (p[1] - straight).abs() <= ROUNDING * magnitude {
                continue;
            }
        }
        kept.push(p);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_are_no_kinks() {
        let points: Vec<[f64; 2]> = (0..=10).map(|i| [0.1 * f64::from(i), 0.3 + 0.07 * f64::from(i)]).collect();
        assert_eq!(without_straight_points(&points).len(), 2);
    }

    #[test]
    fn a_point_far_below_does_not_straighten_a_ridge() {
        let points = [[0.0, 1e-16], [1.0, 1e-7], [2.0, -1e-16], [3.0, 1e-16], [4.0, 1e9]];
        assert_eq!(without_straight_points(&points), points);
    }
}
