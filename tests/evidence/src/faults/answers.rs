//! Faults that are put into the state of a discretised answer, and answers that are put into the place of another's: of the
//! same beam above another foundation, under another load, on a finer grid.

use palkki::scene::{LinearLoad, Load, PointLoad, Scene, SceneError};
use palkki::state::{ContactState, Nodes, SupportForce};

use crate::draft::scaled;

/// Sizes of the faults that have one: shares of what they change.
pub const SIZES: [f64; 12] = [1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];

/// A fault in an answer.
#[derive(Debug, Clone, Copy)]
pub struct Fault {
    /// What it is, in words.
    pub name: &'static str,
    /// Whether it has a size, one of [`SIZES`].
    pub sized: bool,
    act: fn(&mut Subject<'_>, f64),
}

/// What a fault is put into.
struct Subject<'a> {
    state: &'a mut ContactState,
    /// Sum of the magnitudes of all loads, or 1 without loads.
    load: f64,
    length: f64,
}

impl Fault {
    /// The state with the fault in it; [`None`] if it has no nodes or is the same as before, to the bit.
    ///
    /// `load` is the sum of the magnitudes of all loads.
    #[must_use]
    pub fn put_into(&self, state: &ContactState, size: f64, load: f64, length: f64) -> Option<ContactState> {
        let nodes = state.nodes.as_ref().filter(|nodes| !nodes.x.is_empty())?;
        let mut broken = state.clone();
        let load = if 0.0 < load { load } else { 1.0 };
        (self.act)(&mut Subject { state: &mut broken, load, length }, size);
        let same = broken.nodes.as_ref().is_some_and(|other| bits(nodes).eq(bits(other)))
            && broken.reactions == state.reactions
            && broken.supports == state.supports;
        (!same).then_some(broken)
    }
}

/// Every fault in every size, with the state that has it; without those that change nothing.
pub fn every_fault<'a>(
    state: &'a ContactState,
    scene: &Scene,
) -> impl Iterator<Item = (Fault, f64, ContactState)> + 'a {
    let length = scene.beam().length();
    let load = scene.load().magnitude(length);
    let sizes = |sized: bool| if sized { &SIZES[..] } else { &[0.0] };
    let all = FAULTS.into_iter().flat_map(move |fault| sizes(fault.sized).iter().map(move |&size| (fault, size)));
    all.filter_map(move |(fault, size)| Some((fault, size, fault.put_into(state, size, load, length)?)))
}

/// All numbers of the nodes, so that NaN equals itself.
fn bits(nodes: &Nodes) -> impl Iterator<Item = u64> + '_ {
    let lists = [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    lists.into_iter().flat_map(|list| list.iter().map(|value| value.to_bits()).chain([list.len() as u64]))
}

impl Subject<'_> {
    fn nodes(&mut self) -> &mut Nodes {
        self.state.nodes.get_or_insert_default()
    }

    fn forces(&mut self) -> &mut Vec<f64> {
        &mut self.nodes().contact_force
    }

    /// Changes the forces of supports, and what is said of those at the ends with them.
    fn supports(&mut self, change: impl FnOnce(&mut [SupportForce])) {
        change(&mut self.state.supports);
        let at_end = |end: f64| self.state.supports.iter().find(|s| (s.at - end).abs() <= 0.0).map(|s| s.force);
        let (left, right) = (at_end(0.0), at_end(self.length));
        let reactions = &mut self.state.reactions;
        (reactions.left, reactions.right) = (left.unwrap_or(reactions.left), right.unwrap_or(reactions.right));
    }

    /// Changes the couple at the first support in which the beam is built in.
    fn couple(&mut self, change: impl FnOnce(&mut Option<f64>)) {
        if let Some(support) = self.state.supports.iter_mut().find(|support| support.moment.is_some()) {
            change(&mut support.moment);
        }
    }

    /// The largest contact force and its neighbour to the right, or to the left at the end.
    fn pair(&mut self) -> (usize, usize) {
        let forces = self.forces();
        let i = largest(forces);
        (i, if i + 1 < forces.len() { i + 1 } else { i.saturating_sub(1) })
    }

    /// The clearest node, where no force belongs.
    fn clearest(&mut self) -> usize {
        let clearance = &self.nodes().clearance;
        (0..clearance.len()).max_by(|&i, &j| clearance[i].total_cmp(&clearance[j])).unwrap_or(0)
    }
}

/// Index of the largest magnitude.
fn largest(values: &[f64]) -> usize {
    (0..values.len()).max_by(|&i, &j| values[i].abs().total_cmp(&values[j].abs())).unwrap_or(0)
}

