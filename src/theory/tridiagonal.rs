//! Tridiagonal systems of which the matrix is eliminated once.

/// Eliminates rows of `[left, middle, right]`: what each takes of the row before, its pivot, and what is to the right of it.
pub(super) fn factored(mut rows: Vec<[f64; 3]>) -> Option<Vec<[f64; 3]>> {
    for i in 0..rows.len() {
        let [_, pivot, upper] = rows[i];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        if let Some(next) = rows.get_mut(i + 1) {
            next[0] /= pivot;
            next[1] -= next[0] * upper;
        }
    }
    Some(rows)
}

/// The unknowns whose sum with the constants is zero.
pub(super) fn solved(factors: &[[f64; 3]], mut constants: Vec<f64>) -> Vec<f64> {
    for i in 1..constants.len() {
        constants[i] -= factors[i][0] * constants[i - 1];
    }
    let mut beyond = 0.0;
    for (constant, [_, pivot, upper]) in constants.iter_mut().zip(factors).rev() {
        *constant = -(*constant + upper * beyond) / pivot;
        beyond = *constant;
    }
    constants
}
