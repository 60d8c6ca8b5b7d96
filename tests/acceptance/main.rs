//! The acceptance suite: one test binary, one file per kind of evidence.

mod support;

mod invariants;
mod words;
