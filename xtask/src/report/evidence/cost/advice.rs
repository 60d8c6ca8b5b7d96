//! Advice as data: each recommendation of a route is a row of `report/advice.csv` that has to hold in the measurements, or
//! there is no report.

use std::path::Path;

use serde::Deserialize;

use super::milliseconds;
use crate::data;
use crate::measure::line::{Line, Store};
use crate::report::evidence::prelude::*;

/// Where it is, below the root.
const PATH: &str = "report/advice.csv";

/// One recommendation.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Advice {
    /// Whose case it is.
    case: String,
    /// Scenes that stand for it, with blanks between them.
    scenes: String,
    method: String,
    solver: String,
    /// 0 for no grid, or one that the route chooses.
    intervals: usize,
    /// What is asked for; 0 for nothing.
    tolerance: f64,
    /// The largest error that is promised, see [`Advice::error`].
    promise: f64,
    /// What one types.
    command: String,
    /// What to believe of the answer.
    believe: String,
}

impl Advice {
    /// The lines that it rests on, one for each scene.
    fn lines<'a>(&self, store: &'a Store) -> Result<Vec<&'a Line>, String> {
        let of_scene = |scene: &str| {
            let same = |line: &&Line| {
                line.scene == scene
                    && line.is(&self.method, &self.solver)
                    && line.intervals == self.intervals
                    && line.asks(self.tolerance)
            };
            store.lines.iter().find(same).ok_or_else(|| format!("`{}` on scene {scene} was not measured", self.case))
        };
        self.scenes.split_whitespace().map(of_scene).collect()
    }

    /// The error that a promise is about: of the exact solution its residual, of the adaptive grid the certified error of the
    /// deflection, of a grid the worst of left reaction, largest contact, deflection and energy against the exact solution.
    fn error(line: &Line) -> Option<f64> {
        match (line.method.as_str(), line.certified_error) {
            ("exact", _) => line.residual,
            (_, Some(certified)) => Some(certified),
            (_, None) => line.worst(),
        }
    }

    /// Whether all its lines are certified and within the promise.
    fn check(&self, store: &Store) -> Result<(), String> {
        let lines = self.lines(store)?;
        if lines.is_empty() {
            return Err(format!("`{}` names no scene", self.case));
        }
        for line in lines {
            if !line.succeeded() {
                return Err(format!("`{}` is {} on scene {}", self.case, line.status, line.scene));
            }
            match Self::error(line) {
                Some(error) if error <= self.promise => {}
                error => {
                    return Err(format!(
                        "`{}` promises an error of at most {:e}, but on scene {} it is {}",
                        self.case,
                        self.promise,
                        line.scene,
                        error.map_or_else(|| "unknown".to_owned(), |error| format!("{error:e}"))
                    ));
                }
            }
        }
        Ok(())
    }
}

/// All advice, if all of it holds.
pub(super) fn held(root: &Path, store: &Store) -> Result<Vec<Advice>, Cause> {
    let (_, advice): (_, Vec<Advice>) = data::read(root, PATH)?;
    advice.iter().try_for_each(|advice| advice.check(store)).map_err(|error| format!("{PATH}: {error}"))?;
    Ok(advice)
}

/// The table of the recommendation: times and errors are the worst over the scenes.
pub(super) fn table(advice: &[Advice], store: &Store) -> Table {
    let rows = advice.iter().map(|advice| {
        let lines = advice.lines(store).unwrap_or_default();
        let worst = |of: &dyn Fn(&Line) -> Option<f64>| lines.iter().filter_map(|line| of(line)).max_by(f64::total_cmp);
        let grids: Vec<usize> = lines.iter().filter_map(|line| line.last_intervals).collect();
        let grid = match (advice.intervals, grids.iter().min(), grids.iter().max()) {
            (0, Some(least), Some(most)) => format!("{} to {} intervals", count(*least), count(*most)),
            (0, ..) => "no grid".to_owned(),
            (intervals, ..) => format!("{} intervals", count(intervals)),
        };
        let [promised, measured] = [Some(advice.promise), worst(&|line| Advice::error(line))].map(error_cell);
        // Only what is proven is an upper bound.
        let error = match (advice.method.as_str(), grids.is_empty(), lines.len()) {
            ("exact", ..) => format!("{measured}, residual"),
            (_, false, _) => format!("{promised}, guaranteed"),
            (_, true, 1) => format!("{measured}, measured"),
            (_, true, scenes) => format!("{measured}, measured on {scenes} scenes"),
        };
        row![
            advice.case,
            format!("`{}`", advice.command),
            format!("{grid}, {} ms", cell(worst(&|line| Some(milliseconds(line))), 2)),
            error,
            advice.believe,
        ]
    });
    Table::new(["your case", "command", "grid and time", "error", "what to believe"]).rows(rows)
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    fn root() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
    }

    #[test]
    fn the_advice_holds_and_a_false_one_does_not() {
        let (_, store) = Store::read(&root()).expect("measurements can be read");
        let advice = held(&root(), &store).expect("all advice holds");
        assert!(5 <= advice.len(), "one for each case");
        for advice in advice {
            // A promise just below the error, another solver that nobody measured, and a scene without measurement.
            let worst =
                advice.lines(&store).expect("measured").into_iter().filter_map(Advice::error).fold(0.0, f64::max);
            let too_good = Advice { promise: 0.99 * worst, ..advice.clone() };
            assert!(worst == 0.0 || too_good.check(&store).is_err(), "{too_good:?}");
            let unknown = Advice { scenes: "nowhere".to_owned(), ..advice.clone() };
            assert!(unknown.check(&store).is_err(), "{unknown:?}");
        }
    }

    #[test]
    fn what_is_not_solved_is_no_advice() {
        let (_, mut store) = Store::read(&root()).expect("measurements can be read");
        let advice = held(&root(), &store).expect("all advice holds").remove(0);
        store.lines.iter_mut().for_each(|line| line.status = "not solved".to_owned());
        assert!(advice.check(&store).is_err_and(|message| message.contains("not solved")));
    }
}
