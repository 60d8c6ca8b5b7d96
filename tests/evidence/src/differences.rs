//! Derivatives of exact answers beside differences of answers, over steps of one length and of twice that.

use palkki::scene::{Quantity, Scene};
use palkki::theory::{self, By, Derivative, Exact};

use crate::random;

/// What became of the derivatives of some scenes.
#[derive(Debug, Clone, Default)]
pub struct Trial {
    /// Scenes with an answer.
    pub scenes: usize,
    /// Derivatives by one number that hold on both sides, and agree with differences there.
    pub both: usize,
    /// Those that are said to hold on one side, and do.
    pub one: usize,
    /// Of these, those that hold on both.
    pub cautious: usize,
    /// Those that are said not to be there.
    pub none: usize,
    /// Those with which no difference can be compared: a scene beside this one is refused, or has no answer.
    pub alone: usize,
    /// What is wrong.
    pub wrong: Vec<String>,
}

/// Lengths of steps, as shares of the size of the number: too long a step bends or leaves the kind, too short a one rounds.
const STEPS: [f64; 6] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];

/// What a derivative may differ by from a difference, relative to its size: what is left of rounding over the shorter steps.
const WITHIN: f64 = 1e-4;

/// The random scene of that index, one of three dice.
#[must_use]
pub fn drawn(i: u64) -> Scene {
    match i % 4 {
        0 => random::held(i),
        1 => random::scene(i),
        _ => random::coinciding(i),
    }
}

impl Trial {
    /// Adds the random scene of that index, one of three dice.
    pub fn add(&mut self, i: u64) {
        self.compare(&format!("scene {i}"), &drawn(i));
    }

    /// Adds a scene.
    pub fn compare(&mut self, name: &str, scene: &Scene) {
        let Some(exact) = theory::solve(scene).ok().filter(|exact| exact.solved) else { return };
        self.scenes += 1;
        let all = exact.derivatives(scene);
        // EI ∂J/∂EI.
        let by_stiffness = all.iter().find(|derivative| derivative.by == By::Number(Quantity::BendingStiffness));
        let strain_energy = by_stiffness.map_or(f64::NAN, |by| by.energy * scene.beam().bending_stiffness());
        for derivative in &all {
            let found = Difference { scene, exact: &exact, derivative, strain_energy };
            if derivative.missing.is_some() {
                self.none += 1;
                continue;
            }
            let central = found.central();
            if !derivative.one_sided {
                match central {
                    None => self.alone += 1,
                    Some(true) => self.both += 1,
                    Some(false) => {
                        self.wrong.push(format!("{name}, two-sided, by {}: {}", derivative.by, found.shown()))
                    }
                }
                continue;
            }
            let sides = [-1.0, 1.0].map(|side| found.beside(side));
            let holds = sides.contains(&Some(true));
            if holds || sides == [None; 2] {
                self.one += usize::from(holds);
                self.alone += usize::from(!holds);
                self.cautious += usize::from(central == Some(true));
            } else {
                self.wrong.push(format!("{name}, one-sided, by {}: {}", derivative.by, found.shown()));
            }
        }
    }
}

/// A derivative beside differences.
struct Difference<'a> {
    scene: &'a Scene,
    exact: &'a Exact,
    derivative: &'a Derivative,
    /// `½∫EI v''²`.
    strain_energy: f64,
}

