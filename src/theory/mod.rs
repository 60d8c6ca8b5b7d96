//! Beam theory with free lift-off points: the exact solution of (4), (5), (8), the paper's "vertailuratkaisu", for any scene.
//!
//! The exact solution is a short list: points of contact (place, force) and zones of contact (from, to, pressure
//! `q − EI u''''`, a concentrated force at each end). Between them the beam is a polynomial that its two ends determine.
//! Unknown are only the places where it lifts off:
//!
//! 1. `given`, `cut`, `profile`, `shape`: profile and load as functions by pieces.
//! 2. `chain`, `guess`, `zones`: a first idea of the list, from a chain of links above samples of the profile.
//! 3. `list`, `hold`, `span`, `cosine`, `newton`, `bracket`: the equations of a list and Newton's method for its lift-off positions.
//! 4. `piece`, `forces`, `pressure`, `bernstein`, `penetration`, `measure`, `verify`, `fault`: all conditions, everywhere and not at samples.
//! 5. `repair`, `tidy`, `gap`, `edge`, `search`, `alternatives`, `explore`: what fails its check changes the list, first all of it, then
//!    fault by fault; after a bounded number of lists it ends.
//! 6. `exact`, `summary`, `violation`, `samples`, `solve`: the answer in the units of the scene.
//!
//! [`flat()`] is the paper's own case in closed form, [`closed`] has others.
//!
//! **Invariant:** nothing here knows a grid, a method of discretisation or a solver of the programme (32).

mod alternatives;
mod bernstein;
mod bracket;
mod chain;
pub mod closed;
mod cosine;
mod cut;
mod edge;
mod exact;
mod explore;
mod fault;
mod flat;
mod forces;
mod gap;
mod gauss;
mod given;
mod guess;
mod hold;
mod list;
mod measure;
mod newton;
mod penetration;
mod piece;
mod pressure;
mod profile;
mod repair;
mod samples;
mod search;
mod shape;
mod solve;
mod span;
mod summary;
mod tidy;
mod verify;
mod violation;
mod zones;

pub use exact::Exact;
pub use flat::{FlatSolution, flat};
pub use samples::Sample;
pub use solve::{TheoryError, solve};
pub use violation::Violation;
