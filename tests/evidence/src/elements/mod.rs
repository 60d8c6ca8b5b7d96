//! The general beam by finite elements, which share nothing with the library: the scene is read from its file by code of our own, the beam is
//! cubic elements, and what presses is found by springs that are switched on and off.
//!
//! ```text
//! (K + N G + Σ k w bbᵀ) u = f + Σ k w g b       over the springs that are pressed, b: how much each freedom moves one
//! ```
//!
//! `mesh` has elements and springs, `results` what they say, `problem` the file, `wide` numbers of 32 digits, and `reference` two meshes whose
//! difference says how good they are.

mod mesh;
mod problem;
mod reference;
mod results;
mod wide;

pub(crate) use mesh::{carried, shapes};
pub use reference::{Found, Numbers, Reference, Shares, reference};
