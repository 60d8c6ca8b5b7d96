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
        let rise = (values[2] - values[0]) / h;
        let (left, right) = (values[1] - rise, values[3] - rise);
        let [a, b] =
            [left + left + right, left + right + right].map(|turned| (turned + turned) / h * self.stiffness.into());
        let shear = (a + b) / h;
        let pull = |parts: [f64; 3], h: Wide| {
            let sum = rise * parts[0].into() + values[1] * parts[1].into() + values[3] * parts[2].into();
            sum * h * (self.tension / 30.0).into()
        };
        let (cross, one) =
            (pull([-36.0, 3.0, 3.0], 1.0.into()), [pull([-3.0, 4.0, -1.0], h), pull([-3.0, -1.0, 4.0], h)]);
        [shear + cross, a + one[0], -shear - cross, b + one[1]]
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
        let mut mesh = Self { problem, nodes, values, springs: Vec::new() };
        mesh.make_springs();
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

    pub(super) fn make_springs(&mut self) {
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
    pub(super) fn loads(&self) -> Vec<Wide> {
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

    /// Deflections and slopes if the springs that are pressed hold, none of them stiffer than so.
    fn held(&self, most: f64) -> Vec<Wide> {
        /// So little holds every node that a free beam has an answer on the way: 1e-18 of its bending stiffness.
        const LOOSE: f64 = 1e-18;
        let mut band = Band::zeros(self.values.len());
        let mut right = self.loads();
        for i in 0..self.nodes.len() - 1 {
            let element = self.element(i);
            for c in 0..4 {
                let mut unit = [Wide::ZERO; 4];
                unit[c] = 1.0.into();
                let column = element.bent(&unit);
                (0..=c).for_each(|r| band.add(2 * i + r, 2 * i + c, column[r]));
            }
        }
        (0..right.len()).for_each(|i| band.add(i, i, LOOSE.into()));
        for spring in self.springs.iter().filter(|spring| spring.presses()) {
            let stiffness = Wide::from(spring.stiffness.min(most));
            for (i, a) in spring.moved() {
                let part = stiffness * a.into();
                right[i] = right[i] + part * spring.gap.into();
                spring.moved().filter(|(j, _)| i <= *j).for_each(|(j, b)| band.add(i, j, part * b.into()));
            }
        }
        band.solved(right)
    }

    /// Presses and lets go of springs until none changes. True if it came to that.
    pub(super) fn settle(&mut self, most: f64) -> bool {
        const STEPS: u32 = 100;
        for _ in 0..STEPS {
            let found = self.held(most);
            let next: Vec<f64> = self.springs.iter().map(|spring| spring.compression(&found)).collect();
            let size = self.force_size(most, &next);
            let changed = |(spring, s): (&Spring, &f64)| {
                !spring.holds && spring.pressed != (0.0 < *s) && size * 1e-13 < spring.stiffness.min(most) * s.abs()
            };
            let settled = !self.springs.iter().zip(&next).any(changed);
            let step = if settled { 1.0 } else { self.step(&found, &next, most) };
            for (value, found) in self.values.iter_mut().zip(found) {
                *value = *value + (found - *value) * step.into();
            }
            if settled {
                return true;
            }
            self.press();
        }
        false
    }

    /// Those springs press that the beam presses in.
    pub(super) fn press(&mut self) {
        for spring in &mut self.springs {
            spring.pressed = 0.0 < spring.compression(&self.values);
        }
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
    fn step(&self, found: &[Wide], next: &[f64], most: f64) -> f64 {
        let change: Vec<Wide> = found.iter().zip(&self.values).map(|(a, b)| *a - *b).collect();
        let bend: f64 = self
            .nodes
            .windows(2)
            .enumerate()
            .map(|(i, _)| {
                let d = &change[2 * i..2 * i + 4];
                self.element(i).bent(d).iter().zip(d).fold(Wide::ZERO, |sum, (a, b)| sum + *a * *b).near()
            })
            .sum();
        let springs = self.springs.iter().zip(next).filter(|(spring, _)| !spring.holds);
        let springs: Vec<[f64; 4]> = springs
            .map(|(spring, to)| {
                let from = spring.compression(&self.values);
                [from, *to, spring.stiffness.min(most), f64::from(u8::from(spring.pressed))]
            })
            .collect();
        let held: f64 = self
            .springs
            .iter()
            .zip(next)
            .filter(|(spring, _)| spring.holds)
            .map(|(spring, to)| {
                let moved = to - spring.compression(&self.values);
                spring.stiffness.min(most) * moved * moved
            })
            .sum();
        // The derivative of the energy, from that at the end without what changes: the values found solve the problem of springs that were pressed.
        let slope = |t: f64| {
            let sum = |[from, to, k, pressed]: &[f64; 4]| {
                let at = from + t * (to - from);
                k * (to - from) * (at.max(0.0) - pressed * to)
            };
            springs.iter().map(sum).sum::<f64>() - (1.0 - t) * (bend + held)
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
