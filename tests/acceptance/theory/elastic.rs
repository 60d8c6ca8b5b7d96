//! Elastic foundations as they are met: pipes on a surveyed sea bed, rails under many axles, free beams, and things that all but meet. Each
//! answer is certified.

use std::f64::consts::TAU;

use palkki::route::Status;
use palkki::scene::{Foundation, Scene, Support};
use palkki::sweep::Sweep;
use palkki::{Solution, solve_exactly};
use palkki_evidence::draft::Draft;
use palkki_evidence::random::{Random, sample_of};
use palkki_evidence::soil::Pipe;

/// What is certified of a beam on springs of a stiffness, or why nothing is.
fn certified(draft: &Draft, stiffness: f64) -> Result<Solution, String> {
    certified_on(&on_springs(draft, stiffness))
}

fn on_springs(draft: &Draft, stiffness: f64) -> Scene {
    draft.scene().and_then(|scene| scene.on_springs(stiffness)).expect("a scene")
}

/// The same of a scene that is on springs.
fn certified_on(scene: &Scene) -> Result<Solution, String> {
    let solution = solve_exactly(scene).map_err(|error| error.to_string())?;
    let what = solution.verdict.to_string();
    if solution.verdict.status == Status::Certified { Ok(solution) } else { Err(what) }
}

/// Contact and supports carry the load to a billionth.
#[track_caller]
fn in_equilibrium(solution: &Solution, load: f64) {
    let state = &solution.state;
    let carried = state.supports.iter().fold(state.contact_force(), |sum, support| sum + support.force);
    assert!((carried - load).abs() <= 1e-9 * load, "{carried} for {load}");
}

/// A beam of 10 on ground in straight lines: a step down, or a corner, at 3.
fn above(points: [[f64; 2]; 4]) -> Draft {
    let ground = Some(Foundation::Polyline { points: points.to_vec() });
    Draft { length: 10.0, stiffness: 1000.0, uniform: 1.0, ground, supports: Some(Vec::new()), ..Draft::default() }
}

const STEP: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [10.0, 1.0]];
const CORNER: [[f64; 2]; 4] = [[0.0, 0.3], [3.0, 0.0], [6.0, 0.1], [10.0, 0.3]];

/// A load beside a step, a load beside a corner, a support beside a corner, and two loads beside each other, from 0.1 to a rounding apart.
#[test]
fn things_that_all_but_meet_are_certified() {
    let mut lost = Vec::new();
    for half in 0..30 {
        for side in [-1.0, 1.0] {
            let x = 3.0 + side * libm::pow(10.0, -1.0 - 0.5 * f64::from(half));
            let support = vec![Support::simple(x).at_level(-0.01)];
            let scenes = [
                ("a load beside a step", above(STEP).with_points(&[(x, 3.0)])),
                ("a load beside a corner", above(CORNER).with_points(&[(x, 3.0)])),
                ("a support beside a corner", Draft { supports: Some(support), ..above(CORNER) }),
                ("two loads", above(CORNER).with_points(&[(3.0, 3.0), (x, 2.0)])),
            ];
            for (what, draft) in scenes {
                lost.extend(certified(&draft, 100.0).err().map(|why| format!("{what}, {x:?}: {why}")));
            }
        }
    }
    assert!(lost.is_empty(), "{} of 240: {lost:#?}", lost.len());
}

/// Beams without supports, with a load inside, at a tip, or at both tips, on soft and on stiff level ground: most of them press in one part.
#[test]
fn free_beams_with_loads_anywhere_are_certified() {
    let count = sample_of(400);
    for seed in 0..count {
        let mut random = Random::new(seed);
        let mut power = |from: f64, to: f64| libm::pow(10.0, random.between(from, to));
        let [length, stiffness, ground, uniform] =
            [power(-1.0, 2.0), power(-1.0, 4.0), power(-1.0, 5.0), power(-2.0, 1.0)];
        let mut force = |x: f64| (x, uniform * length * power(-2.0, 1.0));
        let loads = match seed % 3 {
            0 => vec![force(length * 0.37)],
            1 => vec![force(length)],
            _ => vec![force(0.0), force(length)],
        };
        let level = Some(Foundation::Flat { depth: 0.0 });
        let free = Draft { length, stiffness, uniform, ground: level, supports: Some(Vec::new()), ..Draft::default() };
        let draft = free.with_points(&loads);
        let solution = certified(&draft, ground).unwrap_or_else(|why| panic!("{seed}: {why}, {}", draft.text()));
        in_equilibrium(&solution, loads.iter().fold(uniform * length, |sum, load| sum + load.1));
    }
}

