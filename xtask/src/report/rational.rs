//! The example on a grid in exact rational arithmetic: the authority that shares no line with the library.
//!
//! Matrices from the paper's formulas, Gaussian elimination on a given contact set, and the optimality conditions (34),
//! (35) checked without rounding. Since `A` is positive definite, a point that passes is the only optimum, wherever the
//! contact set came from.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// An exact optimum.
#[derive(Debug)]
pub(super) struct Optimum {
    /// Contact forces at the interior nodes.
    pub(super) contact_force: Vec<RBig>,
    /// Reaction of the left support, with the load of half an interval on it.
    pub(super) left_reaction: RBig,
}

/// A contact set that is not the one of the optimum.
#[derive(Debug, thiserror::Error)]
#[error("node {node}: force or clearance is negative, or the contact set leaves one of them unbalanced")]
pub(super) struct NotOptimal {
    node: usize,
}

/// `EI = 500/384`, `l = 10`, `q₀ = 1`, `u₀ = 1`, divided into `intervals`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Example {
    intervals: i32,
}

fn fraction(numerator: i32, denominator: u32) -> RBig {
    RBig::from_parts(IBig::from(numerator), UBig::from(denominator))
}

impl Example {
    pub(super) fn new(intervals: u16) -> Self {
        Self { intervals: i32::from(intervals) }
    }

    fn spacing(self) -> RBig {
        fraction(10, self.intervals.unsigned_abs())
    }

    /// `C` (26), shape (n, n).
    fn flexibility(self) -> Vec<Vec<RBig>> {
        let m = self.intervals;
        let quarter = fraction(m * m, 1);
        // l³ / (6 EI (n + 1)⁴)
        let factor = fraction(1000, 1) / (fraction(6 * 500, 384) * &quarter * &quarter);
        let entry = |a: i32, b: i32| {
            let (i, j) = (a.min(b), a.max(b));
            fraction((m - j) * i, 1) * fraction(2 * j * m - j * j - i * i, 1) * &factor
        };
        (1..m).map(|i| (1..m).map(|j| entry(i, j)).collect()).collect()
    }

    /// `A` of the finite differences, shape (n, n).
    fn differences(self) -> Vec<Vec<RBig>> {
        let m = self.intervals;
        let square = self.spacing() * self.spacing();
        let factor = fraction(500, 384) / (&square * &square);
        let entry = |i: i32, j: i32| match (i - j).abs() {
            0 if i == 1 || i == m - 1 => fraction(5, 1) * &factor,
            0 => fraction(6, 1) * &factor,
            1 => fraction(-4, 1) * &factor,
            2 => factor.clone(),
            _ => RBig::ZERO,
        };
        (1..m).map(|i| (1..m).map(|j| entry(i, j)).collect()).collect()
    }

    /// Methods 2 and 3: `C p = C q − u` on the nodes that touch.
    pub(super) fn by_energy(self, touches: &[bool]) -> Result<Optimum, NotOptimal> {
        let c = self.flexibility();
        let loads = vec![self.spacing(); touches.len()];
        let linear: Vec<RBig> = product(&c, &loads).into_iter().map(|v| v - RBig::ONE).collect();
        let force = on_face(&c, &linear, touches);
        let clearance = product(&c, &force).into_iter().zip(&linear).map(|(g, b)| g - b).collect();
        self.checked(force, clearance)
    }

    /// Method 1: `A h = A u − q` on the nodes that do not.
    pub(super) fn by_differences(self, touches: &[bool]) -> Result<Optimum, NotOptimal> {
        let a = self.differences();
        let depths = vec![RBig::ONE; touches.len()];
        let linear: Vec<RBig> = product(&a, &depths).into_iter().map(|f| f - RBig::ONE).collect();
        let lifted: Vec<bool> = touches.iter().map(|touches| !touches).collect();
        let clearance = on_face(&a, &linear, &lifted);
        let pressure = product(&a, &clearance).into_iter().zip(&linear);
        let force = pressure.map(|(g, b)| (g - b) * self.spacing()).collect();
        self.checked(force, clearance)
    }

    /// (34), (35): both not negative, one of them zero.
    fn checked(self, contact_force: Vec<RBig>, clearance: Vec<RBig>) -> Result<Optimum, NotOptimal> {
        for (i, (p, h)) in contact_force.iter().zip(&clearance).enumerate() {
            if *p < RBig::ZERO || *h < RBig::ZERO || !(p.is_zero() || h.is_zero()) {
                return Err(NotOptimal { node: i + 1 });
            }
        }
        let m = self.intervals;
        let shares = (1..m).map(|i| fraction(m - i, m.unsigned_abs()));
        let carried = contact_force.iter().map(|p| self.spacing() - p).zip(shares);
        let left_reaction = carried.fold(self.spacing() / fraction(2, 1), |sum, (t, share)| sum + t * share);
        Ok(Optimum { contact_force, left_reaction })
    }
}

fn product(a: &[Vec<RBig>], x: &[RBig]) -> Vec<RBig> {
    a.iter().map(|row| row.iter().zip(x).fold(RBig::ZERO, |sum, (a, x)| sum + a * x)).collect()
}

/// Solves `A x = b` on the chosen variables, zero elsewhere. No pivoting: `A` is positive definite.
fn on_face(a: &[Vec<RBig>], b: &[RBig], chosen: &[bool]) -> Vec<RBig> {
    let face: Vec<usize> = (0..b.len()).filter(|&i| chosen[i]).collect();
    let row = |&i: &usize| face.iter().map(|&j| a[i][j].clone()).chain([b[i].clone()]).collect();
    let mut rows: Vec<Vec<RBig>> = face.iter().map(row).collect();
    for k in 0..rows.len() {
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot = &above[k];
        for row in below.iter_mut().filter(|row| !row[k].is_zero()) {
            let factor = &row[k] / &pivot[k];
            for (entry, from) in row.iter_mut().zip(pivot).skip(k) {
                *entry = &*entry - &factor * from;
            }
        }
    }
    let mut x = vec![RBig::ZERO; b.len()];
    for (k, &i) in face.iter().enumerate().rev() {
        let known = (k + 1..face.len()).fold(rows[k][face.len()].clone(), |sum, j| sum - &rows[k][j] * &x[face[j]]);
        x[i] = known / &rows[k][k];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mirror-symmetric contact from node `first` on.
    fn from(first: usize) -> Vec<bool> {
        (1..30).map(|i: usize| first <= i.min(30 - i)).collect()
    }

    #[test]
    fn the_optimum_of_the_example_passes_and_others_do_not() {
        let example = Example::new(30);
        let optimum = example.by_energy(&from(7)).expect("the contact begins at node 7");
        assert_eq!(optimum.contact_force[6].to_string(), "79510997/69626256");
        assert!(example.by_differences(&from(7)).is_ok(), "with finite differences too");
        for first in [6, 8] {
            assert!(
                example.by_energy(&from(first)).is_err() && example.by_differences(&from(first)).is_err(),
                "{first}"
            );
        }
    }
}
