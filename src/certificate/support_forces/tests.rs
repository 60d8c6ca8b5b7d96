//! How far the forces of supports are known, beside closed forms.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::proof::Sprung;
use crate::certificate::kernel::reference::{Datum, Line};
use crate::certificate::kernel::springs::{self, Stretch};
use crate::certificate::kernel::tension::Taut;
use crate::scene::{Balance, Beam, Foundation, Load, Support};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// A few dozen roundings.
const ROUNDING: f64 = 1e-13;

#[track_caller]
fn sharp(bound: f64, value: f64) {
    assert!((value * (1.0 - ROUNDING)..=value * (1.0 + ROUNDING)).contains(&bound), "{bound}, not {value}");
}

fn piece([from, to]: [f64; 2], coefficients: &[f64]) -> Piece {
    let coefficients: Vec<Interval> = coefficients.iter().map(|c| Interval::exact(*c)).collect();
    Piece { from, to, v: Polynomial::new(&coefficients), pressed: false }
}

/// A pair of a beam on its two ends, with forces of 3 and 4.
fn pair_on_two_ends(pieces: Vec<Piece>, gap: f64) -> Pair {
    Pair {
        pieces,
        gap,
        carried: [(0.0, 3.0), (LENGTH, 4.0)].map(|(x, force)| (x, Interval::exact(force))).to_vec(),
        lines: vec![Line(Datum::at(0.0), Datum::at(LENGTH))],
        zones: Vec::new(),
        turns_about: None,
        lifted: 0.0,
        ground: None,
        turned: Interval::ZERO,
        soft: 0.0,
        taut: Taut::default(),
    }
}

/// Moments `κ x` up to the distance `c` from a support, and not beyond, store `κ² c³/6 EI`.
#[test]
fn reactions_are_as_good_as_the_beam_is_known_to_be_clear() {
    /// Chosen so that the proof ends within the beam: `√(2 gap/3 EI l)`.
    const SHARE: f64 = 0.0041;
    let gap = 1.5 * SHARE * SHARE * STIFFNESS * LENGTH;
    let sag = 0.07;
    /// Parts that are clear: until `0.4 − v` is less than the bound.
    const CLEAR: [f64; 2] = [13.0 * 7.0 / 16.0, 8.0 * 13.0 / 16.0];
    let slopes = [piece([0.0, 7.0], &[0.0, sag / 7.0]), piece([7.0, LENGTH], &[sag, -sag / 13.0])];
    let pair = pair_on_two_ends(slopes.to_vec(), gap);
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, 1.0).expect("finite");
    let over = |pair: &Pair, depth: f64| {
        let flat = Some(Foundation::Flat { depth });
        let scene = Scene::new(beam.clone(), load.clone(), flat.filter(|_| depth.is_finite())).expect("well posed");
        in_intervals(&scene, Balance::Held, |enclosed| forces(&scene, scene.load(), enclosed, pair).0)
    };
    let check = |pair: &Pair, depth: f64, clear: [f64; 2]| {
        for ((bracket, middle), c) in over(pair, depth).iter().zip([3.0, 4.0]).zip(clear) {
            let turn = (6.0 * STIFFNESS * gap / (c * c * c)).sqrt();
            let bracket = bracket.expect("the beam is clear of the ground beside both supports");
            sharp(bracket.hi(), middle + turn);
            sharp(middle - bracket.lo(), turn);
        }
    };
    // Without ground the forces follow from statics alone.
    for bracket in over(&pair, f64::INFINITY) {
        let bracket = bracket.expect("the beam is clear");
        sharp(bracket.hi(), 0.5 * LENGTH);
        sharp(bracket.lo(), 0.5 * LENGTH);
    }
    // Ground so deep that the beam is clear of it from end to end.
    check(&pair, 1e6, [LENGTH, LENGTH]);
    // Sixteen parts a piece; in each the least clearance has to be more than SHARE times the largest `x (l − x)`.
    check(&pair, 0.4, CLEAR);

    let mut lying = pair;
    lying.pieces[0].pressed = true;
    let [left, right] = over(&lying, 0.4)[..] else { panic!("two supports") };
    assert!(left.is_none() && right.is_some(), "where the beam lies on the ground beside a support, nothing is known");
}

/// Where a witness presses on soft ground and `v̂` is clear of it, nothing follows from the moments of the pair beside a support.
#[test]
fn a_pair_that_presses_beside_a_support_is_not_clear_there() {
    const SOFT: f64 = 1e-6;
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, 1e-9).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 0.4 })).expect("well posed");
    let scene = scene.on_springs(SOFT).expect("positive");
    let stretch = |sunk: &[f64], depth: f64| Stretch {
        from: 0.0,
        to: LENGTH,
        sunk: sunk.to_vec(),
        ends: [[depth, 0.0, 0.0, 0.0]; 2],
    };
    in_intervals(&scene, Balance::Held, |enclosed| {
        let clear = |stretch: Stretch| {
            let pair = springs::pair(enclosed, &[stretch]).expect("supports hold it");
            assert!(pair.pieces.iter().all(|piece| piece.v.range(Interval::exact(LENGTH)).hi() < 0.4));
            clear_from(enclosed, &pair, 0.0, LENGTH)
        };
        sharp(clear(stretch(&[], 0.0)), LENGTH);
        assert!(clear(stretch(&[0.1], 0.1)) <= 0.0);
    });
}

