//! Derivatives of a general beam, with elastic supports, joints, steps or an axial force: differences of answers in neighbouring scenes.
//!
//! On a rigid foundation, the neighbouring answers keep the contacts and the pressed stops of the answer, whether their conditions are
//! satisfied there or not. So their results are smooth functions of the number of the scene. On an elastic foundation the scenes are
//! solved anew. With `f_k` at `k` steps `h`
//!
//! ```text
//! f' = (45 (f₁ − f₋₁) − 9 (f₂ − f₋₂) + (f₃ − f₋₃))/60h + O(h⁶)         (8 (f₁ − f₋₁) − (f₂ − f₋₂))/12h + O(h⁴)
//! f' = ±(−25 f₀ + 48 f₁ − 36 f₂ + 16 f₃ − 3 f₄)/12h + O(h⁴)           on one side
//! ```
//!
//! The result comes from the step for which the formula and the formula of the next lower order differ least. The derivative is valid on
//! both sides if both one-sided derivatives are the same and the answer continues on both sides.

use super::{By, ContactDerivative, Derivative, Missing};
use crate::scene::{Quantity, Scene};
use crate::theory::exact::Exact;
use crate::theory::sensitivity::Change;
use crate::theory::variation::{NOTHING, Variation, is_next_to};

/// Steps, in multiples of a negligible change ([`NOTHING`]): shares of 1e-2 to 1e-5 of the size of a number.
const STEPS: [f64; 4] = [1e5, 1e4, 1e3, 1e2];

/// An upper limit of the number of answers that a derivative needs.
pub(super) const ANSWERS: usize = 2 + 9 * STEPS.len();

/// Derivatives on both sides that differ by less than this share of them, or by less than [`ROUNDING`] of the largest result of their
/// kind, are the same: the difference can come from the differences.
const SAME: f64 = 1e-4;

/// As a share of the largest result of its kind over the size of the varied number.
const ROUNDING: f64 = 1e-6;

/// Derivatives from the left, from both sides and from the right, as far as they exist.
struct Sides([Option<Vec<f64>>; 3]);

impl Exact {
    /// The requested derivative, by answers that keep the contacts.
    pub(super) fn moved_derivative(&self, scene: &Scene, variation: Variation, lies: bool) -> Derivative {
        let goes_on =
            if lies || variation.moves_at_zone(self) { [false; 2] } else { self.goes_on_beside(scene, variation) };
        let sizes = self.sizes();
        let Sides([left, both, right]) = self.differences(scene, variation, &sizes);
        let own = variation.least / NOTHING;
        let same = |a: &[f64], b: &[f64]| {
            a.iter().zip(b).zip(&sizes).all(|((a, b), size)| {
                a.is_nan() && b.is_nan() || (a - b).abs() <= SAME * (a.abs() + b.abs()) + ROUNDING * size / own
            })
        };
        let is_smooth = left.as_ref().zip(right.as_ref()).is_some_and(|(left, right)| same(left, right));
        let (numbers, one_sided) = match goes_on {
            [true, true] if is_smooth => (both, false),
            [false, false] => (None, true),
            [true, false] => (left, true),
            _ => (right, true),
        };
        let missing = numbers.is_none().then_some(Missing::Ends);
        self.of_numbers(variation.by, &numbers.unwrap_or_else(|| vec![f64::NAN; sizes.len()]), one_sided, missing)
    }

    /// Whether this answer continues if the number decreases, and if it increases.
    fn goes_on_beside(&self, scene: &Scene, variation: Variation) -> [bool; 2] {
        [-variation.least, variation.least].map(|step| {
            let there = variation.changed_scene(scene, step).and_then(|there| self.kept_in(&there));
            there.is_some_and(|there| there.solved && is_next_to(self, &there, scene.beam().length()))
        })
    }

    /// The results to be differentiated: reactions, contacts of the list, energy.
    fn numbers(&self) -> Vec<f64> {
        let supports = self.state.supports.iter().map(|support| support.force);
        let contacts = self.listed.iter().flat_map(|contact| {
            let [left, right] = contact.end_forces.unwrap_or([f64::NAN; 2]);
            [contact.from, contact.to, contact.force, left, right]
        });
        supports.chain(contacts).chain([self.state.energy]).collect()
    }

    /// The scale of each result: the largest of its kind.
    fn sizes(&self) -> Vec<f64> {
        let forces = self.state.supports.iter().map(|support| support.force.abs());
        let force = forces.fold(self.given.total_load * self.units.force, f64::max);
        let length = self.given.length * self.units.length;
        let supports = self.state.supports.iter().map(|_| force);
        let contacts = self.listed.iter().flat_map(|_| [length, length, force, force, force]);
        supports.chain(contacts).chain([self.state.energy.abs()]).collect()
    }

