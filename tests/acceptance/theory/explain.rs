//! The equations of an explanation hold for the moments of the exact answer, and are those of a textbook.

use palkki::explain::{Chain, ChainNode, Explanation, Parts, What};
use palkki::scene::{Beam, CoupleLoad, Foundation, LinearLoad, Load, Scene, Support, file};
use palkki::theory;
use palkki_evidence::hostile;
use palkki_evidence::random::{Feature, Random, general, sample_of};

use super::settled::pipe;
use crate::scenes::on_supports;

/// `2 L M(2)·2 = −q L³/2` for two equal spans, and what a middle support that settles by `d` adds, `6 EI·2 d/L`.
#[test]
fn two_spans_have_the_equation_of_the_textbook() {
    let (span, stiffness, q, settled) = (6.0, 40.0, 3.0, 0.01);
    let held = [Support::simple(0.0), Support::simple(span).at_level(settled), Support::simple(2.0 * span)];
    let scene = on_supports([2.0 * span, stiffness], &held, (q, &[]), None);
    let found = Explanation::of(&scene, &theory::solve(&scene).expect("an answer"));
    let [equation] = &found.equations[..] else { panic!("{:?}", found.equations) };
    let factors: Vec<f64> = equation.terms.iter().map(|term| term.2).collect();
    assert_eq!(factors, [span, 2.0 * span, 2.0 * span, span]);
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
    assert!(close(equation.load, 0.5 * q * span * span * span), "{equation:?}");
    assert!(close(equation.settlement, 6.0 * stiffness * 2.0 * settled / span), "{equation:?}");
    assert!(
        close(found.nodes[1].moments[0], (equation.settlement - equation.load) / (4.0 * span)),
        "{:?}",
        found.nodes
    );
}

/// `S` of a triangular load that grows from zero at the left end: `7 q L³/60` at the left and `8 q L³/60` at the right end.
#[test]
fn a_triangular_load_has_the_terms_of_the_textbook() {
    let (length, q) = (5.0, 2.0);
    let beam = Beam::new(length, 7.0).expect("a beam");
    let triangle = LinearLoad { from: 0.0, to: length, start: 0.0, end: q };
    let scene = Scene::new(beam.clone(), Load::new(&beam, 0.0, vec![triangle], vec![]).expect("a load"), None);
    let scene = scene.expect("a scene");
    let found = Explanation::of(&scene, &theory::solve(&scene).expect("an answer"));
    let expected = [7.0, 8.0].map(|share| share * q * length * length * length / 60.0);
    for (found, expected) in found.spans[0].load.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-13 * expected, "{found}, not {expected}");
    }
    // The ends have no moment: the largest is what the load alone would bend the span by.
    let [largest, expected] = [found.moment(), expected[1] / length];
    assert!((largest - expected).abs() <= 1e-13 * expected, "{largest}, not {expected}");
}

/// The shear forces stand at their nodes, not beside them: under any load, the force of a node follows from them in fifteen digits.
#[test]
fn shear_forces_stand_at_their_nodes() {
    let mut nodes = 0;
    for (depth, load) in (1..=20).flat_map(|i| [0.5, 3.0, 700.0].map(|load| (0.1 * f64::from(i), load))) {
        let beam = Beam::new(10.0, load).expect("a beam");
        let all = Load::uniform_on(&beam, load).expect("a load");
        let scene = Scene::new(beam, all, Some(Foundation::Flat { depth })).expect("a scene");
        let found = Explanation::of(&scene, &theory::solve(&scene).expect("an answer"));
        for node in &found.nodes {
            let [left, right] = node.shears;
            let off = right - left + node.load - node.force;
            assert!(off.abs() <= 2e-15 * 10.0 * load, "{depth}, {load}: {off:e} of {node:?}");
            nodes += 1;
        }
    }
    assert!(200 < nodes, "{nodes}");
}

