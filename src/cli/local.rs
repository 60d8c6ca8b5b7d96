//! Sensitivity of an exact answer: `--derivatives` and `--depth-tolerance`, as JSON and as tables.

use std::collections::{BTreeMap, BTreeSet};

use palkki::scene::Scene;
use palkki::state::SupportForce;
use palkki::text::magnitude;
use palkki::theory::{ContactDerivative, Derivative, Missing, Spread};
use palkki::tolerance::{DepthTolerance, Touches};
use serde::Serialize;

use super::answer::Answer;
use super::arguments::Solve;
use super::input::Input;
use super::json::{ContactObject, EndsObject};
use super::table::{Labels, MOST_ROWS, Row, first, list, table};
use super::text::BRACKET;

/// The requested results.
#[derive(Debug, Serialize)]
pub(super) struct Local {
    /// Derivatives by the path of the number, or by `depth` for the whole foundation.
    #[serde(skip_serializing_if = "Option::is_none")]
    derivatives: Option<BTreeMap<String, DerivativeObject>>,
    /// Number of scene numbers without derivatives, because these would be too many or need too long.
    #[serde(skip_serializing_if = "Option::is_none")]
    derivatives_left_out: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_tolerance: Option<ToleranceObject>,
}

#[derive(Debug, Serialize)]
struct DerivativeObject {
    one_sided: bool,
    /// The reason why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none")]
    missing: Option<&'static str>,
    reactions: EndsObject,
    supports: Vec<f64>,
    contacts: Vec<ContactObject>,
    /// Includes contacts that begin to press.
    contact_force: f64,
    energy: f64,
}

#[derive(Debug, Serialize)]
struct ToleranceObject {
    tolerance: f64,
    guaranteed: GuaranteedObject,
    /// First-order estimates, not bounds.
    estimates: Option<Spread>,
    /// What is left out, and why.
    #[serde(skip_serializing_if = "Option::is_none")]
    left_out: Option<&'static str>,
}

#[derive(Debug, Serialize)]
struct GuaranteedObject {
    energy: [Option<f64>; 2],
    contact: Touches,
}

impl Local {
    /// The results that the arguments request for an answer of beam theory.
    pub(super) fn of(scene: &Scene, answer: &Answer, arguments: &Solve) -> Self {
        let exact = answer.solution.exact.as_deref();
        let supports = &answer.solution.state.supports;
        let length = scene.beam().length();
        let found = exact.filter(|_| arguments.derivatives).map(|exact| exact.derivatives_and_left_out(scene));
        let left_out = found.as_ref().map(|(_, left_out)| *left_out).filter(|&count| 0 < count);
        let derivatives = found.map(|(all, _)| {
            let all = all.into_iter();
            all.map(|derivative| (derivative.by.to_string(), object(derivative, supports, length))).collect()
        });
        let known = exact.zip(arguments.depth_tolerance).map(|(exact, tolerance)| {
            let DepthTolerance { tolerance, energy, contact, estimates, left_out } =
                DepthTolerance::of(scene, exact, tolerance);
            ToleranceObject { tolerance, guaranteed: GuaranteedObject { energy, contact }, estimates, left_out }
        });
        Self { derivatives, derivatives_left_out: left_out, depth_tolerance: known }
    }

    /// The results as tables.
    pub(super) fn text(&self, input: &Input) -> String {
        let labels = input.labels();
        let mut text = String::new();
        if let Some(derivatives) = &self.derivatives {
            text += &table_of(derivatives, self.derivatives_left_out, &labels);
        }
        if let Some(known) = &self.depth_tolerance {
            let [lower, upper] = known.guaranteed.energy;
            let none = || "not known".to_owned();
            text += &format!("\nIf each depth has an error of up to {}\n", magnitude(known.tolerance));
            let mut lines = vec![
                ("proven: the beam touches".to_owned(), known.guaranteed.contact.name().to_owned()),
                (
                    format!("proven: {}", labels.moment.name("energy J*")),
                    format!(
                        "{} {} {} {}",
                        BRACKET[0],
                        lower.map_or_else(none, |energy| labels.results.at_least(energy)),
                        BRACKET[1],
                        upper.map_or_else(none, |energy| labels.results.at_most(energy)),
                    ),
                ),
            ];
            lines.extend(known.left_out.map(|why| ("left out".to_owned(), why.to_owned())));
            for (i, spread) in
                known.estimates.iter().flat_map(|spread| spread.supports.iter().enumerate().take(MOST_ROWS))
            {
                let name = labels.force.name(&format!("error of reaction {}", i + 1));
                lines.push((format!("estimated: {name}"), magnitude(*spread)));
            }
            text += &list(&lines);
        }
        text
    }
}

/// Largest number of support columns in a table.
const MOST_SUPPORTS: usize = 8;

/// One row for each number of the scene, followed by the reasons for missing derivatives.
fn table_of(derivatives: &BTreeMap<String, DerivativeObject>, left_out: Option<usize>, labels: &Labels) -> String {
    let supports = derivatives.values().map(|d| d.supports.len()).max().unwrap_or(0);
    let shown = supports.min(MOST_SUPPORTS);
    let mut header = vec!["of:".to_owned()];
    header.extend((1..=shown).map(|i| format!("support {i}")));
    header.extend(["contact force", "energy", ""].map(str::to_owned));
    let number = |value: &f64| if value.is_finite() { labels.number(*value) } else { "-".to_owned() };
    let row = |(by, derivative): (&String, &DerivativeObject)| -> Row {
        let mut row = vec![format!("by {by}")];
        row.extend(
            derivative.supports.iter().take(shown).chain([&derivative.contact_force, &derivative.energy]).map(number),
        );
        row.push(match (derivative.missing, derivative.one_sided) {
            (Some(why), _) => why.split(':').next().unwrap_or_default().to_owned(),
            (None, true) => "one-sided".to_owned(),
            (None, false) => String::new(),
        });
        row
    };
    let rows: Vec<Row> = derivatives.iter().take(MOST_ROWS).map(row).collect();
    let mut text = table("Derivatives; --format json has those of each contact", &header, &rows);
    let reasons: BTreeSet<&str> = derivatives.values().filter_map(|derivative| derivative.missing).collect();
    text.extend(reasons.into_iter().map(|why| format!("{why}\n")));
    for (what, there, shown) in [("supports", supports, shown), ("numbers of the scene", derivatives.len(), rows.len())]
    {
        text += &first(what, there, shown);
    }
    if let Some(count) = left_out {
        text += &format!(
            "Left out are derivatives by {count} numbers of the scene: they would be too many, or take too long.\n"
        );
    }
    text
}

fn object(derivative: Derivative, supports: &[SupportForce], length: f64) -> DerivativeObject {
    let Derivative { one_sided, missing, supports: forces, contacts, contact_force, energy, .. } = derivative;
    let contact = |ContactDerivative { from, to, force, end_forces }| ContactObject::new(from, to, force, end_forces);
    DerivativeObject {
        one_sided,
        missing: missing.map(Missing::reason),
        reactions: EndsObject::of(length, supports, |i| forces[i]),
        contacts: contacts.into_iter().map(contact).collect(),
        supports: forces,
        contact_force,
        energy,
    }
}
