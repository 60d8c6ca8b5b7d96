//! Proven error bounds for the optimum of a body, and from them for any answer.
//!
//! ```text
//! 1  λ_min(A) ≥ τ > 0       Cholesky's factorisation of A − σ succeeds, and σ exceeds its rounding errors
//! 2  x ≥ 0                  solved on the free variables of some answer, refined in twice the precision; negative parts are set to zero
//! 3  r = A x − b − λ        with λ = g where x = 0 and g is certainly positive, else 0: for the optimum x* and δ = x − x*
//!                           δᵀA δ = rᵀδ + (x − x*)ᵀ(λ − λ*) ≤ ‖r‖ ‖δ‖,  as xᵀλ = x*ᵀλ* = 0
//!        ‖δ‖ ≤ ‖r‖/τ        since τ ‖δ‖² ≤ δᵀA δ
//!        |A δ|_i ≤ √a_ii ‖r‖/√τ      Cauchy and Schwarz in A
//!        0 ≤ f(x) − f* ≤ rᵀδ − ½ δᵀA δ ≤ ½ ‖r‖²/τ
//! 4  any answer y           max|y − x| − ε ≤ max|y − x*| ≤ max|y − x| + ε
//! ```
//!
//! *Step 1.* Factors `L` with rows of at most `w` numbers, from sums in any order, are the exact factors of a matrix close to
//! `A − σ`. It differs by at most `γ/(1 − γ) √(a_ii a_jj)` with `γ = (w + 1) u/(1 − (w + 1) u)`, only at positions inside the
//! profile (Demmel 1989; Higham 2002, theorems 10.3 and 10.5; Rump 2006). `L Lᵀ` has no negative eigenvalue, and no eigenvalue of
//! a symmetric matrix exceeds its largest row sum. The set of free variables is only a candidate: a wrong one leads to wide
//! bounds, but never to false ones.

mod judge;

use super::reach;
use super::{Body, Kind};
use crate::double::Double;
use crate::qp::{Explicit, NotPositiveDefinite, Sums};

/// A point close to the optimum with proven error bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Proof {
    clearance: Vec<Double>,
    /// A bound on the error of each clearance.
    pub error: f64,
    force: Vec<Double>,
    force_error: f64,
    /// Lower and upper bound on the energy of the optimum.
    pub energy: [f64; 2],
    /// The part of their distance that is not rounding, `½ ‖r‖²/τ`.
    pub gap: f64,
    /// `τ`.
    pub least_eigenvalue: f64,
    /// The reference values of errors.
    pub sizes: Sizes,
}

/// Reference values for the errors of a body: the largest value of each quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// The smaller of the largest displacement and the largest clearance that the loads could close. If nothing moves, the
    /// largest displacement without a foundation; without loads the largest clearance, and 1 if there is none.
    pub clearance: f64,
    /// The largest contact force; if there is none, the largest load, and 1 without loads.
    pub force: f64,
    /// The energy; if it is zero, the energy of the body without a foundation, and 1 without loads.
    pub energy: f64,
}

/// Bounds on the maximum error of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Off {
    /// Lower bound on the maximum error.
    pub least: f64,
    /// Upper bound on the maximum error.
    pub most: f64,
    /// The upper bound relative to the [reference value](Proof::sizes) of the quantity.
    pub share: f64,
}

impl Off {
    fn new([least, most]: [f64; 2], size: f64) -> Self {
        Self { least, most, share: most / size }
    }
}

/// Error bounds for an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// For the clearances.
    pub clearance: Off,
    /// For the contact forces.
    pub force: Off,
    /// For the energy.
    pub energy: Off,
}

impl Errors {
    /// The bounds if nothing is proven.
    pub(crate) const UNKNOWN: Self = {
        let unknown = Off { least: 0.0, most: f64::INFINITY, share: f64::INFINITY };
        Self { clearance: unknown, force: unknown, energy: unknown }
    };
}

/// The reason why nothing is proven.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unproven {
    /// The matrix is too close to a singular one.
    #[error(
        "nothing could be proven: the least eigenvalue of the matrix, about {estimate:.1e}, is not above what its proof rounds off, {lost:.1e}"
    )]
    Eigenvalue {
        /// Estimate from inverse iteration.
        estimate: f64,
        /// Bound on the error of a factorisation.
        lost: f64,
    },
    /// Numbers of the body are too large, or their magnitudes differ too much.
    #[error("nothing could be proven: numbers on the way go beyond the range of 64-bit floating point")]
    Range,
    /// A degree of freedom that was considered out of reach of the foundation may be in contact.
    #[error("nothing could be proven: whether the loads bring freedom {} to its ground", freedom + 1)]
    Reach {
        /// The degree of freedom, from 0.
        freedom: usize,
    },
    /// Rounding made the matrix of the free variables indefinite.
    #[error("nothing could be proven: {0}")]
    Face(#[from] NotPositiveDefinite),
}

/// The answer of another program for a body.
#[derive(Debug, Clone, PartialEq)]
pub enum Brought {
    /// Clearances of all degrees of freedom.
    Clearance(Vec<f64>),
    /// Contact forces at all degrees of freedom.
    Force(Vec<f64>),
}

