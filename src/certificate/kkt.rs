//! The residual of a discrete problem: how far nodal values are from (4), (5) and (8), as five dimensionless numbers.
//!
//! Loads and contact forces on the nodes bend the beam from support to support ([`NodalBeam`]): no method and no solver is asked.
//! A beam that its supports do not hold is held by two nodes with the deflections of the state, its support and the nodes that
//! press most: what balance asks of these takes the place of their contact forces, and the difference is one of equilibrium.

use super::nodal_beam::{self, NodalBeam, Station};
use crate::scene::{Grid, Held, Scene, is_same_place};
use crate::state::{ContactState, Nodes, Reactions, SupportForce};

/// Nodes that are compared together: few enough for the nearest cache.
const BATCH: usize = 256;

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
    /// Judges the nodal values of `state` in `scene`; [`None`] if the state has none, or if its nodes are not those of a grid with
    /// all supports among them: all nodes but the ends of the beam that have a support.
    #[must_use]
    pub fn of(scene: &Scene, state: &ContactState) -> Option<Self> {
        let bent = BentBeam::of(scene, state)?;
        let BentBeam { nodes, grid, first, ref stations, ref said, ref beam, .. } = bent;
        let (x, v, h, p, moment) = (&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment);
        let [force, depth] = bent.sizes(scene);

        let (mut places, mut depths) = ([0.0; BATCH], [0.0; BATCH]);
        let mut worst = [0.0; 7];
        let mut compare = |node: usize, caused_moment: &[f64], caused_deflection: &[f64]| {
            let (places, u) = (&mut places[..caused_moment.len()], &mut depths[..caused_moment.len()]);
            grid.places(node, places);
            scene.gaps(places, u);
            let rows = (0..places.len()).map(|k| {
                let i = node - first + k;
                let clearance = u[k] - v[i];
                [
                    -clearance,
                    -p[i],
                    (clearance / depth).min(p[i] / force),
                    (v[i] - caused_deflection[k]).abs(),
                    (moment[i] - caused_moment[k]).abs(),
                    mistaken(h[i], u[k], clearance),
                    (x[i] - places[k]).abs(),
                ]
            });
            worst = largest_each(worst, rows);
        };
        beam.walk(&mut compare);
        // Beside a support in which the beam is built in either moment will do.
        let nearer =
            |said: f64, [left, right]: [f64; 2]| if (said - left).abs() < (said - right).abs() { left } else { right };
        for (station, (_, moments)) in stations.iter().zip(&beam.stations) {
            if let Some(&said) = station.node.checked_sub(first).and_then(|i| moment.get(i)) {
                compare(station.node, &[nearer(said, *moments)], &[station.deflection]);
            }
        }
        let [penetration, tension, complementarity, elastic, moments, clearances, out_of_place] = worst;
        let balance = bent.exerted.iter().zip(&beam.stations).map(|(said, (force, _))| said - force);
        let Reactions { left, right } = state.reactions;
        let said_at = |node: usize| stations.iter().zip(said).find(|(station, _)| station.node == node)?.1.as_ref();
        let ends = [(0, left), (grid.intervals(), right)]
            .map(|(node, reaction)| reaction - said_at(node).map_or(0.0, |said| said.force));
        let couples = said.iter().zip(&beam.stations).filter_map(|(said, (_, moments))| {
            let said = said.as_ref()?.moment?;
            Some((said - nearer(said, *moments)).abs())
        });
        Some(Self {
            penetration: penetration / depth,
            tension: tension / force,
            complementarity,
            equilibrium: largest([elastic / depth, largest(balance.chain(ends).map(f64::abs)) / force]),
            record: largest([
                moments.max(largest(couples)) / (force * scene.beam().length()),
                clearances / depth,
                out_of_place / scene.beam().length(),
            ]),
        })
    }

    /// The worst of the five; infinite if any of them is NaN.
    #[must_use]
    pub fn residual(&self) -> f64 {
        largest([self.penetration, self.tension, self.complementarity, self.equilibrium, self.record])
    }

    /// Whether the state passes.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.residual() <= CERTIFIED_RESIDUAL
    }
}

/// The beam that the loads and the contact forces of a state bend, beside what the state says.
struct BentBeam<'a> {
    nodes: &'a Nodes,
    grid: Grid,
    /// The node of the grid that is the first of the state.
    first: usize,
    stations: Vec<Station>,
    /// What the state says of the support at each station, where there is one, and of the force that holds the beam there.
    said: Vec<Option<SupportForce>>,
    exerted: Vec<f64>,
    beam: NodalBeam,
    /// Sums of the magnitudes of all loads and of all contact forces \[force\].
    load: f64,
    contact: f64,
}

