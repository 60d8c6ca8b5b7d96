//! Solvers and libraries on bodies whose answers are proven: what each says, how far it is off, and what `certify` says of it.

use palkki::DEFAULT_TOLERANCE;
use palkki::body::proof::{Off, Proof, prove};
use palkki::body::{Body, Verdict};
use palkki::plot::{Axis, Cell, Color, Layer, Panel};
use palkki::qp::{Qp as _, residual};
use palkki::text::{magnitude_at_least, magnitude_at_most};
use palkki::verdict::EXACT;
use palkki_evidence::bodies::{Known, five_diagonal, two_beams, whole};
use palkki_evidence::compare::apart;
use palkki_evidence::random::Random;
use palkki_evidence::slab::Laid;

use super::prelude::*;

/// The bodies of five diagonals, and what a row of them sums to in magnitude, which no eigenvalue exceeds.
const FIVE_DIAGONALS: &str = "five diagonals";
const ROW: f64 = 16.0;

/// Freedoms of the five-diagonal bodies.
const SIZES: [usize; 3] = [100, 1000, 5000];

/// Intervals of the two beams.
const INTERVALS: usize = 30;

/// Random bodies, and the exponent by which their diagonals grow: conditions of up to 10¹⁴.
const RANDOM: usize = 100;
const EXPONENT: usize = 23;

/// The tolerance of both libraries before anybody sets one: 10⁻⁸ is the own one of clarabel and 10⁻³ of osqp when they are asked for
/// this.
const AS_IT_COMES: f64 = 1e-3;

/// An error from which on an answer is called wrong here, over the largest clearance.
const WRONG: f64 = 1e-3;

/// What is tried on up to how many freedoms: beyond, it takes more than a second.
const TRIED: [(Solver, f64, usize); 7] = [
    (Solver::ActiveSet, DEFAULT_TOLERANCE, 5000),
    (Solver::FourStep, DEFAULT_TOLERANCE, 1000),
    (Solver::Nsor, DEFAULT_TOLERANCE, 100),
    (Solver::Clarabel, AS_IT_COMES, 5000),
    (Solver::Clarabel, DEFAULT_TOLERANCE, 5000),
    (Solver::Osqp, AS_IT_COMES, 5000),
    (Solver::Osqp, DEFAULT_TOLERANCE, 100),
];

/// One answer.
struct Run {
    solver: Solver,
    asked: f64,
    message: String,
    says_solved: bool,
    residual: f64,
    clearance: Vec<f64>,
    off: Off,
    /// The largest clearance.
    size: f64,
    certified: bool,
}

impl Run {
    fn new(body: &Body, proof: &Proof, solver: Solver, asked: f64) -> Self {
        let answer = body.run(solver, asked);
        let errors = proof.errors(body, &answer);
        let [clearance, _] = body.clearance_and_force(&answer);
        let off = proof.off(&clearance);
        Self {
            solver,
            asked,
            residual: residual(body.program().sizes(), &answer.x, &answer.gradient),
            message: answer.run.message,
            says_solved: answer.run.reports_success,
            clearance,
            off,
            size: proof.sizes.clearance,
            certified: Verdict::new(Ok(errors), EXACT, true).status == Status::Certified,
        }
    }

    /// At least and at most, over the largest clearance, rounded so that it stays so.
    fn off(&self) -> [String; 2] {
        let shown = |text: String| match text.parse() {
            Ok(value) if value != 0.0 => significant(value, 2),
            _ => text,
        };
        let [least, most] = [self.off.least, self.off.most].map(|off| off / self.size);
        [shown(magnitude_at_least(least)), shown(magnitude_at_most(most))]
    }

    /// Whether it says that it is solved and is wrong for certain.
    fn misleads(&self) -> bool {
        self.says_solved && WRONG * self.size < self.off.least
    }

    fn is_library(&self) -> bool {
        matches!(self.solver, Solver::Clarabel | Solver::Osqp)
    }

    fn own_tolerance(&self) -> String {
        self.solver.own_tolerance(self.asked).map_or_else(|| "–".to_owned(), tolerance)
    }
}

/// The proof, with the answer of the active set as its witness.
fn proven(body: &Body) -> Option<Proof> {
    let answer = body.run(Solver::ActiveSet, 0.0);
    prove(body, answer.x.iter().map(|x| 0.0 < *x)).ok()
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut cases: Vec<(String, Body)> = Vec::new();
    let mut built_in = true;
    for n in SIZES {
        let Known { body, clearance, .. } = five_diagonal(n);
        built_in &= proven(&body).is_some_and(|proof| proof.off(&clearance).least == 0.0);
        cases.push((FIVE_DIAGONALS.to_owned(), body));
    }
    cases.push(("two beams".to_owned(), two_beams(INTERVALS).body));
    cases.extend(Laid::ALL.map(|laid| (laid.name().to_owned(), laid.body())));
    let (mut tables, mut data) = ([table(), table()], table());
    let (mut runs, mut errors, mut condition) = (Vec::new(), Vec::new(), 0.0_f64);
    for (name, body) in &cases {
        let proof = proven(body).ok_or_else(|| format!("nothing is proven of {name}"))?;
        let n = body.program().dimension();
        errors.push(proof.error / proof.sizes.clearance);
        let largest_row = if name == FIVE_DIAGONALS { ROW } else { 0.0 };
        condition = condition.max(largest_row / proof.least_eigenvalue);
        for (solver, asked, _) in TRIED.into_iter().filter(|(_, _, most)| n <= *most) {
            let run = Run::new(body, &proof, solver, asked);
            let [least, most] = run.off();
            let residual = cell(Some(run.residual).filter(|residual| 0.0 < *residual), 1);
            let certified = if run.certified { "certified" } else { "not certified" };
            let row = row![name, n, solver, run.own_tolerance(), run.message, residual, least, most, certified];
            tables[usize::from(!run.is_library())].push(row.clone());
            data.push(row);
            runs.push(run);
        }
    }
    let (random, random_table) = random();
    let [libraries, ours] = tables;
    let misled: Vec<&Run> = runs.iter().filter(|run| run.misleads()).collect();
    let neatest = misled.iter().min_by(|a, b| a.residual.total_cmp(&b.residual)).map(|run| {
        let [off, _] = run.off();
        context! { solver => run.solver.name(), off, residual => run.residual }
    });
    let (drawn, highest) = slabs(study)?;
    let values = context! {
        libraries,
        ours,
        built_in,
        error => largest(errors),
        exact => EXACT,
        condition,
        wrong => WRONG,
        answers => runs.len(),
        certified => runs.iter().filter(|run| run.certified).count(),
        misled => misled.len(),
        misled_certified => misled.iter().filter(|run| run.certified).count(),
        neatest,
        random => context! { table => random_table.to_string(), ..random },
        instance => Laid::Settled.name(),
        highest,
    };
    Evidence::new(values).data("referee", data)?.data("referee-random", random_table)?.figures([drawn])
}

