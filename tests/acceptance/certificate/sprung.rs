//! Forces of the springs of another program: how far the beam is that they bend.

use palkki::certificate::{Certificate, ContactLoad, Judged, ViolationKind, violations};
use palkki::route::Status;
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::theory::Exact;
use palkki::verdict::Verdict;
use palkki::{Witness, theory};
use palkki_evidence::random::{Random, sample_of};

use crate::theory::settled::pipe;

/// A free beam on an elastic foundation, pressed all along or in parts.
fn free(seed: u64) -> Scene {
    let mut random = Random::new(0x60_0000 + seed);
    let length = random.pick(&[10.0, 20.0, 40.0]);
    let beam = Beam::new(length, random.pick(&[1e3, 1e4, 5e4])).and_then(|beam| beam.with_supports(Vec::new()));
    let beam = beam.expect("a beam");
    let points = vec![PointLoad { at: length * random.between(0.3, 0.7), force: random.pick(&[20.0, 100.0, 300.0]) }];
    let load = Load::new(&beam, random.pick(&[5.0, 20.0]), Vec::new(), points).expect("finite");
    let ground = match random.below(2) {
        0 => Foundation::Flat { depth: random.pick(&[0.0, 2.0]) },
        _ => Foundation::Polynomial { coefficients: vec![1.0, random.between(-0.01, 0.01)] },
    };
    Scene::above(beam, load, Some(ground), Some(random.pick(&[100.0, 1000.0]))).expect("a scene")
}

/// What the springs at the nodes of equal intervals exert that stand for the pressure of an answer on their shares of the beam; those at
/// supports that only push with the force of these.
fn springs(scene: &Scene, exact: &Exact, intervals: u32) -> Vec<(f64, f64)> {
    let length = scene.beam().length();
    let step = length / f64::from(intervals);
    let node = |i: u32| {
        let x = step * f64::from(i);
        let [from, to] = [(x - 0.5 * step).max(0.0), (x + 0.5 * step).min(length)];
        let part = (to - from) / 40.0;
        let pressure: f64 = (0..40).map(|k| part * exact.pressure(from + part * (0.5 + f64::from(k)))).sum();
        let here = exact.state.supports.iter().filter(|s| s.pushes_only && (s.at - x).abs() <= 0.5 * step);
        let pushed: f64 = here.map(|support| support.force).sum();
        (x, pressure + pushed)
    };
    (0..=intervals).map(node).collect()
}

/// The certificate of forces.
#[track_caller]
fn judged(scene: &Scene, forces: &[(f64, f64)]) -> Certificate {
    let load = ContactLoad::new(scene.beam().length(), forces.iter().copied()).expect("forces");
    Witness::of(scene).judge(Judged::Forces(&load), &[]).expect("in range")
}

/// Whether the largest deflection that is judged and that of theory are no farther apart than the bound.
fn holds(certificate: &Certificate, exact: &Exact) -> bool {
    let size = exact.state.deflection.magnitude();
    let off = (certificate.deflection_at_least - size).max(0.0);
    off <= certificate.deflection_error && size <= certificate.deflection + certificate.deflection_error
}

/// Springs of finer and finer meshes: the bound holds, and falls with the square of the spacing. Of a beam many times as long as `1/λ`, and
/// of one that supports hold far away, it is large: forces alone bend it, and what they are off by adds up.
#[test]
fn forces_of_springs_are_judged() {
    for seed in 0..sample_of(120) {
        let (pipe, free) = (pipe(seed), free(seed));
        let decay = (0.25 * free.ground_stiffness().expect("soft") / free.beam().bending_stiffness()).sqrt().sqrt();
        let usable = if free.beam().length() * decay <= 8.0 { 0.1 } else { f64::INFINITY };
        for (scene, usable) in [(pipe, f64::INFINITY), (free, usable)] {
            let exact = theory::solve(&scene).expect("an answer");
            let size = exact.state.deflection.magnitude();
            let share = |intervals: u32| {
                let certificate = judged(&scene, &springs(&scene, &exact, intervals));
                assert!(holds(&certificate, &exact), "{seed}, {intervals}: {certificate:?}\n{scene:?}");
                assert!(certificate.energy_lower <= exact.state.energy + 1e-9 * exact.state.energy.abs());
                certificate.deflection_error / size
            };
            let shares = [80, 320].map(share);
            assert!(shares[0] <= usable && shares[1] <= 0.25 * shares[0] + 1e-4, "{seed}: {shares:?}\n{scene:?}");
        }
    }
}

/// Forged: one force twice as large, all a tenth less, or all moved to the next node. The bound holds, and says what is wrong.
#[test]
fn forged_forces_of_springs_are_found() {
    for seed in 0..sample_of(80) {
        let scene = free(seed);
        let exact = theory::solve(&scene).expect("an answer");
        let right = springs(&scene, &exact, 100);
        let strongest = (0..right.len()).max_by(|a, b| right[*a].1.total_cmp(&right[*b].1)).expect("forces");
        let forged: [Vec<(f64, f64)>; 3] = [
            (0..right.len()).map(|i| (right[i].0, right[i].1 * if i == strongest { 10.0 } else { 1.0 })).collect(),
            right.iter().map(|f| (f.0, 0.5 * f.1)).collect(),
            (0..right.len()).map(|i| (right[i].0, right[(i + 10) % right.len()].1)).collect(),
        ];
        for (k, forces) in forged.iter().enumerate() {
            let certificate = judged(&scene, forces);
            assert!(holds(&certificate, &exact), "{seed}, {k}: {certificate:?}\n{scene:?}");
            let load = ContactLoad::new(scene.beam().length(), forces.iter().copied()).expect("forces");
            let worst =
                |load: &ContactLoad| violations(&scene, load).expect("in range").first().map_or(0.0, |v| v.relative);
            let own = ContactLoad::new(scene.beam().length(), right.iter().copied()).expect("forces");
            assert!(3.0 * worst(&own) <= worst(&load), "{seed}, {k}: {} beside {}", worst(&load), worst(&own));
        }
    }
}

/// A weightless beam under a force in the middle, of which the springs are known, and which nothing else places; forces that say nothing
/// of it have no bound.
#[test]
fn forces_place_a_beam_that_nothing_holds() {
    let scene = free(0);
    let exact = theory::solve(&scene).expect("an answer");
    let verdict = Verdict::of_forces(judged(&scene, &springs(&scene, &exact, 200)));
    assert_eq!(verdict.status, Status::Certified, "{verdict}");
    let none = judged(&scene, &[(1.0, 0.0), (2.0, 0.0)]);
    assert!(none.deflection_error.is_infinite(), "{none:?}");
    let load =
        ContactLoad::new(scene.beam().length(), [(1.0, 5.0), (2.0, 0.0), (3.0, 5.0), (4.0, 0.0)]).expect("forces");
    let kinds: Vec<_> = violations(&scene, &load).expect("in range").iter().map(|v| v.kind).collect();
    assert!(kinds.contains(&ViolationKind::SpringLaw) && kinds.contains(&ViolationKind::Balance), "{kinds:?}");
    // On a single support that holds they say how it turns.
    let beam = scene.beam().clone().with_supports(vec![Support::simple(0.0)]).expect("a beam");
    let one = Scene::above(beam, scene.load().clone(), scene.foundation().cloned(), scene.ground_stiffness());
    let one = one.expect("a scene");
    let exact = theory::solve(&one).expect("an answer");
    let certificate = judged(&one, &springs(&one, &exact, 200));
    assert!(holds(&certificate, &exact) && Verdict::of_forces(certificate).status == Status::Certified);
}
