//! One test for every variant of `SceneError`, with the place that a scene file gives it.

use palkki::scene::{Beam, Foundation, Grid, LinearLoad, Load, Scene};

use super::message;

#[test]
fn not_positive() {
    insta::assert_snapshot!(message("length = 10.0", "length = -10"), @"
    error: `beam.length` must be positive and finite, but is -10
     --> scene.toml:5:10
      |
    5 | length = -10
      |          ^^^
    ");
}

#[test]
fn not_positive_and_too_long_to_write_out() {
    insta::assert_snapshot!(message("length = 10.0", "length = -1e300"), @"
    error: `beam.length` must be positive and finite, but is -1e300
     --> scene.toml:5:10
      |
    5 | length = -1e300
      |          ^^^^^^
    ");
}

#[test]
fn not_positive_because_zero() {
    insta::assert_snapshot!(message("bending_stiffness = 1.3", "bending_stiffness = 0"), @"
    error: `beam.bending_stiffness` must be positive and finite, but is 0
     --> scene.toml:6:21
      |
    6 | bending_stiffness = 0
      |                     ^
    ");
}

#[test]
fn not_positive_because_nan() {
    insta::assert_snapshot!(message("length = 10.0", "length = nan"), @"
    error: `beam.length` must be positive and finite, but is NaN
     --> scene.toml:5:10
      |
    5 | length = nan
      |          ^^^
    ");
}

#[test]
fn not_positive_wavelength() {
    let cosine = "cosine = { mean = 1.0, amplitude = 0.3, wavelength = 0.0 }";
    insta::assert_snapshot!(message("depth = 1.0", cosine), @"
    error: `foundation.cosine.wavelength` must be positive and finite, but is 0
      --> scene.toml:14:54
       |
    14 | cosine = { mean = 1.0, amplitude = 0.3, wavelength = 0.0 }
       |                                                      ^^^
    ");
}

#[test]
fn not_finite() {
    insta::assert_snapshot!(message("uniform = 1.0", "uniform = nan"), @"
    error: `load.uniform` must be finite, but is NaN
     --> scene.toml:9:11
      |
    9 | uniform = nan
      |           ^^^
    ");
}

#[test]
fn not_finite_deep_inside() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [5, -inf], [10, 1]]"), @"
    error: `foundation.points[1][1]` must be finite, but is -inf
      --> scene.toml:14:23
       |
    14 | points = [[0, 1], [5, -inf], [10, 1]]
       |                       ^^^^
    ");
}

#[test]
fn outside_the_beam() {
    insta::assert_snapshot!(message("at = 5.0", "at = 10.5"), @"
    error: `load.point[0].at` must lie on the beam, between 0 and 10, but is 10.5
      --> scene.toml:11:17
       |
    11 | point = [{ at = 10.5, force = 3.0 }]
       |                 ^^^^
    ");
}

#[test]
fn empty_load() {
    insta::assert_snapshot!(message("from = 2.0, to = 5.0", "from = 5.0, to = 2.0"), @"
    error: `load.linear[0].to` must be greater than the start of the load, 5, but is 2
      --> scene.toml:10:30
       |
    10 | linear = [{ from = 5.0, to = 2.0, start = 0.0, end = 1.0 }]
       |                              ^^^
    ");
}

#[test]
fn no_coefficients() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = []"), @"
    error: `foundation.polynomial` needs at least one coefficient, but has none
      --> scene.toml:14:14
       |
    14 | polynomial = []
       |              ^^
    ");
}

#[test]
fn too_few_points() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1]]"), @"
    error: a foundation given by points needs at least 2 of them, but has 1
      --> scene.toml:14:10
       |
    14 | points = [[0, 1]]
       |          ^^^^^^^^
    ");
}

#[test]
fn points_run_back() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [6, 1], [5, 1], [10, 1]]"), @"
    error: `foundation.points[2][0]` must not be less than the place of the point before it, 6, but is 5
      --> scene.toml:14:28
       |
    14 | points = [[0, 1], [6, 1], [5, 1], [10, 1]]
       |                            ^
    ");
}

