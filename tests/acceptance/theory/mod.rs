//! Beam theory with free lift-off points: closed forms first, then its own conditions on scenes without one.

mod balance;
mod beside;
mod borders;
mod clearance;
mod closed;
mod crests;
mod explain;
mod held;
mod level;
mod long;
mod near;
mod random;
mod springs;
mod stiff;
mod supports;
mod surveys;

/// What an answer may be off by the definition: ten times what the check of beam theory allows.
const OFF: f64 = 1e-11;
