//! What the judge sees node by node.

use super::carried::{BATCH, Bent};
use super::worst::Worst;
use crate::scene::{Grid, Scene};
use crate::state::Nodes;

/// The worst of each kind, in the units of the scene but for the complementarity.
#[derive(Debug, Default)]
pub(super) struct Seen {
    pub(super) penetration: Worst,
    pub(super) tension: Worst,
    pub(super) complementarity: Worst,
    pub(super) elastic: Worst,
    pub(super) clearances: Worst,
    pub(super) places: Worst,
    pub(super) moments: Worst,
}

impl Seen {
    /// One pass over the nodes of a state beside the beam that its forces bend; `sizes` are those of forces and of depths.
    pub(super) fn of(scene: &Scene, grid: &Grid, nodes: &Nodes, mut bent: Bent<'_>, sizes: [f64; 2]) -> Self {
        let mut seen = Self::default();
        let spacing = grid.spacing();
        let mut room = [[0.0; BATCH]; 2];
        for first in (0..nodes.x.len()).step_by(BATCH) {
            let end = nodes.x.len().min(first + BATCH);
            let [places, depths] = room.each_mut().map(|room| &mut room[..end - first]);
            grid.places(first + 1, places);
            scene.depths(places, depths);
            let (moments, deflections) = bent.along(first + 1, end - first);
            let said = nodes.x[first..end].iter().zip(&nodes.moment[first..end]);
            for ((x, m), (place, moment)) in said.zip(places.iter().zip(moments)) {
                seen.places.see((x - place).abs());
                seen.moments.see((m - moment * spacing).abs());
            }
            let said = nodes.deflection[first..end].iter().zip(&nodes.clearance[first..end]);
            let said = said.zip(&nodes.contact_force[first..end]);
            for (((v, clearance), p), (u, caused)) in said.zip(depths.iter().zip(deflections)) {
                let h = u - v;
                seen.penetration.see(-h);
                seen.tension.see(-p);
                // Anything else is not positive, or no number, which the lines around this one see.
                if 0.0 < h && 0.0 < *p {
                    seen.complementarity.see((h / sizes[1]).min(p / sizes[0]));
                }
                seen.elastic.see((v - caused * spacing).abs());
                seen.clearances.see(mistaken(*clearance, *u, h));
            }
        }
        seen
    }
}

/// By how much a clearance is said wrong, beyond the rounding of the depth `u` that it was taken from.
fn mistaken(said: f64, u: f64, clearance: f64) -> f64 {
    // Where there is no foundation both are infinite.
    if u == f64::INFINITY && said == f64::INFINITY {
        return 0.0;
    }
    (said - clearance).abs() - 4.0 * f64::EPSILON * u.abs()
}
