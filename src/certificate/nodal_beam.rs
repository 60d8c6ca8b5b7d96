//! A beam on any supports under forces at the nodes of a grid: what the supports exert, moments and deflections, by statics and
//! integration as in [`kkt`](super::kkt), from station to station.
//!
//! A **station** is a node whose deflection is given: a support, or of a beam that its supports do not hold one of two nodes that
//! take the place of one. Between two stations moments and deflections are double sums with given ends; beyond the outermost
//! ones moments follow from the loads. With the moments `m` of the stations unknown, deflection and slope at both ends of a
//! span depend linearly on them, and
//!
//! ```text
//! φ(x−) = φ(x+) at a station,     φ(x−) = φ(x+) = φ_s where it is built in
//! φ(x±) = chord ± (Δ/EI) share,   share = M/2 (finite differences),  (2 M + M beside)/6 (exact beam)
//! ```
//!
//! are equations with three diagonals.

use super::kkt::DoubleSum;
use super::witness::tridiagonal;
use crate::scene::{Grid, Scene};
use crate::state::Discretisation;

/// A node whose deflection is given, and where the beam is built in its slope.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub(super) node: usize,
    pub(super) deflection: f64,
    pub(super) slope: Option<f64>,
}

/// The beam at all nodes, dimensionless.
#[derive(Debug, Clone)]
pub(super) struct NodalBeam {
    /// Deflections.
    pub(super) deflection: Vec<f64>,
    /// Moments on the left and on the right side of each node; they differ where the beam is built in.
    pub(super) moment: Vec<[f64; 2]>,
    /// What the stations exert upwards.
    pub(super) forces: Vec<f64>,
}

/// How a beam on a grid bends: `unit = Δ²/EI`, and the shares of the moments in the curvature at a node and beside an end.
struct Bending {
    unit: f64,
    /// Of the moment at a node and at each neighbour.
    inner: [f64; 2],
    /// Of the moment at the end of a span and at the node next to it.
    end: [f64; 2],
}

/// A part of the beam between two stations: `v/Δ` at its inner nodes, and the slopes at its ends.
struct Span {
    heights: Vec<f64>,
    slopes: [f64; 2],
}

impl Bending {
    fn of(discretisation: Discretisation, unit: f64) -> Self {
        match discretisation {
            Discretisation::FiniteDifferences => Self { unit, inner: [1.0, 0.0], end: [0.5, 0.0] },
            Discretisation::BeamElements => Self { unit, inner: [4.0 / 6.0, 1.0 / 6.0], end: [2.0 / 6.0, 1.0 / 6.0] },
        }
    }

    /// What the slope changes by at node `i` of moments `M/Δ`.
    fn turn(&self, moments: &[f64], i: usize) -> f64 {
        self.unit * (self.inner[0] * moments[i] + self.inner[1] * (moments[i - 1] + moments[i + 1]))
    }

    /// What it changes by between an end and the chord beside it.
    fn turn_at_end(&self, own: f64, beside: f64) -> f64 {
        self.unit * (self.end[0] * own + self.end[1] * beside)
    }

    /// A span with moments `M/Δ` at all its nodes, between two deflections `v/Δ`.
    fn span(&self, moments: &[f64], [from, to]: [f64; 2]) -> Span {
        let last = moments.len() - 1;
        let mut heights: Vec<f64> = (1..last).map(|i| self.turn(moments, i)).collect();
        let (start, turned) = DoubleSum::between_supports(&mut heights);
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let chord = (to - from) / last as f64;
        for (height, i) in heights.iter_mut().zip(1_u32..) {
            *height += from + chord * f64::from(i);
        }
        let left = chord + start + self.turn_at_end(moments[0], moments[1]);
        let right = chord + start - turned - self.turn_at_end(moments[last], moments[last - 1]);
        Span { heights, slopes: [left, right] }
    }

    /// `v/Δ` beyond an outermost station, from there outwards, with `M/Δ` in the same order and the slope outwards.
    fn overhang(&self, moments: &[f64], from: f64, slope: f64) -> Vec<f64> {
        if moments.len() < 2 {
            return Vec::new();
        }
        let mut falls: Vec<f64> = (1..moments.len() - 1).map(|i| self.turn(moments, i)).chain([0.0]).collect();
        DoubleSum::from(from, slope - self.turn_at_end(moments[0], moments[1])).along(&mut falls);
        falls
    }
}

/// `M/Δ` of a part that reaches to a free end under the forces `t` of its nodes, from that end inwards.
fn moments_from_tip(forces: &[f64]) -> Vec<f64> {
    let Some((tip, inner)) = forces.split_first() else { return Vec::new() };
    let mut moments = inner.to_vec();
    DoubleSum::from(0.0, -tip).along(&mut moments);
    std::iter::once(0.0).chain(moments).collect()
}

