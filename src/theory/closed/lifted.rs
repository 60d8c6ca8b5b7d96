//! A flat foundation from which a force at mid-span lifts the beam: two zones and a gap between them.

use super::flat;

/// Beam theory for a beam that is lifted off a flat foundation at mid-span; made by [`lifted`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lifted {
    /// The two zones, `[from, to]` \[length\].
    pub zones: [[f64; 2]; 2],
    /// Reaction of each support, and the equal concentrated force at the outer end of each zone \[force\].
    pub reaction: f64,
    /// Concentrated force at the inner end of each zone \[force\].
    pub inner_force: f64,
    /// Resultant of each zone \[force\].
    pub zone_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// A beam above a flat foundation at `depth` > 0 under a uniform `load` > 0 and a `lift` > 0 upwards at mid-span.
/// [`None`] unless it rests on two zones.
///
/// The outer ends are those of [`flat()`]. Over the gap of length `g` the beam is clamped at both ends (`h = h' = 0`), and
/// its clamping moments vanish as well (`h'' = 0`):
///
/// ```text
/// lift g/8 − q g²/12 = 0:     g = 3 lift/(2 q),     inner force = (q g − lift)/2 = lift/4
/// J = J_flat + lift u₀ − ½ (lift h_middle − q ∫h),     h_middle = lift g³/192 EI − q g⁴/384 EI,  ∫h = lift g⁴/384 EI − q g⁵/720 EI
/// ```
#[must_use]
pub fn lifted(length: f64, bending_stiffness: f64, depth: f64, load: f64, lift: f64) -> Option<Lifted> {
    let (l, ei, q, p) = (length, bending_stiffness, load, lift);
    let flat = flat(length, bending_stiffness, depth, load);
    let a = flat.lift_off?;
    let g = 1.5 * p / q;
    let (inner, outer) = (0.5 * (l - g), 0.5 * (l + g));
    if inner <= a {
        return None;
    }
    let middle = (p * g * g * g / 192.0 - q * g * g * g * g / 384.0) / ei;
    let area = (p * g * g * g * g / 384.0 - q * g * g * g * g * g / 720.0) / ei;
    Some(Lifted {
        zones: [[a, inner], [outer, l - a]],
        reaction: flat.reaction,
        inner_force: 0.25 * p,
        zone_force: flat.reaction + q * (inner - a) + 0.25 * p,
        energy: flat.energy + p * depth - 0.5 * (p * middle - q * area),
    })
}
