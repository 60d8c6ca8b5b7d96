//! Beam theory with free lift-off points: closed forms first, then its own conditions on scenes without one.

mod closed;
mod random;
mod statics;
