//! Units: one scene in metres and microns, newtons and meganewtons, and near the ends of the range of `f64`.

use super::{Extreme, Known, in_units};
use crate::closed::flat;
use crate::draft::{Draft, Units};
use crate::paper::{LENGTH as L, STIFFNESS as EI};
use palkki::scene::{Foundation, SceneError};

/// Units that are tried; those of the last four are powers of two.
const ALL: [(&str, Units); 16] = [
    of("metres and kilonewtons", 1.0, 1.0, 1.0),
    of("millimetres", 1e3, 1e3, 1.0),
    of("microns", 1e6, 1e6, 1.0),
    of("newtons", 1.0, 1.0, 1e3),
    of("meganewtons", 1.0, 1.0, 1e-3),
    of("millimetres and newtons", 1e3, 1e3, 1e3),
    of("lengths × 1e150", 1e150, 1e150, 1.0),
    of("lengths × 1e-150", 1e-150, 1e-150, 1.0),
    of("forces × 1e150", 1.0, 1.0, 1e150),
    of("forces × 1e-150", 1.0, 1.0, 1e-150),
    of("depths × 1e150", 1.0, 1e150, 1.0),
    of("depths × 1e-150", 1.0, 1e-150, 1.0),
    of("lengths × 2³⁰⁰", P300, P300, 1.0),
    of("depths × 2⁻³⁰⁰", 1.0, 1.0 / P300, 1.0),
    of("forces × 2³⁰⁰", 1.0, 1.0, P300),
    of("lengths × 2¹⁰, depths × 2⁻³, forces × 2¹⁶", 1024.0, 0.125, 65536.0),
];

/// 2³⁰⁰.
const P300: f64 = {
    let p100 = (1_u128 << 100) as f64;
    p100 * p100 * p100
};

/// Units of length, depth and force, and what they are called.
pub(super) const fn of(name: &str, length: f64, depth: f64, force: f64) -> (&str, Units) {
    (name, Units { length, depth, force })
}

/// The example of the paper, and a ridge, in all units. The first of each is in the units of the paper.
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene leaves the range of `f64`.
pub fn units() -> Result<Vec<(Units, Extreme)>, SceneError> {
    let force = 48.0 * EI / (L * L * L) * 60.0;
    let energy = -L * L * L * L * L / (240.0 * EI) + force * force * L * L * L / (96.0 * EI);
    let ridge = Known::symmetric(0.5 * (L - force), force, energy);
    let mut found = Vec::new();
    for (what, depths, known) in
        [("the example", [1.0; 3], Known::from(flat(L, EI, 1.0, 1.0))), ("a ridge", [400.0, 40.0, 400.0], ridge)]
    {
        let points = [0.0, 5.0, 10.0].into_iter().zip(depths).map(|(x, u)| [x, u]).collect();
        let draft = Draft::over(Foundation::Polyline { points });
        for (name, units) in ALL {
            found.push((units, in_units(format!("{what}, {name}"), "scaling", &draft, known, units)?));
        }
    }
    Ok(found)
}
