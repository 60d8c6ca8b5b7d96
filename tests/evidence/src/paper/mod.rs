//! The paper, reproduced: its example, its figures, its claims. One figure or claim, one file: scene, numbers, verdict.

pub mod approach;
pub mod claims;
pub mod convergence;
mod example;
mod figures;
pub mod uneven;

pub use example::{
    INTERVALS, PRINTED_FORCE, PRINTED_REACTION, PRINTED_USEFUL_INTERVALS, beam, example, scene_over, theory,
};
pub use figures::{Deflections, Pressures, figure_4, figure_7, figure_8};
