//! Bars with their values.

use super::super::axis::{Axis, Direction, Scale};
use super::super::canvas::{Align, Type, text_width};
use super::super::error::{PlotError, finite};
use super::super::figure::{MARGIN, whole};
use super::super::number::{DIGITS, significant};
use super::super::palette::{Color, Dash};
use super::super::svg::{WIDTH, document};
use super::{Heading, LINE, count, name_width};

/// Horizontal bars from zero (or from the left end of a logarithmic axis), each with its name and its value.
///
/// A histogram is this with the bins as names and the counts as values.
///
/// # Errors
///
/// A [`PlotError`] if there is no bar, for a value that is not finite, or not positive on a logarithmic axis.
pub fn bars(title: &str, description: &str, axis: &Axis, items: &[(&str, f64)]) -> Result<String, PlotError> {
    const BAR: f64 = 62.0;
    let sheet = f64::from(WIDTH);
    let left = MARGIN + name_width(items.iter().map(|item| item.0));
    let mut texts = Vec::new();
    for &(_, value) in items {
        texts.push(significant(finite("the value of a bar", value)?, DIGITS));
    }
    // The values stand beyond the ends of the bars.
    let beside = texts.iter().fold(0.0_f64, |most, text| most.max(text_width(text, Type::PLAIN))) + 40.0;
    let zero = if axis.scale == Scale::Linear { &[0.0][..] } else { &[] };
    let axis = axis.clone().including(zero);
    let axis = Axis { padding: 0.0, direction: Direction::Up, ..axis };
    let right = sheet - MARGIN - beside;
    let negative = items.iter().any(|item| item.1 < 0.0);
    let start = if negative { left + beside } else { left };
    let resolved = axis.resolve(items.iter().map(|item| item.1), [start, right], (right - start) / 240.0)?;
    let origin = if axis.scale == Scale::Linear { resolved.place(0.0) } else { start };
    let top = Heading::of(title).height;
    let bottom = top + BAR * count(items.len()) + 16.0;
    document(title, description, whole(bottom + 2.6 * LINE + MARGIN), |canvas| {
        Heading::of(title).draw(canvas)?;
        for tick in &resolved.ticks {
            let x = resolved.place(tick.value);
            canvas.line(&[[x, top], [x, bottom + 10.0]], Color::GRID, 2, Dash::Solid)?;
            canvas.text(&tick.label, [x, bottom + 0.8 * LINE], Align::Center, Type::PLAIN)?;
        }
        let label = axis.heading(resolved.factor);
        canvas.text(&label, [0.5 * (start + right), bottom + 2.0 * LINE], Align::Center, Type::PLAIN)?;
        for (i, (&(name, value), text)) in items.iter().zip(&texts).enumerate() {
            let y = top + BAR * (count(i) + 0.5);
            let end = resolved.place(value);
            canvas.text(name, [left - 24.0, y], Align::Right, Type::PLAIN)?;
            canvas.rectangle([origin, y - 0.34 * BAR], [end, y + 0.34 * BAR], Color::BLUE, 0.8)?;
            let (at, align) = if value < 0.0 { (end - 16.0, Align::Right) } else { (end + 16.0, Align::Left) };
            canvas.text(text, [at, y], align, Type::PLAIN)?;
        }
        canvas.line(&[[origin, top], [origin, bottom]], Color::GRAY, 3, Dash::Solid)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_carry_their_values() {
        let svg = bars("Counts", "All.", &Axis::new("scenes"), &[("a", 12.0), ("b", -3.5), ("c", 0.0)]).expect("bars");
        for text in ["\n12\n", "\n−3.5\n", "\n0\n", "scenes"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
        let axis = Axis::new("sweeps").log();
        assert!(bars("", "", &axis, &[("a", 1e4), ("b", 3.0)]).is_ok(), "logarithmic");
        assert!(matches!(bars("", "", &axis, &[("a", 0.0)]), Err(PlotError::NotPositive { .. })), "zero on it");
        assert!(matches!(bars("", "", &axis, &[("a", f64::NAN)]), Err(PlotError::NotFinite { .. })), "NaN");
        assert!(matches!(bars("", "", &axis, &[]), Err(PlotError::Empty { .. })), "no bar");
    }
}
