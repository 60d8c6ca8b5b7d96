//! The acceptance suite: one test binary, one file per kind of evidence.

mod support;

mod bad_input;
mod command_line;
mod invariants;
mod scene_file;
mod words;
