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
pub(super) fn tidied(foundation: &Foundation) -> Option<Foundation> {
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
mod tests;
