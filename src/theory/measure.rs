//! What violations are measured against: the size of everything in the answer.

use super::given::Given;
use super::piece::{Piece, derivatives};

/// A violation below this is rounding: conditions are met to 12 digits of the largest deflection, force and moment.
pub(super) const TOLERANCE: f64 = 1e-12;

/// Deflections, forces and moments are measured against their largest, but at least against this part of what the loads
/// do to a free beam: `TOLERANCE · AT_REST` is the rounding of an addition.
const AT_REST: f64 = 1e-3;

/// What violations are measured against.
pub(super) struct Scale {
    /// Largest deflection.
    deflection: f64,
    /// Largest deflection, or the rounding of the profile if that is larger, beside the left and the right support, where the profile may be known far better than elsewhere.
    pub(super) beside: [f64; 2],
    /// Largest of all forces.
    pub(super) force: f64,
    /// Largest curvature: a moment over `EI`.
    pub(super) moment: f64,
}

impl Scale {
    /// Largest deflection, largest of all forces, and the moment that goes with them.
    pub(super) fn of(given: &Given, pieces: &[Piece], forces: &[f64], shear: &[f64; 2]) -> Self {
        let mut taylor = vec![0.0; given.terms];
        let (mut depth, mut moment) = (0.0_f64, 0.0_f64);
        for piece in pieces {
            piece.deflection(given, &mut taylor);
            for t in [0.0, 0.5 * (piece.lo + piece.hi) - piece.anchor] {
                let [v, _, v2, _] = derivatives(&taylor, t);
                depth = depth.max(v.abs());
                moment = moment.max(v2.abs());
            }
        }
        let force = forces.iter().chain(shear).fold(0.0_f64, |most, f| most.max(f.abs()));
        // A beam at rest has nothing but rounding: of what its loads could do to it, and of the profile.
        let (l, load) = (given.length, AT_REST * given.total_load);
        let deflection = depth.max(load * l * l * l / 384.0);
        Self {
            deflection,
            beside: given.supports.map(|depths| deflection.max(AT_REST * depths.size)),
            force: force.max(moment / l).max(load),
            moment: moment.max(load * l / 8.0),
        }
    }

    /// Largest deflection, and the rounding of the profile at a place: near a support a polynomial is known far better than
    /// where its highest powers have grown.
    pub(super) fn depth_at(&self, given: &Given, x: f64) -> f64 {
        self.deflection.max(AT_REST * given.magnitude_at(x))
    }
}
