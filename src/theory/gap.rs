//! Gaps between two zones of contact: where the beam lifts off a foundation that it follows on both sides.

use super::given::Given;
use super::hold::End;
use super::span::Span;

/// Half the length over which a beam bridges the valley at a joint between two zones; infinite where there is no valley.
///
/// With `h = h' = h'' = 0` at both ends of a gap of length `g` under the load `q`, and a kink `κ < 0` at its middle, the
/// fixed-end moments vanish: `q g²/12 + κ/g = 0`.
pub(super) fn half_bridge(given: &Given, joint: usize) -> f64 {
    let pressure = -given.drive(joint, given.joints[joint].x);
    let cube = -12.0 * given.joints[joint].kink / pressure;
    if 0.0 < cube && 0.0 < pressure { 0.5 * libm::cbrt(cube) } else { f64::INFINITY }
}

/// The gap between two zones around a stretch that lifts the beam off, as if nothing else were near.
///
/// At both ends `h = h' = h'' = 0`, and at those of a gap that is too narrow `0 < h''`: each end in turn moves outwards
/// until its own `h''` vanishes, found by bisection, which a load beside the stretch cannot mislead.
pub(super) fn settled_gap(given: &Given, [lo, hi]: [f64; 2]) -> [f64; 2] {
    /// Turns of the two ends; a dozen leave nothing to do.
    const TURNS: usize = 40;
    const HALVINGS: usize = 60;
    let narrow = |gap: [f64; 2], side: usize| {
        let span = across(given, gap);
        0.0 < [span.at_a[2], span.at_b[2]][side]
    };
    let least = 1e-9 * given.length;
    let mut gap = [(lo - least).max(0.0), (hi + least).min(given.length)];
    for _ in 0..TURNS {
        let before = gap;
        for side in 0..2 {
            if !narrow(gap, side) {
                continue;
            }
            let (mut inner, mut outer) = (gap[side], [0.0, given.length][side]);
            for _ in 0..HALVINGS {
                gap[side] = 0.5 * (inner + outer);
                if narrow(gap, side) {
                    inner = gap[side];
                } else {
                    outer = gap[side];
                }
            }
        }
        if gap[0].to_bits() == before[0].to_bits() && gap[1].to_bits() == before[1].to_bits() {
            break;
        }
    }
    gap
}

/// A gap that is somewhat too wide, around a stretch that lifts the beam off between two zones.
///
/// With `h = h' = h'' = 0` at both ends the fixed-end moments of the gap vanish. In a gap that is too narrow they would
/// open it, and Newton's method closes it altogether: no gap is a solution of the equations as well.
pub(super) fn gap_around(given: &Given, [lo, hi]: [f64; 2], [least, most]: [f64; 2]) -> [f64; 2] {
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
