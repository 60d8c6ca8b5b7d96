//! Inverse questions: the values of the varied number for which a quantity reaches its target.
//!
//! The measured quantity is continuous in the value, except where a load or a support passes its position. It is sampled like the
//! extremes in module `govern`, and intervals in which it may reach its target are divided in the same way. If two neighbouring
//! samples are on different sides of the target, the root between them is computed to rounding.
//!
//! A target that is only touched, between two values on the same side, is found as an extreme. This needs a smooth extreme: the
//! position of a kink is known only to a thousand-millionth of the range. If the quantity stays at the target, the result is the
//! interval in which it stays there. The beginning or end of contact is an event.

use std::cell::{Cell, RefCell};

use super::events::BESIDE;
use super::follow::FARTHER;
use super::govern::{Extreme, Govern, Largest};
use super::until::{Measured, Until};
use super::{Sweep, SweepError, last, root};

/// The measured quantity jumps if it changes by more than this share of its size from just below a value to just above it.
const JUMP: f64 = 1e-6;

/// If the target is reached to rounding over less than this share of the range, it counts as reached at one value. An extreme is
/// flat: to 12 digits it extends over a millionth of the range.
const ONE_VALUE: f64 = 1e-5;

/// A value for which the target is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Found {
    /// The value.
    pub value: f64,
    /// The other end of the interval, if the target stays reached over an interval.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub until: Option<f64>,
    /// How far the value may be off ([`Event::uncertainty`](super::Event::uncertainty)); 0 if it is known to rounding.
    pub uncertainty: f64,
    /// Whether the measured quantity jumps past the target.
    pub jumps: bool,
    /// The sample just below, if it has an answer.
    pub below: Option<Beside>,
    /// The sample just above, if it has an answer.
    pub above: Option<Beside>,
}

/// A value, and the measured quantity there.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "as said above")]
pub struct Beside {
    pub value: f64,
    pub reached: f64,
}

/// The result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// All values found, in the order of the sweep.
    pub found: Vec<Found>,
    /// The value that comes closest to the target, if no value reaches it.
    pub nearest: Option<Beside>,
    /// False if the allowed work was not enough: further values, or a closer one, may exist.
    pub is_whole: bool,
}

/// Where the target is reached: at one value, or from one value to another, with the uncertainty of the value.
#[derive(Debug, Clone, Copy)]
struct Reached {
    from: f64,
    to: f64,
    off: f64,
}

impl Reached {
    fn at(value: f64) -> Self {
        Self { from: value, to: value, off: 0.0 }
    }
}

impl Sweep<'_> {
    /// The values in the range for which the target is reached, found with at most this much work ([`Exact::work`]).
    ///
    /// # Errors
    ///
    /// [`SweepError::Invalid`] if no value has an answer.
    ///
    /// [`Exact::work`]: crate::theory::Exact::work
    pub fn find(&self, until: &Until, work: u64) -> Result<Finding, SweepError> {
        let left = Cell::new(work);
        let mut search =
            Find { sweep: self, until: *until, govern: Govern::of(self, until.measure, &left), left: &left };
        if search.govern.samples.iter().all(|sample| sample.measured().is_none())
            && let Err(error) = self.walk().solve(self.range[0])
        {
            return Err(error);
        }
        search.govern.towards(until.target);
        let mut reached = match until.measure {
            measure if measure.is_contact() => search.contact(),
            _ => search.reached(until.target),
        };
        let mut nearest = None;
        if reached.is_empty() {
            // The target may be an extreme.
            nearest = search.nearest();
            reached = search.reached(until.target);
        }
        let is_whole = 0 < left.get();
        left.set(u64::MAX);
        let found: Vec<Found> = reached.into_iter().map(|reached| search.found(reached)).collect();
        Ok(Finding { nearest: nearest.filter(|_| found.is_empty()), found, is_whole })
    }
}

/// A search along a sweep.
struct Find<'a> {
    sweep: &'a Sweep<'a>,
    until: Until,
    govern: Govern<'a>,
    left: &'a Cell<u64>,
}

