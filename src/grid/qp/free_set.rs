//! The set of free variables; all other variables are zero.

use std::ops::Range;

/// A set of free variables among `x_0 … x_{n−1}`. The others are fixed at zero.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct FreeSet {
    free: Vec<bool>,
}

impl FreeSet {
    /// All of n variables.
    #[must_use]
    pub fn all(n: usize) -> Self {
        Self { free: vec![true; n] }
    }

    /// None of n variables.
    #[must_use]
    pub fn none(n: usize) -> Self {
        Self { free: vec![false; n] }
    }

    /// `n`, the number of variables, free or not.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.free.len()
    }

    /// Whether `x_i` is free.
    #[must_use]
    pub fn contains(&self, i: usize) -> bool {
        self.free[i]
    }

    /// For each variable, whether it is free.
    pub fn iter(&self) -> impl Iterator<Item = bool> + '_ {
        self.free.iter().copied()
    }

    /// The free variables, ascending.
    pub fn variables(&self) -> impl Iterator<Item = usize> + '_ {
        self.within(0..self.free.len())
    }

    /// Frees `x_i`, or fixes it at zero.
    pub fn set(&mut self, i: usize, free: bool) {
        self.free[i] = free;
    }

    /// Frees the variables of a range.
    pub(crate) fn release(&mut self, range: Range<usize>) {
        self.free[range].fill(true);
    }

    /// The variables of a range as a separate set.
    #[must_use]
    pub(crate) fn part(&self, range: Range<usize>) -> Self {
        Self { free: self.free[range].to_vec() }
    }

    /// Copies a smaller set to the variables from `start` on.
    pub(crate) fn replace(&mut self, start: usize, part: &Self) {
        self.free[start..start + part.dimension()].copy_from_slice(&part.free);
    }

    /// The free variables of a range, ascending.
    pub(crate) fn within(&self, range: Range<usize>) -> impl Iterator<Item = usize> + '_ {
        let start = range.start;
        let chunks = self.free[range].chunks(STRIDE).enumerate().filter(|(_, chunk)| any(chunk));
        chunks.flat_map(move |(c, chunk)| (0..chunk.len()).filter(|&k| chunk[k]).map(move |k| start + c * STRIDE + k))
    }

    /// The number of free variables in a range.
    #[must_use]
    pub(crate) fn count(&self, range: Range<usize>) -> usize {
        self.free[range].iter().filter(|free| **free).count()
    }

    /// The free variables before `x_end`, descending.
    pub(crate) fn before(&self, end: usize) -> impl Iterator<Item = usize> + '_ {
        let chunks = self.free[..end].rchunks(STRIDE).scan(end, |end, chunk| {
            *end -= chunk.len();
            Some((*end, chunk))
        });
        chunks
            .filter(|(_, chunk)| any(chunk))
            .flat_map(|(start, chunk)| (0..chunk.len()).rev().filter(|&k| chunk[k]).map(move |k| start + k))
    }

    /// Runs of neighbouring free variables, ascending.
    pub(crate) fn runs(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        let mut end = 0;
        let stretches = self.free.chunk_by(|one, next| one == next).map(move |stretch| {
            end += stretch.len();
            (stretch[0], end - stretch.len()..end)
        });
        stretches.filter(|(free, _)| *free).map(|(_, run)| run)
    }
}

impl FromIterator<bool> for FreeSet {
    fn from_iter<I: IntoIterator<Item = bool>>(flags: I) -> Self {
        Self { free: flags.into_iter().collect() }
    }
}

/// Flags that are tested together, so that long stretches without a free variable are skipped at once.
const STRIDE: usize = 256;

/// Whether any of at most [`STRIDE`] flags is set, by comparing blocks of memory.
fn any(flags: &[bool]) -> bool {
    flags != &[false; STRIDE][..flags.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs that begin and end within, at and across the ends of strides, against flags one by one.
    #[test]
    fn sets_are_walked_from_any_place_in_both_directions() {
        for (from, to) in [(0, 0), (0, 1), (3, 700), (255, 257), (256, 512), (600, 601), (0, 1000)] {
            let set: FreeSet = (0..1000).map(|i| (from..to).contains(&i) || i == 990).collect();
            for place in [0, 1, 255, 256, 300, 991, 1000] {
                let expected: Vec<usize> = (place..1000).filter(|&i| set.contains(i)).collect();
                assert_eq!(set.within(place..1000).collect::<Vec<_>>(), expected, "{from}..{to}, from {place}");
                let expected: Vec<usize> = (0..place).rev().filter(|&i| set.contains(i)).collect();
                assert_eq!(set.before(place).collect::<Vec<_>>(), expected, "{from}..{to}, before {place}");
            }
            let runs: Vec<usize> = set.runs().flatten().collect();
            assert_eq!(runs, set.variables().collect::<Vec<_>>(), "{from}..{to}");
        }
    }
}
