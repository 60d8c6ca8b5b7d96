//! Rulers: how two printed results are compared, and what order of convergence a series of errors shows.
//!
//! Library code, because the acceptance tests, the snapshots and the report measure with the same ones.

mod numdiff;
mod numeral;
mod order;

pub use numdiff::{Difference, Mismatch, numdiff, numdiff_svg};
pub use order::observed_order;
