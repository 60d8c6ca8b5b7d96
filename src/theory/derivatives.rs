//! Derivatives of an exact answer by the numbers of its scene, in the units of the scene.
//!
//! Places and forces follow from module `sensitivity`. The energy is the least one, so that its derivative is that of the functional
//! and of the constraints alone (envelope theorem), with the forces as multipliers:
//!
//! ```text
//! ∂J/∂(depth) = −Σ R     ∂J/∂EI = ½∫v''²     ∂J/∂q₀ = −∫v     ∂J/∂P = −v(a)     ∂J/∂a = −P v'(a)     ∂J/∂d_s = −R_s
//! ```

use super::exact::Exact;
use super::list::{Beside, Kind, Node};
use super::margin::lowest;
use super::piecewise::AtSupport;
use super::sensitivity::{Change, NodeChange, Sensitivity, bend, standing};
use super::span::Span;
use crate::scene::{Foundation, Held, Quantity, Scene};
use crate::state::Contact;

/// By what an answer is differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// The depth of all of the ground \[length\].
    Depth,
    /// A number of the scene.
    Number(Quantity),
}

impl std::fmt::Display for By {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Depth => f.write_str("depth"),
            Self::Number(quantity) => quantity.fmt(f),
        }
    }
}

/// The derivatives of an answer by one number; each has the unit of what is differentiated over that of the number.
#[derive(Debug, Clone, PartialEq)]
pub struct Derivative {
    /// The number.
    pub by: By,
    /// True at a change of the kind of the answer: to the other side of it the derivatives are others, or the scene is refused.
    pub one_sided: bool,
    /// Why numbers below are missing, that is not numbers; [`None`] if all of them are there.
    pub missing: Option<Missing>,
    /// Of the forces of the supports, from left to right.
    pub supports: Vec<f64>,
    /// Of the contacts, in their order.
    pub contacts: Vec<ContactDerivative>,
    /// Of the energy `J`.
    pub energy: f64,
}

/// Why a derivative is not there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Missing {
    /// The ground parts from a support where the beam lies on it: forces change as a root of the distance, infinitely fast.
    Parts,
    /// The beam lies on the ground beside a support, or along it, without pressing on it: what touches is not determined.
    Unloaded,
    /// Beyond a support that moves off an end of the beam, the ground is level with it, and the beam touches it at once.
    Touches,
    /// The force at the end of a zone, or of a support there, jumps: a load that stands on it moves into the zone or out of it.
    Jumps,
    /// Loads of both signs stand at one place on a zone, which lifts off under one of them as soon as they part.
    Pulls,
    /// Where a zone ends nothing presses: its place is not determined.
    Undetermined,
    /// A contact is so near a support that of the two forces only the couple is certain.
    Crowded,
}

impl Missing {
    /// The reason in words.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::Parts => {
                "infinite: the ground parts from a support beside which the beam lies on it, and forces change as a root of the distance"
            }
            Self::Unloaded => {
                "none: the beam lies on the ground without pressing on it, so that what touches is not determined"
            }
            Self::Touches => {
                "none: beyond a support that moves off the end of the beam, the beam touches the ground at once"
            }
            Self::Jumps => "in part: the force at the end of a zone jumps as the load that stands there moves",
            Self::Pulls => "none: one of the loads at this place pulls, and lifts the beam off as soon as they part",
            Self::Crowded => {
                "in part: a contact is so near a support that only the sum and the couple of their forces are certain"
            }
            Self::Undetermined => "in part: nothing presses where a zone ends, so that the place is not determined",
        }
    }
}

/// The derivatives of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactDerivative {
    /// Of its left end.
    pub from: f64,
    /// Of its right end.
    pub to: f64,
    /// Of its resultant.
    pub force: f64,
    /// Of the forces at the ends of a zone.
    pub end_forces: Option<[f64; 2]>,
}

