//! The definition of `certified`: the conditions that an answer has to meet, and the message that states its error bound.
//!
//! The check ([`crate::certificate`]) measures and does not decide. It computes a residual of the discrete problem and bounds for the
//! continuous beam. An answer is **certified** if it satisfies all of these conditions:
//!
//! | | a method on a grid | beam theory |
//! |---|---|---|
//! | its own problem | the largest KKT residual is at most [`CERTIFIED_RESIDUAL`], or what was [demanded](Demand) | every condition is satisfied along the whole beam, to 12 digits |
//! | the certificate | it exists: all bounds are finite, `energy_lower ≤ energy_upper`, `0 ≤ gap` | the same |
//! | its own numbers | the judged deflection is the deflection of its nodes | its largest deflection differs from the judged one by at most `deflection_error` and at most half of the judged deflection; its energy is between the bounds |
//! | the error | `deflection_error` ≤ share × largest deflection, where the share is [`USABLE`] or what was [demanded](Demand), whichever is smaller | the same with [`EXACT`] |
//! | each [`Number`] of its summary | no value in its bracket differs from the number by more than share × the largest value of that quantity, plus the rounding of the sum | the same with [`EXACT`] |
//!
//! If beam and answer are both proven to be at rest, the error is zero, because a share of zero is undefined. The same applies to a
//! beam proven to be straight apart from a rotation. If the beam can rotate freely about a position, its deflection is judged after
//! the rotation that fits best, and the message names the position.
//!
//! So an answer that solves its grid well is not certified if it may be far from the beam. Where an error is demanded
//! ([`crate::adaptive`]), the error bound includes what the solver left undone, and the residual may be up to a tenth of that error.
//! Contact forces from elsewhere have no discrete problem and no summary. For them only the certificate and the error count
//! ([`Verdict::of_forces`]). Single contact forces, their positions and moments have no bracket on a grid and are not covered.
//!
//! ```
//! use palkki::Witness;
//! use palkki::certificate::{ContactLoad, Judged};
//! use palkki::route::Status;
//! use palkki::scene::{Beam, Foundation, Load, Scene};
//! use palkki::verdict::Verdict;
//!
//! let beam = Beam::new(10.0, 500.0 / 384.0)?;
//! let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
//! // The result of another program: positions, and forces of the foundation on the beam, upwards.
//! let forces = ContactLoad::new(10.0, vec![(2.4, 1.45), (3.2, 0.9), (4.1, 0.9), (5.0, 1.1), (5.9, 0.9), (6.8, 0.9), (7.6, 1.45)])?;
//! // Bounds are proven from a candidate contact list. It comes from beam theory if theory has a solution.
//! let witness = Witness::of(&scene);
//! let certificate = witness.judge(Judged::Forces(&forces), &[])?;
//! assert!(certificate.energy_lower <= certificate.energy_upper);
//! let verdict = Verdict::of_forces(certificate);
//! assert_eq!(verdict.status, Status::NotCertified, "{verdict}");
//! assert!(verdict.to_string().starts_with("the deflection error may be "), "{verdict}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod caused;
mod summary;
pub(crate) mod witness;

use std::fmt;

use crate::certificate::{CERTIFIED_RESIDUAL, Certificate, Judged, certify};
use crate::route::Solution;
use crate::scene::Scene;
use crate::state::ContactState;
use crate::text::{Results, share_at_most};
use crate::theory::Exact;
use crate::witness::{ExactContacts, Witness};

use self::summary::{ENERGY, apart, deflection_rounding, energy_size, flaw, is_unbent, rests_as_built, shares};

pub use self::summary::Number;

/// The largest deflection error of a certified answer, as a share of the largest deflection: a tenth, the accuracy that the paper
/// calls usable.
pub const USABLE: f64 = 0.1;

/// The same limit for beam theory, which has no discretisation error.
pub const EXACT: f64 = 1e-6;

/// Our verdict on an answer. What the solver reports matters only if the answer fails our check.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Status {
    /// The answer passes our check, and its error bound is small enough.
    Certified,
    /// The solver reports success, but the answer fails our check.
    NotCertified,
    /// The solver reports no success, and its answer fails our check.
    NotConverged,
}

