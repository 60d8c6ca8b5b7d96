//! Guaranteed bounds for the continuous beam beside the true errors, on every scene of the gallery; and for contact forces
//! that were computed with the load lumped at the nodes: by the paper, and by springs instead of a rigid foundation. What
//! `palkki certify` finds about them, told that the load is nodal and not told.

use nalgebra::{DMatrix, DVector};
use palkki::certificate::{
    ContactLoad, Judged, Lumped, Violation, ViolationKind, certify, violations, violations_at_nodes,
};
use palkki::methods::Discrete;
use palkki::qp::Dense;
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
    let springs = of_springs()?;
    let first_stiff = springs.iter().find(|spring| spring.accepted()).ok_or("some springs are stiff enough")?.exponent;
    let paper = of_the_paper()?;
    let values = context! {
        table,
        runs => data.len(),
        held, sharp,
        accepted => USABLE,
        sags => sags()?,
        forces => of_forces(paper.iter().chain(&springs)),
        spaced => SPACED,
        first_stiff => power_of_ten(first_stiff),
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

/// Intervals between springs.
const SPACED: usize = 60;
/// Stiffness of a spring over that of the beam, powers of ten.
const STIFFNESSES: [i32; 7] = [0, 1, 2, 3, 4, 6, 8];
/// Violations below this share are rounding.
const ROUNDING: f64 = 1e-9;

/// What is found about some forces. Errors are shares of the largest deflection, infinite if nothing could be shown.
#[derive(Debug)]
struct Found {
    /// Whose they are.
    who: String,
    /// Power of ten of a spring's stiffness over that of the beam; 0 if there is none.
    exponent: i32,
    /// Guaranteed error of the deflection, where the load is taken to be distributed, and where it is known to be nodal.
    errors: [f64; 2],
    /// Whether either is accepted.
    accepted: [bool; 2],
    /// What the forces violate most: under the distributed load, and at the nodes under the nodal loads.
    worst: [Option<Violation>; 2],
}

impl Found {
    fn of(scene: &Scene, who: String, forces: &[(f64, f64)]) -> Result<Self, Cause> {
        let length = scene.beam().length();
        let lumped = Lumped::new(scene, forces.iter().copied())?;
        let load = ContactLoad::new(length, forces.iter().copied())?;
        let contacts = theory::solve(scene)?.state.contacts;
        let certificates = [
            certify(scene, Judged::Forces(&load), &contacts)?,
            certify(scene, Judged::Nodes(&lumped.nodes), &contacts)?,
        ];
        Ok(Self {
            who,
            exponent: 0,
            errors: certificates.each_ref().map(|c| c.deflection_error / c.deflection),
            accepted: certificates.clone().map(|c| Verdict::of_forces(scene, c).status == Status::Certified),
            worst: [violations(scene, &load)?, violations_at_nodes(&lumped)].map(|all| all.into_iter().next()),
        })
    }

    /// Accepted where it is known that the load is nodal.
    fn accepted(&self) -> bool {
        self.accepted[1]
    }
}

/// The paper's own forces.
fn of_the_paper() -> Result<Vec<Found>, Cause> {
    let found =
        |name: &str, nodes: &Nodes| Found::of(&paper::example()?, format!("the paper's {name}"), &of_nodes(nodes));
    Ok(vec![
        found("Figure 4, finite differences", &paper::figure_4()?.nodes)?,
        found("Figure 7, force method", &paper::figure_7()?.nodes)?,
    ])
}

/// Springs of several stiffnesses.
fn of_springs() -> Result<Vec<Found>, Cause> {
    let scene = paper::example()?;
    let found = |&exponent: &i32| {
        let forces = spring_forces(&scene, SPACED, 10_f64.powi(exponent))?;
        let who = format!("springs, {} × the beam", power_of_ten(exponent));
        Ok(Found { exponent, ..Found::of(&scene, who, &forces)? })
    };
    STIFFNESSES.iter().map(found).collect()
}

/// What is found about the forces of the paper and of springs.
fn of_forces<'a>(all: impl Iterator<Item = &'a Found>) -> Table {
    let header =
        ["forces", "error if not told", "error with `--load nodal`", "accepted", "worst violation at the nodes"];
    Table::new(header).rows(all.map(|found| {
        let accepted = format!("{}, then {}", yes_no(found.accepted[0]), yes_no(found.accepted[1]));
        let [not_told, told] = found.errors.map(|e| cell(Some(e), 2));
        row![found.who, not_told, told, accepted, words(found.worst[1])]
    }))
}

/// How much deeper the forces of the force method let the beam sag under the distributed load: by the formula, and found.
fn sags() -> Result<Table, Cause> {
    let scene = paper::example()?;
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let mut table = Table::new(["intervals", "q Δ² l²/(96 EI)", "over the largest deflection", "violation found"]);
    for intervals in [paper::INTERVALS, SPACED] {
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
    let length = beam.length();
    let spring = ratio * 48.0 * beam.bending_stiffness() / (length * length * length);
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let rigid = Method::Force.qp(&discrete);
    let (n, flexibility) = (rigid.dimension(), rigid.matrix());
    let softness = |i: usize, j: usize| if i == j { 1.0 / spring } else { 0.0 };
    let qp = Dense {
        matrix: DMatrix::from_fn(n, n, |i, j| flexibility.entry(i, j) + softness(i, j)),
        linear: DVector::from_vec(rigid.linear()),
        sizes: rigid.sizes(),
    };
    let answer = Solver::ActiveSet.run(&qp, 0.0);
    if !answer.reports_success {
        return Err(format!("springs of ratio {ratio}: {}", answer.words).into());
    }
    let scale = &scaled.scale;
    let place = |i: usize| discrete.grid.place(i + 1) * scale.length;
    Ok(answer.x.iter().enumerate().map(|(i, force)| (place(i), force * scale.force)).collect())
}
