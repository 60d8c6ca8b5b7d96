//! Gaps between two zones of contact: where the beam lifts off a foundation that it follows on both sides.

use super::given::Given;
use super::span::{End, Hold, Span};

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
    let end = |x: f64, cell: usize| End {
        x,
        rest: 0.0,
        cell,
        hold: Hold::Clamped { height: 0.0, slope: 0.0, turn: None, level: None },
    };
    let narrow = |gap: [f64; 2], side: usize| {
        let span = Span::between(given, end(gap[0], given.cell_from(gap[0])), end(gap[1], given.cell_to(gap[1])));
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
