//! Contact forces that were computed with the load lumped at the nodes: by the paper, by springs instead of a rigid
//! foundation, and by libraries. What `palkki certify` finds about them, told that the load is nodal and not told.

use palkki::certificate::{Violation, ViolationKind, violations, violations_at_nodes};
use palkki::certificate::{ContactLoad, Judged, Lumped, certify};
use palkki::methods::Method;
use palkki::route::Status;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki::verdict::accepts;
use palkki::{DEFAULT_TOLERANCE, Settings, solve};
use palkki_evidence::paper::{example, figure_4, figure_7, theory};

use super::springs;
use crate::report::error::Cause;
use crate::report::numbers::{bound, cell, power};
use crate::report::scenes;
use crate::report::study::Study;
use crate::report::table::Table;

/// Intervals between springs.
pub(super) const SPACED: usize = 60;
/// Stiffness of a spring over that of the beam, powers of ten.
const STIFFNESSES: [i32; 7] = [0, 1, 2, 3, 4, 6, 8];
/// Intervals of the runs of libraries, and what they are asked for: little, and as much as by default.
const INTERVALS: usize = 256;
const RUNS: [(Method, Solver, f64); 4] = [
    (Method::Displacement, Solver::Clarabel, 1e-2),
    (Method::Displacement, Solver::Clarabel, DEFAULT_TOLERANCE),
    (Method::Force, Solver::Osqp, 1e-3),
    (Method::Complementarity, Solver::Osqp, DEFAULT_TOLERANCE),
];
/// Violations below this share are rounding.
const ROUNDING: f64 = 1e-9;

/// What is found about some forces. Errors are shares of the largest deflection, infinite if nothing could be shown.
#[derive(Debug)]
pub(super) struct Found {
    /// Whose they are.
    who: String,
    /// Power of ten of a spring's stiffness over that of the beam; 0 if there is none.
    pub(super) exponent: i32,
    /// Guaranteed error of the deflection, where the load is taken to be distributed, and where it is known to be nodal.
    errors: [f64; 2],
    /// Whether either is accepted.
    accepted: [bool; 2],
    /// What the forces violate most: under the distributed load, and at the nodes under the nodal loads.
    worst: [Option<Violation>; 2],
    /// Error of the end reaction of the example, as a share.
    pub(super) reaction: f64,
}

impl Found {
    fn of(scene: &Scene, who: String, forces: &[(f64, f64)]) -> Result<Self, Cause> {
        let length = scene.beam().length();
        let lumped = Lumped::new(scene, forces.iter().copied())?;
        let load = ContactLoad::new(length, forces.iter().copied())?;
        let contacts = palkki::theory::solve(scene)?.state.contacts;
        let certificates =
            [Judged::Forces(&load), Judged::Nodes(&lumped.nodes)].map(|judged| certify(scene, judged, &contacts));
        let certificates = {
            let [one, other] = certificates;
            [one?, other?]
        };
        // The example is symmetrical: an end reaction is half of what the forces leave.
        let carried: f64 = forces.iter().map(|f| f.1).sum();
        Ok(Self {
            who,
            exponent: 0,
            errors: [&certificates[0], &certificates[1]].map(|c| c.deflection_error / c.deflection),
            accepted: [&certificates[0], &certificates[1]].map(accepts),
            worst: [violations(scene, &load)?, violations_at_nodes(&lumped)].map(|all| all.into_iter().next()),
            reaction: (0.5 * (scene.load().resultant(length) - carried) / theory().reaction - 1.0).abs(),
        })
    }

    /// Accepted where it is known that the load is nodal.
    pub(super) fn accepted(&self) -> bool {
        self.accepted[1]
    }

    /// The guaranteed error where it is known that the load is nodal.
    pub(super) fn error(&self) -> f64 {
        self.errors[1]
    }

    /// The worst violation at the nodes.
    pub(super) fn violation(&self) -> f64 {
        self.worst[1].map_or(0.0, |v| v.relative)
    }
}

