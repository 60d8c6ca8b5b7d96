//! What `certified` means, in one place: which conditions an answer has to meet, and the message on how far it may be off,
//! certified or not.
//!
//! The check ([`crate::certificate`]) measures and does not decide: it computes a residual of the discrete problem, and bounds for
//! the continuous beam. An answer is **certified** if all of this holds.
//!
//! | | a method on a grid | beam theory |
//! |---|---|---|
//! | its own problem | the worst of the KKT residuals is at most [`CERTIFIED_RESIDUAL`], or what was [demanded](Demand) | every condition holds everywhere, to 12 digits |
//! | the certificate | there is one: all bounds are finite, `energy_lower ≤ energy_upper`, `0 ≤ gap` | the same |
//! | its own numbers | the deflection that is judged is that of its nodes | its largest deflection differs from the one that is judged by no more than `deflection_error`, and by no more than half of it; its energy is between the bounds |
//! | the error | `deflection_error` ≤ share × largest deflection, the share being [`USABLE`] or what was [demanded](Demand), whichever is smaller | the same with [`EXACT`] |
//! | each [`Number`] of its summary | no value of its bracket is farther from it than share × the largest of its kind, and what rounding makes of such a sum | the same with [`EXACT`] |
//!
//! A beam that is proven to be at rest, with an answer that is at rest too, has the error zero, and so has one that is proven to be
//! straight but for a turn: a share of no deflection is undefined.
//! The deflection of a beam that may turn freely about a place is judged after the turn that fits best, and the message has the place.
//!
//! So no answer is certified that may be far from the beam, however well it solves its grid. Where an error is demanded
//! ([`crate::adaptive`]), it counts in what the solver left undone, and the residual may be as large as a tenth of it.
//! Contact forces from elsewhere have no problem and no summary of their own: of them the certificate and the error count
//! ([`Verdict::of_forces`]). A single contact force, its place and a moment of a grid have no bracket, and nothing is said of them.
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
//! // What some program found: places, and forces of the foundation on the beam, upwards.
//! let forces = ContactLoad::new(10.0, vec![(2.4, 1.45), (3.2, 0.9), (4.1, 0.9), (5.0, 1.1), (5.9, 0.9), (6.8, 0.9), (7.6, 1.45)])?;
//! // Bounds are proven from a list of contacts: that of beam theory, if it has one.
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

use self::summary::{ENERGY, apart, deflection_rounding, energy_size, flaw, is_unbent, shares};

pub use self::summary::Number;

/// Share of its largest value to which a deflection has to be certain: a tenth, what the paper calls usable.
pub const USABLE: f64 = 0.1;

/// The same of beam theory, which has no discretisation error.
pub const EXACT: f64 = 1e-6;

/// Our verdict on an answer, independent of what the solver reports unless the answer fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Status {
    /// The answer passes our own check, and its deflection is certain enough.
    Certified,
    /// An answer came back and fails it.
    NotCertified,
    /// The solver gave up, and what it had fails our check.
    NotConverged,
}

impl Status {
    /// Every status.
    pub const ALL: [Self; 3] = [Self::Certified, Self::NotCertified, Self::NotConverged];

    /// That of several answers together, of which enough are certified, or not.
    #[must_use]
    pub fn of_several(enough: bool) -> Self {
        if enough { Self::Certified } else { Self::NotCertified }
    }

    /// The only place that returns `Certified`: for an answer that passes its checks, whatever its solver reports. For another one
    /// the status depends on whether the solver reports success.
    pub(crate) fn of(passes: bool, reports_success: bool) -> Self {
        match (passes, reports_success) {
            (true, _) => Self::Certified,
            (false, true) => Self::NotCertified,
            (false, false) => Self::NotConverged,
        }
    }

