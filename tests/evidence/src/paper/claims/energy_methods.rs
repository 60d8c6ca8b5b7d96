//! What the paper says of the force and the displacement method: the same result, whichever matrix is easier, bounds from both
//! sides, and that the former was new.

use nalgebra::DMatrix;
use palkki::certificate::{Judged, certify};
use palkki::methods::{Discrete, Method};
use palkki::qp::{Dense, FreeSet, Matrix, Qp, Stationary};
use palkki::scene::{Scene, SceneError};
use palkki::solvers::{Answer, Solver};
use palkki::state::Contact;
use palkki::text::power_of_ten;
use palkki::{Settings, solve_raw};

use super::{Claim, Verdict, bound};
use crate::compare::apart;
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, PRINTED_USEFUL_INTERVALS, example, theory};

/// Random scenes of each kind.
const SCENES: usize = 100;
/// Seed of the random scenes.
const SEED: u64 = 1984;
/// The difference that rounding may make: condition numbers here stay below 10⁷, so 16 digits leave nine.
const ROUNDING: f64 = 1e-9;

/// "Force and displacement method lead to entirely the same result here": the largest differences between the two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SameResult {
    /// Scenes that were compared.
    pub scenes: usize,
    /// Largest difference of a nodal deflection, over the largest deflection.
    pub deflection: f64,
    /// Largest difference of a nodal contact force, over the total load.
    pub contact_force: f64,
    /// Largest entry of `K C − I` with 29 interior nodes.
    pub inverse: f64,
}

/// Compares the methods, each with the matrix that the paper gives it, on the example and on random scenes, 30 intervals each.
///
/// # Errors
///
/// None for these scenes; the type is that of [`Discrete::new`].
pub fn same_result() -> Result<SameResult, SceneError> {
    let mut all = vec![example()?];
    for kind in Unevenness::ALL {
        all.extend(scenes(kind, SCENES, SEED)?);
    }
    let (mut deflection, mut contact_force) = (0.0_f64, 0.0_f64);
    for scene in &all {
        let (v, p) = differences(scene)?;
        (deflection, contact_force) = (deflection.max(v), contact_force.max(p));
    }
    Ok(SameResult { scenes: all.len(), deflection, contact_force, inverse: inverse_defect(INTERVALS)? })
}

fn differences(scene: &Scene) -> Result<(f64, f64), SceneError> {
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, INTERVALS)?;
    let nodal = |method: Method| {
        let qp = method.qp(&discrete);
        let (linear, sizes) = (qp.linear().into(), qp.sizes());
        let Answer { x, gradient, .. } =
            Solver::ActiveSet.run(&Dense { matrix: dense(qp.as_ref()), linear, sizes }, 0.0);
        method.nodal(&discrete, x, gradient)
    };
    let (a, b) = (nodal(Method::Displacement), nodal(Method::Force));
    let largest = b.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let total = scaled.scene.load().magnitude(scaled.scene.beam().length());
    Ok((apart(&a.deflection, &b.deflection) / largest, apart(&a.contact_force, &b.contact_force) / total))
}

/// The largest entry of `K C − I` on a grid of the example.
///
/// # Errors
///
/// None for the example; the type is that of [`Discrete::new`].
pub fn inverse_defect(intervals: usize) -> Result<f64, SceneError> {
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
        banded @ Matrix::Pentadiagonal(_) => {
            let n = banded.dimension();
            DMatrix::from_fn(n, n, |i, j| banded.entry(i, j))
        }
    }
}

impl SameResult {
    /// Whether the results are the same up to rounding.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.deflection.max(self.contact_force) <= ROUNDING { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "same_result",
            statement: "Force and displacement method lead to entirely the same result.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("the same up to rounding on {} scenes", self.scenes),
            evidence: format!(
                "The two quadratic programs are dual, and K C = I (largest entry of K C − I with n = 29: below {}). On the example and {} \
                 random uneven foundations, on 30 intervals, nodal deflections differ by less than {} of the largest one, \
                 contact forces by less than {} of the load.",
                bound(self.inverse),
                self.scenes - 1,
                bound(self.deflection),
                bound(self.contact_force),
            ),
        }
    }
}

