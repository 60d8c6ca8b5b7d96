//! Uneven foundations that have a solution in closed form, each with its derivation: independent tests of [`super::solve`].
//!
//! All use one result. Beside a zone let `s` be the distance from the lift-off point, where `h = h' = h'' = 0`, under a
//! uniform load and with `u''''= 0`:
//!
//! ```text
//! EI h'''' = −q,      h = R s³ / (6 EI) − q s⁴ / (24 EI)         R the concentrated force at the lift-off point
//! ```

mod incline;
mod lifted;
mod parabola;

pub use incline::{Incline, incline};
pub use lifted::{Lifted, lifted};
pub use parabola::{FlatSolution, flat, parabola};
