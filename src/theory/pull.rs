//! Stretches where a contact zone is possible and where it is not: its pressure `q − e u'''' + N u''` must not be negative. Around a
//! stretch in tension, the beam lifts off a foundation that it follows on both sides.

use super::bernstein::{lowest_below, sign_changes};
use super::divided;
use super::list::Node;
use super::piecewise::PiecewiseScene;
use super::span::{End, Span};

/// Taylor coefficients of the contact pressure at the left end of `cell`.
pub(super) fn pressure(given: &PiecewiseScene, cell: usize) -> Vec<f64> {
    let c = &given.cells[cell];
    let mut taylor = vec![0.0; given.terms.max(6)];
    given.profile(cell, c.lo, &mut taylor);
    let mut pressure: Vec<f64> = taylor
        .iter()
        .enumerate()
        .skip(4)
        .map(|(j, c)| {
            #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
            let j = j as f64;
            -c * j * (j - 1.0) * (j - 2.0) * (j - 3.0) * given.cells[cell].stiffness
        })
        .collect();
    if given.tension != 0.0 {
        #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
        let bent = |j: usize| given.tension * taylor[j + 2] * ((j + 2) * (j + 1)) as f64;
        pressure.iter_mut().enumerate().for_each(|(j, p)| *p += bent(j));
    }
    pressure[0] += c.load;
    pressure[1] += c.load_slope;
    pressure
}

/// Stretches in which a zone would be in tension, from left to right. An upward point load and a couple are stretches without length.
/// So is a change of the bending stiffness on a curved foundation: the moment of the beam does not jump, but a beam that follows the
/// foundation would need a larger moment in its stiffer part.
pub(super) fn pulling_stretches(given: &PiecewiseScene) -> Vec<(f64, f64)> {
    /// Rounding of `q` and `u''''` against each other.
    const ROUNDING: f64 = 1e-13;
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut add = |from: f64, to: f64| match found.last_mut() {
        Some(last) if from <= last.1 => last.1 = last.1.max(to),
        _ => found.push((from, to)),
    };
    for (i, cell) in given.cells.iter().enumerate() {
        let [couple, force] = given.acts_along_ground(i);
        if force < 0.0 || couple != 0.0 {
            add(cell.lo, cell.lo);
        }
        let width = cell.hi - cell.lo;
        let straight =
            given.shapes[cell.shape].degree().is_some_and(|degree| degree < if given.tension == 0.0 { 4 } else { 2 });
        if straight && 0.0 <= cell.load && 0.0 <= cell.load + cell.load_slope * width {
            continue;
        }
        let p = pressure(given, i);
        let fourth = given.bent(i, cell.lo, 4).abs();
        let pulled = (given.tension * given.derivative(i, cell.lo, 2)).abs();
        let size = fourth + pulled + cell.load.abs() + (cell.load_slope * width).abs();
        if lowest_below(&p, width, -ROUNDING * size).is_some() {
            let mut ends = vec![0.0];
            ends.extend(sign_changes(&p, width));
            ends.push(width);
            for w in ends.windows(2) {
                if super::bernstein::value(&p, 0.5 * (w[0] + w[1])) < 0.0 {
                    add(cell.lo + w[0], if w[1] < width { cell.lo + w[1] } else { cell.hi });
                }
            }
        }
    }
    found
}

/// The largest of three tensions of a zone: the mean between `lo` and `hi`, the value at these two, and an upward point load or a
/// couple between them, spread over the beam.
pub(super) fn mean_pull(given: &PiecewiseScene, lo: f64, hi: f64) -> f64 {
    let (first, last) = (given.cell_from(lo), given.cell_to(hi).max(given.cell_from(lo)));
    let [from, behind] =
        [0, 1].map(|side| given.breakpoints.partition_point(|j| if side == 0 { j.x < lo } else { j.x <= hi }));
    let lifts = |i: usize| {
        let [couple, force] = given.acts_along_ground(i);
        couple.abs() / given.length - force.min(0.0)
    };
    let point = (from..behind).map(lifts).sum::<f64>() / given.length;
    if hi <= lo {
        return point;
    }
    let mut sum = 0.0;
    for cell in first..=last {
        let c = &given.cells[cell];
        let (from, to) = (c.lo.max(lo), c.hi.min(hi));
        if from < to {
            sum += given.load_rule.integral(from, to, |x| given.drive(cell, x).max(0.0));
        }
    }
    point.max(sum / (hi - lo)).max(given.drive(first, lo)).max(given.drive(last, hi))
}

