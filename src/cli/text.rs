//! Answers as text tables.

use std::fmt::Display;

use palkki::certificate::Certificate;
use palkki::route::Status;
use palkki::scene::Beam;
use palkki::state::{Contact, Extremes, Motion, Nodes, Pressure, Standing, SupportForce, Touch};
use palkki::text::{magnitude, magnitude_at_most};
use palkki::theory::{Exact, FreeSpan};

use super::answer::{Answer, Grids};
use super::given::scene_lines;
use super::input::Input;
use super::table::{Label, Labels, MOST_ROWS, Row, first, list, table};

/// The status with its reason in the first line, and the underlined title of the scene.
pub(super) fn heading<M>(status: impl Display, reason: &str, input: &Input<M>) -> String {
    titled(status, reason, input, input.warnings())
}

/// The same with other warnings.
pub(super) fn titled<M>(status: impl Display, reason: &str, input: &Input<M>, warnings: &[String]) -> String {
    let title = input.title();
    format!("{status}: {reason}\n\n{title}\n{}\n\n{}", "=".repeat(title.chars().count()), warning_lines(warnings))
}

/// Warnings as lines of text, followed by a blank line; empty if there are none.
pub(super) fn warning_lines(warnings: &[String]) -> String {
    let lines: String = warnings.iter().map(|warning| format!("Warning: {warning}.\n")).collect();
    if lines.is_empty() { lines } else { lines + "\n" }
}

/// Printed if the candidate contact list was not proven to be the contact list of the beam.
const COARSE: &str = "These bounds are true and wide: no contact list was proven to be that of the beam.\n";

/// A bracket, rounded outwards; `none` without one.
fn bracket(of: Option<[f64; 2]>, labels: &Labels) -> [String; 2] {
    let words = || ["none", ""].map(str::to_owned);
    of.map_or_else(words, |[least, most]| [labels.results.at_least(least), labels.results.at_most(most)])
}

/// Heading of the computed value. The bracket next to it applies to the true beam; on a grid the computed value may be outside it.
pub(super) const COMPUTED: &str = "computed";
/// Headings of the bracket; see [`COMPUTED`].
pub(super) const BRACKET: [&str; 2] = ["true value between", "and"];

/// All bounds for forces from elsewhere, which have no computed values to be printed with.
pub(super) fn bounds(certificate: &Certificate, labels: &Labels) -> String {
    let mut rows: Vec<Row> = Vec::new();
    let mut add = |name: String, of: Option<[f64; 2]>| {
        rows.push(std::iter::once(name).chain(bracket(of, labels)).collect());
    };
    add(labels.moment.name("energy J*"), Some([certificate.energy_lower, certificate.energy_upper]));
    let count = certificate.reactions.len();
    for (k, reaction) in certificate.reactions.iter().enumerate().take(MOST_ROWS) {
        let name = match (count, k) {
            (1, _) => "support".to_owned(),
            (2, 0) => "left support".to_owned(),
            (2, _) => "right support".to_owned(),
            _ => format!("support {}", k + 1),
        };
        add(labels.force.name(&name), *reaction);
    }
    add(labels.force.name("contact force"), certificate.contact_force);
    add(labels.length.name("largest deflection"), certificate.deflection_max);
    text_of(certificate, rows, &first("supports", count, count.min(MOST_ROWS)), labels)
}

/// The bounds that are not printed next to a computed value.
fn others(certificate: &Certificate, labels: &Labels) -> String {
    text_of(certificate, Vec::new(), "", labels)
}

fn text_of(certificate: &Certificate, mut rows: Vec<Row>, left_out: &str, labels: &Labels) -> String {
    rows.extend(certificate.stiffness.map(|stiffness| {
        std::iter::once(labels.density.name("stiffness D")).chain(bracket(Some(stiffness), labels)).collect()
    }));
    let error = magnitude_at_most(certificate.deflection_error);
    rows.push(vec![labels.length.name("error of the deflection"), "0".to_owned(), error]);
    let mut table = table("Error bounds for the continuous beam", &["", BRACKET[0], BRACKET[1]], &rows) + left_out;
    if let Some(about) = certificate.up_to_a_turn {
        table += &format!(
            "The deflection is bounded up to a rotation about x = {}: its slope there is not determined.\n",
            labels.number(about)
        );
    }
    if certificate.contacts_proven { table } else { table + COARSE }
}

