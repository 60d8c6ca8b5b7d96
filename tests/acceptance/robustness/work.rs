//! Scene files below 64 KB that once took minutes: what they cost is counted, and does not depend on the machine.

use palkki::adaptive::{Request, adapt};
use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::sweep::{MOST_WORK, Sweep};
use palkki::{Settings, solve_raw, theory};
use palkki_evidence::random::{Random, sample_of};

const LENGTH: f64 = 100.0;

fn scene(stiffness: f64, uniform: f64, point: Vec<PointLoad>, foundation: Foundation) -> Scene {
    let beam = Beam::new(LENGTH, stiffness).expect("a beam");
    let load = Load::new(&beam, uniform, Vec::new(), point).expect("a load");
    Scene::new(beam, load, Some(foundation)).expect("a scene")
}

/// Ground by so many equal segments, with this depth at a share of the beam.
fn survey(segments: u32, mut depth: impl FnMut(f64) -> f64) -> Foundation {
    let shares = (0..=segments).map(|i| f64::from(i) / f64::from(segments));
    Foundation::Polyline { points: shares.map(|t| [LENGTH * t, depth(t)]).collect() }
}

/// One scene of each kind: rough and smooth surveys, up to a thousand waves, 1750 point loads, seven coefficients, nothing special.
fn kinds() -> Vec<(&'static str, Scene)> {
    let turn = std::f64::consts::TAU;
    let mut random = Random::new(13);
    let rough = survey(2000, |_| random.between(0.5, 0.8));
    let hard = |t: f64| 1.0 - 0.5 * (turn * t).cos() + 0.01 * (30.0 * turn * t).sin();
    let points = (0..1750).map(|_| PointLoad { at: random.between(0.0, LENGTH), force: random.between(-0.5, 2.0) });
    let points: Vec<PointLoad> = points.collect();
    let wavelength = LENGTH / sample_of(1000.0);
    let waves = |amplitude| Foundation::Cosine { mean: 1.0, amplitude, wavelength, phase: 0.0 };
    let coefficients = (0..=6).map(|j| random.between(0.1, 1.0) / (0.5 * LENGTH).powi(j)).collect();
    vec![
        ("plain", scene(13.0, 1.0, Vec::new(), Foundation::Flat { depth: 1.0 })),
        ("rough survey", scene(1.0, 10.0, Vec::new(), rough)),
        ("smooth survey", scene(10.0, 1.0, Vec::new(), survey(4000, |t| 1.0 - 0.5 * (turn * t).cos()))),
        ("smooth survey in contact", scene(1.0, 100.0, Vec::new(), survey(2600, hard))),
        ("waves", scene(100.0, 1.0, Vec::new(), waves(0.3))),
        ("waves in contact", scene(1.0, 1000.0, Vec::new(), waves(1e-3))),
        ("point loads", scene(10.0, 0.0, points, Foundation::Flat { depth: 1.0 })),
        ("polynomial", scene(10.0, 10.0, Vec::new(), Foundation::Polynomial { coefficients })),
    ]
}

/// By force and place of many loads; on ground that gives each derivative is a solve of its own, in as many parts, of which a limit leaves
/// some out: of 1,700 loads so many that no more than its unknowns are computed. What there is to compute is by depth, both stiffnesses,
/// uniform load, loads, and levels and, on rigid ground, places of two supports.
#[test]
fn derivatives_by_many_loads_are_little_work() {
    const MANY: u32 = 1700;
    const MOST_UNKNOWNS: usize = 20_000_000;
    let rigid = |loads: u32| {
        let at = |i: u32| LENGTH * (f64::from(i) + 0.5) / f64::from(loads);
        let point = (0..loads).map(|i| PointLoad { at: at(i), force: 1.0 }).collect();
        scene(10.0, 1.0, point, Foundation::Flat { depth: 1.0 })
    };
    let springs = |loads: u32| rigid(loads).on_springs(100.0).expect("ground");
    for (scene, all) in [(rigid(MANY), 2 * MANY + 7), (springs(10), 2 * 10 + 6)] {
        let exact = theory::solve(&scene).expect("an answer");
        let (computed, left_out) = exact.derivatives_and_left_out(&scene);
        assert_eq!((computed.len(), left_out), (all as usize, 0));
    }
    // What is computed is all but what is left out: a list is cut in two.
    let scene = springs(MANY);
    let (computed, left_out) = theory::solve(&scene).expect("an answer").derivatives_and_left_out(&scene);
    let computed = computed.len();
    assert_eq!(computed + left_out, 2 * MANY as usize + 6);
    assert!(0 < left_out && 4 * MANY as usize * computed <= MOST_UNKNOWNS, "{computed} and {left_out}");
}

