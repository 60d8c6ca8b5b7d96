//! The discrete problem in rationals: matrices from the paper's formulas, elimination, optimality.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// `numerator / denominator`, the latter positive.
pub fn fraction(numerator: i32, denominator: i32) -> RBig {
    RBig::from_parts(IBig::from(numerator), UBig::from(denominator.unsigned_abs()))
}

/// The nearest 64-bit number.
pub fn number(value: &RBig) -> f64 {
    value.to_f64().value()
}

/// A scene on a grid, in rationals.
#[derive(Debug)]
pub struct Data {
    /// `l`.
    pub length: RBig,
    /// `EI`.
    pub stiffness: RBig,
    /// Nodal loads `q_1 … q_n`, forces.
    pub loads: Vec<RBig>,
    /// Depths `u_1 … u_n`.
    pub depths: Vec<RBig>,
}

/// An exact answer.
#[derive(Debug)]
pub struct Exact {
    /// `p`, forces.
    pub contact_force: Vec<RBig>,
    /// `h`.
    pub clearance: Vec<RBig>,
    /// `v`.
    pub deflection: Vec<RBig>,
}

/// The square of a number.
fn square(value: &RBig) -> RBig {
    value * value
}

impl Data {
    fn intervals(&self) -> i32 {
        i32::try_from(self.loads.len()).map_or(i32::MAX, |nodes| nodes + 1)
    }

    /// `C` (26), with the letters of the paper.
    pub fn flexibility(&self) -> Vec<Vec<RBig>> {
        let m = self.intervals();
        let cube = square(&self.length) * &self.length;
        let below = fraction(6, 1) * &self.stiffness * fraction(m * m, 1) * fraction(m * m, 1);
        let factor = cube / below;
        let entry = |a: i32, b: i32| {
            let (i, j) = (a.min(b), a.max(b));
            fraction((m - j) * i * (2 * j * m - j * j - i * i), 1) * &factor
        };
        (1..m).map(|i| (1..m).map(|j| entry(i, j)).collect()).collect()
    }

    /// The energy methods on a contact set: `C_cc p = (C q − u)_c`, then `h = C p + u − C q` (28).
    pub fn energy(&self, contact: &[bool]) -> Exact {
        let c = self.flexibility();
        let linear: Vec<RBig> = times(&c, &self.loads).iter().zip(&self.depths).map(|(v, u)| v - u).collect();
        let contact_force = on_face(&c, &linear, contact);
        let clearance: Vec<RBig> = times(&c, &contact_force).iter().zip(&linear).map(|(v, b)| v - b).collect();
        self.answer(contact_force, clearance)
    }

    /// Finite differences on a contact set: `A_ff h = (A u − q/Δ)_f`, then `p = A h − b`, times `Δ`.
    pub fn differences(&self, contact: &[bool]) -> Exact {
        let m = self.intervals();
        let spacing = &self.length / fraction(m, 1);
        let factor = &self.stiffness / square(&square(&spacing));
        let entry = |i: i32, j: i32| {
            let corner = i32::from(i == 1) + i32::from(i == m - 1);
            let whole = match (i - j).abs() {
                0 => 6 - corner,
                1 => -4,
                2 => 1,
                _ => 0,
            };
            fraction(whole, 1) * &factor
        };
        let a: Vec<Vec<RBig>> = (1..m).map(|i| (1..m).map(|j| entry(i, j)).collect()).collect();
        let linear: Vec<RBig> =
            times(&a, &self.depths).iter().zip(&self.loads).map(|(f, q)| f - q / &spacing).collect();
        let free: Vec<bool> = contact.iter().map(|c| !c).collect();
        let clearance = on_face(&a, &linear, &free);
        let pressure = times(&a, &clearance).into_iter().zip(&linear).map(|(g, b)| (g - b) * &spacing).collect();
        self.answer(pressure, clearance)
    }

    fn answer(&self, contact_force: Vec<RBig>, clearance: Vec<RBig>) -> Exact {
        let deflection = self.depths.iter().zip(&clearance).map(|(u, h)| u - h).collect();
        Exact { contact_force, clearance, deflection }
    }

    /// Share of the left support in the forces on the interior nodes: `Σ (q_i − p_i) (N − i)/N`.
    pub fn left_reaction(&self, exact: &Exact) -> RBig {
        let m = self.intervals();
        let carried = self.loads.iter().zip(&exact.contact_force).map(|(q, p)| q - p);
        (1..m).zip(carried).fold(fraction(0, 1), |sum, (i, t)| sum + t * fraction(m - i, m))
    }
}

impl Exact {
    /// The first node, by its number, at which (34), (35) do not hold exactly: `p ≥ 0` and `h = 0` in contact, `p = 0` and
    /// `h ≥ 0` elsewhere. None for the optimum.
    pub fn violation(&self, contact: &[bool]) -> Option<usize> {
        let none = fraction(0, 1);
        let holds = |i: usize| {
            let (p, h) = (&self.contact_force[i], &self.clearance[i]);
            if contact[i] { none <= *p && *h == none } else { *p == none && none <= *h }
        };
        (0..contact.len()).find(|&i| !holds(i)).map(|i| i + 1)
    }
}

fn times(a: &[Vec<RBig>], x: &[RBig]) -> Vec<RBig> {
    a.iter().map(|row| row.iter().zip(x).fold(fraction(0, 1), |sum, (a, x)| sum + a * x)).collect()
}

/// Solves `A_cc x_c = b_c`, `x = 0` elsewhere, by Gaussian elimination; no pivoting, `A` is positive definite.
fn on_face(a: &[Vec<RBig>], b: &[RBig], chosen: &[bool]) -> Vec<RBig> {
    let face: Vec<usize> = (0..b.len()).filter(|&i| chosen[i]).collect();
    let mut rows: Vec<Vec<RBig>> =
        face.iter().map(|&i| face.iter().map(|&j| a[i][j].clone()).chain([b[i].clone()]).collect()).collect();
    for k in 0..rows.len() {
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot = &above[k];
        for row in below {
            if row[k].is_zero() {
                continue;
            }
            let factor = &row[k] / &pivot[k];
            for (entry, from) in row.iter_mut().zip(pivot).skip(k) {
                *entry = &*entry - &factor * from;
            }
        }
    }
    let mut x = vec![fraction(0, 1); b.len()];
    for k in (0..rows.len()).rev() {
        let known = (k + 1..face.len()).fold(rows[k][face.len()].clone(), |sum, j| sum - &rows[k][j] * &x[face[j]]);
        x[face[k]] = known / &rows[k][k];
    }
    x
}
