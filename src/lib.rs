//! A simple beam on a rigid uneven foundation: a reference implementation of M. Heinisuo (1984).

pub mod route;
pub mod scene;
mod solve;
pub mod state;
pub mod verification;

pub use solve::{Settings, solve};
