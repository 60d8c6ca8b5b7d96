//! The extremes: every route is right there, or says that it is not; judged by authorities that solve nothing.

mod beam_theory;
mod routes;
mod scaling;

use palkki_evidence::extremes::{Extreme, POWERS, borders, deep, sizes, supports, units};

/// Every extreme, whatever is extreme about it.
fn all() -> Vec<Extreme> {
    let mut all = sizes().expect("well-posed scenes");
    all.extend(borders().expect("well-posed scenes"));
    all.extend(units().expect("well-posed scenes").into_iter().map(|(_, extreme)| extreme));
    all.extend(supports().expect("well-posed scenes"));
    all.extend(POWERS.map(|power| deep(power).expect("a depth in range")));
    all
}
