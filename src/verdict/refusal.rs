//! Why an answer is not certified, in words.

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
    /// It violates conditions of beam theory.
    #[error(
        "it violates a condition of beam theory by {residual:.1e}, relative to the largest deflection, force or moment"
    )]
    Theory {
        /// The worst violation.
        residual: f64,
    },
    /// Its contact forces are no numbers, so that nothing can be said about them.
    #[error("its contact forces are not all numbers")]
    NoNumbers,
    /// Nothing could be proven for the continuous beam.
    #[error("no finite bounds for the continuous beam could be proven from its contact forces")]
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
    /// The guaranteed error is larger than what was demanded.
    #[error(
        "its guaranteed error is {share:.1e} of the largest deflection, more than the {most:.1e} that was demanded"
    )]
    Error {
        /// Guaranteed error over the largest deflection.
        share: f64,
        /// What was demanded.
        most: f64,
    },
}
