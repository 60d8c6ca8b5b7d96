//! Beams on any supports, and such that change, against an authority that shares nothing with the methods.

use palkki::route::{Method, Solution, Solver, Status};
use palkki::scene::{Balance, Beam, Foundation, Joint, PointLoad, Scaled, Scene, Support};
use palkki::solve_exactly;
use palkki_evidence::draft::Draft;
use palkki_evidence::random::{Random, sample_of};

use super::dense::{Dense, Optimum};
use crate::scenes::{nodes, run};

/// Intervals: few enough that every set of contacts can be tried.
const INTERVALS: usize = 8;

/// A scene: supports at some nodes, built in now and then or, if `push` says so, most of them such that they only push, at uneven
/// levels; rough ground, or without it loads at nodes alone; now and then with a shape.
fn scene(random: &mut Random, supports: usize, push: bool, grounded: bool) -> Option<Scene> {
    let mut held: Vec<Support> = Vec::new();
    for _ in 0..supports {
        let at = random.below(INTERVALS + 1) as f64;
        if held.iter().all(|s| (s.at - at).abs() > 0.5) {
            let level = random.between(-0.2, 0.2);
            let pushes_only = push && !random.once_in(3);
            let slope = (!pushes_only && random.once_in(3)).then(|| random.between(-0.1, 0.1));
            held.push(Support { level, slope, pushes_only, ..Support::simple(at) });
        }
    }
    if push && !held.iter().any(|s| s.pushes_only) {
        return None;
    }
    let depth = |random: &mut Random, x: f64| {
        let level = held.iter().find(|s| (s.at - x).abs() < 0.5).map_or(-0.2, |s| s.level);
        [x, level + random.between(0.02, 0.8)]
    };
    let points = (0..=8).map(|k| depth(random, f64::from(k))).collect();
    let place = |random: &mut Random| {
        if grounded { random.between(0.0, 8.0) } else { random.below(INTERVALS + 1) as f64 }
    };
    let load = |random: &mut Random| PointLoad { at: place(random), force: random.between(-0.5, 2.0) };
    let shape = random.once_in(3).then(|| [0.0, random.between(-0.1, 0.1), random.between(-0.02, 0.02)].to_vec());
    let draft = Draft {
        length: 8.0,
        stiffness: random.between(0.3, 30.0),
        uniform: if grounded { random.between(0.1, 1.5) } else { 0.0 },
        point: (0..usize::from(push) + random.below(4)).map(|_| load(random)).collect(),
        ground: grounded.then_some(Foundation::Polyline { points }),
        supports: Some(held),
        shape: shape.map(|coefficients| Foundation::Polynomial { coefficients }),
        ..Draft::default()
    };
    let scene = draft.scene().ok()?;
    // One that may turn has no deflection to compare.
    let turns = |scaled: Scaled| matches!(scaled.balance, Balance::Neutral { .. });
    scene.scaled().is_ok_and(|scaled| !turns(scaled)).then_some(scene)
}

/// Scene number `i` on up to three supports above ground.
fn holding(i: u64) -> Option<Scene> {
    let random = &mut Random::new(0x50_0000 + i);
    let supports = random.below(4);
    scene(random, supports, false, true)
}

/// Scene number `i` on two to five supports, most of which only push; every other beam is above ground.
fn pushing(i: u64) -> Option<Scene> {
    let random = &mut Random::new(0x60_0000 + i);
    let supports = 2 + random.below(4);
    scene(random, supports, true, i.is_multiple_of(2))
}

/// The same beam with steps of the bending stiffness and joints at nodes, about every third of these a hinge; [`None`] where a built-in
/// support is at one of them, or hinges let the beam move.
fn changing(random: &mut Random, scene: &Scene) -> Option<Scene> {
    let stiffness = scene.beam().bending_stiffness();
    let (mut steps, mut joints) = (Vec::new(), Vec::new());
    for node in 0..INTERVALS {
        if node == 0 || random.once_in(3) {
            steps.push([node as f64, stiffness * libm::exp(random.between(-1.0, 3.0))]);
        }
        if 0 < node && random.once_in(4) {
            joints.push(node as f64);
        }
    }
    let mut joint = |at: f64| {
        let k = libm::exp(random.between(-3.0, 3.0)) * stiffness;
        Joint { at, stiffness: (!random.once_in(3)).then_some(k) }
    };
    let joints = joints.into_iter().map(&mut joint).collect();
    let beam: Beam = scene.beam().clone().with_steps(steps).and_then(|beam| beam.with_joints(joints)).ok()?;
    let scene = Scene::new(beam, scene.load().clone(), scene.foundation().cloned()).ok()?;
    let turns = |scaled: Scaled| matches!(scaled.balance, Balance::Neutral { .. });
    scene.scaled().is_ok_and(|scaled| !turns(scaled)).then_some(scene)
}

