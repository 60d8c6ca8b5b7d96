//! Faults in answers for beams on any supports, with own shapes and free ends, and in their witnesses, beside closed forms: a share
//! of what `cargo xtask certificates` tries.

use palkki::route::{Method, Solver};
use palkki_evidence::faults::{CONTACT_FAULTS, FAULTS, Truth, closed};

use super::{INTERVALS, bounded_truthfully, distance, is_near, load, passes};
use crate::scenes::run;

/// A middle and the largest size of each fault.
const SOME: [f64; 2] = [1e-6, 1e-1];

#[test]
fn faults_in_answers_of_held_beams_are_bounded_truthfully() {
    let (mut bounded, mut wrong) = (0, Vec::new());
    for known in &closed::all().expect("well-posed scenes") {
        let (truth, scene) = (Truth::closed(known), &known.scene);
        for method in Method::ALL {
            let sound = run(scene, method, Solver::ActiveSet, INTERVALS).state;
            let what = format!("{}, {method}", known.name);
            assert!(passes(scene, &sound), "{what}: without a fault it passes");
            assert!(bounded_truthfully(&what, &truth, &sound), "{what}: without a fault it has a bound");
            for fault in FAULTS {
                for &size in if fault.sized { &SOME[..] } else { &[0.0] } {
                    let Some(broken) = fault.put_into(&sound, size, load(scene), scene.beam().length()) else {
                        continue;
                    };
                    let what = format!("{what}: {}, {size:e}", fault.name);
                    bounded += usize::from(bounded_truthfully(&what, &truth, &broken));
                    let off = distance(scene, &sound, &broken);
                    if passes(scene, &broken) && !is_near(&truth, &off) {
                        wrong.push(format!("{what} passes, and is off by {off:?}"));
                    }
                }
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert!(1000 < bounded, "of {bounded} wrong answers something can be said");
}

#[test]
fn faults_in_witnesses_of_held_beams_cost_sharpness_and_never_truth() {
    let all = closed::all().expect("well-posed scenes");
    let mut tried = 0;
    for (number, known) in all.iter().enumerate() {
        let truth = Truth::closed(known);
        let state = run(&known.scene, Method::Force, Solver::ActiveSet, INTERVALS).state;
        let nodes = state.nodes.as_ref().expect("a grid has nodes");
        let mut check = |what: &str, witness: &[palkki::state::Contact]| {
            tried += 1;
            let judged = truth.nodes_from(nodes, witness).expect("numbers");
            assert!(judged.false_bounds.is_empty(), "{}: {what}: {judged:?}", known.name);
        };
        check("its own contacts", &state.contacts);
        for fault in CONTACT_FAULTS {
            for &size in if fault.sized { &SOME[..] } else { &[0.0] } {
                if let Some(broken) = fault.put_into(&known.contacts, size, known.scene.beam().length()) {
                    check(&format!("{}, {size:e}", fault.name), &broken);
                }
            }
        }
        let foreign = &all[(number + 1) % all.len()];
        check(&format!("the contacts of {}", foreign.name), &foreign.contacts);
    }
    assert!(8 * all.len() < tried, "only {tried} witnesses");
}