/// Beside a support at its level ground that bends away has no contact if it is rigid; into ground that gives the beam may sink.
#[test]
fn only_rigid_ground_that_bends_away_is_clear_whatever_the_pair() {
    const HELD: f64 = 0.5 * LENGTH;
    let supports = [0.0, HELD].map(Support::simple).to_vec();
    let beam = Beam::new(LENGTH, STIFFNESS).and_then(|beam| beam.with_supports(supports)).expect("two supports");
    let load = Load::uniform_on(&beam, 1e-9).expect("finite");
    // 1e-3 (x − 10)².
    let ground = Foundation::Polynomial { coefficients: vec![0.1, -0.02, 1e-3] };
    let scene = Scene::new(beam, load, Some(ground)).expect("well posed");
    let pair = |ground| Pair {
        pieces: vec![piece([0.0, LENGTH], &[0.0])],
        // Of the deflection nothing is known.
        gap: 1e9,
        carried: Vec::new(),
        lines: vec![Line(Datum::at(0.0), Datum::at(HELD))],
        zones: Vec::new(),
        turns_about: None,
        lifted: 0.0,
        ground,
        turned: Interval::ZERO,
        soft: 0.0,
        taut: Taut::default(),
    };
    in_intervals(&scene, Balance::Held, |enclosed| {
        let sprung = Sprung { energy: Interval::ZERO, moments: Vec::new() };
        assert!(HELD < clear_from(enclosed, &pair(None), HELD, LENGTH));
        assert!(clear_from(enclosed, &pair(Some(sprung)), HELD, LENGTH) <= HELD);
    });
}

/// Many parts are looked at together: the beam is clear up to the last reading before one that is too high, from either support.
#[test]
fn many_readings_are_clear_up_to_the_one_that_is_not() {
    const READINGS: u32 = 1600;
    const HIGH: [u32; 2] = [777, 1200];
    let at = |i: u32| LENGTH * f64::from(i) / f64::from(READINGS);
    // No three on a line, or they would be one.
    let depth = |i: u32| if HIGH.contains(&i) { 0.05 } else { 0.4 + 0.01 * f64::from(i % 2) };
    let points = (0..=READINGS).map(|i| [at(i), depth(i)]).collect();
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, 1.0).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Polyline { points })).expect("well posed");
    // Off by 0.1 in the middle.
    let bend = 0.1 / (0.25 * LENGTH * LENGTH);
    let gap = 1.5 * STIFFNESS * bend * bend * LENGTH;
    let pair = pair_on_two_ends(vec![piece([0.0, LENGTH], &[0.0])], gap);
    in_intervals(&scene, Balance::Held, |enclosed| {
        let [left, right] = [[0.0, LENGTH], [LENGTH, 0.0]].map(|[x, end]| clear_from(enclosed, &pair, x, end));
        let expected = [at(HIGH[0] - 1), at(HIGH[1] + 1)];
        assert_eq!([left, right].map(f64::to_bits), expected.map(f64::to_bits), "{left} and {right}, not {expected:?}");
    });
}

