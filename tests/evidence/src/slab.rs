//! A rectangular slab by conforming elements (Bogner, Fox and Schmit 1965), condensed to its deflections.
//!
//! ```text
//! ½ D ∫∫ w_xx² + w_yy² + 2ν w_xx w_yy + 2(1 − ν) w_xy²
//! ```
//!
//! The shape functions are products of cubic ones along x and along y, so that the stiffness is a sum of products of four matrices
//! of a line: `∫N''N''`, `∫NN`, `∫N'N'` and `∫N''N`.

mod laid;

use nalgebra::{Cholesky, DMatrix};
use palkki::body::{Body, Kind};
use palkki::qp::Profile;

pub use laid::{Laid, files};

/// A slab on two simple supports along its short edges `x = 0` and `x = length`; the long edges are free.
#[derive(Debug, Clone, Copy)]
pub struct Slab {
    /// Between the supports, along x.
    pub length: f64,
    /// Along y.
    pub width: f64,
    /// `D`.
    pub stiffness: f64,
    /// Poisson's number `ν`.
    pub poisson: f64,
    /// Elements along x and along y.
    pub elements: [usize; 2],
}

/// The four matrices of a line of equal elements with two unknowns a node, deflection and slope.
struct Line {
    bend: DMatrix<f64>,
    mass: DMatrix<f64>,
    slope: DMatrix<f64>,
    mixed: DMatrix<f64>,
}

impl Line {
    fn new(length: f64, elements: usize) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "some tens of elements")]
        let h = length / elements as f64;
        // By hand from the cubic polynomials of Hermite, for unknowns w₁, h w'₁, w₂, h w'₂.
        let bend = [[12., 6., -12., 6.], [6., 4., -6., 2.], [-12., -6., 12., -6.], [6., 2., -6., 4.]];
        let mass = [[156., 22., 54., -13.], [22., 4., 13., -3.], [54., 13., 156., -22.], [-13., -3., -22., 4.]];
        let slope = [[36., 3., -36., 3.], [3., 4., -3., -1.], [-36., -3., 36., -3.], [3., -1., -3., 4.]];
        // By parts: ∫N''N = [N'N] − ∫N'N'.
        let mut mixed = slope.map(|row| row.map(|value| -value));
        mixed[1][0] -= 30.0;
        mixed[3][2] += 30.0;
        let assembled = |element: [[f64; 4]; 4], factor: f64| {
            let unit = |k: usize| if k % 2 == 1 { h } else { 1.0 };
            let mut whole = DMatrix::zeros(2 * (elements + 1), 2 * (elements + 1));
            for e in 0..elements {
                for (i, row) in element.iter().enumerate() {
                    for (j, value) in row.iter().enumerate() {
                        whole[(2 * e + i, 2 * e + j)] += value * factor * unit(i) * unit(j);
                    }
                }
            }
            whole
        };
        Self {
            bend: assembled(bend, 1.0 / (h * h * h)),
            mass: assembled(mass, h / 420.0),
            slope: assembled(slope, 1.0 / (30.0 * h)),
            mixed: assembled(mixed, 1.0 / (30.0 * h)),
        }
    }
}

impl Slab {
    /// Nodes without a support, column by column along y: `(x, y, share of the area)`.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "some tens of elements")]
    pub fn nodes(&self) -> Vec<[f64; 3]> {
        let [m, n] = self.elements;
        let [dx, dy] = [self.length / m as f64, self.width / n as f64];
        let node = |i: usize, j: usize| {
            let edge = if j == 0 || j == n { 0.5 } else { 1.0 };
            [i as f64 * dx, j as f64 * dy, edge * dx * dy]
        };
        (1..m).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| node(i, j)).collect()
    }

    /// The stiffness against deflections of the [nodes](Self::nodes), slopes and twists being free.
    ///
    /// # Panics
    ///
    /// If the slab is not held, which two supported edges exclude.
    #[must_use]
    pub fn stiffness(&self) -> Profile {
        let [m, n] = self.elements;
        let (x, y) = (Line::new(self.length, m), Line::new(self.width, n));
        let crossed = x.mixed.kronecker(&y.mixed.transpose()) + x.mixed.transpose().kronecker(&y.mixed);
        let whole = x.bend.kronecker(&y.mass)
            + x.mass.kronecker(&y.bend)
            + crossed * self.poisson
            + x.slope.kronecker(&y.slope) * (2.0 * (1.0 - self.poisson));
        let whole = whole * self.stiffness;
        // Unknown a of node i along x and b of node j along y: number (2i + a)(2n + 2) + 2j + b. On a supported edge w and w_y are zero.
        let number = |i: usize, a: usize, j: usize, b: usize| (2 * i + a) * (2 * n + 2) + 2 * j + b;
        let kept: Vec<usize> = (1..m).flat_map(|i| (0..=n).map(move |j| number(i, 0, j, 0))).collect();
        let others =
            (0..=m).flat_map(|i| (0..=n).flat_map(move |j| [[0, 1], [1, 0], [1, 1]].map(|[a, b]| (i, a, j, b))));
        let others = others.filter(|(i, a, _, _)| *a == 1 || (0 < *i && *i < m));
        let others: Vec<usize> = others.map(|(i, a, j, b)| number(i, a, j, b)).collect();
        let part = |rows: &[usize], columns: &[usize]| whole.select_rows(rows).select_columns(columns);
        let coupling = part(&others, &kept);
        let solved = Cholesky::new(part(&others, &others)).expect("held").solve(&coupling);
        let condensed = part(&kept, &kept) - coupling.transpose() * solved;
        Profile::full(kept.len(), |i, j| 0.5 * (condensed[(i, j)] + condensed[(j, i)]))
    }

    /// Under a load per area, above ground at some depth at each place `(x, y)`.
    ///
    /// # Panics
    ///
    /// As [`Self::stiffness`].
    #[must_use]
    pub fn above(&self, load: f64, gap: impl Fn(f64, f64) -> f64) -> Body {
        let nodes = self.nodes();
        let gaps = nodes.iter().map(|[x, y, _]| gap(*x, *y)).collect();
        let loads = nodes.iter().map(|[_, _, area]| load * area).collect();
        Body::new(Kind::Stiffness, self.stiffness(), None, gaps, loads).expect("held")
    }
}
