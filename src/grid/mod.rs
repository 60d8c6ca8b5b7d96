//! The beam on a grid: methods turn a scene into a quadratic program, and solvers solve it.

pub mod adaptive;
pub mod methods;
pub(crate) mod multigrid;
pub mod qp;
pub mod solvers;
