//! The evidence for `palkki`: what its tests, its report and its measurements share, and the library does without.
//!
//! [`paper`] has the example, the figures and the claims of the paper; [`faults`] puts faults into answers and compares
//! what is certified with beam theory; [`extremes`] has scenes whose answer is known without a solver; [`authority`] solves
//! discrete problems exactly. [`numdiff`] compares texts as printed numbers, [`random`] has numbers from a fixed seed.

pub mod authority;
pub mod extremes;
pub mod faults;
pub mod numdiff;
pub mod paper;
pub mod random;
