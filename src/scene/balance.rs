//! What the supports leave free, and whether loads and ground hold it.
//!
//! One built-in support or any two hold the beam. With fewer, loads can only be balanced by ground that pushes, which is there
//! from `0` to `l` wherever there is a foundation:
//!
//! | supports | an answer exists if and only if |
//! |---|---|
//! | none | `W > 0` and `0 ≤ x_W ≤ l`: the moments `∫q x` and `∫q (l − x)` are not negative |
//! | one simple, at `x_s` | there is a foundation, or `∫q (x − x_s) = 0` |
//!
//! with the resultant `W = ∫q` of the loads and its place `x_W = ∫q x / W` (Fichera 1964: a semi-coercive variational
//! inequality). Each of these sums is an interval: loads and places are decimals, known to half a unit in their last place. The
//! sums themselves are taken in twice the precision. Where zero lies in the interval, the loads are balanced within rounding,
//! and nothing is said about the side to which the beam would turn.

use std::cmp::Ordering;

use super::error::shown;
use super::{Load, Scale, Scene};

/// The resultant of all loads.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "cli", derive(serde::Serialize))]
pub struct Resultant {
    /// `W`, positive downwards \[force\].
    pub force: f64,
    /// Its place `x_W`; not finite where `W` vanishes \[length\].
    pub at: f64,
}

/// What the supports leave free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Balance {
    /// Nothing: two supports or more, or a built-in one.
    Held,
    /// The beam can turn, and pushing ground holds it.
    Stands(Resultant),
    /// The resultant is exactly, within rounding, above the only place about which the beam could turn: the end of the ground or
    /// the one support. The forces are certain; the position is so only if the ground holds it besides.
    Neutral {
        /// The loads.
        resultant: Resultant,
        /// That place \[length\].
        about: f64,
    },
}

/// Why nothing balances the loads.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unheld {
    /// The resultant is beside the ground.
    #[error(
        "the loads have their resultant {} at x = {}, outside the ground (0 … {}): the beam turns over its {} end",
        rounded(*force),
        beside(*at, *length),
        shown(*length),
        if *at < 0.0 { "left" } else { "right" }
    )]
    Overturns {
        /// The resultant, positive downwards \[force\].
        force: f64,
        /// Its place \[length\].
        at: f64,
        /// Length of the beam, and so of the ground \[length\].
        length: f64,
    },
    /// The loads pull the beam off the ground.
    #[error("the loads pull upwards by {}: nothing holds the beam down", rounded(*force))]
    PulledUp {
        /// The resultant, positive upwards \[force\].
        force: f64,
    },
    /// The loads turn the beam and do not press it down.
    #[error("the loads have no resultant, but a couple of {}: nothing keeps the beam from turning", rounded(*moment))]
    Couple {
        /// Its magnitude \[force · length\].
        moment: f64,
    },
    /// There is no load, or the loads balance each other.
    #[error("no load presses on the beam: any position is one of rest")]
    NothingPresses,
    /// Neither supports nor ground.
    #[error("there is neither a support nor a foundation: nothing carries the beam")]
    NothingCarries,
    /// One simple support and no ground.
    #[error(
        "there is no foundation: nothing keeps the beam from turning about its support at x = {}, with a moment of {}",
        shown(*at),
        rounded(*moment)
    )]
    Turns {
        /// Where the support is \[length\].
        at: f64,
        /// The moment of the loads about it, positive clockwise \[force · length\].
        moment: f64,
    },
}

