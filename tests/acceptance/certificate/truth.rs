//! Random scenes with random forces, right, wrong or absurd: the true energy and the true deflection lie within the bounds.
//!
//! The truth is beam theory's, which shares no code with the judge.

use palkki::certificate::{Certificate, ContactLoad, Judged, certify, violations};
use palkki::route::{Method, Solver};
use palkki::scene::{Foundation, Scene};
use palkki::state::Nodes;
use palkki::theory::{self, Exact};
use palkki::{Settings, solve_raw};

use super::{of_forces, places};
use crate::scenes::uniform;
use palkki_evidence::compare::largest;
use palkki_evidence::random::{self, Random};

/// Theory is certified to twelve digits of the largest numbers that the scene has.
const THEORY: f64 = 1e-10;
/// Scenes of each series.
const SCENES: u64 = 150;

/// Forces of some kind: of the scene's own grid, then spoilt in one of several ways, or made up.
fn forces(random: &mut Random, scene: &Scene, exact: &Exact) -> Vec<(f64, f64)> {
    let l = scene.beam().length();
    let all = 1.0 + exact.state.contacts.iter().map(|c| c.force).sum::<f64>().abs();
    let made_up = |random: &mut Random| {
        let count = random.below(12);
        (0..count).map(|_| (random.between(0.0, l), all * random.between(-0.1, 0.5))).collect()
    };
    let intervals = 2 + random.below(60);
    let raw =
        solve_raw(scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals)).expect("the grid is fine enough");
    let Some(nodes) = raw.state.nodes else { return made_up(random) };
    let mut given: Vec<(f64, f64)> = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect();
    match random.below(11) {
        0 => return made_up(random),
        1 => {
            let share = 10.0_f64.powf(random.between(-12.0, 0.0));
            given.iter_mut().for_each(|f| f.1 *= 1.0 + random.between(-share, share));
        }
        2 => {
            let dropped = random.below(given.len());
            given.remove(dropped);
        }
        3 => given.iter_mut().for_each(|f| f.0 = (f.0 + random.between(0.0, 0.1) * l).min(l)),
        4 => given.iter_mut().for_each(|f| f.1 += all * random.between(-0.01, 0.01)),
        5 => given.iter_mut().for_each(|f| f.1 = -f.1),
        6 => given.iter_mut().for_each(|f| f.1 = 0.3 * all),
        7 => given.iter_mut().for_each(|f| f.0 = l - f.0),
        8 => given.iter_mut().step_by(3).for_each(|f| f.1 *= 2.0),
        9 => {
            let most = given.iter().map(|f| f.1).fold(0.0, f64::max);
            given.retain(|f| f.1 < most);
        }
        _ => {}
    }
    given
}

/// The deflection under the true load and forces, by the beam's own flexibility.
fn caused(scene: &Scene, forces: &[(f64, f64)]) -> impl Fn(f64) -> f64 {
    let (l, ei) = (scene.beam().length(), scene.beam().bending_stiffness());
    let bare = Scene::new(scene.beam().clone(), scene.load().clone(), None).expect("a beam without a foundation");
    let free = theory::solve(&bare).expect("a free beam");
    move |x: f64| {
        let lifted = forces.iter().map(|&(at, force)| {
            let (a, b) = (x.min(at), l - x.max(at));
            force.max(0.0) * a * b * (l * l - a * a - b * b) / (6.0 * ei * l)
        });
        free.deflection(x) - lifted.sum::<f64>()
    }
}

/// Units in which rounding of theory is small: of the energy and of the deflection.
fn units(scene: &Scene, exact: &Exact) -> [f64; 2] {
    let scale = scene.scaled().expect("the scene can be scaled").scale;
    let size = exact.state.deflection.magnitude();
    [exact.state.energy.abs().max(scale.energy()), size.max(scale.depth)]
}

#[track_caller]
fn holds(what: &str, certificate: &Certificate, scene: &Scene, exact: &Exact, judged: impl Fn(f64) -> f64) {
    let [energy_unit, unit] = units(scene, exact);
    let energy = exact.state.energy;
    assert!(certificate.energy_lower <= energy + THEORY * energy_unit, "{what}: {energy} for {certificate:?}");
    assert!(energy - THEORY * energy_unit <= certificate.energy_upper, "{what}: {energy} for {certificate:?}");
    assert!(certificate.energy_lower <= certificate.energy_upper && 0.0 <= certificate.gap, "{what}: {certificate:?}");
    assert!(certificate.gap.is_finite(), "{what}: there is always a bound, {certificate:?}");
    let l = scene.beam().length();
    let load = scene.load().magnitude(l);
    for (support, bracket) in exact.state.supports.iter().zip(&certificate.reactions) {
        let Some([least, most]) = *bracket else { continue };
        let slack = THEORY * load.max(support.force.abs());
        assert!(
            least <= support.force + slack && support.force - slack <= most,
            "{what}: {support:?} for {certificate:?}"
        );
    }
    for k in 1..40 {
        let x = l * f64::from(k) / 40.0;
        let v = judged(x);
        let off = (v - exact.deflection(x)).abs();
        let slack = THEORY * unit.max(v.abs());
        assert!(off <= certificate.deflection_error + slack, "{what}: {off} at {x} for {certificate:?}");
    }
}

