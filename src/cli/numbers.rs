//! The numbers that options accept, and the messages that reject others.

use palkki::sweep::MOST_STEPS;
use palkki::text::MOST_DIGITS;

/// A number of something, from 2 to `most`.
fn count(of: &str, most: usize, text: &str) -> Result<usize, String> {
    let not = |what: &str| Err(format!("the number of {of} must be {what}, but is {text}"));
    match text.parse::<usize>() {
        Ok(..2) => not("at least 2"),
        Ok(number) if number <= most => Ok(number),
        Err(error) if *error.kind() != std::num::IntErrorKind::PosOverflow => not("a whole number, at least 2"),
        _ => not(&format!("at most {most}")),
    }
}

/// `--steps`.
pub(super) fn steps(text: &str) -> Result<usize, String> {
    count("steps", MOST_STEPS, text)
}

/// `--intervals`.
pub(super) fn intervals(text: &str) -> Result<usize, String> {
    count("intervals", MOST_INTERVALS, text)
}

/// `--digits`.
pub(super) fn digits(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(number @ 1..=MOST_DIGITS) => Ok(number),
        _ => Err(format!("the number of digits must be a whole number from 1 to {MOST_DIGITS}, but is {text}")),
    }
}

/// A positive, finite number; messages call it `what`.
fn positive(what: &str, text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if 0.0 < number && number < f64::INFINITY => Ok(number),
        _ => Err(format!("the {what} must be a positive, finite number, but is {text}")),
    }
}

/// `--tolerance`.
pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    positive("tolerance", text)
}

/// `--depth-tolerance`.
pub(super) fn depth_tolerance(text: &str) -> Result<f64, String> {
    positive("tolerance of the depth", text)
}

/// A finite number.
pub(super) fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("it must be a finite number, but is {text}")),
    }
}

/// More intervals than fit into the memory of any computer that this runs on.
const MOST_INTERVALS: usize = 10_000_000;
