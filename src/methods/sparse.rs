//! The methods in the variables in which they are sparse: moments beside clearances, or beside contact forces.
//!
//! Methods 1 and 2 minimise the potential energy in clearances `h` and moments `M`, with the curvature as equation; method 3
//! the complementary energy in contact forces `p` and moments, with equilibrium as equation:
//!
//! ```text
//! ½ Σ (Δ/EI) M c(M) + Σ q h    subject to   (Δ/EI) c(M)_i − δ²h_i/Δ = −δ²u_i/Δ,   h ≥ 0
//! ½ Σ (Δ/EI) M c(M) + Σ u p    subject to   δ²M_i/Δ − p_i = −q_i,                 p ≥ 0
//!
//! δ²y_i = y_{i−1} − 2 y_i + y_{i+1};   c(M)_i = M_i, or (M_{i−1} + 4 M_i + M_{i+1})/6 for beam elements
//! ```
//!
//! Second differences appear instead of fourth ones: condition numbers are roots of those of `A`.
//!
//! *Scaling.* Energy is measured by `X G`, with the sizes of [`Discrete::sizes`], and each equation is divided by what stands
//! before its second difference. Units of moment and of the variables with a sign were found by measurement, with 300, 3000
//! and 30 000 intervals of the example, among powers of the number of nodes:
//!
//! - potential energy: `M₀ = √(EI X G/Δ)`, which makes the quadratic part `c` itself, and clearances in units of `X/√n`;
//! - complementary energy: `M₀ = G Δ`, which makes equilibrium `δ²M − p = −q` in plain numbers, and forces in units of `G`.
//!
//! With other choices the libraries lose their way on 30 000 intervals, or on 3000.

use super::Discrete;
use crate::qp::{Sizes, SparseForm, UpperColumns};
use crate::state::Discretisation;

/// Methods 1 and 2: moments, then clearances. `sizes` are those of clearance and gradient in the quadratic program.
pub(super) fn potential(discrete: &Discrete, discretisation: Discretisation, sizes: Sizes) -> SparseForm {
    let n = discrete.interior();
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    let fine = (n as f64).sqrt();
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    let (depth, force) = (depth / fine, force * fine);
    // (Δ/EI) M₀ over X/Δ; the same for these units as for X and G, but for the factor √n.
    let coupling = stiffness_number(discrete).sqrt() * fine;
    let (own, beside) = shares(discretisation);
    let mut equations: Vec<_> = (0..n).map(|j| around(j, n, coupling * own, coupling * beside)).collect();
    equations.extend((0..n).map(|j| around(j, n, 2.0, -1.0)));
    let mut linear = vec![0.0; n];
    linear.extend(discrete.interior_loads().iter().map(|q| q / force));
    let bend = |i: usize| -discrete.spacing / depth * discrete.bend(i - 1, i, i + 1);
    let right = (1..=n).map(bend).collect();
    let sizes = Sizes { x: sizes.x / fine, gradient: sizes.gradient * fine };
    SparseForm { quadratic: quadratic(n, discretisation, 1.0), linear, equations, right, signed: n, sizes }
}

/// Method 3: moments, then contact forces.
pub(super) fn complementary(discrete: &Discrete, discretisation: Discretisation, sizes: Sizes) -> SparseForm {
    let n = discrete.interior();
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    let mut equations: Vec<_> = (0..n).map(|j| around(j, n, -2.0, 1.0)).collect();
    equations.extend((0..n).map(|j| vec![(j, -1.0)]));
    let mut linear = vec![0.0; n];
    linear.extend(discrete.depths.iter().map(|u| u / depth));
    let right = discrete.interior_loads().iter().map(|q| -q / force).collect();
    let quadratic = quadratic(n, discretisation, stiffness_number(discrete));
    SparseForm { quadratic, linear, equations, right, signed: n, sizes }
}

/// `G Δ³/(EI X)`: how far a force `G` bends one interval, measured by `X`.
fn stiffness_number(discrete: &Discrete) -> f64 {
    let Discrete { spacing, stiffness, .. } = discrete;
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    force / depth * spacing * spacing * (spacing / stiffness)
}

/// The curvature `c`: share of the node itself and of each neighbour.
fn shares(discretisation: Discretisation) -> (f64, f64) {
    match discretisation {
        Discretisation::FiniteDifferences => (1.0, 0.0),
        Discretisation::BeamElements => (4.0 / 6.0, 1.0 / 6.0),
    }
}

/// A column of a symmetric tridiagonal matrix with the same numbers in all rows.
fn around(j: usize, n: usize, own: f64, beside: f64) -> Vec<(usize, f64)> {
    let entries = [(j.wrapping_sub(1), beside), (j, own), (j + 1, beside)];
    entries.into_iter().filter(|(i, value)| *i < n && *value != 0.0).collect()
}

/// `P`: the curvature of the n moments times a factor, nothing for the n others.
fn quadratic(n: usize, discretisation: Discretisation, factor: f64) -> UpperColumns {
    let (own, beside) = shares(discretisation);
    let mut columns = UpperColumns::default();
    for j in 0..2 * n {
        columns.starts.push(columns.rows.len());
        for (i, value) in around(j, n, own, beside).into_iter().filter(|(i, _)| j < n && *i <= j) {
            columns.rows.push(i);
            columns.values.push(factor * value);
        }
    }
    columns.starts.push(columns.rows.len());
    columns
}
