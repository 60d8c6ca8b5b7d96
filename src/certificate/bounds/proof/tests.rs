//! The gap of a pair against its own two energies, which are computed apart.

use super::*;
use crate::certificate::bounds::ground::Ground;
use crate::scene::{Beam, Foundation, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
const DEPTH: f64 = 0.4;
/// Both energies are sums of some dozens of roundings, and the gap is what is left of them.
const ROUNDING: f64 = 1e-12;

/// Lift-off points at the distances `a` and `b` from the supports, where the moments vanish: the contact load is `q` between
/// them and a force `q a/2`, `q b/2` at each, and
///
/// ```text
/// D(p) = −q² (a⁵ + b⁵)/240 EI − u q (l − (a + b)/2)
/// ```
#[test]
fn the_gap_is_the_difference_of_the_two_energies() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let flat = Foundation::Flat { depth: DEPTH };
    let scene = Scene::new(beam, load, Some(flat.clone())).expect("well posed");
    let pieces = Pieces::of(&scene);
    let setting = Setting { ground: Ground::on(&flat, LENGTH), load: &pieces, stiffness: STIFFNESS, length: LENGTH };
    // Nearer to the supports than the true ones, so that the beam arrives from above; and slopes that are off.
    for (a, b, share) in [(3.5, 3.5, 0.0), (3.0, 3.6, 0.0), (3.5, 3.2, 0.05), (3.1, 3.4, -0.05)] {
        let slope = |a: f64| (1.5 * DEPTH / a + LOAD * a * a * a / (48.0 * STIFFNESS)) * (1.0 + share);
        let joints = [
            Joint { kind: Kind::Support, x: 0.0, slope: slope(a) },
            Joint::new(Kind::Start, a),
            Joint::new(Kind::End, LENGTH - b),
            Joint { kind: Kind::Support, x: LENGTH, slope: -slope(b) },
        ];
        let pair = pair(&setting, &joints).expect("a pattern from support to support");
        assert!(pair.amends <= 0.0, "{a}, {b}: nothing pulls and nothing penetrates: {pair:?}");
        let upper = pair.curve.energy(&pieces, STIFFNESS);
        let fifth = |a: f64| a * a * a * a * a;
        let lower =
            -LOAD * LOAD * (fifth(a) + fifth(b)) / (240.0 * STIFFNESS) - DEPTH * LOAD * (LENGTH - 0.5 * (a + b));
        let off = pair.gap.hi() - (upper.middle() - lower);
        assert!(off.abs() <= ROUNDING * lower.abs(), "{a}, {b}, {share}: off by {off} in {:?}", pair.gap);
        for (reaction, a) in pair.reactions.iter().zip([a, b]) {
            assert!((reaction.middle() - 0.5 * LOAD * a).abs() <= ROUNDING * LOAD * a, "{a}, {b}: {reaction:?}");
        }
    }
}
