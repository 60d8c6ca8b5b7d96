//! All routes on two scenes and three grids, and two questions for each: did the solver do what it was asked, and does its
//! answer pass our check?

use std::path::Path;

use minijinja::{Value, context};
use palkki::route::{Method, Outcome, Solver, Status};
use palkki::{DEFAULT_TOLERANCE, Settings, solve};

use super::exactly_a_power;
use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::scenes;
use crate::report::table::Table;

/// The example, and ground that is not flat.
const SCENES: [&str; 2] = ["heinisuo-1984", "wave"];
const GRIDS: [usize; 3] = [30, 100, 300];

/// What the libraries are asked for besides the default.
const LOOSE: f64 = 1e-4;

/// NSOR runs out of its budget on the finest grid; it takes many seconds to.
fn too_long(solver: Solver, intervals: usize) -> bool {
    200 < intervals && solver == Solver::Nsor
}

/// Runs everything: the counts, and every run as data.
pub(super) fn evidence(root: &Path) -> Result<(Value, String), Cause> {
    let scenes = SCENES.map(|name| scenes::read(root, name).map(|scene| (name, scene)));
    let scenes = scenes.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut table = Table::new([
        "solver",
        "asked for",
        "own tolerance",
        "runs",
        "says solved",
        "did what it was asked",
        "passes our check",
    ]);
    let (mut data, mut libraries, mut all) = (Vec::new(), Counts::default(), Counts::default());
    for solver in Solver::ALL {
        let is_library = matches!(solver, Solver::Clarabel | Solver::Osqp);
        for tolerance in [LOOSE, DEFAULT_TOLERANCE].into_iter().filter(|&t| is_library || t == DEFAULT_TOLERANCE) {
            let mut counts = Counts::default();
            for (name, scene) in &scenes {
                for method in Method::ALL {
                    for intervals in GRIDS.into_iter().filter(|&n| !too_long(solver, n)) {
                        let outcome =
                            solve(scene, &Settings { tolerance, ..Settings::new(method, solver, intervals) })?;
                        let run = Counts::of(&outcome);
                        let words =
                            [*name, method.word(), solver.word(), &intervals.to_string(), &format!("{tolerance:e}")];
                        data.push(words.into_iter().map(str::to_owned).chain(run.yes_or_no()).collect());
                        counts.add(&run);
                    }
                }
            }
            all.add(&counts);
            if is_library {
                libraries.add(&counts);
            }
            let has_tolerance = is_library || solver == Solver::Nsor;
            let asked = if has_tolerance { exactly_a_power(tolerance) } else { "–".to_owned() };
            let own = counts.asked.map_or("–".to_owned(), exactly_a_power);
            let met = if is_library { counts.met.to_string() } else { "–".to_owned() };
            let [runs, says, passes] = [counts.runs, counts.says, counts.passes].map(|count| count.to_string());
            table = table.row([solver.word().to_owned(), asked, own, runs, says, met, passes]);
        }
    }
    let values = context! {
        table,
        grids => GRIDS,
        scenes => scenes.iter().map(|(_, scene)| scene.title().to_owned()).collect::<Vec<_>>(),
        loose => exactly_a_power(LOOSE),
        runs => all.runs,
        fooled => all.says_and_fails,
        fooled_libraries => libraries.says_and_fails,
        met_and_fails => libraries.met_and_fails,
        unmet_and_passes => libraries.unmet_and_passes,
    };
    let header = ["scene", "method", "solver", "intervals", "asked", "says_solved", "did_what_it_was_asked", "passes"];
    Ok((values, csv(&header, data)))
}

/// Numbers of runs.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    runs: usize,
    says: usize,
    met: usize,
    passes: usize,
    says_and_fails: usize,
    met_and_fails: usize,
    unmet_and_passes: usize,
    /// Runs of which nobody knows what they left of their own problem.
    unknown: usize,
    /// The tolerance of a library, in its own norm.
    asked: Option<f64>,
}

impl Counts {
    /// A single run.
    fn of(outcome: &Outcome) -> Self {
        let (says, passes) = (outcome.solver_claims_success, outcome.status == Status::Certified);
        let met = outcome.own_residual.is_some_and(|own| own.is_met());
        let unmet = outcome.own_residual.is_some_and(|own| !own.is_met());
        Self {
            runs: 1,
            says: usize::from(says),
            met: usize::from(met),
            passes: usize::from(passes),
            says_and_fails: usize::from(says && !passes),
            met_and_fails: usize::from(met && !passes),
            unmet_and_passes: usize::from(unmet && passes),
            unknown: usize::from(outcome.own_residual.is_none()),
            asked: outcome.own_residual.map(|own| own.asked),
        }
    }

    fn add(&mut self, other: &Self) {
        self.runs += other.runs;
        self.says += other.says;
        self.met += other.met;
        self.passes += other.passes;
        self.says_and_fails += other.says_and_fails;
        self.met_and_fails += other.met_and_fails;
        self.unmet_and_passes += other.unmet_and_passes;
        self.unknown += other.unknown;
        self.asked = other.asked;
    }

    /// Of a single run: the solver says solved, it did what it was asked, its answer passes.
    fn yes_or_no(&self) -> [String; 3] {
        let word = |count: usize| if count == 1 { "yes" } else { "no" };
        [word(self.says), if self.unknown == 1 { "" } else { word(self.met) }, word(self.passes)].map(str::to_owned)
    }
}
