//! Trains that come onto the beam and leave it, influence lines, and what goes with the governing value.

use palkki::scene::file::{Model, ReadProblem, parse, parse_train};
use palkki::scene::{Foundation, Scene, Support};
use palkki::sweep::{AtPlace, Sweep};
use palkki::theory;
use palkki_evidence::random::Random;
use palkki_evidence::texts::Files;

use super::envelope::gathered;
use crate::scenes::{ends, on_supports};

/// What each row has at a place.
fn at(sweep: &Sweep<'_>, x: f64) -> Vec<(f64, AtPlace)> {
    let mut walk = sweep.walk();
    let mut row = |value| {
        let step = walk.solve(value).expect("an answer");
        let at = step.at(x);
        walk.row(step);
        (value, at)
    };
    sweep.values().map(&mut row).collect()
}

/// The influence lines of three equal spans, for a force at `a`: the moments over the two inner supports solve the three-moment equations
/// `4 M₁ + M₂ = −K₁`, `M₁ + 4 M₂ = −K₂`, in which a force `P` in a span `l` at `s` from its left end has
/// `K = P s (l² − s²)/l²` on its right and `P t (l² − t²)/l²`, `t = l − s`, on its left.
fn three_spans(l: f64, force: f64, a: f64) -> [f64; 2] {
    let mut k = [0.0; 2];
    let span = if a < l {
        0
    } else if a < 2.0 * l {
        1
    } else {
        2
    };
    let s = a - l * [0.0, 1.0, 2.0][span];
    let (t, load) = (l - s, |s: f64| force * s * (l * l - s * s) / (l * l));
    if span < 2 {
        k[span] += load(s);
    }
    if 0 < span {
        k[span - 1] += load(t);
    }
    [(-4.0 * k[0] + k[1]) / 15.0, (k[0] - 4.0 * k[1]) / 15.0]
}

#[test]
fn influence_lines_of_three_spans_are_those_of_the_textbook() {
    let (l, force) = (4.0, 10.0);
    let supports = [0.0, l, 2.0 * l, 3.0 * l].map(Support::simple);
    let scene = on_supports([3.0 * l, 700.0], &supports, (0.0, &[(0.0, force)]), None);
    let sweep = Sweep::new(&scene, "load.point[0].at", [0.0, 3.0 * l], 61).expect("a sweep");
    let near = |found: f64, expected: f64, what: &str| {
        assert!((found - expected).abs() <= 1e-12 * force * l, "{what}: {found}, not {expected}");
    };
    // Over the first inner support, and at the middle of the middle span.
    for ((a, over), (_, middle)) in at(&sweep, l).into_iter().zip(at(&sweep, 1.5 * l)) {
        let [first, second] = three_spans(l, force, a);
        let in_first = if a < l { force * a / l } else { 0.0 };
        let in_middle = if l < a && a < 2.0 * l { force * (2.0 * l - a) / l } else { 0.0 };
        let what = format!("{a}");
        over.moment.into_iter().for_each(|moment| near(moment, first, &what));
        // A force on the support itself goes through it.
        if (a - l).abs() > 0.0 {
            near(over.shear[0], first / l - in_first, &what);
            near(over.shear[1], (second - first) / l + in_middle, &what);
        }
        let own = if l < a && a < 2.0 * l { 0.5 * force * (a - l).min(2.0 * l - a) } else { 0.0 };
        middle.moment.into_iter().for_each(|moment| near(moment, 0.5 * (first + second) + own, &what));
    }
}

/// A train of twelve axles, 25 m long, over a bridge of 30 m from outside to outside.
fn train() -> (Scene, String, [f64; 2]) {
    let supports = [0.0, 12.0, 30.0].map(Support::simple);
    let axles: Vec<(f64, f64)> = (0..12).map(|k| (f64::from(k) * 25.0 / 11.0, 100.0 + f64::from(k % 3))).collect();
    (on_supports([30.0, 5000.0], &supports, (0.0, &axles), None), "load.point[*].at".to_owned(), [-25.0, 30.0])
}

/// The same beam with the axles that are on it.
fn by_hand(axles: &Scene, value: f64, supports: &[Support]) -> Option<Scene> {
    let point: Vec<(f64, f64)> = axles.load().point().iter().map(|p| (p.at + value, p.force)).collect();
    let on: Vec<(f64, f64)> = point.into_iter().filter(|(at, _)| (0.0..=30.0).contains(at)).collect();
    (!on.is_empty()).then(|| on_supports([30.0, 5000.0], supports, (0.0, &on), None))
}

