//! A symmetric matrix by rows, each from its first entry to the diagonal: banded, dense or anything between.
//!
//! Cholesky's factor `L` of `L Lᵀ` fills exactly the same entries, so that a row of `w` numbers costs `w²/2` products.

use std::ops::Range;

use super::NotPositiveDefinite;
use crate::double::Double;

/// The lower triangle of a symmetric matrix, shape (n, n).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Profile {
    /// Column of the first entry of each row.
    first: Vec<usize>,
    /// Index in `values` at which each row starts; n + 1 entries.
    start: Vec<usize>,
    /// Row of the last entry of each column.
    last: Vec<usize>,
    values: Vec<f64>,
}

impl Profile {
    /// The matrix with the given entries `(i, j, a_ij)`, on or below the diagonal and each given at most once.
    #[must_use]
    pub fn of_entries(n: usize, entries: impl Iterator<Item = (usize, usize, f64)> + Clone) -> Self {
        let mut first: Vec<usize> = (0..n).collect();
        entries.clone().for_each(|(i, j, _)| first[i] = first[i].min(j));
        let mut matrix = Self::zero(first);
        entries.for_each(|(i, j, a)| matrix.values[matrix.start[i] + j - matrix.first[i]] = a);
        matrix
    }

    /// A zero matrix whose rows begin in these columns.
    fn zero(first: Vec<usize>) -> Self {
        let mut start = vec![0];
        first.iter().enumerate().for_each(|(i, first)| start.push(start[i] + i + 1 - first));
        let mut last: Vec<usize> = (0..first.len()).collect();
        first.iter().enumerate().for_each(|(i, first)| last[*first..i].fill(i));
        Self { values: vec![0.0; start[first.len()]], first, start, last }
    }

    /// The full matrix with the given entries of the lower triangle.
    #[must_use]
    pub fn full(n: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut matrix = Self::zero(vec![0; n]);
        matrix.values = (0..n).flat_map(|i| (0..=i).map(move |j| [i, j])).map(|[i, j]| entry(i, j)).collect();
        matrix
    }

    /// The sum of two matrices, and its rounding error, exactly.
    #[must_use]
    pub(crate) fn sum(&self, other: &Self) -> [Self; 2] {
        let first: Vec<usize> = self.first.iter().zip(&other.first).map(|(a, b)| *a.min(b)).collect();
        let mut sum = [Self::zero(first.clone()), Self::zero(first)];
        for i in 0..self.dimension() {
            for j in sum[0].first[i]..=i {
                let both = Double::exact(self.entry(i, j)) + Double::exact(other.entry(i, j));
                let at = sum[0].start[i] + j - sum[0].first[i];
                [sum[0].values[at], sum[1].values[at]] = both.parts();
            }
        }
        sum
    }

