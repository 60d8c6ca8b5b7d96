//! What presses, and where a beam only lies: neither depends on the list of contacts that was found.

use palkki::route::Status;
use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Beam, Foundation, Load, PointLoad, Quantity, Scene, Support};
use palkki::solve_exactly;
use palkki::state::ContactState;
use palkki::sweep::Sweep;
use palkki::theory::By;
use palkki_evidence::random::{self, Feature, Random, sample_of};

use crate::scenes;

/// A beam without weight, with forces at places, on supports and above ground.
fn scene(length: f64, supports: &[Support], forces: &[[f64; 2]], ground: Option<Foundation>) -> Scene {
    let beam = Beam::new(length, 1.0).and_then(|beam| beam.with_supports(supports.to_vec())).expect("a beam");
    let point = forces.iter().map(|&[at, force]| PointLoad { at, force }).collect();
    let load = Load::new(&beam, 0.0, Vec::new(), point).expect("a load");
    Scene::new(beam, load, ground).expect("a scene")
}

fn level() -> Option<Foundation> {
    Some(Foundation::Flat { depth: 0.0 })
}

/// The certified state: contacts as `[from, to, force]`, and touches as `[from, to]`.
#[track_caller]
fn state(scene: &Scene) -> (Vec<[f64; 3]>, Vec<[f64; 2]>, ContactState) {
    let solution = solve_exactly(scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}", solution.verdict);
    let state = solution.state;
    let contacts = state.contacts.iter().map(|c| [c.from, c.to, c.force]).collect();
    (contacts, state.touches.iter().map(|t| [t.from, t.to]).collect(), state)
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9
}

#[test]
fn a_beam_without_weight_presses_where_its_loads_are() {
    let held = [Support::simple(0.0), Support::simple(1.0)];
    for supports in [&held[..], &held[..1], &[]] {
        let (contacts, touches, state) = state(&scene(1.0, supports, &[[0.3, 1.0]], level()));
        assert_eq!(contacts, [[0.3, 0.3, 1.0]], "{supports:?}");
        assert_eq!(touches, [[0.0, 1.0]], "{supports:?}");
        assert!(state.standing.is_none_or(|standing| near(standing.margin, 0.3)), "{:?}", state.standing);
    }
    let clamped = Support { slope: Some(0.0), ..Support::simple(0.0) };
    let (contacts, touches, _) = state(&scene(1.0, &[clamped], &[[1.0, 1.0]], level()));
    assert_eq!((contacts, touches), (vec![[1.0, 1.0, 1.0]], vec![[0.0, 1.0]]), "a clamp on the ground");
}

/// A plank on the floor presses everywhere.
#[test]
fn a_plank_presses_on_the_whole_floor() {
    let beam = Beam::new(3.0, 1.0).and_then(|beam| beam.with_supports(Vec::new())).expect("a beam");
    let load = Load::uniform_on(&beam, 2.0).expect("a load");
    let (contacts, touches, state) = state(&Scene::new(beam, load, level()).expect("a scene"));
    assert_eq!((contacts, touches), (vec![[0.0, 3.0, 6.0]], Vec::new()));
    assert!(near(state.standing.expect("it is not held").margin, 0.5));
}

/// Random forces on a floor, some of them at one place, and a load that covers a part: what presses is where they are, and the beam touches
/// what is beside.
#[test]
fn what_presses_is_the_load_on_a_floor() {
    for i in 0..sample_of(200_u64) {
        let mut random = Random::new(46 + i);
        let length = random.between(0.1, 20.0);
        let mut places: Vec<f64> = (0..1 + random.below(4)).map(|_| length * random.between(0.0, 1.0)).collect();
        places.sort_by(f64::total_cmp);
        let forces: Vec<[f64; 2]> = places.iter().map(|&at| [at, random.between(0.1, 10.0)]).collect();
        let held = [Support::simple(0.0), Support::simple(length)];
        let supports = &held[..random.below(3)];
        let (contacts, touches, state) = state(&scene(length, supports, &forces, level()));
        assert_eq!(contacts.len(), forces.len(), "{i}: {contacts:?} for {forces:?}");
        for ([from, to, force], [at, load]) in contacts.iter().zip(&forces) {
            assert!(near(*from, *at) && near(*to, *at) && near(*force, *load), "{i}: {contacts:?} for {forces:?}");
        }
        let [[from, to]] = touches[..] else { panic!("{i}: {touches:?}") };
        assert!(near(from, 0.0) && near(to, length), "{i}: {touches:?}");
        if let Some(standing) = state.standing {
            let share = standing.resultant.at / length;
            assert!(near(standing.margin, share.min(1.0 - share)), "{i}: {standing:?}");
        }
    }
}

