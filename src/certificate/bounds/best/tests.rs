//! The choice between admissible deflections, for a beam whose bounds are known in closed form.

use super::*;
use crate::certificate::bounds::curve::Piece;
use crate::certificate::bounds::joints::{Joint, Kind};
use crate::certificate::bounds::polynomial::Polynomial;
use crate::scene::{Beam, Foundation, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
const CUBE: f64 = LENGTH * LENGTH * LENGTH;
/// `−q² l⁵/240 EI` and `5 q l⁴/384 EI`, of the free beam.
const FREE: f64 = -LOAD * LOAD * CUBE * LENGTH * LENGTH / (240.0 * STIFFNESS);
const SAG: f64 = 5.0 * LOAD * CUBE * LENGTH / (384.0 * STIFFNESS);
/// Of both energies, which are sums of some dozens of roundings.
const ROUNDING: f64 = 1e-12;

/// The beam over flat ground that it touches, and what is asked of it.
fn touching<R>(depth: f64, ask: impl FnOnce(&Inner<'_>, &Pair) -> R) -> R {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let flat = Foundation::Flat { depth };
    let scene = Scene::new(beam, load, Some(flat)).expect("well posed");
    let inner = Inner::of(&scene, scene.foundation());
    // As if it did not touch, with the slopes of the free beam: in the ground, and lifted.
    let slope = LOAD * CUBE / (24.0 * STIFFNESS);
    let support = |x: f64, slope: f64| Joint { kind: Kind::Support, x, slope };
    let pair = inner.pair(&[support(0.0, slope), support(LENGTH, -slope)]).expect("from support to support");
    ask(&inner, &pair)
}

/// `w x (l − x)` with the energy `2 EI w² l − q w l³/6`, as one piece.
fn parabola(w: f64) -> (Curve, f64) {
    let v = Polynomial::new(&[0.0, w * LENGTH, -w].map(Interval::exact));
    let energy = 2.0 * STIFFNESS * w * w * LENGTH - LOAD * w * CUBE / 6.0;
    (Curve { pieces: vec![Piece { from: 0.0, to: LENGTH, v, follows: false }] }, energy)
}

/// The moments of the pair are those of the free beam, so that `D(p)` is its energy, and every admissible deflection has the
/// gap `J(v̂) − D(p)`.
#[test]
fn of_admissible_deflections_the_one_with_the_least_energy_counts() {
    touching(0.5 * SAG, |inner, pair| {
        let own = pair.curve.energy(&inner.load, STIFFNESS).middle();
        assert!(!inner.is_sharp(pair), "it had to be lifted");
        // Half as deep as the ground allows, and as deep as it allows.
        let shallow = parabola(SAG / (CUBE / LENGTH));
        let deep = parabola(2.0 * SAG / (CUBE / LENGTH));
        assert!(deep.1 < own && own < shallow.1, "{}, {own}, {}", deep.1, shallow.1);
        for (others, energy) in [
            (vec![shallow.0.clone()], own),
            (vec![], own),
            (vec![deep.0.clone()], deep.1),
            (vec![shallow.0.clone(), deep.0.clone()], deep.1),
            (vec![deep.0, shallow.0], deep.1),
        ] {
            let best = inner.best(Some(pair), || others);
            let slack = ROUNDING * own.abs();
            assert!((best.energy.middle() - energy).abs() <= slack, "{:?}, not {energy}", best.energy);
            assert!((best.curve.energy(&inner.load, STIFFNESS).middle() - energy).abs() <= slack, "its own energy");
            // A bound, and as sharp as the amends of the pair are counted.
            let gap = energy - FREE;
            assert!(gap - slack <= best.gap.hi() && best.gap.hi() <= 1.001 * gap, "{:?}, not {gap}", best.gap);
            assert!(0.0 <= best.gap.lo());
        }
    });
}

/// Without a pair any admissible deflection is better than none, and says nothing of the gap; without that, nothing is known.
#[test]
fn without_a_pair_there_is_no_gap() {
    touching(0.5 * SAG, |inner, _| {
        let (curve, energy) = parabola(SAG / (CUBE / LENGTH));
        let best = inner.best(None, || vec![curve]);
        assert!((best.energy.middle() - energy).abs() <= ROUNDING * energy.abs(), "{:?}, not {energy}", best.energy);
        assert_eq!(best.gap, Interval::WHOLE);
        let none = inner.best(None, Vec::new);
        assert_eq!((none.energy, none.gap), (Interval::WHOLE, Interval::WHOLE));
    });
}

/// Amends are rounding up to a millionth of the deflection, wherever in its pieces that is largest; nothing else is looked at
/// then.
#[test]
fn a_pair_is_sharp_up_to_a_millionth() {
    touching(0.5 * SAG, |inner, pair| {
        // Both ends of a second piece that begins behind the support, and the one where they meet.
        let piece = |from: f64, to: f64, c: [f64; 2]| Piece {
            from,
            to,
            v: Polynomial::new(&c.map(Interval::exact)),
            follows: false,
        };
        let pieces = vec![piece(0.0, 8.0, [0.0, 0.25]), piece(8.0, LENGTH, [2.0, 0.5])];
        let mut pair = Pair { curve: Curve { pieces }, ..pair.clone() };
        // 2 + 0.5 · 12 at the right end, and what moments may be for it to move by a millionth of that.
        let per = error::of_moments(1.0, STIFFNESS, LENGTH);
        for (share, sharp) in [(0.99, true), (1.01, false)] {
            pair.amends = share * 8e-6 / per;
            assert_eq!(inner.is_sharp(&pair), sharp, "{share}");
        }
        pair.amends = 0.0;
        let best = inner.best(Some(&pair), || panic!("nothing else is looked at"));
        assert_eq!(best.gap, pair.gap);
    });
}
