//! Figures as SVG: pure functions from data to text, the same to the byte for the same data, without I/O.
//!
//! [`Figure`], [`Panel`], [`Axis`] and [`Layer`] are the grammar; [`solution`] draws a beam in its final position, `paper`
//! the figures of the paper, [`study`] convergence and regimes, [`table`] verdicts and bars. Deflections and bending
//! moments grow downwards; a concentrated force is an arrow with its value, on a scale of forces of its own.

mod axis;
mod canvas;
mod curves;
mod draw;
mod error;
mod exact;
mod figure;
mod label;
mod layer;
mod load;
mod number;
mod palette;
mod panel;
pub mod paper;
mod solution;
pub mod study;
mod svg;
pub mod table;
mod ticks;
mod trace;

pub use axis::{Axis, Direction, Scale};
pub use curves::{Curves, PointForce};
pub use error::PlotError;
pub use figure::Figure;
pub use layer::{Arrow, Arrows, Layer, LoadSketch, Place, Reference};
pub use number::significant;
pub use palette::{Color, Dash, Marker, Style};
pub use panel::Panel;
pub use solution::{curves, sheet, solution};

#[cfg(test)]
mod tests;
