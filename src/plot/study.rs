//! Figures of studies: how errors fall with the grid, and how the end reaction depends on the foundation's depth.

use super::axis::Axis;
use super::error::{PlotError, finite};
use super::figure::Figure;
use super::layer::{Layer, Place, Reference};
use super::number::fixed;
use super::palette::{Color, Dash, Marker, Style};
use super::panel::Panel;

/// Errors of one quantity on finer and finer grids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorSeries<'a> {
    /// Name in the legend.
    pub label: &'a str,
    /// `[N, error]`: intervals and the magnitude of the error, coarse grids first.
    pub points: &'a [Place],
    /// Observed order `p` of `error ~ N⁻ᵖ`, drawn as a dotted line of that slope.
    pub order: Option<f64>,
}

/// Errors over the number of intervals, both axes logarithmic; `quantity` names the error.
///
/// An error of exactly zero has no place on the axis: it is left out, and the description says so.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, a number of intervals that is not positive, or no error at all.
pub fn convergence(
    title: &str,
    description: &str,
    quantity: &str,
    series: &[ErrorSeries<'_>],
) -> Result<String, PlotError> {
    let mut panel = Panel::new(Axis::new("intervals N").log(), Axis::new(quantity).log()).tall(900.0);
    let mut zeros = 0;
    for (i, series) in series.iter().enumerate() {
        let points: Vec<Place> = series.points.iter().copied().filter(|p| p[1] != 0.0).collect();
        zeros += series.points.len() - points.len();
        let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
            continue;
        };
        let style = Style::of_series(i);
        let label = match series.order {
            Some(order) => format!("{} (order {:.2})", series.label, finite("an observed order", order)?),
            None => series.label.to_owned(),
        };
        panel = panel.with(Layer::Series { points, style, label });
        if let Some(order) = series.order {
            panel = slope(panel, first, last, order, style.color);
        }
    }
    let mut description = description.to_owned();
    if 0 < zeros {
        description.push_str(&format!(" Errors of exactly zero, not shown: {zeros}."));
    }
    Figure::new(title, description, vec![panel]).svg()
}

/// A dotted line below a series with the slope of its order, over the finer half of the grids.
fn slope(panel: Panel, first: Place, last: Place, order: f64, color: Color) -> Panel {
    /// How far below the series, as a factor.
    const BELOW: f64 = 0.45;
    let from = libm::sqrt(first[0] * last[0]);
    let to = last[0];
    let end = BELOW * last[1];
    let start = end * libm::pow(to / from, order);
    // A single grid has no slope; NaN and overflow end here too.
    if !(from < to && 0.0 < end && 0.0 < start && start < f64::INFINITY) {
        return panel;
    }
    let style = Style { color, dash: Some(Dash::Dotted), marker: None, width: 5 };
    let middle = [libm::sqrt(from * to), libm::sqrt(start) * libm::sqrt(end)];
    panel
        .with(Layer::Series { points: vec![[from, start], [to, end]], style, label: String::new() })
        .with(Layer::Note { at: middle, text: format!("slope {}", fixed(-order, 2)), dot: false })
}

/// Border between contact zone and contact at mid-span, in `EI u₀ / (q₀ l⁴)`.
const ZONE_ENDS: f64 = 1.0 / 384.0;
/// Border between contact at mid-span and no contact: the mid-span deflection of the free beam.
const CONTACT_ENDS: f64 = 5.0 / 384.0;

/// End reaction over `EI u₀ / (q₀ l⁴)` with the borders 1/384 and 5/384 of the three regimes of a flat foundation.
///
/// `theory` and `computed` are lists of `[EI u₀ / (q₀ l⁴), reaction / (q₀ l)]`; `label` names the computed points.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite.
pub fn regimes(
    title: &str,
    description: &str,
    theory: &[Place],
    computed: &[Place],
    label: &str,
) -> Result<String, PlotError> {
    let reach = theory.iter().chain(computed).fold(1.2 * CONTACT_ENDS, |most, p| most.max(p[0]));
    let x = Axis { padding: 0.0, ..Axis::new("EI u₀ / (q₀ l⁴)").including(&[0.0, reach]) };
    let y = Axis::new("end reaction / (q₀ l)").including(&[0.0]);
    let mut panel = Panel::new(x, y).tall(760.0).room(150.0, 0.0);
    for (at, text) in [(ZONE_ENDS, "1/384"), (CONTACT_ENDS, "5/384")] {
        panel = panel.with(Layer::Reference { at: Reference::X(at), text: text.to_owned() });
    }
    let top = theory.iter().chain(computed).fold(0.0_f64, |most, p| most.max(p[1]));
    for (from, to, text) in
        [(0.0, ZONE_ENDS, "zone"), (ZONE_ENDS, CONTACT_ENDS, "mid-span only"), (CONTACT_ENDS, reach, "free")]
    {
        panel = panel.with(Layer::Note { at: [0.5 * (from + to), top], text: text.to_owned(), dot: false });
    }
    panel = panel
        .with(Layer::Series { points: theory.to_vec(), style: Style::theory(), label: "beam theory".to_owned() })
        .with(Layer::Series {
            points: computed.to_vec(),
            style: Style::marks(Color::BLUE, Marker::OpenCircle),
            label: label.to_owned(),
        });
    Figure::new(title, description, vec![panel]).svg()
}

#[cfg(test)]
mod tests {
    use super::{ErrorSeries, PlotError, convergence, regimes};

    #[test]
    fn the_order_is_written_and_zeros_are_counted() {
        let points = [[10.0, 1e-2], [20.0, 2.5e-3], [40.0, 0.0], [80.0, 1.5e-4]];
        let series = ErrorSeries { label: "end reaction", points: &points, order: Some(2.0) };
        let svg = convergence("Errors", "Errors fall.", "error", &[series]).expect("a figure");
        for text in ["end reaction (order 2.00)", "slope −2.00", "Errors of exactly zero, not shown: 1.", "10⁻⁵"]
        {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }

    #[test]
    fn errors_without_a_place_are_refused() {
        let series = |points| ErrorSeries { label: "", points, order: Some(1.0) };
        let nan = convergence("", "", "error", &[series(&[[1.0, f64::NAN]])]);
        assert!(matches!(nan, Err(PlotError::NotFinite { .. })), "NaN");
        let negative = convergence("", "", "error", &[series(&[[1.0, -1.0]])]);
        assert!(matches!(negative, Err(PlotError::NotPositive { .. })), "negative");
        let none = convergence("", "", "error", &[series(&[[1.0, 0.0]])]);
        assert!(matches!(none, Err(PlotError::Empty { .. })), "nothing left");
        assert!(convergence("", "", "error", &[series(&[[1.0, 1.0]])]).is_ok(), "one grid has no slope");
    }

    #[test]
    fn the_borders_of_the_regimes_are_marked() {
        let svg = regimes("Regimes", "Three.", &[[0.0, 0.0], [0.02, 0.5]], &[], "computed").expect("a figure");
        for text in ["1/384", "5/384", "mid-span only", "free"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }
}
