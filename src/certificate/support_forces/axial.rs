//! The effect of an axial force on the uncertainty of vertical forces.

use crate::certificate::kernel::contact_node::EnclosedScene;
use crate::certificate::kernel::distance;
use crate::certificate::kernel::interval::Interval;
use crate::certificate::kernel::polynomial::number;
use crate::certificate::kernel::proof::Pair;

/// A bound of the error of `∫ N w' φ' dx`, with `w = v̂ − v*`. Under tension `N ∫ w'² ≤ 2 gap` and `∫ φ'² = 6/5w` on each side; under
/// compression `∫ |φ''| = 3/w`.
pub(super) fn pulled(enclosed: &EnclosedScene<'_>, pair: &Pair, widths: impl Iterator<Item = Interval>) -> Interval {
    let sides = widths.fold(Interval::ZERO, |sum, width| sum + number(1) / width);
    let force = Interval::exact(enclosed.tension.abs());
    if 0.0 < enclosed.tension {
        return (number(12) * Interval::exact(pair.gap) * force * sides / number(5)).sqrt();
    }
    number(3) * force * sides * Interval::exact(distance::anywhere(pair, enclosed.stiffness, enclosed.length))
}

/// An upper bound of `κ²` for a beam under an axial force. The vertical forces differ by `κ = m' + N w'`, `w = v̂ − v*`, up to the
/// distance `c`. The moments of the pair are in equilibrium with the loads and `N v̂''`, so they differ by `ρ` from `−EI v̂''`. With
/// `φ = 6 s (c − s)/c³`
///
/// ```text
/// κ = ∫ κ φ dx = −∫ m φ' dx + ∫ N w' φ dx,    ‖m‖ ≤ ρ + ‖w‖ ≤ 2 √(2 gap)
/// |κ| ≤ √(2 gap) (2 √(12 EI/c³) + √(6 N/5 c)),      under compression with max |w| (∫ |φ'| dx = 3/c) in the last term: 3 |N| max |w|/c
/// ```
pub(super) fn under_axial_force(enclosed: &EnclosedScene<'_>, pair: &Pair, c: Interval) -> Interval {
    let root = (number(2) * Interval::exact(pair.gap)).sqrt();
    let bent = number(2) * root * (number(12) * Interval::exact(enclosed.stiffest) / (c * c * c)).sqrt();
    (bent + pulled(enclosed, pair, std::iter::once(c))).square()
}
