//! Beams on any supports, with own shapes and free ends, and beams that merely lie on the ground: closed forms, invariances, and what
//! is refused.

mod reference;

use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, LinearLoad, Load, Scene, SceneError, Support};
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
    assert!(found.solved, "{method}, {intervals}: {}", found.solver_status);
    found.state
}

/// Values of grids of 100, 1000 and 10 000 intervals come to an exact value with the square of the spacing: a hundred times nearer
/// each time, or half of that where lift-off is between nodes.
#[track_caller]
fn converges(scene: &Scene, exact: f64, value: impl Fn(&ContactState) -> f64) {
    for method in Method::ALL {
        let errors = [100, 1000, 10_000].map(|n| (value(&state(scene, method, n)) - exact).abs() / exact.abs());
        assert!(errors[0] <= 0.01, "{method}: {errors:?}");
        assert!(errors.windows(2).all(|pair| 50.0 * pair[1] <= pair[0] + 1e-10), "{method}: {errors:?}");
    }
}

/// Lift-off after `a`, where `EI v'''' = q` with `v = v' = 0` at the support and `v = u`, `v' = v'' = 0` at lift-off:
/// `v = q a⁴/EI (ξ⁴/24 − ξ³/9 + ξ²/12)`, so `a⁴ = 72 EI u/q`, the reaction is `2qa/3`, the couple `qa²/6`, and the contact force at
/// lift-off `qa/3`. The energy of the lifted part and of the rest:
fn from_a_built_in_end(u: f64) -> (f64, f64) {
    let a = libm::sqrt(libm::sqrt(72.0 * STIFFNESS * u));
    let energy_without_rest = -0.5 * libm::pow(a, 5.0) / (120.0 * STIFFNESS) - 0.5 * u * a / 3.0;
    (a, energy_without_rest)
}

#[test]
fn a_cantilever_above_flat_ground_has_a_closed_form() {
    let u = 1.0;
    let cantilever = scene(vec![Support::built_in(0.0)], UNIFORM, flat(u), None);
    let (a, energy) = from_a_built_in_end(u);
    converges(&cantilever, energy - u * (LENGTH - a), |state| state.energy);
    let state = state(&cantilever, Method::Force, 10_000);
    let support = state.supports[0];
    let moment = support.moment.expect("built in");
    assert!((support.force - 2.0 * a / 3.0).abs() < 1e-3, "{support:?}");
    assert!((moment + a * a / 6.0).abs() < 1e-3, "{support:?}");
    assert!((state.contacts[0].from - a).abs() < 2e-3 && state.contacts.iter().any(|c| c.to >= LENGTH), "the tip lies");
    assert_eq!((state.reactions.left.to_bits(), state.reactions.right.to_bits()), (support.force.to_bits(), 0));
    assert!(state.standing.is_none(), "its support holds it");
}

#[test]
fn a_beam_built_in_at_both_ends_has_a_closed_form() {
    let u = 0.5;
    let both = scene(vec![Support::built_in(0.0), Support::built_in(LENGTH)], UNIFORM, flat(u), None);
    let (a, energy) = from_a_built_in_end(u);
    converges(&both, 2.0 * energy - u * (LENGTH - 2.0 * a), |state| state.energy);
    // Without ground q l²/12 at its ends; finite differences make it 1 + 2/N² times as large.
    let free = scene(vec![Support::built_in(0.0), Support::built_in(LENGTH)], UNIFORM, None, None);
    let moments = state(&free, Method::Displacement, 40).supports;
    let exact = -LENGTH * LENGTH / 12.0 * (1.0 - 1.0 / 1600.0);
    assert!(moments.iter().all(|s| (s.moment.expect("built in") - exact).abs() < 1e-12 * LENGTH), "{moments:?}");
}

