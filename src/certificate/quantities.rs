//! Other quantities than the deflection from a proven pair: the energy, and the paper's structural stiffness.

use super::kernel::contact_node::EnclosedScene;
use super::kernel::interval::Interval;
use super::kernel::polynomial::Polynomial;
use super::kernel::proof::Piece;
use crate::scene::{Concentrated, Load};

/// `J(v) = ½∫EI v''² dx + ½∫N v'² dx − ∫q v dx − Σ P v − Σ C v'` of a deflection, (17) with point loads and couples. Pieces must end
/// where the load changes.
pub(super) fn energy(pieces: &[Piece], enclosed: &EnclosedScene<'_>) -> Interval {
    let load = enclosed.load;
    let mut sum = Interval::ZERO;
    for Piece { from, to, v, .. } in pieces {
        let width = Interval::exact(*to) - Interval::exact(*from);
        let bent = v.derivative().derivative();
        let bending = bent.integral_of_product(&bent, width).not_negative()
            * Interval::exact(0.5 * enclosed.stiffness_between([*from, *to]));
        let turned = v.derivative();
        let pulled =
            || turned.integral_of_product(&turned, width).not_negative() * Interval::exact(0.5 * enclosed.tension);
        let bending = if enclosed.tension == 0.0 { bending } else { bending + pulled() };
        let done = Polynomial::new(&load.line(*from, [*from, *to])).integral_of_product(v, width)
            + load.point(*from) * v.at(Interval::ZERO)
            + load.couple(*from) * v.derivative().at(Interval::ZERO);
        sum = sum + bending - done;
    }
    // No piece begins at the right end.
    if let Some(Piece { from, to, v, .. }) = pieces.last() {
        let width = Interval::length(*from, *to);
        sum = sum - load.point(*to) * v.at(width) - load.couple(*to) * v.derivative().at(width);
    }
    sum
}

/// Bounds of the structural stiffness from bounds of the energy and the load with its resultant `Q`.
///
/// The paper does not define `D`. A linear structure whose load displaces it by `w`, the mean deflection under the load, has
/// `J* = −½ Q w` and the stiffness `D = Q / w`; hence
///
/// ```text
/// D = Q² / (−2 J*),      Q² / (−2 energy_lower) ≤ D ≤ Q² / (−2 energy_upper)
/// ```
///
/// For a beam in contact, this is the stiffness of the linear structure with the same energy. The complementary energy gives the lower
/// bound and the potential energy the upper one.
#[must_use]
pub fn stiffness([lower, upper]: [f64; 2], load: &Load, length: f64) -> Option<[f64; 2]> {
    if !(lower.is_finite() && upper < 0.0) {
        return None;
    }
    let square = resultant(load, length).square();
    let half = |energy: f64| square / (Interval::exact(-2.0) * Interval::exact(energy));
    Some([half(lower).lo().max(0.0), half(upper).hi()])
}

/// `Q`; parts of a load may cancel.
pub(super) fn resultant(load: &Load, length: f64) -> Interval {
    let exact = Interval::exact;
    let linear =
        load.linear().iter().map(|q| exact(0.5) * (exact(q.start) + exact(q.end)) * (exact(q.to) - exact(q.from)));
    let concentrated = load.concentrated().map(|Concentrated { at: _, force, couple: _ }| exact(force));
    linear.chain(concentrated).fold(exact(load.uniform()) * exact(length), |sum, part| sum + part)
}

/// `∫ q (x − c)` with all couples, the moment of a load about a position.
pub(super) fn moment(load: &Load, length: f64, about: f64) -> Interval {
    let exact = Interval::exact;
    let (lever, l) = (|x: f64| exact(x) - exact(about), exact(length));
    let linear = load.linear().iter().map(|q| {
        let (width, start, end) = (exact(q.to) - exact(q.from), exact(q.start), exact(q.end));
        exact(0.5) * (start + end) * width * lever(q.from) + (start + end + end) * width * width / exact(6.0)
    });
    let concentrated = load.concentrated().map(|Concentrated { at, force, couple }| match couple {
        0.0 => exact(force) * lever(at),
        couple => exact(force) * lever(at) + exact(couple),
    });
    linear.chain(concentrated).fold(exact(load.uniform()) * l * (exact(0.5) * l - exact(about)), |sum, part| sum + part)
}
