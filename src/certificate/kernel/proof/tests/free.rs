//! Beams without supports, which contact forces hold.

use super::*;

/// A beam without supports above some ground.
fn free(ground: Foundation, load: f64, points: Vec<PointLoad>) -> Scene {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(Vec::new()).expect("none");
    let load = Load::new(&beam, load, Vec::new(), points).expect("finite");
    Scene::new(beam, load, Some(ground)).expect("well posed")
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64) {
    /// Of sums of a few dozen numbers, and of a lift that is found by parts.
    const CLOSE: f64 = 1e-9;
    assert!((found - expected).abs() <= CLOSE * expected, "{what}: {found}, not {expected}");
}

/// The beam on ridges at 5 and 15, `h = 10` apart, in each overhang `a = 5` of it. What is off:
///
/// - slopes there by `±δ`: of each half `r = −4 EI δ/5` beside the ridge and zero in the middle,
/// - a ridge in the middle, `w` below the beam, which pulls with `R = 48 EI w/h³`, less `4 EI δ/25` for the slopes,
/// - the end of the left overhang, which is in the ground and lifted by `α (s/a)²`.
fn on_ridges(delta: f64, w: f64, penetration: f64) -> Option<(Pair, f64)> {
    let (h, a) = (10.0, 5.0);
    let slope = LOAD * h * h * h / (24.0 * STIFFNESS) - LOAD * a * a * h / (4.0 * STIFFNESS) + 3.0 * w / h + delta;
    let middle = 1.0 + 5.0 * LOAD * h * h * h * h / (384.0 * STIFFNESS) - LOAD * a * a * h * h / (16.0 * STIFFNESS) + w;
    let tip = 1.0 - slope * a + LOAD * a * a * a * a / (8.0 * STIFFNESS);
    let ground =
        [[0.0, tip - penetration], [5.0, 1.0], [7.5, 40.0], [10.0, middle], [12.5, 40.0], [15.0, 1.0], [20.0, 40.0]];
    let nodes = [node(Kind::Corner, 5.0, slope), node(Kind::Corner, 10.0, 0.0), node(Kind::Corner, 15.0, -slope)];
    let (pair, _) = pair_of(&free(Foundation::Polyline { points: ground.to_vec() }, LOAD, Vec::new()), &nodes)?;
    Some((pair, 48.0 * STIFFNESS * w / (h * h * h) - 4.0 * STIFFNESS * delta / 25.0))
}

/// The roots of what slopes, lifts and pulls cost add up; what the two places that hold the beam are known by is the gap over what
/// is left of their forces, of which the pull takes.
#[test]
fn what_is_off_adds_up_and_places_are_as_good_as_their_forces() {
    for (delta, w, penetration) in
        [(0.0, 0.0, 0.0), (0.02, 0.0, 0.0), (0.0, 0.3, 0.0), (0.0, 0.0, 0.1), (0.02, 0.3, 0.1)]
    {
        let what = format!("{delta}, {w}, {penetration}");
        let (pair, pull) = on_ridges(delta, w, penetration).expect("held by two ridges");
        let alpha = pair.lifted;
        assert!(penetration <= alpha * (1.0 + ROUNDING) && alpha <= 2.0 * penetration + ROUNDING, "{what}: {alpha}");
        let slopes = (32.0 / 15.0 * STIFFNESS * delta * delta).sqrt();
        let lift = (STIFFNESS * alpha * alpha * 4.0 / 125.0).sqrt();
        let pulls = pull.max(0.0) * (1000.0 / (48.0 * STIFFNESS)).sqrt();
        let gap = 0.5 * (slopes + lift + pulls) * (slopes + lift + pulls);
        assert!((pair.gap - gap).abs() <= 1e-9 * gap + 1e-20, "{what}: {}, not {gap}", pair.gap);
        let [Line(left, right)] = pair.lines[..] else { panic!("{what}: one pair of places, not {:?}", pair.lines) };
        // A ridge in the middle that presses takes its part from the others.
        let force = 0.5 * (LOAD * LENGTH + pull) - pull.max(0.0);
        for (place, x) in [(left, 5.0), (right, 15.0)] {
            assert_eq!([place.from, place.to].map(f64::to_bits), [x, x].map(f64::to_bits), "{what}");
            assert!(
                (place.uncertainty - pair.gap / force).abs() <= 1e-9 * place.uncertainty + 1e-20,
                "{what}: {place:?} of {force}"
            );
        }
    }
    // More than is there cannot be taken.
    let most = 60.0 * 1000.0 / (48.0 * STIFFNESS);
    assert!(on_ridges(0.0, 0.99 * most, 0.0).is_some());
    assert!(on_ridges(0.0, 1.01 * most, 0.0).is_none());
}

