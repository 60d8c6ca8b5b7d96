//! The beam that contact forces from elsewhere bend, where statics does not say how: with supports that give, hinges or an axial force.
//!
//! It is what beam theory says of the same beam without its ground, with the forces as loads. Forces on an elastic foundation are spread as
//! those of its springs are. A support that gives exerts what its law gives: where nothing but it can press, a force that is given at its
//! place is compared with that, and bends nothing.
//! A beam that its supports do not hold touches the ground where some of the forces are, and those that equilibrium needs take their place.
//! Of the others the next is that which turns most about the nearest place that holds the beam.

use crate::certificate::{ContactLoad, Hung, Violation, ViolationKind, spread};
use crate::scene::{LinearLoad, Load, PointLoad, Scene, SceneError, Support, is_same_place};
use crate::theory::{self, Exact};

/// Forces that are farther from a law than this share of the loads violate it: rounding of some digits that were printed is none.
const ROUNDING: f64 = 1e-9;

/// What forces do to a beam.
#[derive(Debug)]
pub(crate) struct Caused {
    /// Its deflection, in the units of [`Scene::scaled`].
    pub(crate) curve: Vec<Hung>,
    /// Forces that are not those of supports that give, and those that are not in balance with the loads.
    pub(crate) violations: Vec<Violation>,
}

impl Caused {
    /// Of forces on the beam of a scene; [`None`] if they do not hold it.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] of a beam that an elastic foundation holds.
    pub(crate) fn of(scene: &Scene, forces: &ContactLoad) -> Result<Option<Self>, SceneError> {
        let mut given = Given::of(scene, forces);
        let solved = |given: &Given| {
            let bare = given.scene(scene, forces).ok()?;
            theory::solve(&bare).ok().filter(|exact| exact.solved)
        };
        let exact = loop {
            if let Some(exact) = solved(&given) {
                break exact;
            }
            if scene.ground_stiffness().is_some() && 0 < given.free_motions(scene) {
                let (what, feature) = ("a check of contact forces", "such a beam that an elastic foundation holds");
                return Err(SceneError::NotKnown { what, feature });
            }
            if !given.hold(scene) {
                return Ok(None);
            }
        };
        let scale = scene.scaled()?.scale;
        Ok(Some(Self { curve: exact.curve(&scale), violations: given.violations(scene, &exact).collect() }))
    }
}

/// The forces that are given, by what they are.
struct Given {
    /// Places and forces of what presses on the beam besides its supports.
    contacts: Vec<(f64, f64)>,
    /// Those at places where nothing but a support that gives can press.
    own: Vec<(f64, f64)>,
    /// Those that hold the beam.
    holding: Vec<(f64, f64)>,
    /// What it stands on: its supports but those that only push and do not give, and places of the ground.
    supports: Vec<Support>,
}

impl Given {
    fn of(scene: &Scene, forces: &ContactLoad) -> Self {
        let beam = scene.beam();
        let stands = |x: f64, support: &Support| is_same_place(support.at, x, beam.length());
        let is_own = |&(x, _): &(f64, f64)| scene.foundation().is_none() && beam.springs().iter().any(|s| stands(x, s));
        let (own, contacts) = forces.pressing.iter().copied().partition(is_own);
        let supports = beam.supports().iter().chain(beam.springs()).copied().collect();
        Self { contacts, own, holding: Vec::new(), supports }
    }

    /// In how many ways the beam may move without bending; under tension any place holds it.
    fn free_motions(&self, scene: &Scene) -> usize {
        let mut holding = self.supports.iter().filter(|support| !support.pushes_only);
        if 0.0 < scene.beam().tension() {
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
            let level = scene.gap(at) + beam.shape().map_or(0.0, |shape| shape.depth(at));
            if !level.is_finite() {
                continue;
            }
            self.supports.push(Support { level, ..Support::simple(at) });
            if self.free_motions(scene) < free {
                self.holding.push(self.contacts.remove(i));
                return true;
            }
            self.supports.pop();
        }
        false
    }

    /// The beam without its ground.
    fn scene(&self, scene: &Scene, forces: &ContactLoad) -> Result<Scene, SceneError> {
        let (beam, load) = (scene.beam().clone().with_supports(self.supports.clone())?, scene.load());
        let (mut linear, mut point) = (load.linear().to_vec(), load.point().to_vec());
        match scene.ground_stiffness() {
            Some(_) => {
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
            None => point.extend(self.contacts.iter().map(|&(at, force)| PointLoad { at, force: -force })),
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
