//! The beam that contact forces from elsewhere bend, where statics does not say how: with supports that give, hinges or an axial force.
//!
//! It is what beam theory says of the same beam without its ground, with the forces as loads. Forces on an elastic foundation are spread as
//! those of its springs are. A support that gives exerts what its law gives: where nothing but it can press, a force that is given at its
//! place is compared with that, and bends nothing.
//! A beam that its supports do not hold touches the ground where some of the forces are, and those that equilibrium needs take their place.
//! Of the others the next is that which turns most about the nearest place that holds the beam.
//! On an elastic foundation it is held at places of forces, as deep as the springs that exert them are there, and what it presses on these
//! places besides is what equilibrium lacks.

use crate::certificate::{ContactLoad, Hung, Violation, ViolationKind, spread};
use crate::scene::{LinearLoad, Load, PointLoad, Scale, Scene, SceneError, Support, is_same_place};
use crate::theory::{self, Exact};

/// Forces that are farther from a law than this share of the loads violate it: rounding of some digits that were printed is none.
const ROUNDING: f64 = 1e-9;

/// Of what a beam without stops violates, this share is rounding: a thousandth of what a program prints forces with.
const NEARLY: f64 = 1e-6;

/// What forces do to a beam.
#[derive(Debug)]
pub(crate) struct Caused {
    /// Its deflection, in the units that were asked for.
    pub(crate) curve: Vec<Hung>,
    /// Forces that are not those of supports that give, and those that are not in balance with the loads.
    pub(crate) violations: Vec<Violation>,
}

impl Caused {
    /// Of forces on the beam of a scene, in these units; [`None`] if they do not hold it. Those on an elastic foundation are spread, or act at
    /// nodes.
    pub(crate) fn of(scene: &Scene, forces: &ContactLoad, units: &Scale, at_nodes: bool) -> Option<Self> {
        let mut given = Given::of(scene, forces, at_nodes);
        let solved = |given: &Given| {
            let bare = given.scene(scene, forces).ok()?;
            theory::solve(&bare).ok().filter(|exact| given.is_answer(exact) && given.is_held(scene, exact))
        };
        let mut exact = loop {
            if let Some(exact) = solved(&given) {
                break exact;
            }
            given.is_placed = scene.ground_stiffness().is_some();
            if !given.hold(scene) {
                return None;
            }
        };
        if given.is_placed
            && let Some(better) = given.place(scene, &exact, solved)
        {
            exact = better;
        }
        Some(Self { curve: exact.curve(units), violations: given.violations(scene, &exact).collect() })
    }
}

/// The forces that are given, by what they are.
#[derive(Debug, Clone)]
struct Given {
    /// Places and forces of what presses on the beam besides its supports.
    contacts: Vec<(f64, f64)>,
    /// Those at places where nothing but a support that gives can press.
    own: Vec<(f64, f64)>,
    /// Those that hold the beam.
    holding: Vec<(f64, f64)>,
    /// What it stands on: its supports but those that only push and do not give, and places of the ground.
    supports: Vec<Support>,
    /// Whether forces are spread.
    is_spread: bool,
    /// Places of an elastic foundation, and how deep below its surface the force there says that the beam is.
    sunk: Vec<(f64, f64)>,
    /// Whether these hold it. Under tension one place would be enough, and would leave it to what moments lack how the beam turns.
    is_placed: bool,
}

impl Given {
    fn of(scene: &Scene, forces: &ContactLoad, at_nodes: bool) -> Self {
        let beam = scene.beam();
        let stands = |x: f64, support: &Support| is_same_place(support.at, x, beam.length());
        let is_own = |&(x, _): &(f64, f64)| scene.foundation().is_none() && beam.springs().iter().any(|s| stands(x, s));
        let (own, contacts) = forces.pressing.iter().copied().partition(is_own);
        let supports = beam.supports().iter().chain(beam.springs()).copied().collect();
        let is_spread = scene.ground_stiffness().is_some() && !at_nodes;
        let soil = if scene.ground_stiffness().is_some() { spread::spread(scene, forces) } else { Vec::new() };
        let sunk =
            soil.iter().filter(|part| 0.0 < part.spring).map(|part| (part.x, part.force / part.spring)).collect();
        Self { contacts, own, holding: Vec::new(), supports, is_spread, sunk, is_placed: false }
    }

    /// Whether an answer is one. Without stops there is one beam alone: what it violates is rounding, of forces in balance with loads a large
    /// share of what supports have besides.
    fn is_answer(&self, exact: &Exact) -> bool {
        exact.solved || exact.residual <= NEARLY && !self.supports.iter().any(|support| support.pushes_only)
    }

    /// Whether its supports and the stops that it presses hold the beam in an answer: in balance but for rounding it may be anywhere.
    fn is_held(&self, scene: &Scene, exact: &Exact) -> bool {
        let length = scene.beam().length();
        let least = ROUNDING * scene.load().magnitude(length);
        let presses = |stop: &Support| {
            exact.state.supports.iter().any(|s| least < s.force && is_same_place(s.at, stop.at, length))
        };
        self.free_motions_on(scene, presses) == 0
    }

    /// In how many ways the beam may move without bending on what holds it both ways.
    fn free_motions(&self, scene: &Scene) -> usize {
        self.free_motions_on(scene, |_| false)
    }

    /// The same with the stops that are pressed; under tension any place holds it.
    fn free_motions_on(&self, scene: &Scene, presses: impl Fn(&Support) -> bool) -> usize {
        let mut holding = self.supports.iter().filter(|support| !support.pushes_only || presses(support));
        if 0.0 < scene.beam().tension() && !self.is_placed {
            return usize::from(holding.next().is_none());
        }
        scene.beam().free_motions(holding)
    }

