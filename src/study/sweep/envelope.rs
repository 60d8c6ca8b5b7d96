//! The envelope of a sweep: the greatest and least moment, shear force and reaction over its values.

use std::cell::Cell;

use super::govern::{Extreme, Govern, Largest, Sample};
use super::{Step, Sweep};

/// Number of equal parts of the beam at whose ends moment and shear force are compared.
const PARTS: usize = 200;

/// Extremes over the values of a sweep. Moments are positive where the underside is in tension. The shear force is defined in
/// [`Exact::shear`](crate::theory::Exact::shear).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Envelope {
    /// Positions along the beam \[length\].
    pub x: Vec<f64>,
    /// The greatest moment there over all values and both sides of the position \[force · length\].
    pub moment_max: Vec<f64>,
    /// The least moment.
    pub moment_min: Vec<f64>,
    /// The greatest shear force there over all values and both sides of the position \[force\].
    pub shear_max: Vec<f64>,
    /// The least shear force.
    pub shear_min: Vec<f64>,
    /// The supports, from left to right.
    pub supports: Vec<SupportEnvelope>,
    /// The governing moments at any position, also between the values of the sweep.
    pub governing: Governing,
}

/// The extremes of the reaction of one support, upwards on the beam \[force\], with the values of the varied number at which they occur.
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

/// The greatest and the least moment.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "as said above")]
pub struct Governing {
    pub moment_max: Moment,
    pub moment_min: Moment,
}

/// A moment, its position and the value of the varied number, with the other results for that value: the shear force on both sides of
/// the position, and the reaction of each support from left to right.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "as said above")]
pub struct Moment {
    pub moment: f64,
    pub at: f64,
    pub value: f64,
    pub shear: [f64; 2],
    pub supports: Vec<f64>,
}

/// Gathers the envelope row by row.
#[derive(Debug)]
pub struct Gathered<'a> {
    sweep: &'a Sweep<'a>,
    x: Vec<f64>,
    moment: Vec<[f64; 2]>,
    shear: Vec<[f64; 2]>,
    rows: Vec<Sample>,
}

impl<'a> Gathered<'a> {
    pub(super) fn new(sweep: &'a Sweep<'a>) -> Self {
        let beam = sweep.scene.beam();
        #[expect(clippy::cast_precision_loss, reason = "a few hundred places")]
        let place = |i: usize| beam.length() * (i as f64 / PARTS as f64);
        let mut x: Vec<f64> =
            (0..=PARTS).map(place).chain(beam.all_supports().iter().map(|support| support.at)).collect();
        x.extend(sweep.scene.load().couple().iter().map(|couple| couple.at));
        x.sort_by(f64::total_cmp);
        x.dedup();
        let none = vec![[f64::INFINITY, f64::NEG_INFINITY]; x.len()];
        Self { sweep, x, moment: none.clone(), shear: none, rows: Vec::new() }
    }

    /// Adds the answer of the next value.
    pub fn add(&mut self, step: &Step) {
        let (value, exact) = (step.value, &step.exact);
        for ((x, moment), shear) in self.x.iter().zip(&mut self.moment).zip(&mut self.shear) {
            let [least, most] = *moment;
            // Beyond an end there is no beam.
            let sides = exact.moments(*x);
            let left = if 0.0 < *x && *x < self.sweep.scene.beam().length() { sides[0] } else { sides[1] };
            *moment = [least.min(left).min(sides[1]), most.max(left).max(sides[1])];
            for of in exact.shear(*x) {
                *shear = [shear[0].min(of), shear[1].max(of)];
            }
        }
        self.rows.push(Sample::of(value, exact));
    }

    /// The envelope, with its extremes refined between the rows; [`None`] without a row.
    #[must_use]
    pub fn envelope(self) -> Option<Envelope> {
        self.envelope_within(u64::MAX).0
    }

    /// The same with at most this much work ([`Exact::work`](crate::theory::Exact::work)), used for the moments first, and whether
    /// the work was enough. If it was not, an extreme is the one of the rows, or a partly refined one.
    #[must_use]
    pub fn envelope_within(self, work: u64) -> (Option<Envelope>, bool) {
        let (sweep, left) = (self.sweep, Cell::new(work));
        let mut govern = Govern::new(sweep, self.rows, &left);
        let moments = [1.0, -1.0].map(|sign| govern.largest(Extreme::Moment { sign }));
        let [Some(max), Some(min)] = [0, 1].map(|k| moment(sweep, moments[k]?, [1.0, -1.0][k])) else {
            return (None, 0 < left.get());
        };
        let supports = (0..sweep.scene.beam().all_supports().len()).filter_map(|index| {
            let [max, min] = [1.0, -1.0].map(|sign| govern.largest(Extreme::Support { index, sign }));
            let (max, min) = (max?, min?);
            let [max_value, min_value] = [max.value, min.value];
            Some(SupportEnvelope { at: max.at, max: max.size, max_value, min: -min.size, min_value })
        });
        let supports: Vec<SupportEnvelope> = supports.collect();
        let enough = 0 < left.get();
        let side = |values: &[[f64; 2]], k: usize| values.iter().map(|value| value[k]).collect();
        let envelope = Envelope {
            moment_max: side(&self.moment, 1),
            moment_min: side(&self.moment, 0),
            shear_max: side(&self.shear, 1),
            shear_min: side(&self.shear, 0),
            x: self.x,
            supports,
            governing: Governing { moment_max: max, moment_min: min },
        };
        (Some(envelope), enough)
    }
}

/// A governing moment with the other results for its value.
fn moment(sweep: &Sweep<'_>, found: Largest, sign: f64) -> Option<Moment> {
    let (_, exact) = sweep.answer(found.value, &[]).ok()?;
    let supports = exact.state.supports.iter().map(|support| support.force).collect();
    let Largest { size, value, at } = found;
    Some(Moment { moment: sign * size, at, value, shear: exact.shear(at), supports })
}
