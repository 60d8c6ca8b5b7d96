//! Answers as tables for a person.

use palkki::certificate::Certificate;
use palkki::route::Status;
use palkki::state::{Contact, Extremes, Motion, Nodes, Pressure, Standing};
use palkki::text::{magnitude, magnitude_at_most};

use super::answer::{Answer, Grids};
use super::given::given;
use super::input::Input;
use super::table::{Labels, MOST_ROWS, Row, first, list, table};

/// What the answer is worth, in the first line, and the title of the scene, underlined.
pub(super) fn heading<M>(status: Status, reason: &str, input: &Input<M>) -> String {
    let title = input.title();
    format!("{status}: {reason}\n\n{title}\n{}\n\n", "=".repeat(title.chars().count()))
}

/// Where the witness of a certificate is not the list of contacts of the beam.
const COARSE: &str = "These bounds hold and are coarse: no list of contacts was proven to be that of the beam.\n";

/// What is guaranteed, rounded so that it stays so.
pub(super) fn bounds(certificate: &Certificate, labels: &Labels) -> String {
    let bracket = |name: String, [least, most]: [f64; 2]| {
        vec![name, labels.results.at_least(least), labels.results.at_most(most)]
    };
    let mut rows = vec![bracket(labels.moment.name("energy J*"), [certificate.energy_lower, certificate.energy_upper])];
    for (k, reaction) in certificate.reactions.iter().enumerate().take(MOST_ROWS) {
        let name = match (certificate.reactions.len(), k) {
            (2, 0) => "left reaction".to_owned(),
            (2, _) => "right reaction".to_owned(),
            _ => format!("force of support {}", k + 1),
        };
        rows.extend(reaction.map(|reaction| bracket(labels.force.name(&name), reaction)));
    }
    rows.extend(certificate.stiffness.map(|stiffness| bracket(labels.density.name("stiffness D"), stiffness)));
    let error = magnitude_at_most(certificate.deflection_error);
    rows.push(vec![labels.length.name("error of the deflection"), String::new(), error]);
    let mut table = table("Guaranteed for the continuous beam", &["", "at least", "at most"], &rows);
    table += &first("supports", certificate.reactions.len(), certificate.reactions.len().min(MOST_ROWS));
    if let Some(about) = certificate.up_to_a_turn {
        table += &format!(
            "The deflection is guaranteed up to a turn about x = {}: nothing says how the beam stands.\n",
            labels.number(about)
        );
    }
    if certificate.contacts_proven { table } else { table + COARSE }
}

/// The answer of `solve`: how it was found, equilibrium, contacts, extremes, and what is guaranteed.
pub(super) fn solve(input: &Input, answer: &Answer, nodes: bool) -> String {
    let labels = input.labels();
    let mut text = heading(answer.solution.verdict.status, &reason(answer), input);
    text += &list(&given(&input.scene, &labels));
    text.push('\n');
    text += &how(answer);
    if let Some(found) = &answer.grids {
        text += &grids(answer, found);
    }
    if !answer.solution.has_answer() {
        return text;
    }
    text += &equilibrium(input, answer, &labels);
    text += &contacts(&answer.solution.state.contacts, &labels);
    text += &extremes(answer, &labels);
    if let Some(certificate) = &answer.solution.verdict.certificate {
        text += &bounds(certificate, &labels);
    }
    if nodes && let Some(nodes) = answer.nodes() {
        text += &table_of_nodes(nodes, &labels);
    }
    text
}

/// Why the status is what it is.
fn reason(answer: &Answer) -> String {
    let solution = &answer.solution;
    let residual =
        if solution.has_answer() { format!(" (residual {})", magnitude(solution.residual)) } else { String::new() };
    let gave_up = if solution.verdict.status == Status::NotConverged { "the solver gave up; " } else { "" };
    format!("{gave_up}{}{residual}", answer.reason())
}

fn how(answer: &Answer) -> String {
    let solution = &answer.solution;
    let method = match answer.intervals {
        Some(intervals) => format!("{}, {intervals} intervals", answer.method),
        None => answer.method.to_owned(),
    };
    list(&[
        ("method", method),
        ("solver", format!("{}, which says: {}", answer.solver, solution.solver_status)),
        ("regime", solution.state.regime.name().to_owned()),
        ("unknowns", solution.unknowns.to_string()),
        ("iterations", solution.iterations.to_string()),
        ("seconds", magnitude(answer.seconds)),
    ])
}

/// What it took to find the grid.
fn grids(answer: &Answer, found: &Grids) -> String {
    let rows: Vec<Row> = found
        .trials
        .iter()
        .map(|(t, seconds)| {
            vec![
                t.intervals.to_string(),
                magnitude(t.tolerance),
                t.iterations.to_string(),
                magnitude(t.residual),
                magnitude_at_most(t.error),
                magnitude(*seconds),
            ]
        })
        .collect();
    let header = ["intervals", "solver asked for", "iterations", "residual", "error, relative", "seconds"];
    let end = match answer.solution.verdict.error {
        error if error.is_finite() => {
            format!("{}, with {} on {} intervals", found.end, magnitude_at_most(error), answer.intervals.unwrap_or(0))
        }
        _ => format!("{}, with no bound on the error", found.end),
    };
    let demanded = format!("an error of the deflection of at most {} of its largest value", magnitude(found.demanded));
    let seconds = format!("{} in all, bounds included", magnitude(found.seconds));
    table("Grids tried", &header, &rows) + "\n" + &list(&[("demanded", demanded), ("end", end), ("seconds", seconds)])
}

