//! A pipe on surveyed soil, and what an engineer would write for it otherwise: cubic elements half a reading long on springs at their Gauss
//! points, which are switched on and off until none changes, in double precision.
//!
//! ```text
//! (K + Σ k w bbᵀ) u = f + Σ k w g b       over the springs that are pressed, b: how much each freedom moves one
//! ```
//!
//! [`elements`](crate::elements) is the authority for scenes of any kind; this is a competitor, with the means of most programs.

use palkki::scene::{Beam, Foundation, Load, Scene, SceneError};

use crate::elements::{carried, shapes};
use crate::random::Random;

/// The bending stiffness of the pipe in N m², and its weight in N/m.
const STIFFNESS: f64 = 2.1e8;
const WEIGHT: f64 = 1500.0;

/// A pipe without supports on a bed with long and short waves and a noise of 5 cm.
#[derive(Debug, Clone, Copy)]
pub struct Pipe {
    /// Of the pipe \[m\].
    pub length: f64,
    /// Depths of the bed, equally far apart; two at least.
    pub readings: u32,
    /// Of the noise.
    pub seed: u64,
    /// Stiffness of the soil \[N/m²\].
    pub soil: f64,
}

/// Springs are switched at most so often.
const STEPS: u32 = 200;

/// The answer of finite elements.
#[derive(Debug)]
pub struct Answer {
    /// The nodes from left to right \[m\].
    pub nodes: Vec<f64>,
    /// Deflection \[m\] and slope of each.
    pub values: Vec<[f64; 2]>,
    /// Linear systems that were solved.
    pub steps: u32,
    /// Whether the springs settled.
    pub settled: bool,
}

impl Answer {
    /// The bending moments in the middle of the elements, with their places \[N m, m\].
    pub fn moments(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.nodes.windows(2).zip(self.values.windows(2)).map(|(x, value)| {
            let turned = value[1][1] - value[0][1];
            (0.5 * (x[0] + x[1]), -STIFFNESS * turned / (x[1] - x[0]))
        })
    }
}

/// A spring at a Gauss point of an element.
struct Spring {
    element: usize,
    shares: [f64; 4],
    stiffness: f64,
    gap: f64,
    pressed: bool,
}

impl Pipe {
    /// The depths of the bed with their places.
    fn bed(&self) -> Vec<[f64; 2]> {
        let mut random = Random::new(self.seed);
        let point = |i: u32| {
            let x = self.length * (f64::from(i) / f64::from(self.readings - 1));
            [x, 100.0 + 1.5 * libm::sin(x / 25.0) + 0.5 * libm::sin(x / 7.0 + 1.0) + random.between(-0.05, 0.05)]
        };
        (0..self.readings).map(point).collect()
    }

    /// As a scene.
    ///
    /// # Errors
    ///
    /// A [`SceneError`] for a length or a stiffness that is none.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let beam = Beam::new(self.length, STIFFNESS)?.with_supports(Vec::new())?;
        let load = Load::uniform_on(&beam, WEIGHT)?;
        Scene::new(beam, load, Some(Foundation::Polyline { points: self.bed() }))?.on_springs(self.soil)
    }

    /// Its weight \[N\].
    #[must_use]
    pub fn weight(&self) -> f64 {
        WEIGHT * self.length
    }

    /// Solves it by finite elements.
    #[must_use]
    pub fn by_elements(&self) -> Answer {
        let points = self.bed();
        let mut nodes = vec![points[0][0]];
        points.windows(2).for_each(|pair| nodes.extend([0.5 * (pair[0][0] + pair[1][0]), pair[1][0]]));
        let mut springs = springs(&points, &nodes, self.soil);
        let mut answer = Answer { nodes, values: Vec::new(), steps: 0, settled: false };
        while answer.steps < STEPS && !answer.settled {
            answer.steps += 1;
            answer.values = solved(&answer.nodes, &springs);
            answer.settled = true;
            for spring in &mut springs {
                let [[v0, slope0], [v1, slope1]] = [0, 1].map(|k| answer.values[spring.element + k]);
                let moved: f64 = [v0, slope0, v1, slope1].iter().zip(spring.shares).map(|(v, share)| v * share).sum();
                let pressed = spring.gap < moved;
                answer.settled &= pressed == spring.pressed;
                spring.pressed = pressed;
            }
        }
        answer
    }
}

