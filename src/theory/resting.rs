//! The compression-only supports on which a rigid beam rests, where nothing else is below it. They are a starting list where the chain
//! of links fails, because the levels differ by far more than the beam bends.

// Held by: theory::pushing::a_stiff_beam_rests_on_two_of_many_supports

use super::list::List;
use super::normal::{edge_node, normal_form};
use super::overhang::Overhang;
use super::piecewise::PiecewiseScene;

/// The list of a rigid beam.
pub(super) fn rigid_beam(given: &PiecewiseScene) -> List {
    let mut nodes = List::free(given).nodes;
    nodes.extend(under_rigid_beam(given).into_iter().map(|i| edge_node(given, i)));
    nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
    normal_form(given, &nodes)
}

/// The supports under a rigid beam. Of all lines that are nowhere below a support it follows the one that is deepest at the resultant
/// of the loads. This line passes through two compression-only supports, or through one and the support that holds the beam.
fn under_rigid_beam(given: &PiecewiseScene) -> Vec<usize> {
    let place = |&i: &usize| (given.breakpoints[i].x, given.breakpoints[i].depth);
    // The moment of the loads about the right end of the beam.
    let turn = Overhang::of(given, given.length, true).moment;
    match given.supports.as_slice() {
        [] => {
            let at = given.length - turn / given.resultant;
            // The corners of the lower hull from left to right: the middle of three consecutive ones is below the line through the
            // other two.
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
            right.checked_sub(1).and_then(|left| Some(hull.get(left..=right)?.to_vec())).unwrap_or_default()
        }
        [support] if !support.built_in => {
            let x = given.breakpoints[support.breakpoint].x;
            let to_the_right = turn < given.resultant * (given.length - x);
            let slope = |i: &usize| (place(i).1 - support.level) / (place(i).0 - x).abs();
            let beside = given.bearings.iter().filter(|i| (x < place(i).0) == to_the_right);
            beside.min_by(|a, b| slope(a).total_cmp(&slope(b))).into_iter().copied().collect()
        }
        _ => Vec::new(),
    }
}
