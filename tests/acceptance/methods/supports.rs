//! Beams on any supports, with own shapes and free ends, and beams that merely lie on the ground: what only they have, and what is
//! refused.

mod dense;
mod reference;

use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, LinearLoad, Load, Quantity, Scene, SceneError, Support};
use palkki::state::ContactState;
use palkki::{Settings, solve_raw};
use palkki_evidence::draft::Draft;

use crate::scenes::{apart, nodes, run};

const LENGTH: f64 = 10.0;
const STIFFNESS: f64 = 500.0 / 384.0;

/// Under a uniform load and point loads `(place, force)`.
#[track_caller]
fn scene(
    supports: Vec<Support>,
    (uniform, points): (f64, &[(f64, f64)]),
    ground: Option<Foundation>,
    shape: Option<Foundation>,
) -> Scene {
    let (length, stiffness, supports) = (LENGTH, STIFFNESS, Some(supports));
    let draft = Draft { length, stiffness, uniform, ground, supports, shape, ..Draft::default() };
    draft.with_points(points).scene().expect("well posed")
}

const UNIFORM: (f64, &[(f64, f64)]) = (1.0, &[]);

fn flat(depth: f64) -> Option<Foundation> {
    Some(Foundation::Flat { depth })
}

fn polynomial(coefficients: &[f64]) -> Option<Foundation> {
    Some(Foundation::Polynomial { coefficients: coefficients.to_vec() })
}

#[track_caller]
fn state(scene: &Scene, method: Method, intervals: usize) -> ContactState {
    let found = run(scene, method, Solver::ActiveSet, intervals);
    assert!(found.solved, "{method}, {intervals}: {}", found.run.message);
    found.state
}

fn nodes_of(state: &ContactState) -> &palkki::state::Nodes {
    state.nodes.as_ref().expect("a grid")
}

/// The paper's beam by the formulas for any supports, which a shape of zero makes necessary: the same problem to its last digits.
#[test]
fn the_papers_beam_is_one_of_all() {
    let ends = vec![Support::simple(0.0), Support::simple(LENGTH)];
    for ground in [flat(1.0), polynomial(&[1.5, -0.3, 0.02]), None] {
        let paper = scene(ends.clone(), (1.0, &[(3.3, 2.0)]), ground.clone(), None);
        let any = scene(ends.clone(), (1.0, &[(3.3, 2.0)]), ground, polynomial(&[0.0]));
        for method in Method::ALL {
            for intervals in [7, 100, 3000] {
                let [a, b] = [&paper, &any].map(|scene| run(scene, method, Solver::ActiveSet, intervals));
                assert_eq!((a.unknowns, a.run.iterations), (b.unknowns, b.run.iterations), "{method}, {intervals}");
                assert!(apart(&nodes(&a).deflection, &nodes(&b).deflection) < 1e-9, "{method}, {intervals}");
                assert!(apart(&nodes(&a).moment, &nodes(&b).moment) < 1e-9, "{method}, {intervals}");
                let (a, b) = (a.state, b.state);
                assert!((a.energy - b.energy).abs() < 1e-11 * a.energy.abs(), "{method}, {intervals}");
                assert!((a.reactions.left - b.reactions.left).abs() < 1e-9, "{method}, {intervals}");
                assert!((a.deflection.max - b.deflection.max).abs() < 1e-9, "{method}, {intervals}");
            }
        }
    }
}

/// In balance on one support, `l/2` on both sides: a beam that hangs by `q (l/2)⁴/8EI` at its tips, and may turn until one of these
/// touches.
#[test]
fn a_beam_in_balance_may_turn() {
    let hangs = libm::pow(0.5 * LENGTH, 4.0) / (8.0 * STIFFNESS);
    let depth = hangs + 10.0;
    for (ground, expected) in [(None, None), (flat(depth), Some(10.0 / (0.5 * LENGTH)))] {
        let scene = scene(vec![Support::simple(0.5 * LENGTH)], UNIFORM, ground, None);
        for method in Method::ALL {
            for solver in [Solver::ActiveSet, Solver::FourStep] {
                let state = run(&scene, method, solver, 400).state;
                let motion = state.standing.and_then(|standing| standing.motion).expect("it may turn");
                assert!((motion.about - 0.5 * LENGTH).abs() < 1e-12);
                match (motion.slope, expected) {
                    ([None, None], None) => {}
                    ([Some(least), Some(most)], Some(slope)) => {
                        assert!((most - slope).abs() < 1e-3 && (least + slope).abs() < 1e-3, "{motion:?}");
                    }
                    (slopes, _) => panic!("{slopes:?} instead of {expected:?}"),
                }
                let deflections = &nodes_of(&state).deflection;
                assert!((deflections[0] - deflections[400]).abs() < 1e-9 * hangs, "it is level");
                assert!((state.supports[0].force - LENGTH).abs() < 1e-12 * LENGTH);
            }
        }
    }
}

