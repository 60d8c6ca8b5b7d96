//! Numbers and positions as messages print them.

use super::grid::MOST_FITTING;
use super::quantity::Quantity;
use crate::text::Results;

/// A number as messages print it: as written in the file, or with six digits if it was computed.
pub(crate) fn as_written(value: f64) -> String {
    /// Input rarely has more digits, whereas most computed sums and products do.
    const WRITTEN: usize = 12;
    let text = in_full(value);
    let digits = text.split('e').next().unwrap_or_default().chars().filter(char::is_ascii_digit).count();
    if digits <= WRITTEN || !value.is_finite() { text } else { Results::default().number(value) }
}

/// A number that is compared with another one: with all digits if six would make them look equal.
pub(super) fn against(value: f64, other: f64) -> String {
    let text = as_written(value);
    if text == as_written(other) { in_full(value) } else { text }
}

/// A number with all digits, and with a power of ten where many zeros would have to be counted.
pub(super) fn in_full(value: f64) -> String {
    // Turns −0 into 0.
    let value = value + 0.0;
    let size = value.abs();
    if size == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&size) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// The objects that can carry a beam without bilateral supports, with their outermost positions.
pub(super) fn carriers(grounded: bool, ends: [f64; 2]) -> String {
    let [from, to] = ends.map(as_written);
    match (grounded, from == to) {
        (true, _) => format!("the ground ({from} … {to})"),
        (false, true) => format!("the only support that pushes ({from})"),
        (false, false) => format!("the supports that push ({from} … {to})"),
    }
}

/// The point about which the beam rotates if the resultant of its loads is at a position outside `ends`: the end of the
/// foundation, or the outermost support.
pub(super) fn fulcrum(grounded: bool, ends: [f64; 2], at: f64) -> String {
    let (side, end) = if at < ends[0] { ("left", ends[0]) } else { ("right", ends[1]) };
    if grounded { format!("the {side} end of the ground") } else { format!("its support at x = {}", as_written(end)) }
}

/// A number with four significant digits.
pub(super) fn rounded(value: f64) -> String {
    as_written(format!("{value:.3e}").parse().unwrap_or(value))
}

/// A position outside a range with four significant digits, or with all digits if rounding would move it into the range.
pub(super) fn beside(at: f64, [from, to]: [f64; 2]) -> String {
    let rounded: f64 = format!("{at:.3e}").parse().unwrap_or(at);
    if (from..=to).contains(&rounded) { in_full(at) } else { as_written(rounded) }
}

/// The name of an object that needs a node of the grid at its position.
pub(super) fn placed(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::JointAt(_) => "the joint",
        Quantity::StepAt(_) => "the change of the bending stiffness",
        _ => "the support",
    }
}

/// The advice for a position between nodes.
pub(super) fn fitting(fits: Option<usize>) -> String {
    const PLACES: &str = "a node at every support, joint and change of the bending stiffness";
    match fits {
        Some(least) => format!("the least number of intervals with {PLACES} is {least} (--intervals {least})"),
        None => format!("no number of intervals up to {MOST_FITTING} has {PLACES}"),
    }
}
