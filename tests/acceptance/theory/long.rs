//! Ground by long polynomials: Chebyshev's, `u = m + a T_d(2x/l − 1)`, written in powers of `x`, up to degree 20.
//!
//! Their terms add up to as much as `10¹⁵` times what they are, and the problem is well posed. The reference for a depth is the
//! polynomial with the coefficients that are given, in fractions.

use palkki::route::{Method, Solver, Status};
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, SceneError, Support};
use palkki::{Solution, solve_exactly};
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::number::Number;
use palkki_evidence::extremes::chebyshev;

use crate::scenes::{run, uniform};

/// Coefficients of `m + a T_d(2x/l − 1)`.
fn wave(degree: i32, mean: f64, amplitude: f64, length: f64) -> Vec<f64> {
    let unit = chebyshev(degree.unsigned_abs() as usize);
    let mut coefficients: Vec<f64> = (0..).zip(unit).map(|(j, c)| amplitude * c / length.powi(j)).collect();
    coefficients[0] += mean;
    coefficients
}

/// A beam that `load` times a unit depth would bend by that depth without ground.
fn scene(coefficients: Vec<f64>, length: f64, load: f64) -> Result<Scene, SceneError> {
    let beam = Beam::new(length, 5.0 / 384.0 * length.powi(4)).expect("a beam");
    let load = Load::new(&beam, load, Vec::new(), vec![PointLoad { at: 0.3 * length, force: 0.1 * load * length }]);
    Scene::new(beam, load.expect("a load"), Some(Foundation::Polynomial { coefficients }))
}

fn solved(coefficients: Vec<f64>, length: f64, load: f64) -> Solution {
    let name = format!("{coefficients:?}, load {load}");
    let answer = solve_exactly(&scene(coefficients, length, load).expect("a scene")).expect("an answer");
    assert_eq!(answer.verdict.status, Status::Certified, "{name}: {:?}", answer.verdict);
    answer
}

/// `u(x)` of the coefficients as they are, in fractions.
fn depth(coefficients: &[f64], x: f64) -> f64 {
    let exact = |value: f64| RBig::try_from(value).expect("a finite number");
    let x = exact(x);
    coefficients.iter().rev().fold(RBig::ZERO, |sum, &c| sum * &x + exact(c)).to_double()
}

/// From a beam that touches nothing to one that is pressed into every hollow.
const LOADS: [f64; 4] = [0.1, 3.0, 100.0, 1e5];

#[test]
fn long_polynomials_are_solved_exactly() {
    /// Rounding, as a share of the depths.
    const ROUNDING: f64 = 1e-12;
    for degree in [10, 13, 16, 19, 20] {
        for (mean, amplitude) in [(1.0, 0.9), (1.0, -0.3), (0.05, 0.04), (10.0, 1e-3)] {
            for length in [1.0, 10.0, 1000.0] {
                let coefficients = wave(degree, mean, amplitude, length);
                for load in LOADS {
                    let exact = solved(coefficients.clone(), length, load).exact;
                    let exact = exact.expect("the exact solution");
                    for k in 1..40 {
                        let x = length * f64::from(k) / 40.0;
                        let depth = depth(&coefficients, x);
                        let clearance = depth - exact.deflection(x);
                        assert!(-ROUNDING * mean <= clearance, "degree {degree}, load {load}: {clearance:e} at {x}");
                        let close = (exact.clearance(x) - clearance).abs() <= ROUNDING * mean.max(clearance);
                        assert!(close, "degree {degree}, load {load}, at {x}: {clearance:e}");
                    }
                }
            }
        }
    }
}

/// `T_d(1 − t) = (−1)^d T_d(t)`: with lengths and amplitudes for which the coefficients are exact, the energy is the same.
#[test]
fn the_mirror_image_has_the_same_energy() {
    for degree in [11, 13, 15, 17, 19] {
        for (amplitude, load) in [(0.875, 3.0), (0.25, 100.0), (0.5, 1e5)] {
            for length in [1.0, 1024.0] {
                let [one, other] = [amplitude, -amplitude].map(|amplitude| {
                    let ground = Foundation::Polynomial { coefficients: wave(degree, 1.0, amplitude, length) };
                    let scene = uniform(length, 5.0 / 384.0 * length.powi(4), load, ground);
                    solve_exactly(&scene).expect("an answer").state.energy
                });
                assert!((one / other - 1.0).abs() < 1e-11, "degree {degree}, load {load}: {one} and {other}");
            }
        }
    }
}

