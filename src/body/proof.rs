//! What is proven of the optimum of a body, and from it of any answer.
//!
//! ```text
//! 1  λ_min(A) ≥ τ > 0       Cholesky's factorisation of A − σ ends, and σ is more than it may have rounded
//! 2  x ≥ 0                  solved on the free variables of some answer, refined in twice the precision; negative parts are zero
//! 3  r = A x − b − λ        with λ = g where x = 0 and g is certainly positive, else 0: for the optimum x* and δ = x − x*
//!                           δᵀA δ = rᵀδ + (x − x*)ᵀ(λ − λ*) ≤ ‖r‖ ‖δ‖,  as xᵀλ = x*ᵀλ* = 0
//!        ‖δ‖ ≤ ‖r‖/τ        since τ ‖δ‖² ≤ δᵀA δ
//!        |A δ|_i ≤ √a_ii ‖r‖/√τ      Cauchy and Schwarz in A
//!        0 ≤ f(x) − f* ≤ rᵀδ − ½ δᵀA δ ≤ ½ ‖r‖²/τ
//! 4  any answer y           max|y − x| − ε ≤ max|y − x*| ≤ max|y − x| + ε
//! ```
//!
//! *Step 1.* Factors `L` of rows of at most `w` numbers, from sums in any order, are the exact ones of a matrix beside `A − σ`, off by
//! at most `γ/(1 − γ) √(a_ii a_jj)` with `γ = (w + 1) u/(1 − (w + 1) u)`, in the places of the profile alone (Demmel 1989; Higham
//! 2002, theorems 10.3 and 10.5; Rump 2006). `L Lᵀ` has no negative eigenvalue, and none of a symmetric matrix is larger than its
//! largest row sum. A face is only a witness: from a wrong one bounds are wide, and never untrue.

use super::{Body, Kind};
use crate::double::Double;
use crate::qp::{Explicit, NotPositiveDefinite, Sums};

/// A proven point beside the optimum.
#[derive(Debug, Clone, PartialEq)]
pub struct Proof {
    clearance: Vec<Double>,
    /// What each clearance is off at most.
    pub error: f64,
    force: Vec<Double>,
    force_error: f64,
    /// Lower and upper bound of the energy of the optimum.
    pub energy: [f64; 2],
    /// A bound on their distance without what is rounded: `½ ‖r‖²/τ`.
    pub gap: f64,
    /// `τ`.
    pub least_eigenvalue: f64,
    /// The largest clearance; where there is none the largest displacement, and 1 where nothing moves.
    pub size: f64,
}

/// How far clearances are off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Off {
    /// The largest error of one of them is at least this,
    pub least: f64,
    /// and at most this,
    pub most: f64,
    /// which is such a share of their [size](Proof::size).
    pub share: f64,
}

/// Why nothing is proven.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unproven {
    /// The matrix is too near to a singular one.
    #[error(
        "nothing could be proven: the least eigenvalue of the matrix, about {estimate:.1e}, is not above what its proof rounds off, {lost:.1e}"
    )]
    Eigenvalue {
        /// By inverse iteration.
        estimate: f64,
        /// What a factorisation may be off.
        lost: f64,
    },
    /// The numbers of the body are too large or too far apart.
    #[error("nothing could be proven: numbers on the way go beyond the range of 64-bit floating point")]
    Range,
    /// Rounding destroyed a face.
    #[error("nothing could be proven: {0}")]
    Face(#[from] NotPositiveDefinite),
}

/// What a program brought for a body.
#[derive(Debug, Clone, PartialEq)]
pub enum Brought {
    /// Clearances of all freedoms.
    Clearance(Vec<f64>),
    /// Contact forces on all freedoms.
    Force(Vec<f64>),
}

/// More than what some million roundings of sums of magnitudes leave.
const UP: f64 = 1.0 + 1e-9;

/// Steps of inverse iteration: the estimate needs one digit.
const STEPS: usize = 12;

/// Shares of the estimate that are tried for `σ`.
const SHIFTS: [f64; 3] = [0.9, 0.5, 0.1];

/// `τ`.
fn least_eigenvalue(qp: &Explicit) -> Result<f64, Unproven> {
    let a = qp.profile();
    let n = a.dimension();
    // Neither symmetric nor smooth, so that no eigenvector is missing in it.
    let mut v: Vec<f64> = (0..n).map(|i| f64::from(u8::try_from(i * 7919 % 101).unwrap_or(0)) + 300.0).collect();
    let norm = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
    let mut estimate = f64::INFINITY;
    for _ in 0..STEPS {
        let size = norm(&v);
        v.iter_mut().for_each(|v| *v /= size);
        qp.factor().solve(&mut v);
        estimate = 1.0 / norm(&v);
    }
    let most = |values: Vec<f64>| values.into_iter().fold(0.0, f64::max);
    let roots: Vec<f64> = a.diagonal().map(f64::sqrt).collect();
    let diagonal = most(a.diagonal().collect());
    #[expect(clippy::cast_precision_loss, reason = "far below 2⁵³")]
    let width = (0..n).map(|i| a.row(i).len()).max().unwrap_or(0) as f64;
    let unit = 0.5 * f64::EPSILON;
    let gamma = (width + 1.0) * unit / (1.0 - 2.0 * (width + 1.0) * unit);
    let factors = gamma * most(a.row_sums(|i, j, _| roots[i] * roots[j]));
    // Products and quotients below the range of 64 bits.
    let tiny = most(a.row_sums(|_, _, _| 1.0)) * width * f64::MIN_POSITIVE * (1.0 + diagonal.sqrt());
    let rest = most(qp.rest().row_sums(|_, _, a| a.abs()));
    let lost = (factors + unit * diagonal + rest + tiny) * UP;
    let all: Vec<usize> = (0..n).collect();
    let proven = SHIFTS.into_iter().map(|share| share * estimate).find_map(|shift| {
        let least = (shift - lost) * (1.0 - f64::EPSILON);
        (0.0 < least && a.part(&all, shift).cholesky().is_ok()).then_some(least)
    });
    proven.ok_or(Unproven::Eigenvalue { estimate, lost })
}

