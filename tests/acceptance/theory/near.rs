//! Places that nearly coincide: a load beside a kink, a step or a place of contact, from the last bit to a millionth of the
//! beam away from it.

use palkki::scene::{Foundation, LinearLoad, Scene, Support};
use palkki::theory::{Exact, solve};
use palkki::verdict::{Demand, Status, Verdict};
use palkki_evidence::draft::Draft;

use crate::scenes::on_supports;

const LENGTH: f64 = 12.0;

/// A load that moves by a share of the beam changes the energy by some hundred times this share of it.
const SENSITIVITY: f64 = 1e3;
/// Digits of the energy that rounding leaves.
const DIGITS: f64 = 1e-11;

/// A ridge by points, a step, waves and a bowl.
fn foundations() -> [Foundation; 4] {
    let ridge = [0.45, 0.3844, 0.3375, 0.3094, 0.3, 0.3094, 0.3375, 0.3844, 0.45];
    let places = (0..9).map(|i| 1.5 * f64::from(i));
    let step = [[0.0, 0.4], [6.0, 0.4], [6.0, 0.3], [9.0, 0.3], [9.0, 0.5], [12.0, 0.5]];
    [
        Foundation::Polyline { points: places.zip(ridge).map(|(x, depth)| [x, depth]).collect() },
        Foundation::Polyline { points: step.to_vec() },
        Foundation::Cosine { mean: 0.3, amplitude: 0.05, wavelength: 4.0, phase: 0.3 },
        Foundation::Polynomial { coefficients: vec![0.05, 0.08, -0.08 / LENGTH] },
    ]
}

/// The beam above a foundation, without load.
fn above(foundation: &Foundation) -> Draft {
    Draft { length: LENGTH, stiffness: 400.0, uniform: 10.0, ground: Some(foundation.clone()), ..Draft::default() }
}

/// Under loads that act or end at a place: one that presses, one that lifts, and the end of a distributed one.
fn loaded(foundation: &Foundation, at: f64) -> [Draft; 3] {
    let linear = vec![LinearLoad { from: at - 2.0, to: at, start: 200.0, end: 100.0 }];
    let draft = above(foundation);
    [draft.clone().with_points(&[(at, 300.0)]), draft.clone().with_points(&[(at, -20.0)]), Draft { linear, ..draft }]
}

fn solved(draft: &Draft) -> Exact {
    solve(&draft.scene().expect("a scene")).expect("an answer")
}

#[test]
fn a_load_may_lie_beside_any_place() {
    let shares = [1e-15, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6];
    for foundation in foundations() {
        for at in [4.0, 6.0, 9.0_f64] {
            let here = loaded(&foundation, at).map(|draft| solved(&draft).state.energy);
            let mut places = vec![at, at.next_up(), at.next_down()];
            places.extend(shares.iter().flat_map(|share| [at - share * LENGTH, at + share * LENGTH]));
            for x in places {
                for (draft, energy) in loaded(&foundation, x).iter().zip(here) {
                    let beside = solved(draft);
                    let what = format!("{foundation:?}, load at {x:?} beside {at}");
                    assert!(beside.solved, "{what}: {:?}", beside.violations);
                    let allowed = DIGITS + SENSITIVITY * (x - at).abs() / LENGTH;
                    assert!((beside.state.energy / energy - 1.0).abs() <= allowed, "{what}: {}", beside.state.energy);
                }
            }
        }
    }
}

#[test]
fn a_force_beside_a_kink_has_the_energy_of_one_on_it() {
    let [ridge, ..] = foundations();
    for at in [9.0, 9.000_000_000_000_01] {
        let [force, ..] = loaded(&ridge, at);
        let energy = solved(&force).state.energy;
        assert!((energy - -127.265_820_8).abs() < 1e-6, "{energy} for a force at {at}");
    }
}

