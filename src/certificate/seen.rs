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
            let (places, depths) = (&*places, &*depths);
            let (moments, deflections) = bent.along(first + 1, end - first);
            let [x, v, clearance, p, moment] =
                [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment]
                    .map(|list| &list[first..end]);
            seen.places.see_all(x.iter().zip(places).map(|(x, place)| (x - place).abs()));
            seen.moments.see_all(moment.iter().zip(moments).map(|(m, caused)| (m - caused * spacing).abs()));
            seen.elastic.see_all(v.iter().zip(deflections).map(|(v, caused)| (v - caused * spacing).abs()));
            seen.tension.see_all(p.iter().map(|p| -p));
            let clearances = depths.iter().zip(v).map(|(u, v)| u - v);
            seen.penetration.see_all(clearances.clone().map(|h| -h));
            let said = clearance.iter().zip(depths).zip(clearances.clone());
            seen.clearances.see_all(said.map(|((said, u), h)| mistaken(*said, *u, h)));
            for (h, p) in clearances.zip(p) {
                // Anything else is not positive, or no number, which the lines above see.
                if 0.0 < h && 0.0 < *p {
                    seen.complementarity.see((h / sizes[1]).min(p / sizes[0]));
                }
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
