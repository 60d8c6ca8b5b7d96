//! What the paper says of the force and the displacement method: the same result, whichever matrix is easier, bounds from both
//! sides, and that the former was new.

use nalgebra::DMatrix;
use palkki::certificate::{Judged, certify};
use palkki::methods::{Discrete, Method};
use palkki::qp::{Explicit, FreeSet, Matrix, Profile, Qp, Stationary};
use palkki::scene::{Scene, SceneError};
use palkki::solvers::{Answer, Solver};
use palkki::state::Contact;
use palkki::{Settings, solve_raw};
use serde_json::json;

use super::{Claim, Verdict};
use crate::compare::{apart, largest};
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, PRINTED_USEFUL_INTERVALS, example, theory};

/// Random scenes of each kind.
const SCENES: usize = 100;
/// Seed of the random scenes.
const SEED: u64 = 1984;
/// Rounding where condition numbers of up to 10⁵ stand between two ways of computing the same.
const CONDITIONED: f64 = 1e-10;
/// The product of two matrices whose condition numbers are 10⁵ at most, and some digits to spare.
const INVERSE: f64 = 1e-8;

/// "Force and displacement method lead to entirely the same result here".
///
/// Compares the methods, each with the matrix that the paper gives it, on the example and on random scenes, 30 intervals each.
pub(super) fn same_result() -> Result<Claim, SceneError> {
    let mut all = vec![example()?];
    for kind in Unevenness::ALL {
        all.extend(scenes(kind, SCENES, SEED)?);
    }
    let (mut deflection, mut contact_force) = (0.0_f64, 0.0_f64);
    for scene in &all {
        let (v, p) = differences(scene)?;
        (deflection, contact_force) = (deflection.max(v), contact_force.max(p));
    }
    let inverse = inverse_defect(INTERVALS)?;
    assert!(200 < all.len(), "the words speak of at least two hundred uneven foundations: {}", all.len());
    assert!(inverse < INVERSE, "K C = I: {inverse}");
    let verdict = Verdict::of(deflection.max(contact_force) <= CONDITIONED);
    let numbers = json!({
        "scenes": all.len(), "uneven": all.len() - 1, "deflection": deflection, "force": contact_force, "inverse": inverse,
    });
    Ok(Claim { name: "same_result", verdict, numbers })
}

/// Largest difference of a nodal deflection over the largest one, and of a contact force over the total load.
fn differences(scene: &Scene) -> Result<(f64, f64), SceneError> {
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, INTERVALS)?;
    let nodal = |method: Method| {
        let qp = method.qp(&discrete);
        let Answer { x, gradient, .. } = Solver::ActiveSet.run(&explicit(qp.as_ref()), 0.0);
        method.nodal(&discrete, x, gradient)
    };
    let (a, b) = (nodal(Method::Displacement), nodal(Method::Force));
    let largest = b.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let total = scaled.scene.load().magnitude(scaled.scene.beam().length());
    Ok((apart(&a.deflection, &b.deflection) / largest, apart(&a.contact_force, &b.contact_force) / total))
}

/// The largest entry of `K C − I` on a grid of the example.
fn inverse_defect(intervals: usize) -> Result<f64, SceneError> {
    let scene = example()?;
    let discrete = Discrete::new(&scene, intervals)?;
    let matrix = |method: Method| dense(method.qp(&discrete).as_ref());
    let product = matrix(Method::Displacement) * matrix(Method::Force);
    Ok((&product - DMatrix::identity(product.nrows(), product.ncols())).amax())
}

/// The matrix of a quadratic program as numbers in rows and columns.
#[must_use]
pub fn dense(qp: &dyn Qp) -> DMatrix<f64> {
    match qp.matrix() {
        Matrix::Dense(a) => a,
        other @ (Matrix::Pentadiagonal(_) | Matrix::Profile(_)) => {
            let n = other.dimension();
            DMatrix::from_fn(n, n, |i, j| other.entry(i, j))
        }
    }
}

/// A quadratic program that knows nothing but its matrix.
///
/// # Panics
///
/// If rounding has destroyed its definiteness, as it does with conditions beyond 1e16.
#[must_use]
pub fn explicit(qp: &dyn Qp) -> Explicit {
    let matrix = qp.matrix();
    let matrix = Profile::full(matrix.dimension(), |i, j| matrix.entry(i, j));
    Explicit::new(matrix, &qp.linear()).expect("positive definite")
}

/// What the matrices cost in digits on one grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Digits {
    /// Number of intervals.
    pub intervals: usize,
    /// Condition number of `K`, which is that of `C` as well.
    pub condition: f64,
    /// Largest error of a contact force over the total load, when the contact set is known and `K` is factorised.
    pub with_stiffness: f64,
    /// The same with `C`.
    pub with_flexibility: f64,
    /// The same without either, by the three-moment equations: by how much forces at mirror images differ.
    pub without_matrix: f64,
}

/// Digits on the paper's grid and on a fine one, with the middle 60 % of the beam in contact.
pub(super) fn digits_lost() -> Result<[Digits; 2], SceneError> {
    Ok([digits(INTERVALS)?, digits(200)?])
}

