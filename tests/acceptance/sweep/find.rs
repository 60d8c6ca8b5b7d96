//! Inverse questions whose answers have a closed form.

use palkki::route::Status;
use palkki::scene::{Foundation, Scene, Support};
use palkki::sweep::{Finding, Sweep, Until};

use super::regimes;
use crate::scenes::{ends, on_supports};

const L: f64 = 10.0;
const EI: f64 = 1000.0;

/// A load `q` and forces on a beam of length [`L`] with [`EI`], on these supports, without a foundation.
fn beam(supports: &[Support], load: f64, points: &[(f64, f64)]) -> Scene {
    on_supports([L, EI], supports, (load, points), None)
}

/// What a search finds. Each value has certified answers beside it, on different sides of the target where it is crossed.
fn find(scene: &Scene, path: &str, range: [f64; 2], until: &str) -> Finding {
    let sweep = Sweep::new(scene, path, range, 2).expect("a sweep");
    let until = Until::parse(until, scene).expect("a condition");
    let finding = sweep.find(&until, u64::MAX).expect("answers");
    assert!(finding.is_whole && finding.found.is_empty() == finding.nearest.is_some(), "{finding:?}");
    for found in &finding.found {
        for beside in [found.below, found.above].into_iter().flatten() {
            let mut walk = sweep.walk();
            let step = walk.solve(beside.value).expect("an answer");
            assert_eq!(walk.row(step).solution.verdict.status, Status::Certified, "{path}: {found:?}");
        }
    }
    finding
}

/// The values that are found, each of them crossed.
fn crossed(scene: &Scene, path: &str, range: [f64; 2], until: &str) -> Vec<f64> {
    let target = until.split_once('=').map_or(0.0, |(_, number)| number.trim().parse().expect("a number"));
    let of = |finding: Finding| {
        let all = finding.found.into_iter().map(|found| {
            let (below, above) = (found.below.expect("below"), found.above.expect("above"));
            assert!((below.reached - target) * (above.reached - target) < 0.0, "{path} {until}: {found:?}");
            assert!(below.value < found.value && found.value < above.value && !found.jumps, "{path}: {found:?}");
            found.value
        });
        all.collect::<Vec<f64>>()
    };
    let forth = of(find(scene, path, range, until));
    let mut back = of(find(scene, path, [range[1], range[0]], until));
    back.reverse();
    near(&back, &forth, &format!("{path} {until}, backwards"));
    forth
}

/// Equal to 12 digits.
#[track_caller]
fn near(found: &[f64], expected: &[f64], what: &str) {
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12 * b.abs();
    assert!(
        found.len() == expected.len() && found.iter().zip(expected).all(is_near),
        "{what}: {found:?}, {expected:?}"
    );
}

/// `v(l/2) = 5 q l⁴/(384 EI)`, `M(x) = P b x/l`, `M(l/2) = P a/2`, `R = P a/l`, `v = P l³/(3 EI)`, and
/// `R = 5 q s/4 − 6 EI δ/s³` at the inner one of three supports with the spacing `s` that settles by `δ`.
#[test]
fn inverse_questions_of_beams_without_a_foundation_have_their_closed_form() {
    let simple = ends(L);
    let found = crossed(&beam(&simple, 1.0, &[]), "load.uniform", [0.01, 1.0], "deflection(5) = 0.0095");
    near(&found, &[384.0 * EI * 0.0095 / (5.0 * L.powi(4))], "load for a deflection");

    let found = crossed(&beam(&simple, 0.0, &[(6.0, 1.0)]), "load.point[0].force", [0.5, 50.0], "moment(3) = 7");
    near(&found, &[7.0 * L / (4.0 * 3.0)], "force for a moment");

    let moving = beam(&simple, 0.0, &[(1.0, 3.0)]);
    let found = crossed(&moving, "load.point[0].at", [0.0, L], "moment(5) = 6.1");
    near(&found, &[2.0 * 6.1 / 3.0, L - 2.0 * 6.1 / 3.0], "positions for a moment");
    let found = crossed(&moving, "load.point[0].at", [0.0, L], "support[1] = 1.1");
    near(&found, &[1.1 * L / 3.0], "position for a reaction");

    let built_in = [Support { slope: Some(0.0), ..Support::simple(0.0) }];
    let found =
        crossed(&beam(&built_in, 0.0, &[(L, 2.0)]), "beam.bending_stiffness", [100.0, 9000.0], "deflection(10) = 0.4");
    near(&found, &[2.0 * L.powi(3) / (3.0 * 0.4)], "stiffness for a deflection");

    let three = [0.0, 5.0, 10.0].map(Support::simple);
    let found = crossed(&beam(&three, 1.0, &[]), "beam.supports[1].level", [0.0, 1.0], "support[1] = 0.5");
    near(&found, &[(1.25 * 5.0 - 0.5) * 125.0 / (6.0 * EI)], "settlement for a reaction");
}

