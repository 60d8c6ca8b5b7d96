//! Events: between them nothing happens, and at them something does.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::sweep::{Event, Sweep};
use palkki::theory::{self, Exact};

use super::{loaded, regimes, varied};

fn events(scene: &Scene, path: &str, range: [f64; 2], steps: usize) -> Vec<Event> {
    let sweep = Sweep::new(scene, path, range, steps).expect("a sweep");
    sweep.events(&sweep.rows().expect("answers"))
}

/// `q l⁴/(384 EI)` and five times that, in either direction and with any number of rows.
#[test]
fn the_borders_of_the_three_regimes_are_events() {
    let names = [
        [
            "the zone at x = 5 becomes a point; the regime changes from zone to points",
            "the contact at x = 5 goes; the regime changes from points to none",
        ],
        [
            "a contact appears at x = 5; the regime changes from none to points",
            "the point at x = 5 becomes a zone; the regime changes from points to zone",
        ],
    ];
    for steps in [2, 3, 12, 101] {
        for (range, borders, names) in
            [([1.0, 150.0], [20.0, 100.0], names[0]), ([150.0, 1.0], [100.0, 20.0], names[1])]
        {
            let found = events(&regimes(1.0), "foundation.depth", range, steps);
            assert_eq!(found.iter().map(|e| e.what.as_str()).collect::<Vec<_>>(), names, "{range:?} {steps}");
            for (event, border) in found.iter().zip(borders) {
                assert!((event.value - border).abs() <= 1e-12 * border, "{event:?}");
            }
        }
    }
}

/// The same borders as stiffnesses: EI with `q l⁴/(384 EI)` the depth, and a fifth of it.
#[test]
fn the_borders_are_events_of_the_stiffness_too() {
    let found = events(&regimes(1.0), "beam.bending_stiffness", [1.0, 200.0], 7);
    let borders = [10_000.0 / 384.0, 50_000.0 / 384.0];
    assert_eq!(found.len(), 2, "{found:?}");
    for (event, border) in found.iter().zip(borders) {
        assert!((event.value - border).abs() <= 1e-12 * border, "{event:?}");
    }
}

/// Two equal spans `a` under a uniform load, of which an end support goes down: its force is `3qa/8 − 3 EI d/(2a³)` and vanishes at
/// `d = q a⁴/(4 EI)`.
#[test]
fn a_support_that_settles_begins_to_pull_where_its_force_vanishes() {
    let supports = vec![Support::simple(0.0), Support::simple(5.0), Support::simple(10.0)];
    let beam = Beam::new(10.0, 2.0).and_then(|beam| beam.with_supports(supports)).expect("a beam");
    let load = Load::uniform_on(&beam, 1.0).expect("a load");
    let scene = Scene::new(beam, load, None).expect("a scene");
    let border = 5.0_f64.powi(4) / (4.0 * 2.0);
    let found = events(&scene, "beam.supports[2].level", [0.0, 2.0 * border], 6);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].value - border).abs() <= 1e-12 * border, "{found:?} for {border}");
    // By the balance of moments about the middle both ends carry the same.
    let expected =
        "the support at x = 0 begins to pull the beam down; the support at x = 10 begins to pull the beam down";
    assert_eq!(found[0].what, expected);
}

/// A load that is taken off and turned round splits the zone below it, just where it vanishes.
#[test]
fn a_load_history_splits_a_zone_where_the_load_begins_to_pull() {
    let scene = loaded(vec![Support::simple(0.0), Support::simple(10.0)], 1.0);
    let found = events(&scene, "load.point[0].force", [3.0, -2.0], 10);
    let split = found.iter().find(|event| event.what.contains("splits")).expect("the zone splits");
    assert!(split.value.abs() < 1e-12, "{found:?}");
}

fn alone(sweep: &Sweep<'_>, value: f64) -> Option<Exact> {
    theory::solve(&sweep.scene(value).ok()?).ok().filter(|exact| exact.solved)
}

/// On both sides of each event the scene is solved from nothing: the kinds differ there, and are one kind from each event to the
/// next.
#[test]
fn events_are_confirmed_from_both_sides() {
    /// How far from an event, as a share of the range: beside an edge two kinds are the same answer to 12 digits for a millionth
    /// or so, as what the one penetrates grows with the square of the distance.
    const BESIDE: f64 = 1e-5;
    let (mut confirmed, mut quiet, mut open) = (0, 0, 0);
    for i in 0..12 {
        let (scene, paths) = varied(i);
        for (path, from, to) in paths {
            let sweep = Sweep::new(&scene, &path, [from, to], 9).expect("a sweep");
            let Ok(rows) = sweep.rows() else { continue };
            let found = sweep.events(&rows);
            let step = BESIDE * (to - from);
            let mut ends = vec![from];
            ends.extend(found.iter().map(|event| event.value));
            ends.push(to);
            assert!(ends.windows(2).all(|pair| pair[0] <= pair[1]), "{i}, {path}: {found:?}");
            for (k, event) in found.iter().enumerate() {
                if ends[k + 1] - ends[k] < 4.0 * step || ends[k + 2] - ends[k + 1] < 4.0 * step {
                    continue;
                }
                let sides = [-step, step].map(|step| alone(&sweep, event.value + step));
                let [Some(before), Some(after)] = sides else { continue };
                let differs = !before.pattern().is_same(&after.pattern());
                assert!(differs, "{i}, {path}: nothing happens at {event:?}");
                confirmed += 1;
            }
            for pair in ends.windows(2).filter(|pair| 4.0 * step < pair[1] - pair[0]) {
                let sides = [pair[0] + step, pair[1] - step].map(|value| alone(&sweep, value));
                let [Some(first), Some(last)] = sides else { continue };
                // Where contacts carry nothing one answer has several lists of them.
                let one_kind = first.pattern().is_same(&last.pattern())
                    || sweep.scene(pair[1] - step).is_ok_and(|scene| first.holds(&scene));
                if one_kind {
                    quiet += 1;
                } else {
                    open += 1;
                }
            }
        }
    }
    // On an unloaded stretch that lies on level ground one answer has more lists than two.
    assert!(50 * open <= quiet, "{open} of {quiet} stretches between events have two kinds");
    assert!(60 < confirmed && 90 < quiet, "{confirmed} {quiet}");
}

/// A ridge that a load passes: the contact is there for less than a step of the sweep, and is found.
#[test]
fn what_comes_and_goes_between_two_rows_is_found() {
    let beam = Beam::new(10.0, 100.0).expect("a beam");
    let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 5.0, force: 10.0 }]).expect("a load");
    // The deflection under a load at mid-span, 10 · 10³/(48 · 100) = 2.083.
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 2.05 })).expect("a scene");
    let found = events(&scene, "load.point[0].at", [2.0, 8.0], 2);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0].value + found[1].value - 10.0).abs() < 1e-11, "{found:?}");
}
