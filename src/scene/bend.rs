//! The bend of a profile: the change of the chord slope at a position.
//!
//! ```text
//! bend = (u(x + b) − u(x))/b − (u(x) − u(x − a))/a
//! ```
//!
//! On a fine grid the three depths agree in almost all digits, so that their difference would contain only rounding. Each kind of
//! profile therefore has its own formula, in which no digits cancel. A polyline has two formulas. Over few points it is the sum
//! of the kinks. Over many points it is the difference of the two chord slopes, in a time that does not grow with the number of
//! points between.

use std::f64::consts::PI;
use std::ops::Range;

use super::{Foundation, polynomial};

impl Foundation {
    /// The slope of the chord of length `b` to the right of `x` minus the slope of the chord of length `a` to its left; both
    /// lengths are positive. Rounding of `a` and `b` perturbs positions and not depths. `ends` are the positions of the outer
    /// ends of the two chords. At a step of the profile the smallest difference in them matters.
    #[must_use]
    #[inline]
    pub(crate) fn bend(&self, x: f64, a: f64, b: f64, ends: [f64; 2]) -> f64 {
        match self {
            Self::Flat { .. } => 0.0,
            Self::Polynomial { coefficients } => polynomial::bend(coefficients, x, a, b),
            Self::Cosine { amplitude, wavelength, phase, .. } => {
                let rate = 2.0 * PI / wavelength;
                amplitude * rate * cosine(2.0 * PI * (x / wavelength) + phase, 0.5 * rate * a, 0.5 * rate * b)
            }
            Self::Polyline { points } => corners(points, x, a, b, ends).unwrap_or_else(|| {
                let u = self.depth(x);
                (self.depth(ends[1]) - u) / b - (u - self.depth(ends[0])) / a
            }),
        }
    }
}

/// The bend of `cos` at the phase `angle`, with chords of length `2a` to the left and `2b` to the right. With `S(t) = sin t / t`,
///
/// ```text
/// (cos(φ + 2b) − cos φ)/2b = −sin(φ + b) S(b),    (cos φ − cos(φ − 2a))/2a = −sin(φ − a) S(a)
/// bend = −S(a) (sin(φ + b) − sin(φ − a)) − (S(b) − S(a)) sin(φ + b)
/// ```
fn cosine(angle: f64, a: f64, b: f64) -> f64 {
    let (middle, half) = (angle + 0.5 * (b - a), 0.5 * (a + b));
    let sines = 2.0 * libm::cos(middle) * libm::sin(half);
    let uneven = lack(a) - lack(b);
    let lopsided = if uneven == 0.0 { 0.0 } else { uneven * libm::sin(angle + b) };
    -(1.0 - lack(a)) * sines - lopsided
}

/// `1 − sin t / t`, computed from its series where the difference would cancel.
fn lack(t: f64) -> f64 {
    if 0.5 < t.abs() {
        return 1.0 - libm::sin(t) / t;
    }
    let square = t * t;
    // t²/3! (1 − t²/(4·5) (1 − t²/(6·7) (…))): the omitted term, t¹²/(4 ⋯ 15), is relatively below 10⁻¹⁵ for t ≤ 1/2.
    let inner = [156.0, 110.0, 72.0, 42.0, 20.0].iter().fold(1.0, |sum, divisor| 1.0 - square / divisor * sum);
    square / 6.0 * inner
}

/// The greatest number of points between the two ends for which kinks are summed. A kink has the rounding errors of two segment
/// slopes, and two chords have no more. On rough foundations, where segment slopes are far greater than chord slopes, many kinks
/// have far larger errors: a million kinks of both signs cancel except for the last few digits.
const FEW: usize = 8;

/// The bend at `x` of the chords to the two ends; [`None`] if a step affects it.
fn corners(points: &[[f64; 2]], x: f64, a: f64, b: f64, ends: [f64; 2]) -> Option<f64> {
    // An end of the beam may have been rounded beyond the end of the polyline.
    let (from, to) = (ends[0].max(points.first()?[0]), ends[1].min(points.last()?[0]));
    let before = parted(points, equally_spaced(points, from), |p| p[0] < from);
    let first = parted(points, before, |p| p[0] <= from);
    let last = parted(points, first, |p| p[0] < to);
    let behind = parted(points, last, |p| p[0] <= to);
    if before + 1 < first || last + 1 < behind {
        return None;
    }
    if last <= first + FEW {
        // The vertices strictly between the ends, with one neighbour on each side.
        return kinks(points.get(first.checked_sub(1)?..=last)?, x, a, b, [from, to]);
    }
    let middle = parted(points, first, |p| p[0] < x);
    let beyond = parted(points, middle, |p| p[0] <= x);
    if middle + 1 < beyond {
        return None;
    }
    let right = rise(points, [x, to], middle..behind)?;
    Some(right / b - rise(points, [from, x], before..beyond)? / a)
}

