//! The three methods of the paper. Each turns a scene on a grid into a quadratic program (32), and an answer of that program into a
//! [`ContactState`](crate::state::ContactState). None contains an optimisation algorithm.
//!
//! | method | unknown `x` | `A` | `b` | gradient |
//! |---|---|---|---|---|
//! | [`Complementarity`](Method::Complementarity), (4)–(16) | clearance `h` | `(EI/Δ⁴) pentadiag(1, −4, 6, −4, 1)` | `A u − q` | pressure `p` |
//! | [`Displacement`](Method::Displacement), (17)–(24) | clearance `h` | condensed stiffness `K` (20) | `K u − q` | nodal contact force |
//! | [`Force`](Method::Force), (25)–(31) | nodal contact force `p` | flexibility `C` (26) | `C q − u` | clearance `h` |
//!
//! The table is for the paper's beam. For a beam with an initial shape or supports at other levels, the gap `g` replaces `u`.
//!
//! On a given set of contacts all three methods describe the same beam, or the same chain of links, on supports at the level of the
//! foundation. `contact_set.rs` solves it, `springs.rs` on an elastic foundation and `axial.rs` under an axial force. None of them
//! uses the matrices of the table, so no method loses digits on fine grids.

mod answer;
mod axial;
mod bend;
mod complementarity;
pub(crate) mod contact_set;
mod discrete;
mod displacement;
mod divisions;
mod extremes;
mod force;
mod held_beam;
mod overhang;
mod program;
mod rigid;
pub(crate) mod span;
mod sparse;
mod springs;
mod statics;
pub(crate) mod supports;
mod touching;
mod turns;

pub use answer::Nodal;
pub(crate) use answer::{contact_state, free_beam};
pub use discrete::Discrete;
pub use force::flexibility;
pub(crate) use rigid::{balanced, single_contact};
pub use sparse::unsigned;

use std::f64::consts::PI;
use std::fmt;

use crate::qp::Qp;
use crate::state::Discretisation;
use program::Program;

/// The three methods of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Method {
    /// Complementarity problem by finite differences, (4)–(16).
    Complementarity,
    /// Potential energy, no penetration, (17)–(24).
    Displacement,
    /// Complementary energy, no tension, (25)–(31).
    Force,
}

impl Method {
    /// All methods, in the order of the paper.
    pub const ALL: [Self; 3] = [Self::Complementarity, Self::Displacement, Self::Force];

    /// The name used by command line, JSON and report.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Complementarity => "complementarity",
            Self::Displacement => "displacement",
            Self::Force => "force",
        }
    }

    /// The quadratic program (32) of this method for a scene on a grid.
    #[must_use]
    pub fn qp(self, discrete: &Discrete) -> Box<dyn Qp + '_> {
        Box::new(Program { method: self, discrete })
    }

    /// The shape of the beam of this method between the nodes.
    #[must_use]
    pub fn discretisation(self) -> Discretisation {
        match self {
            Self::Complementarity => Discretisation::FiniteDifferences,
            Self::Displacement | Self::Force => Discretisation::BeamElements,
        }
    }

    /// Whether the variable of a node is free where there is contact, like a contact force, or where there is none, like a clearance.
    #[must_use]
    pub fn is_free_in_contact(self) -> bool {
        match self {
            Self::Complementarity | Self::Displacement => false,
            Self::Force => true,
        }
    }

    /// The length by which a contact force is divided in the gradient: finite differences use pressures, the other methods forces.
    #[must_use]
    pub fn share(self, discrete: &Discrete) -> f64 {
        match self {
            Self::Complementarity => discrete.spacing,
            Self::Displacement | Self::Force => 1.0,
        }
    }

    /// The nodal values that belong to an answer `(x, g)` of the quadratic program.
    #[must_use]
    pub fn nodal(self, discrete: &Discrete, x: Vec<f64>, gradient: Vec<f64>) -> Nodal {
        let [x, gradient] = [x, gradient].map(|values| discrete.with_supports(values));
        let (clearance, contact_force) = if self.is_free_in_contact() {
            (gradient, x)
        } else {
            (x, gradient.into_iter().map(|p| p * self.share(discrete)).collect())
        };
        Nodal::new(discrete, self.discretisation(), clearance, contact_force)
    }

    /// `cond A = ‖A‖ ‖A⁻¹‖` of the matrix of this method in the Euclidean norm, on `intervals` equal intervals of any beam.
    ///
    /// All three matrices are functions of `T = tridiag(−1, 2, −1)`, shape (n, n), whose eigenvalues are known. They are monotonic in
    /// `T`, so their condition numbers are quotients of the values at its largest and smallest eigenvalues:
    ///
    /// ```text
    /// λ_k = 4 sin²(k π / 2N),   k = 1 … n
    /// finite differences   A = (EI/Δ⁴) T²                         λ²
    /// stiffness            K = (EI/Δ³) T (1 − T/6)⁻¹ T            λ² / (1 − λ/6)
    /// flexibility          C = K⁻¹                                the inverse
    /// ```
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
    pub fn condition(self, intervals: usize) -> f64 {
        let angle = 0.5 * PI / intervals as f64;
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        // sin(n π/2N) = cos(π/2N).
        let (least, largest) = (4.0 * sine * sine, 4.0 * cosine * cosine);
        let root = largest / least;
        match self {
            Self::Complementarity => root * root,
            Self::Displacement | Self::Force => root * root * (1.0 - least / 6.0) / (1.0 - largest / 6.0),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
