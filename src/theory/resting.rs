//! The compression-only supports on which a rigid beam rests, where nothing else carries it. They are a starting list where the chain
//! of links fails, because the levels differ by far more than the beam bends.

// Held by: theory::pushing::a_stiff_beam_rests_on_two_of_many_supports

use super::list::List;
use super::normal::{edge_node, normal_form};
use super::overhang::Overhang;
use super::piecewise::PiecewiseScene;

/// The list of a rigid beam on compression-only supports. Of all lines that are nowhere below a support it follows the one that is
/// deepest at the resultant of the loads.
pub(super) fn rigid_beam(given: &PiecewiseScene) -> List {
    let place = |&i: &usize| (given.breakpoints[i].x, given.breakpoints[i].depth);
    // From the moment of the loads about the right end of the beam.
    let at = given.length - Overhang::of(given, given.length, true).moment / given.resultant;
    // The corners of the lower hull from left to right: the middle of three consecutive ones is below the line through the other two.
    let mut hull: Vec<usize> = Vec::new();
    for i in &given.bearings {
        while let [.., a, b] = &hull[..]
            && let ([(a, u), (b, v)], (c, w)) = ([place(a), place(b)], place(i))
            && (w - u) * (b - a) <= (v - u) * (c - a)
        {
            hull.pop();
        }
        hull.push(*i);
    }
    let right = hull.partition_point(|i| place(i).0 < at);
    let carries = right.checked_sub(1).and_then(|left| hull.get(left..=right)).unwrap_or_default();
    normal_form(given, &carries.iter().map(|&i| edge_node(given, i)).collect::<Vec<_>>())
}