impl<'a> BentBeam<'a> {
    /// [`None`] if the nodes of the state are not those of a grid with all supports among them, or if the state does not say of
    /// each support what it exerts.
    fn of(scene: &Scene, state: &'a ContactState) -> Option<Self> {
        let nodes = state.nodes.as_ref()?;
        let p = &nodes.contact_force;
        if [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.moment].iter().any(|list| list.len() != p.len()) {
            return None;
        }
        let (held, length) = (scene.held(), scene.beam().length());
        let [left, right] = [0.0, length].map(|end| usize::from(held.iter().any(|s| is_same_place(s.at, end, length))));
        let (grid, first) = (Grid::uniform(scene, (p.len() + left + right).checked_sub(1)?).ok()?, left);
        let mut stations = nodal_beam::supports(&grid, &held)?;
        let supports: Vec<SupportForce> =
            held.iter().map(|held| said_of(state, held, length)).collect::<Option<_>>()?;
        nodal_beam::stand(&mut stations, first, p, &nodes.deflection);

        let mut forces = grid.nodal_loads(scene.load());
        let [load, contact] = [&forces, p].map(|forces| forces.iter().map(|force| force.abs()).sum::<f64>());
        forces[first..].iter_mut().zip(p).for_each(|(q, p)| *q -= p);
        let said_at = |station: &Station| {
            let mut supports = held.iter().zip(&supports);
            supports.find(|(held, _)| grid.node_at(held.at) == Some(station.node)).map(|(_, said)| *said)
        };
        let said: Vec<Option<SupportForce>> = stations.iter().map(said_at).collect();
        // What presses at a station counts as what it exerts.
        let mut exerted = Vec::with_capacity(stations.len());
        for (&Station { node, .. }, said) in stations.iter().zip(&said) {
            exerted.push(if let Some(said) = said {
                said.force
            } else {
                grid.loads(scene.load(), node, &mut forces[node..=node]);
                p[node - first]
            });
        }
        let beam = NodalBeam::of(scene, grid, forces, &stations, nodes.discretisation)?;
        Some(Self { nodes, grid, first, stations, said, exerted, beam, load, contact })
    }

    /// `P` and `D`, by which forces and lengths are measured.
    fn sizes(&self, scene: &Scene) -> [f64; 2] {
        let length = scene.beam().length();
        let flexibility = length * length * length / (48.0 * scene.beam().bending_stiffness());
        let deepest = largest(self.nodes.deflection.iter().map(|v| v.abs()));
        let idle = if self.load == 0.0 {
            within_reach(&self.grid.gaps_at(scene, self.first..self.first + self.nodes.x.len())).max(deepest)
        } else {
            0.0
        };
        let force = nonzero(self.load.max(self.contact).max(idle / flexibility));
        // Of the state alone: ground that the beam does not reach, however deep, must not loosen the measure.
        [force, nonzero(deepest.max(idle).max(ROUNDING * flexibility * force))]
    }
}

/// The largest of some numbers, at least 0; infinite if one of them is NaN.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    largest_each([0.0], values.into_iter().map(|value| [value]))[0]
}

/// The same of each column of a table, of which the upper part has been seen.
fn largest_each<const COLUMNS: usize>(
    mut most: [f64; COLUMNS],
    rows: impl Iterator<Item = [f64; COLUMNS]>,
) -> [f64; COLUMNS] {
    let mut unknown = [false; COLUMNS];
    for row in rows {
        for ((most, unknown), value) in most.iter_mut().zip(&mut unknown).zip(row) {
            // Not `max`: a comparison is all that a number needs.
            *most = if *most < value { value } else { *most };
            *unknown |= value.is_nan();
        }
    }
    most.iter_mut().zip(unknown).filter(|(_, unknown)| *unknown).for_each(|(most, _)| *most = f64::INFINITY);
    most
}

/// By how much a clearance is said wrong, beyond the rounding of the depth `u` that it was taken from.
fn mistaken(said: f64, u: f64, clearance: f64) -> f64 {
    // Where there is no foundation both are infinite.
    if u == f64::INFINITY && said == f64::INFINITY {
        return 0.0;
    }
    (said - clearance).abs() - 4.0 * f64::EPSILON * u.abs()
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

/// What a state says of a support; [`None`] if nothing, or no moment where the beam is built in.
fn said_of(state: &ContactState, held: &Held, length: f64) -> Option<SupportForce> {
    let said = state.supports.iter().find(|said| is_same_place(said.at, held.at, length))?;
    (said.moment.is_some() == held.slope.is_some()).then_some(*said)
}

#[cfg(test)]
mod tests {
    use super::largest;

    #[test]
    fn nan_is_the_largest_wherever_it_stands() {
        assert_eq!(largest([-1.0, -2.0]).to_bits(), 0.0_f64.to_bits(), "at least zero");
        assert_eq!(largest([1.0, 3.0, 2.0]).to_bits(), 3.0_f64.to_bits(), "the largest");
        for place in 0..3 {
            let mut values = [1.0, 3.0, 2.0];
            values[place] = f64::NAN;
            assert!(largest(values).is_infinite(), "NaN at {place}");
        }
    }
}