/// Every equation of random scenes with supports, own shapes, points and zones holds; there are as many as unknowns, and statics hold.
#[test]
fn equations_of_random_scenes_hold() {
    let (mut equations, mut kinds, mut laws) = (0, [0; 11], 0);
    for seed in hostile::seeds(0..1500) {
        let Ok(scene) = hostile::draft(seed).scene() else { continue };
        // `explain` refuses these, and has the equations of an elastic foundation in another form.
        if !scene.has_no_tension() || scene.on_rigid_ground("explain").is_err() {
            continue;
        }
        let Ok(exact) = theory::solve(&scene) else { continue };
        if !exact.solved || exact.residual > 1e-12 {
            continue;
        }
        let found = Explanation::of(&scene, &exact);
        let what = [
            What::End,
            What::Tip,
            What::Support,
            What::BuiltIn,
            What::Spring,
            What::Corner,
            What::Point,
            What::ZoneEnd,
            What::Hinge,
            What::Load,
            What::Between,
        ];
        for node in &found.nodes {
            kinds[what.iter().position(|kind| *kind == node.what).expect("one of them")] += 1;
        }
        // Moments and deflections of one answer are rounded beside the largest of them.
        let largest = found.nodes.iter().flat_map(|node| node.moments).fold(0.0, |most: f64, m| most.max(m.abs()));
        let deepest = found.nodes.iter().fold(0.0, |most: f64, node| most.max(node.deflection.abs()));
        // A hinge off the ground is where it has no force.
        let hinges = found.nodes.iter().filter(|node| node.what == What::Hinge).count();
        assert_eq!(found.unknowns().len(), found.equations.len() + hinges, "{seed}: {:?}", found.nodes);
        let load = scene.load().magnitude(scene.beam().length());
        let forces = found.nodes.iter().map(|node| node.force.abs()).fold(load, f64::max);
        for (i, node) in found.nodes.iter().enumerate() {
            let [left, right] = node.shears;
            let jump = right - left + node.load;
            let rounding = if node.what == What::End { 0.0 } else { 1e-9 * forces };
            assert!((jump - node.force).abs() <= rounding, "{seed}: {node:?}");
            for span in found.spans.iter().filter(|span| span.left == i) {
                let next = &found.nodes[i + 1];
                let rise = (next.moments[0] - node.moments[1]) / span.length;
                let off = [rise + span.reactions[0] - right, rise - span.reactions[1] - next.shears[0]];
                let rounding = 1e-9 * forces + 1e-12 * largest / span.length;
                assert!(off.iter().all(|off| off.abs() <= rounding), "{seed}: {node:?} {span:?} {off:?}");
            }
        }
        for law in &found.laws {
            let (unit, size) = if law.turning { (scene.beam().length(), 1.0) } else { (1.0, deepest) };
            let rounding = 1e-9 * (forces * unit).max(largest) + 1e-12 * law.stiffness * size.max(law.without.abs());
            assert!((law.says() - law.exerts).abs() <= rounding, "{seed}: {law:?}");
            laws += 1;
        }
        for overhang in &found.overhangs {
            let root = &found.nodes[overhang.root];
            let side = usize::from(overhang.root < overhang.tip);
            let (moment, size) = (root.moments[side], scene.beam().length() * load);
            assert!((moment + overhang.moment).abs() <= 1e-9 * size, "{seed}: {root:?} {overhang:?}");
            let shear = if side == 0 { -overhang.load } else { overhang.load };
            assert!((root.shears[side] - shear).abs() <= 1e-9 * forces, "{seed}: {root:?} {overhang:?}");
        }
        for equation in &found.equations {
            let (residual, size) = (found.residual(equation).abs(), found.size(equation));
            let lengths = equation.spans.iter().flatten().map(|&span| found.spans[span].length);
            let (least, most) = lengths.fold((f64::INFINITY, 0.0_f64), |(a, b), length| (a.min(length), b.max(length)));
            let rounding = 1e-12 * most * largest + 1e-13 * found.stiffness * deepest / least;
            let fulfilled = residual <= 1e-9 * size + rounding;
            assert!(fulfilled, "{seed}: {equation:?} of {:?}: {residual:e} of {size:e}", found.nodes);
            equations += 1;
        }
    }
    let enough = 1000 < equations && 50 < laws && kinds[..8].iter().all(|count| 20 < *count) && 0 < kinds[8];
    assert!(enough, "{equations}, {laws}, {kinds:?}");
}

/// A pipe in soil, two of three with one or two couples.
fn turned_pipe(seed: u64) -> Scene {
    let (scene, mut random) = (pipe(seed), Random::new(0x60_0000 + seed));
    let length = scene.beam().length();
    let place = |random: &mut Random| length * random.between(0.0, 1.0);
    let couple = |_| CoupleLoad {
        at: place(&mut random),
        moment: scene.load().uniform() * random.pick(&[-20.0, -2.0, 5.0, 20.0]),
    };
    let couples = (0..seed % 3).map(couple).collect();
    let load = scene.load().clone().with_couples(scene.beam(), couples).expect("on the beam");
    Scene::above(scene.beam().clone(), load, scene.foundation().cloned(), scene.ground_stiffness()).expect("a scene")
}

/// What is left of `v` and `M`, which have twelve digits, over the shortest link of a chain.
const LEFT: f64 = 1e-8;

