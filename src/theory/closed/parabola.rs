//! A parabolic dish or crest under a uniform load.

use crate::state::Regime;

/// Beam theory for a parabolic foundation; made by [`parabola`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parabola {
    /// Which regime.
    pub regime: Regime,
    /// Length that is lifted off at each end; half of the beam with contact at mid-span, [`None`] without contact \[length\].
    pub lift_off: Option<f64>,
    /// Reaction of each support \[force\].
    pub reaction: f64,
    /// Resultant of the contact \[force\].
    pub contact_force: f64,
    /// Concentrated force at each lift-off point of a zone, zero without one \[force\].
    pub end_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// A beam above `u = depth + 4 rise x (l − x)/l²`, `depth` ≥ 0: a dish for `rise` > 0, a crest for `rise` < 0, under a
/// uniform `load` ≥ 0.
///
/// The foundation has the curvature `w = u'' = −8 rise/l²`. A zone is pressed with `q`, since `u'''' = 0`; at the support
/// `v'' = 0`, so `h'' = w` there:
///
/// ```text
/// R a/EI − q a²/(2 EI) = w,     R a³/(6 EI) − q a⁴/(24 EI) = depth
/// R = q a/2 + EI w/a,     q a⁴/(24 EI) + w a²/6 = depth,     T = q a − R = q a/2 − EI w/a
/// ```
///
/// a quadratic equation for `a²`; a dish that starts at the supports (`depth` = 0) has `a² = −4 EI w/q`. For `a > l/2` the
/// beam touches at mid-span only, with `F = 48 EI/l³ (5 q l⁴/(384 EI) − depth − rise)`, or not at all.
#[must_use]
pub fn parabola(length: f64, bending_stiffness: f64, depth: f64, rise: f64, load: f64) -> Parabola {
    let (l, ei, d, q) = (length, bending_stiffness, depth, load);
    let w = -8.0 * rise / (l * l);
    let free_energy = -q * q * l * l * l * l * l / (240.0 * ei);
    let force = 48.0 * ei / (l * l * l) * (5.0 * q * l * l * l * l / (384.0 * ei) - d - rise);
    if force <= 0.0 {
        return Parabola {
            regime: Regime::None,
            lift_off: None,
            reaction: 0.5 * q * l,
            contact_force: 0.0,
            end_force: 0.0,
            energy: free_energy,
        };
    }
    let root = (w * w / 36.0 + q * d / (6.0 * ei)).sqrt();
    // The positive root a², in the form that does not cancel.
    let square = if 0.0 < w { 2.0 * d / (w / 6.0 + root) } else { 12.0 * ei / q * (root - w / 6.0) };
    let a = square.sqrt();
    // A crest that starts at the supports would clamp the beam there.
    if 0.0 < a && a <= 0.5 * l {
        let r = 0.5 * q * a + ei * w / a;
        let t = 0.5 * q * a - ei * w / a;
        // ∫ v''², with v'' = w − R s/EI + q s²/(2 EI), and ∫ h over one end.
        let bent = w * w * a - w * (r * a * a - q * a * a * a / 3.0) / ei
            + (r * r * a * a * a / 3.0 - r * q * a * a * a * a / 4.0 + q * q * a * a * a * a * a / 20.0) / (ei * ei);
        let gap = (r * a * a * a * a / 24.0 - q * a * a * a * a * a / 120.0) / ei;
        return Parabola {
            regime: Regime::Zone,
            lift_off: Some(a),
            reaction: t,
            contact_force: q * l - 2.0 * t,
            end_force: r,
            energy: ei * (bent + 0.5 * w * w * (l - 2.0 * a)) - q * l * (d + 2.0 * rise / 3.0) + 2.0 * q * gap,
        };
    }
    Parabola {
        regime: Regime::Points,
        lift_off: Some(0.5 * l),
        reaction: 0.5 * (q * l - force),
        contact_force: force,
        end_force: 0.0,
        energy: free_energy + force * force * l * l * l / (96.0 * ei),
    }
}