/// How far forces may be off, by estimate: magnitudes \[force\].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "cli", derive(serde::Serialize))]
pub struct Spread {
    /// Of the supports, from left to right.
    pub supports: Vec<f64>,
    /// Of the resultants of the contacts.
    pub contacts: Vec<f64>,
}

/// A derivative to be computed.
#[derive(Debug, Clone, Copy)]
struct Asked {
    by: By,
    change: Change,
    unit: f64,
    one_sided: bool,
    /// Why it is not there where the change parts ground and support.
    parts: Option<Missing>,
}

/// The ground at a support.
#[derive(Debug, Clone, Copy, Default)]
struct Ground {
    /// It starts at the level of the support, and cannot rise.
    meets: bool,
    /// The beam lies on it beside the support, and how it leaves it.
    rests: Option<Missing>,
    /// It is level around the support, which may move along it.
    level: bool,
    /// The slope of the axis of the beam to its left and to its right.
    axis: [f64; 2],
}

/// Numbers of all derivatives together at most: some 400 MB as text.
const MOST_NUMBERS: usize = 20_000_000;

/// A contact force, a bend or a clearance below this share of the largest one is zero: there the kind of the answer changes.
const AT_A_CHANGE: f64 = 1e-9;

impl Exact {
    /// The derivatives of this solution of `scene` by the depth of all of the ground, the bending stiffness, the uniform load, force
    /// and place of each point load, level and place of each support. Left out is what has none: all of a beam whose position is
    /// not certain.
    #[must_use]
    pub fn derivatives(&self, scene: &Scene) -> Vec<Derivative> {
        let Some(linear) = self.sensitivity() else { return Vec::new() };
        let (at_change, lies) = (self.at_a_change(), self.lies());
        let of = |asked: Asked| {
            // More load presses all of a stretch that lies on the ground, less of it none.
            let unloaded = (lies && matches!(asked.change, Change::Uniform(_))).then_some(Missing::Unloaded);
            let (one_sided, parts) = (at_change || asked.one_sided, asked.parts.or(unloaded));
            self.derivative(&linear, Asked { one_sided, parts, ..asked })
        };
        self.asked(scene).into_iter().take(self.most_derivatives()).map(of).collect()
    }

    /// How many derivatives are left out of [`Self::derivatives`] for there are too many numbers in all.
    #[must_use]
    pub fn derivatives_left_out(&self, scene: &Scene) -> usize {
        self.asked(scene).len().saturating_sub(self.most_derivatives())
    }

    fn most_derivatives(&self) -> usize {
        MOST_NUMBERS / (self.state.supports.len() + 5 * self.state.contacts.len() + 1)
    }

