//! Memory limits of an exact solution, checked as the need arises: a few points of a survey may carry the beam, or all.

use super::piecewise::PiecewiseScene;
use super::solve::TheoryError;
use crate::memory::can_be_had;

/// Maximum memory of an exact solution, in bytes.
pub(super) const MEMORY: usize = 4 << 30;
/// Per point of a profile: 203 bytes were measured at 10⁶ points of which five carry, certificate included, and 420 with a figure.
const BYTES_PER_POINT: usize = 420;
/// Per sample in a chain, in addition to its point: 200 to 250 bytes were measured where 10⁶ cells have three each.
const BYTES_PER_SAMPLE: usize = 270;
/// Per contact, in addition to its point: 1,850 bytes for both were measured where nearly all of 10⁵ points carry.
const BYTES_PER_CONTACT: usize = 1650;

/// Checks the memory for this number of points.
pub(super) fn for_points(count: usize) -> Result<(), TheoryError> {
    taken(0, [count, BYTES_PER_POINT])
}

/// Checks the memory for this number of samples, in addition to the points.
pub(super) fn for_samples(given: &PiecewiseScene, count: usize) -> Result<(), TheoryError> {
    taken(given.breakpoints.len(), [count, BYTES_PER_SAMPLE])
}

/// Checks the memory for this number of contacts, in addition to the points.
pub(super) fn for_contacts(given: &PiecewiseScene, count: usize) -> Result<(), TheoryError> {
    taken(given.breakpoints.len(), [count, BYTES_PER_CONTACT])
}

/// Fails if `count` items of `bytes` bytes in addition to the `points` exceed [`MEMORY`], or if the system does not provide them.
fn taken(points: usize, [count, bytes]: [usize; 2]) -> Result<(), TheoryError> {
    let all = count.saturating_mul(bytes).saturating_add(points.saturating_mul(BYTES_PER_POINT));
    if all <= MEMORY && can_be_had(count, bytes) {
        return Ok(());
    }
    let (points, near) = if points == 0 { (count, 0) } else { (points, count) };
    Err(TheoryError::NoMemory { points, near, bytes: all })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contacts_count_and_not_points_alone() {
        let needed = |points, contacts| taken(points, [contacts, BYTES_PER_CONTACT]);
        for (points, contacts) in [(10_000_000, 1000), (2_000_000, 2_000_000)] {
            assert_eq!(needed(points, contacts), Ok(()));
        }
        for (points, near) in [(10_000_000, 2_000_000), (2_500_000, 2_500_000), (usize::MAX, 1)] {
            let bytes = points.saturating_mul(BYTES_PER_POINT).saturating_add(near * BYTES_PER_CONTACT);
            assert_eq!(needed(points, near), Err(TheoryError::NoMemory { points, near, bytes }));
        }
        assert_eq!(for_points(10_000_001), Ok(()));
        assert!(for_points(11_000_000).is_err() && for_points(usize::MAX).is_err());
    }
}
