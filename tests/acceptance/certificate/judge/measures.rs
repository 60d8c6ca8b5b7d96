//! What the judge measures: every violation has the size that is documented, in a scene in which no unit is one.
//!
//! Mutation testing asked for these: all scenes of the report are of order one, and there a measure by the wrong unit looks
//! like one by the right unit.

use palkki::certificate::{CERTIFIED_RESIDUAL, Kkt};
use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::state::ContactState;

use crate::scenes::{largest, run, uniform};

/// Length, stiffness, load and depth, all different, and so are the sizes of forces, moments and deflections.
const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
const DEPTH: f64 = 0.4;
/// `P`: all loads.
const ALL: f64 = LOAD * LENGTH;
/// The judge's own rounding, a few units in the last place of what it measures, against violations of a thousandth and more.
const ROUNDING: f64 = 1e-11;
/// What is put into a state.
const FAULT: f64 = 1e-3;

fn on(depth: f64, load: f64) -> Scene {
    uniform(LENGTH, STIFFNESS, load, Foundation::Flat { depth })
}

/// The answer on 20 intervals: the beam touches from about node 4 to about node 16.
fn answer(scene: &Scene) -> ContactState {
    run(scene, Method::Force, Solver::ActiveSet, 20).state
}

#[track_caller]
fn judged(scene: &Scene, state: &ContactState) -> Kkt {
    Kkt::of(scene, state).expect("as many nodes as places")
}

#[track_caller]
fn is(what: &str, measured: f64, expected: f64) {
    assert!((measured - expected).abs() <= ROUNDING * expected.max(1.0), "{what}: {measured}, not {expected}");
}

/// The fields of [`Kkt`] in their order.
#[track_caller]
fn check(what: &str, scene: &Scene, fault: impl FnOnce(&mut ContactState), expected: [f64; 5]) {
    let mut state = answer(scene);
    fault(&mut state);
    let Kkt { penetration, tension, complementarity, equilibrium, record } = judged(scene, &state);
    for (measured, expected) in [penetration, tension, complementarity, equilibrium, record].iter().zip(expected) {
        is(what, *measured, expected);
    }
}

#[test]
fn what_is_said_beside_is_measured_by_length_depth_and_moment() {
    let scene = on(DEPTH, LOAD);
    let share = |unit: f64| [0.0, 0.0, 0.0, 0.0, FAULT / unit];
    let nodes = |change: fn(&mut palkki::state::Nodes)| {
        move |state: &mut ContactState| change(state.nodes.as_mut().expect("nodes"))
    };
    check("a place", &scene, nodes(|n| n.x[2] += FAULT), share(LENGTH));
    check("a clearance", &scene, nodes(|n| n.clearance[2] -= FAULT), share(DEPTH));
    check("a moment", &scene, nodes(|n| n.moment[2] += FAULT), share(ALL * LENGTH));
}

#[test]
fn reactions_are_measured_by_the_loads() {
    let scene = on(DEPTH, LOAD);
    let share = [0.0, 0.0, 0.0, FAULT / ALL, 0.0];
    check("left", &scene, |state| state.reactions.left += FAULT, share);
    check("right", &scene, |state| state.reactions.right -= FAULT, share);
}

#[test]
fn deflections_are_measured_by_the_largest_one() {
    let scene = on(DEPTH, LOAD);
    let share = FAULT / DEPTH;
    let up = |state: &mut ContactState| state.nodes.as_mut().expect("nodes").deflection[1] -= FAULT;
    check("beside the contact", &scene, up, [0.0, 0.0, 0.0, share, share]);
    // Into the ground: the deflection itself is now the largest one.
    let share = FAULT / (DEPTH + FAULT);
    let down = |state: &mut ContactState| state.nodes.as_mut().expect("nodes").deflection[9] += FAULT;
    check("in contact", &scene, down, [share, 0.0, 0.0, share, share]);
}

#[test]
fn forces_are_measured_by_the_loads_or_by_all_forces() {
    let scene = on(DEPTH, LOAD);
    let sound = answer(&scene);
    let with = |changes: &[(usize, f64)]| {
        let mut state = sound.clone();
        let nodes = state.nodes.as_mut().expect("nodes");
        changes.iter().for_each(|&(node, force)| nodes.contact_force[node] = force);
        let sum: f64 = nodes.contact_force.iter().map(|p| p.abs()).sum();
        (judged(&scene, &state), sum)
    };
    let (kkt, sum) = with(&[(9, -FAULT)]);
    assert!(sum < ALL, "loads are the larger sum: {sum}");
    is("a pull", kkt.tension, FAULT / ALL);
    let (kkt, sum) = with(&[(8, 1000.0), (9, -500.0)]);
    assert!(ALL < sum, "contact forces are the larger sum: {sum}");
    is("a strong pull", kkt.tension, 500.0 / sum);
    let (kkt, _) = with(&[(0, 1.0)]);
    is("a force across a clearance", kkt.complementarity, 1.0 / ALL);
    let clearance = DEPTH - sound.nodes.as_ref().expect("nodes").deflection[0];
    let (kkt, sum) = with(&[(0, 1000.0)]);
    assert!(clearance / DEPTH < 1000.0 / sum, "the clearance is the smaller one");
    is("a strong force across a clearance", kkt.complementarity, clearance / DEPTH);
}

