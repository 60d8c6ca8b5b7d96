//! Compression-only supports next to an elastic foundation: a loop on their set finds the pressed ones, around the loop on the
//! stretches.
//!
//! ```text
//! B ← all;    repeat  v ← the beam on springs with B as supports;  B ← B − { R < 0 } + { v > level },    until B stays
//! ```
//!
//! Starting with all of them, the beam has more supports than it needs. On a stiff foundation alone the search would be slow. If the
//! loop does not settle, it starts again with none.
//!
//! For a linear problem with a positive definite matrix, exchanging one support at a time, always the last one on the wrong side,
//! terminates (Murty 1974). On an elastic foundation the problem is only piecewise linear and termination is not proven, so the work is
//! limited. All supports are exchanged at once as long as the number of wrong ones falls.

use super::{Part, ROUNDING, StretchSet, Work, beside, part_at, search};
use crate::theory::piecewise::{AtSpring, AtSupport, PiecewiseScene};

/// Number of exchanges of all wrong supports at once without a better set than before. *Tuned*: any small number will do, since single
/// exchanges follow.
const PATIENCE: usize = 3;

/// The scene in which the pressed compression-only supports act as supports, and the beam on them; `near` are stretches that are nearly
/// right.
pub(super) fn search_with(
    given: PiecewiseScene,
    springs: f64,
    near: &[Vec<[f64; 2]>],
) -> Option<(PiecewiseScene, StretchSet)> {
    let mut work = Work::default();
    if pushing(&given) == 0 {
        let found = search(&given, springs, near, &mut work)?;
        return Some((given, found));
    }
    let all = exchange(&given, springs, near, true, &mut work);
    let is_settled = all.as_ref().is_some_and(|(_, found)| found.settled);
    if is_settled { all } else { exchange(&given, springs, near, false, &mut work).or(all) }
}

/// The number of compression-only supports: the rigid ones, followed by the elastic ones.
fn pushing(given: &PiecewiseScene) -> usize {
    given.bearings.len() + given.springs.iter().filter(|spring| spring.pushes_only).count()
}

/// The same, starting with all of them or with none.
fn exchange(
    given: &PiecewiseScene,
    springs: f64,
    near: &[Vec<[f64; 2]>],
    all: bool,
    work: &mut Work,
) -> Option<(PiecewiseScene, StretchSet)> {
    let mut presses = vec![all; pushing(given)];
    let (mut fewest, mut patience) = (usize::MAX, PATIENCE);
    loop {
        let held = holding(given, &presses);
        let found = search(&held, springs, near, work)?;
        let wrong: Vec<usize> = wrong(&held, &found.parts, &presses);
        if wrong.is_empty() || !found.settled || work.is_done(given) {
            let settled = found.settled && wrong.is_empty();
            return Some((held, StretchSet { settled, ..found }));
        }
        (fewest, patience) =
            if wrong.len() < fewest { (wrong.len(), PATIENCE) } else { (fewest, patience.saturating_sub(1)) };
        let exchanged = if 0 < patience { &wrong[..] } else { &wrong[wrong.len() - 1..] };
        exchanged.iter().for_each(|&i| presses[i] = !presses[i]);
    }
}

/// The scene with the pressed compression-only supports as supports that hold.
fn holding(given: &PiecewiseScene, presses: &[bool]) -> PiecewiseScene {
    let mut held = given.clone();
    let pressed = given.bearings.iter().zip(presses).filter(|(_, presses)| **presses);
    held.supports.extend(pressed.map(|(&breakpoint, _)| AtSupport {
        breakpoint,
        level: given.breakpoints[breakpoint].depth,
        slope: None,
        built_in: false,
        turning: None,
        clearance: [f64::INFINITY; 2],
        tangent: [false; 2],
        size: 0.0,
    }));
    held.supports.sort_by_key(|support| support.breakpoint);
    let stops = held.springs.iter_mut().filter(|spring| spring.pushes_only);
    stops.zip(&presses[given.bearings.len()..]).for_each(|(stop, presses)| stop.acts = *presses);
    held
}

/// The supports that would be in tension, and those that the beam would penetrate, both beyond rounding.
fn wrong(held: &PiecewiseScene, parts: &[Part], presses: &[bool]) -> Vec<usize> {
    let forces = held.supports.iter().map(|support| force(held, parts, support.breakpoint).abs());
    let force_size = forces.fold(held.total_load, f64::max);
    let size = parts.iter().fold(0.0, |most: f64, part| most.max(part.beam(part.piece.lo)[0].abs()));
    // A pressed elastic support must be below its level, and one that is not pressed above it.
    let is_off = |stop: &AtSpring, presses: bool| {
        let x = held.breakpoints[stop.breakpoint].x;
        let sunk = part_at(parts, x, false).beam(x)[0] - stop.level;
        let nothing = ROUNDING * size.max(stop.level.abs());
        if presses { sunk < -nothing } else { nothing < sunk }
    };
    let is_wrong = |&i: &usize| {
        let Some(&breakpoint) = held.bearings.get(i) else {
            let stop = held.springs.iter().filter(|spring| spring.pushes_only).nth(i - held.bearings.len());
            return stop.is_some_and(|stop| is_off(stop, presses[i]));
        };
        if presses[i] {
            return force(held, parts, breakpoint) < -ROUNDING * force_size;
        }
        let at = &held.breakpoints[breakpoint];
        ROUNDING * size.max(at.depth.abs()) < part_at(parts, at.x, false).beam(at.x)[0] - at.depth
    };
    (0..presses.len()).filter(is_wrong).collect()
}

/// The support force at a breakpoint, over `EI`: `v'''(x+) − v'''(x−) = P − R`, with an axial force less `N [v']` where the slope
/// jumps.
pub(super) fn force(given: &PiecewiseScene, parts: &[Part], breakpoint: usize) -> f64 {
    let at = &given.breakpoints[breakpoint];
    let [before, behind] = beside(parts, at.x);
    let force = at.acts.force() - (behind[3] - before[3]);
    let turns = at.x <= 0.0 || given.length <= at.x || at.is_jointed();
    if given.tension != 0.0 && turns { force + given.tension * (behind[1] - before[1]) } else { force }
}
