//! The answer of `solve`: how it was found, equilibrium, contacts, extremes, and what is guaranteed.

use palkki::route::Status;
use palkki::state::{Contact, Extremes, Nodes};

use super::super::answer::Answer;
use super::super::given::given;
use super::super::grids::grids;
use super::super::input::Input;
use super::super::labels::Labels;
use super::super::number::{magnitude, result};
use super::super::table::{Row, list, table};
use super::{bounds, heading};

pub(in super::super) fn solve(input: &Input, answer: &Answer, nodes: bool) -> String {
    let labels = Labels::of(input.scene.units());
    let mut text = heading(input);
    text += &list(&given(&input.scene));
    text.push('\n');
    text += &how(answer);
    if let Some(search) = &answer.search {
        text += &grids(answer, search);
    }
    text += &equilibrium(input, answer, &labels);
    text += &contacts(&answer.state.contacts, &labels);
    text += &extremes(answer, &labels);
    if let Some(certificate) = &answer.certificate {
        text += &bounds(certificate, &labels);
    }
    if nodes && let Some(nodes) = answer.nodes() {
        text += &table_of_nodes(nodes, &labels);
    }
    text
}

fn how(answer: &Answer) -> String {
    let method = match answer.intervals {
        Some(intervals) => format!("{}, {intervals} intervals", answer.method),
        None => answer.method.to_owned(),
    };
    let residual = answer.residual.map_or_else(String::new, |r| format!(" (residual {})", magnitude(r)));
    let why = answer.refusal.map_or_else(String::new, |refusal| format!(", {refusal}"));
    let status = match answer.status {
        Status::Certified => format!("{}{residual}", answer.status),
        Status::NotCertified => format!("{}: the answer fails our check{residual}{why}", answer.status),
        Status::NotConverged => {
            format!("{}: the solver gave up, and what it had fails our check{residual}{why}", answer.status)
        }
    };
    list(&[
        ("method", method),
        ("solver", format!("{}, which says: {}", answer.solver, answer.solver_status)),
        ("status", status),
        ("regime", answer.state.regime.word().to_owned()),
        ("unknowns", answer.unknowns.to_string()),
        ("iterations", answer.iterations.to_string()),
        ("seconds", magnitude(answer.seconds)),
    ])
}

fn equilibrium(input: &Input, answer: &Answer, labels: &Labels) -> String {
    let (load, reactions) = (input.scene.load().resultant(input.scene.beam().length()), answer.state.reactions);
    let contact = answer.state.contact_force();
    let remains = load - reactions.left - reactions.right - contact;
    let rows = [
        ("loads", load, "down"),
        ("left support", reactions.left, "up"),
        ("right support", reactions.right, "up"),
        ("contact", contact, "up"),
        ("what remains", remains, ""),
    ];
    let rows = rows.map(|(name, value, way)| vec![name.to_owned(), shown(name, value), way.to_owned()]);
    table("Equilibrium", &["", &labels.force("force"), ""], &rows)
}

/// A force of the balance; what remains of it is rounding, of which only the size is of interest.
fn shown(name: &str, value: f64) -> String {
    if name == "what remains" { magnitude(value) } else { result(value) }
}

fn contacts(contacts: &[Contact], labels: &Labels) -> String {
    if contacts.is_empty() {
        return "\nContacts: none\n".to_owned();
    }
    let ends = contacts.iter().any(|contact| contact.end_forces.is_some());
    let rows: Vec<Row> = contacts
        .iter()
        .map(|contact| {
            let kind = if contact.from < contact.to { "zone" } else { "point" };
            let mut row = vec![kind.to_owned(), result(contact.from), result(contact.to), result(contact.force)];
            if ends {
                row.extend(match contact.end_forces {
                    Some(forces) => forces.map(result),
                    None => [String::new(), String::new()],
                });
            }
            row
        })
        .collect();
    let (from, to, force) = (labels.length("from"), labels.length("to"), labels.force("force"));
    let at_ends = [labels.force("force at from"), labels.force("force at to")];
    let mut header = vec!["", &from, &to, &force];
    if ends {
        header.extend(at_ends.iter().map(String::as_str));
    }
    table("Contacts", &header, &rows)
}

fn extremes(answer: &Answer, labels: &Labels) -> String {
    let lines = |name: &str, extremes: &Extremes| {
        [("largest", extremes.max, extremes.max_at), ("least", extremes.min, extremes.min_at)]
            .map(|(which, value, at)| vec![format!("{which} {name}"), result(value), result(at)])
    };
    let mut rows = Vec::new();
    rows.extend(lines(&labels.length("deflection"), &answer.state.deflection));
    rows.extend(lines(&labels.moment("moment"), &answer.state.moment));
    rows.push(vec![labels.moment("energy J"), result(answer.state.energy), String::new()]);
    table("Extremes", &["", "value", &labels.length("at")], &rows)
}

fn table_of_nodes(nodes: &Nodes, labels: &Labels) -> String {
    let columns = [&nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    let rows: Vec<Row> = (0..nodes.x.len())
        .map(|i| {
            let place = [(i + 1).to_string(), result(nodes.x[i])];
            place.into_iter().chain(columns.iter().map(|c| c.get(i).map_or_else(String::new, |&v| result(v)))).collect()
        })
        .collect();
    let header = [
        "node".to_owned(),
        labels.length("x"),
        labels.length("deflection"),
        labels.length("clearance"),
        labels.force("contact force"),
        labels.moment("moment"),
    ];
    table("Nodes", &header.each_ref().map(String::as_str), &rows)
}
