//! The kernel: everything that the bound on a deflection rests on, apart from the theorem at the head of [`certificate`](super).
//!
//! | part | files |
//! |---|---|
//! | intervals and polynomials with interval coefficients | `interval`, `polynomial` |
//! | enclosure of the scene: foundation, gap, load, and what is zero up to rounding | `foundation`, `gap`, `load`; `scene::pieces` |
//! | from contact nodes to a proven pair: spans, springs, clearances, contact forces, gap | `contact_node`, `span`, `flexibility`, `giving`, `proof`, `clearance`, `pressing`, `held`, `lines` |
//! | the same under an axial force; the margin against buckling | `tension`; `steady` |
//! | the same on an elastic foundation; short stretches, and what holds the beam locally | `springs`; `walks`, `groups` |
//! | from the gap to the error of a deflection | `reference`, `distance` |
//!
//! The only input from outside is a scene. The kernel bounds the error of any deflection that is a polynomial on each of a set of cells.

pub(super) mod clearance;
pub(super) mod contact_node;
pub(super) mod distance;
mod flexibility;
pub(super) mod foundation;
pub(super) mod gap;
pub(super) mod giving;
pub(super) mod held;
pub(super) mod interval;
mod lines;
pub(super) mod load;
pub(super) mod polynomial;
pub(super) mod pressing;
pub(super) mod proof;
pub(super) mod reference;
pub(super) mod span;
pub(super) mod springs;
mod steady;
pub(super) mod tension;
