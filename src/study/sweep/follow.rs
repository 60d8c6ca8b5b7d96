//! Follows contacts from one answer to the next to find events.
//!
//! From each value on, the contacts of its answer are kept and only move. Every condition that they violate at the end of an interval
//! has a margin: a contact force, the bend beside a point, the length of a zone or a clearance. The first root of these margins is
//! the event. Just beyond the event the beam is solved again, and the rest of the interval is treated in the same way. If no margin
//! can be followed, the kind of the answer itself is bisected. Between two answers of one kind, a margin that comes close to zero on
//! the way is followed to its least value.

use std::collections::HashMap;

use super::events::{At, BESIDE, PAST, Root, Search};
use super::{GOLDEN, last, root};
use crate::theory::{Condition, Exact};

/// Factors on the distance from an event at which the scene is solved again if the kind of the answer is not clear.
pub(super) const FARTHER: [f64; 4] = [1.0, 1e2, 1e4, 1e6];

/// Largest number of events between two rows: more would be rounding.
const MOST_EVENTS: usize = 1000;

impl Search<'_> {
    /// Whether all allowed work has been done.
    pub(super) fn is_spent(&self) -> bool {
        self.left.get() == 0
    }

    /// Counts work against the limit.
    fn count(&self, work: u64) {
        self.left.set(self.left.get().saturating_sub(work));
    }

    /// The answer at a value, if there is one; the search starts from answers at nearby values.
    pub(super) fn at(&self, value: f64, near: &[&At]) -> Option<At> {
        if self.is_spent() {
            return None;
        }
        let near: Vec<&Exact> = near.iter().map(|near| &near.exact).collect();
        let (_, exact) = self.sweep.answer(value, &near).ok()?;
        self.count(exact.work());
        exact.solved.then(|| At::new(value, exact))
    }

    /// The last accepted answer on the way to a value that has none.
    pub(super) fn farthest(&self, from: &At, to: f64, accepts: impl Fn(&At) -> bool) -> At {
        /// Number of halvings: the value is then known to a thousand-millionth of the way.
        const HALVINGS: u32 = 30;
        let has = |value, with: &At| self.at(value, &[with]).filter(&accepts);
        last((from.value, from.clone()), to, HALVINGS, |a, b| self.sweep.is_narrow(a, b), has).1
    }

    /// Finds the events on the way from one answer to another, including changes that are reversed between two answers of one kind.
    pub(super) fn follow(&self, left: At, right: At, events: &mut Vec<Root>) {
        if !left.is_like(&right) {
            return self.between(left, right, events);
        }
        if let Some(middle) = self.dip(&left, &right) {
            self.between(left, middle.clone(), events);
            self.between(middle, right, events);
        }
    }

    /// An answer of another kind between two answers of one kind, where a margin falls below zero and rises again.
    fn dip(&self, left: &At, right: &At) -> Option<At> {
        /// Step for the derivatives of margins, as a share of the interval.
        const STEP: f64 = 1e-3;
        /// Largest number of golden-section steps on the way to the least value.
        const SECTIONS: u32 = 40;
        let width = right.value - left.value;
        let margins = |value: f64| left.exact.margins(&self.sweep.scene(value).ok()?);
        let places = [left.value, left.value + STEP * width, right.value - STEP * width, right.value];
        let [a, near_a, near_b, b] = places.map(margins);
        let (a, near_a, near_b, b) = (a?, near_a?, near_b?, b?);
        self.count(4 * left.exact.work_to_move());
        let others = [near_a, near_b, b].map(|list| list.into_iter().collect::<HashMap<Condition, f64>>());
        for (condition, at_a) in a {
            let [Some(&next), Some(&last), Some(&at_b)] = others.each_ref().map(|list| list.get(&condition)) else {
                continue;
            };
            let (falls, rises) = ((at_a - next) / STEP, (at_b - last) / STEP);
            // The tangents meet here: a margin that curves in one direction does not fall below this value.
            let lowest = (at_a * rises + at_b * falls - falls * rises) / (falls + rises);
            if !(0.0 < falls && 0.0 < rises && lowest < 0.0 && 0.0 < at_a && 0.0 < at_b) {
                continue;
            }
            let value = |share: f64| self.margin(left, left.value + share * width, condition);
            let (mut lo, mut hi) = (0.0, 1.0);
            for _ in 0..SECTIONS {
                let (c, d) = (hi - GOLDEN * (hi - lo), lo + GOLDEN * (hi - lo));
                let (Some(at_c), Some(at_d)) = (value(c), value(d)) else { break };
                if at_c.min(at_d) < 0.0 {
                    let share = if at_c < at_d { c } else { d };
                    let middle = self.at(left.value + share * width, &[left]).filter(|middle| !middle.is_like(left));
                    if middle.is_some() {
                        return middle;
                    }
                    break;
                }
                if at_c < at_d { hi = d } else { lo = c }
            }
        }
        None
    }

    /// Finds the events on the way from one answer to an answer of another kind.
    fn between(&self, mut left: At, mut right: At, events: &mut Vec<Root>) {
        /// Shares at which an interval is divided: the next one is tried where there is no answer.
        const SHARES: [f64; 3] = [1.0 - PAST, PAST, 0.5];
        let mut beyond = Vec::new();
        while !left.is_like(&right) && events.len() + beyond.len() < MOST_EVENTS && !self.is_spent() {
            if let Some(event) = self.next_event(&left, &right) {
                left = event.after.clone();
                events.push(event);
                continue;
            }
            if let Some(Root { value, off, before, after }) = self.next_event(&right, &left) {
                // Seen from the other side, before and after are exchanged.
                right = after.clone();
                beyond.push(Root { value, off, before: after, after: before });
                continue;
            }
            let inside = |share: f64| left.value + share * (right.value - left.value);
            let narrow = self.sweep.is_narrow(left.value, right.value);
            let found = |share| self.at(inside(share), &[&left, &right]);
            let Some(middle) = SHARES.into_iter().filter(|_| !narrow).find_map(found) else {
                let gap = self.gap(&left, &right);
                // If the work is used up, no answer is found anywhere.
                events.extend((!self.is_spent()).then_some(gap));
                break;
            };
            if left.is_like(&middle) {
                left = middle;
            } else if right.is_like(&middle) {
                right = middle;
            } else {
                self.between(left, middle.clone(), events);
                left = middle;
            }
        }
        events.extend(beyond.into_iter().rev());
    }

    /// The event between two answers without an answer between them. It is between the last answer of the first kind and the first
    /// answer of the second kind; no more is known.
    fn gap(&self, left: &At, right: &At) -> Root {
        let before = self.farthest(left, right.value, |at| at.is_like(left));
        let after = self.farthest(right, before.value, |at| at.is_like(right));
        let [value, off] = [0.5 * (before.value + after.value), 0.5 * (after.value - before.value).abs()];
        Root { value, off, before, after }
    }

    /// The first event on the way from `from` to `to`, which may be against the direction of the sweep, with an answer just beyond it
    /// as `after`.
    fn next_event(&self, from: &At, to: &At) -> Option<Root> {
        let violated = from.exact.violated_conditions(&self.sweep.scene(to.value).ok()?)?;
        let mut roots: Vec<f64> =
            violated.into_iter().filter_map(|condition| self.root(from, to.value, condition)).collect();
        roots.sort_by(|a, b| (a - from.value).abs().total_cmp(&(b - from.value).abs()));
        let [start, end] = self.sweep.range;
        let step = BESIDE * (end - start).abs() * (to.value - from.value).signum();
        // On the near side the contacts are still the same.
        let near = |value: f64| {
            let before = value - step;
            if 0.0 < (before - from.value) * step { self.with_contacts_of(from, before) } else { Some(from.clone()) }
        };
        let sides: Vec<(f64, At)> = roots.into_iter().map_while(|value| Some((value, near(value)?))).collect();
        // Beyond the event the contacts are different, and not the same contacts that move fast. The answer is taken as close to the
        // event as possible, and at the first step it may be `to`: farther away there may be more events before it.
        let beyond = |value: f64, farther: f64| {
            let next = value + farther * step;
            let inside = 0.0 < (to.value - next) * step;
            if inside { self.at(next, &[from, to]) } else { (farther <= FARTHER[0]).then(|| to.clone()) }
        };
        FARTHER.into_iter().find_map(|farther| {
            sides.iter().find_map(|(value, near)| {
                let after = beyond(*value, farther).filter(|after| !after.pattern.is_same_kind(&near.pattern))?;
                Some(Root { value: *value, off: 0.0, before: near.clone(), after })
            })
        })
    }

    /// The answer at a value with the contacts of another answer, if it exists.
    pub(super) fn with_contacts_of(&self, from: &At, value: f64) -> Option<At> {
        self.count(from.exact.work_to_move());
        let exact = from.exact.moved(&self.sweep.scene(value).ok()?)?;
        Some(At::new(value, exact)).filter(|near| near.is_like(from))
    }

    /// A margin of the contacts of an answer at another value.
    fn margin(&self, of: &At, value: f64, condition: Condition) -> Option<f64> {
        if self.is_spent() {
            return None;
        }
        self.count(of.exact.work_to_move());
        of.exact.margin(&self.sweep.scene(value).ok()?, condition)
    }

    /// The value at which a margin of the contacts at `from` changes its sign before `to`, where it is negative.
    pub(super) fn root(&self, from: &At, to: f64, condition: Condition) -> Option<f64> {
        /// Largest negative margin that counts as a root, as a share of the margin at `to`.
        const NONE: f64 = 1e-2;
        let of = |value: f64| self.margin(from, value, condition);
        let (good, bad) = (from.value, to);
        let (at_good, at_bad) = (of(good), of(bad).filter(|m| *m < 0.0)?);
        if at_good.is_some_and(|m| m <= 0.0) {
            // A condition that is undefined at `from` is violated there by more than rounding.
            return at_good.filter(|m| NONE * at_bad <= *m).map(|_| good);
        }
        let is_done = |a, b| self.is_spent() || self.sweep.is_narrow(a, b);
        let value = root::root((good, at_good), (bad, at_bad), is_done, of);
        (!self.is_spent()).then_some(value)
    }
}
