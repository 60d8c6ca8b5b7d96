//! Shared utilities: numbers as text, arithmetic with 32 digits, and a check for available memory.

pub(crate) mod double;
pub(crate) mod memory;
pub mod text;