/// The answer of `solve`: method and solver, equilibrium, contacts, extremes and bounds.
pub(super) fn solve(input: &Input, answer: &Answer, nodes: bool) -> String {
    let labels = input.labels();
    let warnings = answer.warnings(input);
    let mut text = titled(answer.solution.verdict.status, &reason(answer), input, &warnings);
    text += &list(&scene_lines(&input.scene, &labels));
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
    text += &touches(&answer.solution.state.touches, &labels);
    text += &extremes(answer, &labels);
    if let Some(exact) = &answer.solution.exact
        && 1 < answer.solution.state.touched().len()
    {
        text += &spans(input.scene.beam(), exact, &labels);
    }
    if let Some(certificate) = &answer.solution.verdict.certificate {
        text += &others(certificate, &labels);
    }
    if nodes && let Some(nodes) = answer.nodes() {
        text += &table_of_nodes(nodes, &labels);
    }
    text
}

/// The reason for the status.
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
        ("solver", answer.solver.to_owned()),
        ("solver message", solution.run.message.to_string()),
        ("regime", solution.state.regime.name().to_owned()),
        ("unknowns", solution.unknowns.to_string()),
        ("iterations", solution.run.iterations.to_string()),
        ("seconds", magnitude(answer.seconds)),
    ])
}

/// The grids that were tried.
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
    let end = match answer.solution.verdict.largest_error() {
        error if error.is_finite() => {
            format!("{}, with {} on {} intervals", found.end, magnitude_at_most(error), answer.intervals.unwrap_or(0))
        }
        _ => format!("{}, with no bound on the error", found.end),
    };
    let demanded = format!("errors of at most {} of the largest of each kind", magnitude(found.demanded));
    let seconds = format!("{} in all, bounds included", magnitude(found.seconds));
    table("Grids tried", &header, &rows) + "\n" + &list(&[("demanded", demanded), ("end", end), ("seconds", seconds)])
}

fn equilibrium(input: &Input, answer: &Answer, labels: &Labels) -> String {
    let (state, beam) = (&answer.solution.state, input.scene.beam());
    let certificate = answer.solution.verdict.certificate.as_ref();
    let load = input.scene.load().resultant(beam.length());
    let contact = state.contact_force();
    let remains = state.supports.iter().fold(load, |rest, support| rest - support.force) - contact;
    let is_only = state.supports.len() == 1;
    let named = |support: &SupportForce| support_at(support.at, beam.length(), is_only, labels);
    let row = |name: String, force: String, way: &str, guaranteed: [String; 2]| -> Row {
        [name, force, way.to_owned()].into_iter().chain(guaranteed).collect()
    };
    let none = || [String::new(), String::new()];
    let mut rows = vec![row("loads".to_owned(), labels.number(load), "down", none())];
    rows.extend(state.supports.iter().enumerate().take(MOST_ROWS).map(|(k, support)| {
        let known = certificate.and_then(|c| c.reactions.get(k).copied().flatten());
        let touches = state.touches.iter().any(|touch| touch.from <= support.at && support.at <= touch.to);
        let lifted = if support.pushes_only && support.force <= 0.0 && !touches { ", lifted off" } else { "" };
        let name = named(support) + lifted;
        row(name, labels.number(support.force), "up", bracket(known, labels))
    }));
    let known = bracket(certificate.and_then(|c| c.contact_force), labels);
    rows.push(row("contact".to_owned(), labels.number(contact), "up", known));
    // This is rounding, of which only the magnitude matters.
    rows.push(row("equilibrium residual".to_owned(), magnitude(remains), "", none()));
    let mut text = table("Equilibrium", &["", &labels.force.name(COMPUTED), "", BRACKET[0], BRACKET[1]], &rows);
    text += &first("supports", state.supports.len(), state.supports.len().min(MOST_ROWS));
    let moments: Vec<Row> = state
        .supports
        .iter()
        .filter_map(|support| Some(vec![named(support), labels.number(support.moment?)]))
        .collect();
    if !moments.is_empty() {
        text += &table("Built in", &["", &labels.moment.name("moment")], &moments);
    }
    if let Some(standing) = &state.standing {
        text += &stands(standing, labels);
    }
    text
}

/// The name of a support: by its end of the beam, unless it is the only support.
fn support_at(at: f64, length: f64, is_only: bool, labels: &Labels) -> String {
    match at {
        0.0 if !is_only => "left support".to_owned(),
        at if !is_only && at.total_cmp(&length).is_eq() => "right support".to_owned(),
        at => format!("support at {}", labels.number(at)),
    }
}

