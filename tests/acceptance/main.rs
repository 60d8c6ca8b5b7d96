//! The acceptance suite: one binary, one file for each thing that is asked of the program.

mod bad_input;
mod scene_file;
