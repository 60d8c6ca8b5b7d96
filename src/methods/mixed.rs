//! Deflections and moments together: the equations of the first two methods on a given contact set, in O(n) and with the
//! condition number of a second difference, `n²`, instead of that of a fourth, `n⁴`.
//!
//! With `v = u` at the held nodes and no contact force at the free ones, the unknowns of node `i` are `v_i` and the
//! dimensionless moment `m_i = M_i Δ²/EI`:
//!
//! ```text
//! curvature      c(m)_i + v_{i−1} − 2 v_i + v_{i+1} = 0        c(m)_i = m_i                            finite differences
//!                                                              c(m)_i = (m_{i−1} + 4 m_i + m_{i+1})/6   beam elements
//! equilibrium    m_{i−1} − 2 m_i + m_{i+1} = −q_i Δ³/EI        if node i is free
//! contact        v_i = u_i                                     if it is held
//! ```
//!
//! Eliminating the moments first would give back `A` of (12) or `K` of (20). Eliminating node by node, in blocks of two,
//! never forms them: where all nodes are free, the two second differences stay apart.

use nalgebra::{Matrix2, Vector2};

use super::Discrete;
use crate::problem::NotPositiveDefinite;
use crate::state::Bending;

/// Deflections `v_1 … v_n` and contact forces at the held nodes (zero at the free ones).
pub(super) struct Held {
    pub(super) deflection: Vec<f64>,
    pub(super) contact_force: Vec<f64>,
}

/// Solves for the beam that is held at the depth of the foundation wherever `free` is false.
pub(super) fn solve(discrete: &Discrete, bending: Bending, free: &[bool]) -> Result<Held, NotPositiveDefinite> {
    let n = free.len();
    let unit = discrete.spacing * discrete.spacing / discrete.stiffness;
    let loads = discrete.interior_loads();
    let (diagonal, beside) = match bending {
        Bending::AtNodes => (1.0, 0.0),
        Bending::Between => (4.0 / 6.0, 1.0 / 6.0),
    };
    // Rows: curvature, then equilibrium or contact. Columns: moment, deflection.
    let own = |i: usize| {
        if free[i] { Matrix2::new(diagonal, -2.0, -2.0, 0.0) } else { Matrix2::new(diagonal, -2.0, 0.0, 1.0) }
    };
    let neighbour =
        |i: usize| if free[i] { Matrix2::new(beside, 1.0, 1.0, 0.0) } else { Matrix2::new(beside, 1.0, 0.0, 0.0) };
    let right =
        |i: usize| Vector2::new(0.0, if free[i] { -loads[i] * discrete.spacing * unit } else { discrete.depths[i] });

    // Forwards: node i in terms of node i + 1, x_i = s_i − T_i x_{i+1}.
    let mut steps: Vec<(Vector2<f64>, Matrix2<f64>)> = Vec::with_capacity(n);
    for i in 0..n {
        let (mut pivot, mut rest) = (own(i), right(i));
        if let Some((s, t)) = steps.last() {
            pivot -= neighbour(i) * t;
            rest -= neighbour(i) * s;
        }
        let inverse = pivot.try_inverse().filter(|m| m.iter().all(|x| x.is_finite()));
        let inverse = inverse.ok_or(NotPositiveDefinite { index: i, pivot: pivot.determinant() })?;
        steps.push((inverse * rest, inverse * neighbour(i)));
    }
    // Backwards.
    let mut behind = Vector2::zeros();
    let mut moment = vec![0.0; n + 2];
    let mut deflection = vec![0.0; n];
    for (i, (s, t)) in steps.iter().enumerate().rev() {
        behind = s - t * behind;
        moment[i + 1] = behind[0];
        deflection[i] = if free[i] { behind[1] } else { discrete.depths[i] };
    }
    // p = q + ΔM'/…: what the moments leave of the load.
    let force = |i: usize| {
        let [left, here, right] = [moment[i], moment[i + 1], moment[i + 2]];
        loads[i] + ((right - here) - (here - left)) / (discrete.spacing * unit)
    };
    let contact_force = (0..n).map(|i| if free[i] { 0.0 } else { force(i) }).collect();
    Ok(Held { deflection, contact_force })
}