/// The governing moments, the moment at mid-span and its shear force are those of a search over 5,500 places in which each axle beyond
/// the beam is left out by hand.
#[test]
fn a_train_comes_onto_the_bridge_and_leaves_it() {
    let (scene, path, range) = train();
    let supports = [0.0, 12.0, 30.0].map(Support::simple);
    let sweep = Sweep::new(&scene, &path, range, 56).expect("a sweep");
    assert_eq!(sweep.paths().split(',').count(), 12);
    let found = gathered(&sweep).envelope().expect("rows");
    let mut brute = [f64::INFINITY, f64::NEG_INFINITY];
    for k in 0..=5500 {
        let value = range[0] + (range[1] - range[0]) * f64::from(k) / 5500.0;
        let Some(scene) = by_hand(&scene, value, &supports) else { continue };
        let state = theory::solve(&scene).expect("an answer").state;
        brute = [brute[0].min(state.moment.min), brute[1].max(state.moment.max)];
    }
    let [max, min] = [&found.governing.moment_max, &found.governing.moment_min];
    for (moment, brute) in [(min.moment, brute[0]), (max.moment, brute[1])] {
        assert!(
            (moment - brute).abs() <= 1e-4 * brute.abs() && brute.abs() <= moment.abs() * (1.0 + 1e-12),
            "{moment} {brute}"
        );
    }
    for governing in [max, min] {
        let exact =
            theory::solve(&by_hand(&scene, governing.value, &supports).expect("axles on it")).expect("an answer");
        let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * 1200.0, "{governing:?}: {a} {b}");
        near(governing.moment, exact.moment(governing.at));
        governing.shear.into_iter().zip(exact.shear(governing.at)).for_each(|(a, b)| near(a, b));
        governing.supports.iter().zip(&exact.state.supports).for_each(|(a, b)| near(*a, b.force));
    }
    for (value, place) in at(&sweep, 15.0) {
        let Some(scene) = by_hand(&scene, value, &supports) else {
            assert_eq!((place.moment, place.shear), ([0.0; 2], [0.0; 2]), "{value}");
            continue;
        };
        let exact = theory::solve(&scene).expect("an answer");
        let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * 1200.0, "{value}: {a} {b}");
        near(place.moment[0], exact.moment(15.0));
        place.shear.into_iter().zip(exact.shear(15.0)).for_each(|(a, b)| near(a, b));
        near(place.deflection, exact.deflection(15.0));
        near(place.slope, exact.slope(15.0));
    }
}

/// With a minus sign a number moves the other way: two supports towards each other, the scene stays symmetric.
#[test]
fn supports_that_move_towards_each_other_leave_a_symmetric_beam() {
    let supports = [1.0, 9.0].map(Support::simple);
    let ground = Some(Foundation::Flat { depth: 1.0 });
    let scene = on_supports([10.0, 10.0], &supports, (1.0, &[]), ground);
    let path = "beam.supports[0].at, -beam.supports[1].at";
    let sweep = Sweep::new(&scene, path, [0.0, 3.0], 13).expect("a sweep");
    assert_eq!(sweep.paths(), "beam.supports[0].at,-beam.supports[1].at");
    for row in sweep.rows().expect("answers") {
        let supports = &row.solution.state.supports;
        assert!((supports[0].at + supports[1].at - 10.0).abs() < 1e-12, "{}", row.value);
        assert!((supports[0].force - supports[1].force).abs() < 1e-10, "{}: {supports:?}", row.value);
    }
    let mut random = Random::new(5);
    let value = random.between(0.0, 3.0);
    let moved = sweep.scene(value).expect("a scene");
    assert!((moved.beam().supports()[1].at - (9.0 - (value - 1.0))).abs() < 1e-12);
}

/// A train that is longer than its bridge is read with axles beyond it. Each row has those that are on the bridge, and no other command reads it.
#[test]
fn a_train_may_be_longer_than_its_bridge() {
    let axles = [(0.0, 100.0), (-2.0, 110.0), (-37.0, 120.0), (-39.0, 130.0)];
    let point = axles.map(|(at, force)| format!("{{ at = {at}, force = {force} }}")).join(", ");
    let still = ", { at = 40.0, force = 1000.0 }";
    let beam = "[beam]\nlength = 30.0\nbending_stiffness = 5000.0\n";
    let text = format!("{beam}[load]\nuniform = 1.0\npoint = [{point}{still}]\n");
    let refused = parse("train", &text, |_| Err(ReadProblem::Missing)).expect_err("an axle beyond the beam");
    assert!(refused.to_string().contains("must lie on the beam, between 0 and 30"), "{refused}");
    let Ok(Model::Scene(scene)) = parse_train("train", &text, &mut Files(&[])) else { panic!("a scene") };
    assert_eq!(scene.loads_beyond().collect::<Vec<_>>(), [1, 2, 3, 4]);
    let path = "load.point[0].at,load.point[1].at,load.point[2].at,load.point[3].at";
    let sweep = Sweep::new(&scene, path, [-5.0, 75.0], 33).expect("a sweep");
    for row in sweep.rows().expect("answers") {
        let on = axles.map(|(at, force)| (at + row.value, force)).into_iter();
        let on: Vec<(f64, f64)> = on.filter(|(at, _)| (0.0..=30.0).contains(at)).collect();
        let state =
            theory::solve(&on_supports([30.0, 5000.0], &ends(30.0), (1.0, &on), None)).expect("an answer").state;
        let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-12 * state.moment.max, "{}: {a} {b}", row.value);
        near(row.solution.state.moment.max, state.moment.max);
        near(row.solution.state.reactions.left, state.reactions.left);
    }
}
