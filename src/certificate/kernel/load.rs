//! The true distributed load: piecewise linear, with point loads and couples between the pieces.

use super::interval::Interval;
use crate::scene::{Concentrated, Scene};

/// The load of a scene, by pieces.
#[derive(Debug, Clone)]
pub(crate) struct EnclosedLoad {
    /// Ends of the pieces, from 0 to `l`.
    ends: Vec<f64>,
    /// `q` at both ends of each piece.
    lines: Vec<[Interval; 2]>,
    /// Positions and forces, from left to right.
    pub(crate) points: Vec<(f64, Interval)>,
    /// Positions and couples, from left to right. The moment increases by the couple.
    pub(crate) couples: Vec<(f64, Interval)>,
}

impl EnclosedLoad {
    pub(crate) fn of(scene: &Scene) -> Self {
        let (load, length) = (scene.load(), scene.beam().length());
        let ends = ends(load.linear().iter().flat_map(|q| [q.from, q.to]).chain([0.0, length]).collect());
        let mut lines = vec![[Interval::exact(load.uniform()); 2]; ends.len() - 1];
        for q in load.linear() {
            let [from, to] = [q.from, q.to].map(|end| ends.partition_point(|x| *x < end));
            let at = |x: f64| line([q.from, q.to], [q.start, q.end].map(Interval::exact), x)[0];
            for piece in from..to {
                lines[piece] = [0, 1].map(|k| lines[piece][k] + at(ends[piece + k]));
            }
        }
        let mut acting: Vec<Concentrated> = load.concentrated().collect();
        acting.sort_by(|a, b| a.at.total_cmp(&b.at));
        let (mut points, mut couples) = (Vec::with_capacity(acting.len()), Vec::new());
        for Concentrated { at, force, couple } in acting {
            points.extend((force != 0.0 || couple == 0.0).then_some((at, Interval::exact(force))));
            couples.extend((couple != 0.0).then_some((at, Interval::exact(couple))));
        }
        Self { ends, lines, points, couples }
    }

    /// Positions strictly between two others where the formula of the load changes, or where a point load or a couple acts.
    pub(crate) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let first = self.ends.partition_point(|x| *x <= from);
        let ends = self.ends[first..].iter().copied().take_while(|x| *x < to);
        let acting = [&self.points, &self.couples].into_iter().flat_map(|all| {
            let first = all.partition_point(|p| p.0 <= from);
            all[first..].iter().map(|p| p.0).take_while(|x| *x < to)
        });
        self::ends(ends.chain(acting).collect())
    }

    /// `[q, q']` at an origin, which lies within the given interval; the interval contains no break.
    pub(crate) fn line(&self, origin: f64, [from, to]: [f64; 2]) -> [Interval; 2] {
        let piece = self.ends.partition_point(|x| *x <= from.max(0.0).min(to)).clamp(1, self.lines.len()) - 1;
        line([self.ends[piece], self.ends[piece + 1]], self.lines[piece], origin)
    }

    /// The sum of the point loads at a position, zero if there is none.
    pub(crate) fn point(&self, x: f64) -> Interval {
        at(&self.points, x)
    }

    /// The sum of the couples at a position, zero if there is none.
    pub(crate) fn couple(&self, x: f64) -> Interval {
        at(&self.couples, x)
    }
}

/// The sum of the entries at a position.
fn at(all: &[(f64, Interval)], x: f64) -> Interval {
    let here = all[all.partition_point(|p| p.0 < x)..].iter().take_while(|p| p.0 <= x);
    here.fold(Interval::ZERO, |sum, p| sum + p.1)
}

/// The value of a line at a position and its slope, from its values at both ends. Using both ends keeps a zero at either of them exact.
fn line(ends: [f64; 2], values: [Interval; 2], x: f64) -> [Interval; 2] {
    let slope = (values[1] - values[0]) / Interval::length(ends[0], ends[1]);
    let [left, right] = [0, 1].map(|k| values[k] + slope * Interval::length(ends[k], x));
    [left.meet(right), slope]
}

/// The cells between two positions: pairs of neighbouring ends, including all `breaks`.
pub(crate) fn cells(from: f64, to: f64, mut breaks: Vec<f64>) -> Vec<[f64; 2]> {
    breaks.retain(|x| from < *x && *x < to);
    breaks.extend([from, to]);
    ends(breaks).windows(2).map(|w| [w[0], w[1]]).collect()
}

/// The positions from left to right, without duplicates.
fn ends(mut places: Vec<f64>) -> Vec<f64> {
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::kernel::polynomial::Polynomial;
    use crate::scene::{Beam, LinearLoad, Load};

    /// Loads that overlap, follow each other or begin together add up at every position.
    #[test]
    fn parts_of_a_load_add_up() {
        /// Rounding of a sum of a few hundred numbers of similar size.
        const ROUNDING: f64 = 1e-12;
        const LENGTH: f64 = 8.0;
        let beam = Beam::new(LENGTH, 70.0).expect("positive");
        for count in [0, 1, 2, 5, 40, 300] {
            let part = |k: i32| {
                let (from, width) = (0.25 * f64::from(7 * k % 31), 0.25 * f64::from(1 + 5 * k % 9));
                LinearLoad { from, to: LENGTH.min(from + width), start: f64::from(k % 4), end: 3.0 - f64::from(k % 7) }
            };
            let parts: Vec<LinearLoad> = (0..count).map(part).collect();
            let load = Load::new(&beam, 2.0, parts.clone(), Vec::new()).expect("finite");
            let pieces = EnclosedLoad::of(&Scene::new(beam.clone(), load, None).expect("well posed"));
            for [from, to] in cells(0.0, LENGTH, pieces.breaks(0.0, LENGTH)) {
                for share in [0.0, 0.3, 0.9] {
                    let s = share * (to - from);
                    let acts = |q: &&LinearLoad| q.from <= from && to <= q.to;
                    let sum = parts.iter().filter(acts).fold(2.0, |sum, q| sum + q.intensity(from + s));
                    let size = 2.0 + 12.0 * f64::from(count);
                    for (origin, s, left) in [(from, s, from), (to, s - (to - from), from), (from + s, 0.0, from + s)] {
                        let q = Polynomial::new(&pieces.line(origin, [left, to])).at(Interval::exact(s)).middle();
                        assert!((q - sum).abs() <= ROUNDING * size, "{q}, not {sum}, {s} from {origin}");
                    }
                }
            }
        }
    }
}
