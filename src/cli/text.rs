//! Answers as tables for a person.

use palkki::certificate::Certificate;
use palkki::certificate::bounds::ViolationKind;
use palkki::route::Status;
use palkki::state::{Contact, Extremes, Nodes};

use super::answer::Answer;
use super::certify::Judgement;
use super::compare::{Comparison, Difference};
use super::given::given;
use super::grids::grids;
use super::input::Input;
use super::labels::Labels;
use super::number::{at_least, at_most, magnitude, magnitude_at_most, result};
use super::table::{Row, list, table};

pub(super) fn solve(input: &Input, answer: &Answer, nodes: bool) -> String {
    let labels = Labels::of(input.scene.units());
    let mut text = format!("{}\n{}\n\n", input.title(), "=".repeat(input.title().chars().count()));
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

pub(super) fn compare(input: &Input, comparison: &Comparison) -> String {
    let error =
        |difference: &Option<Difference>| difference.as_ref().map_or_else(|| "–".to_owned(), |d| magnitude(d.worst()));
    let rows: Vec<Row> = comparison
        .routes
        .iter()
        .map(|compared| {
            let answer = &compared.answer;
            vec![
                answer.method.to_owned(),
                answer.solver.to_owned(),
                answer.status.to_string(),
                answer.residual.map_or_else(|| "–".to_owned(), magnitude),
                answer.iterations.to_string(),
                magnitude(answer.seconds),
                result(answer.state.reactions.left),
                certified(answer.error),
                error(&compared.solver_error),
                error(&compared.model_error),
            ]
        })
        .collect();
    let reaction = Labels::of(input.scene.units()).force("left reaction");
    let header = [
        "method",
        "solver",
        "status",
        "residual",
        "iterations",
        "seconds",
        &reaction,
        "certified error",
        "solver error",
        "model error",
    ];
    let title = format!("{}, {} intervals", input.title(), comparison.intervals);
    let mut text = table(&title, &header, &rows).trim_start().to_owned();
    text.push_str(
        "\nCertified error: at most this far is the deflection from that of the beam, relative to its largest value.\n\
         Solver error: against the active-set answer on the same grid; model error: against beam theory.\n\
         These two are the worst relative difference among end reactions, energy and largest deflection.\n",
    );
    text
}

pub(super) fn certify(input: &Input, judgement: &Judgement) -> String {
    let labels = Labels::of(input.scene.units());
    let mut text = format!("{}\n{}\n\n", input.title(), "=".repeat(input.title().chars().count()));
    let share = judgement.certificate.deflection_error / judgement.certificate.deflection;
    let status = match judgement.status() {
        Status::Certified => {
            format!("certified: the deflection is certain to {} of its largest value", magnitude_at_most(share))
        }
        status if share.is_finite() => {
            format!("{status}: the deflection may be off by {} of its largest value", magnitude_at_most(share))
        }
        status => format!("{status}: nothing could be shown about these forces"),
    };
    let cut: f64 = judgement.load.pulling().iter().map(|f| -f.1).sum();
    let cut = match judgement.load.pulling().len() {
        0 => "none".to_owned(),
        count => format!("{count}, together {}", result(cut)),
    };
    text += &list(&[("status", status), (&labels.force("forces cut off"), cut)]);
    text += &bounds(&judgement.certificate, &labels);
    let best = magnitude_at_most(judgement.certificate.best_deflection_error);
    text += &list(&[(&labels.length("error of the best deflection found"), best)]);
    if judgement.violations.is_empty() {
        text += "\nViolations: none\n";
        return text;
    }
    let rows: Vec<Row> = judgement
        .violations
        .iter()
        .map(|v| {
            let what = match v.kind {
                ViolationKind::Tension => labels.force("a force pulls"),
                ViolationKind::Penetration => labels.length("the beam is in the foundation"),
                ViolationKind::Complementarity => labels.length("a force acts across a clearance"),
            };
            vec![what, magnitude(v.amount), magnitude(v.relative), result(v.at)]
        })
        .collect();
    text += &table("Violations, the worst of each kind", &["", "amount", "relative", &labels.length("at")], &rows);
    text
}

/// An error that is guaranteed, if there is one.
fn certified(error: f64) -> String {
    if error.is_finite() { magnitude_at_most(error) } else { "–".to_owned() }
}

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
    table("Guaranteed for the continuous beam", &["", "at least", "at most"], &rows)
}
