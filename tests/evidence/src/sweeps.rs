//! Sweeps of random scenes of all kinds over random numbers of theirs: whatever the number of rows and the direction, the events have
//! to be the same, and the rows have to follow from them.

use palkki::scene::{Foundation, LinearLoad, Load, PointLoad, Scene};
use palkki::sweep::{Event, Sweep};
use palkki::theory::{self, Exact, Pattern};

use crate::random::{self, Random};

/// Numbers of rows that are compared.
pub const STEPS: [usize; 3] = [3, 101, 1009];

/// A scene, the path of a number of it, and a range.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// The scene.
    pub scene: Scene,
    /// The path.
    pub path: String,
    /// The range.
    pub range: [f64; 2],
}

/// Number `i` of the family.
#[must_use]
pub fn drawn(i: u64) -> Drawn {
    let mut random = Random::new(0x0005_3eeb_0000 + i);
    loop {
        let seed = random.bits() % 1_000_000;
        let scene = match i % 5 {
            0 => random::held(seed),
            1 => random::on_lattice(seed),
            2 => random::scene(seed),
            _ => random::scene(seed),
        };
        let scene = if i % 5 == 4 { waved(&mut random, &scene) } else { Some(scene) };
        let Some(scene) = scene.and_then(|scene| loaded(&mut random, &scene)) else { continue };
        let paths = paths(&mut random, &scene);
        let (path, range) = paths[random.below(paths.len())].clone();
        let range = if random.once_in(2) { range } else { [range[1], range[0]] };
        let drawn = Drawn { scene, path, range };
        let Ok(sweep) = Sweep::new(&drawn.scene, &drawn.path, drawn.range, 3) else { continue };
        if rows(&sweep).is_some_and(|rows| rows.len() == 3) {
            return drawn;
        }
    }
}

/// The scene above steep waves, of which it touches some.
fn waved(random: &mut Random, scene: &Scene) -> Option<Scene> {
    let length = scene.beam().length();
    let load = scene.load().magnitude(length);
    let sag = load * length * length * length / (77.0 * scene.beam().bending_stiffness());
    let amplitude = sag * random.between(0.05, 0.9);
    let mean = amplitude + sag * random.between(0.0, 0.3);
    let wavelength = length / random.between(3.0, 25.0);
    let waves = Foundation::Cosine { mean, amplitude, wavelength, phase: random.between(0.0, 6.0) };
    Scene::new(scene.beam().clone(), scene.load().clone(), Some(waves)).ok()
}

/// The scene with a point load and a linear one.
fn loaded(random: &mut Random, scene: &Scene) -> Option<Scene> {
    let length = scene.beam().length();
    let load = scene.load().magnitude(length);
    let mut point = scene.load().point().to_vec();
    point.insert(0, PointLoad { at: random.between(0.1, 0.9) * length, force: random.between(-0.1, 0.4) * load });
    let mut linear = scene.load().linear().to_vec();
    let (a, b) = (random.between(0.0, length), random.between(0.0, length));
    let size = load / length;
    linear.insert(
        0,
        LinearLoad { from: a.min(b), to: a.max(b), start: random.between(0.0, size), end: random.between(0.0, size) },
    );
    let load = Load::new(scene.beam(), scene.load().uniform(), linear, point).ok()?;
    Scene::new(scene.beam().clone(), load, scene.foundation().cloned()).ok()
}

/// Numbers of a scene with ranges.
fn paths(random: &mut Random, scene: &Scene) -> Vec<(String, [f64; 2])> {
    let length = scene.beam().length();
    let stiffness = scene.beam().bending_stiffness();
    let load = scene.load().magnitude(length);
    let sag = load * length * length * length / (77.0 * stiffness);
    let mut paths = vec![
        ("load.point[0].at".to_owned(), [0.01 * length, 0.98 * length]),
        ("load.point[0].force".to_owned(), [-0.3 * load, load]),
        ("load.uniform".to_owned(), [0.0, 2.0 * load / length]),
        ("load.linear[0].start".to_owned(), [-load / length, 2.0 * load / length]),
        ("load.linear[0].to".to_owned(), [scene.load().linear()[0].from + 0.01 * length, length]),
        ("beam.bending_stiffness".to_owned(), [0.3 * stiffness, 5.0 * stiffness]),
    ];
    let supports = scene.beam().supports_as_given();
    if !supports.is_empty() {
        let k = random.below(supports.len());
        let level = supports[k].level;
        paths.push((format!("beam.supports[{k}].level"), [level - 0.7 * sag, level]));
        let at = supports[k].at;
        if 0.0 < at && at < length {
            paths.push((format!("beam.supports[{k}].at"), [at - 0.02 * length, at + 0.02 * length]));
        }
    }
    match scene.foundation() {
        Some(&Foundation::Flat { depth }) => paths.push(("foundation.depth".to_owned(), [depth, depth + sag])),
        Some(&Foundation::Cosine { mean, amplitude, wavelength, phase }) => paths.extend([
            ("foundation.cosine.mean".to_owned(), [mean, mean + sag]),
            ("foundation.cosine.amplitude".to_owned(), [0.0, amplitude]),
            ("foundation.cosine.wavelength".to_owned(), [wavelength, 1.1 * wavelength]),
            ("foundation.cosine.phase".to_owned(), [phase, phase + 0.5]),
        ]),
        Some(Foundation::Polynomial { coefficients }) => {
            paths.push(("foundation.polynomial[0]".to_owned(), [coefficients[0], coefficients[0] + sag]));
        }
        Some(Foundation::Polyline { points }) => {
            let k = random.below(points.len());
            paths.push((format!("foundation.points[{k}].depth"), [points[k][1], points[k][1] + sag]));
        }
        None => {}
    }
    paths
}

