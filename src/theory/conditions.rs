//! The conditions of an answer, and on which sides of a change of the scene they hold: a derivative is that of one side where one ends
//! within a change that is too small to mean anything.

use super::changes::AT_A_CHANGE;
use super::exact::Exact;
use super::forces::{force_beside, pulling_couple};
use super::list::Node;
use super::margin::lowest;
use super::sensitivity::{Change, NodeChange, bend};
use super::span::Span;
use crate::state::Contact;

/// A condition of the answer that may fail to one side of the scene.
#[derive(Debug, Clone, Copy)]
pub(super) enum OneSidedCondition {
    /// This node presses.
    Force(usize),
    /// Ground and the support of this node push at each other.
    Couple(usize),
    /// The beam leaves the ground on that side of this node.
    Bend(usize, usize),
    /// The zone that ends at this node does so on one side of a change of the load.
    Place(usize),
    /// The zone that ends at this node has a length.
    Length(usize),
    /// The beam clears the ground in the span of this index; where it lies along it, beside its left or its right end.
    Span(usize, usize),
    /// The zone before this node presses everywhere.
    Zone(usize),
    /// This cell, in a zone, presses at this breakpoint, inside the zone or at an end of it that stays there.
    Pressure(usize, usize),
}

/// The conditions of an answer, and what each has to spare, as a force, a bend, a length or a clearance: nothing where that is rounding.
#[derive(Debug, Default)]
pub(super) struct Conditions {
    all: Vec<(OneSidedCondition, f64)>,
    /// The largest force that acts on the beam, also of what stands on a support: the size of a load.
    largest: f64,
}

/// On which sides of a change the conditions hold that have a sign.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kept {
    /// As the number falls, and as it grows.
    pub(super) sides: [bool; 2],
    /// None ends on either side, and all of them have a sign.
    pub(super) both: bool,
    /// One that ends has something to spare in this scene.
    pub(super) soon: bool,
}

impl Exact {
    /// A change of no meaning, [`AT_A_CHANGE`] of the size of the number, in units of the change.
    fn least(&self, of: Change, largest: f64) -> f64 {
        let size = match of {
            Change::Ground | Change::GroundUnder(..) | Change::Level(_) => {
                self.state.deflection.magnitude() / self.scale.depth
            }
            Change::Unload | Change::Stiffen => 1.0,
            Change::Uniform(q) => largest / (q * self.given.length),
            Change::Force(_, p) => largest / p,
            Change::Move(..) | Change::Support(..) => self.given.length,
        };
        AT_A_CHANGE * size.abs()
    }

    /// True where the load changes its formula, or a point load stands, no farther away than `near`: what follows from the load beside
    /// an end of a zone is another on its two sides.
    fn is_at_load(&self, x: f64, near: f64) -> bool {
        let given = &self.given;
        given.breakpoints_inside((x - near).max(0.0), (x + near).min(given.length)).any(|i| given.load_changes_at(i))
    }

