//! Beams with hinges: whether the loads move a part of the beam without end, upwards or into an opening.
//!
//! A motion without bending is a line `w` with a corner in each hinge. It is zero at bilateral supports, and not downwards at
//! compression-only supports and at the foundation. The loads can be balanced if and only if they do no positive work on any such motion.
//! The parts are examined from left to right. The largest work on all parts to the left of a hinge is proportional to the motion of the
//! hinge, so two numbers describe it: one for a motion up and one for a motion down.

use super::{Unheld, pushing};
use crate::scene::{Concentrated, Scene};

/// A smaller work is zero within rounding, as a share of the work of all loads without regard to signs.
const ROUNDING: f64 = 1e-10;

/// The largest work, the sum of the magnitudes of its terms, and the motion of the hinge before.
#[derive(Debug, Clone, Copy)]
struct Work {
    work: f64,
    size: f64,
    before: f64,
}

/// For a motion up and a motion down, if it is possible.
type Most = [Option<Work>; 2];

/// A part between two hinges, or from a hinge to an end.
struct Part {
    from: f64,
    to: f64,
    /// Work for a unit motion of each end, and the sum of the magnitudes of its terms.
    work: [f64; 2],
    size: [f64; 2],
    /// Positions as shares of the length of the part, and whether the contact there is bilateral; otherwise it is compression-only.
    stops: Vec<(f64, bool)>,
    /// Whether the part cannot rotate.
    is_level: bool,
}

impl Part {
    fn of(scene: &Scene, [from, to]: [f64; 2]) -> Self {
        let (beam, load, l) = (scene.beam(), scene.load(), scene.beam().length());
        let share = |x: f64| (x - from) / (to - from);
        let is_here = |x: f64| from <= x && (x < to || l <= to);
        let mut part = Self { from, to, work: [0.0; 2], size: [0.0; 2], stops: Vec::new(), is_level: false };
        for q in load.spread(l).filter(|q| q.from < to && from < q.to) {
            let [a, b] = [q.from.max(from), q.to.min(to)];
            let at = |x: f64| q.start + (q.end - q.start) * ((x - q.from) / (q.to - q.from));
            // A distributed load as two forces, each from the thirds of two triangles.
            for (x, third) in [(a, 2.0 * at(a) + at(b)), (b, at(a) + 2.0 * at(b))] {
                part.add(third * (b - a) / 6.0, share(x));
            }
        }
        for Concentrated { at, force, couple } in load.concentrated().filter(|acts| is_here(acts.at)) {
            part.add(force, share(at));
            let pair = couple / (to - from);
            part.work = [part.work[0] - pair, part.work[1] + pair];
            part.size = part.size.map(|size| size + pair.abs());
        }
        let touches = |x: &f64| (from..=to).contains(x);
        let holding = beam.holding().map(|support| (support.at, true));
        let pushing = pushing(scene).map(|support| (support.at, false));
        part.stops = holding.chain(pushing).filter(|(x, _)| touches(x)).map(|(x, holds)| (share(x), holds)).collect();
        let rigid = scene.foundation().filter(|_| scene.ground_stiffness().is_none()).map(|_| [0.0, l]);
        let soft = scene.ground_parts().filter(|(_, k)| 0.0 < *k).map(|(ends, _)| ends);
        for [a, b] in rigid.into_iter().chain(soft).filter(|[a, b]| *a < to && from < *b) {
            part.stops.extend([a.max(from), b.min(to)].map(|x| (share(x), false)));
        }
        part.is_level = beam.holding().any(|support| support.slope.is_some() && touches(&support.at));
        part
    }

    /// Adds a force at a share of the length.
    fn add(&mut self, force: f64, t: f64) {
        for (k, share) in [1.0 - t, t].into_iter().enumerate() {
            self.work[k] += force * share;
            self.size[k] += force.abs() * share;
        }
    }

