//! A simple beam on a rigid uneven foundation: a reference implementation of M. Heinisuo (1984).

pub mod route;
pub mod scene;
pub mod state;
