//! The linear system of a beam by cells: a band of rows, each of which reaches over the two nodes of a cell.

/// Unknowns at a node: `y, y', y'', y'''`.
pub(super) const STATE: usize = 4;
/// Diagonals below and above the main one: four rows for each cell behind the two of the left end.
const REACH: usize = 5;
/// Columns that a row has after rows were exchanged, and the place of the main diagonal among them.
const WIDTH: usize = 3 * REACH + 1;

/// A row: the node on its left, its entries for both nodes, the right-hand side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) node: usize,
    pub(super) entries: [f64; 2 * STATE],
    pub(super) right: f64,
}

/// Solves the rows by elimination with exchange of rows. Unknown `j` of node `i` is measured in units of `1/size[i]^j`, and each row
/// in its largest entry, so that a pivot is chosen among numbers that are comparable. One more solve for what remains takes the
/// answer to the rounding of its own terms (Skeel 1980).
pub(super) fn solve(rows: &[Row], sizes: &[f64]) -> Option<Vec<[f64; STATE]>> {
    let unit = |column: usize| (0..column % STATE).fold(1.0, |unit, _| unit / sizes[column / STATE]);
    let scaled: Vec<Row> = rows
        .iter()
        .map(|row| {
            let mut entries = row.entries;
            for (k, entry) in entries.iter_mut().enumerate() {
                if *entry != 0.0 {
                    *entry *= unit(STATE * row.node + k);
                }
            }
            let most = entries.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            Row { node: row.node, entries: entries.map(|entry| entry / most), right: row.right / most }
        })
        .collect();
    let factors = Factors::of(&scaled)?;
    let mut x = factors.solve(scaled.iter().map(|row| row.right).collect());
    let remains = scaled.iter().map(|row| {
        let at = STATE * row.node;
        row.entries.iter().enumerate().fold(row.right, |sum, (k, a)| if *a == 0.0 { sum } else { sum - a * x[at + k] })
    });
    let change = factors.solve(remains.collect());
    x.iter_mut().zip(change).for_each(|(x, change)| *x += change);
    let states = x.chunks_exact(STATE).enumerate();
    let states: Vec<[f64; STATE]> = states.map(|(i, y)| [0, 1, 2, 3].map(|j| y[j] * unit(STATE * i + j))).collect();
    states.iter().flatten().all(|y| y.is_finite()).then_some(states)
}

/// Upper triangle, multipliers, and with which row each row was exchanged.
struct Factors {
    upper: Vec<[f64; WIDTH]>,
    lower: Vec<[f64; REACH]>,
    exchanged: Vec<usize>,
}

impl Factors {
    fn of(rows: &[Row]) -> Option<Self> {
        let n = rows.len();
        let mut a = vec![[0.0; WIDTH]; n];
        for (r, row) in rows.iter().enumerate() {
            for (k, entry) in row.entries.iter().enumerate().filter(|(_, entry)| **entry != 0.0) {
                *a[r].get_mut((STATE * row.node + k + REACH).checked_sub(r)?)? = *entry;
            }
        }
        let (mut lower, mut exchanged) = (vec![[0.0; REACH]; n], vec![0; n]);
        for k in 0..n {
            let below = k..n.min(k + REACH + 1);
            let size = |r: &usize| a[*r][k + REACH - r].abs();
            let best = below.clone().max_by(|r, s| size(r).total_cmp(&size(s)))?;
            exchanged[k] = best;
            for column in (k..=k + 2 * REACH).filter(|_| best != k) {
                let there = a[best][column + REACH - best];
                a[best][column + REACH - best] = std::mem::replace(&mut a[k][column + REACH - k], there);
            }
            let pivot = a[k];
            if pivot[REACH] == 0.0 || !pivot[REACH].is_finite() {
                return None;
            }
            for r in below.skip(1) {
                let factor = a[r][k + REACH - r] / pivot[REACH];
                lower[k][r - k - 1] = factor;
                if factor != 0.0 {
                    for column in k + 1..=k + 2 * REACH {
                        a[r][column + REACH - r] -= factor * pivot[column + REACH - k];
                    }
                }
            }
        }
        Some(Self { upper: a, lower, exchanged })
    }

    fn solve(&self, mut x: Vec<f64>) -> Vec<f64> {
        let n = x.len();
        for k in 0..n {
            x.swap(k, self.exchanged[k]);
            for r in k + 1..n.min(k + REACH + 1) {
                x[r] -= self.lower[k][r - k - 1] * x[k];
            }
        }
        for k in (0..n).rev() {
            let known =
                (k + 1..n.min(k + 2 * REACH + 1)).fold(x[k], |sum, c| sum - self.upper[k][c + REACH - k] * x[c]);
            x[k] = known / self.upper[k][REACH];
        }
        x
    }
}
