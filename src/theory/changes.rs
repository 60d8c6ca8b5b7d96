//! Where the kind of an answer changes: what vanishes, ground that is level with supports, loads at the ends of zones.

use super::derivatives::Missing;
use super::exact::Exact;
use super::forces::{force_beside, pulling_couple};
use super::list::Node;
use super::margin::lowest;
use super::piecewise::{AtSupport, Cell};
use super::sensitivity::{Change, NodeChange, bend, standing};
use super::span::Span;
use crate::scene::{Foundation, Held, Scene};
use crate::state::Contact;

/// The ground at a support.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ground {
    /// It starts at the level of the support, and cannot rise.
    pub(super) meets: bool,
    /// The beam lies on it beside the support, and how it leaves it.
    pub(super) rests: Option<Missing>,
    /// It is level around the support, which may move along it: no load stands there.
    pub(super) level: bool,
    /// The slope of the axis of the beam to its left and to its right.
    pub(super) axis: [f64; 2],
}

/// A condition of the answer that holds with nothing to spare: to one side of the scene it may fail.
#[derive(Debug, Clone, Copy)]
pub(super) enum Weak {
    /// This node presses.
    Force(usize),
    /// Ground and the support of this node push at each other.
    Couple(usize),
    /// The beam leaves the ground on that side of this node.
    Bend(usize, usize),
    /// The zone that ends at this node does so on one side of a change of the load.
    Place(usize),
    /// A zone has a length.
    Length,
    /// The beam clears the ground in the span of this index; where it lies along it, beside its left or its right end.
    Span(usize, usize),
    /// The zone before this node presses everywhere.
    Zone(usize),
    /// This cell, in a zone, presses at this breakpoint, inside the zone or at an end of it that stays there.
    Pressure(usize, usize),
}

/// A contact force, a bend or a clearance below this share of the largest one is zero: there the kind of the answer changes.
pub(super) const AT_A_CHANGE: f64 = 1e-9;

impl Exact {
    /// What the ground does at the supports, from left to right.
    pub(super) fn at_supports(&self, scene: &Scene) -> Vec<Ground> {
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
        let crowded = self.crowded(i);
        let by_ground = !support.built_in && support.slope.is_some();
        let meets = bridged || held.meets.contains(&true);
        let loaded = standing(given, &self.list, i) != 0.0;
        // A load that leaves the support for a stretch that lies on the ground presses there at once.
        let leaves = meets && loaded && self.lies();
        let rests = (by_ground || leaves || node.is_held() || crowded).then(|| {
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
            !loaded && flat && curvature(ground, held.at) == 0.0 && held.meets == [0.0 < held.at, held.at < length]
        });
        let ends = super::sensitivity::ends(&self.spans, i);
        let slope = ends[0].map(|span| span.beam_b[1]).or(ends[1].map(|span| span.beam_a[1])).unwrap_or(0.0);
        let own = scene.beam().shape().map_or([0.0; 2], |own| own.sides(held.at).map(|[_, slope]| slope));
        let axis = own.map(|own| own + slope * self.scale.depth / self.scale.length);
        Ground { meets, rests, level, axis }
    }

    /// True if the gap between a support and the ground is none, or next to none.
    fn bridged(&self, support: &AtSupport) -> bool {
        let size = self.state.deflection.magnitude() / self.scale.depth;
        self.given.founded && support.clearance.into_iter().any(|gap| gap <= AT_A_CHANGE * size)
    }

