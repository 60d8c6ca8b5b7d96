//! Point loads that act directly on supports that hold the beam. The supports carry them, and the beam is the same without them.
//!
//! Everything is proven for the beam under the other loads. The loads on supports are added to the reactions, and their work to the
//! energy. So a load of `10¹³` on a support does not reduce the accuracy of the other forces:
//!
//! ```text
//! J(v) = J₀(v) − Σ P d_s,     R_s = R₀_s + Σ P
//! ```

use super::kernel::contact_node::EnclosedScene;
use super::kernel::interval::Interval;
use super::kernel::load::EnclosedLoad;
use crate::scene::{Load, Scene};

/// The loads of a dimensionless scene without the loads that its supports carry directly.
pub(super) fn between(scene: &Scene) -> EnclosedLoad {
    let mut load = EnclosedLoad::of(scene);
    load.points.retain(|(at, _)| !scene.beam().carries(*at));
    load
}

/// The loads that act directly on supports, separate from the others.
pub(super) struct Standing {
    /// All other loads.
    pub(super) others: Load,
    /// The positions of supports and the loads there.
    forces: Vec<(f64, Interval)>,
    /// `Σ P d_s`.
    work: Interval,
}

impl Standing {
    /// The loads on supports that the enclosed scene omits.
    pub(super) fn of(enclosed: &EnclosedScene<'_>, load: &Load) -> Self {
        let left_out = |at: f64| enclosed.load.points.binary_search_by(|point| point.0.total_cmp(&at)).is_err();
        let on = |at: f64| enclosed.support(at).filter(|_| left_out(at));
        let standing = load.point().iter().filter_map(|p| Some((on(p.at)?, Interval::exact(p.force))));
        let work = standing.clone().fold(Interval::ZERO, |sum, (support, force)| sum + force * support.deflection);
        let forces = standing.map(|(support, force)| (support.x, force)).collect();
        Self { others: load.without(|at| on(at).is_some()), forces, work }
    }

    /// The energy of the whole scene, from the energy under the other loads.
    pub(super) fn energy(&self, of_others: Interval) -> Interval {
        if self.forces.is_empty() { of_others } else { of_others - self.work }
    }

    /// The reaction of the support at a position, from the reaction under the other loads.
    pub(super) fn force(&self, at: f64, of_others: Interval) -> Interval {
        let here = self.forces.iter().filter(|(x, _)| x.total_cmp(&at).is_eq());
        here.fold(of_others, |sum, (_, force)| sum + *force)
    }
}
