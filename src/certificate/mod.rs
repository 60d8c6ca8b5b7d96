//! The judge: how far a state is from solving its discrete problem, from the scene and the state alone.
//!
//! The judge is no contestant: it uses no method and no solver. From the contact forces it computes bending moments by
//! statics and deflections by integration, and compares; from the scene it takes depths and loads anew.

pub mod bounds;
mod interval;
mod kkt;

pub use bounds::{ACCEPTED_ERROR, Certificate, ContactLoad, Judged, Lumped, certify};
pub use interval::Interval;
pub use kkt::{CERTIFIED_RESIDUAL, Kkt};
