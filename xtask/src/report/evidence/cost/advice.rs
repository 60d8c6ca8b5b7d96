//! Advice that is held by data: the routes of `report/advice.csv` solve the scenes on which they are measured, and keep their promises
//! on the second draw of the population, or there is no report.

use super::milliseconds;
use crate::measure::advice::{self, Advice};
use crate::measure::line::{self, Store};
use crate::measure::population::{Line, SCENES};
use crate::report::evidence::population::Spread;
use crate::report::evidence::prelude::*;
use palkki_evidence::observables::NAMES;

/// The observables of the report.
const SUPPORTS_AND_MOMENT: [usize; 2] = [0, 3];

/// Of so many scenes one may miss a promise.
const ONE_IN: usize = 100;

/// What is measured of a recommendation: a line for each scene with its time, and a line for each scene of the second draw.
struct Measured<'a> {
    timed: Vec<&'a line::Line>,
    drawn: Vec<&'a Line>,
}

impl<'a> Measured<'a> {
    fn of(advice: &Advice, store: &'a Store, population: &'a [Line]) -> Result<Self, String> {
        let unknown = |scene: &str| format!("`{}` on {scene} was not measured", advice.case);
        let of_scene = |scene: &str| {
            let same = |line: &&line::Line| {
                line.scene == scene
                    && line.is(&advice.method, &advice.solver)
                    && line.intervals == advice.intervals
                    && line.asks(advice.tolerance)
            };
            store.lines.iter().find(same).ok_or_else(|| unknown(scene))
        };
        let timed = advice.scenes.split_whitespace().map(of_scene).collect::<Result<Vec<_>, _>>()?;
        let mut drawn = Vec::new();
        for family in advice.families() {
            let before = drawn.len();
            drawn.extend(population.iter().filter(|line| {
                line.draw == 2
                    && line.family == family
                    && (line.method.as_str(), line.solver.as_str()) == (&advice.method, &advice.solver)
                    && line.intervals == advice.intervals
                    && line.tolerance.total_cmp(&advice.tolerance).is_eq()
            }));
            if drawn.len() != before + SCENES[1] as usize {
                return Err(unknown(family));
            }
        }
        if timed.is_empty() || drawn.is_empty() { Err(unknown("no scene")) } else { Ok(Self { timed, drawn }) }
    }

    /// The errors of an observable where the scene is solved.
    fn errors(&self, of: usize) -> Option<Spread> {
        let solved = self.drawn.iter().filter(|line| line.succeeded());
        Spread::of(solved.filter_map(|line| Some(line.errors()?[of])))
    }

    /// How many scenes miss something that is promised.
    fn misses(&self, advice: &Advice) -> usize {
        let kept = |line: &&&Line| {
            let within = |errors: [f64; 5]| {
                errors.iter().zip(advice.promises()).all(|(error, promise)| promise.is_none_or(|most| *error <= most))
            };
            line.succeeded() && line.errors().is_some_and(within)
        };
        self.drawn.len() - self.drawn.iter().filter(kept).count()
    }
}

/// Whether all that is timed is solved, and the promises are kept but on one scene in a hundred.
fn check(advice: &Advice, store: &Store, population: &[Line]) -> Result<(), String> {
    let found = Measured::of(advice, store, population)?;
    if let Some(line) = found.timed.iter().find(|line| !line.succeeded()) {
        return Err(format!("`{}` is {} on scene {}", advice.case, line.status, line.scene));
    }
    match found.misses(advice) {
        _ if !advice.has_promise() => Ok(()),
        misses if misses * ONE_IN <= found.drawn.len() => Ok(()),
        misses => Err(format!("`{}` misses its promise on {misses} of {} scenes", advice.case, found.drawn.len())),
    }
}

/// All advice, if all of it holds.
fn held(study: &Study<'_>, store: &Store, population: &[Line]) -> Result<Vec<Advice>, Cause> {
    let advice = advice::read(study.root)?;
    let checked = advice.iter().try_for_each(|advice| check(advice, store, population));
    checked.map_err(|error| format!("{}: {error}", advice::PATH))?;
    Ok(advice)
}

/// How many of the cases the report shows; the page on costs has all.
const SHOWN: usize = 5;

/// Two tables, if the advice holds: the first cases with their command, grid, time and promises, and the errors of every observable in
/// every case.
pub(super) fn tables(study: &Study<'_>, store: &Store, population: &[Line]) -> Result<[Table; 2], Cause> {
    let of_supports_and_moment = ["reactions, %", "moment, %"];
    let header = ["your case", "command", "intervals", "time, ms"].into_iter().chain(of_supports_and_moment);
    let mut advised = Table::new(header.chain(["what to trust"]));
    let mut all = Table::new(["your case", "quantity", "promised, %", "median, %", "maximum, %", "problems", "missed"]);
    for (place, advice) in held(study, store, population)?.into_iter().enumerate() {
        let found = Measured::of(&advice, store, population)?;
        let percent = |error: Option<f64>, digits| cell(error.map(|error| 100.0 * error), digits);
        let promised = |of: usize| percent(advice.promises()[of], 1);
        for (of, name) in NAMES.into_iter().enumerate() {
            // The grid-free solution is what all others are compared with.
            let spread = found.errors(of).filter(|_| advice.method != "exact");
            let [median, most] = [|s: Spread| s.median, |s: Spread| s.worst].map(|of| percent(spread.map(of), 2));
            all.push(row![advice.case, name, promised(of), median, most, found.drawn.len(), found.misses(&advice)]);
        }
        if place < SHOWN {
            let slowest = found.timed.iter().map(|line| milliseconds(line)).fold(0.0, f64::max);
            let grid = match advice.intervals {
                0 if advice.method == "exact" => "none".to_owned(),
                0 => "as needed".to_owned(),
                intervals => count(intervals),
            };
            let [supports, moment] = SUPPORTS_AND_MOMENT.map(promised);
            let (command, time) = (format!("`{}`", advice.command), cell(Some(slowest), 2));
            advised.push(row![advice.case, command, grid, time, supports, moment, advice.believe]);
        }
    }
    Ok([advised, all])
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::data;
    use crate::measure::population::PATH;

    #[test]
    fn the_advice_holds_and_a_false_one_does_not() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let (_, mut store) = Store::read(&root).expect("measurements can be read");
        let (_, population): (_, Vec<Line>) = data::read(&root, PATH).expect("the population can be read");
        let all = advice::read(&root).expect("advice can be read");
        assert!(5 <= all.len(), "one for each case");
        for advice in &all {
            assert_eq!(check(advice, &store, &population), Ok(()));
            let nowhere = Advice { scenes: "nowhere".to_owned(), ..advice.clone() };
            assert!(check(&nowhere, &store, &population).is_err(), "{nowhere:?}");
            if !advice.has_promise() {
                continue;
            }
            // One scene in fifty misses what is promised, or is not solved.
            let (mut far, mut unsolved) = (population.clone(), population.clone());
            let own = |line: &Line| line.draw == 2 && line.method == advice.method && line.solver == advice.solver;
            for line in far.iter_mut().filter(|line| own(line) && line.scene % 50 == 7) {
                *line = line.clone().with_error(1.0);
            }
            unsolved.iter_mut().filter(|line| own(line) && line.scene % 50 == 7).for_each(|line| line.status.clear());
            assert!([far, unsolved].iter().all(|false_one| check(advice, &store, false_one).is_err()), "{advice:?}");
        }
        store.lines.iter_mut().for_each(|line| line.status = "not solved".to_owned());
        assert!(check(&all[0], &store, &population).is_err_and(|message| message.contains("not solved")));
    }
}
