//! The search for the pressed stretches by Newton's method, from stretches that are nearly right or from a softer foundation.

use super::chain::solve;
use super::solved::Solved;
use super::{ROUNDING, StretchSet};
use crate::theory::bernstein::sign_changes;
use crate::theory::piecewise::PiecewiseScene;

/// Strategies for raising the stiffness. The next one is tried if one does not settle. *Tuned* on the random scenes of the tests and on
/// surveys of up to 10⁵ readings.
const WAYS: [Way; 3] = [
    Way { at_first: 4096.0, factor: 16.0, roughly: true, most: 24 },
    Way { at_first: 16.0, factor: 16.0, roughly: false, most: 60 },
    Way { at_first: 2.0, factor: 2.0, roughly: false, most: 60 },
];

/// See [`WAYS`].
#[derive(Debug, Clone, Copy)]
struct Way {
    /// Factor of the stiffness as long as the whole beam is pressed.
    at_first: f64,
    /// Factor of the stiffness after that.
    factor: f64,
    /// Whether a set on a softer foundation is only a start: then it only needs to be nearly unchanged, whatever the number of its
    /// stretches.
    roughly: bool,
    /// Maximum number of solves for one set; a few are usual.
    most: usize,
}

/// Maximum number of links in all solves of a search together: some seconds on a slow machine.
const MOST_LINKS: usize = 500_000;

/// The same per cell of the scene, if that is more. On a foundation so stiff that the positions where pressure begins have no correct
/// digits, the search would otherwise continue through all stiffnesses.
const MOST_LINKS_OF_A_CELL: usize = 200;

/// The work done so far.
#[derive(Debug, Default)]
pub(super) struct Work {
    solves: usize,
    links: usize,
}

impl Work {
    /// Whether the work limit is reached.
    pub(super) fn is_done(&self, given: &PiecewiseScene) -> bool {
        MOST_LINKS.max(MOST_LINKS_OF_A_CELL * given.cells.len()) < self.links
    }

    /// Solves once more; [`None`] if there is no solution or the work limit is reached.
    fn solve<'a>(&mut self, given: &'a PiecewiseScene, springs: f64, stretches: &[[f64; 2]]) -> Option<Solved<'a>> {
        if self.is_done(given) {
            return None;
        }
        let solved = solve(given, springs, stretches, None)?;
        self.solves += 1;
        self.links += solved.size();
        Some(solved)
    }
}

/// The stretches on which springs of a stiffness over `EI` press, and the beam on them. The search starts from each set in `near`, in
/// turn. If no set settles, the whole beam is pressed; [`None`] if numbers leave the range of `f64`.
pub(super) fn search(
    given: &PiecewiseScene,
    springs: f64,
    near: &[Vec<[f64; 2]>],
    work: &mut Work,
) -> Option<StretchSet> {
    for near in near {
        let found = in_vain(work, |work| beginning_near(given, springs, near, work));
        if found.is_some() {
            return found;
        }
    }
    for way in &WAYS {
        let found = if way.roughly {
            in_vain(work, |work| stiffening(given, springs, way, work))
        } else {
            stiffening(given, springs, way, work)
        };
        if found.as_ref().is_some_and(|found| found.settled) {
            return found;
        }
    }
    let stretches = grounded(given);
    let parts = solve(given, springs, &stretches, None)?.parts()?;
    Some(StretchSet { parts, stretches, solves: work.solves, settled: false })
}

/// The stretches of the beam with a foundation below them.
fn grounded(given: &PiecewiseScene) -> Vec<[f64; 2]> {
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    for cell in given.cells.iter().filter(|cell| 0.0 < cell.ground) {
        match stretches.last_mut() {
            Some(last) if cell.lo <= last[1] => last[1] = cell.hi,
            _ => stretches.push([cell.lo, cell.hi]),
        }
    }
    stretches
}

/// The set that `find` returns if it settles. If not, its work does not count.
fn in_vain(work: &mut Work, find: impl FnOnce(&mut Work) -> Option<StretchSet>) -> Option<StretchSet> {
    let links = work.links;
    let found = find(work).filter(|found| found.settled);
    if found.is_none() {
        work.links = links;
    }
    found
}

/// Newton's method from stretches that are nearly right: the correct digits double with each solve.
fn beginning_near(given: &PiecewiseScene, springs: f64, near: &[[f64; 2]], work: &mut Work) -> Option<StretchSet> {
    /// Maximum number of solves. *Tuned* on surveys, which need 7 to 12 from a coarse bed, and on wheels along a rail, which need 6
    /// from the previous row.
    const MOST: usize = 16;
    let mut stretches = near.to_vec();
    let settled = settle(given, springs, &mut stretches, (MOST, Enough::Exactly), work)?;
    let parts = work.solve(given, springs, &stretches)?.parts()?;
    Some(StretchSet { parts, stretches, solves: work.solves, settled })
}

