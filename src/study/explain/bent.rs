//! The coefficients of a span in the three-moment equations, also where the bending stiffness changes on it.
//!
//! With `ξ` from the left end, `EI₀` the least bending stiffness, and `m₀` the moments of the load on a simple beam:
//!
//! ```text
//! B_l = 6 EI₀ ∫ (1 − ξ/L)²/EI,   B = 6 EI₀ ∫ (ξ/L)(1 − ξ/L)/EI,   B_r = 6 EI₀ ∫ (ξ/L)²/EI,   and a joint adds 6 EI₀/k of the same at ξ_j
//! S_l = 6 EI₀ ∫ m₀ (1 − ξ/L)/EI,   S_r = 6 EI₀ ∫ m₀ (ξ/L)/EI,                                 and a joint adds the same here
//! ```
//!
//! If the bending stiffness is constant, the `B` are `2L`, `L` and `2L`.
//!
//! Beam theory has the same numbers in another form. They are computed anew here on purpose: an explanation checks beam theory.

use super::places::SAME;
use crate::scene::{Concentrated, Scene};
use crate::theory::gauss::Gauss;

/// The coefficients of a span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bent {
    /// `B_l`, `B` and `B_r` \[length\].
    pub(super) bend: [f64; 3],
    /// `S_l` and `S_r` \[force · length²\].
    pub(super) load: [f64; 2],
    /// `A_l` and `A_r` \[force\].
    pub(super) reactions: [f64; 2],
    /// The sum of the contributions of the load to both `S`, without their signs.
    pub(super) size: f64,
}

impl Bent {
    /// The coefficients between two positions of a scene.
    pub(super) fn of(scene: &Scene, ends: [f64; 2]) -> Self {
        let beam = scene.beam();
        let is_even = beam.changes().next().is_none() && joints(scene, ends).next().is_none();
        if is_even { Self::even(scene, ends) } else { Self::changing(scene, ends) }
    }

    /// For constant bending stiffness and no joints.
    fn even(scene: &Scene, [from, to]: [f64; 2]) -> Self {
        let (length, here) = (to - from, SAME * scene.beam().length());
        let mut bent =
            Self { bend: [2.0 * length, length, 2.0 * length], load: [0.0; 2], reactions: [0.0; 2], size: 0.0 };
        each_load(scene, from, to, |Concentrated { at, force, couple }| {
            let (xi, rest) = (at - from, to - at);
            let (common, turned) = (force * xi * rest / length, couple / length);
            // The effect of a couple is the derivative of the effect of a force with respect to its position.
            let left = common * (length + rest) + turned * (rest * (length + rest) - xi * (length + 2.0 * rest));
            let right = common * (length + xi) + turned * ((rest - xi) * (length + xi) + xi * rest);
            bent.reactions = [bent.reactions[0] - turned, bent.reactions[1] + turned];
            bent.load = [bent.load[0] + left, bent.load[1] + right];
            // A force this close to a node is a load on the node; only its lever arm counts, for the moments.
            if here < xi && here < rest {
                let [left, right] = bent.reactions;
                bent.reactions = [left + force * rest / length, right + force * xi / length];
            }
            bent.size += left.abs() + right.abs();
        });
        bent
    }

    /// For any beam.
    fn changing(scene: &Scene, [from, to]: [f64; 2]) -> Self {
        /// The integrands are products of a cubic and a line, and squares of lines.
        const DEGREE: usize = 4;
        let (length, beam) = (to - from, scene.beam());
        let even = Self::even(scene, [from, to]);
        let mut places: Vec<f64> = beam.changes().chain(scene.load().places(beam.length())).collect();
        places.retain(|x| from < *x && *x < to);
        places.extend([from, to]);
        places.sort_by(f64::total_cmp);
        let mut bent = Self { bend: [0.0; 3], load: [0.0; 2], size: 0.0, ..even };
        let mut add = |x: f64, softness: f64| {
            let (share, moment) = ((x - from) / length, unloaded(scene, [from, to], even.reactions[0], x));
            let [left, right] = [1.0 - share, share].map(|share| 6.0 * softness * share);
            bent.bend =
                [bent.bend[0] + left * (1.0 - share), bent.bend[1] + left * share, bent.bend[2] + right * share];
            bent.load = [bent.load[0] + left * moment, bent.load[1] + right * moment];
            bent.size += (left + right) * moment.abs();
        };
        for cell in places.windows(2).filter(|cell| cell[0] < cell[1]) {
            let softness = beam.bending_stiffness() / beam.stiffness_between(cell[0], cell[1]);
            Gauss::exact_to(DEGREE).points(cell[0], cell[1]).for_each(|(x, weight)| add(x, weight * softness));
        }
        joints(scene, [from, to]).for_each(|(x, k)| add(x, beam.bending_stiffness() / k));
        bent
    }
}

/// The joints strictly between two positions, without hinges, with their stiffness.
fn joints(scene: &Scene, [from, to]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> + '_ {
    let here = SAME * scene.beam().length();
    let inside = move |x: f64| from + here < x && x + here < to;
    scene
        .beam()
        .joints()
        .iter()
        .filter(move |joint| inside(joint.at))
        .filter_map(|joint| Some((joint.at, joint.stiffness?)))
}

/// The moment at a third position of the load between two positions, with the reaction on the left.
fn unloaded(scene: &Scene, [from, to]: [f64; 2], reaction: f64, x: f64) -> f64 {
    let (load, here) = (scene.load(), SAME * scene.beam().length());
    let is_before = |at: f64| from + here < at && at < x && at + here < to;
    let acts = load.concentrated().filter(|acts| is_before(acts.at));
    let concentrated: f64 = acts.map(|acts| acts.couple - acts.force * (x - acts.at)).sum();
    let spread = load.spread(scene.beam().length()).map(|part| {
        let [start, end] = [part.from, part.to].map(|place| place.max(from).min(x));
        Gauss::exact_to(2).points(start, end).map(|(at, weight)| part.intensity(at) * weight * (x - at)).sum::<f64>()
    });
    reaction * (x - from) + concentrated - spread.sum::<f64>()
}

/// The load strictly between two positions, as couples and as forces with the same resultant and the same next three moments.
pub(super) fn each_load(scene: &Scene, from: f64, to: f64, mut visit: impl FnMut(Concentrated)) {
    /// For these integrals under a linear load.
    const DEGREE: usize = 4;
    let (rule, load) = (Gauss::exact_to(DEGREE), scene.load());
    load.concentrated().filter(|acts| from < acts.at && acts.at < to).for_each(&mut visit);
    for part in load.spread(scene.beam().length()) {
        // A part outside has zero width, and its weights are zero.
        let [start, end] = [part.from, part.to].map(|x| x.max(from).min(to));
        let force = |at: f64, weight: f64| Concentrated { at, force: part.intensity(at) * weight, couple: 0.0 };
        rule.points(start, end).for_each(|(x, weight)| visit(force(x, weight)));
    }
}
