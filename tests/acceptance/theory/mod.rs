//! Beam theory with free lift-off points: closed forms first, then its own conditions on scenes without one.

mod balance;
mod borders;
mod closed;
mod held;
mod level;
mod long;
mod near;
mod statics;
mod supports;
mod surveys;