/// Ground of constant curvature κ that falls off to both sides: the beam lies on it but for ends of length `b`, whose weight keeps
/// the moment `q b²/2 = EI κ`, and presses there with `q b`. With `c = l/2 − b` and depths counted from the top, half of its energy is
/// `EI κ² c/2 − q κ c³/6` of the part that lies and `q² b⁵/40EI − q (κ c² b/2 + κ c b²/2 + q b⁵/20EI)` of the end.
#[test]
fn a_free_beam_over_a_hump_has_a_closed_form() {
    let curvature = 0.2;
    let hump = scene(Vec::new(), UNIFORM, polynomial(&[2.5, -1.0, 0.5 * curvature]), None);
    let b = libm::sqrt(2.0 * STIFFNESS * curvature);
    let (c, b5) = (0.5 * LENGTH - b, b * b * b * b * b);
    let lies = 0.5 * STIFFNESS * curvature * curvature * c - curvature * c * c * c / 6.0;
    let end = b5 / (40.0 * STIFFNESS) - 0.5 * curvature * c * b * (c + b) - b5 / (20.0 * STIFFNESS);
    converges(&hump, 2.0 * (lies + end), |state| state.energy);
    for method in Method::ALL {
        let state = state(&hump, method, 10_000);
        assert!((state.contacts[0].from - b).abs() < 3e-3, "{method}: {:?}", state.contacts[0]);
        let standing = state.standing.expect("nothing holds it");
        assert!((standing.resultant.force - LENGTH).abs() < 1e-12 && (standing.margin - 0.5).abs() < 1e-12);
        assert_eq!(standing.motion, None);
        assert!((state.contact_force() - LENGTH).abs() < 1e-9, "in balance");
    }
    // The same beam curled over flat ground.
    let curled = scene(Vec::new(), UNIFORM, flat(0.0), polynomial(&[-2.5, 1.0, -0.5 * curvature]));
    for method in Method::ALL {
        let [a, b] = [&hump, &curled].map(|scene| state(scene, method, 200));
        assert!(apart(&forces(&a), &forces(&b)) < 1e-9, "{method}");
    }
}

/// Two spans `l/2` under `q`: 3/8, 5/4 and 3/8 of `q l/2`; and a middle support that settles by `d` takes `48 EI d/l³` off.
#[test]
fn a_settlement_takes_off_what_the_beam_resists() {
    for d in [0.0, 0.3, -0.2] {
        let supports = vec![Support::simple(0.0), Support::simple(5.0).at_level(d), Support::simple(LENGTH)];
        let spans = scene(supports, UNIFORM, None, None);
        let middle = 0.625 * LENGTH - 48.0 * STIFFNESS * d / (LENGTH * LENGTH * LENGTH);
        converges(&spans, middle, |state| state.supports[1].force);
        let all: f64 = state(&spans, Method::Force, 30).supports.iter().map(|s| s.force).sum();
        assert!((all - LENGTH).abs() < 1e-12 * LENGTH, "in balance");
    }
}

/// Overhangs of `c` on both sides of two supports, no ground: `q c²/2` at the supports, `q (l − 2c)²/8` less than that between.
#[test]
fn overhangs_bend_by_statics() {
    let c = 2.0;
    let overhung = scene(vec![Support::simple(c), Support::simple(LENGTH - c)], UNIFORM, None, None);
    for method in Method::ALL {
        let state = state(&overhung, method, 20);
        assert!((state.moment.min + 0.5 * c * c).abs() < 1e-12, "{method}: {:?}", state.moment);
        let middle = (LENGTH - 2.0 * c) * (LENGTH - 2.0 * c) / 8.0 - 0.5 * c * c;
        assert!((state.moment.max - middle).abs() < 1e-12, "{method}: {:?}", state.moment);
        assert!(state.supports.iter().all(|s| (s.force - 0.5 * LENGTH).abs() < 1e-12), "{method}");
        assert_eq!(nodes_of(&state).x.len(), 21, "tips are nodes");
    }
}

fn nodes_of(state: &ContactState) -> &palkki::state::Nodes {
    state.nodes.as_ref().expect("a grid")
}

fn forces(state: &ContactState) -> Vec<f64> {
    nodes_of(state).contact_force.clone()
}