/// A share of the value of largest magnitude added to it.
fn add_to_largest(values: &mut [f64], share: f64) {
    if let Some(value) = values.get_mut(largest(values)) {
        *value += share * *value;
    }
}

fn scale(values: &mut [f64], factor: f64) {
    values.iter_mut().for_each(|value| *value *= factor);
}

/// The value of largest magnitude replaced.
fn put(values: &mut [f64], value: f64) {
    let place = largest(values);
    if let Some(place) = values.get_mut(place) {
        *place = value;
    }
}

const fn sized(name: &'static str, act: fn(&mut Subject<'_>, f64)) -> Fault {
    Fault { name, sized: true, act }
}

const fn whole(name: &'static str, act: fn(&mut Subject<'_>, f64)) -> Fault {
    Fault { name, sized: false, act }
}

/// All of them: those with a size first.
pub const FAULTS: [Fault; 41] = [
    sized("the largest force larger", |s, e| add_to_largest(s.forces(), e)),
    sized("the largest force smaller", |s, e| add_to_largest(s.forces(), -e)),
    sized("all forces larger", |s, e| scale(s.forces(), 1.0 + e)),
    sized("all forces perturbed, with alternating signs", |s, e| {
        s.forces().iter_mut().enumerate().for_each(|(i, p)| *p *= if i % 2 == 0 { 1.0 + e } else { 1.0 - e });
    }),
    sized("part of the largest force moved to its neighbour", |s, e| {
        let (i, j) = s.pair();
        let part = e * s.forces()[i];
        s.forces()[i] -= part;
        s.forces()[j] += part;
    }),
    sized("part of the largest force moved to both neighbours", |s, e| {
        let (i, _) = s.pair();
        if 0 < i && i + 1 < s.forces().len() {
            let part = e * s.forces()[i];
            s.forces()[i] -= part;
            s.forces()[i - 1] += 0.5 * part;
            s.forces()[i + 1] += 0.5 * part;
        }
    }),
    sized("a force where the clearance is largest, over the load", |s, e| {
        let (i, load) = (s.clearest(), s.load);
        s.forces()[i] += e * load;
    }),
    sized("a pull where the clearance is largest, over the load", |s, e| {
        let (i, load) = (s.clearest(), s.load);
        s.forces()[i] -= e * load;
    }),
    sized("the largest deflection larger", |s, e| add_to_largest(&mut s.nodes().deflection, e)),
    sized("all deflections larger", |s, e| scale(&mut s.nodes().deflection, 1.0 + e)),
    sized("all deflections shifted, over the largest one", |s, e| {
        let v = &mut s.nodes().deflection;
        let shift = v.get(largest(v)).map_or(0.0, |v| e * v.abs());
        v.iter_mut().for_each(|v| *v += shift);
    }),
    sized("one clearance larger, over the largest deflection", |s, e| {
        let nodes = s.nodes();
        let size = nodes.deflection[largest(&nodes.deflection)].abs();
        let middle = nodes.clearance.len() / 2;
        nodes.clearance[middle] += e * size;
    }),
    sized("the largest moment larger", |s, e| add_to_largest(&mut s.nodes().moment, e)),
    sized("all moments larger", |s, e| scale(&mut s.nodes().moment, 1.0 + e)),
    sized("one node to the right, over the length", |s, e| {
        let length = s.length;
        s.nodes().x[0] += e * length;
    }),
    sized("the left reaction larger, over the load", |s, e| {
        let more = e * s.load;
        s.supports(|supports| supports.iter_mut().take(1).for_each(|s| s.force += more));
    }),
    sized("load moved from one reaction to the other", |s, e| {
        let moved = e * s.load;
        s.supports(|supports| {
            if let [first, .., last] = supports {
                first.force += moved;
                last.force -= moved;
            }
        });
    }),
    sized("the couple where the beam is built in larger, over the load times the length", |s, e| {
        let more = e * s.load * s.length;
        s.couple(|couple| *couple = couple.map(|couple| couple + more));
    }),
    sized("forces, reactions, moments and deflections larger", |s, e| {
        let factor = 1.0 + e;
        s.supports(|supports| {
            for support in supports {
                support.force *= factor;
                support.moment = support.moment.map(|couple| couple * factor);
            }
        });
        let nodes = s.nodes();
        for list in [&mut nodes.contact_force, &mut nodes.moment, &mut nodes.deflection] {
            scale(list, factor);
        }
    }),
    whole("the largest force dropped", |s, _| put(s.forces(), 0.0)),
    whole("all forces dropped", |s, _| scale(s.forces(), 0.0)),
    whole("a force missing", |s, _| {
        s.forces().pop();
    }),
    whole("the largest force with the wrong sign", |s, _| add_to_largest(s.forces(), -2.0)),
    whole("all forces with the wrong sign", |s, _| scale(s.forces(), -1.0)),
    whole("all deflections with the wrong sign", |s, _| scale(&mut s.nodes().deflection, -1.0)),
    whole("all moments with the wrong sign", |s, _| scale(&mut s.nodes().moment, -1.0)),
    whole("forces shifted by a node", |s, _| s.forces().rotate_right(1)),
    whole("forces turned round", |s, _| s.forces().reverse()),
    whole("everything turned round", |s, _| {
        let length = s.length;
        s.supports(|supports| {
            supports.reverse();
            supports.iter_mut().for_each(|s| s.at = length - s.at);
        });
        let nodes = s.nodes();
        for list in [&mut nodes.contact_force, &mut nodes.moment, &mut nodes.deflection, &mut nodes.clearance] {
            list.reverse();
        }
    }),
    whole("forces in another unit", |s, _| scale(s.forces(), 1000.0)),
    whole("deflections in another unit", |s, _| scale(&mut s.nodes().deflection, 1000.0)),
    whole("a force that is NaN", |s, _| put(s.forces(), f64::NAN)),
    whole("a force that is infinite", |s, _| put(s.forces(), f64::INFINITY)),
    whole("a deflection that is NaN", |s, _| put(&mut s.nodes().deflection, f64::NAN)),
    whole("a deflection that is infinite", |s, _| put(&mut s.nodes().deflection, f64::INFINITY)),
    whole("a clearance that is NaN", |s, _| put(&mut s.nodes().clearance, f64::NAN)),
    whole("a moment that is NaN", |s, _| put(&mut s.nodes().moment, f64::NAN)),
    whole("a place that is NaN", |s, _| put(&mut s.nodes().x, f64::NAN)),
    whole("a reaction that is NaN", |s, _| {
        s.supports(|supports| supports.iter_mut().take(1).for_each(|s| s.force = f64::NAN));
    }),
    whole("a couple that is NaN", |s, _| s.couple(|couple| *couple = Some(f64::NAN))),
    whole("a couple that is missing", |s, _| s.couple(|couple| *couple = None)),
];

