//! Deflections and moments together: the equations of the first two methods on a given contact set, in O(n) and with the
//! condition number of a second difference, `n²`, instead of that of a fourth, `n⁴`.
//!
//! Between the held nodes, where `v = u`, runs a chord `g`; unknown at node `i` are `w_i = v_i − g_i` and the dimensionless
//! moment `m_i = M_i Δ²/EI`:
//!
//! ```text
//! curvature      c(m)_i + w_{i−1} − 2 w_i + w_{i+1} = −(g_{i−1} − 2 g_i + g_{i+1})
//! equilibrium    m_{i−1} − 2 m_i + m_{i+1} = −q_i Δ³/EI        if node i is free
//! contact        w_i = 0                                       if it is held
//!
//! c(m)_i = m_i                               finite differences
//! c(m)_i = (m_{i−1} + 4 m_i + m_{i+1})/6     beam elements
//! ```
//!
//! The chord bends at held nodes only, and not at all over a flat foundation: depths enter as differences of slopes, so that
//! their own rounding is not divided by `Δ³`. Eliminating the moments first would give back `A` of method 1 or `K` of (20).
//! Eliminating node by node, in blocks of two, never forms them.

use nalgebra::{Matrix2, Vector2};

use super::Discrete;
use crate::problem::NotPositiveDefinite;
use crate::state::Bending;

/// The beam held at the depth of the foundation at some nodes.
pub(super) struct Held {
    /// Clearances `h_1 … h_n`, zero at the held nodes.
    pub(super) clearance: Vec<f64>,
    /// Contact forces at the held nodes, zero at the free ones.
    pub(super) contact_force: Vec<f64>,
}

/// Solves for the beam that is held wherever `free` is false.
pub(super) fn solve(discrete: &Discrete, bending: Bending, free: &[bool]) -> Result<Held, NotPositiveDefinite> {
    let n = free.len();
    let unit = discrete.spacing * discrete.spacing / discrete.stiffness;
    let loads = discrete.interior_loads();
    let (chord, bends) = chord(&discrete.depths, free);
    let (diagonal, beside) = match bending {
        Bending::AtNodes => (1.0, 0.0),
        Bending::Between => (4.0 / 6.0, 1.0 / 6.0),
    };
    // Rows: curvature, then equilibrium or contact. Columns: moment, deflection above the chord.
    let own = |i: usize| {
        if free[i] { Matrix2::new(diagonal, -2.0, -2.0, 0.0) } else { Matrix2::new(diagonal, -2.0, 0.0, 1.0) }
    };
    let neighbour =
        |i: usize| if free[i] { Matrix2::new(beside, 1.0, 1.0, 0.0) } else { Matrix2::new(beside, 1.0, 0.0, 0.0) };
    let right = |i: usize| Vector2::new(-bends[i], if free[i] { -loads[i] * discrete.spacing * unit } else { 0.0 });

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
    let mut clearance = vec![0.0; n];
    for (i, (s, t)) in steps.iter().enumerate().rev() {
        behind = s - t * behind;
        moment[i + 1] = behind[0];
        if free[i] {
            clearance[i] = (discrete.depths[i] - chord[i]) - behind[1];
        }
    }
    // What the moments leave of the load: p = q + M''.
    let force = |i: usize| {
        let [left, here, right] = [moment[i], moment[i + 1], moment[i + 2]];
        loads[i] + ((right - here) - (here - left)) / (discrete.spacing * unit)
    };
    let contact_force = (0..n).map(|i| if free[i] { 0.0 } else { force(i) }).collect();
    Ok(Held { clearance, contact_force })
}

/// The polyline through the held nodes and the supports at the interior nodes, and its second difference there.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn chord(depths: &[f64], free: &[bool]) -> (Vec<f64>, Vec<f64>) {
    let n = free.len();
    let depth = |node: usize| if node == 0 || node == n + 1 { 0.0 } else { depths[node - 1] };
    let (mut chord, mut bends) = (vec![0.0; n], vec![0.0; n]);
    let (mut last, mut slope_before) = (0, 0.0);
    for node in (1..=n + 1).filter(|&node| node == n + 1 || !free[node - 1]) {
        let slope = (depth(node) - depth(last)) / (node - last) as f64;
        for between in last + 1..node {
            chord[between - 1] = depth(last) + slope * (between - last) as f64;
        }
        if 0 < last {
            chord[last - 1] = depth(last);
            bends[last - 1] = slope - slope_before;
        }
        (last, slope_before) = (node, slope);
    }
    (chord, bends)
}
