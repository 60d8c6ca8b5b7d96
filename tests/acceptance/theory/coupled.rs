//! Couples on an elastic foundation beside something else: beside a step, a corner, a load, a support and an end, from a tenth of a unit to a
//! rounding apart. Each answer is certified, and each certified number is that of another description of the same beam: two opposite forces,
//! the mirror image, and finite elements.

use palkki::route::Status;
use palkki::scene::{Beam, CoupleLoad, Foundation, Load, PointLoad, Scene, Support};
use palkki::{Solution, solve_exactly};
use palkki_evidence::draft::Draft;
use palkki_evidence::elements::{Found, reference};

const LENGTH: f64 = 10.0;
const SOIL: f64 = 100.0;
const STEP: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [LENGTH, 1.0]];
const CORNER: [[f64; 2]; 4] = [[0.0, 0.3], [3.0, 0.0], [6.0, 0.1], [LENGTH, 0.3]];

/// Elements are no shorter: their stiffness grows with the third power.
const SHORTEST: f64 = 1e-5;

/// A beam on soil, with forces and couples.
#[derive(Debug, Clone)]
struct Coupled {
    ground: Vec<[f64; 2]>,
    supports: Vec<Support>,
    forces: Vec<(f64, f64)>,
    couples: Vec<(f64, f64)>,
}

impl Coupled {
    fn scene(&self) -> Scene {
        let beam =
            Beam::new(LENGTH, 1000.0).and_then(|beam| beam.with_supports(self.supports.clone())).expect("a beam");
        let points = self.forces.iter().map(|&(at, force)| PointLoad { at, force }).collect();
        let couples = self.couples.iter().map(|&(at, moment)| CoupleLoad { at, moment }).collect();
        let load = Load::new(&beam, 1.0, Vec::new(), points).and_then(|load| load.with_couples(&beam, couples));
        let ground = Foundation::Polyline { points: self.ground.clone() };
        Scene::above(beam, load.expect("a load"), Some(ground), Some(SOIL)).expect("a scene")
    }

    /// Seen from the other side.
    fn mirrored(&self) -> Self {
        Self {
            ground: self.ground.iter().rev().map(|p| [LENGTH - p[0], p[1]]).collect(),
            supports: self.supports.iter().rev().map(|s| Support { at: LENGTH - s.at, ..*s }).collect(),
            forces: self.forces.iter().map(|(x, force)| (LENGTH - x, *force)).collect(),
            couples: self.couples.iter().map(|(x, couple)| (LENGTH - x, -couple)).collect(),
        }
    }

    /// With two opposite forces for each couple.
    fn by_forces(&self, arm: f64) -> Self {
        let pair = |&(x, couple): &(f64, f64)| {
            let from = (x - 0.5 * arm).clamp(0.0, LENGTH - arm);
            [(from, -couple / arm), (from + arm, couple / arm)]
        };
        let forces = self.forces.iter().copied().chain(self.couples.iter().flat_map(pair)).collect();
        Self { forces, couples: Vec::new(), ..self.clone() }
    }
}

/// The numbers of a summary that are certified, with their brackets and a size of their kind.
fn numbers(solution: &Solution) -> Vec<(&'static str, f64, Option<[f64; 2]>, f64)> {
    let (state, certificate) = (&solution.state, solution.verdict.certificate.as_ref().expect("bounds"));
    let (moment, force) = (state.moment.max.max(-state.moment.min), LENGTH);
    let supports =
        state.supports.iter().zip(&certificate.reactions).map(|(s, bracket)| ("support", s.force, *bracket, force));
    let energies = [certificate.energy_lower, certificate.energy_upper];
    let others = [
        ("contact force", state.contact_force(), certificate.contact_force, force),
        ("energy", state.energy, Some(energies), state.energy.abs()),
        ("deflection", state.deflection.max, certificate.deflection_max, state.deflection.max.abs()),
        ("greatest moment", state.moment.max, certificate.moments[0], moment),
        ("least moment", state.moment.min, certificate.moments[1], moment),
    ];
    supports.chain(others).collect()
}

