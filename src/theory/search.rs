//! Finding the list of contacts: guess, Newton's method, check, mend; finer guesses until the check passes; in the end the
//! lists that were tried are changed one fault at a time.

use super::explore::explored;
use super::given::Given;
use super::guess;
use super::list::{AtSupport, List};
use super::newton;
use super::pressure::lifting;
use super::repair::mended;
use super::tidy::{consistent, joined};
use super::verify::{Checked, check};

/// Links of the chains that guesses come from. The first is enough for most scenes; the last resolves contacts that are
/// a thousandth of the beam apart.
const LINKS: [u32; 5] = [12, 48, 192, 768, 3456];
/// How often a list is mended before a finer guess is asked for.
const ROUNDS: usize = 10;

/// The best list that was found.
#[derive(Debug, Clone)]
pub(super) struct Found {
    /// The list.
    pub(super) list: List,
    /// What follows from it.
    pub(super) checked: Checked,
    /// Newton steps of all attempts together.
    pub(super) steps: usize,
    /// Lists that were tried.
    pub(super) lists: usize,
    /// True if Newton's method converged for the list.
    pub(super) converged: bool,
}

impl Found {
    /// True if every condition holds.
    pub(super) fn certified(&self) -> bool {
        /// Newton's method creeps towards a double root (the end of a zone at an edge that carries nothing) and may not
        /// say that it is there; conditions that hold to a few units of rounding say so.
        const ROUNDING: f64 = 1e-14;
        self.checked.faults.is_empty() && (self.converged || self.checked.worst <= ROUNDING)
    }

    /// The better of two: one that is certified, one that converged, the one that violates less.
    pub(super) fn better(self, other: Self) -> Self {
        let rank = |f: &Self| u8::from(f.certified()) + u8::from(f.converged);
        let better = rank(&self).cmp(&rank(&other)).then(other.checked.worst.total_cmp(&self.checked.worst));
        if better.is_lt() { other } else { self }
    }
}

/// The beam without contact.
pub(super) fn free(given: &Given) -> Found {
    let list = List::free();
    let checked = check(given, &[], &list);
    Found { list, checked, steps: 0, lists: 1, converged: true }
}

/// The exact solution above a foundation; it ends after at most `LINKS.len() · ROUNDS` lists and those of [`explored`].
pub(super) fn search(given: &Given) -> Found {
    let mut best = free(given);
    if best.certified() {
        return best;
    }
    let lifting = lifting(given);
    let first = mended(given, &lifting, &best.list, &best.checked);
    let (mut steps, mut lists) = (0, 1);
    let mut pool = Vec::new();
    for links in LINKS {
        let mut list = guess::list(given, &lifting, links);
        if list.nodes.is_empty() && list.supports == [AtSupport::Free; 2] {
            list.clone_from(&first);
        }
        let mut tried: Vec<List> = Vec::new();
        for _ in 0..ROUNDS {
            if tried.contains(&list) {
                break;
            }
            tried.push(list.clone());
            list = joined(given, list);
            let run = newton::solve(given, &mut list);
            list = consistent(given, list);
            steps += run.steps;
            lists += 1;
            let checked = check(given, &lifting, &list);
            let next = mended(given, &lifting, &list, &checked);
            let found = Found { list, checked, steps, lists, converged: run.converged };
            pool.push(found.clone());
            best = best.better(found);
            if best.certified() {
                return best;
            }
            list = next;
        }
    }
    explored(given, &lifting, Found { steps, lists, ..best }, pool)
}
