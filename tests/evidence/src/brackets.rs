//! Whether the numbers of an answer lie between what is proven of them, as they are printed and as near as beam theory is computed.

use palkki::certificate::Certificate;
use palkki::scene::{Scene, Support};
use palkki::state::ContactState;

use crate::hostile::laws::THEORY;

/// Half a unit in the last digit of a table, as a share of the number: where it is zero, so is what is printed.
const PRINTED: f64 = 5e-6;
/// What rounding makes of a sum of forces, as a share of the largest that bends the beam.
const ROUNDING: f64 = 1e-12;

/// The numbers of an answer that do not lie in their brackets, in words. The greatest deflection of a beam that may turn has none.
#[must_use]
pub fn outside(scene: &Scene, state: &ContactState, certificate: &Certificate) -> Vec<String> {
    let (length, contact) = (scene.beam().length(), state.contact_force());
    // A load that stands on a support that holds is exact, and hides nothing but the last digits of the sum there.
    let held: &[Support] = if scene.beam().is_held() { scene.beam().supports() } else { &[] };
    let same = |a: f64, b: f64| a <= b && b <= a;
    let standing = || scene.load().point().iter().filter(|p| held.iter().any(|support| same(support.at, p.at)));
    let on = |at: f64| standing().filter(|p| same(at, p.at)).map(|p| p.force).sum::<f64>();
    let loads = scene.load().magnitude(length) - standing().map(|p| p.force.abs()).sum::<f64>();
    let forces = state.supports.iter().map(|support| (support.force - on(support.at)).abs());
    let largest = forces.fold(loads.max(contact), f64::max);
    let forces = state.supports.iter().zip(&certificate.reactions);
    let forces = forces.map(|(support, bracket)| (format!("the force at {}", support.at), support.force, *bracket));
    let forces = forces.chain([("the contact force".to_owned(), contact, certificate.contact_force)]);
    let forces = forces.map(|number| (number, largest, THEORY));
    let moments = [state.moment.max, state.moment.min].into_iter().zip(certificate.moments);
    let moments = moments.map(|(value, bracket)| (("a moment".to_owned(), value, bracket), largest * length, THEORY));
    let deflection = ("the greatest deflection".to_owned(), state.deflection.max, certificate.deflection_max);
    let all = forces.chain(moments).chain([(deflection, state.deflection.magnitude(), PRINTED)]);
    let is_outside = |((what, value, bracket), size, share): ((String, f64, Option<[f64; 2]>), f64, f64)| {
        let [least, most] = bracket?;
        let off = (least - value).max(value - most);
        // True also of what is no number.
        let last_digits = 4.0 * f64::EPSILON * value.abs();
        let is_inside = off <= (PRINTED * value.abs()).min(share * size) + ROUNDING * size + last_digits;
        (!is_inside).then(|| format!("{what} is {value:e} and not in [{least:e}, {most:e}]"))
    };
    all.filter_map(is_outside).collect()
}