impl Status {
    /// All statuses.
    pub const ALL: [Self; 3] = [Self::Certified, Self::NotCertified, Self::NotConverged];

    /// The status of several answers together; `enough` says whether enough of them are certified.
    #[must_use]
    pub fn of_several(enough: bool) -> Self {
        if enough { Self::Certified } else { Self::NotCertified }
    }

    /// The only function that returns `Certified`: for an answer that passes its checks, whatever its solver reports. For any other
    /// answer the status depends on whether the solver reports success.
    pub(crate) fn of(passes: bool, reports_success: bool) -> Self {
        match (passes, reports_success) {
            (true, _) => Self::Certified,
            (false, true) => Self::NotCertified,
            (false, false) => Self::NotConverged,
        }
    }

    /// The status of an answer for a [body](crate::body), which has no discretisation error. `errors` are the largest errors of its
    /// clearances, contact forces and energy, each as a share of the largest value of that quantity.
    #[must_use]
    pub(crate) fn of_body(errors: [f64; 3], demanded: f64, reports_success: bool) -> Self {
        Self::of(errors.iter().all(|error| Self::is_certain(*error, demanded)), reports_success)
    }

    /// Whether an error is at most what was demanded and at most [`EXACT`].
    #[must_use]
    pub(crate) fn is_certain(error: f64, demanded: f64) -> bool {
        within(error, demanded.min(EXACT))
    }

    /// The word used in JSON and in the report.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Certified => "certified",
            Self::NotCertified => "not-certified",
            Self::NotConverged => "not-converged",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The accuracy that is demanded of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// Largest residual of the discrete problem. Beam theory has its own conditions and does not use it.
    pub residual: f64,
    /// Largest error bound of the deflection, as a share of the largest deflection; for beam theory at most [`EXACT`].
    pub error: f64,
}

impl Default for Demand {
    fn default() -> Self {
        Self { residual: CERTIFIED_RESIDUAL, error: USABLE }
    }
}

impl Demand {
    /// Demands an error bound of the deflection of at most `share` of the largest deflection, and never more than [`USABLE`].
    #[must_use]
    pub fn of_error(share: f64) -> Self {
        let error = share.min(USABLE);
        Self { residual: (0.1 * error).max(CERTIFIED_RESIDUAL), error }
    }
}

/// The reason why an answer is not certified.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// The answer does not solve its own discrete problem.
    #[error("the residual of its discrete problem is {residual:.1e}, more than {most:.0e}")]
    Residual {
        /// The largest KKT residual.
        residual: f64,
        /// The largest residual allowed.
        most: f64,
    },
    /// The solver returns no answer, or an answer that contains NaN or infinity.
    #[error("there is no answer to its discrete problem")]
    NoAnswer,
    /// The answer violates a condition of beam theory.
    #[error(
        "it violates a condition of beam theory by {residual:.1e}, relative to the largest deflection or moment, or to forces beside it"
    )]
    Theory {
        /// The largest violation.
        residual: f64,
    },
    /// Some numbers of the answer are not finite.
    #[error("it has numbers that are not finite")]
    NoNumbers,
    /// No finite bound could be proven for the continuous beam.
    #[error("no finite error bound could be proven")]
    Unbounded,
    /// The bounds contradict each other, so the certificate is invalid.
    #[error(
        "its bounds contradict each other: the energy lies above {lower:?} and below {upper:?}, with a gap of {gap:?}"
    )]
    Contradiction {
        /// Lower bound of the energy.
        lower: f64,
        /// Upper bound of the energy.
        upper: f64,
        /// Bound on the difference between the two.
        gap: f64,
    },
    /// The largest deflection of the answer is not the one that its contacts imply.
    #[error(
        "its largest deflection is {own:?}, but its contacts make it {judged:?} with an error of at most {error:.1e}"
    )]
    Deflection {
        /// The largest deflection of the answer.
        own: f64,
        /// The largest deflection implied by the contacts.
        judged: f64,
        /// The error bound of the judged deflection.
        error: f64,
    },
    /// The energy of the answer is outside the bounds proven from its contacts.
    #[error("its energy is {own:?}, but its contacts prove that it lies between {lower:?} and {upper:?}")]
    Energy {
        /// The energy of the answer.
        own: f64,
        /// Lower bound.
        lower: f64,
        /// Upper bound.
        upper: f64,
    },
    /// The error bound is larger than allowed.
    #[error("the deflection error may be {} of the largest deflection, more than {}", any_share(*share), share_at_most(*most))]
    Error {
        /// Error bound of the deflection over the largest deflection.
        share: f64,
        /// The largest share allowed.
        most: f64,
    },
    /// The deflection is accurate enough, but a number of the summary is not.
    #[error("the error of {of} may be {} of {}, more than {}", any_share(*share), of.kind(), share_at_most(*most))]
    Number {
        /// The number.
        of: Number,
        /// Its error bound over the largest value of that quantity.
        share: f64,
        /// The largest share allowed.
        most: f64,
    },
}

