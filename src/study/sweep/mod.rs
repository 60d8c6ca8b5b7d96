//! Sweeps: one number of a scene varied, with a certified exact answer for each value, and the events between them.
//!
//! Each answer starts from the contacts of its neighbour and is checked like any other. An [`Event`] is a value at which a contact
//! appears or is lost, becomes a zone or a point, splits, merges or moves over an edge, or at which a support starts or stops being
//! in tension. It is not a sample but a root of the condition that decides it, with the contacts next to it fixed (module `events`).
//!
//! Guarantee: the events between two rows lead from the kind of one row to the kind of the other. Events are searched for between 256
//! consecutive values that depend only on the range, so the number of rows does not change the events. Between two of these values, a
//! condition that comes close to failing is followed to its closest value. What appears and disappears without such a warning may be
//! missed, unless a row is in between. Events closer together than `2·10⁻¹⁰` of the range are reported as one. So are events between
//! which an answer has several lists of contacts that all satisfy their conditions to 12 digits.
//!
//! Work is counted and not timed ([`Exact::work`](crate::theory::Exact::work)). A caller may stop a walk or a search for events at
//! [`MOST_WORK`].
//!
//! ```
//! use palkki::scene::{Beam, Foundation, Load, Scene};
//! use palkki::sweep::Sweep;
//!
//! // q l⁴/(384 EI) = 20: down to this depth the beam lies on a zone, down to five times this depth on a point, and deeper nowhere.
//! let beam = Beam::new(10.0, 10_000.0 / 384.0 / 20.0)?;
//! let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
//! let sweep = Sweep::new(&scene, "foundation.depth", [1.0, 150.0], 12)?;
//! let events = sweep.events(&sweep.rows()?);
//! let values: Vec<f64> = events.iter().map(|event| event.value).collect();
//! assert!((values[0] - 20.0).abs() < 1e-12 && (values[1] - 100.0).abs() < 1e-11, "{events:?}");
//! assert_eq!(events[1].what, "the contact at x = 5 is lost; the regime changes from points to none");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod buckling;
mod describe;
mod envelope;
mod events;
mod find;
mod follow;
mod govern;
mod root;
mod settle;
mod train;
mod until;

use crate::route::Solution;
use crate::scene::{PathError, Quantity, Scene, SceneError, Unstable, as_written};
use crate::theory::{self, Exact, Pattern, TheoryError};
use crate::verdict::Demand;

pub use envelope::{Envelope, Gathered, Governing, Moment, SupportEnvelope};
pub use events::{Event, Events};
pub use find::{Beside, Finding, Found};
pub use until::{Measure, Until, UntilError};

/// The largest number of values in a sweep.
pub const MOST_STEPS: usize = 20_001;

/// Limit on the work for the rows of a sweep, and separately for its events, in units of [`Walk::work`]: some ten seconds each on a
/// slow machine, and more than 20,001 rows need for scenes with few pieces.
pub const MOST_WORK: u64 = 50_000_000;

/// The golden section, `(√5 − 1)/2`.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The reason why there is no sweep.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SweepError {
    /// The number cannot be varied.
    #[error(transparent)]
    Path(#[from] PathError),
    /// A number is named twice.
    #[error("`{0}` is to be varied twice")]
    Twice(Quantity),
    /// The numbers cannot be changed by the same amount.
    #[error("`{first}` and `{other}` cannot move together: one amount for both would have two units")]
    Units {
        /// The number that has the values.
        first: Quantity,
        /// A number that moves with it.
        other: Quantity,
    },
    /// Sweeps do not support the scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Too few or too many values.
    #[error("the number of steps must be between 2 and {MOST_STEPS}, but is {0}")]
    Steps(usize),
    /// The range has no length, or an end that is not finite.
    #[error("the range must have two different, finite ends, but goes from {} to {}", as_written(*from), as_written(*to))]
    Range {
        /// The start of the range.
        from: f64,
        /// The end of the range.
        to: f64,
    },
    /// A value has no scene or no answer of beam theory.
    #[error("there is no answer for `{quantity}` = {}{}: {error}", as_written(*value), from(*border, *value))]
    Invalid {
        /// The varied number.
        quantity: Quantity,
        /// A value of the sweep without an answer.
        value: f64,
        /// The position of the border between the last value with an answer and this one; this value itself if no value before it has
        /// an answer.
        border: f64,
        /// The reason.
        error: TheoryError,
    },
}

impl SweepError {
    /// Whether a value has no answer because the beam buckles.
    #[must_use]
    pub fn buckles(&self) -> bool {
        let Self::Invalid { error: TheoryError::Scene(error), .. } = self else { return false };
        matches!(error, SceneError::Unstable(Unstable::Buckles { .. }))
    }
}

