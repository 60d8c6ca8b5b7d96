//! Contact forces on beams of which statics does not say how they bend: the bound beside finite elements, which share nothing with the
//! library, and beside closed forms.

use palkki::certificate::{Certificate, ContactLoad, Judged, ViolationKind};
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Scene, file};
use palkki::theory::Exact;
use palkki::verdict::Verdict;
use palkki::{Settings, Witness, solve, theory};
use palkki_evidence::elements::{Found, reference};
use palkki_evidence::random::{Feature, Random, general, general_on_grid, sample_of};

fn parsed(text: &str) -> Option<Scene> {
    file::parse("scene.toml", text, |_| unreachable!("no survey")).ok()
}

/// Places and forces.
type Rows = Vec<(f64, f64)>;

#[track_caller]
fn read(text: &str) -> Scene {
    parsed(text).unwrap_or_else(|| panic!("a scene\n{text}"))
}

/// Bounds and violations of forces.
#[track_caller]
fn judged(scene: &Scene, forces: &[(f64, f64)]) -> (Certificate, Vec<(ViolationKind, f64)>) {
    let load = ContactLoad::new(scene.beam().length(), forces.iter().copied()).expect("forces");
    let witness = Witness::of(scene);
    let found = witness.judge_forces(&load, &[]).expect("a scene").1;
    let kinds = found.iter().map(|violation| (violation.kind, violation.relative));
    (witness.judge(Judged::Forces(&load), &[]).expect("a scene"), kinds.collect())
}

/// The forces of an exact answer, the pressure of zones in so many parts.
fn forces_of(exact: &Exact, parts: u32) -> Vec<(f64, f64)> {
    let mut rows: Vec<(f64, f64)> = exact.forces_inside_zones().collect();
    for contact in &exact.state.contacts {
        let Some(ends) = contact.end_forces.filter(|_| contact.from < contact.to) else {
            rows.push((contact.from, contact.force));
            continue;
        };
        rows.extend([(contact.from, ends[0]), (contact.to, ends[1])]);
        let part = (contact.to - contact.from) / f64::from(parts);
        let places = (0..parts).map(|k| contact.from + part * (f64::from(k) + 0.5));
        rows.extend(places.map(|x| (x, part * exact.pressure(x))));
    }
    rows.into_iter().filter(|row| 0.0 < row.1).collect()
}

/// Equal nodes with the pressure of an elastic foundation on their shares of the beam.
fn shares_of(exact: &Exact, length: f64, nodes: u32) -> Vec<(f64, f64)> {
    const PARTS: u32 = 40;
    let step = length / f64::from(nodes);
    let share = |i: u32| {
        let x = step * f64::from(i);
        let [from, to] = [(x - 0.5 * step).max(0.0), (x + 0.5 * step).min(length)];
        let part = (to - from) / f64::from(PARTS);
        let pressed: f64 = (0..PARTS).map(|k| exact.pressure(from + part * (f64::from(k) + 0.5))).sum();
        (x, part * pressed)
    };
    (0..=nodes).map(share).collect()
}

/// The file of the beam without its ground, under the forces as loads; those inside it spread, if that is said, over so much of the beam.
fn bare(text: &str, forces: &[(f64, f64)], width: Option<f64>) -> String {
    let mut text = text.split("[foundation]").next().unwrap_or(text).to_owned();
    let mut add = |key: &str, rows: Vec<String>| {
        let (rows, list) = (rows.join(", "), format!("{key} = ["));
        text = match text.split_once(&list) {
            Some((before, after)) => format!("{before}{list}{rows}, {after}"),
            None => text.replace("[load]\n", &format!("[load]\n{list}{rows}]\n")),
        };
    };
    let inside = |at: f64| width.filter(|_| forces[0].0 < at && at < forces[forces.len() - 1].0);
    let point = |(x, f): &(f64, f64)| format!("{{ at = {x:?}, force = {:?} }}", -f);
    add("point", forces.iter().filter(|row| inside(row.0).is_none()).map(point).collect());
    let spread = |(x, f): &(f64, f64)| {
        let width = inside(*x)?;
        let (from, to, q) = (x - 0.5 * width, x + 0.5 * width, -f / width);
        Some(format!("{{ from = {from:?}, to = {to:?}, start = {q:?}, end = {q:?} }}"))
    };
    let spread: Vec<String> = forces.iter().filter_map(spread).collect();
    if !spread.is_empty() {
        add("linear", spread);
    }
    text
}

