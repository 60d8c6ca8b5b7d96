//! The example on any grid with eighty digits: three-moment equations in whole numbers with 256 binary places.
//!
//! Exact rationals grow with every elimination; numbers of fixed width do not, and the equations (see `hencky.rs` for the chain
//! of the finite differences) lose none of their places. Units are chosen so that the data are short: lengths in intervals,
//! forces in nodal loads `q₀Δ`, depths in `q₀Δ⁴/6EI`, which makes the depth of the foundation `N⁴/1280`.
//!
//! A contact set comes from whoever proposes it and is exchanged until (34), (35) hold in these numbers.

use dashu_int::IBig;
use palkki::state::Bending;

/// Binary places.
const PLACES: usize = 256;

/// Exchanges of all violators before the search is given up; from a good guess one or two are enough.
const EXCHANGES: usize = 40;

/// The optimum, rounded to 64 bits.
#[derive(Debug)]
pub(super) struct Optimum {
    /// Contact forces at the interior nodes, over the whole load.
    pub(super) contact_force: Vec<f64>,
    /// Reaction of the left support with the load on it, over the whole load.
    pub(super) left_reaction: f64,
    /// Deflections at the interior nodes, over the depth of the foundation.
    pub(super) deflection: Vec<f64>,
    /// Which nodes touch.
    pub(super) touches: Vec<bool>,
}

/// The optimum of the example on `guess.len() + 1` intervals; none if the exchanges do not end.
pub(super) fn optimum(bending: Bending, guess: &[bool]) -> Option<Optimum> {
    let mut touches = guess.to_vec();
    for _ in 0..EXCHANGES {
        let beam = Beam::on(bending, &touches);
        let wrong = |i: &usize| if touches[*i] { beam.force[*i] < IBig::ZERO } else { beam.clearance[*i] < IBig::ZERO };
        let violators: Vec<usize> = (0..touches.len()).filter(wrong).collect();
        if violators.is_empty() {
            return Some(beam.rounded(touches));
        }
        violators.into_iter().for_each(|i| touches[i] = !touches[i]);
    }
    None
}

/// The beam on given nodes.
struct Beam {
    depth: IBig,
    force: Vec<IBig>,
    clearance: Vec<IBig>,
    left: IBig,
}

fn whole(number: usize) -> IBig {
    IBig::from(number) << PLACES
}

fn divide(a: &IBig, b: &IBig) -> IBig {
    (a << PLACES) / b
}

fn times(a: &IBig, b: &IBig) -> IBig {
    (a * b) >> PLACES
}

/// The nearest 64-bit number.
fn number(value: &IBig) -> f64 {
    let places = (0..PLACES).fold(1.0, |power, _| 2.0 * power);
    value.to_f64().value() / places
}

/// What a span of `L` intervals contributes: its coefficients beside and on the diagonal, `ϑ = L (L² − 1)/4`.
fn coefficients(bending: Bending, steps: usize) -> [IBig; 3] {
    let inverse = match bending {
        Bending::AtNodes => whole(1) / steps,
        Bending::Between => IBig::ZERO,
    };
    let square = IBig::from(steps) * steps - IBig::ONE;
    [whole(steps) - &inverse, whole(2 * steps) + inverse, whole(steps) * square / 4]
}

impl Beam {
    fn on(bending: Bending, touches: &[bool]) -> Self {
        let intervals = touches.len() + 1;
        let held = (1..intervals).filter(|&node| touches[node - 1]);
        let nodes: Vec<usize> = std::iter::once(0).chain(held).chain([intervals]).collect();
        let power = IBig::from(intervals) * intervals * intervals * intervals;
        let depth = (power << PLACES) / 1280;
        let moments = moments(bending, &nodes, &depth);

        let (mut force, mut clearance) = (vec![IBig::ZERO; intervals - 1], vec![IBig::ZERO; intervals - 1]);
        let (mut left, mut before) = (IBig::ZERO, IBig::ZERO);
        for (k, pair) in nodes.windows(2).enumerate() {
            let steps = pair[1] - pair[0];
            // Half of the loads between, and the shear force of the end moments.
            let (share, shear) = (whole(steps - 1) / 2, (&moments[k + 1] - &moments[k]) / steps);
            if k == 0 {
                left = &share + &shear + whole(1) / 2;
            } else {
                force[pair[0] - 1] = &before + &share + &shear;
            }
            before = share - shear + whole(1);
            let ends =
                [pair[0], pair[1]].map(|node| if node == 0 || node == intervals { IBig::ZERO } else { depth.clone() });
            if 1 < steps {
                let sags = sags(bending, steps, [&moments[k], &moments[k + 1]]);
                for (i, sag) in (1..steps).zip(sags) {
                    let chord = &ends[0] + (&ends[1] - &ends[0]) * i / steps;
                    clearance[pair[0] + i - 1] = &depth - chord - sag;
                }
            }
        }
        Self { depth, force, clearance, left }
    }

