//! Beams on any supports, with own shapes, free ends and none to hold them, against closed forms.
//!
//! With the right contacts the deflection is known to a billionth of its size. With wrong ones what is said stays true: of the
//! deflection of nodes that are off by a known amount, of the energy and of the forces of supports.

use super::SOME;
use palkki::certificate::{ContactLoad, Judged, Lumped, certify, violations};
use palkki::scene::{Foundation, Scene, Support};
use palkki::state::{Contact, Nodes};
use palkki_evidence::closed::{self, Closed, EI, Q, between, overhang};
use palkki_evidence::compare::largest;
use palkki_evidence::faults::{Truth, every_contact_fault};

use crate::scenes::on_supports;

fn at(x: f64) -> Contact {
    Contact::at(x, 1.0)
}

pub(super) fn zone(from: f64, to: f64) -> Contact {
    Contact { from, to, force: 1.0, end_forces: None }
}

pub(super) fn flat(depth: f64) -> Option<Foundation> {
    Some(Foundation::Flat { depth })
}

/// Nodes at equal distances with the deflection of a function, without moments between them: what is judged at the nodes.
pub(super) fn sampled(scene: &Scene, deflection: impl Fn(f64) -> f64) -> Nodes {
    let length = scene.beam().length();
    let held = |x: f64| scene.beam().supports().iter().any(|s| (s.at - x).abs() <= 0.0);
    let places = (0..=40_u32).map(|k| length * f64::from(k) / 40.0);
    let x: Vec<f64> = places.filter(|&x| (0.0 < x && x < length) || !held(x)).collect();
    let deflection: Vec<f64> = x.iter().map(|&x| deflection(x)).collect();
    Nodes { moment: vec![0.0; x.len()], deflection, x, ..Nodes::default() }
}

/// With the right contacts what is said is sharp, and with any others it is true.
#[track_caller]
fn check(known: &Closed) {
    /// Of the largest deflection.
    const SHARP: f64 = 1e-9;
    /// Of closed forms.
    const ROUNDING: f64 = 1e-11;
    let Closed { name, scene, contacts, .. } = known;
    let (length, truth) = (scene.beam().length(), Truth::closed(known));
    let right = certify(scene, Judged::Witness, contacts).expect("in range");
    let size = truth.deflection;
    assert!((right.deflection - size).abs() <= 1e-3 * size + ROUNDING, "{name}: {size} for {right:?}");
    assert!(right.deflection_error <= SHARP * size.max(1e-3) && right.up_to_a_turn.is_none(), "{name}: {right:?}");
    let beside = truth.contacts(contacts).expect("in range");
    assert!(beside.false_bounds.is_empty(), "{name}: {:?} of {right:?}", beside.false_bounds);
    let slack = 1e-6 * (right.energy_lower.abs() + right.energy_upper.abs());
    assert!(right.energy_upper - right.energy_lower <= slack, "{name}: {right:?}");
    for [least, most] in right.reactions.iter().flatten().filter(|_| scene.foundation().is_none()) {
        assert!(most - least <= 1e-6 * (Q * length).max(most.abs()), "{name}: {right:?}");
    }

    // Nodes that are off, by any witness; by all of them where they are off by little.
    for off in [0.03, 0.0, -0.2].map(|off| off * size.max(1.0)) {
        let nodes = sampled(scene, |x| known.deflection(x) + off * (3.0 * x / length).sin());
        let most = largest(nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| v - known.deflection(*x)));
        let holds = |what: &str, witness: &[Contact]| {
            let said = truth.nodes_from(&nodes, witness).expect("in range");
            assert!(said.false_bounds.is_empty(), "{name}, {what}: {said:?}");
            let said = said.certificate.deflection_error;
            assert!(most <= said + ROUNDING * size.max(1.0), "{name}, {what}: {most} for {said}");
            said
        };
        assert!(holds("right", contacts).is_finite(), "{name}");
        holds("none", &[]);
        for (fault, size, wrong) in every_contact_fault(contacts, length, &SOME).filter(|_| 0.0 < off) {
            holds(&format!("{} by {size}", fault.name), &wrong);
        }
    }
}

