//! The beam on a grid: methods make a quadratic program of a scene, and solvers solve it.

pub mod adaptive;
pub mod methods;
pub(crate) mod multigrid;
pub mod qp;
pub mod solvers;
