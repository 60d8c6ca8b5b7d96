//! A beam in its final position as curves and forces: the data of a figure, from any source.

use super::layer::Place;
use super::{PlotError, SAMPLES, same_length};
use crate::scene::{Scene, is_same_place};
use crate::state::{ContactState, Extremes, Nodes, SupportForce};
use crate::theory::Exact;

/// A concentrated contact force, upwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointForce {
    /// The position \[length\].
    pub at: f64,
    /// The force \[force\].
    pub force: f64,
}

/// The beam in its final position. Points of curves are joined linearly; a jump is two values at the same position.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// Positions for the lists below, from end to end of the beam \[length\].
    pub x: Vec<f64>,
    /// `v`, positive downwards \[length\].
    pub deflection: Vec<f64>,
    /// The initial shape `w0`, positive downwards; empty for a straight beam \[length\].
    pub shape: Vec<f64>,
    /// `h = u − w0 − v` \[length\]; infinite where there is no foundation.
    pub clearance: Vec<f64>,
    /// `M = −EI v''`, positive with the underside in tension \[force · length\].
    pub moment: Vec<f64>,
    /// `[x, V]` with `V = M'` \[force\].
    pub shear: Vec<Place>,
    /// `[x, p]`, one list for each interval of distributed contact pressure \[force / length\].
    pub pressure: Vec<Vec<Place>>,
    /// Concentrated contact forces.
    pub point_forces: Vec<PointForce>,
    /// The intervals in which the beam touches the foundation \[length\].
    pub contacts: Vec<[f64; 2]>,
    /// The reactions.
    pub supports: Vec<SupportForce>,
    /// Extremes of the deflection, to be labelled.
    pub deflection_extremes: Extremes,
    /// Extremes of the clearance, to be labelled: over the whole beam, and between its outermost contacts.
    pub clearance_extremes: [Extremes; 2],
    /// Extremes of the moment, to be labelled.
    pub moment_extremes: Extremes,
}

/// Contacts with at most this many nodes are drawn force by force; longer ones by their resultants.
const SINGLE_FORCES: usize = 5;

/// At each end of a contact this many nodal forces are drawn as one.
///
/// A concentrated force at a lift-off position between two nodes is split between these nodes. When the grid is refined, the two
/// parts do not converge, but their sum does.
const END_NODES: usize = 2;

/// A nodal force inside a contact that exceeds the median of its neighbours by this factor is drawn as a concentrated force (at a
/// kink of the foundation, for example) and not as pressure.
const PEAK: f64 = 3.0;

impl Curves {
    /// The curves of a discretised state.
    ///
    /// The shear force is constant between the nodes, as in the discretisation. In a contact of many nodes the inner contact forces
    /// are drawn as pressure, force per interval, and the outermost nodal forces at each end as their resultant. In a short contact
    /// each nodal force is drawn separately. Together they are the total contact force.
    ///
    /// # Errors
    ///
    /// [`PlotError::NoNodes`] for a state without nodes, [`PlotError::LengthMismatch`] for nodes of unequal length.
    pub fn of(scene: &Scene, state: &ContactState) -> Result<Self, PlotError> {
        let nodes = state.nodes.as_ref().ok_or(PlotError::NoNodes)?;
        same_length("the deflections", &nodes.deflection, &nodes.x)?;
        same_length("the clearances", &nodes.clearance, &nodes.x)?;
        same_length("the contact forces", &nodes.contact_force, &nodes.x)?;
        same_length("the moments", &nodes.moment, &nodes.x)?;
        let length = scene.beam().length();
        // A supported end of the beam is not a node of the grid; a free end is.
        let held = scene.held();
        #[expect(clippy::float_cmp, reason = "a support at an end is exactly there")]
        let [left, right] = [0.0, length].map(|end| {
            let held = held.iter().find(|held| held.at == end)?;
            let force = state.supports.iter().find(|force| force.at == end)?;
            let v = held.deflection;
            Some([end, v, scene.gap(end) - v, force.moment.unwrap_or(0.0)])
        });
        let closed = |values: &[f64], quantity: usize| -> Vec<f64> {
            let end = |end: Option<[f64; 4]>| end.map(|end| end[quantity]);
            end(left).into_iter().chain(values.iter().copied()).chain(end(right)).collect()
        };
        let x = closed(&nodes.x, 0);
        let moment = closed(&nodes.moment, 3);
        let shear = x
            .windows(2)
            .zip(moment.windows(2))
            .flat_map(|(x, m)| {
                let v = (m[1] - m[0]) / (x[1] - x[0]);
                [[x[0], v], [x[1], v]]
            })
            .collect();
        let places: Vec<f64> = std::iter::once(0.0).chain(nodes.x.iter().copied()).chain([length]).collect();
        let (pressure, point_forces) = contact_forces(state, nodes, &places);
        let clearance = above_ground(scene, &x, &closed(&nodes.deflection, 1), closed(&nodes.clearance, 2));
        let clearance_within = |[from, to]: [f64; 2]| {
            let places = x.iter().copied().zip(clearance.iter().copied());
            Extremes::of(places.filter(|(x, _)| from <= *x && *x <= to))
        };
        Ok(Self {
            clearance_extremes: [[0.0, length], between_contacts(state)].map(clearance_within),
            deflection: closed(&nodes.deflection, 1),
            shape: own_shape(scene, &x),
            clearance,
            moment,
            shear,
            pressure,
            point_forces,
            contacts: state.contacts.iter().map(|c| [c.from, c.to]).collect(),
            supports: state.supports.clone(),
            deflection_extremes: state.deflection,
            moment_extremes: state.moment,
            x,
        })
    }
}

