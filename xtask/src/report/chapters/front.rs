//! The first screen: what the report is.

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

/// Nothing of its own: it quotes the other chapters.
pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    Ok(Evidence::new(()))
}
