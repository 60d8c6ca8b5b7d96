//! Targets of a search along a sweep: `deflection(4.0) = 0.0095`, or `contact`.

use std::fmt;

use crate::scene::{Scene, as_written};
use crate::theory::Exact;

/// A quantity that can be measured in each answer of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// `v(x)`, positive downwards \[length\].
    Deflection(f64),
    /// `M(x)`, just right of `x` where it has two values \[force · length\].
    Moment(f64),
    /// `V(x) = M'(x)`, just right of `x` where it has two values \[force\].
    Shear(f64),
    /// `h(x)` \[length\].
    Clearance(f64),
    /// The reaction of this support, counted from 0 from left to right, positive upwards on the beam \[force\].
    Support(usize),
    /// The total contact force if the beam touches the foundation \[force\]; otherwise minus the least clearance \[length\]. It is
    /// zero where contact begins or ends.
    Contact,
    /// For compression-only supports without a foundation: their least force if the beam bears on all of them \[force\]; otherwise
    /// minus the largest clearance at one of them \[length\].
    Bearings,
}

/// A measured quantity and its target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Until {
    /// The measured quantity.
    pub measure: Measure,
    /// The target; 0 for [`Measure::Contact`] and [`Measure::Bearings`].
    pub target: f64,
}

/// The reason why a text is not a valid target.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum UntilError {
    /// The text has none of the accepted forms.
    #[error(
        "`{0}` is not a condition. The forms are `contact`, where contact begins or ends, and `QUANTITY = NUMBER` \
         with one of the quantities deflection(x), moment(x), shear(x), clearance(x), and support[i] for a reaction"
    )]
    Form(String),
    /// The right-hand side is not a finite number.
    #[error("the right-hand side of `{text}` must be a finite number, but is `{number}`")]
    Number {
        /// The whole text.
        text: String,
        /// The text in place of the number.
        number: String,
    },
    /// The position is not on the beam.
    #[error("the position in `{measure}` must lie on the beam, between 0 and {}", as_written(*length))]
    Place {
        /// The measured quantity, with the position.
        measure: Measure,
        /// The length of the beam.
        length: f64,
    },
    /// The support does not exist.
    #[error(
        "`{measure}` must be one of the {count} supports of the beam, which are counted from 0 on from left to right"
    )]
    Support {
        /// The measured quantity, with the index of the support.
        measure: Measure,
        /// The number of supports.
        count: usize,
    },
    /// There is no foundation or compression-only support.
    #[error("`{0}` needs a foundation or a support with `pushes_only`, and the scene has neither")]
    NoFoundation(Measure),
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Deflection(x) => write!(f, "deflection({x})"),
            Self::Moment(x) => write!(f, "moment({x})"),
            Self::Shear(x) => write!(f, "shear({x})"),
            Self::Clearance(x) => write!(f, "clearance({x})"),
            Self::Support(index) => write!(f, "support[{index}]"),
            Self::Contact | Self::Bearings => f.write_str("contact"),
        }
    }
}

impl fmt::Display for Until {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.measure {
            measure if measure.is_contact() => measure.fmt(f),
            measure => write!(f, "{measure} = {}", self.target),
        }
    }
}

impl Until {
    /// Reads `contact` or `QUANTITY = NUMBER` for the beam of a scene.
    ///
    /// # Errors
    ///
    /// [`UntilError`].
    pub fn parse(text: &str, scene: &Scene) -> Result<Self, UntilError> {
        let form = || UntilError::Form(text.to_owned());
        let until = if text.trim() == "contact" {
            let on_ground = scene.foundation().is_some();
            Self { measure: if on_ground { Measure::Contact } else { Measure::Bearings }, target: 0.0 }
        } else {
            let (measure, number) = text.split_once('=').ok_or_else(form)?;
            let measure = Measure::parse(measure.trim()).ok_or_else(form)?;
            let number = number.trim();
            let target = number.parse().ok().filter(|target: &f64| target.is_finite());
            let wrong = || UntilError::Number { text: text.to_owned(), number: number.to_owned() };
            Self { measure, target: target.ok_or_else(wrong)? }
        };
        until.measure.fits(scene)?;
        Ok(until)
    }
}