impl Balance {
    /// What is left free of a dimensionless scene.
    ///
    /// # Errors
    ///
    /// [`Unheld`] if nothing balances the loads.
    pub(super) fn of(scene: &Scene) -> Result<Self, Unheld> {
        let (load, length) = (scene.load(), scene.beam().length());
        let grounded = scene.foundation().is_some();
        let force = Sum::of_forces(load, length);
        let turn = |about: f64| Sum::of_moments(load, length, about);
        let resultant = || Resultant { force: force.value(), at: turn(0.0).value() / force.value() };
        match scene.beam().supports() {
            [] if !grounded => Err(Unheld::NothingCarries),
            [] => {
                // Positive where the resultant is on the beam's side of its left and of its right end.
                let [left, right] = [turn(0.0), turn(length).negated()];
                let Resultant { force: weight, at } = resultant();
                match (left.sign(), right.sign()) {
                    (Ordering::Equal, Ordering::Equal) => Err(Unheld::NothingPresses),
                    (Ordering::Less, Ordering::Less) => Err(Unheld::PulledUp { force: -weight }),
                    _ if force.sign() == Ordering::Less => Err(Unheld::PulledUp { force: -weight }),
                    (Ordering::Less, _) | (_, Ordering::Less) if force.sign() == Ordering::Equal => {
                        Err(Unheld::Couple { moment: left.value().abs() })
                    }
                    (Ordering::Less, _) | (_, Ordering::Less) => Err(Unheld::Overturns { force: weight, at, length }),
                    (Ordering::Equal, _) => Ok(Self::Neutral { resultant: resultant(), about: 0.0 }),
                    (_, Ordering::Equal) => Ok(Self::Neutral { resultant: resultant(), about: length }),
                    (Ordering::Greater, Ordering::Greater) => Ok(Self::Stands(resultant())),
                }
            }
            [support] if support.slope.is_none() => {
                let turn = turn(support.at);
                match turn.sign() {
                    Ordering::Equal => Ok(Self::Neutral { resultant: resultant(), about: support.at }),
                    _ if grounded => Ok(Self::Stands(resultant())),
                    _ => Err(Unheld::Turns { at: support.at, moment: turn.value() }),
                }
            }
            _ => Ok(Self::Held),
        }
    }

    /// The resultant of the loads, of a beam that its supports do not hold.
    #[must_use]
    pub fn resultant(&self) -> Option<Resultant> {
        match *self {
            Self::Held => None,
            Self::Stands(resultant) | Self::Neutral { resultant, .. } => Some(resultant),
        }
    }

    /// From dimensionless numbers to the units of the scene.
    #[must_use]
    pub fn in_units_of(self, scale: &Scale) -> Self {
        let units = |r: Resultant| Resultant { force: r.force * scale.force, at: r.at * scale.length };
        match self {
            Self::Held => Self::Held,
            Self::Stands(resultant) => Self::Stands(units(resultant)),
            Self::Neutral { resultant, about } => {
                Self::Neutral { resultant: units(resultant), about: about * scale.length }
            }
        }
    }
}

impl Unheld {
    /// From dimensionless numbers to the units of the scene.
    pub(super) fn in_units_of(self, scale: &Scale) -> Self {
        match self {
            Self::Overturns { force, at, length } => {
                Self::Overturns { force: force * scale.force, at: at * scale.length, length: length * scale.length }
            }
            Self::PulledUp { force } => Self::PulledUp { force: force * scale.force },
            Self::Couple { moment } => Self::Couple { moment: moment * scale.moment() },
            Self::Turns { at, moment } => Self::Turns { at: at * scale.length, moment: moment * scale.moment() },
            Self::NothingPresses | Self::NothingCarries => self,
        }
    }
}

/// To four significant digits.
fn rounded(value: f64) -> String {
    shown(format!("{value:.3e}").parse().unwrap_or(value))
}

/// The same of a place that is not on the beam, with all its digits where four would put it there.
fn beside(at: f64, length: f64) -> String {
    let rounded: f64 = format!("{at:.3e}").parse().unwrap_or(at);
    shown(if (0.0..=length).contains(&rounded) { at } else { rounded })
}

/// A sum in twice the precision, and how far the rounding of what is given may have moved it.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    sum: Double,
    within: f64,
}

impl Sum {
    /// Half a unit in the last place, as a share; the sums themselves are exact to its square.
    const ROUNDING: f64 = 0.5 * f64::EPSILON;

