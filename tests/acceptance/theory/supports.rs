//! Beams on other supports than the paper's, beside closed forms that have no place in `palkki_evidence::closed`: an edge,
//! beams that may turn, and what is refused.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, SceneError, Support};
use palkki::theory::Exact;

use super::{close, solved};

const L: f64 = 10.0;
const EI: f64 = 1.3;
const Q: f64 = 0.7;

fn flat(depth: f64) -> Option<Foundation> {
    Some(Foundation::Flat { depth })
}

fn beam(supports: Vec<Support>) -> Beam {
    Beam::new(L, EI).and_then(|beam| beam.with_supports(supports)).expect("a beam")
}

/// The certified answer of a beam under the uniform load.
#[track_caller]
fn uniform(beam: Beam, ground: Option<Foundation>) -> Exact {
    let load = Load::uniform_on(&beam, Q).expect("a load");
    solved(&Scene::new(beam, load, ground).expect("a scene"))
}

/// Over an edge with an overhang `b` the beam lifts off behind it over `s`: with `T` at lift-off `v(s) = 0` gives `T = q s/4`, and
/// `M(s) = −q s²/4` is that of the overhang, `−q b²/2`: `s = √2 b`.
#[test]
fn a_beam_lies_over_an_edge() {
    let b = 2.0;
    let c = L - b;
    let ground = Foundation::Polyline { points: vec![[0.0, 1.0], [c, 1.0], [c, 100.0], [L, 100.0]] };
    let exact = uniform(beam(Vec::new()), Some(ground));
    let [zone, edge] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    let s = b * 2.0_f64.sqrt();
    close("the zone starts at the free end", zone.from, 0.0);
    close("lift-off", zone.to, c - s);
    close("force at lift-off", zone.end_forces.expect("a zone")[1], Q * s / 4.0);
    close("the edge", edge.from, c);
    close("force of the edge", edge.force, Q * (b + 0.75 * s));
    close("moment over the edge", exact.moment(c), -Q * b * b / 2.0);
    // The overhang sags by what its slope at the edge and its own load make.
    let slope = Q * s * s * s / (24.0 * EI);
    close("tip", exact.deflection(L), 1.0 + slope * b + Q * b.powi(4) / (8.0 * EI));
}

/// In balance on its one support above flat ground: the tip of the sagging beam limits how far it may turn.
#[test]
fn a_seesaw_in_balance() {
    let (half, d) = (L / 2.0, 60.0);
    let exact = uniform(beam(vec![Support::simple(half)]), flat(d));
    let sag = Q * half.powi(4) / (8.0 * EI);
    let motion = exact.state.standing.and_then(|standing| standing.motion).expect("it may turn");
    close("about", motion.about, half);
    close("least slope", motion.slope[0].expect("the ground is in the way"), -(d - sag) / half);
    close("greatest slope", motion.slope[1].expect("the ground is in the way"), (d - sag) / half);
    close("level", exact.slope(half), 0.0);
    close("force", exact.state.supports[0].force, Q * L);
    // Without ground nothing limits it, and forces and energy are the same.
    let above = uniform(beam(vec![Support::simple(half)]), None);
    let motion = above.state.standing.and_then(|standing| standing.motion);
    assert_eq!(motion.map(|motion| motion.slope), Some([None; 2]));
    close("energy", above.state.energy, exact.state.energy);
}

