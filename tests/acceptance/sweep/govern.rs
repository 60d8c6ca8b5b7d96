//! The governing values of an envelope do not depend on the number of its steps.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::sweep::{Envelope, Sweep};
use palkki::theory;
use palkki_evidence::random::{Random, sample_of};

use super::envelope::gathered;
use super::varied;

/// What governs is the same to six digits.
const DIGITS: f64 = 1e-6;

/// The scene number `i`, the path that is varied, and its range.
fn drawn(i: u64) -> (Scene, String, [f64; 2]) {
    let mut random = Random::new(0x5eed_0046 + i);
    if i.is_multiple_of(5) {
        let (scene, paths) = varied(i);
        let (path, from, to) = paths[random.below(paths.len())].clone();
        return (scene, path, [from, to]);
    }
    let count = 2 + random.below(8);
    let mut places = vec![0.0];
    for _ in 1..count {
        places.push(places[places.len() - 1] + random.between(1.0, 4.0));
    }
    let length = places[places.len() - 1];
    let sleepers = i % 5 == 1 && 2 < count;
    let support = |at: &f64| Support { level: 0.0, pushes_only: i % 5 == 2, ..Support::simple(*at) };
    let supports = if sleepers { Vec::new() } else { places.iter().map(support).collect() };
    let beam = Beam::new(length, 100.0).and_then(|beam| beam.with_supports(supports)).expect("a beam");
    let axles = 1 + random.below(3);
    let mut point = vec![PointLoad { at: 0.0, force: random.between(1.0, 10.0) }];
    for k in 1..axles {
        point.push(PointLoad {
            at: point[k - 1].at + random.between(0.1, 0.2) * length,
            force: random.between(1.0, 10.0),
        });
    }
    let room = length - point[point.len() - 1].at;
    let paths = (0..axles).map(|k| format!("load.point[{k}].at")).collect::<Vec<_>>().join(",");
    let load = Load::new(&beam, random.between(1.0, 3.0), Vec::new(), point).expect("a load");
    let ground = match i % 5 {
        // Sleepers that give: tops 0.2 wide.
        1 if sleepers => {
            let tops = places.iter().flat_map(|x| [[x - 0.1, 1.0], [x - 0.1, 0.0], [x + 0.1, 0.0], [x + 0.1, 1.0]]);
            let mut points: Vec<[f64; 2]> = tops.filter(|[x, _]| 0.0 < *x && *x < length).collect();
            points.insert(0, [0.0, 0.0]);
            points.push([length, 0.0]);
            Some(Foundation::Polyline { points })
        }
        3 => Some(Foundation::Cosine { mean: 0.06, amplitude: 0.05, wavelength: 0.3 * length, phase: 1.0 }),
        _ => None,
    };
    let scene = Scene::new(beam, load, ground).expect("a scene");
    let scene = if sleepers { scene.on_springs(1e4).expect("a stiffness") } else { scene };
    (scene, paths, [0.02 * room, 0.98 * room])
}

/// The governing moments and forces of supports, greatest and least in turn, with their values.
fn governing(envelope: &Envelope) -> Vec<[f64; 2]> {
    let moments = [&envelope.governing.moment_max, &envelope.governing.moment_min].map(|m| [m.moment, m.value]);
    let supports = envelope.supports.iter().flat_map(|s| [[s.max, s.max_value], [s.min, s.min_value]]);
    moments.into_iter().chain(supports).collect()
}

/// The same numbers of one value.
fn at(sweep: &Sweep<'_>, value: f64) -> Option<Vec<f64>> {
    let exact = theory::solve(&sweep.scene(value).ok()?).ok().filter(|exact| exact.solved)?;
    let supports = exact.state.supports.iter().flat_map(|support| [support.force; 2]);
    Some([exact.state.moment.max, exact.state.moment.min].into_iter().chain(supports).collect())
}

/// What is wrong with the envelopes of scene `i`.
fn wrong(i: u64) -> Vec<String> {
    const POSITIONS: u32 = 1500;
    let (scene, path, range) = drawn(i);
    let found: Vec<Vec<[f64; 2]>> = [11, 21, 41, 101]
        .into_iter()
        .map(|steps| {
            let sweep = Sweep::new(&scene, &path, range, steps).expect("a sweep");
            governing(&gathered(&sweep).envelope().expect("there are rows"))
        })
        .collect();
    let sweep = Sweep::new(&scene, &path, range, 2).expect("a sweep");
    let places = (0..=POSITIONS).map(|k| range[0] + (range[1] - range[0]) * f64::from(k) / f64::from(POSITIONS));
    let all: Vec<Vec<f64>> = places.filter_map(|value| at(&sweep, value)).collect();
    let mut wrong = Vec::new();
    for k in 0..found[0].len() {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        let brute = all.iter().map(|numbers| sign * numbers[k]).fold(f64::NEG_INFINITY, f64::max);
        let pair = |numbers: &[[f64; 2]]| numbers[k - k % 2][0].abs().max(numbers[k - k % 2 + 1][0].abs());
        let size = pair(&found[0]);
        for (steps, numbers) in [11, 21, 41, 101].into_iter().zip(&found) {
            let [number, value] = numbers[k];
            let off = (number - found[0][k][0]).abs() / size;
            let below = (brute - sign * number) / size;
            let there = at(&sweep, value).map_or(f64::INFINITY, |numbers| (numbers[k] - number).abs() / size);
            if DIGITS < off || DIGITS < below || 1e-9 < there {
                wrong.push(format!("{i} {path}, {k}, {steps} steps: {number} at {value}, {off:e} {below:e} {there:e}"));
            }
        }
    }
    wrong
}

#[test]
fn what_governs_does_not_depend_on_the_steps() {
    let wrong: Vec<String> = std::thread::scope(|scope| {
        let part =
            |first: usize| move || (0..sample_of(100)).skip(first).step_by(2).flat_map(wrong).collect::<Vec<_>>();
        let threads = [0, 1].map(|first| scope.spawn(part(first)));
        threads.into_iter().flat_map(|thread| thread.join().expect("no panic")).collect()
    });
    assert!(wrong.is_empty(), "{wrong:#?}");
}
