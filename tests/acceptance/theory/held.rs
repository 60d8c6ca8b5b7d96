//! Random beams on random supports, beside the definition of the problem: it is convex, so that an answer that meets all of its
//! conditions is the answer. Nothing here is taken from the search or from its check.
//!
//! ```text
//! statics     V' = p − q, M' = V between places, V jumps by the forces there, M not but at a held slope; zero beyond both ends
//! beam        v(b) = v(a) + v'(a)(b − a) − ∫ M/EI (b − x) dx
//! supports    v = d_s, and v' = φ_s where built in
//! contact     h ≥ 0,  forces and pressure ≥ 0,  h = 0 where they act
//! ```

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::theory::{Exact, TheoryError, solve};
use palkki_evidence::random::{Random, held};

/// What may be off, of the largest deflection, moment or force: ten times what the check of beam theory allows.
const OFF: f64 = 1e-11;
/// Two-point Gauss quadrature of a cubic, and of the quadratic moment under a uniform load times a lever.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Places and weights of five-point Gauss quadrature on `[−1, 1]`: of a load and a pressure, over a two-hundredth of the beam.
const FIVE: [[f64; 2]; 5] = [
    [0.0, 0.568_888_888_888_888_9],
    [0.538_469_310_105_683_1, 0.478_628_670_499_366_5],
    [-0.538_469_310_105_683_1, 0.478_628_670_499_366_5],
    [0.906_179_845_938_664, 0.236_926_885_056_189_1],
    [-0.906_179_845_938_664, 0.236_926_885_056_189_1],
];

/// What loads and pressure between `a` and `b` do, `∫ (q − p) dx` and `∫ (q − p) (b − x) dx`, without concentrated forces.
fn carried(scene: &Scene, exact: &Exact, [a, b]: [f64; 2]) -> [f64; 2] {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    FIVE.iter().fold([0.0; 2], |[force, moment], [place, weight]| {
        let x = middle + half * place;
        let part = half * weight * (scene.load().uniform() - exact.pressure(x));
        [force + part, moment + part * (b - x)]
    })
}

/// The concentrated force from `from` to `to`, one place up to rounding, upwards: of supports and contacts, less the point loads. A
/// load inside a zone is carried there.
fn concentrated(scene: &Scene, exact: &Exact, [from, to]: [f64; 2]) -> f64 {
    let here = |at: f64| from <= at && at <= to;
    let state = &exact.state;
    let zoned = !state.supports.iter().any(|s| here(s.at)) && state.contacts.iter().any(|c| c.from < from && to < c.to);
    let loads: f64 = scene.load().point().iter().filter(|p| !zoned && here(p.at)).map(|p| p.force).sum();
    let supports: f64 = state.supports.iter().filter(|s| here(s.at)).map(|s| s.force).sum();
    let ends = state.contacts.iter().flat_map(|c| {
        let [first, last] = c.end_forces.unwrap_or([c.force, 0.0]);
        [(c.from, first), (c.to, last)]
    });
    supports - loads + ends.filter(|(at, _)| here(*at)).map(|(_, force)| force).sum::<f64>()
}

/// Whether the moment may jump at a place, down and up: only at a support that holds the slope, built in, or by ground that pushes
/// beside it while the support pulls, which on its left makes the moment jump up and on its right down.
fn couples(scene: &Scene, [from, to]: [f64; 2]) -> [bool; 2] {
    let held = scene.held().into_iter().find(|held| from <= held.at && held.at <= to);
    held.map_or([false; 2], |held| [1, 0].map(|side| held.slope.is_some() || held.grounded[side]))
}