/// A closed form meets the definition: `EI v'''' = q` of free spans follows from its derivation; that it is held by its supports, and
/// above the ground but for its contacts, is seen here, and that forces of supports and contacts add up where no contact is a zone.
#[test]
fn closed_forms_are_admissible() {
    /// Of the largest deflection.
    const ROUNDING: f64 = 1e-12;
    for known in closed::all().expect("well-posed scenes") {
        let Closed { name, scene, contacts, .. } = &known;
        let (length, size) = (scene.beam().length(), known.largest());
        for k in 0..=1000_u32 {
            let x = length * f64::from(k) / 1000.0;
            let clearance = scene.gap(x) - known.deflection(x);
            assert!(-ROUNDING * size <= clearance, "{name}: {clearance} at {x}");
            if contacts.iter().any(|c| c.from <= x && x <= c.to) {
                assert!(
                    clearance <= ROUNDING * size.max(scene.gap(x).abs()),
                    "{name}: {clearance} at {x} in a contact"
                );
            }
        }
        for support in scene.held() {
            let off = known.deflection(support.at) - support.deflection;
            assert!(off.abs() <= ROUNDING * size, "{name}: off by {off} at {support:?}");
        }
        if contacts.is_empty() {
            let forces: f64 = known.reactions().into_iter().map(|force| force.expect("no contact")).sum();
            let load = scene.load().resultant(length);
            assert!((forces - load).abs() <= 1e-10 * (load + 1.0), "{name}: {forces} carry {load}");
        }
    }
}

#[test]
fn every_closed_form_is_known() {
    closed::all().expect("well-posed scenes").iter().for_each(check);
}

/// A beam in balance on one place: how it stands is not known, and how it is bent is.
#[test]
fn of_a_beam_that_may_turn_the_bending_is_known() {
    let l = 6.0;
    let scene = on_supports([l, EI], &[Support::simple(0.5 * l)], (Q, &[]), None);
    let said = certify(&scene, Judged::Witness, &[]).expect("in balance");
    let bent = move |x: f64| overhang(0.5 * l, (x - 0.5 * l).abs());
    assert!(said.up_to_a_turn == Some(0.5 * l) && said.deflection_error <= 1e-9 * bent(0.0), "{said:?}");
    assert!((said.deflection - bent(0.0)).abs() <= 1e-9 * bent(0.0), "{said:?}");
    // −½ ∫M²/EI with M = q s²/2 on both sides.
    let energy = -2.0 * Q * Q * (0.5_f64 * l).powi(5) / (40.0 * EI);
    assert!(
        said.energy_lower <= energy * (1.0 - 1e-12) && energy * (1.0 + 1e-12) <= said.energy_upper,
        "{energy}: {said:?}"
    );
    let on_its_end = |ground| on_supports([l, EI], &[], (0.0, &[(0.0, 5.0)]), ground);
    let scene = on_its_end(flat(2.0));
    let said = certify(&scene, Judged::Witness, &[at(0.0)]).expect("in balance");
    assert!(said.up_to_a_turn == Some(0.0) && said.deflection_error <= 1e-9, "{said:?}");
    assert!(said.energy_lower <= -10.0 && -10.0 <= said.energy_upper, "−P g: {said:?}");
    // On ground that rises it stands as little inclined as the ground lets it.
    let scene = on_its_end(Some(Foundation::Polynomial { coefficients: vec![2.0, -0.125, -0.01] }));
    let said = certify(&scene, Judged::Witness, &[at(0.0)]).expect("in balance");
    assert!(said.up_to_a_turn == Some(0.0) && said.deflection_error <= 1e-11, "{said:?}");
}

/// Ground that is level with the one support on both sides leaves one slope there, its own: a force that lifts one end bends the
/// beam as if it were built in, `v = u − P s² (3a − s)/6EI` at the distance `s` from the support, and the other side lies on the
/// ground. On a ridge the beam can turn, as far as the ground stops it.
#[test]
fn level_ground_on_both_sides_of_a_support_holds_the_slope() {
    let (l, a, force, depth) = (8.0, 3.0, 2.0, 0.5);
    let lifted = |ground| on_supports([l, EI], &[Support::simple(a).at_level(depth)], (0.0, &[(0.0, -force)]), ground);
    let scene = lifted(flat(depth));
    let truth = |x: f64| {
        let s = (a - x).max(0.0);
        depth - force * s * s * (3.0 * a - s) / (6.0 * EI)
    };
    let said = certify(&scene, Judged::Witness, &[]).expect("in range");
    assert!(said.up_to_a_turn.is_none() && said.deflection_error <= 1e-9 * truth(0.0).abs(), "{said:?}");
    let energy = -force * force * a * a * a / (6.0 * EI) + force * depth;
    assert!(said.energy_lower <= energy + 1e-12 && energy - 1e-12 <= said.energy_upper, "{energy}: {said:?}");
    for off in [0.0, 0.1] {
        let nodes = sampled(&scene, |x| truth(x) + off * (x - a));
        let said = certify(&scene, Judged::Nodes(&nodes), &[]).expect("in range");
        let most = largest(nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| v - truth(*x)));
        assert!(most <= said.deflection_error && said.deflection_error.is_finite(), "{most}: {said:?}");
    }
    let scene = lifted(Some(Foundation::Polyline { points: vec![[0.0, 1.0], [a, depth], [l, 1.0]] }));
    let said = certify(&scene, Judged::Witness, &[]).expect("in range");
    let exact = palkki::theory::solve(&scene).expect("theory has an answer").state;
    assert!(said.energy_lower <= exact.energy && exact.energy <= said.energy_upper, "{}: {said:?}", exact.energy);
    let size = exact.deflection.magnitude();
    assert!(size <= said.deflection + said.deflection_error && said.deflection_error.is_finite(), "{size}: {said:?}");
    assert!(!said.contacts_proven, "{said:?}");
}