/// Beside the left support numbers are as close as `5·10⁻³²⁴`, beside the other one they are not.
#[test]
fn a_load_beside_the_left_support_is_at_it() {
    for foundation in foundations() {
        for x in [0.0_f64.next_up(), 1e-300, 1e-40, 1e-17] {
            let point = |at: f64| above(&foundation).with_points(&[(at, -300.0)]);
            let linear = |from: f64, to: f64| Draft {
                linear: vec![LinearLoad { from, to, start: 100.0, end: 300.0 }],
                ..above(&foundation)
            };
            let pairs = [
                [point(x), point(0.0)],
                [linear(x, LENGTH), linear(0.0, LENGTH)],
                [linear(0.0, x), above(&foundation)],
            ];
            for [beside, at] in pairs.map(|pair| pair.map(|draft| solved(&draft))) {
                assert!(beside.solved, "{foundation:?}, {x:e}: {:?}", beside.violations);
                assert!((beside.state.energy / at.state.energy - 1.0).abs() <= DIGITS, "{foundation:?}, {x:e}");
                let [left, held] = [&beside, &at].map(|exact| exact.state.reactions.left);
                assert!((left - held).abs() <= 1e-9 * held.abs(), "{foundation:?}, {x:e}: {left} and {held}");
            }
        }
    }
}

/// Two supports at a distance `δ` whose levels differ by `h` bend the span of length `L` beside them by
///
/// ```text
/// v'' = κ = 3 h/(δ (L + δ)) at the support between,     J = ½ EI κ² (L + δ)/3
/// ```
#[test]
fn the_energy_of_supports_beside_each_other_has_its_digits() {
    const ROUNDING: f64 = 1e-13;
    let (middle, level, stiffness) = (4.0, 0.001, 400.0);
    for share in [1e-3, 1e-5, 1e-6, 1e-8] {
        let last = middle + share * LENGTH;
        let supports = [Support::simple(0.0), Support::simple(middle), Support::simple(last).at_level(level)];
        let answer = solve(&on_supports([LENGTH, stiffness], &supports, (0.0, &[]), None)).expect("an answer");
        let curvature = 3.0 * level / ((last - middle) * last);
        let energy = 0.5 * stiffness * curvature * curvature * last / 3.0;
        let found = answer.state.energy;
        assert!((found / energy - 1.0).abs() <= ROUNDING, "{share}: {found}, not {energy}");
    }
}

/// A force `P` at a distance `b` from an end.
struct Beside {
    length: f64,
    b: f64,
    right: bool,
    built_in: bool,
    /// Over all of `b`, and not at one place.
    spread: bool,
}

impl Beside {
    const FORCE: f64 = 3.0;
    const STIFFNESS: f64 = 20.0;

    fn scene(&self) -> Scene {
        let &Self { length, b, right, built_in, spread } = self;
        let support = if built_in { Support::built_in } else { Support::simple };
        let supports = Some(vec![support(0.0), support(length)]);
        let draft = Draft { length, stiffness: Self::STIFFNESS, supports, ..Draft::default() };
        let at = if right { length - b } else { b };
        let [from, to] = if right { [at, length] } else { [0.0, at] };
        let [start, end] = [Self::FORCE / b; 2];
        let draft = match spread {
            false => draft.with_points(&[(at, Self::FORCE)]),
            true => Draft { linear: vec![LinearLoad { from, to, start, end }], ..draft },
        };
        draft.scene().expect("a scene")
    }

    /// The largest deflection.
    ///
    /// ```text
    /// P b (l² − b²)^1.5 / 9√3 l EI     simple     2 P a³ b² / 3 EI (3a + b)²     built in, a = l − b
    /// ```
    ///
    /// What is spread acts at its middle, and has a third of the fixed-end moment at the other end, but for terms of the order `b/l`.
    fn largest(&self) -> f64 {
        let &Self { length, b, built_in, spread, .. } = self;
        if built_in {
            let (a, share) = (length - b, if spread { 1.0 / 3.0 } else { 1.0 });
            share * 2.0 * Self::FORCE * a.powi(3) * b * b / (3.0 * Self::STIFFNESS * (3.0 * a + b).powi(2))
        } else {
            let b = if spread { 0.5 * b } else { b };
            Self::FORCE * b * (length * length - b * b).powf(1.5) / (9.0 * 3.0_f64.sqrt() * length * Self::STIFFNESS)
        }
    }
}

