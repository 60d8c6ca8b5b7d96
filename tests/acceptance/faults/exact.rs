//! Faults in the contacts of exact answers: the certificate says how far off the deflection is that they make.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::state::Contact;
use palkki::trial::{CONTACT_FAULTS, SIZES, Truth};

use crate::scenes::report;

#[test]
fn faults_in_exact_contacts_are_bounded_truthfully() {
    let mut judged_at_all = 0;
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        for fault in CONTACT_FAULTS {
            for &size in if fault.sized { &SIZES[..] } else { &[0.0] } {
                let broken = fault.put_into(&truth.exact.state.contacts, size, scene.beam().length());
                if let Some(judged) = broken.and_then(|broken| truth.contacts(&broken)) {
                    assert!(judged.lies.is_empty(), "{name}: {}, {size:e}: {judged:?}", fault.name);
                    judged_at_all += 1;
                }
            }
        }
    }
    assert!(CONTACT_FAULTS.len() * report().len() < judged_at_all, "only {judged_at_all} faults were judged");
}

/// Places that are off by this share of the length and more are not certain to what a discrete answer is asked for.
const REFUSED: f64 = 1e-8;
/// The end of a zone may be off by the root of what is allowed before it is felt: there `v = u`, `v' = u'` and `v'' = u''`, so
/// that a beam that lifts off a little too early or too late is off by the square of that.
const REFUSED_AT_ZONES: f64 = 1e-4;
/// A point of contact that is about to become a zone: there `v''` is nearly `u''`, too.
const VERGE: &str = "verge";

#[test]
fn places_that_are_off_are_not_certain() {
    let mut tried = 0;
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        let contacts = &truth.exact.state.contacts;
        let certain = |contacts: &[Contact]| {
            let judged = truth.contacts(contacts).expect("contacts are judged");
            judged.certificate.deflection_error <= CERTIFIED_RESIDUAL * truth.deflection
        };
        assert!(certain(contacts), "{name}: the exact answer is certain");
        for fault in CONTACT_FAULTS.iter().filter(|fault| fault.sized) {
            // A beam that is let go over a short stretch beside a support only sags with the fourth power of that.
            if contacts.iter().any(|c| c.from <= 0.0 || scene.beam().length() <= c.to) {
                continue;
            }
            let zones = name == VERGE || contacts.iter().any(|c| c.from < c.to);
            let refused = if zones { REFUSED_AT_ZONES } else { REFUSED };
            for &size in SIZES.iter().filter(|size| refused <= **size) {
                if let Some(broken) = fault.put_into(contacts, size, scene.beam().length()) {
                    assert!(!certain(&broken), "{name}: {}, {size:e}, goes unnoticed", fault.name);
                    tried += 1;
                }
            }
        }
    }
    assert!(report().len() < tried, "only {tried} contacts were off");
}
