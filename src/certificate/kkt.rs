//! The optimality conditions of a discrete problem as four dimensionless numbers, and a fifth for what is said beside them.

use super::carried::Carried;
use super::seen::Seen;
use super::worst::{Worst, worst};
use crate::scene::{Grid, Scene};
use crate::state::{ContactState, Reactions};

/// A state whose worst residual is at most this is certified.
///
/// Nodal contact forces differ from the optimum by up to `‖K‖` times the residual. With 30 intervals and the example of
/// the paper that is a factor of some 10³, so that 1e-9 in clearance leaves six digits of a nodal force, and more of every
/// integral quantity.
pub const CERTIFIED_RESIDUAL: f64 = 1e-9;

/// Rounding, as a share of what is certified: sixteen units in the last place of the largest length in the scene.
///
/// Contact forces are rounded numbers, and half a unit in the last place of each moves the beam by that share of the
/// deflection `P l³ / 48 EI` that all of them together would cause. Where the foundation lies so close that the beam moves
/// less than that, a smaller measure would judge the representation of numbers, not the answer.
const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

/// Violations of (4), (5), (8) by a state, all dimensionless.
///
/// Forces are measured by `P`, the sum of all loads or of all contact forces, whichever is larger; in a scene without
/// loads by the force `48 EI u / l³` that bends the beam to the ground. Lengths are measured by `D`, the largest deflection,
/// in a scene without loads not less than the way to the ground, and never by less than rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kkt {
    /// Feasibility: `max(v_i − u_i) / D`, the deepest penetration at a node.
    pub penetration: f64,
    /// Sign of the contact forces: `max(−p_i) / P`, the strongest tension.
    pub tension: f64,
    /// Complementarity: `max min(p_i / P, h_i / D)`, force across a clearance.
    pub complementarity: f64,
    /// Equilibrium and elasticity: the deflection that the contact forces cause, against that of the state, over `D`;
    /// and the balance of forces and of moments with the reactions, over `P`.
    pub equilibrium: f64,
    /// What the state says beside deflections and forces, against what follows from them: places over `l`, clearances over
    /// `D`, bending moments over `P l`.
    pub record: f64,
}

impl Kkt {
    /// Judges the nodal values of `state` in `scene`; `None` if the state has none, or not as many as it should.
    #[must_use]
    pub fn of(scene: &Scene, state: &ContactState) -> Option<Self> {
        let nodes = state.nodes.as_ref()?;
        let n = nodes.contact_force.len();
        let grid = Grid::uniform(scene, n + 1).ok()?;
        if [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.moment].iter().any(|list| list.len() != n) {
            return None;
        }
        let length = scene.beam().length();
        let flexibility = length * length * length / (48.0 * scene.beam().bending_stiffness());
        let carried = Carried::new(scene, grid, nodes);
        let idle = if carried.load == 0.0 { within_reach(&grid.depths(scene)) } else { 0.0 };
        let force = nonzero(carried.load.max(carried.contact).max(idle / flexibility));
        // Of the state alone: ground that the beam does not reach, however deep, must not loosen the measure.
        let depth = nonzero(carried.moved.value().max(idle).max(ROUNDING * flexibility * force));
        // Reactions that balance forces, and moments about the left support.
        let mut balance = Worst::default();
        let Reactions { left, right } = state.reactions;
        balance.see((carried.total - left - right).abs());
        balance.see((carried.right - right).abs());

        let bent = carried.bent(scene.beam().bending_stiffness());
        let seen = Seen::of(scene, &grid, nodes, bent, [force, depth]);
        Some(Self {
            penetration: seen.penetration.value() / depth,
            tension: seen.tension.value() / force,
            complementarity: seen.complementarity.value(),
            equilibrium: (seen.elastic.value() / depth).max(balance.value() / force),
            record: worst([
                seen.moments.value() / (force * length),
                seen.clearances.value() / depth,
                seen.places.value() / length,
            ]),
        })
    }

    /// The worst of the five; infinite if any of them is NaN.
    #[must_use]
    pub fn residual(&self) -> f64 {
        worst([self.penetration, self.tension, self.complementarity, self.equilibrium, self.record])
    }

    /// Whether the state passes.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.residual() <= CERTIFIED_RESIDUAL
    }
}

/// The way from the straight beam to the ground: the highest rise above the line of the supports, or else the least depth.
/// Zero where there is no ground.
fn within_reach(depths: &[f64]) -> f64 {
    let highest = depths.iter().copied().fold(f64::INFINITY, f64::min);
    if highest.is_finite() { highest.abs() } else { 0.0 }
}

/// A divisor: 1 where there is nothing to measure by.
fn nonzero(size: f64) -> f64 {
    if 0.0 < size { size } else { 1.0 }
}
