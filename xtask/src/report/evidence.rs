//! What the report rests on, subject by subject: values for the templates, figures and data.
//!
//! To add a subject: a module here with `evidence(study)`, and a line in [`EVIDENCE`]. Every template sees its values as
//! `{{ <name>.field }}`.

mod adaptive;
mod agreement;
mod bounds;
mod claims;
mod conditioning;
mod convergence;
mod cost;

mod discrepancies;
mod extremes;
mod figures;
mod first_force;
mod hostile;
mod judged;
mod methods;
mod problem;
mod recommendation;
mod regimes;
mod reproduce;
mod scale;
mod scenes;
mod sheet;
mod sliders;
mod solvers;
mod teaching;
mod theory;

use std::collections::BTreeMap;

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;

use super::error::Cause;
use super::study::Study;

/// One subject: its name in the templates, and what computes it.
pub(super) type Subject = (&'static str, fn(&Study<'_>) -> Result<Evidence, Cause>);

/// All subjects. The order has no meaning for the report; the last ones are computed first.
pub(super) const EVIDENCE: &[Subject] = &[
    ("problem", problem::evidence),
    ("methods", methods::evidence),
    ("theory", theory::evidence),
    ("sliders", sliders::evidence),
    ("solvers", solvers::evidence),
    ("teaching", teaching::evidence),
    ("figures", figures::evidence),
    ("first_force", first_force::evidence),
    ("regimes", regimes::evidence),
    ("agreement", agreement::evidence),
    ("bounds", bounds::evidence),
    ("judged", judged::evidence),
    ("adaptive", adaptive::evidence),
    ("convergence", convergence::evidence),
    ("scenes", scenes::evidence),
    ("sheet", sheet::evidence),
    ("claims", claims::evidence),
    ("recommendation", recommendation::evidence),
    ("cost", cost::evidence),
    ("scale", scale::evidence),
    ("conditioning", conditioning::evidence),
    ("extremes", extremes::evidence),
    ("hostile", hostile::evidence),
    ("discrepancies", discrepancies::evidence),
    ("reproduce", reproduce::evidence),
];

/// What one subject hands to the templates, and the files that it makes.
#[derive(Debug)]
pub(crate) struct Evidence {
    /// What the templates interpolate.
    pub(super) values: Value,
    /// Figures and data: path below `report/` → text.
    pub(super) files: BTreeMap<String, String>,
}

impl Evidence {
    /// Values without figures and data.
    pub(crate) fn new(values: impl Serialize) -> Self {
        Self { values: Value::from(Serde(values)), files: BTreeMap::new() }
    }

    /// With a figure and the numbers that it draws: `figures/<name>.svg` and `data/<name>.csv`.
    pub(crate) fn figure(self, name: &str, svg: String, csv: String) -> Self {
        let mut with = self.data(name, csv);
        with.files.insert(format!("figures/{name}.svg"), svg);
        with
    }

    /// With numbers that no figure draws: `data/<name>.csv`.
    pub(crate) fn data(mut self, name: &str, csv: String) -> Self {
        self.files.insert(format!("data/{name}.csv"), csv);
        self
    }
}
