//! Figures of studies: how errors fall with the grid, how the end reaction depends on the depth of the ground, how the first
//! nodal force jumps from grid to grid, and what a digit costs.

use super::axis::Axis;
use super::figure::Figure;
use super::layer::{Layer, Place, Reference};
use super::palette::{Color, Dash, Marker, Style};
use super::panel::Panel;
use super::{PlotError, finite};

/// Points with a name, written at the last of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Named<'a> {
    /// The name.
    pub label: &'a str,
    /// The points in their order.
    pub points: Vec<Place>,
}

/// Errors over the number of intervals, both axes logarithmic, with grey lines of order 1 and 2 to compare with.
///
/// An error of exactly zero has no place on the axis: it is left out, and the description says so.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, a number of intervals that is not positive, or no error at all.
pub fn convergence(title: &str, description: &str, series: &[Named<'_>]) -> Result<String, PlotError> {
    let mut panel = Panel::new(Axis::new("intervals N").log(), Axis::new("relative error").log()).tall(1000.0);
    let (mut zeros, mut all) = (0, Vec::new());
    for (i, series) in series.iter().enumerate() {
        let points: Vec<Place> = series.points.iter().copied().filter(|p| p[1] != 0.0).collect();
        zeros += series.points.len() - points.len();
        all.extend_from_slice(&points);
        if !points.is_empty() {
            panel = panel.with(Layer::named(points, Style::of_series(i), series.label));
        }
    }
    for order in [1_i32, 2] {
        if let Some(points) = slope(&all, f64::from(order)) {
            let style = Style { width: 4, ..Style::solid(Color::GRAY) };
            panel.layers.insert(0, Layer::named(points, style, format!("order {order}")));
        }
    }
    let mut description = format!("{description} Grey lines fall with order 1 and order 2.");
    if 0 < zeros {
        description.push_str(&format!(" Errors of exactly zero, not shown: {zeros}."));
    }
    Figure::new(title, description, vec![panel]).svg()
}

/// A line `error ~ N⁻ᵖ` from above the first errors, over the range of the points; none if they have no range.
fn slope(points: &[Place], order: f64) -> Option<Vec<Place>> {
    /// How far above the largest error on the coarsest grid, as a factor.
    const ABOVE: f64 = 1.6;
    let range = |k: usize| points.iter().fold([f64::INFINITY, 0.0], |r: [f64; 2], p| [r[0].min(p[k]), r[1].max(p[k])]);
    let ([from, to], [least, most]) = (range(0), range(1));
    if !(0.0 < from && from < to && to < f64::INFINITY && 0.0 < least && most < f64::INFINITY) {
        return None;
    }
    let start = ABOVE * most;
    // Not below the least error.
    let end = to.min(from * libm::pow(start / least, 1.0 / order));
    Some(vec![[from, start], [end, start * libm::pow(from / end, order)]])
}

/// Border between contact zone and contact at mid-span, in `EI u₀ / (q₀ l⁴)`.
const ZONE_ENDS: f64 = 1.0 / 384.0;
/// Border between contact at mid-span and no contact: the mid-span deflection of the free beam.
const CONTACT_ENDS: f64 = 5.0 / 384.0;

/// End reaction over `EI u₀ / (q₀ l⁴)` with the three regimes of a flat foundation and their borders 1/384 and 5/384.
///
/// `theory` and `computed` are lists of `[EI u₀ / (q₀ l⁴), reaction / (q₀ l)]`, `example` is such a point with its name.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite.
pub fn regimes(
    title: &str,
    description: &str,
    theory: &[Place],
    computed: &Named<'_>,
    (example, name): (Place, &str),
) -> Result<String, PlotError> {
    // In units of 1/384 the borders are 1 and 5.
    let scaled = |points: &[Place]| -> Vec<Place> { points.iter().map(|p| [p[0] / ZONE_ENDS, p[1]]).collect() };
    let theory = scaled(theory);
    let reach = theory.iter().fold(1.2 * CONTACT_ENDS / ZONE_ENDS, |most, p| most.max(p[0]));
    let x = Axis {
        padding: 0.0,
        ..Axis::new("384 EI u₀ / (q₀ l⁴): a stiffer beam or deeper ground to the right").including(&[0.0, reach])
    };
    let y = Axis { padding: 0.06, ..Axis::new("end reaction / (q₀ l)").including(&[0.0, 0.5]) };
    let mut panel = Panel::new(x, y).tall(820.0).room(110.0, 0.0);
    let borders = [0.0, 1.0, CONTACT_ENDS / ZONE_ENDS, reach];
    for at in &borders[1..3] {
        panel = panel.with(Layer::Reference { at: Reference::X(*at), text: String::new() });
    }
    for (pair, text) in borders.windows(2).zip(["contact zone", "contact at mid-span only", "no contact"]) {
        panel = panel.with(Layer::Note { at: [0.5 * (pair[0] + pair[1]), 0.55], text: text.to_owned(), dot: false });
    }
    let marks = Style::marks(Color::BLUE, Marker::OpenCircle);
    panel = panel.with(Layer::line(theory, Style::theory())).with(Layer::named(
        scaled(&computed.points),
        marks,
        computed.label,
    ));
    panel = panel.with(Layer::named(scaled(&[example]), Style::marks(Color::VERMILLION, Marker::Star), name));
    Figure::new(title, description, vec![panel]).svg()
}

/// What a digit costs on one kind of ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Price<'a> {
    /// The kind of ground.
    pub ground: &'a str,
    /// `[digits, milliseconds]` of each solver. A solver has the same place in the lists of all panels, and no points where
    /// it has nothing to show.
    pub lines: Vec<Named<'a>>,
    /// `[digits, milliseconds]` of beam theory.
    pub exact: Place,
}