impl Find<'_> {
    /// The values at which contact begins or ends.
    fn contact(&mut self) -> Vec<Reached> {
        let known = self.govern.samples.iter().filter(|sample| sample.measured().is_some());
        let values: Vec<f64> = known.map(|sample| sample.value).collect();
        let ends = [values.first(), values.last()].into_iter().flatten();
        let kind = |value: &f64| Some((*value, self.sweep.answer(*value, &[]).ok()?.1.pattern()));
        let (changes, is_whole) = self.sweep.changes_of_contact(
            self.until.measure,
            &ends.filter_map(kind).collect::<Vec<_>>(),
            self.left.get(),
        );
        if !is_whole {
            self.left.set(0);
        }
        changes.into_iter().map(|(value, off)| Reached { off, ..Reached::at(value) }).collect()
    }

    /// Where a target is reached, from the existing samples.
    fn reached(&mut self, target: f64) -> Vec<Reached> {
        let [start, end] = self.sweep.range;
        let one = ONE_VALUE * (end - start).abs();
        let sides: Vec<(f64, Option<f64>)> =
            self.govern.samples.iter().map(|sample| (sample.value, sample.side_of(target))).collect();
        let runs: Vec<&[(f64, Option<f64>)]> = sides.chunk_by(|a, b| a.1 == b.1).collect();
        let mut all = Vec::new();
        for (i, run) in runs.iter().enumerate() {
            let ([(from, Some(side)), ..], [.., (to, _)]) = (run, run) else { continue };
            let (from, side, to) = (*from, *side, *to);
            let before =
                i.checked_sub(1).and_then(|i| runs[i].last()).and_then(|(value, side)| Some((*value, (*side)?)));
            let beyond = runs.get(i + 1).and_then(|run| run[0].1.map(|side| (run[0].0, side)));
            if side != 0.0 {
                // The target is crossed between the two sides.
                if let Some((next, _)) = beyond.filter(|(_, other)| side * other < 0.0) {
                    all.extend(self.crossing(target, to, next));
                }
                continue;
            }
            if one < (to - from).abs() {
                let [from, to] =
                    [(from, before), (to, beyond)].map(|(value, other)| self.end_of_stretch(target, value, other));
                all.push(Reached { from, to, off: 0.0 });
                continue;
            }
            match (before, beyond) {
                (Some((a, side)), Some((b, other))) if side * other < 0.0 => all.extend(self.crossing(target, a, b)),
                _ => all.push(Reached::at(0.5 * (from + to))),
            }
        }
        all
    }

    /// The measured quantity at a value.
    fn at(&mut self, value: f64) -> Option<Measured> {
        self.govern.solved(value)?.measured()
    }

    /// The root between two values on different sides.
    fn crossing(&mut self, target: f64, a: f64, b: f64) -> Option<Reached> {
        let (sweep, left) = (self.sweep, self.left);
        let [at_a, at_b] = [a, b].map(|value| self.at(value).map(|measured| measured.number - target));
        let (at_a, at_b) = (at_a?, at_b?);
        let sign = at_a.signum();
        let is_done = |a, b| left.get() == 0 || sweep.is_narrow(a, b);
        let of = |value| Some(sign * (self.at(value)?.number - target));
        let value = root::root((a, Some(sign * at_a)), (b, sign * at_b), is_done, of);
        (0 < left.get()).then(|| Reached::at(value))
    }

    /// The end of an interval in which the target is reached, between a value inside and a value beyond it, if there is one. The line
    /// that leads to the target from beyond gives the end, if it agrees with bisection within the rounding of the measured quantity.
    fn end_of_stretch(&mut self, target: f64, inside: f64, beyond: Option<(f64, f64)>) -> f64 {
        /// Distance from the end to the first of two values that define the line, as a share of the range; the second is twice as far.
        const APART: f64 = 1e-7;
        let Some((beyond, _)) = beyond else { return inside };
        let sweep = self.sweep;
        let this = RefCell::new(&mut *self);
        let has = |value, (): &()| {
            let measured = this.borrow_mut().at(value)?;
            (measured.side_of(target) == 0.0).then_some(())
        };
        let end = last((inside, ()), beyond, u32::MAX, |a, b| sweep.is_narrow(a, b), has).0;
        let [from, to] = sweep.range;
        let step = APART * (to - from).abs() * (beyond - end).signum();
        let [near, far] = [end + step, end + 2.0 * step].map(|value| self.at(value));
        let Some((near, far)) = near.zip(far) else { return end };
        let slope = (far.number - near.number) / step;
        let meets = end + step - (near.number - target) / slope;
        if (slope * (meets - end)).abs() <= 2.0 * near.rounding(target) { meets } else { end }
    }

    /// The value that comes closest to the target.
    fn nearest(&mut self) -> Option<Beside> {
        let target = self.until.target;
        let known = |side: f64| self.govern.samples.iter().any(|sample| sample.side_of(target) == Some(side));
        let sign = match [known(-1.0), known(1.0)] {
            [true, false] => 1.0,
            [false, true] => -1.0,
            _ => {
                let samples = self.govern.samples.iter();
                let all = samples
                    .filter_map(|sample| Some(Beside { value: sample.value, reached: sample.measured()?.number }));
                return all.min_by(|a, b| (a.reached - target).abs().total_cmp(&(b.reached - target).abs()));
            }
        };
        let Largest { size, value, .. } = self.govern.largest(Extreme::Asked { sign })?;
        // The first value that reaches it: rounding decides which value of an interval is the largest.
        let value = self.reached(sign * size).first().map_or(value, |reached| reached.from);
        Some(Beside { value, reached: self.at(value)?.number })
    }

    /// A value that reaches the target, with the values next to it.
    fn found(&mut self, Reached { from, to, off }: Reached) -> Found {
        let [below, above] = [from.min(to), from.max(to)];
        let [below, above] = [(below, -1.0), (above, 1.0)].map(|(value, way)| self.beside(value, way));
        let size = self.at(from).map_or(0.0, |measured| measured.size.max(self.until.target.abs()));
        let stays = from.total_cmp(&to).is_ne();
        let changes = |(below, above): (&(Beside, f64), &(Beside, f64))| {
            let is_nearest = [below, above].iter().all(|(_, farther)| *farther <= FARTHER[0]);
            is_nearest && JUMP * size < (above.0.reached - below.0.reached).abs()
        };
        let crosses = !self.until.measure.is_contact() && !stays;
        let jumps = crosses && below.as_ref().zip(above.as_ref()).is_some_and(changes);
        let [below, above] = [below, above].map(|beside| beside.map(|(beside, _)| beside));
        Found { value: from, until: stays.then_some(to), uncertainty: off, jumps, below, above }
    }

    /// The nearest value in one direction that is clearly above or below the target, with the factor of its distance. If there is
    /// none, the nearest value with an answer.
    fn beside(&mut self, value: f64, way: f64) -> Option<(Beside, f64)> {
        let [start, end] = self.sweep.range;
        let mut nearest = None;
        for farther in FARTHER {
            let value = value + way * farther * BESIDE * (end - start).abs();
            let Some(measured) = self.at(value) else { continue };
            let found = (Beside { value, reached: measured.number }, farther);
            if measured.side_of(self.until.target) != 0.0 {
                return Some(found);
            }
            nearest.get_or_insert(found);
        }
        nearest
    }
}