/// A measured number, and the largest number of its kind in the same answer, with which its rounding is compared.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measured {
    pub(super) number: f64,
    pub(super) size: f64,
}

impl Measured {
    /// Answers satisfy their conditions to 12 digits.
    const DIGITS: f64 = 1e-12;

    /// 1 above a target, −1 below it, and 0 if it is reached to rounding.
    pub(super) fn side_of(self, target: f64) -> f64 {
        let off = self.number - target;
        if off.abs() <= self.rounding(target) { 0.0 } else { off.signum() }
    }

    /// Rounding of the number near a target.
    pub(super) fn rounding(self, target: f64) -> f64 {
        Self::DIGITS * self.size.max(target.abs())
    }
}

impl Measure {
    fn parse(text: &str) -> Option<Self> {
        if let Some(index) = text.strip_prefix("support[").and_then(|rest| rest.strip_suffix(']')) {
            return index.trim().parse().ok().map(Self::Support);
        }
        let (name, x) = text.strip_suffix(')')?.split_once('(')?;
        let x: f64 = x.trim().parse().ok()?;
        match name.trim_end() {
            "deflection" => Some(Self::Deflection(x)),
            "moment" => Some(Self::Moment(x)),
            "shear" => Some(Self::Shear(x)),
            "clearance" => Some(Self::Clearance(x)),
            _ => None,
        }
    }

    /// Whether the target is the beginning or end of contact.
    #[must_use]
    pub fn is_contact(self) -> bool {
        matches!(self, Self::Contact | Self::Bearings)
    }

    /// Checks that the beam of a scene has this quantity.
    fn fits(self, scene: &Scene) -> Result<(), UntilError> {
        let (length, supports) = (scene.beam().length(), scene.beam().all_supports());
        let bearing = |x: f64| supports.iter().any(|support| support.pushes_only && support.at.total_cmp(&x).is_eq());
        match self {
            Self::Deflection(x) | Self::Moment(x) | Self::Shear(x) | Self::Clearance(x)
                if !(0.0..=length).contains(&x) =>
            {
                Err(UntilError::Place { measure: self, length })
            }
            Self::Support(index) if supports.len() <= index => {
                Err(UntilError::Support { measure: self, count: supports.len() })
            }
            Self::Clearance(x) if scene.foundation().is_none() && !bearing(x) => Err(UntilError::NoFoundation(self)),
            Self::Bearings if supports.iter().all(|support| !support.pushes_only) => {
                Err(UntilError::NoFoundation(self))
            }
            _ => Ok(()),
        }
    }

    /// The quantity in an answer of a beam of this length, if it is a finite number.
    pub(super) fn of(self, exact: &Exact, length: f64) -> Option<Measured> {
        let state = &exact.state;
        let deflection = state.deflection.max.abs().max(state.deflection.min.abs());
        let forces = state.supports.iter().map(|support| support.force.abs());
        let force = forces.fold(state.contact_force().abs(), f64::max);
        let (number, size) = match self {
            Self::Deflection(x) => (exact.deflection(x), deflection),
            Self::Moment(x) => (exact.moment(x), state.moment.max.abs().max(state.moment.min.abs())),
            Self::Shear(x) => (exact.shear(x)[1], force),
            Self::Clearance(x) => (exact.clearance(x), deflection),
            Self::Support(index) => (state.supports.get(index)?.force, force),
            Self::Contact if state.contacts.is_empty() => (-exact.clearance_extremes(0.0, length).min, deflection),
            Self::Contact => (state.contact_force(), force),
            Self::Bearings => {
                let bearings = || state.supports.iter().filter(|support| support.pushes_only);
                let lifted = bearings().filter(|support| support.force <= 0.0);
                match lifted.map(|support| exact.clearance(support.at)).max_by(f64::total_cmp) {
                    Some(most) => (0.0 - most, deflection),
                    None => (bearings().map(|support| support.force).fold(f64::INFINITY, f64::min), force),
                }
            }
        };
        number.is_finite().then_some(Measured { number, size })
    }
}
