//! What the code of a chapter hands to its template, and the files that it makes.

use std::collections::BTreeMap;

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;

/// What one chapter rests on.
#[derive(Debug)]
pub(crate) struct Evidence {
    /// What the template interpolates.
    pub(super) values: Value,
    /// Figures and data: path below `report/` → text.
    files: BTreeMap<String, String>,
}

impl Evidence {
    /// The values of a chapter without figures and data.
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

    /// Path below `report/` → text.
    pub(super) fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }
}
