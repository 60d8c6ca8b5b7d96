//! Guaranteed bounds for the continuous beam beside the true errors, on every scene of the gallery; and for contact forces
//! that were computed with the load lumped at the nodes: those of the paper, and of springs instead of a rigid foundation. What
//! `palkki certify` finds about them, told that the load is nodal and not told.

use palkki::certificate::{ContactLoad, Judged, Lumped, Violation, ViolationKind, certify, violations_at_nodes};
use palkki::methods::Discrete;
use palkki::qp::{Explicit, Profile};
use palkki::state::Nodes;
use palkki::verdict::{USABLE, Verdict};
use palkki_evidence::authority::RANDOM;
use palkki_evidence::faults::Truth;
use palkki_evidence::paper;

use super::prelude::*;
use crate::certificates::answers::{self, Row};

/// Grids of the table.
const GRIDS: [usize; 3] = [30, 100, 300];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (mut found, mut count) = (GRIDS.map(|_| Vec::new()), 0);
    let mut data = Table::new(["scene", "intervals", "true_error", "certified_error"]);
    let mut held = 0;
    for (_, scene) in scenes::all(study.root)? {
        count += 1;
        let known = Truth::of(&scene)?;
        for (intervals, found) in GRIDS.into_iter().zip(&mut found) {
            let Row { truth, certified, .. } = answers::row("", &known, Method::Force, Solver::ActiveSet, intervals)?;
            data.push(row![scene.title(), intervals, scientific(truth, 2), scientific(certified, 2)]);
            found.push([certified, certified / truth]);
            held += usize::from(truth <= certified);
        }
    }
    let header = ["intervals", "least certified error", "largest", "largest certified over true error"];
    let table = Table::new(header).rows(GRIDS.iter().zip(&found).map(|(intervals, found)| {
        let [error, ratio] = [0, 1].map(|k| range(found.iter().map(|pair| pair[k])));
        let of = |ends: Option<[f64; 2]>, end: usize| ends.map(|ends| ends[end]);
        row![
            intervals,
            cell(of(error, 0), 2),
            cell(of(error, 1), 2),
            of(ratio, 1).map_or("–".to_owned(), |r| fixed(r, 2))
        ]
    }));
    let springs = STIFFNESSES.iter().map(|&exponent| spring(exponent)).collect::<Result<Vec<_>, Cause>>()?;
    let first_stiff = springs.iter().find(|(_, found)| found.accepted[1]).ok_or("some springs are stiff enough")?.0;
    let values = context! {
        table,
        scenes => count,
        runs => data.len(),
        held,
        random => RANDOM,
        accepted => USABLE,
        forces => of_forces(of_the_paper()?.iter().chain(beside(&springs, first_stiff))),
        spaced => SPACED,
        first_stiff => power_of_ten(first_stiff),
    };
    Evidence::new(values).data("bounds", data)
}

/// Violations below this share are rounding.
const ROUNDING: f64 = 1e-9;

/// Intervals between springs.
const SPACED: usize = 2 * paper::INTERVALS;
/// Stiffness of a spring over that of the beam, powers of ten.
const STIFFNESSES: [i32; 7] = [0, 1, 2, 3, 4, 6, 8];

/// What is found about contact forces of the example: where the load is taken to be distributed, and where it is known to be
/// nodal.
struct Found {
    /// Whose they are.
    who: String,
    /// Guaranteed errors of the deflection, over the largest deflection; infinite if nothing could be shown.
    errors: [f64; 2],
    accepted: [bool; 2],
    /// What they violate most at the nodes under the nodal loads.
    worst: Option<Violation>,
}

impl Found {
    fn of(who: &str, forces: &[(f64, f64)]) -> Result<Self, Cause> {
        let scene = paper::example()?;
        let (length, contacts) = (scene.beam().length(), theory::solve(&scene)?.state.contacts);
        let lumped = Lumped::new(&scene, forces.iter().copied())?;
        let load = ContactLoad::new(length, forces.iter().copied())?;
        let certificates = [Judged::Forces(&load), Judged::Nodes(&lumped.nodes)];
        let [not_told, told] = certificates.map(|judged| certify(&scene, judged, &contacts));
        let certificates = [not_told?, told?];
        Ok(Self {
            who: who.to_owned(),
            errors: certificates.each_ref().map(|c| c.deflection_error / c.deflection),
            accepted: certificates.map(|c| Verdict::of_forces(c).status == Status::Certified),
            worst: violations_at_nodes(&lumped).into_iter().next(),
        })
    }
}

