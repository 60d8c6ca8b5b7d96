//! All routes on the example with 30 intervals, against each other and against exact rationals.

use palkki::Witness;
use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::methods::Discrete;
use palkki::route::Solution;
use palkki::scene::SceneError;
use palkki::verdict::{Demand, Verdict};
use palkki_evidence::paper::{INTERVALS, example, theory};

use crate::report::evidence::prelude::*;
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::given::example_over;
use palkki_evidence::authority::number::Number;

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
    outcome: Solution<()>,
    forces: Vec<f64>,
}

pub(crate) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let norm = norm()?;
    let run = |(method, solver)| -> Result<Run, Cause> {
        let outcome = on_grid(&scene, method, solver, INTERVALS)?;
        let forces = nodes_of(&outcome.state)?.contact_force.clone();
        Ok(Run { method, solver, outcome, forces })
    };
    let runs = routes().map(run).collect::<Result<Vec<_>, _>>()?;
    let (energy, differences) = (authority(&runs, Method::Force)?, authority(&runs, Method::Complementarity)?);
    let of = |run: &Run| if run.method == Method::Complementarity { &differences } else { &energy };

    let header = ["method", "solver", "status", "guaranteed_error", "first_contact_force", "left_reaction", "agrees"];
    let mut data = Table::new(header);
    let mut agree = 0;
    let witness = Witness::of(&scene);
    for run in &runs {
        let (authority, method, solver) = (of(run), run.method, run.solver);
        let reaction = run.outcome.state.reactions.left;
        let error = apart_if_any(&run.forces, &authority.forces).max((reaction - authority.left_reaction).abs());
        let exponent = exponent(solver, norm);
        let share = error / ten_to(exponent);
        agree += usize::from(share <= 1.0);
        let verdict = Verdict::of_raw(&run.outcome, &witness, &Demand::default());
        let first = run.forces.get(authority.first).copied().unwrap_or(f64::NAN);
        // Digits behind the point that the tolerance promises.
        let places = usize::try_from(-exponent).unwrap_or(0).saturating_sub(1);
        let [force, reaction] = [first, reaction].map(|value| fixed(value, places));
        let error = scientific(verdict.error, 1);
        data.push(row![method, solver, verdict.status, error, force, reaction, yes_no(share <= 1.0)]);
    }

    Evidence::new(context! {
        intervals => INTERVALS,
        exact => exact(&energy, &differences),
        routes => runs.len(),
        agree,
        direct => power_of_ten(exponent(Solver::ActiveSet, norm)),
        iterative => power_of_ten(exponent(Solver::Nsor, norm)),
        norm,
    })
    .data("agreement", data)
}

/// The exact answers of both discrete models, and of beam theory.
fn exact(energy: &Authority, differences: &Authority) -> Table {
    let theory = theory();
    let answers = [("finite differences", differences), ("energy methods", energy)].map(|(name, authority)| {
        let values = [authority.forces[authority.first], authority.left_reaction].map(|value| fixed(value, 9));
        let [force, reaction] = [0, 1].map(|i| format!("{} = {}…", authority.fractions[i], values[i]));
        [name.to_owned(), force, reaction]
    });
    let continuous =
        ["beam theory, no grid".to_owned(), fixed(theory.end_force, 9) + "…", fixed(theory.reaction, 9) + "…"];
    Table::new(["answer", "first contact force", "end reaction"]).rows(answers).rows([continuous])
}

/// The exact optimum. The contact set is read from a computed answer; the check in rationals does not rely on it.
fn authority(runs: &[Run], method: Method) -> Result<Authority, Cause> {
    let run = runs.iter().find(|run| run.method == method && run.solver == Solver::ActiveSet);
    let run = run.ok_or("the active set is among the routes")?;
    let touches: Vec<bool> = run.forces.iter().map(|p| 0.0 < *p).collect();
    let problem = example_over(i64::try_from(INTERVALS)?, method.discretisation(), |_| RBig::whole(1));
    let optimum = problem.solve(&touches);
    if !optimum.is_optimal(&touches) {
        let wrong = optimum.wrong(&touches);
        return Err(format!("the contact set of the {method} method is not that of the optimum: {wrong:?}").into());
    }
    let forces = &optimum.contact_force[1..INTERVALS];
    let first = forces.iter().position(|p| !p.is_zero()).unwrap_or(0);
    let left_reaction = optimum.left_reaction(&problem.loads[0]);
    Ok(Authority {
        first,
        fractions: [forces[first].to_string(), left_reaction.to_string()],
        forces: forces.iter().map(Number::to_double).collect(),
        left_reaction: left_reaction.to_double(),
    })
}

/// Digits of a direct solve: sixteen, of which sums and differences of moments take a few. The rest is margin.
const DIRECT: i32 = -10;

/// Largest row sum of the stiffness for the example on the paper's grid \[force / length\]: how much force a clearance is worth.
fn norm() -> Result<f64, SceneError> {
    let discrete = Discrete::new(&example()?, INTERVALS)?;
    let matrix = Method::Displacement.qp(&discrete).matrix();
    let n = matrix.dimension();
    let row = |i: usize| (0..n).map(|j| matrix.entry(i, j).abs()).sum::<f64>();
    Ok((0..n).map(row).fold(0.0, f64::max))
}

/// The power of ten that is the tolerance of contact forces and reactions \[force\]. An answer that stopped on a residual has
/// that of our check's threshold, at depth 1, times the norm.
fn exponent(solver: Solver, norm: f64) -> i32 {
    match solver {
        Solver::FourStep | Solver::ActiveSet => DIRECT,
        // The next power of ten.
        Solver::Nsor | Solver::Clarabel | Solver::Osqp => {
            (-15..0).find(|&k| CERTIFIED_RESIDUAL * norm <= ten_to(k)).unwrap_or(0)
        }
    }
}
