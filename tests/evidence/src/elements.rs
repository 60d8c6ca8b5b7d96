//! A beam on an elastic foundation by finite elements, which shares nothing with the library but the data types of a scene: cubic
//! elements, springs at the points of a quadrature, switched on where the beam is below the surface and off elsewhere until none
//! changes, and around that supports that only push, switched in the same way.
//!
//! ```text
//! (K + Σ k w NᵀN) u = f + Σ k w g Nᵀ        over the points with v > g;        R = (K u + … − f)  at what is held
//! ```
//!
//! In a joint the slope has two freedoms, one for each side, with a turning spring between them. Supports that give are springs at freedoms;
//! those that only push are switched as well.

use palkki::scene::{Scene, Support};

use crate::definition::{FIVE, intensity};

/// Elements: with nodes at tenths and eighths of the beam. Rounding grows with the fourth power.
const ELEMENTS: u32 = 400;

/// Freedoms of an element.
const EACH: usize = 4;

/// Coefficients of a row of the band, the diagonal first: an element and one more slope in a joint.
const BAND: usize = 5;

/// Changes of a set that are made, at most.
const CHANGES: usize = 200;

/// What the elements say of a beam.
#[derive(Debug, Clone)]
pub struct Found {
    /// Forces of all supports, from left to right, upwards.
    pub supports: Vec<f64>,
    /// What the springs press with in total.
    pub contact: f64,
    /// Places of the nodes, and deflections there.
    pub deflection: Vec<[f64; 2]>,
}

/// Shape functions of an element of width `h` at `t h`.
fn shape(t: f64, h: f64) -> [f64; 4] {
    [
        1.0 - 3.0 * t * t + 2.0 * t * t * t,
        h * (t - 2.0 * t * t + t * t * t),
        3.0 * t * t - 2.0 * t * t * t,
        h * (t * t * t - t * t),
    ]
}

/// Their slopes.
fn slopes(t: f64, h: f64) -> [f64; 4] {
    let turned = 6.0 * t * (1.0 - t) / h;
    [-turned, 1.0 - 4.0 * t + 3.0 * t * t, turned, t * (3.0 * t - 2.0)]
}

/// A point of the quadrature: its element, shape functions, weight times stiffness of the ground, and the depth of the ground.
struct Point {
    element: usize,
    shape: [f64; EACH],
    weight: f64,
    ground: f64,
}

/// A spring at a freedom, with its value without force.
#[derive(Debug, Clone, Copy)]
struct Spring {
    freedom: usize,
    stiffness: f64,
    without: f64,
}

/// The elements of a scene.
struct Elements<'a> {
    scene: &'a Scene,
    nodes: Vec<f64>,
    /// Of each node its deflection, and its slope to the left and to the right.
    freedoms: Vec<[usize; 3]>,
    points: Vec<Point>,
    load: Vec<f64>,
}

