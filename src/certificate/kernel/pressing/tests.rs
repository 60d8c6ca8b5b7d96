//! What cutting off costs, against beams that are pulled.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::reference::Datum;
use crate::scene::{Balance, Beam, Foundation, Load, PointLoad, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// A few dozen roundings.
const ROUNDING: f64 = 1e-12;

#[track_caller]
fn is(what: &str, number: Interval, expected: f64) {
    let range = expected * (1.0 - ROUNDING)..=expected * (1.0 + ROUNDING);
    assert!(range.contains(&number.hi()), "{what}: {number:?}, not {expected}");
}

/// A cut on the beam above `foundation` under one point load, and what becomes of it: moments and share.
fn cut_off(
    foundation: &Foundation,
    load: f64,
    point: [f64; 2],
    change: impl FnOnce(&EnclosedScene<'_>, &mut PullCutOff),
) -> [Interval; 2] {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let points = vec![PointLoad { at: point[0], force: point[1] }];
    let load = Load::new(&beam, load, Vec::new(), points).expect("finite");
    let scene = Scene::new(beam, load, Some(foundation.clone())).expect("well posed");
    in_intervals(&scene, Balance::Held, |enclosed| {
        let mut cut_off = PullCutOff::default();
        change(enclosed, &mut cut_off);
        cut_off.carried(&[Line(Datum::at(0.0), Datum::at(LENGTH))], STIFFNESS, 0.0)
    })
}

const FLAT: Foundation = Foundation::Flat { depth: 1.0 };
const NOWHERE: [f64; 2] = [10.0, 0.0];

/// `√(3 EI l)`, below the moments of a force.
fn root() -> f64 {
    (3.0 * STIFFNESS * LENGTH).sqrt()
}

/// Twice the same is twice as much, in moments and in shear.
#[test]
fn forces_couples_and_pressures_cost_what_their_moments_do() {
    let force = cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| {
        (0..2).for_each(|_| cut_off.force(5.0, Interval::between(-2.0, 1.0)))
    });
    is("moments of forces", force[0], 2.0 * 2.0 * 5.0 * 15.0 / root());
    is("share of forces", force[1], 4.0);
    // m = M x/l: ∫ m²/EI dx = M² l/3 EI.
    let couple = cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| {
        cut_off.couple(0.0, Interval::between(-1.0, 2.0), [false, true]);
        cut_off.couple(LENGTH, Interval::between(-2.0, 1.0), [true, false]);
    });
    is("moments of couples", couple[0], 2.0 * 2.0 * (LENGTH / (3.0 * STIFFNESS)).sqrt());
    is("share of couples", couple[1], 4.0 / LENGTH);
    let pressure = cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| {
        let pressure = Polynomial::new(&[Interval::exact(-2.0)]);
        cut_off.pressure(&pressure, [0.0, LENGTH], Interval::exact(3.0));
    });
    is("moments of pressures", pressure[0], 6.0 * 0.25 * LENGTH * LENGTH / root());
    is("share of pressures", pressure[1], 6.0);
    for nothing in [
        cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| cut_off.force(5.0, Interval::between(0.0, 1.0))),
        cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| cut_off.couple(0.0, Interval::between(-1.0, 0.0), [false, true])),
        cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| cut_off.couple(0.0, Interval::between(0.0, 1.0), [true, false])),
        cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| cut_off.couple(0.0, Interval::between(-1.0, 1.0), [true, true])),
    ] {
        assert!(nothing[0].is_zero() && nothing[1].is_zero(), "what presses costs nothing");
    }
    let neither = cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| {
        cut_off.couple(0.0, Interval::between(-3.0, 1.0), [false, false]);
    });
    is("a couple that nothing makes", neither[1], 3.0 / LENGTH);
}

/// `p = s − 1` pulls with 1/2 before `s = 1`, and `p = −2` with twice the width.
#[test]
fn a_pressure_is_cut_off_where_it_pulls() {
    let pulled = |p: &[f64], width: f64| {
        let p: Vec<Interval> = p.iter().map(|c| Interval::exact(*c)).collect();
        cut_off(&FLAT, 0.0, NOWHERE, |_, cut_off| {
            cut_off.pressure(&Polynomial::new(&p), [0.0, width], Interval::exact(width));
        })
    };
    is("all the way", pulled(&[-2.0], 3.0)[1], 6.0);
    for (p, width) in [([-1.0, 1.0], 5.0), ([4.0, -1.0], 5.0)] {
        let shear = pulled(&p, width)[1].hi();
        // Parts of the part that pulls are counted with the least of their values.
        assert!((0.5..1.1).contains(&shear), "{shear} for {p:?}");
    }
    assert!(pulled(&[0.5, 1.0], 5.0)[1].is_zero());
}

/// A beam on a rise of curvature that changes: `q − EI u''''` of a quartic, and a point load that pulls.
#[test]
fn a_zone_pulls_where_its_curve_is_too_sharp() {
    let quartic = |c: f64| Foundation::Polynomial { coefficients: vec![5.0, 0.0, 0.0, 0.0, c] };
    let zone = |foundation: &Foundation, load: f64, point: [f64; 2]| {
        let mut held = None;
        let cut_off = cut_off(foundation, load, point, |enclosed, cut_off| held = zone(enclosed, [4.0, 12.0], cut_off));
        held.map(|_| cut_off[1].hi())
    };
    let fourth = 24.0 * STIFFNESS * 1e-3;
    let shear = zone(&quartic(1e-3), 0.5 * fourth, NOWHERE).expect("a smooth ground");
    is("pressure", Interval::exact(shear), 0.5 * fourth * 8.0);
    assert!(zone(&quartic(1e-3), 1.01 * fourth, NOWHERE).is_some_and(|shear| shear <= 0.0), "it presses");
    assert!(zone(&FLAT, 1.0, [7.0, -3.0]).is_some_and(|shear| (3.0..3.1).contains(&shear)), "the point load pulls");
    assert!(zone(&FLAT, 1.0, [7.0, 3.0]).is_some_and(|shear| shear <= 0.0), "the point load presses");
    let kink = Foundation::Polyline { points: vec![[0.0, 1.0], [8.0, 2.0], [LENGTH, 1.0]] };
    assert!(zone(&kink, 1.0, NOWHERE).is_none(), "no beam lies in a corner");
}

/// On level ground a beam lies where it is straight, and not over a kink of its own.
#[test]
fn no_zone_goes_over_a_kink_of_the_own_shape() {
    let bent = Foundation::Polyline { points: vec![[0.0, 0.0], [8.0, 0.5], [LENGTH, 0.0]] };
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_shape(bent).expect("a line");
    let load = Load::uniform_on(&beam, 3.0).expect("finite");
    let scene = Scene::new(beam, load, Some(FLAT)).expect("well posed");
    let lies = |ends: [f64; 2]| {
        in_intervals(&scene, Balance::Held, |enclosed| zone(enclosed, ends, &mut PullCutOff::default()).is_some())
    };
    assert_eq!([[4.0, 7.0], [4.0, 12.0], [9.0, 12.0]].map(lies), [true, false, true]);
}
