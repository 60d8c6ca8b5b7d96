//! One line of the verdict table on the first screen.

use serde::Serialize;

/// What the paper has, what came out now, and what is to be thought of it.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Row {
    /// The number, figure or claim.
    pub(super) what: String,
    /// What the paper prints or says.
    pub(super) paper: String,
    /// What was computed for this report.
    pub(super) now: String,
    /// One word.
    pub(super) verdict: &'static str,
    /// Where to read on: an anchor of the report.
    pub(super) section: &'static str,
}
