//! Remedies for values that a scene cannot have: a mistyped number, a sign, an order of rows, missing data.

use super::{Found, mistyped};
use crate::scene::{SceneError, Unheld};

/// The remedy for a value of a wrong type that is probably a mistyped number, from the words for what was found and what is required.
pub(super) fn of_type(found: &str, expected: &str) -> Option<String> {
    if let Some(text) = found.strip_prefix("the text \"").and_then(|text| text.strip_suffix('"'))
        && expected.starts_with("a number")
    {
        return mistyped::in_text(text);
    }
    // A decimal comma separates two numbers.
    let is_long = ["an array of length 3", "an array of length 4"].contains(&found);
    (is_long && expected.contains('['))
        .then(|| "write numbers with a decimal point: a comma separates two numbers".to_owned())
}

/// The remedy for a number that a scene cannot have. `surveyed` is true for a number of a survey.
pub(super) fn of_number(error: &SceneError, surveyed: bool) -> Option<&'static str> {
    match error {
        SceneError::AboveSupport { depth, level, .. } if *depth < 0.0 && 0.0 <= *level => {
            Some("depths are positive downwards: a foundation below the line of the supports has positive depths")
        }
        SceneError::Unheld(Unheld::PulledUp { .. }) => Some("loads are positive downwards"),
        SceneError::PointsRunBack { .. } if surveyed => Some(
            "sort the rows by x, unless the columns are swapped; with declared columns, \
             `survey = { file = …, x = \"x\", depth = \"depth\" }`, the rows may also descend",
        ),
        SceneError::ThreePointsAtOnePlace { .. } if surveyed => Some("keep one of the rows, or two of them for a step"),
        SceneError::OutsideBeam { .. } if surveyed => Some(
            "if x has the unit of the beam, declare where the beam begins, and rows beyond it are left out: \
             `survey = { file = …, x = \"x\", depth = \"depth\", origin = 0 }`",
        ),
        SceneError::PointsDoNotCover { .. } if surveyed => {
            Some("add a row at each end of the beam that the survey does not reach")
        }
        _ => None,
    }
}

/// The remedy for a field of a table that is not a number. `may_lack` is true where data may be missing.
pub(super) fn of_field(found: &Found, may_lack: bool) -> Option<String> {
    /// Bytes of the longest text that marks missing data.
    const LONGEST: usize = 12;
    let Found::Text(text) = found else { return None };
    // A number that is infinite is written well.
    if text.trim().parse::<f64>().is_ok_and(|value| !value.is_nan()) {
        return None;
    }
    if text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+'))
        && text.contains(|c: char| c.is_ascii_digit())
    {
        return Some("write the number alone, with a decimal point".to_owned());
    }
    (may_lack && text.len() <= LONGEST).then(|| {
        format!(
            "if it marks missing data, declare it, and such rows are left out: \
             `survey = {{ file = …, x = \"x\", depth = \"depth\", no_data = {text:?} }}`"
        )
    })
}
