//! Beam theory with free lift-off points: the exact solution of (4), (5), (8), the paper's "vertailuratkaisu".
//!
//! **Invariant:** nothing here knows a grid, a method of discretisation or a solver of the programme (32).

mod flat;

pub use flat::{FlatSolution, flat};
