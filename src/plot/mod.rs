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
mod error;
mod exact;
mod figure;
mod label;
mod layer;
mod load;
mod palette;
mod panel;
pub mod paper;
mod solution;
pub mod study;
mod svg;
pub mod table;
mod ticks;
mod trace;

pub use crate::text::significant;
pub use axis::{Axis, Direction, Scale};
pub use curves::{Curves, PointForce};
pub use error::PlotError;
pub use figure::Figure;
pub use layer::{Arrow, Arrows, Layer, LoadSketch, Place, Reference};
pub use palette::{Color, Dash, Marker, Style};
pub use panel::Panel;
pub use solution::{curves, sheet, solution};

/// Digits of a value that is written beside the point that it belongs to.
const DIGITS: usize = 4;

#[cfg(test)]
mod tests;