impl<'a> Elements<'a> {
    fn of(scene: &'a Scene, elements: u32) -> Self {
        let length = scene.beam().length();
        let mut nodes = vec![0.0, length];
        nodes.extend(scene.beam().all_supports().iter().map(|support| support.at));
        nodes.extend(scene.beam().joints().iter().map(|joint| joint.at));
        nodes.extend(scene.beam().steps().iter().chain(scene.ground_steps()).map(|step| step[0]));
        // None beside these: the stiffness of an element grows with the cube of how short it is.
        let beside = |x: &f64| nodes.iter().any(|node| (node - x).abs() <= 0.25 * length / f64::from(elements));
        let even: Vec<f64> = (1..elements).map(|i| length * f64::from(i) / f64::from(elements)).collect();
        nodes.extend(even.into_iter().filter(|x| !beside(x)).collect::<Vec<f64>>());
        nodes.sort_by(f64::total_cmp);
        nodes.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * length);
        let own = |x: f64| scene.beam().shape().map_or(0.0, |shape| shape.depth(x));
        let mut count = 0;
        let freedoms: Vec<[usize; 3]> = nodes
            .iter()
            .map(|x| {
                let turns = scene.beam().joints().iter().any(|joint| (joint.at - x).abs() <= 1e-9 * length);
                let first = count;
                count += 2 + usize::from(turns);
                [first, first + 1, count - 1]
            })
            .collect();
        let mut elements = Self { scene, points: Vec::new(), load: vec![0.0; count], nodes, freedoms };
        for (element, pair) in elements.nodes.windows(2).enumerate() {
            let freedoms = of_element(&elements.freedoms, element);
            let width = pair[1] - pair[0];
            for [place, share] in FIVE {
                let t = 0.5 + 0.5 * place;
                let (x, weight, shape) = (pair[0] + t * width, 0.5 * share * width, shape(t, width));
                (0..EACH).for_each(|i| elements.load[freedoms[i]] += weight * intensity(scene, x) * shape[i]);
                let [_, k] = scene.ground_stiffness_beside(x);
                if 0.0 < k {
                    elements.points.push(Point { element, shape, weight: k * weight, ground: scene.depth(x) - own(x) });
                }
            }
        }
        let forces = scene.load().point().iter().map(|load| (load.at, load.force, shape as fn(f64, f64) -> [f64; 4]));
        let couples = scene.load().couple().iter().map(|load| (load.at, load.moment, slopes as _));
        for (at, acts, on) in forces.chain(couples) {
            let element = elements.nodes.partition_point(|x| *x <= at).clamp(1, elements.nodes.len() - 1) - 1;
            let width = elements.nodes[element + 1] - elements.nodes[element];
            let on = on((at - elements.nodes[element]) / width, width);
            let freedoms = of_element(&elements.freedoms, element);
            (0..EACH).for_each(|i| elements.load[freedoms[i]] += acts * on[i]);
        }
        elements
    }

    /// The springs of supports that give: those that act both ways, and those that only push.
    fn springs(&self) -> [Vec<Spring>; 2] {
        let [mut both, mut pushing] = [Vec::new(), Vec::new()];
        let turning = |at: f64, [stiffness, without]: [f64; 2]| Spring {
            freedom: self.freedoms[self.node(at)][1],
            stiffness,
            without,
        };
        both.extend(self.scene.held().iter().filter_map(|held| held.turning.map(|of| turning(held.at, of))));
        for spring in self.scene.springs() {
            let freedom = self.freedoms[self.node(spring.at)][0];
            let of = Spring { freedom, stiffness: spring.stiffness, without: spring.deflection };
            if spring.pushes_only {
                pushing.push(of)
            } else {
                both.push(of)
            }
            both.extend(spring.turning.map(|of| turning(spring.at, of)));
        }
        [both, pushing]
    }

    fn node(&self, x: f64) -> usize {
        let off = |i: &usize| (self.nodes[*i] - x).abs();
        (0..self.nodes.len()).min_by(|a, b| off(a).total_cmp(&off(b))).expect("nodes")
    }

    /// `K u`, and its rows.
    fn bending(&self) -> Vec<[f64; BAND]> {
        let mut rows = vec![[0.0; BAND]; self.load.len()];
        for (element, pair) in self.nodes.windows(2).enumerate() {
            let h = pair[1] - pair[0];
            let steps = self.scene.beam().steps();
            let step = steps.iter().rfind(|step| step[0] <= 0.5 * (pair[0] + pair[1]));
            let unit = step.map_or(self.scene.beam().bending_stiffness(), |step| step[1]) / (h * h * h);
            let [a, b, c] = [12.0 * unit, 6.0 * h * unit, 2.0 * h * h * unit];
            let all = [[a, b, -a, b], [b, 2.0 * c, -b, c], [-a, -b, a, -b], [b, c, -b, 2.0 * c]];
            let freedoms = of_element(&self.freedoms, element);
            for i in 0..EACH {
                (i..EACH).for_each(|j| rows[freedoms[i]][freedoms[j] - freedoms[i]] += all[i][j]);
            }
        }
        for joint in self.scene.beam().joints() {
            let ([_, left, right], k) = (self.freedoms[self.node(joint.at)], joint.stiffness.unwrap_or(0.0));
            (rows[left][0], rows[right][0], rows[left][1]) = (rows[left][0] + k, rows[right][0] + k, rows[left][1] - k);
        }
        rows
    }

    fn deflection(&self, u: &[f64], point: &Point) -> f64 {
        let freedoms = of_element(&self.freedoms, point.element);
        (0..EACH).map(|i| point.shape[i] * u[freedoms[i]]).sum()
    }

    /// The beam with these springs on and these freedoms held: its freedoms and what holds them.
    fn solve(&self, on: &[bool], held: &[(usize, f64)], springs: &[Spring]) -> [Vec<f64>; 2] {
        let (mut rows, mut right) = (self.bending(), self.load.clone());
        for Spring { freedom, stiffness, without } in springs {
            (rows[*freedom][0], right[*freedom]) =
                (rows[*freedom][0] + stiffness, right[*freedom] + stiffness * without);
        }
        for (point, _) in self.points.iter().zip(on).filter(|(_, on)| **on) {
            let freedoms = of_element(&self.freedoms, point.element);
            for i in 0..EACH {
                right[freedoms[i]] += point.weight * point.ground * point.shape[i];
                let pushed = |j: usize| point.weight * point.shape[i] * point.shape[j];
                (i..EACH).for_each(|j| rows[freedoms[i]][freedoms[j] - freedoms[i]] += pushed(j));
            }
        }
        let (all, loads) = (rows.clone(), right.clone());
        for &(freedom, value) in held {
            for away in 1..BAND {
                if let Some(above) = freedom.checked_sub(away) {
                    right[above] -= std::mem::take(&mut rows[above][away]) * value;
                }
                if freedom + away < right.len() {
                    right[freedom + away] -= std::mem::take(&mut rows[freedom][away]) * value;
                }
            }
            (rows[freedom][0], right[freedom]) = (1.0, value);
        }
        eliminate(&mut rows, &mut right);
        let left = product(&all, &right);
        [right, left.iter().zip(&loads).map(|(left, load)| load - left).collect()]
    }
}

