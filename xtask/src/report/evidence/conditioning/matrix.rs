//! What the matrices themselves are worth: `A`, `K` or `C` factorised on the optimal contact set, contact forces from (33).

use palkki::methods::{Discrete, Method, contact_state};
use palkki::problem::{Band, Dense, FreeSet, Matrix, Programme, Row};
use palkki::scene::Scene;
use palkki::state::ContactState;

use crate::report::error::Cause;

/// Finest grid for a matrix that is full.
const FULL: usize = 300;

/// The answer of the matrix; none where it is too large, or where rounding has destroyed its definiteness.
pub(super) fn solved(scene: &Scene, method: Method, touches: &[bool]) -> Result<Option<ContactState>, Cause> {
    let intervals = touches.len() + 1;
    if method != Method::Complementarity && FULL < intervals {
        return Ok(None);
    }
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let programme = method.programme(&discrete);
    let free: FreeSet = touches.iter().map(|&touches| touches == method.is_free_in_contact()).collect();
    let point = match programme.matrix() {
        Matrix::Dense(matrix) => {
            let dense = Dense { matrix, linear: programme.linear().into(), sizes: programme.sizes() };
            dense.stationary(&free).ok().map(|point| (point.x, point.gradient))
        }
        banded @ Matrix::Pentadiagonal(_) => on_band(programme.as_ref(), &banded, &free).map(|x| {
            let gradient = programme.gradient(&x);
            (x, gradient)
        }),
    };
    Ok(point.map(|(x, gradient)| {
        contact_state(discrete.clone(), method.nodal(&discrete, x, gradient)).in_units_of(&scaled.scale)
    }))
}

/// `A_ff x_f = b_f` by a banded factorisation.
fn on_band(programme: &dyn Programme, matrix: &Matrix, free: &FreeSet) -> Option<Vec<f64>> {
    let chosen: Vec<usize> = free.variables().collect();
    let linear = programme.linear();
    let mut equations = Band::with_capacity(chosen.len());
    for (k, &i) in chosen.iter().enumerate() {
        let above = [k + 1, k + 2].map(|l| chosen.get(l).map_or(0.0, |&j| matrix.entry(i, j)));
        equations.push(Row { diagonal: matrix.entry(i, i), above, right: linear[i] }).ok()?;
    }
    let mut x = vec![0.0; free.dimension()];
    chosen.iter().zip(equations.solve()).for_each(|(&i, value)| x[i] = value);
    Some(x)
}
