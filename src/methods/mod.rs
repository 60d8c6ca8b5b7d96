//! The three methods of the paper: each turns a scene on a grid into the programme (32) and an answer of the programme
//! into a [`ContactState`](crate::state::ContactState). They know beams and no algorithm.
//!
//! | method | unknown `x` | `A` | `b` | gradient |
//! |---|---|---|---|---|
//! | [`Complementarity`], (4)–(16) | clearance `h` | `(EI/Δ⁴) pentadiag(1, −4, 6, −4, 1)` | `A u − q` | pressure `p` |
//! | [`Displacement`], (17)–(24) | clearance `h` | condensed stiffness `K` (20) | `K u − q` | nodal contact force |
//! | [`Force`], (25)–(31) | nodal contact force `p` | flexibility `C` (26) | `C q − u` | clearance `h` |
//!
//! On a contact set each has equations of its own, in which no fourth difference is taken: three moments of a chain
//! (`hencky.rs`), rotations (`rotations.rs`), three moments of a beam (`continuous.rs`). All are tridiagonal, of condition
//! number at most 3 once scaled, and so each method keeps its discrete problem and its digits on any grid.

mod complementarity;
mod continuous;
mod cubic;
mod discrete;
mod displacement;
mod force;
mod held;
mod hencky;
mod method;
mod native;
mod nodal;
mod ranges;
mod rotations;
mod segment;
mod spectrum;
mod statics;

pub use complementarity::Complementarity;
pub use discrete::Discrete;
pub use displacement::Displacement;
pub use force::{Force, flexibility};
pub use method::Method;
pub use nodal::{Nodal, contact_state, free_beam};

use crate::problem::Programme;
use crate::state::Bending;

impl Method {
    /// The programme (32) that this method makes of a scene on a grid.
    #[must_use]
    pub fn programme(self, discrete: &Discrete) -> Box<dyn Programme + '_> {
        match self {
            Self::Complementarity => Box::new(Complementarity(discrete)),
            Self::Displacement => Box::new(Displacement(discrete)),
            Self::Force => Box::new(Force { discrete, bending: self.bending() }),
        }
    }

    /// How the beam of this method bends between the nodes.
    #[must_use]
    pub fn bending(self) -> Bending {
        match self {
            Self::Complementarity => Bending::AtNodes,
            Self::Displacement | Self::Force => Bending::Between,
        }
    }

    /// What an answer `(x, g)` of the programme means for the nodes.
    #[must_use]
    pub fn nodal(self, discrete: &Discrete, x: Vec<f64>, gradient: Vec<f64>) -> Nodal {
        let (clearance, contact_force) = match self {
            Self::Complementarity => (x, gradient.into_iter().map(|p| p * discrete.spacing).collect()),
            Self::Displacement => (x, gradient),
            Self::Force => (gradient, x),
        };
        let deflection = self.deflection(discrete, &clearance, &contact_force);
        Nodal { bending: self.bending(), deflection, clearance, contact_force }
    }

    /// `v = u − h`; where the ground lies so deep that this difference has few digits left, or none, `v = C t` by statics.
    fn deflection(self, discrete: &Discrete, clearance: &[f64], contact_force: &[f64]) -> Vec<f64> {
        /// Ground this many times as deep as the beam deflects: three of sixteen digits are what the difference may lose, and
        /// more than statics lose on any grid on which the difference would be the better one.
        const DEEP: f64 = 1e3;
        let mut deflection = discrete.clearances(clearance);
        let size = DEEP * discrete.sizes().x;
        if discrete.depths.iter().all(|&u| u <= size) {
            return deflection;
        }
        let carried: Vec<f64> = discrete.interior_loads().iter().zip(contact_force).map(|(q, p)| q - p).collect();
        let by_statics = discrete.deflection(&carried, self.bending());
        for ((v, &statics), &u) in deflection.iter_mut().zip(&by_statics).zip(&discrete.depths) {
            if size < u {
                *v = statics;
            }
        }
        deflection
    }
}