    /// `n`.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.first.len()
    }

    /// Number of stored numbers.
    #[must_use]
    pub fn numbers(&self) -> usize {
        self.values.len()
    }

    /// Approximate number of products of a factorisation.
    #[must_use]
    pub(crate) fn products(&self) -> usize {
        self.rows().map(|(_, row)| row.len() * row.len() / 2 + row.len()).sum()
    }

    /// Entry `a_ij`.
    #[must_use]
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        let (i, j) = (i.max(j), i.min(j));
        j.checked_sub(self.first[i]).map_or(0.0, |k| self.row(i)[k])
    }

    /// The diagonal.
    pub(crate) fn diagonal(&self) -> impl Iterator<Item = f64> + '_ {
        self.start[1..].iter().map(|end| self.values[end - 1])
    }

    /// Row `i`, from its first entry to the diagonal.
    #[must_use]
    pub fn row(&self, i: usize) -> &[f64] {
        &self.values[self.start[i]..self.start[i + 1]]
    }

    /// The columns in which row `i` may have entries, on both sides of the diagonal.
    #[must_use]
    pub(crate) fn across(&self, i: usize) -> Range<usize> {
        self.first[i]..self.last[i] + 1
    }

    /// All rows, each with the column in which it begins.
    fn rows(&self) -> impl Iterator<Item = (usize, &[f64])> {
        (0..self.dimension()).map(|i| (self.first[i], self.row(i)))
    }

    /// Non-zero entries, by rows.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        let of_row = |i: usize| (self.first[i]..).zip(self.row(i)).map(move |(j, a)| (i, j, *a));
        (0..self.dimension()).flat_map(of_row).filter(|(_, _, a)| *a != 0.0)
    }

    /// The chosen rows and columns, in the given order, with `shift` subtracted from the diagonal.
    #[must_use]
    pub(crate) fn part(&self, chosen: &[usize], shift: f64) -> Self {
        let mut place = vec![None; self.dimension()];
        chosen.iter().enumerate().for_each(|(k, i)| place[*i] = Some(k));
        let of_part = |(i, j, a): (usize, usize, f64)| {
            let (k, l) = (place[i]?, place[j]?);
            Some((k.max(l), k.min(l), a))
        };
        let mut part = Self::of_entries(chosen.len(), self.entries().filter_map(of_part));
        part.add_to_diagonal(std::iter::repeat_n(-shift, chosen.len()));
        part
    }

    /// Adds to the diagonal.
    pub(crate) fn add_to_diagonal(&mut self, added: impl Iterator<Item = f64>) {
        self.start[1..].iter().zip(added).for_each(|(end, added)| self.values[end - 1] += added);
    }

    /// The factor `L` of `L Lᵀ`, row by row.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if a pivot is not positive.
    pub(crate) fn cholesky(mut self) -> Result<Self, NotPositiveDefinite> {
        /// Rows treated together: each row above them is read from memory once for all of them. Four rows of 3000 numbers are 96 kB,
        /// which fit into the cache of a core.
        const ROWS: usize = 4;
        let (n, first, start) = (self.dimension(), &self.first, &self.start);
        for from in (0..n).step_by(ROWS) {
            let rows = from..n.min(from + ROWS);
            let (done, rest) = self.values.split_at_mut(start[from]);
            let entry = |row: &mut [f64], i: usize, other: &[f64], j: usize| {
                let common = first[i].max(first[j]);
                let taken = dot(&row[common - first[i]..j - first[i]], &other[common - first[j]..]);
                row[j - first[i]] = (row[j - first[i]] - taken) / other[j - first[j]];
            };
            for j in rows.clone().map(|i| first[i]).min().unwrap_or(from)..from {
                for i in rows.clone().filter(|i| first[*i] <= j) {
                    entry(&mut rest[start[i] - start[from]..], i, &done[start[j]..start[j + 1]], j);
                }
            }
            for i in rows {
                let (above, row) = rest.split_at_mut(start[i] - start[from]);
                for j in first[i].max(from)..i {
                    entry(row, i, &above[start[j] - start[from]..start[j + 1] - start[from]], j);
                }
                let (before, pivot) = row[..=i - first[i]].split_at_mut(i - first[i]);
                pivot[0] -= dot(before, before);
                // Also rejects NaN.
                if !(0.0 < pivot[0] && pivot[0] < f64::INFINITY) {
                    return Err(NotPositiveDefinite { index: i, pivot: pivot[0] });
                }
                pivot[0] = pivot[0].sqrt();
            }
        }
        Ok(self)
    }

    /// Solves `L Lᵀ x = b` in place, where `self` is `L`.
    pub(crate) fn solve(&self, b: &mut [f64]) {
        for (i, (first, row)) in self.rows().enumerate() {
            let (before, pivot) = row.split_at(i - first);
            b[i] = (b[i] - dot(before, &b[first..i])) / pivot[0];
        }
        for i in (0..self.dimension()).rev() {
            let (before, pivot) = self.row(i).split_at(i - self.first[i]);
            b[i] /= pivot[0];
            let x = b[i];
            b[self.first[i]..i].iter_mut().zip(before).for_each(|(b, a)| *b -= a * x);
        }
    }

    /// `A x`.
    #[must_use]
    pub(crate) fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for (i, (first, row)) in self.rows().enumerate() {
            product[i] += dot(row, &x[first..=i]);
            product[first..i].iter_mut().zip(row).for_each(|(sum, a)| *sum += a * x[i]);
        }
        product
    }

    /// Adds `A x` to sums.
    pub(crate) fn times_into(&self, x: &[Double], sums: &mut Sums) {
        for (i, (first, row)) in self.rows().enumerate() {
            for (j, &a) in (first..).zip(row).filter(|(_, a)| **a != 0.0) {
                sums.add(i, a, x[j]);
                if j < i {
                    sums.add(j, a, x[i]);
                }
            }
        }
    }

    /// For each row the sum of `part(i, j, a_ij)` over all its columns, including those beyond the diagonal.
    pub(crate) fn row_sums(&self, part: impl Fn(usize, usize, f64) -> f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.dimension()];
        for (i, (first, row)) in self.rows().enumerate() {
            for (j, &a) in (first..).zip(row) {
                let part = part(i, j, a);
                sums[i] += part;
                if j < i {
                    sums[j] += part;
                }
            }
        }
        sums
    }
}

/// The scalar product over the length of `a`, in a fixed order and several terms at a time, so that the bits are the same on every
/// processor.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    /// Twice the number of 64-bit numbers that common processors add at once, because the additions of one sum depend on each other.
    const LANES: usize = 8;
    let (a, b) = (a.chunks_exact(LANES), b[..a.len()].chunks_exact(LANES));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; LANES];
    for (a, b) in a.zip(b) {
        (0..LANES).for_each(|k| sums[k] += a[k] * b[k]);
    }
    sums.iter().sum::<f64>() + rest
}

