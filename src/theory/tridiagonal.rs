//! Tridiagonal systems with a matrix that is eliminated once.

/// Eliminates rows of `[left, middle, right]`. Each result row contains the factor for the row before, the pivot, and the entry to its
/// right.
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

/// Solves for the unknowns: matrix times unknowns plus constants is zero.
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