/// `Σ x_i y_i` of numbers that are off by at most the third, and what the sum is off.
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

/// What the energy of a body has besides the objective of its program: `½ gᵀ(b − q)` of a stiffness, `−½ qᵀ(b + g)` of a flexibility.
pub(super) fn constant(body: &Body) -> (Double, f64) {
    let b = body.program.right();
    let half = |x: f64| Double::exact(0.5 * x);
    let each = body.gap.iter().zip(&body.load).enumerate();
    match body.kind {
        Kind::Stiffness => {
            inner(each.map(|(i, (gap, load))| (half(*gap), b.values[i] - Double::exact(*load), b.off(i))))
        }
        Kind::Flexibility => {
            inner(each.map(|(i, (gap, load))| (half(-load), b.values[i] + Double::exact(*gap), b.off(i))))
        }
    }
}

/// Proves a point beside the optimum, from the free variables of any answer.
///
/// # Errors
///
/// [`Unproven`].
pub fn prove(body: &Body, free: impl Iterator<Item = bool>) -> Result<Proof, Unproven> {
    let qp = &body.program;
    let least = least_eigenvalue(qp)?;
    let chosen: Vec<usize> = free.enumerate().filter(|(_, free)| *free).map(|(i, _)| i).collect();
    let mut x = qp.solved(&chosen, &[])?;
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
    let b = qp.right();
    let each = (0..x.len()).map(|i| (Double::exact(0.5) * x[i], found.values[i] - b.values[i], offs[i] + b.off(i)));
    let (objective, objective_off) = inner(each);
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
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, value| most.max(value.abs()));
    let clear = most(&mut clearance.iter().map(|h| h.rounded()));
    let moved = most(&mut clearance.iter().zip(&body.gap).map(|(h, gap)| gap - h.rounded()));
    let size = [clear, moved].into_iter().find(|size| error < *size).unwrap_or(1.0);
    Ok(Proof { clearance, error, force, force_error, energy, gap, least_eigenvalue: least, size })
}

impl Proof {
    /// How far some clearances are off.
    #[must_use]
    pub fn off(&self, clearance: &[f64]) -> Off {
        self.off_by(clearance.iter().copied().map(Double::exact), self.error)
    }

    fn off_by(&self, clearance: impl Iterator<Item = Double>, error: f64) -> Off {
        let [least, most] = apart(&self.clearance, clearance, error);
        Off { least, most, share: most / self.size }
    }

    /// What the largest error of some contact forces is at least and at most.
    #[must_use]
    pub fn force_off(&self, force: &[f64]) -> [f64; 2] {
        apart(&self.force, force.iter().copied().map(Double::exact), self.force_error)
    }

    /// The clearances that an answer has, or that its forces cause, and how far they are off.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] never of a body that there is.
    pub fn judge(&self, body: &Body, brought: &Brought) -> Result<(Vec<f64>, Off), NotPositiveDefinite> {
        let qp = &body.program;
        let exact = |values: &[f64]| values.iter().copied().map(Double::exact).collect::<Vec<_>>();
        let (clearance, off) = match (brought, body.kind) {
            (Brought::Clearance(clearance), _) => (exact(clearance), 0.0),
            (Brought::Force(force), Kind::Flexibility) => {
                let sums = qp.gradient_at(&exact(force));
                let off = (0..force.len()).map(|i| sums.off(i)).fold(0.0, f64::max);
                (sums.values, off)
            }
            (Brought::Force(force), Kind::Stiffness) => {
                let all: Vec<usize> = (0..force.len()).collect();
                let x = qp.solved(&all, force)?;
                let found = qp.gradient_at(&x);
                let rest = |i: usize| (found.values[i] - Double::exact(force[i])).rounded().abs() + found.off(i);
                let square: f64 = all.iter().map(|&i| rest(i) * rest(i)).sum();
                (x, square.sqrt() / self.least_eigenvalue * UP)
            }
        };
        // What may be nothing but the rounding of its own solve is zero.
        let rounded = clearance.iter().map(|h| if h.rounded().abs() <= off { 0.0 } else { h.rounded() }).collect();
        Ok((rounded, self.off_by(clearance.into_iter(), (self.error + off) * UP)))
    }
}

/// How far numbers are from others that are known up to an error, at least and at most.
fn apart(known: &[Double], found: impl Iterator<Item = Double>, error: f64) -> [f64; 2] {
    let most = known.iter().zip(found).map(|(known, found)| (*known - found).rounded().abs());
    // Not `f64::max`, which would overlook what is no number.
    let most = most.fold(0.0, |most: f64, apart| if most.is_nan() || apart <= most { most } else { apart });
    let most = if most.is_finite() { most } else { f64::INFINITY };
    // Of differences in twice the precision, rounded once.
    let rounding = f64::EPSILON;
    [(most * (1.0 - rounding) - error * UP).max(0.0), most * (1.0 + rounding) + error * UP]
}