fn digits(intervals: usize) -> Result<Digits, SceneError> {
    let scaled = example()?.scaled()?;
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let touches: FreeSet = (1..intervals).map(|i| 5 * i >= intervals && 5 * i <= 4 * intervals).collect();
    let lifted: FreeSet = touches.iter().map(|t| !t).collect();
    let total: f64 = discrete.interior_loads().iter().sum();

    // Contact forces on a known contact set by four ways: the three-moment equations are the reference.
    let forces = |point: Option<Stationary>, of_x: bool| -> Vec<f64> {
        point.map_or_else(|| vec![f64::NAN; intervals - 1], |p| if of_x { p.x } else { p.gradient })
    };
    let [stiffness, flexibility] = [Method::Displacement, Method::Force].map(|method| method.qp(&discrete));
    let largest = |qp: &dyn Qp| dense(qp).symmetric_eigenvalues().max();
    let reference = forces(Method::Force.qp(&discrete).stationary(&touches).ok(), true);
    let error = |forces: Vec<f64>| apart(&forces, &reference) / total;
    Ok(Digits {
        intervals,
        condition: largest(stiffness.as_ref()) * largest(flexibility.as_ref()),
        with_stiffness: error(forces(explicit(stiffness.as_ref()).stationary(&lifted).ok(), false)),
        with_flexibility: error(forces(explicit(flexibility.as_ref()).stationary(&touches).ok(), true)),
        // Scene and contact set are symmetric, the elimination runs from left to right: what differs is its rounding.
        without_matrix: error(reference.iter().rev().copied().collect()),
    })
}

/// "Force or displacement method, whichever matrix is easier to compute; the flexibility matrix may be found in closed form."
///
/// The matrices are what the paper says; but on a fine grid going without them keeps more digits than either.
pub(super) fn whichever_matrix_is_easier(digits: &[Digits; 2]) -> Result<Claim, SceneError> {
    let [paper, fine] = digits;
    let growth = fine.condition / paper.condition;
    assert!(
        (1500.0..2500.0).contains(&growth),
        "cond(K) grows like n⁴, from 30 to 200 intervals by about 2000: {growth}"
    );
    // With `C` from the closed form (26).
    let inverse = inverse_defect(INTERVALS)?;
    let verdict = if INVERSE < inverse {
        Verdict::Refuted
    } else if fine.without_matrix < fine.with_stiffness.min(fine.with_flexibility) {
        Verdict::Qualified
    } else {
        Verdict::Confirmed
    };
    let line = |d: &Digits| {
        json!({
            "intervals": d.intervals, "condition": d.condition, "with_stiffness": d.with_stiffness,
            "with_flexibility": d.with_flexibility, "without": d.without_matrix,
        })
    };
    let numbers = json!({ "inverse": inverse, "grids": digits.iter().map(line).collect::<Vec<_>>() });
    Ok(Claim { name: "whichever_matrix_is_easier", verdict, numbers })
}

/// How narrow a bracket of the energy is, as a share of it, if its condition is satisfied between the nodes too.
const PROVEN: f64 = 1e-9;

/// "If in the force method there is no tension between the supports either, or in the displacement method the clearance is
/// positive between the supports too, the structural quantity stiffness D is bounded from above and from below."
///
/// The condition is essential: without it the two methods give one and the same number, which bounds nothing.
pub(super) fn bounded_from_both_sides() -> Result<Claim, SceneError> {
    let scene = example()?;
    let exact = theory().energy;
    // The zone between the two lift-off points of the closed form.
    let length = scene.beam().length();
    let zone = theory().lift_off.map(|a| Contact { from: a, to: length - a, ..Contact::at(a, 0.0) });
    let (mut grids, mut differences, mut penetrations, mut width, mut stiffness) =
        (Vec::new(), Vec::new(), Vec::new(), 0.0_f64, None);
    for intervals in [PRINTED_USEFUL_INTERVALS, INTERVALS, 100] {
        let state = |method| solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).map(|o| o.state);
        let (displacement, force) = (state(Method::Displacement)?, state(Method::Force)?);
        let nodes = force.nodes.unwrap_or_default();
        let certificate = certify(&scene, Judged::Nodes(&nodes), zone.as_slice())?;
        let [lower, upper] = [certificate.energy_lower, certificate.energy_upper].map(|e| (e - exact) / exact.abs());
        assert!(lower <= 0.0 && 0.0 <= upper, "the bracket holds beam theory: {lower} {upper}");
        // The foundation is flat at u₀ = 1, so that the largest deflection says how deep the beam goes between the nodes.
        let (penetration, energy) = (displacement.deflection.max - 1.0, displacement.energy / exact - 1.0);
        assert!(energy < 0.0, "the energy is above the exact one, which is negative: {energy}");
        grids.push(json!({ "intervals": intervals, "energy": energy, "penetration": penetration }));
        differences.push((displacement.energy / force.energy - 1.0).abs());
        penetrations.push(penetration);
        width = width.max(upper - lower);
        stiffness = certificate.stiffness;
    }
    let difference = largest(differences);
    let penetrates = penetrations.iter().all(|depth| 1e-9 < *depth);
    // The paper states the condition, and the nodal constraints alone do not satisfy it: both methods then have one and the same number.
    assert!(difference < CONDITIONED && penetrates, "{difference} {penetrations:?}");
    let verdict = Verdict::of(width < PROVEN);
    // Two sums that end in the same bits still say no more than that.
    let difference = difference.max(f64::EPSILON);
    let numbers = json!({
        "grids": grids, "difference": difference, "width": width, "penetration": largest(penetrations), "stiffness": stiffness,
    });
    Ok(Claim { name: "bounded_from_both_sides", verdict, numbers })
}
