//! Figures as SVG: pure functions from data to text, the same to the byte for the same data, without I/O.
//!
//! [`Figure`], [`Panel`], [`Axis`] and [`Layer`] are the grammar; [`solution`] draws a beam in its final position, `paper`
//! the figures of the paper, [`study`] convergence and regimes, [`table`] verdicts and bars. Deflections and bending
//! moments grow downwards; a concentrated force is an arrow with its value, on a scale of forces of its own.
//!
//! ```
//! use palkki::plot::{self, Axis, Curves, Figure, Layer, Panel, Style};
//! use palkki::scene::{Beam, Foundation, Load, Scene};
//! use palkki::theory;
//!
//! let beam = Beam::new(10.0, 500.0 / 384.0)?;
//! let scene = Scene::new(beam, Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
//! let exact = theory::solve(&scene)?;
//! let svg = plot::curves(&scene, &Curves::exact(&scene, &exact), "beam theory")?;
//! assert!(svg.starts_with("<svg"));
//!
//! // A figure of one's own: the slope along the beam.
//! let points = (0..=100).map(|i| f64::from(i) / 10.0).map(|x| [x, exact.slope(x)]).collect();
//! let slope = Layer::Series { points, style: Style::of_series(0), label: "slope".to_owned() };
//! let panel = Panel::new(Axis::new("x"), Axis::new("v'").down()).with(slope);
//! assert!(Figure::new("Slope", "The slope of the beam along it.", vec![panel]).svg()?.contains("slope"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod canvas;
mod curves;
mod draw;
mod figure;
mod label;
mod layer;
mod palette;
mod panel;
pub mod paper;
mod sketch;
mod solution;
pub mod study;
pub mod table;

pub use crate::text::significant;
pub use axis::{Axis, Direction, Scale};
pub use curves::{Curves, PointForce};
pub use figure::Figure;
pub use layer::{Arrow, Arrows, Layer, LoadSketch, Place, Reference};
pub use palette::{Color, Dash, Marker, Style};
pub use panel::Panel;
pub use solution::{curves, sheet, solution};

/// Why a figure was not drawn.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// A number that has no place on paper.
    #[error("{what} must be finite, but is {value}")]
    NotFinite {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number that has no place on a logarithmic axis.
    #[error("{what} must be positive on a logarithmic axis, but is {value}")]
    NotPositive {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Nothing to draw.
    #[error("{what} must hold at least one value, but is empty")]
    Empty {
        /// What is empty.
        what: &'static str,
    },
    /// Two lists that belong together and differ in length.
    #[error("{what} must have {expected} values, one for each place, but has {count}")]
    LengthMismatch {
        /// Which list.
        what: &'static str,
        /// How many values it has.
        count: usize,
        /// How many it needs.
        expected: usize,
    },
    /// A state without values at nodes: its curves have to be sampled by whoever knows them.
    #[error("a state without nodes has no curves of its own; sample them into `Curves`")]
    NoNodes,
    /// The drawing library failed; drawing to a string, nothing should.
    #[error("the figure could not be drawn: {0}")]
    Backend(String),
}

/// `value` if it is finite.
fn finite(what: &'static str, value: f64) -> Result<f64, PlotError> {
    if value.is_finite() { Ok(value) } else { Err(PlotError::NotFinite { what, value }) }
}

/// Nothing, if `values` has as many values as there are places.
fn same_length(what: &'static str, values: &[f64], places: &[f64]) -> Result<(), PlotError> {
    if values.len() == places.len() {
        Ok(())
    } else {
        Err(PlotError::LengthMismatch { what, count: values.len(), expected: places.len() })
    }
}

/// A number of lines or columns to calculate with.
fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// Digits of a value that is written beside the point that it belongs to.
const DIGITS: usize = 4;

#[cfg(test)]
mod tests;
