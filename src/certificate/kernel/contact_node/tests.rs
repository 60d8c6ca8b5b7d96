//! What a support asks of the deflection above ground that it meets or not, and how a beam meets it.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::foundation::tests as survey;
use crate::scene::{Balance, Beam, Foundation, Load, Support};

const LENGTH: f64 = 20.0;
/// Slope of the own shape, and that of the ground on the left and on the right of a kink.
const OWN: f64 = 0.125;
const GROUND: [f64; 2] = [-0.25, 0.5];

/// What a node is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Kind {
    Support,
    Corner,
    Touch,
    Start,
    End,
}

/// A node of some kind, with its slope where that is its own.
pub(in super::super) fn node(kind: Kind, x: f64, slope: f64) -> ContactNode {
    let from_the_left = kind == Kind::End;
    let free = matches!(kind, Kind::Support | Kind::Corner);
    let slope = if free { Slope::Free(slope) } else { Slope::OfGround { from_the_left } };
    ContactNode { x, slope, lies: kind == Kind::Start }
}

fn contains(interval: Interval, value: f64) -> bool {
    interval.lo() <= value && value <= interval.hi()
}

/// What becomes of a support at a kink of the ground, at its level or at another one, and the order at its two sides.
fn at_kink(slope: Option<f64>, above: f64, node: Slope) -> (EnclosedSupport, [usize; 2]) {
    let x = 8.0;
    let ground = [[0.0, 2.0 - GROUND[0] * x], [x, 2.0], [LENGTH, 2.0 + GROUND[1] * (LENGTH - x)]];
    let shape = Foundation::Polynomial { coefficients: vec![0.25, OWN] };
    let supports = vec![Support { level: 2.0 - above, slope, ..Support::simple(x) }, Support::simple(LENGTH)];
    let beam = Beam::new(LENGTH, 70.0).expect("positive").with_supports(supports).expect("on the beam");
    let beam = beam.with_shape(shape).expect("a curve");
    let ground = Foundation::Polyline { points: ground.to_vec() };
    let scene = Scene::new(beam, Load::default(), Some(ground)).expect("well posed");
    in_intervals(&scene, Balance::Held, |enclosed| {
        let node = ContactNode { x, slope: node, lies: false };
        (*enclosed.support(x).expect("it is there"), [true, false].map(|left| enclosed.order(&node, left)))
    })
}

#[test]
fn a_support_has_the_deflection_and_the_slope_of_ground_that_it_meets() {
    let free = Slope::Free(0.0);
    for (slope, order) in [(-0.25, [2, 1]), (0.5, [1, 2]), (0.1, [1, 1])] {
        let (support, found) = at_kink(Some(slope), 0.0, free);
        assert_eq!(found, order, "built in at {slope}");
        let is = support.slope.expect("built in");
        assert!(contains(is, slope - OWN) && is.hi() - is.lo() < 1e-15, "{is:?}, not {}", slope - OWN);
        assert!(contains(support.deflection, 2.0 - 0.25 - 8.0 * OWN), "{:?}", support.deflection);
        // Above the ground it meets nothing, whatever its slope.
        let (support, found) = at_kink(Some(slope), 0.5, free);
        assert_eq!(found, [0, 0], "above the ground, built in at {slope}");
        assert!(contains(support.deflection, 1.5 - 0.25 - 8.0 * OWN), "{:?}", support.deflection);
    }
    for (slope, order) in [
        (free, [1, 1]),
        (Slope::OfGround { from_the_left: true }, [2, 1]),
        (Slope::OfGround { from_the_left: false }, [1, 2]),
    ] {
        assert_eq!(at_kink(None, 0.0, slope).1, order, "{slope:?}");
        assert_eq!(at_kink(None, 0.5, slope).1, [0, 0], "{slope:?}, above the ground");
    }
}

/// `v₁ − v₀ − θ₀ L` by cells and as it stands are one number; by cells it is known to rounding of slopes.
#[test]
fn the_rise_between_two_contacts_follows_from_cells() {
    /// Four roundings each of 16 slopes of at most `10⁻⁶`, over 8 of length; of a depth one rounding is 1000 times as much.
    const ROUNDING: f64 = 512e-6 * f64::EPSILON;
    let above = |ground: &Foundation, left: ContactNode, to: f64| {
        let beam = Beam::new(survey::LENGTH, 70.0).expect("positive");
        let scene = Scene::new(beam, Load::default(), Some(ground.clone())).expect("well posed");
        in_intervals(&scene, Balance::Held, |enclosed| {
            let slope = enclosed.end(&left)[1];
            (enclosed.rise(Some(&left), Some(&node(Kind::Corner, to, 0.0))), slope)
        })
    };
    for seed in 0..20 {
        let ground = survey::nearly_level(seed);
        let Foundation::Polyline { points } = &ground else { panic!("a survey") };
        for (first, last) in [(1, 2), (1, 3), (2, 9), (5, 20)] {
            let [from, to] = [points[first], points[last]];
            for kind in [Kind::Corner, Kind::Start, Kind::End] {
                let (rise, slope) = above(&ground, node(kind, from[0], 1e-9), to[0]);
                let rise = rise.expect("a few segments");
                let straight = Interval::length(from[1], to[1]) - slope * Interval::length(from[0], to[0]);
                assert!(rise.lo() <= straight.hi() && straight.lo() <= rise.hi(), "{rise:?} is not {straight:?}");
                assert!(rise.hi() - rise.lo() <= ROUNDING, "{kind:?}: {rise:?}");
            }
        }
    }
    let stairs = vec![[0.0, 1.0], [4.0, 1.0], [4.0, 2.0], [8.0, 2.0], [8.0, 1.0], [survey::LENGTH, 1.0]];
    let stairs = Foundation::Polyline { points: stairs };
    for (from, to) in [(1.0, 4.0), (1.0, 5.0), (4.0, 5.0), (5.0, 8.0), (8.0, 9.0)] {
        assert!(above(&stairs, node(Kind::Corner, from, 0.0), to).0.is_none(), "a step between {from} and {to}");
    }
    assert!(above(&stairs, node(Kind::Corner, 1.0, 0.0), 2.0).0.is_some());
    let wave = Foundation::Cosine { mean: 1.0, amplitude: 0.5, wavelength: 2.0, phase: 0.0 };
    let rise = above(&wave, node(Kind::Corner, 1.0, 0.0), 1.125).0.expect("a few cells of a curve");
    let expected = 0.5 * (1.0 - libm::cos(std::f64::consts::PI / 8.0));
    assert!((rise.lo() - 4e-16..=rise.hi() + 4e-16).contains(&expected), "{rise:?} is not {expected}");
    assert!(above(&wave, node(Kind::Corner, 1.0, 0.0), 2.0).0.is_none(), "half a wave has many cells");
    assert!(
        above(&stairs, node(Kind::Corner, 0.0, 0.0), 2.0).0.is_none(),
        "a support is where it is, not on the ground"
    );
}
