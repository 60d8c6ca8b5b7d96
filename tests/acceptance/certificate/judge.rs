//! The judge: what it must not let pass, beside the faults of `faults`.

mod measures;

use palkki::certificate::Kkt;
use palkki::route::{Method, Solver};
use palkki::scene::{Foundation, Scene};
use palkki::state::{ContactState, Nodes};

use super::passes;
use crate::scenes::{example, run, uniform};

/// The state that the active set finds.
#[track_caller]
fn correct_on(scene: &Scene, intervals: usize) -> ContactState {
    let raw = run(scene, Method::Force, Solver::ActiveSet, intervals);
    assert!(raw.solved);
    raw.state
}

/// As [`correct_on`], on 30 intervals by any method.
#[track_caller]
fn correct(scene: &Scene, method: Method) -> ContactState {
    let raw = run(scene, method, Solver::ActiveSet, 30);
    assert!(raw.solved, "{method}");
    raw.state
}

#[test]
fn lists_that_lack_values_do_not_pass() {
    for method in Method::ALL {
        let state = correct(&example(), method);
        assert!(passes(&example(), &state), "{method}");
        let lacks: [fn(&mut Nodes); 2] = [|nodes| nodes.deflection.truncate(1), |nodes| nodes.contact_force.clear()];
        for lack in lacks {
            let mut broken = state.clone();
            lack(broken.nodes.as_mut().expect("nodes"));
            assert!(!passes(&example(), &broken), "{method}");
        }
    }
}

#[test]
fn a_beam_that_ignores_the_ground_penetrates() {
    let out_of_reach = uniform(10.0, 500.0 / 384.0, 1.0, Foundation::Flat { depth: 1e3 });
    let free = correct(&out_of_reach, Method::Force);
    assert!(passes(&out_of_reach, &free));
    let kkt = Kkt::of(&example(), &free).expect("as many nodes");
    assert!(0.5 < kkt.penetration, "{kkt:?}");
}

/// The nodal values of one method are none of the other: the two discretise differently.
#[test]
fn a_state_of_another_method_does_not_pass() {
    let mut mixed = correct(&example(), Method::Force);
    mixed.nodes.as_mut().expect("nodes").discretisation = palkki::state::Discretisation::FiniteDifferences;
    assert!(!passes(&example(), &mixed), "beam elements taken for finite differences");
}

/// Once, a stray force of rounding size above a deep pit made the pit the measure of all lengths, and penetrations of any
/// size passed beside it.
#[test]
fn a_deep_pit_does_not_loosen_the_measure() {
    let points = [[0.0, 1.0], [5.0, 1.0], [5.2, 1e9], [5.4, 1.0], [10.0, 1.0]].to_vec();
    let pit = uniform(10.0, 500.0 / 384.0, 1.0, Foundation::Polyline { points });
    let free = uniform(10.0, 500.0 / 384.0, 1.0, Foundation::Flat { depth: 1e3 });
    let mut state = run(&free, Method::Force, Solver::ActiveSet, 50).state;
    let nodes = state.nodes.as_mut().expect("nodes");
    // Node 26 of 50 lies at x = 5.2.
    nodes.contact_force[25] = 1e-20;
    let kkt = Kkt::of(&pit, &state).expect("nodes");
    assert!(!kkt.holds(), "a free beam passes through ground at depth 1: {kkt:?}");
}

/// Without loads nothing moves. A pull must not hide behind a pit that is deep enough to make any force look small.
#[test]
fn a_deep_pit_does_not_loosen_the_measure_of_an_idle_beam() {
    let points = [[0.0, 1.0], [5.0, 1.0], [5.2, 1e9], [5.4, 1.0], [10.0, 1.0]].to_vec();
    let pit = uniform(10.0, 500.0 / 384.0, 0.0, Foundation::Polyline { points });
    let idle = correct_on(&pit, 50);
    assert!(passes(&pit, &idle), "a beam without load does not move");
    let mut broken = idle;
    let nodes = broken.nodes.as_mut().expect("nodes");
    nodes.contact_force[24] = -1.0;
    assert!(!passes(&pit, &broken), "a pull of 1 on a beam without load");
}
