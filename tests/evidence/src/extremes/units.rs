//! Units: one scene in metres and microns, newtons and meganewtons, and near the ends of the range of `f64`.

use super::{Extreme, Parts, Truth, extreme};
use palkki::scene::{Foundation, SceneError};
use palkki::theory::flat;

/// Units of length, depth and force, in units of the original.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// What they are called.
    pub name: &'static str,
    /// Unit along the beam.
    pub length: f64,
    /// Unit of depth.
    pub depth: f64,
    /// Unit of force.
    pub force: f64,
}

/// Units that are tried; those of the last four are powers of two.
const ALL: [Factors; 16] = [
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

pub(super) const fn of(name: &'static str, length: f64, depth: f64, force: f64) -> Factors {
    Factors { name, length, depth, force }
}

impl Factors {
    /// Whether all of them are powers of two, so that no digit of the data is rounded.
    #[must_use]
    pub fn exact(&self) -> bool {
        const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
        [self.length, self.depth, self.force].iter().all(|f| f.to_bits() & MANTISSA == 0)
    }
}

/// The example of the paper, and a ridge, in all units. The first of each is in the units of the paper.
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene leaves the range of `f64`.
pub fn units() -> Result<Vec<(Factors, Extreme)>, SceneError> {
    let (l, ei) = (10.0, 500.0 / 384.0);
    let force = 48.0 * ei / (l * l * l) * 60.0;
    let energy = -l * l * l * l * l / (240.0 * ei) + force * force * l * l * l / (96.0 * ei);
    let ridge = Truth::symmetric(0.5 * (l - force), force, energy);
    let mut found = Vec::new();
    for (what, depths, truth) in
        [("the example", [1.0; 3], Truth::from(flat(l, ei, 1.0, 1.0))), ("a ridge", [400.0, 40.0, 400.0], ridge)]
    {
        for factors in ALL {
            let Factors { name, length, depth, force } = factors;
            let points = [0.0, 5.0, 10.0].iter().zip(depths).map(|(x, u)| [x * length, u * depth]);
            let foundation = Foundation::Polyline { points: points.collect() };
            let parts = Parts {
                length: l * length,
                // EI has the unit force · length³ / depth; the ratio first, which stays in range.
                stiffness: ei * (length / depth) * force * length * length,
                uniform: force / length,
                foundation: Some(foundation.clone()),
                ..Parts::over(foundation)
            };
            let scaled = Truth {
                reactions: truth.reactions.map(|r| r * force),
                contact_force: truth.contact_force * force,
                energy: truth.energy.map(|j| j * force * depth),
            };
            found.push((factors, extreme(format!("{what}, {name}"), "scaling", &parts, scaled)?));
        }
    }
    Ok(found)
}
