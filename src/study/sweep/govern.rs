//! The values at which a sweep has its extremes: a search whose result does not depend on the number of rows.
//!
//! Between two events an extreme is a smooth function of the value, and at an event it has a kink. The function is known at samples
//! whose values depend only on the range, and at the rows. Between two samples its upper estimate is where the two lines meet that
//! lead to them from outside, with twice the height to be safe. The interval with the highest estimate is divided there, until no
//! estimate exceeds the highest sample by more than [`KNOWN`]. A golden-section search next to that sample ends the search.
//!
//! The search does not find a peak that begins and ends between two samples.

use std::cell::Cell;

use super::events::PAST;
use super::until::{Measure, Measured};
use super::{GOLDEN, Sweep};
use crate::theory::Exact;

/// Number of values at which the scene is solved, in addition to the rows. *Tuned* on the drawn envelopes of the tests: with a
/// quarter of them no result differs.
const PLACES: usize = 256;

/// Minimum number of values per support: within a span between two supports, many reactions have a peak.
const PER_SUPPORT: usize = 8;

/// An interval is not divided if its estimate exceeds the highest sample by less than this share: the governing value is known to six
/// digits, and smooth peaks that are equally high to this share count as one.
const KNOWN: f64 = 1e-8;

/// Intervals shorter than this share of the range are not divided.
const SHORTEST: f64 = 1e-7;

/// Safety factor on the height at which the lines meet: they are secants, and a function that curves upwards is steeper inside.
const SAFE: f64 = 2.0;

/// Largest number of divisions for one extreme.
const DIVISIONS: usize = 1000;

/// Final width of the bracket of the governing value, as a share of the range. A moment that is smooth there is then known to twice
/// these digits, and a moment with a kink to these digits.
const LEFT: f64 = 1e-9;

/// A quantity to be maximised: an extreme with its sign.
#[derive(Debug, Clone, Copy)]
pub(super) enum Extreme {
    Moment {
        sign: f64,
    },
    Support {
        index: usize,
        sign: f64,
    },
    /// The measured quantity.
    Asked {
        sign: f64,
    },
}

/// The extremes of an answer at a value.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    pub(super) value: f64,
    /// The extremes; none if there is no answer.
    known: Option<Known>,
}

#[derive(Debug, Clone)]
struct Known {
    /// The greatest moment and the least moment with its sign changed, each with its position.
    moments: [[f64; 2]; 2],
    /// The force and position of each support.
    supports: Vec<[f64; 2]>,
    /// The measured number, if one is measured.
    asked: Option<Measured>,
}

impl Sample {
    pub(super) fn of(value: f64, exact: &Exact) -> Self {
        let state = &exact.state;
        let moments = [[state.moment.max, state.moment.max_at], [-state.moment.min, state.moment.min_at]];
        let supports = state.supports.iter().map(|support| [support.force, support.at]).collect();
        Self { value, known: Some(Known { moments, supports, asked: None }) }
    }

    fn asking(mut self, asked: Option<Measured>) -> Self {
        self.known = self.known.map(|known| Known { asked, ..known });
        self
    }

    /// The side of a target on which the measured number is ([`Measured::side_of`]); none without an answer.
    pub(super) fn side_of(&self, target: f64) -> Option<f64> {
        self.measured().map(|asked| asked.side_of(target))
    }

    /// The measured number.
    pub(super) fn measured(&self) -> Option<Measured> {
        self.known.as_ref()?.asked
    }

    /// The value of an extreme, times its sign.
    fn size(&self, extreme: Extreme) -> Option<f64> {
        let known = self.known.as_ref()?;
        match extreme {
            Extreme::Moment { sign } => Some(known.moments[usize::from(sign < 0.0)][0]),
            Extreme::Support { index, sign } => known.supports.get(index).map(|[force, _]| sign * force),
            Extreme::Asked { sign } => known.asked.map(|asked| sign * asked.number),
        }
    }
}

/// An extreme that was found: its value times its sign, the value of the varied number, and its position, if it has one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Largest {
    pub(super) size: f64,
    pub(super) value: f64,
    pub(super) at: f64,
}

/// The search for the extremes of a sweep.
#[derive(Debug)]
pub(super) struct Govern<'a> {
    sweep: &'a Sweep<'a>,
    /// The measured quantity, if there is one.
    asked: Option<Measure>,
    /// In the order of the sweep.
    pub(super) samples: Vec<Sample>,
    near: Option<Exact>,
    /// The remaining work, in units of [`Exact::work`].
    left: &'a Cell<u64>,
}