/// Whether supports that hold the beam both ways hold it alone.
fn is_held(scene: &Scene) -> bool {
    let holding = scene.beam().supports_as_given().into_iter().filter(|support| !support.pushes_only).collect();
    let beam = scene.beam().clone().with_supports(holding);
    let bare = beam.and_then(|beam| Scene::new(beam, scene.load().clone(), None));
    bare.and_then(|bare| bare.scaled().map(drop)).is_ok()
}

/// A random scene of which statics does not say how forces bend it, with the forces of its answer. Half of those with an axial force are
/// under compression.
fn scene(i: u64, on_soil: bool) -> Option<(String, Exact, Rows)> {
    let general = general(i, &Feature::ALL, on_soil);
    let is_new = |feature: &Feature| match feature {
        Feature::Couple | Feature::SoilSteps => false,
        Feature::Steps | Feature::Joint => on_soil,
        _ => true,
    };
    general.features.iter().any(is_new).then_some(())?;
    let sign = if i.is_multiple_of(2) { "-0.01" } else { "" };
    let text = general.text.replace("tension = ", &format!("tension = {sign}"));
    let scene = parsed(&text)?;
    let exact = theory::solve(&scene).ok().filter(|exact| exact.solved)?;
    let forces = if on_soil { shares_of(&exact, scene.beam().length(), 40) } else { forces_of(&exact, 12) };
    (!forces.is_empty()).then_some((text, exact, forces))
}

/// Right forces, and forged ones: all smaller, all moved, one larger. The bound is no smaller than what the beam that they bend is off by, and
/// that of right forces is small.
#[test]
fn no_forces_have_a_bound_below_their_error() {
    /// What two meshes may have in common, of the largest deflection.
    const ELEMENTS: f64 = 1e-7;
    let (mut count, mut close, mut tight) = (0, 0, 0);
    for (i, on_soil) in (0..sample_of(400_u64)).flat_map(|i| [(i, false), (i, true)]) {
        let Some((text, exact, right)) = scene(i, on_soil) else { continue };
        let (scene, mut random) = (read(&text), Random::new(0xca11 + i));
        let (strongest, length) = (random.below(right.len()), scene.beam().length());
        let width = on_soil.then_some(length / 40.0);
        // What nothing but the ground holds is not asked of finite elements.
        if !is_held(&scene) || parsed(&bare(&text, &right, width)).is_none() {
            continue;
        }
        for k in 0..4 {
            let forged = |(j, (x, force)): (usize, &(f64, f64))| match k {
                1 => (*x, 0.7 * force),
                2 if on_soil => (*x, right[(j + 1) % right.len()].1),
                2 => ((x + 0.03 * length).min(length), *force),
                3 if j == strongest => (*x, 1.5 * force),
                _ => (*x, *force),
            };
            let forces: Vec<(f64, f64)> = right.iter().enumerate().map(forged).collect();
            let Found::Answer(bent) = reference(&bare(&text, &forces, width)) else { continue };
            let (certificate, _) = judged(&scene, &forces);
            let places = bent.places.iter().zip(&bent.numbers.deflections);
            let size = bent.numbers.deflections.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            let off = places.fold(0.0, |most: f64, (x, v)| most.max((v - exact.deflection(*x)).abs()));
            let slack = size * (2.0 * bent.estimate[1] + ELEMENTS);
            let bound = certificate.deflection_error;
            assert!(off <= bound * (1.0 + 1e-6) + slack, "{i}, {k}: {off:e} for {certificate:?}\n{text}{forces:?}");
            count += 1;
            tight += usize::from(bound <= 1.5 * off + 0.01 * size);
            close += usize::from(k == 0 && bound <= 0.05 * size);
        }
    }
    assert!(800 * count <= 1000 * tight && 800 * count <= 4000 * close, "{close} and {tight} of {count}");
}

