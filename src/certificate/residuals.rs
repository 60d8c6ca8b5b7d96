//! The residual of a discrete problem on any supports: [`Kkt`] of a beam that is not the paper's.
//!
//! The contact forces of a state bend the beam on its supports ([`NodalBeam`]). A beam that its supports do not hold is held by
//! two nodes with the deflections of the state, its support and the nodes that press most: what balance asks of these takes the
//! place of their contact forces, and the difference is one of equilibrium.

use super::kkt::{Kkt, ROUNDING, largest, mistaken, nonzero, within_reach};
use super::nodal_beam::{NodalBeam, Station};
use crate::scene::{Grid, Held, Scene};
use crate::state::{ContactState, Nodes};

/// A node is at a support if it is nearer than this share of the beam: some units in the last place.
const AT: f64 = 1e-14;

/// Violations of a dimensionless state; [`None`] if its nodes are not those of a grid with all supports among them: all nodes but
/// the ends of the beam that have a support.
pub(super) fn on_supports(scene: &Scene, state: &ContactState) -> Option<Kkt> {
    let nodes = state.nodes.as_ref()?;
    let (held, length) = (scene.held(), scene.beam().length());
    let ends = [0.0, length].map(|end| usize::from(held.iter().any(|s| (s.at - end).abs() <= AT * length)));
    let count = nodes.contact_force.len();
    if [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.moment].iter().any(|list| list.len() != count) {
        return None;
    }
    let (grid, first) = (Grid::uniform(scene, (count + ends[0] + ends[1]).checked_sub(1)?).ok()?, ends[0]);
    let all = grid.intervals() + 1;
    let mut deflection = vec![0.0; all];
    deflection[first..first + count].copy_from_slice(&nodes.deflection);
    let mut stations = supports(&grid, &held, length)?;
    // What stands at a station counts as what it exerts, and not as a load.
    let mut exerted: Vec<f64> = held.iter().map(|s| force_at(state, s, length)).collect::<Option<_>>()?;
    let mut contact = vec![0.0; all];
    contact[first..first + count].copy_from_slice(&nodes.contact_force);
    stand(&mut stations, &mut exerted, &mut contact, &deflection);

    let loads = grid.nodal_loads(scene.load());
    let forces: Vec<f64> = loads.iter().zip(&contact).map(|(q, p)| q - p).collect();
    let caused = NodalBeam::of(scene, grid, &forces, &stations, nodes.discretisation)?;
    let mut gaps = vec![0.0; count];
    scene.gaps(&grid_places(&grid, first, count), &mut gaps);
    Some(compare(scene, state, nodes, &Caused { grid, first, gaps, loads, exerted, beam: caused }))
}

/// What the forces of a state cause, and what they are compared with.
struct Caused {
    grid: Grid,
    /// The first node of the state.
    first: usize,
    /// Gaps at its nodes.
    gaps: Vec<f64>,
    loads: Vec<f64>,
    /// What the state says that its stations exert.
    exerted: Vec<f64>,
    beam: NodalBeam,
}

fn compare(scene: &Scene, state: &ContactState, nodes: &Nodes, caused: &Caused) -> Kkt {
    let Caused { grid, first, gaps, loads, exerted, beam } = caused;
    let (x, v, h, p) = (&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force);
    let length = scene.beam().length();
    let flexibility = length * length * length / (48.0 * scene.beam().bending_stiffness());
    let sum = |forces: &[f64]| forces.iter().map(|force| force.abs()).sum::<f64>();
    let load = sum(loads);
    let idle = if load == 0.0 { within_reach(gaps).max(largest(v.iter().map(|v| v.abs()))) } else { 0.0 };
    let force = nonzero(load.max(sum(p)).max(idle / flexibility));
    let depth = nonzero(largest(v.iter().map(|v| v.abs())).max(idle).max(ROUNDING * flexibility * force));
    let clearance = |k: usize| gaps[k] - v[k];
    let all = || 0..p.len();
    let elastic = largest(all().map(|k| (v[k] - beam.deflection[first + k]).abs()));
    let balance = largest(exerted.iter().zip(&beam.forces).map(|(said, caused)| (said - caused).abs()));
    // Beside a support in which the beam is built in either moment will do.
    let moment = |k: usize| beam.moment[first + k].map(|m| (nodes.moment[k] - m).abs());
    let moments = largest(all().map(moment).map(|[left, right]| if left < right { left } else { right }));
    let built_in = state.supports.iter().filter_map(|support| Some((support.at, support.moment?)));
    let couples = built_in.filter_map(|(at, said)| {
        let node = (0..beam.moment.len()).find(|i| (grid.place(*i) - at).abs() <= AT * length)?;
        let [left, right] = beam.moment[node].map(|m| (said - m).abs());
        Some(if left < right { left } else { right })
    });
    let places = all().map(|k| (x[k] - grid.place(first + k)).abs());
    let clearances = all().map(|k| mistaken(h[k], gaps[k], clearance(k)));
    Kkt {
        penetration: largest(all().map(|k| -clearance(k))) / depth,
        tension: largest(p.iter().map(|p| -p)) / force,
        complementarity: largest(all().map(|k| (clearance(k) / depth).min(p[k] / force))),
        equilibrium: largest([elastic / depth, balance / force]),
        record: largest([
            moments.max(largest(couples)) / (force * length),
            largest(clearances) / depth,
            largest(places) / length,
        ]),
    }
}

fn grid_places(grid: &Grid, first: usize, count: usize) -> Vec<f64> {
    let mut places = vec![0.0; count];
    grid.places(first, &mut places);
    places
}

/// The supports as stations; [`None`] if one of them is between nodes.
pub(super) fn supports(grid: &Grid, held: &[Held], length: f64) -> Option<Vec<Station>> {
    let station = |support: &Held| {
        let node = (0..=grid.intervals()).find(|i| (grid.place(*i) - support.at).abs() <= AT * length)?;
        Some(Station { node, deflection: support.deflection, slope: support.slope })
    };
    held.iter().map(station).collect()
}

/// The force that a state says a support exerts; [`None`] if it says none, or no moment where the beam is built in.
fn force_at(state: &ContactState, held: &Held, length: f64) -> Option<f64> {
    let support = state.supports.iter().find(|s| (s.at - held.at).abs() <= AT * length)?;
    (support.moment.is_some() == held.slope.is_some()).then_some(support.force)
}

/// Takes nodes for stations until the beam is held: those that press most, or that press most about the one that is there, and
/// where nothing presses an end of the beam.
pub(super) fn stand(stations: &mut Vec<Station>, exerted: &mut Vec<f64>, contact: &mut [f64], deflection: &[f64]) {
    while stations.len() < 2 && stations.iter().all(|station| station.slope.is_none()) {
        let last = contact.len() - 1;
        let taken = stations.first().map(|station| station.node);
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let turns = |node: usize| contact[node] * taken.map_or(1.0, |taken| taken.abs_diff(node) as f64);
        let most = (0..=last).max_by(|a, b| turns(*a).total_cmp(&turns(*b))).filter(|node| 0.0 < turns(*node));
        let node = most.unwrap_or(if taken.is_some_and(|taken| last <= 2 * taken) { 0 } else { last });
        let at = stations.partition_point(|station| station.node < node);
        stations.insert(at, Station { node, deflection: deflection[node], slope: None });
        exerted.insert(at, std::mem::take(&mut contact[node]));
    }
}
