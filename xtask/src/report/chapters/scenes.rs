//! Every scene file of the report: contacts, reactions, extremes, and which routes are certified.

mod extremes;

use std::fs;
use std::path::Path;

use palkki::plot::{Curves, curves};
use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::state::{Contact, ContactState, Extremes, Regime};
use palkki::{Settings, solve};
use serde::Serialize;

use self::extremes::nodal;
use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::scenes;
use crate::report::study::Study;

/// For the figures: a grid with nodes at all kinks of these scenes.
const INTERVALS: usize = 240;
/// For the routes: the paper's grid, on which every solver has a chance.
const COARSE: usize = palkki::paper::INTERVALS;

#[derive(Debug, Serialize)]
struct Values {
    intervals: usize,
    coarse: usize,
    rows: Vec<Row>,
    /// Routes that are meant to reach the optimum, on all scenes together, and how many are certified.
    routes: usize,
    certified: usize,
    /// The same for the four steps.
    four_step_routes: usize,
    four_step_certified: usize,
}

#[derive(Debug, Serialize)]
struct Row {
    name: String,
    title: String,
    /// What the scene file says of itself.
    story: String,
    figure: String,
    regime: &'static str,
    length: String,
    force: String,
    moment: String,
    contacts: Vec<Touch>,
    left: f64,
    right: f64,
    contact_force: f64,
    deflection: [f64; 2],
    largest_moment: [f64; 2],
    least_moment: [f64; 2],
    certified: usize,
    routes: usize,
    four_step: usize,
    four_step_routes: usize,
    /// Routes meant to reach the optimum that the judge does not certify, and whether they claim success.
    failed: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Touch {
    from: f64,
    to: f64,
    point: bool,
    force: f64,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut rows = Vec::new();
    let mut drawings = Vec::new();
    for (name, scene) in scenes::all(study.root)? {
        let mut state = solve(&scene, &Settings::new(Method::Force, Solver::ActiveSet, INTERVALS))?.state;
        (state.deflection, state.moment) = nodal(&state);
        let row = row(study.root, name, &scene, &state)?;
        let svg = curves(&scene, &Curves::of(&scene, &state)?, &format!("force method, {INTERVALS} intervals"))?;
        drawings.push((row.figure.clone(), svg, table(&state)));
        rows.push(row);
    }
    let sum = |of: fn(&Row) -> usize| rows.iter().map(of).sum();
    let values = Values {
        intervals: INTERVALS,
        coarse: COARSE,
        routes: sum(|row| row.routes),
        certified: sum(|row| row.certified),
        four_step_routes: sum(|row| row.four_step_routes),
        four_step_certified: sum(|row| row.four_step),
        rows,
    };
    Ok(drawings.into_iter().fold(Evidence::new(values), |with, (name, svg, csv)| with.figure(&name, svg, csv)))
}

fn row(root: &Path, name: String, scene: &Scene, state: &ContactState) -> Result<Row, Cause> {
    let ([certified, routes], failed) = judged(scene, &Solver::OPTIMAL)?;
    let ([four_step, four_step_routes], _) = judged(scene, &[Solver::FourStep])?;
    let unit = |label: Option<&String>| label.map_or_else(String::new, |label| format!(" {label}"));
    let units = scene.units();
    let moment = units.force.as_ref().zip(units.length.as_ref()).map(|(force, length)| format!("{force}·{length}"));
    let touch = |c: &Contact| Touch { from: c.from, to: c.to, point: c.from.total_cmp(&c.to).is_eq(), force: c.force };
    let greatest = |e: &Extremes| [e.max, e.max_at];
    Ok(Row {
        title: scene.title().to_owned(),
        story: story(&fs::read_to_string(root.join(format!("report/scenes/{name}.toml")))?),
        figure: format!("scene-{name}"),
        name,
        regime: match state.regime {
            Regime::None => "no contact",
            Regime::Points => "single points",
            Regime::Zone => "zones",
        },
        length: unit(units.length.as_ref()),
        force: unit(units.force.as_ref()),
        moment: unit(moment.as_ref()),
        contacts: state.contacts.iter().map(touch).collect(),
        left: state.reactions.left,
        right: state.reactions.right,
        contact_force: state.contact_force(),
        deflection: greatest(&state.deflection),
        largest_moment: greatest(&state.moment),
        least_moment: [state.moment.min, state.moment.min_at],
        certified,
        routes,
        four_step,
        four_step_routes,
        failed,
    })
}

/// How many routes are certified, how many there are, and which are not.
fn judged(scene: &Scene, solvers: &[Solver]) -> Result<([usize; 2], Vec<String>), Cause> {
    let mut counts = [0, 0];
    let mut failed = Vec::new();
    for method in Method::ALL {
        for &solver in solvers {
            let outcome = solve(scene, &Settings::new(method, solver, COARSE))?;
            counts = [counts[0] + usize::from(outcome.status == Status::Certified), counts[1] + 1];
            if outcome.status != Status::Certified {
                let word = if outcome.solver_claims_success { "success" } else { "failure" };
                failed.push(format!("{solver} on the {method} method (it reports {word})"));
            }
        }
    }
    Ok((counts, failed))
}

/// The comment at the head of a scene file.
fn story(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim).collect();
    lines.join(" ")
}

fn table(state: &ContactState) -> String {
    let nodes = state.nodes.clone().unwrap_or_default();
    let rows = nodes.x.iter().enumerate().map(|(i, &x)| {
        let columns = [x, nodes.deflection[i], nodes.clearance[i], nodes.contact_force[i], nodes.moment[i]];
        columns.map(|value| if value.is_finite() { fixed(value, 5) } else { String::new() }).to_vec()
    });
    csv(&["x", "deflection", "clearance", "contact_force", "moment"], rows)
}

#[cfg(test)]
mod tests {
    use super::story;

    #[test]
    fn a_story_is_the_comment_at_the_head() {
        assert_eq!(story("# One.\n# Two.\ntitle = \"a\"\n# no\n"), "One. Two.");
    }
}