/// `Σ κ φ`: the kinks at all points except the first and the last, weighted by a hat function that is 1 at `x` and vanishes at
/// `from` and `to`; [`None`] if there is a step.
fn kinks(points: &[[f64; 2]], x: f64, a: f64, b: f64, [from, to]: [f64; 2]) -> Option<f64> {
    let mut bend = 0.0;
    for three in points.windows(3) {
        let [left, here, right] = [three[0], three[1], three[2]];
        if here[0] <= left[0] || right[0] <= here[0] {
            return None;
        }
        let kink = (right[1] - here[1]) / (right[0] - here[0]) - (here[1] - left[1]) / (here[0] - left[0]);
        let hat = if here[0] < x { (here[0] - from) / a } else { (to - here[0]) / b };
        bend += kink * hat;
    }
    Some(bend)
}

/// The rise of a polyline between two positions, neither of them at a step; `inside` are the points between them. It is the
/// difference of two given depths plus fractions of the segments at both ends. The rounding error is therefore relative to the
/// rise and not to the depths.
fn rise(points: &[[f64; 2]], [from, to]: [f64; 2], inside: Range<usize>) -> Option<f64> {
    // The rise between two positions in the segment that ends at a point.
    let part = |end: usize, [from, to]: [f64; 2]| {
        if to <= from {
            return Some(0.0);
        }
        let (left, right) = (points.get(end.checked_sub(1)?)?, points.get(end)?);
        Some((right[1] - left[1]) * ((to - from) / (right[0] - left[0])))
    };
    let Some([first, .., last]) = points.get(inside.clone()).filter(|inside| 2 <= inside.len()) else {
        let place = points.get(inside.start).filter(|_| !inside.is_empty()).map_or(to, |p| p[0]);
        return Some(part(inside.start, [from, place])? + part(inside.end, [place, to])?);
    };
    Some((last[1] - first[1]) + (part(inside.start, [from, first[0]])? + part(inside.end, [last[0], to])?))
}

/// The index of the point at a position if the points were equally spaced, which is approximately true for surveys.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "the share is limited to the points"
)]
fn equally_spaced(points: &[[f64; 2]], x: f64) -> usize {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return 0 };
    let share = ((x - first[0]) / (last[0] - first[0])).clamp(0.0, 1.0);
    (share * (points.len() - 1) as f64) as usize
}

