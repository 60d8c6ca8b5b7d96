//! Faults in what a discretised answer says of its nodes.

use palkki::route::{Method, Solver};
use palkki_evidence::faults::{FAULTS, SIZES, Truth, closed};

use super::{INTERVALS, bounded_truthfully, distance, load, passes, passes_only_near, states};
use crate::scenes::{example, report, run};

#[test]
fn faults_are_refused_or_harmless_on_every_route() {
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        for method in Method::ALL {
            let (sound, states) = states(&scene, method);
            for (solver, state) in &states {
                for fault in FAULTS {
                    for &size in if fault.sized { &SIZES[..] } else { &[0.0] } {
                        let broken = fault.put_into(state, size, load(&scene), scene.beam().length());
                        if let Some(broken) = broken {
                            let what = format!("{name}, {method}, {solver}: {}, {size:e}", fault.name);
                            passes_only_near(&what, &truth, &sound, &broken);
                        }
                    }
                }
            }
        }
    }
}

/// A middle and the largest size of each fault; the evidence of the report has all of them.
#[test]
fn faults_are_bounded_truthfully() {
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        let mut bounded = 0;
        for method in Method::ALL {
            let state = run(&scene, method, Solver::ActiveSet, INTERVALS).state;
            for fault in FAULTS {
                for &size in if fault.sized { &[1e-6, 1e-1][..] } else { &[0.0] } {
                    let broken = fault.put_into(&state, size, load(&scene), scene.beam().length());
                    if let Some(broken) = broken {
                        let what = format!("{name}, {method}: {}, {size:e}", fault.name);
                        bounded += usize::from(bounded_truthfully(&what, &truth, &broken));
                    }
                }
            }
        }
        assert!(0 < bounded, "{name}: something can be said of some wrong answers");
    }
}

/// Faults of this size and above are refused wherever there is contact; where there is none, forces are rounding, and a share
/// of rounding is harmless.
const REFUSED: f64 = 1e-6;

/// A mirror image may be the answer itself.
#[test]
fn faults_of_a_millionth_and_those_without_a_size_are_refused() {
    for (name, scene) in report() {
        for method in Method::ALL {
            let sound = run(&scene, method, Solver::ActiveSet, INTERVALS).state;
            assert!(passes(&scene, &sound), "{name}, {method}: without a fault it passes");
            if sound.contacts.is_empty() {
                continue;
            }
            for fault in FAULTS.iter().filter(|fault| !fault.name.ends_with("round")) {
                for &size in if fault.sized { SIZES.as_slice() } else { &[1.0] }.iter().filter(|size| REFUSED <= **size)
                {
                    let broken = fault.put_into(&sound, size, load(&scene), scene.beam().length());
                    let seen = broken.is_none_or(|broken| !passes(&scene, &broken));
                    assert!(seen, "{name}, {method}: {}, {size:e}, goes unnoticed", fault.name);
                }
            }
        }
    }
}

/// Every fault does something: those of couples to a beam that is built in, all others to the example.
#[test]
fn every_fault_changes_the_example() {
    let cantilever = closed::built_in().expect("well-posed scenes").swap_remove(0).scene;
    for fault in FAULTS {
        let scene = if fault.name.contains("couple") { &cantilever } else { &example() };
        let sound = run(scene, Method::Complementarity, Solver::Clarabel, INTERVALS).state;
        let broken = fault.put_into(&sound, SIZES[0], load(scene), scene.beam().length());
        assert!(broken.is_some(), "{} changes nothing", fault.name);
    }
}

/// Faults without a size on the example: all of them refused, but for the mirror image, which is the answer itself.
#[test]
fn faults_without_a_size_are_refused_on_the_example() {
    let scene = example();
    for method in Method::ALL {
        let sound = run(&scene, method, Solver::ActiveSet, INTERVALS).state;
        for fault in FAULTS.iter().filter(|fault| !fault.sized) {
            if let Some(broken) = fault.put_into(&sound, 0.0, load(&scene), scene.beam().length()) {
                let image = distance(&scene, &sound, &broken).shape() <= super::NEAR && fault.name.ends_with("round");
                assert_eq!(passes(&scene, &broken), image, "{method}: {}", fault.name);
            } else {
                // The example is its own mirror image, to the bit, and is built in nowhere.
                let none = fault.name.ends_with("round") || fault.name.contains("couple");
                assert!(none, "{method}: {} changes nothing", fault.name);
            }
        }
    }
}
