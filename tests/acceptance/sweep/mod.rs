//! Sweeps of one number of a scene, their events, and derivatives of exact answers.

mod derivatives;
mod envelope;
mod events;
mod family;
mod find;
mod find_soft;
mod govern;
mod rows;
mod steps;
mod trains;

use palkki::scene::{Foundation, Load, PointLoad, Scene, Support};
use palkki::sweep::{Event, Sweep};
use palkki_evidence::random;

use crate::scenes::{on_supports, uniform};

/// A beam of length 10 above level ground, with `q l⁴/(384 EI) = 20`: it lies on a zone above ground less deep than 20, on a point
/// above less than 100, and deeper nowhere.
fn regimes(depth: f64) -> Scene {
    uniform(10.0, 10_000.0 / 384.0 / 20.0, 1.0, Foundation::Flat { depth })
}

/// The same with a point load, on supports of the given kind.
fn loaded(supports: Vec<Support>, depth: f64) -> Scene {
    let beam = [10.0, 10_000.0 / 384.0 / 20.0];
    on_supports(beam, &supports, (1.0, &[(5.0, 3.0)]), Some(Foundation::Flat { depth }))
}

/// The events of a sweep.
fn events(scene: &Scene, path: &str, range: [f64; 2], steps: usize) -> Vec<Event> {
    let sweep = Sweep::new(scene, path, range, steps).expect("a sweep");
    sweep.events(&sweep.rows().expect("answers"))
}

/// A random scene with a point load, and ranges of five of its numbers, as `(path, from, to)`.
fn varied(i: u64) -> (Scene, Vec<(String, f64, f64)>) {
    let scene = if i.is_multiple_of(2) { random::scene(i) } else { random::held(i) };
    let length = scene.beam().length();
    let mut point = scene.load().point().to_vec();
    point.insert(0, PointLoad { at: 0.4 * length, force: 0.3 * scene.load().magnitude(length) });
    let load = Load::new(scene.beam(), scene.load().uniform(), scene.load().linear().to_vec(), point.clone());
    let scene = Scene::new(scene.beam().clone(), load.expect("a load"), scene.foundation().cloned()).expect("a scene");
    let stiffness = scene.beam().bending_stiffness();
    let size = scene.load().magnitude(length) * length * length * length / (77.0 * stiffness);
    let supports = scene.beam().supports_as_given();
    let mut paths = vec![
        ("load.point[0].at".to_owned(), 0.01 * length, 0.98 * length),
        ("load.point[0].force".to_owned(), 0.0, 3.0 * point[0].force),
        ("load.uniform".to_owned(), 0.0, 2.0 * scene.load().magnitude(length) / length),
        ("beam.bending_stiffness".to_owned(), 0.3 * stiffness, 5.0 * stiffness),
    ];
    if let Some(support) = supports.last() {
        let path = format!("beam.supports[{}].level", supports.len() - 1);
        paths.push((path, support.level - 0.7 * size, support.level));
    }
    (scene, paths)
}