/// What is wrong with an answer.
fn wrong(coupled: &Coupled, apart: f64, for_elements: &Coupled) -> Vec<String> {
    /// What opposite forces at this distance are off by, and elements of a beam whose places are at most so far away.
    const ARM: f64 = 1e-4;
    const OTHERS: f64 = 1e-3;
    let elements = if SHORTEST < apart { 1e-5 } else { OTHERS };
    /// Of a mirror image, which is found in another order.
    const MIRRORED: f64 = 1e-9;
    // Over a short stretch between a couple and a step the pressure of the pair is a rounded difference over its length.
    let widest = if 1e-13 < apart { 1e-6 } else { 5e-5 };
    let solved = |coupled: &Coupled| solve_exactly(&coupled.scene()).map_err(|error| vec![error.to_string()]);
    let solutions = [coupled.clone(), coupled.mirrored(), coupled.by_forces(ARM)].map(|coupled| solved(&coupled));
    let [Ok(solution), Ok(mirrored), Ok(by_forces)] = solutions else {
        return solutions.into_iter().filter_map(Result::err).flatten().collect();
    };
    let mut wrong = Vec::new();
    if solution.verdict.status != Status::Certified {
        wrong.push(solution.verdict.to_string());
    }
    let mut other = numbers(&mirrored);
    let supports = other.len() - 5;
    other[..supports].reverse();
    for (((what, own, bracket, size), mirrored), by_forces) in
        numbers(&solution).into_iter().zip(other).zip(numbers(&by_forces))
    {
        let off = [(own - mirrored.1).abs() / size, (own - by_forces.1).abs() / size];
        if !(off[0] <= MIRRORED && off[1] <= OTHERS) {
            wrong.push(format!("{what}: {own}, mirrored {}, by forces {}", mirrored.1, by_forces.1));
        }
        let is_inside = |[least, most]: [f64; 2]| {
            least - 1e-12 * size <= own && own <= most + 1e-12 * size && most - least <= widest * size
        };
        if !bracket.is_some_and(is_inside) {
            wrong.push(format!("{what}: {own} in {bracket:?}"));
        }
    }
    let Found::Answer(found) = reference(&Draft::from(&for_elements.scene()).text()) else {
        return [wrong, vec!["elements go on".to_owned()]].concat();
    };
    let exact = solution.exact.as_ref().expect("functions");
    let deepest = solution.state.deflection.max.abs();
    let deflections = found.places.iter().zip(&found.numbers.deflections);
    let off = deflections.map(|(x, v)| (exact.deflection(*x) - v).abs()).fold(0.0, f64::max);
    let contact = found.numbers.contact;
    if !(off <= elements * deepest && (contact - solution.state.contact_force()).abs() <= elements * LENGTH) {
        wrong.push(format!("{off:e} off the elements, contact {contact}"));
    }
    wrong
}

/// Couples that turn either way beside something at 3, on both sides of it.
#[test]
fn couples_beside_something_are_certified() {
    let mut lost = Vec::new();
    let mut count = 0;
    let free = |ground: [[f64; 2]; 4]| Coupled {
        ground: ground.to_vec(),
        supports: Vec::new(),
        forces: Vec::new(),
        couples: Vec::new(),
    };
    let scenes = |apart: f64, side: f64, turns: f64| {
        let couples = vec![(3.0 + side * apart, turns)];
        let support = vec![Support::simple(3.0).at_level(-0.01)];
        let end = if side < 0.0 { apart } else { LENGTH - apart };
        [
            ("a step", Coupled { couples: couples.clone(), ..free(STEP) }),
            ("a corner", Coupled { couples: couples.clone(), ..free(CORNER) }),
            ("a load", Coupled { couples: couples.clone(), forces: vec![(3.0, 3.0)], ..free(CORNER) }),
            ("a support", Coupled { couples: couples.clone(), supports: support, ..free(CORNER) }),
            ("another couple", Coupled { couples: [couples, vec![(3.0, 1.0)]].concat(), ..free(CORNER) }),
            ("an end", Coupled { couples: vec![(end, 2.0)], ..free(STEP) }),
        ]
    };
    for (k, apart) in (0_u8..32).map(|k| (k, libm::pow(10.0, -1.0 - 0.47 * f64::from(k)))) {
        for side in [-1.0, 1.0] {
            let turns = if k % 2 == 0 { 2.0 } else { -2.0 };
            let for_elements = scenes(apart.max(SHORTEST), side, turns);
            for ((what, coupled), (_, other)) in scenes(apart, side, turns).into_iter().zip(for_elements) {
                count += 1;
                let wrong = wrong(&coupled, apart, &other);
                lost.extend(wrong.into_iter().map(|why| format!("{what}, {side} {apart:e}: {why}")));
            }
        }
    }
    assert!(lost.is_empty(), "{} of {count}: {lost:#?}", lost.len());
}
