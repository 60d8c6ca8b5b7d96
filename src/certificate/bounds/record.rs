//! What was proven, as a certificate in the units of the scene.

use super::contact_node::EnclosedScene;
use super::curve::Piece;
use super::distance::{self, Error};
use super::proof::Pair;
use super::reactions::reactions;
use super::stiffness::stiffness;
use crate::certificate::interval::Interval;
use crate::scene::{Load, Scale};

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

/// Whether a pair bounds the deflection to a millionth of its largest value.
pub(super) fn is_sharp(enclosed: &EnclosedScene<'_>, pair: &Pair) -> bool {
    const SHARP: f64 = 1e-6;
    let width = |p: &Piece| Interval::exact(p.to) - Interval::exact(p.from);
    let size = pair.curve.pieces.iter().fold(0.0, |most: f64, p| most.max(p.v.range(width(p)).magnitude()));
    distance::of_gap(pair.gap.hi(), enclosed.stiffness, enclosed.length) <= SHARP * size
}

impl Certificate {
    /// Nothing could be shown.
    pub(super) const UNKNOWN: Self = Self {
        energy_lower: f64::NEG_INFINITY,
        energy_upper: f64::INFINITY,
        gap: f64::INFINITY,
        deflection_error: f64::INFINITY,
        deflection_error_at: 0.0,
        best_deflection_error: f64::INFINITY,
        deflection: f64::INFINITY,
        reactions: [None, None],
        stiffness: None,
        contacts_proven: false,
    };

    /// From what was proven, dimensionless. All factors are powers of two: only exponents change.
    pub(super) fn new(enclosed: &EnclosedScene<'_>, load: &Load, scale: &Scale, pair: &Pair, error: Error) -> Self {
        let energy = pair.curve.energy(enclosed.load, enclosed.stiffness);
        let gap = pair.gap.hi();
        let energies = [(Interval::exact(energy.lo()) - Interval::exact(gap)).lo(), energy.hi()];
        let stiffness = stiffness(energies, load, enclosed.length);
        let force = |r: Interval| [r.lo() * scale.force, r.hi() * scale.force];
        Self {
            energy_lower: energies[0] * scale.energy(),
            energy_upper: energies[1] * scale.energy(),
            gap: gap * scale.energy(),
            deflection_error: error.most * scale.depth,
            deflection_error_at: error.at * scale.length,
            best_deflection_error: distance::of_gap(gap, enclosed.stiffness, enclosed.length) * scale.depth,
            deflection: error.size * scale.depth,
            reactions: reactions(enclosed, pair).map(|bracket| bracket.map(force)),
            stiffness: stiffness.map(|d| d.map(|d| d * (scale.force / scale.depth))),
            contacts_proven: is_sharp(enclosed, pair),
        }
    }
}
