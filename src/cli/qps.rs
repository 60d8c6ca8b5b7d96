//! A sparse form as a file in free MPS with `QUADOBJ`, in the units of the scene.
//!
//! Variables are not scaled, so the answer of a solver can be read directly. The multipliers of `x ≥ 0` are contact forces if the
//! variables are clearances, and clearances if they are contact forces.

use palkki::qp::{SparseForm, UpperColumns};

/// The file, in which `x_k` is variable `k` from 1. `units` are those of the variables, and `energy` that of the objective.
pub(super) fn qps(form: &SparseForm, units: &[f64], energy: f64) -> String {
    let rows = (1..=form.right.len()).map(|row| format!(" E e{row}"));
    let columns = (1..).zip(&form.linear).zip(&form.equations).zip(units);
    let columns = columns.flat_map(|(((k, linear), column), unit)| {
        let of_energy = format!(" x{k} energy {:?}", linear * (energy / unit));
        let entries = column.iter().map(move |(row, value)| format!(" x{k} e{} {:?}", row + 1, value / unit));
        std::iter::once(of_energy).chain(entries)
    });
    let right = (1..).zip(&form.right).filter(|(_, value)| **value != 0.0);
    let right = right.map(|(row, value)| format!(" right e{row} {value:?}"));
    let free = (1..=form.signed).map(|k| format!(" FR bound x{k}"));
    let UpperColumns { starts, rows: above, values } = &form.quadratic;
    let quadratic = starts.windows(2).enumerate().flat_map(|(j, range)| (range[0]..range[1]).map(move |k| (j, k)));
    let quadratic = quadratic.map(|(j, k)| {
        let i = above[k];
        format!(" x{} x{} {:?}", i + 1, j + 1, values[k] * (energy / units[i] / units[j]))
    });
    let section = |name: &str| std::iter::once(name.to_owned());
    let head = section("NAME palkki").chain(section("ROWS")).chain(section(" N energy")).chain(rows);
    let linear = section("COLUMNS").chain(columns).chain(section("RHS")).chain(right);
    let rest = section("BOUNDS").chain(free).chain(section("QUADOBJ")).chain(quadratic).chain(section("ENDATA"));
    head.chain(linear).chain(rest).fold(String::new(), |text, line| text + &line + "\n")
}