/// Without loads there is the way to the ground, and the force that bends the beam to it, `48 EI u / l³`.
#[test]
fn an_idle_beam_is_measured_by_the_way_to_the_ground() {
    let force = 48.0 * STIFFNESS * DEPTH / (LENGTH * LENGTH * LENGTH);
    let scene = on(DEPTH, 0.0);
    let mut state = answer(&scene);
    state.nodes.as_mut().expect("nodes").contact_force[9] = -FAULT;
    is("a pull", judged(&scene, &state).tension, FAULT / force);

    let mut state = answer(&scene);
    state.nodes.as_mut().expect("nodes").deflection[1] = FAULT;
    is("a deflection", judged(&scene, &state).equilibrium, FAULT / DEPTH);

    let points = [[0.0, DEPTH], [10.0, -0.5 * DEPTH], [LENGTH, DEPTH]].to_vec();
    let raised = uniform(LENGTH, STIFFNESS, 0.0, Foundation::Polyline { points });
    let straight = answer(&scene);
    is("a beam through a rise", judged(&raised, &straight).penetration, 1.0);
}

/// With loads the way to the ground measures nothing, however far it is.
#[test]
fn a_loaded_beam_is_not_measured_by_the_way_to_the_ground() {
    let scene = on(1e6, LOAD);
    let mut state = answer(&scene);
    let nodes = state.nodes.as_mut().expect("nodes");
    let most = largest(&nodes.deflection);
    nodes.deflection[1] -= FAULT;
    is("a deflection", judged(&scene, &state).equilibrium, FAULT / most);
}

/// Where the beam hardly moves, deflections are measured by sixteen units in the last place of `P l³ / 48 EI`, over
/// [`CERTIFIED_RESIDUAL`]: by what rounded forces do.
#[test]
fn no_deflection_is_measured_by_less_than_rounding() {
    let scene = on(1e-9, LOAD);
    let least = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL * ALL * (LENGTH * LENGTH * LENGTH) / (48.0 * STIFFNESS);
    let mut state = answer(&scene);
    let fault = 0.1 * least;
    state.nodes.as_mut().expect("nodes").deflection[1] -= fault;
    is("a deflection", judged(&scene, &state).equilibrium, fault / least);
}

/// A clearance above ground at depth `u` is known to a few units in the last place of `u`, and no better.
#[test]
fn a_clearance_is_as_good_as_the_depth_that_it_is_taken_from() {
    let (deep, unit) = (1e10, f64::EPSILON * 1e10);
    let scene = on(deep, LOAD);
    for (units, passes) in [(3.0, true), (100.0, false)] {
        let mut state = answer(&scene);
        state.nodes.as_mut().expect("nodes").clearance[2] += units * unit;
        assert_eq!(judged(&scene, &state).holds(), passes, "off by {units} units in the last place of the depth");
    }
}

#[test]
fn where_there_is_no_ground_clearances_are_infinite() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    for load in [0.0, LOAD] {
        let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, load).expect("finite"), None).expect("well posed");
        let mut state = answer(&scene);
        is("a beam without a foundation", judged(&scene, &state).residual(), 0.0);
        state.nodes.as_mut().expect("nodes").clearance[2] = 1.0;
        assert!(!judged(&scene, &state).holds(), "a clearance over no ground, load {load}");
    }
    // And where there is ground they are not.
    let mut state = answer(&on(DEPTH, LOAD));
    state.nodes.as_mut().expect("nodes").clearance[2] = f64::INFINITY;
    assert!(!judged(&on(DEPTH, LOAD), &state).holds(), "an infinite clearance over ground");
}

/// What rounding takes from the sums is kept: on many nodes the deflection that forces cause is still that of the state.
#[test]
fn many_nodes_cost_no_digits() {
    /// A few dozen roundings; sums that keep nothing lose thousands on as many nodes.
    const KEPT: f64 = 1e-13;
    let scene = on(DEPTH, LOAD);
    let state = run(&scene, Method::Force, Solver::ActiveSet, 100_000).state;
    let kkt = judged(&scene, &state);
    assert!(kkt.residual() <= KEPT, "{kkt:?}");
}