/// The conditions that an answer fails, with by how much.
fn wrong(scene: &Scene, exact: &Exact) -> Vec<String> {
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let mut wrong = Vec::new();
    let state = &exact.state;
    let deflection = state.deflection.max.abs().max(state.deflection.min.abs()).max(1e-3 * size(scene));
    let moment = state.moment.max.abs().max(state.moment.min.abs()).max(1e-3 * scene.load().magnitude(length) * length);
    let force = moment / length;
    let mut check = |what: String, off: f64, scale: f64| {
        if off.is_nan() || OFF * scale < off {
            wrong.push(format!("{what}: {off:e} of {scale:e}"));
        }
    };
    for held in scene.held() {
        check(format!("level at {}", held.at), (exact.deflection(held.at) - held.deflection).abs(), deflection);
        if let Some(slope) = held.slope {
            check(format!("slope at {}", held.at), (exact.slope(held.at) - slope).abs() * length, deflection);
        }
    }
    for contact in &state.contacts {
        let [first, last] = contact.end_forces.unwrap_or([contact.force; 2]);
        check(format!("pull at {}", contact.from), -first.min(last), force);
        for x in [contact.from, 0.5 * (contact.from + contact.to), contact.to] {
            check(format!("gap in contact at {x}"), exact.clearance(x).abs(), deflection);
            check(format!("pressure at {x}"), -exact.pressure(x), force / length);
        }
    }
    // Places where something begins, and points between.
    let mut places: Vec<f64> = (0..=200).map(|k| length * f64::from(k) / 200.0).collect();
    places.extend(state.contacts.iter().flat_map(|c| [c.from, c.to]));
    places.extend(scene.load().point().iter().map(|p| p.at));
    places.extend(scene.held().iter().map(|held| held.at));
    for profile in scene.foundation().into_iter().chain(scene.beam().shape()) {
        if let Foundation::Polyline { points } = profile {
            places.extend(points.iter().map(|p| p[0]));
        }
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    let zoned = |x: f64| state.contacts.iter().any(|c| c.from < x && x < c.to);
    for pair in places.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        check(format!("penetration at {a}"), -exact.clearance(a), deflection);
        // M is continuous but for the couples of built-in supports and of ground beside a support.
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let gauss = [middle - GAUSS * half, middle + GAUSS * half];
        let [near, far] = gauss.map(|x| exact.moment(x) / stiffness * half);
        let bent = exact.deflection(a) + exact.slope(b) * (b - a) + near * (gauss[0] - a) + far * (gauss[1] - a);
        if !zoned(middle) {
            check(format!("bending from {a} to {b}"), (exact.deflection(b) - bent).abs(), deflection);
        }
    }
    // Every part of the beam is in equilibrium, and every place, with nothing beyond the ends.
    let shear = |x: f64| {
        let [left, right] = exact.shear(x);
        [if x <= 0.0 { 0.0 } else { left }, if length <= x { 0.0 } else { right }]
    };
    let shears = places.iter().flat_map(|&x| shear(x)).fold(force, |most, v| most.max(v.abs()));
    // A unit in the last place of a place moves the moment by so much of the shear force.
    let moment = moment.max(f64::EPSILON * length * shears / OFF);
    // Places that differ by rounding are one.
    let same = |a: &f64, b: &f64| b - a <= 4.0 * f64::EPSILON * length;
    let places: Vec<[f64; 2]> = places.chunk_by(same).map(|group| [group[0], group[group.len() - 1]]).collect();
    for pair in places.windows(2) {
        let (a, b) = (pair[0][1], pair[1][0]);
        let [turned, sheared] = [moment_before(exact, b) - exact.moment(a), shear(b)[0] - shear(a)[1]];
        let [load, lever] = carried(scene, exact, [a, b]);
        let size = moment.max(shears * (b - a));
        check(format!("shear from {a} to {b}"), (sheared + load).abs(), shears);
        check(format!("moment from {a} to {b}"), (turned - shear(a)[1] * (b - a) + lever).abs(), size);
    }
    for &[from, to] in &places {
        let force = shear(to)[1] - shear(from)[0] - concentrated(scene, exact, [from, to]);
        check(format!("force at {from}"), force.abs(), shears);
        if 0.0 < from && to < length {
            let jump = exact.moment(to) - moment_before(exact, from);
            let [down, up] = couples(scene, [from, to]);
            check(format!("moment that jumps up at {from}"), if up { 0.0 } else { jump }, moment);
            check(format!("moment that jumps down at {from}"), if down { 0.0 } else { -jump }, moment);
        }
    }
    check("moment at the left end".to_owned(), couple_free(scene, 0.0) * exact.moment(0.0).abs(), moment);
    check("moment at the right end".to_owned(), couple_free(scene, length) * exact.moment(length).abs(), moment);
    let carried: f64 = state.supports.iter().map(|s| s.force).sum::<f64>() + state.contact_force();
    let forces: f64 = state.supports.iter().map(|s| s.force.abs()).sum();
    check("balance".to_owned(), (scene.load().resultant(length) - carried).abs(), 100.0 * force.max(forces));
    wrong
}

/// The size of what is given across the beam.
fn size(scene: &Scene) -> f64 {
    let length = scene.beam().length();
    let profiles = scene.foundation().into_iter().chain(scene.beam().shape());
    profiles.map(|profile| profile.magnitude(length)).fold(0.0, f64::max)
}

/// 1 at an end of the beam where nothing can hold its slope, and 0 elsewhere.
fn couple_free(scene: &Scene, end: f64) -> f64 {
    let held = scene.held().into_iter().find(|held| held.at <= end && end <= held.at);
    f64::from(held.is_none_or(|held| held.slope.is_none() && held.grounded == [false; 2]))
}

#[test]
fn random_beams_meet_the_definition() {
    let (mut certified, mut refused) = (0, 0);
    let mut open = Vec::new();
    for i in 0..2000 {
        let scene = held(i);
        match solve(&scene) {
            Ok(exact) if exact.solved => {
                certified += 1;
                let wrong = wrong(&scene, &exact);
                assert!(wrong.is_empty(), "{i}: {wrong:#?}\n{scene:#?}\n{:#?}", exact.state);
            }
            Ok(exact) => open.push((i, exact.violations)),
            Err(TheoryError::Scene(_)) => refused += 1,
            Err(error) => panic!("{i}: {error}"),
        }
    }
    assert!(refused < 200, "{refused} are not held");
    assert!(2000 <= certified + refused + 10, "{certified} certified, open: {open:#?}");
}

/// The moment just to the left of `x`.
fn moment_before(exact: &Exact, x: f64) -> f64 {
    exact.moment(x.next_down())
}