/// A share as text; it is infinite if the largest deflection is zero.
fn any_share(share: f64) -> String {
    if share.is_finite() { share_at_most(share) } else { "any share".to_owned() }
}

/// The status with its reason and bounds. Displayed, it is a message that states the error bound of the deflection or the reason for
/// the refusal.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Certified or not.
    pub status: Status,
    /// The bounds; none if the contact forces are not finite.
    pub certificate: Option<Certificate>,
    /// Error bound of the deflection over the largest deflection of the answer; infinite if nothing could be proven.
    pub error: f64,
    /// The number of the summary with the largest relative error bound, and this bound over the largest value of that quantity; none
    /// for contact forces from elsewhere.
    pub worst: Option<(Number, f64)>,
    /// The reason why the answer is not certified; none if it is.
    pub refusal: Option<Refusal>,
}

impl Verdict {
    /// Judges the answer of a method on a grid.
    #[must_use]
    pub fn of_raw(raw: &Solution<()>, witness: &Witness<'_>, demand: &Demand) -> Self {
        let own = match raw.residual {
            residual if !residual.is_finite() => Some(Refusal::NoAnswer),
            residual if within(residual, demand.residual) => None,
            residual => Some(Refusal::Residual { residual, most: demand.residual }),
        };
        let certificate = certificate(&raw.state, witness);
        let scene = witness.scene();
        Self::new(certificate, Some((scene, &raw.state)), own, demand.error, raw.run.reports_success)
    }

    /// Judges the answer of beam theory. Its own contacts are the candidate contact list.
    #[must_use]
    pub fn of_exact(scene: &Scene, exact: &Exact, demand: &Demand) -> Self {
        let certificate = ExactContacts::of(exact).proof(scene).map(|proof| proof.judge(Judged::Witness));
        let own = match (exact.solved, exact.state.is_finite()) {
            (true, _) => certificate.as_ref().and_then(|c| differs_from_bounds(scene, c, &exact.state)),
            (false, true) => Some(Refusal::Theory { residual: exact.residual }),
            (false, false) => Some(Refusal::NoNumbers),
        };
        let most = demand.error.min(EXACT);
        let size = exact.state.deflection.magnitude();
        // The answer prints its own deflection, so the difference from the judged one counts as well.
        let certificate = certificate.map(|c| {
            let off = apart(&c, size);
            // The judged deflection is known only between two bounds and may be at the farther one.
            let off = if 0.0 < off { off + (c.deflection - c.deflection_at_least) } else { 0.0 };
            Certificate { deflection_error: c.deflection_error + off, ..c }
        });
        Self::new(certificate, Some((scene, &exact.state)), own, most, exact.converged)
    }

    /// Judges contact forces alone, without a grid, by the deflection that they cause.
    #[must_use]
    pub fn of_forces(certificate: Certificate) -> Self {
        Self::new(Some(certificate), None, None, USABLE, true)
    }

