//! A search among lists that differ by the mending of one fault, for scenes on which mending all faults at once goes round
//! in circles.

use super::alternatives::alternatives;
use super::given::Given;
use super::list::{Kind, List};
use super::newton;
use super::search::Found;
use super::tidy::{consistent, joined};
use super::verify::check;

/// Lists that are explored at most; one or two are enough for most scenes that come here.
const EXPLORED: usize = 200;
/// How often Newton's method goes on with a list that has not converged.
const AGAIN: usize = 3;

/// The best list that changes of single faults lead to, starting from all lists that were `tried`: always those of the list
/// with the fewest faults that has not been changed yet, of several the one that violates least.
pub(super) fn explored(given: &Given, lifting: &[(f64, f64)], best: Found, tried: Vec<Found>) -> Found {
    let (mut steps, mut lists) = (best.steps, best.lists);
    let last = lists + EXPLORED;
    let mut best = best;
    let mut seen: Vec<Outline> = tried.iter().map(|f| outline(&f.list)).collect();
    let mut open = tried;
    while let Some(next) = (0..open.len()).min_by(|&i, &j| {
        let (a, b) = (&open[i].checked, &open[j].checked);
        a.faults.len().cmp(&b.faults.len()).then(a.worst.total_cmp(&b.worst))
    }) {
        let from = open.swap_remove(next);
        for list in alternatives(given, &from.list, &from.checked) {
            let mut list = joined(given, list);
            if seen.contains(&outline(&list)) {
                continue;
            }
            seen.push(outline(&list));
            let mut run = newton::solve(given, &mut list);
            steps += run.steps;
            for _ in 0..AGAIN {
                if run.converged {
                    break;
                }
                run = newton::solve(given, &mut list);
                steps += run.steps;
            }
            list = consistent(given, list);
            lists += 1;
            let checked = check(given, lifting, &list);
            let found = Found { list, checked, steps, lists, converged: run.converged };
            open.push(found.clone());
            best = best.better(found);
            if best.certified() || last <= lists {
                return Found { steps, lists, ..best };
            }
        }
    }
    Found { steps, lists, ..best }
}

/// What a list looks like, wherever its nodes are.
type Outline = Vec<(Kind, usize)>;

fn outline(list: &List) -> Outline {
    list.nodes.iter().map(|n| (n.kind, n.cell)).collect()
}
