//! x

mod theory;