fn from(border: f64, value: f64) -> String {
    if border.total_cmp(&value).is_eq() { String::new() } else { format!(", and none from {} on", as_written(border)) }
}

/// A scene, its varied number, and the values of this number.
#[derive(Debug, Clone)]
pub struct Sweep<'a> {
    scene: &'a Scene,
    quantity: Quantity,
    /// The numbers that move with it.
    with: Vec<Moves>,
    range: [f64; 2],
    steps: usize,
}

/// A number that moves with the varied number.
#[derive(Debug, Clone, Copy)]
struct Moves {
    quantity: Quantity,
    /// Its value in the scene.
    number: f64,
    /// Its change for each unit of the varied number: 1 or −1.
    sign: f64,
}

/// An answer of a sweep.
#[derive(Debug, Clone)]
pub struct Row {
    /// The value of the varied number.
    pub value: f64,
    /// The answer with its verdict, without its functions of `x`.
    pub solution: Solution,
    /// The kind of the answer.
    pub pattern: Pattern,
}

impl<'a> Sweep<'a> {
    /// A sweep over `steps` values from `range[0]` to `range[1]`, both included, of the number with this path.
    ///
    /// If there are several paths, separated by commas, the first number has these values and the others change by the same amount:
    /// an axle keeps its distance from the next. A path after a minus sign changes by minus this amount. `[*]` in a path stands for
    /// every existing index.
    ///
    /// # Errors
    ///
    /// [`SweepError`], except for values without an answer, which are found only when they are solved.
    pub fn new(scene: &'a Scene, path: &str, range: [f64; 2], steps: usize) -> Result<Self, SweepError> {
        let (first, others) = path.split_once(',').map_or((path, None), |(first, others)| (first, Some(others)));
        let first = each(scene, first.trim())?;
        let [quantity, rest @ ..] = &first[..] else { return Err(scene.quantity(path).map(SweepError::Twice)?) };
        let quantity = *quantity;
        let mut all: Vec<(Quantity, f64)> = rest.iter().map(|other| (*other, 1.0)).collect();
        for other in others.into_iter().flat_map(|others| others.split(',')).map(str::trim) {
            let (other, sign) = other.strip_prefix('-').map_or((other, 1.0), |path| (path.trim(), -1.0));
            all.extend(each(scene, other)?.into_iter().map(|other| (other, sign)));
        }
        let mut with: Vec<Moves> = Vec::new();
        for (other, sign) in all {
            if other == quantity || with.iter().any(|known| known.quantity == other) {
                return Err(SweepError::Twice(other));
            }
            if other.kind() != quantity.kind() {
                return Err(SweepError::Units { first: quantity, other });
            }
            with.push(Moves { quantity: other, number: scene.number(other).unwrap_or_default(), sign });
        }
        let [from, to] = range;
        if !(2..=MOST_STEPS).contains(&steps) {
            return Err(SweepError::Steps(steps));
        }
        let width = (to - from).abs();
        if !(0.0 < width && width.is_finite()) {
            return Err(SweepError::Range { from, to });
        }
        Ok(Self { scene, quantity, with, range, steps })
    }

    /// The varied number; if there are several, the first.
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// The paths of all varied numbers, separated by commas, with a minus sign before those that change by minus the amount.
    #[must_use]
    pub fn paths(&self) -> String {
        let others = self.with.iter().map(|Moves { quantity, sign, .. }| {
            let minus = if *sign < 0.0 { "-" } else { "" };
            format!("{minus}{quantity}")
        });
        std::iter::once(self.quantity.to_string()).chain(others).collect::<Vec<_>>().join(",")
    }

    /// The values of the varied number.
    #[expect(clippy::cast_precision_loss, reason = "at most 20,001 steps")]
    pub fn values(&self) -> impl ExactSizeIterator<Item = f64> + use<> {
        let ([from, to], last) = (self.range, self.steps - 1);
        (0..self.steps).map(move |i| if i == last { to } else { from + (to - from) * (i as f64 / last as f64) })
    }

    /// A walk along the values.
    #[must_use]
    pub fn walk(&self) -> Walk<'_> {
        Walk { sweep: self, last: None, work: 0 }
    }

    /// A collector for the envelope of the rows.
    #[must_use]
    pub fn gathered(&self) -> Gathered<'_> {
        Gathered::new(self)
    }

    /// All rows, or the rows before the beam buckles.
    ///
    /// # Errors
    ///
    /// [`SweepError::Invalid`] at the first value without an answer, unless the beam buckles there and an earlier value has an
    /// answer. A row that is not certified is not an error.
    pub fn rows(&self) -> Result<Vec<Row>, SweepError> {
        let (mut walk, mut rows) = (self.walk(), Vec::new());
        for value in self.values() {
            match walk.solve(value) {
                Ok(step) => rows.push(walk.row(step)),
                Err(error) if !rows.is_empty() && error.buckles() => break,
                Err(error) => return Err(error),
            }
        }
        Ok(rows)
    }

    /// The answer for a value; the search starts from the answers at nearby values.
    fn answer(&self, value: f64, near: &[&Exact]) -> Result<(Scene, Exact), TheoryError> {
        let scene = self.scene(value)?;
        let exact = theory::solve_near(&scene, near)?;
        Ok((scene, exact))
    }
}