/// The methods converge to the exact solution: their error is that of the grid, and not that of depths.
#[test]
fn grids_converge_to_the_exact_solution() {
    for degree in [12, 20] {
        for length in [1.0, 10.0] {
            let coefficients = wave(degree, 1.0, 0.25, length);
            let exact = solved(coefficients.clone(), length, 100.0).state.energy;
            let scene = scene(coefficients, length, 100.0).expect("a scene");
            for method in Method::ALL {
                let off = [200, 400, 800].map(|intervals| {
                    let raw = run(&scene, method, Solver::ActiveSet, intervals);
                    assert!(raw.solved, "degree {degree}, {method}, {intervals}");
                    (raw.state.energy / exact - 1.0).abs()
                });
                assert!(off[2] < 1e-3 && off[2] < 0.5 * off[0], "degree {degree}, {method}: {off:?}");
            }
        }
    }
}

/// At a support a long polynomial is what its coefficients make it: level if that is zero, and above if it is above.
#[test]
fn a_long_polynomial_is_level_where_it_is_zero() {
    for degree in 10..=20 {
        for amplitude in [1.0, -1.0] {
            solved(wave(degree, 1.0, amplitude, 1.0), 1.0, 30.0);
            let above = scene(wave(degree, 1.0 - 1e-9, amplitude, 1.0), 1.0, 30.0);
            // Of an even degree with `a = 1` the polynomial is zero at no support.
            let touches = amplitude < 0.0 || degree % 2 == 1;
            let refused = matches!(above, Err(SceneError::AboveSupport { depth, .. }) if (depth + 1e-9).abs() < 1e-12);
            assert_eq!(refused, touches, "degree {degree}, {amplitude}: {above:?}");
        }
    }
}

/// `[u, u', u'']` of the coefficients as they are, in fractions.
fn jet(coefficients: &[f64], x: f64) -> [f64; 3] {
    let exact = |value: f64| RBig::try_from(value).expect("a finite number");
    let x = exact(x);
    let start = [RBig::ZERO, RBig::ZERO, RBig::ZERO];
    let [u, slope, half] = coefficients
        .iter()
        .rev()
        .fold(start, |[u, slope, half], &c| [&u * &x + exact(c), &slope * &x + u, half * &x + slope]);
    [u, slope, half * RBig::from(2)].map(|value| value.to_double())
}

/// Beside a support, too, depth and slope of a long polynomial are what its coefficients make them: ground below a support is not level
/// with it, and ground that rises where the beam is built in is not along the beam, by far less than the rounding of the terms.
#[test]
fn ground_meets_a_support_as_its_coefficients_say() {
    /// Of a depth and a slope in 64 bits.
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    /// More than what is level but for rounding, and below the rounding of the terms of the higher degrees.
    const BESIDE: f64 = 1e-11;
    for degree in 7..=20 {
        for length in [1.0, 10.0, 1000.0] {
            let coefficients = wave(degree, 1.0, 0.25, length);
            let ground = Foundation::Polynomial { coefficients: coefficients.clone() };
            let above = |support: Support| {
                let beam = Beam::new(length, 1.0).and_then(|beam| beam.with_supports(vec![support])).expect("a beam");
                let load = Load::new(&beam, 1.0, Vec::new(), Vec::new()).expect("a load");
                Scene::new(beam, load, Some(ground.clone()))
            };
            for at in (1..40).map(|k| length * f64::from(k) / 40.0) {
                let name = format!("degree {degree}, at {at} of {length}");
                let [depth, slope, bend] = jet(&coefficients, at);
                for [u, du] in ground.sides(at) {
                    assert!((u - depth).abs() <= ROUNDING * depth, "{name}: {u}, not {depth}");
                    assert!(
                        (du - slope).abs() <= ROUNDING * (slope.abs() + at * bend.abs()),
                        "{name}: {du}, not {slope}"
                    );
                }
                let size = 1.0 + at * slope.abs();
                for (raised, at_level) in [(0.0, true), (BESIDE * size, false)] {
                    let scene = above(Support::simple(at).at_level(depth - raised)).expect("above the ground");
                    assert_eq!(scene.held()[0].at_level, [at_level; 2], "{name}, raised by {raised:e}");
                }
                let along = Support { slope: Some(slope), ..Support::simple(at).at_level(depth) };
                assert_eq!(above(along).expect("along the ground").held()[0].tangent, [true; 2], "{name}");
                let turned = BESIDE * (slope.abs() + at * bend.abs());
                let turned = above(Support { slope: Some(slope + turned), ..along });
                assert!(matches!(turned, Err(SceneError::RisesAtBuiltIn { .. })), "{name}: {turned:?}");
            }
        }
    }
}