fn table() -> Table {
    Table::new([
        "instance",
        "unknowns",
        "solver",
        "its tolerance",
        "solver message",
        "residual",
        "error at least",
        "error at most",
        "`certify`",
    ])
}

/// Random bodies with answers in whole numbers, solver by solver.
fn random() -> (Value, Table) {
    let mut random = Random::new(30);
    let (mut bodies, mut proven_bodies, mut untrue) = (0, 0, 0);
    let mut runs: Vec<Vec<Run>> = TRIED.map(|_| Vec::new()).into();
    while bodies < RANDOM {
        let Some(Known { body, clearance, .. }) = whole(&mut random, EXPONENT) else { continue };
        bodies += 1;
        let Some(proof) = proven(&body) else { continue };
        proven_bodies += 1;
        for ((solver, asked, _), runs) in TRIED.into_iter().zip(&mut runs) {
            let run = Run::new(&body, &proof, solver, asked);
            // A library that refuses has no answer.
            if run.clearance.iter().any(|h| h.is_nan()) {
                continue;
            }
            let off = apart(&run.clearance, &clearance);
            untrue += usize::from(off < run.off.least || run.off.most < off);
            runs.push(run);
        }
    }
    let header =
        ["solver", "its tolerance", "answers", "reported solved", "of these wrong", "of the wrong ones certified"];
    let counts = runs.iter().filter_map(|runs| {
        let first = runs.first()?;
        let wrong = || runs.iter().filter(|run| run.misleads());
        let solved = runs.iter().filter(|run| run.says_solved).count();
        let certified = wrong().filter(|run| run.certified).count();
        Some(row![first.solver, first.own_tolerance(), runs.len(), solved, wrong().count(), certified])
    });
    let table = Table::new(header).rows(counts);
    let all = || runs.iter().flatten();
    let values = context! {
        bodies,
        proven => proven_bodies,
        untrue,
        answers => all().count(),
        misled => all().filter(|run| run.misleads()).count(),
        misled_certified => all().filter(|run| run.misleads() && run.certified).count(),
    };
    (values, table)
}

/// Metres to millimetres.
const MILLIMETRES: f64 = 1e3;

/// Contact and clearance of the slabs, node by node; and whether they touch the ground only where it is highest.
fn slabs(study: &Study<'_>) -> Result<(Drawn, bool), Cause> {
    let mut data = Table::new(["instance", "x_m", "y_m", "clearance_mm", "contact_force_kN"]);
    let [xs, ys] = Laid::places();
    let (mut panels, mut highest) = (Vec::new(), true);
    for laid in Laid::ALL {
        let body = laid.body();
        let answer = body.run(Solver::ActiveSet, 0.0);
        let [clearance, contact_force] = body.clearance_and_force(&answer);
        let mut cells = Vec::new();
        let nodes = (0_u32..).zip(&xs).flat_map(|(i, x)| (0_u32..).zip(&ys).map(move |(j, y)| ([i, j], [x, y])));
        for (([i, j], [x, y]), (h, p)) in nodes.zip(clearance.iter().zip(&contact_force)) {
            let touches = 0.0 < *p;
            highest &= !touches || laid.gap(*x, *y) <= Laid::HIGHEST;
            let text = if touches { fixed(*p, 0) } else { fixed(MILLIMETRES * h, 0) };
            let color = if touches { Color::VERMILLION } else { Color::SKY };
            cells.push(Cell { at: [f64::from(i), f64::from(j)], color, text });
            data.push(row![laid.name(), fixed(*x, 1), fixed(*y, 1), fixed(MILLIMETRES * h, 2), fixed(*p, 2)]);
        }
        panels.push(map(laid, [&xs, &ys], cells));
    }
    Ok((study.drawn("slabs", context! {}, 1, panels, data)?, highest))
}

fn map(laid: Laid, [xs, ys]: [&[f64]; 2], cells: Vec<Cell>) -> Panel {
    let names = |places: &[f64]| places.iter().map(|place| fixed(*place, 0)).collect();
    let x = Axis::named(format!("{}: x in m", laid.title()), names(xs));
    let y = Axis::named("y in m; orange: contact force in kN; blue: clearance in mm", names(ys)).down();
    Panel::new(x, y).tall(CELL * as_number(ys.len())).with(Layer::Cells(cells))
}

/// Height of a cell \[drawing units\].
const CELL: f64 = 70.0;