/// Time over correct digits, one panel for each kind of ground, side by side and on the same axes.
///
/// `digits` says what has so many correct digits.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, a time that is not positive, or no panel.
pub fn price(title: &str, description: &str, digits: &str, grounds: &[Price<'_>]) -> Result<String, PlotError> {
    let all = || grounds.iter().flat_map(|g| g.lines.iter().flat_map(|s| &s.points).chain([&g.exact]));
    let [digits_range, times]: [Vec<f64>; 2] = [0, 1].map(|k| all().map(|p| p[k]).collect());
    let panels = grounds.iter().map(|ground| {
        let x = Axis::new(digits).including(&digits_range).including(&[0.0]);
        let y = Axis::new(format!("{}: time", ground.ground)).unit(Some("ms".to_owned()));
        let mut panel = Panel::new(x, y.log().including(&times)).tall(1000.0).room(40.0, 70.0);
        for (i, solver) in ground.lines.iter().enumerate().filter(|(_, solver)| !solver.points.is_empty()) {
            let style = Style { dash: Some(Dash::Solid), ..Style::of_series(i) };
            panel = panel.with(Layer::named(solver.points.clone(), style, solver.label));
        }
        let star = Style::marks(Color::BLACK, Marker::Star);
        panel.with(Layer::named(vec![ground.exact], star, "exact"))
    });
    let figure = Figure::new(title, description, panels.collect());
    Figure { columns: 2, ..figure }.svg()
}

/// The first nodal contact force of each grid beside the resultant at the lift-off point, both over the point force of beam
/// theory: lists of `[intervals, force / T]`.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, and for empty lists.
pub fn first_force(
    title: &str,
    description: &str,
    first: &Named<'_>,
    resultant: &Named<'_>,
) -> Result<String, PlotError> {
    let (Some(from), Some(to)) = (first.points.first(), first.points.last()) else {
        return Err(PlotError::Empty { what: "a list of grids" });
    };
    let theory = vec![[finite("a number of intervals", from[0])?, 1.0], [to[0], 1.0]];
    let y = Axis::new("force / T, where T is the point force of beam theory at lift-off").including(&[0.0]);
    let x = Axis { padding: 0.02, ..Axis::new("intervals N").including(&[0.0]) };
    // The name of the scattered circles stands beside the frame, off them.
    let name = Layer::named(vec![[to[0], 0.5]], Style::solid(Color::VERMILLION), first.label);
    let circles = Style::marks(Color::VERMILLION, Marker::OpenCircle);
    let panel = Panel::new(x, y)
        .tall(900.0)
        .with(Layer::line(first.points.clone(), circles))
        .with(name)
        .with(Layer::named(resultant.points.clone(), Style::solid(Color::BLUE), resultant.label))
        .with(Layer::line(theory, Style::theory()));
    Figure::new(title, description, vec![panel]).svg()
}

#[cfg(test)]
mod tests {
    use super::{Named, PlotError, Price, convergence, price, regimes};

    fn named<'a>(label: &'a str, points: &[[f64; 2]]) -> Named<'a> {
        Named { label, points: points.to_vec() }
    }

    #[test]
    fn orders_are_drawn_to_compare_with_and_zeros_are_counted() {
        let points = [[10.0, 1e-2], [20.0, 2.5e-3], [40.0, 0.0], [80.0, 1.5e-4]];
        let svg = convergence("Errors", "Errors fall.", &[named("end reaction", &points)]).expect("a figure");
        for text in [">end reaction<", ">order 1<", ">order 2<", "Errors of exactly zero, not shown: 1."] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }

    #[test]
    fn errors_that_are_all_zero_are_refused() {
        let figure = |points: &[[f64; 2]]| convergence("", "", &[named("", points)]);
        assert!(matches!(figure(&[[1.0, 0.0]]), Err(PlotError::Empty { .. })), "nothing left");
        assert!(figure(&[[1.0, 1.0]]).is_ok(), "one grid has no slope");
    }

    #[test]
    fn the_regimes_and_the_example_are_named() {
        let computed = named("computed", &[[0.01, 0.2]]);
        let theory = [[0.0, 0.0], [0.02, 0.5]];
        let svg = regimes("Regimes", "Three.", &theory, &computed, ([0.001, 0.1], "the example")).expect("a figure");
        for text in ["contact zone", "contact at mid-span only", "no contact", ">the example<", ">computed<"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }

    /// The chart of what a digit costs: panels side by side, a logarithmic axis of times, names at the ends of lines, a star.
    #[test]
    fn a_price_has_a_panel_for_each_ground() {
        let flat = Price {
            ground: "flat ground",
            lines: vec![
                named("active set", &[[1.7, 0.005], [11.0, 140.0]]),
                named("clarabel", &[[1.7, 0.05], [8.4, 640.0]]),
            ],
            exact: [14.0, 0.017],
        };
        let uneven = Price {
            ground: "uneven ground",
            lines: vec![named("active set", &[[1.3, 0.004], [6.1, 80.0]]), named("clarabel", &[])],
            exact: [14.0, 0.11],
        };
        let svg = price("One more digit", "Two panels.", "correct digits", &[flat, uneven]).expect("a figure");
        for text in ["flat ground: time [ms]", "uneven ground: time [ms]"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
        assert_eq!(svg.matches(">exact<").count(), 2, "a star in each panel");
        assert_eq!(svg.matches(">clarabel<").count(), 1, "no line without points");
    }
}
