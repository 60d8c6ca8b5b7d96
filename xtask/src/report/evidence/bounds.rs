//! Guaranteed bounds for the continuous beam beside the true errors, on every scene of the gallery; and for contact forces
//! that were computed with the load lumped at the nodes: by the paper, by springs instead of a rigid foundation, and by
//! libraries. What `palkki certify` finds about them, told that the load is nodal and not told.

use nalgebra::{DMatrix, DVector};
use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::{
    ContactLoad, Judged, Lumped, Violation, ViolationKind, certify, violations, violations_at_nodes,
};
use palkki::methods::Discrete;
use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
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
    let (svg, springs_data) = figure(&springs, first_stiff)?;
    let paper = of_the_paper()?;
    let (libraries, met, passed, accepted) = of_libraries(study)?;
    let values = context! {
        table,
        runs => data.len(),
        held, sharp,
        accepted => USABLE,
        sags => sags()?,
        forces => of_forces(paper.iter().chain(&springs)),
        spaced => SPACED,
        first_stiff => power_of_ten(first_stiff),
        libraries => libraries,
        library_runs => context! { met, passed, accepted },
    };
    Ok(Evidence::new(values).data("bounds", data).figure("springs", svg, springs_data))
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
/// Intervals of the runs of libraries, and what they are asked for: little, and as much as by default.
const LIBRARY_INTERVALS: usize = 256;
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
    /// Error of the end reaction of the example, as a share.
    reaction: f64,
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
        // The example is symmetrical: an end reaction is half of what the forces leave.
        let carried: f64 = forces.iter().map(|f| f.1).sum();
        Ok(Self {
            who,
            exponent: 0,
            errors: certificates.each_ref().map(|c| c.deflection_error / c.deflection),
            accepted: certificates.clone().map(|c| Verdict::of_forces(scene, c).status == Status::Certified),
            worst: [violations(scene, &load)?, violations_at_nodes(&lumped)].map(|all| all.into_iter().next()),
            reaction: (0.5 * (scene.load().resultant(length) - carried) / paper::theory().reaction - 1.0).abs(),
        })
    }

    /// Accepted where it is known that the load is nodal.
    fn accepted(&self) -> bool {
        self.accepted[1]
    }

    /// The guaranteed error where it is known that the load is nodal.
    fn error(&self) -> f64 {
        self.errors[1]
    }

    /// The worst violation at the nodes.
    fn violation(&self) -> f64 {
        self.worst[1].map_or(0.0, |v| v.relative)
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

/// Libraries asked for little and for much, on the cosine wave; how many did what they were asked, how many pass our check,
/// and how many are accepted.
fn of_libraries(study: &Study<'_>) -> Result<(Table, usize, usize, usize), Cause> {
    let wave = scenes::read(study.root, "wave")?;
    let header =
        ["library, method", "asked for", "did what it was asked", "passes our check", "certified error", "accepted"];
    let mut table = Table::new(header);
    let (mut met, mut passed, mut accepted) = (0, 0, 0);
    for (method, solver, tolerance) in RUNS {
        let settings = Settings { tolerance, ..Settings::new(method, solver, LIBRARY_INTERVALS) };
        let outcome = solve_raw(&wave, &settings)?;
        let own = outcome.own_residual.ok_or("a library has a residual of its own")?;
        let certified = outcome.solved;
        let found = Found::of(&wave, String::new(), &of_nodes(&outcome.state.nodes.unwrap_or_default()))?;
        met += usize::from(own.is_met());
        passed += usize::from(certified);
        accepted += usize::from(found.accepted());
        let [is_met, passes, is_accepted] = [own.is_met(), certified, found.accepted()].map(yes_no);
        let error = cell(Some(found.error()), 2);
        table.push(row![format!("{solver}, {method}"), bound(own.asked), is_met, passes, error, is_accepted]);
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
        ViolationKind::Balance => "forces out of balance",
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

/// The figure of the springs, of which the first that are accepted have the stiffness 10ᵏ, and its numbers.
fn figure(springs: &[Found], first_stiff: i32) -> Result<(String, Table), PlotError> {
    let line =
        |value: fn(&Found) -> f64| springs.iter().map(|s| [10_f64.powi(s.exponent), value(s)]).collect::<Vec<_>>();
    let lines = [
        ("certified error of the deflection", line(Found::error)),
        ("worst violation at the nodes", line(Found::violation)),
        ("true error of the end reaction", line(|s| s.reaction)),
    ];
    let x = Axis::new("stiffness of a spring over that of the beam, k l³/48EI").log();
    let mut panel = Panel::new(x, Axis::new("relative error").log()).tall(700.0);
    let mut data = Table::new(["quantity", "stiffness_ratio", "relative_error"]);
    for (i, (label, points)) in lines.into_iter().enumerate() {
        data = data.rows(points.iter().map(|p| row![label, scientific(p[0], 0), scientific(p[1], 2)]));
        panel = panel.with(Layer::Series { points, style: Style::of_series(i), label: label.to_owned() });
    }
    let svg = Figure::new(
        format!("Springs are accepted from {} times the stiffness of the beam on", power_of_ten(first_stiff)),
        "Relative errors over the stiffness of the springs, both axes logarithmic. The violation at the nodes falls in proportion; \
         the certified error and the error of the end reaction fall until the error of the grid is left.",
        vec![panel],
    )
    .svg()?;
    Ok((svg, data))
}