/// Two in each element, all of them pressed: with an element half a reading long more would change nothing that is seen.
fn springs(points: &[[f64; 2]], nodes: &[f64], soil: f64) -> Vec<Spring> {
    let at = 0.5 / 3.0_f64.sqrt();
    let elements = nodes.windows(2).enumerate().flat_map(|(i, pair)| [(i, pair, 0.5 - at), (i, pair, 0.5 + at)]);
    let spring = |(element, pair, t): (usize, &[f64], f64)| {
        let (h, [a, b]) = (pair[1] - pair[0], [points[element / 2], points[element / 2 + 1]]);
        let x = pair[0] + t * h;
        Spring {
            element,
            shares: shapes(h, t),
            stiffness: 0.5 * h * soil,
            gap: a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]),
            pressed: true,
        }
    };
    elements.map(spring).collect()
}

/// Half of the bandwidth, with the diagonal.
const BAND: usize = 4;

/// The linear system of the springs that are pressed, by Cholesky's elimination without roots in its band.
fn solved(nodes: &[f64], springs: &[Spring]) -> Vec<[f64; 2]> {
    let count = 2 * nodes.len();
    // Row i: the entries (i, i) to (i, i + 3).
    let (mut band, mut right) = (vec![[0.0; BAND]; count], vec![0.0; count]);
    for (i, pair) in nodes.windows(2).enumerate() {
        let h = pair[1] - pair[0];
        let (a, b, c) = (12.0 * STIFFNESS / (h * h * h), 6.0 * STIFFNESS / (h * h), 2.0 * STIFFNESS / h);
        let element = [[a, b, -a, b], [2.0 * c, -b, c, 0.0], [a, -b, 0.0, 0.0], [2.0 * c, 0.0, 0.0, 0.0]];
        for (row, entries) in band[2 * i..].iter_mut().zip(element) {
            row.iter_mut().zip(entries).for_each(|(sum, entry)| *sum += entry);
        }
        right[2 * i..].iter_mut().zip(carried(h, [WEIGHT; 2])).for_each(|(sum, part)| *sum += part);
    }
    for spring in springs.iter().filter(|spring| spring.pressed) {
        for (r, a) in spring.shares.iter().enumerate() {
            let part = spring.stiffness * a;
            right[2 * spring.element + r] += part * spring.gap;
            let row = &mut band[2 * spring.element + r];
            row.iter_mut().zip(&spring.shares[r..]).for_each(|(sum, b)| *sum += part * b);
        }
    }
    for i in 0..count {
        let row = band[i];
        for k in 1..BAND.min(count - i) {
            let factor = row[k] / row[0];
            band[i + k].iter_mut().zip(&row[k..]).for_each(|(entry, above)| *entry -= factor * above);
            right[i + k] -= factor * right[i];
        }
    }
    for i in (0..count).rev() {
        let behind: f64 = (1..BAND.min(count - i)).map(|k| band[i][k] * right[i + k]).sum();
        right[i] = (right[i] - behind) / band[i][0];
    }
    right.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

#[cfg(test)]
mod tests {
    use palkki::theory;

    use super::*;

    /// Finite elements that share no code find the pipe of the exact solution, to the size of an element.
    #[test]
    fn both_find_the_same_pipe() {
        let pipe = Pipe { length: 300.0, readings: 300, seed: 1, soil: 5e5 };
        let exact = theory::solve(&pipe.scene().expect("a scene")).expect("an answer");
        let found = pipe.by_elements();
        assert!(exact.solved && found.settled, "{} steps", found.steps);
        let off = found.nodes.iter().zip(&found.values).map(|(x, value)| (value[0] - exact.deflection(*x)).abs());
        let off = off.fold(0.0, f64::max);
        assert!(1e-9 < off && off < 1e-2, "of some 100 m: {off:e}");
        let largest = exact.state.moment.max.max(-exact.state.moment.min);
        let most = found.moments().map(|(x, moment)| (moment - exact.moment(x)).abs()).fold(0.0, f64::max);
        assert!(most < 0.05 * largest, "{most:e} of {largest:e}");
    }
}
