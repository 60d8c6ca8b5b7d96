//! What the worst violations at nodes and supports amount to, with those of the beam as a whole.

use super::{Kkt, MOST, Recorded, largest};
use crate::scene::Scene;
use crate::state::ContactState;

impl Recorded<'_> {
    /// What the worst of each kind at nodes and at supports amounts to, with the equilibrium of the whole; `tangents` are those of the walk.
    pub(super) fn judged(
        &self,
        scene: &Scene,
        state: &ContactState,
        worst: [f64; 7],
        at_supports: [f64; 2],
        tangents: &[f64],
    ) -> Option<Kkt> {
        let ([force, depth], length) = (self.sizes(scene), scene.beam().length());
        let [penetration, tension, complementarity, elastic, bent, clearances, out_of_place] = worst;
        let [low, couples] = at_supports;
        let [foot, pushed, pressed, law] = self.of_springs([force, depth]);
        let turned = self.turned(tangents, [force, depth], length);
        // A mechanism that only rounding holds moves by far more than any beam: all else is little beside that.
        let moves = if !self.hinges.is_empty() && MOST * length < depth { f64::INFINITY } else { 0.0 };
        let [shear, remaining] = self.summed.left_over;
        let [left, right, mistaken_forces] = self.of_supports(scene, state)?;
        let balance = [shear, remaining / length, left, right].map(f64::abs);
        Some(Kkt {
            penetration: (penetration / depth).max(foot),
            tension: (tension / force).max(pushed),
            complementarity: complementarity.max(pressed),
            equilibrium: largest([elastic.max(low) / depth, largest(balance) / force, law, turned, moves]),
            record: largest([
                bent.max(couples) / (force * length),
                clearances / depth,
                out_of_place / length,
                mistaken_forces / force,
            ]),
        })
    }
}