/// "To our knowledge a solution of the contact problem based on the force method has not been presented in the literature in
/// this form."
///
/// A claim about the literature of 1984: nothing is measured, and no search can show that something was never printed.
pub(super) fn novelty() -> Claim {
    Claim {
        name: "novelty_of_the_force_method",
        statement: "To our knowledge a solution of the contact problem based on the force method has not been presented in the \
                    literature in this form.",
        verdict: Verdict::Open,
        reading: None,
        summary: "a claim about the literature of 1984; the principle was known, and we know of no earlier flexibility form for a beam"
            .to_owned(),
        evidence: "What can be said: the principle was not new. The paper itself says that the minimum of complementary energy under \
                   its constraints had long been known, and claims to have discretised it. That the minimum of potential energy under \
                   unilateral constraints has such a dual was known in general form (Prager 1963, Moreau 1968), and Kalker and van \
                   Randen (1972) computed the contact of half-spaces from a minimum over contact pressures that are not negative. \
                   We know of no earlier work that does this for a beam above a rigid foundation, with the flexibility matrix of the \
                   simply supported beam in closed form (26). What cannot be said: that there is none. We searched little, and the \
                   paper's own references of this kind, /11/ to /13/, are not available to us."
            .to_owned(),
    }
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

/// "Force or displacement method, whichever matrix is easier to compute; the flexibility matrix may be found in closed form."
#[derive(Debug, Clone, PartialEq)]
pub struct Recommendation {
    /// Largest entry of `K C − I` with 29 interior nodes, `C` from the closed form (26).
    pub closed_form: f64,
    /// Digits on the paper's grid and on a fine one.
    pub digits: [Digits; 2],
}

/// Measures on the example with the middle 60 % of the beam in contact, against the three-moment equations.
///
/// # Errors
///
/// None for the example; the type is that of [`Discrete::new`].
pub fn recommendation() -> Result<Recommendation, SceneError> {
    Ok(Recommendation { closed_form: inverse_defect(INTERVALS)?, digits: [digits(INTERVALS)?, digits(200)?] })
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
    let with_matrix = |method: Method| -> Dense {
        let qp = method.qp(&discrete);
        Dense { matrix: dense(qp.as_ref()), linear: qp.linear().into(), sizes: qp.sizes() }
    };
    let (stiffness, flexibility) = (with_matrix(Method::Displacement), with_matrix(Method::Force));
    let reference = forces(Method::Force.qp(&discrete).stationary(&touches).ok(), true);
    let error = |forces: Vec<f64>| apart(&forces, &reference) / total;
    let eigenvalues = stiffness.matrix.symmetric_eigenvalues();
    let least = flexibility.matrix.symmetric_eigenvalues().max().recip();
    Ok(Digits {
        intervals,
        condition: eigenvalues.max() / least,
        with_stiffness: error(forces(stiffness.stationary(&lifted).ok(), false)),
        with_flexibility: error(forces(flexibility.stationary(&touches).ok(), true)),
        // Scene and contact set are symmetric, the elimination runs from left to right: what differs is its rounding.
        without_matrix: error(reference.iter().rev().copied().collect()),
    })
}

/// A large number to two digits, `4.0·10⁵`.
fn power_of_ten_times(value: f64) -> String {
    let printed = format!("{value:.1e}");
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((&printed, "0"));
    format!("{mantissa}·{}", power_of_ten(exponent.parse().unwrap_or(0)))
}

impl Recommendation {
    /// The matrices are what the paper says; but on a fine grid going without them keeps more digits than either.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let fine = &self.digits[1];
        if 1e-9 < self.closed_form {
            Verdict::Refuted
        } else if fine.without_matrix < fine.with_stiffness.min(fine.with_flexibility) {
            Verdict::Qualified
        } else {
            Verdict::Confirmed
        }
    }

    pub(super) fn claim(&self) -> Claim {
        let line = |d: &Digits| {
            format!(
                "on {} intervals (condition number {}) contact forces are off by less than {} of the load \
                 with K, {} with C, and {} without either",
                d.intervals,
                power_of_ten_times(d.condition),
                bound(d.with_stiffness),
                bound(d.with_flexibility),
                bound(d.without_matrix),
            )
        };
        Claim {
            name: "whichever_matrix_is_easier",
            statement: "Force or displacement method, whichever matrix is easier to compute; C can often be found in closed form.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "K C = I holds; on {} intervals contact forces are off by less than {} with K, {} with C and {} without either",
                self.digits[1].intervals,
                bound(self.digits[1].with_stiffness),
                bound(self.digits[1].with_flexibility),
                bound(self.digits[1].without_matrix),
            ),
            evidence: format!(
                "C in closed form (26) is the inverse of the condensed K (largest entry of K C − I: below {}). But neither matrix is \
                 needed. Measured on a known contact set, with K and C against the three-moment equations, which do without \
                 either, and these against their own mirror image: {}; {}.",
                bound(self.closed_form),
                line(&self.digits[0]),
                line(&self.digits[1]),
            ),
        }
    }
}