/// On flat ground: the free beam sags by `5 q l⁴/(384 EI)`; a zone begins at `a`, `a⁴ = 24 EI u/q`, with end reactions `q a/2`; between
/// the two the beam lies on a point with `F = (v₀ − u) 48 EI/l³`.
#[test]
fn inverse_questions_of_beams_on_flat_ground_have_their_closed_form() {
    let scene = regimes(1.0);
    let stiffness = scene.beam().bending_stiffness();
    let depth = "foundation.depth";
    near(&crossed(&scene, depth, [1.0, 150.0], "contact"), &[100.0], "depth at which contact ends");
    near(&crossed(&scene, "load.uniform", [0.001, 1.0], "contact"), &[0.01], "load at which contact begins");
    near(&crossed(&scene, depth, [1.0, 150.0], "clearance(5) = 7"), &[107.0], "depth for a clearance");
    let zone = 81.0 / (24.0 * stiffness);
    near(&crossed(&scene, depth, [1.0, 15.0], "support[0] = 1.5"), &[zone], "depth for a reaction beside a zone");
    let point = 100.0 - (0.5 * L - 3.0) * 2.0 * L.powi(3) / (48.0 * stiffness);
    near(&crossed(&scene, depth, [15.0, 150.0], "shear(0) = 3"), &[point], "depth for a shear force beside a point");
    near(&crossed(&scene, depth, [1.0, 19.0], "deflection(5) = 3"), &[3.0], "depth for a deflection in a zone");
}

/// The deflection at mid-span is `P l³/(48 EI)` when the force is there, and less otherwise.
#[test]
fn a_target_that_is_only_touched_is_found_and_one_beyond_has_a_nearest_value() {
    let scene = beam(&ends(L), 0.0, &[(1.0, 3.0)]);
    let most = 3.0 * L.powi(3) / (48.0 * EI);
    let search = |target: f64| find(&scene, "load.point[0].at", [0.3, 9.0], &format!("deflection(5) = {target}"));
    let touched = search(most).found;
    assert!(touched.len() == 1 && (touched[0].value - 5.0).abs() < 1e-5 && touched[0].until.is_none(), "{touched:?}");
    for above in [1.0 + 1e-9, 1.3] {
        let finding = search(above * most);
        let nearest = finding.nearest.expect("a nearest value");
        assert!((nearest.value - 5.0).abs() < 1e-5 && (nearest.reached - most).abs() < 1e-12 * most, "{nearest:?}");
    }
    assert_eq!(search((1.0 - 1e-9) * most).found.len(), 2);
}

/// Right of x = 4 the shear force is `P (1 − a/l)` with the force at `a` to the right of it, and `−P a/l` with the force to the left.
#[test]
fn a_jump_past_the_target_is_called_a_jump() {
    let scene = beam(&ends(L), 0.0, &[(1.0, 3.0)]);
    let found = find(&scene, "load.point[0].at", [0.3, 9.0], "shear(4) = 0.6").found;
    assert!(found[0].jumps && !found[1].jumps && found.len() == 2, "{found:?}");
    near(&[found[0].value, found[1].value], &[4.0, L * (1.0 - 0.6 / 3.0)], "a jump and a root");
}

/// Level ground stops the middle of the beam at its depth, from `5 q l⁴ = 384 EI u` on.
#[test]
fn a_target_that_stays_reached_is_a_stretch_of_values() {
    let scene = regimes(1.0);
    let found = find(&scene, "load.uniform", [0.001, 1.0], "deflection(5) = 1").found;
    assert_eq!((found.len(), found[0].until), (1, Some(1.0)), "{found:?}");
    near(&[found[0].value], &[0.01], "where it comes to rest");
    let nearest = find(&scene, "load.uniform", [0.001, 1.0], "deflection(5) = 2").nearest.expect("a nearest value");
    near(&[nearest.value, nearest.reached], &[0.01, 1.0], "where it comes to rest, the nearest value");
    let always = find(&scene, "load.uniform", [0.1, 1.0], "contact").nearest.expect("contact all the way");
    near(&[always.value], &[0.1], "the load that presses least");
    let ground = Some(Foundation::Flat { depth: 1.0 });
    let never = on_supports([L, EI], &ends(L), (0.1, &[]), ground);
    let nearest = find(&never, "load.uniform", [0.1, 0.7], "contact").nearest.expect("no contact");
    near(
        &[nearest.value, nearest.reached],
        &[0.7, 5.0 * 0.7 * L.powi(4) / (384.0 * EI) - 1.0],
        "the load that comes nearest",
    );
}

/// A stop under the middle of a simple beam is reached when `5 q l⁴/(384 EI)` is its play. The first of three bearings with the spacing `s`
/// is lost when a force in the middle of the second span is `4 q s`: `3 q s/8 = 3 P/32`.
#[test]
fn contact_with_bearings_begins_and_ends_where_the_closed_form_has_it() {
    let stop = Support { pushes_only: true, ..Support::simple(0.5 * L).at_level(0.02) };
    for stop in [stop, Support { stiffness: Some(700.0), ..stop }] {
        let supports = [Support::simple(0.0), stop, Support::simple(L)];
        let found = crossed(&beam(&supports, 1.0, &[]), "load.uniform", [0.01, 1.0], "contact");
        near(&found, &[384.0 * EI * 0.02 / (5.0 * L.powi(4))], "load that closes the play");
        let half = format!("clearance({}) = 0.01", 0.5 * L);
        let found = crossed(&beam(&supports, 1.0, &[]), "load.uniform", [0.01, 1.0], &half);
        near(&found, &[384.0 * EI * 0.01 / (5.0 * L.powi(4))], "load that leaves half of the play");
    }
    let supports = [Support::pushing(0.0), Support::simple(5.0), Support::simple(10.0)];
    let found = crossed(&beam(&supports, 1.0, &[(7.5, 1.0)]), "load.point[0].force", [1.0, 50.0], "contact");
    near(&found, &[20.0], "force that lifts the beam off its bearing");
    let neither = Until::parse("contact", &beam(&ends(L), 1.0, &[])).expect_err("nothing to touch").to_string();
    assert!(neither.contains("a foundation or a support with `pushes_only`"), "{neither}");
}