/// Some scenes of every kind, each with its mirror image.
fn pairs() -> Vec<[Scene; 2]> {
    let beams: [(&[Support], Option<&[f64]>); 6] = [
        (&[Support { at: 0.0, level: 0.1, slope: Some(0.05) }], None),
        (&[Support { at: 2.0, level: 0.0, slope: None }, Support { at: 6.0, level: -0.1, slope: None }], None),
        (&[Support { at: 3.0, level: 0.0, slope: None }], None),
        (&[Support { at: 4.0, level: 0.1, slope: Some(-0.02) }, Support { at: 0.0, level: 0.0, slope: None }], None),
        (&[], None),
        (&[], Some(&[0.0, 0.2, -0.02])),
    ];
    let one = |(supports, shape): (&[Support], Option<&[f64]>), mirrored: bool| {
        let place = |x: f64| if mirrored { LENGTH - x } else { x };
        let support =
            |s: &Support| Support { at: place(s.at), slope: s.slope.map(|s| if mirrored { -s } else { s }), ..*s };
        let depth = |x: f64| 0.6 + 0.05 * (x - 4.0) * (x - 4.0) * 0.3;
        let mut points: Vec<[f64; 2]> = (0..=10).map(|k| [place(f64::from(k)), depth(f64::from(k))]).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        // c₀ + c₁ (l − x) + c₂ (l − x)².
        let shape = shape.map(|c| match mirrored {
            true => vec![c[0] + c[1] * LENGTH + c[2] * LENGTH * LENGTH, -c[1] - 2.0 * c[2] * LENGTH, c[2]],
            false => c.to_vec(),
        });
        let supports = supports.iter().map(support).collect();
        let shape = shape.map(|coefficients| Foundation::Polynomial { coefficients });
        scene(supports, (1.0, &[(place(6.3), 2.0)]), Some(Foundation::Polyline { points }), shape)
    };
    beams.into_iter().map(|beam| [one(beam, false), one(beam, true)]).collect()
}

#[test]
fn mirror_images_have_mirrored_answers() {
    for (k, [scene, mirrored]) in pairs().iter().enumerate() {
        for method in Method::ALL {
            let [a, b] = [scene, mirrored].map(|scene| state(scene, method, 200));
            let mut turned = forces(&b);
            turned.reverse();
            assert!(apart(&forces(&a), &turned) < 1e-8, "{method}, {k}");
            assert!((a.energy - b.energy).abs() < 1e-9 * a.energy.abs(), "{method}, {k}");
            let supports = a.supports.iter().zip(b.supports.iter().rev());
            for (a, b) in supports {
                assert!((a.force - b.force).abs() < 1e-8, "{method}, {k}: {a:?}, {b:?}");
                assert!(
                    (a.moment.unwrap_or(0.0) - b.moment.unwrap_or(0.0)).abs() < 1e-8,
                    "{method}, {k}: {a:?}, {b:?}"
                );
            }
        }
    }
}

#[test]
fn energy_methods_agree_by_every_solver() {
    for (k, [scene, _]) in pairs().iter().enumerate() {
        let held = scene.scaled().expect("balanced").balance.resultant().is_none();
        let reference = state(scene, Method::Force, 40);
        let mut solved = 0;
        for method in [Method::Displacement, Method::Force] {
            for solver in Solver::OPTIMAL {
                let found = run(scene, method, solver, 40);
                if found.solved {
                    solved += 1;
                    assert!(apart(&forces(&found.state), &forces(&reference)) < 1e-5, "{method}, {solver}, {k}");
                } else {
                    assert!(solver == Solver::Nsor && method == Method::Force, "{method}, {solver}, {k}");
                    assert_eq!(!held, found.iterations == 0, "{k}: {}", found.solver_status);
                }
            }
        }
        assert!(2 * Solver::OPTIMAL.len() - 1 <= solved);
    }
}