fn stiffening(given: &PiecewiseScene, springs: f64, way: &Way, work: &mut Work) -> Option<StretchSet> {
    let whole = grounded(given);
    let mut stretches = whole.clone();
    let square = given.length * given.length;
    let mut k = (1.0 / (square * square)).min(springs);
    loop {
        let is_last = springs <= k;
        let enough = match way.roughly {
            _ if is_last => Enough::Exactly,
            true => Enough::Roughly,
            false => Enough::Nearly,
        };
        let settled = settle(given, k, &mut stretches, (way.most, enough), work)?;
        if is_last {
            let parts = work.solve(given, springs, &stretches)?.parts()?;
            return Some(StretchSet { parts, stretches, solves: work.solves, settled });
        }
        if way.roughly && !settled {
            return None;
        }
        let is_whole = distance(&stretches, &whole) <= 0.0;
        k = (k * if is_whole { way.at_first } else { way.factor }).min(springs);
    }
}

/// The criterion by which a set of stretches is good enough.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Enough {
    /// On a softer foundation that is only a start: the set is nearly unchanged, whatever the number of its stretches.
    Roughly,
    /// On a softer foundation: its ends hardly move.
    Nearly,
    /// On the given foundation: it has all its digits, or as many as rounding allows.
    Exactly,
}

/// Newton's method on a foundation of one stiffness; returns whether the set is good enough within `most` solves.
fn settle(
    given: &PiecewiseScene,
    springs: f64,
    stretches: &mut Vec<[f64; 2]>,
    (most, enough): (usize, Enough),
    work: &mut Work,
) -> Option<bool> {
    /// Largest movement of ends that hardly move, as a share of the length.
    const NEARLY: f64 = 1e-6;
    /// Largest change of a set that is nearly unchanged, as a share of the pressed length.
    const ROUGHLY: f64 = 1e-2;
    /// Accuracy of a position with all its digits, as a share of the length.
    const DIGITS: f64 = 4.0 * f64::EPSILON;
    /// Distance below which a set that comes no closer is at the level of rounding.
    const FEW: f64 = 1e-12;
    let mut before = f64::INFINITY;
    for _ in 0..most {
        let next = pressed(given, &work.solve(given, springs, stretches)?)?;
        let apart = distance(stretches, &next) / given.length;
        let is_enough = match enough {
            Enough::Roughly => apart <= NEARLY || difference(stretches, &next) <= ROUGHLY * total(&next),
            Enough::Nearly => apart <= NEARLY,
            Enough::Exactly => apart <= DIGITS || apart <= FEW && 0.5 * before <= apart,
        };
        (*stretches, before) = (next, apart);
        if is_enough {
            return Some(true);
        }
    }
    Some(false)
}

/// The largest distance between the ends of two sets.
fn distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}

/// The length of the beam that belongs to only one of two sets.
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

/// The stretches on which a beam is below the surface of the foundation, from left to right; [`None`] if numbers leave the range of
/// `f64`.
fn pressed(given: &PiecewiseScene, solved: &Solved<'_>) -> Option<Vec<[f64; 2]>> {
    /// Distance up to which two positions count as one, as a share of the length: two units in the last place.
    const SAME: f64 = 4e-16;
    /// Length up to which a stretch is dropped: a few such units.
    const NOTHING: f64 = 1e-15;
    /// Distance from a break within which an end is moved onto the break: a penetration between them is rounding.
    const BESIDE: f64 = 1e-12;
    let rounding = ROUNDING * solved.deepest();
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    let mut ends = Vec::new();
    solved.near_ground(|piece, presses, clearance| {
        piece.outwards(clearance);
        ends.clear();
        ends.extend([piece.lo, piece.hi]);
        ends.extend(sign_changes(clearance, piece.width()).into_iter().map(|s| piece.place(s)));
        ends.sort_by(f64::total_cmp);
        for end in ends.windows(2).filter(|w| w[0] < w[1]) {
            let at = |share: f64| {
                let x = end[0] + share * (end[1] - end[0]);
                clearance.iter().rev().fold(0.0, |sum, c| sum * (x - piece.anchor).abs() + c)
            };
            let mut is_pressed = at(0.5) < 0.0;
            if is_pressed != presses && [0.25, 0.5, 0.75].into_iter().all(|share| at(share).abs() <= rounding) {
                is_pressed = presses;
            }
            match stretches.last_mut() {
                _ if !is_pressed => {}
                Some(last) if end[0] - last[1] <= SAME * given.length => last[1] = end[1],
                _ => stretches.push([end[0], end[1]]),
            }
        }
    })?;
    // Moves ends very close to a break onto it.
    for end in stretches.iter_mut().flatten() {
        let next = given.breakpoints.partition_point(|breakpoint| breakpoint.x < *end);
        let beside =
            [next.checked_sub(1), Some(next)].map(|i| given.breakpoints.get(i?).map(|breakpoint| breakpoint.x));
        let apart = |x: &f64| (x - *end).abs();
        let nearest = beside.into_iter().flatten().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        *end = nearest.filter(|x| apart(x) <= BESIDE * given.length).unwrap_or(*end);
    }
    stretches.retain(|[from, to]| NOTHING * given.length < to - from);
    Some(stretches)
}
