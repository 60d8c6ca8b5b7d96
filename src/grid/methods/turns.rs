//! Soft joints: the rotation of each, added to a beam without soft joints, so that the moments in the joints are right.
//!
//! ```text
//! M + G q = q/κ      M of the loads, G of a unit turn in each joint, q = κ M
//! ```
//!
//! As terms of `c(M)`, soft joints next to each other would cost the elimination as many digits as they are soft. Elimination loses
//! no digits only as long as each node is held from one side. Each soft joint costs one more solve.
//!
//! If the contacts leave a part between hinges free to move, the hinges get a very small stiffness. The motion then takes the beam so
//! far below the foundation that a search finds contact there.

use super::divisions::LOOSE;
use super::springs::Row;
use crate::qp::{NotPositiveDefinite, blocks};

/// Joints that are this many times as soft as an interval are treated in this way. The others may cost three of sixteen digits.
pub(super) const SOFT: f64 = 1e3;

/// Adds the rotations of soft joints to a beam that was solved without them. Each joint is a row number with its `1/κ`. The rows are
/// factored towards the row `meeting`.
pub(super) fn turn(rows: &mut [Row], soft: &[(usize, f64)], meeting: usize) -> Result<(), NotPositiveDefinite> {
    /// The second pass removes what rounding left.
    const TIMES: usize = 2;
    if soft.is_empty() {
        return Ok(());
    }
    let steps = |rows: &[Row]| rows.iter().map(|row| row.block.step).collect::<Vec<_>>();
    let mut sum = steps(rows);
    let mut turned = Vec::with_capacity(soft.len());
    for (i, _) in soft {
        rows.iter_mut().for_each(|row| row.right = [0.0; 2]);
        rows[*i].right = [0.0, 1.0];
        blocks::solve_towards(rows, meeting, |row| row.right);
        turned.push(steps(rows));
    }
    let matrix = |stiffer: f64| -> Vec<Vec<f64>> {
        let entry = |k: usize, j: usize| {
            let [response, other] = [turned[j][soft[k].0][1], turned[k][soft[j].0][1]];
            -0.5 * (response + other) + if k == j { soft[k].1 + stiffer } else { 0.0 }
        };
        (0..soft.len()).map(|k| (0..soft.len()).map(|j| entry(k, j)).collect()).collect()
    };
    let diagonal = soft.iter().zip(&turned).map(|((i, stiff), turned)| stiff - turned[*i][1]);
    let least = diagonal.fold(0.0, f64::max) / LOOSE;
    let factor = Factor::of(matrix(0.0), least).or_else(|| Factor::of(matrix(least), 0.0));
    let factor = factor.ok_or(NotPositiveDefinite { index: soft[0].0, pivot: 0.0 })?;
    let mut turns = vec![0.0; soft.len()];
    for _ in 0..TIMES {
        let missing = soft.iter().zip(&turns).map(|((i, stiff), turn)| sum[*i][1] - stiff * turn).collect();
        let more = factor.solve(missing);
        for (turned, more) in turned.iter().zip(&more) {
            sum.iter_mut().zip(turned).for_each(|(sum, turned)| (0..2).for_each(|k| sum[k] += more * turned[k]));
        }
        turns.iter_mut().zip(more).for_each(|(turn, more)| *turn += more);
    }
    rows.iter_mut().zip(sum).for_each(|(row, step)| row.block.step = step);
    Ok(())
}

/// The lower triangle of `L Lᵀ`, the factorisation of a small matrix.
struct Factor(Vec<Vec<f64>>);

impl Factor {
    /// The factorisation, or [`None`] if a pivot is not larger than `least`.
    fn of(mut matrix: Vec<Vec<f64>>, least: f64) -> Option<Self> {
        for j in 0..matrix.len() {
            let (upper, below) = matrix.split_at_mut(j + 1);
            let own = &mut upper[j];
            let pivot = own[j] - own[..j].iter().map(|l| l * l).sum::<f64>();
            // The comparison also rejects NaN.
            if !(least < pivot && pivot < f64::INFINITY) {
                return None;
            }
            own[j] = pivot.sqrt();
            for row in below {
                let product: f64 = row[..j].iter().zip(&own[..j]).map(|(a, b)| a * b).sum();
                row[j] = (row[j] - product) / own[j];
            }
        }
        Some(Self(matrix))
    }

    fn solve(&self, mut right: Vec<f64>) -> Vec<f64> {
        let rows = &self.0;
        for (i, row) in rows.iter().enumerate() {
            let known: f64 = row[..i].iter().zip(&right[..i]).map(|(l, x)| l * x).sum();
            right[i] = (right[i] - known) / row[i];
        }
        for i in (0..rows.len()).rev() {
            let known: f64 = (i + 1..rows.len()).map(|k| rows[k][i] * right[k]).sum();
            right[i] = (right[i] - known) / rows[i][i];
        }
        right
    }
}

#[cfg(test)]
mod tests {
    use super::Factor;

    /// `L Lᵀ` of integers, times (1, 2, 3), and a matrix that is not definite.
    #[test]
    fn small_systems_are_solved_exactly() {
        let matrix = || vec![vec![4.0, 2.0, 0.0], vec![2.0, 5.0, 2.0], vec![0.0, 2.0, 5.0]];
        let factor = Factor::of(matrix(), 0.0).expect("definite");
        let bits = |x: Vec<f64>| x.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(factor.solve(vec![8.0, 18.0, 19.0])), bits(vec![1.0, 2.0, 3.0]));
        assert!(Factor::of(vec![vec![1.0, 2.0], vec![2.0, 1.0]], 0.0).is_none());
        assert!(Factor::of(matrix(), 4.0).is_none(), "all pivots are 4");
    }
}