fn forces(exact: &Exact) -> Vec<f64> {
    let contacts = exact.state.contacts.iter().flat_map(|c| [c.from, c.to, c.force]);
    contacts.chain(exact.state.supports.iter().map(|s| s.force)).collect()
}

#[track_caller]
fn same(what: &str, found: &[f64], expected: &[f64], scale: f64) {
    let close = found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-9 * scale.max(b.abs()));
    assert!(close, "{what}: {found:?} instead of {expected:?}");
}

fn certified(scene: &Scene) -> Option<Exact> {
    solve(scene).ok().filter(|exact| exact.solved)
}

/// Ground + a + bx has the same forces under a free body, and its mirror image the mirrored ones.
#[test]
fn a_free_body_feels_no_plane() {
    let mut random = Random::new(11);
    let mut compared = 0;
    for _ in 0..60 {
        let length = random.between(2.0, 12.0);
        let beam =
            Beam::new(length, random.between(1.0, 100.0)).and_then(|b| b.with_supports(Vec::new())).expect("a beam");
        let load =
            Load::new(&beam, random.between(0.5, 2.0), Vec::new(), vec![PointLoad { at: 0.6 * length, force: 1.0 }]);
        let load = load.expect("a load");
        let c = [random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.02, 0.02)];
        let ground = |a: f64, b: f64| Foundation::Polynomial {
            coefficients: vec![a, b, c[0], c[1] / length, c[2] / (length * length)],
        };
        let plain = Scene::new(beam.clone(), load.clone(), Some(ground(0.0, 0.0))).expect("a scene");
        let tilted = Scene::new(beam.clone(), load.clone(), Some(ground(3.0, 0.2))).expect("a scene");
        let (Some(plain), Some(tilted)) = (certified(&plain), certified(&tilted)) else { continue };
        same("tilted", &forces(&tilted), &forces(&plain), length);
        compared += 1;
    }
    assert!(55 <= compared, "{compared}");
}

/// A hump under a straight beam is straight ground under a curled one.
#[test]
fn only_the_gap_counts() {
    let coefficients = [0.4, -0.3, 0.02, 0.003];
    let polynomial = |sign: f64, from: f64| {
        let signed: Vec<f64> = coefficients.iter().map(|c| sign * c).collect();
        Foundation::Polynomial { coefficients: [vec![from + signed[0]], signed[1..].to_vec()].concat() }
    };
    for supports in [vec![], vec![Support::built_in(0.0)], vec![Support::simple(2.0)]] {
        let straight = Beam::new(9.0, 5.0).and_then(|b| b.with_supports(supports.clone())).expect("a beam");
        // The supports of the curled beam hold what those of the straight one do.
        let own = |x: f64| polynomial(-1.0, 0.0).sides(x)[1];
        let lowered = supports.iter().map(|s| {
            let [level, slope] = own(s.at);
            Support { at: s.at, level: s.level + level, slope: s.slope.map(|held| held + slope) }
        });
        let curled = Beam::new(9.0, 5.0).and_then(|b| b.with_supports(lowered.collect()));
        let curled = curled.and_then(|b| b.with_shape(polynomial(-1.0, 0.0))).expect("a beam");
        let load = Load::uniform_on(&straight, 1.1).expect("a load");
        let hump = Scene::new(straight, load.clone(), Some(polynomial(1.0, 2.0))).expect("a scene");
        let flat = Scene::new(curled, load, Some(Foundation::Flat { depth: 2.0 })).expect("a scene");
        let (hump, flat) = (certified(&hump).expect("certified"), certified(&flat).expect("certified"));
        same("curled", &forces(&flat), &forces(&hump), 9.0);
        same("energy", &[flat.state.energy], &[hump.state.energy], 9.0);
    }
}

/// A support that presses may be replaced by a spike of the ground.
#[test]
fn a_pressing_support_is_a_spike() {
    let load = |beam: &Beam| Load::uniform_on(beam, 1.0).expect("a load");
    let ends = [Support::simple(0.0), Support::simple(10.0)];
    let beam = |supports: Vec<Support>| Beam::new(10.0, 3.0).and_then(|b| b.with_supports(supports)).expect("a beam");
    let held = beam(vec![ends[0], Support::simple(4.0).at_level(0.5), ends[1]]);
    let spike = vec![[0.0, 90.0], [4.0, 90.0], [4.0, 0.5], [4.0, 90.0], [10.0, 90.0]];
    let plain = beam(ends.to_vec());
    for points in [vec![[0.0, 90.0], [3.99, 90.0], [4.0, 0.5], [4.01, 90.0], [10.0, 90.0]], spike] {
        let Ok(scene) = Scene::new(plain.clone(), load(&plain), Some(Foundation::Polyline { points })) else {
            continue;
        };
        let pressed = certified(&scene).expect("certified");
        let supported = certified(&Scene::new(held.clone(), load(&held), None).expect("a scene")).expect("certified");
        same("force", &[pressed.state.contacts[0].force], &[supported.state.supports[1].force], 10.0);
        same("energy", &[pressed.state.energy], &[supported.state.energy], 10.0);
    }
}