/// Above ground `u = d + m t + c t²`, `t` from the place of its one support, a straight beam at level 0 may turn as long as
/// `s t ≤ u`: on the right `s ≤ m + min (d/t + c t)` and on the left `s ≥ m − min (d/|t| + c |t|)`. The least is `2 √(c d)` at
/// `|t| = √(d/c)`, or where the beam ends, and for `d = 0` it is at the support or where the beam ends.
#[test]
fn a_seesaw_above_a_parabola() {
    const M: f64 = -3.0;
    let turned = |at: f64, d: f64, c: f64| {
        let beam = beam(vec![Support::simple(at)]);
        let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at, force: 2.0 }]).expect("a load");
        let ground = Foundation::Polynomial { coefficients: vec![d - M * at + c * at * at, M - 2.0 * c * at, c] };
        let exact = solved(&Scene::new(beam, load, Some(ground)).expect("a scene"));
        close("force", exact.state.supports[0].force, 2.0);
        (exact.slope(at), exact.state.standing.and_then(|standing| standing.motion))
    };
    let [left, right] = [4.0, L - 4.0];
    // Near on both sides; far on both; far on the left alone; far, where the ground rises towards both ends.
    for (d, c, least) in [
        (0.5, 0.5, [1.0, 1.0]),
        (50.0, 0.5, [50.0 / left + 0.5 * left, 50.0 / right + 0.5 * right]),
        (12.5, 0.5, [12.5 / left + 0.5 * left, 5.0]),
        (20.0, -0.25, [20.0 / left - 0.25 * left, 20.0 / right - 0.25 * right]),
    ] {
        let (slope, motion) = turned(4.0, d, c);
        let [from, to] = [M - least[0], M + least[1]];
        let motion = motion.expect("it may turn").slope.map(|slope| slope.expect("the ground is in the way"));
        close("least slope", motion[0], from);
        close("greatest slope", motion[1], to);
        close("nearest to zero", slope, 0.0_f64.clamp(from, to));
    }
    // Ground at the level of the support leaves no other slope than its own.
    let (slope, motion) = turned(4.0, 0.0, 0.5);
    close("along the ground", slope, M);
    assert_eq!(motion, None);
    // On the end of the beam, where there is ground on one side only, near and far.
    for (c, least) in [(0.5, 0.0), (-0.25, -0.25 * L)] {
        let (slope, motion) = turned(0.0, 0.0, c);
        let motion = motion.expect("it may turn");
        assert_eq!(motion.slope[0], None, "nothing limits how far the other end may rise");
        close("greatest slope", motion.slope[1].expect("the ground is in the way"), M + least);
        close("nearest to zero", slope, M + least);
    }
}

/// All of the load above the end of the ground: the beam may stand on it at any slope that keeps the other end up.
#[test]
fn a_beam_that_stands_on_its_end() {
    let beam = beam(Vec::new());
    let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 0.0, force: 2.0 }]).expect("a load");
    let exact = solved(&Scene::new(beam, load, flat(1.0)).expect("a scene"));
    let motion = exact.state.standing.and_then(|standing| standing.motion).expect("it may turn");
    close("about", motion.about, 0.0);
    close("greatest slope", motion.slope[1].expect("the ground is in the way"), 0.0);
    assert_eq!(motion.slope[0], None, "nothing limits how far the other end may rise");
    close("force", exact.state.contacts[0].force, 2.0);
}

/// Ground at the level of a simple support may fall off on both sides of it and not rise on both: no slope of the beam would do.
#[test]
fn a_support_in_a_valley_is_refused() {
    let ground = |outside: f64| Foundation::Polyline { points: vec![[0.0, outside], [4.0, 3.0], [L, outside]] };
    let supported = || beam(vec![Support::simple(0.0), Support::simple(4.0).at_level(3.0)]);
    let scene = |outside| Scene::new(supported(), Load::default(), Some(ground(outside)));
    assert_eq!(scene(1.0), Err(SceneError::ValleyAtSupport { at: 4.0, slopes: [0.5, -2.0 / 6.0] }));
    assert!(scene(5.0).is_ok());
}

/// Ground that rises towards a built-in support and falls off there in a step.
#[test]
fn ground_that_rises_to_a_step_is_refused_at_a_built_in_support() {
    let held = Support { level: 3.0, slope: Some(0.0), ..Support::simple(4.0) };
    let ground = Foundation::Polyline { points: vec![[0.0, 1.0], [4.0, 3.0], [4.0, 7.0], [L, 7.0]] };
    let refused = SceneError::RisesAtBuiltIn { at: 4.0, side: "left", slope: 0.5, held: 0.0 };
    assert_eq!(Scene::new(beam(vec![held]), Load::default(), Some(ground)), Err(refused));
}
