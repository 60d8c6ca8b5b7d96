//! Beams on other supports than the paper's, beside closed forms. In all of them `h''` of a free span and of the zone beside it
//! agree at the end of the zone, and a uniform load `q` makes a span between two such conditions a power of its length:
//!
//! ```text
//! hinge to zone       v = q(x⁴ − 2ax³ + …):   EI d = q a⁴/24,   force at lift-off q a/2,   reaction q a/2
//! built in to zone                            EI d = q a⁴/72,   force at lift-off q a/3,   reaction 2q a/3,   moment −q a²/6
//! ```

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, SceneError, Support};
use palkki::state::Standing;
use palkki::theory::{Exact, solve};

const DIGITS: f64 = 1e-12;
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
    answer(&Scene::new(beam, load, ground).expect("a scene"))
}

#[track_caller]
fn answer(scene: &Scene) -> Exact {
    let exact = solve(scene).expect("an answer");
    assert!(exact.solved, "{:?}", exact.violations);
    exact
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64) {
    assert!((found - expected).abs() <= DIGITS * expected.abs().max(1.0), "{what}: {found} instead of {expected}");
}

/// `∛`, `⁴√` of a positive number.
fn fourth_root(x: f64) -> f64 {
    x.sqrt().sqrt()
}

/// The tip touches: `q l⁴/8EI − P l³/3EI = d`, as long as it does not slope upwards, `q l⁴ ≤ 72 EI d`.
#[test]
fn a_cantilever_touches_with_its_tip() {
    let d = Q * L.powi(4) / (30.0 * EI);
    let exact = uniform(beam(vec![Support::built_in(0.0)]), flat(d));
    let force = 3.0 * Q * L / 8.0 - 3.0 * EI * d / L.powi(3);
    let [tip] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    close("place", tip.from, L);
    close("force", tip.force, force);
    let [support] = exact.state.supports[..] else { panic!("{:?}", exact.state.supports) };
    close("reaction", support.force, Q * L - force);
    close("moment", support.moment.expect("built in"), force * L - Q * L * L / 2.0);
    assert_eq!((exact.unknowns, exact.iterations), (0, 0));
}

/// A zone from `a` to the free end, `EI d = q a⁴/72`; in the span `∫v = q a⁵/120EI`, and
/// `J = −½∫q v − ½ d ∫p` as `v = d` wherever the ground pushes.
#[test]
fn a_cantilever_lies_on_the_ground_up_to_its_tip() {
    let a = 4.0;
    let d = Q * a * a * a * a / (72.0 * EI);
    for mirrored in [false, true] {
        let place = |x: f64| if mirrored { L - x } else { x };
        let exact = uniform(beam(vec![Support::built_in(place(0.0))]), flat(d));
        let [zone] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
        let ends = zone.end_forces.expect("a zone has end forces");
        let (near, far) = if mirrored {
            ((zone.to, ends[1]), (zone.from, ends[0]))
        } else {
            ((zone.from, ends[0]), (zone.to, ends[1]))
        };
        close("lift-off", near.0, place(a));
        close("free end", far.0, place(L));
        close("force at lift-off", near.1, Q * a / 3.0);
        close("force at the free end", far.1, 0.0);
        close("reaction", exact.state.supports[0].force, 2.0 * Q * a / 3.0);
        close("moment", exact.state.supports[0].moment.expect("built in"), -Q * a * a / 6.0);
        let rest = Q * (L - a);
        let energy = -0.5 * (Q * Q * a.powi(5) / (120.0 * EI) + rest * d) - 0.5 * d * (Q * a / 3.0 + rest);
        close("energy", exact.state.energy, energy);
        assert_eq!(exact.unknowns, 1);
    }
}

/// Built in at both ends: at mid-span `P = q l/2 − 192 EI d/l³`, and a zone from `q l⁴ = 1152 EI d` on.
#[test]
fn a_beam_built_in_at_both_ends() {
    let supports = vec![Support::built_in(0.0), Support::built_in(L)];
    let d = Q * L.powi(4) / (700.0 * EI);
    let exact = uniform(beam(supports.clone()), flat(d));
    let force = Q * L / 2.0 - 192.0 * EI * d / L.powi(3);
    close("place", exact.state.contacts[0].from, L / 2.0);
    close("force", exact.state.contacts[0].force, force);
    close("moment", exact.state.supports[1].moment.expect("built in"), force * L / 8.0 - Q * L * L / 12.0);
    let a = 3.0;
    let exact = uniform(beam(supports), flat(Q * a * a * a * a / (72.0 * EI)));
    let zone = exact.state.contacts[0];
    close("from", zone.from, a);
    close("to", zone.to, L - a);
    for support in &exact.state.supports {
        close("reaction", support.force, 2.0 * Q * a / 3.0);
        close("moment", support.moment.expect("built in"), -Q * a * a / 6.0);
    }
}

#[test]
fn a_beam_hangs_over_its_supports() {
    let a = 1.5;
    let exact = uniform(beam(vec![Support::simple(L - a), Support::simple(a)]), None);
    for support in &exact.state.supports {
        close("reaction", support.force, Q * L / 2.0);
        assert_eq!(support.moment, None);
    }
    close("moment at a support", exact.moment(a), -Q * a * a / 2.0);
    close("moment at mid-span", exact.moment(L / 2.0), Q * (L - 2.0 * a).powi(2) / 8.0 - Q * a * a / 2.0);
    close("moment at the free end", exact.moment(L), 0.0);
    close("shear at the free end", exact.shear(0.0)[1], 0.0);
}

