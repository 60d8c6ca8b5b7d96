//! The true load, distributed as it is: linear on pieces, with point loads between them.

use super::polynomial::Polynomial;
use crate::certificate::interval::Interval;
use crate::scene::{Load, Scene};

/// The load of a scene by pieces.
#[derive(Debug, Clone)]
pub(super) struct Pieces {
    /// Ends of the pieces, from 0 to `l`.
    ends: Vec<f64>,
    /// On each piece `q` at its left end, and its slope.
    lines: Vec<[Interval; 2]>,
    /// Places and forces, from left to right, one at a place.
    points: Vec<(f64, Interval)>,
}

impl Pieces {
    pub(super) fn of(scene: &Scene) -> Self {
        let (load, length) = (scene.load(), scene.beam().length());
        let mut ends: Vec<f64> = load.linear().iter().flat_map(|q| [q.from, q.to]).chain([0.0, length]).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let lines = ends.windows(2).map(|w| line(load, w[0], w[1])).collect();
        let mut points: Vec<(f64, Interval)> = Vec::new();
        let mut given: Vec<_> = load.point().iter().map(|p| (p.at, Interval::exact(p.force))).collect();
        given.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (at, force) in given {
            match points.last_mut() {
                Some(last) if at <= last.0 => last.1 = last.1 + force,
                _ => points.push((at, force)),
            }
        }
        Self { ends, lines, points }
    }

    /// Where the load changes its formula, and where point loads are, strictly between two places.
    pub(super) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let first = self.ends.partition_point(|x| *x <= from);
        let ends = self.ends[first..].iter().copied().take_while(|x| *x < to);
        let first = self.points.partition_point(|p| p.0 <= from);
        let points = self.points[first..].iter().map(|p| p.0).take_while(|x| *x < to);
        ends.chain(points).collect()
    }

    /// `q(from + s)`; there is no break between the two places.
    pub(super) fn cell(&self, from: f64, to: f64) -> Polynomial {
        let piece = self.ends.partition_point(|x| *x <= from.max(0.0).min(to)).clamp(1, self.lines.len()) - 1;
        let [start, slope] = self.lines[piece];
        if slope == Interval::ZERO {
            return Polynomial::new(&[start]);
        }
        Polynomial::new(&[start + slope * (Interval::exact(from) - Interval::exact(self.ends[piece])), slope])
    }

    /// The point load at a place.
    pub(super) fn point(&self, x: f64) -> Option<Interval> {
        self.points.binary_search_by(|p| p.0.total_cmp(&x)).ok().map(|i| self.points[i].1)
    }
}

/// All distributed loads on the piece from `from` to `to`.
fn line(load: &Load, from: f64, to: f64) -> [Interval; 2] {
    let mut sum = [Interval::exact(load.uniform()), Interval::ZERO];
    for q in load.linear().iter().filter(|q| q.from <= from && to <= q.to) {
        let rise = Interval::exact(q.end) - Interval::exact(q.start);
        let slope = rise / (Interval::exact(q.to) - Interval::exact(q.from));
        sum[0] = sum[0] + Interval::exact(q.start) + slope * (Interval::exact(from) - Interval::exact(q.from));
        if 0.0 < (q.end - q.start).abs() {
            sum[1] = sum[1] + slope;
        }
    }
    sum
}

/// Cells between two places: pairs of neighbouring ends, with all `breaks` among them.
pub(super) fn cells(from: f64, to: f64, mut breaks: Vec<f64>) -> Vec<[f64; 2]> {
    breaks.retain(|x| from < *x && *x < to);
    breaks.extend([from, to]);
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    breaks.windows(2).map(|w| [w[0], w[1]]).collect()
}
