//! Events of a sweep: values at which the kind of its answer changes.
//!
//! The scene is solved at values that depend only on the range, so the events do not depend on the number of rows. From each value to
//! the next, and never past it, the contacts are followed (module `follow`). If a row has another kind than the events before it lead
//! to, the interval is divided there.

use std::cell::Cell;

use super::describe::{describe, pressed, touches};
use super::until::Measure;
use super::{Row, Sweep};
use crate::theory::{Exact, Pattern};

/// A value at which the kind of the answer changes.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Event {
    /// The value of the varied number.
    pub value: f64,
    /// What changes there in the direction of the sweep.
    pub what: String,
    /// How far the value may be off. It is positive if the answers before and after it both satisfy their conditions to 12 digits
    /// over some distance, or if no answer is found between them. Otherwise it is 0, and the value is known to a thousand-millionth
    /// of the range.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "is_zero"))]
    pub uncertainty: f64,
}

#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
fn is_zero(value: &f64) -> bool {
    *value <= 0.0
}

/// The result of a search for events.
#[derive(Debug, Clone, PartialEq)]
pub struct Events {
    /// The events, in the order of the sweep.
    pub events: Vec<Event>,
    /// The value up to which events were searched for, if the work exceeded the limit.
    pub until: Option<f64>,
}

/// Distance from an event at which the scene is solved on both sides, as a share of the range.
pub(super) const BESIDE: f64 = 1e-10;

/// Number of values at which the scene is solved, in addition to the rows.
const PLACES: u32 = 256;

/// Offset of these values within an interval, as a share of it, so that they are not round numbers.
pub(super) const PAST: f64 = 0.382;

/// Events closer together than this share of the range count as one.
const ONE: f64 = 2.0 * BESIDE;

/// A root, and the answers just before and just after it in the direction of the sweep.
#[derive(Debug, Clone)]
pub(super) struct Root {
    pub(super) value: f64,
    /// How far the value may be off if no condition determines it, only the answers on both sides.
    pub(super) off: f64,
    pub(super) before: At,
    pub(super) after: At,
}

/// An answer and its value.
#[derive(Debug, Clone)]
pub(super) struct At {
    pub(super) value: f64,
    pub(super) exact: Exact,
    pub(super) pattern: Pattern,
}

impl At {
    pub(super) fn new(value: f64, exact: Exact) -> Self {
        Self { value, pattern: exact.pattern(), exact }
    }

    pub(super) fn is_like(&self, other: &Self) -> bool {
        self.pattern.is_same(&other.pattern)
    }
}

/// A search for the events of a sweep.
#[derive(Debug)]
pub(super) struct Search<'a> {
    pub(super) sweep: &'a Sweep<'a>,
    /// The remaining work, in units of [`Exact::work`].
    pub(super) left: Cell<u64>,
}

impl Sweep<'_> {
    /// The events between the rows of this sweep, in their order.
    #[must_use]
    pub fn events(&self, rows: &[Row]) -> Vec<Event> {
        let kinds: Vec<(f64, Pattern)> = rows.iter().map(|row| (row.value, row.pattern.clone())).collect();
        self.events_within(&kinds, u64::MAX).events
    }

    /// The events between rows with these values and kinds, found with at most this much work ([`Exact::work`]).
    #[must_use]
    pub fn events_within(&self, rows: &[(f64, Pattern)], work: u64) -> Events {
        self.events_and_work(rows, work).0
    }

    /// The same, and the work that the search needed.
    #[must_use]
    pub fn events_and_work(&self, rows: &[(f64, Pattern)], work: u64) -> (Events, u64) {
        let search = Search { sweep: self, left: Cell::new(work) };
        let (roots, until) = search.inside(rows);
        // All roots that were found are described, however much work this needs.
        let taken = work - search.left.replace(u64::MAX);
        let mut events = search.described(roots);
        if rows.len() < self.values().len() {
            events.extend(self.buckling());
            let sign = (self.range[1] - self.range[0]).signum();
            events.sort_by(|a, b| (sign * a.value).total_cmp(&(sign * b.value)));
        }
        (Events { events, until }, taken)
    }

    /// The values between rows at which contact with the foundation or with a compression-only support begins or ends, in their
    /// order, each with its error; and whether the work was enough to find them all.
    pub(super) fn changes_of_contact(
        &self,
        with: Measure,
        rows: &[(f64, Pattern)],
        work: u64,
    ) -> (Vec<(f64, f64)>, bool) {
        let search = Search { sweep: self, left: Cell::new(work) };
        let (roots, until) = search.inside(rows);
        search.left.set(u64::MAX);
        let changes = |root: &&Root| {
            let [before, after] = [&root.before.pattern, &root.after.pattern];
            match with {
                Measure::Bearings => pressed(before) != pressed(after),
                _ => touches(before) != touches(after),
            }
        };
        (search.single(roots).iter().filter(changes).map(|root| search.settled(root)).collect(), until.is_none())
    }
}

