//! From a scene to its answer: the solution procedure, the names of methods and solvers, and the contents of an answer.

pub mod route;
pub(crate) mod solve;
pub mod state;