/// Of three level sleepers the beam without weight touches all where its load stands above the middle one, and two where it stands between
/// two: the margin is the distance to the outermost ones that it touches.
#[test]
fn the_margin_on_three_sleepers_does_not_depend_on_the_list() {
    for i in 0..sample_of(80_u64) {
        let mut random = Random::new(52 + i);
        let mut places = [0.0, random.between(0.5, 3.0), 0.0];
        places[2] = places[1] + random.between(0.5, 3.0);
        let length = places[2] + 1.0;
        let sleepers = places.map(|at| Support::pushing(at + 0.5));
        let k = random.below(3);
        let at = match k {
            0 => random.between(places[0], places[1]),
            1 => random.between(places[1], places[2]),
            _ => places[1],
        };
        let force = random.between(0.1, 10.0);
        let points = |level: f64| -> Vec<[f64; 2]> {
            let tops = places.iter().flat_map(|x| [[x + 0.4, level + 1.0], [x + 0.5, level], [x + 0.6, level + 1.0]]);
            [[0.0, level + 1.0]].into_iter().chain(tops).chain([[length, level + 1.0]]).collect()
        };
        let ground = Foundation::Polyline { points: points(0.0) };
        let of_supports = scene(length, &sleepers, &[[at + 0.5, force]], None);
        let of_ground = scene(length, &[], &[[at + 0.5, force]], Some(ground));
        let [from, to] = [[places[0], places[1]], [places[1], places[2]], [places[0], places[2]]][k];
        let expected = ((at - from) / (to - from)).min((to - at) / (to - from));
        for scene in [of_supports, of_ground] {
            let (_, touches, state) = state(&scene);
            let margin = state.standing.expect("it is not held").margin;
            assert!((margin - expected).abs() <= 1e-9, "{i}: {margin}, not {expected}");
            assert_eq!(touches.len(), if k == 2 { 2 } else { 0 }, "{i}: {touches:?}");
        }
    }
}

/// From row to row of a sweep there are as many contacts and touches as there are loads and floors, in both directions.
#[test]
fn nothing_flickers_from_row_to_row() {
    let two = scene(10.0, &[], &[[1.0, 2.0], [7.3, 1.0]], level());
    let one = scene(10.0, &[Support::simple(0.0), Support::simple(10.0)], &[[1.0, 2.0]], level());
    for (scene, contacts) in [(&two, 2), (&one, 1)] {
        for range in [[0.5, 6.9], [6.9, 0.5]] {
            let sweep = Sweep::new(scene, "load.point[0].at", range, 41).expect("a sweep");
            for row in sweep.rows().expect("answers") {
                let state = row.solution.state;
                assert_eq!((state.contacts.len(), state.touches.len()), (contacts, 1), "{}: {state:?}", row.value);
            }
        }
    }
}

/// Of the paper's example the spans beside the zone are `a = (24 EI u₀/q)^¼` long, with a largest moment of `q a²/8`; the clearance is
/// largest at the support. With a contact at a point, or on ground that gives, the spans reach from contact to contact as well.
#[test]
fn free_spans_lie_between_the_contacts() {
    let (length, stiffness, depth, load) = (10.0, 1.3, 1.0, 1.0);
    let beam = Beam::new(length, stiffness).expect("a beam");
    let uniform = Load::uniform_on(&beam, load).expect("a load");
    let scene = Scene::new(beam, uniform, Some(Foundation::Flat { depth })).expect("a scene");
    let a = (24.0 * stiffness * depth / load).powf(0.25);
    let exact = palkki::theory::solve(&scene).expect("an answer");
    let spans = exact.free_spans(scene.beam());
    let [left, right] = spans[..] else { panic!("{spans:?}") };
    for (span, [from, to], support) in [(left, [0.0, a], 0.0), (right, [length - a, length], length)] {
        let clearance = span.clearance.expect("there is ground");
        assert!(near(span.from, from) && near(span.to, to), "{span:?}");
        assert!(near(clearance.max, depth) && near(clearance.max_at, support) && near(clearance.min, 0.0), "{span:?}");
        assert!(near(span.moment.max, load * a * a / 8.0) && near(span.moment.min, 0.0), "{span:?}");
    }
    for scene in [scene.with_ground_moved(30.0), scene.on_springs(100.0)].map(|scene| scene.expect("a scene")) {
        let exact = palkki::theory::solve(&scene).expect("an answer");
        let spans = exact.free_spans(scene.beam());
        let [left, right] = spans[..] else { panic!("{spans:?}") };
        let contact = exact.state.contacts[0];
        assert!(near(left.to, contact.from) && near(right.from, contact.to), "{spans:?}");
        let sampled = (0..=1000).map(|k| exact.moment(left.to * f64::from(k) / 1000.0)).fold(0.0, f64::max);
        assert!((left.moment.max - sampled).abs() <= 1e-5 * sampled && sampled <= left.moment.max + 1e-12, "{spans:?}");
    }
}

