//! A beam on any supports under forces at the nodes of a grid: what the supports exert, moments and deflections, by statics and
//! integration from station to station.
//!
//! A **station** is a node whose deflection is given: a support, or of a beam that its supports do not hold one of two nodes that
//! take the place of one. Between two stations, and between the outermost ones and the tips of the beam, forces `t` bend the beam
//! by
//!
//! ```text
//! M_i = M_{i−1} + V_{i−1} Δ,   V_i = V_{i−1} − t_i
//! v_i = v_{i−1} + θ_{i−1} Δ,   θ_i = θ_{i−1} − (Δ/EI) c_i
//! ```
//!
//! with the curvature share `c_i = M_i` of finite differences or `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. Both are the same
//! [`DoubleSum`]: of moments that vanish at a tip, of deflections with given ends. With the moments `M` of the stations unknown,
//! the slopes at both ends of a span depend linearly on them, and
//!
//! ```text
//! φ(x−) = φ(x+) at a station,     φ(x−) = φ(x+) = φ_s where it is built in
//! φ(x±) = θ ± (Δ/EI) share,       share = M/2 (finite differences),  (2 M + M beside)/6 (exact beam)
//! ```
//!
//! are equations with three diagonals. The paper's beam has two stations and no unknown.

use super::double_sum::DoubleSum;
use super::witness::tridiagonal;
use crate::scene::{Grid, Held, Scene};
use crate::state::Discretisation;

/// A node whose deflection is given, and where the beam is built in its slope.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub(super) node: usize,
    pub(super) deflection: f64,
    pub(super) slope: Option<f64>,
}

/// The beam at all nodes, dimensionless.
///
/// Deflections of a fine grid are not kept: whoever wants them [walks](Self::walk) along the beam.
#[derive(Debug, Clone)]
pub(super) struct NodalBeam {
    bending: Bending,
    step: f64,
    /// `M_i/Δ` at all nodes but stations \[force\].
    moments: Vec<f64>,
    spans: Vec<Part>,
    /// Beyond the first and the last station.
    overhangs: [Option<Part>; 2],
    /// Of each station: what it exerts upwards, and the moments on both sides of it, which differ where the beam is built in.
    pub(super) stations: Vec<(f64, [f64; 2])>,
}

/// How a beam on a grid bends: `unit = Δ²/EI`, and the shares of the moments in the curvature at a node and beside an end.
#[derive(Debug, Clone, Copy)]
struct Bending {
    unit: f64,
    /// Of the moment at a node and at each neighbour.
    inner: [f64; 2],
    /// Of the moment at the end of a span and at the node next to it.
    end: [f64; 2],
}

/// A part of the beam between two neighbours among tips and stations.
#[derive(Debug, Clone, Copy)]
struct Part {
    /// Its first and its last node.
    nodes: [usize; 2],
    /// `M/Δ` at both.
    ends: [f64; 2],
    /// Shear forces `V` in its first and its last interval.
    shears: [f64; 2],
    /// Slopes `θ` there.
    slopes: [f64; 2],
    /// `v/Δ` at its first node.
    height: f64,
}

/// Nodes of a step of a walk: few enough for the nearest cache.
const BATCH: usize = 256;

/// A number of nodes, for arithmetic.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn number(nodes: usize) -> f64 {
    nodes as f64
}

impl Bending {
    fn of(discretisation: Discretisation, unit: f64) -> Self {
        match discretisation {
            Discretisation::FiniteDifferences => Self { unit, inner: [1.0, 0.0], end: [0.5, 0.0] },
            Discretisation::BeamElements => Self { unit, inner: [4.0 / 6.0, 1.0 / 6.0], end: [2.0 / 6.0, 1.0 / 6.0] },
        }
    }

    /// `(Δ²/EI) c_i/Δ` at the inner nodes of a part, of some neighbours at a time, with the index of the first one.
    fn curvatures(&self, moments: &[f64], [left, right]: [f64; 2], mut visit: impl FnMut(usize, &mut [f64])) {
        let [own, beside] = self.inner.map(|share| self.unit * share);
        let mut curvatures = [0.0; BATCH];
        let mut before = left;
        for (b, batch) in moments.chunks(BATCH).enumerate() {
            let first = b * BATCH;
            let behind = moments.get(first + BATCH).copied().unwrap_or(right);
            let after = batch.iter().skip(1).chain([&behind]);
            let curvatures = &mut curvatures[..batch.len()];
            for ((share, &m), after) in curvatures.iter_mut().zip(batch).zip(after) {
                *share = own * m + beside * (before + after);
                before = m;
            }
            visit(first, curvatures);
        }
    }

