//! The paper's structural stiffness.

use crate::certificate::interval::Interval;
use crate::scene::Load;

/// The structural stiffness from bounds on the energy, and the load with its resultant `Q`.
///
/// The paper does not define `D`. A linear structure that its load pushes down by `w`, taken as the mean deflection under
/// the load, has `J* = −½ Q w` and the stiffness `D = Q / w`; hence
///
/// ```text
/// D = Q² / (−2 J*),      Q² / (−2 energy_lower) ≤ D ≤ Q² / (−2 energy_upper)
/// ```
///
/// For a beam that touches, this is the stiffness of the linear structure that takes up the same energy. The
/// complementary energy gives the lower bound and the potential energy the upper one.
#[must_use]
pub fn stiffness([lower, upper]: [f64; 2], load: &Load, length: f64) -> Option<[f64; 2]> {
    if !(lower.is_finite() && upper < 0.0) {
        return None;
    }
    let square = resultant(load, length).square();
    let half = |energy: f64| square / (Interval::exact(-2.0) * Interval::exact(energy));
    Some([half(lower).lo().max(0.0), half(upper).hi()])
}

/// `Q`, in which parts of a load may cancel.
fn resultant(load: &Load, length: f64) -> Interval {
    let exact = Interval::exact;
    let linear =
        load.linear().iter().map(|q| exact(0.5) * (exact(q.start) + exact(q.end)) * (exact(q.to) - exact(q.from)));
    let point = load.point().iter().map(|p| exact(p.force));
    linear.chain(point).fold(exact(load.uniform()) * exact(length), |sum, part| sum + part)
}
