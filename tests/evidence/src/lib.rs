//! The evidence for `palkki`: what its tests, its report and its measurements share, and the library does without.
//!
//! [`paper`] has the example, the figures and the claims of the paper. [`faults`] puts faults into answers and compares what is
//! certified with the truth. [`extremes`] has scenes whose answer is known without a solver. [`closed`] has closed forms, [`authority`] solves discrete
//! problems exactly, and [`definition`] asks an answer for all that the problem is defined by, and [`differences`] whether its derivatives are those of
//! the answers beside it. [`draft`] is a scene as numbers,
//! [`compare`] the difference of two lists, [`brackets`] asks whether numbers lie between what is proven of them, [`observables`] what of an answer is compared, [`random`] has numbers and scenes from a fixed seed, and [`hostile`] runs of the whole
//! program on random and adversarial ones. [`practice`] has beams of engineers, and their answers by finite elements. [`sweeps`] compares the events of random
//! sweeps. [`bodies`] and [`slab`] have elastic bodies that are no beam. [`soil`] has a pipe on surveyed soil, and elements for it. [`exchanges`] and [`libraries`] have what is hard for a solver, [`texts`] says what
//! holds for any text that is read, and [`numdiff`] compares texts as printed numbers.

#![cfg(feature = "full")]

pub mod authority;
pub mod bodies;
pub mod brackets;
pub mod closed;
pub mod compare;
pub mod definition;
pub mod differences;
pub mod draft;
pub mod elements;
pub mod exchanges;
pub mod extremes;
pub mod faults;
pub mod few;
pub mod hostile;
pub mod libraries;
pub mod numdiff;
pub mod observables;
pub mod paper;
pub mod practice;
pub mod random;
pub mod slab;
pub mod soil;
pub mod sweeps;
pub mod texts;
