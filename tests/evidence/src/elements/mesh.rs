//! The beam as cubic elements on springs that push where they are pressed: those of the soil at the Gauss points of each element, those of rigid
//! ground, bearings and supports at nodes, so stiff that they give by nothing that shows. A joint is two nodes at one place with a spring between
//! their slopes. Without tension an element with forces at its nodes is exact.

use super::problem::{ONE_PLACE, Problem};
use super::wide::{Band, Wide};

/// Stiffness of what is rigid, times `EI/l³`: it gives by 1e-15 of what its force would bend the whole beam.
pub(super) const RIGID: f64 = 1e15;

/// What a spring stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Of {
    Ground,
    /// What carries at a support.
    Support,
    /// What holds a slope, or two nodes together.
    Other,
}

/// A spring under a node, or within an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spring {
    /// First freedom that moves it; deflection and slope of a node are freedoms `2i` and `2i + 1`.
    pub(super) first: usize,
    /// How much each of four freedoms moves it.
    shares: [f64; 4],
    pub(super) stiffness: f64,
    gap: f64,
    /// True for a support that holds both ways.
    holds: bool,
    pub(super) pressed: bool,
    of: Of,
}

impl Spring {
    fn at_node(node: usize, gap: f64) -> Self {
        Self {
            first: 2 * node,
            shares: [1.0, 0.0, 0.0, 0.0],
            stiffness: RIGID,
            gap,
            holds: false,
            pressed: true,
            of: Of::Ground,
        }
    }

    /// Whether it is there: it is pressed, or pulls as well.
    pub(super) fn presses(&self) -> bool {
        self.holds || self.pressed
    }

    /// The freedoms that move it, with their shares.
    pub(super) fn moved(&self) -> impl Iterator<Item = (usize, f64)> + use<> {
        let first = self.first;
        self.shares.into_iter().enumerate().filter(|(_, share)| *share != 0.0).map(move |(k, share)| (first + k, share))
    }

    /// How far it is pressed in; negative where the beam is above it.
    pub(super) fn compression(&self, values: &[Wide]) -> f64 {
        let moved = self.moved().fold(Wide::ZERO, |sum, (i, share)| sum + values[i] * share.into());
        (moved - self.gap.into()).near()
    }

    /// With what force it pushes, upwards.
    pub(super) fn force(&self, values: &[Wide]) -> f64 {
        let force = self.stiffness * self.compression(values);
        if self.holds { force } else { force.max(0.0) }
    }
}

/// A mesh with its springs, and the deflections and slopes that were found last.
#[derive(Debug)]
pub(super) struct Mesh<'a> {
    pub(super) problem: &'a Problem,
    pub(super) nodes: Vec<f64>,
    pub(super) values: Vec<Wide>,
    pub(super) springs: Vec<Spring>,
    /// What there is without springs: the stiffness of the elements, and the loads.
    bare: Band,
    pub(super) loads: Vec<Wide>,
}

/// Shape functions of an element of length `h` at a share `t` of it.
pub(crate) fn shapes(h: f64, t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * (1.0 + 2.0 * t), h * t * s * s, t * t * (3.0 - 2.0 * t), -h * t * t * s]
}

/// What is in balance with a load that grows from `a` to `b` along an element.
pub(crate) fn carried(h: f64, [a, b]: [f64; 2]) -> [f64; 4] {
    let part = |x: f64, y: f64, over: f64| (x * a + y * b) / over;
    [h * part(7.0, 3.0, 20.0), h * h * part(3.0, 2.0, 60.0), h * part(3.0, 7.0, 20.0), -h * h * part(2.0, 3.0, 60.0)]
}

/// An element: its length, `EI` over the least one, and the tension in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    pub(super) h: f64,
    pub(super) stiffness: f64,
    pub(super) tension: f64,
}

