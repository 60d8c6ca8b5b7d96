//! Events over families of sweeps: they do not depend on the number of rows, and the kinds of the rows follow from them.

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};
use palkki::sweep::{MOST_STEPS, Sweep, SweepError};
use palkki_evidence::compare::largest;
use palkki_evidence::random::sample_of;
use palkki_evidence::sweeps::faults;

use super::{events, regimes};

/// Sweeps in the suite, of which it draws a sample; `cargo run --release --package palkki-evidence --features full --example sweeps 0 500` makes more.
const SWEEPS: u64 = 8;

/// And some of those that once depended on it: a contact that parts from the end of a zone (18, 148), a short span beside a support
/// (110), contacts beyond an inner support (420), an event that is known to a few millionths of the range (426).
const ONCE: [u64; 5] = [18, 110, 148, 420, 426];

#[test]
fn events_do_not_depend_on_the_number_of_rows_or_the_direction() {
    let all: Vec<(usize, Vec<String>)> = std::thread::scope(|scope| {
        let all = |first| (0..sample_of(SWEEPS)).chain(ONCE).skip(first).step_by(2);
        let part = |first: usize| move || all(first).map(|i| faults(i, 1e-9)).collect::<Vec<_>>();
        let threads = [0, 1].map(|first| scope.spawn(part(first)));
        threads.into_iter().flat_map(|thread| thread.join().expect("no panic")).collect()
    });
    let wrong: Vec<&String> = all.iter().flat_map(|(_, wrong)| wrong).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let events: usize = all.iter().map(|(events, _)| events).sum();
    assert!(3 < events, "{events}");
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
        let off = largest(forth.iter().zip(&other).map(|(a, b)| a.value - b.value));
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

/// The only contact becomes a zone, and the regime changes with it, also where the zone beside the event is shorter than the last digit
/// of its place: over so short a range.
#[test]
fn a_point_that_becomes_a_zone_is_a_change_of_regime() {
    for share in [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        for ends in [[1.0 + share, 1.0 - share], [1.0 + 0.3 * share, 1.0 - share]] {
            let found = events(&regimes(1.0), "foundation.depth", ends.map(|end| 20.0 * end), 3);
            let [event] = found.as_slice() else { panic!("{share:e}: {found:?}") };
            assert!((event.value - 20.0).abs() <= 1e-9 * 40.0 * share + 1e-13, "{share:e}: {event:?}");
            assert_eq!(
                event.what, "the point at x = 5 becomes a zone; the regime changes from points to zone",
                "{share:e}"
            );
        }
    }
}

/// Between the last row with an answer and the end of what has one there may be an event as well.
#[test]
fn events_before_a_row_without_an_answer_are_found() {
    let scene = regimes(1.0);
    let sweep = Sweep::new(&scene, "foundation.depth", [150.0, -1.0], 3).expect("a sweep");
    let mut walk = sweep.walk();
    let rows: Vec<_> = sweep.values().map_while(|value| walk.solve(value).ok().map(|step| walk.row(step))).collect();
    assert_eq!(rows.len(), 2, "there is no ground above the supports");
    let found = sweep.events(&rows);
    assert!(found.len() == 2 && (found[1].value - 20.0).abs() < 1e-9, "{found:?}");
}

/// Where a beam without weight lies on ground that carries nothing, it has several lists of contacts: a row has the same one whatever
/// the rows before it are.
#[test]
fn contacts_of_a_stretch_without_weight_do_not_depend_on_the_rows() {
    let mut compared = 0;
    for i in 0..20_u32 {
        let beam = Beam::new(10.0, 2.0).and_then(|beam| beam.with_supports(Vec::new())).expect("a beam");
        let at = |k: u32| 1.0 + f64::from((7 * i + 3 * k) % 9);
        let point = (0..1 + i % 3).map(|k| PointLoad { at: at(k), force: 1.0 + f64::from(k) }).collect();
        let load = Load::new(&beam, 0.0, Vec::new(), point).expect("a load");
        let ground = vec![[0.0, 0.5], [3.0, 0.5 + 0.1 * f64::from(i % 2)], [6.0, 0.5], [10.0, 0.5]];
        let scene = Scene::new(beam, load, Some(Foundation::Polyline { points: ground })).expect("a scene");
        let rows = |range: [f64; 2], steps: usize| {
            let sweep = Sweep::new(&scene, "load.point[0].at", range, steps).expect("a sweep");
            let mut walk = sweep.walk();
            let row = |value| walk.solve(value).ok().map(|step| walk.row(step).solution.state.contacts);
            sweep.values().map(row).collect::<Vec<_>>()
        };
        let (all, few, mut back) = (rows([0.5, 9.5], 19), rows([0.5, 9.5], 7), rows([9.5, 0.5], 19));
        back.reverse();
        for (k, contacts) in all.iter().enumerate() {
            let others = [Some(&back[k]), k.is_multiple_of(3).then(|| &few[k / 3])];
            for other in others.into_iter().flatten() {
                let (Some(contacts), Some(other)) = (contacts, other) else { continue };
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-9;
                let same = contacts.iter().zip(other).all(|(a, b)| near(a.from, b.from) && near(a.to, b.to));
                assert!(contacts.len() == other.len() && same, "{i}, row {k}: {contacts:?} and {other:?}");
                compared += 1;
            }
        }
    }
    assert!(300 < compared, "{compared}");
}

/// Work is counted: what was found before it was done is there, with the value up to which was looked.
#[test]
fn a_search_that_is_stopped_says_up_to_where_it_came() {
    let scene = regimes(1.0);
    let sweep = Sweep::new(&scene, "foundation.depth", [1.0, 150.0], 12).expect("a sweep");
    let rows: Vec<_> = sweep.rows().expect("answers").into_iter().map(|row| (row.value, row.pattern)).collect();
    let all = sweep.events_within(&rows, u64::MAX);
    assert_eq!((all.events.len(), all.until), (2, None));
    let some = sweep.events_within(&rows, 20_000);
    let until = some.until.expect("it is stopped");
    assert!((20.0..100.0).contains(&until) && some.events[..] == all.events[..1], "{some:?}");
    for work in [1, 100, 1000, 10_000] {
        let until = sweep.events_within(&rows, work).until.expect("it is stopped");
        assert!((1.0..150.0).contains(&until), "{work}: events up to {until}");
    }
    assert!(matches!(Sweep::new(&scene, "foundation.depth", [1.0, 150.0], MOST_STEPS + 1), Err(SweepError::Steps(_))));
}
