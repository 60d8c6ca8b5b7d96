//! Events: between them nothing happens, and at them something does.

use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Foundation, Support};
use palkki::sweep::{Event, Sweep};
use palkki::theory::{self, Exact};
use palkki_evidence::random::sample_of;

use crate::scenes::{ends, on_supports};

use super::{events, loaded, regimes, varied};

/// `q l⁴/(384 EI)` and five times that, in either direction and with any number of rows.
#[test]
fn the_borders_of_the_three_regimes_are_events() {
    let names = [
        [
            "the zone at x = 5 becomes a point; the regime changes from zone to points",
            "the contact at x = 5 is lost; the regime changes from points to none",
        ],
        [
            "a contact appears at x = 5; the regime changes from none to points",
            "the point at x = 5 becomes a zone; the regime changes from points to zone",
        ],
    ];
    for steps in [2, 3, 12, 13, 101, 241] {
        let ranges = [
            ([1.0, 150.0], [20.0, 100.0], names[0]),
            ([150.0, 1.0], [100.0, 20.0], names[1]),
            // Of 241 rows two are just at the borders, and here the first and the last one.
            ([1.0, 121.0], [20.0, 100.0], names[0]),
            ([20.0, 100.0], [20.0, 100.0], names[0]),
        ];
        for (range, borders, names) in ranges {
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

/// Play closes where the sag of the free beam reaches it, `q = 384 EI s/5 l⁴`; two spans lift off their end under a load `P = 4 q a` in
/// the middle of the other one, and the same as the end is let down or up.
#[test]
fn a_beam_lifts_off_and_comes_to_bear() {
    let play = 0.3;
    let middle = Support::pushing(5.0).at_level(play);
    let supports = [Support::simple(0.0), middle, Support::simple(10.0)];
    let gap = on_supports([10.0, 70.0], &supports, (0.0, &[]), None);
    let closes = 384.0 * 70.0 * play / 5e4;
    let spans = [Support::pushing(0.0), Support::simple(5.0), Support::simple(10.0)];
    let two = on_supports([10.0, 70.0], &spans, (0.5, &[(7.5, 1.0)]), None);
    let lifts = 4.0 * 0.5 * 5.0;
    // Without the end the left span is an overhang, whose end is at `q a⁴/8EI + (q a³/6 − q a³/24 − P a²/16) a/EI`.
    let free = (0.5 * 625.0 / 8.0 + (0.5 * 125.0 / 8.0 - 25.0 / 16.0) * 5.0) / 70.0;
    let cases = [
        (&gap, "load.uniform", [0.1 * closes, 4.0 * closes], closes, "the beam comes to bear on its support at x = 5"),
        (&gap, "load.uniform", [4.0 * closes, 0.1 * closes], closes, "the beam lifts off its support at x = 5"),
        (&two, "load.point[0].force", [0.1, 3.0 * lifts], lifts, "the beam lifts off its support at x = 0"),
        (&two, "beam.supports[0].level", [0.0, 2.0 * free], free, "the beam lifts off its support at x = 0"),
    ];
    for (scene, path, range, border, what) in cases {
        for steps in [2, 3, 10] {
            let found = events(scene, path, range, steps);
            let [Event { value, what: told, .. }] = &found[..] else { panic!("{path}, {steps}: {found:?}") };
            assert!((value - border).abs() <= 1e-11 * border, "{path}, {steps}: {value} instead of {border}");
            assert_eq!(told, what, "{path}");
        }
    }
}

/// Two equal spans `a` under a uniform load, of which an end support goes down: its force is `3qa/8 − 3 EI d/(2a³)` and vanishes at
/// `d = q a⁴/(4 EI)`.
#[test]
fn a_support_that_settles_begins_to_pull_where_its_force_vanishes() {
    let scene = on_supports([10.0, 2.0], &[0.0, 5.0, 10.0].map(Support::simple), (1.0, &[]), None);
    let border = 5.0_f64.powi(4) / (4.0 * 2.0);
    let found = events(&scene, "beam.supports[2].level", [0.0, 2.0 * border], 6);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].value - border).abs() <= 1e-12 * border, "{found:?} for {border}");
    // By the balance of moments about the middle both ends carry the same.
    let expected =
        "the support at x = 0 begins to pull the beam down; the support at x = 10 begins to pull the beam down";
    assert_eq!(found[0].what, expected);
}