    /// `W = ∫q`.
    fn of_forces(load: &Load, length: f64) -> Self {
        let mut sum = Self::default();
        let (uniform, length) = (Double::from(load.uniform()), Double::from(length));
        sum.add(uniform * length, 2.0 * (uniform * length).value().abs());
        for q in load.linear() {
            let (mean, width) =
                (Double::from(q.start) + Double::from(q.end), Double::from(q.to) - Double::from(q.from));
            let size = 0.5 * (q.start.abs() + q.end.abs());
            sum.add(mean * width * Double::from(0.5), size * (width.value() + q.to + q.from));
        }
        for p in load.point() {
            sum.add(Double::from(p.force), p.force.abs());
        }
        sum
    }

    /// `∫q (x − c)`, six times of which is a sum of products.
    fn of_moments(load: &Load, length: f64, about: f64) -> Self {
        let mut sum = Self::default();
        let (uniform, l, c) = (load.uniform(), Double::from(length), Double::from(about));
        let lever = l - c - c;
        let size = 3.0 * uniform.abs() * length;
        sum.add(
            Double::from(3.0) * Double::from(uniform) * l * lever,
            size * (2.0 * lever.value().abs() + length + about),
        );
        for q in load.linear() {
            let (start, end) = (Double::from(q.start), Double::from(q.end));
            let (width, lever) = (Double::from(q.to) - Double::from(q.from), Double::from(q.from) - c);
            let (places, size) = (q.to + q.from + about, q.start.abs() + q.end.abs());
            sum.add(
                Double::from(3.0) * (start + end) * width * lever + (start + end + end) * width * width,
                6.0 * size * width.value() * (places + width.value()),
            );
        }
        for p in load.point() {
            let lever = Double::from(p.at) - c;
            // A load just above the place has no lever, whatever its last digit.
            let known = if lever.value() == 0.0 { 0.0 } else { lever.value().abs() + p.at + about };
            sum.add(Double::from(6.0) * Double::from(p.force) * lever, 6.0 * p.force.abs() * known);
        }
        Self { sum: sum.sum * Double::from(1.0 / 6.0), within: sum.within / 6.0 }
    }

    /// Adds a term; `size` is that of the numbers of which half a unit in the last place is not known.
    fn add(&mut self, term: Double, size: f64) {
        self.sum = self.sum + term;
        self.within += Self::ROUNDING * size;
    }

    fn negated(self) -> Self {
        Self { sum: Double::default() - self.sum, ..self }
    }

    fn value(self) -> f64 {
        self.sum.value()
    }

    /// The sign, equal to zero where zero cannot be told from it.
    fn sign(self) -> Ordering {
        match self.value() {
            value if value.abs() <= self.within => Ordering::Equal,
            value => value.total_cmp(&0.0),
        }
    }
}

/// A number as the sum of two, the second below half a unit in the last place of the first (Dekker 1971).
#[derive(Debug, Clone, Copy, Default)]
struct Double {
    high: f64,
    low: f64,
}

impl Double {
    fn value(self) -> f64 {
        self.high + self.low
    }

    /// The sum of two numbers, exactly (Knuth).
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_part = high - a;
        Self { high, low: (a - (high - b_part)) + (b - b_part) }
    }

    /// The product of two numbers, exactly (Veltkamp and Dekker).
    fn product(a: f64, b: f64) -> Self {
        /// `2²⁷ + 1` parts a number in halves of 26 bits.
        const SPLIT: f64 = 134_217_729.0;
        let halves = |x: f64| {
            let high = SPLIT * x - (SPLIT * x - x);
            [high, x - high]
        };
        let high = a * b;
        let ([a1, a2], [b1, b2]) = (halves(a), halves(b));
        Self { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl std::ops::Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let first = Self::sum(high.high, high.low + low.high);
        Self::sum(first.high, first.low + low.low)
    }
}

impl std::ops::Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl std::ops::Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}