/// Beams that nothing but rigid ground holds, in parts between hinges too: right forces are close, and forged ones out of balance.
#[test]
fn forces_hold_a_beam_that_its_supports_do_not() {
    let (mut count, mut close) = (0, 0);
    for i in 0..sample_of(500_u64) {
        let Some((text, exact, right)) = scene(i, false) else { continue };
        let (scene, size) = (read(&text), exact.state.deflection.magnitude());
        if is_held(&scene) {
            continue;
        }
        let (certificate, found) = judged(&scene, &right);
        let is_open = |found: &[(ViolationKind, f64)]| {
            found.iter().any(|(kind, share)| *kind == ViolationKind::Balance && 1e-3 < *share)
        };
        let off = (exact.deflection(0.4 * scene.beam().length())).abs() - certificate.deflection;
        assert!(off <= certificate.deflection_error, "{i}: {certificate:?}\n{text}");
        let is_close = certificate.deflection_error <= 0.05 * size;
        count += 1;
        close += usize::from(is_close);
        let forged: Vec<(f64, f64)> = right.iter().map(|(x, force)| (*x, 0.5 * force)).collect();
        // One place that a string hangs on takes what it has to.
        let alone = right.len() < 2 && 0.0 < scene.beam().tension();
        // So do stops that nothing pressed before.
        let held = parsed(&bare(&text, &forged, None)).is_some();
        assert!(alone || held || is_open(&judged(&scene, &forged).1), "{i}: {found:?}\n{text}");
    }
    assert!(0 < count && 8 * count <= 10 * close, "{close} of {count}");
}

/// On two elastic bearings `k` above level ground that the beam touches in the middle:
///
/// ```text
/// F = (5 q l⁴/384 EI + q l/2k − u₀)/(1/2k + l³/48 EI),      F too much by f lifts the middle by f (1/2k + l³/48 EI), and the ends by f/2k
/// ```
#[test]
fn a_point_between_elastic_bearings() {
    let (l, ei, q, k, depth) = (8.0, 50.0, 1.5, 20.0, 1.2);
    let soft = 0.5 / k + l * l * l / (48.0 * ei);
    let force = (5.0 * q * l * l * l * l / (384.0 * ei) + 0.5 * q * l / k - depth) / soft;
    let bearings = format!("supports = [{{ at = 0, stiffness = {k} }}, {{ at = {l}, stiffness = {k} }}]");
    let beam = format!("[beam]\nlength = {l}\nbending_stiffness = {ei}\n{bearings}\n[load]\nuniform = {q}\n");
    let scene = read(&format!("{beam}[foundation]\ndepth = {depth}\n"));
    let (right, _) = judged(&scene, &[(0.5 * l, force)]);
    assert!(0.0 < force && right.deflection_error <= 1e-9, "{right:?}");
    assert_eq!(Verdict::of_forces(right).status, Status::Certified);
    for more in [-0.5, -0.01, 0.02, 0.5] {
        let (said, found) = judged(&scene, &[(0.5 * l, force + more)]);
        let off = more.abs() * soft;
        assert!(off <= said.deflection_error * (1.0 + 1e-9) && said.deflection_error <= 1.01 * off, "{more}: {said:?}");
        let kind = if more < 0.0 { ViolationKind::Penetration } else { ViolationKind::Complementarity };
        assert!(found.first().is_some_and(|first| first.0 == kind), "{found:?}");
    }
}

