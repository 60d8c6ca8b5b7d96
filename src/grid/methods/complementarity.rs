//! Method 1: the complementarity problem by finite differences, (4)–(16).
//!
//! The unknown is the clearance `h = u − v` at the interior nodes, and the gradient is the contact pressure `p`:
//!
//! ```text
//! p = q − EI v''''         EI v_i'''' ≈ (EI/Δ⁴) (v_{i−2} − 4 v_{i−1} + 6 v_i − 4 v_{i+1} + v_{i+2})        (5)
//! A = (EI/Δ⁴) pentadiag(1, −4, 6, −4, 1),   b = A u − q,   p = A h − b
//! ```
//!
//! At the supports `v_0 = 0` and `v_0'' = 0`, that is `v_{−1} = −v_1` (8), which leaves 5 in the two corners of `A`. At a built-in
//! end half a cell has curvature, `v_0'' ≈ 2 (v_1 − v_0 − φ Δ)/Δ²`, which leaves 7 in the corner. At a free end no cell has
//! curvature, which leaves 1 and 5 there. So `A` is a sum over the nodes where the beam can bend. Pressures are forces per length; a
//! load `q_i` is the nodal load divided by `Δ`.

// Discrepancy: finite-difference-equations
//
// The difference scheme is rebuilt from (5), (7), (8) with central differences, the only formula of second order for `v''''` on five
// nodes. The paper prints no number for this method.

use super::Discrete;
use crate::qp::Matrix;

/// `A` of the paper's beam.
pub(super) fn matrix(discrete: &Discrete) -> Matrix {
    let n = discrete.unknowns();
    let square = discrete.spacing * discrete.spacing;
    let factor = discrete.stiffness / square / square;
    let mut rows = vec![[6.0 * factor, -4.0 * factor, factor]; n];
    rows[0][0] -= factor;
    rows[n - 1][0] -= factor;
    Matrix::Pentadiagonal(rows)
}