/// Sums of products `a · x` in twice the precision, with a bound on the rounding error of each.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sums {
    pub(crate) values: Vec<Double>,
    /// Sum of the magnitudes of all terms.
    sizes: Vec<f64>,
    /// Number of terms.
    terms: Vec<f64>,
    /// Bound on the error of the first term.
    before: Vec<f64>,
}

impl Sums {
    /// Bound on the rounding error of one step of a sum, relative to the magnitudes of its terms so far.
    ///
    /// In [`Double::times_plus`] six operations round, each on numbers of at most `4 · 2⁻⁵³` of product and sum: below `13 · 2⁻¹⁰⁶`.
    /// The remaining factor of 5 covers the rounding of the magnitudes themselves.
    pub(crate) const STEP: f64 = 1.0 / ((1_u128 << 100) as f64);

    /// Empty sums.
    pub(crate) fn zero(n: usize) -> Self {
        Self { values: vec![Double::ZERO; n], sizes: vec![0.0; n], terms: vec![0.0; n], before: vec![0.0; n] }
    }

    /// Adds a product to sum `i`.
    pub(crate) fn add(&mut self, i: usize, a: f64, x: Double) {
        self.values[i] = x.times_plus(a, self.values[i]);
        self.sizes[i] += (a * x.rounded()).abs();
        self.terms[i] += 1.0;
    }

    /// Bound on the error of sum `i`. The second term covers products below the range of 64 bits, which lose digits.
    pub(crate) fn off(&self, i: usize) -> f64 {
        self.before[i] + self.terms[i] * (self.sizes[i] * Self::STEP + f64::MIN_POSITIVE)
    }

    /// New sums that begin with the negatives of these.
    pub(crate) fn negative(&self) -> Self {
        let n = self.values.len();
        Self {
            values: self.values.iter().map(|value| Double::ZERO - *value).collect(),
            sizes: self.values.iter().map(|value| value.rounded().abs()).collect(),
            terms: vec![1.0; n],
            before: (0..n).map(|i| self.off(i)).collect(),
        }
    }

    /// The sums, rounded.
    pub(crate) fn rounded(&self) -> Vec<f64> {
        self.values.iter().map(|value| value.rounded()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `[[4, 2, 0], [2, 5, 2], [0, 2, 5]]`, whose pivots are all 4, times (1, 2, 3).
    #[test]
    fn factors_and_products_of_a_small_matrix_are_exact() {
        let entries = [(0, 0, 4.0), (1, 0, 2.0), (1, 1, 5.0), (2, 1, 2.0), (2, 2, 5.0)];
        let matrix = Profile::of_entries(3, entries.into_iter());
        assert_eq!(matrix.numbers(), 5, "row 2 begins in column 1");
        assert_eq!(matrix.times(&[1.0, 2.0, 3.0]), [8.0, 18.0, 19.0]);
        let mut sums = Sums::zero(3);
        matrix.times_into(&[1.0, 2.0, 3.0].map(Double::exact), &mut sums);
        assert_eq!(sums.rounded(), [8.0, 18.0, 19.0]);
        let mut x = [8.0, 18.0, 19.0];
        matrix.clone().cholesky().expect("its pivots are 4").solve(&mut x);
        assert_eq!(x.map(f64::to_bits), [1.0, 2.0, 3.0].map(f64::to_bits));
        let outer = matrix.part(&[0, 2], 1.0);
        let bits = |values: [f64; 3]| values.map(f64::to_bits);
        let entries = [outer.entry(0, 0), outer.entry(0, 1), outer.entry(1, 1)];
        assert_eq!(bits(entries), bits([3.0, 0.0, 4.0]));
        let error = matrix.part(&[0, 1, 2], 4.5).cholesky().expect_err("a pivot is 4 − 4.5");
        assert_eq!(error, NotPositiveDefinite { index: 0, pivot: -0.5 });
    }

    /// `a_ij = min(i, j)` from 1 has a factor of ones. The lengths of its rows lie around the eight products that are summed together.
    #[test]
    fn long_rows_are_factored_exactly() {
        let whole = |i: usize| f64::from(u32::try_from(i).expect("small"));
        let entries = (0..40).flat_map(|i| (0..=i).map(move |j| (i, j, whole(j + 1))));
        let factor = Profile::of_entries(40, entries).cholesky().expect("its pivots are 1");
        for i in 0..40 {
            assert!(factor.row(i).iter().all(|l| l.to_bits() == 1.0_f64.to_bits()), "row {i}");
        }
    }

    #[test]
    fn what_a_sum_of_matrices_rounds_off_is_kept() {
        let tiny = f64::EPSILON / 8.0;
        let one = |a: f64| Profile::of_entries(2, [(0, 0, a), (1, 1, 1.0), (1, 0, 0.0)].into_iter());
        let [sum, rest] = one(1.0).sum(&one(tiny));
        let entries = [sum.entry(0, 0), rest.entry(0, 0), sum.entry(1, 1)];
        assert_eq!(entries.map(f64::to_bits), [1.0, tiny, 2.0].map(f64::to_bits));
    }
}
