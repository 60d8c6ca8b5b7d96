//! The commands `solve`, `compare` and `certify` for an elastic body.

use std::time::Instant;

use palkki::DEFAULT_TOLERANCE;
use palkki::body::proof::{Brought, Errors, Proof, Sizes, Unproven, prove};
use palkki::body::{Body, Verdict};
use palkki::certificate::ViolationKind;
use palkki::qp::{Qp as _, residual};
use palkki::route::{Solver, Status};
use palkki::solvers::Answer;
use palkki::text::{magnitude, magnitude_at_least, magnitude_at_most};
use palkki::verdict::EXACT;
use serde::Serialize;
use serde_json::{Value, json};

use super::Outcome;
use super::arguments::{Certify, Common, DEFAULT_SOLVER, LoadArgument, Solve};
use super::csv::field;
use super::input::Input;
use super::json::{MOST_INTERVALS_WITH_NODES, print};
use super::output::Failure;
use super::table::{Row, list, table};
use super::text::{BRACKET, heading};

/// The result of one solver for a body.
#[derive(Debug, Serialize)]
struct Route {
    method: &'static str,
    solver: &'static str,
    status: Status,
    reason: String,
    solver_status: String,
    residual: f64,
    unknowns: usize,
    iterations: usize,
    seconds: f64,
    energy: f64,
    /// Lower and upper bound of the largest clearance error.
    off: [f64; 2],
    certificate: Option<Certificate>,
    #[serde(skip)]
    answer: Answer,
}

/// The proven bounds; `error` is the bound for the clearances, and `force_error` the bound for the contact forces.
#[derive(Debug, Clone, Copy, Serialize)]
struct Certificate {
    energy_lower: f64,
    energy_upper: f64,
    gap: f64,
    error: f64,
    force_error: f64,
}

impl Certificate {
    fn new(proof: &Proof, errors: &Errors) -> Self {
        let [energy_lower, energy_upper] = proof.energy;
        Self {
            energy_lower,
            energy_upper,
            gap: proof.gap,
            error: errors.clearance.most,
            force_error: errors.force.most,
        }
    }
}

type Proven = Result<Proof, Unproven>;

/// A point that is proven to be close to the optimum. The candidate contact list consists of the free variables of an active-set answer.
fn proven(body: &Body, answer: &Answer) -> Proven {
    prove(body, answer.x.iter().map(|x| 0.0 < *x))
}

fn timed(body: &Body, solver: Solver) -> (Answer, f64) {
    let start = Instant::now();
    (body.run(solver, DEFAULT_TOLERANCE), start.elapsed().as_secs_f64())
}

impl Route {
    fn of(body: &Body, solver: Solver, (answer, seconds): (Answer, f64), demanded: f64, proof: &Proven) -> Self {
        let errors = proof.as_ref().map(|proof| proof.errors(body, &answer)).map_err(|error| *error);
        let Verdict { status, reason, errors } = Verdict::new(errors, demanded, answer.run.reports_success);
        Self {
            method: body.method(),
            solver: solver.name(),
            status,
            reason,
            residual: residual(body.program().sizes(), &answer.x, &answer.gradient),
            solver_status: answer.run.message.clone(),
            unknowns: answer.x.len(),
            iterations: answer.run.iterations,
            seconds,
            energy: body.energy(&answer),
            off: [errors.clearance.least, errors.clearance.most],
            certificate: proof.as_ref().ok().map(|proof| Certificate::new(proof, &errors)),
            answer,
        }
    }
}