/// A free beam feels nothing of ground that is raised and tilted as a whole.
#[test]
fn tilted_ground_leaves_the_forces_of_a_free_beam() {
    let ground = [0.3, 0.4, -0.3, 0.05, -0.002];
    let tilted = [2.3, 0.15, -0.3, 0.05, -0.002];
    for method in Method::ALL {
        let [a, b] = [&ground, &tilted]
            .map(|c| state(&scene(Vec::new(), (1.0, &[(2.0, 1.0)]), polynomial(c), None), method, 300));
        assert!(apart(&forces(&a), &forces(&b)) < 1e-9, "{method}");
        let [a, b] = [a, b].map(|state| nodes_of(&state).clearance.clone());
        assert!(apart(&a, &b) < 1e-9, "{method}");
    }
}

/// A support that presses does what a spike of the ground would do.
#[test]
fn a_pressing_support_is_a_spike_of_the_ground() {
    let ends = [Support::simple(0.0), Support::simple(LENGTH)];
    let narrow = vec![[0.0, 1.0], [3.999_999, 1.0], [4.0, 0.3], [4.000_001, 1.0], [LENGTH, 1.0]];
    let spiked = scene(ends.to_vec(), UNIFORM, Some(Foundation::Polyline { points: narrow }), None);
    let held = [ends[0], Support::simple(4.0).at_level(0.3), ends[1]];
    let supported = scene(held.to_vec(), UNIFORM, flat(1.0), None);
    for method in Method::ALL {
        let [a, b] = [&spiked, &supported].map(|scene| state(scene, method, 100));
        let (i, mut without) = (39, forces(&a));
        assert!((without[i] - b.supports[1].force).abs() < 1e-9, "{method}: {} {:?}", without[i], b.supports[1]);
        without[i] = 0.0;
        assert!(apart(&without, &forces(&b)) < 1e-9, "{method}");
        assert!((a.energy - b.energy).abs() < 1e-10 * a.energy.abs(), "{method}");
    }
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
                assert_eq!((a.unknowns, a.iterations), (b.unknowns, b.iterations), "{method}, {intervals}");
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

/// A rigid body, nearly, on the top of a hump: the slope of the ground there. On a ridge it may have any between those of its sides.
#[test]
fn one_contact_gives_the_slope_where_the_ground_is_smooth() {
    let smooth = scene(Vec::new(), (0.0, &[(3.0, 1.0)]), polynomial(&[2.5, -1.0, 0.1]), None);
    let ridge = Foundation::Polyline { points: vec![[0.0, 1.0], [3.0, 0.4], [LENGTH, 3.0]] };
    let ridge = scene(Vec::new(), (0.0, &[(3.0, 1.0)]), Some(ridge), None);
    for method in Method::ALL {
        let found = state(&smooth, method, 40);
        assert_eq!(found.standing.expect("free").motion, None);
        let x = nodes_of(&found);
        let slope = (x.deflection[40] - x.deflection[0]) / LENGTH;
        assert!((slope - (-1.0 + 0.2 * 3.0)).abs() < 1e-12, "{slope}");
        let found = state(&ridge, method, 40);
        let motion = found.standing.expect("free").motion.expect("it may turn");
        let [Some(least), Some(most)] = motion.slope else { panic!("{motion:?}") };
        assert!((least + 0.2).abs() < 1e-12 && (most - 2.6 / 7.0).abs() < 1e-12, "{motion:?}");
        assert!(found.deflection.max - found.deflection.min < 1e-12, "slope zero is the nearest");
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
    assert_eq!(error, SceneError::SupportBetweenNodes { at: 2.5, intervals: 30, fits: Some(20) });
    assert_eq!(
        error.to_string(),
        "no node of 30 equal intervals lies on the support at x = 2.5; the least number of intervals with a node at every \
         support is 20 (--intervals 20)"
    );
    assert!(run(&spans, Method::Force, Solver::ActiveSet, 40).solved);
    let irrational = at(&[0.0, std::f64::consts::PI, LENGTH]);
    let error = refused(&irrational, 100);
    assert_eq!(error, SceneError::SupportBetweenNodes { at: std::f64::consts::PI, intervals: 100, fits: None });
    assert!(error.to_string().ends_with("no number of intervals up to 10000 has a node at every support"), "{error}");
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