    /// The conditions of the answer that a change of the scene may end.
    pub(super) fn conditions(&self) -> Conditions {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let largest = self.largest_node_force();
        // What the forces beside a node can bend, or the loads on a beam at rest: what is small beside that is rounding.
        let bent = |i: usize| {
            let spans = super::sensitivity::ends(&self.spans, i).into_iter().flatten();
            let beside = force_beside(&self.spans, i) * spans.fold(0.0, |most: f64, span| most.max(span.length()));
            beside.max(self.rest() * given.length)
        };
        let small = |value: f64, scale: f64| value.abs() <= AT_A_CHANGE * scale;
        let spare = |value: f64, scale: f64| if small(value, scale) { 0.0 } else { value.abs() };
        let mut all = Vec::new();
        for (i, node) in nodes.iter().enumerate() {
            let mut add =
                |is: bool, condition: OneSidedCondition, spare: f64| all.extend(is.then_some((condition, spare)));
            let force = spare(self.forces[i], largest);
            match node.support(given) {
                None if node.is_point(given) => {
                    add(true, OneSidedCondition::Force(i), force);
                    let bend = if node.can_move() { spare(bend(&self.spans, i), bent(i)) } else { f64::INFINITY };
                    [0, 1].into_iter().for_each(|side| add(node.can_move(), OneSidedCondition::Bend(i, side), bend));
                }
                None if node.can_move() => {
                    add(true, OneSidedCondition::Force(i), force);
                    add(force == 0.0, OneSidedCondition::Bend(i, usize::from(node.ends_zone())), 0.0);
                    add(true, OneSidedCondition::Place(i), 0.0);
                }
                Some(index) if node.is_held() => all.extend(self.support_conditions(i, index, bent(i))),
                None => {
                    let zone = if self.list.in_zone_before(i) { i } else { i + 1 };
                    add(!self.presses(i, zone), OneSidedCondition::Force(i), 0.0);
                }
                Some(_) => {}
            }
        }
        let lengths = self
            .list
            .zones()
            .map(|zone| (OneSidedCondition::Length(zone.node), spare(zone.to - zone.from, given.length)));
        all.extend(lengths);
        // Ground that carries nothing where the beam lies on it carries something as soon as a load is there.
        let carried = self.contacts_by_kind();
        let near = |a: f64, b: f64| small((a - b) / self.scale.length, given.length);
        let same =
            |(carried, whole): (&Contact, &Contact)| near(carried.from, whole.from) && near(carried.to, whole.to);
        let contacts = &self.state.contacts;
        let unloaded = carried.len() != contacts.len() || !carried.iter().map(|(_, c)| c).zip(contacts).all(same);
        all.extend(self.list.zones().filter(|_| unloaded).map(|zone| (OneSidedCondition::Zone(zone.node), 0.0)));
        all.extend(self.list.zones().flat_map(|zone| self.unpressed(zone.node)).map(|condition| (condition, 0.0)));
        if given.has_obstacle() {
            let clearances =
                self.spans.iter().enumerate().filter_map(|(j, (_, span))| Some((j, lowest(given, span)?.abs())));
            all.extend(clearances.flat_map(|(j, least)| [0, 1].map(|end| (OneSidedCondition::Span(j, end), least))));
        }
        let exerted = (0..nodes.len()).map(|i| self.exerted(i).abs());
        Conditions { all, largest: exerted.fold(self.largest_force(), f64::max) }
    }

    /// Those at a support where the ground holds the slope, beside what can be `bent` there.
    fn support_conditions(&self, i: usize, index: usize, bent: f64) -> impl Iterator<Item = (OneSidedCondition, f64)> {
        let given = &self.given;
        let size = self.state.deflection.magnitude() / self.scale.depth;
        let small = |value: f64, scale: f64| value.abs() <= AT_A_CHANGE * scale;
        let [left, right] = self.bends(i);
        let couple = small(right - left, bent.max(self.largest_node_force() * given.length));
        let ends = super::sensitivity::ends(&self.spans, i);
        let clear = [ends[0].map(|span| span.at_b), ends[1].map(|span| span.at_a)];
        let bends = [0, 1].map(|side| {
            let bridged = given.supports[index].clearance[side] <= AT_A_CHANGE * size;
            let level = clear[side].is_some_and(|[_, slope, ..]| small(slope * given.length, size));
            let straight = clear[side].is_some_and(|[_, _, bend, _]| small(bend, bent));
            (bridged && level && straight, OneSidedCondition::Bend(i, side))
        });
        let at = [(couple, OneSidedCondition::Couple(i)), (self.list.ends_zone(i), OneSidedCondition::Place(i))];
        at.into_iter().chain(bends).filter_map(|(is, condition)| is.then_some((condition, 0.0)))
    }

    /// Where a zone does not press at a change of the load inside it, or at an end that stays where it is.
    fn unpressed(&self, node: usize) -> Vec<OneSidedCondition> {
        let (given, ends) = (&self.given, [node - 1, node].map(|i| &self.list.nodes[i]));
        let [from, to] = ends.map(|end| end.x);
        let stays = |end: &Node| !end.can_move();
        let least = AT_A_CHANGE * self.largest_force();
        let (first, last) = (given.cell_from(from), given.cell_to(to));
        let sides = (first..=last).flat_map(|cell| [(cell, cell), (cell + 1, cell)]);
        let fixed = sides.filter(|&(breakpoint, _)| {
            let x = given.breakpoints[breakpoint].x;
            from < x && x < to || x <= from && from <= x && stays(ends[0]) || x <= to && to <= x && stays(ends[1])
        });
        let presses = |x: f64, cell: usize| least < given.drive(cell, x).abs() * given.length;
        let none = fixed.filter(|&(breakpoint, cell)| !presses(given.breakpoints[breakpoint].x, cell));
        none.map(|(breakpoint, cell)| OneSidedCondition::Pressure(breakpoint, cell)).collect()
    }