    /// The derivatives from differences, for the step with the smallest error.
    fn differences(&self, scene: &Scene, variation: Variation, sizes: &[f64]) -> Sides {
        let at = |step: f64| {
            let there = variation.changed_scene(scene, step)?;
            let numbers = self.kept_in(&there)?.numbers();
            let kinds = |of: &[f64]| of.iter().map(|number| number.is_nan()).collect::<Vec<_>>();
            (kinds(&numbers) == kinds(&self.numbers())).then_some(numbers)
        };
        let mut best: [(f64, Option<Vec<f64>>); 3] = [const { (f64::INFINITY, None) }; 3];
        let here = self.numbers();
        for h in STEPS.map(|steps| steps * variation.least) {
            let of = |sign: f64| [1.0, 2.0, 3.0, 4.0].map(|k| at(sign * k * h));
            let [left, right] = [of(-1.0), of(1.0)];
            let mut keep = |side: usize, found: Option<[Vec<f64>; 2]>| {
                let Some([fine, coarse]) = found else { return };
                let off = fine.iter().zip(&coarse).zip(sizes);
                let off = off.map(|((a, b), size)| (a - b).abs() / size).filter(|off| off.is_finite());
                let off = off.fold(0.0, f64::max);
                if off < best[side].0 {
                    best[side] = (off, Some(fine));
                }
            };
            keep(0, one_sided(&here, &left, -h));
            keep(2, one_sided(&here, &right, h));
            keep(1, central(&left, &right, h));
        }
        Sides(best.map(|(_, found)| found))
    }

    /// Converts a list of numbers to a derivative.
    fn of_numbers(&self, by: By, numbers: &[f64], one_sided: bool, missing: Option<Missing>) -> Derivative {
        let (supports, rest) = numbers.split_at(self.state.supports.len());
        let contact = |(of, five): (&crate::state::Contact, &[f64])| ContactDerivative {
            from: five[0],
            to: five[1],
            force: five[2],
            end_forces: of.end_forces.map(|_| [five[3], five[4]]),
        };
        let contacts: Vec<_> = self.listed.iter().zip(rest.chunks_exact(5)).map(contact).collect();
        let energy = rest.last().copied().unwrap_or(f64::NAN);
        let (contacts, contact_force) = self.of_pressing(&contacts);
        Derivative { by, one_sided, missing, supports: supports.to_vec(), contacts, contact_force, energy }
    }

    /// The additional derivatives of a general beam: with respect to steps, joints, elastic supports, couples and axial force.
    pub(super) fn variations_of_general_beam(&self, scene: &Scene) -> Vec<Variation> {
        let beam = scene.beam();
        let (length, bending) = (beam.length(), beam.bending_stiffness());
        let variation = |quantity, size: f64| {
            let change = [Change::Uniform(0.0); 2];
            Variation { by: By::Number(quantity), change, unit: 1.0, least: NOTHING * size }
        };
        let force = self.given.total_load * self.units.force;
        let mut all = Vec::new();
        let steps = beam.steps().iter().enumerate();
        all.extend(steps.map(|(i, step)| variation(Quantity::StepStiffness(i), step[1])));
        let joints = beam.joints().iter().enumerate();
        all.extend(joints.filter_map(|(i, joint)| Some(variation(Quantity::JointStiffness(i), joint.stiffness?))));
        for (i, support) in beam.supports_as_given().iter().enumerate() {
            all.extend(support.stiffness.map(|k| variation(Quantity::SupportStiffness(i), k)));
            all.extend(support.turning_stiffness.map(|k| variation(Quantity::SupportTurningStiffness(i), k)));
        }
        let couples = 0..scene.load().couple().len();
        all.extend(couples.map(|i| variation(Quantity::CoupleMoment(i), force * length)));
        let pull = beam.tension().abs().max(bending / length / length);
        all.extend((beam.tension() != 0.0).then(|| variation(Quantity::Tension, pull)));
        all
    }

    /// The derivatives with respect to the steps of the stiffness of an elastic foundation. A step to zero has none: as soon as it has a
    /// stiffness, the contacts change.
    pub(super) fn variations_of_foundation_steps(scene: &Scene) -> impl Iterator<Item = Variation> + '_ {
        let is_one = scene.ground_changes().next().is_none();
        let steps = scene.ground_steps().iter().enumerate().filter(move |(_, step)| !is_one && 0.0 < step[1]);
        let change = [Change::Stiffen; 2];
        steps.map(move |(i, step)| {
            let by = By::Number(Quantity::GroundStepStiffness(i));
            Variation { by, change, unit: 1.0, least: NOTHING * step[1] }
        })
    }
}

/// One-sided differences of fourth and of third order.
fn one_sided(here: &[f64], beside: &[Option<Vec<f64>>; 4], h: f64) -> Option<[Vec<f64>; 2]> {
    let [one, two, three, four] = beside.each_ref().map(Option::as_ref);
    let (one, two, three, four) = (one?, two?, three?, four?);
    let all = 0..here.len();
    let fine =
        |n: usize| (-25.0 * here[n] + 48.0 * one[n] - 36.0 * two[n] + 16.0 * three[n] - 3.0 * four[n]) / (12.0 * h);
    let coarse = |n: usize| (-11.0 * here[n] + 18.0 * one[n] - 9.0 * two[n] + 2.0 * three[n]) / (6.0 * h);
    Some([all.clone().map(fine).collect(), all.map(coarse).collect()])
}

/// Central differences of sixth and of fourth order.
fn central(left: &[Option<Vec<f64>>; 4], right: &[Option<Vec<f64>>; 4], h: f64) -> Option<[Vec<f64>; 2]> {
    let apart = |k: usize| {
        let (left, right) = (left[k].as_ref()?, right[k].as_ref()?);
        Some(right.iter().zip(left).map(|(right, left)| right - left).collect::<Vec<f64>>())
    };
    let [one, two, three] = [apart(0)?, apart(1)?, apart(2)?];
    let all = 0..one.len();
    let fine = |n: usize| (45.0 * one[n] - 9.0 * two[n] + three[n]) / (60.0 * h);
    let coarse = |n: usize| (8.0 * one[n] - two[n]) / (12.0 * h);
    Some([all.clone().map(fine).collect(), all.map(coarse).collect()])
}