/// A stop below the middle exerts `R = k (5 q l⁴/384 EI − d)/(1 + k l³/48 EI)`, whatever is said of it, and another force is found; one of a
/// bearing that holds both ways is, too.
#[test]
fn a_force_is_not_that_of_its_stop() {
    let (l, ei, q, k, level) = (10.0, 30.0, 1.0, 4.0, 0.5);
    let free = 5.0 * q * l * l * l * l / (384.0 * ei) - level;
    let right = k * free / (1.0 + k * l * l * l / (48.0 * ei));
    for kind in ["pushes_only = true, ", ""] {
        let stop = format!("{{ at = {}, {kind}stiffness = {k}, level = {level} }}", 0.5 * l);
        let supports = format!("supports = [{{ at = 0 }}, {stop}, {{ at = {l} }}]");
        let beam = format!("[beam]\nlength = {l}\nbending_stiffness = {ei}\n{supports}\n");
        let scene = read(&format!("{beam}[load]\nuniform = {q}\n"));
        for (force, wrong) in [(right, None), (right + 0.5, Some(0.5)), (right - 1.0, Some(1.0))] {
            let (said, found) = judged(&scene, &[(0.5 * l, force)]);
            assert!(said.deflection_error <= 1e-9 && said.contacts_proven, "{said:?}");
            let share = wrong.map(|wrong| wrong / (q * l).max(force));
            let law = found.iter().find(|found| found.0 == ViolationKind::SpringLaw);
            let is_right = match (law, share) {
                (None, None) => true,
                (Some((_, found)), Some(share)) => (found - share).abs() <= 1e-9,
                _ => false,
            };
            assert!(is_right, "{force}: {found:?}");
        }
    }
}

/// Answers on grids, of which forces and load act at nodes: brought as forces they bend the same beam, and have the same bound.
#[test]
fn forces_at_nodes_bend_the_beam_of_their_grid() {
    const INTERVALS: usize = 20;
    let (mut count, mut places) = (0, 0);
    for (i, on_soil) in (0..sample_of(200_u64)).flat_map(|i| [(i, false), (i, true)]) {
        let text = general_on_grid(i, &Feature::ALL[..8], on_soil, 20.0).text;
        let Some(scene) = parsed(&text) else { continue };
        let settings = Settings::new(Method::Force, Solver::ActiveSet, INTERVALS);
        let Ok(solution) = solve(&scene, &settings) else { continue };
        let (Some(nodes), Some(own)) = (&solution.state.nodes, &solution.verdict.certificate) else { continue };
        let witness = Witness::of(&scene);
        let rows = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied());
        let Ok(lumped) = witness.lumped(rows) else { continue };
        if lumped.nodes.x.len() != nodes.x.len() {
            continue;
        }
        let size = nodes.deflection.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let off = lumped.nodes.deflection.iter().zip(&nodes.deflection).map(|(a, b)| (a - b).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off <= 1e-7 * size, "{i}, {on_soil}: {off:e} of {size:e}\n{text}");
        let said = witness.judge(Judged::Nodes(&lumped.nodes), &[]).expect("a scene").deflection_error;
        // What is not known of the moments beside a spring against turning may be known in another way.
        let is_one = (said - own.deflection_error).abs() <= 1e-6 * size;
        places += usize::from(is_one);
        count += 1;
    }
    assert!(sample_of(150) < count && 9 * count <= 10 * places, "{places} of {count}");
}

/// What is not computed says so: a list of contacts alone does not bend a beam on springs.
#[test]
fn what_bends_in_no_known_way_is_refused() {
    let beam = "[beam]\nlength = 4.0\nbending_stiffness = 1.0\n";
    let springs = "supports = [{ at = 0, stiffness = 1.0 }, { at = 4 }]\n";
    let load = ContactLoad::new(4.0, [(2.0, 1.0)]).expect("a force");
    let giving = read(&format!("{beam}{springs}[load]\nuniform = 1\n[foundation]\ndepth = 1\n"));
    let alone = palkki::certificate::certify(&giving, Judged::Forces(&load), &[]).expect_err("springs");
    assert!(alone.to_string().contains("cannot compute supports that give yet"), "{alone}");
}

