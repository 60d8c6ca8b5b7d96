//! Cells of the foundation against depths that can be computed exactly, and what is asked of a polyline against one with
//! everything that a polyline can have.

use super::*;

pub(in super::super) const LENGTH: f64 = 16.0;

impl<'a> EnclosedFoundation<'a> {
    /// With nothing that stands above it.
    pub(crate) fn on(given: &'a Foundation, length: f64) -> Self {
        Self { given, length, bearings: &[] }
    }
}

#[track_caller]
fn encloses(cell: &Polynomial, s: f64, value: f64, slack: f64) {
    let range = cell.at(Interval::exact(s));
    assert!(range.lo() - slack <= value && value <= range.hi() + slack, "{value} at {s}, not in {range:?}");
}

/// `u(from + s)` and `u(to − s)`.
fn from_both_ends(ground: &EnclosedFoundation<'_>, from: f64, to: f64) -> [Polynomial; 2] {
    [ground.about(from, from), ground.about(to, from).mirrored()]
}

/// `T_6(x/4 − 1)`, the terms of which add up to 20,000: the cell encloses what its recurrence gives, to some roundings of 1.
#[test]
fn the_cell_of_a_polynomial_is_sharp() {
    const ROUNDING: f64 = 1e-13;
    let (mut last, mut this) = (vec![1.0], vec![-1.0, 0.25]);
    for _ in 1..6 {
        let mut next = vec![0.0; this.len() + 1];
        for (j, c) in this.iter().enumerate() {
            next[j] -= 2.0 * c;
            next[j + 1] += 0.5 * c;
        }
        next.iter_mut().zip(&last).for_each(|(next, last)| *next -= last);
        (last, this) = (this, next);
    }
    let chebyshev = |x: f64| {
        let t = x / 4.0 - 1.0;
        (1..6).fold((1.0, t), |(last, this), _| (this, 2.0 * t * this - last)).1
    };
    let foundation = Foundation::Polynomial { coefficients: this };
    let ground = EnclosedFoundation::on(&foundation, 8.0);
    assert!(ground.breaks(0.0, 8.0).is_empty(), "one cell");
    for [from, to] in [[0.0, 1.0], [3.0, 4.0], [7.0, 8.0]] {
        let [enclosed, mirrored] = from_both_ends(&ground, from, to);
        for x in [from, 0.5 * (from + to), to] {
            encloses(&enclosed, x - from, chebyshev(x), ROUNDING);
            encloses(&mirrored, to - x, chebyshev(x), ROUNDING);
            let range = enclosed.at(Interval::exact(x - from));
            assert!(range.hi() - range.lo() < 10.0 * ROUNDING, "{range:?} at {x}");
        }
    }
}

/// The same for a cosine, on a cell as long as the wave; on one of those that it is cut into the remainder is of rounding size.
#[test]
fn cells_of_a_cosine_enclose_it() {
    /// Of libm's cosine and its argument.
    const ROUNDING: f64 = 1e-14;
    let (mean, amplitude, wavelength, phase) = (3.0, 2.0, 8.0, 0.5);
    let foundation = Foundation::Cosine { mean, amplitude, wavelength, phase };
    let ground = EnclosedFoundation::on(&foundation, LENGTH);
    let depth = |x: f64| mean + amplitude * libm::cos(std::f64::consts::TAU * x / wavelength + phase);
    for (from, to) in [(1.0, 9.0), (2.0, 2.25)] {
        let [cell, mirrored] = from_both_ends(&ground, from, to);
        for k in 0..=8 {
            let s = (to - from) * f64::from(k) / 8.0;
            encloses(&cell, s, depth(from + s), ROUNDING);
            encloses(&mirrored, s, depth(to - s), ROUNDING);
        }
    }
    let range = ground.about(2.0, 2.0).at(Interval::exact(0.25));
    assert!(range.hi() - range.lo() <= 20.0 * ROUNDING, "{range:?}");
}

#[test]
fn cells_end_where_they_are_said_to() {
    let wave = Foundation::Cosine { mean: 1.0, amplitude: 0.5, wavelength: 64.0, phase: 0.0 };
    assert_eq!(EnclosedFoundation::on(&wave, LENGTH).breaks(9.0, 14.0), [10.0, 12.0], "32 cells in a wave");
}

