//! What the supports leave free: classified beside exact fractions.

use std::cmp::Ordering;

use palkki::scene::{Balance, Beam, Foundation, LinearLoad, Load, PointLoad, Scene, SceneError, Support, Unheld};
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::number::Number;
use palkki_evidence::authority::statics::{exactly, resultant_and_moment};
use palkki_evidence::random::Random;

const GROUND: Option<Foundation> = Some(Foundation::Flat { depth: 1.0 });

fn scene(length: f64, supports: Vec<Support>, load: Load, ground: Option<Foundation>) -> Scene {
    let beam = Beam::new(length, 1.0).and_then(|beam| beam.with_supports(supports)).expect("a beam");
    Scene::new(beam, load, ground).expect("a scene")
}

/// On which side a scene falls, if it is not one of rest.
fn classified(scene: &Scene) -> Result<Balance, Unheld> {
    match scene.scaled() {
        Ok(scaled) => Ok(scaled.balance.in_units_of(&scaled.scale)),
        Err(SceneError::Unheld(why)) => Err(why),
        Err(other) => panic!("{other}"),
    }
}

/// A few loads; of every other one the last point load brings the resultant to a border, or beside it.
fn random_load(random: &mut Random, length: f64, about: f64) -> Load {
    let beam = Beam::new(length, 1.0).expect("a beam");
    let intensity = |random: &mut Random| random.between(-2.0, 3.0);
    let uniform = if random.once_in(2) { intensity(random) } else { 0.0 };
    let linear = (0..random.below(3)).map(|_| {
        let from = random.between(0.0, 0.9 * length);
        let to = random.between(from + 0.01 * length, length);
        LinearLoad { from, to, start: intensity(random), end: intensity(random) }
    });
    let linear = linear.collect();
    let mut point: Vec<PointLoad> = Vec::new();
    for _ in 0..random.below(4) {
        point.push(PointLoad { at: random.between(0.0, length), force: random.between(-10.0, 20.0) });
    }
    if random.once_in(2) {
        let load = Load::new(&beam, uniform, linear, point.clone()).expect("loads");
        let [_, moment] = resultant_and_moment(&load, length, about).expect("finite");
        let at = if about < 0.5 * length { length } else { 0.0 };
        let shift = random.pick(&[0.0, 1e-15, -1e-15, 1e-13, -1e-13, 1e-3]);
        let force = -moment.to_double() / (at - about) + shift * load.magnitude(length);
        point.push(PointLoad { at, force });
        return Load::new(&beam, uniform, load.linear().to_vec(), point).expect("loads");
    }
    Load::new(&beam, uniform, linear, point).expect("loads")
}

/// What may be unknown of a moment: two roundings of each force and place, and those of the sum of places.
fn known_to(load: &Load, length: f64) -> RBig {
    exactly(5.0 * f64::EPSILON * load.magnitude(length) * length).expect("finite")
}

#[test]
fn random_loads_are_classified_as_fractions_classify_them() {
    let mut random = Random::new(72);
    let zero = RBig::ZERO;
    let (mut stood, mut neutral, mut fell) = (0, 0, 0);
    for k in 0..500 {
        let length = random.between(0.5, 20.0);
        let support = (k % 3 == 0).then(|| random.between(0.0, length));
        let about = support.unwrap_or_else(|| if random.once_in(2) { 0.0 } else { length });
        let load = random_load(&mut random, length, about);
        let ground = if support.is_some() && random.once_in(3) { None } else { GROUND };
        let grounded = ground.is_some();
        let scene = scene(length, support.map(Support::simple).into_iter().collect(), load.clone(), ground);
        let within = known_to(&load, length);
        let near = |value: &RBig| *value <= within && -value <= within;
        let [force, left] = resultant_and_moment(&load, length, 0.0).expect("finite");
        let [_, right] = resultant_and_moment(&load, length, length).expect("finite");
        let [_, turn] = resultant_and_moment(&load, length, about).expect("finite");
        let found = classified(&scene);
        let what = format!("{k}: {found:?}, {scene:?}");
        match found {
            Ok(Balance::Held) => panic!("{what}"),
            Ok(Balance::Neutral { about: place, .. }) => {
                neutral += 1;
                let [_, turn] = resultant_and_moment(&load, length, place).expect("finite");
                assert!(near(&turn), "{what}");
            }
            Ok(Balance::Stands(resultant)) => {
                stood += 1;
                if support.is_some() {
                    assert!(turn != zero && grounded, "{what}");
                } else {
                    assert!(zero < left && right < zero, "{what}");
                    let at = (left / force).to_double();
                    assert!((resultant.at - at).abs() <= 1e-15 * at.abs(), "{what}");
                }
            }
            Err(why) => {
                fell += 1;
                match why {
                    Unheld::Turns { moment, .. } => {
                        assert!(support.is_some() && !grounded && 0.0 < moment * turn.to_double(), "{what}");
                    }
                    Unheld::PulledUp { .. } => assert!(force < zero && support.is_none(), "{what}"),
                    Unheld::Overturns { at, .. } => {
                        let side = if at < 0.0 { left < zero } else { zero < right };
                        assert!(zero < force && side && support.is_none(), "{what}");
                    }
                    Unheld::NothingPresses => assert!(near(&left) && near(&right) && support.is_none(), "{what}"),
                    Unheld::Couple { .. }
                    | Unheld::NothingCarries
                    | Unheld::OnBorder { .. }
                    | Unheld::Mechanism
                    | Unheld::Turned { .. }
                    | Unheld::Moved { .. } => panic!("{what}"),
                }
            }
        }
    }
    assert!(100 < stood && 30 < neutral && 100 < fell, "{stood}, {neutral}, {fell}");
}