impl Search<'_> {
    /// All roots between rows and within the range, and the value up to which they were searched for if the search is incomplete.
    fn inside(&self, rows: &[(f64, Pattern)]) -> (Vec<Root>, Option<f64>) {
        let (mut roots, until) = self.all(rows);
        let [start, end] = self.sweep.range;
        // The scene is also solved slightly beyond both ends.
        let within = |value: f64| value.max(start.min(end)).min(start.max(end));
        roots.retain_mut(|root| {
            let inside = within(root.value);
            let outside = (root.value - inside).abs();
            root.value = inside;
            // A root at an end may be found slightly beyond it.
            outside <= BESIDE * (end - start).abs()
        });
        (roots, until.map(within))
    }

    /// All roots between rows, and the value up to which they were searched for if the search is incomplete.
    fn all(&self, rows: &[(f64, Pattern)]) -> (Vec<Root>, Option<f64>) {
        let mut roots = Vec::new();
        let [start, end] = self.sweep.range;
        if rows.is_empty() {
            return (roots, Some(start));
        }
        let place = |i: u32| start + (end - start) * ((f64::from(i) - PAST) / f64::from(PLACES));
        // A row itself may be an event, because round numbers often are; this shows only from beyond the row. The effect of a load
        // that comes onto the beam there is outside the range.
        let beyond = |i: u32, row: f64| {
            let there = Some(place(i)).filter(|there| self.sweep.has_same_loads(*there, row));
            there.filter(|there| self.at(*there, &[]).is_some()).unwrap_or(row)
        };
        let places: Vec<f64> =
            [beyond(0, start)].into_iter().chain((1..=PLACES).map(place)).chain([beyond(PLACES + 1, end)]).collect();
        let mut last: Option<At> = None;
        let mut first_without: Option<f64> = None;
        let mut without = start;
        for value in places {
            let next = self.at(value, last.as_ref().as_slice());
            if self.is_spent() {
                return (roots, Some(last.map_or(start, |last| last.value)));
            }
            let Some(next) = next else {
                // Search up to the last value with an answer.
                if let Some(at) = last.take_if(|_| first_without.is_none()) {
                    let farthest = self.farthest(&at, value, |_| true);
                    self.interval(&at, &farthest, rows, &mut roots);
                    last = Some(farthest);
                }
                first_without.get_or_insert(value);
                without = value;
                continue;
            };
            let near = first_without.map_or_else(|| next.clone(), |_| self.farthest(&next, without, |_| true));
            if let Some(last) = &last {
                self.interval(last, &near, rows, &mut roots);
            }
            self.interval(&near, &next, rows, &mut roots);
            if self.is_spent() {
                return (roots, Some(last.map_or(start, |last| last.value)));
            }
            (last, first_without) = (Some(next), None);
        }
        (roots, None)
    }

    /// The events between two answers without a solved value between them, unless a row there has another kind.
    fn interval(&self, left: &At, right: &At, rows: &[(f64, Pattern)], roots: &mut Vec<Root>) {
        if self.is_spent() || left.value.total_cmp(&right.value).is_eq() {
            return;
        }
        let mut found = Vec::new();
        self.follow(left.clone(), right.clone(), &mut found);
        let sign = (right.value - left.value).signum();
        let [start, end] = self.sweep.range;
        let near = ONE * (end - start).abs();
        let from = rows.partition_point(|(value, _)| (value - left.value) * sign <= near);
        let to = rows.partition_point(|(value, _)| (value - right.value) * sign < -near).max(from);
        let unexpected = |(value, pattern): &&(f64, Pattern)| {
            let is_close = found.iter().any(|root: &Root| (root.value - value).abs() <= near);
            let before =
                found.iter().rev().find(|root| (root.value - value) * sign < 0.0).map_or(left, |root| &root.after);
            !is_close && !before.pattern.is_same(pattern)
        };
        let middle = rows[from..to].iter().find(unexpected).and_then(|(value, pattern)| {
            let middle = self.at(*value, &[left])?;
            let before =
                found.iter().rev().find(|root| (root.value - value) * sign < 0.0).map_or(left, |root| &root.after);
            let unexpected = middle.pattern.is_same(pattern) && !middle.is_like(before);
            // If the contacts before it are an answer as well, both are valid to 12 digits, and the row shows nothing new.
            (unexpected && self.with_contacts_of(before, *value).is_none()).then_some(middle)
        });
        match middle {
            Some(middle) => {
                self.interval(left, &middle, rows, roots);
                self.interval(&middle, right, rows, roots);
            }
            None => roots.extend(found),
        }
    }

    /// Merges roots at one value into one event, and also roots between which an answer has several lists of contacts that all
    /// satisfy their conditions. Of these lists, the one that stays valid longest counts.
    fn single(&self, roots: Vec<Root>) -> Vec<Root> {
        let [start, end] = self.sweep.range;
        let mut single: Vec<Root> = Vec::new();
        for root in roots {
            let Some(last) = single.last_mut() else {
                single.push(root);
                continue;
            };
            let close = (root.value - last.value).abs() <= ONE * (end - start).abs();
            let middle = 0.5 * (last.value + root.value);
            let lasts =
                |at: &At, to: f64| [middle, to].into_iter().all(|value| self.with_contacts_of(at, value).is_some());
            if lasts(&last.before, root.before.value) {
                (last.value, last.off, last.after) = (root.value, root.off, root.after);
            } else if close || lasts(&root.after, last.after.value) {
                last.after = root.after;
            } else {
                single.push(root);
            }
        }
        single
    }

    /// The roots as events, described in words.
    fn described(&self, roots: Vec<Root>) -> Vec<Event> {
        let happens = |root: &&Root| !root.before.is_like(&root.after);
        let event = |root: &Root| {
            let (value, uncertainty) = self.settled(root);
            Event { value, what: describe(&root.before.exact, &root.after.exact), uncertainty }
        };
        // Contacts that only move need no description, however fast they move.
        self.single(roots).iter().filter(happens).map(event).filter(|event| !event.what.is_empty()).collect()
    }
}
