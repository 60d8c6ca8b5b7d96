//! How an exact answer changes with what is given: `--derivatives` and `--depth-tolerance`, as JSON and as tables.

use std::collections::BTreeMap;

use palkki::scene::Scene;
use palkki::state::SupportForce;
use palkki::text::{at_least, at_most, magnitude, result};
use palkki::theory::{ContactDerivative, Derivative, Spread};
use palkki::tolerance::{DepthTolerance, Touches};
use serde::Serialize;

use super::answer::Answer;
use super::arguments::Solve;
use super::input::Input;
use super::json::{ContactObject, EndsObject};
use super::table::{Labels, Row, list, table};

/// What was asked for.
#[derive(Debug, Serialize)]
pub(super) struct Local {
    /// By the paths of the numbers, or `depth` for all of the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    derivatives: Option<BTreeMap<String, DerivativeObject>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_tolerance: Option<ToleranceObject>,
}

#[derive(Debug, Serialize)]
struct DerivativeObject {
    one_sided: bool,
    reactions: EndsObject,
    supports: Vec<f64>,
    contacts: Vec<ContactObject>,
    energy: f64,
}

#[derive(Debug, Serialize)]
struct ToleranceObject {
    tolerance: f64,
    guaranteed: GuaranteedObject,
    /// First-order estimates, not bounds.
    estimates: Option<Spread>,
}

#[derive(Debug, Serialize)]
struct GuaranteedObject {
    energy: [Option<f64>; 2],
    contact: Touches,
}

impl Local {
    /// What the arguments ask for of an answer of beam theory.
    pub(super) fn of(scene: &Scene, answer: &Answer, arguments: &Solve) -> Self {
        let exact = answer.solution.exact.as_deref();
        let supports = &answer.solution.state.supports;
        let length = scene.beam().length();
        let derivatives = exact.filter(|_| arguments.derivatives).map(|exact| {
            let all = exact.derivatives(scene).into_iter();
            all.map(|derivative| (derivative.by.to_string(), object(derivative, supports, length))).collect()
        });
        let known = exact.zip(arguments.depth_tolerance).map(|(exact, tolerance)| {
            let DepthTolerance { tolerance, energy, contact, estimates } = DepthTolerance::of(scene, exact, tolerance);
            ToleranceObject { tolerance, guaranteed: GuaranteedObject { energy, contact }, estimates }
        });
        Self { derivatives, depth_tolerance: known }
    }

    /// Tables for a person.
    pub(super) fn text(&self, input: &Input) -> String {
        let labels = Labels::of(input.scene.units());
        let mut text = String::new();
        if let Some(derivatives) = &self.derivatives {
            let supports = derivatives.values().map(|d| d.supports.len()).max().unwrap_or(0);
            let mut header = vec!["of:".to_owned()];
            header.extend((1..=supports).map(|i| format!("support {i}")));
            header.extend(["contact force", "energy", ""].map(str::to_owned));
            let row = |(by, derivative): (&String, &DerivativeObject)| -> Row {
                let contact: f64 = derivative.contacts.iter().map(|contact| contact.force).sum();
                let mut row = vec![format!("by {by}")];
                row.extend(
                    derivative.supports.iter().chain([&contact, &derivative.energy]).map(|value| result(*value)),
                );
                row.push(if derivative.one_sided { "one-sided" } else { "" }.to_owned());
                row
            };
            let rows: Vec<Row> = derivatives.iter().map(row).collect();
            text += &table("Derivatives; --format json has those of each contact", &header, &rows);
        }
        if let Some(known) = &self.depth_tolerance {
            let [lower, upper] = known.guaranteed.energy;
            let none = || "not known".to_owned();
            text += &format!("\nIf each depth may be off by {}\n", magnitude(known.tolerance));
            let mut lines = vec![
                ("guaranteed: the beam touches".to_owned(), known.guaranteed.contact.name().to_owned()),
                (
                    format!("guaranteed: {} at least", labels.moment.name("energy J*")),
                    lower.map_or_else(none, at_least),
                ),
                (format!("guaranteed: {} at most", labels.moment.name("energy J*")), upper.map_or_else(none, at_most)),
            ];
            for (i, spread) in known.estimates.iter().flat_map(|spread| spread.supports.iter().enumerate()) {
                let name = labels.force.name(&format!("force of support {}", i + 1));
                lines.push((format!("estimate: {name} off by"), magnitude(*spread)));
            }
            text += &list(&lines);
        }
        text
    }
}

fn object(derivative: Derivative, supports: &[SupportForce], length: f64) -> DerivativeObject {
    let Derivative { one_sided, supports: forces, contacts, energy, .. } = derivative;
    let contact = |ContactDerivative { from, to, force, end_forces }| ContactObject::new(from, to, force, end_forces);
    DerivativeObject {
        one_sided,
        reactions: EndsObject::of(length, supports, |i| forces[i]),
        contacts: contacts.into_iter().map(contact).collect(),
        supports: forces,
        energy,
    }
}