/// The number of points before a position, as from `partition_point`. The search starts from a guess with steps that double and
/// needs O(log d) steps if the guess is wrong by d.
fn parted(points: &[[f64; 2]], guess: usize, is_before: impl Fn(&[f64; 2]) -> bool) -> usize {
    let (mut low, mut high, mut step) = (guess, guess, 1);
    while 0 < low && !is_before(&points[low - 1]) {
        high = low - 1;
        low = low.saturating_sub(step);
        step *= 2;
    }
    while high < points.len() && is_before(&points[high]) {
        low = high + 1;
        high = points.len().min(high + step);
        step *= 2;
    }
    low + points[low..high].partition_point(is_before)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At the end of the series: `1 − 2 sin ½`, from a program with 40 digits.
    #[test]
    fn what_a_sine_lacks_has_all_its_digits() {
        const LACK: f64 = 0.041_148_922_791_594;
        /// The omitted terms of the series, and rounding.
        const OFF: f64 = 2e-15;
        assert!((lack(0.5) / LACK - 1.0).abs() <= OFF, "{:e}", lack(0.5) / LACK - 1.0);
    }

    /// Compares with the definition, on chords so long that it loses few digits.
    #[test]
    fn every_kind_bends_as_its_depths_do() {
        let points = vec![[0.0, 1.0], [2.0, 0.5], [3.0, 1.5], [3.0, 0.75], [6.0, 0.25], [10.0, 2.0]];
        let profiles = [
            Foundation::Flat { depth: 1.5 },
            Foundation::Polynomial { coefficients: vec![1.0, -0.5, 0.25, 0.125, -0.03] },
            Foundation::Cosine { mean: 1.0, amplitude: 0.5, wavelength: 3.0, phase: 0.7 },
            Foundation::Polyline { points },
        ];
        for profile in &profiles {
            for (x, a, b) in
                [(5.0, 1.0, 1.0), (5.0, 0.5, 2.0), (4.0, 1.0, 0.25), (4.0, 3.0, 6.0), (1.5, 0.75, 1.5), (3.0, 1.0, 1.0)]
            {
                let u = |x| profile.depth(x);
                let expected = (u(x + b) - u(x)) / b - (u(x) - u(x - a)) / a;
                let found = profile.bend(x, a, b, [x - a, x + b]);
                // Depths of up to 300 and lengths of a quarter: a thousand roundings of 10⁻¹⁶.
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{profile:?} at {x}, {a}, {b}: {found} instead of {expected}"
                );
            }
        }
    }

    /// Any number of points, on smooth and rough foundations at any depth. The depths are integers, so that only the two
    /// quotients of the definition are rounded.
    #[test]
    fn the_bend_over_many_points_loses_nothing() {
        const DEEP: f64 = 1_073_741_824.0;
        const HIGH: f64 = 1000.0;
        let (mut state, mut height) = (1_u32, 0.0);
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1_u32 << 24) - 0.5
        };
        for count in [10, 60, 70, 200, 3000, 40_000] {
            let end = f64::from(count);
            let mut walk = |x: f64, random: f64| {
                height = if x == 0.0 { 0.0 } else { height + 30.0 * random };
                height
            };
            let mut made = |kind: usize, x: f64, random: f64| match kind {
                0 => HIGH * random,
                1 => walk(x, random),
                _ => HIGH * libm::sin(5.0 * x / end),
            };
            for kind in 0..3 {
                let mut at = |x: f64| [x, DEEP + made(kind, x, noise()).round()];
                let points: Vec<[f64; 2]> = (0..=count).map(|x| at(f64::from(x))).collect();
                let most = points.iter().fold(0.0_f64, |most, p| most.max((p[1] - DEEP).abs()));
                let profile = Foundation::Polyline { points };
                for [from, x, to] in
                    [[0.0, 0.5, 1.0], [0.0, 0.3, 1.0], [0.1, 0.6, 0.9], [0.0, 0.001, 0.99], [0.5, 0.9999, 1.0]]
                {
                    let [from, x, to] = [from, x, to].map(|share| (2.0 * share * end).round() / 2.0);
                    let (a, b) = (x - from, to - x);
                    if a <= 0.0 || b <= 0.0 {
                        continue;
                    }
                    let u = |x| profile.depth(x);
                    let expected = (u(to) - u(x)) / b - (u(x) - u(from)) / a;
                    // A few roundings of each of the two slopes, and of segments at the ends.
                    let most = 16.0 * f64::EPSILON * most * (1.0 / a + 1.0 / b);
                    let found = profile.bend(x, a, b, [from, to]);
                    assert!(
                        (found - expected).abs() <= most,
                        "kind {kind}, {count} points, {from}, {x}, {to}: {found:e}"
                    );
                }
            }
        }
    }

    /// A step between the ends has no effect. A step at an end or at `x` has one: the smaller depth governs there.
    #[test]
    fn steps_bend_as_depths_do() {
        let points: Vec<[f64; 2]> =
            (0..1000).map(|i| [f64::from(i - i / 100), 5.0 + f64::from(i % 7) - f64::from(i % 100)]).collect();
        let profile = Foundation::Polyline { points };
        for (from, x, to) in [(0.0, 300.5, 900.0), (0.0, 99.0, 300.0), (10.0, 98.5, 99.0), (99.0, 250.0, 700.5)] {
            let u = |x| profile.depth(x);
            let (a, b) = (x - from, to - x);
            let expected = (u(to) - u(x)) / b - (u(x) - u(from)) / a;
            let found = profile.bend(x, a, b, [from, to]);
            // Depths of up to a hundred, with a few roundings.
            assert!((found - expected).abs() < 1e-13, "{from}, {x}, {to}: {found} instead of {expected}");
        }
    }

    /// From every guess, with several points at one position and positions beyond all points.
    #[test]
    fn points_are_parted_from_any_guess() {
        let points: Vec<[f64; 2]> = [0, 1, 2, 2, 3, 5, 8, 8, 8, 9].map(|x| [f64::from(x), 0.0]).to_vec();
        for guess in 0..=points.len() {
            for x in [-1.0, 0.0, 0.5, 2.0, 4.0, 8.0, 8.5, 9.0, 10.0] {
                assert_eq!(parted(&points, guess, |p| p[0] < x), points.partition_point(|p| p[0] < x), "{x}");
                assert_eq!(parted(&points, guess, |p| p[0] <= x), points.partition_point(|p| p[0] <= x), "{x}");
                assert!(equally_spaced(&points, x) < points.len());
            }
        }
    }

    /// Where the depths agree in all digits, the bend of a cosine still follows its curvature.
    #[test]
    fn a_short_chord_loses_nothing() {
        let (wave, step) = (Foundation::Cosine { mean: 1e6, amplitude: 1.0, wavelength: 2.0 * PI, phase: 0.0 }, 1e-7);
        // u'' = −cos x; the next term of the second difference is smaller by the square of the step.
        assert!((wave.bend(1.0, step, step, [1.0 - step, 1.0 + step]) / (-libm::cos(1.0) * step) - 1.0).abs() < 1e-13);
        let dish = Foundation::Polynomial { coefficients: vec![1e6, 0.0, 0.5] };
        assert!((dish.bend(1.0, step, 2.0 * step, [1.0 - step, 1.0 + 2.0 * step]) / (1.5 * step) - 1.0).abs() < 1e-15);
    }
}
