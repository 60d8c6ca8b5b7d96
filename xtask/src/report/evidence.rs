//! What the report rests on, subject by subject: values for the templates, figures and data.
//!
//! To add a subject: a module here with `evidence(study)`, and a line in [`SUBJECTS`]. Every template sees its values as
//! `{{ <name>.field }}`.

mod adaptive;
mod bounds;
mod closed;
mod convergence;
mod cost;
mod gallery;
mod holds;
mod in_one_file;
mod judged;
mod moment;
mod opened_gap;
mod paper;
mod play;
mod point_force;
mod population;
mod problem;
mod proven;
mod provenance;
mod referee;
mod scale;
mod scene_file;
mod soil;
mod stability;
mod stiff;
mod sweeps;
mod taught;
mod teaching;
mod trains;
mod verdict_map;
pub(super) mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::OnceLock;

use minijinja::{Value, context};
use palkki::plot::{Figure, Panel};
use palkki::route::{Method, Solution, Solver};
use palkki::scene::{Scene, SceneError};
use palkki::state::{ContactState, Nodes};
use palkki::{Settings, solve_raw};
use palkki_evidence::paper::claims::Ledger;
use rayon::prelude::*;

use crate::table::Table;
use crate::{Cause, tell};
use words::Words;

/// What the subjects have in common.
mod prelude {
    pub(super) use minijinja::{Value, context};
    pub(super) use palkki::route::{Method, Solver, Status};
    pub(super) use palkki::scene::{Foundation, Scene};
    pub(super) use palkki::theory;
    pub(super) use palkki_evidence::compare::{apart_if_any, largest};

    pub(super) use super::words::Words;
    pub(super) use super::{Drawn, Evidence, Study, least_most, load, nodes_of, on_grid, range, routes};
    pub(super) use crate::table::{Table, row};
    pub(super) use crate::text::*;
    pub(super) use crate::{Cause, scenes};
}

/// One subject: its name in the templates, and what computes it.
type Subject = (&'static str, fn(&Study<'_>) -> Result<Evidence, Cause>);

/// All subjects, in the order in which the report lists their data.
const SUBJECTS: &[Subject] = &[
    ("problem", problem::sketch),
    ("methods", problem::methods),
    ("paper", in_one_file::evidence),
    ("proof", proven::evidence),
    ("theory", closed::evidence),
    ("play", play::evidence),
    ("solvers", problem::solvers),
    ("teaching", teaching::evidence),
    ("opened_gap", opened_gap::evidence),
    ("figures", paper::figures::evidence),
    ("flexibility", paper::flexibility::evidence),
    ("moment", moment::evidence),
    ("first_force", paper::figures::first_force),
    ("agreement", paper::agreement::evidence),
    ("bounds", bounds::evidence),
    ("judged", judged::evidence),
    ("adaptive", adaptive::evidence),
    ("referee", referee::evidence),
    ("convergence", convergence::evidence),
    ("population", population::evidence),
    ("scenes", gallery::evidence),
    ("holds", holds::evidence),
    ("scene_file", scene_file::evidence),
    ("sweeps", sweeps::evidence),
    ("trains", trains::evidence),
    ("stiff", stiff::evidence),
    ("point_force", point_force::evidence),
    ("claims", paper::claims::evidence),
    ("recommendation", paper::claims::recommendation),
    ("cost", cost::evidence),
    ("scale", scale::evidence),
    ("soil", soil::evidence),
    ("conditioning", stability::conditioning::evidence),
    ("extremes", stability::extremes::evidence),
    ("hostile", stability::hostile::evidence),
    ("discrepancies", provenance::discrepancies),
    ("reproduce", provenance::evidence),
];

/// The repository, and what was measured for more than one subject.
#[derive(Debug)]
pub(crate) struct Study<'a> {
    /// Root of the repository.
    root: &'a Path,
    /// The words of the figures.
    words: BTreeMap<String, String>,
    ledger: OnceLock<Result<Ledger, SceneError>>,
}

