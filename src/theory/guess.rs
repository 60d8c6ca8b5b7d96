//! The first idea of a list of contacts: samples of the profile, the chain above them, and the points and zones where it
//! touches.
//!
//! Samples are few where nothing touches, and are refined where the chain lifts off and where a list failed its check.

use std::ops::Range;

use super::chain::{Chain, Guess};
use super::list::{AtSupport, Kind, List, Node, edge_node, normalised};
use super::piecewise::PiecewiseScene;
use super::tension::zones_between;

/// Sampled places of the profile, from support to support.
#[derive(Debug, Clone)]
pub(super) struct Samples {
    /// Where.
    x: Vec<f64>,
    /// The cell to the right of each.
    cell: Vec<usize>,
    /// True for a link that is far from contact; link `i` starts at sample `i`.
    far: Vec<bool>,
}

/// A profile of more cells than this is sampled at the shallowest places of as many blocks first.
pub(super) const LONG: usize = 4000;
/// Parts into which a link near a lift-off point is cut.
const PARTS: u32 = 4;
/// Parts of each cell where several cells were one link: a beam may touch at breaks, and in between.
const PARTS_OF_CELL: u32 = 3;

impl Samples {
    /// All breakpoints, and cells cut into parts no longer than a fraction 1/`links` of the beam; of a long survey the
    /// shallowest breakpoint of each block, and where the load changes.
    pub(super) fn first(given: &PiecewiseScene, links: u32) -> Self {
        let mut samples = Self { x: Vec::new(), cell: Vec::new(), far: Vec::new() };
        let cells = given.cells.len();
        if cells <= LONG {
            let aim = given.length / f64::from(links);
            for (i, cell) in given.cells.iter().enumerate() {
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most `links`")]
                let parts = ((cell.hi - cell.lo) / aim).ceil() as u32;
                samples.cut(i, [cell.lo, cell.hi], parts, false);
            }
        } else {
            samples.push(0.0, 0, false);
            let block = cells.div_ceil(LONG);
            for first in (1..cells).step_by(block) {
                let breakpoints = first..cells.min(first + block);
                let depth = |&i: &usize| given.depth_at_breakpoint(i);
                let shallowest = breakpoints.clone().min_by(|i, j| depth(i).total_cmp(&depth(j)));
                for i in breakpoints.filter(|&i| Some(i) == shallowest || given.load_changes_at(i)) {
                    samples.push(given.breakpoints[i].x, i, false);
                }
            }
        }
        samples.end(given);
        samples
    }

    /// More samples where the chain lifts off, and near `places`.
    pub(super) fn refined(&self, given: &PiecewiseScene, touches: &[bool], places: &[f64]) -> Self {
        let n = self.x.len();
        let touching = |i: usize| 0 < i && i + 1 < n && touches[i - 1];
        let mut near: Vec<bool> = (0..n).map(touching).collect();
        for &x in places {
            let i = self.x.partition_point(|&other| other <= x).saturating_sub(1);
            near[i] = true;
            near[(i + 1).min(n - 1)] = true;
        }
        let mut refined =
            Self { x: Vec::with_capacity(2 * n), cell: Vec::with_capacity(2 * n), far: Vec::with_capacity(2 * n) };
        let coarse = |i: usize| given.cells[self.cell[i]].hi < self.x[i + 1];
        for i in 0..n - 1 {
            // Beside a link of many cells the contact is known to within a block or two.
            let reach = if coarse(i) { 2 } else { 0 };
            let close = (i.saturating_sub(reach)..=(i + 1 + reach).min(n - 1)).any(|j| near[j]);
            let around = [i.saturating_sub(1), (i + 2).min(n - 1)];
            let interior = (around[0]..=around[1]).all(touching)
                && !coarse(i)
                && given.tension_between(self.x[around[0]], self.x[around[1]]).next().is_none()
                && [i, i + 1]
                    .iter()
                    .all(|&j| given.cells[self.cell[j]].lo < self.x[j] || !given.breaks_at(self.cell[j]));
            let parts = match (close, interior) {
                (true, false) => PARTS,
                _ => 1,
            };
            if coarse(i) && close {
                let last = given.cell_to(self.x[i + 1]);
                for cell in self.cell[i]..=last {
                    let c = &given.cells[cell];
                    refined.cut(cell, [c.lo.max(self.x[i]), c.hi.min(self.x[i + 1])], PARTS_OF_CELL, false);
                }
            } else {
                refined.cut(self.cell[i], [self.x[i], self.x[i + 1]], parts, !close);
            }
        }
        refined.end(given);
        refined
    }

    fn push(&mut self, x: f64, cell: usize, far: bool) {
        self.x.push(x);
        self.cell.push(cell);
        self.far.push(far);
    }

    /// The start of a link in `cell` and the places that cut it into equal parts.
    fn cut(&mut self, cell: usize, [lo, hi]: [f64; 2], parts: u32, far: bool) {
        self.push(lo, cell, far);
        for part in 1..parts {
            let x = lo + (hi - lo) * (f64::from(part) / f64::from(parts));
            if self.x.last().is_some_and(|&last| last < x) && x < hi {
                self.push(x, cell, far);
            }
        }
    }

    /// The right support.
    fn end(&mut self, given: &PiecewiseScene) {
        self.x.push(given.length);
        self.cell.push(given.cells.len() - 1);
        if self.x.len() < 3 {
            self.x.insert(1, 0.5 * given.length);
            self.cell.insert(1, 0);
            self.far.push(false);
        }
    }