/// The links of a chain meet at each of its nodes; the sizes of slopes and shear forces.
#[track_caller]
fn links_meet(chain: &Chain, what: impl Fn() -> String) -> [f64; 2] {
    let sizes = |of: &dyn Fn(usize) -> [Option<Parts>; 2]| -> f64 {
        let all = (0..chain.nodes.len()).flat_map(of).flatten();
        all.fold(0.0, |most: f64, parts| most.max(parts.size()))
    };
    let sizes = [sizes(&|node| chain.slopes(node)), sizes(&|node| chain.shears(node))];
    for node in 0..chain.nodes.len() {
        let off = chain.residuals(node);
        let close = [0, 1].map(|kind| off[kind] <= LEFT * sizes[kind]);
        assert_eq!(close, [true; 2], "node {node}: {off:?} of {sizes:?}\n{}", what());
    }
    sizes
}

/// On an elastic foundation the slopes and the shear forces of the links meet at every node, with numbers that the links compute from the
/// scene alone: free beams, supports in soil, clamps, bearings, waves, polylines and couples.
#[test]
fn the_links_of_a_chain_meet_at_every_node() {
    let mut turned = 0;
    for seed in 0..sample_of(200) {
        let scene = turned_pipe(seed);
        let exact = theory::solve(&scene).expect("an answer");
        let chain = Chain::of(&scene, &exact).expect("an elastic foundation");
        links_meet(&chain, || format!("{seed}: {scene:?}"));
        // The moments of a chain jump by its couples.
        for couple in scene.load().couple() {
            let is_here = |node: &&ChainNode| (node.x - couple.at).abs() <= 1e-12 * scene.beam().length();
            let node = chain.nodes.iter().find(is_here).unwrap_or_else(|| panic!("{seed}: no node at {couple:?}"));
            let moments = chain.nodes.iter().flat_map(|node| node.moments);
            let size = moments.fold(0.0, |most: f64, moment| most.max(moment.abs()));
            let jump = node.moments[1] - node.moments[0];
            assert!((jump - couple.moment).abs() <= 1e-9 * size, "{seed}: {jump} of {couple:?}");
            turned += 1;
        }
        // The reactions are among what is printed.
        let forces: f64 = chain.nodes.iter().map(|node| node.force).sum();
        let own: f64 = exact.state.supports.iter().map(|support| support.force).sum();
        assert!((forces - own).abs() <= 1e-9 * (own.abs() + scene.load().magnitude(scene.beam().length())));
    }
    assert!(sample_of(200) < 2 * turned, "only {turned} couples");
    let rigid = on_supports([6.0, 40.0], &[Support::simple(0.0), Support::simple(6.0)], (3.0, &[]), None);
    assert!(Chain::of(&rigid, &theory::solve(&rigid).expect("an answer")).is_none());
}

/// So they do with steps, joints, hinges and supports that give, of which each exerts what its law says; and under an axial force, half of the
/// times compression, on rigid ground too.
#[test]
fn the_links_of_a_general_beam_meet_at_every_node() {
    let (mut laws, mut joints, mut tense) = (0, 0, 0);
    for (i, on_soil) in (0..sample_of(300_u64)).flat_map(|i| [(i, false), (i, true)]) {
        let sign = if i.is_multiple_of(2) { "-0.01" } else { "" };
        let text = general(i, &Feature::ALL, on_soil).text.replace("tension = ", &format!("tension = {sign}"));
        let Ok(scene) = file::parse("scene.toml", &text, |_| unreachable!("no survey")) else { continue };
        if !on_soil && scene.beam().tension() == 0.0 {
            continue;
        }
        let exact = theory::solve(&scene).expect("an answer");
        if !exact.solved {
            continue;
        }
        let chain = Chain::of(&scene, &exact).expect("a chain");
        tense += usize::from(!on_soil);
        let sizes = links_meet(&chain, || format!("{i}: {text}\n{chain:#?}"));
        let hinges = chain.nodes.iter().filter(|node| node.joint == Some(0.0));
        let most = chain.nodes.iter().fold(0.0, |most: f64, node| most.max(node.moments[0].abs()));
        assert!(
            hinges.into_iter().all(|hinge| hinge.moments[0].abs() <= 1e-9 * most.max(sizes[1] * scene.beam().length())),
            "{i}\n{text}"
        );
        joints += chain.nodes.iter().filter(|node| node.joint.is_some()).count();
        for law in &chain.laws {
            // Rigid ground may give the deflection.
            let Some(node) = law.node.map(|node| &chain.nodes[node]) else { continue };
            let turned = node.moments[1] - node.moments[0];
            let acts = scene.load().couple().iter().filter(|couple| (couple.at - law.x).abs() <= 1e-12);
            let own = if law.turning { turned - acts.map(|couple| couple.moment).sum::<f64>() } else { node.force };
            // Beyond an end there is no moment.
            let end = law.x <= 0.0 || scene.beam().length() <= law.x;
            let size = if law.turning { sizes[1] * scene.beam().length() } else { sizes[1] };
            let is_one = law.turning && end || (law.says() - own).abs() <= LEFT * size;
            assert!(is_one && (law.says() - law.exerts).abs() <= LEFT * size, "{i}: {law:?} of {node:?}\n{text}");
            laws += 1;
        }
    }
    let enough = sample_of(100) < laws && sample_of(60) < joints && sample_of(30) < tense;
    assert!(enough, "{laws} laws, {joints} joints, {tense} under an axial force");
}

