//! What an answer does where its kind changes: ground that is level with supports, loads at the ends of zones, stretches that lie
//! along the ground.

use super::exact::Exact;
use super::list::Node;
use super::missing::Missing;
use super::piecewise::{AtSupport, Cell};
use super::sensitivity::{Change, standing};
use super::span::{EndCondition, Span};
use crate::scene::{Foundation, Held, Scene};

/// The ground at a support.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ground {
    /// It starts at the level of the support, and cannot rise.
    pub(super) at_level: bool,
    /// The beam lies on it beside the support, and how it leaves it.
    pub(super) rests: Option<Missing>,
    /// It is level around the support, which may move along it: no load stands there.
    pub(super) flat: bool,
    /// The slope of the axis of the beam to its left and to its right.
    pub(super) axis: [f64; 2],
}

/// A contact force, a bend or a clearance below this share of the largest one is zero: there the kind of the answer changes. So it does
/// where a number of the scene that changes by this share of its size ends it: no number of a scene is known to nine digits, and
/// conditions are met to twelve.
pub(super) const AT_A_CHANGE: f64 = 1e-9;

impl Exact {
    /// What the ground does at the supports, from left to right.
    pub(super) fn at_supports(&self, scene: &Scene) -> Vec<Ground> {
        if self.springs.is_some() {
            let at_level = |held: &Held| held.at_level.contains(&true);
            return scene.held().iter().map(|held| Ground { at_level: at_level(held), ..Ground::default() }).collect();
        }
        let nodes = self.list.nodes.iter().enumerate();
        let held = scene.held();
        let ground = |(i, node): (usize, &Node)| Some(self.at_support(scene, i, &held[node.support(&self.given)?]));
        nodes.filter_map(ground).collect()
    }

    fn at_support(&self, scene: &Scene, i: usize, held: &Held) -> Ground {
        let (given, length) = (&self.given, scene.beam().length());
        let node = &self.list.nodes[i];
        let Some(index) = node.support(given) else { return Ground::default() };
        let support = &given.supports[index];
        let bridged = self.bridged(support);
        let unresolved = self.unresolved(i);
        let by_ground = !support.built_in && support.slope.is_some();
        let at_level = bridged || held.at_level.contains(&true);
        let loaded = standing(given, &self.list, i) != 0.0;
        // A load that leaves the support for a stretch that lies on the ground presses there at once.
        let leaves = at_level && loaded && self.lies();
        let rests = (by_ground || leaves || node.is_held() || unresolved).then(|| {
            let pushes = |zone: bool, cell: usize| zone && given.drive(cell, node.x) != 0.0;
            let pressed = pushes(self.list.in_zone_before(i), given.cell_to(node.x))
                || pushes(self.list.in_zone_before(i + 1), given.cell_from(node.x));
            let [left, right] = self.bends(i);
            let couple = AT_A_CHANGE * self.largest_node_force() * given.length < (right - left).abs();
            if pressed || couple || unresolved { Missing::Parts } else { Missing::Unloaded }
        });
        // Level ground on both sides, where there is a beam.
        let flat = scene.foundation().is_some_and(|ground| {
            let level = ground.sides(held.at).into_iter().all(|[_, slope]| slope == 0.0);
            !loaded && level && curvature(ground, held.at) == 0.0 && held.at_level == [0.0 < held.at, held.at < length]
        });
        let ends = super::sensitivity::ends(&self.spans, i);
        let slope = ends[0].map(|span| span.beam_b[1]).or(ends[1].map(|span| span.beam_a[1])).unwrap_or(0.0);
        let own = scene.beam().shape().map_or([0.0; 2], |own| own.sides(held.at).map(|[_, slope]| slope));
        let axis = own.map(|own| own + slope * self.scale.depth / self.scale.length);
        Ground { at_level, rests, flat, axis }
    }

    /// True if the gap between a support and the ground is none, or next to none.
    fn bridged(&self, support: &AtSupport) -> bool {
        let size = self.state.deflection.magnitude() / self.scale.depth;
        self.given.founded && support.clearance.into_iter().any(|gap| gap <= AT_A_CHANGE * size)
    }

    /// True of a support and of a contact that are side by side: a gap that is small is bridged over a distance that is small as
    /// its root.
    pub(super) fn unresolved(&self, i: usize) -> bool {
        let nodes = &self.list.nodes;
        let near = |[a, b]: [&Node; 2]| {
            let [left, right] = [a, b].map(|node| node.support(&self.given));
            let support = left.or(right).map(|index| &self.given.supports[index]);
            left.is_some() != right.is_some()
                && (b.x - a.x).abs() <= AT_A_CHANGE.sqrt() * self.given.length
                && support.is_some_and(|support| self.bridged(support))
        };
        let beside = |left: usize| nodes.get(left).zip(nodes.get(left + 1)).is_some_and(|(a, b)| near([a, b]));
        beside(i) || i.checked_sub(1).is_some_and(beside)
    }

