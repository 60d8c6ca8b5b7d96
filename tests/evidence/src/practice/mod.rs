//! Beams that engineers have, in newtons and metres.

mod beds;
mod families;

pub use families::Family;