    /// Of an answer for a [body](crate::body), which has no discretisation error: from the largest errors of its clearances, contact
    /// forces and energy, each as a share of the largest of its kind, and what was demanded.
    #[must_use]
    pub(crate) fn of_body(errors: [f64; 3], demanded: f64, reports_success: bool) -> Self {
        Self::of(errors.iter().all(|error| Self::is_certain(*error, demanded)), reports_success)
    }

    /// Whether one of these errors is as small as it has to be.
    #[must_use]
    pub(crate) fn is_certain(error: f64, demanded: f64) -> bool {
        within(error, demanded.min(EXACT))
    }

    /// The word that JSON and report use.
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

/// The accuracy that an answer must have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// Largest residual of the discrete problem; not used for beam theory, which has conditions of its own.
    pub residual: f64,
    /// Largest guaranteed error of the deflection, as a share of the largest deflection; of beam theory never more than
    /// [`EXACT`].
    pub error: f64,
}

impl Default for Demand {
    fn default() -> Self {
        Self { residual: CERTIFIED_RESIDUAL, error: USABLE }
    }
}

impl Demand {
    /// A guaranteed error of the deflection of at most `share` of the largest deflection, and never more than [`USABLE`].
    #[must_use]
    pub fn of_error(share: f64) -> Self {
        let error = share.min(USABLE);
        Self { residual: (0.1 * error).max(CERTIFIED_RESIDUAL), error }
    }
}

/// Why an answer is not certified.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// It does not solve its own discrete problem.
    #[error("the residual of its discrete problem is {residual:.1e}, more than {most:.0e}")]
    Residual {
        /// The worst of the KKT residuals.
        residual: f64,
        /// What was allowed.
        most: f64,
    },
    /// The solver gives no answer, or one that is not all numbers.
    #[error("there is no answer to its discrete problem")]
    NoAnswer,
    /// It violates conditions of beam theory.
    #[error(
        "it violates a condition of beam theory by {residual:.1e}, relative to the largest deflection or moment, or to forces beside it"
    )]
    Theory {
        /// The worst violation.
        residual: f64,
    },
    /// Its numbers are not all finite.
    #[error("it has numbers that are not finite")]
    NoNumbers,
    /// Nothing could be proven for the continuous beam.
    #[error("no finite error bound could be proven")]
    Unbounded,
    /// The bounds contradict each other; there is no such certificate.
    #[error(
        "its bounds contradict each other: the energy lies above {lower:?} and below {upper:?}, with a gap of {gap:?}"
    )]
    Contradiction {
        /// Lower bound of the energy.
        lower: f64,
        /// Upper bound.
        upper: f64,
        /// Bound on their distance.
        gap: f64,
    },
    /// Its largest deflection is not the one that its contacts make.
    #[error(
        "its largest deflection is {own:?}, but its contacts make it {judged:?} with an error of at most {error:.1e}"
    )]
    Deflection {
        /// Its own.
        own: f64,
        /// That of the contacts.
        judged: f64,
        /// The guaranteed error.
        error: f64,
    },
    /// Its energy is not between the bounds that its contacts prove.
    #[error("its energy is {own:?}, but its contacts prove that it lies between {lower:?} and {upper:?}")]
    Energy {
        /// Its own.
        own: f64,
        /// Lower bound.
        lower: f64,
        /// Upper bound.
        upper: f64,
    },
    /// The guaranteed error is larger than what is allowed.
    #[error("the deflection error may be {} of the largest deflection, more than {}", any_share(*share), share_at_most(*most))]
    Error {
        /// Guaranteed error over the largest deflection.
        share: f64,
        /// What is allowed.
        most: f64,
    },
    /// The deflection is certain enough, and a number of the summary is not.
    #[error("the error of {of} may be {} of {}, more than {}", any_share(*share), of.kind(), share_at_most(*most))]
    Number {
        /// Which.
        of: Number,
        /// Guaranteed error over the largest of its kind.
        share: f64,
        /// What is allowed.
        most: f64,
    },
}

/// A share that may be without bound, as it is of a deflection that is zero.
fn any_share(share: f64) -> String {
    if share.is_finite() { share_at_most(share) } else { "any share".to_owned() }
}