fn check(name: &str, i: u64, scene: &Scene) -> bool {
    let exact = theory::solve(scene).expect("theory has an answer");
    if !exact.solved {
        return false;
    }
    let mut random = Random::new(0xb0bb_0000 + i);
    let given = forces(&mut random, scene, &exact);
    let what = format!("{name} {i}");
    let load = ContactLoad::new(scene.beam().length(), given.iter().copied()).expect("finite forces on the beam");
    assert!(violations(scene, &load).is_ok(), "{what}");
    let caused = caused(scene, &given);
    for (whose, witness) in [("exact", &exact.state.contacts), ("its own", &places(&given)), ("no", &Vec::new())] {
        let certificate = of_forces(scene, &given, witness);
        holds(&format!("{what}, {whose} contacts"), &certificate, scene, &exact, &caused);
    }

    let exact_contacts = &exact.state.contacts;
    let contacts = certify(scene, Judged::Witness, exact_contacts).expect("the scene can be scaled");
    assert!(contacts.deflection_error.is_finite(), "{what}: an exact answer has a bound");
    if contacts.contacts_proven {
        holds(&format!("{what}, exact"), &contacts, scene, &exact, |x| exact.deflection(x));
    }
    true
}

#[test]
fn right_and_wrong_forces_on_random_scenes_are_bounded_truthfully() {
    let mut compared = 0;
    let scenes = random::sample_of(SCENES);
    for i in 0..scenes {
        compared += usize::from(check("random", i, &random::scene(i)));
        compared += usize::from(check("lattice", i, &random::on_lattice(i)));
        if i % 5 == 0 {
            compared += usize::from(check("rough", i, &random::rough(i)));
        }
    }
    assert!(scenes < compared as u64, "theory is certified on most scenes: {compared}");
}

/// The example with a lift-off point moved by `δ`: what it is off by, from the closed form of a span that ends at `a + δ` with
/// `v = u`, `v' = 0`. It grows with `δ²`, and the certificate from the right lift-off points says so.
#[test]
fn a_lift_off_point_that_is_off_is_off_by_the_square() {
    /// The bound is the true error to a few per cent, and what rounding adds.
    const LOOSE: f64 = 1.05;
    /// Of the depth: values at nodes that are known to a unit in the last place, and cubics between them.
    const ROUNDING: f64 = 1e-11;
    const INTERVALS: u32 = 10_000;
    let scene = palkki_evidence::paper::example().expect("the example is well posed");
    let (ei, l) = (scene.beam().bending_stiffness(), scene.beam().length());
    // Deflection and moment under a unit load.
    let span = |a: f64, x: f64| {
        let third = -(ei + a * a * a * a / 8.0) / (2.0 * a * a * a);
        let first = -3.0 * third * a * a - a * a * a / 6.0;
        let v = (first * x + third * x * x * x + x * x * x * x / 24.0) / ei;
        if x < a { [v, -6.0 * third * x - 0.5 * x * x] } else { [1.0, 0.0] }
    };
    let exact = theory::solve(&scene).expect("theory has an answer");
    let a = exact.state.contacts[0].from;
    for share in [1e-2, 1e-3, 1e-4, 1e-5] {
        let moved = a + share * l;
        let x: Vec<f64> = (1..INTERVALS).map(|k| l * f64::from(k) / f64::from(INTERVALS)).collect();
        let values = x.iter().map(|&x| if x < 0.5 * l { span(moved, x) } else { span(a, l - x) });
        let (deflection, moment): (Vec<f64>, Vec<f64>) = values.map(|[v, m]| (v, m)).unzip();
        let off = largest(x.iter().map(|&x| span(a, x)[0] - span(moved, x)[0]));
        let nodes = Nodes { x, deflection, moment, ..Nodes::default() };
        let certificate = certify(&scene, Judged::Nodes(&nodes), &exact.state.contacts);
        let bound = certificate.expect("the scene can be scaled").deflection_error;
        assert!(off <= bound && bound <= LOOSE * off + ROUNDING, "moved by {share:e}: {off:e}, bound {bound:e}");
    }
}

/// A force that throws the beam beyond all numbers, from a pattern of which nothing follows: no admissible deflection is found,
/// and nothing is bounded by its distance from one.
#[test]
fn where_no_admissible_deflection_is_found_nothing_is_bounded() {
    let scene = uniform(1.0, 1e-300, 1e-100, Foundation::Polynomial { coefficients: vec![1.0, 1.0] });
    let forces = [(0.3, 1e-100), (0.5, 1e-100), (0.7, 1e300)];
    let certificate = of_forces(&scene, &forces, &places(&forces));
    let bounds = [certificate.gap, certificate.deflection_error, certificate.best_deflection_error];
    assert!(bounds.iter().all(|bound| bound.is_infinite()), "{certificate:?}");
    assert!(certificate.energy_upper.is_infinite() && certificate.energy_lower.is_infinite(), "{certificate:?}");
    assert!(!certificate.contacts_proven && certificate.reactions == [None, None], "{certificate:?}");
}
