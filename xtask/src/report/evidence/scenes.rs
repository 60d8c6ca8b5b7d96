//! The gallery: the exact solution of every scene file, what it required, and which discrete routes are certified.

mod required;
mod routes;

use std::fs;
use std::path::Path;

use palkki::plot::{Curves, curves};
use palkki::route::Status;
use palkki::scene::Scene;
use palkki::state::{Contact, Extremes, Regime};
use palkki::theory::{self, Exact};
use serde::Serialize;

use self::required::Required;
use self::routes::Routes;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::{exact, numbers, scenes, verdict};

#[derive(Debug, Serialize)]
struct Values {
    rows: Vec<Row>,
    /// How many of them are exact and checked.
    exact: usize,
    fewest: usize,
    most: usize,
    /// The grid on which routes are counted.
    coarse: usize,
    /// Routes that are meant to reach the optimum, on all scenes together, and how many are certified.
    routes: usize,
    certified: usize,
    /// The same for the four steps.
    four_step_routes: usize,
    four_step_certified: usize,
    targets: [String; 2],
    cap: usize,
    /// Whether some search for a grid ended there.
    capped: bool,
    /// Whether the judge stopped one before.
    refused: bool,
    /// Worst residual of all scenes, as a bound.
    residual: String,
    /// Lines of the verdict table.
    verdicts: Vec<verdict::Row>,
}

#[derive(Debug, Serialize)]
struct Row {
    name: String,
    title: String,
    /// What the scene file says of itself.
    story: String,
    figure: String,
    status: &'static str,
    regime: &'static str,
    unknowns: usize,
    length: String,
    force: String,
    moment: String,
    energy_unit: String,
    contacts: Vec<Touch>,
    /// Concentrated forces inside zones, `[place, force]`.
    inside: Vec<[f64; 2]>,
    left: f64,
    right: f64,
    /// Moments of foundation and support together, where the foundation meets a support.
    couples: [f64; 2],
    contact_force: f64,
    energy: f64,
    deflection: Span,
    bending: Span,
    required: Required,
    routes: Routes,
}

/// A contact; the forces at its ends are missing at a point.
#[derive(Debug, Serialize)]
struct Touch {
    from: f64,
    to: f64,
    point: bool,
    force: f64,
    ends: [f64; 2],
}

/// The greatest and the least value, each with its place.
#[derive(Debug, Serialize)]
struct Span {
    max: [f64; 2],
    min: [f64; 2],
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut rows = Vec::new();
    let mut drawings = Vec::new();
    let mut residual = 0.0_f64;
    for (name, scene) in scenes::all(study.root)? {
        let exact = theory::solve(&scene)?;
        residual = residual.max(exact.residual);
        let row = row(study.root, name, &scene, &exact)?;
        let drawn = Curves::exact(&scene, &exact);
        drawings.push((row.figure.clone(), curves(&scene, &drawn, "exact solution")?, exact::table(&drawn)));
        rows.push(row);
    }
    let sum = |of: fn(&Routes) -> usize| rows.iter().map(|row| of(&row.routes)).sum();
    let unknowns = || rows.iter().map(|row| row.unknowns);
    let exact = rows.iter().filter(|row| row.status == Status::Certified.word()).count();
    let values = Values {
        verdicts: vec![on_the_first_screen(&rows, exact)],
        exact,
        fewest: unknowns().min().unwrap_or(0),
        most: unknowns().max().unwrap_or(0),
        coarse: routes::INTERVALS,
        routes: sum(|routes| routes.of),
        certified: sum(|routes| routes.certified),
        four_step_routes: sum(|routes| routes.four_step_of),
        four_step_certified: sum(|routes| routes.four_step),
        targets: required::TARGETS.map(numbers::bound),
        cap: required::MOST,
        capped: rows.iter().any(|row| row.required.is_capped()),
        refused: rows.iter().any(|row| row.required.is_refused()),
        residual: numbers::bound(residual),
        rows,
    };
    Ok(drawings.into_iter().fold(Evidence::new(values), |with, (name, svg, csv)| with.figure(&name, svg, csv)))
}

/// What the first screen says.
fn on_the_first_screen(rows: &[Row], exact: usize) -> verdict::Row {
    let unknowns: Vec<String> = rows
        .iter()
        .map(|row| row.unknowns)
        .fold([usize::MAX, 0], |[least, most], n| [least.min(n), most.max(n)])
        .iter()
        .map(usize::to_string)
        .collect();
    verdict::Row {
        what: "Beam theory for any scene".to_owned(),
        paper: "beam theory to compare with, on a flat foundation".to_owned(),
        now: format!(
            "{exact} of {} scenes exact and checked everywhere, with {} unknowns",
            rows.len(),
            unknowns.join(" to ")
        ),
        verdict: if exact == rows.len() { "extended" } else { "not always found" },
        section: "gallery",
    }
}

fn row(root: &Path, name: String, scene: &Scene, exact: &Exact) -> Result<Row, Cause> {
    let unit = |label: Option<&String>| label.map_or_else(String::new, |label| format!(" {label}"));
    let units = scene.units();
    let moment = units.force.as_ref().zip(units.length.as_ref()).map(|(force, length)| format!("{force}·{length}"));
    let state = &exact.state;
    Ok(Row {
        title: scene.title().to_owned(),
        story: story(&fs::read_to_string(root.join(format!("report/scenes/{name}.toml")))?),
        figure: format!("scene-{name}"),
        name,
        status: exact.status.word(),
        regime: match state.regime {
            Regime::None => "no contact",
            Regime::Points => "single points",
            Regime::Zone => "zones",
        },
        unknowns: exact.unknowns,
        length: unit(units.length.as_ref()),
        force: unit(units.force.as_ref()),
        energy_unit: unit(moment.as_ref()),
        moment: unit(moment.as_ref()),
        contacts: state.contacts.iter().map(touch).collect(),
        inside: exact.forces_inside_zones().map(|(at, force)| [at, force]).collect(),
        left: state.reactions.left,
        right: state.reactions.right,
        couples: exact.support_couples,
        contact_force: state.contact_force(),
        energy: state.energy,
        deflection: span(&state.deflection),
        bending: span(&state.moment),
        required: required::required(scene, exact)?,
        routes: routes::judged(scene)?,
    })
}

fn touch(contact: &Contact) -> Touch {
    let &Contact { from, to, force, end_forces } = contact;
    Touch { from, to, point: end_forces.is_none(), force, ends: end_forces.unwrap_or_default() }
}

fn span(extremes: &Extremes) -> Span {
    Span { max: [extremes.max, extremes.max_at], min: [extremes.min, extremes.min_at] }
}

/// The comment at the head of a scene file.
fn story(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim).collect();
    lines.join(" ")
}

#[cfg(test)]
mod tests {
    use super::story;

    #[test]
    fn a_story_is_the_comment_at_the_head() {
        assert_eq!(story("# One.\n# Two.\ntitle = \"a\"\n# no\n"), "One. Two.");
    }
}
