//! What a settled mesh says: where it has to be finer, and its forces, energy and moments.

use super::mesh::{Mesh, RIGID, carried, shapes};
use super::reference::Numbers;
use super::wide::Wide;

impl Mesh<'_> {
    /// Whether ground and supports hold the beam. One that they do not hold is held by next to nothing, and far away.
    pub(super) fn is_held(&self) -> bool {
        const FAR: f64 = 1e9;
        let loads = self.loads.iter().fold(0.0, |most: f64, load| most.max(load.near().abs()));
        let gaps = self.nodes.iter().map(|x| self.problem.gap(*x)).filter(|gap| gap.is_finite());
        let levels = self.problem.supports.iter().map(|support| support.level);
        let size = gaps.chain(levels).fold(loads, |most: f64, gap| most.max(gap.abs()));
        self.values.iter().all(|value| value.near().abs() < FAR * size)
    }

    /// Values of another mesh of the same problem as a start.
    pub(super) fn start_from(&mut self, other: &Self) {
        for (i, x) in self.nodes.iter().enumerate() {
            let element = other.nodes.partition_point(|node| node <= x).clamp(1, other.nodes.len() - 1) - 1;
            let (from, to) = (other.nodes[element], other.nodes[element + 1]);
            let [v, slope] = between(to - from, (x - from) / (to - from), &other.values[2 * element..]);
            (self.values[2 * i], self.values[2 * i + 1]) = (v, slope);
        }
        self.press();
    }

    /// Cuts elements at that share where contact begins or ends, or where the beam is below rigid ground between its nodes by more than
    /// so much of the range of its deflections. False if there is none.
    pub(super) fn refine(&mut self, share: f64, below: f64) -> bool {
        let marks = if self.problem.is_on_soil() { self.marks_on_soil() } else { self.marks_on_rigid_ground(below) };
        if !marks.contains(&true) {
            return false;
        }
        let (nodes, values) = (std::mem::take(&mut self.nodes), std::mem::take(&mut self.values));
        for (i, x) in nodes.iter().enumerate() {
            self.nodes.push(*x);
            self.values.extend_from_slice(&values[2 * i..2 * i + 2]);
            if marks.get(i) == Some(&true) {
                let h = nodes[i + 1] - x;
                self.nodes.push(x + share * h);
                self.values.extend(between(h, share, &values[2 * i..]));
            }
        }
        self.assemble();
        self.press();
        true
    }

    /// Elements with springs of the soil that press beside such that do not.
    fn marks_on_soil(&self) -> Vec<bool> {
        /// So far from an end of an element, by its length, the ground is that of the element, and not what is beyond a step.
        const INSIDE: f64 = 1e-3;
        let of_element = |i: usize| {
            let (x, h) = (self.nodes[i], self.nodes[i + 1] - self.nodes[i]);
            let is_below =
                |t: f64| 0.0 < (sunk(h, t, &self.values[2 * i..]) - self.problem.gap(x + t * h).into()).near();
            let inside = self.soil_of(i).map(|spring| spring.pressed);
            [is_below(INSIDE), is_below(1.0 - INSIDE)].into_iter().chain(inside).collect::<Vec<bool>>()
        };
        let is_element = |i: usize| 0.0 < self.problem.soil(self.nodes[i], self.nodes[i + 1]) * self.element(i).h;
        let mut elements: Vec<Vec<bool>> = Vec::new();
        for i in 0..self.nodes.len() - 1 {
            // Between the two nodes of a joint, and over no soil, there is nothing to cut.
            let before = elements.last().is_some_and(|states: &Vec<bool>| states[1]);
            elements.push(if is_element(i) { of_element(i) } else { vec![before; 2] });
        }
        let mixed = |i: usize| {
            let of = |k: Option<usize>, at: usize| k.and_then(|k| elements.get(k)).map(|states| states[at]);
            let [left, right] = [elements[i][0], elements[i][1]];
            let beside =
                [of(i.checked_sub(1), 1).unwrap_or(left) != left, of(Some(i + 1), 0).unwrap_or(right) != right];
            beside.contains(&true) || elements[i].iter().any(|state| *state != left)
        };
        (0..elements.len()).map(|i| is_element(i) && mixed(i)).collect()
    }

    /// Elements that are below the ground between their nodes. The answer with forces at nodes alone has no more energy than the true one, and is the
    /// true one if no element is below the ground.
    fn marks_on_rigid_ground(&self, below: f64) -> Vec<bool> {
        /// Of `F l³/EI`.
        const FLAT: f64 = 1e-6;
        /// Of the deflection: far more than rounding.
        const LEVEL: f64 = 1e-9;
        /// Shares of an element: a beam that touches beside a node is below the ground between the two, and nowhere else.
        const NEAR_NODES: [f64; 4] = [1e-4, 1e-3, 1e-2, 0.05];
        let count = self.nodes.len();
        let deflections = self.values.iter().step_by(2).map(|v| v.near());
        let [least, most] = deflections.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
        // A beam that lies on flat ground all along has no range but rounding: then what its load would do counts.
        let load = self.loads.iter().step_by(2).fold(0.0, |sum, load| sum + load.near().abs());
        let is_level = most - least <= LEVEL * most.abs().max(least.abs());
        let size = if is_level { FLAT * load } else { most - least };
        let pressed = self.pressed();
        let mark = |i: usize| {
            let (x, h) = (self.nodes[i], self.nodes[i + 1] - self.nodes[i]);
            let [a, b] = self.problem.load(x, x + h);
            // What is below the ground far inside a zone does not show at its ends.
            let inside = 0 < i && pressed[i - 1..(i + 3).min(count)].iter().all(|pressed| *pressed);
            let below = if inside { 1e3 * below } else { below };
            let is_below = |t: f64| {
                let hangs =
                    h * h * h * h * (a + b) / (48.0 * self.element(i).stiffness) * t * t * (1.0 - t) * (1.0 - t);
                let v = sunk(h, t, &self.values[2 * i..]) - self.problem.gap(x + t * h).into();
                below * size < v.near() + hangs
            };
            0.0 < h && NEAR_NODES.into_iter().chain([0.25, 0.5]).any(|t| is_below(t) || is_below(1.0 - t))
        };
        (0..count - 1).map(mark).collect()
    }

    /// Which nodes rigid ground presses, and a false one behind the last.
    fn pressed(&self) -> Vec<bool> {
        let mut pressed = vec![false; self.nodes.len() + 1];
        self.soil().for_each(|spring| pressed[spring.first / 2] = spring.pressed);
        pressed
    }

    /// Forces, energy, deflections and moments, in the units of the case.
    pub(super) fn numbers(&self) -> Numbers {
        let (force, length) = (1.0 / self.problem.unit(), self.problem.length());
        let at_places: Vec<usize> = self.problem.places.iter().map(|place| self.node_at(*place)).collect();
        let ends: Vec<[f64; 4]> = (0..self.nodes.len() - 1).map(|i| self.end_forces(i)).collect();
        // A load between the nodes of a zone bends each element, which the true beam does not do there; and a force between nodes is shared by both.
        let pressed = if self.problem.is_on_soil() { vec![false; self.nodes.len() + 1] } else { self.pressed() };
        let beside = |node: usize| pressed[node + 1] || 0 < node && pressed[node - 1];
        let moment = |node: usize| {
            let joined = self.nodes.get(node + 1).is_some_and(|next| *next <= self.nodes[node]);
            let node = node + usize::from(joined);
            ends.get(node).map_or_else(|| -ends[node - 1][3], |forces| forces[1])
        };
        let is_one = |node: usize| !beside(node) && !self.problem.has_two_moments(self.nodes[node]);
        Numbers {
            supports: self.supports().map(|spring| spring.force(&self.values) * force).collect(),
            contact: self.soil().filter(|spring| spring.pressed).map(|spring| spring.force(&self.values)).sum::<f64>()
                * force,
            energy: self.energy() * force,
            length,
            deflections: at_places.iter().map(|node| self.values[2 * node].near()).collect(),
            moments: at_places.iter().map(|node| is_one(*node).then(|| moment(*node) * force * length)).collect(),
        }
    }

    /// What acts on the two ends of an element: what bends it and presses its springs, less its load.
    fn end_forces(&self, i: usize) -> [f64; 4] {
        let (x, h) = (self.nodes[i], self.nodes[i + 1] - self.nodes[i]);
        let mut forces = self.element(i).bent(&self.values[2 * i..]);
        let loads = carried(h, self.problem.load(x, x + h));
        forces.iter_mut().zip(loads).for_each(|(force, load)| *force = *force - load.into());
        for spring in self.soil_of(i).filter(|spring| spring.pressed) {
            let pressure = spring.force(&self.values);
            spring.moved().for_each(|(freedom, share)| {
                forces[freedom - 2 * i] = forces[freedom - 2 * i] + Wide::from(pressure * share);
            });
        }
        forces.map(Wide::near)
    }

    /// Of bending and springs, less that of the loads.
    fn energy(&self) -> f64 {
        let mut sum = self.loads.iter().zip(&self.values).fold(Wide::ZERO, |sum, (load, value)| sum - *load * *value);
        for (i, pair) in self.nodes.windows(2).enumerate() {
            let (element, values) = (self.element(i), &self.values[2 * i..2 * i + 4]);
            let bending = element.bent(values).iter().zip(values).fold(Wide::ZERO, |sum, (a, b)| sum + *a * *b);
            sum = sum + bending * 0.5.into();
            // Between nodes the load bends an element on, as if its ends were built in: m²h⁵/1440 and d²h⁵/50400 for q = m ± d at the ends.
            if self.soil_of(i).all(|spring| !spring.pressed) {
                let [a, b] = self.problem.load(pair[0], pair[1]);
                let (mean, part) = (0.5 * (a + b), 0.5 * (a - b));
                let h = element.h;
                let fifth = h * h * h * h * h / element.stiffness;
                sum = sum - Wide::from(fifth * (mean * mean / 1440.0 + part * part / 50400.0));
            }
        }
        // In springs that do not give there is next to nothing.
        for spring in self.springs.iter().filter(|spring| spring.presses() && spring.stiffness < RIGID) {
            sum = sum + Wide::from(0.5 * spring.force(&self.values) * spring.compression(&self.values));
        }
        sum.near()
    }
}

/// Values of an element times these shares.
fn sum(shares: [f64; 4], values: &[Wide]) -> Wide {
    shares.iter().zip(values).fold(Wide::ZERO, |sum, (share, value)| sum + value.times(*share))
}

/// Deflection at a share of an element.
fn sunk(h: f64, t: f64, values: &[Wide]) -> Wide {
    sum(shapes(h, t), values)
}

/// Deflection and slope there.
fn between(h: f64, t: f64, values: &[Wide]) -> [Wide; 2] {
    let slopes = [-6.0 * t * (1.0 - t) / h, (1.0 - t) * (1.0 - 3.0 * t), 6.0 * t * (1.0 - t) / h, t * (3.0 * t - 2.0)];
    [sunk(h, t, values), sum(slopes, values)]
}