    /// What the inner nodes of a part let its height fall by until its end, and its slope.
    fn falls(&self, moments: &[f64], ends: [f64; 2]) -> [f64; 2] {
        let mut shot = DoubleSum::default();
        self.curvatures(moments, ends, |_, curvatures| shot.along(curvatures));
        [-shot.next(), -shot.slope()]
    }

    /// By how much the slope changes between the end of a part and the interval beside it, for `M/Δ` there and at the next node.
    fn turn(&self, end: f64, next: f64) -> f64 {
        self.unit * (self.end[0] * end + self.end[1] * next)
    }

    /// Slopes of the tangents at the ends of `n` intervals of which moments `a` and `b` at the ends are all that bends them, on a
    /// straight line between these.
    ///
    /// ```text
    /// θ = Σ (n−i)/n c_i = (Δ²/EI) (n−1) (a (2n−1) + b (n+1)) / 6n,     c_i = a (n−i)/n + b i/n
    /// ```
    fn tangents_of_line(&self, intervals: usize, [a, b]: [f64; 2]) -> [f64; 2] {
        let n = number(intervals);
        let slope = |near: f64, far: f64| {
            let first = self.unit * ((n - 1.0) * (near * (2.0 * n - 1.0) + far * (n + 1.0))) / (6.0 * n);
            first + self.turn(near, near + (far - near) / n)
        };
        [slope(a, b), -slope(b, a)]
    }
}

impl Part {
    fn intervals(&self) -> usize {
        self.nodes[1] - self.nodes[0]
    }

    /// Its inner nodes.
    fn inner(&self) -> std::ops::Range<usize> {
        self.nodes[0] + 1..self.nodes[1]
    }

    /// From the tip of an overhang on the left to a station, with `V = −t` beside the tip. Forces become moments.
    fn from_tip(forces: &mut [f64], station: usize) -> Self {
        let shear = -forces[0];
        let mut sums = DoubleSum::from(0.0, shear);
        sums.along(&mut forces[1..station]);
        Self { nodes: [0, station], ends: [0.0, sums.next()], shears: [shear, sums.slope()], ..Self::unbent() }
    }

    /// From a station to the tip of an overhang on the right, with `V = t` beside the tip.
    fn to_tip(forces: &mut [f64], station: usize) -> Self {
        let (tip, nodes) = (forces.len() - 1, [station, forces.len() - 1]);
        let (shear, inner) = (forces[tip], &mut forces[station + 1..tip]);
        let shot = DoubleSum::shot(inner);
        let first = shear - shot.slope();
        let moment = -(shot.next() + first * number(tip - station));
        DoubleSum::from(moment, first).along(inner);
        Self { nodes, ends: [moment, 0.0], shears: [first, shear], ..Self::unbent() }
    }

    /// Between two stations, without moments there.
    fn span(forces: &mut [f64], nodes: [usize; 2]) -> Self {
        let (shear, sum) = DoubleSum::between_supports(&mut forces[nodes[0] + 1..nodes[1]]);
        Self { nodes, shears: [shear, shear - sum], ..Self::unbent() }
    }

    fn unbent() -> Self {
        Self { nodes: [0; 2], ends: [0.0; 2], shears: [0.0; 2], slopes: [0.0; 2], height: 0.0 }
    }

    /// Moments at the ends of a span, and what they add to those of its inner nodes and to its shear forces.
    fn add_line(&mut self, moments: &mut [f64], ends: [f64; 2]) {
        let n = number(self.intervals());
        let rise = (ends[1] - ends[0]) / n;
        for (i, moment) in moments.iter_mut().enumerate() {
            let share = number(i + 1) / n;
            *moment += ends[0] * (1.0 - share) + ends[1] * share;
        }
        self.ends = ends;
        self.shears.iter_mut().for_each(|shear| *shear += rise);
    }

    /// Slopes of a span between two heights `v/Δ`.
    fn bend(&mut self, bending: &Bending, moments: &[f64], [from, to]: [f64; 2]) {
        let [low, turned] = bending.falls(moments, self.ends);
        let slope = (to - from + low) / number(self.intervals());
        (self.height, self.slopes) = (from, [slope, slope - turned]);
    }

