//! Search for the contact list.
//!
//! A chain of links above samples of the profile proposes contacts, Newton's method computes their positions, and all conditions are
//! checked. A list that fails its check is repaired. If repairs end without an answer, the chain gets more samples near its contacts
//! and where the check failed. The search also tries lists of a neighbouring scene, of a rigid beam at rest and without contact. A list
//! that passes is checked once more closely ([`super::close`]).

use super::check::{Check, check};
use super::close::checked_closely;
use super::guess::{LONG, Samples};
use super::list::List;
use super::newton;
use super::normal::normal_form;
use super::piecewise::PiecewiseScene;
use super::repair::repaired;
use super::resting;
use super::room;
use super::solve::TheoryError;
use super::violation::Violation;

/// Number of links of the first chain; breaks of the profile add more. *Tuned* on random and hostile scenes: with 6 or with 24 three or
/// four of 700 hostile ones are lost.
const LINKS: u32 = 12;
/// Number of samples above which the first chain is refined before its first list, because the contacts are finer than its links. With
/// half or twice as many no fewer of 1,700 random and hostile scenes are certified.
const ENOUGH: usize = 40;
/// Maximum number of guesses, each with samples four times as fine. *Tuned* on hostile scenes: with half as many one of 700 is lost.
const GUESSES: usize = 12;
/// The same for a profile that is [`LONG`] and therefore fine already.
const GUESSES_OF_LONG: usize = 4;
/// Maximum number of samples of all guesses together, in addition to [`MULTIPLE`]: about 0.6 s, where 38,000 samples take 0.11 s.
const MOST_SAMPLES: usize = 200_000;
/// Further samples allowed, as a multiple of the samples of the first guess: the cost of a search is in proportion to its scene.
const MULTIPLE: usize = 10;
/// Maximum number of lists from one guess. With a third of them no fewer of 700 random and hostile scenes are certified: a finer guess
/// makes up for them.
const ROUNDS: usize = 10;
/// Maximum number of lists from the list of a neighbouring scene: after a step of a sweep it is the same, or one or two repairs away.
const ROUNDS_FROM_NEAR: usize = 3;
/// Number of lists without fewer faults than an earlier list, after which a finer guess is better. A list for which Newton's method
/// does not converge counts three times. With half of them no fewer of the same scenes are certified.
const STRIKES: usize = 6;

/// The best list that was found.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    /// The list.
    pub(super) list: List,
    /// The check of the list.
    pub(super) checked: Check,
    /// Number of Newton steps, including steps on lists that were tried before.
    pub(super) steps: usize,
    /// Number of lists that were tried, including this one.
    pub(super) lists: usize,
    /// Number of samples of the chains solved for all of these lists, set at the end of the search.
    pub(super) samples: usize,
    /// Whether Newton's method converged for the list.
    pub(super) converged: bool,
}

impl Candidate {
    /// Whether every condition is satisfied.
    pub(super) fn solved(&self) -> bool {
        self.checked.faults.is_empty() && self.converged
    }

    /// The same candidate with the faults of the elastic compression-only supports.
    pub(super) fn with(mut self, wrong: Vec<(usize, Violation)>) -> Self {
        if !wrong.is_empty() {
            self.checked.worst = f64::INFINITY;
        }
        self.checked.faults.extend(wrong);
        self
    }

    /// The better of two candidates: solved before converged, then the smaller violation. The work of both is added up.
    pub(super) fn better(self, other: Self) -> Self {
        let rank = |f: &Self| u8::from(f.solved()) + u8::from(f.converged);
        let better = rank(&self).cmp(&rank(&other)).then(other.checked.worst.total_cmp(&self.checked.worst));
        let (steps, lists) = (self.steps + other.steps, self.lists + other.lists);
        Self { steps, lists, ..if better.is_lt() { other } else { self } }
    }
}

/// The beam without contact.
fn free(given: &PiecewiseScene) -> Candidate {
    let mut list = List::free(given);
    // The slopes over inner supports are still unknown.
    let run = newton::solve(given, &mut list);
    let checked = check(given, &list);
    Candidate { list, checked, steps: run.steps, lists: 1, samples: 0, converged: run.converged }
}

