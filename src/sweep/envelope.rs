//! The envelope of a sweep: the largest and the least moment, shear force and support force over its values.

use std::cell::Cell;

use super::{GOLDEN, Step, Sweep};
use crate::theory::Exact;

/// Equal parts of the beam at whose ends moment and shear force are compared.
const PARTS: usize = 200;

/// What is left of a bracket in which the governing value is, as a share of it: a moment that is smooth there is then known to twice
/// these digits, and one with a kink to these.
const LEFT: f64 = 1e-9;

/// Extremes over the values of a sweep. Moments are positive where the underside is in tension; the shear force is that of
/// [`Exact::shear`].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Envelope {
    /// Places along the beam \[length\].
    pub x: Vec<f64>,
    /// The largest moment there over all values \[force · length\].
    pub moment_max: Vec<f64>,
    /// The least.
    pub moment_min: Vec<f64>,
    /// The largest shear force there, of both sides of a place \[force\].
    pub shear_max: Vec<f64>,
    /// The least.
    pub shear_min: Vec<f64>,
    /// Each support, in the order of the beam.
    pub supports: Vec<SupportEnvelope>,
    /// The moments that govern, at any place, and between the values too.
    pub governing: Governing,
}

/// The extremes of one support's force, upwards on the beam \[force\], with the values of the number varied at which they occur.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "as said above")]
pub struct SupportEnvelope {
    pub at: f64,
    pub max: f64,
    pub max_value: f64,
    pub min: f64,
    pub min_value: f64,
}

/// The largest and the least moment.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "as said above")]
pub struct Governing {
    pub moment_max: Moment,
    pub moment_min: Moment,
}

/// A moment, its place, and the value of the number varied.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "as said above")]
pub struct Moment {
    pub moment: f64,
    pub at: f64,
    pub value: f64,
}

/// What is to be as large as possible: an extreme with its sign.
#[derive(Debug, Clone, Copy)]
enum Extreme {
    Moment { sign: f64 },
    Support { index: usize, sign: f64 },
}

impl Extreme {
    /// Its size, times its sign, and its place.
    fn of(self, exact: &Exact) -> Option<[f64; 2]> {
        let state = &exact.state;
        match self {
            Self::Moment { sign } if 0.0 < sign => Some([state.moment.max, state.moment.max_at]),
            Self::Moment { .. } => Some([-state.moment.min, state.moment.min_at]),
            Self::Support { index, sign } => {
                state.supports.get(index).map(|support| [sign * support.force, support.at])
            }
        }
    }
}

/// An extreme that was found: value of the number varied, size times sign, place.
#[derive(Debug, Clone, Copy)]
struct Largest {
    extreme: Extreme,
    value: f64,
    size: f64,
    at: f64,
    /// The values beside it.
    beside: [f64; 2],
}

/// Gathers the envelope row by row.
#[derive(Debug)]
pub struct Gathered<'a> {
    sweep: &'a Sweep<'a>,
    x: Vec<f64>,
    moment: Vec<[f64; 2]>,
    shear: Vec<[f64; 2]>,
    found: Vec<Largest>,
    last: Option<f64>,
}

impl<'a> Gathered<'a> {
    pub(super) fn new(sweep: &'a Sweep<'a>) -> Self {
        let beam = sweep.scene.beam();
        #[expect(clippy::cast_precision_loss, reason = "a few hundred places")]
        let place = |i: usize| beam.length() * (i as f64 / PARTS as f64);
        let mut x: Vec<f64> =
            (0..=PARTS).map(place).chain(beam.all_supports().iter().map(|support| support.at)).collect();
        x.sort_by(f64::total_cmp);
        x.dedup();
        let none = vec![[f64::INFINITY, f64::NEG_INFINITY]; x.len()];
        Self { sweep, x, moment: none.clone(), shear: none, found: Vec::new(), last: None }
    }

