//! A simple beam on a rigid uneven foundation: a verification-first reference implementation of M. Heinisuo,
//! "Yksinkertainen palkki jäykällä epätasaisella alustalla", *Rakenteiden Mekaniikka* 17 (1984) 1, pp. 1–16.
//!
//! ```text
//! equilibrium        p = q − EI v''''                              (5)
//! clearance          h = u − v                                     (6)
//! contact            p ≥ 0,  h ≥ 0,  p h = 0    on 0 ≤ x ≤ l       (4), (7)
//! simple supports    v(0) = v(l) = 0,  v''(0) = v''(l) = 0         (8)
//! ```
//!
//! `v''''` is a measure: where the beam lifts off, the contact pressure contains a concentrated force.
//!
//! # Solving a scene
//!
//! ```
//! use palkki::route::{Method, Solver, Status};
//! use palkki::scene::{Beam, Foundation, Load, Scene};
//! use palkki::{Settings, solve_exactly, solve};
//!
//! // The example of the paper. Without a foundation the beam would sag a hundred times as far as the foundation is below it.
//! let beam = Beam::new(10.0, 500.0 / 384.0)?;
//! let load = Load::uniform_on(&beam, 1.0)?;
//! let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 }))?;
//!
//! // Grid-free solution by beam theory: the lift-off positions are unknowns.
//! let exact = solve_exactly(&scene)?;
//! assert_eq!(exact.verdict.status, Status::Certified);
//!
//! // A method of the paper with a solver, on 300 equal intervals, and the bound on its error.
//! let solution = solve(&scene, &Settings::new(Method::Force, Solver::ActiveSet, 300))?;
//! let error = solution.state.deflection.max - exact.state.deflection.max;
//! assert!(solution.verdict.certificate.is_some_and(|bounds| error.abs() <= bounds.deflection_error));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | task | item |
//! |---|---|
//! | read a scene file | [`scene::file::parse`] |
//! | solve by beam theory; solve with a method and a solver on a grid | [`solve_exactly`], [`solve()`] |
//! | request an accuracy and let the program choose the grid | [`adaptive::adapt`] |
//! | bound the error of contact forces from another program | [`certificate::certify`], [`verdict::Verdict::of_forces`] |
//! | solve any elastic body, and bound the error of any answer for it | [`body::Body`], [`body::proof::prove`] |
//! | draw figures | `plot::curves`, with the feature `plot` |
//! | write a proof that others can check | `proof::prove`, with the feature `proof` |
//!
//! # Features
//!
//! | feature | what it adds |
//! |---|---|
//! | none | the grid-free solution, the three methods, our own solvers, the certificate, scene files: pure Rust |
//! | `clarabel` | the interior-point solver |
//! | `osqp` | the operator-splitting solver, a C library whose build needs cmake |
//! | `plot` | figures as SVG |
//! | `proof` | proofs of answers in rational arithmetic |
//! | `serde` | `Serialize` for answers |
//! | `cli` | the program |
//!
//! # Notation
//!
//! | paper | name here | unit | sign and meaning | equation |
//! |---|---|---|---|---|
//! | `x`, `l` | `x`, `length` | length | position, from 0 at the left end of the beam to `l` at the right end | (4) |
//! | `EI` | `bending_stiffness` | force · length² | constant along the beam in the paper; here it may vary in steps | (5) |
//! | `q` | `load` | force / length | downwards; nodal loads are forces `q_i = q₀Δ` | (5), (27) |
//! | `u` | `depth` | length | of the foundation, downwards from the straight beam on supports at level 0 | (6) |
//! | | `gap` | length | `g = u − w0`, with the initial shape `w0` of the beam; `g = u` for a straight beam | |
//! | `v` | `deflection` | length | downwards, from the unloaded beam | (5), (17) |
//! | `h` | `clearance` | length | `g − v`, the paper's `u − v`; not negative | (6) |
//! | `p` | `contact_force`, `pressure` | force, force / length | of the foundation on the beam, upwards | (5) |
//! | `T` | `reaction`, `force_from`, `force_to` | force | upwards, at supports and ends of contact zones; equal on a flat foundation | |
//! | | `moment` | force · length | `M = −EI v''`, positive with the underside in tension | |
//! | `J` | `energy` | force · length | `½∫EI v''² dx − ∫q v dx` | (17) |
//! | `A`, `b`, `g` | `matrix`, `linear`, `gradient` | | of the quadratic program of each method; elsewhere `g` is the gap | (32), (33) |
//! | `K`, `C` | `Displacement`, `Force` | force / length, length / force | condensed stiffness, flexibility; `K C = I` | (20), (26) |
//! | `n`, `Δ` | `interior`, `spacing` | 1, length | interior nodes; `Δ = l / (n + 1)` | (26) |
//!
//! # Modules
//!
//! [`solve()`] passes a [`scene`] through [`methods`], [`qp`], [`solvers`] and [`methods`] again to obtain a [`state`].
//! [`solve_exactly`] uses [`theory`] instead. Both then call [`certificate`] and [`verdict`]. For an elastic [`body`], [`qp`] and
//! [`solvers`] use its matrix; the body has its own proof, from which the verdict follows. ARCHITECTURE.md contains the map. The
//! claims and figures of the paper, fault injection and scenes with known answers are in the package `palkki-evidence`.

#![warn(clippy::disallowed_methods)]

mod answer;
pub mod body;
pub mod certificate;
mod grid;
#[cfg(feature = "plot")]
pub mod plot;
#[cfg(feature = "proof")]
pub mod proof;
pub mod scene;
mod shared;
mod study;
pub mod theory;
pub mod verdict;

pub use answer::solve::{DEFAULT_TOLERANCE, Settings, left_out, solve, solve_exactly, solve_raw, solve_raw_near};
pub use answer::{route, state};
pub use grid::{adaptive, methods, qp, solvers};
pub use route::Solution;
pub use shared::text;
pub use study::{explain, sweep, tolerance};
pub use verdict::witness::Witness;

use grid::multigrid;
use shared::{double, memory};
use verdict::witness;