    /// The range of the possible motions of the left end if the right end moves by `y`.
    fn range(&self, y: f64) -> Option<[f64; 2]> {
        let [mut least, mut most] = if self.is_level { [y; 2] } else { [f64::NEG_INFINITY, f64::INFINITY] };
        for &(t, holds) in &self.stops {
            if 1.0 <= t {
                if 0.0 < y || holds && y != 0.0 {
                    return None;
                }
                continue;
            }
            let there = -t * y / (1.0 - t);
            most = most.min(there);
            least = if holds { least.max(there) } else { least };
        }
        (least <= most + ROUNDING * most.abs()).then_some([least, most])
    }

    /// The work if its ends move in this way, including the work on all parts to its left.
    fn with(&self, left: &Most, [x, y]: [f64; 2]) -> Option<Work> {
        let none = Work { work: 0.0, size: 0.0, before: 0.0 };
        let beyond = if x == 0.0 { none } else { left[usize::from(0.0 < x)]? };
        let work = x.abs() * beyond.work + self.work[0] * x + self.work[1] * y;
        let size = x.abs() * beyond.size + self.size[0] * x.abs() + self.size[1] * y.abs();
        Some(Work { work, size, before: x })
    }
}

/// Checks that no part can move without end.
///
/// # Errors
///
/// [`Unheld::Turned`], [`Unheld::Moved`].
pub(super) fn check_parts(scene: &Scene) -> Result<(), Unheld> {
    let l = scene.beam().length();
    let hinges = scene.beam().joints().iter().filter(|joint| joint.stiffness.is_none()).map(|joint| joint.at);
    let places: Vec<f64> = [0.0].into_iter().chain(hinges).chain([l]).collect();
    let parts: Vec<Part> = places.windows(2).map(|ends| Part::of(scene, [ends[0], ends[1]])).collect();
    let free = Some(Work { work: 0.0, size: 0.0, before: 0.0 });
    let mut most: Vec<Most> = vec![[free; 2]];
    let gains = |work: &Work| ROUNDING * work.size < work.work;
    for (i, part) in parts.iter().enumerate() {
        let left = most[i];
        let is_last = i + 1 == parts.len();
        if let Some(range) = part.range(0.0) {
            for x in [-1.0, 1.0].into_iter().filter(|x| range[0] <= *x && *x <= range[1]) {
                if part.with(&left, [x, 0.0]).is_some_and(|work| gains(&work)) {
                    return Err(moved(&parts[..=i], &most, [x, 0.0]));
                }
            }
        }
        let to = [-1.0, 1.0].map(|y| {
            // The work is concave, so the ends of the range and zero are enough.
            let [least, most] = part.range(y)?;
            let inside = (least <= 0.0 && 0.0 <= most).then_some(0.0);
            let tried = [least, most].into_iter().chain(inside).filter(|x| x.is_finite());
            tried.filter_map(|x| part.with(&left, [x, y])).max_by(|a, b| a.work.total_cmp(&b.work))
        });
        for (work, y) in to.iter().zip([-1.0, 1.0]).filter(|_| is_last) {
            if let Some(work) = work.filter(gains) {
                return Err(moved(&parts, &most, [work.before, y]));
            }
        }
        most.push(to);
    }
    Ok(())
}

/// The error for a motion, from the motions of the ends of its last part.
fn moved(parts: &[Part], most: &[Most], [x, y]: [f64; 2]) -> Unheld {
    let (mut first, mut motion, mut left) = (parts.len() - 1, vec![y, x], x);
    while 0 < first
        && let Some(before) = most[first][usize::from(0.0 < left)].filter(|_| left != 0.0)
    {
        left = left.abs() * before.before;
        motion.push(left);
        first -= 1;
    }
    let largest = motion.iter().fold(0.0, |largest: f64, w| if largest.abs() < w.abs() { *w } else { largest });
    let (from, to, up) = (parts[first].from, parts[parts.len() - 1].to, largest < 0.0);
    match (&parts[first..], [x, y]) {
        ([part], [x, y]) if x == 0.0 || y == 0.0 => {
            let (hinge, moment) = if x == 0.0 { (from, part.work[1] * y) } else { (to, part.work[0] * x) };
            Unheld::Turned { hinge, moment: moment * (to - from), right: x == 0.0, up }
        }
        _ => Unheld::Moved { from, to, up },
    }
}
