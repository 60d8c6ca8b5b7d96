//! Depths that are far from all others: usually a marker for missing data, such as -9999, that was read as a depth.

use std::fmt;

use super::written::as_written;
use super::{Foundation, Profile};
use crate::text::Results;

/// A depth is far if its distance from the median exceeds this multiple of the range of the depths nearer to the median.
/// Foundations of any roughness stay below the limit: among depths that double from one to the next, none is twice as far away as
/// this range.
const FAR: f64 = 1000.0;

/// Depths with a smaller relative difference count as one depth, since no survey is more accurate. Their magnitude then replaces
/// their range.
const ONE_DEPTH: f64 = 1e-6;

/// Fewer depths cannot be compared with others.
const LEAST: usize = 3;

/// Depths that are far from all others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FarDepths {
    /// The profile.
    pub of: Profile,
    /// The number of far depths.
    pub count: usize,
    /// Position and depth of the first of them \[length\].
    pub first: [f64; 2],
    /// The smallest and the greatest of the other depths \[length\].
    pub others: [f64; 2],
}

impl FarDepths {
    /// The far depths of a profile. Only polylines can have any, because formulas have no missing data.
    pub(super) fn of(of: Profile, profile: &Foundation) -> Option<Self> {
        let Foundation::Polyline { points } = profile else { return None };
        if points.len() < LEAST {
            return None;
        }
        let half = points.len() / 2;
        let mut depths: Vec<f64> = points.iter().map(|point| point[1]).collect();
        let median = *depths.select_nth_unstable_by(half, f64::total_cmp).1;
        let nearer = |a: &f64, b: &f64| (a - median).abs().total_cmp(&(b - median).abs());
        // The half nearer to the median first: for most foundations nothing else needs to be examined.
        depths.select_nth_unstable_by(half, nearer);
        let mut range = depths[..=half].iter().fold([median; 2], |range, depth| wider(range, *depth));
        let far = |range: [f64; 2], depth: f64| FAR * size(range) < (depth - median).abs() && 0.0 < size(range);
        if !depths[half..].iter().any(|depth| far(range, *depth)) {
            return None;
        }
        depths[half..].sort_unstable_by(nearer);
        let first = depths[half..].iter().position(|&depth| {
            let is_far = far(range, depth);
            range = if is_far { range } else { wider(range, depth) };
            is_far
        })?;
        let count = depths.len() - half - first;
        let outside = |point: &&[f64; 2]| point[1] < range[0] || range[1] < point[1];
        points.iter().find(outside).map(|&first| Self { of, count, first, others: range })
    }
}

/// The range extended by one depth.
fn wider([least, most]: [f64; 2], depth: f64) -> [f64; 2] {
    [least.min(depth), most.max(depth)]
}

/// The size of a range, or the magnitude of its depths if they count as one depth.
fn size([least, most]: [f64; 2]) -> f64 {
    let magnitude = least.abs().max(most.abs());
    if ONE_DEPTH * magnitude < most - least { most - least } else { magnitude }
}

impl fmt::Display for FarDepths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { of, count, first: [x, depth], others } = *self;
        let [least, most] = others.map(|depth| Results::default().number(depth));
        let (of, x, depth) = (of.path(), as_written(x), as_written(depth));
        match count {
            1 => write!(f, "the depth {depth} of `{of}` at x = {x} is far from all other depths")?,
            _ => write!(
                f,
                "{count} depths of `{of}` are far from all other depths, the first of them {depth} at x = {x}"
            )?,
        }
        write!(f, ": more than 1,000 times their range ({least} to {most}). If it marks missing data, remove it")
    }
}
