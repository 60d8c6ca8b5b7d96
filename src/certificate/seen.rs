//! What the judge sees node by node.

use super::carried::Deflection;
use super::worst::Worst;
use crate::scene::{Grid, Scene};
use crate::state::Nodes;

/// Nodes whose places and depths are taken from the scene together.
const BATCH: usize = 256;

/// The worst of each kind, in the units of the scene but for the complementarity.
#[derive(Debug, Default)]
pub(super) struct Seen {
    pub(super) penetration: Worst,
    pub(super) tension: Worst,
    pub(super) complementarity: Worst,
    pub(super) elastic: Worst,
    pub(super) clearances: Worst,
    pub(super) places: Worst,
}

impl Seen {
    /// One pass over the nodes of a state; `caused` is the deflection that its forces cause, `sizes` are those of forces and
    /// of depths.
    pub(super) fn of(scene: &Scene, grid: &Grid, nodes: &Nodes, caused: &Deflection, sizes: [f64; 2]) -> Self {
        let mut seen = Self::default();
        let (mut places, mut depths) = ([0.0; BATCH], [0.0; BATCH]);
        for first in (0..nodes.x.len()).step_by(BATCH) {
            let end = nodes.x.len().min(first + BATCH);
            let (places, depths) = (&mut places[..end - first], &mut depths[..end - first]);
            grid.places(first + 1, places);
            scene.depths(places, depths);
            let batch = places.iter().zip(depths).zip(caused.from(first + 1));
            let list = |list| {
                let list: &Vec<f64> = list;
                list[first..end].iter()
            };
            let state =
                list(&nodes.x).zip(list(&nodes.deflection)).zip(list(&nodes.clearance)).zip(list(&nodes.contact_force));
            for (((place, u), caused), (((x, v), said), p)) in batch.zip(state) {
                let h = *u - v;
                seen.penetration.see(-h);
                seen.tension.see(-p);
                // Anything else is not positive, or no number, which the lines around this one see.
                if 0.0 < h && 0.0 < *p {
                    seen.complementarity.see((h / sizes[1]).min(p / sizes[0]));
                }
                seen.elastic.see((v - caused).abs());
                seen.clearances.see(mistaken(*said, *u, h));
                seen.places.see((x - place).abs());
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
