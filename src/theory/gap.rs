//! Gaps between two zones of contact: where the beam lifts off a foundation that it follows on both sides.

use super::given::Given;
use super::list::{Kind, Node};
use super::span::{End, Span};

/// The ends of a zone from `from` to `to`, and of the gaps in it around every stretch where it would pull.
pub(super) fn zones_between(given: &Given, [from, to]: [f64; 2]) -> Vec<Node> {
    let mut nodes = Vec::new();
    let mut add = |start: f64, end: f64| {
        if start < end {
            nodes.push(Node::new(Kind::ZoneStart, start, given.cell_from(start)));
            nodes.push(Node::new(Kind::ZoneEnd, end, given.cell_to(end)));
        }
    };
    let mut start = from;
    for &(lo, hi) in given.tension_between(from, to) {
        if hi < start {
            continue;
        }
        let inside = start < lo && hi < to;
        let [end, next] = if inside { gap_around(given, [lo, hi], [start, to]) } else { [lo, hi] };
        add(start, end);
        start = next;
    }
    add(start, to);
    nodes
}

/// A gap that is somewhat too wide, around a stretch that lifts the beam off between two zones.
///
/// With `h = h' = h'' = 0` at both ends the fixed-end moments of the gap vanish. In a gap that is too narrow they would
/// open it, and Newton's method closes it altogether: no gap is a solution of the equations as well.
fn gap_around(given: &Given, [lo, hi]: [f64; 2], [least, most]: [f64; 2]) -> [f64; 2] {
    /// Each try is wider by this factor, on the side that is too narrow.
    const WIDER: f64 = 1.3;
    /// From a thousand-millionth of the beam to the whole of it, on either side.
    const TRIES: u32 = 150;
    let mut margin = [(0.1 * (hi - lo)).max(1e-9 * given.length); 2];
    let mut gap = [lo, hi];
    for _ in 0..TRIES {
        gap = [(lo - margin[0]).max(least), (hi + margin[1]).min(most)];
        let span = across(given, gap);
        let narrow = [0.0 < span.at_a[2] && least < gap[0], 0.0 < span.at_b[2] && gap[1] < most];
        if narrow == [false; 2] {
            break;
        }
        for side in 0..2 {
            if narrow[side] {
                margin[side] *= WIDER;
            }
        }
    }
    gap
}

/// The span that bridges a gap, resting on the profile at both ends.
fn across(given: &Given, [from, to]: [f64; 2]) -> Span {
    Span::between(given, End::resting(from, given.cell_from(from)), End::resting(to, given.cell_to(to)))
}
