//! The gallery: the exact solution of every scene file as a card, what it required, and which discrete routes are certified.

mod card;
mod closed;
mod required;

use std::fs;

use minijinja::context;
use palkki::plot::{Curves, curves};
use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::state::Regime;
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, solve, theory};

use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::{bound, cell};
use crate::report::study::Study;
use crate::report::table::Table;
use crate::report::{exact, scenes};

/// The paper's grid, on which every solver has a chance.
const INTERVALS: usize = palkki_evidence::paper::INTERVALS;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut overview = Table::new([
        "scene",
        "contact",
        "unknowns",
        "left reaction",
        "right reaction",
        "contact force",
        "unit of force",
    ]);
    let [coarse, fine] = required::TARGETS.map(bound);
    let mut grids = Table::new([
        "scene".to_owned(),
        "beam theory".to_owned(),
        format!("differences, {coarse}"),
        format!("differences, {fine}"),
        format!("energy methods, {coarse}"),
        format!("energy methods, {fine}"),
    ]);
    let (mut cards, mut drawings, mut runs, mut unknowns) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut residual, mut certified, mut capped, mut refused) = (0.0_f64, 0, false, false);
    for (name, scene) in scenes::all(study.root)? {
        let exact = theory::solve(&scene)?;
        let verdict = Verdict::of_exact(&scene, &exact, &Demand::default());
        residual = residual.max(exact.residual);
        certified += usize::from(verdict.status == Status::Certified);
        unknowns.push(exact.unknowns);
        let state = &exact.state;
        let force = scene.load().magnitude(scene.beam().length());
        let regime = match state.regime {
            Regime::None => "none",
            Regime::Points => "points",
            Regime::Zone => "zones",
        };
        let forces = [state.reactions.left, state.reactions.right, state.contact_force()];
        let [left, right, contact] = forces.map(|value| value_of(value, force, 5));
        let unit = scene.units().force.clone().unwrap_or_else(|| "any".to_owned());
        let link = format!("[{}](#{name})", scene.title());
        overview = overview.row([link, regime.to_owned(), exact.unknowns.to_string(), left, right, contact, unit]);

        let searched = required::required(&scene, &exact)?;
        (capped, refused) = (capped | searched.capped, refused | searched.refused);
        grids = grids.row(std::iter::once(scene.title().to_owned()).chain(searched.cells));
        runs.extend(routes(&name, &scene)?);

        let story = story(&fs::read_to_string(study.root.join(format!("report/scenes/{name}.toml")))?);
        cards.push(card::card(&name, &scene, &exact, &verdict, story)?);
        let drawn = Curves::exact(&scene, &exact);
        drawings.push((format!("scene-{name}"), curves(&scene, &drawn, "exact solution")?, exact::table(&drawn)));
    }
    let four_step = |run: &&Vec<String>| run[2] == Solver::FourStep.word();
    let is_certified = |run: &&Vec<String>| run[3] == Status::Certified.word();
    let others = || runs.iter().filter(|run| !four_step(run));
    let values = context! {
        count => cards.len(),
        exact => certified,
        fewest => unknowns.iter().min(),
        most => unknowns.iter().max(),
        residual => bound(residual),
        overview,
        required => grids,
        targets => required::TARGETS.map(bound),
        coarsest => required::COARSEST - 1,
        cap => required::MOST,
        capped,
        refused,
        intervals => INTERVALS,
        routes => others().count(),
        certified => others().filter(is_certified).count(),
        not_certified => others().filter(|run| !is_certified(run)).map(|run| run.join(" ")).collect::<Vec<_>>(),
        four_step_routes => runs.iter().filter(four_step).count(),
        four_step_certified => runs.iter().filter(four_step).filter(is_certified).count(),
        cards,
    };
    let routes = csv(&["scene", "method", "solver", "status", "solver_reports"], runs);
    let with = Evidence::new(values).data("scene-routes", routes);
    Ok(drawings.into_iter().fold(with, |with, (name, svg, csv)| with.figure(&name, svg, csv)))
}

/// Every method with every solver on a scene: names, status, and whether the solver reports success.
fn routes(name: &str, scene: &Scene) -> Result<Vec<Vec<String>>, Cause> {
    let mut rows = Vec::new();
    for method in Method::ALL {
        for solver in Solver::ALL {
            let outcome = solve(scene, &Settings::new(method, solver, INTERVALS))?;
            let reports = if outcome.solver_claims_success { "success" } else { "failure" };
            rows.push([name, method.word(), solver.word(), outcome.status.word(), reports].map(str::to_owned).to_vec());
        }
    }
    Ok(rows)
}

/// A number of a table to some significant digits; `0` for what is rounding beside `scale`.
fn value_of(value: f64, scale: f64, digits: usize) -> String {
    if value.abs() <= 1e-9 * scale { "0".to_owned() } else { cell(Some(value), digits) }
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