/// The paper's own forces.
pub(super) fn of_the_paper() -> Result<Vec<Found>, Cause> {
    let found = |name: &str, nodes: &Nodes| Found::of(&example()?, format!("the paper's {name}"), &of_nodes(nodes));
    Ok(vec![
        found("Figure 4, finite differences", &figure_4()?.nodes)?,
        found("Figure 7, force method", &figure_7()?.nodes)?,
    ])
}

/// Springs of several stiffnesses.
pub(super) fn of_springs() -> Result<Vec<Found>, Cause> {
    let scene = example()?;
    let found = |&exponent: &i32| {
        let forces = springs::forces(&scene, SPACED, 10_f64.powi(exponent))?;
        let who = format!("springs, {} × the beam", power(exponent));
        Ok(Found { exponent, ..Found::of(&scene, who, &forces)? })
    };
    STIFFNESSES.iter().map(found).collect()
}

/// What is found about the forces of the paper and of springs.
pub(super) fn table<'a>(all: impl Iterator<Item = &'a Found>) -> Table {
    let header =
        ["forces", "error if not told", "error with `--load nodal`", "accepted", "worst violation at the nodes"];
    let yes = |accepted| if accepted { "yes" } else { "no" };
    all.fold(Table::new(header), |table, found| {
        let accepted = format!("{}, then {}", yes(found.accepted[0]), yes(found.accepted[1]));
        let [not_told, told] = found.errors.map(|e| cell(Some(e), 2));
        table.row([found.who.clone(), not_told, told, accepted, words(found.worst[1])])
    })
}

/// How much deeper the forces of the force method let the beam sag under the distributed load: by the formula, and found.
pub(super) fn sags() -> Result<Table, Cause> {
    let scene = example()?;
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let mut table = Table::new(["intervals", "q Δ² l²/(96 EI)", "over the largest deflection", "violation found"]);
    for intervals in [palkki_evidence::paper::INTERVALS, SPACED] {
        let state = solve(&scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals))?.state;
        let forces = of_nodes(&state.nodes.ok_or("an answer has nodes")?);
        let worst = violations(&scene, &ContactLoad::new(length, forces)?)?.into_iter().next();
        #[expect(clippy::cast_precision_loss, reason = "few intervals")]
        let width = length / intervals as f64;
        let sag = scene.load().uniform() * width * width * length * length / (96.0 * stiffness);
        let depth = scene.depth(0.5 * length);
        let numbers = [Some(sag / depth), Some(sag / (depth + sag)), worst.map(|v| v.relative)];
        table = table.row(std::iter::once(intervals.to_string()).chain(numbers.map(|n| cell(n, 3))));
    }
    Ok(table)
}

/// Libraries asked for little and for much, on the cosine wave; how many did what they were asked, how many pass our check,
/// and how many are accepted.
pub(super) fn of_libraries(study: &Study<'_>) -> Result<(Table, usize, usize, usize), Cause> {
    let wave = scenes::read(study.root, "wave")?;
    let header =
        ["library, method", "asked for", "did what it was asked", "passes our check", "certified error", "accepted"];
    let mut table = Table::new(header);
    let (mut met, mut passed, mut accepted) = (0, 0, 0);
    for (method, solver, tolerance) in RUNS {
        let settings = Settings { tolerance, ..Settings::new(method, solver, INTERVALS) };
        let outcome = solve(&wave, &settings)?;
        let own = outcome.own_residual.ok_or("a library has a residual of its own")?;
        let certified = outcome.status == Status::Certified;
        let found = Found::of(&wave, String::new(), &of_nodes(&outcome.state.nodes.unwrap_or_default()))?;
        met += usize::from(own.is_met());
        passed += usize::from(certified);
        accepted += usize::from(found.accepted());
        let yes = |is: bool| if is { "yes" } else { "no" }.to_owned();
        table = table.row([
            format!("{solver}, {method}"),
            bound(own.asked),
            yes(own.is_met()),
            yes(certified),
            cell(Some(found.error()), 2),
            yes(found.accepted()),
        ]);
    }
    Ok((table, met, passed, accepted))
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