/// A rigid body, nearly, on the top of a hump: the slope of the ground there. On a ridge it may have any between those of its sides, and
/// on the edge of a step from that of the upper side until its end is on the lower one.
#[test]
fn one_contact_gives_the_slope_where_the_ground_is_smooth() {
    let smooth = scene(Vec::new(), (0.0, &[(3.0, 1.0)]), polynomial(&[2.5, -1.0, 0.1]), None);
    let ridge = Foundation::Polyline { points: vec![[0.0, 1.0], [3.0, 0.4], [LENGTH, 3.0]] };
    let ridge = scene(Vec::new(), (0.0, &[(3.0, 1.0)]), Some(ridge), None);
    let step = Foundation::Polyline { points: vec![[0.0, 1.0], [3.0, 1.0], [3.0, 3.0], [LENGTH, 3.0]] };
    let step = scene(Vec::new(), (0.0, &[(3.0, 1.0)]), Some(step), None);
    let lifted_ends = scene(Vec::new(), (0.0, &[(0.0, -1.0), (3.0, 5.0), (6.0, -1.0)]), flat(0.0), None);
    assert_eq!(state(&lifted_ends, Method::Force, 30).standing.expect("free").motion, None);
    for method in Method::ALL {
        let found = state(&smooth, method, 40);
        assert_eq!(found.standing.expect("free").motion, None);
        let x = nodes_of(&found);
        let slope = (x.deflection[40] - x.deflection[0]) / LENGTH;
        assert!((slope - (-1.0 + 0.2 * 3.0)).abs() < 1e-12, "{slope}");
        for (edge, expected) in [(&ridge, [-0.2, 2.6 / 7.0]), (&step, [0.0, 2.0 / 7.0])] {
            let found = state(edge, method, 40);
            let motion = found.standing.expect("free").motion.expect("it may turn");
            let [Some(least), Some(most)] = motion.slope else { panic!("{motion:?}") };
            assert!((least - expected[0]).abs() < 1e-12 && (most - expected[1]).abs() < 1e-12, "{motion:?}");
            assert!(found.deflection.max - found.deflection.min < 1e-12, "slope zero is the nearest");
        }
    }
}

#[test]
fn a_support_has_to_be_a_node() {
    let at = |places: &[f64]| scene(places.iter().map(|x| Support::simple(*x)).collect(), UNIFORM, flat(1.0), None);
    let refused = |scene: &Scene, intervals: usize| {
        solve_raw(scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals)).expect_err("no node")
    };
    let spans = at(&[0.0, 2.5, 6.0, LENGTH]);
    let error = refused(&spans, 30);
    assert_eq!(
        error,
        SceneError::BetweenNodes { quantity: Quantity::Supports, at: 2.5, intervals: 30, fits: Some(20) }
    );
    assert_eq!(
        error.to_string(),
        "no node of 30 equal intervals lies on the support at x = 2.5; the least number of intervals with a node at every \
         support, joint and change of the bending stiffness is 20 (--intervals 20)"
    );
    assert!(run(&spans, Method::Force, Solver::ActiveSet, 40).solved);
    let irrational = at(&[0.0, std::f64::consts::PI, LENGTH]);
    let error = refused(&irrational, 100);
    assert_eq!(
        error,
        SceneError::BetweenNodes { quantity: Quantity::Supports, at: std::f64::consts::PI, intervals: 100, fits: None }
    );
    assert!(error.to_string().contains("no number of intervals up to 10000 has a node at every support"), "{error}");
    // A third of the beam is no number of 64 bits.
    assert!(run(&at(&[0.0, LENGTH / 3.0, LENGTH]), Method::Force, Solver::ActiveSet, 30).solved);
}

/// A load that pulls on a part of a free beam, and one that lifts a tip.
#[test]
fn a_tip_touches_or_lifts() {
    let beam = Beam::new(LENGTH, STIFFNESS).and_then(|b| b.with_supports(Vec::new())).expect("a beam");
    let linear = vec![LinearLoad { from: 6.0, to: LENGTH, start: -1.5, end: -1.5 }];
    let load = Load::new(&beam, 1.0, linear, Vec::new()).expect("a load");
    let lifted = Scene::new(beam, load, flat(0.7)).expect("well posed");
    for method in Method::ALL {
        let state = state(&lifted, method, 200);
        let nodes = nodes_of(&state);
        assert!(0.0 < nodes.clearance[200] && nodes.clearance[0] == 0.0 && 0.0 < nodes.contact_force[0], "{method}");
        assert!((state.contact_force() - 4.0).abs() < 1e-9, "in balance");
        let turned: f64 = nodes.x.iter().zip(&nodes.contact_force).map(|(x, p)| x * p).sum();
        assert!((turned - (50.0 - 6.0 * 8.0)).abs() < 1e-8, "in balance about the left tip: {turned}");
    }
}

/// Loads that are in balance above one node: the beam stands on it alone, and a second contact is at zero. Where two contacts reach
/// zero together, one of them has to stay in the set.
#[test]
fn beams_in_balance_on_one_node_have_an_answer_on_every_grid() {
    for (place, reach, pull) in
        [(3.0, 3.0, -1.0), (2.0, 1.0, -1.0), (3.0, 2.0, -2.0), (5.0, 4.0, -1.0), (7.0, 3.0, -2.0)]
    {
        let loads = [(place - reach, pull), (place, 5.0), (place + reach, pull)];
        let scene = scene(Vec::new(), (0.0, &loads), flat(1.0), None);
        for method in Method::ALL {
            for intervals in [10, 20, 30, 40, 50, 60, 80, 100] {
                let state = state(&scene, method, intervals);
                let [contact] = state.contacts.as_slice() else {
                    panic!("{method}, {intervals}: {:?}", state.contacts)
                };
                let force = 5.0 + 2.0 * pull;
                assert!((contact.force - force).abs() <= 1e-12 * force, "{method}, {intervals}: {contact:?}");
                assert!((contact.from - place).abs() <= 1e-12, "{method}, {intervals}: {contact:?}");
            }
        }
    }
}