impl Curves {
    /// The axis of the beam, `w0 + v`, at the positions `x`.
    pub(super) fn axis(&self) -> Vec<Place> {
        let shape = self.shape.iter().copied().chain(std::iter::repeat(0.0));
        self.x.iter().zip(&self.deflection).zip(shape).map(|((&x, v), w0)| [x, w0 + v]).collect()
    }
}

/// The interval from the leftmost to the rightmost contact; empty if there are fewer than two.
fn between_contacts(state: &ContactState) -> [f64; 2] {
    match &state.contacts[..] {
        [first, .., last] => [first.from, last.to],
        _ => [f64::INFINITY, f64::NEG_INFINITY],
    }
}

/// The clearance above the foundation, also at compression-only supports, which are drawn as supports.
fn above_ground(scene: &Scene, x: &[f64], deflection: &[f64], mut clearance: Vec<f64>) -> Vec<f64> {
    for support in scene.beam().bearings() {
        let own = scene.beam().shape().map_or(0.0, |shape| shape.depth(support.at));
        for (i, _) in x.iter().enumerate().filter(|(_, x)| is_same_place(**x, support.at, scene.beam().length())) {
            clearance[i] = scene.depth(support.at) - own - deflection[i];
        }
    }
    clearance
}

/// `w0` at the positions `x`; empty for a straight beam.
fn own_shape(scene: &Scene, x: &[f64]) -> Vec<f64> {
    scene.beam().shape().map_or(Vec::new(), |shape| x.iter().map(|&x| shape.depth(x)).collect())
}

/// Pressures and concentrated forces of all contacts. `x` has one more position than the nodes at each end.
fn contact_forces(state: &ContactState, nodes: &Nodes, x: &[f64]) -> (Vec<Vec<Place>>, Vec<PointForce>) {
    let mut pressure = Vec::new();
    let mut forces = Vec::new();
    for run in runs(state, nodes) {
        let f = |i: usize| nodes.contact_force[i];
        let single = |i: usize| PointForce { at: nodes.x[i], force: f(i) };
        // An elastic foundation exerts no concentrated force.
        if state.pressure.is_some() {
            pressure.push(run.flat_map(|i| steps(nodes, x, i)).collect());
            continue;
        }
        if run.len() <= SINGLE_FORCES {
            forces.extend(run.filter(|&i| f(i) != 0.0).map(single));
            continue;
        }
        let inner = run.start + END_NODES..run.end - END_NODES;
        forces.push(resultant(nodes, run.start..inner.start));
        let mut line = Vec::new();
        for i in inner.clone() {
            let mut around = [f(i - 2), f(i - 1), f(i + 1), f(i + 2)];
            around.sort_by(f64::total_cmp);
            let deep_inside = inner.start < i && i + 1 < inner.end;
            if deep_inside && PEAK * 0.5 * (around[1] + around[2]) < f(i) {
                forces.push(single(i));
                pressure.push(std::mem::take(&mut line));
                continue;
            }
            line.extend(steps(nodes, x, i));
        }
        pressure.push(line);
        forces.push(resultant(nodes, inner.end..run.end));
    }
    pressure.retain(|steps: &Vec<Place>| !steps.is_empty());
    (pressure, forces)
}

/// The pressure of node `i`, whose force is spread over half an interval on either side.
fn steps(nodes: &Nodes, x: &[f64], i: usize) -> [Place; 2] {
    // Node `i` of the interior is node `i + 1` of `x`, which begins with the support.
    let (left, right) = (0.5 * (x[i] + x[i + 1]), 0.5 * (x[i + 1] + x[i + 2]));
    [left, right].map(|x| [x, nodes.contact_force[i] / (right - left)])
}