/// The left one of two supports at 0 and 5 pulls where the load at the tip of the beam is more than 3/5 of one at 2; so it does above ground
/// that gives and is out of reach.
#[test]
fn a_support_begins_to_pull_above_ground_that_gives() {
    let above = |ground: Option<Foundation>| {
        on_supports([10.0, 2.0], &[0.0, 5.0].map(Support::simple), (0.0, &[(2.0, 1.0), (10.0, 0.1)]), ground)
    };
    let deep = above(Some(Foundation::Flat { depth: 1e3 }));
    for scene in [deep.on_springs(1.0).expect("ground"), deep, above(None)] {
        let found = events(&scene, "load.point[1].force", [0.1, 1.0], 4);
        let [event] = &found[..] else { panic!("{found:?}") };
        assert!((event.value - 0.6).abs() <= 1e-11, "{event:?}");
        assert_eq!(event.what, "the support at x = 0 begins to pull the beam down");
    }
}

/// Ground that is level with the one support on its right side alone: where the left end is lifted the beam is pressed onto the ground
/// beside the support, which keeps its slope, until nothing lifts any more.
#[test]
fn ground_beside_a_support_holds_the_slope_of_a_lifted_beam() {
    let ground = Foundation::Polyline { points: vec![[0.0, 1.5], [3.0, 0.5], [8.0, 0.5]] };
    let support = Support::simple(3.0).at_level(0.5);
    let scene = on_supports([8.0, 2.0], &[support], (0.0, &[(0.0, -1.0), (8.0, 0.5)]), Some(ground));
    for (range, word) in [([-3.0, 3.0], "ceases"), ([3.0, -3.0], "begins")] {
        let found = events(&scene, "load.point[0].force", range, 5);
        let held = format!("the ground {word} to hold the slope of the beam at the support at x = 3");
        let event = found.iter().find(|event| event.what.contains(&held)).unwrap_or_else(|| panic!("{found:?}"));
        assert!(event.value.abs() <= 1e-12, "{event:?}");
        assert!(event.what.contains(&format!("the support at x = 3 {word} to pull the beam down")), "{event:?}");
    }
}

/// A load that is taken off and turned round splits the zone below it, just where it vanishes.
#[test]
fn a_load_history_splits_a_zone_where_the_load_begins_to_pull() {
    let scene = loaded(vec![Support::simple(0.0), Support::simple(10.0)], 1.0);
    let found = events(&scene, "load.point[0].force", [3.0, -2.0], 10);
    let split = found.iter().find(|event| event.what.contains("splits")).expect("the zone splits");
    assert!(split.value.abs() < 1e-12, "{found:?}");
}

/// A load that pulls and comes into a zone splits it: a uniform load lifts the beam off over `a = (24 EI u₀/q)^¼`, wherever on the
/// zone the load begins to pull. And it leaves it at the mirror image.
#[test]
fn a_load_that_pulls_splits_the_zone_that_it_enters() {
    for (uniform, force) in [(1.0_f64, -1.0), (0.3, -0.1)] {
        let ground = Some(Foundation::Flat { depth: 1.0 });
        let scene = on_supports([10.0, 500.0 / 384.0], &ends(10.0), (uniform, &[(0.0, force)]), ground);
        let lift_off = (24.0 * 500.0 / 384.0 / uniform).powf(0.25);
        for steps in [2, 41, 401] {
            let found = events(&scene, "load.point[0].at", [0.0, 10.0], steps);
            let [first, .., last] = found.as_slice() else { panic!("{found:?}") };
            assert!((first.value - lift_off).abs() <= 1e-12 * 10.0, "{first:?} for {lift_off}");
            assert!((last.value - (10.0 - lift_off)).abs() <= 1e-12 * 10.0, "{last:?} for {lift_off}");
            assert!(first.what.contains("splits") && last.what.contains("merge into a zone"), "{found:?}");
        }
    }
}

fn alone(sweep: &Sweep<'_>, value: f64) -> Option<Exact> {
    theory::solve(&sweep.scene(value).ok()?).ok().filter(|exact| exact.solved)
}

fn is_like(one: &Exact, other: &Exact) -> bool {
    one.pattern().is_same(&other.pattern())
}

/// The same of answers that are farther from each other, whose contacts have moved.
fn is_of_one_kind(one: &Exact, other: &Exact) -> bool {
    one.pattern().is_same_kind(&other.pattern())
}