fn of_the_paper() -> Result<[Found; 2], Cause> {
    Ok([
        Found::of("Figure 4, finite differences", &of_nodes(&paper::figure_4()?.nodes))?,
        Found::of("Figure 7, force method", &of_nodes(&paper::figure_7()?.nodes))?,
    ])
}

/// Of springs the first that are stiff enough, and those before and behind.
fn beside(springs: &[(i32, Found)], first_stiff: i32) -> impl Iterator<Item = &Found> {
    let near = springs.iter().filter(move |(exponent, _)| (exponent - first_stiff).abs() <= 1);
    near.map(|(_, found)| found)
}

fn of_forces<'a>(all: impl Iterator<Item = &'a Found>) -> Table {
    let header =
        ["forces", "error", "error with `--load nodal`", "accepted without, with it", "maximum violation at the nodes"];
    Table::new(header).rows(all.map(|found| {
        let accepted = format!("{}, {}", yes_no(found.accepted[0]), yes_no(found.accepted[1]));
        let [not_told, told] = found.errors.map(|error| cell(Some(error), 2));
        row![found.who, not_told, told, accepted, words(found.worst)]
    }))
}

fn of_nodes(nodes: &Nodes) -> Vec<(f64, f64)> {
    nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect()
}

/// A violation as a share, in words.
fn words(violation: Option<Violation>) -> String {
    let Some(violation) = violation.filter(|v| ROUNDING < v.relative) else { return "none".to_owned() };
    let what = match violation.kind {
        ViolationKind::Tension => "a force pulls",
        ViolationKind::Penetration => "beam below the foundation",
        ViolationKind::Complementarity => "force without touching",
        ViolationKind::SpringLaw => "force of no spring",
        ViolationKind::Balance => "forces out of balance",
    };
    format!("{what}, {}", cell(Some(violation.relative), 2))
}

/// What is found about springs of 10ᵏ times the stiffness of the beam, with `k`.
fn spring(exponent: i32) -> Result<(i32, Found), Cause> {
    let forces = spring_forces(&paper::example()?, SPACED, ten_to(exponent))?;
    Ok((exponent, Found::of(&format!("springs, {} × the beam", power_of_ten(exponent)), &forces)?))
}

/// Contact forces `(x, force)` by penalty: tensionless springs at the nodes instead of a rigid foundation, as programs for
/// structures do it. `ratio` is the stiffness of one of them over that of the free beam in its middle, `48 EI / l³`.
///
/// A spring of stiffness `k` gives way by `f/k`, so that the clearance of the force method, (28), becomes
///
/// ```text
/// f ≥ 0,  (C + I/k) f + u − C q ≥ 0,  fᵀ((C + I/k) f + u − C q) = 0
/// ```
///
/// the same quadratic program (32) with a matrix that is stiffer on its diagonal.
fn spring_forces(scene: &Scene, intervals: usize, ratio: f64) -> Result<Vec<(f64, f64)>, Cause> {
    let scaled = scene.scaled()?;
    let beam = scaled.scene.beam();
    let spring = ratio * 48.0 * beam.bending_stiffness() / beam.length().powi(3);
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let rigid = Method::Force.qp(&discrete);
    let (n, flexibility) = (rigid.dimension(), rigid.matrix());
    let softness = |i: usize, j: usize| if i == j { 1.0 / spring } else { 0.0 };
    let matrix = Profile::full(n, |i, j| flexibility.entry(i, j) + softness(i, j));
    let qp = Explicit::new(matrix, &rigid.linear())?;
    let answer = Solver::ActiveSet.run(&qp, 0.0);
    if !answer.run.reports_success {
        return Err(format!("springs of ratio {ratio}: {}", answer.run.message).into());
    }
    let scale = &scaled.scale;
    let place = |i: usize| discrete.grid.place(i + 1) * scale.length;
    Ok(answer.x.iter().enumerate().map(|(i, force)| (place(i), force * scale.force)).collect())
}
