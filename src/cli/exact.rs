//! `--method exact`: beam theory with free lift-off points.

use super::answer::Answer;
use super::input::Input;

/// Why theory has no answer.
#[derive(Debug, Clone, Copy, thiserror::Error)]
pub(super) enum NotAvailable {
    /// It is not part of the program yet.
    #[error("it is not part of the program yet")]
    NotYet,
}

/// The answer of beam theory.
pub(super) fn exact(_input: &Input) -> Result<Answer, NotAvailable> {
    // The one call site of theory.
    Err(NotAvailable::NotYet)
}