/// True if the contacts of an answer, moved, are an answer for another value as well.
fn lasts(sweep: &Sweep<'_>, exact: &Exact, value: f64) -> bool {
    sweep.scene(value).is_ok_and(|scene| exact.moved(&scene).is_some())
}

/// What became of events and of the stretches between them.
#[derive(Debug, Default)]
struct Seen {
    /// Events with another kind on either side.
    confirmed: u64,
    /// Events at an end of the range, with another kind inside than at the end or beyond it.
    at_end: u64,
    /// Events beside which both kinds are the same answer to 12 digits.
    ties: Vec<String>,
    /// Events beside which theory finds no answer from nothing, and the contacts of one farther off are one.
    unsolved: Vec<String>,
    /// Stretches of one kind.
    quiet: u64,
}

/// Events of one sweep, each solved from nothing on both sides of it.
fn confirm(name: &str, sweep: &Sweep<'_>, [from, to]: [f64; 2], seen: &mut Seen) {
    /// How far from an event, as a share of the range.
    const BESIDE: f64 = 1e-5;
    /// Nearer to an end of the range is at the end.
    const AT_END: f64 = 1e-7;
    let Ok(rows) = sweep.rows() else { return };
    let found = sweep.events(&rows);
    let range = to - from;
    let mut ends = vec![from];
    ends.extend(found.iter().map(|event| event.value));
    ends.push(to);
    assert!(ends.windows(2).all(|pair| pair[0] <= pair[1]), "{name}: {found:?}");
    let mut tied = false;
    for (k, event) in found.iter().enumerate() {
        let name = format!("{name}: {event:?}");
        let value = event.value;
        if let Some((end, inwards)) =
            [(from, 1.0), (to, -1.0)].into_iter().find(|(end, _)| (value - end).abs() < AT_END * range)
        {
            let beside = inwards * BESIDE * range;
            let inside = alone(sweep, end + beside).expect("an answer");
            let other = [end - beside, end].into_iter().filter_map(|value| alone(sweep, value));
            assert!(other.into_iter().any(|other| !is_like(&other, &inside)), "nothing happens at the end: {name}");
            seen.at_end += 1;
            continue;
        }
        let room = 0.25 * (value - ends[k]).min(ends[k + 2] - value);
        let step = room.min(BESIDE * range);
        assert!(1e-9 * range < step, "too near to its neighbour: {name}");
        let beside = [-step, step].map(|step| alone(sweep, value + step));
        if let [Some(before), Some(after)] = &beside
            && !is_like(before, after)
        {
            seen.confirmed += 1;
            continue;
        }
        let farther = [1e1, 1e2, 1e3].into_iter().map(|times| step * times).filter(|step| *step < room);
        let two = |step: f64| Some([alone(sweep, value - step)?, alone(sweep, value + step)?]);
        let sides = farther.filter_map(two).find(|[before, after]| !is_like(before, after));
        let sides = sides.unwrap_or_else(|| panic!("nothing happens: {name}"));
        for (side, (exact, step)) in sides.iter().zip([-step, step]).enumerate() {
            assert!(lasts(sweep, exact, value + step), "no answer on side {side}: {name}");
        }
        tied = true;
        let list = if beside.iter().all(Option::is_some) { &mut seen.ties } else { &mut seen.unsolved };
        list.push(name.split(": ").next().unwrap_or_default().to_owned());
    }
    let step = BESIDE * range;
    for pair in ends.windows(2).filter(|pair| 4.0 * step < pair[1] - pair[0]) {
        let place = |share: f64| pair[0] + step + share * (pair[1] - pair[0] - 2.0 * step);
        let answers = [0.0, 0.3, 0.55, 0.8, 1.0].map(place).into_iter();
        let answers: Vec<(f64, Exact)> = answers.filter_map(|value| Some((value, alone(sweep, value)?))).collect();
        for (value, exact) in &answers {
            let (start, first) = &answers[0];
            let tie = || tied && (lasts(sweep, first, *value) || lasts(sweep, exact, *start));
            assert!(is_of_one_kind(first, exact) || tie(), "{name}: {pair:?} has two kinds, at {start} and at {value}");
        }
        seen.quiet += 1;
    }
}

