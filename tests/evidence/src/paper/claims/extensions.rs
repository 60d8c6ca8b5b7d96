//! "The methods extend to any elastic body whose condensed stiffness or flexibility matrix can be computed, and to an elastic
//! foundation; further study is needed where the rigid motion of the body is not known beforehand."

use nalgebra::{DMatrix, DVector};
use palkki::body::{Body, Kind};
use palkki::methods::{Method, flexibility};
use palkki::qp::{Profile, Qp as _, residual};
use palkki::scene::{Foundation, SceneError};
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki::{Settings, solve_raw};
use serde_json::json;

use super::curved::scene_on;
use super::{Claim, Verdict};
use crate::paper::{INTERVALS, beam, example};

/// A few units in the last place, over the sizes of a program.
const ROUNDING: f64 = 1e-12;

/// Errors of second order on 60 to 200 intervals are of the size of `Δ²/l²`, some times over.
const SECOND_ORDER: f64 = 1e-3;

/// A taut string of span 10 under tension 10 and a unit load, above a flat foundation at depth 1: touched or not, the
/// quadratic program (32) with another `K`, solved with the active set.
///
/// Closed form: `S v'' = −q` up to the lift-off point `b`, where `v = u₀`, `v' = 0`: `b² = 2 S u₀/q`, reaction `q b`.
#[expect(clippy::cast_precision_loss, reason = "200 intervals")]
pub(super) fn any_elastic_body() -> Claim {
    const INTERVALS: usize = 200;
    let (length, tension, load, depth) = (10.0, 10.0, 1.0, 1.0_f64);
    let n = INTERVALS - 1;
    let spacing = length / INTERVALS as f64;
    let entries = (0..n).flat_map(|i| (i.saturating_sub(1)..=i).map(move |j| (i, j, if i == j { 2.0 } else { -1.0 })));
    let stiffness = Profile::of_entries(n, entries.map(|(i, j, share)| (i, j, share * tension / spacing)));
    let body = Body::new(Kind::Stiffness, stiffness, None, vec![depth; n], vec![load * spacing; n])
        .expect("a taut string is positive definite");
    let answer = body.run(Solver::ActiveSet, 0.0);
    let first = depth - answer.x[0];
    let reaction = tension * first / spacing + 0.5 * load * spacing;
    let residual = residual(body.program().sizes(), &answer.x, &answer.gradient);
    let end_reaction = reaction / (2.0 * tension * load * depth).sqrt() - 1.0;
    let verdict = Verdict::of(residual < ROUNDING && end_reaction.abs() < SECOND_ORDER);
    let numbers = json!({ "residual": residual.max(f64::EPSILON), "end_reaction": end_reaction });
    Claim { name: "any_elastic_body", verdict, numbers }
}

/// Foundation modulus `k` \[force / length²\] on which the example lifts off, and the stiffness of a girder below it over its own.
const MODULUS: f64 = 100.0;
const GIRDER: f64 = 4.0;
const FOUNDATION_INTERVALS: usize = 120;