impl NodalBeam {
    /// The beam of a dimensionless scene under nodal forces `t` (loads less contact forces) at all nodes, on stations from left to
    /// right; [`None`] if they do not hold it.
    pub(super) fn of(
        scene: &Scene,
        grid: Grid,
        forces: &[f64],
        stations: &[Station],
        discretisation: Discretisation,
    ) -> Option<Self> {
        let step = grid.spacing();
        let bending = Bending::of(discretisation, step * step / scene.beam().bending_stiffness());
        let (first, last, nodes) = (stations.first()?.node, stations.last()?.node, forces.len());
        if stations.len() == 1 && stations[0].slope.is_none() {
            return None;
        }
        let left_tip = moments_from_tip(&forces[..=first]);
        let right_tip = moments_from_tip(&forces[last..].iter().rev().copied().collect::<Vec<_>>());
        let given = [*left_tip.last()?, *right_tip.last()?];

        // Moments of the spans without those of stations.
        let plain: Vec<Vec<f64>> = stations
            .windows(2)
            .map(|w| {
                let mut inner = forces[w[0].node + 1..w[1].node].to_vec();
                DoubleSum::between_supports(&mut inner);
                [0.0].into_iter().chain(inner).chain([0.0]).collect()
            })
            .collect();
        let with_ends = |k: usize, [a, b]: [f64; 2]| -> Vec<f64> {
            #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
            let share = |i: usize| i as f64 / (plain[k].len() - 1) as f64;
            plain[k].iter().enumerate().map(|(i, m)| m + a * (1.0 - share(i)) + b * share(i)).collect()
        };
        let ends = |k: usize| [stations[k].deflection / step, stations[k + 1].deflection / step];
        let slopes = |k: usize, moments: [f64; 2], ends: [f64; 2]| bending.span(&with_ends(k, moments), ends).slopes;

        // One unknown at a simple station, two at one where the beam is built in: left and right.
        let built_in = |k: usize| stations[k].slope.is_some();
        let index: Vec<[usize; 2]> = stations
            .iter()
            .scan(0, |next, station| {
                let left = *next;
                *next += if station.slope.is_some() { 2 } else { 1 };
                Some([left, *next - 1])
            })
            .collect();
        let mut rows = vec![[0.0; 4]; index.last()?[1] + 1];
        for (k, station) in stations.iter().enumerate() {
            for (side, at) in [(0, index[k][0]), (1, index[k][1])] {
                let outermost = if side == 0 { k == 0 } else { k + 1 == stations.len() };
                if outermost {
                    // Known from the overhang; at a simple station on both sides.
                    rows[at] = [0.0, 1.0, 0.0, given[side]];
                } else if built_in(k) {
                    rows[at][3] += if side == 0 { -station.slope? } else { station.slope? };
                }
            }
        }
        for k in 0..plain.len() {
            let base = slopes(k, [0.0; 2], ends(k));
            let units = [[1.0, 0.0], [0.0, 1.0]].map(|unit| {
                let of = slopes(k, unit, ends(k));
                [of[0] - base[0], of[1] - base[1]]
            });
            let (a, b) = (index[k][1], index[k + 1][0]);
            // φ(x+) − φ(x−) at the left end, and the same at the right one.
            if built_in(k) || 0 < k {
                rows[a][1] += units[0][0];
                rows[a][2] += units[1][0];
                rows[a][3] -= base[0];
            }
            if built_in(k + 1) || k + 2 < stations.len() {
                rows[b][0] -= units[0][1];
                rows[b][1] -= units[1][1];
                rows[b][3] += base[1];
            }
        }
        let unknown = tridiagonal(rows)?;

        let mut beam = Self { deflection: vec![0.0; nodes], moment: vec![[0.0; 2]; nodes], forces: Vec::new() };
        let mut end_slopes = [stations[0].slope, stations[stations.len() - 1].slope];
        for k in 0..plain.len() {
            let moments = with_ends(k, [unknown[index[k][1]], unknown[index[k + 1][0]]]);
            let Span { heights, slopes } = bending.span(&moments, ends(k));
            let from = stations[k].node;
            for (i, moment) in moments.iter().enumerate() {
                let sides = if i == 0 {
                    1..2
                } else if i + 1 == moments.len() {
                    0..1
                } else {
                    0..2
                };
                sides.for_each(|side| beam.moment[from + i][side] = moment * step);
            }
            heights.iter().enumerate().for_each(|(i, v)| beam.deflection[from + 1 + i] = v * step);
            if k == 0 {
                end_slopes[0] = end_slopes[0].or(Some(slopes[0]));
            }
            if k + 1 == plain.len() {
                end_slopes[1] = end_slopes[1].or(Some(slopes[1]));
            }
        }
        stations.iter().for_each(|station| beam.deflection[station.node] = station.deflection);
        for (side, tip) in [left_tip, right_tip].into_iter().enumerate() {
            let outwards: Vec<f64> = tip.into_iter().rev().collect();
            let (at, sign) = if side == 0 { (first, -1.0) } else { (last, 1.0) };
            let place = |i: usize| if side == 0 { at - i } else { at + i };
            let heights = bending.overhang(&outwards, beam.deflection[at] / step, sign * end_slopes[side]?);
            heights.iter().enumerate().for_each(|(i, v)| beam.deflection[place(i + 1)] = v * step);
            beam.moment[at][side] = outwards[0] * step;
            outwards.iter().enumerate().skip(1).for_each(|(i, m)| beam.moment[place(i)] = [m * step; 2]);
        }
        beam.forces = stations
            .iter()
            .map(|&Station { node, .. }| {
                let own = beam.moment[node];
                let left = node.checked_sub(1).map_or(0.0, |i| (beam.moment[i][1] - own[0]) / step);
                let right = beam.moment.get(node + 1).map_or(0.0, |beside| (beside[0] - own[1]) / step);
                forces[node] + left + right
            })
            .collect();
        Some(beam)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::kernel::interval::Interval;
    use crate::certificate::residuals::supports;
    use crate::certificate::{ContactLoad, contact_load, in_intervals};
    use crate::scene::{Balance, Beam, Load, PointLoad, Support};

    const LENGTH: f64 = 8.0;
    const INTERVALS: usize = 32;

    /// Beams on supports of every kind under forces at nodes: one simple support with a node of a given deflection, one built in,
    /// several with overhangs.
    fn scenes() -> Vec<Scene> {
        let (simple, built_in) = (Support::simple, Support::built_in);
        let turned = Support { at: 3.0, level: 0.2, slope: Some(-0.1) };
        let lists = [
            vec![simple(0.0), simple(LENGTH)],
            vec![simple(1.0), simple(6.0).at_level(0.3)],
            vec![built_in(0.0)],
            vec![turned],
            vec![built_in(LENGTH), simple(2.0), simple(3.0).at_level(-0.1)],
            vec![simple(0.5), turned, simple(5.0), built_in(7.75)],
            vec![built_in(0.0), simple(0.25), built_in(LENGTH)],
        ];
        let scene = |supports| {
            let beam = Beam::new(LENGTH, 3.0).expect("positive").with_supports(supports).expect("on the beam");
            let point = [(0.0, 0.5), (1.25, 2.0), (4.0, -1.0), (6.5, 1.0), (LENGTH, 0.75)];
            let point = point.map(|(at, force)| PointLoad { at, force }).to_vec();
            let load = Load::new(&beam, 0.0, Vec::new(), point).expect("finite");
            Scene::new(beam, load, None).expect("well posed")
        };
        lists.map(scene).to_vec()
    }

    fn solved(scene: &Scene, intervals: usize, discretisation: Discretisation) -> NodalBeam {
        let grid = Grid::uniform(scene, intervals).expect("a grid");
        let stations = supports(&grid, &scene.held(), LENGTH).expect("supports are nodes");
        NodalBeam::of(scene, grid, &grid.nodal_loads(scene.load()), &stations, discretisation).expect("it is held")
    }

    /// An exact beam, from its spans in intervals.
    fn exact(scene: &Scene, x: f64) -> f64 {
        let none = ContactLoad::new(LENGTH, []).expect("none");
        let cells = in_intervals(scene, Balance::Held, |enclosed| contact_load::deflection(&none, enclosed, &[]));
        let cells = cells.expect("it is held");
        let ([from, _], v) = cells[cells.partition_point(|c| c.0[1] < x).min(cells.len() - 1)];
        v.at(Interval::exact(x - from)).middle()
    }

    #[test]
    fn an_exact_beam_under_nodal_forces_is_found() {
        for scene in scenes() {
            let beam = solved(&scene, INTERVALS, Discretisation::BeamElements);
            let size = beam.deflection.iter().fold(0.1, |most: f64, v| most.max(v.abs()));
            for (k, v) in (0_u32..).zip(&beam.deflection) {
                let expected = exact(&scene, 0.25 * f64::from(k));
                assert!((v - expected).abs() <= 1e-12 * size, "{v}, not {expected}, at node {k} of {:?}", scene.beam());
            }
            let all: f64 = beam.forces.iter().sum();
            assert!((all - 3.25).abs() <= 1e-11, "{:?} carry 3.25", beam.forces);
        }
    }

    /// Finite differences come to it with the square of the interval.
    #[test]
    fn finite_differences_come_to_the_exact_beam() {
        for scene in scenes() {
            let off = |intervals: usize| {
                let beam = solved(&scene, intervals, Discretisation::FiniteDifferences);
                let step = intervals / INTERVALS;
                let nodes = (0_u32..).zip(beam.deflection.iter().step_by(step));
                nodes.fold(0.0, |most: f64, (k, v)| most.max((v - exact(&scene, 0.25 * f64::from(k))).abs()))
            };
            let (coarse, fine) = (off(4 * INTERVALS), off(8 * INTERVALS));
            assert!(fine <= 0.3 * coarse + 1e-12 && coarse < 0.02, "{coarse} and {fine} of {:?}", scene.beam());
        }
    }
}
