//! An inclined plane under a uniform load.

/// Beam theory for an inclined foundation; made by [`incline`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Incline {
    /// Lengths that are lifted off at the left and the right end \[length\].
    pub lift_off: [f64; 2],
    /// Reactions, and the equal concentrated forces at the lift-off points \[force\].
    pub reactions: [f64; 2],
    /// Resultant of the contact \[force\].
    pub contact_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// A beam that rests with a zone on the plane through `depths` ≥ 0 below its two supports, under a uniform `load` > 0.
/// [`None`] if the plane is so deep that there is no zone.
///
/// A plane has `u'' = 0`, so at the support `h'' = 0` and `h = u` there:
///
/// ```text
/// R = q a / 2,     a⁴ = 24 EI u_end / q,     T = q a − R = q a / 2         at each end by itself
/// J = Σ (½∫ EI h''² + ∫ q h) − ∫ q u = Σ q² a⁵ / (60 EI) − q l (u_left + u_right) / 2
/// ```
#[must_use]
pub fn incline(length: f64, bending_stiffness: f64, depths: [f64; 2], load: f64) -> Option<Incline> {
    let (l, ei, q) = (length, bending_stiffness, load);
    let lift_off = depths.map(|u| (24.0 * ei * u / q).sqrt().sqrt());
    let reactions = lift_off.map(|a| 0.5 * q * a);
    let bent: f64 = lift_off.iter().map(|a| q * q * a * a * a * a * a / (60.0 * ei)).sum();
    (lift_off[0] + lift_off[1] <= l).then(|| Incline {
        lift_off,
        reactions,
        contact_force: q * l - reactions[0] - reactions[1],
        energy: bent - 0.5 * q * l * (depths[0] + depths[1]),
    })
}