/// The example above two elastic foundations.
///
/// *Springs beside each other*: the three methods on ground that gives, against the exact solution, of reaction and deflection.
///
/// *A body*: a girder of four times its stiffness that carries the beam between the same supports, whose flexibility `G` is added to `C`.
/// Where there is no gap both have one deflection, and the girder carries `G⁻¹/(C⁻¹ + G⁻¹)` of the load, four fifths, at each node; with
/// the gap of the example a part of the nodes lifts off.
#[expect(clippy::cast_precision_loss, reason = "120 intervals")]
pub(super) fn elastic_foundation() -> Result<Claim, SceneError> {
    let scene = example()?.on_springs(MODULUS)?;
    let exact = palkki::solve_exactly(&scene).expect("the example has an answer").state;
    let (mut off, mut lifted) = (0.0_f64, usize::MAX);
    for method in Method::ALL {
        let answer = solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, FOUNDATION_INTERVALS))?;
        let state = answer.state;
        let reaction = state.reactions.left / exact.reactions.left - 1.0;
        off = off.max(reaction.abs()).max((state.deflection.max / exact.deflection.max - 1.0).abs());
        let open = |nodes: &Nodes| nodes.contact_force.iter().filter(|force| **force <= 0.0).count();
        lifted = lifted.min(state.nodes.as_ref().map_or(0, open)).min(if answer.solved { usize::MAX } else { 0 });
    }

    let beam = beam()?;
    let (l, ei, n) = (beam.length(), beam.bending_stiffness(), FOUNDATION_INTERVALS - 1);
    let load = l / FOUNDATION_INTERVALS as f64;
    let of = |ei: f64| Profile::full(n, |i, j| flexibility(l, ei, n, i + 1, j + 1));
    let girder = of(GIRDER * ei);
    let body = |gap: f64| {
        let body = Body::new(Kind::Flexibility, of(ei), Some(&girder), vec![gap; n], vec![load; n]);
        let body = body.expect("two beams are positive definite");
        let answer = body.run(Solver::ActiveSet, 0.0);
        let residual = residual(body.program().sizes(), &answer.x, &answer.gradient);
        (answer.x, residual)
    };
    let ((shared, of_shared), (touching, of_touching)) = (body(0.0), body(scene.depth(0.0)));
    let shares = shared.iter().map(|force| (force / load * (1.0 + GIRDER) / GIRDER - 1.0).abs()).fold(0.0, f64::max);
    let residual = of_shared.max(of_touching);
    let open = touching.iter().filter(|force| **force <= 0.0).count();
    let parted = 0 < lifted && lifted < n && 0 < open && open < n;
    let verdict = Verdict::of(parted && off < SECOND_ORDER && residual < ROUNDING && shares < SHARES);
    let numbers = json!({
        "intervals": FOUNDATION_INTERVALS, "nodes": n, "off": off, "lifted": lifted, "open": open,
        "residual": residual.max(f64::EPSILON), "shares": shares.max(f64::EPSILON), "girder": GIRDER,
    });
    Ok(Claim { name: "elastic_foundation", verdict, numbers })
}

/// Forces by a flexibility of this condition number, 10⁸ on 120 intervals, have eight digits.
const SHARES: f64 = 1e-7;

/// The condensed stiffness of an unsupported beam with 29 inner nodes and two ends, and what step 1° makes of it.
///
/// Deflections of the ends are added to those of the supported beam: `K_free = Bᵀ K B` with `B v = v − chord of the ends`.
/// Confirmed if there are rigid motions, the algorithm does not even start, and another start, a rigid beam on the ground below the
/// resultant of the loads, is enough.
#[expect(clippy::cast_precision_loss, reason = "30 intervals")]
pub(super) fn unknown_rigid_motion() -> Result<Claim, SceneError> {
    let beam = beam()?;
    let n = 29;
    let c = DMatrix::from_fn(n, n, |i, j| flexibility(beam.length(), beam.bending_stiffness(), n, i + 1, j + 1));
    let chord = |i: usize, end: usize| {
        let share = (i + 1) as f64 / (n + 1) as f64;
        if end == 0 { 1.0 - share } else { share }
    };
    let relative = DMatrix::from_fn(n, n + 2, |i, j| match j {
        0 => -chord(i, 0),
        j if j == n + 1 => -chord(i, 1),
        j => f64::from(u8::from(j == i + 1)),
    });
    let stiffness = c.try_inverse().unwrap_or_else(|| DMatrix::zeros(n, n));
    let free = relative.transpose() * stiffness * &relative;
    let eigenvalues = free.clone().symmetric_eigenvalues();
    let largest = eigenvalues.max();
    // A x = b has a solution only if b does no work on the motions that A takes to zero.
    let loads = DVector::from_element(n + 2, 1.0);
    let motions = [DVector::from_element(n + 2, 1.0), DVector::from_fn(n + 2, |i, _| i as f64)];
    let is_rigid = |motion: &DVector<f64>| (&free * motion).amax() <= 1e-9 * largest * motion.amax();
    let first_step_works = !motions.iter().any(|motion| is_rigid(motion) && 1e-9 < loads.dot(motion).abs());
    let ground = Foundation::Polyline { points: vec![[0.0, 1.0], [4.0, 0.5], [10.0, 1.0]] };
    let lies = scene_on(vec![], None, ground)?;
    let solved = solve_raw(&lies, &Settings::new(Method::Force, Solver::ActiveSet, INTERVALS))?.solved;
    // A translation and a rotation.
    let rigid_motions = eigenvalues.iter().filter(|e| e.abs() <= 1e-9 * largest).count();
    let verdict = Verdict::of(rigid_motions == 2 && !first_step_works && solved);
    let numbers = json!({ "rigid_motions": rigid_motions, "intervals": INTERVALS });
    Ok(Claim { name: "unknown_rigid_motion", verdict, numbers })
}
