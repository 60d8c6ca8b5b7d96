//! Answers of other problems: of other ground, other loads, other grids, other scenes.

use palkki::route::{Method, Solver};
use palkki_evidence::faults::{Truth, every_second, scaled_ground, scaled_load};

use super::{INTERVALS, bounded_truthfully, passes, passes_only_near};
use crate::scenes::{example, report, run};

#[test]
fn answers_of_other_scenes_are_refused_or_the_same_and_bounded_truthfully() {
    let scenes = report();
    for method in Method::ALL {
        let states: Vec<_> =
            scenes.iter().map(|(_, scene)| run(scene, method, Solver::ActiveSet, INTERVALS).state).collect();
        for ((name, scene), sound) in scenes.iter().zip(&states) {
            let truth = Truth::of(scene).expect("theory has an answer");
            for ((other, _), state) in scenes.iter().zip(&states) {
                let what = format!("{name}, {method}: the answer of {other}");
                assert!(passes_only_near(&what, &truth, sound, state) || other != name, "{what}: its own answer");
                bounded_truthfully(&what, &truth, state);
            }
        }
    }
}

#[test]
fn stale_answers_are_refused_by_every_route() {
    /// A change of ground or load by this share is seen on the example, whoever solved it.
    const SEEN: f64 = 1e-6;
    let scene = example();
    let truth = Truth::of(&scene).expect("theory has an answer");
    for share in [SEEN, 1e-3] {
        for other in [scaled_ground(&scene, share), scaled_load(&scene, share), scaled_ground(&scene, -share)] {
            let other = other.expect("the scene is well posed");
            for method in Method::ALL {
                for solver in Solver::ALL {
                    let stale = run(&other, method, solver, INTERVALS).state;
                    let what = format!("{method}, {solver}: stale by {share:e}");
                    assert!(!passes(&scene, &stale), "{what} goes unnoticed");
                    assert!(bounded_truthfully(&what, &truth, &stale), "{what}: there is a bound");
                }
            }
        }
    }
}

#[test]
fn answers_of_a_finer_grid_are_refused() {
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        for method in Method::ALL {
            let sound = run(&scene, method, Solver::ActiveSet, INTERVALS).state;
            let finer = every_second(&run(&scene, method, Solver::ActiveSet, 2 * INTERVALS).state);
            let what = format!("{name}, {method}: every second node of a finer grid");
            assert!(!passes_only_near(&what, &truth, &sound, &finer), "{what}");
            bounded_truthfully(&what, &truth, &finer);
        }
    }
}