/// On ground `u = 1 + c x²` the beam takes moments `−2 c EI` up to its ends, which nothing there can exert: couples that are cut
/// off, of which the outer thirds of the zone are worth `√((l + 3 l/3)/3 EI)` each, and take `2 c EI/(l/3)`.
#[test]
fn couples_at_free_ends_are_cut_off() {
    let c = 0.02;
    let parabola = Foundation::Polynomial { coefficients: vec![1.0, 0.0, c] };
    let nodes = [node(Kind::Start, 0.0, 0.0), node(Kind::End, LENGTH, 0.0)];
    let (pair, _) = pair_of(&free(parabola, LOAD, Vec::new()), &nodes).expect("it lies on the ground");
    let couple = 2.0 * c * STIFFNESS;
    let moments = 2.0 * couple * (2.0 * LENGTH / (3.0 * STIFFNESS)).sqrt();
    close("gap", pair.gap, 0.5 * moments * moments);
    let remains = LOAD * LENGTH / 3.0 - 2.0 * couple * 3.0 / LENGTH;
    let [Line(left, right)] = pair.lines[..] else { panic!("one pair of places, not {:?}", pair.lines) };
    for place in [left, right] {
        close("place", place.uncertainty, pair.gap / remains);
    }
}

/// The force on a crest.
const ON_CREST: f64 = 50.0;
/// The distance of the nearest stops from a crest.
const STOP: f64 = LENGTH / 274_877_906_944.0;

/// `u = 1 + c (x − m)²`.
fn crest(middle: f64, c: f64) -> Foundation {
    Foundation::Polynomial { coefficients: vec![1.0 + c * middle * middle, -2.0 * c * middle, c] }
}

/// A beam on the crest of `u = 1 + c (x − m)²`, below forces that bend it there by the moment `M`: beside the crest the clearance has
/// the curvature `2 c − M/EI`. The ground stops it at the distance `f` on both sides, where it is known by `f² (g − v̂)''/2`.
#[test]
fn a_single_place_is_stopped_on_both_of_its_sides() {
    let at = |x: f64| vec![PointLoad { at: x, force: ON_CREST }];
    let (pair, _) = pair_of(&free(crest(8.0, 0.25), 0.0, at(8.0)), &[node(Kind::Touch, 8.0, 0.0)]).expect("in balance");
    let [Line(left, right)] = pair.lines[..] else { panic!("one pair of places, not {:?}", pair.lines) };
    assert_eq!([left.from, right.from].map(f64::to_bits), [8.0 - STOP, 8.0 + STOP].map(f64::to_bits));
    for place in [left, right] {
        // Half as much again for places that are rounded.
        let expected = 0.25 * STOP * STOP;
        assert!((expected..1.5 * expected).contains(&place.uncertainty), "{place:?}, not {expected}");
    }
    assert!(pair.gap <= 1e-20, "{}", pair.gap);
    // A couple takes stops that are farther away, so that its share of the force is a sixteenth at each.
    let beside =
        pair_of(&free(crest(8.0, 0.25), 0.0, at(8.25)), &[node(Kind::Touch, 8.0, 0.0)]).expect("not much beside");
    for Line(left, right) in &beside.0.lines {
        close("left place", left.from, 4.0);
        close("right place", right.from, 12.0);
    }
    // The couple 50/4 at the crest, taken by either of two spans of 4, and what presses at both stops, where the clearance is 4.
    let moments = 12.5 * (2.0 + 2.0) / (3.0 * STIFFNESS).sqrt();
    close("gap", beside.0.gap, 0.5 * moments * moments + 2.0 * (12.5 / 4.0) * 4.0);
    // Where the beam lies on the ground on both sides, it is not open there at all.
    let (pair, _) = pair_of(
        &free(Foundation::Flat { depth: 1.0 }, 0.0, at(7.0)),
        &[node(Kind::Start, 4.0, 0.0), node(Kind::End, 16.0, 0.0)],
    )
    .expect("a load that stands in a zone");
    for Line(left, right) in pair.lines {
        assert!(
            left.from < 7.0 && 7.0 < right.from && left.uncertainty.max(right.uncertainty) <= 1e-25,
            "{left:?}, {right:?}"
        );
    }
    // A slope that is that of the crest, and nobody knows it.
    for slope in [0.0, 1e-3, -1e-3, 0.1] {
        assert!(pair_of(&free(crest(8.0, 0.25), 0.0, at(8.0)), &[node(Kind::Corner, 8.0, slope)]).is_none(), "{slope}");
    }
    // A load so far beside it that the stops would have to press with more than what is there.
    assert!(pair_of(&free(crest(8.0, 0.25), 0.0, at(15.0)), &[node(Kind::Touch, 8.0, 0.0)]).is_none());
}

