//! Benchmarks of every route, to be written.
fn main() {}