    /// Slopes of an overhang on the left or on the right of a station with a given height `v/Δ` and slope.
    fn hang(&mut self, side: usize, bending: &Bending, moments: &[f64], height: f64, slope: f64) {
        let [low, turned] = bending.falls(moments, self.ends);
        let [first, last] = [moments.first(), moments.last()].map(|moment| moment.copied().unwrap_or(0.0));
        if side == 0 {
            let slope = slope + bending.turn(self.ends[1], last);
            self.slopes = [slope + turned, slope];
            self.height = height - (self.slopes[0] * number(self.intervals()) - low);
        } else {
            let slope = slope - bending.turn(self.ends[0], first);
            (self.height, self.slopes) = (height, [slope, slope - turned]);
        }
    }

    /// Slopes of the tangents at both ends.
    fn tangents(&self, bending: &Bending, moments: &[f64]) -> [f64; 2] {
        let [left, right] = self.ends;
        let [first, last] = [moments.first().copied().unwrap_or(right), moments.last().copied().unwrap_or(left)];
        [self.slopes[0] + bending.turn(left, first), self.slopes[1] - bending.turn(right, last)]
    }
}

impl NodalBeam {
    /// The beam of a dimensionless scene under nodal forces `t` (loads less contact forces) at all nodes, on stations from left to
    /// right; [`None`] if they do not hold it.
    pub(super) fn of(
        scene: &Scene,
        grid: Grid,
        forces: Vec<f64>,
        stations: &[Station],
        discretisation: Discretisation,
    ) -> Option<Self> {
        let step = grid.spacing();
        let bending = Bending::of(discretisation, step * step / scene.beam().bending_stiffness());
        let (leftmost, rightmost) = (stations.first()?, stations.last()?);
        if stations.len() == 1 && leftmost.slope.is_none() {
            return None;
        }
        let own: Vec<f64> = stations.iter().map(|station| forces[station.node]).collect();
        let mut moments = forces;
        let left = (0 < leftmost.node).then(|| Part::from_tip(&mut moments, leftmost.node));
        let right = (rightmost.node < grid.intervals()).then(|| Part::to_tip(&mut moments, rightmost.node));
        let mut spans: Vec<Part> =
            stations.windows(2).map(|w| Part::span(&mut moments, [w[0].node, w[1].node])).collect();
        let heights = |k: usize| [stations[k].deflection / step, stations[k + 1].deflection / step];

        let given = [left.map_or(0.0, |part| part.ends[1]), right.map_or(0.0, |part| part.ends[0])];
        let unknown = at_stations(&bending, stations, given, &spans, &moments, heights)?;
        for (k, span) in spans.iter_mut().enumerate() {
            span.add_line(&mut moments[span.inner()], [unknown[k][1], unknown[k + 1][0]]);
            span.bend(&bending, &moments[span.inner()], heights(k));
        }
        let mut overhangs = [left, right];
        let outer = [(leftmost, spans.first()), (rightmost, spans.last())];
        for (side, (part, (station, span))) in overhangs.iter_mut().zip(outer).enumerate() {
            let tangent = |span: &Part| span.tangents(&bending, &moments[span.inner()])[side];
            let slope = station.slope.or(span.map(tangent))?;
            let Some(part) = part else { continue };
            part.hang(side, &bending, &moments[part.inner()], station.deflection / step, slope);
        }
        let sides = |k: usize| {
            let [left, right] = overhangs;
            let left = if k == 0 { left } else { Some(spans[k - 1]) };
            [left, if k + 1 == stations.len() { right } else { Some(spans[k]) }]
        };
        let at_station = |(k, own): (usize, f64)| {
            let [left, right] = sides(k).map(|part| part.unwrap_or(Part::unbent()));
            (own + right.shears[0] - left.shears[1], [left.ends[1], right.ends[0]].map(|moment| moment * step))
        };
        let stations = own.into_iter().enumerate().map(at_station).collect();
        Some(Self { bending, step, moments, spans, overhangs, stations })
    }

