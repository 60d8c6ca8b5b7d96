//! The deflection caused by given contact forces where statics alone does not determine it.
//!
//! These are beams on elastic supports, with hinges or under an axial force.
//!
//! Beam theory solves the same beam without its foundation, with the given forces as loads. On an elastic foundation the forces are
//! spread over the beam like the forces of its springs. An elastic support exerts the force of its own law. Where only an elastic
//! support can press, a force given at its position does not bend the beam: it is compared with the law of the support.
//!
//! If its supports do not hold the beam, some of the given forces become supports on the foundation, and equilibrium determines their
//! reactions. The next position to hold is the one whose force has the largest moment about the nearest position that is already
//! held.

use crate::certificate::{ContactLoad, Hung, Violation, ViolationKind, spread};
use crate::scene::{LinearLoad, Load, PointLoad, Scale, Scene, SceneError, Support, is_same_place};
use crate::theory::{self, Exact};

/// A force that deviates from its law by more than this share of the loads is a violation; a smaller deviation can be the rounding of
/// printed digits.
const ROUNDING: f64 = 1e-9;

/// The deflection that given contact forces cause, and the conditions that the forces violate.
#[derive(Debug)]
pub(crate) struct Caused {
    /// The deflection, in the units of the caller.
    pub(crate) curve: Vec<Hung>,
    /// Forces that deviate from the laws of elastic supports, and forces that are not in balance with the loads.
    pub(crate) violations: Vec<Violation>,
}

impl Caused {
    /// Solves the beam of a scene under given forces, in these units; [`None`] if they do not hold it. On an elastic foundation the
    /// forces are spread, unless they act at nodes (`at_nodes`).
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] for a beam that only an elastic foundation holds.
    pub(crate) fn of(
        scene: &Scene,
        forces: &ContactLoad,
        units: &Scale,
        at_nodes: bool,
    ) -> Result<Option<Self>, SceneError> {
        let mut given = Given::of(scene, forces, at_nodes);
        let solved = |given: &Given| {
            let bare = given.scene(scene, forces).ok()?;
            theory::solve(&bare).ok().filter(|exact| exact.solved && given.is_held(scene, exact))
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
        Ok(Some(Self { curve: exact.curve(units), violations: given.violations(scene, &exact).collect() }))
    }
}

/// The given forces, sorted by their cause.
struct Given {
    /// Positions and forces of the contacts that load the beam.
    contacts: Vec<(f64, f64)>,
    /// Forces at positions where only an elastic support can press.
    own: Vec<(f64, f64)>,
    /// Forces that the solution replaces by supports on the foundation.
    holding: Vec<(f64, f64)>,
    /// The supports of the beam, except rigid compression-only supports, and the positions held by the foundation.
    supports: Vec<Support>,
    /// Whether the forces are spread over the beam.
    is_spread: bool,
}

impl Given {
    fn of(scene: &Scene, forces: &ContactLoad, at_nodes: bool) -> Self {
        let beam = scene.beam();
        let stands = |x: f64, support: &Support| is_same_place(support.at, x, beam.length());
        let is_own = |&(x, _): &(f64, f64)| scene.foundation().is_none() && beam.springs().iter().any(|s| stands(x, s));
        let (own, contacts) = forces.pressing.iter().copied().partition(is_own);
        let supports = beam.supports().iter().chain(beam.springs()).copied().collect();
        let is_spread = scene.ground_stiffness().is_some() && !at_nodes;
        Self { contacts, own, holding: Vec::new(), supports, is_spread }
    }

    /// Whether the supports, with the compression-only supports that are pressed in `exact`, hold the beam. If they do not, its
    /// position is undetermined even where the loads balance to rounding.
    fn is_held(&self, scene: &Scene, exact: &Exact) -> bool {
        let length = scene.beam().length();
        let least = ROUNDING * scene.load().magnitude(length);
        let presses = |stop: &Support| {
            exact.state.supports.iter().any(|s| least < s.force && is_same_place(s.at, stop.at, length))
        };
        self.free_motions_on(scene, presses) == 0
    }

    /// The number of rigid-body motions that the two-way supports leave free.
    fn free_motions(&self, scene: &Scene) -> usize {
        self.free_motions_on(scene, |_| false)
    }

    /// The number of rigid-body motions left free when the supports for which `presses` is true hold as well. A beam in tension needs
    /// only one support of any kind.
    fn free_motions_on(&self, scene: &Scene, presses: impl Fn(&Support) -> bool) -> usize {
        let mut holding = self.supports.iter().filter(|support| !support.pushes_only || presses(support));
        if 0.0 < scene.beam().tension() {
            return usize::from(holding.next().is_none());
        }
        scene.beam().free_motions(holding)
    }

    /// Turns the next contact into a support on the foundation; false if no contact is left that helps.
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

    /// The beam without its foundation, with the contact forces as loads.
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

    /// The largest deviation from the law of an elastic support, and the largest force that equilibrium does not confirm.
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
