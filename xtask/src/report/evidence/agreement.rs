//! All routes on the example with 30 intervals, against each other and against exact rationals.

mod tolerance;

use minijinja::context;
use palkki::route::{Method, Outcome, Solver, Status};
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, Witness, solve};
use palkki_evidence::paper::{INTERVALS, example, theory};

use self::tolerance::Tolerances;
use crate::report::csv::{csv, fixed, scientific};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::table::Table;
use palkki_evidence::authority::rational::{Data, fraction, number};

/// Exact results of one discrete model, as fractions and as the nearest numbers.
struct Authority {
    fractions: [String; 2],
    forces: Vec<f64>,
    /// The first node in contact.
    first: usize,
    left_reaction: f64,
}

/// A route with what is compared.
struct Run {
    method: Method,
    solver: Solver,
    outcome: Outcome,
    forces: Vec<f64>,
}

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let tolerances = Tolerances::new()?;
    let run = |method, solver, intervals| -> Result<Run, Cause> {
        let outcome = solve(&scene, &Settings::new(method, solver, intervals))?;
        let forces = outcome.state.nodes.as_ref().map_or_else(Vec::new, |nodes| nodes.contact_force.clone());
        Ok(Run { method, solver, outcome, forces })
    };
    let mut runs = Vec::new();
    for method in Method::ALL {
        for solver in Solver::ALL {
            runs.push(run(method, solver, INTERVALS)?);
        }
    }
    let (energy, differences) = (authority(&runs, Method::Force)?, authority(&runs, Method::Complementarity)?);
    let of = |run: &Run| if run.method == Method::Complementarity { &differences } else { &energy };

    let mut table = Table::new(["method", "solver", "first contact force", "end reaction", "tolerance"]);
    let mut rows = Vec::new();
    let (mut worst, mut certified) = (0.0_f64, 0);
    let witness = Witness::of(&scene);
    for run in &runs {
        let authority = of(run);
        let reaction = run.outcome.state.reactions.left;
        let error = largest_difference(&run.forces, &authority.forces).max((reaction - authority.left_reaction).abs());
        let share = error / tolerances.of(run.solver);
        worst = worst.max(share);
        let verdict = Verdict::of_outcome(&run.outcome, &witness, &Demand::default());
        certified += usize::from(verdict.status == Status::Certified);
        let first = run.forces.get(authority.first).copied().unwrap_or(f64::NAN);
        let printed = [first, reaction].map(|value| fixed(value, tolerances.places(run.solver)));
        let [force, reaction] = printed.clone();
        let (method, solver) = (run.method.word().to_owned(), run.solver.word().to_owned());
        table = table.row([method.clone(), solver.clone(), force, reaction, tolerances.printed(run.solver)]);
        let [force, reaction] = printed;
        let agrees = if share <= 1.0 { "yes" } else { "no" };
        let (status, error) = (verdict.status.word().to_owned(), scientific(verdict.error, 1));
        rows.push(vec![method, solver, status, error, force, reaction, agrees.to_owned()]);
    }

    let (mut pairs, mut pairs_agree) = (0, 0);
    for (i, a) in runs.iter().enumerate() {
        let same_model = |b: &&Run| (a.method == Method::Complementarity) == (b.method == Method::Complementarity);
        for b in runs[i + 1..].iter().filter(same_model) {
            pairs += 1;
            let allowed = tolerances.of(a.solver) + tolerances.of(b.solver);
            pairs_agree += usize::from(largest_difference(&a.forces, &b.forces) <= allowed);
        }
    }
    let exact = theory();
    let answers = [("finite differences", &differences), ("energy methods", &energy)].map(|(name, authority)| {
        let values = [authority.forces[authority.first], authority.left_reaction].map(|value| fixed(value, 9));
        let [force, reaction] = [0, 1].map(|i| format!("{} = {}…", authority.fractions[i], values[i]));
        [name.to_owned(), force, reaction]
    });
    let continuous =
        ["beam theory, no grid".to_owned(), fixed(exact.end_force, 9) + "…", fixed(exact.reaction, 9) + "…"];
    // What Figure 4 would show if its n counted the nodes.
    let one_more = run(Method::Complementarity, Solver::ActiveSet, INTERVALS + 1)?;
    let header = ["method", "solver", "status", "guaranteed_error", "first_contact_force", "left_reaction", "agrees"];
    Ok(Evidence::new(context! {
        intervals => INTERVALS,
        exact => Table::new(["answer", "first contact force", "end reaction"]).rows(answers).row(continuous),
        table,
        routes => runs.len(),
        certified,
        agree => rows.iter().filter(|row| row.last().is_some_and(|word| word == "yes")).count(),
        direct => tolerances.printed(Solver::ActiveSet),
        iterative => tolerances.printed(Solver::Nsor),
        norm => tolerances.norm,
        margin => worst <= 0.1,
        pairs,
        pairs_agree,
        one_more => context! {
            intervals => INTERVALS + 1,
            force => one_more.forces.iter().copied().find(|p| 0.0 < *p),
            x => one_more.outcome.state.contacts.first().map_or(f64::NAN, |c| c.from),
        },
    })
    .data("agreement", csv(&header, rows)))
}

/// The exact optimum. The contact set is read from a computed answer; the check in rationals does not rely on it.
fn authority(runs: &[Run], method: Method) -> Result<Authority, Cause> {
    let run = runs.iter().find(|run| run.method == method && run.solver == Solver::ActiveSet);
    let touches: Vec<bool> = run.map_or_else(Vec::new, |run| run.forces.iter().map(|p| 0.0 < *p).collect());
    let load = fraction(10, i32::try_from(INTERVALS)?);
    let data = Data {
        length: fraction(10, 1),
        stiffness: fraction(500, 384),
        loads: vec![load.clone(); touches.len()],
        depths: vec![fraction(1, 1); touches.len()],
    };
    let optimum = if method == Method::Complementarity { data.differences(&touches) } else { data.energy(&touches) };
    if let Some(node) = optimum.violation(&touches) {
        return Err(
            format!("the contact set of the {method} method is not that of the optimum, see node {node}").into()
        );
    }
    let first = optimum.contact_force.iter().position(|p| !p.is_zero()).unwrap_or(0);
    // With the load of half an interval on the support.
    let left_reaction = data.left_reaction(&optimum) + load / fraction(2, 1);
    Ok(Authority {
        first,
        fractions: [optimum.contact_force[first].to_string(), left_reaction.to_string()],
        forces: optimum.contact_force.iter().map(number).collect(),
        left_reaction: number(&left_reaction),
    })
}

/// Infinite if there is nothing to compare, or NaN in it.
fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() || a.is_empty() {
        return f64::INFINITY;
    }
    let worst = |worst: f64, e: f64| if e.is_nan() { f64::INFINITY } else { worst.max(e) };
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, worst)
}
