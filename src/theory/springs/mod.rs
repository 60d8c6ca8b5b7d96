//! Ground that gives: unilateral springs, `p = k (v − g)` where the beam is pressed into the ground and nothing elsewhere.
//!
//! There is no list of contacts. `J` is convex with a continuous derivative, and its minimum is found by Newton's method in the space
//! of deflections, each step of which is a linear problem (`links`, `chain`):
//!
//! ```text
//! S ← whole beam;    v ← the beam on springs that press on S,  S ← { v > g },    until S stays
//! ```
//!
//! first for soft ground, then for stiffer and stiffer ground up to the given. Which supports that only push press is found around that
//! (`bearings`). `answer` is what is read off the
//! polynomials, and `change` how that changes with the numbers of the scene.

mod answer;
mod bearings;
mod chain;
mod change;
mod links;

pub(super) use self::answer::{Springs, exact};
use self::chain::solve;
use super::bernstein::sign_changes;
use super::piece::{Piece, derivatives};
use super::piecewise::PiecewiseScene;

/// A part of the beam with its polynomials about the anchor of its piece.
#[derive(Debug, Clone)]
pub(in crate::theory) struct Part {
    pub(in crate::theory) piece: Piece,
    /// Whether the springs press on it.
    pub(in crate::theory) pressed: bool,
    /// Taylor coefficients of `v`.
    pub(in crate::theory) deflection: Vec<f64>,
    /// Taylor coefficients of `w = v − g`.
    pub(in crate::theory) penetration: Vec<f64>,
}

impl Part {
    /// `v, v', v'', v'''` at a place of it.
    pub(in crate::theory) fn beam(&self, x: f64) -> [f64; 4] {
        derivatives(&self.deflection, x - self.piece.anchor)
    }

    /// `w, w', w'', w'''` at a place of it.
    pub(in crate::theory) fn sunk(&self, x: f64) -> [f64; 4] {
        derivatives(&self.penetration, x - self.piece.anchor)
    }
}

/// The part at `x`, of two the left or the right one.
fn part_at(parts: &[Part], x: f64, right: bool) -> &Part {
    let i = parts.partition_point(|part| if right { part.piece.hi <= x } else { part.piece.hi < x });
    &parts[i.min(parts.len() - 1)]
}

/// `v, v', v'', v'''` before a place between two parts and behind it, zero where there is no beam.
fn beside(parts: &[Part], x: f64) -> [[f64; 4]; 2] {
    let i = parts.partition_point(|part| part.piece.lo < x);
    [i.checked_sub(1), Some(i)].map(|i| i.and_then(|i| parts.get(i)).map_or([0.0; 4], |part| part.beam(x)))
}

/// The stretches that press, and the beam on them.
#[derive(Debug)]
struct StretchSet {
    parts: Vec<Part>,
    /// From left to right.
    stretches: Vec<[f64; 2]>,
    solves: usize,
    /// Whether the set stays.
    settled: bool,
}

/// How the search goes from one stiffness to the next. The next way is tried where one does not settle. *Tuned* on the random scenes of the
/// tests and on surveys of up to 10⁵ readings.
const WAYS: [Way; 3] = [
    Way { at_first: 4096.0, factor: 16.0, roughly: true, most: 24 },
    Way { at_first: 16.0, factor: 16.0, roughly: false, most: 60 },
    Way { at_first: 2.0, factor: 2.0, roughly: false, most: 60 },
];

/// See [`WAYS`].
#[derive(Debug, Clone, Copy)]
struct Way {
    /// The factor of stiffness as long as all of the beam presses.
    at_first: f64,
    /// The factor from there on.
    factor: f64,
    /// Whether a set of softer ground is only a start: it is enough that it hardly changes, whatever the number of its stretches.
    roughly: bool,
    /// Solves for one set, at most; a handful are the rule.
    most: usize,
}

/// Parts of the beam that all solves of a search go through together, at most: some seconds on a slow machine.
const MOST_PARTS: usize = 500_000;

/// Or as many for each cell of the scene, each of which has a part in every solve. Ground so stiff that the places where it begins to press
/// have no digits left would go on through all stiffnesses.
const MOST_PARTS_OF_A_CELL: usize = 200;

/// What has been done.
#[derive(Debug, Default)]
struct Work {
    solves: usize,
    parts: usize,
}

impl Work {
    /// Whether none is left.
    fn is_done(&self, given: &PiecewiseScene) -> bool {
        MOST_PARTS.max(MOST_PARTS_OF_A_CELL * given.cells.len()) < self.parts
    }

    /// One more solve; [`None`] where there is none, or no work is left.
    fn solve(&mut self, given: &PiecewiseScene, springs: f64, stretches: &[[f64; 2]]) -> Option<Vec<Part>> {
        if self.is_done(given) {
            return None;
        }
        let parts = solve(given, springs, stretches, None)?;
        self.solves += 1;
        self.parts += parts.len();
        Some(parts)
    }
}

/// The stretches on which springs of a stiffness over `EI` press, and the beam on them. Where the set does not settle, the whole
/// beam is pressed; [`None`] if numbers leave the range of `f64`.
fn search(given: &PiecewiseScene, springs: f64, work: &mut Work) -> Option<StretchSet> {
    let mut found = WAYS.iter().filter_map(|way| {
        let parts = work.parts;
        let found = stiffening(given, springs, way, work);
        if way.roughly && !found.as_ref().is_some_and(|found| found.settled) {
            // The others have all of the work.
            work.parts = parts;
        }
        found
    });
    if let Some(settled) = found.find(|found| found.settled) {
        return Some(settled);
    }
    let stretches = vec![[0.0, given.length]];
    Some(StretchSet { parts: solve(given, springs, &stretches, None)?, stretches, solves: work.solves, settled: false })
}