    /// True of a support and of a contact that are side by side: a gap that is small is bridged over a distance that is small as
    /// its root.
    pub(super) fn crowded(&self, i: usize) -> bool {
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

    fn largest_node_force(&self) -> f64 {
        self.forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()))
    }

    /// True if the beam lies along the ground somewhere without pressing on it, as one without weight does beyond a contact.
    pub(super) fn lies(&self) -> bool {
        self.given.founded && self.spans.iter().any(|(_, span)| self.lies_along(span))
    }

    fn lies_along(&self, span: &Span) -> bool {
        let size = AT_A_CHANGE * self.state.deflection.magnitude() / self.scale.depth;
        let at = |[h, slope, bend, third]: [f64; 4], l: f64| {
            [h, slope * l, bend * l * l, third * l * l * l].into_iter().all(|h| h.abs() <= size)
        };
        at(span.at_a, span.length()) && at(span.at_b, span.length())
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
        let least = AT_A_CHANGE * self.largest_node_force().max(given.total_load);
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

    /// True where the load changes its formula, or a point load stands: what follows from the load beside an end of a zone is another
    /// on its two sides.
    fn is_at_load(&self, x: f64) -> bool {
        let (given, near) = (&self.given, AT_A_CHANGE * self.given.length);
        given.breakpoints_inside((x - near).max(0.0), (x + near).min(given.length)).any(|i| given.load_changes_at(i))
    }

    /// The conditions of the answer that hold with nothing to spare.
    pub(super) fn weak(&self) -> Vec<Weak> {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let largest = self.largest_node_force();
        // What the forces beside a node can bend, or the loads on a beam at rest: what is small beside that is rounding.
        let bent = |i: usize| {
            let spans = super::sensitivity::ends(&self.spans, i).into_iter().flatten();
            let beside = force_beside(&self.spans, i) * spans.fold(0.0, |most: f64, span| most.max(span.length()));
            beside.max(self.rest() * given.length)
        };
        let size = self.state.deflection.magnitude() / self.scale.depth;
        let small = |value: f64, scale: f64| value.abs() <= AT_A_CHANGE * scale;
        let mut weak = Vec::new();
        for (i, node) in nodes.iter().enumerate() {
            let mut add = |is: bool, conditions: &[Weak]| weak.extend(conditions.iter().filter(|_| is));
            match node.support(given) {
                None if node.is_point(given) => {
                    add(small(self.forces[i], largest), &[Weak::Force(i)]);
                    add(node.can_move() && small(bend(&self.spans, i), bent(i)), &[Weak::Bend(i, 0), Weak::Bend(i, 1)]);
                }
                None if node.can_move() => {
                    let outer = usize::from(node.ends_zone());
                    add(small(self.forces[i], largest), &[Weak::Force(i), Weak::Bend(i, outer)]);
                    add(self.is_at_load(node.x), &[Weak::Place(i)]);
                }
                Some(index) if node.is_held() => {
                    let [left, right] = self.bends(i);
                    add(small(right - left, bent(i).max(largest * given.length)), &[Weak::Couple(i)]);
                    add(self.list.ends_zone(i) && self.is_at_load(node.x), &[Weak::Place(i)]);
                    let ends = super::sensitivity::ends(&self.spans, i);
                    let clear = [ends[0].map(|span| span.at_b), ends[1].map(|span| span.at_a)];
                    let bridged = given.supports[index].clearance.map(|gap| gap <= AT_A_CHANGE * size);
                    for side in [0, 1] {
                        let level = clear[side].is_some_and(|[_, slope, ..]| small(slope * given.length, size));
                        let straight = clear[side].is_some_and(|[_, _, bend, _]| small(bend, bent(i)));
                        add(bridged[side] && level && straight, &[Weak::Bend(i, side)]);
                    }
                }
                None => {
                    let zone = if self.list.in_zone_before(i) { i } else { i + 1 };
                    add(!self.presses(i, zone), &[Weak::Force(i)]);
                }
                Some(_) => {}
            }
        }
        let short = self.list.zones().any(|zone| small(zone.to - zone.from, given.length));
        weak.extend(short.then_some(Weak::Length));
        // Ground that carries nothing where the beam lies on it carries something as soon as a load is there.
        let carried = self.touches();
        let near = |a: f64, b: f64| small((a - b) / self.scale.length, given.length);
        let all = |(carried, whole): (&Contact, &Contact)| near(carried.from, whole.from) && near(carried.to, whole.to);
        let contacts = &self.state.contacts;
        let unloaded = carried.len() != contacts.len() || !carried.iter().map(|(_, c)| c).zip(contacts).all(all);
        weak.extend(self.list.zones().filter(|_| unloaded).map(|zone| Weak::Zone(zone.node)));
        weak.extend(self.list.zones().flat_map(|zone| self.unpressed(zone.node)));
        let touches = |span| given.has_obstacle() && lowest(given, span).is_some_and(|least| small(least, size));
        let spans = (0..self.spans.len()).filter(|&j| touches(&self.spans[j].1));
        weak.extend(spans.flat_map(|j| [Weak::Span(j, 0), Weak::Span(j, 1)]));
        weak
    }

    /// Where a zone does not press at a change of the load inside it, or at an end that stays where it is.
    fn unpressed(&self, node: usize) -> Vec<Weak> {
        let (given, ends) = (&self.given, [node - 1, node].map(|i| &self.list.nodes[i]));
        let [from, to] = ends.map(|end| end.x);
        let stays = |end: &Node| !end.can_move();
        let least = AT_A_CHANGE * self.largest_node_force().max(given.total_load);
        let (first, last) = (given.cell_from(from), given.cell_to(to));
        let sides = (first..=last).flat_map(|cell| [(cell, cell), (cell + 1, cell)]);
        let fixed = sides.filter(|&(breakpoint, _)| {
            let x = given.breakpoints[breakpoint].x;
            from < x && x < to || x <= from && from <= x && stays(ends[0]) || x <= to && to <= x && stays(ends[1])
        });
        let presses = |x: f64, cell: usize| least < given.drive(cell, x).abs() * given.length;
        let none = fixed.filter(|&(breakpoint, cell)| !presses(given.breakpoints[breakpoint].x, cell));
        none.map(|(breakpoint, cell)| Weak::Pressure(breakpoint, cell)).collect()
    }

    /// How a condition with nothing to spare changes: a number below which it fails, [`None`] where it is of no sign and not zero.
    fn rate(&self, weak: Weak, of: Change, changes: &[NodeChange]) -> Option<f64> {
        let rounded = |value: f64, of: [f64; 2]| {
            if value.abs() <= AT_A_CHANGE * of[0].abs().max(of[1].abs()) { 0.0 } else { value }
        };
        let zero = |is: bool| is.then_some(0.0);
        match weak {
            Weak::Force(i) => Some(rounded(changes[i].force, changes[i].ends.third)),
            Weak::Couple(i) => {
                let index = self.list.nodes[i].support(&self.given)?;
                let [left, right] = changes[i].ends.bend;
                let jump = rounded(left - right, [left, right]);
                Some(-pulling_couple(&self.given, index, self.list.rests(i), jump).unwrap_or(0.0))
            }
            Weak::Bend(i, side) => {
                let bends = changes[i].ends.bend;
                zero(rounded(bends[side], bends) == 0.0)
            }
            Weak::Place(i) => zero(changes[i].place == 0.0),
            Weak::Length => None,
            Weak::Span(j, end) => {
                let rises = Self::rises(&self.spans[j], of, changes);
                let stays = rises.iter().all(|rise| *rise == 0.0);
                (stays || self.lies_along(&self.spans[j].1)).then_some(rises[end])
            }
            Weak::Pressure(breakpoint, cell) => Some(match of {
                Change::Uniform(more) => more,
                Change::Unload => -self.given.load(cell, self.given.breakpoints[breakpoint].x),
                _ => 0.0,
            }),
            Weak::Zone(i) => {
                let [from, to] = [i - 1, i].map(|end| self.list.nodes[end].x);
                zero(!matches!(of, Change::Uniform(_)) && !matches!(of, Change::Force(at, _) if from <= at && at <= to))
            }
        }
    }

    /// How the clearance of a span or overhang changes beside its left and its right end: the first of its value and derivatives there
    /// that is not zero, times powers of the length.
    fn rises(&(right, ref span): &(usize, Span), of: Change, changes: &[NodeChange]) -> [f64; 2] {
        let (sunk, l) = (f64::from(u8::from(of == Change::Ground)), span.length());
        let at = |node: Option<&NodeChange>, side: usize, inwards: f64| {
            node.map_or([0.0; 4], |NodeChange { value, slopes, ends, .. }| {
                let (turn, third) = (inwards * slopes[side], inwards * ends.third[side]);
                [sunk - value, -turn * l, -ends.bend[side] * l * l, -third * l * l * l]
            })
        };
        let left = right.checked_sub(1).and_then(|left| changes.get(left));
        let ends = [at(left, 1, 1.0), at(changes.get(right), 0, -1.0)];
        let least = AT_A_CHANGE * ends.as_flattened().iter().fold(0.0, |most: f64, rise| most.max(rise.abs()));
        ends.map(|end| end.into_iter().find(|rise| least < rise.abs()).unwrap_or(0.0))
    }

    /// On which sides of a change, as the number falls and as it grows, the answer keeps the conditions that it holds with nothing to
    /// spare, of those that have a sign; and whether there are such that keep on neither, or have none.
    pub(super) fn keeps(&self, weak: &[Weak], of: Change, changes: &[NodeChange]) -> ([bool; 2], bool) {
        let rates = weak.iter().map(|&weak| self.rate(weak, of, changes));
        rates.fold(([true; 2], true), |([falls, grows], both), rate| match rate {
            None => ([falls, grows], false),
            Some(rate) => ([falls && rate <= 0.0, grows && 0.0 <= rate], both && rate == 0.0),
        })
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
