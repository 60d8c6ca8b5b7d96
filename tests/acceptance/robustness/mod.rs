//! Bad input, hostile input, the extremes of sizes and units, and the same bits again and elsewhere.

mod bad_input;
mod determinism;
mod extremes;
mod hostile;
mod invariances;
mod mistyped;
mod work;
