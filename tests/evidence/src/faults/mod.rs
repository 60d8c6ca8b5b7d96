//! Fault injection: what is certified about an answer, beside the truth.
//!
//! The truth is a [closed form](crate::closed) where there is one: those have beams on any supports, with own shapes, free ends and none to
//! hold them. For other scenes it is beam theory with free lift-off points, which shares no code with the judge. Theory also
//! proposes the witness that certificates are proven from: so the tests put wrong witnesses beside fractions and closed forms, too. An
//! answer comes from a route, or
//! from a route and a [`Fault`] that is put into it afterwards. Whatever it is, two things are asked:
//!
//! 1. What was guaranteed holds: `|v − v*|` is at most the certified error, `J*` lies between its bounds, the reactions in
//!    their brackets. One [`FalseBound`] is a bug of the judge.
//! 2. What passes the check of the discrete problem ([`Kkt`](palkki::certificate::Kkt)) is close to its solution.

mod answers;
mod contacts;
mod truth;

pub use answers::{FAULTS, Fault, SIZES, every_fault, every_second, scaled_ground, scaled_load};
pub use contacts::{CONTACT_FAULTS, ContactFault, every_contact_fault};
pub use truth::{Certified, Distance, FalseBound, THEORY, Truth};
