//! Events: where the answer of a sweep changes its kind.
//!
//! From a value on, the contacts of its answer are kept and only move. What they violate at the end of an interval names
//! conditions, and the first root of their margins is the event: force at a contact, bend beside a point, length of a zone,
//! clearance. Just beyond it the beam is solved again, and the rest of the interval is treated in the same way. Where no margin can
//! be followed, the kind of the answer itself is bisected.

use super::describe::describe;
use super::{Row, Sweep};
use crate::theory::{Exact, Margin};

/// A value at which the answer changes its kind.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "cli", derive(serde::Serialize))]
pub struct Event {
    /// The value of the number that is varied.
    pub value: f64,
    /// What happens there as the sweep goes on.
    pub what: String,
}

/// Beside an event the answer is looked at so far from it, as a share of the range; farther, by tens, where its kind is not decided.
const BESIDE: f64 = 1e-10;
const FARTHER: [f64; 7] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];

/// Events between two rows, at most: more are no events but rounding.
const MOST_EVENTS: usize = 1000;

/// Events nearer to each other than this share of the range are one.
const ONE: f64 = 1e-13;

/// So far from an event, as a share of the range, the contacts beyond it are no answer any more.
const APART: f64 = 1e-4;

/// A value below this share of the range has no digits of its own that count.
const SMALL: f64 = 1e-3;

/// A root, and the answers just before and just beyond it as the sweep goes on.
#[derive(Debug)]
struct Root {
    value: f64,
    before: Exact,
    after: Exact,
}

/// An answer and its value.
#[derive(Debug, Clone)]
struct At {
    value: f64,
    exact: Exact,
}

impl At {
    fn is_like(&self, other: &Self) -> bool {
        self.exact.pattern().is_same(&other.exact.pattern())
    }
}

