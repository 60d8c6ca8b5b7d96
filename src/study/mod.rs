//! Studies built on exact answers: equations with their numbers, sweeps over a number, and foundation depths known to a tolerance.

pub mod explain;
pub mod sweep;
pub mod tolerance;