fn equilibrium(input: &Input, answer: &Answer, labels: &Labels) -> String {
    let (state, beam) = (&answer.solution.state, input.scene.beam());
    let load = input.scene.load().resultant(beam.length());
    let contact = state.contact_force();
    let remains = state.supports.iter().fold(load, |rest, support| rest - support.force) - contact;
    let mut rows = vec![("loads".to_owned(), load, "down")];
    rows.extend(
        state
            .supports
            .iter()
            .take(MOST_ROWS)
            .map(|support| (support_at(support.at, beam.length(), labels), support.force, "up")),
    );
    rows.extend([("contact".to_owned(), contact, "up"), ("what remains".to_owned(), remains, "")]);
    let rows: Vec<Row> = rows
        .into_iter()
        .map(|(name, value, way)| vec![name.clone(), shown(&name, value, labels), way.to_owned()])
        .collect();
    let mut text = table("Equilibrium", &["", &labels.force.name("force"), ""], &rows);
    text += &first("supports", state.supports.len(), state.supports.len().min(MOST_ROWS));
    let moments: Vec<Row> = state
        .supports
        .iter()
        .filter_map(|support| Some(vec![support_at(support.at, beam.length(), labels), labels.number(support.moment?)]))
        .collect();
    if !moments.is_empty() {
        text += &table("Built in", &["", &labels.moment.name("moment")], &moments);
    }
    if let Some(standing) = &state.standing {
        text += &stands(standing, labels);
    }
    text
}

/// What a support is called.
fn support_at(at: f64, length: f64, labels: &Labels) -> String {
    match at {
        0.0 => "left support".to_owned(),
        at if at.total_cmp(&length).is_eq() => "right support".to_owned(),
        at => format!("support at {}", labels.number(at)),
    }
}

/// How a beam stands that its supports do not hold.
fn stands(standing: &Standing, labels: &Labels) -> String {
    let Standing { resultant, margin, motion } = standing;
    let margin_in_words =
        if margin.is_nan() { "none: a support holds the beam down".to_owned() } else { labels.number(*margin) };
    let mut rows: Vec<Row> = vec![
        vec![labels.force.name("resultant of the loads"), labels.number(resultant.force)],
        vec![labels.length.name("its place"), labels.number(resultant.at)],
        vec!["margin against overturning".to_owned(), margin_in_words],
    ];
    if let Some(Motion { about, slope: [least, most] }) = motion {
        let end = |slope: &Option<f64>| slope.map_or_else(|| "any".to_owned(), |slope| labels.number(slope));
        rows.push(vec![labels.length.name("free to turn about"), labels.number(*about)]);
        rows.push(vec!["with slopes there".to_owned(), format!("from {} to {}", end(least), end(most))]);
    }
    table("How it stands", &["", ""], &rows)
}

/// A force of the balance; what remains of it is rounding, of which only the size is of interest.
fn shown(name: &str, value: f64, labels: &Labels) -> String {
    if name == "what remains" { magnitude(value) } else { labels.number(value) }
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
            let mut row = vec![
                kind.to_owned(),
                labels.number(contact.from),
                labels.number(contact.to),
                labels.number(contact.force),
            ];
            if ends {
                row.extend(match contact.end_forces {
                    Some(forces) => forces.map(|force| labels.number(force)),
                    None => [String::new(), String::new()],
                });
            }
            row
        })
        .collect();
    let (from, to, force) = (labels.length.name("from"), labels.length.name("to"), labels.force.name("force"));
    let at_ends = [labels.force.name("force at from"), labels.force.name("force at to")];
    let mut header = vec!["", &from, &to, &force];
    if ends {
        header.extend(at_ends.iter().map(String::as_str));
    }
    table("Contacts", &header, &rows)
}

fn extremes(answer: &Answer, labels: &Labels) -> String {
    let state = &answer.solution.state;
    let lines = |name: &str, extremes: &Extremes| {
        [("largest", extremes.max, extremes.max_at), ("least", extremes.min, extremes.min_at)]
            .map(|(which, value, at)| vec![format!("{which} {name}"), labels.number(value), labels.number(at)])
    };
    let mut rows = Vec::new();
    rows.extend(lines(&labels.length.name("deflection"), &state.deflection));
    rows.extend(lines(&labels.moment.name("moment"), &state.moment));
    let pressure =
        |p: Pressure| vec![labels.density.name("largest pressure"), labels.number(p.max), labels.number(p.at)];
    rows.extend(state.pressure.map(pressure));
    rows.push(vec![labels.moment.name("energy J"), labels.number(state.energy), String::new()]);
    table("Extremes", &["", "value", &labels.length.name("at")], &rows)
}

fn table_of_nodes(nodes: &Nodes, labels: &Labels) -> String {
    let columns = [&nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    // A supported end is node 0, and has no row.
    let first = usize::from(nodes.x.first().is_none_or(|x| 0.0 < *x));
    let rows: Vec<Row> = (0..nodes.x.len())
        .map(|i| {
            let place = [(i + first).to_string(), labels.number(nodes.x[i])];
            place
                .into_iter()
                .chain(columns.iter().map(|c| c.get(i).map_or_else(String::new, |&v| labels.number(v))))
                .collect()
        })
        .collect();
    let header = [
        "node".to_owned(),
        labels.length.name("x"),
        labels.length.name("deflection"),
        labels.length.name("clearance"),
        labels.force.name("contact force"),
        labels.moment.name("moment"),
    ];
    table("Nodes", &header, &rows)
}