/// The ends of a zone from `from` to `to`, and of the gaps in it around every stretch in tension.
pub(super) fn zones_between(given: &PiecewiseScene, [from, to]: [f64; 2]) -> Vec<Node> {
    let mut nodes = Vec::new();
    let mut add = |start: f64, end: f64| {
        if start < end {
            nodes.push(Node::start(start, given.cell_from(start)));
            nodes.push(Node::end(end, given.cell_to(end)));
        }
    };
    let mut start = from;
    for &(lo, hi) in given.pulling_between(from, to) {
        let inside = start < lo && hi < to;
        let [end, next] = if inside { gap_around(given, [lo, hi], [start, to]) } else { [lo, hi] };
        add(start, end);
        start = next;
    }
    add(start, to);
    nodes
}

/// A slightly too wide gap around a stretch that lifts the beam off between two zones.
///
/// With `h = h' = h'' = 0` at both ends the fixed-end moments of the gap vanish. In a gap that is too narrow they would open it, but
/// Newton's method closes it completely, because no gap satisfies the equations as well.
fn gap_around(given: &PiecewiseScene, [lo, hi]: [f64; 2], [least, most]: [f64; 2]) -> [f64; 2] {
    /// Growth factor of the margin on the side that is too narrow.
    const WIDER: f64 = 1.3;
    /// Maximum number of tries: from 10⁻⁹ of the beam to the whole of it, on either side.
    const TRIES: u32 = 150;
    let mut margin = margin_of_couple(given, lo, hi).unwrap_or([(0.1 * (hi - lo)).max(1e-9 * given.length); 2]);
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

/// Slightly more than the two parts of the gap that a couple `C`, or a change of the stiffness by `C/g''`, causes under a pressure `p`,
/// to its left and right. Its length and parts are
///
/// ```text
/// ℓ² = 2√3 |C|/p,     (3 + √3)/6 ℓ and (3 − √3)/6 ℓ
/// ```
///
/// which is exact as `C → 0`: at both ends `h'' = 0`.
fn margin_of_couple(given: &PiecewiseScene, lo: f64, hi: f64) -> Option<[f64; 2]> {
    /// Factor by which each part is longer.
    const MORE: f64 = 1.05;
    let at = given.breakpoint_at(lo).filter(|_| hi <= lo)?;
    let [_, cell] = given.cells_beside(at);
    let ([couple, _], pressure) = (given.acts_along_ground(at), -given.drive(cell, lo));
    let root = 3.0_f64.sqrt();
    let length = MORE * (2.0 * root * couple.abs() / pressure).sqrt();
    let [long, short] = [(3.0 + root) / 6.0 * length, (3.0 - root) / 6.0 * length];
    let margin = if 0.0 < couple { [long, short] } else { [short, long] };
    (0.0 < length && length.is_finite()).then_some(margin)
}

/// The span across a gap, in contact with the profile at both ends.
fn across(given: &PiecewiseScene, [from, to]: [f64; 2]) -> Span {
    let ends = [End::resting(from, given.cell_from(from)), End::resting(to, given.cell_to(to))];
    let divisions = given.divisions_between(from, to);
    let parts = if given.springs.is_empty() || divisions.is_empty() {
        None
    } else {
        divided::between(given, ends, divisions, 0.0)
    };
    match parts.as_deref() {
        Some([first, .., last]) => Span { b: last.b, at_b: last.at_b, beam_b: last.beam_b, ..*first },
        _ => Span::between(given, ends[0], ends[1]),
    }
}