/// Where the clearance is largest, position and clearance are the depth of the ground: of one of its sides at a step.
#[test]
fn the_position_of_a_free_span_is_that_of_its_largest_clearance() {
    let mut count = 0;
    for (name, scene) in ["held", "soft", "practice"].into_iter().flat_map(scenes::in_folder) {
        let Some(foundation) = scene.foundation() else { continue };
        let exact = palkki::theory::solve(&scene).expect("an answer");
        let scale = exact.state.deflection.max.abs().max(exact.state.deflection.min.abs());
        for span in exact.free_spans(scene.beam()) {
            let (clearance, position) = span.clearance.zip(span.position).expect("there is ground");
            let off = foundation.sides(clearance.max_at).map(|[depth, _]| (position + clearance.max - depth).abs());
            assert!(off[0].min(off[1]) <= 1e-11 * scale, "{name}: {span:?} {off:?}");
            count += usize::from(scene.beam().shape().is_some());
        }
    }
    assert!(4 <= count, "{count} spans of beams with an own shape");
}

/// The moments of the free spans together have the extremes of the whole beam, or zones have them: in scenes without zones they are equal,
/// whatever changes along the beam.
#[test]
fn the_moments_of_all_free_spans_are_those_of_the_beam() {
    const SCENES: u64 = 60;
    let mut compared = 0;
    for (i, on_soil) in (0..SCENES).flat_map(|i| [(i, false), (i, true)]) {
        let text = random::general(i, &Feature::ALL, on_soil).text;
        let Ok(scene) = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)) else { continue };
        let Ok(exact) = palkki::theory::solve(&scene) else { continue };
        if !exact.solved || exact.state.contacts.iter().any(|contact| contact.from < contact.to) {
            continue;
        }
        let moments: Vec<_> = exact.free_spans(scene.beam()).iter().map(|span| span.moment).collect();
        let [max, min] = [
            moments.iter().map(|moment| moment.max).fold(f64::NEG_INFINITY, f64::max),
            moments.iter().map(|moment| moment.min).fold(f64::INFINITY, f64::min),
        ];
        let whole = &exact.state.moment;
        let off = (max - whole.max).abs().max((min - whole.min).abs());
        assert!(off <= 1e-9 * whole.max.max(-whole.min), "{i}, {on_soil}: {max} and {min}, not {whole:?}");
        compared += 1;
    }
    assert!(SCENES / 2 <= compared, "{compared} scenes without zones");
}

/// A plank with two forces exactly above two crests, and a third crest on the line of these two, which it touches without pressing. More
/// load presses there: the derivatives on that side include it, and the total contact force changes as the load does.
#[test]
fn a_contact_that_begins_to_press_counts_in_derivatives() {
    let crests = vec![[0.0, 1.375], [2.0, 0.875], [4.0, 2.75], [6.0, 0.5], [8.0, 3.0], [10.0, 0.125], [16.0, 2.25]];
    let scene = scene(16.0, &[], &[[10.0, 0.7], [6.0, 0.7]], Some(Foundation::Polyline { points: crests }));
    let exact = palkki::theory::solve(&scene).expect("an answer");
    assert_eq!((exact.state.contacts.len(), exact.state.touches.len()), (2, 1));
    let all = exact.derivatives(&scene);
    for derivative in &all {
        let of_load = match derivative.by {
            By::Number(Quantity::Uniform) => 16.0,
            By::Number(Quantity::PointForce(_)) => 1.0,
            _ => 0.0,
        };
        assert!((derivative.contact_force - of_load).abs() <= 1e-12, "{derivative:?}");
    }
    let of = |by: Quantity| all.iter().find(|derivative| derivative.by == By::Number(by)).expect("a derivative");
    let by_uniform = of(Quantity::Uniform);
    let pressing: f64 = by_uniform.contacts.iter().map(|contact| contact.force).sum();
    assert!(by_uniform.one_sided && pressing < 16.0 - 1.0, "{by_uniform:?}");
}
