//! A simple beam on a rigid uneven foundation: a reference implementation of M. Heinisuo (1984).

pub mod certificate;
pub mod methods;
pub mod problem;
pub mod route;
pub mod scene;
mod solve;
pub mod solvers;
pub mod state;
pub mod theory;

pub use solve::{DEFAULT_TOLERANCE, Settings, solve};