/// Nearly all of such a load goes into the support, and the rest bends the beam: of a force that is known to ten digits and more beside
/// a simple support and a built-in end alike, and what is claimed of it is true.
#[test]
fn a_load_right_beside_a_support_bends_the_beam() {
    // What is lost where the pieces of a span still meet in its middle: six digits of sixteen.
    const CLOSE: f64 = 1e-10;
    for length in [1.0, 10.0, 12.7] {
        for share in [1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 2e-3] {
            for (right, built_in, spread) in (0..8).map(|k| (k & 1 == 1, k & 2 == 2, k & 4 == 4)) {
                // As it is in 64 bits.
                let b = if right { length - (length - share * length) } else { share * length };
                let beside = Beside { length, b, right, built_in, spread };
                let (scene, expected) = (beside.scene(), beside.largest());
                let exact = solve(&scene).expect("an answer");
                // A share of what is found, as what is claimed is.
                let off = (expected / exact.state.deflection.max - 1.0).abs();
                let verdict = Verdict::of_exact(&scene, &exact, &Demand::default());
                let what = format!("{length}, {share}, right {right}, built in {built_in}, spread {spread}");
                let formula = if spread { 4.0 * share } else { 0.0 } + 1e-14;
                assert!(off <= verdict.error + formula, "{what}: off by {off:e}, and {:e} is claimed", verdict.error);
                if !spread {
                    assert!(off <= CLOSE, "{what}: off by {off:e}");
                    assert!(!right || built_in || verdict.status == Status::Certified, "{what}: {verdict}");
                }
            }
        }
    }
}

/// A load over a few units in the last place, and nothing else: over them it changes by what it is. At the end of an overhang, inside
/// a span and beside a support, its force is its mean times its length, and the shear force is the same from there to the support.
#[test]
fn a_load_over_a_few_last_units_has_its_force() {
    let supports = Some(vec![Support::simple(2.0), Support::simple(6.0)]);
    let beam = Draft { length: 10.0, stiffness: 3.0, supports, ..Draft::default() };
    for (end, sides) in [(10.0, [6.5, 8.5]), (4.7, [5.0, 5.9]), (6.0, [2.5, 4.0]), (1.3, [1.4, 1.9])] {
        let mut from: f64 = end;
        for units in 1..=6 {
            from = from.next_down();
            let linear = vec![LinearLoad { from, to: end, start: 5.0, end: -1.0 }];
            let scene = Draft { linear, ..beam.clone() }.scene().expect("a scene");
            let exact = solve(&scene).expect("in range");
            let (force, state) = (2.0 * (end - from), &exact.state);
            let right = force * (end - 2.0) / 4.0;
            for (found, expected) in [(state.supports[1].force, right), (state.supports[0].force, force - right)] {
                assert!((found - expected).abs() <= 1e-13 * force, "{end}, {units}: {found:e} for {expected:e}");
            }
            let [left, right] = sides.map(|x| exact.shear(x)[0]);
            assert!((left - right).abs() <= 1e-13 * force, "{end}, {units}: {left:e} and {right:e}");
        }
    }
}

/// Under an axial force, a load from the last bit to a millionth of the beam beside a change of the bending stiffness and another load: the bounds
/// are as narrow as where it acts at the same place.
#[test]
fn a_load_under_an_axial_force_may_lie_beside_any_place() {
    for (tension, at) in [-20.0, 0.5, 300.0, 30_000.0].into_iter().flat_map(|n| [(n, 3.0), (n, 4.5_f64)]) {
        let mut places = vec![at, at.next_up(), at.next_down()];
        places.extend(
            [1e-13, 1e-10, 1e-8, 1e-6].into_iter().flat_map(|share| [at - share * LENGTH, at + share * LENGTH]),
        );
        for x in places {
            let text = format!(
                "[beam]\nlength = 12.0\nbending_stiffness = {{ steps = [[0, 400.0], [3.0, 600.0]] }}\ntension = {tension}\n\
                 supports = [{{ at = 0 }}, {{ at = 9 }}, {{ at = 12 }}]\n[load]\nuniform = 10.0\n\
                 point = [{{ at = {x:?}, force = 30.0 }}, {{ at = 4.5, force = -5.0 }}]\n"
            );
            let solution = palkki::solve_exactly(&super::general::scene(&text)).expect("an answer");
            assert_eq!(solution.verdict.status, Status::Certified, "{}\n{text}", solution.verdict);
        }
    }
    // The last cell is the short one, before a support.
    let text = "[beam]\nlength = 12.0\nbending_stiffness = 400.0\ntension = 20.0\n[load]\npoint = [{ at = 11.999999999, force = 1e3 }]\n";
    let solution = palkki::solve_exactly(&super::general::scene(text)).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}\n{text}", solution.verdict);
}