/// Twice what was counted at the most: lists of contacts and Newton steps of the exact solution, solves of the whole grid by the
/// active set (how often its unknowns are gone through), unknowns on all grids of an adaptive run.
const LISTS: usize = 64;
const STEPS: usize = 2000;
const SOLVES: usize = 60;
const ADAPTED: usize = 12_000_000;

#[test]
fn small_files_are_little_work() {
    for (kind, scene) in kinds() {
        let exact = theory::solve(&scene).expect("an answer");
        let [lists, steps] = [exact.lists, exact.iterations];
        assert!(lists <= LISTS && steps <= STEPS, "{kind}: {lists} lists, {steps} steps");
        for method in Method::ALL {
            for intervals in [30, 10_000] {
                let raw = solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).expect("an answer");
                assert!(
                    raw.run.work <= SOLVES * raw.unknowns,
                    "{kind}, {method}, {intervals} intervals: {}",
                    raw.run.work
                );
            }
        }
        let adapted = adapt(&scene, &Request::new(Method::Force, Solver::ActiveSet, 1e-3)).expect("an answer");
        let work: usize = adapted.trials.iter().map(|trial| trial.work).sum();
        assert!(work <= ADAPTED, "{kind}: {work}");
    }
}

/// A search through tens of thousands of samples counts as work, or a sweep of such answers has no end: waves, and a force of `10¹³` on a
/// support that is raised by `10¹⁰`.
#[test]
fn the_samples_of_a_search_are_work() {
    let (length, at) = (8.727_194_418_120_849, 0.410_305_173_698_997_7);
    let supports = [(at, -20_576_904_475.283_4), (1.745_438_883_624_17, 0.0)]
        .map(|(at, level)| Support { level, ..Support::simple(at) });
    let beam = Beam::new(length, 974.225_927_544_029_6).and_then(|beam| beam.with_supports(supports.to_vec()));
    let beam = beam.expect("a beam");
    let point =
        [(0.410_305_173_698_995_8, 1.0), (at, 7.637_535_102_195_078e12)].map(|(at, force)| PointLoad { at, force });
    let load = Load::new(&beam, 0.0, Vec::new(), point.to_vec()).expect("a load");
    let waves = Foundation::Cosine {
        mean: 0.007_394_203_718_527_087,
        amplitude: 0.001_679_536_333_641_294_4,
        wavelength: 4.935_057_725_763_338,
        phase: 2.759_607_504_056_789,
    };
    let hard = theory::solve(&Scene::new(beam, load, Some(waves)).expect("a scene")).expect("in range");
    let plain = scene(13.0, 1.0, Vec::new(), Foundation::Flat { depth: 1.0 });
    let plain = theory::solve(&plain).expect("in range");
    assert!(100 * plain.work() < hard.work(), "{} and {}", plain.work(), hard.work());
}

/// Bounds on ground that gives count as what they take: the rows of a limited sweep are over in some ten seconds, of which each took 5 ms
/// where they were timed.
#[test]
fn rows_are_counted_as_what_they_take() {
    /// A count is no clock: it may be off by a half.
    const MISCOUNTED: f64 = 1.5;
    const ROWS: f64 = 2000.0;
    let level = scene(13.0, 1.0, Vec::new(), Foundation::Flat { depth: 1.0 }).on_springs(1e12).expect("ground");
    let sweep = Sweep::new(&level, "load.uniform", [1.0, 2.0], 3).expect("a number");
    let mut walk = sweep.walk();
    let step = walk.solve(1.0).expect("an answer");
    walk.row(step);
    let most = MOST_WORK / walk.work();
    assert!(u32::try_from(most).is_ok_and(|most| f64::from(most) <= MISCOUNTED * ROWS), "{most} rows");
}
