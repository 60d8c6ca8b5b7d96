//! Faults in the contacts of exact answers, and in witnesses: the certificate says how far off the deflection is that they make,
//! and a wrong witness costs sharpness and never truth.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::{Method, Solver};
use palkki::state::Contact;
use palkki_evidence::faults::{CONTACT_FAULTS, SIZES, Truth, every_contact_fault};

use super::super::SOME;
use super::INTERVALS;
use crate::scenes::{report, run};

/// Places that are off by this share of the length and more are not certain to what a discrete answer is asked for.
const REFUSED: f64 = 1e-8;
/// The end of a zone may be off by the root of what is allowed before it is felt: there `v = u`, `v' = u'` and `v'' = u''`, so
/// that a beam that lifts off a little too early or too late is off by the square of that.
const REFUSED_AT_ZONES: f64 = 1e-4;
/// A point of contact that is about to become a zone: there `v''` is nearly `u''`, too.
const VERGE: &str = "verge";

#[test]
fn faults_in_exact_contacts_are_bounded_truthfully_and_not_certain() {
    let (mut tried, mut off) = (0, 0);
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        let length = scene.beam().length();
        let certain = |what: &str, contacts: &[Contact]| {
            let judged = truth.contacts(contacts)?;
            assert!(judged.false_bounds.is_empty(), "{name}: {what}: {judged:?}");
            Some(judged.certificate.deflection_error <= CERTIFIED_RESIDUAL * truth.deflection)
        };
        assert_eq!(certain("no fault", &truth.contacts), Some(true), "{name}: the exact answer is certain");
        let zones = name == VERGE || truth.contacts.iter().any(|c| c.from < c.to);
        // A beam that is let go over a short stretch beside a support only sags with the fourth power of that.
        let at_support = truth.contacts.iter().any(|c| c.from <= 0.0 || length <= c.to);
        for (fault, size, broken) in every_contact_fault(&truth.contacts, length, &SIZES) {
            let what = format!("{}, {size:e}", fault.name);
            let Some(certain) = certain(&what, &broken) else { continue };
            tried += 1;
            if fault.sized && !at_support && if zones { REFUSED_AT_ZONES } else { REFUSED } <= size {
                assert!(!certain, "{name}: {what}, goes unnoticed");
                off += 1;
            }
        }
    }
    assert!(CONTACT_FAULTS.len() * report().len() < tried, "only {tried} faults were judged");
    assert!(report().len() < off, "only {off} contacts were off");
}

/// The same answer from the right witness, from one with each fault in it, and from those of all other scenes: what is said is
/// true, there is always a bound, and no wrong witness makes it sharper than rounding can.
#[test]
fn faults_in_a_witness_cost_sharpness_and_never_truth() {
    /// A fault that is as small as rounding may be as good as the list itself.
    const ROUNDING: f64 = 1e-9;
    let scenes = report();
    let lists: Vec<_> =
        scenes.iter().map(|(_, scene)| Truth::of(scene).expect("theory has an answer").contacts).collect();
    for ((name, scene), contacts) in scenes.iter().zip(&lists) {
        let truth = Truth::of(scene).expect("theory has an answer");
        let state = run(scene, Method::Force, Solver::ActiveSet, INTERVALS).state;
        let nodes = state.nodes.as_ref().expect("a grid has nodes");
        let sound = truth.nodes(nodes).expect("numbers").certificate.deflection_error;
        let check = |what: &str, witness: &[Contact]| {
            let judged = truth.nodes_from(nodes, witness).expect("numbers");
            assert!(judged.false_bounds.is_empty(), "{name}: {what}: {judged:?}");
            let error = judged.certificate.deflection_error;
            assert!(error.is_finite(), "{name}: {what}: there is always a bound");
            assert!((1.0 - ROUNDING) * sound <= error, "{name}: {what}: {error:e} and not {sound:e}");
        };
        check("its own contacts", &state.contacts);
        for (fault, size, broken) in every_contact_fault(contacts, scene.beam().length(), &SOME) {
            check(&format!("{}, {size:e}", fault.name), &broken);
        }
        for ((other, _), foreign) in scenes.iter().zip(&lists) {
            check(&format!("the contacts of {other}"), foreign);
        }
    }
}