    /// `v''` to the left and to the right of a node, that of the ground in a zone, and zero where there is no beam.
    pub(super) fn bends(&self, i: usize) -> [f64; 2] {
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

    pub(super) fn largest_node_force(&self) -> f64 {
        self.forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()))
    }

    /// Of the nodes, or all loads between them.
    pub(super) fn largest_force(&self) -> f64 {
        self.largest_node_force().max(self.given.total_load)
    }

    /// True if the beam lies along the ground somewhere without pressing on it, as one without weight does beyond a contact.
    pub(super) fn lies(&self) -> bool {
        self.given.founded && self.spans.iter().any(|(_, span)| self.lies_along(span))
    }

    /// However little a short span clears the ground, it does not lie along it under a load.
    pub(super) fn lies_along(&self, span: &Span) -> bool {
        let size = AT_A_CHANGE * self.state.deflection.magnitude() / self.scale.depth;
        let at = |[h, slope, bend, third]: [f64; 4], l: f64| {
            [h, slope * l, bend * l * l, third * l * l * l].into_iter().all(|h| h.abs() <= size)
        };
        at(span.at_a, span.length()) && at(span.at_b, span.length()) && !self.is_loaded(span)
    }

    /// True if what acts inside a span, or on a free end of it, is more than rounding of the largest force.
    fn is_loaded(&self, span: &Span) -> bool {
        let (given, [from, to]) = (&self.given, [span.a.x, span.b.x]);
        let spread = (given.cell_from(from)..=given.cell_to(to)).map(|i| {
            let (lo, hi) = (given.cells[i].lo.max(from), given.cells[i].hi.min(to));
            (hi - lo) * given.load(i, lo).abs().max(given.load(i, hi).abs())
        });
        let free = [&span.a, &span.b].into_iter().filter(|end| end.hold == EndCondition::Free);
        let at = given.breakpoints_inside(from, to).chain(free.filter_map(|end| given.breakpoint_at(end.x)));
        let loads: f64 = spread.sum::<f64>() + at.map(|i| given.breakpoints[i].force.abs()).sum::<f64>();
        AT_A_CHANGE * self.largest_force() < loads
    }

    /// True if a contact begins, lies or ends where no load drives the beam onto the ground: one answer has several lists of contacts
    /// there. On ground that gives there is no list.
    pub(crate) fn touches_without_load(&self) -> bool {
        let given = &self.given;
        let straight = |shape: usize| given.shapes[shape].degree().is_some_and(|degree| degree < 4);
        let idle = |cell: &Cell| cell.load == 0.0 && cell.load_slope == 0.0 && straight(cell.shape);
        self.springs.is_none()
            && self.state.contacts.iter().any(|contact| {
                let [from, to] = [contact.from, contact.to].map(|x| x / self.scale.length);
                given.cells.get(given.cell_to(from)..=given.cell_from(to)).is_some_and(|cells| cells.iter().any(idle))
            })
    }

    /// True if the ground presses at node `end`, an end of the zone before node `i`.
    pub(super) fn presses(&self, end: usize, i: usize) -> bool {
        let (given, node) = (&self.given, &self.list.nodes[end]);
        let cell = if end == i { given.cell_to(node.x) } else { given.cell_from(node.x) };
        let least = AT_A_CHANGE * self.largest_force();
        // The place of a lift-off follows from the force there; a tip or a support is where it is.
        let middle = 0.5 * (given.cells[cell].lo + given.cells[cell].hi);
        let pushes = [node.x, middle].into_iter().any(|x| least < given.drive(cell, x).abs() * given.length);
        let has_force = || least < self.forces[end];
        match node.support(given) {
            Some(_) => pushes,
            None if node.can_move() => has_force(),
            None => pushes || has_force(),
        }
    }

    /// True if the force at the end of a zone at node `i`, which moves in the direction of `place`, jumps: a load that stands there goes
    /// into the zone or out of it.
    pub(super) fn jumps(&self, i: usize, of: Change, place: f64) -> bool {
        let node = &self.list.nodes[i];
        let loaded = standing(&self.given, &self.list, i) != 0.0;
        match of {
            Change::Move(at, _) if node.x <= at && at <= node.x => self.list.ends_zone(i),
            Change::Support(moved, _) if node.support(&self.given) == Some(moved) => loaded && self.list.ends_zone(i),
            _ if node.starts_zone() => loaded && place < 0.0,
            _ if node.ends_zone() => loaded && 0.0 < place,
            _ => false,
        }
    }

    /// True if the load at `at` stands on an end of a zone.
    pub(super) fn ends_zone(&self, at: f64) -> bool {
        let list = &self.list;
        list.nodes.iter().enumerate().any(|(i, node)| node.x <= at && at <= node.x && list.ends_zone(i))
    }

    /// True if the load `force` at `at` stands on a zone, and it or what stands there besides pulls.
    pub(super) fn pulls(&self, at: f64, force: f64) -> bool {
        let given = &self.given;
        let all = given.breakpoint_at(at).map_or(force, |i| given.breakpoints[i].force);
        let least = -AT_A_CHANGE * force.abs();
        self.list.zones().any(|zone| zone.from <= at && at <= zone.to) && force.min(all - force) < least
    }
}

/// The second derivative of a profile, which is smooth there.
pub(super) fn curvature(profile: &Foundation, x: f64) -> f64 {
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