fn stiffening(given: &PiecewiseScene, springs: f64, way: &Way, work: &mut Work) -> Option<StretchSet> {
    /// Of the length: a set of softer ground is a start, and no more.
    const START: f64 = 1e-6;
    /// Of what presses: the same, where a set may be rough.
    const ROUGHLY: f64 = 1e-2;
    /// That of the given ground has all its digits.
    const DIGITS: f64 = 4.0 * f64::EPSILON;
    /// Or as many as there are: below this a set that comes no nearer is rounding.
    const FEW: f64 = 1e-12;
    let mut stretches = vec![[0.0, given.length]];
    let square = given.length * given.length;
    let mut k = (1.0 / (square * square)).min(springs);
    loop {
        let is_last = springs <= k;
        let (mut before, mut settled) = (f64::INFINITY, false);
        for _ in 0..way.most {
            let parts = work.solve(given, k, &stretches)?;
            let next = pressed(given, &parts);
            let apart = distance(&stretches, &next) / given.length;
            let changed = difference(&stretches, &next);
            stretches = next;
            settled = if is_last {
                apart <= DIGITS || apart <= FEW && 0.5 * before <= apart
            } else {
                apart <= START || way.roughly && changed <= ROUGHLY * total(&stretches)
            };
            if settled {
                break;
            }
            before = apart;
        }
        if is_last {
            let parts = work.solve(given, springs, &stretches)?;
            return Some(StretchSet { parts, stretches, solves: work.solves, settled });
        }
        if way.roughly && !settled {
            return None;
        }
        let is_whole = matches!(stretches[..], [[from, to]] if from <= 0.0 && given.length <= to);
        k = (k * if is_whole { way.at_first } else { way.factor }).min(springs);
    }
}

/// How far the ends of two sets are apart at most.
fn distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}

/// How much of the beam is in one of two sets and not in the other.
fn difference(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let (mut both, mut rest) = (0.0, b);
    for [from, to] in a {
        rest = &rest[rest.partition_point(|next| next[1] <= *from)..];
        let inside = rest.iter().take_while(|next| next[0] < *to);
        both += inside.map(|next| next[1].min(*to) - next[0].max(*from)).sum::<f64>();
    }
    total(a) + total(b) - 2.0 * both
}

/// The length of all stretches of a set.
fn total(set: &[[f64; 2]]) -> f64 {
    set.iter().map(|[from, to]| to - from).sum()
}

/// A penetration below this share of the largest one has no sign of its own: what is so near stays on the side on which it is.
const ROUNDING: f64 = 1e-13;

/// The largest penetration of a beam.
fn deepest(parts: &[Part]) -> f64 {
    let inside = |part: &Part| {
        let (lo, hi) = (part.piece.lo, part.piece.hi);
        [lo, 0.5 * (lo + hi), hi].map(|x| part.sunk(x)[0].abs()).into_iter().fold(0.0, f64::max)
    };
    parts.iter().filter(|part| part.pressed).map(inside).fold(0.0, f64::max)
}

/// The stretches on which a beam is below the surface of the ground, from left to right.
fn pressed(given: &PiecewiseScene, parts: &[Part]) -> Vec<[f64; 2]> {
    /// Places that are one, as a share of the length: two units in the last place.
    const SAME: f64 = 4e-16;
    /// Stretches that are none: a few of these.
    const NOTHING: f64 = 1e-15;
    /// An end that is so near to a break is there: between them a penetration is rounding.
    const BESIDE: f64 = 1e-12;
    let rounding = ROUNDING * deepest(parts);
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    for part in parts {
        let mut outwards = part.penetration.clone();
        part.piece.outwards(&mut outwards);
        let mut ends = vec![part.piece.lo, part.piece.hi];
        ends.extend(sign_changes(&outwards, part.piece.width()).into_iter().map(|s| part.piece.place(s)));
        ends.sort_by(f64::total_cmp);
        for end in ends.windows(2).filter(|w| w[0] < w[1]) {
            let at = |share: f64| part.sunk(end[0] + share * (end[1] - end[0]))[0];
            let mut is_pressed = 0.0 < at(0.5);
            if is_pressed != part.pressed && [0.25, 0.5, 0.75].into_iter().all(|share| at(share).abs() <= rounding) {
                is_pressed = part.pressed;
            }
            if !is_pressed {
                continue;
            }
            match stretches.last_mut() {
                Some(last) if end[0] - last[1] <= SAME * given.length => last[1] = end[1],
                _ => stretches.push([end[0], end[1]]),
            }
        }
    }
    // An end beside a break is there.
    for end in stretches.iter_mut().flatten() {
        let next = given.breakpoints.partition_point(|breakpoint| breakpoint.x < *end);
        let beside =
            [next.checked_sub(1), Some(next)].map(|i| given.breakpoints.get(i?).map(|breakpoint| breakpoint.x));
        let apart = |x: &f64| (x - *end).abs();
        let nearest = beside.into_iter().flatten().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        *end = nearest.filter(|x| apart(x) <= BESIDE * given.length).unwrap_or(*end);
    }
    stretches.retain(|[from, to]| NOTHING * given.length < to - from);
    stretches
}