/// The command `solve`.
pub(super) fn solve<'a>(input: &Input<Body>, arguments: &'a Solve) -> Result<Outcome<'a>, Failure> {
    #[derive(Debug, Serialize)]
    struct SolveObject<'a> {
        scene: &'a str,
        #[serde(flatten)]
        route: &'a Route,
        nodes: Option<Value>,
    }
    let Solve { common, csv, plot, proof, nodes, solver, tolerance, .. } = arguments;
    let of_beams = [
        ("intervals", arguments.intervals.is_some()),
        ("derivatives", arguments.derivatives),
        ("depth-tolerance", arguments.depth_tolerance.is_some()),
        ("plot", plot.is_some()),
        ("proof", proof.is_some()),
    ];
    if let Some((option, _)) = of_beams.iter().find(|(_, asked)| *asked) {
        return Err(Failure::refused("solve", format!("--{option} belongs to a beam; a [body] has no use for it")));
    }
    let method = input.scene.method();
    if arguments.method.discretised().is_some_and(|asked| asked.name() != method) {
        return Err(Failure::refused("solve", format!("the matrix of this [body] is that of --method {method}")));
    }
    let solver = solver.map_or(DEFAULT_SOLVER, |solver| solver.0);
    let timed_answer = timed(&input.scene, solver);
    let proof = match solver {
        Solver::ActiveSet => proven(&input.scene, &timed_answer.0),
        _ => proven(&input.scene, &input.scene.run(Solver::ActiveSet, 0.0)),
    };
    let route = Route::of(&input.scene, solver, timed_answer, tolerance.unwrap_or(EXACT), &proof);
    let [clearance, contact_force] = input.scene.clearance_and_force(&route.answer);
    let few = route.unknowns <= MOST_INTERVALS_WITH_NODES || *nodes;
    let shown = common.shown(
        || text(input, &route, *nodes),
        || {
            let nodes = few.then(|| json!({ "clearance": clearance, "contact_force": contact_force }));
            print(&SolveObject { scene: input.title(), route: &route, nodes })
        },
    );
    // In the format of a gap file without foundation and of an answer for `certify`.
    let clear = |h: f64| if h.is_infinite() { "inf".to_owned() } else { field(h) };
    let rows = (1..).zip(clearance.iter().zip(&contact_force));
    let rows = rows.map(|(i, (h, p))| format!("{i},{},{}\n", clear(*h), field(*p)));
    let written = csv
        .as_ref()
        .map(|path| (path, std::iter::once("i,clearance,contact_force\n".to_owned()).chain(rows).collect()));
    Ok(Outcome { text: shown, files: vec![written], is_certified: route.status == Status::Certified })
}

/// The answer of `solve` as text.
fn text(input: &Input<Body>, route: &Route, nodes: bool) -> String {
    let labels = input.labels();
    let [clearance, contact_force] = input.scene.clearance_and_force(&route.answer);
    let touching = contact_force.iter().filter(|force| 0.0 < **force).count();
    let largest = clearance.iter().copied().filter(|h| h.is_finite()).fold(0.0, f64::max);
    let mut text = heading(route.status, &route.reason, input);
    text += &list(&[
        ("method", route.method.to_owned()),
        ("solver", route.solver.to_owned()),
        ("solver message", route.solver_status.to_owned()),
        ("unknowns", route.unknowns.to_string()),
        ("iterations", route.iterations.to_string()),
        ("seconds", magnitude(route.seconds)),
        ("freedoms in contact", touching.to_string()),
        (&labels.force.name("contact force"), labels.number(contact_force.iter().sum())),
        (&labels.length.name("largest clearance"), labels.number(largest)),
        (&labels.moment.name("energy J"), labels.number(route.energy)),
    ]);
    if let Some(certificate) = &route.certificate {
        text += &bounds(input, certificate, None);
    }
    if nodes {
        let rows: Vec<Row> = (1..)
            .zip(clearance.iter().zip(&contact_force))
            .map(|(i, (h, p)): (usize, _)| vec![i.to_string(), labels.number(*h), labels.number(*p)])
            .collect();
        let header = ["freedom", &labels.length.name("clearance"), &labels.force.name("contact force")];
        text += &table("Freedoms", &header, &rows);
    }
    text
}

/// The error bounds, rounded outwards so that they remain valid.
fn bounds(input: &Input<Body>, certificate: &Certificate, least: Option<f64>) -> String {
    let labels = input.labels();
    let Certificate { energy_lower, energy_upper, error, force_error, .. } = *certificate;
    let [lower, upper] = [labels.results.at_least(energy_lower), labels.results.at_most(energy_upper)];
    let mut rows = vec![vec![labels.moment.name("energy J*"), lower, upper]];
    let least = least.map_or_else(|| "0".to_owned(), magnitude_at_least);
    rows.push(vec![labels.length.name("largest error of a clearance"), least, magnitude_at_most(error)]);
    let of_force = labels.force.name("largest error of a contact force");
    rows.push(vec![of_force, "0".to_owned(), magnitude_at_most(force_error)]);
    table("Error bounds", &["", BRACKET[0], BRACKET[1]], &rows)
}