    /// How a condition with nothing to spare over the `least` change changes itself: below zero it fails, [`None`] where it is of no sign
    /// and not zero.
    fn rate(&self, condition: OneSidedCondition, of: Change, changes: &[NodeChange], least: f64) -> Option<f64> {
        let zero = |is: bool| is.then_some(0.0);
        match condition {
            OneSidedCondition::Force(i) => Some(rounded(changes[i].force, changes[i].ends.third)),
            OneSidedCondition::Couple(i) => {
                let index = self.list.nodes[i].support(&self.given)?;
                let [left, right] = changes[i].ends.bend;
                let jump = rounded(left - right, [left, right]);
                Some(-pulling_couple(&self.given, index, self.list.rests(i), jump).unwrap_or(0.0))
            }
            OneSidedCondition::Bend(i, side) => {
                let bends = changes[i].ends.bend;
                zero(rounded(bends[side], bends) == 0.0)
            }
            OneSidedCondition::Place(i) => {
                let place = changes[i].place;
                let near = (least * place.abs()).max(AT_A_CHANGE * self.given.length);
                zero(place == 0.0 || !self.is_at_load(self.list.nodes[i].x, near))
            }
            OneSidedCondition::Length(_) => None,
            OneSidedCondition::Span(j, end) => {
                let rises = Self::rises(&self.spans[j], of, changes);
                let rises = rises.map(|end| end.into_iter().find(|rise| *rise != 0.0).unwrap_or(0.0));
                let stays = rises.iter().all(|rise| *rise == 0.0);
                (stays || self.lies_along(&self.spans[j].1)).then_some(rises[end])
            }
            OneSidedCondition::Pressure(breakpoint, cell) => Some(match of {
                Change::Uniform(more) => more,
                Change::Unload => -self.given.load(cell, self.given.breakpoints[breakpoint].x),
                _ => 0.0,
            }),
            OneSidedCondition::Zone(i) => {
                let [from, to] = [i - 1, i].map(|end| self.list.nodes[end].x);
                zero(!matches!(of, Change::Uniform(_)) && !matches!(of, Change::Force(at, _) if from <= at && at <= to))
            }
        }
    }

    /// How fast what a condition has to spare changes.
    fn speed(&self, condition: OneSidedCondition, of: Change, changes: &[NodeChange]) -> f64 {
        match condition {
            OneSidedCondition::Force(i) => rounded(changes[i].force, changes[i].ends.third).abs(),
            OneSidedCondition::Bend(i, side) => {
                let [left, right] = super::sensitivity::ends(&self.spans, i);
                let third = [left.map(|span| span.at_b[3]), right.map(|span| span.at_a[3])][side].unwrap_or(0.0);
                changes[i].ends.bend[side].abs() + (third * changes[i].place).abs()
            }
            OneSidedCondition::Length(i) => (changes[i].place - changes[i - 1].place).abs(),
            OneSidedCondition::Span(j, _) => {
                let rises = Self::rises(&self.spans[j], of, changes);
                rises.as_flattened().iter().fold(0.0, |most, rise| most.max(rise.abs()))
            }
            _ => 0.0,
        }
    }

    /// How the clearance of a span or overhang changes beside its left and its right end: its value and derivatives there, times powers
    /// of the length, without what is rounding.
    fn rises(&(right, ref span): &(usize, Span), of: Change, changes: &[NodeChange]) -> [[f64; 4]; 2] {
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
        ends.map(|end| end.map(|rise| if least < rise.abs() { rise } else { 0.0 }))
    }

    /// Where the answer keeps the conditions that it holds with nothing to spare over a change of no meaning.
    pub(super) fn keeps(&self, conditions: &Conditions, of: Change, changes: &[NodeChange]) -> Kept {
        let least = self.least(of, conditions.largest);
        let weak = |&&(condition, spare): &&(OneSidedCondition, f64)| {
            spare == 0.0 || spare <= least * self.speed(condition, of, changes)
        };
        let mut kept = Kept { sides: [true; 2], both: true, soon: false };
        for &(condition, spare) in conditions.all.iter().filter(weak) {
            let rate = self.rate(condition, of, changes, least);
            kept.both &= rate == Some(0.0);
            if let Some(rate) = rate {
                let keeps = [rate <= 0.0, 0.0 <= rate];
                kept.soon |= 0.0 < spare && keeps != [true; 2];
                kept.sides = [0, 1].map(|side| kept.sides[side] && keeps[side]);
            }
        }
        kept
    }
}

/// A value that is not rounding of those that it is the difference of.
fn rounded(value: f64, of: [f64; 2]) -> f64 {
    if value.abs() <= AT_A_CHANGE * of[0].abs().max(of[1].abs()) { 0.0 } else { value }
}