/// A walk from value to value, in their order. The search for each answer starts from the previous one.
#[derive(Debug)]
pub struct Walk<'a> {
    sweep: &'a Sweep<'a>,
    last: Option<(f64, Exact)>,
    work: u64,
}

/// A value with its scene and its answer, from which envelopes and rows are made.
#[derive(Debug)]
pub struct Step {
    value: f64,
    scene: Scene,
    exact: Exact,
}

/// The results of an answer at a position.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AtPlace {
    /// The position \[length\].
    pub x: f64,
    /// `v`, positive downwards \[length\].
    pub deflection: f64,
    /// `v'`.
    pub slope: f64,
    /// `M` just left and just right of the position \[force · length\].
    pub moment: [f64; 2],
    /// `V = M'` just left and just right of the position \[force\].
    pub shear: [f64; 2],
}

impl Step {
    /// The results at a position of the beam.
    #[must_use]
    pub fn at(&self, x: f64) -> AtPlace {
        let exact = &self.exact;
        AtPlace {
            x,
            deflection: exact.deflection(x),
            slope: exact.slope(x),
            moment: exact.moments(x),
            shear: exact.shear(x),
        }
    }
}

impl Walk<'_> {
    /// The work needed for the rows so far.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.work
    }

    /// The exact answer for the next value, not judged yet.
    ///
    /// # Errors
    ///
    /// [`SweepError::Invalid`].
    pub fn solve(&mut self, value: f64) -> Result<Step, SweepError> {
        let near = self.last.as_ref().map(|(_, exact)| exact);
        match self.sweep.answer(value, near.as_slice()) {
            Ok((scene, exact)) => Ok(Step { value, scene, exact }),
            Err(error) => Err(SweepError::Invalid {
                quantity: self.sweep.quantity,
                value,
                border: self.last.as_ref().map_or(value, |&(last, _)| self.border(last, value)),
                error,
            }),
        }
    }

    /// The answer with its verdict. The next answer starts from it.
    pub fn row(&mut self, Step { value, scene, exact }: Step) -> Row {
        let pattern = exact.pattern();
        self.work = self.work.saturating_add(exact.work()).saturating_add(exact.work_of_bounds());
        let mut solution = exact.judged(&scene, &Demand::default());
        self.last = solution.exact.take().map(|exact| (value, *exact));
        Row { value, solution, pattern }
    }

    /// The last value with a well-posed scene on the way from a value with one to a value without.
    #[must_use]
    pub fn border(&self, with: f64, without: f64) -> f64 {
        let has = |value, (): &()| self.sweep.scene(value).and_then(|scene| scene.scaled()).ok().map(drop);
        last((with, ()), without, u32::MAX, |_, _| false, has).0
    }
}

/// The numbers of a path, in which `[*]` stands for every existing index.
fn each(scene: &Scene, path: &str) -> Result<Vec<Quantity>, PathError> {
    let Some((before, behind)) = path.split_once("[*]") else {
        return scene.quantity(path).map(|quantity| vec![quantity]);
    };
    let of = |i: usize| scene.quantity(&format!("{before}[{i}]{behind}"));
    let rest = (1..).map_while(|i| of(i).ok());
    Ok(std::iter::once(of(0)?).chain(rest).collect())
}

/// Bisects between a value for which `has` finds something and a value for which it does not. Returns the last value with a finding,
/// and the finding. The search ends after this many halvings, or earlier if there is no number in between or the interval
/// `is_narrow`.
fn last<T>(
    mut with: (f64, T),
    mut without: f64,
    halvings: u32,
    is_narrow: impl Fn(f64, f64) -> bool,
    has: impl Fn(f64, &T) -> Option<T>,
) -> (f64, T) {
    for _ in 0..halvings {
        let middle = 0.5 * (with.0 + without);
        if [with.0, without].iter().any(|end| end.total_cmp(&middle).is_eq()) || is_narrow(with.0, without) {
            break;
        }
        match has(middle, &with.1) {
            Some(found) => with = (middle, found),
            None => without = middle,
        }
    }
    with
}