    /// Takes the answer of the next value in.
    pub fn add(&mut self, step: &Step) {
        let (value, exact) = (step.value, &step.exact);
        for ((x, moment), shear) in self.x.iter().zip(&mut self.moment).zip(&mut self.shear) {
            let [least, most] = *moment;
            let of = exact.moment(*x);
            *moment = [least.min(of), most.max(of)];
            for of in exact.shear(*x) {
                *shear = [shear[0].min(of), shear[1].max(of)];
            }
        }
        if self.found.is_empty() {
            let supports = 0..exact.state.supports.len();
            let of_moment = [1.0, -1.0].map(|sign| Extreme::Moment { sign });
            let of_supports = supports.flat_map(|index| [1.0, -1.0].map(|sign| Extreme::Support { index, sign }));
            let none = |extreme| Largest { extreme, value, size: f64::NEG_INFINITY, at: 0.0, beside: [value; 2] };
            self.found = of_moment.into_iter().chain(of_supports).map(none).collect();
        }
        for found in &mut self.found {
            // The row behind the extreme.
            if self.last.is_some_and(|last| found.value.total_cmp(&last).is_eq()) {
                found.beside[1] = value;
            }
            if let Some([size, at]) = found.extreme.of(exact).filter(|[size, _]| found.size < *size) {
                *found =
                    Largest { extreme: found.extreme, value, size, at, beside: [self.last.unwrap_or(value), value] };
            }
        }
        self.last = Some(value);
    }

    /// The envelope, its extremes refined between the rows; [`None`] without a row.
    #[must_use]
    pub fn envelope(self) -> Option<Envelope> {
        self.envelope_within(u64::MAX).0
    }

    /// The same with so much work at the most ([`Exact::work`]), first of all for the moments, and whether that was enough. Extremes for
    /// which it was not are those of the rows, or lie between one of them and the refined one.
    #[must_use]
    pub fn envelope_within(self, work: u64) -> (Option<Envelope>, bool) {
        let (sweep, left) = (self.sweep, Cell::new(work));
        let found: Vec<Largest> = self.found.into_iter().map(|found| refined(sweep, found, &left)).collect();
        let enough = 0 < left.get();
        let [max, min, supports @ ..] = &found[..] else { return (None, enough) };
        let moment =
            |found: &Largest, sign: f64| Moment { moment: sign * found.size, at: found.at, value: found.value };
        let supports = supports.chunks_exact(2).map(|pair| SupportEnvelope {
            at: pair[0].at,
            max: pair[0].size,
            max_value: pair[0].value,
            min: -pair[1].size,
            min_value: pair[1].value,
        });
        let side = |values: &[[f64; 2]], k: usize| values.iter().map(|value| value[k]).collect();
        let envelope = Envelope {
            moment_max: side(&self.moment, 1),
            moment_min: side(&self.moment, 0),
            shear_max: side(&self.shear, 1),
            shear_min: side(&self.shear, 0),
            x: self.x,
            supports: supports.collect(),
            governing: Governing { moment_max: moment(max, 1.0), moment_min: moment(min, -1.0) },
        };
        (Some(envelope), enough)
    }
}

/// The extreme between the values beside the one where it is largest, by golden section: it is taken for one hill there.
/// Ends where no work is left.
fn refined(sweep: &Sweep<'_>, found: Largest, left: &Cell<u64>) -> Largest {
    let mut best = found;
    let mut near: Option<Exact> = None;
    let mut size_at = |value: f64| {
        if left.get() == 0 {
            return f64::NEG_INFINITY;
        }
        let answer = sweep.answer(value, &near.iter().collect::<Vec<_>>()).ok();
        let Some((exact, [size, at])) = answer.and_then(|(_, exact)| found.extreme.of(&exact).map(|of| (exact, of)))
        else {
            return f64::NEG_INFINITY;
        };
        left.set(left.get().saturating_sub(exact.work()));
        if exact.solved && best.size < size {
            best = Largest { value, size, at, ..best };
        }
        near = Some(exact);
        size
    };
    let [mut from, mut to] = found.beside;
    let whole = (to - from).abs();
    let mut inner = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
    let mut sizes = inner.map(&mut size_at);
    while LEFT * whole < (to - from).abs() && 0 < left.get() {
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
