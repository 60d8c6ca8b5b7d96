//! Each row of a sweep is the answer that its scene has by itself.

use palkki::route::Status;
use palkki::scene::Support;
use palkki::sweep::{Sweep, SweepError};
use palkki::theory;

use super::{loaded, regimes, varied};

/// Compares forces and energies of all rows with answers from nothing, relative to the largest force and to the energy.
fn compare(i: u64) {
    let (scene, paths) = varied(i);
    for (path, from, to) in paths {
        let sweep = Sweep::new(&scene, &path, [from, to], 9).expect("a sweep");
        let mut walk = sweep.walk();
        for value in sweep.values() {
            // A range may leave what has an answer: a beam may turn over.
            let Ok(step) = walk.solve(value) else { break };
            let state = walk.row(step).solution.state;
            let alone = theory::solve(&sweep.scene(value).expect("a scene")).expect("an answer");
            if !alone.solved {
                continue;
            }
            let forces = |state: &palkki::state::ContactState| -> Vec<f64> {
                state.supports.iter().map(|s| s.force).chain([state.contact_force()]).collect()
            };
            let (a, b) = (forces(&state), forces(&alone.state));
            let size = b.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
            let pairs = a.iter().zip(&b).map(|(a, b)| (a - b).abs() / size);
            let energy = (state.energy - alone.state.energy).abs() / alone.state.energy.abs();
            let difference = pairs.fold(energy, f64::max);
            assert!(difference <= 1e-12, "{i}, {path} = {value}: {difference:e}");
        }
    }
}

/// Rows that start from their neighbour are those that start from nothing.
#[test]
fn every_row_is_an_answer_from_nothing() {
    std::thread::scope(|scope| {
        let threads = [0, 1].map(|first| scope.spawn(move || (first..40).step_by(2).for_each(compare)));
        threads.into_iter().for_each(|thread| thread.join().expect("no panic"));
    });
}

#[test]
fn a_thousand_answers_of_a_moving_load_are_certified() {
    let supports = vec![Support::simple(0.0), Support::simple(10.0)];
    let scene = loaded(supports, 1.0);
    let rows = Sweep::new(&scene, "load.point[0].at", [0.0, 10.0], 1001).expect("a sweep").rows().expect("answers");
    assert_eq!(rows.len(), 1001);
    assert!(rows.iter().all(|row| row.solution.verdict.status == Status::Certified));
    // Most lists are right at once.
    let steps: usize = rows.iter().map(|row| row.solution.run.iterations).sum();
    assert!(steps < 10 * rows.len(), "{steps} Newton steps");
    let (first, last) = (&rows[0].solution.state.reactions, &rows[1000].solution.state.reactions);
    assert!((first.left - last.right).abs() < 1e-12 * first.left, "the mirror image");
}

#[test]
fn ranges_that_leave_what_is_valid_say_where() {
    let supports = vec![Support::simple(0.0), Support::simple(4.0), Support::simple(10.0)];
    let scene = loaded(supports, 1.0);
    let invalid = |path: &str, from: f64, to: f64| match Sweep::new(&scene, path, [from, to], 8).and_then(|s| s.rows())
    {
        Err(SweepError::Invalid { border, error, .. }) => (border, error.to_string()),
        other => panic!("{path}: {other:?}"),
    };
    let (border, message) = invalid("beam.supports[2].at", 8.0, 12.0);
    assert!((border - 10.0).abs() < 1e-14 && message.contains("must lie on the beam"), "{border} {message}");
    let (border, message) = invalid("foundation.depth", 1.0, -1.0);
    assert!(border.abs() < 1e-14 && message.contains("above a support"), "{border} {message}");
    let (border, message) = invalid("beam.bending_stiffness", 1.0, -1.0);
    assert!(border < 1e-300 && message.contains("`beam.bending_stiffness`"), "{border} {message}");
    for steps in [0, 1, 1_000_002] {
        assert_eq!(Sweep::new(&scene, "load.uniform", [0.0, 1.0], steps).err(), Some(SweepError::Steps(steps)));
    }
    for range in [[1.0, 1.0], [0.0, f64::NAN], [f64::NEG_INFINITY, 1.0], [-f64::MAX, f64::MAX]] {
        assert!(matches!(Sweep::new(&scene, "load.uniform", range, 5), Err(SweepError::Range { .. })), "{range:?}");
    }
    assert!(matches!(Sweep::new(&regimes(1.0), "load.point[0].at", [0.0, 1.0], 5), Err(SweepError::Path(_))));
}