#[test]
fn three_points_at_one_place() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1], [5, 1], [5, 2], [5.0, 3], [10, 1]]"), @"
    error: `foundation.points[3][0]` is the third point at x = 5: two points make a step, more have no meaning
      --> scene.toml:14:36
       |
    14 | points = [[0, 1], [5, 1], [5, 2], [5.0, 3], [10, 1]]
       |                                    ^^^
    ");
}

#[test]
fn points_do_not_cover_the_beam() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0.5, 1], [10, 1]]"), @"
    error: a foundation given by points must reach from 0 to 10, but `foundation.points[0][0]` is 0.5
      --> scene.toml:14:12
       |
    14 | points = [[0.5, 1], [10, 1]]
       |            ^^^
    ");
}

#[test]
fn foundation_above_a_support() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = [1.0, -0.2]"), @"
    error: the foundation must not lie above a support, but its depth at the support x = 10 is -1, above the level 0 of the support; no deflection satisfies the supports and the foundation
      --> scene.toml:14:14
       |
    14 | polynomial = [1.0, -0.2]
       |              ^^^^^^^^^^^
    ");
}

#[test]
fn foundation_above_a_support_by_a_point() {
    insta::assert_snapshot!(message("depth = 1.0", "points = [[0, 1],\n  [10, -1]]"), @"
    error: the foundation must not lie above a support, but its depth at the support x = 10 is -1, above the level 0 of the support; no deflection satisfies the supports and the foundation
      --> scene.toml:15:8
       |
    15 |   [10, -1]]
       |        ^^
    ");
}

#[test]
fn overflow_of_all_loads_together() {
    insta::assert_snapshot!(message("uniform = 1.0", "uniform = 1e308"), @"
    error: `load` leads to numbers beyond the range of 64-bit floating point (the sum of all loads is inf)
     --> scene.toml:8:1
      |
    8 | [load]
      | ^^^^^^
    ");
}

#[test]
fn overflow_of_the_foundation() {
    insta::assert_snapshot!(message("depth = 1.0", "polynomial = [1, 1e308, 1e308]"), @"
    error: `foundation` leads to numbers beyond the range of 64-bit floating point (a bound on its depth is inf)
      --> scene.toml:14:14
       |
    14 | polynomial = [1, 1e308, 1e308]
       |              ^^^^^^^^^^^^^^^^^
    ");
}

#[test]
fn overflow_of_the_units() {
    insta::assert_snapshot!(message("bending_stiffness = 1.3", "bending_stiffness = 1e-307"), @"
    error: `beam.bending_stiffness` leads to numbers beyond the range of 64-bit floating point (the unit of depth is inf)
     --> scene.toml:6:21
      |
    6 | bending_stiffness = 1e-307
      |                     ^^^^^^
    ");
}

/// The one error that comes from a grid and not from a file.
#[test]
fn too_few_intervals() {
    let beam = Beam::new(10.0, 1.3).expect("a valid beam");
    let scene = Scene::new(beam, Load::default(), None).expect("a valid scene");
    insta::assert_snapshot!(Grid::uniform(&scene, 0).expect_err("no intervals"), @"the number of intervals must be at least 2, but is 0");
    insta::assert_snapshot!(Grid::uniform(&scene, 1).expect_err("no interior node"), @"the number of intervals must be at least 2, but is 1");
}

// The same rules without a file.

#[test]
fn constructors_name_quantity_value_and_requirement() {
    let beam = Beam::new(10.0, 1.3).expect("a valid beam");
    let backwards = LinearLoad { from: 3.0, to: 3.0, start: 1.0, end: 1.0 };
    insta::assert_snapshot!(Beam::new(f64::INFINITY, 1.3).expect_err("infinite length"), @"`beam.length` must be positive and finite, but is inf");
    insta::assert_snapshot!(Load::new(&beam, 0.0, vec![backwards], vec![]).expect_err("no length"), @"`load.linear[0].to` must be greater than the start of the load, 3, but is 3");
    insta::assert_snapshot!(Foundation::Flat { depth: -0.5 }.checked(&beam).expect_err("above the supports"), @"the foundation must not lie above a support, but its depth at the support x = 0 is -0.5, above the level 0 of the support; no deflection satisfies the supports and the foundation");
}
