//! Stability: rounding and conditioning, the extremes of sizes and units, and hostile input.

pub(super) mod conditioning;
pub(super) mod extremes;
pub(super) mod hostile;
