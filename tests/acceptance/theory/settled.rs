//! Supports that share a place with the foundation: settled to the level of rigid ground, and into an elastic foundation.

use palkki::route::{Method, Solver, Status};
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, SceneError, Support};
use palkki::{Settings, Solution, solve, solve_exactly};
use palkki_evidence::definition::violated;
use palkki_evidence::draft::Draft;
use palkki_evidence::elements::{Found, Reference, reference};
use palkki_evidence::random::{Random, sample_of};

use super::{DIGITS, OFF, close, solved};
use crate::scenes::on_supports;

/// The answer, certified.
#[track_caller]
fn certified(scene: &Scene) -> Solution {
    let solution = solve_exactly(scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}\n{scene:?}", solution.verdict);
    solution
}

/// Whether the reported forces are within their brackets.
fn holds(solution: &Solution) -> bool {
    let certificate = solution.verdict.certificate.as_ref().expect("bounds");
    let size = solution.state.supports.iter().fold(solution.state.contact_force(), |most, s| most.max(s.force.abs()));
    let inside = |bracket: Option<[f64; 2]>, force: f64| {
        bracket.is_some_and(|[least, most]| least - DIGITS * size <= force && force <= most + DIGITS * size)
    };
    let supports = solution.state.supports.iter().zip(&certificate.reactions);
    inside(certificate.contact_force, solution.state.contact_force())
        && supports.into_iter().all(|(support, bracket)| inside(*bracket, support.force))
}

/// Built in along ground `x²/2`, `EI = l = 1`, under a force `P = 2` at the tip. The beam follows the ground up to `a`, where
/// `M = −EI g'' = −1 = −P (l − a)`, without a pressure, `EI g'''' = 0`, and with the shear force `EI g''' = 0`: the support carries nothing,
/// and at `a = ½` the ground carries all.
#[test]
fn a_beam_that_follows_the_ground_without_pressing_is_certified() {
    let ground = |curvature: f64| Some(Foundation::Polynomial { coefficients: vec![0.0, 0.0, 0.5 * curvature] });
    let support = Support { slope: Some(0.0), ..Support::simple(0.0) };
    for (curvature, force) in [(1.0, 2.0), (0.5, 2.0), (1.0, 1.5), (3.0, 4.0)] {
        let solution = certified(&on_supports([1.0, 1.0], &[support], (0.0, &[(1.0, force)]), ground(curvature)));
        let state = &solution.state;
        close("reaction", state.supports[0].force, 0.0);
        close("moment", state.supports[0].moment.expect("built in"), -curvature);
        close("contact force", state.contact_force(), force);
        close("contact", state.contacts[state.contacts.len() - 1].to, 1.0 - curvature / force);
        assert!(holds(&solution), "{:?}", solution.verdict.certificate);
    }
}

/// A bridge on two to six supports, one of which is settled to the ground, that is level.
fn bridge(seed: u64) -> Scene {
    let mut random = Random::new(0x5e_0000 + seed);
    let spans = random.pick(&[2_u32, 3, 4, 5]);
    let (length, stiffness) = (random.pick(&[20.0, 30.0, 40.0, 60.0]), random.pick(&[1e5, 5e5, 2e6]));
    let (depth, settled) = (random.pick(&[0.01, 0.02, 0.05, 0.1]), random.below(1 + spans as usize));
    let support = |k: u32| {
        let level = if k as usize == settled { depth } else { 0.0 };
        Support::simple(length * f64::from(k) / f64::from(spans)).at_level(level)
    };
    let supports: Vec<Support> = (0..=spans).map(support).collect();
    let uniform = random.pick(&[5.0, 10.0, 30.0, 100.0]);
    let count = random.pick(&[0, 1, 3]);
    let points: Vec<(f64, f64)> =
        (0..count).map(|_| (random.between(0.0, length), random.pick(&[50.0, 100.0, 300.0]))).collect();
    on_supports([length, stiffness], &supports, (uniform, &points), Some(Foundation::Flat { depth }))
}

/// Settled bridges whose support stands exactly at the level of the ground: each is certified, and meets the definition.
#[test]
fn a_support_at_the_level_of_the_ground_takes_what_both_carry() {
    for seed in 0..sample_of(400) {
        let scene = bridge(seed);
        let solution = certified(&scene);
        assert!(holds(&solution), "{seed}: {:?}", solution.verdict.certificate);
        let wrong = violated(&scene, solution.exact.as_ref().expect("functions"), OFF);
        assert!(wrong.is_empty(), "{seed}: {wrong:?}\n{scene:?}");
    }
}