/// The exact solution; the search first starts from each list in `near`.
///
/// The work is bounded by `GUESSES · ROUNDS` lists, [`ROUNDS_FROM_NEAR`] more for each list in `near`, the lists of a beam at rest and
/// of the close check, and by a multiple of the samples of the first guess, which are a few for each piece of the scene.
///
/// # Errors
///
/// [`TheoryError::NoMemory`] for more samples or contacts than there is memory for.
pub(super) fn search(given: &PiecewiseScene, near: impl Iterator<Item = List>) -> Result<Candidate, TheoryError> {
    // On such a long profile a guess, which may be the free beam, is cheaper than this check, which most beams fail.
    let is_long = LONG < given.cells.len();
    let nothing = !given.has_obstacle();
    let mut best = (nothing || !is_long).then(|| free(given));
    let is_solved = |best: &Option<Candidate>| best.as_ref().is_some_and(Candidate::solved);
    if let Some(free) = best.take_if(|free| free.solved() || nothing) {
        return Ok(free);
    }
    let mut places = Vec::new();
    for list in near {
        best = with_repairs(given, list, ROUNDS_FROM_NEAR, best, &mut places)?;
        if let Some(found) = best.take_if(|found| found.solved()) {
            return Ok(found);
        }
    }
    let mut samples = Samples::first(given, LINKS);
    let mut guess = samples.chain(given);
    if ENOUGH < samples.count() && given.founded {
        samples = samples.refined(given, &guess.touches, &[]);
        room::for_samples(given, samples.count())?;
        guess = samples.chain(given);
    }
    let mut taken = samples.count();
    let mut left = MULTIPLE * taken + MOST_SAMPLES;
    // For isolated compression-only supports one chain gives all that a chain can give.
    let guesses = match (given.founded, is_long) {
        (false, _) => 1,
        (true, true) => GUESSES_OF_LONG,
        (true, false) => GUESSES,
    };
    for turn in 0..guesses {
        if 0 < turn {
            samples = samples.refined(given, &guess.touches, &places);
            if left < samples.count() {
                break;
            }
            left -= samples.count();
            taken += samples.count();
            room::for_samples(given, samples.count())?;
            guess = samples.chain(given);
        }
        places.clear();
        best = with_repairs(given, samples.list(given, &guess), ROUNDS, best, &mut places)?;
        if is_solved(&best) {
            break;
        }
    }
    if !given.founded && !is_solved(&best) {
        best = with_repairs(given, resting::rigid_beam(given), ROUNDS, best, &mut places)?;
    }
    let found = match best {
        Some(found) if found.solved() || !is_long => found,
        found => better(found, free(given)),
    };
    Ok(Candidate { samples: taken, ..found })
}

/// The better of an earlier candidate, if there is one, and a new one.
fn better(before: Option<Candidate>, found: Candidate) -> Candidate {
    match before {
        Some(before) => before.better(found),
        None => found,
    }
}

/// The best of an earlier candidate and up to `rounds` lists. The first is `list`; each next one repairs the faults of the one before.
/// The positions of faults are added to `places`.
fn with_repairs(
    given: &PiecewiseScene,
    mut list: List,
    rounds: usize,
    mut best: Option<Candidate>,
    places: &mut Vec<f64>,
) -> Result<Option<Candidate>, TheoryError> {
    let (mut strikes, mut fewest) = (0, usize::MAX);
    for _ in 0..rounds {
        room::for_contacts(given, list.nodes.len())?;
        let run = newton::solve(given, &mut list);
        let normal = normal_form(given, &list.nodes);
        // Without the invalid nodes the equations change, and Newton's method has not solved the new ones.
        let changed = normal != list;
        let checked = check(given, &normal);
        let converged = run.converged && !changed;
        let found = Candidate { list: normal, checked, steps: run.steps, lists: 1, samples: 0, converged };
        if found.solved() {
            return Ok(Some(better(best, checked_closely(given, found))));
        }
        // Faults of a list that was not solved mean nothing.
        list = match changed {
            true => found.list.clone(),
            false => repaired(given, &found.list, &found.checked, &found.checked.faults),
        };
        let faults = found.checked.faults.len();
        strikes += match (fewest <= faults, run.converged) {
            (true, true) => 1,
            (true, false) => 3,
            _ => 0,
        };
        fewest = fewest.min(faults);
        let ends = list == found.list && !changed || STRIKES <= strikes;
        places.extend(found.checked.faults.iter().filter_map(|(_, fault)| fault.place()));
        best = Some(better(best, found));
        if ends {
            break;
        }
    }
    Ok(best)
}
