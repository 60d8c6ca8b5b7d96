//! What is built on answers: equations with their numbers, sweeps over a number, and depths that are known to a tolerance.

pub mod explain;
pub mod sweep;
pub mod tolerance;