    /// The number of samples.
    pub(super) fn count(&self) -> usize {
        self.x.len()
    }

    /// Which of the samples touch, and with what force.
    pub(super) fn chain(&self, given: &PiecewiseScene) -> Guess {
        let n = self.x.len() - 2;
        let mut load = vec![0.0; n + 2];
        let mut bend = vec![0.0; n + 2];
        for i in 0..=n {
            let (a, b) = (self.x[i], self.x[i + 1]);
            let length = b - a;
            let last = given.cell_to(b).max(self.cell[i]);
            for cell in self.cell[i]..=last {
                let c = &given.cells[cell];
                let (lo, hi) = (c.lo.max(a), c.hi.min(b));
                let (start, end, width) = (given.load(cell, lo), given.load(cell, hi), hi - lo);
                // Resultant and lever of a trapezium.
                let force = 0.5 * width * (start + end);
                let lever = width * width * (start + 2.0 * end) / 6.0 + force * (lo - a);
                load[i] += force - lever / length;
                load[i + 1] += lever / length;
                if a < c.lo {
                    let force = given.breakpoints[cell].force;
                    load[i] += force * (b - c.lo) / length;
                    load[i + 1] += force * (c.lo - a) / length;
                }
            }
            if a <= given.cells[self.cell[i]].lo {
                load[i] += given.breakpoints[self.cell[i]].force;
                bend[i] += given.breakpoints[self.cell[i]].kink;
            }
            let [start, end] = given.turns([a, b], [self.cell[i], last], !self.far[i]);
            bend[i] += start;
            bend[i + 1] += end;
            if self.far[i] {
                let (start, end) = (given.load(self.cell[i], a), given.load(last, b));
                let unit = length * length * length / 360.0;
                bend[i] += unit * (8.0 * start + 7.0 * end);
                bend[i + 1] += unit * (7.0 * start + 8.0 * end);
            }
        }
        let ends = [given.derivative(0, 0.0, 0), given.derivative(given.cells.len() - 1, given.length, 0)];
        Chain { x: &self.x, bend: &bend[1..=n], load: &load[1..=n], beam: &self.far, ends }.solve()
    }

    /// The list that the chain suggests.
    pub(super) fn list(&self, given: &PiecewiseScene, guess: &Guess) -> List {
        let mut builder = Builder { given, samples: self, guess, list: List::free() };
        let n = self.x.len() - 2;
        // A run of touching samples falls apart at every break of the profile.
        let (mut first, mut beside_edge) = (None, false);
        for i in 1..=n + 1 {
            let touches = i <= n && guess.touches[i - 1];
            let breakpoint = self.cell[i.min(n)];
            let breaks = i <= n && self.x[i] <= given.breakpoints[breakpoint].x && given.breaks_at(breakpoint);
            if touches && !breaks {
                first.get_or_insert(i);
                continue;
            }
            let edge = touches && given.is_edge(breakpoint);
            if let Some(first) = first.take() {
                builder.add(first..i, beside_edge || edge);
            }
            if edge {
                builder.list.nodes.push(edge_node(given, breakpoint));
            }
            beside_edge = edge;
        }
        normalised(given, builder.list)
    }
}

/// A list under construction.
struct Builder<'a> {
    given: &'a PiecewiseScene,
    samples: &'a Samples,
    guess: &'a Guess,
    list: List,
}

impl Builder<'_> {
    /// Adds a point or a zone for a run of touching samples on one smooth piece of the profile.
    fn add(&mut self, run: Range<usize>, beside_edge: bool) {
        let (given, x) = (self.given, &self.samples.x);
        let n = x.len() - 2;
        let at_support = [run.start == 1 && given.starts_at_zero(0), run.end == n + 1 && given.starts_at_zero(1)];
        if 2 < run.len() {
            let start = if at_support[0] { 0.0 } else { self.lift_off(run.clone().take(4)) };
            let end = if at_support[1] { given.length } else { self.lift_off(run.rev().take(4)) };
            self.list.nodes.extend(zones_between(given, [start, end]));
        } else if at_support[0] {
            self.list.supports[0] = AtSupport::Clamped;
        } else if at_support[1] {
            self.list.supports[1] = AtSupport::Clamped;
        } else if !beside_edge {
            // Otherwise it is the force of the edge that spreads to its neighbours.
            let place = self.point(run);
            self.list.nodes.push(Node::new(Kind::Smooth, place, given.cell_from(place)));
        }
    }

    /// Where the force of a run acts.
    fn point(&self, run: Range<usize>) -> f64 {
        let x = &self.samples.x;
        let (force, moment) =
            run.fold((0.0, 0.0), |(f, m), i| (f + self.guess.force[i - 1], m + self.guess.force[i - 1] * x[i]));
        moment / force
    }

    /// Where the concentrated force at the end of a zone acts, from the end samples of its run: what they have more than
    /// the pressure at the innermost of them.
    fn lift_off(&self, samples: impl Iterator<Item = usize>) -> f64 {
        let x = &self.samples.x;
        let samples: Vec<usize> = samples.collect();
        let width = |i: usize| x[i + 1] - x[i - 1];
        let pressure = samples.last().map_or(0.0, |&i| self.guess.force[i - 1] / width(i));
        let outer = samples.first().map_or(0.0, |&i| x[i]);
        let (mut sum, mut moment) = (0.0, 0.0);
        for &i in &samples {
            let more = (self.guess.force[i - 1] - pressure * width(i)).max(0.0);
            sum += more;
            moment += more * x[i];
        }
        if 0.0 < sum { moment / sum } else { outer }
    }
}