/// The status with its reason and bounds. Displayed, it is a message on how far the beam may be off, or what else is wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Certified or not.
    pub status: Status,
    /// The bounds; none if the forces are no numbers.
    pub certificate: Option<Certificate>,
    /// Guaranteed error of the deflection over the largest deflection of the answer; infinite where nothing could be shown.
    pub error: f64,
    /// The number of its summary that is known worst, with its guaranteed error over the largest of its kind; none of contact forces
    /// from elsewhere.
    pub worst: Option<(Number, f64)>,
    /// Why it is not certified; none if it is.
    pub refusal: Option<Refusal>,
}

impl Verdict {
    /// On the answer of a method on a grid.
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

    /// On the answer of beam theory, whose contacts are its own witness.
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
        // What is printed is its own deflection: its distance from the one that is judged counts as well.
        let certificate = certificate.map(|c| {
            let off = apart(&c, size);
            // The one that is judged is known to lie between two bounds, and may be at the farther one.
            let off = if 0.0 < off { off + (c.deflection - c.deflection_at_least) } else { 0.0 };
            Certificate { deflection_error: c.deflection_error + off, ..c }
        });
        Self::new(certificate, Some((scene, &exact.state)), own, most, exact.converged)
    }

    /// On contact forces alone, without a grid: the deflection that they cause is judged.
    #[must_use]
    pub fn of_forces(certificate: Certificate) -> Self {
        Self::new(Some(certificate), None, None, USABLE, true)
    }

    /// From the certificate, the answer if it has a summary, what is wrong with how it solves its own problem, and the largest error.
    fn new(
        certificate: Option<Certificate>,
        answer: Option<(&Scene, &ContactState)>,
        own: Option<Refusal>,
        most: f64,
        reports_success: bool,
    ) -> Self {
        let error = certificate.as_ref().map_or(f64::INFINITY, |c| {
            let size = answer.map_or(c.deflection, |(_, state)| state.deflection.magnitude());
            if is_unbent(c) { 0.0 } else { c.deflection_error / size }
        });
        let known = certificate.as_ref().zip(answer);
        let worst = known.and_then(|(c, (scene, state))| {
            // Not a number counts as the worst of all.
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

    /// The larger one of the guaranteed errors of the deflection and of the numbers of the summary.
    #[must_use]
    pub fn largest_error(&self) -> f64 {
        self.worst.map_or(self.error, |(_, share)| if share <= self.error { self.error } else { share })
    }

    /// Whether it solves its discrete problem, or meets the conditions of theory, however far that is from the beam.
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

/// Bounds for an answer, in the units of the scene; none if its contact forces are no numbers. Of a grid the deflection at its
/// nodes is judged, of beam theory the one that its contacts make, which are their own witness.
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

/// An exact answer is judged by the places of its contacts: its own deflection has to be the one that they make.
///
/// And its energy lies between the bounds that they prove: a beam that is not held where it should be has too little of it.
fn differs_from_bounds(scene: &Scene, certificate: &Certificate, state: &ContactState) -> Option<Refusal> {
    let Certificate { deflection: judged, deflection_error: error, .. } = *certificate;
    let Certificate { energy_lower: lower, energy_upper: upper, .. } = *certificate;
    let own = state.deflection.magnitude();
    // Within a bound of more than half the deflection any deflection would do.
    let most = error.min(0.5 * judged) + deflection_rounding(scene, state);
    // Where nothing is finite this is false, and `flaw` refuses.
    if most < apart(certificate, own) {
        return Some(Refusal::Deflection { own, judged, error });
    }
    let rounding = ENERGY * energy_size(scene, state);
    let outside = state.energy + rounding < lower || upper < state.energy - rounding;
    outside.then_some(Refusal::Energy { own: state.energy, lower, upper })
}

/// Not true of NaN.
fn within(value: f64, most: f64) -> bool {
    value <= most
}