/// The stability of a beam that its supports do not hold.
fn stands(standing: &Standing, labels: &Labels) -> String {
    let Standing { resultant, margin, motion } = standing;
    let margin_in_words =
        if margin.is_nan() { "none: a support holds the beam down".to_owned() } else { labels.number(*margin) };
    let mut rows: Vec<Row> = vec![
        vec![labels.force.name("resultant of the loads"), labels.number(resultant.force)],
        vec![labels.length.name("its position"), labels.number(resultant.at)],
        vec!["margin against overturning".to_owned(), margin_in_words],
    ];
    if let Some(Motion { about, slope: [least, most] }) = motion {
        let end = |slope: &Option<f64>| slope.map_or_else(|| "any".to_owned(), |slope| labels.number(slope));
        rows.push(vec![labels.length.name("free to turn about"), labels.number(*about)]);
        rows.push(vec!["with slopes there".to_owned(), format!("from {} to {}", end(least), end(most))]);
    }
    table("Stability against overturning", &["", ""], &rows)
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

/// One line with the positions at which the beam touches without pressing.
fn touches(touches: &[Touch], labels: &Labels) -> String {
    if touches.is_empty() {
        return String::new();
    }
    let place = |touch: &Touch| {
        let [from, to] = [touch.from, touch.to].map(|x| labels.number(x));
        if touch.from < touch.to { format!("from {from} to {to}") } else { format!("at {from}") }
    };
    let shown = touches.iter().take(MOST_ROWS).map(place).collect::<Vec<_>>().join(", ");
    let more = if MOST_ROWS < touches.len() { ", and further places" } else { "" };
    format!("Without pressing, the beam touches {shown}{more}\n")
}

/// The spans between contacts, with the position of the beam if it has an initial shape or no supports.
fn spans(beam: &Beam, exact: &Exact, labels: &Labels) -> String {
    let spans = exact.free_spans(beam);
    if spans.is_empty() {
        return String::new();
    }
    let has_position = beam.shape().is_some() || beam.all_supports().is_empty();
    let row = |span: &FreeSpan| -> Row {
        let &FreeSpan { from, to, clearance, position, moment } = span;
        let (clearance, at) = clearance.map_or((f64::INFINITY, f64::INFINITY), |c| (c.max, c.max_at));
        let position = has_position.then_some(position.unwrap_or(f64::INFINITY));
        let numbers = [from, to, to - from, clearance, at].into_iter().chain(position).chain([moment.max, moment.min]);
        numbers.map(|number| if number.is_finite() { labels.number(number) } else { String::new() }).collect()
    };
    let [length, moment] = [&labels.length, &labels.moment];
    let of_length = |names: &[&str]| names.iter().map(|name| length.name(name)).collect::<Vec<_>>();
    let mut header = of_length(&["from", "to", "length", "largest clearance", "at"]);
    if has_position {
        header.push(length.name("position there"));
    }
    header.extend(["largest moment", "least moment"].map(|name| moment.name(name)));
    let shown = spans.len().min(MOST_ROWS);
    let rows: Vec<Row> = spans.iter().take(shown).map(row).collect();
    table("Free spans", &header, &rows) + &first("spans", spans.len(), shown)
}

fn extremes(answer: &Answer, labels: &Labels) -> String {
    let state = &answer.solution.state;
    let certificate = answer.solution.verdict.certificate.as_ref();
    let row = |name: String, value: f64, at: Option<f64>, guaranteed: [String; 2]| -> Row {
        let at = at.map_or_else(String::new, |at| labels.number(at));
        [name, labels.number(value)].into_iter().chain(guaranteed).chain([at]).collect()
    };
    let moments = certificate.and_then(|c| c.moments_beside(state)).unwrap_or([None; 2]);
    let named = |name: &str, label: &Label| label.name(name);
    let Extremes { max, max_at, min, min_at } = state.deflection;
    let (v, m) = (&labels.length, &labels.moment);
    let largest = bracket(certificate.and_then(|c| c.deflection_max), labels);
    let mut rows = vec![row(named("largest deflection", v), max, Some(max_at), largest)];
    // The least deflection has no bracket.
    rows.push(row(named("least deflection", v), min, Some(min_at), bracket(None, labels)));
    let Extremes { max, max_at, min, min_at } = state.moment;
    rows.push(row(named("largest moment", m), max, Some(max_at), bracket(moments[0], labels)));
    rows.push(row(named("least moment", m), min, Some(min_at), bracket(moments[1], labels)));
    let energy = certificate.map(|c| [c.energy_lower, c.energy_upper]);
    rows.push(row(named("energy J", m), state.energy, None, bracket(energy, labels)));
    let pressure =
        |p: Pressure| row(named("largest pressure", &labels.density), p.max, Some(p.at), bracket(None, labels));
    rows.extend(state.pressure.map(pressure));
    table("Extremes", &["", COMPUTED, BRACKET[0], BRACKET[1], &labels.length.name("at")], &rows)
}

fn table_of_nodes(nodes: &Nodes, labels: &Labels) -> String {
    let columns = [&nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    // A supported end is node 0 and has no row.
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