/// Energy and penetration on one grid of the example.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energies {
    /// Number of intervals.
    pub intervals: usize,
    /// Energy of the displacement method over that of beam theory, minus one.
    pub energy: f64,
    /// Difference of the energies of the two methods, relative.
    pub difference: f64,
    /// Largest penetration between the nodes, over `u₀`.
    pub penetration: f64,
    /// Guaranteed bounds on the energy of the continuous beam from the contact forces of the force method, over the energy
    /// of beam theory: lower and upper, relative differences.
    pub bracket: [f64; 2],
}

/// "If in the force method there is no tension between the supports either, or in the displacement method the clearance is
/// positive between the supports too, the structural quantity stiffness D is bounded from above and from below."
#[derive(Debug, Clone, PartialEq)]
pub struct BothSides {
    /// Three grids.
    pub grids: Vec<Energies>,
}

/// Measures on the example, 20, 30 and 100 intervals.
///
/// # Errors
///
/// None for the example; the type is that of [`solve_raw`].
pub fn both_sides() -> Result<BothSides, SceneError> {
    let scene = example()?;
    let exact = theory().energy;
    // The zone between the two lift-off points of the closed form.
    let length = scene.beam().length();
    let zone = theory().lift_off.map(|a| Contact { from: a, to: length - a, ..Contact::at(a, 0.0) });
    let mut grids = Vec::new();
    for intervals in [PRINTED_USEFUL_INTERVALS, INTERVALS, 100] {
        let state = |method| solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).map(|o| o.state);
        let (displacement, force) = (state(Method::Displacement)?, state(Method::Force)?);
        let nodes = force.nodes.unwrap_or_default();
        let certificate = certify(&scene, Judged::Nodes(&nodes), zone.as_slice())?;
        let bracket = [certificate.energy_lower, certificate.energy_upper].map(|bound| (bound - exact) / exact.abs());
        grids.push(Energies {
            intervals,
            energy: displacement.energy / exact - 1.0,
            difference: (displacement.energy / force.energy - 1.0).abs(),
            // The foundation is flat at u₀ = 1, so that the largest deflection says how deep the beam goes.
            penetration: displacement.deflection.max - 1.0,
            bracket,
        });
    }
    Ok(BothSides { grids })
}

impl BothSides {
    /// The condition is essential: without it the two methods give one and the same number, which bounds nothing.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let same = self.grids.iter().all(|g| g.difference < 1e-9);
        let penetrates = self.grids.iter().any(|g| 1e-9 < g.penetration);
        match (same, penetrates) {
            (true, true) => Verdict::Qualified,
            (false, false) => Verdict::Confirmed,
            _ => Verdict::Refuted,
        }
    }

    pub(super) fn claim(&self) -> Claim {
        let line = |g: &Energies| {
            format!("{:.3} % of u₀ and {:+.2} % on {} intervals", 100.0 * g.penetration, 100.0 * g.energy, g.intervals)
        };
        let between = |g: &Energies| g.bracket[0] <= 0.0 && 0.0 <= g.bracket[1];
        let holds = if self.grids.iter().all(between) { "contains" } else { "does not contain" };
        let width = self.grids.iter().map(|g| g.bracket[1] - g.bracket[0]).fold(0.0, f64::max);
        Claim {
            name: "bounded_from_both_sides",
            statement: "Without tension, or penetration, between the nodes, the stiffness D is bounded from both sides.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "not by nodes alone: between them the beam goes up to {:.2} % of u₀ below the ground on coarse grids; `palkki certify` \
                 computes such bounds",
                100.0 * self.grids.iter().map(|g| g.penetration).fold(0.0, f64::max),
            ),
            evidence: format!(
                "The condition is not met by the methods as they stand. They have constraints at the nodes only, and both then have \
                 the same energy (the two differ by less than {}), which is one number and no pair of bounds. Between the nodes the \
                 beam goes below the ground; the penetration and the difference of the energy from beam theory are {}. \
                 If the deflection is changed so that it stays above the ground between the nodes too, the claim can be carried out: \
                 `palkki certify` bounds the energy of the continuous beam from both sides, from the contact forces alone. On each of \
                 these grids the interval {holds} the energy of beam theory, and it is narrower than {} of that energy.",
                // Two sums that end in the same bits still say no more than that.
                bound(self.grids.iter().map(|g| g.difference).fold(f64::EPSILON, f64::max)),
                self.grids.iter().map(line).collect::<Vec<_>>().join("; "),
                bound(width),
            ),
        }
    }
}