/// Contacts as ranges of nodes; two contacts with at most one open node between them count as one.
fn runs(state: &ContactState, nodes: &Nodes) -> Vec<std::ops::Range<usize>> {
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for contact in &state.contacts {
        let first = nodes.x.partition_point(|&x| x < contact.from);
        let end = nodes.x.partition_point(|&x| x <= contact.to);
        match runs.last_mut() {
            Some(last) if first <= last.end + 1 => last.end = end.max(last.end),
            _ if first < end => runs.push(first..end),
            _ => {}
        }
    }
    runs
}

/// One force for several nodal forces, at their centroid.
fn resultant(nodes: &Nodes, range: std::ops::Range<usize>) -> PointForce {
    let force: f64 = range.clone().map(|i| nodes.contact_force[i]).sum();
    let moment: f64 = range.clone().map(|i| nodes.contact_force[i] * nodes.x[i]).sum();
    let at = if 0.0 < force { moment / force } else { nodes.x[range.start] };
    PointForce { at, force }
}

impl Curves {
    /// The curves of the exact solution of a scene.
    #[must_use]
    pub fn exact(scene: &Scene, exact: &Exact) -> Self {
        let samples = exact.samples(scene, SAMPLES);
        let state = &exact.state;
        let zones = state.contacts.iter().filter(|c| c.from < c.to);
        let pressure = zones
            .map(|zone| {
                let within = samples.iter().filter(|s| zone.from <= s.x && s.x <= zone.to);
                // At its ends, the samples that belong outside the zone are those without pressure.
                let outside = |x: f64, pressure: f64| pressure == 0.0 && (x <= zone.from || zone.to <= x);
                within.filter(|s| !outside(s.x, s.pressure)).map(|s| [s.x, s.pressure]).collect()
            })
            .collect();
        Self {
            x: samples.iter().map(|s| s.x).collect(),
            deflection: samples.iter().map(|s| s.deflection).collect(),
            shape: own_shape(scene, &samples.iter().map(|s| s.x).collect::<Vec<_>>()),
            clearance: above_ground(
                scene,
                &samples.iter().map(|s| s.x).collect::<Vec<_>>(),
                &samples.iter().map(|s| s.deflection).collect::<Vec<_>>(),
                samples.iter().map(|s| s.clearance).collect(),
            ),
            moment: samples.iter().map(|s| s.moment).collect(),
            shear: samples.iter().map(|s| [s.x, s.shear]).collect(),
            pressure,
            point_forces: point_forces(exact),
            contacts: state.contacts.iter().map(|c| [c.from, c.to]).collect(),
            supports: state.supports.clone(),
            deflection_extremes: state.deflection,
            clearance_extremes: [[0.0, scene.beam().length()], between_contacts(state)]
                .map(|[from, to]| exact.clearance_extremes(from, to)),
            moment_extremes: state.moment,
        }
    }
}

/// Concentrated contact forces: at point contacts, at the ends of zones, and from point loads that a zone carries.
fn point_forces(exact: &Exact) -> Vec<PointForce> {
    let mut forces = Vec::new();
    for contact in &exact.state.contacts {
        match contact.end_forces {
            Some([from, to]) => forces.extend([(contact.from, from), (contact.to, to)]),
            // An elastic foundation exerts no concentrated force.
            None if exact.state.pressure.is_some() => {}
            None => forces.push((contact.from, contact.force)),
        }
    }
    forces.extend(exact.forces_inside_zones());
    forces.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A zone that ends at a support has no force there.
    forces.retain(|&(_, force)| force != 0.0);
    forces.into_iter().map(|(at, force)| PointForce { at, force }).collect()
}

#[cfg(test)]
mod tests {
    use super::{Curves, contact_forces};
    use crate::plot::curves;
    use crate::route::{Method, Solver};
    use crate::scene::{Beam, Foundation, Load, PointLoad, Scene};
    use crate::state::{Contact, ContactState, Extremes, Nodes, Reactions, Regime};
    use crate::theory;

    /// Position and value of each concentrated force.
    type Forces = Vec<(f64, f64)>;