/// Covers the rounding of some millions of additions of magnitudes.
const UP: f64 = 1.0 + 1e-9;

/// Displacements, clearances, forces and energies below this fraction of the terms of which they are the difference count as
/// zero: it exceeds the rounding of input with sixteen digits.
const NONE: f64 = 1e-12;

/// Fractions of the estimate that are tried for `σ`.
const SHIFTS: [f64; 3] = [0.9, 0.5, 0.1];

/// Proves a lower bound `τ` on the smallest eigenvalue.
fn least_eigenvalue(qp: &Explicit) -> Result<f64, Unproven> {
    let all = qp.order();
    let a = &qp.profile().part(all, 0.0);
    let n = a.dimension();
    let estimate = reach::least_eigenvalue(qp, &vec![1.0; n]);
    let most = |values: Vec<f64>| values.into_iter().fold(0.0, f64::max);
    let roots: Vec<f64> = a.diagonal().map(f64::sqrt).collect();
    let diagonal = most(a.diagonal().collect());
    #[expect(clippy::cast_precision_loss, reason = "far below 2⁵³")]
    let width = (0..n).map(|i| a.row(i).len()).max().unwrap_or(0) as f64;
    let unit = 0.5 * f64::EPSILON;
    let gamma = (width + 1.0) * unit / (1.0 - 2.0 * (width + 1.0) * unit);
    let factors = gamma * most(a.row_sums(|i, j, _| roots[i] * roots[j]));
    // Products and quotients below the range of 64-bit numbers.
    let tiny = most(a.row_sums(|_, _, _| 1.0)) * width * f64::MIN_POSITIVE * (1.0 + diagonal.sqrt());
    let rest = most(qp.rest().row_sums(|_, _, a| a.abs()));
    let lost = (factors + unit * diagonal + rest + tiny) * UP;
    let proven = SHIFTS.into_iter().map(|share| share * estimate).find_map(|shift| {
        let least = (shift - lost) * (1.0 - f64::EPSILON);
        (0.0 < least && qp.profile().part(all, shift).cholesky().is_ok()).then_some(least)
    });
    proven.ok_or(Unproven::Eigenvalue { estimate, lost })
}

/// `Σ x_i y_i`, and a bound on its error. The third number of each term bounds the error of `y_i`.
fn inner(terms: impl Iterator<Item = (Double, Double, f64)>) -> (Double, f64) {
    let (mut sum, mut size, mut off, mut count) = (Double::ZERO, 0.0, 0.0, 0.0);
    for (x, y, y_off) in terms {
        sum = sum + x * y;
        size += (x.rounded() * y.rounded()).abs();
        off += x.rounded().abs() * y_off;
        count += 1.0;
    }
    (sum, (off + count * (size * Sums::STEP + f64::MIN_POSITIVE)) * UP)
}

/// The part of the energy of a body that its program does not contain: `½ gᵀ(b − q)` for a stiffness, `−½ qᵀ(b + g)` for a
/// flexibility.
fn constant(body: &Body) -> (Double, f64) {
    let b = body.program.right();
    let half = |x: f64| Double::exact(0.5 * x);
    let each = body.reach.gap.iter().zip(&body.load).enumerate();
    match body.kind {
        Kind::Stiffness => {
            inner(each.map(|(i, (gap, load))| (half(*gap), b.values[i] - Double::exact(*load), b.off(i))))
        }
        Kind::Flexibility => {
            inner(each.map(|(i, (gap, load))| (half(-load), b.values[i] + Double::exact(*gap), b.off(i))))
        }
    }
}

/// `½ Σ x_i (A x − b)_i + share x_i b_i`, with a bound on its rounding error. It is the objective of the program if `share` is
/// −½, and `½ xᵀ A x` if it is ½.
fn half_products(body: &Body, x: &[Double], gradient: &Sums, share: f64) -> (Double, f64) {
    let b = body.program.right();
    inner(x.iter().enumerate().flat_map(|(i, x)| {
        [
            (Double::exact(0.5) * *x, gradient.values[i], gradient.off(i)),
            (Double::exact(share) * *x, b.values[i], b.off(i)),
        ]
    }))
}

/// The potential energy of a body for these variables and this gradient of its program, with a bound on its rounding error.
pub(super) fn energy(body: &Body, x: &[Double], gradient: &Sums) -> (Double, f64) {
    let share = if body.kind == Kind::Stiffness { -0.5 } else { 0.5 };
    let (sum, sum_off) = half_products(body, x, gradient, share);
    let (constant, constant_off) = constant(body);
    let energy = constant + sum;
    (energy, (sum_off + constant_off) * UP + f64::EPSILON * energy.rounded().abs())
}