impl Difference<'_> {
    /// The size of the number, of which steps are a small part.
    fn size(&self) -> f64 {
        let length = self.scene.beam().length();
        let load = self.scene.load().magnitude(length);
        match self.derivative.by {
            By::Number(Quantity::BendingStiffness) => self.scene.beam().bending_stiffness(),
            By::Number(Quantity::GroundStiffness) => self.scene.ground_stiffness().unwrap_or(f64::NAN),
            By::Number(Quantity::Uniform) => load / length,
            By::Number(Quantity::PointForce(_)) => load,
            By::Depth | By::Number(Quantity::SupportLevel(_)) => {
                let deflection = &self.exact.state.deflection;
                deflection.max.abs().max(deflection.min.abs()).max(1e-9)
            }
            By::Number(Quantity::CoupleMoment(_)) => load * length,
            By::Number(Quantity::Tension) => {
                self.scene.beam().tension().abs().max(self.scene.beam().bending_stiffness() / length / length)
            }
            By::Number(
                quantity @ (Quantity::StepStiffness(_)
                | Quantity::JointStiffness(_)
                | Quantity::SupportStiffness(_)
                | Quantity::SupportTurningStiffness(_)),
            ) => self.scene.number(quantity).unwrap_or(f64::NAN),
            By::Number(_) => length,
        }
    }

    /// Lengths of steps: parts of the size of the number, and of what changes one of the numbers of the answer by its own size, if that is
    /// less. What is rounding beside its terms says nothing of that.
    fn steps(&self) -> Vec<f64> {
        const TOLD: f64 = 1e-6;
        let numbers = values(self.exact).into_iter().zip(self.ours()).zip(self.scale());
        let told = numbers.filter(|((now, by), scale)| TOLD * scale <= now.abs() && 0.0 < by.abs());
        let own = told.fold(self.size(), |least, ((now, by), _)| least.min((now / by).abs()));
        let sizes = [Some(self.size()), Some(own).filter(|own| *own < self.size())];
        sizes.into_iter().flatten().flat_map(|size| STEPS.map(|step| step * size)).collect()
    }

    /// The answer some way off, if it has as many contacts of the same kinds; [`Err`] if there is none.
    fn at(&self, step: f64) -> Result<Option<Vec<f64>>, ()> {
        let scene = match self.derivative.by {
            By::Depth => self.scene.with_ground_moved(step),
            By::Number(quantity) => self.scene.with_number(quantity, self.scene.number(quantity).ok_or(())? + step),
        };
        let answer = theory::solve(&scene.map_err(|_| ())?).ok().filter(|answer| answer.solved).ok_or(())?;
        let kinds = |exact: &Exact| exact.state.contacts.iter().map(|c| c.end_forces.is_some()).collect::<Vec<_>>();
        Ok((kinds(&answer) == kinds(self.exact)).then(|| values(&answer)))
    }

    /// True where differences are the derivative; [`None`] where no answer is beside this one.
    fn agrees(&self, weights: &[(f64, f64)]) -> Option<bool> {
        let mut tried = None;
        for step in self.steps() {
            let at: Result<Vec<_>, ()> = weights.iter().map(|(at, _)| self.at(at * step)).collect();
            let Ok(at) = at else { continue };
            let mut differences = vec![0.0; self.scale().len()];
            let alike = at.into_iter().zip(weights).all(|(values, (_, weight))| {
                let add = |values: Vec<f64>| {
                    differences.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value / step);
                };
                values.map(add).is_some()
            });
            let close = |((difference, ours), scale): ((&f64, f64), f64)| {
                (difference - ours).abs() <= WITHIN * (difference.abs() + scale / self.size())
            };
            if alike && differences.iter().zip(self.ours()).zip(self.scale()).all(close) {
                return Some(true);
            }
            tried = Some(false);
        }
        tried
    }

    /// Differences on both sides: `(8 (f(h) − f(−h)) − f(2h) + f(−2h)) / 12 h`, right to the fourth order.
    fn central(&self) -> Option<bool> {
        self.agrees(&[(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)])
    }

    /// Differences on one side: `(4 f(h) − 3 f(0) − f(2h)) / 2 h`, right to the second order.
    fn beside(&self, side: f64) -> Option<bool> {
        self.agrees(&[(0.0, -1.5 * side), (side, 2.0 * side), (2.0 * side, -0.5 * side)])
    }

    fn ours(&self) -> Vec<f64> {
        let Derivative { supports, contacts, energy, .. } = self.derivative;
        let contacts = contacts.iter().flat_map(|c| {
            let [from, to] = c.end_forces.unwrap_or_default();
            [c.from, c.to, c.force, from, to]
        });
        supports.iter().copied().chain(contacts).chain([*energy]).collect()
    }

    /// What rounding is compared with: forces with the loads and the shear forces beside, since where supports hold a beam down these
    /// are larger; the energy with the strain energy and the work of the loads, since it is the difference of both.
    fn scale(&self) -> Vec<f64> {
        let length = self.scene.beam().length();
        let load = self.scene.load().magnitude(length);
        let Exact { state, .. } = self.exact;
        let beside = |x: f64| self.exact.shear(x).into_iter().fold(load, |most, shear| most.max(shear.abs()));
        let forces = state.supports.iter().map(|support| beside(support.at));
        let contacts = state.contacts.iter().flat_map(|c| {
            let [from, to] = [beside(c.from), beside(c.to)];
            [length, length, from.max(to), from, to]
        });
        let (strain, energy) = (self.strain_energy, state.energy);
        // Not a number where that derivative is missing.
        let energy = strain.abs().max((strain - energy).abs()).max(energy.abs());
        forces.chain(contacts).chain([energy]).collect()
    }

    fn shown(&self) -> String {
        let step = STEPS[3] * self.size();
        let of = |side: f64| {
            let (near, here) = (self.at(side * step).ok().flatten(), values(self.exact));
            near.map(|near| near.iter().zip(&here).map(|(n, h)| side * (n - h) / step).collect::<Vec<_>>())
        };
        format!("{:?} for {:?} and {:?}\n{:#?}", self.ours(), of(-1.0), of(1.0), self.scene)
    }
}

/// Forces of supports; places, forces and end forces of contacts; the energy.
fn values(exact: &Exact) -> Vec<f64> {
    let supports = exact.state.supports.iter().map(|support| support.force);
    let contacts = exact.state.contacts.iter().flat_map(|c| {
        let [from, to] = c.end_forces.unwrap_or_default();
        [c.from, c.to, c.force, from, to]
    });
    supports.chain(contacts).chain([exact.state.energy]).collect()
}