impl Element {
    /// The stiffness of an element times its freedoms: `∫EI N''N''ᵀ + ∫N N'N'ᵀ`. Between the two nodes of a joint there is none.
    pub(super) fn bent(self, values: &[Wide]) -> [Wide; 4] {
        if self.h <= 0.0 {
            return [Wide::ZERO; 4];
        }
        let h = Wide::from(self.h);
        let rise = (values[2] - values[0]).over(self.h);
        let (left, right) = (values[1] - rise, values[3] - rise);
        let [a, b] = [left + left + right, left + right + right]
            .map(|turned| (turned + turned).over(self.h).times(self.stiffness));
        let shear = (a + b).over(self.h);
        let pull = |parts: [f64; 3], h: Wide| {
            let sum = rise.times(parts[0]) + values[1].times(parts[1]) + values[3].times(parts[2]);
            (sum * h).times(self.tension / 30.0)
        };
        if self.tension == 0.0 {
            return [shear, a, -shear, b];
        }
        let (cross, one) =
            (pull([-36.0, 3.0, 3.0], 1.0.into()), [pull([-3.0, 4.0, -1.0], h), pull([-3.0, -1.0, 4.0], h)]);
        [shear + cross, a + one[0], -shear - cross, b + one[1]]
    }

    /// Its stiffness by columns.
    fn columns(self) -> [[Wide; 4]; 4] {
        if 0.0 < self.h && self.tension == 0.0 {
            let two = Wide::from(2.0 * self.stiffness).over(self.h);
            let six = (two + two + two).over(self.h);
            let twelve = (six + six).over(self.h);
            let four = two + two;
            return [
                [twelve, six, -twelve, six],
                [six, four, -six, two],
                [-twelve, -six, twelve, -six],
                [six, two, -six, four],
            ];
        }
        [0, 1, 2, 3].map(|freedom| {
            let mut unit = [Wide::ZERO; 4];
            unit[freedom] = 1.0.into();
            self.bent(&unit)
        })
    }
}

impl<'a> Mesh<'a> {
    /// Nodes at all places of the problem and between them, no two farther apart than `spacing`, with so many elements at least from one place to
    /// the next.
    pub(super) fn new(problem: &'a Problem, spacing: f64, least: f64) -> Self {
        let mut nodes = vec![0.0];
        for pair in problem.places.windows(2) {
            let parts = ((pair[1] - pair[0]) / spacing).ceil().max(least);
            let inner = (1..parts as u32).map(|k| pair[0] + (pair[1] - pair[0]) * f64::from(k) / parts);
            nodes.extend(inner);
            let joined = problem.joints.iter().any(|joint| (joint[0] - pair[1]).abs() < ONE_PLACE);
            nodes.extend(std::iter::repeat_n(pair[1], if joined { 2 } else { 1 }));
        }
        let values = vec![Wide::ZERO; 2 * nodes.len()];
        let (bare, loads) = (Band::default(), Vec::new());
        let mut mesh = Self { problem, nodes, values, springs: Vec::new(), bare, loads };
        mesh.assemble();
        mesh
    }

    /// The node nearest to a place.
    pub(super) fn node_at(&self, x: f64) -> usize {
        let next = self.nodes.partition_point(|node| *node < x).min(self.nodes.len() - 1);
        let before = next.saturating_sub(1);
        if x - self.nodes[before] < self.nodes[next] - x { before } else { next }
    }

    /// An element.
    pub(super) fn element(&self, i: usize) -> Element {
        let [from, to] = [self.nodes[i], self.nodes[i + 1]];
        let (problem, h) = (self.problem, to - from);
        Element { h, stiffness: problem.bending(from, to), tension: problem.tension }
    }

    /// Whatever the nodes alone decide.
    pub(super) fn assemble(&mut self) {
        self.make_springs();
        self.loads = self.nodal_loads();
        self.bare = self.bent();
    }

