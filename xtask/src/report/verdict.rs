//! One line of the verdict table on the first screen.

use serde::Serialize;

/// What the paper has, what came out now, and what is to be thought of it.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Row {
    /// The number, figure or claim.
    pub(super) what: String,
    /// What the paper prints or says.
    pub(super) paper: String,
    /// What was computed for this report.
    pub(super) now: String,
    /// One word.
    pub(super) verdict: &'static str,
    /// Where to read on: an anchor of the report.
    pub(super) section: &'static str,
}

/// `reproduced` if a number rounds to the two printed decimals.
pub(super) fn of_printed(value: f64, printed: f64) -> &'static str {
    /// Half a unit of the last printed digit.
    const HALF: f64 = 0.005;
    if (value - printed).abs() <= HALF { "reproduced" } else { "not reproduced" }
}

#[cfg(test)]
mod tests {
    use super::of_printed;

    #[test]
    fn a_number_is_reproduced_to_the_printed_digits() {
        assert_eq!([of_printed(1.1420, 1.14), of_printed(1.1355, 1.14)], ["reproduced", "reproduced"]);
        assert_eq!(of_printed(1.1860, 1.14), "not reproduced");
    }
}
