//! The first contact list: samples of the profile, the chain above them, and the points and zones where the chain touches.
//!
//! Samples are few where nothing touches. They are refined where the chain lifts off and where a list failed its check.

mod turned;

use std::ops::Range;

use super::chain::{Chain, ChainSample, Guess};
use super::list::{List, Node};
use super::normal::{edge_node, normal_form};
use super::piecewise::PiecewiseScene;
use super::pull::zones_between;

/// Sampled positions of the profile, from end to end.
#[derive(Debug, Clone)]
pub(super) struct Samples {
    /// Positions.
    x: Vec<f64>,
    /// The cell to the right of each sample.
    cell: Vec<usize>,
    /// Whether each link is far from contact; link `i` starts at sample `i`.
    far: Vec<bool>,
}

/// Number of cells above which a profile is first sampled at the shallowest positions of as many blocks: 38,000 samples of a chain take
/// 0.11 s.
pub(super) const LONG: usize = 4000;
/// Number of parts of a link near a lift-off position. With half of them no fewer of 700 random and hostile scenes are certified.
const PARTS: u32 = 4;
/// Maximum number of cells into which coarse links are divided where contacts are few; above it the shallowest positions of blocks are
/// used again. *Tuned* on a rough foundation of 10⁶ points with hundreds of contacts, which are at such positions.
const MOST_CELLS: usize = 50_000;
/// Contacts are few if at most one in this many samples touches, and at most one in this many of those has a touching neighbour.
/// *Tuned* on the same, which touches at one sample in fourteen, and on smooth foundations, where neighbours touch under any load: many
/// contacts are close together there, and the list of so coarse a guess leads nowhere.
const FEW: usize = 4;
/// Number of parts of each cell of a link of several cells: a beam may touch at breaks and between them.
const PARTS_OF_CELL: u32 = 3;

impl Samples {
    /// All breakpoints, with cells divided into parts no longer than 1/`links` of the beam. For a long survey, the shallowest
    /// breakpoint of each block and the positions where the load changes.
    pub(super) fn first(given: &PiecewiseScene, links: u32) -> Self {
        let cells = given.cells.len();
        let mut samples = Self::with_room_for(cells.min(LONG) + links as usize);
        if !given.founded {
            // Links are beams from breakpoint to breakpoint: there is nothing to touch between them.
            (0..cells).for_each(|i| samples.push(given.cells[i].lo, i, true));
        } else if cells <= LONG {
            let aim = given.length / f64::from(links);
            for (i, cell) in given.cells.iter().enumerate() {
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most `links`")]
                let parts = ((cell.hi - cell.lo) / aim).ceil() as u32;
                samples.cut(i, [cell.lo, cell.hi], parts, false);
            }
        } else {
            samples.push(0.0, 0, false);
            samples.take_shallowest(given, 1..cells, cells.div_ceil(LONG));
        }
        samples.end(given);
        samples
    }