    fn make_springs(&mut self) {
        let mut springs = Vec::new();
        for support in &self.problem.supports {
            let (holds, stiffness) = (!support.pushes_only, support.stiffness.unwrap_or(RIGID));
            let node = self.node_at(support.at);
            let spring = Spring { holds, stiffness, of: Of::Support, ..Spring::at_node(node, support.level) };
            springs.push(spring);
            if let Some((slope, stiffness)) = support.turning {
                let stiffness = stiffness.unwrap_or(RIGID);
                let shares = [0.0, 1.0, 0.0, 0.0];
                springs.push(Spring { shares, gap: slope, holds: true, stiffness, of: Of::Other, ..spring });
            }
        }
        // Of a support that does not give and rigid ground at one place only the sum is known: the support takes it.
        let takes = |spring: &&Spring| spring.of == Of::Support && spring.stiffness == RIGID;
        let mut taken: Vec<usize> = springs.iter().filter(takes).map(|spring| spring.first / 2).collect();
        for &[at, stiffness] in &self.problem.joints {
            let node = self.node_at(at);
            let both =
                Spring { shares: [1.0, 0.0, -1.0, 0.0], holds: true, of: Of::Other, ..Spring::at_node(node, 0.0) };
            springs.extend([both, Spring { shares: [0.0, 1.0, 0.0, -1.0], stiffness, ..both }]);
            taken.push(node + 1);
        }
        if self.problem.is_on_soil() {
            (0..self.nodes.len() - 1).for_each(|i| springs.extend(self.springs_of_soil(i)));
        } else {
            let grounded = self.nodes.iter().enumerate().map(|(i, x)| Spring::at_node(i, self.problem.gap(*x)));
            springs.extend(grounded.filter(|spring| spring.gap.is_finite() && !taken.contains(&(spring.first / 2))));
        }
        self.springs = springs;
    }

    /// At Gauss points of degree 7, on which a cubic times a cubic is exact.
    fn springs_of_soil(&self, i: usize) -> [Spring; 4] {
        const POINTS: [f64; 2] = [0.861_136_311_594_052_6, 0.339_981_043_584_856_3];
        const WEIGHTS: [f64; 2] = [0.347_854_845_137_453_9, 0.652_145_154_862_546_1];
        let ([from, to], h) = ([self.nodes[i], self.nodes[i + 1]], self.nodes[i + 1] - self.nodes[i]);
        let signed =
            [(-POINTS[0], WEIGHTS[0]), (-POINTS[1], WEIGHTS[1]), (POINTS[1], WEIGHTS[1]), (POINTS[0], WEIGHTS[0])];
        signed.map(|(point, weight)| {
            let t = 0.5 * (1.0 + point);
            let gap = self.problem.gap(from + t * h);
            let stiffness = 0.5 * weight * h * self.problem.soil(from, to);
            Spring { shares: shapes(h, t), stiffness, ..Spring::at_node(i, gap) }
        })
    }

    /// Loads of the nodes: those of the elements and the point loads.
    fn nodal_loads(&self) -> Vec<Wide> {
        let mut loads = vec![Wide::ZERO; self.values.len()];
        for (i, pair) in self.nodes.windows(2).enumerate() {
            let parts = carried(pair[1] - pair[0], self.problem.load(pair[0], pair[1]));
            parts.into_iter().enumerate().for_each(|(k, part)| loads[2 * i + k] = loads[2 * i + k] + part.into());
        }
        for (at, force) in self.problem.forces() {
            let node = 2 * self.node_at(at);
            loads[node] = loads[node] + force.into();
        }
        for (at, moment) in self.problem.couples() {
            let slope = 2 * self.node_at(at) + 1;
            loads[slope] = loads[slope] + moment.into();
        }
        loads
    }

    /// The stiffness of the elements.
    fn bent(&self) -> Band {
        /// So little holds every node that a free beam has an answer on the way: 1e-18 of its bending stiffness.
        const LOOSE: f64 = 1e-18;
        let mut band = Band::zeros(self.values.len());
        for i in 0..self.nodes.len() - 1 {
            let element = self.element(i);
            let columns = element.columns();
            (0..4).for_each(|c| (0..=c).for_each(|r| band.add(2 * i + r, 2 * i + c, columns[c][r])));
        }
        (0..self.values.len()).for_each(|i| band.add(i, i, LOOSE.into()));
        band
    }

    /// Deflections and slopes if the springs that are pressed hold, none of them stiffer than so.
    fn held(&self, most: f64) -> Vec<Wide> {
        let (mut band, mut right) = (self.bare.clone(), self.loads.clone());
        for spring in self.springs.iter().filter(|spring| spring.presses()) {
            let stiffness = Wide::from(spring.stiffness.min(most));
            for (i, a) in spring.moved() {
                let part = stiffness.times(a);
                right[i] = right[i] + part.times(spring.gap);
                spring.moved().filter(|(j, _)| i <= *j).for_each(|(j, b)| band.add(i, j, part.times(b)));
            }
        }
        band.solved(right)
    }