/// The largest differences of forces, deflections and energy, each relative to the size of these.
fn differences(optimum: &Optimum, found: &Solution<()>) -> [f64; 3] {
    let (state, values) = (&found.state, nodes(found));
    let first = usize::from(values.x[0] > 0.0);
    let mut forces = [0.0; INTERVALS + 1];
    values.contact_force.iter().enumerate().for_each(|(k, p)| forces[k + first] = *p);
    for support in &state.supports {
        // On a beam of 8 in 8 intervals places are nodes.
        forces[(0..=INTERVALS).min_by_key(|k| ((*k as f64 - support.at).abs() * 1e6) as u64).expect("a node")] =
            support.force;
    }
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, v| most.max(v.abs()));
    let force = largest(&mut forces.iter().zip(&optimum.force).map(|(a, b)| a - b));
    let deflections = values.deflection.iter().zip(&optimum.deflection[first..]);
    let deflection = largest(&mut deflections.map(|(a, b)| a - b));
    [
        force / largest(&mut optimum.force.iter().copied()),
        deflection / largest(&mut optimum.deflection.iter().copied()),
        (state.energy - optimum.energy).abs() / optimum.energy.abs(),
    ]
}

/// Rounding of dense systems of condition up to 10⁶.
const ROUNDED: f64 = 1e-9;

/// A solver that stops at a residual of 1e-10, in forces that may be 10⁴ times as sensitive.
const ITERATED: f64 = 1e-5;

#[test]
fn every_route_finds_what_trying_all_contacts_finds() {
    let scenes: Vec<Scene> = (0..120).filter_map(holding).collect();
    let [held, free] = every_route_is_right(&scenes);
    let is_built_in = |scene: &&Scene| scene.beam().supports().iter().any(|s| s.slope.is_some());
    let built_in = scenes.iter().filter(is_built_in).count();
    assert!(40 <= held && 20 <= free && 20 <= built_in, "{held} held, {free} free, {built_in} built in");
}

/// The same beam with about half of its simple supports as springs, of those that only push as well, and some of the others with a spring
/// against turning.
fn giving(random: &mut Random, scene: &Scene) -> Option<Scene> {
    let mut supports = scene.beam().supports_as_given();
    for support in supports.iter_mut().filter(|support| support.slope.is_none()) {
        let mut stiffness = |from: f64, to: f64| scene.beam().bending_stiffness() * libm::exp(random.between(from, to));
        let [sinking, turning] = [stiffness(-6.0, 4.0), stiffness(-4.0, 3.0)];
        support.stiffness = random.once_in(2).then_some(sinking);
        if !support.pushes_only && random.once_in(3) {
            *support = support.turning(turning, random.between(-0.1, 0.1));
        }
    }
    if supports.iter().all(|support| support.stiffness.is_none() && support.turning_stiffness.is_none()) {
        return None;
    }
    let beam = scene.beam().clone().with_supports(supports).ok()?;
    let scene = Scene::new(beam, scene.load().clone(), scene.foundation().cloned()).ok()?;
    let turns = |scaled: Scaled| matches!(scaled.balance, Balance::Neutral { .. });
    scene.scaled().is_ok_and(|scaled| !turns(scaled)).then_some(scene)
}

/// Supports that give, those that only push among them, springs against turning, and beams that change besides.
#[test]
fn supports_that_give_are_right_by_every_route() {
    let of = |i: u64| {
        let random = &mut Random::new(0x90_0000 + i);
        let scene = if i.is_multiple_of(2) { holding(i)? } else { pushing(i)? };
        let scene = giving(random, &scene)?;
        if i.is_multiple_of(3) && scene.foundation().is_some() { changing(random, &scene) } else { Some(scene) }
    };
    let scenes: Vec<Scene> = (0..).filter_map(of).take(120).collect();
    let [held, free] = every_route_is_right(&scenes);
    let springs = |pushes_only: bool| {
        scenes.iter().flat_map(|scene| scene.beam().springs()).filter(|s| s.pushes_only == pushes_only).count()
    };
    let [both, push] = [false, true].map(springs);
    let turning = scenes.iter().flat_map(|scene| scene.beam().all_supports()).filter(|s| s.turning_stiffness.is_some());
    let turning = turning.count();
    assert!(50 <= held && 20 <= free, "{held} held, {free} free");
    assert!(60 <= both && 60 <= push && 40 <= turning, "{both} hold both ways, {push} push, {turning} against turning");
}

