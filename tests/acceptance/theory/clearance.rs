//! The largest and the least clearance, which figures name: those of the solution along the whole beam, and not of samples.

use std::path::Path;

use palkki::plot::{self, Curves};
use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::state::Extremes;
use palkki::theory::{Exact, solve};
use palkki_evidence::random;

use crate::scenes;

/// Samples that no extreme may miss: far more than a figure has.
const SAMPLES: u32 = 4001;

/// Rounding of a clearance, as a share of the largest depth.
const ROUNDING: f64 = 1e-12;

/// The scene `report/scenes/held/<name>.toml`.
fn held(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("report/scenes/held").join(name).with_extension("toml");
    let text = std::fs::read_to_string(path).expect("a scene of the report");
    parse(name, &text, |_| Err(ReadProblem::Missing)).expect("a valid scene")
}

#[track_caller]
fn is_beyond_every_sample(name: &str, scene: &Scene, exact: &Exact) {
    let length = scene.beam().length();
    let found = exact.clearance_extremes(0.0, length);
    let slack = ROUNDING * found.magnitude().max(exact.state.deflection.magnitude());
    for i in 0..=SAMPLES {
        let x = length * f64::from(i) / f64::from(SAMPLES);
        let h = exact.clearance(x);
        assert!(found.min - slack <= h && h <= found.max + slack, "{name}: {h} at {x} is beyond {found:?}");
    }
    // What is named is the clearance there, on one side of the place.
    for (at, value) in [(found.max_at, found.max), (found.min_at, found.min)] {
        let beside = [-1e-9, 0.0, 1e-9].map(|off| exact.clearance((at + off * length).clamp(0.0, length)));
        let nearest = beside.iter().map(|h| (h - value).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= 1e-6 * found.magnitude(), "{name}: {value} at {at}, where it is {beside:?}");
    }
}

#[test]
fn no_sample_is_beyond_the_extremes() {
    let drawn = (0..40).map(|i| (format!("scene {i}"), random::scene(i)));
    let drawn_held = (0..40).map(|i| (format!("held {i}"), random::held(i)));
    let mut solved = 0;
    for (name, scene) in scenes::report().into_iter().chain(drawn).chain(drawn_held) {
        let Some(exact) = solve(&scene).ok().filter(|exact| exact.solved && scene.foundation().is_some()) else {
            continue;
        };
        is_beyond_every_sample(&name, &scene, &exact);
        solved += 1;
    }
    assert!(60 < solved, "{solved} scenes were solved");
}

/// Beside a step of the ground the clearance comes as near to its largest value as one likes.
#[test]
fn a_figure_names_the_extremes_and_no_sample() {
    for (name, label) in [
        ("table-edge", "h = 2 at x = 6"),
        ("pipe-sleeper", "h = 0.8 m at x = 49 m"),
        ("pipe-step", "h = 0.6 m at x = 24 m"),
    ] {
        let scene = held(name);
        let exact = solve(&scene).expect("an answer");
        let svg = plot::curves(&scene, &Curves::exact(&scene, &exact), "beam theory").expect("a figure");
        assert!(svg.contains(label), "{name}: {label:?} is not in the figure");
    }
}

/// A beam at rest is as far from the ground as that is deep: of equal extremes the left one is named.
#[test]
fn of_equal_extremes_the_left_one_is_named() {
    let points = (0..=20).map(|i| [0.5 * f64::from(i), if i % 2 == 0 { 1.0 } else { 3.0 }]).collect();
    let beam = Beam::new(10.0, 1.0).expect("a beam");
    let scene = Scene::new(beam, Load::default(), Some(Foundation::Polyline { points })).expect("a scene");
    let exact = solve(&scene).expect("an answer");
    for from in (0..10).map(f64::from) {
        let found = exact.clearance_extremes(from, 10.0);
        assert_eq!(found, Extremes { max: 3.0, max_at: from + 0.5, min: 1.0, min_at: from });
    }
}

/// A ski of curvature κ that is pressed flat but for a length a at each tip: the tip touches, and h = q x (a − x)³/(24 EI) with
/// a² = 4 EI κ/q, which is largest at x = a/4.
#[test]
fn between_two_contacts_it_has_its_closed_form() {
    let (stiffness, load, curvature) = (150.0, 400.0, 2.0 * 0.018_518_518_518_518_517);
    let scene = held("ski");
    let exact = solve(&scene).expect("an answer");
    let a = (4.0_f64 * stiffness * curvature / load).sqrt();
    let largest = load / (24.0 * stiffness) * 27.0 * a * a * a * a / 256.0;
    let found = exact.clearance_extremes(0.0, scene.beam().length());
    assert!((found.max / largest - 1.0).abs() < 1e-9, "{} instead of {largest}", found.max);
    assert!((found.max_at / (0.25 * a) - 1.0).abs() < 1e-6, "at {} instead of {}", found.max_at, 0.25 * a);
    let [tip, _, _] = &exact.state.contacts[..] else { panic!("three contacts: {:?}", exact.state.contacts) };
    let nothing = exact.clearance_extremes(tip.to, tip.to);
    assert!(nothing.max <= 0.0, "no stretch, no clearance: {nothing:?}");
}