/// A rail of 100 to 1000 m under 40 axles: the error does not grow with its length.
#[test]
fn long_rails_under_many_axles_are_certified() {
    for length in [100.0, 200.0, 400.0, 1000.0] {
        let axles: Vec<(f64, f64)> = (0..40).map(|i| (length * (f64::from(i) + 0.5) / 40.0, 1e5)).collect();
        let level = Some(Foundation::Flat { depth: 0.0 });
        let rail = Draft {
            length,
            stiffness: 6.4e6,
            uniform: 600.0,
            ground: level,
            supports: Some(Vec::new()),
            ..Draft::default()
        };
        let solution = certified(&rail.with_points(&axles), 3e7).unwrap_or_else(|why| panic!("{length}: {why}"));
        let error = solution.verdict.largest_error();
        assert!(error <= 1e-7, "{length}: {error:e}");
        in_equilibrium(&solution, 600.0 * length + 4e6);
    }
}

/// Surveys of 500 to 3,000 readings, most cells of which hang, some by less than a millionth of the beam.
#[test]
fn pipes_on_surveyed_soil_are_certified() {
    for (readings, seeds) in [(500, 4), (1000, 4), (2000, 3), (3000, 2)] {
        for seed in 0..seeds {
            let pipe = Pipe { length: 1000.0, readings, seed, soil: 5e5 };
            let solution = certified_on(&pipe.scene().expect("a scene"));
            let solution = solution.unwrap_or_else(|why| panic!("{readings}, {seed}: {why}"));
            let error = solution.verdict.largest_error();
            assert!(error <= 1e-8, "{readings}, {seed}: {error:e}");
            in_equilibrium(&solution, pipe.weight());
        }
    }
}

/// Of pipes of 3 km on stiff soil what rounding pulls is carried by what is pressed beside it: from end to end that would be an error of 7e-7.
#[test]
fn long_pipes_on_stiff_soil_are_certified() {
    for (soil, most) in [(1e7, 1e-8), (1e9, 1e-7)] {
        let pipe = Pipe { length: 3000.0, readings: 10_000, seed: 1, soil };
        let solution = certified_on(&pipe.scene().expect("a scene")).unwrap_or_else(|why| panic!("{soil:e}: {why}"));
        let error = solution.verdict.largest_error();
        assert!(error <= most, "{soil:e}: {error:e}");
        in_equilibrium(&solution, pipe.weight());
    }
}

/// A soft pipe of 2 km on a wavy bed of 1,001 readings: its stretches are found to the last digits.
#[test]
fn a_soft_pipe_of_two_kilometres_is_certified() {
    let point = |i: u32| {
        let x = 2.0 * f64::from(i);
        [x, 10.0 + libm::sin(TAU * x / 90.0) + 0.3 * libm::sin(TAU * x / 31.0)]
    };
    let ground = Some(Foundation::Polyline { points: (0..=1000).map(point).collect() });
    let pipe = Draft {
        length: 2000.0,
        stiffness: 54_100.0,
        uniform: 25.0,
        ground,
        supports: Some(Vec::new()),
        ..Draft::default()
    };
    let solution = certified(&pipe, 46.0).unwrap_or_else(|why| panic!("{why}"));
    in_equilibrium(&solution, 5e4);
}

/// A wheel along 25 m of rail, in 41 and in 101 steps: each row is certified, and begins from the one before, which takes a third of the solves.
/// Events are the same whatever the steps, and those of a rail that is turned round.
#[test]
fn a_wheel_along_a_rail_has_all_events() {
    const LENGTH: f64 = 25.0;
    let level = Some(Foundation::Flat { depth: 0.0 });
    let rail = Draft {
        length: LENGTH,
        stiffness: 6.4e6,
        uniform: 600.0,
        ground: level,
        supports: Some(Vec::new()),
        ..Draft::default()
    };
    let wheel = rail.with_points(&[(0.0, 1e5)]);
    let scene = wheel.scene().and_then(|scene| scene.on_springs(3e7)).expect("a scene");
    let events = |steps: usize| {
        let sweep = Sweep::new(&scene, "load.point[0].at", [0.0, LENGTH], steps).expect("a sweep");
        let rows = sweep.rows().expect("answers");
        let (mut near, mut alone) = (0, 0);
        for row in &rows {
            let status = row.solution.verdict.status;
            assert_eq!(status, Status::Certified, "{}: {}", row.value, row.solution.verdict);
            let scene = sweep.scene(row.value).expect("a scene");
            let exact = palkki::theory::solve(&scene).expect("an answer");
            let apart = (exact.state.energy - row.solution.state.energy).abs();
            assert!(apart <= 1e-11 * exact.state.energy.abs(), "{}: {apart:e}", row.value);
            near += row.solution.run.iterations;
            alone += exact.iterations;
        }
        assert!(2 * near < alone, "{near} of {alone} solves");
        sweep.events(&rows).iter().map(|event| event.value).collect::<Vec<_>>()
    };
    let [few, many] = [41, 101].map(events);
    assert!(!few.is_empty() && few.len() == many.len(), "{few:?} {many:?}");
    for ((few, many), mirrored) in few.iter().zip(&many).zip(few.iter().rev()) {
        assert!((few - many).abs() <= 1e-9 * LENGTH, "{few} in 41 steps, {many} in 101");
        assert!((few + mirrored - LENGTH).abs() <= 1e-9 * LENGTH, "{few} and {mirrored}");
    }
}

