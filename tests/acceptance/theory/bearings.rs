//! Supports that only push beside ground that gives: a closed form, the conditions of the minimum, rigid ground as the limit.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Foundation, PointLoad, Scene, Support};
use palkki::sweep::Sweep;
use palkki::{Settings, Solution, solve, solve_exactly};
use palkki_evidence::compare::{apart, largest};
use palkki_evidence::differences::Trial;
use palkki_evidence::draft::Draft;
use palkki_evidence::random::{Random, sample_of};

use crate::scenes::{on_supports, run};

/// What is asked for of a closed form.
const DIGITS: f64 = 1e-12;

#[track_caller]
fn certified(scene: &Scene) -> Solution {
    let solution = solve_exactly(scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}: {:?}", solution.verdict, scene.beam().all_supports());
    solution
}

/// A long beam of the weight `q` on level ground, lifted in its middle by a support that stands higher by `δ`. Beyond the distance `c`
/// from there it lies on the ground, where `v − q/k = e^(−λt) (A cos λt + B sin λt)`: `A = −q/k` at the lift-off, `v' = λ (B − A)`,
/// `v'' = −2λ² B`, `v''' = 2λ³ (A + B)` there. Up to it `EI v'''' = q`, and `v' = 0` in the middle says what `B` is for a given `c`:
///
/// ```text
/// v'(0) = v' − v'' c + v''' c²/2 − q c³/6 EI = 0,    δ = v' c − v'' c²/2 + v''' c³/6 − q c⁴/24 EI,    R = 2 (EI v''' − q c)
/// ```
#[test]
fn a_long_beam_is_lifted_in_its_middle() {
    let (q, k, bending) = (1.5, 4.0, 2.0);
    let l = libm::sqrt(libm::sqrt(0.25 * k / bending));
    for c in [0.7_f64, 1.5, 3.0] {
        let a = -q / k;
        // Of λ (B − A) + 2 λ² B c + λ³ (A + B) c² = q c³/6 EI.
        let b = (q * c.powi(3) / (6.0 * bending) + l * a - l.powi(3) * a * c * c)
            / (l + 2.0 * l * l * c + l.powi(3) * c * c);
        let (first, second, third) = (l * (b - a), -2.0 * l * l * b, 2.0 * l.powi(3) * (a + b));
        let rise = first * c - 0.5 * second * c * c + third * c.powi(3) / 6.0 - q * c.powi(4) / (24.0 * bending);
        let pushes = 2.0 * (q * c - bending * third);
        let half = 40.0 / l;
        let under = |force: f64| {
            let (support, ground) = (Support::pushing(half).at_level(-rise), Some(Foundation::Flat { depth: 0.0 }));
            let scene = on_supports([2.0 * half, bending], &[support], (q, &[(0.5, force)]), ground);
            scene.on_springs(k).expect("ground")
        };
        // Nothing says how the beam is held but the ground: the load is not quite above the support.
        let refused = solve_exactly(&under(1e-30)).expect_err("the border");
        assert!(refused.to_string().contains("no position is known"), "{refused}");
        let solution = certified(&under(1e-3));
        let [left, right] = solution.state.contacts[..] else { panic!("{:?}", solution.state.contacts) };
        let close = |what: &str, found: f64, expected: f64, size: f64| {
            assert!((found - expected).abs() <= DIGITS * size, "{what} for {c}: {found} instead of {expected}");
        };
        close("force", solution.state.supports[0].force, pushes, pushes);
        close("left lift-off", left.to, half - c, 2.0 * half);
        close("right lift-off", right.from, half + c, 2.0 * half);
        let moment = solution.exact.expect("functions").moment(half);
        let expected = -bending * (second - third * c + q * c * c / (2.0 * bending));
        close("moment", moment, expected, expected.abs());
    }
}

/// A symmetric beam on three supports, of which the middle one is just below the resultant: the others keep it from turning as long as
/// they press. Where they stand too deep to be touched nothing does, and no position is known to be the one.
#[test]
fn a_symmetric_beam_is_kept_from_turning() {
    let (l, q, bending) = (6.0, 0.8, 70.0);
    for middle in [Support::simple(l), Support::pushing(l)] {
        let of = |deep: f64| {
            let ends = [0.0, 2.0 * l].map(|at| Support::pushing(at).at_level(deep));
            let ground = Some(Foundation::Flat { depth: 50.0 });
            let scene = on_supports([2.0 * l, bending], &[ends[0], middle, ends[1]], (q, &[]), ground);
            scene.on_springs(20.0).expect("ground")
        };
        let found = certified(&of(0.0)).state.supports;
        for (found, expected) in found.iter().zip([0.375, 1.25, 0.375]) {
            assert!((found.force - expected * q * l).abs() <= DIGITS * q * l, "{found:?}");
        }
        for method in Method::ALL {
            let grid = solve(&of(0.0), &Settings::new(method, Solver::ActiveSet, 60)).expect("an answer");
            assert_eq!(grid.verdict.status, Status::Certified, "{method}: {}", grid.verdict);
        }
        // The ends of a beam on its middle hang down by q l⁴/8 EI.
        let refused = solve_exactly(&of(1.01 * q * l.powi(4) / (8.0 * bending)));
        match refused {
            Ok(solution) => assert_eq!(solution.verdict.status, Status::NotConverged, "{}", solution.verdict),
            Err(why) => assert!(why.to_string().contains("no position is known"), "{why}"),
        }
    }
}