/// Two spans on a bearing `k` in the middle: `R = k v` and `v = (5 q l⁴/384 EI)/(1 + k l³/48 EI)` over the whole length `l`.
#[test]
fn an_elastic_bearing_has_the_law_of_the_textbook() {
    let (length, stiffness, q, k) = (12.0, 40.0, 3.0, 5.0);
    let held = [Support::simple(0.0), Support::spring(0.5 * length, k), Support::simple(length)];
    let scene = on_supports([length, stiffness], &held, (q, &[]), None);
    let found = Explanation::of(&scene, &theory::solve(&scene).expect("an answer"));
    let cube = length * length * length;
    let deflection = 5.0 * q * cube * length / (384.0 * stiffness) / (1.0 + k * cube / (48.0 * stiffness));
    let [law] = found.laws[..] else { panic!("{:?}", found.laws) };
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-11 * b.abs();
    assert!(law.node == Some(1) && close(law.now, deflection) && close(law.exerts, k * deflection), "{law:?}");
    let [equation] = &found.equations[..] else { panic!("{:?}", found.equations) };
    // M in the middle by statics, from the bearing alone.
    let moment = q * length * length / 8.0 - 0.25 * k * deflection * length;
    assert!(close(found.nodes[1].moments[0], moment) && found.residual(equation).abs() <= 1e-9 * found.size(equation));
}

/// A rope with stiffness: `w = (u coth u − 1)/(N ℓ)` and `ω = (1 − u/sinh u)/(N ℓ)` with `u² = N ℓ²/EI`, of links of equal length; those of a strut
/// have the cotangent.
#[test]
fn a_link_under_an_axial_force_has_its_hyperbolic_functions() {
    for tension in [5.0_f64, -1.5] {
        let beam = format!("length = 6.0\nbending_stiffness = 40.0\ntension = {tension}");
        let text = format!("[beam]\n{beam}\n[load]\nuniform = 3.0\n");
        let scene = file::parse("scene.toml", &text, |_| unreachable!("no survey")).expect("a scene");
        let chain = Chain::of(&scene, &theory::solve(&scene).expect("an answer")).expect("an axial force");
        for link in &chain.links {
            let u = link.length * (tension.abs() / 40.0).sqrt();
            let over = tension.abs() * link.length;
            let expected = match 0.0 < tension {
                true => [(u / u.tanh() - 1.0) / over, (1.0 - u / u.sinh()) / over],
                false => [(1.0 - u / u.tan()) / over, (u / u.sin() - 1.0) / over],
            };
            for (found, expected) in link.bend.into_iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-12 * expected, "{found} for {expected} under {tension}");
            }
            assert!((link.spring[0] - tension / link.length).abs() <= 1e-12 * tension.abs(), "{link:?}");
        }
    }
}

/// Without a foundation a link has the terms of the equation of three moments: `c = 1/L`, `w = L/3EI`, `ω = L/6EI`, `s = q L³/24 EI` and
/// `t = q L/2`.
#[test]
fn a_link_off_the_foundation_is_a_simple_beam() {
    let (length, stiffness, q) = (6.0, 40.0, 3.0);
    let held = [Support::simple(0.0), Support::simple(length)];
    let scene = on_supports([length, stiffness], &held, (q, &[]), Some(Foundation::Flat { depth: 50.0 }));
    let scene = scene.on_springs(7.0).expect("a scene");
    let chain = Chain::of(&scene, &theory::solve(&scene).expect("an answer")).expect("an elastic foundation");
    let [link] = chain.links[..] else { panic!("{chain:?}") };
    let close = |found: [f64; 2], expected: [f64; 2]| {
        let off = found.into_iter().zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(off <= 1e-12 * (expected[0].abs() + expected[1].abs()), "{found:?} for {expected:?}");
    };
    close(link.stretch, [1.0 / length, 0.0]);
    close(link.bend, [length / (3.0 * stiffness), length / (6.0 * stiffness)]);
    close(link.spring, [0.0; 2]);
    let turned = q * length * length * length / (24.0 * stiffness);
    close(link.slopes, [turned, -turned]);
    close(link.shears, [0.5 * q * length, -0.5 * q * length]);
}
