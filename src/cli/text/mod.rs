//! Answers as tables for a person.

mod certify;
mod compare;
mod solve;

use palkki::certificate::Certificate;

pub(super) use self::certify::certify;
pub(super) use self::compare::compare;
pub(super) use self::solve::solve;
use super::input::Input;
use super::labels::Labels;
use super::number::{at_least, at_most, magnitude_at_most};
use super::table::table;

/// The title of the scene, underlined.
fn heading(input: &Input) -> String {
    let title = input.title();
    format!("{title}\n{}\n\n", "=".repeat(title.chars().count()))
}

/// Where the witness of a certificate is not the list of contacts of the beam.
const COARSE: &str = "These bounds hold and are coarse: no list of contacts was proven to be that of the beam.\n";

/// What is guaranteed, rounded so that it stays so.
fn bounds(certificate: &Certificate, labels: &Labels) -> String {
    let bracket = |name: String, [least, most]: [f64; 2]| vec![name, at_least(least), at_most(most)];
    let mut rows = vec![bracket(labels.moment("energy J*"), [certificate.energy_lower, certificate.energy_upper])];
    for (name, reaction) in ["left reaction", "right reaction"].into_iter().zip(certificate.reactions) {
        rows.extend(reaction.map(|reaction| bracket(labels.force(name), reaction)));
    }
    rows.extend(certificate.stiffness.map(|stiffness| bracket(labels.stiffness("stiffness D"), stiffness)));
    let error = magnitude_at_most(certificate.deflection_error);
    rows.push(vec![labels.length("error of the deflection"), String::new(), error]);
    let table = table("Guaranteed for the continuous beam", &["", "at least", "at most"], &rows);
    if certificate.contacts_proven { table } else { table + COARSE }
}
