//! The reference: two meshes of different nodes, each refined where contact begins and ends. What they differ by is what the reference may be off by.

use super::mesh::{Mesh, RIGID};
use super::problem::Problem;

/// What is compared: forces, energy, and values at places.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbers {
    /// Of the supports from left to right, upwards \[force\].
    pub supports: Vec<f64>,
    /// Of the ground in total, upwards \[force\].
    pub contact: f64,
    /// Energy \[force · length\].
    pub energy: f64,
    /// Deflections at the places, positive downwards \[length\].
    pub deflections: Vec<f64>,
    /// Bending moments there, positive with the underside in tension; [`None`] where finite elements do not tell, beside contact with rigid ground
    /// \[force · length\].
    pub moments: Vec<Option<f64>>,
    /// Of the beam \[length\].
    pub length: f64,
}

/// Shares by which forces, deflections, energy and moments differ, each of the largest of its kind.
pub type Shares = [f64; 4];

impl Numbers {
    /// How far other numbers of the same case are from these.
    #[must_use]
    pub fn apart(&self, other: &Self) -> Shares {
        const ROUNDING: f64 = 1e-9;
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, value| most.max(value.abs()));
        let apart = |a: &[f64], b: &[f64]| most(&mut a.iter().zip(b).map(|(a, b)| a - b));
        let size = |values: &[f64]| most(&mut values.iter().copied());
        let both = self.moments.iter().zip(&other.moments).filter_map(|(a, b)| a.zip(*b));
        // Moments that are none, compared where the beam has no others, are rounding of forces.
        let least = ROUNDING * self.length * size(&self.supports).max(self.contact.abs());
        let moments = [most(&mut both.clone().map(|(a, b)| a - b)), most(&mut both.map(|(a, _)| a)).max(least)];
        let forces = apart(&self.supports, &other.supports).max((self.contact - other.contact).abs());
        let share = |off: f64, size: f64| if off == 0.0 { 0.0 } else { off / size };
        [
            share(forces, size(&self.supports).max(self.contact.abs())),
            share(apart(&self.deflections, &other.deflections), size(&self.deflections)),
            share((self.energy - other.energy).abs(), self.energy.abs()),
            share(moments[0], moments[1]),
        ]
    }
}

/// What finite elements find.
#[derive(Debug, Clone)]
pub struct Reference {
    /// Where deflections and moments are told \[length\].
    pub places: Vec<f64>,
    /// On the second, finer mesh.
    pub numbers: Numbers,
    /// By how much both meshes differ, and what they have in common.
    pub estimate: Shares,
}

/// What became of a case.
#[derive(Debug, Clone)]
pub enum Found {
    /// An answer.
    Answer(Box<Reference>),
    /// No place of the ground or the supports balances the loads, or rigid ground stands above a support.
    NoAnswer,
    /// The springs did not settle.
    Unsettled,
}

/// How fine a mesh is.
struct Fineness {
    /// Longest element at first, as a share of the beam.
    spacing: f64,
    /// Fewest elements from one place to the next at first.
    least: f64,
    /// Where an element is cut, as a share of it.
    cut: f64,
    /// How often, at most.
    levels: u32,
    /// What the beam may be below rigid ground, as a share of the range of its deflections.
    below: f64,
}

impl Fineness {
    /// Of the first mesh and of the second, of which the first is coarser by far: nearly all that they differ by is its error. *Tuned* on
    /// the families, so that they differ by some 1e-5, or by 1e-4 beside a support whose ground holds the slope, in acceptable time.
    fn of_both(problem: &Problem) -> [Self; 2] {
        let soil = problem.hardest_soil();
        // Lengths of an element over that on which a beam on soil decays, (4EI/k)^¼.
        let decay = soil.map_or(0.0, |soil| (0.25 * soil).sqrt().sqrt());
        let lengths = if decay < 300.0 { [0.1, 0.06] } else { [0.3, 0.18] };
        let levels = match soil {
            Some(_) => [6, 9],
            None if problem.has_few_places() => [14, 18],
            None => [10, 14],
        };
        let below = if problem.has_few_places() { [1e-11, 1e-12] } else { [1e-8, 1e-9] };
        let least = if soil.is_some() { [1.0, 2.0] } else { [1.0; 2] };
        // A rope bends over √(EI/N) beside what carries it: *tuned* to an energy that both meshes have to 1e-6.
        let rope = [8.0, 12.0].map(|parts| parts * problem.tension.abs().sqrt());
        let (parts, cuts) = ([32.0, 50.0], [0.5, 0.45]);
        [0, 1].map(|mesh| Self {
            spacing: 1.0 / f64::max(parts[mesh], decay / lengths[mesh]).max(rope[mesh]),
            least: least[mesh],
            cut: cuts[mesh],
            levels: levels[mesh],
            below: below[mesh],
        })
    }
}

/// The answer to a scene file by finite elements.
#[must_use]
pub fn reference(text: &str) -> Found {
    let problem = Problem::read(text);
    if problem.contradicts() {
        return Found::NoAnswer;
    }
    let [coarse, fine] = Fineness::of_both(&problem);
    let mut first = Mesh::new(&problem, coarse.spacing, coarse.least);
    // From soft springs to stiff ones, since those that press are found more easily on soft ones.
    if ![1e3, 1e6, 1e9, 1e12, RIGID].into_iter().all(|most| first.settle(most)) {
        return Found::Unsettled;
    }
    if !first.is_held() {
        return Found::NoAnswer;
    }
    let mut second = Mesh::new(&problem, fine.spacing, fine.least);
    second.start_from(&first);
    if !(refined(&mut first, &coarse) && refined(&mut second, &fine)) {
        return Found::Unsettled;
    }
    let [coarse, numbers] = [first, second].map(|mesh| mesh.numbers());
    let places = problem.places.iter().map(|place| place * problem.length()).collect();
    let mut estimate = numbers.apart(&coarse);
    if !problem.is_on_soil() && !problem.has_few_places() {
        estimate[3] += SHORT_ZONES;
    }
    Found::Answer(Box::new(Reference { places, estimate, numbers }))
}

/// A node in a short zone of contact with rigid ground has a moment that the true beam has not, in both meshes. A share of the largest
/// moment, *tuned* on the pipes on rock, where 8e-3 was found.
const SHORT_ZONES: f64 = 1e-2;

/// Whether a mesh settles wherever it is cut.
fn refined(mesh: &mut Mesh<'_>, fineness: &Fineness) -> bool {
    for _ in 0..fineness.levels {
        if !mesh.settle(RIGID) {
            return false;
        }
        if !mesh.refine(fineness.cut, fineness.below) {
            return true;
        }
    }
    mesh.settle(RIGID)
}
