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

/// Beside an event the answer is looked at so far from it, as a share of the range; farther, by hundreds, where its kind is not decided.
const BESIDE: f64 = 1e-10;
const FARTHER: [f64; 4] = [1.0, 1e2, 1e4, 1e6];

/// Events between two rows, at most: more are no events but rounding.
const MOST_EVENTS: usize = 1000;

/// A sweep of fewer values is looked at between them as well, so that it is looked at at so many values.
const LOOKED_AT: f64 = 128.0;

/// Places beside the rows lie at this share of an interval, so that they are no round numbers.
const PAST: f64 = 0.382;

/// Events nearer to each other than this share of the range are one.
const ONE: f64 = 2.0 * BESIDE;

/// A value below this share of the range has no digits of its own that count.
const SMALL: f64 = 1e-3;

/// A root, and the answers just before and just beyond it as the sweep goes on.
#[derive(Debug)]
struct Root {
    value: f64,
    before: At,
    after: At,
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
        let mut roots = Vec::new();
        // The last answer before this row; where a row has none, the next one with an answer follows on it.
        let mut last: Option<At> = None;
        for (i, pair) in rows.windows(2).enumerate() {
            let [from, to] = [pair[0].value, pair[1].value];
            // A row itself may be an event, as round numbers are: that is seen from beyond it only.
            let past = PAST * (to - from) / f64::from(1 + self.places_inside(from, to));
            let (is_first, is_last) = (i == 0, i + 2 == rows.len());
            let same = pair[0].pattern.is_same(&pair[1].pattern) && self.places_inside(from, to) == 0;
            if same && !is_first && !is_last && last.as_ref().is_none_or(|last| last.value.total_cmp(&from).is_eq()) {
                last = None;
                continue;
            }
            let before = || if is_first { self.at(from - past, &[]) } else { None };
            let Some(left) = last.take().or_else(before).or_else(|| self.at(from, &[])) else { continue };
            let mut right = self.at(to, &[&left]);
            if is_last || right.as_ref().is_some_and(|right| !right.is_like(&left)) {
                right = self.at(to + past, &[&left]).or(right);
            }
            if let Some(right) = &right {
                self.all_between(&left, right, &mut roots);
            }
            last = right.or(Some(left));
        }
        let [start, end] = self.range;
        roots.retain_mut(|root| {
            let inside = root.value.max(start.min(end)).min(start.max(end));
            let outside = (root.value - inside).abs();
            root.value = inside;
            // One at an end may come out beyond it.
            outside <= BESIDE * (end - start).abs()
        });
        self.described(roots)
    }

    /// Roots in words. Those at one value are one event, and so are those between which an answer has several lists of contacts
    /// that all meet their conditions: of these the list counts that holds the longest.
    fn described(&self, roots: Vec<Root>) -> Vec<Event> {
        let [start, end] = self.range;
        let mut single: Vec<Root> = Vec::new();
        for root in roots {
            let Some(last) = single.last_mut() else {
                single.push(root);
                continue;
            };
            let close = (root.value - last.value).abs() <= ONE * (end - start).abs();
            let middle = 0.5 * (last.value + root.value);
            let lasts = |at: &At, to: f64| [middle, to].into_iter().all(|value| self.kept(at, value).is_some());
            if lasts(&last.before, root.before.value) {
                (last.value, last.after) = (root.value, root.after);
            } else if close || lasts(&root.after, last.after.value) {
                last.after = root.after;
            } else {
                single.push(root);
            }
        }
        let happens = |root: &&Root| !root.before.is_like(&root.after);
        let event = |root: &Root| Event { value: root.value, what: describe(&root.before.exact, &root.after.exact) };
        single.iter().filter(happens).map(event).collect()
    }

    /// True if nothing is between two values.
    fn is_narrow(&self, a: f64, b: f64) -> bool {
        let [start, end] = self.range;
        (b - a).abs() <= 2.0 * f64::EPSILON * a.abs().max(b.abs()).max(SMALL * (end - start).abs())
    }

    /// The answer at a value, if there is one, searched for from answers at values nearby.
    fn at(&self, value: f64, near: &[&At]) -> Option<At> {
        let near: Vec<&Exact> = near.iter().map(|near| &near.exact).collect();
        let (_, exact) = self.answer(value, &near).ok()?;
        exact.solved.then_some(At { value, exact })
    }

    /// The events between two answers, and between these what appears and goes again.
    fn all_between(&self, left: &At, right: &At, events: &mut Vec<Root>) {
        let mut found = Vec::new();
        if !left.is_like(right) {
            self.between(left.clone(), right.clone(), &mut found);
        }
        let mut start = left.clone();
        for root in found {
            self.unlike_inside(&start, &root.before, events);
            start = root.after.clone();
            events.push(root);
        }
        self.unlike_inside(&start, right, events);
    }

    /// How many places between two values are looked at besides.
    fn places_inside(&self, from: f64, to: f64) -> u32 {
        let [start, end] = self.range;
        let share = (to - from).abs() / (end - start).abs();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small number")]
        let places = (share * LOOKED_AT).ceil() as u32;
        places.saturating_sub(1)
    }

    /// What appears and goes again between two answers of one kind.
    fn unlike_inside(&self, left: &At, right: &At, events: &mut Vec<Root>) {
        if MOST_EVENTS < events.len() {
            return;
        }
        let count = self.places_inside(left.value, right.value);
        let place = |i: u32| left.value + (right.value - left.value) * ((f64::from(i) - PAST) / f64::from(count + 1));
        let answers = (1..=count).filter_map(|i| self.at(place(i), &[left]));
        let unlike = answers.chain([right.clone()]).find(|middle| !middle.is_like(left));
        if let Some(middle) = unlike {
            self.all_between(left, &middle, events);
            self.unlike_inside(&middle, right, events);
        }
    }

    /// The events on the way from one answer to another of another kind.
    fn between(&self, mut left: At, mut right: At, events: &mut Vec<Root>) {
        /// Where an interval is divided; where there is no answer, elsewhere.
        const SHARES: [f64; 3] = [1.0 - PAST, PAST, 0.5];
        let mut beyond = Vec::new();
        while !left.is_like(&right) && events.len() + beyond.len() < MOST_EVENTS {
            if let Some(event) = self.next_event(&left, &right) {
                left = event.after.clone();
                events.push(event);
                continue;
            }
            if let Some(Root { value, before, after }) = self.next_event(&right, &left) {
                // From the other side what it becomes is what it was.
                right = after.clone();
                beyond.push(Root { value, before: after, after: before });
                continue;
            }
            let inside = |share: f64| left.value + share * (right.value - left.value);
            let narrow = self.is_narrow(left.value, right.value);
            let middle = SHARES.into_iter().filter(|_| !narrow).find_map(|share| self.at(inside(share), &[&left]));
            let Some(middle) = middle else {
                events.push(Root { value: inside(0.5), before: left, after: right });
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

    /// The first event on the way from `from` to `to`, which may be against the sweep, with an answer just beyond it as `after`.
    fn next_event(&self, from: &At, to: &At) -> Option<Root> {
        let margins = from.exact.failing(&self.scene(to.value).ok()?)?;
        let mut roots: Vec<f64> = margins.into_iter().filter_map(|margin| self.root(from, to.value, margin)).collect();
        roots.sort_by(|a, b| (a - from.value).abs().total_cmp(&(b - from.value).abs()));
        let [start, end] = self.range;
        let step = BESIDE * (end - start).abs() * (to.value - from.value).signum();
        // On the near side the contacts are still the same.
        let near = |value: f64| {
            let before = value - step;
            if 0.0 < (before - from.value) * step { self.kept(from, before) } else { Some(from.clone()) }
        };
        let sides: Vec<(f64, At)> = roots.into_iter().map_while(|value| Some((value, near(value)?))).collect();
        // Beyond it they are others, and as near to it as may be those of `to`.
        let beyond = |value: f64| {
            let inside = 0.0 < (to.value - value) * step;
            let after = if inside { self.at(value, &[from, to])? } else { to.clone() };
            (!after.is_like(from)).then_some(after)
        };
        FARTHER.into_iter().find_map(|farther| {
            sides.iter().find_map(|(value, near)| {
                let after = beyond(value + step * farther)?;
                Some(Root { value: *value, before: near.clone(), after })
            })
        })
    }

    /// The answer at a value that has the contacts of another one, if there is one.
    fn kept(&self, from: &At, value: f64) -> Option<At> {
        let exact = from.exact.moved(&self.scene(value).ok()?)?;
        Some(At { value, exact }).filter(|near| near.is_like(from))
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