/// Level at the left, a kink that points down, a line of two segments, a step up, a kink that points up, a step down.
fn survey() -> Foundation {
    let points = [
        [0.0, 2.0],
        [1.0, 2.0],
        [2.0, 2.0],
        [3.0, 4.0],
        [4.0, 3.0],
        [5.0, 2.0],
        [5.0, 1.0],
        [6.0, 3.0],
        [7.0, 2.0],
        [8.0, 2.5],
        [8.0, 3.5],
        [16.0, -3.5],
    ];
    Foundation::Polyline { points: points.to_vec() }
}

#[test]
fn a_polyline_is_what_its_points_say() {
    let foundation = survey();
    let ground = EnclosedFoundation::on(&foundation, LENGTH);
    assert_eq!(ground.breaks(1.0, 5.0), [2.0, 3.0, 4.0]);
    assert_eq!(ground.breaks(4.5, 6.0), [5.0, 5.0]);
    for (x, expected) in [(0.5, true), (1.0, false), (4.0, false), (4.5, true), (5.0, false)] {
        assert_eq!(ground.is_smooth_at(x), expected, "at {x}");
    }
    for (from, to, expected) in [
        // A level line with a point inside: in a scene it is one segment.
        (0.0, 2.0, false),
        (0.5, 1.5, false),
        (2.0, 3.0, true),
        (2.2, 2.8, true),
        (1.5, 2.5, false),
        (3.5, 4.5, false),
        (4.5, 5.5, false),
        (6.0, 7.0, true),
        (7.0, 2.0, false),
    ] {
        assert_eq!(ground.is_smooth_between(from, to), expected, "from {from} to {to}");
    }
    for (x, upper, depth) in [(5.0, [false, true], 1.0), (8.0, [true, false], 2.5), (3.0, [true, true], 4.0)] {
        assert_eq!([true, false].map(|left| ground.is_upper(x, left)), upper, "at {x}");
        assert_eq!(ground.depth(x), Interval::exact(depth), "at {x}");
    }
    assert!(ground.is_upper(4.5, true), "there is no step");
    // From one depth to its opposite is not level.
    encloses(&ground.about(8.0, 8.0), 4.0, 0.0, 0.0);
    encloses(&ground.about(12.0, 12.0), 4.0, -3.5, 0.0);
    encloses(&ground.about(LENGTH, 12.0), -4.0, 0.0, 0.0);
    assert_eq!(
        ground.about(0.5, 0.5).coefficients(),
        [Interval::exact(2.0), Interval::ZERO],
        "a level stretch is level without rounding"
    );
}

/// Points at uneven distances, at depths about 1 that differ by as little as `10⁻⁹`.
pub(in super::super) fn nearly_level(seed: u64) -> Foundation {
    let mut state = seed;
    let mut share = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 33).unwrap_or(0)) / f64::from(1_u32 << 31)
    };
    let mut x = 0.0;
    let mut points = vec![[0.0, 1.0]];
    while x < LENGTH {
        x = LENGTH.min(x + 1e-3 + 0.5 * share());
        points.push([x, 1.0 + 1e-9 * share()]);
    }
    Foundation::Polyline { points }
}

const WAVE: Foundation = Foundation::Cosine { mean: 1.0, amplitude: 0.5, wavelength: 2.0, phase: 0.0 };

/// No depth between two places is less than what is said without a look at each cell; nothing is said of other foundations.
#[test]
fn the_least_depth_is_below_all() {
    for seed in 0..20 {
        let foundation = nearly_level(seed);
        let ground = EnclosedFoundation::on(&foundation, LENGTH);
        for (from, to) in [(0.0, LENGTH), (0.3, 0.31), (2.0, 7.7), (15.9, 16.0)] {
            let least = ground.least(from, to);
            for k in 0..=200 {
                let depth = ground.depth(from + (to - from) * f64::from(k) / 200.0);
                assert!(least <= depth.hi(), "{least} is not below {depth:?}");
            }
        }
    }
    let level = EnclosedFoundation::on(&Foundation::Flat { depth: 1.5 }, LENGTH).least(0.0, 1.0);
    assert!(level.total_cmp(&1.5).is_eq(), "{level}");
    let least = EnclosedFoundation::on(&WAVE, LENGTH).least(0.0, 1.0);
    assert!(least < f64::MIN, "{least}");
}
