//! What was proven, as a certificate in the units of the scene.

use super::error::{self, Error};
use super::inner::Inner;
use super::proof::Pair;
use super::reactions::reactions;
use super::stiffness::stiffness;
use crate::certificate::interval::Interval;
use crate::scene::{Scale, Scene};

/// Bounds that hold for the continuous beam, in the units of the scene. Infinite where nothing could be shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// At most `J*`: `D(p)` of the contact load.
    pub energy_lower: f64,
    /// At least `J*`: `J(v̂)` of an admissible deflection.
    pub energy_upper: f64,
    /// At least `J(v̂) − D(p)`, without cancellation.
    pub gap: f64,
    /// At least `max |v − v*|` over the whole beam.
    pub deflection_error: f64,
    /// Where that bound is largest.
    pub deflection_error_at: f64,
    /// At least `max |v̂ − v*|` of the admissible deflection `v̂` that was built: how well the true deflection is known, even
    /// if the one that was judged is far off.
    pub best_deflection_error: f64,
    /// The largest magnitude of the deflection that was judged, rounded up.
    pub deflection: f64,
    /// What the reactions of the two supports lie between, left and right; [`None`] where nothing could be shown.
    pub reactions: [Option<[f64; 2]>; 2],
    /// What the structural stiffness `D` lies between; see [`stiffness`]. [`None`] if the sign of `J*` is open.
    pub stiffness: Option<[f64; 2]>,
    /// True if the true deflection is known to a millionth of its largest value: the contacts of the witness are those of the
    /// beam, but for what cannot be felt. Otherwise the bounds are coarse.
    pub contacts_proven: bool,
}

/// The parts of a certificate, dimensionless.
pub(super) struct Proven<'a> {
    /// That of the witness, if there is any.
    pub(super) pair: Option<&'a Pair>,
    /// Of the deflection that is judged.
    pub(super) error: Error,
}

impl Proven<'_> {
    /// All factors are powers of two: only exponents change.
    pub(super) fn certificate(&self, inner: &Inner<'_>, scene: &Scene, scale: &Scale) -> Certificate {
        let Self { pair, ref error } = *self;
        let energy = pair.map_or(Interval::WHOLE, |pair| pair.curve.energy(&inner.load, inner.stiffness));
        let gap = pair.map_or(f64::INFINITY, |pair| pair.gap.hi());
        let lower = (Interval::exact(energy.lo()) - Interval::exact(gap)).lo();
        let energies = [lower, energy.hi()];
        let reactions = reactions(pair, inner.ground.as_ref(), inner.stiffness, inner.length);
        let reactions = reactions.map(|r| r.map(|r| [r.lo() * scale.force, r.hi() * scale.force]));
        let stiffness = stiffness(energies, scene.load(), inner.length);
        Certificate {
            energy_lower: energies[0] * scale.energy(),
            energy_upper: energies[1] * scale.energy(),
            gap: gap * scale.energy(),
            deflection_error: error.most * scale.depth,
            deflection_error_at: error.at * scale.length,
            best_deflection_error: error::of_gap(gap, inner.stiffness, inner.length) * scale.depth,
            deflection: error.size * scale.depth,
            reactions,
            stiffness: stiffness.map(|d| d.map(|d| d * (scale.force / scale.depth))),
            contacts_proven: pair.is_some_and(|pair| inner.is_sharp(pair)),
        }
    }
}