/// Steps of the bending stiffness, joints and hinges by every route.
#[test]
fn beams_that_change_are_right_by_every_route() {
    let on_ground = (0..).filter_map(|i| changing(&mut Random::new(0x70_0000 + i), &holding(i)?)).take(sample_of(80));
    // Without ground a part beyond a hinge may have neither load nor contact, and any position.
    let pushed = (0..)
        .map(|i| 2 * i)
        .filter_map(|i| changing(&mut Random::new(0x80_0000 + i), &pushing(i)?))
        .take(sample_of(40));
    let scenes: Vec<Scene> = on_ground.chain(pushed).collect();
    let [held, free] = every_route_is_right(&scenes);
    let hinged = |scene: &&Scene| scene.beam().joints().iter().any(|joint| joint.stiffness.is_none());
    let hinges = scenes.iter().filter(hinged).count();
    let [least, few, some] = [40, 20, 30].map(sample_of);
    assert!(least <= held && few <= free && some <= hinges, "{held} held, {free} free, {hinges} with hinges");
}

/// How many of the scenes are held by their supports, and how many are not.
fn every_route_is_right(scenes: &[Scene]) -> [usize; 2] {
    let ([mut held, mut free], [mut asked, mut solved]) = ([0; 2], [0; 2]);
    let mut lifted = 0;
    for scene in scenes {
        let supports = scene.beam().all_supports();
        let is_held = scene.scaled().expect("balanced").balance.resultant().is_none();
        *(if is_held { &mut held } else { &mut free }) += 1;
        for method in Method::ALL {
            // Loads may lift a part beyond a hinge for ever.
            let optimum = Dense::of(scene, method, INTERVALS).optimum();
            let is_hinged = scene.beam().joints().iter().any(|joint| joint.stiffness.is_none());
            let Some(optimum) = optimum.or_else(|| is_hinged.then_some(None).expect("an optimum")) else {
                assert!(!run(scene, method, Solver::ActiveSet, INTERVALS).solved, "nothing holds it");
                lifted += 1;
                continue;
            };
            for solver in Solver::OPTIMAL {
                let found = run(scene, method, solver, INTERVALS);
                let (beam, end) = (scene.beam(), &found.run.message);
                let told = format!("{method}, {solver}, {supports:?}, {:?}, {:?}: {end}", beam.steps(), beam.joints());
                if solver == Solver::Nsor && method == Method::Force && !is_held {
                    assert!(!found.solved && found.run.message.starts_with("not tried: the supports leave"), "{told}");
                    continue;
                }
                asked += 1;
                assert!(found.solved || solver != Solver::ActiveSet, "{told}, {:e}", found.residual);
                if found.solved {
                    solved += 1;
                    let most = if solver == Solver::ActiveSet { ROUNDED } else { ITERATED };
                    let apart = differences(&optimum, &found);
                    assert!(apart.iter().all(|apart| *apart <= most), "{told}: {apart:?}");
                }
            }
        }
    }
    assert!(95 * asked <= 100 * solved, "only {solved} of {asked} are solved");
    assert!(20 * lifted <= scenes.len(), "{lifted} have no answer");
    [held, free]
}

/// How many random scenes with supports that only push there are.
const PUSHING: usize = 500;

#[test]
fn supports_that_only_push_are_right_by_every_route() {
    let scenes: Vec<Scene> = (0..).filter_map(pushing).take(PUSHING).collect();
    let [held, free] = every_route_is_right(&scenes);
    assert!(100 <= held && 100 <= free, "{held} held, {free} free");
}

/// Beam theory beside the same authority, which is beam theory where all loads stand at nodes and there is no ground: each force is
/// in its bracket, and what is lifted off has none.
#[test]
fn beam_theory_knows_what_only_pushes() {
    let (mut lifted, mut pressed) = (0, 0);
    for scene in (0..).filter(|i: &u64| !i.is_multiple_of(2)).filter_map(pushing).take(PUSHING) {
        let told = format!("{:?} {:?}", scene.beam().all_supports(), scene.load());
        let solution = solve_exactly(&scene).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{told}: {}", solution.verdict);
        let optimum = Dense::of(&scene, Method::Displacement, INTERVALS).optimum().expect("an optimum");
        let size = optimum.force.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let certificate = solution.verdict.certificate.expect("bounds");
        for (support, bracket) in solution.state.supports.iter().zip(certificate.reactions) {
            let truth = optimum.force[support.at.round() as usize];
            assert!((support.force - truth).abs() <= ROUNDED * size, "{told}: {truth} at {}", support.at);
            let [least, most] = bracket.expect("a bracket");
            let rounding = ROUNDED * size;
            assert!(least - rounding <= truth && truth <= most + rounding, "{told}: {truth} in {least} … {most}");
            if support.pushes_only {
                *(if support.force == 0.0 { &mut lifted } else { &mut pressed }) += 1;
            }
        }
        let energy = optimum.energy;
        assert!((solution.state.energy - energy).abs() <= ROUNDED * energy.abs().max(size), "{told}: {energy}");
        assert!(
            certificate.energy_lower <= energy + ROUNDED * size && energy - ROUNDED * size <= certificate.energy_upper
        );
    }
    assert!(300 <= lifted && 300 <= pressed, "{lifted} lifted off, {pressed} press");
}