    fn sensitivity(&self) -> Option<Sensitivity<'_>> {
        Sensitivity::of(&self.given, &self.list, &self.spans, &self.forces)
    }

    /// By what an answer is differentiated, and what is known of each derivative before it is computed.
    fn asked(&self, scene: &Scene) -> Vec<Asked> {
        let scale = &self.scale;
        let (stiffness, bending) = (self.stiffness, scene.beam().bending_stiffness());
        let supports = self.at_supports(scene);
        let mut all = Vec::new();
        let mut add = |by, change, unit, one_sided, parts| all.push(Asked { by, change, unit, one_sided, parts });
        if scene.foundation().is_some() {
            let parts = supports.iter().find_map(|s| s.rests);
            add(By::Depth, Change::Ground, scale.depth, supports.iter().any(|s| s.meets), parts);
        }
        add(By::Number(Quantity::BendingStiffness), Change::Unload, bending, false, None);
        add(By::Number(Quantity::Uniform), Change::Uniform(1.0 / stiffness), scale.force / scale.length, false, None);
        for (i, load) in scene.load().point().iter().enumerate() {
            let at = load.at / scale.length;
            add(By::Number(Quantity::PointForce(i)), Change::Force(at, 1.0 / stiffness), scale.force, false, None);
            let size = load.force / scale.force / stiffness;
            // At the end of a zone, or of the beam, the other side is another stretch.
            let one_sided = at <= 0.0 || self.given.length <= at || self.ends_zone(at);
            let parts = self.pulls(at, size).then_some(Missing::Pulls);
            add(By::Number(Quantity::PointAt(i)), Change::Move(at, size), scale.length, one_sided, parts);
        }
        for (given, support) in scene.beam().supports_as_given().into_iter().enumerate() {
            let i = scene.beam().supports().partition_point(|s| s.at < support.at);
            let here = &supports[i];
            add(By::Number(Quantity::SupportLevel(given)), Change::Level(i), scale.depth, here.meets, here.rests);
            let unit = scale.length / scale.depth;
            let (at_left, at_right) = (support.at <= 0.0, scene.beam().length() <= support.at);
            // Where the ground meets the support the beam may pass this place on one side only.
            let blocked = match (at_left, at_right) {
                (true, _) => [true, here.meets && here.axis[1] <= 0.0],
                (_, true) => [here.meets && 0.0 <= here.axis[0], true],
                _ => [here.meets && 0.0 < here.axis[0], here.meets && here.axis[1] < 0.0],
            };
            let side = usize::from(!blocked[1]);
            let (own, kinked) = scene.beam().shape().map_or(([0.0; 2], false), |shape| {
                let slopes = shape.sides(support.at).map(|[_, slope]| slope);
                let kinked = slopes[0].total_cmp(&slopes[1]).is_ne();
                ([slopes[side] * unit, curvature(shape, support.at) * unit * scale.length], kinked)
            });
            let at_end = at_left || at_right;
            let one_sided = at_end || kinked || here.meets && !here.level;
            let touches = blocked == [true; 2] || at_end && here.rests.is_some();
            let parts = here.rests.filter(|_| !here.level).or(touches.then_some(Missing::Touches));
            add(By::Number(Quantity::SupportAt(given)), Change::Support(i, own), scale.length, one_sided, parts);
        }
        all
    }

    /// What the ground does at the supports, from left to right.
    fn at_supports(&self, scene: &Scene) -> Vec<Ground> {
        let nodes = self.list.nodes.iter().enumerate();
        let held = scene.held();
        let ground = |(i, node): (usize, &Node)| Some(self.at_support(scene, i, &held[node.support()?]));
        nodes.filter_map(ground).collect()
    }

    fn at_support(&self, scene: &Scene, i: usize, held: &Held) -> Ground {
        let (given, length) = (&self.given, scene.beam().length());
        let node = &self.list.nodes[i];
        let Kind::Support(index, beside) = node.kind else { return Ground::default() };
        let support = &given.supports[index];
        let bridged = self.bridged(support);
        let crowded = self.crowded(i);
        let by_ground = !support.built_in && support.slope.is_some();
        let rests = (by_ground || beside != [Beside::Apart; 2] || crowded).then(|| {
            let pushes = |zone: bool, cell: usize| zone && given.drive(cell, node.x) != 0.0;
            let pressed = pushes(self.list.in_zone_before(i), given.cell_to(node.x))
                || pushes(self.list.in_zone_before(i + 1), given.cell_from(node.x));
            let [left, right] = self.bends(i);
            let couple = AT_A_CHANGE * self.largest_node_force() * given.length < (right - left).abs();
            if pressed || couple || crowded { Missing::Parts } else { Missing::Unloaded }
        });
        // Level ground on both sides, where there is a beam.
        let level = scene.foundation().is_some_and(|ground| {
            let flat = ground.sides(held.at).into_iter().all(|[_, slope]| slope == 0.0);
            flat && curvature(ground, held.at) == 0.0 && held.meets == [0.0 < held.at, held.at < length]
        });
        let ends = super::sensitivity::ends(&self.spans, i);
        let slope = ends[0].map(|span| span.beam_b[1]).or(ends[1].map(|span| span.beam_a[1])).unwrap_or(0.0);
        let own = scene.beam().shape().map_or([0.0; 2], |own| own.sides(held.at).map(|[_, slope]| slope));
        let axis = own.map(|own| own + slope * self.scale.depth / self.scale.length);
        Ground { meets: bridged || held.meets.contains(&true), rests, level, axis }
    }

    /// True if the gap between a support and the ground is none, or next to none.
    fn bridged(&self, support: &AtSupport) -> bool {
        let size = self.state.deflection.magnitude() / self.scale.depth;
        self.given.founded && support.clearance.into_iter().any(|gap| gap <= AT_A_CHANGE * size)
    }

    /// True of a support and of a contact that are side by side: a gap that is small is bridged over a distance that is small as
    /// its root.
    fn crowded(&self, i: usize) -> bool {
        let nodes = &self.list.nodes;
        let near = |[a, b]: [&Node; 2]| {
            let support = a.support().or(b.support()).map(|index| &self.given.supports[index]);
            a.support().is_some() != b.support().is_some()
                && (b.x - a.x).abs() <= AT_A_CHANGE.sqrt() * self.given.length
                && support.is_some_and(|support| self.bridged(support))
        };
        let beside = |left: usize| nodes.get(left).zip(nodes.get(left + 1)).is_some_and(|(a, b)| near([a, b]));
        beside(i) || i.checked_sub(1).is_some_and(beside)
    }

    /// `v''` to the left and to the right of a node, that of the ground in a zone, and zero where there is no beam.
    fn bends(&self, i: usize) -> [f64; 2] {
        let (given, x) = (&self.given, self.list.nodes[i].x);
        let [left, right] = super::sensitivity::ends(&self.spans, i);
        let zone = |before: usize, cell: usize| {
            if self.list.in_zone_before(before) { given.derivative(cell, x, 2) } else { 0.0 }
        };
        [
            left.map_or_else(|| zone(i, given.cell_to(x)), |span| span.beam_b[2]),
            right.map_or_else(|| zone(i + 1, given.cell_from(x)), |span| span.beam_a[2]),
        ]
    }

    fn largest_node_force(&self) -> f64 {
        self.forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()))
    }

    /// How far forces are off to first order if the depth under each contact by itself may be off by `tolerance`: the sum of the
    /// magnitudes of all derivatives. Under a zone the ground moves as a whole.
    #[must_use]
    pub fn spread(&self, tolerance: f64) -> Option<Spread> {
        let nodes = &self.list.nodes;
        let none =
            Spread { supports: vec![0.0; self.state.supports.len()], contacts: vec![0.0; self.state.contacts.len()] };
        let stretches = (0..=nodes.len()).filter_map(|i| match nodes.get(i).map(|node| node.kind) {
            _ if self.list.in_zone_before(i) => Some((i - 1, i)),
            Some(Kind::Smooth | Kind::Edge(_)) => Some((i, i)),
            _ => None,
        });
        // Where the ground parts from a support forces change as a root of the distance.
        let rests = |(i, node): (usize, &Node)| match node.kind {
            Kind::Support(index, beside) => {
                let support = &self.given.supports[index];
                beside != [Beside::Apart; 2] || support.slope.is_some() && !support.built_in || self.crowded(i)
            }
            _ => false,
        };
        if nodes.iter().enumerate().any(rests) {
            return None;
        }
        let linear = self.sensitivity()?;
        stretches.into_iter().try_fold(none, |mut sum, (from, to)| {
            let of = Change::GroundUnder(from, to);
            let derivative = self.derivative(
                &linear,
                Asked { by: By::Depth, change: of, unit: self.scale.depth, one_sided: false, parts: None },
            );
            let add = |sum: &mut f64, by: f64| *sum += by.abs() * tolerance;
            sum.supports.iter_mut().zip(&derivative.supports).for_each(|(sum, &by)| add(sum, by));
            sum.contacts.iter_mut().zip(&derivative.contacts).for_each(|(sum, by)| add(sum, by.force));
            Some(sum)
        })
    }

    fn derivative(&self, linear: &Sensitivity<'_>, asked: Asked) -> Derivative {
        let Asked { by, change: of, unit, one_sided, parts } = asked;
        let (given, list, scale) = (&self.given, &self.list, &self.scale);
        let changes = linear.change(of);
        let place = |z: f64| z * scale.length / unit;
        // A force is EI times what is computed here, so that it grows with EI as such.
        let force = |now: f64, change: f64| {
            let own = if of == Change::Unload { now } else { 0.0 };
            (own + change) * self.stiffness * scale.force / unit + 0.0
        };
        let total =
            |i: usize| self.forces[i] + if list.nodes[i].support().is_some() { standing(given, list, i) } else { 0.0 };
        let jumping = |i: usize| match of {
            Change::Move(at, _) => list.nodes[i].x <= at && at <= list.nodes[i].x && list.ends_zone(i),
            Change::Support(index, _) => list.nodes[i].support() == Some(index) && self.jumps(i),
            _ => false,
        };
        let certain = |i: usize, value: f64| if self.crowded(i) || jumping(i) { f64::NAN } else { value };
        let (mut supports, mut contacts) = (Vec::new(), Vec::new());
        for i in 0..=list.nodes.len() {
            if list.in_zone_before(i) {
                let ends = [i - 1, i].map(|end| {
                    let node = &list.nodes[end];
                    match node.support() {
                        // The support is said to take all of what is carried there.
                        Some(_) => (node.x, changes[end].place, 0.0, 0.0),
                        None if !self.presses(end, i) => (node.x, f64::NAN, self.forces[end], changes[end].force),
                        None => (node.x, changes[end].place, self.forces[end], changes[end].force),
                    }
                });
                let [(from, left, force_from, change_from), (to, right, force_to, change_to)] = ends;
                let (first, last) = (given.cell_from(from), given.cell_to(to));
                let pushed = |cell: usize, x: f64, place: f64| match -given.drive(given.cell_ahead(x, cell, place), x) {
                    0.0 => 0.0,
                    pressure => pressure * place,
                };
                let spread = of.on_zone(given, from, to) + pushed(last, to, right) - pushed(first, from, left);
                let own = super::forces::zone_force(given, from, to) + force_from + force_to;
                contacts.push(ContactDerivative {
                    from: place(left),
                    to: place(right),
                    force: force(own, spread + change_from + change_to),
                    end_forces: Some([force(force_from, change_from), force(force_to, change_to)]),
                });
            }
            let Some(node) = list.nodes.get(i) else { continue };
            match node.kind {
                Kind::Smooth | Kind::Edge(_) => contacts.push(ContactDerivative {
                    from: place(changes[i].place),
                    to: place(changes[i].place),
                    force: certain(i, force(self.forces[i], changes[i].force)),
                    end_forces: None,
                }),
                Kind::Support(..) => supports.push(certain(i, force(total(i), changes[i].force))),
                _ => {}
            }
        }
        let mut energy = self.energy_by(of, &changes) * self.stiffness * scale.energy() / unit + 0.0;
        let places = |c: &ContactDerivative| c.from.is_finite() && c.to.is_finite();
        if self.lies() {
            // Whether the end of a stretch that lies on the ground touches it is not determined either.
            let least = AT_A_CHANGE * self.state.contact_force().abs();
            let unpressed = contacts.iter_mut().zip(&self.state.contacts).filter(|(_, c)| c.force.abs() <= least);
            unpressed.for_each(|(change, _)| (change.from, change.to) = (f64::NAN, f64::NAN));
        }
        let nodes = || 0..list.nodes.len();
        let jumps = nodes().any(jumping).then_some(Missing::Jumps);
        let crowded = || nodes().any(|i| self.crowded(i)).then_some(Missing::Crowded);
        let undetermined = || (!contacts.iter().all(places)).then_some(Missing::Undetermined);
        let missing = parts.or(jumps).or_else(undetermined).or_else(crowded);
        if parts.is_some() {
            supports.fill(f64::NAN);
            let none = ContactDerivative { from: f64::NAN, to: f64::NAN, force: f64::NAN, end_forces: None };
            contacts
                .iter_mut()
                .for_each(|c| *c = ContactDerivative { end_forces: c.end_forces.map(|_| [f64::NAN; 2]), ..none });
            energy = f64::NAN;
        }
        Derivative { by, one_sided, missing, supports, contacts, energy }
    }

    /// True if the beam lies along the ground somewhere without pressing on it, as one without weight does beyond a contact.
    fn lies(&self) -> bool {
        let size = AT_A_CHANGE * self.state.deflection.magnitude() / self.scale.depth;
        let at = |[h, slope, bend, third]: [f64; 4], l: f64| {
            [h, slope * l, bend * l * l, third * l * l * l].into_iter().all(|h| h.abs() <= size)
        };
        let along = |span: &Span| at(span.at_a, span.length()) && at(span.at_b, span.length());
        self.given.founded && self.spans.iter().any(|(_, span)| along(span))
    }

    /// True if the ground presses at node `end`, an end of the zone before node `i`.
    fn presses(&self, end: usize, i: usize) -> bool {
        let x = self.list.nodes[end].x;
        let cell = if end == i { self.given.cell_to(x) } else { self.given.cell_from(x) };
        let least = AT_A_CHANGE * self.largest_node_force().max(self.given.total_load);
        // The place of a lift-off follows from the force there; a tip stays where it is.
        let is_tip = self.list.nodes[end].kind == Kind::Tip;
        least < self.forces[end] || is_tip && least < self.given.drive(cell, x).abs() * self.given.length
    }

    /// True if a load stands on node `i`, and a zone ends there.
    fn jumps(&self, i: usize) -> bool {
        standing(&self.given, &self.list, i) != 0.0 && self.list.ends_zone(i)
    }

    /// True if the load at `at` stands on an end of a zone.
    fn ends_zone(&self, at: f64) -> bool {
        let list = &self.list;
        list.nodes.iter().enumerate().any(|(i, node)| node.x <= at && at <= node.x && list.ends_zone(i))
    }

    /// True if the load `force` at `at` stands on a zone, and it or what stands there besides pulls.
    fn pulls(&self, at: f64, force: f64) -> bool {
        let given = &self.given;
        let all = given.breakpoint_at(at).map_or(force, |i| given.breakpoints[i].force);
        let least = -AT_A_CHANGE * force.abs();
        self.list.zones().any(|zone| zone.from <= at && at <= zone.to) && force.min(all - force) < least
    }

    /// The derivative of `J / EI`, of `J` by the logarithm of `EI`.
    fn energy_by(&self, of: Change, changes: &[NodeChange]) -> f64 {
        let (given, scale) = (&self.given, &self.scale);
        let deflection = |at: f64| self.deflection(at * scale.length) / scale.depth;
        match of {
            // The energy of a part of the ground is not asked for.
            Change::GroundUnder(..) => 0.0,
            Change::Ground => {
                let contact = self.state.contact_force() / (self.stiffness * scale.force);
                -contact
            }
            Change::Unload => self.integral(|[_, _, v2, _]| 0.5 * v2 * v2),
            Change::Uniform(q) => -q * self.integral(|[v, ..]| v),
            Change::Force(at, p) => -p * deflection(at),
            Change::Move(at, p) => -p * self.slope(at * scale.length) * scale.length / scale.depth,
            Change::Level(index) | Change::Support(index, _) => {
                let Some(i) = self.list.nodes.iter().position(|node| node.support() == Some(index)) else { return 0.0 };
                let force = self.forces[i] + standing(given, &self.list, i);
                let held = self.list.nodes[i].held_slope(given).is_some() && matches!(of, Change::Support(..));
                let bends = self.bends(i);
                // Where the beam is built in the ends of its two parts move and turn.
                let [left, right] = changes[i].slopes;
                let turned = if held {
                    bends[0] * left - bends[1] * right + 0.5 * (bends[0] * bends[0] - bends[1] * bends[1])
                } else {
                    0.0
                };
                turned - force * changes[i].value
            }
        }
    }

    /// True where a force, a bend, a length or a clearance vanishes.
    fn at_a_change(&self) -> bool {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let largest = self.largest_node_force();
        let moments = self.spans.iter().flat_map(|(_, span)| [span.beam_a[2], span.beam_b[2]]);
        let bent =
            moments.fold(0.0, |most: f64, moment| most.max(moment.abs())).max(largest * given.length * AT_A_CHANGE);
        let size = self.state.deflection.magnitude() / self.scale.depth;
        let small = |value: f64, scale: f64| value.abs() <= AT_A_CHANGE * scale;
        let at_node = nodes.iter().enumerate().any(|(i, node)| match node.kind {
            Kind::Smooth => small(self.forces[i], largest) || small(bend(&self.spans, i), bent),
            Kind::Edge(_) | Kind::ZoneStart | Kind::ZoneEnd => small(self.forces[i], largest),
            Kind::Support(_, beside) => beside != [Beside::Apart; 2],
            Kind::Tip => false,
        });
        let short = self.list.zones().any(|zone| small(zone.to - zone.from, given.length));
        // Ground that carries nothing where the beam lies on it carries something as soon as a load is there.
        let carried = self.touches();
        let near = |a: f64, b: f64| small((a - b) / self.scale.length, given.length);
        let all = |(carried, whole): (&Contact, &Contact)| near(carried.from, whole.from) && near(carried.to, whole.to);
        let contacts = &self.state.contacts;
        let unloaded = carried.len() != contacts.len() || !carried.iter().map(|(_, c)| c).zip(contacts).all(all);
        let touches = |span| given.founded && lowest(given, span).is_some_and(|least| small(least, size));
        at_node || short || unloaded || self.spans.iter().any(|(_, span)| touches(span))
    }
}