    fn rounded(&self, touches: Vec<bool>) -> Optimum {
        let intervals = whole(touches.len() + 1);
        let of_load = |force: &IBig| number(&divide(force, &intervals));
        Optimum {
            contact_force: self.force.iter().map(of_load).collect(),
            left_reaction: of_load(&self.left),
            deflection: self.clearance.iter().map(|h| number(&divide(&(&self.depth - h), &self.depth))).collect(),
            touches,
        }
    }
}

/// Moments at the nodes, zero at the two ends.
fn moments(bending: Bending, nodes: &[usize], depth: &IBig) -> Vec<IBig> {
    let last = nodes.len() - 1;
    let mut moments = vec![IBig::ZERO; last + 1];
    // M_i = moments[i] − passed[i] M_{i+1}
    let mut passed = vec![IBig::ZERO; last + 1];
    for i in 1..last {
        let (a, b) = (nodes[i] - nodes[i - 1], nodes[i + 1] - nodes[i]);
        let ([before, left, turned_left], [behind, right, turned_right]) =
            (coefficients(bending, a), coefficients(bending, b));
        let mut rest = -(turned_left + turned_right) - times(&before, &moments[i - 1]);
        // The ground is flat: the chord bends where a neighbour is a support of the beam.
        if i == 1 {
            rest += depth / a;
        }
        if i + 1 == last {
            rest += depth / b;
        }
        let pivot = left + right - times(&before, &passed[i - 1]);
        moments[i] = divide(&rest, &pivot);
        if i + 1 < last {
            passed[i] = divide(&behind, &pivot);
        }
    }
    for i in (1..last).rev() {
        let from_right = times(&passed[i], &moments[i + 1]);
        moments[i] -= from_right;
    }
    moments
}

/// Deflections below the chord at the inner nodes of a span, by summing curvatures twice.
fn sags(bending: Bending, steps: usize, ends: [&IBig; 2]) -> Vec<IBig> {
    let (mut slope, mut height) = (IBig::ZERO, IBig::ZERO);
    let mut heights = Vec::with_capacity(steps);
    for k in 1..=steps {
        height += &slope;
        heights.push(height.clone());
        let moment = whole(k * (steps - k)) / 2 + ends[0] + (ends[1] - ends[0]) * k / steps;
        slope -= match bending {
            Bending::AtNodes => moment * 6,
            // M_{k−1} + 4 M_k + M_{k+1}, and the second difference of M is −1.
            Bending::Between => moment * 6 - whole(1),
        };
    }
    let end = height;
    (1..steps).zip(&heights).map(|(k, height)| height - &end * k / steps).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::rational::Example;

    /// Against elimination in exact rationals on the matrices of the paper, from a guess that is wrong by a node.
    #[test]
    fn the_optimum_is_that_of_exact_rationals() {
        let from = |first: usize| -> Vec<bool> { (1..30).map(|i: usize| first <= i.min(30 - i)).collect() };
        for bending in [Bending::AtNodes, Bending::Between] {
            let wide = optimum(bending, &from(8)).expect("one exchange");
            assert_eq!(wide.touches, from(7));
            let example = Example::new(30);
            let exact = match bending {
                Bending::AtNodes => example.by_differences(&from(7)),
                Bending::Between => example.by_energy(&from(7)),
            }
            .expect("the contact begins at node 7");
            for (found, force) in wide.contact_force.iter().zip(&exact.contact_force) {
                let expected = force.to_f64().value() / 10.0;
                assert!((found - expected).abs() <= f64::EPSILON * expected, "{found} and not {expected}");
            }
            let reaction = exact.left_reaction.to_f64().value() / 10.0;
            assert!((wide.left_reaction - reaction).abs() <= f64::EPSILON * reaction, "{}", wide.left_reaction);
        }
    }
}