    /// More samples where the chain lifts off, and near `places`.
    pub(super) fn refined(&self, given: &PiecewiseScene, touches: &[bool], places: &[f64]) -> Self {
        let few = places.is_empty() && are_few(touches);
        let n = self.x.len();
        let touching = |i: usize| touches[i];
        let mut near: Vec<bool> = (0..n).map(touching).collect();
        for &x in places {
            let i = self.x.partition_point(|&other| other <= x).saturating_sub(1);
            near[i] = true;
            near[(i + 1).min(n - 1)] = true;
        }
        let mut refined = Self::with_room_for(2 * n);
        let coarse = |i: usize| given.cells[self.cell[i]].hi < self.x[i + 1];
        // Next to a link of many cells the contact position is known only to one or two blocks.
        let reach = |i: usize| if coarse(i) { 2 } else { 0 };
        let is_close = |i: usize| (i.saturating_sub(reach(i))..=(i + 1 + reach(i)).min(n - 1)).any(|j| near[j]);
        let cells = |i: usize| self.cell[i]..given.cell_to(self.x[i + 1]) + 1;
        let block = (0..n - 1)
            .filter(|&i| coarse(i) && is_close(i))
            .map(|i| cells(i).len())
            .sum::<usize>()
            .div_ceil(if few { MOST_CELLS } else { usize::MAX });
        for i in 0..n - 1 {
            let close = is_close(i);
            let around = [i.saturating_sub(1), (i + 2).min(n - 1)];
            let interior = (around[0]..=around[1]).all(touching)
                && !coarse(i)
                && given.pulling_between(self.x[around[0]], self.x[around[1]]).next().is_none()
                && [i, i + 1]
                    .iter()
                    .all(|&j| given.cells[self.cell[j]].lo < self.x[j] || !given.breaks_at(self.cell[j]));
            let parts = match (close, interior) {
                (true, false) => PARTS,
                _ => 1,
            };
            if coarse(i) && close && 1 < block {
                refined.push(self.x[i], self.cell[i], false);
                refined.take_shallowest(given, cells(i).start + 1..cells(i).end, block);
            } else if coarse(i) && close {
                for cell in cells(i) {
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

    fn with_room_for(count: usize) -> Self {
        Self { x: Vec::with_capacity(count), cell: Vec::with_capacity(count), far: Vec::with_capacity(count) }
    }

    fn push(&mut self, x: f64, cell: usize, far: bool) {
        self.x.push(x);
        self.cell.push(cell);
        self.far.push(far);
    }

    /// Adds the shallowest breakpoint of each block of `block` breakpoints, and those with a change of load or beam, or with a support.
    fn take_shallowest(&mut self, given: &PiecewiseScene, breakpoints: Range<usize>, block: usize) {
        let end = breakpoints.end;
        for first in breakpoints.step_by(block) {
            let breakpoints = first..end.min(first + block);
            let depth = |&i: &usize| given.breakpoints[i].depth;
            let shallowest = breakpoints.clone().min_by(|i, j| depth(i).total_cmp(&depth(j)));
            for i in breakpoints.filter(|&i| Some(i) == shallowest || given.load_changes_at(i) || given.changes_at(i)) {
                self.push(given.breakpoints[i].x, i, false);
            }
        }
    }

    /// Adds the start of a link in `cell` and the positions that divide it into equal parts.
    fn cut(&mut self, cell: usize, [lo, hi]: [f64; 2], parts: u32, far: bool) {
        self.push(lo, cell, far);
        for part in 1..parts {
            let x = lo + (hi - lo) * (f64::from(part) / f64::from(parts));
            if self.x.last().is_some_and(|&last| last < x) && x < hi {
                self.push(x, cell, far);
            }
        }
    }

    /// Adds the right end.
    fn end(&mut self, given: &PiecewiseScene) {
        self.x.push(given.length);
        self.cell.push(given.cells.len() - 1);
        if self.x.len() < 3 && given.founded {
            self.x.insert(1, 0.5 * given.length);
            self.cell.insert(1, 0);
            self.far.push(false);
        }
    }

    /// The breakpoint at sample `i`, if there is one.
    fn breakpoint(&self, given: &PiecewiseScene, i: usize) -> Option<usize> {
        if i + 1 == self.x.len() {
            return Some(given.cells.len());
        }
        let breakpoint = self.cell[i];
        (self.x[i] <= given.breakpoints[breakpoint].x).then_some(breakpoint)
    }

    /// The support at sample `i`, if there is one.
    fn support(&self, given: &PiecewiseScene, i: usize) -> Option<usize> {
        given.support_at(self.breakpoint(given, i)?)
    }

    /// The number of samples.
    pub(super) fn count(&self) -> usize {
        self.x.len()
    }

    /// The touching samples and their forces.
    pub(super) fn chain(&self, given: &PiecewiseScene) -> Guess {
        let mut samples: Vec<ChainSample> = (0..self.x.len()).map(|i| self.chain_sample(given, i)).collect();
        for i in 0..self.far.len() {
            let (a, b) = (self.x[i], self.x[i + 1]);
            let length = b - a;
            let last = given.cell_to(b).max(self.cell[i]);
            for cell in self.cell[i]..=last {
                let c = &given.cells[cell];
                let (lo, hi) = (c.lo.max(a), c.hi.min(b));
                let (start, end, width) = (given.load(cell, lo), given.load(cell, hi), hi - lo);
                // Resultant and first moment of a trapezium.
                let force = 0.5 * width * (start + end);
                let lever = width * width * (start + 2.0 * end) / 6.0 + force * (lo - a);
                samples[i].load += force - lever / length;
                samples[i + 1].load += lever / length;
                if a < c.lo {
                    let [couple, force] = given.breakpoints[cell].acts.jumps();
                    samples[i].load += (force * (b - c.lo) + couple) / length;
                    samples[i + 1].load += (force * (c.lo - a) - couple) / length;
                }
            }
            if a <= given.cells[self.cell[i]].lo {
                samples[i].load += given.breakpoints[self.cell[i]].acts.force();
                samples[i].bend += given.breakpoints[self.cell[i]].kink;
            }
            let [start, end] = given.rotations_to_chord([a, b], [self.cell[i], last], !self.far[i]);
            let mut add = |start: f64, end: f64| {
                samples[i].bend += start;
                samples[i + 1].bend += end;
                samples[i].sides[1] += start;
                samples[i + 1].sides[0] += end;
            };
            add(start, end);
            if self.far[i] {
                let (start, end) = (given.load(self.cell[i], a), given.load(last, b));
                let unit = length * length * length / 360.0 / given.cells[self.cell[i]].stiffness;
                add(unit * (8.0 * start + 7.0 * end), unit * (7.0 * start + 8.0 * end));
            }
        }
        if let (Some(sample), Some(end)) = (samples.last_mut(), given.breakpoints.last()) {
            sample.load += end.acts.force();
        }
        self.turn(given, &mut samples);
        self.on_springs(given, &mut samples);
        self.pull(given, &mut samples);
        self.solve(given, &mut samples)
    }

    /// Sample `i` of the chain, before bend and load are known.
    fn chain_sample(&self, given: &PiecewiseScene, i: usize) -> ChainSample {
        let held = self.support(given, i).map(|support| given.supports[support].clearance[1]);
        let open =
            !given.founded && held.is_none() && !self.breakpoint(given, i).is_some_and(|at| given.is_bearing(at));
        ChainSample {
            x: self.x[i],
            held,
            open,
            beam: self.far.get(i).is_some_and(|&far| far),
            flexibility: 1.0 / given.cells[self.cell[i]].stiffness,
            joint: self.breakpoint(given, i).map_or(0.0, |at| given.breakpoints[at].joint),
            ..ChainSample::default()
        }
    }

    /// Solves the chains between built-in supports one by one: they do not influence each other.
    fn solve(&self, given: &PiecewiseScene, samples: &mut [ChainSample]) -> Guess {
        let last = samples.len() - 1;
        let built_in = |i: usize| self.support(given, i).and_then(|support| given.supports[support].slope);
        let mut guess = Guess { touches: Vec::with_capacity(last + 1), force: Vec::with_capacity(last + 1) };
        let mut from = 0;
        for to in (1..=last).filter(|&i| i == last || built_in(i).is_some()) {
            let slopes = [from, to].map(built_in);
            // A support between two chains uses the bend of the chain that is solved.
            if let Some(slope) = slopes[0] {
                let x = self.x[from];
                samples[from].bend = samples[from].sides[1] + (given.derivative(given.cell_from(x), x, 1) - slope);
            }
            if let Some(slope) = slopes[1] {
                let x = self.x[to];
                samples[to].bend = samples[to].sides[0] - (given.derivative(given.cell_to(x), x, 1) - slope);
            }
            let chain = Chain {
                samples: &samples[from..=to],
                built_in: slopes.map(|slope| slope.is_some()),
                tension: given.tension,
            };
            let Guess { touches, force } = chain.solve();
            // Both chains end at the support between them, and neither touches there.
            guess.touches.truncate(from);
            guess.force.truncate(from);
            guess.touches.extend(touches);
            guess.force.extend(force);
            from = to;
        }
        guess
    }

    /// The contact list that the chain suggests.
    pub(super) fn list(&self, given: &PiecewiseScene, guess: &Guess) -> List {
        let mut builder = Builder { given, samples: self, guess, nodes: Vec::new(), clamped: false };
        let last = self.x.len() - 1;
        // A run of touching samples is split at every break of the profile.
        let mut first = None;
        for i in 0..=last + 1 {
            let touches = i <= last && guess.touches[i];
            let breakpoint = if i <= last { self.breakpoint(given, i) } else { None };
            let breaks = |b: usize| given.breaks_at(b) || given.is_free_end(b) && !given.is_flat_end(b);
            // A single touching joint is an edge; within a contact on a level foundation it has no effect.
            let beside = |j: Option<usize>| j.and_then(|j| guess.touches.get(j)).is_some_and(|touches| *touches);
            let alone = !(beside(i.checked_sub(1)) && beside(Some(i + 1)));
            let breaks = |b: usize| breaks(b) || given.breakpoints[b].is_jointed() && alone;
            let at_break = breakpoint.filter(|&breakpoint| breaks(breakpoint));
            if touches && at_break.is_none() {
                first.get_or_insert(i);
                continue;
            }
            let edge = at_break.filter(|&breakpoint| touches && given.is_edge(breakpoint));
            if let Some(first) = first.take() {
                builder.add(first..i);
            }
            if let Some(breakpoint) = breakpoint.filter(|&breakpoint| given.support_at(breakpoint).is_some()) {
                builder.add_support(breakpoint);
            } else if let Some(breakpoint) = edge {
                builder.nodes.push(edge_node(given, breakpoint));
            }
        }
        normal_form(given, &builder.nodes)
    }
}

/// Whether only isolated samples touch, with few touching neighbours.
fn are_few(touches: &[bool]) -> bool {
    let count = touches.iter().filter(|&&touches| touches).count();
    let beside = touches.windows(2).filter(|pair| pair[0] && pair[1]).count();
    FEW * count < touches.len() && FEW * beside < count
}

/// A list under construction.
struct Builder<'a> {
    given: &'a PiecewiseScene,
    samples: &'a Samples,
    guess: &'a Guess,
    nodes: Vec<Node>,
    /// Whether the foundation fixes the slope at the next support.
    clamped: bool,
}

impl Builder<'_> {
    fn add_support(&mut self, breakpoint: usize) {
        let mut node = Node::at(self.given, breakpoint);
        if std::mem::take(&mut self.clamped) {
            node.hold(true);
        }
        self.nodes.push(node);
    }

    /// Adds a point or a zone for a run of touching samples on one smooth piece of the profile.
    fn add(&mut self, run: Range<usize>) {
        let (given, x) = (self.given, &self.samples.x);
        let last = x.len() - 1;
        let tangent = |i: Option<usize>, side: usize| {
            let support = i.filter(|&i| i <= last).and_then(|i| self.samples.support(given, i));
            support.filter(|&support| given.supports[support].tangent[side])
        };
        let (left, right) = (tangent(run.start.checked_sub(1), 1), tangent(Some(run.end), 0));
        let at_tip = [run.start == 0, run.end == last + 1];
        if 2 < run.len() {
            let start = match run.start.checked_sub(1) {
                Some(support) if left.is_some() => x[support],
                None => 0.0,
                _ => self.lift_off(run.clone().take(4)),
            };
            let end = match x.get(run.end) {
                Some(&support) if right.is_some() => support,
                None => given.length,
                _ => self.lift_off(run.rev().take(4)),
            };
            self.nodes.extend(zones_between(given, [start, end]));
        } else if left.is_some() {
            if let Some(support) = self.nodes.last_mut().filter(|last| last.support(given).is_some()) {
                support.hold(false);
            }
        } else if right.is_some() {
            self.clamped = true;
        } else if at_tip[0] {
            self.nodes.push(edge_node(given, 0));
        } else if at_tip[1] {
            self.nodes.push(edge_node(given, given.cells.len()));
        } else {
            let place = self.point(run);
            self.nodes.push(Node::touch(place, given.cell_from(place)));
        }
    }

    /// The centre of the forces of a run.
    fn point(&self, run: Range<usize>) -> f64 {
        let x = &self.samples.x;
        let (force, moment) =
            run.fold((0.0, 0.0), |(f, m), i| (f + self.guess.force[i], m + self.guess.force[i] * x[i]));
        moment / force
    }

    /// The position of the concentrated force at the end of a zone, from the outermost samples of its run: the centre of their forces
    /// in excess of the pressure at the innermost one.
    fn lift_off(&self, samples: impl Iterator<Item = usize>) -> f64 {
        let x = &self.samples.x;
        let samples: Vec<usize> = samples.collect();
        let width = |i: usize| x[(i + 1).min(x.len() - 1)] - x[i.saturating_sub(1)];
        let pressure = samples.last().map_or(0.0, |&i| self.guess.force[i] / width(i));
        let outer = samples.first().map_or(0.0, |&i| x[i]);
        let (mut sum, mut moment) = (0.0, 0.0);
        for &i in &samples {
            let more = (self.guess.force[i] - pressure * width(i)).max(0.0);
            sum += more;
            moment += more * x[i];
        }
        if 0.0 < sum { moment / sum } else { outer }
    }
}
