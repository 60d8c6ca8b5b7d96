//! The quadratic programs of a beam on any supports, from the beam on a set of contacts alone.
//!
//! ```text
//! methods 1 and 2    p = q − K v,  v = g − h     the forces that hold the beam at every node, at the level v
//! method 3           h = g − v,    v = C (q − p)  the beam on its supports alone, under loads q − p
//! ```
//!
//! Both are linear in the unknown but for what loads, gaps, levels and slopes add; the columns of `A` are what is left without
//! these. The paper's beam has formulas of its own in each method. A beam that its supports do not hold has no `C`: forces that
//! are not in balance have no position of rest. Its complementary energy is minimised over contact forces in balance.

use nalgebra::{DMatrix, DVector};

use super::Discrete;
use super::contact_set::ContactSet;
use super::held_beam;
use crate::qp::Matrix;
use crate::state::Discretisation;

/// Why a beam that its supports do not hold has no matrix of flexibility.
pub(super) const NO_FLEXIBILITY: &str =
    "the supports leave the beam free to move as a whole, so that there is no flexibility matrix";

/// Nodal contact forces `p` that belong to clearances `h`, at the nodes without a support.
pub(super) fn contact_forces(discrete: &Discrete, clearances: &[f64], discretisation: Discretisation) -> Vec<f64> {
    let clearances = discrete.with_supports(clearances.to_vec());
    let held = discrete.above(discrete.depths.iter().zip(&clearances).map(|(g, h)| g - h).collect());
    let everywhere = ContactSet::at(&held, held.nodes());
    let forces = everywhere.solve(&held, discretisation).map(|nodal| nodal.contact_force);
    discrete.without_supports(forces.unwrap_or_else(|_| vec![f64::NAN; discrete.depths.len()]))
}

/// Clearances `h` that belong to nodal contact forces `p`, at the nodes without a support.
pub(super) fn clearances(discrete: &Discrete, forces: &[f64], discretisation: Discretisation) -> Vec<f64> {
    let deflection = deflection(discrete, &discrete.with_supports(forces.to_vec()), discretisation);
    discrete.without_supports(discrete.clearances(&deflection))
}

/// The deflection at all nodes but supported ends of the beam on its supports, under its loads less some contact forces there.
pub(super) fn deflection(discrete: &Discrete, forces: &[f64], discretisation: Discretisation) -> Vec<f64> {
    let unknown = || vec![f64::NAN; forces.len()];
    if 0 < discrete.supports().lacking() {
        return unknown();
    }
    let basic = discrete.basic(remaining(discrete, forces));
    held_beam::on_supports(&basic, discretisation).map_or_else(|_| unknown(), |beam| beam.deflection())
}

/// `q − p` at all nodes, of contact forces at all but supported ends.
pub(super) fn remaining(discrete: &Discrete, forces: &[f64]) -> Vec<f64> {
    let mut loads = discrete.loads.clone();
    loads[discrete.nodes()].iter_mut().zip(forces).for_each(|(q, p)| *q -= p);
    loads
}

/// The matrix of which `column` has what a unit of one unknown causes without loads, gaps, levels and slopes.
pub(super) fn matrix(
    discrete: &Discrete,
    column: impl Fn(&Discrete, &[f64], Discretisation) -> Vec<f64>,
    discretisation: Discretisation,
) -> DMatrix<f64> {
    let (bare, n) = (discrete.bare(), discrete.unknowns());
    let mut matrix = DMatrix::zeros(n, n);
    let mut unit = vec![0.0; n];
    for j in 0..n {
        unit[j] = 1.0;
        matrix.set_column(j, &DVector::from_vec(column(&bare, &unit, discretisation)));
        unit[j] = 0.0;
    }
    // Symmetric up to rounding; whoever takes the matrix may rely on it.
    (&matrix + matrix.transpose()) * 0.5
}

/// A symmetric matrix with two diagonals above the main one.
pub(super) fn pentadiagonal(matrix: &DMatrix<f64>) -> Matrix {
    let n = matrix.nrows();
    let entry = |i: usize, k: usize| if i + k < n { matrix[(i, i + k)] } else { 0.0 };
    Matrix::Pentadiagonal((0..n).map(|i| [0, 1, 2].map(|k| entry(i, k))).collect())
}