impl<'a> Govern<'a> {
    /// A search that starts from the samples of the rows.
    pub(super) fn new(sweep: &'a Sweep<'a>, rows: Vec<Sample>, left: &'a Cell<u64>) -> Self {
        let all = Self { sweep, asked: None, samples: rows, near: None, left };
        if all.samples.is_empty() { all } else { all.on_places() }
    }

    /// A search for the extremes of a measured quantity.
    pub(super) fn of(sweep: &'a Sweep<'a>, asked: Measure, left: &'a Cell<u64>) -> Self {
        Self { sweep, asked: Some(asked), samples: Vec::new(), near: None, left }.on_places()
    }

    /// Adds the samples at the values that depend only on the range.
    fn on_places(mut self) -> Self {
        let sweep = self.sweep;
        let [start, end] = sweep.range;
        let places = PLACES.max(PER_SUPPORT * sweep.scene.beam().all_supports().len());
        #[expect(clippy::cast_precision_loss, reason = "thousands of places")]
        let place = |i: usize| start + (end - start) * ((i as f64 - PAST) / places as f64);
        for value in std::iter::once(start).chain((1..=places).map(place)).chain([end]) {
            self.sample(value);
        }
        self
    }

    /// The extreme of sample `i`, if it has one.
    fn found(&self, i: usize, extreme: Extreme) -> Option<Largest> {
        let sample = self.samples.get(i)?;
        let known = sample.known.as_ref()?;
        let [_, at] = match extreme {
            Extreme::Moment { sign } => known.moments[usize::from(sign < 0.0)],
            Extreme::Support { index, .. } => *known.supports.get(index)?,
            Extreme::Asked { .. } => [known.asked?.number, f64::NAN],
        };
        Some(Largest { size: sample.size(extreme)?, value: sample.value, at })
    }

    /// The distance of a value from the start of the sweep.
    fn along(&self, value: f64) -> f64 {
        let [start, end] = self.sweep.range;
        (value - start) * (end - start).signum()
    }

    /// Solves the scene at a value, unless its sample exists or no work is left. Returns the index of the sample.
    fn sample(&mut self, value: f64) -> Option<usize> {
        let along = self.along(value);
        let at = self.samples.partition_point(|sample| self.along(sample.value) < along);
        if self.samples.get(at).is_some_and(|sample| self.along(sample.value) <= along) {
            return Some(at);
        }
        let sample = self.solved(value)?;
        self.samples.insert(at, sample);
        Some(at)
    }

    /// The sample at a value, unless no work is left.
    pub(super) fn solved(&mut self, value: f64) -> Option<Sample> {
        if self.left.get() == 0 {
            return None;
        }
        let answer = self.sweep.answer(value, self.near.as_ref().as_slice()).ok().map(|(_, exact)| exact);
        let work = answer.as_ref().map_or(1, Exact::work);
        self.left.set(self.left.get().saturating_sub(work));
        let solved = answer.filter(|exact| exact.solved);
        let length = self.sweep.scene.beam().length();
        let of = |exact: &Exact| Sample::of(value, exact).asking(self.asked.and_then(|asked| asked.of(exact, length)));
        let sample = solved.as_ref().map_or(Sample { value, known: None }, of);
        self.near = solved.or_else(|| self.near.take());
        Some(sample)
    }

    fn size(&self, i: usize, extreme: Extreme) -> Option<f64> {
        self.samples.get(i)?.size(extreme)
    }

    /// The largest sample; if several are equal, the first.
    fn best(&self, extreme: Extreme) -> Option<(usize, f64)> {
        let sizes = self.samples.iter().enumerate().filter_map(|(i, sample)| Some((i, sample.size(extreme)?)));
        sizes.fold(None, |best, (i, size)| best.filter(|(_, most)| size <= *most).or(Some((i, size))))
    }

    /// The growth of an extreme per unit of the value towards sample `i`, from the nearest sample on one side that is far enough away
    /// for rounding not to matter.
    fn growth(&self, i: usize, before: bool, extreme: Extreme) -> Option<f64> {
        /// As a share of the range.
        const APART: f64 = 1e-5;
        let [start, end] = self.sweep.range;
        let here = self.samples.get(i)?.value;
        let distance = |j: &usize| (here - self.samples[*j].value).abs();
        let is_apart = |j: &usize| APART * (end - start).abs() < distance(j);
        let other = if before { (0..i).rev().find(is_apart) } else { (i + 1..self.samples.len()).find(is_apart) }?;
        Some((self.size(i, extreme)? - self.size(other, extreme)?) / distance(&other))
    }