impl Sweep<'_> {
    /// The events between rows of this sweep, in their order.
    #[must_use]
    pub fn events(&self, rows: &[Row]) -> Vec<Event> {
        let mut events = Vec::new();
        for pair in rows.windows(2) {
            let middle = 0.5 * (pair[0].value + pair[1].value);
            let Some(left) = self.at(pair[0].value, None) else { continue };
            let Some(right) = self.at(pair[1].value, Some(&left)) else { continue };
            let mut found = Vec::new();
            if left.is_like(&right) {
                // What appears and goes again.
                let Some(middle) = self.at(middle, Some(&left)).filter(|middle| !middle.is_like(&left)) else {
                    continue;
                };
                self.between(left, middle.clone(), &mut found);
                self.between(middle, right, &mut found);
            } else {
                self.between(left, right, &mut found);
            }
            events.extend(self.described(found));
        }
        events
    }

    /// Roots in words; those at one value are one event.
    fn described(&self, roots: Vec<Root>) -> Vec<Event> {
        let [start, end] = self.range;
        let mut single: Vec<Root> = Vec::new();
        for root in roots {
            match single.last_mut() {
                Some(last) if (root.value - last.value).abs() <= ONE * (end - start).abs() => last.after = root.after,
                _ => single.push(root),
            }
        }
        single.iter().map(|root| Event { value: root.value, what: describe(&root.before, &root.after) }).collect()
    }

    /// True if the contacts of an answer are those at another value as well.
    fn holds(&self, at: &At, value: f64) -> bool {
        self.scene(value).is_ok_and(|scene| at.exact.holds(&scene))
    }

    /// True if nothing is between two values.
    fn is_narrow(&self, a: f64, b: f64) -> bool {
        let [start, end] = self.range;
        (b - a).abs() <= 2.0 * f64::EPSILON * a.abs().max(b.abs()).max(SMALL * (end - start).abs())
    }

    fn at(&self, value: f64, near: Option<&At>) -> Option<At> {
        let (_, exact) = self.answer(value, near.map(|near| &near.exact)).ok()?;
        Some(At { value, exact })
    }

    /// The events between two answers.
    fn between(&self, mut left: At, mut right: At, events: &mut Vec<Root>) {
        let mut beyond = Vec::new();
        while !left.is_like(&right) && !self.holds(&left, right.value) && events.len() + beyond.len() < MOST_EVENTS {
            if let Some((event, after)) = self.next_event(&left, &right) {
                events.extend(self.is_real(&left, &event, &after).then_some(event));
                left = after;
            } else if let Some((event, before)) = self.next_event(&right, &left) {
                // From the other side what it becomes is what it was.
                beyond.extend(self.is_real(&right, &event, &before).then_some(event));
                right = before;
            } else {
                let middle = 0.5 * (left.value + right.value);
                let narrow =
                    (right.value - left.value).abs() <= 4.0 * f64::EPSILON * left.value.abs().max(right.value.abs());
                let Some(middle) = (!narrow).then(|| self.at(middle, Some(&left))).flatten() else {
                    events.push(Root { value: middle, before: left.exact, after: right.exact });
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
        }
        events.extend(beyond.into_iter().rev());
    }

    /// False if the contacts beyond an event are an answer before it as well: then one answer has two lists of contacts, some of
    /// which carry nothing, and it is no event that one of the lists ends.
    fn is_real(&self, from: &At, event: &Root, after: &At) -> bool {
        let [start, end] = self.range;
        let back = (from.value - event.value).clamp(-APART * (end - start).abs(), APART * (end - start).abs());
        !self.holds(after, event.value + back)
    }

    /// The first event on the way from `from` to `to`, which may be against the sweep, and an answer just beyond it.
    fn next_event(&self, from: &At, to: &At) -> Option<(Root, At)> {
        let margins = from.exact.failing(&self.scene(to.value).ok()?)?;
        let mut roots: Vec<f64> = margins.into_iter().filter_map(|margin| self.root(from, to.value, margin)).collect();
        roots.sort_by(|a, b| (a - from.value).abs().total_cmp(&(b - from.value).abs()));
        let [start, end] = self.range;
        let onwards = (to.value - from.value).signum();
        let step = BESIDE * (end - start).abs();
        // On the near side the contacts are still the same.
        let near = |value: f64| {
            let before = value - onwards * step;
            if 0.0 < (before - from.value) * onwards {
                self.at(before, Some(from)).filter(|near| near.is_like(from) || self.holds(from, before))
            } else {
                Some(from.clone())
            }
        };
        let sides: Vec<(f64, At)> = roots.into_iter().map_while(|value| Some((value, near(value)?))).collect();
        let (value, near, after) = FARTHER.into_iter().find_map(|farther| {
            sides.iter().find_map(|(value, near)| {
                let after = value + onwards * step * farther;
                let after = if 0.0 < (to.value - after) * onwards { self.at(after, Some(from))? } else { to.clone() };
                (!after.is_like(from)).then(|| (*value, near.clone(), after))
            })
        })?;
        let ahead = 0.0 < onwards * (end - start);
        let (near, far) = (near.exact, after.exact.clone());
        let (before, beyond) = if ahead { (near, far) } else { (far, near) };
        Some((Root { value, before, after: beyond }, after))
    }

    /// Where a margin of the contacts at `from` changes its sign before `to`, at which it is negative: the secant, with the value
    /// at an end that stays halved (Illinois), and the middle where that does not halve the interval soon.
    fn root(&self, from: &At, to: f64, margin: Margin) -> Option<f64> {
        /// Secants in turn before the middle is taken.
        const SECANTS: u32 = 3;
        let of = |value: f64| from.exact.margin(&self.scene(value).ok()?, margin);
        let (mut good, mut bad) = (from.value, to);
        let (mut at_good, mut at_bad) = (of(good), of(bad).filter(|m| *m < 0.0)?);
        if at_good.is_some_and(|m| m <= 0.0) {
            return Some(good);
        }
        let mut turn = 0;
        let mut stays = 0;
        loop {
            let middle = 0.5 * (good + bad);
            if self.is_narrow(good, bad) {
                return Some(middle);
            }
            turn += 1;
            let secant = at_good.map(|at_good| bad - at_bad * ((bad - good) / (at_bad - at_good)));
            let inside = |x: &f64| (x - good) * (x - bad) < 0.0;
            let next = secant.filter(|_| turn % (SECANTS + 1) != 0).filter(inside).unwrap_or(middle);
            match of(next) {
                Some(0.0) => return Some(next),
                Some(m) if m < 0.0 => {
                    (bad, at_bad) = (next, m);
                    if stays == 1 {
                        at_good = at_good.map(|m| 0.5 * m);
                    }
                    stays = 1;
                }
                m => {
                    (good, at_good) = (next, m);
                    if stays == -1 {
                        at_bad *= 0.5;
                    }
                    stays = -1;
                }
            }
        }
    }
}
