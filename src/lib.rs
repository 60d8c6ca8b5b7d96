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
//! # Notation
//!
//! | paper | name here | unit | sign and meaning | equation |
//! |---|---|---|---|---|
//! | `x`, `l` | `x`, `length` | length | from the left support, at 0, to the right one | (4) |
//! | `EI` | `bending_stiffness` | force · length² | constant along the beam | (5) |
//! | `q` | `load` | force / length | downwards; nodal loads are forces `q_i = q₀Δ` | (5), (27) |
//! | `u` | `depth` | length | of the foundation below the line of the supports, downwards | (6) |
//! | `v` | `deflection` | length | downwards | (5), (17) |
//! | `h` | `clearance` | length | `u − v`, not negative | (6) |
//! | `p` | `contact_force`, `pressure` | force, force / length | of the foundation on the beam, upwards | (5) |
//! | `T` | `reaction`, `force_from`, `force_to` | force | upwards; at a lift-off point of a flat foundation both are equal | |
//! | | `moment` | force · length | `M = −EI v''`, positive with the underside in tension | |
//! | `J` | `energy` | force · length | `½∫EI v''² dx − ∫q v dx` | (17) |
//! | `A`, `b`, `g` | `matrix`, `linear`, `gradient` | | of the programme that every method becomes | (32), (33) |
//! | `K`, `C` | `Displacement`, `Force` | force / length, length / force | condensed stiffness, flexibility; `K C = I` | (20), (26) |
//! | `n`, `Δ` | `interior`, `spacing` | 1, length | interior nodes; `Δ = l / (n + 1)` | (26) |
//!
//! # Map of rooms
//!
//! ```text
//! scene ──► methods ──► problem (32) ──► solvers ──► methods ──► state ──► certificate
//!   │                                                              ▲
//!   └──────────────────────────► theory ───────────────────────────┘
//! ```

pub mod certificate;
pub mod dial;
pub mod extremes;
pub mod methods;
mod nested;
pub mod paper;
pub mod plot;
pub mod problem;
pub mod route;
pub mod scene;
mod solve;
pub mod solvers;
pub mod state;
pub mod theory;
pub mod trial;
pub mod verdict;
pub mod verification;

pub use solve::{DEFAULT_TOLERANCE, Settings, solve};
