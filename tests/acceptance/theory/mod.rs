//! Beam theory with free lift-off points: closed forms first, then its own conditions on scenes without one.

mod borders;
mod closed;
mod level;
mod long;
mod near;
mod statics;
mod surveys;