    /// Takes the next place where the ground holds the beam; false if there is none.
    fn hold(&mut self, scene: &Scene) -> bool {
        let (beam, free) = (scene.beam(), self.free_motions(scene));
        let apart = |x: f64| {
            let holding = self.supports.iter().filter(|support| !support.pushes_only);
            holding.map(|support| (support.at - x).abs()).reduce(f64::min)
        };
        let mut next: Vec<(f64, usize)> = (0..self.contacts.len())
            .filter(|&i| !self.supports.iter().any(|s| is_same_place(s.at, self.contacts[i].0, beam.length())))
            .map(|i| (self.contacts[i].1 * apart(self.contacts[i].0).unwrap_or(1.0), i))
            .collect();
        next.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (_, i) in next {
            let at = self.contacts[i].0;
            let sunk = self.sunk.iter().find(|(x, _)| x.total_cmp(&at).is_eq()).map(|(_, sunk)| *sunk);
            let Some(sunk) = sunk.or((!self.is_placed).then_some(0.0)) else { continue };
            let level = scene.gap(at) + beam.shape().map_or(0.0, |shape| shape.depth(at)) + sunk;
            if !level.is_finite() {
                continue;
            }
            self.supports.push(Support { level, ..Support::simple(at) });
            if self.free_motions(scene) < free {
                // The springs go on to press; beside them nothing has to.
                self.holding.push(if self.is_placed { (at, 0.0) } else { self.contacts.remove(i) });
                return true;
            }
            self.supports.pop();
        }
        false
    }

    /// The beam as near to where all springs say that it is as its levels at the holding places can bring it, by least squares: these
    /// move what is free to move.
    fn place(&mut self, scene: &Scene, exact: &Exact, solved: impl Fn(&Self) -> Option<Exact>) -> Option<Exact> {
        let first = self.supports.len() - self.holding.len();
        let lacking = |exact: &Exact| -> Vec<f64> {
            self.sunk.iter().map(|(x, sunk)| scene.gap(*x) + sunk - exact.deflection(*x)).collect()
        };
        let unit = self.sunk.iter().fold(0.0, |most: f64, (_, sunk)| most.max(sunk.abs()));
        let here = lacking(exact);
        let mut columns = Vec::new();
        for i in first..self.supports.len() {
            let mut supports = self.supports.clone();
            supports[i].level += unit;
            let there = lacking(&solved(&Self { supports, ..self.clone() })?);
            columns.push(here.iter().zip(there).map(|(here, there)| here - there).collect::<Vec<f64>>());
        }
        for (i, steps) in least_squares(&columns, &here)?.into_iter().enumerate() {
            self.supports[first + i].level += steps * unit;
        }
        solved(self)
    }

    /// The beam without its ground.
    fn scene(&self, scene: &Scene, forces: &ContactLoad) -> Result<Scene, SceneError> {
        let (beam, load) = (scene.beam().clone().with_supports(self.supports.clone())?, scene.load());
        let (mut linear, mut point) = (load.linear().to_vec(), load.point().to_vec());
        match self.is_spread {
            true => {
                for part in spread::spread(scene, forces) {
                    let (x, half, force) = (part.x, 0.5 * part.width, part.force);
                    if part.width <= 0.0 {
                        point.push(PointLoad { at: x, force: -force });
                        continue;
                    }
                    let (start, end) = (-force / part.width, -force / part.width);
                    linear.push(LinearLoad {
                        from: (x - half).max(0.0),
                        to: (x + half).min(beam.length()),
                        start,
                        end,
                    });
                }
            }
            false => point.extend(self.contacts.iter().map(|&(at, force)| PointLoad { at, force: -force })),
        }
        let load = Load::new(&beam, load.uniform(), linear, point)?.with_couples(&beam, load.couple().to_vec())?;
        Scene::new(beam, load, None)
    }

    /// Forces that are not those of supports that give, and what is missing for balance.
    fn violations<'a>(&'a self, scene: &'a Scene, exact: &'a Exact) -> impl Iterator<Item = Violation> + 'a {
        let length = scene.beam().length();
        let all = scene.load().magnitude(length);
        let worst = move |rows: &'a [(f64, f64)], kind: ViolationKind| {
            let off = rows.iter().map(move |&(at, force)| {
                let here = exact.state.supports.iter().find(|support| is_same_place(support.at, at, length));
                let amount = (force - here.map_or(0.0, |support| support.force)).abs();
                Violation { kind, at, amount, relative: amount / all.max(force) }
            });
            off.max_by(|a, b| a.amount.total_cmp(&b.amount)).filter(|worst| ROUNDING < worst.relative)
        };
        let law = worst(&self.own, ViolationKind::SpringLaw);
        law.into_iter().chain(worst(&self.holding, ViolationKind::Balance))
    }
}

/// How much of each column is nearest to a vector: a few normal equations by elimination.
fn least_squares(columns: &[Vec<f64>], of: &[f64]) -> Option<Vec<f64>> {
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let row = |a: &Vec<f64>| columns.iter().map(|b| product(a, b)).chain([product(a, of)]).collect::<Vec<f64>>();
    let mut rows: Vec<Vec<f64>> = columns.iter().map(row).collect();
    for i in 0..rows.len() {
        let pivot = rows[i].clone();
        for row in rows.iter_mut().skip(i + 1) {
            let factor = row[i] / pivot[i];
            row.iter_mut().zip(&pivot).for_each(|(value, above)| *value -= factor * above);
        }
    }
    let mut found = vec![0.0; rows.len()];
    for (i, row) in rows.iter().enumerate().rev() {
        let right = row.last()? - product(&row[i + 1..columns.len()], &found[i + 1..]);
        found[i] = right / row[i];
    }
    found.iter().all(|steps| steps.is_finite()).then_some(found)
}
