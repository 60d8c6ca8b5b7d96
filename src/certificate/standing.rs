//! Point loads that stand on supports, where these hold the beam: the supports carry them, and the beam is the same without them.
//!
//! All is proven of the beam on the other loads. What stands is added to the force of its support, and its work to the energy, so that
//! a load of `10¹³` on a support takes no digits from what the contacts exert:
//!
//! ```text
//! J(v) = J₀(v) − Σ P d_s,     R_s = R₀_s + Σ P
//! ```

use super::kernel::contact_node::EnclosedScene;
use super::kernel::interval::Interval;
use super::kernel::load::EnclosedLoad;
use crate::scene::{Load, Scene};

/// The loads of a dimensionless scene without those that its supports carry.
pub(super) fn between(scene: &Scene) -> EnclosedLoad {
    let mut load = EnclosedLoad::of(scene);
    load.points.retain(|(at, _)| !scene.beam().carries(*at));
    load
}

/// The loads that stand on supports, beside the others.
pub(super) struct Standing {
    /// All loads but those.
    pub(super) others: Load,
    /// The places of supports and what stands there.
    forces: Vec<(f64, Interval)>,
    /// `Σ P d_s`.
    work: Interval,
}

impl Standing {
    /// Those of all loads on supports that the enclosed scene does not have.
    pub(super) fn of(enclosed: &EnclosedScene<'_>, load: &Load) -> Self {
        let left_out = |at: f64| enclosed.load.points.binary_search_by(|point| point.0.total_cmp(&at)).is_err();
        let on = |at: f64| enclosed.support(at).filter(|_| left_out(at));
        let standing = load.point().iter().filter_map(|p| Some((on(p.at)?, Interval::exact(p.force))));
        let work = standing.clone().fold(Interval::ZERO, |sum, (support, force)| sum + force * support.deflection);
        let forces = standing.map(|(support, force)| (support.x, force)).collect();
        Self { others: load.without(|at| on(at).is_some()), forces, work }
    }

    /// The energy of the whole scene, from that on the other loads.
    pub(super) fn energy(&self, of_others: Interval) -> Interval {
        if self.forces.is_empty() { of_others } else { of_others - self.work }
    }

    /// The force of the support at a place, from that on the other loads.
    pub(super) fn force(&self, at: f64, of_others: Interval) -> Interval {
        let here = self.forces.iter().filter(|(x, _)| x.total_cmp(&at).is_eq());
        here.fold(of_others, |sum, (_, force)| sum + *force)
    }
}