/// Over the middle support the beam is as if it were built in; the end supports are hinges.
#[test]
fn two_spans_with_a_zone_in_each() {
    let b = 2.0;
    let d = Q * b * b * b * b / (72.0 * EI);
    let a = fourth_root(24.0 * EI * d / Q);
    let exact = uniform(beam(vec![Support::simple(0.0), Support::simple(L / 2.0), Support::simple(L)]), flat(d));
    let [left, right] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    for (found, expected) in [(left.from, a), (left.to, L / 2.0 - b), (right.from, L / 2.0 + b), (right.to, L - a)] {
        close("end of a zone", found, expected);
    }
    let [end, middle, other] = exact.state.supports[..] else { panic!("three supports") };
    close("end reaction", end.force, Q * a / 2.0);
    close("end reaction", other.force, Q * a / 2.0);
    close("middle reaction", middle.force, 4.0 * Q * b / 3.0);
    close("moment over the middle", exact.moment(L / 2.0), -Q * b * b / 6.0);
}

/// `R = 5q(2s)/8 − 6EI δ/s³` of the middle support, which pulls the beam down in the end.
#[test]
fn a_middle_support_settles() {
    let s = L / 2.0;
    for delta in [-3.0, 0.0, 0.1, 40.0] {
        let supports = vec![Support::simple(0.0), Support::simple(s).at_level(delta), Support::simple(L)];
        let exact = uniform(beam(supports), None);
        close("reaction", exact.state.supports[1].force, 1.25 * Q * s - 6.0 * EI * delta / s.powi(3));
        close("level", exact.deflection(s), delta);
    }
    // Without loads the levels alone bend it.
    let supports = vec![Support::simple(0.0), Support::simple(s).at_level(1.0), Support::simple(L)];
    let exact = answer(&Scene::new(beam(supports), Load::default(), None).expect("a scene"));
    close("reaction", exact.state.supports[1].force, -6.0 * EI / s.powi(3));
}

/// A beam on the floor is lifted at one end: hinge to zone, and the zone reaches the other end.
#[test]
fn a_floor_beam_is_lifted_at_one_end() {
    let a = 3.5;
    let height = Q * a * a * a * a / (24.0 * EI);
    let exact = uniform(beam(vec![Support::simple(0.0).at_level(-height)]), flat(0.0));
    close("reaction", exact.state.supports[0].force, Q * a / 2.0);
    let zone = exact.state.contacts[0];
    close("lift-off", zone.from, a);
    close("free end", zone.to, L);
    close("force at lift-off", zone.end_forces.expect("a zone")[0], Q * a / 2.0);
    let Standing { resultant, margin, .. } = exact.state.standing.expect("one support does not hold it");
    close("resultant", resultant.force, Q * L);
    close("its place", resultant.at, L / 2.0);
    close("margin", margin, 0.5);
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

/// An arch of height `c` over `l` stands on its two ends; under `5 q l⁴/384EI > c` its middle touches as well, with
/// `R = 5q l/8 − 48EI c/l³`.
#[test]
fn a_ski_closes_under_its_load() {
    let arch = |c: f64| {
        let shape = Foundation::Polynomial { coefficients: vec![0.0, -4.0 * c / L, 4.0 * c / (L * L)] };
        beam(Vec::new()).with_shape(shape).expect("a shape")
    };
    let full = 5.0 * Q * L.powi(4) / (384.0 * EI);
    let exact = uniform(arch(1.5 * full), flat(0.0));
    let [left, right] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    close("force of an end", left.force, Q * L / 2.0);
    close("the other end", right.from, L);
    close("clearance of the middle", exact.clearance(L / 2.0), 0.5 * full);
    close("moment", exact.moment(L / 2.0), Q * L * L / 8.0);
    let c = 0.95 * full;
    let exact = uniform(arch(c), flat(0.0));
    let [_, middle, _] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    close("the middle", middle.from, L / 2.0);
    close("its force", middle.force, 5.0 * Q * L / 8.0 - 48.0 * EI * c / L.powi(3));
}

/// On a hump of curvature `k` a free beam lies as far as its overhangs are bent as much, `q b²/2 = EI k`; where the hump is too
/// sharp it rocks on one point.
#[test]
fn a_hump_under_a_free_beam() {
    let hump = |k: f64| Foundation::Polynomial { coefficients: vec![k * L * L / 8.0, -k * L / 2.0, k / 2.0] };
    let b = 3.0;
    let k = Q * b * b / (2.0 * EI);
    let exact = uniform(beam(Vec::new()), Some(hump(k)));
    let zone = exact.state.contacts[0];
    close("from", zone.from, b);
    close("to", zone.to, L - b);
    for force in zone.end_forces.expect("a zone") {
        close("force at an end", force, Q * b);
    }
    let exact = uniform(beam(Vec::new()), Some(hump(4.0 * k)));
    let [point] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    close("place", point.from, L / 2.0);
    close("force", point.force, Q * L);
    let margin = exact.state.standing.expect("nothing holds it").margin;
    assert!(margin.abs() <= 0.0, "a single place: {margin}");
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
        let exact = answer(&Scene::new(beam, load, Some(ground)).expect("a scene"));
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
    let exact = answer(&Scene::new(beam, load, flat(1.0)).expect("a scene"));
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