/// The freedoms of an element: deflection and slope at its left end, and at its right end.
fn of_element(freedoms: &[[usize; 3]], element: usize) -> [usize; EACH] {
    let ([v, _, slope], [next, turned, _]) = (freedoms[element], freedoms[element + 1]);
    [v, slope, next, turned]
}

/// Solves a symmetric band, in place.
fn eliminate(rows: &mut [[f64; BAND]], right: &mut [f64]) {
    let count = rows.len();
    for i in 0..count {
        for away in (1..BAND).filter(|away| i + away < count) {
            let factor = rows[i][away] / rows[i][0];
            (away..BAND).for_each(|j| rows[i + away][j - away] -= factor * rows[i][j]);
            right[i + away] -= factor * right[i];
        }
    }
    for i in (0..count).rev() {
        let known: f64 = (1..BAND).filter(|away| i + away < count).map(|away| rows[i][away] * right[i + away]).sum();
        right[i] = (right[i] - known) / rows[i][0];
    }
}

/// A symmetric band times a vector.
fn product(rows: &[[f64; BAND]], u: &[f64]) -> Vec<f64> {
    let mut all = vec![0.0; u.len()];
    for (i, row) in rows.iter().enumerate() {
        for (away, value) in row.iter().enumerate().filter(|(away, _)| i + away < u.len()) {
            all[i] += value * u[i + away];
            if 0 < away {
                all[i + away] += value * u[i];
            }
        }
    }
    all
}

/// The beam of a scene on an elastic foundation; [`None`] where the sets go on changing.
#[must_use]
pub fn solved(scene: &Scene) -> Option<Found> {
    solved_by(scene, ELEMENTS)
}

/// The same by so many elements.
#[must_use]
pub fn solved_by(scene: &Scene, elements: u32) -> Option<Found> {
    scene.ground_stiffness()?;
    let elements = Elements::of(scene, elements);
    let mut always = Vec::new();
    for held in scene.held() {
        let [v, slope, _] = elements.freedoms[elements.node(held.at)];
        always.push((v, held.deflection));
        always.extend(held.slope.map(|held| (slope, held)));
    }
    let bearings: Vec<(usize, f64)> =
        scene.bearings().map(|b| (elements.freedoms[elements.node(b.at)][0], b.gap)).collect();
    let [both, stops] = elements.springs();
    let mut presses = vec![true; bearings.len() + stops.len()];
    let size: f64 = elements.freedoms.iter().map(|freedoms| elements.load[freedoms[0]].abs()).sum();
    let mut on = vec![true; elements.points.len()];
    for _ in 0..CHANGES {
        let stands = bearings.iter().zip(&presses).filter(|(_, presses)| **presses).map(|(bearing, _)| *bearing);
        let held: Vec<(usize, f64)> = always.iter().copied().chain(stands).collect();
        let stopped = stops.iter().zip(&presses[bearings.len()..]).filter(|(_, presses)| **presses);
        let springs: Vec<Spring> = both.iter().copied().chain(stopped.map(|(stop, _)| *stop)).collect();
        let [u, lacking] = (0..CHANGES).find_map(|_| {
            let [u, lacking] = elements.solve(&on, &held, &springs);
            let next: Vec<bool> = elements.points.iter().map(|p| p.ground < elements.deflection(&u, p)).collect();
            let stays = next == on;
            on = next;
            stays.then_some([u, lacking])
        })?;
        let wrong: Vec<usize> = (0..presses.len())
            .filter(|&i| {
                if let Some(stop) = i.checked_sub(bearings.len()).map(|i| stops[i]) {
                    return presses[i] != (stop.without < u[stop.freedom]);
                }
                let (freedom, level) = bearings[i];
                if presses[i] { lacking[freedom] < -1e-9 * size } else { level + 1e-9 * level.abs() < u[freedom] }
            })
            .collect();
        let Some(last) = wrong.last() else {
            let below = |point: &Point| (elements.deflection(&u, point) - point.ground).max(0.0) * point.weight;
            let force = |support: &Support| {
                let of = elements.freedoms[elements.node(support.at)][0];
                let given = scene.springs().find(|spring| (spring.at - support.at).abs() <= 0.0);
                given.map_or(lacking[of], |spring| {
                    let force = spring.stiffness * (u[of] - spring.deflection);
                    if spring.pushes_only { force.max(0.0) } else { force }
                })
            };
            let deflection = elements.nodes.iter().zip(&elements.freedoms).map(|(x, of)| [*x, u[of[0]]]).collect();
            return Some(Found {
                supports: scene.beam().all_supports().iter().map(force).collect(),
                contact: elements.points.iter().map(below).sum(),
                deflection,
            });
        };
        presses[*last] = !presses[*last];
    }
    None
}