/// The largest share of the largest moment that a bracket of the greatest or the least one takes. The moments themselves are inside.
#[track_caller]
fn moment_brackets(what: &str, scene: &Scene) -> f64 {
    let solution = certified_on(scene).unwrap_or_else(|why| panic!("{what}: {why}"));
    let moment = solution.state.moment;
    let size = moment.max.max(-moment.min);
    let [greatest, least] = solution.verdict.certificate.as_ref().expect("bounds").moments;
    let share = |(bracket, value): (Option<[f64; 2]>, f64)| {
        let [lo, hi] = bracket.unwrap_or_else(|| panic!("{what}: no bounds"));
        // Fifteen digits are printed.
        assert!(lo <= value + 1e-15 * size && value - 1e-15 * size <= hi, "{what}: {value} in {bracket:?}");
        (hi - lo) / size
    };
    [(greatest, moment.max), (least, moment.min)].map(share).into_iter().fold(0.0, f64::max)
}

/// Pipes of 300 to 3,000 readings, and a rail under many axles: the moments are proven to some eight digits. A bracket is as wide as the root of
/// the gap, and of 2,000 readings one pair has a gap a million times as large as the others.
#[test]
fn moments_on_soil_are_proven_to_many_digits() {
    let mut wide = Vec::new();
    let cases = [(300, 4, 1e-8), (500, 3, 1e-8), (1000, 3, 2e-8), (2000, 2, 1e-5), (3000, 2, 2e-7)];
    for (readings, seeds, most) in cases {
        for seed in 0..seeds {
            let pipe = Pipe { length: 1000.0, readings, seed, soil: 5e5 };
            let share = moment_brackets(&format!("{readings}, {seed}"), &pipe.scene().expect("a scene"));
            wide.extend((most < share).then(|| format!("{readings}, {seed}: {share:e}")));
        }
    }
    let level = Some(Foundation::Flat { depth: 0.0 });
    let free = Draft { length: 1000.0, ground: level, supports: Some(Vec::new()), ..Draft::default() };
    let axles: Vec<(f64, f64)> = (0..40).map(|i| (25.0 * (f64::from(i) + 0.5), 1e5)).collect();
    let rail = Draft { stiffness: 6.4e6, uniform: 600.0, ..free }.with_points(&axles);
    let share = moment_brackets("rail", &on_springs(&rail, 3e7));
    wide.extend((2e-8 < share).then(|| format!("rail: {share:e}")));
    assert!(wide.is_empty(), "{wide:#?}");
}

/// A free beam with a force at its middle, at three quarters and at its tip, from soil so soft that it sinks by 10¹⁵ times its length on: each is
/// certified, and the moments are proven by statics, however soft the soil is.
#[test]
fn moments_on_soft_soil_follow_from_statics() {
    let mut wide = Vec::new();
    for k in [1e-12, 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 100.0, 1e4] {
        for at in [1.0, 1.5, 2.0] {
            let level = Some(Foundation::Flat { depth: 0.0 });
            let draft = Draft {
                length: 2.0,
                stiffness: 1e7,
                uniform: 500.0,
                ground: level,
                supports: Some(Vec::new()),
                ..Draft::default()
            };
            let share = moment_brackets(&format!("{k:e}, {at}"), &on_springs(&draft.with_points(&[(at, 1000.0)]), k));
            wide.extend((2e-7 < share).then(|| format!("{k:e}, {at}: {share:e}")));
        }
    }
    assert!(wide.is_empty(), "{wide:#?}");
}