/// Two halves that all but do not bend, a hinge with a force `P` between them, on soil: each presses with `q + P/8 (1 + 3 (2 − s)/2)` at `s` from the
/// hinge, and sinks by that over `k`. So it does under the forces of the springs of a mesh.
#[test]
fn an_elastic_foundation_holds_what_its_forces_bend() {
    let (q, k, force) = (2.0, 5.0, 1.0);
    for pull in ["", "tension = 1e-6\n"] {
        let scene = read(&format!(
            "[beam]\nlength = 8.0\nbending_stiffness = 3e5\nsupports = []\njoints = [{{ at = 4.0 }}]\n{pull}\
             [load]\nuniform = {q:?}\npoint = [{{ at = 4.0, force = {force:?} }}]\n\
             [foundation]\npolynomial = [0.25, 0.125]\nstiffness = {k:?}\n"
        ));
        let pressed = |s: f64| q + force / 8.0 * (1.0 + 1.5 * (2.0 - s));
        let forces: Vec<(f64, f64)> =
            (0..32).map(|i| 0.125 + 0.25 * f64::from(i)).map(|x| (x, 0.25 * pressed((x - 4.0_f64).abs()))).collect();
        let (right, found) = judged(&scene, &forces);
        let deepest = 1.25 + pressed(4.0) / k;
        assert!(right.deflection_error <= 1e-5 && (right.deflection - deepest).abs() <= 1e-5, "{right:?}");
        // Forces in steps of `w` lack the moment `p' L w²/12` that the slope of the pressure has on each half, which two places 3.75 apart make up for.
        let lacking = 2.0 * (1.5 * force / 8.0 * 4.0 * 0.25 * 0.25 / 12.0) / 3.75 / 17.0;
        assert!(found.iter().all(|(_, share)| *share <= 1.01 * lacking), "{found:?}");
        assert_eq!(Verdict::of_forces(right).status, Status::Certified);
        // Twice the force says twice as deep, and is not in balance.
        let double: Vec<(f64, f64)> = forces.iter().map(|(x, force)| (*x, 2.0 * force)).collect();
        let (wrong, found) = judged(&scene, &double);
        assert!(0.9 * q / k <= wrong.deflection_error, "{wrong:?}");
        assert!(found.iter().any(|(kind, share)| *kind == ViolationKind::Balance && 0.1 < *share), "{found:?}");
        // Nothing that presses holds nothing.
        assert!(judged(&scene, &[(1.0, 0.0)]).0.deflection_error.is_infinite());
    }
}

/// General beams that nothing but an elastic foundation holds: no bound below the error of the largest deflection, and right forces are close.
#[test]
fn forces_of_soil_place_a_beam() {
    let (mut count, mut close) = (0, 0);
    for i in 0..sample_of(500_u64) {
        let Some((text, exact, right)) = scene(i, true) else { continue };
        let (scene, size) = (read(&text), exact.state.deflection.magnitude());
        if is_held(&scene) {
            continue;
        }
        for share in [1.0, 0.5] {
            let forces: Vec<(f64, f64)> = right.iter().map(|(x, force)| (*x, share * force)).collect();
            let (certificate, _) = judged(&scene, &forces);
            let off = (size - certificate.deflection).abs();
            let bound = certificate.deflection_error;
            assert!(off <= bound * (1.0 + 1e-6) + 1e-9 * size, "{i}: {off:e} for {certificate:?}\n{text}");
            count += usize::from(share >= 1.0);
            close += usize::from(share >= 1.0 && bound <= 0.05 * size);
        }
    }
    assert!(0 < count && 4 * count <= 10 * close, "{close} of {count}");
}