/// On both sides of each event the scene is solved from nothing: the kinds differ there, and are one kind from each event to the
/// next. What is otherwise is named, with its cause; of a hundred scenes these are eight.
#[test]
fn events_are_confirmed_from_both_sides() {
    const SCENES: u64 = 30;
    /// Those with an event that is otherwise.
    const OTHERWISE: [u64; 2] = [19, 22];
    let drawn = sample_of(SCENES);
    let part = |first: u64| {
        let mut seen = Seen::default();
        for i in (first..SCENES).step_by(2).filter(|i| *i < drawn || OTHERWISE.contains(i)) {
            let (scene, paths) = varied(i);
            for (path, from, to) in paths {
                let sweep = Sweep::new(&scene, &path, [from, to], 9).expect("a sweep");
                confirm(&format!("{i} {path}"), &sweep, [from, to], &mut seen);
            }
        }
        seen
    };
    let [even, odd] = std::thread::scope(|scope| {
        let threads = [0, 1].map(|first| scope.spawn(move || part(first)));
        threads.map(|thread| thread.join().expect("no panic"))
    });
    // A point beside an edge, too near to be told from one on it.
    assert_eq!([even.ties, odd.ties].concat(), ["19 beam.bending_stiffness"]);
    // A point that has just split in two below a point load.
    assert_eq!([even.unsolved, odd.unsolved].concat(), ["22 load.uniform"]);
    let confirmed = even.confirmed + odd.confirmed;
    let at_end = even.at_end + odd.at_end;
    assert!(8 * drawn < confirmed && at_end < 20, "{confirmed} {at_end}");
    assert!(13 * drawn < even.quiet + odd.quiet, "{} {}", even.quiet, odd.quiet);
}

/// A contact that is there for two thousandths of the way, between two of the places at which a search looks first: it is found, wherever
/// the places are. The deflection under the load is `P a² b²/(3 EI l)`.
#[test]
fn a_short_contact_between_two_places_is_found() {
    const HALF: f64 = 1e-3;
    let (a, b) = (5.0 - HALF, 5.0 + HALF);
    let ground = Some(Foundation::Flat { depth: 10.0 * a * a * b * b / (3.0 * 100.0 * 10.0) });
    let scene = on_supports([10.0, 100.0], &ends(10.0), (0.0, &[(5.0, 10.0)]), ground);
    for to in (0..12).map(|k| 8.0 + 0.09 * f64::from(k)) {
        let found = events(&scene, "load.point[0].at", [2.0, to], 2);
        assert_eq!(found.len(), 2, "{to}: {found:?}");
        for (event, near) in found.iter().zip([a, b]) {
            assert!((event.value - near).abs() <= HALF, "{to}: {event:?}");
        }
    }
}

/// A ridge that a load passes: the contact is there for less than a step of the sweep, and is found.
#[test]
fn what_comes_and_goes_between_two_rows_is_found() {
    // The deflection under a load at mid-span, 10 · 10³/(48 · 100) = 2.083.
    let ground = Some(Foundation::Flat { depth: 2.05 });
    let scene = on_supports([10.0, 100.0], &ends(10.0), (0.0, &[(5.0, 10.0)]), ground);
    let found = events(&scene, "load.point[0].at", [2.0, 8.0], 2);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0].value + found[1].value - 10.0).abs() < 1e-11, "{found:?}");
}

/// A joint divides the foundation into two smooth pieces. As it moves, the contacts of an answer move with their pieces, otherwise the
/// value at which the zone splits has only nine digits.
#[test]
fn contacts_move_with_a_joint() {
    let at = |place: f64| {
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = 34.1\njoints = [{{ at = {place:?}, stiffness = 5.6 }}]\n\n\
             [load]\nuniform = 36.9\npoint = [{{ at = 4.8, force = 14.7 }}]\n\n\
             [foundation]\npolynomial = [0.2, 0.0044, -0.00044]\n"
        );
        parse("joint.toml", &text, |_| Err(ReadProblem::Missing)).expect("a scene")
    };
    let found = events(&at(2.8), "beam.joints[0].at", [1.0, 4.0], 7);
    let split = found.first().expect("an event");
    assert!(split.what.ends_with("splits"), "{split:?}");
    let contacts = [-1.0, 1.0].map(|sign| {
        let beside = at(split.value * (1.0 + sign * 3e-11));
        theory::solve(&beside).expect("an answer").state.contacts.len()
    });
    assert_eq!(contacts, [1, 2], "{split:?}");
}