    /// Presses and lets go of springs until none changes. True if it came to that.
    pub(super) fn settle(&mut self, most: f64) -> bool {
        const STEPS: u32 = 100;
        let mut from = self.compressions(&self.values);
        for _ in 0..STEPS {
            let found = self.held(most);
            let next = self.compressions(&found);
            let size = self.force_size(most, &next);
            let changed = |(spring, s): (&Spring, &f64)| {
                !spring.holds && spring.pressed != (0.0 < *s) && size * 1e-13 < spring.stiffness.min(most) * s.abs()
            };
            if !self.springs.iter().zip(&next).any(changed) {
                self.values = found;
                return true;
            }
            let step = self.step(&found, [&from, &next], most);
            for (value, found) in self.values.iter_mut().zip(found) {
                *value = *value + (found - *value).times(step);
            }
            from = self.press();
        }
        false
    }

    /// How far each spring is pressed in.
    fn compressions(&self, values: &[Wide]) -> Vec<f64> {
        self.springs.iter().map(|spring| spring.compression(values)).collect()
    }

    /// Those springs press that the beam presses in; by how much.
    pub(super) fn press(&mut self) -> Vec<f64> {
        let compressions = self.compressions(&self.values);
        self.springs.iter_mut().zip(&compressions).for_each(|(spring, by)| spring.pressed = 0.0 < *by);
        compressions
    }

    /// The springs of soil or rigid ground.
    pub(super) fn soil(&self) -> impl Iterator<Item = &Spring> {
        self.springs.iter().filter(|spring| spring.of == Of::Ground)
    }

    /// Those of the soil within an element.
    pub(super) fn soil_of(&self, element: usize) -> impl Iterator<Item = &Spring> {
        let all = if self.problem.is_on_soil() {
            &self.springs[self.springs.len() - 4 * (self.nodes.len() - 1)..]
        } else {
            &[][..]
        };
        all.iter().skip(4 * element).take(4)
    }

    /// The springs that stand for supports, but for those of slopes.
    pub(super) fn supports(&self) -> impl Iterator<Item = &Spring> {
        self.springs.iter().filter(|spring| spring.of == Of::Support)
    }

    /// The largest force of a spring.
    fn force_size(&self, most: f64, compressions: &[f64]) -> f64 {
        let forces = self.springs.iter().zip(compressions).filter(|(spring, _)| spring.presses());
        forces.fold(0.0, |size: f64, (spring, s)| size.max(spring.stiffness.min(most) * s.abs()))
    }

    /// How far to go from the values to those that were found: to the least energy, which is convex, or at most all of the way.
    fn step(&self, found: &[Wide], [from, next]: [&[f64]; 2], most: f64) -> f64 {
        let change: Vec<Wide> = found.iter().zip(&self.values).map(|(a, b)| *a - *b).collect();
        let bend: f64 = (0..self.nodes.len() - 1)
            .map(|i| {
                let d = &change[2 * i..2 * i + 4];
                self.element(i).bent(d).iter().zip(d).fold(Wide::ZERO, |sum, (a, b)| sum + *a * *b).near()
            })
            .sum();
        // The derivative of the energy, from that at the end without what changes: the values found solve the problem of springs that were
        // pressed. It is a line, `a + b t`, but for springs that the beam leaves or meets on the way.
        let ([mut a, mut b], mut turning) = ([-bend, bend], Vec::new());
        for ((spring, from), to) in self.springs.iter().zip(from).zip(next) {
            let (moved, k) = (to - from, spring.stiffness.min(most));
            let stays = 0.0 < *from && 0.0 < *to;
            if spring.holds || spring.pressed && stays {
                (a, b) = (a - k * moved * moved, b + k * moved * moved);
                continue;
            }
            a -= if spring.pressed { k * moved * to } else { 0.0 };
            if stays {
                (a, b) = (a + k * moved * from, b + k * moved * moved);
            } else if 0.0 < from.max(*to) {
                turning.push([*from, moved, k]);
            }
        }
        let slope = |t: f64| {
            let sum = |[from, moved, k]: &[f64; 3]| k * moved * (from + t * moved).max(0.0);
            a + b * t + turning.iter().map(sum).sum::<f64>()
        };
        if slope(1.0) <= 0.0 {
            return 1.0;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *(if slope(middle) < 0.0 { &mut low } else { &mut high }) = middle;
        }
        high
    }
}