    /// Concentrated forces and pressures of a state on unit intervals with nodal `forces` and the given contacts.
    fn forces_of(forces: &[f64], contacts: &[[f64; 2]]) -> (Forces, Vec<Vec<[f64; 2]>>) {
        let x: Vec<f64> = (1_u32..).take(forces.len()).map(f64::from).collect();
        let nodes = Nodes { x: x.clone(), contact_force: forces.to_vec(), ..Nodes::default() };
        let contact = |&[from, to]: &[f64; 2]| Contact { from, to, force: 0.0, end_forces: None };
        let state = ContactState {
            regime: Regime::Zone,
            reactions: Reactions::default(),
            supports: Vec::new(),
            standing: None,
            contacts: contacts.iter().map(contact).collect(),
            touches: Vec::new(),
            deflection: Extremes::default(),
            moment: Extremes::default(),
            energy: 0.0,
            pressure: None,
            nodes: None,
        };
        let places: Vec<f64> = std::iter::once(0.0).chain(x).chain([f64::from(u32::MAX)]).collect();
        let (pressure, forces) = contact_forces(&state, &nodes, &places);
        (forces.iter().map(|f| (f.at, f.force)).collect(), pressure)
    }

    #[test]
    fn a_short_contact_keeps_its_forces() {
        let (forces, pressure) = forces_of(&[0.0, 2.0, 0.0, 1.0, 0.0], &[[2.0, 2.0], [4.0, 4.0]]);
        assert_eq!(forces, [(2.0, 2.0), (4.0, 1.0)]);
        assert_eq!(pressure, Vec::<Vec<[f64; 2]>>::new());
    }

    #[test]
    fn a_long_contact_keeps_its_resultant() {
        // One open node after the left end does not divide the contact.
        let nodal = [0.0, 3.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.5, 1.0, 3.0, 0.0];
        let (forces, pressure) = forces_of(&nodal, &[[2.0, 3.0], [5.0, 10.0]]);
        assert_eq!(forces, [(2.25, 4.0), (9.75, 4.0)]);
        let distributed: f64 =
            pressure.iter().flatten().collect::<Vec<_>>().chunks(2).map(|p| p[0][1] * (p[1][0] - p[0][0])).sum();
        let total: f64 = forces.iter().map(|f| f.1).sum::<f64>() + distributed;
        assert!((total - nodal.iter().sum::<f64>()).abs() < 1e-12, "{total} is left of the contact force");
    }

    #[test]
    fn a_peak_inside_a_contact_is_a_force() {
        let (forces, pressure) = forces_of(&[2.0, 1.0, 1.0, 1.0, 8.0, 1.0, 1.0, 1.0, 2.0], &[[1.0, 9.0]]);
        assert_eq!(forces[1], (5.0, 8.0));
        assert_eq!(pressure.len(), 2, "the pressure is parted by the force");
    }

    /// Rounding of some hundred sums.
    const ROUNDING: f64 = 1e-9;

    /// A beam with `EI = 1`, `q₀ = 24`, `u₀ = 1`, so that `a = 1`, `T = 12`, and a load on it where it touches.
    #[test]
    fn the_exact_solution_keeps_its_equilibrium() {
        let (l, q, t, force) = (4.0, 24.0, 12.0, 3.0);
        let beam = Beam::new(l, 1.0).expect("a beam");
        let load = Load::new(&beam, q, Vec::new(), vec![PointLoad { at: 2.0, force }]).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
        let sampled = Curves::exact(&scene, &theory::solve(&scene).expect("an exact solution"));
        let area = |line: &[[f64; 2]]| -> f64 {
            line.windows(2).map(|p| 0.5 * (p[0][1] + p[1][1]) * (p[1][0] - p[0][0])).sum()
        };
        let close = |value: f64, expected: f64| (value - expected).abs() < ROUNDING * expected.abs().max(1.0);
        let distributed: f64 = sampled.pressure.iter().map(|zone| area(zone)).sum();
        assert!(close(distributed, q * (l - 2.0)), "{distributed} is distributed");
        let forces: Vec<f64> = sampled.point_forces.iter().map(|f| f.force).collect();
        assert!(forces.len() == 3 && close(forces[1], force), "lift-off points and a load between them: {forces:?}");
        let carried = distributed + forces.iter().sum::<f64>() + 2.0 * t;
        assert!(close(carried, q * l + force), "contact and reactions carry {carried}");
        assert!(close(area(&sampled.shear), 0.0), "shear is the derivative of a moment that vanishes at both ends");
        assert!(close(sampled.shear[0][1], t), "shear at the support is the reaction");
        let settings = crate::Settings::new(Method::Force, Solver::ActiveSet, 400);
        let nodal = crate::solve_raw(&scene, &settings).expect("a grid").state;
        let nodal = Curves::of(&scene, &nodal).expect("nodes");
        assert!(
            (nodal.shear[0][1] - t).abs() < 0.2,
            "{:?}: shear at the support but for half an interval",
            nodal.shear[0]
        );
        let svg = curves(&scene, &sampled, "exact").expect("a figure");
        assert!(svg.contains("V = 12 at x = 0") && svg.contains("contact pressure p"), "shear and pressure are drawn");
    }
}