    /// From left to right, some neighbouring nodes at a time that are no stations: the first one, and `M_i` and `v_i` of all.
    pub(super) fn walk(&self, mut visit: impl FnMut(usize, &[f64], &[f64])) {
        let [left, right] = &self.overhangs;
        if let Some(overhang) = left {
            visit(0, &[0.0], &[overhang.height * self.step]);
        }
        let mut moments = [0.0; BATCH];
        for part in left.iter().chain(&self.spans).chain(right) {
            let mut sums = DoubleSum::from(part.height, part.slopes[0]);
            let inner = &self.moments[part.inner()];
            self.bending.curvatures(inner, part.ends, |first, deflections| {
                // (Δ²/EI) c_i/Δ become v_i/Δ.
                sums.along(deflections);
                let moments = &mut moments[..deflections.len()];
                moments.copy_from_slice(&inner[first..first + deflections.len()]);
                for value in moments.iter_mut().chain(deflections.iter_mut()) {
                    *value *= self.step;
                }
                visit(part.nodes[0] + 1 + first, moments, deflections);
            });
            if right.is_some_and(|overhang| overhang.nodes == part.nodes) {
                visit(part.nodes[1], &[0.0], &[sums.next() * self.step]);
            }
        }
    }
}

/// `M/Δ` on the left and on the right side of each station, from `given` ones of the overhangs.
///
/// One unknown at a simple station, two at one where the beam is built in.
fn at_stations(
    bending: &Bending,
    stations: &[Station],
    given: [f64; 2],
    spans: &[Part],
    moments: &[f64],
    heights: impl Fn(usize) -> [f64; 2],
) -> Option<Vec<[f64; 2]>> {
    let mut unknowns = 0;
    let index: Vec<[usize; 2]> = stations
        .iter()
        .map(|station| {
            let left = unknowns;
            unknowns += if station.slope.is_some() { 2 } else { 1 };
            [left, unknowns - 1]
        })
        .collect();
    // Known from the overhangs; at a simple station on both sides.
    let mut rows = vec![[0.0; 4]; unknowns];
    let outer = [0, unknowns - 1];
    for (row, moment) in outer.into_iter().zip(given) {
        rows[row] = [0.0, 1.0, 0.0, moment];
    }
    for (station, [left, right]) in stations.iter().zip(&index) {
        let Some(slope) = station.slope else { continue };
        for (row, sign) in [(*left, -1.0), (*right, 1.0)] {
            if !outer.contains(&row) {
                rows[row][3] += sign * slope;
            }
        }
    }
    for (k, span) in spans.iter().enumerate() {
        // Equations for the slopes φ(x+) at its left end and φ(x−) at its right one.
        let ends = [index[k][1], index[k + 1][0]];
        if ends.iter().all(|row| outer.contains(row)) {
            continue;
        }
        let mut plain = *span;
        plain.bend(bending, &moments[span.inner()], heights(k));
        let base = plain.tangents(bending, &moments[span.inner()]);
        let of_units = [[1.0, 0.0], [0.0, 1.0]].map(|unit| bending.tangents_of_line(span.intervals(), unit));
        for (side, (row, sign)) in ends.into_iter().zip([1.0, -1.0]).enumerate() {
            if !outer.contains(&row) {
                // Of the three diagonals those of the two ends.
                rows[row][1 - side] += sign * of_units[0][side];
                rows[row][2 - side] += sign * of_units[1][side];
                rows[row][3] -= sign * base[side];
            }
        }
    }
    let unknown = tridiagonal(rows)?;
    Some(index.into_iter().map(|sides| sides.map(|row| unknown[row])).collect())
}

/// The supports as stations; [`None`] if one of them is between nodes.
pub(super) fn supports(grid: &Grid, held: &[Held]) -> Option<Vec<Station>> {
    let station =
        |held: &Held| Some(Station { node: grid.node_at(held.at)?, deflection: held.deflection, slope: held.slope });
    held.iter().map(station).collect()
}

/// Adds nodes to the stations until the beam is held: those that press most, or that press most about the one that is there, and
/// where nothing presses an end of the beam. They have the given deflections; nodes are counted from the `first` one that has any.
pub(super) fn stand(stations: &mut Vec<Station>, first: usize, contact: &[f64], deflection: &[f64]) {
    while stations.len() < 2 && stations.iter().all(|station| station.slope.is_none()) {
        let last = first + contact.len() - 1;
        let taken = stations.first().map(|station| station.node);
        let lever = |node: usize| taken.map_or(1.0, |taken| number(taken.abs_diff(node)));
        let (mut most, mut pressing) = (0.0, None);
        for (node, force) in (first..).zip(contact) {
            let turns = force * lever(node);
            if most < turns {
                (most, pressing) = (turns, Some(node));
            }
        }
        let node = pressing.unwrap_or(if taken.is_some_and(|taken| last <= 2 * taken) { first } else { last });
        let at = stations.partition_point(|station| station.node < node);
        stations.insert(at, Station { node, deflection: deflection[node - first], slope: None });
    }
}

#[cfg(test)]
mod tests;