/// A pipe in soil, on up to three supports: settled into the soil, built in where it rises, or bearings in it and at its surface.
pub(crate) fn pipe(seed: u64) -> Scene {
    let mut random = Random::new(0x5f_0000 + seed);
    let length = random.pick(&[20.0, 40.0, 100.0]);
    let depth = random.pick(&[-0.05, 0.0, 0.02]);
    let ground = match random.below(4) {
        0 => Foundation::Flat { depth },
        1 => {
            let [slope, bend] = [0.02, 0.1].map(|size| size * random.between(-1.0, 1.0));
            Foundation::Polynomial { coefficients: vec![depth, slope / length, bend / (length * length)] }
        }
        2 => {
            let points = (0..=8).map(|k| [length * f64::from(k) / 8.0, depth + random.between(-0.03, 0.03)]);
            Foundation::Polyline { points: points.collect() }
        }
        _ => {
            let (wavelength, phase) = (random.pick(&[7.0, 15.0]), random.between(0.0, 6.0));
            Foundation::Cosine { mean: depth, amplitude: 0.03, wavelength, phase }
        }
    };
    let mut supports: Vec<Support> = Vec::new();
    for _ in 0..1 + random.below(3) {
        // At nodes of a grid of forty intervals.
        let at = length * f64::from(u8::try_from(random.below(11)).expect("small")) / 10.0;
        let level = ground.depth(at) + random.pick(&[0.0, 0.0, 0.01, 0.03, 0.05]);
        let support = match random.below(3) {
            0 => Support::simple(at),
            1 => Support { slope: Some(random.pick(&[-0.005, 0.0, 0.005])), ..Support::simple(at) },
            _ => Support::pushing(at),
        };
        if supports.iter().all(|other| 1e-3 < (other.at - at).abs()) {
            supports.push(support.at_level(level));
        }
    }
    let beam = Beam::new(length, random.pick(&[1e4, 5e4, 2e5])).and_then(|beam| beam.with_supports(supports));
    let beam = beam.expect("a beam");
    let count = random.pick(&[0, 1, 2]);
    let points: Vec<PointLoad> =
        (0..count).map(|_| PointLoad { at: random.between(0.0, length), force: random.pick(&[50.0, 200.0]) }).collect();
    let load = Load::new(&beam, random.pick(&[5.0, 20.0, 50.0]), Vec::new(), points).expect("finite");
    Scene::above(beam, load, Some(ground), Some(random.pick(&[50.0, 200.0, 1000.0, 5000.0]))).expect("a scene")
}

fn by_elements(scene: &Scene) -> Reference {
    match reference(&Draft::from(scene).text()) {
        Found::Answer(found) => *found,
        other => panic!("{other:?}: {scene:?}"),
    }
}

/// Of these the answer is right and no finite bound is proven.
const UNPROVEN: [u64; 1] = [345];

/// Each is solved and agrees with finite elements, and all but [`UNPROVEN`] are certified.
#[test]
fn supports_stand_in_an_elastic_foundation() {
    /// What the elements have: springs are switched at the points of a quadrature.
    const ELEMENTS: f64 = 1e-5;
    for seed in 0..sample_of(400) {
        let scene = pipe(seed);
        let solution = solve_exactly(&scene).expect("an answer");
        let is_certified = solution.verdict.status == Status::Certified;
        assert_eq!(is_certified, !UNPROVEN.contains(&seed), "{seed}: {}", solution.verdict);
        assert!(!is_certified || holds(&solution), "{seed}: {:?}", solution.verdict.certificate);
        let found = by_elements(&scene);
        let state = &solution.state;
        let forces = found.numbers.supports.iter().copied().chain([found.numbers.contact]);
        let size = forces.clone().fold(0.0, |most: f64, force| most.max(force.abs()));
        let own = state.supports.iter().map(|support| support.force).chain([state.contact_force()]);
        for (own, force) in own.zip(forces) {
            assert!((own - force).abs() <= ELEMENTS * size, "{seed}: {own} for {force} of {size}\n{scene:?}");
        }
        let exact = solution.exact.as_ref().expect("functions");
        for (x, v) in found.places.iter().zip(&found.numbers.deflections) {
            let off = (exact.deflection(*x) - v).abs();
            assert!(off <= ELEMENTS * state.deflection.magnitude(), "{seed}: {v} at {x}, off by {off}\n{scene:?}");
        }
    }
}