impl Study<'_> {
    /// What the claims of the paper are judged by.
    fn ledger(&self) -> Result<&Ledger, Cause> {
        self.ledger.get_or_init(Ledger::measure).as_ref().map_err(|&error| error.into())
    }

    /// The words of a figure.
    fn words(&self, figure: &str, values: Value) -> Result<Words, Cause> {
        Words::of(&self.words, figure, values)
    }

    /// A figure of some panels with its words.
    fn drawn(
        &self,
        name: &'static str,
        values: Value,
        columns: usize,
        panels: Vec<Panel>,
        data: Table,
    ) -> Result<Drawn, Cause> {
        let Words { title, description, notes, .. } = self.words(name, values)?;
        Ok((name, Figure { columns, notes, ..Figure::new(title, description, panels) }.svg()?, data))
    }
}

/// What one subject hands to the templates, and the files that it makes.
#[derive(Debug)]
pub(crate) struct Evidence {
    /// What the templates interpolate.
    pub(super) values: Value,
    /// Figures and data: path below `report/` → text.
    pub(super) files: BTreeMap<String, String>,
}

/// The name of a figure, the drawing, and the numbers that it draws.
type Drawn<Name = &'static str> = (Name, String, Table);

impl Evidence {
    /// Values without figures and data.
    pub(super) fn new(values: impl Into<Value>) -> Self {
        Self { values: values.into(), files: BTreeMap::new() }
    }

    /// With a figure and the numbers that it draws: `figures/<name>.svg` and `data/<name>.csv`.
    pub(super) fn figure(mut self, name: &str, svg: String, data: Table) -> Result<Self, Cause> {
        self.files.insert(format!("figures/{name}.svg"), svg);
        self.data(name, data)
    }

    /// With some of them.
    fn figures<Name: AsRef<str>>(self, figures: impl IntoIterator<Item = Drawn<Name>>) -> Result<Self, Cause> {
        figures.into_iter().try_fold(self, |evidence, (name, svg, data)| evidence.figure(name.as_ref(), svg, data))
    }

    /// With numbers that no figure draws: `data/<name>.csv`.
    fn data(self, name: &str, data: Table) -> Result<Self, Cause> {
        Ok(self.file(name, data.csv()?))
    }

    /// With a file of data whose text is there.
    fn file(mut self, name: &str, text: String) -> Self {
        self.files.insert(format!("data/{name}.csv"), text);
        self
    }
}

/// What the `wanted` subjects rest on, in the order of [`SUBJECTS`]; the error of the first that has one.
///
/// A subject is computed by one thread, from the tree and from what [`Study`] measures once for all of them, and so it is the
/// same whichever thread computes it and when.
pub(super) fn compute(root: &Path, wanted: &BTreeSet<String>) -> Result<Vec<(&'static str, Evidence)>, Cause> {
    let subjects: Vec<Subject> = SUBJECTS.iter().filter(|(name, _)| wanted.contains(*name)).copied().collect();
    let study = Study { root, words: words::sections(root)?, ledger: OnceLock::new() };
    // One of the last takes longest.
    let found = subjects.par_iter().rev().with_max_len(1).map(|(subject, evidence)| {
        tell(&format!("evidence for {subject}"));
        evidence(&study)
            .map(|found| (*subject, found))
            .map_err(|error| format!("the evidence `{subject}`: {error}").into())
    });
    found.collect::<Vec<_>>().into_iter().rev().collect()
}

/// Every method with every solver.
fn routes() -> impl Iterator<Item = (Method, Solver)> {
    Method::ALL.into_iter().flat_map(|method| Solver::ALL.map(|solver| (method, solver)))
}

/// A scene solved on a grid, to the tolerance that is the default.
fn on_grid(scene: &Scene, method: Method, solver: Solver, intervals: usize) -> Result<Solution<()>, Cause> {
    Ok(solve_raw(scene, &Settings::new(method, solver, intervals))?)
}

/// The nodes of an answer on a grid.
fn nodes_of(state: &ContactState) -> Result<&Nodes, Cause> {
    state.nodes.as_ref().ok_or_else(|| "a discretised state has nodes".into())
}

/// The whole load of a scene, upward or downward \[force\].
fn load(scene: &Scene) -> f64 {
    scene.load().magnitude(scene.beam().length())
}

/// The least and the greatest of some numbers.
fn range(numbers: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let numbers = numbers.into_iter().map(|number| [number, number]);
    numbers.reduce(|[least, most], [a, b]| [least.min(a), most.max(b)])
}

/// The same for a template.
fn least_most(numbers: impl IntoIterator<Item = f64>) -> Option<Value> {
    range(numbers).map(|[least, most]| context! { least, most })
}