/// A weight and a pull that balance about the left end, and 10⁻¹⁵ beside it on either side.
#[test]
fn a_border_has_two_sides() {
    for (shift, expected) in [(-1e-15, Ordering::Less), (0.0, Ordering::Equal), (1e-15, Ordering::Greater)] {
        let beam = Beam::new(10.0, 1.0).expect("a beam");
        let point = vec![PointLoad { at: 0.0, force: 5.0 }, PointLoad { at: 3.0, force: 1.0 }];
        let pull = PointLoad { at: 10.0, force: -0.3 * (1.0 - shift) };
        let load = Load::new(&beam, 0.0, Vec::new(), point.into_iter().chain([pull]).collect()).expect("loads");
        let found = classified(&scene(10.0, Vec::new(), load, GROUND));
        let side = match &found {
            Err(Unheld::Overturns { .. }) => Ordering::Less,
            Ok(Balance::Neutral { about, .. }) if about.abs() <= 0.0 => Ordering::Equal,
            Ok(Balance::Stands(_)) => Ordering::Greater,
            other => panic!("{other:?}"),
        };
        assert_eq!(side, expected, "{shift}: {found:?}");
    }
}

#[test]
fn what_is_not_held_is_told() {
    let told = |supports: Vec<Support>, point: &[[f64; 2]], ground: Option<Foundation>| {
        let beam = Beam::new(10.0, 1.0).expect("a beam");
        let point = point.iter().map(|&[at, force]| PointLoad { at, force }).collect();
        let load = Load::new(&beam, 0.0, Vec::new(), point).expect("loads");
        scene(10.0, supports, load, ground).scaled().expect_err("nothing holds it").to_string()
    };
    let at = |x: f64| vec![Support::simple(x)];
    insta::assert_snapshot!(told(vec![], &[[0.0, 5.0], [10.0, -0.1]], GROUND), @"the loads have their resultant 4.9 at x = -0.2041, outside the ground (0 … 10): the beam turns over the left end of the ground");
    insta::assert_snapshot!(told(vec![], &[[10.0, 5.0], [0.0, -0.1]], GROUND), @"the loads have their resultant 4.9 at x = 10.2, outside the ground (0 … 10): the beam turns over the right end of the ground");
    insta::assert_snapshot!(told(vec![], &[[2.0, -2.0]], GROUND), @"the loads pull upwards by 2: nothing holds the beam down");
    insta::assert_snapshot!(told(vec![], &[[2.0, -2.0], [4.0, 2.0]], GROUND), @"the loads have no resultant, but a couple of 4: nothing keeps the beam from turning");
    insta::assert_snapshot!(told(vec![], &[], GROUND), @"no load presses on the beam: any position is one of rest");
    insta::assert_snapshot!(told(vec![], &[[2.0, 1.0]], None), @"there is neither a support nor a foundation: nothing carries the beam");
    insta::assert_snapshot!(told(at(0.0), &[[6.0, -1.5]], GROUND), @"there is no ground to the left of the support: nothing keeps the beam from turning about its support at x = 0, with a moment of -9");
    insta::assert_snapshot!(told(at(10.0), &[[6.0, -1.5]], GROUND), @"there is no ground to the right of the support: nothing keeps the beam from turning about its support at x = 10, with a moment of 6");
    insta::assert_snapshot!(told(at(4.0), &[[6.0, 1.5]], None), @"there is no foundation: nothing keeps the beam from turning about its support at x = 4, with a moment of 3");
    // One support in balance, and a built-in one, carry the beam alone.
    let carried = |supports| {
        let beam = Beam::new(10.0, 1.0).expect("a beam");
        let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 4.0, force: 1.0 }]).expect("loads");
        classified(&scene(10.0, supports, load, None))
    };
    assert!(matches!(carried(at(4.0)), Ok(Balance::Neutral { about: 4.0, .. })));
    assert_eq!(carried(vec![Support::built_in(10.0)]), Ok(Balance::Held));
    assert_eq!(carried(vec![Support::simple(1.0), Support::simple(2.0)]), Ok(Balance::Held));
}