/// The kinds of the rows of a sweep, as far as there are answers; [`None`] if one of these is not solved.
#[must_use]
pub fn rows(sweep: &Sweep<'_>) -> Option<Vec<(f64, Pattern)>> {
    let mut last: Option<Exact> = None;
    let mut rows = Vec::new();
    for value in sweep.values() {
        let Ok(scene) = sweep.scene(value) else { return Some(rows) };
        let exact = theory::solve_near(&scene, last.as_ref().as_slice()).ok()?;
        if exact.solved {
            rows.push((value, exact.pattern()));
        }
        last = Some(exact);
    }
    Some(rows)
}

/// What two searches for events differ by, beyond `tolerance`, a share of the range.
#[must_use]
pub fn difference(a: &[Event], b: &[Event], range: [f64; 2], tolerance: f64) -> Option<String> {
    let span = (range[1] - range[0]).abs();
    if a.len() != b.len() {
        let lone = |a: &[Event], b: &[Event]| {
            let has = |event: &Event| b.iter().any(|other| (other.value - event.value).abs() <= 1e-6 * span);
            a.iter()
                .filter(|event| !has(event))
                .map(|event| format!("{} {}", event.value, event.what))
                .collect::<Vec<_>>()
        };
        return Some(format!("{} and {} events: {:?} and {:?}", a.len(), b.len(), lone(a, b), lone(b, a)));
    }
    let worst =
        a.iter().zip(b).max_by(|x, y| (x.0.value - x.1.value).abs().total_cmp(&(y.0.value - y.1.value).abs()))?;
    let off = (worst.0.value - worst.1.value).abs() / span;
    // What says of itself that it is known less well is counted by `uncertain`.
    if tolerance.max(2.0 * (worst.0.uncertainty + worst.1.uncertainty) / span) < off {
        return Some(format!("{off:e}: {} and {}: {}", worst.0.value, worst.1.value, worst.0.what));
    }
    // Where the value is uncertain the places in the words are so too, and the words are to be the same without them.
    let alike = |a: &Event, b: &Event| {
        let certain = a.uncertainty + b.uncertainty <= 0.0;
        let said = |c: &char| certain || !(c.is_ascii_digit() || *c == '.');
        a.what.chars().filter(said).eq(b.what.chars().filter(said))
    };
    let words = a.iter().zip(b).find(|(a, b)| !alike(a, b))?;
    Some(format!("words: {} {} / {}", words.0.value, words.0.what, words.1.what))
}

/// What is wrong with the events of number `i`: other ones with other numbers of rows, or in the other direction, or rows whose kinds
/// differ without an event between them. With the number of events.
#[must_use]
pub fn faults(i: u64, tolerance: f64) -> (usize, Vec<String>) {
    let Drawn { scene, path, range } = drawn(i);
    let mut wrong = Vec::new();
    let mut found: Vec<Vec<Event>> = Vec::new();
    let mut look = |range: [f64; 2], steps: usize| -> Vec<Event> {
        let sweep = Sweep::new(&scene, &path, range, steps).expect("a sweep");
        let Some(rows) = rows(&sweep) else { return Vec::new() };
        let events = sweep.events_within(&rows, u64::MAX).events;
        let close = 1e-9 * (range[1] - range[0]).abs();
        for pair in rows.windows(2) {
            let (lo, hi) = (pair[0].0.min(pair[1].0) - close, pair[0].0.max(pair[1].0) + close);
            if !pair[0].1.is_same_kind(&pair[1].1)
                && !events
                    .iter()
                    .any(|event| lo <= event.value + event.uncertainty && event.value - event.uncertainty <= hi)
            {
                wrong.push(format!("{i} {path} {steps} steps: no event from {} to {}", pair[0].0, pair[1].0));
            }
        }
        events
    };
    for steps in STEPS {
        found.push(look(range, steps));
    }
    let mut back = look([range[1], range[0]], STEPS[0]);
    back.reverse();
    let name = format!("{i} {path} {range:?}");
    for (other, steps) in found.iter().zip(STEPS).skip(1) {
        wrong.extend(
            difference(&found[0], other, range, tolerance).map(|text| format!("{name}: {steps} steps: {text}")),
        );
    }
    // In the other direction the words are others.
    let worded = |events: &[Event]| -> Vec<Event> {
        events.iter().map(|event| Event { value: event.value, what: String::new(), ..event.clone() }).collect()
    };
    let backwards = difference(&worded(&found[0]), &worded(&back), range, tolerance);
    wrong.extend(backwards.map(|text| format!("{name}: backwards: {text}")));
    (found[0].len(), wrong)
}