/// On a grid the same scenes converge to the same answer, and what is certified of them is right.
#[test]
fn supports_in_an_elastic_foundation_on_grids() {
    for seed in 0..sample_of(100) {
        let scene = pipe(seed);
        let answer = certified(&scene);
        let (exact, size) = (answer.exact.as_ref().expect("functions"), answer.state.deflection.magnitude());
        let off = |method: Method, intervals: usize| {
            let settings = Settings::new(method, Solver::ActiveSet, intervals);
            let solution = solve(&scene, &settings).expect("an answer");
            // At nodes: the largest deflection may lie between two of them.
            let nodes = solution.state.nodes.as_ref().expect("a grid");
            let apart = nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| (v - exact.deflection(*x)).abs());
            let off = apart.fold(0.0, f64::max) / size;
            if solution.verdict.status == Status::Certified {
                // The error is a share of the answer's own largest deflection.
                let bound = solution.verdict.error * solution.state.deflection.magnitude() / size;
                assert!(off <= bound, "{seed}: {off} of {}", solution.verdict);
            }
            off
        };
        for method in Method::ALL {
            let errors = [40, 80, 160, 320].map(|intervals| off(method, intervals));
            assert!(
                errors[3] <= 0.01 && errors[3] <= 0.5 * errors[0] + 1e-3,
                "{seed}, {method}: {errors:?}\n{scene:?}"
            );
        }
    }
}

/// Into rigid ground none of these supports fits, and the message says that an elastic foundation would do.
#[test]
fn what_rigid_ground_forbids_an_elastic_foundation_allows() {
    let flat = Foundation::Flat { depth: 0.1 };
    let rising = Foundation::Polynomial { coefficients: vec![0.1, -0.05] };
    let valley = Foundation::Polyline { points: vec![[0.0, 0.05], [2.0, 0.1], [10.0, 0.02]] };
    let above = |support: Support, ground: &Foundation, stiffness: Option<f64>| {
        let beam = Beam::new(10.0, 1e3).and_then(|beam| beam.with_supports(vec![support, Support::simple(10.0)]));
        let beam = beam.expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("finite");
        Scene::above(beam, load, Some(ground.clone()), stiffness)
    };
    let cases = [
        (Support::simple(2.0).at_level(0.15), &flat),
        (Support::pushing(2.0).at_level(0.1), &flat),
        (Support::pushing(2.0).at_level(0.3), &flat),
        (Support::built_in(0.0).at_level(0.1), &rising),
        (Support::simple(2.0).at_level(0.1), &valley),
    ];
    for (support, ground) in cases {
        let refused = above(support, ground, None).expect_err("rigid ground is in its way");
        assert!(refused.to_string().contains("elastic foundation"), "{refused}");
        let solution = certified(&above(support, ground, Some(200.0)).expect("a scene"));
        let found = by_elements(&above(support, ground, Some(200.0)).expect("a scene"));
        assert!((found.numbers.supports[0] - solution.state.supports[0].force).abs() <= 1e-4 * 10.0, "{support:?}");
    }
    // Not a number stays none.
    let wave = Foundation::Cosine { mean: 0.0, amplitude: 1.0, wavelength: 1e-308, phase: 0.0 };
    let refused = above(Support::simple(2.0), &wave, Some(1.0));
    assert!(matches!(refused, Err(SceneError::Overflow { .. })), "{refused:?}");
}

/// A beam without another support that only a bearing at the surface carries below its resultant: the foundation beside it holds it.
#[test]
fn a_bearing_at_the_surface_below_the_resultant() {
    let beam = Beam::new(10.0, 1e3).and_then(|beam| beam.with_supports(vec![Support::pushing(5.0)])).expect("a beam");
    let load = Load::uniform_on(&beam, 20.0).expect("finite");
    let scene = Scene::above(beam, load, Some(Foundation::Flat { depth: 0.0 }), Some(200.0)).expect("a scene");
    let (exact, found) = (solved(&scene), by_elements(&scene));
    assert!((exact.state.supports[0].force - found.numbers.supports[0]).abs() <= 1e-4 * 200.0);
    certified(&scene);
}
