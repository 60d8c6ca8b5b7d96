//! From a scene to its answer: the way there, its names, and what an answer is.

pub mod route;
pub(crate) mod solve;
pub mod state;
