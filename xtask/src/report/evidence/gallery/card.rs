//! A scene as a card: its story and reference on the page, its values with tolerances and their sources as data.

use palkki::theory::Exact;
use palkki::verdict::Verdict;

use super::value_of;
use crate::report::evidence::closed::{CONTACT, Closed, REACTIONS, closed};
use crate::report::evidence::prelude::*;

/// How far beam theory may be from a closed form, relative to the sizes of the scene.
const AGREES: f64 = 1e-11;

/// One row: a quantity with one or two values of a size `scale`, and half the width of what they are proven to lie in.
struct Row {
    name: String,
    unit: String,
    values: Vec<f64>,
    scale: f64,
    proven: Option<f64>,
}

/// The data of all cards of a page, without rows.
pub(in crate::report::evidence) fn values() -> Table {
    Table::new(["scene", "quantity", "unit", "values", "tolerance", "source"])
}

/// The card of a scene with the text of its file; its values become rows of `table`.
pub(super) fn card(
    name: &str,
    scene: &Scene,
    exact: &Exact,
    verdict: &Verdict,
    file: &str,
    table: &mut Table,
) -> Result<Value, Cause> {
    let reference = closed(scene);
    for row in rows(scene, exact, verdict) {
        let places = places(row.values.iter().fold(0.0, |most, v| most.max(v.abs())));
        let printed = |value: f64| if value.abs() <= 1e-9 * row.scale { "0".to_owned() } else { fixed(value, places) };
        let values: Vec<String> = row.values.iter().map(|value| printed(*value)).collect();
        let (error, source) = match (of_closed(&row, name, reference.as_ref())?, row.proven) {
            (Some(difference), _) => (difference, "closed form"),
            (None, Some(width)) if width.is_finite() => (width, "certificate"),
            _ => (0.0, "beam theory"),
        };
        // What is printed is right to its last place, unless less is known.
        let last = -i32::try_from(places)?;
        let tolerance = if error <= ten_to(last) { last } else { decade(error) + 1 };
        let unit = if row.unit.is_empty() { "–" } else { &row.unit };
        table.push(row![name, row.name, unit, values.join(" "), format!("1e{tolerance}"), source]);
    }
    Ok(context! {
        name,
        title => scene.title(),
        story => story(file),
        certified => verdict.status == Status::Certified,
        formula => reference.map(|closed| closed.formula),
    })
}

/// The comment at the head of a scene file.
fn story(file: &str) -> String {
    let head = file.lines().take_while(|line| line.starts_with('#'));
    head.map(|line| line.trim_start_matches('#').trim()).collect::<Vec<_>>().join(" ")
}

/// Digits behind the point for numbers of a size: seven significant ones, of small numbers fewer.
fn places(size: f64) -> usize {
    6 - [1e1, 1e2, 1e3, 1e4, 1e5].iter().filter(|power| **power <= size).count()
}

/// How far the values of a row are from their closed form; none if they have none, an error if they are not the same.
fn of_closed(row: &Row, scene: &str, reference: Option<&Closed>) -> Result<Option<f64>, Cause> {
    let Some(values) = reference.and_then(|closed| closed.of(&row.name)) else { return Ok(None) };
    let (difference, allowed) = (apart_if_any(&row.values, values), AGREES * row.scale);
    if allowed < difference {
        let quantity = &row.name;
        let message = format!("beam theory differs from the closed form by {difference:e} in {quantity} of {scene}");
        return Err(message.into());
    }
    Ok(Some(allowed))
}

/// What a card lists.
fn rows(scene: &Scene, exact: &Exact, verdict: &Verdict) -> Vec<Row> {
    let state = &exact.state;
    let length = scene.beam().length();
    let label = |unit: &Option<String>| unit.clone().unwrap_or_default();
    let [of_length, of_force] = [&scene.units().length, &scene.units().force].map(label);
    let of_moment = if of_force.is_empty() { String::new() } else { format!("{of_force}·{of_length}") };
    let force = load(scene);
    let moment = state.moment.magnitude();
    let deflection = state.deflection.magnitude();
    let certificate = verdict.certificate.as_ref();
    let mut rows = Vec::new();
    let mut row = |name: String, unit: &str, values: &[f64], scale: f64, proven: Option<f64>| {
        rows.push(Row { name, unit: unit.to_owned(), values: values.to_vec(), scale, proven });
    };
    let widths = certificate.and_then(|c| match c.reactions[..] {
        [Some(left), Some(right)] => Some([left, right]),
        _ => None,
    });
    let width = widths.map(|reactions| reactions.iter().map(|[lo, hi]| hi - lo).fold(0.0, f64::max));
    if scene.beam().is_simple() {
        row(REACTIONS.to_owned(), &of_force, &[state.reactions.left, state.reactions.right], force, width);
    } else {
        for (i, support) in state.supports.iter().enumerate() {
            let proven = certificate.and_then(|c| c.reactions.get(i).copied().flatten()).map(|[lo, hi]| hi - lo);
            row(format!("force of the support at x = {}", support.at), &of_force, &[support.force], force, proven);
            if let Some(value) = support.moment {
                row(format!("moment at the support at x = {}", support.at), &of_moment, &[value], moment, None);
            }
        }
    }
    if exact.support_couples.iter().any(|couple| *couple < 0.0) {
        let name = "moments of ground and support, left and right".to_owned();
        row(name, &of_moment, &exact.support_couples, moment, None);
    }
    let (mut zones, mut points) = (0, 0);
    for contact in &state.contacts {
        if let Some(ends) = contact.end_forces {
            zones += 1;
            row(format!("zone {zones}, from and to"), &of_length, &[contact.from, contact.to], length, None);
            row(format!("forces at the ends of zone {zones}"), &of_force, &ends, force, None);
        } else {
            points += 1;
            row(format!("contact point {points}, at x"), &of_length, &[contact.from], length, None);
            if 1 < state.contacts.len() {
                row(format!("force at contact point {points}"), &of_force, &[contact.force], force, None);
            }
        }
    }
    for (at, inside) in exact.forces_inside_zones() {
        row(format!("force in the zone at x = {at:.1}"), &of_force, &[inside], force, None);
    }
    if !state.contacts.is_empty() {
        row(CONTACT.to_owned(), &of_force, &[state.contact_force()], force, None);
    }
    if let Some(standing) = state.standing {
        row("resultant of the loads, at x".to_owned(), &of_length, &[standing.resultant.at], length, None);
        row("margin against overturning".to_owned(), "", &[standing.margin], 1.0, None);
    }
    let error = certificate.map(|c| c.deflection_error);
    for (what, unit, found, scale, proven) in [
        ("deflection", &of_length, &state.deflection, deflection, error),
        ("moment", &of_moment, &state.moment, moment, None),
    ] {
        let least = Some(("least", found.min, found.min_at)).filter(|_| found.min < found.max);
        for (word, value, x) in [Some(("largest", found.max, found.max_at)), least].into_iter().flatten() {
            if value != 0.0 {
                row(format!("{word} {what}, at x = {}", value_of(x, length, 4)), unit, &[value], scale, proven);
            }
        }
    }
    let width = certificate.map(|c| c.energy_upper - c.energy_lower);
    row("energy".to_owned(), &of_moment, &[state.energy], state.energy.abs(), width);
    rows
}

#[cfg(test)]
mod tests {
    use super::story;

    #[test]
    fn a_story_is_the_comment_at_the_head() {
        let file = "# One.\n# Two.\n\ntitle = \"a\"\n# no\n";
        assert_eq!(story(file), "One. Two.");
    }
}
