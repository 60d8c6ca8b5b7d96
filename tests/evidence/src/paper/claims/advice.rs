//! What the paper advises and rests on besides its results: which methods to prefer, what they may be used for, that there is one
//! solution, and what the gradient is.

use palkki::body::proof::prove;
use palkki::methods::{Discrete, Method};
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve_exactly, solve_raw};
use serde_json::json;

use super::energy_methods::{dense, explicit};
use super::{Claim, Verdict};
use crate::compare::apart;
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, example};
use crate::slab::Laid;

/// Random foundations of each kind, their seed, and the grid on which the methods are compared.
const SCENES: usize = 50;
const SEED: u64 = 17;
const COMPARED_ON: usize = 100;

/// Rounding where condition numbers of 10⁵ stand between two ways of computing the same.
const CONDITIONED: f64 = 1e-9;

/// "For this reason both the force and the displacement method may be recommended": rather than the complementarity problem by finite
/// differences, with which the paper begins.
///
/// Confirmed if on each kind of foundation the force method has the smaller median error of the largest moment; refuted if on none.
pub(super) fn energy_methods_preferred() -> Result<Claim, SceneError> {
    let kinds = [vec![example()?], scenes(Unevenness::Wave, SCENES, SEED)?, scenes(Unevenness::Rough, SCENES, SEED)?];
    let mut medians = Vec::new();
    for kind in &kinds {
        let of =
            |method| kind.iter().map(|scene| moment_error(scene, method)).collect::<Result<Vec<_>, _>>().map(median);
        medians.push([of(Method::Complementarity)?, of(Method::Force)?]);
    }
    let better = medians.iter().filter(|[differences, force]| force < differences).count();
    let verdict = match better {
        0 => Verdict::Refuted,
        all if all == medians.len() => Verdict::Confirmed,
        _ => Verdict::Qualified,
    };
    let line = |[differences, force]: &[f64; 2]| json!({ "differences": differences, "force": force });
    let [flat, waves, polylines] = [0, 1, 2].map(|kind| line(&medians[kind]));
    let numbers = json!({
        "intervals": COMPARED_ON, "scenes": SCENES, "flat": flat, "waves": waves, "polylines": polylines, "better": better,
    });
    Ok(Claim { name: "energy_methods_preferred", verdict, numbers })
}

/// The error of the largest moment, over itself.
fn moment_error(scene: &Scene, method: Method) -> Result<f64, SceneError> {
    let exact = solve_exactly(scene).expect("every scene of these families has an answer").state.moment.max;
    let found = solve_raw(scene, &Settings::new(method, Solver::ActiveSet, COMPARED_ON))?.state.moment.max;
    Ok((found / exact - 1.0).abs())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// "The results can be applied to beams or slabs on an uneven (or slightly settled) foundation."
///
/// A slab on a foundation that has settled towards one side: contact in places only, proven to a millionth.
pub(super) fn settled_foundations() -> Claim {
    let body = Laid::Settled.body();
    let answer = body.run(Solver::ActiveSet, 0.0);
    let free = answer.x.iter().map(|x| 0.0 < *x);
    let proof = prove(&body, free).expect("a slab is positive definite");
    let [clearance, force] = body.clearance_and_force(&answer);
    let off = proof.off(&clearance).share;
    let touching = force.iter().filter(|force| 0.0 < **force).count();
    assert!(0 < touching && touching < force.len(), "{touching} of {} nodes touch", force.len());
    let numbers = json!({ "nodes": force.len(), "touching": touching, "error": off.max(f64::EPSILON) });
    Claim { name: "settled_foundations", verdict: Verdict::of(off < 1e-6), numbers }
}

/// "The existence of the unique solution is proven by a theorem of Stampacchia and Lions."
///
/// On a grid: the matrix of the program is positive definite, so that its objective has one minimum.
pub(super) fn one_solution() -> Result<Claim, SceneError> {
    let discrete = Discrete::new(&example()?, INTERVALS)?;
    let least = |method: Method| {
        let eigenvalues = dense(method.qp(&discrete).as_ref()).symmetric_eigenvalues();
        eigenvalues.min() / eigenvalues.max()
    };
    let least = Method::ALL.map(least).into_iter().fold(f64::INFINITY, f64::min);
    let numbers = json!({ "intervals": INTERVALS, "least": least });
    Ok(Claim { name: "one_solution", verdict: Verdict::of(1e-12 < least), numbers })
}

/// "In the force method the gradient is the clearance, in the displacement method the contact pressure."
pub(super) fn meaning_of_the_gradient() -> Result<Claim, SceneError> {
    let scaled = example()?.scaled()?;
    let discrete = Discrete::new(&scaled.scene, INTERVALS)?;
    let solved = |method: Method| Solver::ActiveSet.run(&explicit(method.qp(&discrete).as_ref()), 0.0);
    let [displacement, force] = [Method::Displacement, Method::Force].map(solved);
    let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let pressure = apart(&displacement.gradient, &force.x) / most(&force.x);
    let clearance = apart(&force.gradient, &displacement.x) / most(&displacement.x);
    let numbers = json!({ "pressure": pressure.max(f64::EPSILON), "clearance": clearance.max(f64::EPSILON) });
    Ok(Claim { name: "meaning_of_the_gradient", verdict: Verdict::of(pressure.max(clearance) < CONDITIONED), numbers })
}
