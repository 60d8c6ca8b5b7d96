//! Guaranteed bounds for the continuous beam beside the true errors, on every scene of the gallery; and for contact forces
//! that were computed with the load lumped at the nodes: those of the paper. What `palkki certify` finds about
//! them, told that the load is nodal and not told.

use palkki::certificate::{
    ContactLoad, Judged, Lumped, Violation, ViolationKind, certify, violations, violations_at_nodes,
};
use palkki::state::Nodes;
use palkki::verdict::{USABLE, Verdict};
use palkki_evidence::faults::{THEORY, Truth};
use palkki_evidence::paper;

use super::prelude::*;

/// Grids of the table.
const GRIDS: [usize; 3] = [30, 100, 300];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let header = GRIDS.iter().flat_map(|n| [format!("{n}, true"), format!("{n}, certified")]);
    let mut table = Table::new(row!["scene"].into_iter().chain(header));
    let mut data = Table::new(["scene", "intervals", "true_error", "certified_error"]);
    let (mut held, mut sharp) = (0, 0);
    for (_, scene) in scenes::all(study.root)? {
        let mut row = row![scene.title()].to_vec();
        for intervals in GRIDS {
            let [truth, certified] = errors(&scene, intervals)?;
            data.push(row![scene.title(), intervals, scientific(truth, 2), scientific(certified, 2)]);
            row.extend([if truth == 0.0 { "0".to_owned() } else { cell(Some(truth), 2) }, cell(Some(certified), 2)]);
            held += usize::from(truth <= certified);
            sharp += usize::from(certified <= 1.1 * truth);
        }
        table.push(row);
    }
    let values = context! {
        table,
        runs => data.len(),
        held, sharp,
        accepted => USABLE,
        sags => sags()?,
        forces => of_the_paper()?,
    };
    Ok(Evidence::new(values).data("bounds", data))
}

/// The force method with the active set on one grid: how far its deflection is from beam theory, and how far it can be, over
/// the largest deflection.
fn errors(scene: &Scene, intervals: usize) -> Result<[f64; 2], Cause> {
    let truth = Truth::of(scene)?;
    let state = on_grid(scene, Method::Force, Solver::ActiveSet, intervals)?.state;
    let found = state.nodes.as_ref().and_then(|nodes| truth.nodes(nodes)).ok_or("an answer has nodes")?;
    let [error, certified] = [found.error, found.certificate.deflection_error].map(|e| e / truth.deflection);
    // Digits of an error that is rounding differ between machines.
    Ok([if error < THEORY { 0.0 } else { error }, certified])
}

/// Violations below this share are rounding.
const ROUNDING: f64 = 1e-9;

/// What is found about the paper's own forces: where the load is taken to be distributed, and where it is known to be nodal.
fn of_the_paper() -> Result<Table, Cause> {
    let scene = paper::example()?;
    let contacts = theory::solve(&scene)?.state.contacts;
    let header =
        ["forces", "error if not told", "error with `--load nodal`", "accepted", "worst violation at the nodes"];
    let mut table = Table::new(header);
    for (who, nodes) in [
        ("Figure 4, finite differences", paper::figure_4()?.nodes),
        ("Figure 7, force method", paper::figure_7()?.nodes),
    ] {
        let forces = of_nodes(&nodes);
        let lumped = Lumped::new(&scene, forces.iter().copied())?;
        let load = ContactLoad::new(scene.beam().length(), forces)?;
        let certificates = [
            certify(&scene, Judged::Forces(&load), &contacts)?,
            certify(&scene, Judged::Nodes(&lumped.nodes), &contacts)?,
        ];
        let [not_told, told] = certificates.each_ref().map(|c| cell(Some(c.deflection_error / c.deflection), 2));
        let [first, then] = certificates.map(|c| yes_no(Verdict::of_forces(&scene, c).status == Status::Certified));
        let worst = violations_at_nodes(&lumped).into_iter().next();
        table.push(row![who, not_told, told, format!("{first}, then {then}"), words(worst)]);
    }
    Ok(table)
}

/// How much deeper the forces of the force method let the beam sag under the distributed load: by the formula, and found.
fn sags() -> Result<Table, Cause> {
    let scene = paper::example()?;
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let mut table = Table::new(["intervals", "q Δ² l²/(96 EI)", "over the largest deflection", "violation found"]);
    for intervals in [paper::INTERVALS, 2 * paper::INTERVALS] {
        let state = on_grid(&scene, Method::Force, Solver::ActiveSet, intervals)?.state;
        let forces = of_nodes(nodes_of(&state)?);
        let worst = violations(&scene, &ContactLoad::new(length, forces)?)?.into_iter().next();
        let width = length / as_number(intervals);
        let sag = scene.load().uniform() * width * width * length * length / (96.0 * stiffness);
        let depth = scene.depth(0.5 * length);
        let numbers = [Some(sag / depth), Some(sag / (depth + sag)), worst.map(|v| v.relative)];
        table.push(row![intervals].into_iter().chain(numbers.map(|n| cell(n, 3))));
    }
    Ok(table)
}

fn of_nodes(nodes: &Nodes) -> Vec<(f64, f64)> {
    nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect()
}

/// A violation as a share, in words.
fn words(violation: Option<Violation>) -> String {
    let Some(violation) = violation.filter(|v| ROUNDING < v.relative) else { return "none".to_owned() };
    let what = match violation.kind {
        ViolationKind::Tension => "a force pulls",
        ViolationKind::Penetration => "beam in the ground",
        ViolationKind::Complementarity => "force without touching",
    };
    format!("{what}, {}", cell(Some(violation.relative), 2))
}