/// A beam on its two ends, under a load on it, with level ground at a depth, and a pair of one piece.
fn on_two_ends(depth: f64, load: f64, gap: f64, piece: Piece, test: impl FnOnce(&EnclosedScene<'_>, &Pair)) {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, load).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth })).expect("well posed");
    let pair = pair_on_two_ends(vec![piece], gap);
    in_intervals(&scene, Balance::Held, |enclosed| test(enclosed, &pair));
}

/// A beam that rises from its support by a slope is clear of level ground if that is more than the deflection is off, over the distance.
#[test]
fn a_beam_is_clear_beside_a_support_whose_level_is_the_ground() {
    const SLOPE: f64 = 0.03;
    let most = factor(1.0, STIFFNESS) * LENGTH.sqrt() / SLOPE;
    for (share, is_clear) in [(0.999, true), (1.001, false)] {
        on_two_ends(0.0, 1.0, share * share / (most * most), piece([0.0, LENGTH], &[0.0, -SLOPE]), |enclosed, pair| {
            assert_eq!(0.0 < clear_from(enclosed, pair, 0.0, LENGTH), is_clear, "{share}");
        });
    }
}

/// A load `q` on a beam that is pressed all along `w`: `∫ q φ > √(2 gap EI ∫ φ''²)` for `φ = s² (w − s)²`, `q w⁵/30` and `4 w⁵/5`.
#[test]
fn a_beam_lies_beside_a_support_where_the_load_is_more_than_the_gap() {
    const WIDTH: f64 = LENGTH;
    let most = WIDTH * WIDTH * WIDTH * WIDTH * WIDTH / (1440.0 * STIFFNESS);
    for (share, lies) in [(0.999, true), (1.001, false)] {
        let pressed = Piece { pressed: true, ..piece([0.0, WIDTH], &[0.0]) };
        on_two_ends(0.0, 1.0, share * most, pressed, |enclosed, pair| {
            assert_eq!(lies_beside(enclosed, pair, 0.0, 1), lies, "{share}");
        });
    }
}

/// Built in along level ground, the beam leaves it with a curvature `κ`: it is clear of it from the support on, unless the deflection is
/// off by more than the clearance all along, or leaves it with the cube of the distance only.
#[test]
fn a_beam_that_is_bent_away_from_its_support_is_clear_there() {
    const KAPPA: f64 = 0.02;
    let beam = Beam::new(LENGTH, STIFFNESS).and_then(|beam| beam.with_supports(vec![Support::built_in(0.0)]));
    let beam = beam.expect("one support");
    let load = Load::uniform_on(&beam, 1.0).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 0.0 })).expect("well posed");
    // `κ s²/2` and the bound `√(2 gap/3 EI) s^(3/2)` at the far end of the first of sixteen parts.
    let part = LENGTH / 16.0;
    let most = 1.5 * STIFFNESS * 0.25 * KAPPA * KAPPA * part;
    let clear = |v: &[f64], gap: f64| {
        let at = Line(Datum::at(0.0), Datum::at(0.0));
        let pair = Pair { lines: vec![at], ..pair_on_two_ends(vec![piece([0.0, LENGTH], v)], gap) };
        in_intervals(&scene, Balance::Held, |enclosed| opens(enclosed, &pair, 0.0, [0.0, part]))
    };
    let bent = [0.0, 0.0, -0.5 * KAPPA];
    assert!(clear(&bent, 0.0) && clear(&bent, 1e-3 * most));
    assert!(!clear(&bent, 2.0 * most), "off by more than it is clear");
    assert!(!clear(&[0.0, 0.0, 0.0, -KAPPA], 0.0), "whatever the shear force is, a contact nearer would be as good");
    assert!(!clear(&[0.0, 0.0, 0.5 * KAPPA], 0.0), "into the ground");
}

/// A line on soft ground, and on stiff ground a bent shape of the best width.
#[test]
fn reactions_on_ground_that_gives_are_known_to_the_least_of_two_bounds() {
    const GAP: f64 = 0.02;
    let width = |k: f64| (1260.0 * STIFFNESS / (13.0 * k)).sqrt().sqrt();
    let bent = |k: f64| 12.0 * STIFFNESS / (width(k) * width(k) * width(k)) + 13.0 * k * width(k) / 35.0;
    for (k, size) in [(0.01, 0.01 * LENGTH / 3.0), (100.0, bent(100.0))] {
        on_two_ends(1.0, 1.0, GAP, piece([0.0, LENGTH], &[0.0]), |enclosed, pair| {
            let soft = EnclosedScene { ground: &[([0.0, LENGTH], k)], ..*enclosed };
            for (bracket, middle) in on_springs(&soft, pair).iter().zip([3.0, 4.0]) {
                sharp(bracket.hi() - middle, (2.0 * GAP * size).sqrt());
                sharp(middle - bracket.lo(), (2.0 * GAP * size).sqrt());
            }
        });
    }
}

/// What is next to a beam in balance above its middle keeps it from turning: of the ground and of a support that only pushes, what is
/// nearer to it in relation to the lever.
#[test]
fn a_support_that_only_pushes_may_carry_a_part_of_a_load_in_balance() {
    const MIDDLE: f64 = 0.5 * LENGTH;
    let off = factor(1.0, STIFFNESS) * LENGTH.sqrt();
    for (level, carries) in [(0.1, false), (0.9, true)] {
        let supports = vec![Support::pushing(5.0).at_level(level), Support::simple(MIDDLE)];
        let beam = Beam::new(LENGTH, STIFFNESS).and_then(|beam| beam.with_supports(supports)).expect("two supports");
        let load = Load::uniform_on(&beam, 1.0).expect("finite");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("well posed");
        let pair = Pair {
            pieces: vec![piece([0.0, LENGTH], &[0.0])],
            // The ground alone leaves 1/10 on either side, twice this is a quarter less.
            gap: 0.075 * 0.075 / (off * off),
            carried: Vec::new(),
            lines: Vec::new(),
            zones: Vec::new(),
            turns_about: None,
            lifted: 0.0,
            ground: None,
            turned: Interval::ZERO,
            soft: 0.0,
            taut: Taut::default(),
        };
        in_intervals(&scene, Balance::Held, |enclosed| {
            assert_eq!(carries_all(enclosed, &pair, MIDDLE), carries, "{level}");
        });
    }
}
