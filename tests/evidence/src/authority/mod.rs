//! The authority on discrete problems: the three-moment equations in fractions or in integers of hundreds of bits. And on bounds for the continuous beam: the
//! checker of proofs, `report/check.rs`.
//!
//! It shares no line with the library. Of the library it knows the data types of a scene alone; loads, depths, moments and
//! deflections are its own, and what it finds is checked against the definition of the discrete problem and against (34),
//! (35), node by node. The acceptance suite and the measurements of the report compare floating-point answers with it.

#[path = "../../../../report/check.rs"]
#[expect(dead_code, reason = "the program is for readers of proofs")]
pub mod check;
pub mod clapeyron;
pub mod forward;
pub mod given;
pub mod layer;
pub mod number;
pub mod statics;

pub use dashu_ratio::RBig;

/// Random scenes that the acceptance suite asks fractions about.
pub const RANDOM: usize = 1000;