    /// The upper estimate of an extreme between sample `i` and the next one, and the value at which to divide this interval.
    fn highest(&self, i: usize, extreme: Extreme) -> Option<(f64, f64)> {
        /// Smallest distance between a division and the ends of its interval, as a share of the interval.
        const INSIDE: f64 = 0.1;
        let [a, b] = [&self.samples[i], self.samples.get(i + 1)?].map(|sample| sample.value);
        let width = (b - a).abs();
        let left = self.size(i, extreme);
        let right = self.size(i + 1, extreme);
        let [before, beyond] = [self.growth(i, true, extreme), self.growth(i + 1, false, extreme)];
        let (most, meet, share) = match (left, right) {
            (None, None) => return None,
            (Some(one), None) => (one, one + before.unwrap_or(0.0).max(0.0) * width, 0.5),
            (None, Some(one)) => (one, one + beyond.unwrap_or(0.0).max(0.0) * width, 0.5),
            (Some(left), Some(right)) => {
                // At an end of the range no line leads to the sample from outside.
                let secant = ((right - left) / width).abs();
                let [rise, fall] = [before, beyond].map(|growth| growth.unwrap_or(secant).max(0.0));
                let share = ((right - left) / width + fall) / (rise + fall);
                let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 };
                let meet = (left + rise * share * width).min(right + fall * (1.0 - share) * width);
                (left.max(right), meet, share)
            }
        };
        let highest = most + SAFE * (meet - most).max(0.0);
        Some((highest, a + (b - a) * share.clamp(INSIDE, 1.0 - INSIDE)))
    }

    /// Divides the intervals in which an extreme may exceed `limit`, among those that `is_open` accepts.
    fn divide(
        &mut self,
        extreme: Extreme,
        limit: impl Fn(&Self) -> Option<f64>,
        is_open: impl Fn(&Sample, &Sample) -> bool,
    ) {
        let [start, end] = self.sweep.range;
        let shortest = SHORTEST * (end - start).abs();
        for _ in 0..DIVISIONS {
            let Some(higher) = limit(self) else { return };
            let open = (0..self.samples.len()).filter(|&i| {
                let [here, next] = [self.samples.get(i), self.samples.get(i + 1)];
                here.zip(next)
                    .is_some_and(|(here, next)| shortest < (next.value - here.value).abs() && is_open(here, next))
            });
            let promising = open.filter_map(|i| self.highest(i, extreme)).filter(|(highest, _)| higher < *highest);
            let Some((_, value)) = promising.max_by(|a, b| a.0.total_cmp(&b.0)) else { break };
            if self.sample(value).is_none() {
                break;
            }
        }
    }

    /// Divides intervals with both ends on one side of a target of the measured quantity, if the target may be reached inside.
    pub(super) fn towards(&mut self, target: f64) {
        for sign in [1.0, -1.0] {
            let is_short = |sample: &Sample| sample.side_of(target).is_none_or(|side| sign * side < 0.0);
            self.divide(Extreme::Asked { sign }, |_| Some(sign * target), |a, b| is_short(a) && is_short(b));
        }
    }

    /// An extreme over all values of the range.
    pub(super) fn largest(&mut self, extreme: Extreme) -> Option<Largest> {
        let limit = |all: &Self| {
            let (_, best) = all.best(extreme)?;
            let least = all.samples.iter().filter_map(|sample| sample.size(extreme)).fold(best, f64::min);
            Some(best + KNOWN * best.abs().max(best - least))
        };
        self.divide(extreme, limit, |_, _| true);
        let (i, _) = self.best(extreme)?;
        let best = self.found(i, extreme)?;
        Some(self.refined(extreme, i, best))
    }

    /// The extreme between the samples next to the largest one, by golden-section search.
    fn refined(&mut self, extreme: Extreme, i: usize, mut best: Largest) -> Largest {
        let [start, end] = self.sweep.range;
        let whole = (end - start).abs();
        let beside = [i.saturating_sub(1), (i + 1).min(self.samples.len() - 1)];
        let [mut from, mut to] = beside.map(|i| self.samples[i].value);
        let mut size_at = |value: f64| {
            let found = self.sample(value).and_then(|i| self.found(i, extreme));
            best = found.filter(|found| best.size < found.size).unwrap_or(best);
            found.map_or(f64::NEG_INFINITY, |found| found.size)
        };
        let mut inner = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
        let mut sizes = inner.map(&mut size_at);
        while LEFT * whole < (to - from).abs() && sizes.iter().any(|size| size.is_finite()) {
            if sizes[1] < sizes[0] {
                to = inner[1];
                inner = [to - GOLDEN * (to - from), inner[0]];
                sizes = [size_at(inner[0]), sizes[0]];
            } else {
                from = inner[0];
                inner = [inner[1], from + GOLDEN * (to - from)];
                sizes = [sizes[1], size_at(inner[1])];
            }
        }
        best
    }
}