/// The scene with all depths multiplied by `1 + share`: what an answer belongs to that was not computed again.
///
/// # Errors
///
/// A [`SceneError`] if the depths overflow.
pub fn scaled_ground(scene: &Scene, share: f64) -> Result<Scene, SceneError> {
    let foundation = scene.foundation().map(|foundation| scaled(foundation, 1.0, 1.0 + share));
    Scene::new(scene.beam().clone(), scene.load().clone(), foundation)
}

/// The scene with all loads multiplied by `1 + share`.
///
/// # Errors
///
/// A [`SceneError`] if the loads overflow.
pub fn scaled_load(scene: &Scene, share: f64) -> Result<Scene, SceneError> {
    let factor = 1.0 + share;
    let load = scene.load();
    let linear = load.linear().iter().map(|q| LinearLoad { start: q.start * factor, end: q.end * factor, ..*q });
    let point = load.point().iter().map(|p| PointLoad { force: p.force * factor, ..*p });
    let load = Load::new(scene.beam(), load.uniform() * factor, linear.collect(), point.collect())?;
    Scene::new(scene.beam().clone(), load, scene.foundation().cloned())
}

/// Every second interior node of a state on twice as many intervals, as if it were the answer on the coarser grid.
#[must_use]
pub fn every_second(state: &ContactState) -> ContactState {
    let nodes = state.nodes.as_ref();
    // The first node of the coarser grid is the left end, unless that has a support.
    let first = nodes.and_then(|nodes| nodes.x.first()).map_or(1, |x| usize::from(0.0 < *x));
    let every_second = |list: &Vec<f64>| list.iter().skip(first).step_by(2).copied().collect();
    let nodes = nodes.map(|nodes| Nodes {
        discretisation: nodes.discretisation,
        x: every_second(&nodes.x),
        deflection: every_second(&nodes.deflection),
        clearance: every_second(&nodes.clearance),
        contact_force: every_second(&nodes.contact_force),
        moment: every_second(&nodes.moment),
    });
    ContactState { nodes, ..state.clone() }
}
