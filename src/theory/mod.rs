//! Beam theory with lift-off positions as unknowns: the exact solution of (4), (5), (8), the paper's "vertailuratkaisu", for any scene.
//!
//! The exact solution is a short list: points of contact (position, force) and zones of contact (from, to, pressure `q − EI u''''`, a
//! concentrated force at each end). Between them the beam is a polynomial that the conditions at its two ends determine. Its nodes
//! restrain the beam: supports and contacts, in one list from left to right. The only unknowns are the lift-off positions, and the slopes
//! at inner supports and edges:
//!
//! 1. `piecewise`, `breakpoints`, `shape`, `pull`: profile and load as piecewise functions, and where a zone would be in tension.
//! 2. `chain`, `guess`, `resting`: a first guess of the list, from a chain of links above samples of the profile, or from where a rigid
//!    beam rests.
//! 3. `list`, `span`, `cosine`, `newton`: the equations of a list and Newton's method for them.
//! 4. `check`, `forces`, `violation`, `piece`, `bernstein`, `gauss`: the check of all conditions, everywhere and not only at samples.
//! 5. `search`, `repair`, `penetration`, `normal`: the search. A violated condition changes the list; if that leads nowhere, the chain gets
//!    more samples. `close` examines a list that passes once more; `neutral` treats beams that rest on one position and can rotate there.
//! 6. `solve`, `exact`, `summary`, `touching`, `free_spans`: the answer in the units of the scene, where it touches without pressing, and
//!    where it is free; `room`: whether there is enough memory for it.
//! 7. `continuation`, `pattern`, `margin`: from the answer of one scene to the answer of a neighbour, and when its pattern changes.
//! 8. `sensitivity`, `tridiagonal`, `variation`, `derivatives`, `changes`, `leeway`, `spread`: derivatives with respect to the numbers of the
//!    scene, and where they are one-sided; `missing`: why a derivative does not exist.
//! 9. `springs`: an elastic foundation, which needs no list; `tension`: a part of the beam under an axial force.
//!
//! Time and memory are proportional to the number of pieces of profile and load, and of contacts.
//!
//! **Invariant:** nothing here knows a grid, a method of discretisation or a solver of the quadratic program (32).

mod acts;
mod bernstein;
mod breakpoints;
mod chain;
mod changes;
mod check;
mod close;
mod continuation;
mod cosine;
mod derivatives;
mod divided;
mod exact;
mod forces;
mod free_spans;
pub(crate) mod gauss;
mod giving;
mod guess;
mod leeway;
mod list;
mod margin;
mod neutral;
mod newton;
mod normal;
mod overhang;
mod pattern;
mod penetration;
mod piece;
mod piecewise;
mod pull;
mod repair;
mod resting;
mod room;
mod search;
mod sensitivity;
mod shape;
mod solve;
mod span;
mod spread;
mod springs;
mod summary;
mod tension;
mod touching;
mod tridiagonal;
mod variation;
mod violation;
mod way;

pub use derivatives::{By, ContactDerivative, Derivative, Missing};
pub use exact::{Exact, Sample};
pub use free_spans::FreeSpan;
pub(crate) use margin::Condition;
pub use pattern::Pattern;
pub(crate) use pattern::{ContactKind, ZoneEnd};
pub use solve::{TheoryError, solve, solve_near};
pub use spread::Spread;
pub use violation::Violation;
