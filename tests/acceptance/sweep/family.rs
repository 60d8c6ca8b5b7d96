//! Events over families of sweeps: they do not depend on the number of rows, and the kinds of the rows follow from them.

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};
use palkki::sweep::{Event, MOST_STEPS, Sweep, SweepError};
use palkki_evidence::sweeps::faults;

use super::regimes;

/// Sweeps in the suite; `cargo run --release --package palkki-evidence --features full --example sweeps 0 500` makes more.
const SWEEPS: u64 = 6;

#[test]
fn events_do_not_depend_on_the_number_of_rows_or_the_direction() {
    let all: Vec<(usize, Vec<String>)> = std::thread::scope(|scope| {
        let part = |first: u64| move || (first..SWEEPS).step_by(2).map(|i| faults(i, 1e-9)).collect::<Vec<_>>();
        let threads = [0, 1].map(|first| scope.spawn(part(first)));
        threads.into_iter().flat_map(|thread| thread.join().expect("no panic")).collect()
    });
    let wrong: Vec<&String> = all.iter().flat_map(|(_, wrong)| wrong).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let events: usize = all.iter().map(|(events, _)| events).sum();
    assert!(3 < events, "{events}");
}

fn events(scene: &Scene, path: &str, range: [f64; 2], steps: usize) -> Vec<Event> {
    let sweep = Sweep::new(scene, path, range, steps).expect("a sweep");
    sweep.events(&sweep.rows().expect("answers"))
}

/// Twenty waves: from row to row one crest loses its contact and another one gets one, so that there are as many as before.
#[test]
fn contacts_that_change_the_crest_are_events() {
    let beam = Beam::new(12.0, 2.0).expect("a beam");
    let linear = |from, to, start, end| LinearLoad { from, to, start, end };
    let linear = vec![
        linear(1.363_163_641_492_153, 3.072_396_650_497_158, 29.376_158_979_152_635, 31.180_060_113_380_16),
        linear(2.618_989_271_127_508, 5.233_133_691_107_419, 26.400_846_566_939_347, 27.320_959_060_273_07),
    ];
    let load = Load::new(&beam, 14.038_666_192_835_011, linear, Vec::new()).expect("a load");
    let waves = Foundation::Cosine {
        mean: 1_495.812_214_155_717_4,
        amplitude: 1_218.272_675_962_683_3,
        wavelength: 0.6,
        phase: 3.546_012_483_076_405_3,
    };
    let scene = Scene::new(beam, load, Some(waves)).expect("a scene");
    let path = "beam.bending_stiffness";
    let forth = events(&scene, path, [1.0, 3.0], 3);
    assert_eq!(forth.len(), 12, "{forth:#?}");
    let mut back = events(&scene, path, [3.0, 1.0], 3);
    back.reverse();
    for other in [back, events(&scene, path, [1.0, 3.0], 60)] {
        assert_eq!(other.len(), forth.len(), "{other:#?}");
        let off = forth.iter().zip(&other).map(|(a, b)| (a.value - b.value).abs()).fold(0.0, f64::max);
        assert!(off < 2e-9, "{off:e}");
    }
}

/// A load on a support goes through it, however large it is.
#[test]
fn a_load_on_a_support_hides_no_event() {
    for force in [0.0, 1e6, 1e13] {
        let scene = regimes(1.0);
        let load = Load::new(scene.beam(), 1.0, Vec::new(), vec![PointLoad { at: 0.0, force }]).expect("a load");
        let scene = Scene::new(scene.beam().clone(), load, scene.foundation().cloned()).expect("a scene");
        let found = events(&scene, "foundation.depth", [0.5, 150.0], 11);
        assert_eq!(found.len(), 2, "{force:e}: {found:?}");
        for (event, border) in found.iter().zip([20.0, 100.0]) {
            assert!((event.value - border).abs() <= 1e-10 * border, "{force:e}: {event:?}");
        }
        assert!(found[0].what.contains("the regime changes from zone to points"), "{found:?}");
    }
}

/// Work is counted: what was found before it was done is there, with the value up to which was looked.
#[test]
fn a_search_that_is_stopped_says_up_to_where_it_came() {
    let scene = regimes(1.0);
    let sweep = Sweep::new(&scene, "foundation.depth", [1.0, 150.0], 12).expect("a sweep");
    let rows: Vec<_> = sweep.rows().expect("answers").into_iter().map(|row| (row.value, row.pattern)).collect();
    let all = sweep.events_within(&rows, u64::MAX);
    assert_eq!((all.events.len(), all.until), (2, None));
    let some = sweep.events_within(&rows, 15_000);
    let until = some.until.expect("it is stopped");
    assert!((20.0..100.0).contains(&until) && some.events[..] == all.events[..1], "{some:?}");
    assert!(matches!(Sweep::new(&scene, "foundation.depth", [1.0, 150.0], MOST_STEPS + 1), Err(SweepError::Steps(_))));
}