/// Ground that carries at 1 and at 5.5 alone.
fn two_posts(l: f64) -> Foundation {
    Foundation::Polyline { points: vec![[0.0, 30.0], [1.0, 1.0], [3.0, 30.0], [5.5, 1.0], [l, 30.0]] }
}

/// Forces from elsewhere: those of the supports follow, and what does not balance is told.
#[test]
fn forces_from_elsewhere_are_bounded_on_any_supports() {
    let l = 6.0;
    let scene = on_supports([l, EI], &[], (Q, &[]), Some(two_posts(l)));
    // Σp = q l, Σ p x = q l²/2.
    let right = Q * l * (0.5 * l - 1.0) / 4.5;
    let exact = [(1.0, Q * l - right), (5.5, right)];
    let witness = [at(1.0), at(5.5)];
    let of = |forces: &[(f64, f64)]| {
        let forces = ContactLoad::new(l, forces.iter().copied()).expect("forces");
        let said = certify(&scene, Judged::Forces(&forces), &witness).expect("in range");
        (said, violations(&scene, &forces).expect("in range"))
    };
    let (said, violated) = of(&exact);
    assert!(said.deflection_error <= 1e-9 * said.deflection, "{said:?}");
    assert!(violated.iter().all(|v| v.relative < 1e-9), "{violated:?}");
    let (said, violated) = of(&[(1.0, 5.0), (5.5, 5.0)]);
    assert!(violated.iter().any(|v| v.kind.name() == "balance" && 7.9 < v.amount), "{violated:?}");
    assert!(said.deflection_error.is_finite(), "{said:?}");
    assert!(of(&[]).0.deflection_error.is_infinite(), "nothing holds the beam");

    let three = [Support::built_in(0.0), Support::simple(3.0), Support::simple(l).at_level(0.2)];
    let scene = on_supports([l, EI], &three, (Q, &[]), flat(20.0));
    let none = ContactLoad::new(l, []).expect("none");
    let said = certify(&scene, Judged::Forces(&none), &[]).expect("in range");
    assert!(said.deflection_error <= 1e-9 * said.deflection, "three supports say all: {said:?}");
    assert!(violations(&scene, &none).expect("in range").is_empty());
    let lifted = ContactLoad::new(l, [(4.5, 0.5)]).expect("a force");
    let said = certify(&scene, Judged::Forces(&lifted), &[]).expect("in range");
    assert!(1e-3 * said.deflection < said.deflection_error, "{said:?}");
}

/// Forces at nodes, for a load that is lumped there: the exact ones of a statically determinate beam, on any supports. At the nodes
/// the beam is off by what the load bends between them, `q Δ² (…)/24 EI` at most some thousandths.
#[test]
fn lumped_forces_are_bounded_on_any_supports() {
    let l = 6.0;
    let right = Q * l * (0.5 * l - 1.0) / 4.5;
    for (supports, contacts) in [
        (vec![], vec![(1.0, Q * l - right), (5.5, right)]),
        (vec![Support::simple(1.0).at_level(1.0)], vec![(5.5, right)]),
        (vec![Support::simple(1.0).at_level(1.0), Support::simple(5.5).at_level(1.0)], vec![]),
    ] {
        let scene = on_supports([l, EI], &supports, (Q, &[]), Some(two_posts(l)));
        let rows = (0..=120_u32).map(|k| (l * f64::from(k) / 120.0, 0.0)).chain(contacts.iter().copied());
        let lumped = Lumped::new(&scene, rows).expect("nodes of equal intervals");
        assert_eq!(lumped.intervals(), 120);
        let witness: Vec<Contact> = contacts.iter().map(|c| at(c.0)).collect();
        let said = certify(&scene, Judged::Nodes(&lumped.nodes), &witness).expect("in range");
        let most = lumped.nodes.x.iter().zip(&lumped.nodes.deflection);
        let most = most.fold(0.0, |most: f64, (x, v)| most.max((v - 1.0 - between(1.0, 5.5, l, *x)).abs()));
        assert!(most <= said.deflection_error && said.deflection_error <= 5e-3, "{most} for {said:?}");
        let uneven = Lumped::new(&scene, [(0.0, 1.0), (2.0, 1.0), (4.1, 1.0), (l, 1.0)]);
        assert!(uneven.is_err(), "{uneven:?}");
    }
}
