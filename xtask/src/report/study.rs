//! What several subjects rest on, computed once.

use std::path::Path;
use std::sync::OnceLock;

use palkki::scene::SceneError;
use palkki_evidence::paper::claims::Ledger;

use super::error::Cause;

/// The repository, and what was measured for more than one subject.
#[derive(Debug)]
pub(crate) struct Study<'a> {
    /// Root of the repository.
    pub(super) root: &'a Path,
    ledger: OnceLock<Result<Ledger, SceneError>>,
}

impl<'a> Study<'a> {
    /// Nothing is computed yet.
    pub(super) fn new(root: &'a Path) -> Self {
        Self { root, ledger: OnceLock::new() }
    }

    /// What the claims of the paper are judged by.
    pub(super) fn ledger(&self) -> Result<&Ledger, Cause> {
        self.ledger.get_or_init(Ledger::measure).as_ref().map_err(|&error| error.into())
    }
}