/// A beam with one to four supports that only push above its ground, which is flat, a line of points or a wave; some have an own shape,
/// and some are held by nothing else.
fn draft(seed: u64) -> Option<Draft> {
    let mut random = Random::new(0xbea_0000 + seed);
    let length = random.between(6.0, 14.0);
    let ground = match random.below(3) {
        0 => Foundation::Flat { depth: random.between(0.2, 1.0) },
        1 => Foundation::Cosine {
            mean: random.between(0.5, 1.0),
            amplitude: random.between(0.05, 0.3),
            wavelength: random.between(4.0, 12.0),
            phase: random.between(0.0, 6.0),
        },
        _ => Foundation::Polyline {
            points: (0..=5).map(|i| [length * f64::from(i) / 5.0, random.between(0.3, 1.2)]).collect(),
        },
    };
    let shape = random
        .once_in(4)
        .then(|| Foundation::Polynomial { coefficients: vec![0.0, random.between(-0.05, 0.05), 0.004] });
    let count = 1 + random.below(4);
    let mut supports: Vec<Support> =
        [0.0, length].into_iter().filter(|_| random.once_in(2)).map(Support::simple).collect();
    for _ in 0..count {
        let at = length * [1.0, 0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95][random.below(8)];
        if supports.iter().any(|support| (support.at - at).abs() < 0.1) {
            return None;
        }
        supports.push(Support::pushing(at).at_level(ground.depth(at) - random.between(0.02, 0.9)));
    }
    let point = (0..2).map(|_| PointLoad { at: random.between(0.0, length), force: random.between(-2.0, 20.0) });
    let (point, uniform) = (point.collect(), random.between(0.2, 8.0));
    let stiffness = random.between(20.0, 200.0);
    let draft = Draft {
        length,
        stiffness,
        uniform,
        point,
        ground: Some(ground),
        supports: Some(supports),
        shape,
        ..Draft::default()
    };
    draft.scene().is_ok_and(|scene| scene.scaled().is_ok()).then_some(draft)
}

/// The stiffness of the ground of a draft.
fn stiffness(seed: u64) -> f64 {
    libm::pow(10.0, Random::new(seed).between(-2.0, 6.0))
}

/// Two hundred are certified. What does not push lifts off; what pushes might as well hold; and so it is from right to left, and on
/// grids by each method.
#[test]
fn random_beams_rest_on_what_pushes() {
    const COUNT: usize = 200;
    const ALIKE: f64 = 1e-9;
    const INTERVALS: usize = 200;
    /// Finite differences put the ends of spans between nodes.
    const NEAR: f64 = 0.03;
    let (mut tried, mut lifted, mut pressed, mut zones) = (0, 0, 0, 0);
    for (seed, draft) in (0..).filter_map(|seed| Some((seed, draft(seed)?))) {
        let on = |draft: &Draft| draft.scene().and_then(|scene| scene.on_springs(stiffness(seed))).expect("a scene");
        let scene = on(&draft);
        if scene.scaled().is_err() {
            continue;
        }
        let solution = certified(&scene);
        let (state, bounds) = (&solution.state, solution.verdict.certificate.as_ref().expect("bounds"));
        let size = state.supports.iter().fold(scene.load().magnitude(draft.length), |sum, s| sum + s.force.abs());
        let exact = solution.exact.as_ref().expect("functions");
        for (support, bracket) in state.supports.iter().zip(&bounds.reactions) {
            let [least, most] = bracket.expect("a bracket");
            assert!(
                least - ALIKE * size <= support.force && support.force <= most + ALIKE * size,
                "{seed}: {support:?}"
            );
            if !support.pushes_only {
                continue;
            }
            let (play, deep) = (exact.clearance(support.at), state.deflection.magnitude());
            if support.force == 0.0 {
                lifted += 1;
                assert!(-ALIKE * deep <= play, "{seed}: {support:?} {play}");
            } else {
                pressed += 1;
                assert!(0.0 < support.force && play.abs() <= ALIKE * deep, "{seed}: {support:?} {play}");
            }
        }
        zones += usize::from(!state.contacts.is_empty());
        for method in Method::ALL {
            let grid = run(&scene, method, Solver::ActiveSet, INTERVALS);
            assert!(grid.residual <= CERTIFIED_RESIDUAL, "{seed}, {method}: {:e}", grid.residual);
            let off = grid.state.supports.iter().zip(&state.supports).map(|(a, b)| (a.force - b.force) / size);
            assert!(largest(off) <= NEAR, "{seed}, {method}: {:?}", grid.state.supports);
        }
        // Supports that hold, in the places of those that push.
        let pushes = |at: f64| state.supports.iter().any(|s| s.at.total_cmp(&at).is_eq() && 0.0 < s.force);
        let held = draft.supports.iter().flatten().filter(|s| !s.pushes_only || pushes(s.at));
        let held = held.map(|s| Support { pushes_only: false, ..*s }).collect();
        let other = certified(&on(&Draft { supports: Some(held), ..draft.clone() })).state;
        let expected: Vec<f64> = other.supports.iter().map(|s| s.force).collect();
        let found = state.supports.iter().filter(|s| !s.pushes_only || 0.0 < s.force).map(|s| s.force);
        assert!(apart(&found.collect::<Vec<_>>(), &expected) <= ALIKE * size, "{seed}: {expected:?}");
        let mirrored = certified(&on(&draft.mirrored())).state;
        assert!((mirrored.energy - state.energy).abs() <= ALIKE * size * state.deflection.magnitude(), "{seed}");
        for (support, other) in state.supports.iter().zip(mirrored.supports.iter().rev()) {
            assert!((support.force - other.force).abs() <= ALIKE * size, "{seed}: {support:?} {other:?}");
        }
        tried += 1;
        if tried == COUNT {
            break;
        }
    }
    assert!(80 <= lifted && 150 <= pressed && 100 <= zones, "{lifted} lifted, {pressed} press, {zones} touch");
}

