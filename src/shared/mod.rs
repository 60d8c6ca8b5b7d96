//! What several rooms use and none owns: numbers as text, numbers of 32 digits, and a check for memory.

pub(crate) mod double;
pub(crate) mod memory;
pub mod text;