/// The command `compare`: every solver.
pub(super) fn compare<'a>(input: &Input<Body>, common: &Common) -> Outcome<'a> {
    let body = &input.scene;
    let proof = proven(body, &body.run(Solver::ActiveSet, 0.0));
    let routes = Solver::ALL.map(|solver| Route::of(body, solver, timed(body, solver), EXACT, &proof));
    let certified = routes.iter().filter(|route| route.status == Status::Certified).count();
    let row = |route: &Route| {
        vec![
            route.solver.to_owned(),
            route.status.to_string(),
            magnitude(route.residual),
            route.iterations.to_string(),
            magnitude(route.seconds),
            magnitude_at_least(route.off[0]),
            magnitude_at_most(route.off[1]),
            route.solver_status.clone(),
        ]
    };
    let header = ["solver", "status", "residual", "iterations", "seconds", "true error between", "and", "it says"];
    let as_text = || {
        let title = format!("{}, {} unknowns", input.title(), body.program().dimension());
        let why = proof.as_ref().err().map_or_else(String::new, |error| format!("\n{error}\n"));
        let status = Status::of_several(0 < certified);
        let rows: Vec<Row> = routes.iter().map(row).collect();
        format!("{status}: {certified} of {} answers\n", routes.len()) + &table(&title, &header, &rows) + &why
    };
    let as_json = || print(&json!({ "scene": input.title(), "intervals": null, "routes": routes }));
    Outcome { text: common.shown(as_text, as_json), files: Vec::new(), is_certified: 0 < certified }
}

/// A condition that is violated by more than a certified answer may, at its worst position.
#[derive(Debug, Serialize)]
struct Violation {
    condition: ViolationKind,
    at: usize,
    amount: f64,
}

/// The command `certify`: error bounds for clearances or forces from elsewhere.
pub(super) fn certify<'a>(input: &Input<Body>, arguments: &Certify) -> Result<Outcome<'a>, Failure> {
    if arguments.load == LoadArgument::Nodal {
        return Err(Failure::refused("certify", "--load belongs to a beam; a [body] has no use for it"));
    }
    let body = &input.scene;
    let brought = input.answers(&arguments.forces)?;
    let proof = proven(body, &body.run(Solver::ActiveSet, 0.0));
    let judged = match &proof {
        Ok(proof) => proof.judge(body, &brought).map_err(Unproven::from),
        Err(error) => Err(*error),
    };
    let (state, errors) = match judged {
        Ok((state, errors)) => (Some(state), Ok(errors)),
        Err(error) => (None, Err(error)),
    };
    let verdict = Verdict::new(errors, EXACT, true);
    let certificate = proof.as_ref().ok().map(|proof| Certificate::new(proof, &verdict.errors));
    let found = proof.as_ref().ok().zip(state);
    let violations = found.map_or_else(Vec::new, |(proof, state)| violations(&brought, &state, proof.sizes));
    let as_text = || {
        let mut text = heading(verdict.status, &verdict.reason, input);
        text +=
            &certificate.map_or_else(String::new, |found| bounds(input, &found, Some(verdict.errors.clearance.least)));
        let rows: Vec<Row> = violations
            .iter()
            .map(|v| vec![v.condition.name().to_owned(), v.at.to_string(), magnitude(v.amount)])
            .collect();
        match rows.len() {
            0 => text + "\nViolations: none\n",
            _ => text + &table("Violations, the worst of each kind", &["", "freedom", "amount"], &rows),
        }
    };
    let as_json = || {
        let Verdict { status, reason, errors } = &verdict;
        let off = [errors.clearance.least, errors.clearance.most];
        print(
            &json!({ "scene": input.title(), "status": status, "reason": reason, "off": off, "certificate": certificate, "violations": violations }),
        )
    };
    let text = arguments.common.shown(as_text, as_json);
    Ok(Outcome { text, files: Vec::new(), is_certified: verdict.status == Status::Certified })
}

/// Conditions violated by more than a certified answer may: by the clearances, and by the forces if forces were given.
fn violations(brought: &Brought, [clearance, force]: &[Vec<f64>; 2], sizes: Sizes) -> Vec<Violation> {
    let worst = |condition, size: f64, amounts: &mut dyn Iterator<Item = f64>| {
        let (at, amount) = (1..).zip(amounts).max_by(|a, b| a.1.total_cmp(&b.1))?;
        (EXACT * size < amount).then_some(Violation { condition, at, amount })
    };
    let mut found = vec![worst(ViolationKind::Penetration, sizes.clearance, &mut clearance.iter().map(|h| -h))];
    if let Brought::Force(_) = brought {
        found.push(worst(ViolationKind::Tension, sizes.force, &mut force.iter().map(|p| -p)));
        let pressed = |p: f64| EXACT * sizes.force < p;
        let across = force.iter().zip(clearance).map(|(p, h)| if pressed(*p) { *h } else { 0.0 });
        found.push(worst(ViolationKind::Complementarity, sizes.clearance, &mut { across }));
    }
    found.into_iter().flatten().collect()
}