/// On the same crest, bent by forces at both ends.
#[test]
fn a_bent_beam_on_a_crest_is_stopped_where_it_is_open() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(Vec::new()).expect("none");
    for mirrored in [false, true] {
        let x = |x: f64| if mirrored { LENGTH - x } else { x };
        let points = vec![
            PointLoad { at: x(0.0), force: 8.0 },
            PointLoad { at: x(8.0), force: ON_CREST },
            PointLoad { at: x(LENGTH), force: 16.0 / 3.0 },
        ];
        let load = Load::new(&beam, 0.0, Vec::new(), points).expect("finite");
        let scene = Scene::new(beam.clone(), load, Some(crest(x(8.0), 2.0))).expect("well posed");
        let (pair, _) = pair_of(&scene, &[node(Kind::Touch, x(8.0), 0.0)]).expect("in balance");
        let expected = 0.5 * STOP * STOP * (4.0 - 64.0 / STIFFNESS);
        for Line(left, right) in pair.lines {
            assert!(
                (expected..1.5 * expected).contains(&left.uncertainty.max(right.uncertainty)),
                "{left:?}, not {expected}"
            );
        }
    }
}

/// On a ridge between two slopes the beam turns until it lies on one of them, by as much as the bound says; on sleepers beside the
/// ridge, as far as they are below it.
#[test]
fn on_a_ridge_a_beam_turns_as_far_as_the_ground_lets_it() {
    let at = |x: f64| vec![PointLoad { at: x, force: 50.0 }];
    let turned = |ground: Vec<[f64; 2]>, x: f64| {
        let scene = free(Foundation::Polyline { points: ground }, 0.0, at(x));
        let (pair, _) = pair_of(&scene, &[node(Kind::Corner, x, 0.0)]).expect("a ridge carries it");
        assert!(pair.gap <= 1e-20, "{}", pair.gap);
        let [Line(left, right)] = pair.lines[..] else { panic!("one pair of places, not {:?}", pair.lines) };
        [(left.from, left.uncertainty), (right.from, right.uncertainty)]
    };
    let found = turned(vec![[0.0, 9.0], [8.0, 1.0], [LENGTH, 9.0]], 8.0);
    // Down by 8 at the left end, which lifts the right end by 8 · 12/8; and down by 8 at the right end.
    for ((place, off), [x, expected]) in found.into_iter().zip([[0.0, 8.0], [LENGTH, 12.0]]) {
        assert!((place - x).abs() <= 0.0, "{place}, not {x}");
        close("off", off, expected);
    }
    for [below, above] in [[0.0, 0.0], [0.5, 0.0], [0.0, 0.25], [0.5, 0.25]] {
        let ground = [
            [0.0, 9.0],
            [2.0, 1.0 + below],
            [4.0, 9.0],
            [8.0, 1.0],
            [10.0, 9.0],
            [11.0, 1.0 + above],
            [12.0, 9.0],
            [LENGTH, 9.0],
        ];
        // The ends of the beam are stopped by ground that is deeper.
        let found = turned(ground.to_vec(), 8.0);
        let expected = [below.max(2.0 * above), above.max(0.5 * below)];
        for ((place, off), (x, expected)) in found.into_iter().zip([2.0, 11.0].into_iter().zip(expected)) {
            assert!((place - x).abs() <= 0.0, "{place}, not {x}");
            assert!((off - expected).abs() <= 1e-12, "{off}, not {expected}, at {x}");
        }
    }
}

/// Loads in balance above the end of the ground: a beam that touches there may turn, and of one that touches elsewhere nothing
/// follows.
#[test]
fn a_beam_in_balance_turns_about_one_place_alone() {
    for about in [0.0, LENGTH] {
        let scene = free(Foundation::Flat { depth: 1.0 }, 0.0, vec![PointLoad { at: about, force: 5.0 }]);
        let balance = scene.scaled().expect("finite").balance;
        assert!(matches!(balance, Balance::Neutral { .. }), "{balance:?}");
        let Balance::Neutral { resultant, .. } = balance else { return };
        let pair_at = |kind: Kind, x: f64| {
            in_intervals(&scene, Balance::Neutral { resultant, about }, |enclosed| {
                pair(enclosed, &[node(kind, x, 0.0)])
            })
        };
        let known = pair_at(Kind::Corner, about).expect("it is in balance");
        assert_eq!(known.turns_about, Some(about));
        let [Line(left, right)] = known.lines[..] else { panic!("one place, not {:?}", known.lines) };
        assert_eq!([left.from, left.to, right.from, right.to].map(f64::to_bits), [about.to_bits(); 4]);
        assert!(known.gap <= 0.0, "{}", known.gap);
        for x in [3.0, LENGTH - about] {
            assert!(pair_at(Kind::Touch, x).is_none(), "a contact at {x}");
        }
    }
}
