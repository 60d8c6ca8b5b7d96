//! What each algorithm does where full exchanges without a fallback go round in circles, and where contact is hard to find.

use std::collections::BTreeMap;

use palkki::methods::Discrete;
use palkki::paper::{random, scene_over};
use palkki::problem::Programme;
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Foundation, Scene};

use crate::scenes::run;

/// One line of `tests/corpus/exchanges.csv`: the beam and load of the example over a foundation `cosine amplitude wavelength
/// phase` with mean 1, or `polyline` through depths at equal distances.
struct Instance {
    line: &'static str,
    method: Method,
    intervals: usize,
    /// Length of the circle.
    period: usize,
    /// What becomes of the paper's four steps.
    four_step: &'static str,
    scene: Scene,
}

fn corpus() -> Vec<Instance> {
    let instance = |line: &'static str| {
        let fields: Vec<&str> = line.split(',').collect();
        let [method, intervals, period, four_step, foundation] = fields[..] else { panic!("five fields: {line}") };
        let (kind, numbers) = foundation.split_once(' ').expect("a kind and numbers");
        let numbers: Vec<f64> = numbers.split(' ').map(|n| n.parse().expect("a number")).collect();
        let foundation = match (kind, &numbers[..]) {
            ("cosine", &[amplitude, wavelength, phase]) => {
                Foundation::Cosine { mean: 1.0, amplitude, wavelength, phase }
            }
            ("polyline", depths) => {
                let last = u32::try_from(depths.len() - 1).expect("few points");
                let place = |i: u32| 10.0 * f64::from(i) / f64::from(last);
                Foundation::Polyline { points: (0..=last).zip(depths).map(|(i, &u)| [place(i), u]).collect() }
            }
            _ => panic!("a foundation: {line}"),
        };
        Instance {
            line,
            method: Method::ALL.into_iter().find(|m| m.word() == method).expect("a method"),
            intervals: intervals.parse().expect("a number"),
            period: period.parse().expect("a number"),
            four_step,
            scene: scene_over(foundation).expect("a scene"),
        }
    };
    include_str!("../corpus/exchanges.csv").lines().skip(1).map(instance).collect()
}

/// Full exchanges from the face on which all variables are free, without a fallback: the number of solves, or the length of
/// the circle in which they go.
fn full_exchange(programme: &dyn Programme) -> Result<usize, usize> {
    /// Of the size: far above the rounding of these small solves, far below their violations.
    const SIGN: f64 = 1e-12;
    let sizes = programme.sizes();
    let mut free = vec![true; programme.dimension()];
    let mut seen = BTreeMap::new();
    for solves in 1.. {
        if let Some(before) = seen.insert(free.clone(), solves) {
            return Err(solves - before);
        }
        let point = programme.stationary(&free).expect("definite");
        let wrong = |i: &usize| {
            if free[*i] { point.x[*i] < -SIGN * sizes.x } else { point.gradient[*i] < -SIGN * sizes.gradient }
        };
        let violators: Vec<usize> = (0..free.len()).filter(wrong).collect();
        if violators.is_empty() {
            return Ok(solves);
        }
        violators.iter().for_each(|&i| free[i] = !free[i]);
    }
    unreachable!("there are finitely many faces")
}

#[test]
fn full_exchanges_without_a_fallback_go_round_in_circles() {
    for instance in corpus() {
        let scaled = instance.scene.scaled().expect("in range");
        let discrete = Discrete::new(&scaled.scene, instance.intervals).expect("enough intervals");
        let programme = instance.method.programme(&discrete);
        assert_eq!(full_exchange(programme.as_ref()), Err(instance.period), "{}", instance.line);
    }
}

#[test]
fn the_four_steps_end_there_at_the_optimum_or_not() {
    for instance in corpus() {
        let outcome = run(&instance.scene, instance.method, Solver::FourStep, instance.intervals);
        assert_eq!(outcome.status.word(), instance.four_step, "{}", instance.line);
    }
}

#[test]
fn the_active_set_ends_there_at_the_optimum() {
    for instance in corpus() {
        ends(&instance.scene, instance.method, instance.intervals, 100);
    }
}

/// Ends at the optimum, certified, with at most so many solves, those of neighbourhoods counted.
#[track_caller]
fn ends(scene: &Scene, method: Method, intervals: usize, solves: usize) {
    let outcome = run(scene, method, Solver::ActiveSet, intervals);
    let told = format!("{method}, {intervals}: {} solves, residual {:.1e}", outcome.iterations, outcome.residual);
    assert_eq!(outcome.status, Status::Certified, "{told}");
    assert!(outcome.solver_claims_success && outcome.iterations <= solves, "{told}");
}

/// A hump of three straight lines: thousands of exchanges, since its flanks are lost and won again.
#[test]
fn the_triangular_hump_on_ten_thousand_intervals() {
    for (rise, half) in [(0.5, 1.0), (0.1, 2.0), (0.9, 0.1), (0.5, 4.9)] {
        let points = vec![[0.0, 1.0], [5.0 - half, 1.0], [5.0, 1.0 - rise], [5.0 + half, 1.0], [10.0, 1.0]];
        let scene = scene_over(Foundation::Polyline { points }).expect("a hump");
        ends(&scene, Method::Force, 10_000, 60_000);
    }
}

#[test]
fn random_foundations_on_grids_of_all_sizes() {
    let mut numbers = random::Random::new(2);
    for kind in random::Unevenness::ALL {
        for scene in random::scenes(kind, 30, 3).expect("scenes") {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 10 and 501")]
            let intervals = numbers.between(11.0, 501.0) as usize;
            for method in Method::ALL {
                ends(&scene, method, intervals, 5000);
            }
        }
    }
}

/// Flat foundations at the two borders between the regimes, on them and a hair beside them.
#[test]
fn borders_between_regimes() {
    let border = 1e4 / 500.0;
    for share in [1.0, 1.0 - 1e-12, 1.0 + 1e-9, 5.0, 5.0 - 1e-12, 5.0 - 1e-6, 5.0 + 1e-12] {
        let scene = scene_over(Foundation::Flat { depth: share * border }).expect("flat");
        for intervals in [10, 30, 99, 1000] {
            for method in Method::ALL {
                ends(&scene, method, intervals, 500);
            }
        }
    }
}

/// A hundred thousand intervals, verified: the end reaction of beam theory within the error of the grid, residual far below
/// what is certified.
#[test]
fn a_fine_grid_loses_no_digits() {
    /// The residual that the issue of this size is about.
    const RESIDUAL: f64 = 1e-12;
    /// The end reaction converges with the square of the spacing: 2.7e-6 on a thousand intervals.
    const REACTION: f64 = 1e-9;
    let outcome = run(&crate::scenes::example(), Method::Force, Solver::ActiveSet, 100_000);
    assert!(outcome.residual < RESIDUAL, "{:.1e}", outcome.residual);
    let error = outcome.state.reactions.left - palkki::paper::theory().reaction;
    assert!(error.abs() < REACTION, "{error:.1e}");
    assert!(outcome.iterations < 1000, "{} solves, of which all but a few are of neighbourhoods", outcome.iterations);
}