/// The second derivative of a profile, which is smooth there.
fn curvature(profile: &Foundation, x: f64) -> f64 {
    match profile {
        Foundation::Flat { .. } | Foundation::Polyline { .. } => 0.0,
        Foundation::Polynomial { coefficients } => {
            #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
            let terms = coefficients.iter().enumerate().skip(2).rev().map(|(j, c)| (j * (j - 1)) as f64 * c);
            terms.fold(0.0, |sum, c| sum * x + c)
        }
        Foundation::Cosine { amplitude, wavelength, phase, .. } => {
            let rate = 2.0 * std::f64::consts::PI / wavelength;
            -amplitude * rate * rate * libm::cos(rate * x + phase)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Load};
    use crate::theory::solve;

    /// The paper's example: T = q a/2 with a⁴ = 24 EI u₀/q, so that ∂T/∂u₀ = T/4u₀, ∂T/∂q = 3T/4q, ∂T/∂EI = T/4EI.
    #[test]
    fn the_example_has_those_of_its_closed_form() {
        let stiffness = 500.0 / 384.0;
        let beam = Beam::new(10.0, stiffness).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
        let exact = solve(&scene).expect("an answer");
        let t = exact.state.reactions.left;
        let derivatives = exact.derivatives(&scene);
        let of = |by: &str| derivatives.iter().find(|d| d.by.to_string() == by).expect("a derivative");
        for (by, expected) in
            [("depth", t / 4.0), ("load.uniform", 3.0 * t / 4.0), ("beam.bending_stiffness", t / 4.0 / stiffness)]
        {
            let derivative = of(by);
            assert!(!derivative.one_sided, "{by}");
            let ends = derivative.contacts[0].end_forces.expect("a zone");
            for found in [derivative.supports[0], derivative.supports[1], ends[0], ends[1]] {
                assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{by}: {found} for {expected}");
            }
        }
        let energy = of("depth").energy;
        assert!((energy + 10.0 - 2.0 * t).abs() <= 1e-12 * energy.abs(), "{energy}");
        let from = of("depth").contacts[0].from;
        assert!((from - t / 2.0).abs() <= 1e-12, "a = 2T/q");
    }
}