    /// Builds the verdict from the certificate, the answer if it has a summary, the flaw found in its own problem, and the largest
    /// error allowed.
    fn new(
        certificate: Option<Certificate>,
        answer: Option<(&Scene, &ContactState)>,
        own: Option<Refusal>,
        most: f64,
        reports_success: bool,
    ) -> Self {
        let error = certificate.as_ref().map_or(f64::INFINITY, |c| {
            let size = answer.map_or(c.deflection, |(_, state)| state.deflection.magnitude());
            let rests = answer.is_some_and(|(scene, state)| rests_as_built(scene, state, c.deflection_error));
            if is_unbent(c) || rests { 0.0 } else { c.deflection_error / size }
        });
        let known = certificate.as_ref().zip(answer);
        let worst = known.and_then(|(c, (scene, state))| {
            // `total_cmp` sorts NaN above every number, so NaN counts as the largest error.
            shares(c, scene, state).max_by(|a, b| a.1.total_cmp(&b.1))
        });
        let refusal = own
            .or_else(|| certificate.as_ref().map_or(Some(Refusal::NoNumbers), flaw))
            .or_else(|| (!within(error, most)).then_some(Refusal::Error { share: error, most }))
            .or_else(|| {
                let (of, share) = worst.filter(|(_, share)| !within(*share, most))?;
                Some(Refusal::Number { of, share, most })
            });
        let status = Status::of(refusal.is_none(), reports_success);
        Self { status, certificate, error, worst, refusal }
    }

    /// The larger of two relative error bounds: of the deflection, and of the numbers of the summary.
    #[must_use]
    pub fn largest_error(&self) -> f64 {
        self.worst.map_or(self.error, |(_, share)| if share <= self.error { self.error } else { share })
    }

    /// Whether the answer solves its discrete problem or satisfies the conditions of theory, however far it is from the beam.
    #[must_use]
    pub fn solves_its_problem(&self) -> bool {
        matches!(self.refusal, None | Some(Refusal::Error { .. } | Refusal::Number { .. } | Refusal::Unbounded))
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let error = share_at_most(self.error);
        match self.refusal {
            None if self.error == 0.0 => f.write_str("the deflection error is 0")?,
            None => write!(f, "the deflection error is at most {error} of the largest deflection")?,
            Some(refusal) => write!(f, "{refusal}")?,
        }
        if let (None, Some((_, share))) = (self.refusal, self.worst.filter(|(_, share)| 0.0 < *share)) {
            let share = share_at_most(share);
            write!(f, ", the error of each number of the summary at most {share} of the largest of its kind")?;
        }
        let told = matches!(self.refusal, None | Some(Refusal::Error { .. }));
        if let Some(about) = self.certificate.as_ref().and_then(|c| c.up_to_a_turn).filter(|_| told) {
            write!(f, " after a turn about x = {}, which takes no force", Results::default().number(about))?;
        }
        let coarse = self.certificate.as_ref().is_some_and(|c| !c.contacts_proven);
        if told && coarse && 0.0 < self.error {
            f.write_str(" (a coarse bound: no list of contacts was proven to be that of the beam)")?;
        }
        Ok(())
    }
}

/// Bounds for an answer, in the units of the scene; none if its contact forces are not finite. On a grid the nodal deflection is
/// judged, for beam theory the deflection implied by its contacts, which are the candidate contact list.
#[must_use]
pub fn certificate(state: &ContactState, witness: &Witness<'_>) -> Option<Certificate> {
    let Some(nodes) = &state.nodes else {
        return certify(witness.scene(), Judged::Witness, &state.touched()).ok();
    };
    if nodes.contact_force.iter().any(|force| !force.is_finite()) {
        return None;
    }
    witness.judge(Judged::Nodes(nodes), &state.touched()).ok()
}

/// Checks the deflection and the energy of an exact answer against its contacts, from which the bounds are proven. An answer that
/// does not hold the beam where it should has too low an energy.
fn differs_from_bounds(scene: &Scene, certificate: &Certificate, state: &ContactState) -> Option<Refusal> {
    let Certificate { deflection: judged, deflection_error: error, .. } = *certificate;
    let Certificate { energy_lower: lower, energy_upper: upper, .. } = *certificate;
    let own = state.deflection.magnitude();
    // If the bound is larger than half of the deflection, it would accept almost any deflection.
    let most = error.min(0.5 * judged) + deflection_rounding(scene, state);
    // If a value is not finite, this comparison is false and `flaw` refuses the answer.
    if most < apart(certificate, own) {
        return Some(Refusal::Deflection { own, judged, error });
    }
    let rounding = ENERGY * energy_size(scene, state);
    let outside = state.energy + rounding < lower || upper < state.energy - rounding;
    outside.then_some(Refusal::Energy { own: state.energy, lower, upper })
}

/// Whether `value` is at most `most`; false for NaN.
fn within(value: f64, most: f64) -> bool {
    value <= most
}
