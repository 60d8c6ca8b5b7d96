//! The acceptance suite: one test binary, one file per kind of evidence.

mod support;

#[path = "../authority/mod.rs"]
mod authority;

mod agreement;
mod approach;
mod bad_input;
mod bounds;
mod claims;
mod closed_form;
mod command_line;
mod corpus;
mod costs;
mod determinism;
mod dial;
mod digits;
mod exact;
mod extremes;
mod faults;
mod hostile;
mod invariants;
mod judge;
mod libraries;
mod matrices;
mod multigrid;
mod nodal_loads;
mod order;
mod properties;
mod scene_file;
mod scenes;
mod surveys;
mod tables;
mod theory;
mod verdict;
mod windows;
mod words;
