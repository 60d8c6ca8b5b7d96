//! What can be wrong with the data of a figure.

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::drawing::DrawingAreaErrorKind;

/// What goes wrong in plotters' SVG backend; drawing to a string, nothing should.
type BackendError = DrawingAreaErrorKind<<SVGBackend<'static> as DrawingBackend>::ErrorType>;

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
    /// The drawing library failed.
    #[error("the figure could not be drawn: {0}")]
    Backend(#[from] BackendError),
}

/// `value` if it is finite.
pub(super) fn finite(what: &'static str, value: f64) -> Result<f64, PlotError> {
    if value.is_finite() { Ok(value) } else { Err(PlotError::NotFinite { what, value }) }
}

/// Nothing, if `values` has as many values as there are places.
pub(super) fn same_length(what: &'static str, values: &[f64], places: &[f64]) -> Result<(), PlotError> {
    if values.len() == places.len() {
        Ok(())
    } else {
        Err(PlotError::LengthMismatch { what, count: values.len(), expected: places.len() })
    }
}
