//! What can be wrong with supports and with the own shape, with the place that a scene file gives it.

use palkki::scene::file::parse;
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};

use super::message;

const STIFFNESS: &str = "bending_stiffness = 1.3";

/// The message for the valid scene with one more line in `[beam]`.
#[track_caller]
fn with(line: &str) -> String {
    message(STIFFNESS, &format!("{STIFFNESS}\n{line}"))
}

#[test]
fn two_supports_at_one_place() {
    insta::assert_snapshot!(with("supports = [{ at = 4 }, { at = 10 }, { at = 4.0, level = 0.1 }]"), @"
    error: `beam.supports[2].at` is 4, and another support is at x = 4: two supports must be more than 2.2e-9 apart
     --> scene.toml:7:45
      |
    7 | supports = [{ at = 4 }, { at = 10 }, { at = 4.0, level = 0.1 }]
      |                                             ^^^
    ");
}

#[test]
fn two_supports_nearly_at_one_place() {
    insta::assert_snapshot!(with("supports = [{ at = 4.000000001, level = 0.1 }, { at = 10 }, { at = 4 }]"), @"
    error: `beam.supports[2].at` is 4, and another support is at x = 4.000000001: two supports must be more than 2.2e-9 apart
     --> scene.toml:7:68
      |
    7 | supports = [{ at = 4.000000001, level = 0.1 }, { at = 10 }, { at = 4 }]
      |                                                                    ^
    ");
    let beam = |distance: f64| {
        let supports = vec![Support::simple(4.0), Support::simple(4.0 + distance)];
        Beam::new(10.0, 1.3).and_then(|beam| beam.with_supports(supports))
    };
    assert!(beam(2.2e-9).is_err() && beam(2.3e-9).is_ok());
}

#[test]
fn a_support_outside_the_beam() {
    insta::assert_snapshot!(with("supports = [{ at = 0 }, { at = 10.5 }]"), @"
    error: `beam.supports[1].at` must lie on the beam, between 0 and 10, but is 10.5
     --> scene.toml:7:32
      |
    7 | supports = [{ at = 0 }, { at = 10.5 }]
      |                                ^^^^
    ");
}

#[test]
fn a_level_that_is_no_number() {
    insta::assert_snapshot!(with("supports = [{ at = 0, level = nan }, { at = 10 }]"), @"
    error: `beam.supports[0].level` must be finite, but is NaN
     --> scene.toml:7:31
      |
    7 | supports = [{ at = 0, level = nan }, { at = 10 }]
      |                               ^^^
    ");
}

#[test]
fn a_slope_without_built_in() {
    insta::assert_snapshot!(with("supports = [{ at = 0, slope = 0.1 }, { at = 10 }]"), @"
    error: `beam.supports[0].slope` must not be there: a support holds a slope only with `built_in = true`
     --> scene.toml:7:31
      |
    7 | supports = [{ at = 0, slope = 0.1 }, { at = 10 }]
      |                               ^^^ expected `built_in = true` beside it, or no slope
    ");
    insta::assert_snapshot!(with("supports = [{ at = 0, built_in = 1 }]"), @"
    error: `beam.supports[0].built_in` must be true or false, but is the integer 1
     --> scene.toml:7:34
      |
    7 | supports = [{ at = 0, built_in = 1 }]
      |                                  ^
    ");
}

#[test]
fn unknown_and_missing_keys_of_a_support() {
    insta::assert_snapshot!(with("supports = [{ at = 0, depth = 0.1 }]"), @r#"
    error: unknown key "depth" in `beam.supports[0]`
     --> scene.toml:7:23
      |
    7 | supports = [{ at = 0, depth = 0.1 }]
      |                       ^^^^^ expected one of `at`, `level`, `built_in`, `slope`
    "#);
    insta::assert_snapshot!(with("supports = [{ level = 0.1 }]"), @"
    error: the key `at` is missing in `beam.supports[0]`
     --> scene.toml:7:13
      |
    7 | supports = [{ level = 0.1 }]
      |             ^^^^^^^^^^^^^^^ expected `at = …`, a number
    ");
    insta::assert_snapshot!(with("supports = { at = 0 }"), @"
    error: `beam.supports` must be an array of supports { at = … }, but is a table
     --> scene.toml:7:12
      |
    7 | supports = { at = 0 }
      |            ^^^^^^^^^^
    ");
}

#[test]
fn a_foundation_above_an_inner_support() {
    insta::assert_snapshot!(with("supports = [{ at = 0 }, { at = 4, level = 1.5 }, { at = 10 }]"), @"
    error: the foundation must not lie above a support, but its depth at the support x = 4 is 1, above the level 1.5 of the support; no deflection satisfies the supports and the foundation
     --> scene.toml:7:25
      |
    7 | supports = [{ at = 0 }, { at = 4, level = 1.5 }, { at = 10 }]
      |                         ^^^^^^^^^^^^^^^^^^^^^^^
    ");
}

#[test]
fn ground_that_rises_against_a_built_in_end() {
    insta::assert_snapshot!(with("supports = [{ at = 0, built_in = true, level = 1.0, slope = 0.1 }]"), @"
    error: the foundation must not rise above a beam that is built in, but at the built-in support x = 0, where it is level with the beam, its slope to the right of it is 0, and that of the beam is 0.1; no deflection satisfies both
     --> scene.toml:7:13
      |
    7 | supports = [{ at = 0, built_in = true, level = 1.0, slope = 0.1 }]
      |             ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    ");
    insta::assert_snapshot!(with("supports = [{ at = 10, built_in = true, level = 1.0, slope = -0.1 }]"), @"
    error: the foundation must not rise above a beam that is built in, but at the built-in support x = 10, where it is level with the beam, its slope to the left of it is 0, and that of the beam is -0.1; no deflection satisfies both
     --> scene.toml:7:13
      |
    7 | supports = [{ at = 10, built_in = true, level = 1.0, slope = -0.1 }]
      |             ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    ");
    // On the level, and the ground falls off: well posed.
    let supports = |slope: f64| vec![Support { at: 0.0, level: 1.0, slope: Some(slope) }];
    for slope in [0.0, -0.1] {
        let beam = Beam::new(10.0, 1.3).and_then(|beam| beam.with_supports(supports(slope))).expect("a beam");
        assert!(Foundation::Flat { depth: 1.0 }.checked(&beam).is_ok(), "{slope}");
    }
}

#[test]
fn an_own_shape_is_checked_as_a_foundation_is() {
    insta::assert_snapshot!(with("shape = { points = [[0, 0.0], [9, 0.1]] }"), @"
    error: an own shape given by points must reach from 0 to 10, but `beam.shape.points[1][0]` is 9
     --> scene.toml:7:32
      |
    7 | shape = { points = [[0, 0.0], [9, 0.1]] }
      |                                ^
    ");
    insta::assert_snapshot!(with("shape = { points = [[0, 0.0]] }"), @"
    error: an own shape given by points needs at least 2 of them, but has 1
     --> scene.toml:7:20
      |
    7 | shape = { points = [[0, 0.0]] }
      |                    ^^^^^^^^^^
    ");
    insta::assert_snapshot!(with("shape = { points = [[0, 0.0], [4, 0.1], [4, 0.2], [10, 0.0]] }"), @"
    error: `beam.shape.points[2][0]` is the second point at x = 4: the axis of a beam has no step
     --> scene.toml:7:42
      |
    7 | shape = { points = [[0, 0.0], [4, 0.1], [4, 0.2], [10, 0.0]] }
      |                                          ^
    ");
    insta::assert_snapshot!(with("shape = { polynomial = [] }"), @"
    error: `beam.shape.polynomial` needs at least one coefficient, but has none
     --> scene.toml:7:24
      |
    7 | shape = { polynomial = [] }
      |                        ^^
    ");
    insta::assert_snapshot!(with("shape = { cosine = { mean = 0, amplitude = 1, wavelength = 0 } }"), @"
    error: `beam.shape.cosine.wavelength` must be positive and finite, but is 0
     --> scene.toml:7:60
      |
    7 | shape = { cosine = { mean = 0, amplitude = 1, wavelength = 0 } }
      |                                                            ^
    ");
    insta::assert_snapshot!(with("shape = { }"), @"
    error: `beam.shape` has none of the keys `depth`, `polynomial`, `cosine`, `points`, `survey`
     --> scene.toml:7:9
      |
    7 | shape = { }
      |         ^^^ expected exactly one of them, or no `beam.shape` at all
    ");
    insta::assert_snapshot!(with("shape = { depth = 0, polynomial = [0.0] }"), @"
    error: `beam.shape` has 2 keys that each give an own shape: `depth`, `polynomial`
     --> scene.toml:7:35
      |
    7 | shape = { depth = 0, polynomial = [0.0] }
      |                                   ^^^^^ expected exactly one of them
    ");
}

#[test]
fn a_corner_at_a_built_in_support() {
    let shape = "shape = { points = [[0, 0.0], [4, 0.5], [10, 0.0]] }";
    insta::assert_snapshot!(with(&format!("{shape}\nsupports = [{{ at = 4, built_in = true }}]")), @"
    error: the own shape must not have a corner at a built-in support, which holds the slope, but has one at x = 4
     --> scene.toml:8:13
      |
    8 | supports = [{ at = 4, built_in = true }]
      |             ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    ");
}

#[test]
fn loads_that_nothing_balances() {
    let text = super::EVERY_KEY.replacen(STIFFNESS, &format!("{STIFFNESS}\nsupports = []"), 1).replacen(
        "uniform = 1.0",
        "uniform = -1.0",
        1,
    );
    insta::assert_snapshot!(super::message_of(&text), @"
    error: the loads pull upwards by 5.5: nothing holds the beam down
     --> scene.toml:7:12
      |
    7 | supports = []
      |            ^^
    ");
}

/// A survey of the axis has errors of its own, in its own file.
#[test]
fn a_survey_of_the_axis() {
    let text = super::EVERY_KEY.replacen(STIFFNESS, &format!("{STIFFNESS}\nshape = {{ survey = 'axis.csv' }}"), 1);
    let survey = "x,depth\n0,0\n4,0.1\n11,0\n";
    let error = parse("site/scene.toml", &text, |_| Ok(survey.to_owned())).expect_err("beyond the beam");
    insta::assert_snapshot!(error.to_string(), @"
    error: `x` must lie on the beam, between 0 and 10, but is 11
     --> site/axis.csv:4:1
      |
    4 | 11,0
      | ^^
    ");
}

/// What is read is what was written.
#[test]
fn supports_and_shape_are_read() {
    let lines = "supports = [{ at = 10 }, { at = 0.0, built_in = true, slope = 0.05 }, { at = 4.0, level = 0.3 }]\n\
                 shape = { polynomial = [0.0, -0.051, 0.03] }";
    let text =
        super::EVERY_KEY.replacen(STIFFNESS, &format!("{STIFFNESS}\n{lines}"), 1).replacen("depth = 1", "depth = 9", 1);
    let scene = parse("scene.toml", &text, |_| Ok(String::new())).expect("a scene");
    let expected =
        [Support { at: 0.0, level: 0.0, slope: Some(0.05) }, Support::simple(4.0).at_level(0.3), Support::simple(10.0)];
    assert_eq!(scene.beam().supports(), expected);
    let held = scene.held();
    let asked: Vec<(f64, Option<f64>)> = held.iter().map(|held| (held.deflection, held.slope)).collect();
    let own = |x: f64| (0.03 * x - 0.051) * x;
    let close = |a: f64, b: f64| (a - b).abs() < 1e-15;
    assert!(close(asked[0].0, 0.0) && asked[0].1.is_some_and(|slope| close(slope, 0.05 + 0.051)), "{asked:?}");
    assert!(close(asked[1].0, 0.3 - own(4.0)) && close(asked[2].0, -own(10.0)), "{asked:?}");
    assert!(close(scene.gap(2.0), 9.0 - own(2.0)));
    assert!(!scene.beam().is_simple());
}

/// Scaling changes exponents only, and what is not held is so in every unit.
#[test]
fn supports_are_scaled_by_powers_of_two() {
    let supports = vec![Support { at: 0.0, level: -0.3, slope: Some(0.7) }, Support::simple(7.0).at_level(0.1)];
    let shape = Foundation::Polynomial { coefficients: vec![0.1, 0.2, -0.3] };
    let beam = Beam::new(10.0, 1.3).and_then(|b| b.with_supports(supports)).and_then(|b| b.with_shape(shape));
    let beam = beam.expect("a beam");
    let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 3.0, force: 700.0 }]).expect("a load");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 50.0 })).expect("a scene");
    let scaled = scene.scaled().expect("in range");
    let (length, depth) = (scaled.scale.length, scaled.scale.depth);
    for (scaled, held) in scaled.scene.held().iter().zip(scene.held()) {
        let again = [scaled.at * length, scaled.deflection * depth];
        assert_eq!(again.map(f64::to_bits), [held.at, held.deflection].map(f64::to_bits));
        assert_eq!(scaled.slope.map(|slope| (slope * (depth / length)).to_bits()), held.slope.map(f64::to_bits));
    }
    let gap = scaled.scene.gap(3.0 / length) * depth;
    assert_eq!(gap.to_bits(), scene.gap(3.0).to_bits());
}
