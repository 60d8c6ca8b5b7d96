//! Rulers and dice: how two printed results are compared, what order of convergence a series of errors shows, and random
//! numbers for what one example cannot decide.
//!
//! Library code, because the acceptance tests, the snapshots and the report use the same ones.

mod numdiff;
mod numeral;
mod order;
mod random;
mod token;

pub use numdiff::{Difference, Mismatch, numdiff, numdiff_svg};
pub use order::observed_order;
pub use random::Random;