/// Proves error bounds for a point close to the optimum, computed from the free variables of any answer.
///
/// # Errors
///
/// [`Unproven`].
pub fn prove(body: &Body, free: impl Iterator<Item = bool>) -> Result<Proof, Unproven> {
    let qp = &body.program;
    let least = least_eigenvalue(qp)?;
    let chosen: Vec<usize> = free.enumerate().filter(|(_, free)| *free).map(|(i, _)| i).collect();
    let mut x = qp.solved(&chosen, &[], None)?;
    x.iter_mut().filter(|x| x.rounded() <= 0.0).for_each(|x| *x = Double::ZERO);
    let found = qp.gradient_at(&x);
    let offs: Vec<f64> = (0..x.len()).map(|i| found.off(i)).collect();
    let square: f64 = (0..x.len())
        .map(|i| {
            let gradient = found.values[i].rounded();
            let multiplier = x[i] == Double::ZERO && offs[i] * UP < gradient;
            let rest = if multiplier { 0.0 } else { gradient.abs() + offs[i] };
            rest * rest
        })
        .sum();
    let rest = (square * UP).sqrt() * UP + f64::MIN_POSITIVE;
    let gap = 0.5 * (rest / least) * rest * UP;
    let x_error = rest / least * UP;
    let diagonal = qp.profile().diagonal().fold(0.0, f64::max);
    let off = offs.iter().copied().fold(0.0, f64::max);
    let gradient_error = ((diagonal * UP).sqrt() * rest / least.sqrt() + off) * UP;
    let (objective, objective_off) = half_products(body, &x, &found, -0.5);
    let (constant, constant_off) = constant(body);
    let gradient = found.values;
    let (energy, below, above, [clearance, force], [error, force_error]) = match body.kind {
        Kind::Stiffness => (constant + objective, gap, 0.0, [x, gradient], [x_error, gradient_error]),
        Kind::Flexibility => (constant - objective, 0.0, gap, [gradient, x], [gradient_error, x_error]),
    };
    let energy_off = (objective_off + constant_off) * UP + f64::EPSILON * energy.rounded().abs();
    let energy = [energy.rounded() - (energy_off + below) * UP, energy.rounded() + (energy_off + above) * UP];
    let bounds = [energy[0], energy[1], error, force_error, gap];
    if !bounds.iter().all(|bound| bound.is_finite()) {
        return Err(Unproven::Range);
    }
    // If the point is clear of a reduced gap, the contact force there is zero. The optimum is then the same for the larger gap.
    let touching = (0..clearance.len()).find(|i| body.is_out_of_reach(*i) && clearance[*i].rounded() <= error * UP);
    if let Some(freedom) = touching {
        return Err(Unproven::Reach { freedom });
    }
    let sizes = sizes(body, [&clearance, &force], [error, force_error], energy);
    Ok(Proof { clearance, error, force, force_error, energy, gap, least_eigenvalue: least, sizes })
}

/// Computes the reference values; see [`Sizes`].
fn sizes(
    body: &Body,
    [clearance, force]: [&[Double]; 2],
    [error, force_error]: [f64; 2],
    [lower, upper]: [f64; 2],
) -> Sizes {
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, value| most.max(value.abs()));
    let counts = |value: f64, least: f64| Some(value).filter(|value| least < *value);
    let near = clearance.iter().enumerate().filter(|(i, _)| !body.is_out_of_reach(*i));
    let clear = most(&mut near.map(|(_, h)| h.rounded()));
    let displacement: Vec<f64> =
        clearance.iter().zip(&body.reach.gap).map(|(h, gap)| (Double::exact(*gap) - *h).rounded()).collect();
    let moved = most(&mut displacement.iter().copied());
    let closed =
        counts(moved, error).map(|moved| counts(clear, error.max(NONE * moved)).map_or(moved, |c| c.min(moved)));
    let [free, load] = [&body.reach.free, &body.load].map(|values| most(&mut values.iter().copied()));
    let pressed = most(&mut force.iter().map(|p| p.rounded()));
    let work = |moved: &[f64]| moved.iter().zip(&body.load).map(|(v, q)| (v * q).abs()).sum::<f64>();
    let energy = lower.abs().max(upper.abs());
    let first = |sizes: [Option<f64>; 3]| sizes.into_iter().flatten().next().unwrap_or(1.0);
    Sizes {
        clearance: first([closed, counts(free, 0.0), counts(clear, error)]),
        force: first([counts(pressed, force_error.max(NONE * load)), counts(load, 0.0), None]),
        energy: first([
            counts(energy, (upper - lower).max(NONE * work(&displacement))),
            counts(0.5 * work(&body.reach.free), 0.0),
            None,
        ]),
    }
}

/// Lower and upper bound on the largest difference between numbers and the exact ones, which are known up to an error.
fn apart(known: &[Double], found: impl Iterator<Item = Double>, error: f64) -> [f64; 2] {
    let most = known.iter().zip(found).map(|(known, found)| (*known - found).rounded().abs());
    // `f64::max` would ignore NaN.
    let most = most.fold(0.0, |most: f64, apart| if most.is_nan() || apart <= most { most } else { apart });
    let most = if most.is_finite() { most } else { f64::INFINITY };
    // Differences in twice the precision are rounded once.
    let rounding = f64::EPSILON;
    [(most * (1.0 - rounding) - error * UP).max(0.0), most * (1.0 + rounding) + error * UP]
}
