//! "The methods extend to any elastic body whose condensed stiffness or flexibility matrix can be computed, and to an elastic
//! foundation; further study is needed where the rigid motion of the body is not known beforehand."

use nalgebra::{DMatrix, DVector};
use palkki::body::{Body, Kind};
use palkki::methods::{Method, flexibility};
use palkki::qp::{Profile, Qp as _, residual};
use palkki::scene::{Foundation, Load, Scene, SceneError};
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki::{Settings, solve_raw};
use serde_json::json;

use super::curved::scene_on;
use super::{Claim, Verdict};
use crate::bodies::{self, Known};
use crate::compare::{apart, apart_if_any, largest};
use crate::paper::{INTERVALS, UNIFORM, beam, example};
use crate::slab::Slab;

/// A few units in the last place, over the sizes of a program.
const ROUNDING: f64 = 1e-12;

/// Rounding of a flexibility on 30 intervals times its condition, some 10⁵.
const BENDING: f64 = 1e-10;

/// Errors of second order on 60 intervals are of the size of `Δ²/l²`, some times over.
const SECOND_ORDER: f64 = 1e-3;

/// Widths of a strip over its length: half the width, a quarter of the difference.
const WIDTHS: [f64; 3] = [0.08, 0.04, 0.02];

/// How far a strip of a slab is from the beam of its stiffness on a crest across it, over the largest clearance, for each width.
///
/// Without Poisson's effect its elements are those of the displacement method along it. Loads on the two edges alone, in place of
/// all across, bend it across by a share of (b/l)².
fn strips() -> Result<[f64; 3], SceneError> {
    const ELEMENTS: usize = 40;
    let beam = beam()?;
    let load = Load::uniform_on(&beam, UNIFORM)?;
    let points = vec![[0.0, 1.0], [3.0, 1.0], [4.0, 0.5], [5.0, 1.0], [10.0, 1.0]];
    let scene = Scene::new(beam, load, Some(Foundation::Polyline { points }))?;
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let nodes = solve_raw(&scene, &Settings::new(Method::Displacement, Solver::ActiveSet, ELEMENTS))?.state.nodes;
    let of_beam = nodes.map(|nodes| nodes.clearance).unwrap_or_default();
    Ok(WIDTHS.map(|share| {
        let width = share * length;
        let slab = Slab { length, width, stiffness: stiffness / width, poisson: 0.0, elements: [ELEMENTS, 1] };
        let body = slab.above(scene.load().uniform() / width, |x, _| scene.depth(x));
        let answer = body.run(Solver::ActiveSet, 0.0);
        let [clearance, _] = body.clearance_and_force(&answer);
        let middle: Vec<f64> = clearance.chunks(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        apart_if_any(&middle, &of_beam) / largest(of_beam.iter().copied())
    }))
}

/// What two beams above each other are off by: the error of contact forces over their sum, and of clearances over the gap, whichever
/// is more.
fn two_beams() -> f64 {
    let Known { body, clearance, contact_force } = bodies::two_beams(INTERVALS);
    let answer = body.run(Solver::ActiveSet, 0.0);
    let [found, forces] = body.clearance_and_force(&answer);
    let force = apart(&forces, &contact_force) / contact_force.iter().sum::<f64>();
    force.max(apart(&found, &clearance) / largest(clearance))
}

/// A body that is no beam, the strip of a slab, and a foundation that is another body.
pub(super) fn any_elastic_body() -> Result<Claim, SceneError> {
    let (strips, two_beams) = (strips()?, two_beams());
    let converges = strips.windows(2).all(|pair| 4.0 * pair[1] < pair[0]);
    let verdict = Verdict::of(converges && two_beams < BENDING);
    let [.., narrowest] = WIDTHS;
    let [.., strip] = strips;
    let numbers = json!({ "width": narrowest, "strip": strip, "two_beams": two_beams.max(f64::EPSILON) });
    Ok(Claim { name: "any_elastic_body", verdict, numbers })
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
    let shares = largest(shared.iter().map(|force| force / load * (1.0 + GIRDER) / GIRDER - 1.0));
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
/// An outlook of the paper. There are two rigid motions, the algorithm does not start, and another start, a rigid beam on the foundation
/// below the resultant of the loads, is enough.
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
    assert!(rigid_motions == 2 && !first_step_works && solved, "{rigid_motions} {first_step_works} {solved}");
    let numbers = json!({ "rigid_motions": rigid_motions, "intervals": INTERVALS });
    Ok(Claim { name: "unknown_rigid_motion", verdict: Verdict::Outlook, numbers })
}
