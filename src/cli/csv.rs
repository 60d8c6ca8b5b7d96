//! `--csv`: the values along the beam.

use std::fmt::Write as _;

use super::answer::Answer;
use super::failure::Failure;

/// Names of the columns: place, deflection (positive downwards), clearance to the foundation, contact force (a force at
/// the node, not a density) and bending moment (positive with the underside in tension).
const HEADER: &str = "x,deflection,clearance,contact_force,moment";

/// One row for each interior node. Numbers read back as the same `f64`; the clearance to no foundation is left empty.
pub(super) fn table(answer: &Answer) -> Result<String, Failure> {
    let nodes = answer.nodes().ok_or(Failure::NoTable)?;
    let mut text = format!("{HEADER}\n");
    for (i, x) in nodes.x.iter().enumerate() {
        text.push_str(&field(*x));
        for column in [&nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment] {
            // Writing to a string does not fail.
            let _ = write!(text, ",{}", column.get(i).map_or_else(String::new, |value| field(*value)));
        }
        text.push('\n');
    }
    Ok(text)
}

/// The shortest text that reads back as the same number; nothing for one that is not finite.
fn field(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { String::new() }
}