/// Ever stiffer ground is rigid ground, of which another search finds the answer. A zone comes closer like `k^(−3/4)`. A corner that
/// opens by the angle `θ` is pressed over a width `b` with `F ~ k θ b²`, so that the beam sinks by `θ b ~ k^(−1/2)`: that is the slowest.
#[test]
fn stiff_ground_is_rigid_ground() {
    const COUNT: usize = 40;
    /// As long as `1/λ` is short against all that there is.
    const STIFF: [f64; 2] = [1e10, 1e14];
    let mut tried = 0;
    for (seed, draft) in (0..).filter_map(|seed| Some((seed, draft(seed)?))) {
        let rigid = draft.scene().expect("a scene");
        if STIFF.iter().any(|k| rigid.on_springs(*k).and_then(|scene| scene.scaled()).is_err()) {
            continue;
        }
        let expected = certified(&rigid).state;
        let size = expected.supports.iter().fold(rigid.load().magnitude(draft.length), |sum, s| sum + s.force.abs());
        let off = STIFF.map(|k| {
            let state = solve_exactly(&rigid.on_springs(k).expect("ground")).expect("an answer").state;
            largest(state.supports.iter().zip(&expected.supports).map(|(a, b)| (a.force - b.force) / size))
        });
        assert!(off[0] <= 1e-3, "{seed}: {off:?}");
        // Of ten thousand times the stiffness.
        assert!(off[1] <= 2e-2 * off[0] + 1e-10, "{seed}: {off:?}");
        tried += 1;
        if tried == COUNT {
            break;
        }
    }
}

/// By what a support that only pushes stands at, too.
#[test]
fn derivatives_agree_with_differences() {
    let count = sample_of(40);
    let mut trial = Trial::default();
    for (seed, draft) in (0..).filter_map(|seed| Some((seed, draft(seed)?))).take(count) {
        let scene = draft.scene().and_then(|scene| scene.on_springs(stiffness(seed))).expect("a scene");
        trial.compare(&format!("scene {seed}"), &scene);
    }
    assert!(trial.wrong.is_empty(), "{:#?}", trial.wrong);
    assert!(count - 4 <= trial.scenes && 6 * count <= trial.both, "{trial:?}");
}

/// More load on the right span of two: the left end lifts off, once, and a sweep has the value at which it does so.
#[test]
fn a_sweep_sees_a_support_lift_off() {
    let scene = |force: f64| {
        let supports = [Support::pushing(0.0), Support::simple(6.0), Support::pushing(12.0)];
        let ground = Some(Foundation::Flat { depth: 0.5 });
        on_supports([12.0, 70.0], &supports, (0.8, &[(9.0, force)]), ground).on_springs(20.0).expect("ground")
    };
    let first = scene(10.0);
    let sweep = Sweep::new(&first, "load.point[0].force", [10.0, 60.0], 6).expect("a sweep");
    let events = sweep.events(&sweep.rows().expect("answers"));
    let lifts: Vec<f64> = events.iter().filter(|e| e.what.contains("lifts off")).map(|e| e.value).collect();
    let [at] = lifts[..] else { panic!("{events:?}") };
    let left = |force: f64| certified(&scene(force)).state.supports[0].force;
    assert!(0.0 < left(0.999 * at) && left(1.001 * at) == 0.0, "{at}");
}
