//! Ground that gives: closed forms with their derivations, the limit of rigid ground, random scenes.

use palkki::certificate::{Judged, Proof};
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Foundation, LinearLoad, Scene, Support};
use palkki::theory::{Exact, solve};
use palkki::verdict::Refusal;
use palkki::{Solution, solve_exactly};
use palkki_evidence::compare::largest;
use palkki_evidence::differences::Trial;
use palkki_evidence::draft::{Draft, Units};
use palkki_evidence::random::{self, Random, sample_of};

use crate::scenes::{on_supports, run};

/// What is asked for; the elimination loses a digit or two.
const DIGITS: f64 = 1e-12;

#[track_caller]
fn check(what: &str, found: f64, expected: f64, size: f64) {
    let error = (found - expected).abs();
    assert!(error <= DIGITS * size.abs(), "{what}: {found} instead of {expected}, off by {error:e}");
}

/// A beam on ground of a stiffness.
struct Given {
    draft: Draft,
    stiffness: f64,
}

impl Given {
    /// A beam without supports that lies on the level, under point loads `(place, force)`.
    fn lying(length: f64, bending: f64, stiffness: f64, loads: &[(f64, f64)]) -> Self {
        let (ground, supports) = (Some(Foundation::Flat { depth: 0.0 }), Some(Vec::new()));
        let draft = Draft { length, stiffness: bending, ground, supports, ..Draft::default() };
        Self { draft: draft.with_points(loads), stiffness }
    }

    /// The same under a uniform load, on a simple support at each end, with the ground so deep.
    fn simple(length: f64, bending: f64, stiffness: f64, uniform: f64, depth: f64) -> Self {
        let Self { draft, .. } = Self::lying(length, bending, stiffness, &[]);
        let ground = Some(Foundation::Flat { depth });
        Self { draft: Draft { uniform, ground, supports: None, ..draft }, stiffness }
    }

    fn scene(&self) -> Scene {
        self.draft.scene().and_then(|scene| scene.on_springs(self.stiffness)).expect("a scene")
    }

    /// The answer, solved and certified.
    #[track_caller]
    fn solved(&self) -> Exact {
        let solution = solve_exactly(&self.scene()).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{}", solution.verdict);
        *solution.exact.expect("functions")
    }

    /// `λ`.
    fn decay(&self) -> f64 {
        (0.25 * self.stiffness / self.draft.stiffness).sqrt().sqrt()
    }
}

/// A weightless beam under a load `P` far from its ends touches on both sides of it over `c`, and is straight beyond:
/// `v = v'' = v''' = 0` at the lift-off. With `t = λ(c − s)` at the distance `s` from the load the solutions of `v'''' = −4λ⁴ v` that do so
/// are multiples `a φ(t)` of `φ = sin t cosh t + cos t sinh t`, of which `φ' = 2 cos t cosh t`, `φ'' = 2 (cos t sinh t − sin t cosh t)`,
/// `φ''' = −4 sin t sinh t`, `∫φ = sin t sinh t`. By symmetry `v'` vanishes below the load: `cos λc = 0`, `λc = π/2`. Equilibrium,
/// `k ∫v = P/2`, says `k a sinh(π/2)/λ = P/2`.
#[test]
fn a_weightless_beam_under_a_load_touches_over_half_a_wave() {
    let given = Given::lying(20.0, 2.0, 5.0, &[(11.0, 3.0)]);
    let (exact, l) = (given.solved(), given.decay());
    let contact = exact.state.contacts[0];
    assert_eq!(exact.state.contacts.len(), 1);
    let half = std::f64::consts::FRAC_PI_2 / l;
    check("from", contact.from, 11.0 - half, 20.0);
    check("to", contact.to, 11.0 + half, 20.0);
    check("force", contact.force, 3.0, 3.0);
    let quarter = std::f64::consts::FRAC_PI_2;
    let a = 1.5 * l / (5.0 * libm::sinh(quarter));
    let deepest = a * libm::cosh(quarter);
    check("below the load", exact.deflection(11.0), deepest, deepest);
    let pressure = exact.state.pressure.expect("of ground that gives");
    check("pressure", pressure.max, 5.0 * deepest, 5.0 * deepest);
    check("its place", pressure.at, 11.0, 11.0);
    // EI v'' = EI a λ² φ'' = 2 EI a λ² (cos t sinh t − sin t cosh t).
    let moment = 2.0 * 2.0 * a * l * l * libm::cosh(quarter);
    check("moment", exact.state.moment.max, moment, moment);
}

/// On soft ground, `u = λl < π`, a beam with free ends touches all along under a load at its middle (Hetényi 1946). The deflection below
/// the load is `P λ/2k · (cosh u + cos u + 2)/(sinh u + sin u)`, at the ends `2Pλ/k · cosh(u/2) cos(u/2)/(sinh u + sin u)`: even solutions
/// of `v'''' = −4λ⁴ v` about the middle with `v''' = P/2EI` there and without moment and shear at the ends.
#[test]
fn soft_ground_is_touched_all_along() {
    let given = Given::lying(4.0, 7.0, 0.9, &[(2.0, 3.0)]);
    let (exact, l) = (given.solved(), given.decay());
    let u = l * 4.0;
    let (below, under) = (libm::sinh(u) + libm::sin(u), 3.0 * l / (2.0 * 0.9));
    let middle = under * (libm::cosh(u) + libm::cos(u) + 2.0) / below;
    let end = under * 4.0 * libm::cosh(0.5 * u) * libm::cos(0.5 * u) / below;
    check("middle", exact.deflection(2.0), middle, middle);
    check("end", exact.deflection(0.0), end, middle);
    check("other end", exact.deflection(4.0), end, middle);
    let contact = exact.state.contacts[0];
    assert!(contact.from <= 0.0 && 4.0 <= contact.to, "{contact:?}");
}

/// A simple beam at the level of the ground under a uniform load is pressed all along: with `x` from the middle
/// `v = q/k · (1 − 2 (cosh α cos α · cosh λx cos λx + sinh α sin α · sinh λx sin λx)/(cosh 2α + cos 2α))`, `α = λl/2`, of which value
/// and second derivative vanish at both ends.
#[test]
fn a_simple_beam_on_the_level() {
    let given = Given::simple(3.0, 2.0, 4.0, 1.5, 0.0);
    let (exact, l) = (given.solved(), given.decay());
    let a = 0.5 * l * 3.0;
    let (c, s) = (libm::cosh(a) * libm::cos(a), libm::sinh(a) * libm::sin(a));
    let below = libm::cosh(2.0 * a) + libm::cos(2.0 * a);
    for x in [-1.0, -0.3, 0.0, 0.7, 1.4] {
        let (t, size) = (l * x, 1.5 / 4.0);
        let v = libm::cosh(t) * libm::cos(t) * c + libm::sinh(t) * libm::sin(t) * s;
        check("deflection", exact.deflection(1.5 + x), size * (1.0 - 2.0 * v / below), size);
    }
    let contact = exact.state.contact_force();
    check("equilibrium", 2.0 * exact.state.reactions.left + contact, 1.5 * 3.0, 4.5);
}

/// A cantilever at the level of the ground with a load down at its tip, on ground so soft that it is pressed all along: with `s` from
/// the tip, free of moment there and `EI v''' = −P` towards it, `v = a (cosh cos) + b (sinh cos + cosh sin)`, and `v = v' = 0` at the
/// wall: `v(tip) = 2 P λ/k · (sinh u cosh u − sin u cos u)/(cosh² u + cos² u)`, `u = λl` (Hetényi 1946).
#[test]
fn a_cantilever_on_soft_ground() {
    let mut given = Given::lying(2.0, 6.0, 0.5, &[(2.0, 3.0)]);
    given.draft.supports = Some(vec![Support::built_in(0.0)]);
    let (exact, u) = (given.solved(), given.decay() * 2.0);
    let (sinh, cosh, sin, cos) = (libm::sinh(u), libm::cosh(u), libm::sin(u), libm::cos(u));
    let tip = 2.0 * 3.0 * given.decay() / 0.5 * (sinh * cosh - sin * cos) / (cosh * cosh + cos * cos);
    check("tip", exact.deflection(2.0), tip, tip);
}

/// Loads `F` at both ends of a weightless beam, `λl > π`: between the two contacts of length `c` it hangs in a circle. With
/// `t = λ(c − s)`, `s` from the load, `v = a φ + b ψ` with `φ` as under a load inside and `ψ = sin t sinh t`, for which `v = v''' = 0` at the
/// lift-off. No moment at the load, `τ = λc`: `b = a (tan τ − tanh τ)`. No slope in the middle: from the lift-off on, where `v' = −2λa` and
/// `v'' = 2λ²b`, the slope grows by `v'' (l/2 − c)`, hence `1 = (λl/2 − τ)(tan τ − tanh τ)`. The load is
/// `EI λ³ (4a sin τ sinh τ + 2b (sin τ cosh τ − cos τ sinh τ))`.
#[test]
fn loads_at_both_ends_leave_a_gap_between() {
    let given = Given::lying(10.0, 1.5, 50.0, &[(0.0, 2.0), (10.0, 2.0)]);
    let (exact, l) = (given.solved(), given.decay());
    let turn = |t: f64| libm::tan(t) - libm::tanh(t);
    let (mut lo, mut hi) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..80 {
        let middle = 0.5 * (lo + hi);
        if (5.0 * l - middle) * turn(middle) < 1.0 {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    let (sin, cos, sinh, cosh) = (libm::sin(lo), libm::cos(lo), libm::sinh(lo), libm::cosh(lo));
    let load = 4.0 * sin * sinh + 2.0 * turn(lo) * (sin * cosh - cos * sinh);
    let a = 2.0 / (1.5 * l * l * l * load);
    let [left, right] = exact.state.contacts[..] else { panic!("two contacts: {:?}", exact.state.contacts) };
    check("left", left.to, lo / l, 10.0);
    check("right", right.from, 10.0 - lo / l, 10.0);
    check("force", left.force, 2.0, 2.0);
    let bend = 2.0 * l * l * a * turn(lo);
    check("moment", exact.moment(5.0), -1.5 * bend, 1.5 * bend);
    let rise = 5.0 - lo / l;
    check("middle", exact.deflection(5.0), -0.5 * bend * rise * rise, bend * rise * rise);
}

/// A short stiff beam stays straight. Under a load at `e` from its middle, within its third, the pressure is `P/l (1 + 12 e ξ/l²)` at `ξ`
/// from the middle; outside of it only `3 (l/2 − e)` of the beam touch, with a triangle of pressure up to `2P/(3 (l/2 − e))`.
#[test]
fn an_eccentric_load_on_a_short_stiff_beam() {
    /// What it bends is of the order `k l⁴/EI`.
    const BENDS: f64 = 8e-9;
    let given = |at: f64| Given::lying(2.0, 1e9, 0.5, &[(at, 3.0)]);
    let found = |at: f64| solve(&given(at).scene()).expect("an answer");
    let (exact, inside) = (found(1.7), found(1.2));
    assert!(exact.solved && inside.solved, "{:?} {:?}", exact.violations, inside.violations);
    let (contact, width) = (exact.state.contacts[0], 3.0 * 0.3);
    assert!((contact.from - (2.0 - width)).abs() <= BENDS, "{contact:?}");
    let pressure = exact.state.pressure.expect("of ground that gives");
    assert!((pressure.max - 6.0 / width).abs() <= BENDS * pressure.max, "{pressure:?}");
    for x in [0.0, 0.5, 1.9] {
        let expected = 1.5 * (1.0 + 12.0 * 0.2 * (x - 1.0) / 4.0);
        assert!((inside.pressure(x) - expected).abs() <= BENDS, "{x}: {expected}");
    }
}

/// The example of the paper on ground of a stiffness.
fn example(stiffness: f64) -> Solution {
    let given = Given::simple(10.0, 500.0 / 384.0, stiffness, 1.0, 1.0);
    solve_exactly(&given.scene()).expect("an answer")
}

/// From `k l⁴/EI = 1e-6` to `1e18`: solved, certified, and in equilibrium.
#[test]
fn ground_of_every_stiffness_is_solved() {
    for power in -6..=18 {
        let stiffness = libm::pow(10.0, f64::from(power)) * (500.0 / 384.0) / 1e4;
        let solution = example(stiffness);
        assert_eq!(solution.verdict.status, Status::Certified, "1e{power}: {}", solution.verdict);
        let state = &solution.state;
        let carried = state.reactions.left + state.reactions.right + state.contact_force();
        check("equilibrium", carried, 10.0, 10.0);
    }
}

/// Beside a support in the middle that the beam is built into moments may be as large on both sides, with different signs: which of them is
/// told does not depend on whether the ground, which is out of reach, gives.
#[test]
fn the_moment_at_a_wall_in_the_middle_is_that_of_rigid_ground() {
    let points = [(2.0, 1.0), (8.0, -1.0)];
    let ground = Some(Foundation::Flat { depth: 100.0 });
    let rigid = on_supports([10.0, 130.0], &[Support::built_in(5.0)], (0.0, &points), ground);
    let soft = rigid.on_springs(10.0).expect("ground");
    let of = |scene: &Scene| solve(scene).expect("an answer").state.supports[0].moment.expect("of a wall");
    check("on rigid ground", of(&rigid), -3.0, 3.0);
    check("on ground that gives", of(&soft), -3.0, 3.0);
    for method in Method::ALL {
        let state = run(&rigid, method, Solver::ActiveSet, 30).state;
        check("on a grid", state.supports[0].moment.expect("of a wall"), -3.0, 3.0);
    }
}

/// A random scene on ground of a stiffness from 1e-3 to 1e9, if its supports or the loads hold it there.
fn on_springs(seed: u64) -> Option<Scene> {
    let scene = if seed.is_multiple_of(4) { random::held(seed) } else { random::scene(seed) };
    let stiffness = libm::pow(10.0, Random::new(seed).between(-3.0, 9.0));
    let scene = scene.on_springs(stiffness).expect("positive");
    (scene.ground_stiffness().is_some() && scene.scaled().is_ok()).then_some(scene)
}

/// All but one in five hundred of the first 2,000 are certified.
/// None that is not exact is.
#[test]
fn random_scenes_are_certified() {
    let scenes = sample_of(2_000);
    let (mut tried, mut refused) = (0, Vec::new());
    for (seed, scene) in (0..).filter_map(|seed| Some((seed, on_springs(seed)?))).take(scenes) {
        tried += 1;
        let solution = solve_exactly(&scene).expect("an answer");
        let Solution { state, verdict, .. } = &solution;
        if verdict.status != Status::Certified {
            refused.push(format!("{seed}: {verdict}"));
            continue;
        }
        let load = scene.load().resultant(scene.beam().length());
        let carried = state.supports.iter().fold(state.contact_force(), |sum, support| sum + support.force);
        let size = scene.load().magnitude(scene.beam().length())
            + state.supports.iter().fold(0.0, |sum, support| sum + support.force.abs());
        assert!((carried - load).abs() <= 1e-9 * size, "{seed}: {carried} for {load}");
        let bounds = verdict.certificate.as_ref().expect("bounds");
        for (support, bracket) in state.supports.iter().zip(&bounds.reactions) {
            let [least, most] = bracket.expect("certified").map(|bound| bound - support.force);
            assert!(least <= 1e-9 * size && -1e-9 * size <= most, "{seed}: {support:?} in {bracket:?}");
        }
        let within = 1e-9 * (bounds.energy_upper.abs() + size * state.deflection.magnitude());
        assert!(
            bounds.energy_lower - within <= state.energy && state.energy <= bounds.energy_upper + within,
            "{seed}: {} in {bounds:?}",
            state.energy
        );
    }
    assert_eq!(tried, scenes);
    assert!(500 * refused.len() <= scenes, "{}: {refused:#?}", refused.len());
}

/// Verdict and bounds are the same, however long a unit of length is, from 1e-30 to 1e+30: of powers of two to the last bit. Beyond, the
/// coefficients of some polynomials leave the range of numbers.
#[test]
fn units_of_length_do_not_matter() {
    let two_to = |power: i32| 2.0_f64.powi(power);
    let mut certified = 0;
    for scene in (0..).filter_map(on_springs).take(40) {
        let (draft, stiffness) = (Draft::from(&scene), scene.ground_stiffness().expect("it gives"));
        let of = |unit: f64| {
            let units = Units { length: unit, depth: unit, force: 1.0 };
            let scene = draft.in_units(units).scene().and_then(|scene| scene.on_springs(stiffness / (unit * unit)));
            let verdict = solve_exactly(&scene.expect("in range")).expect("an answer").verdict;
            (verdict.status, verdict.error.to_bits(), verdict.largest_error().to_bits())
        };
        let expected = of(1.0);
        certified += usize::from(expected.0 == Status::Certified);
        for power in [-100, -30, 30, 100] {
            assert_eq!(of(two_to(power)), expected, "2^{power}: {}", draft.text());
        }
    }
    assert!(36 < certified, "{certified}");
}

/// Where an answer leaves the range of numbers that is the reason, and not a condition that it violates by nothing.
#[test]
fn an_answer_beyond_the_range_of_numbers_says_so() {
    let scene = Draft::over(Foundation::Flat { depth: 1.0 }).scene().and_then(|scene| scene.on_springs(1e60));
    let solution = solve_exactly(&scene.expect("a scene")).expect("an answer");
    assert!(!solution.state.is_finite());
    assert_eq!(solution.verdict.refusal, Some(Refusal::NoNumbers));
}

/// Bounds from a wrong witness, the stretches of the beam on softer and stiffer ground, are wide and true.
#[test]
fn a_wrong_witness_proves_nothing_untrue() {
    let mut sharp = 0;
    for scene in (0..).filter_map(on_springs).take(60) {
        let solution = solve_exactly(&scene).expect("an answer");
        let (state, stiffness) = (&solution.state, scene.ground_stiffness().expect("it gives"));
        for factor in [1.0, 1.0 + 1e-6, 1.01, 0.5, 8.0] {
            let other = solve(&scene.on_springs(factor * stiffness).expect("positive")).expect("an answer");
            let stretches = other.stretches().expect("of ground that gives");
            let bounds = Proof::of_stretches(&scene, &stretches).expect("in range").judge(Judged::Witness);
            let rounding = 1e-9 * scene.load().magnitude(scene.beam().length()) * state.deflection.magnitude();
            assert!(bounds.energy_lower <= state.energy + rounding, "{factor}: {} in {bounds:?}", state.energy);
            assert!(state.energy - rounding <= bounds.energy_upper, "{factor}: {} in {bounds:?}", state.energy);
            let off = (0..=20).map(|k| scene.beam().length() * f64::from(k) / 20.0);
            let exact = solution.exact.as_ref().expect("functions");
            let off = largest(off.map(|x| other.deflection(x) - exact.deflection(x)));
            // What is judged is the deflection of the witness, but for what hangs between its ends.
            let most = bounds.deflection_error * (1.0 + 1e-9) + 1e-6 * state.deflection.magnitude();
            assert!(off <= most, "{factor}: {off:e} for {most:e}");
            let loads = 1e-9 * scene.load().magnitude(scene.beam().length());
            for (support, bracket) in state.supports.iter().zip(&bounds.reactions) {
                let Some([least, most]) = *bracket else { continue };
                let known = least - loads <= support.force && support.force <= most + loads;
                assert!(known, "{factor}: {support:?} outside {least:e} to {most:e}");
            }
            sharp += usize::from(bounds.deflection_error <= state.deflection.magnitude());
        }
    }
    assert!(200 <= sharp, "only {sharp} bounds say anything");
}

/// What is not built for ground that gives says so.
#[test]
fn rigid_ground_is_asked_for_by_name() {
    use palkki::scene::SceneError;
    let given = Given::simple(10.0, 1.3, 100.0, 1.0, 1.0);
    let scene = given.scene();
    let refused = |error: SceneError| matches!(error, SceneError::NeedsRigidGround { .. });
    assert!(refused(palkki::certificate::certify(&scene, Judged::Witness, &[]).expect_err("no list of contacts")));
    let exact = solve(&scene).expect("an answer");
    assert!(exact.spread(1e-3).is_none() && exact.moved(&scene).is_none());
}

/// By the depth of the ground, both stiffnesses, loads and levels.
#[test]
fn derivatives_agree_with_differences() {
    let count = sample_of(60);
    let mut trial = Trial::default();
    for (i, scene) in (0..).filter_map(on_springs).take(count).enumerate() {
        trial.compare(&format!("scene {i}"), &scene);
    }
    assert!(trial.wrong.is_empty(), "{:#?}", trial.wrong);
    assert!(count - 2 <= trial.scenes && 6 * count <= trial.both, "{trial:?}");
}

/// A free body whose resultant is above the end of ground that gives has no position of rest.
#[test]
fn the_border_is_no_position_of_rest() {
    for at in [0.0, 4.0] {
        let scene = Given::lying(4.0, 2.5, 10.0, &[(at, 3.0)]).scene();
        let error = solve(&scene).expect_err("nothing carries it").to_string();
        assert!(error.contains(&format!("resultant 3 at x = {at},")) && error.contains("on what gives"), "{error}");
    }
}

/// A support beside a point of the ground, nearer than a place is rounded: the beam between the two has no length and no say.
#[test]
fn a_support_stands_beside_a_point_of_the_ground() {
    let forces = |at: f64| {
        let supports = vec![Support::simple(at).at_level(0.1), Support::simple(2.1).at_level(0.13)];
        let points = vec![[0.0, 0.4], [1.2, 0.7], [2.4, 0.4], [6.0, 0.8]];
        let ground = Some(Foundation::Polyline { points });
        let scene = on_supports([6.0, 130.0], &supports, (5.0, &[(2.6, 14.0)]), ground).on_springs(800.0);
        let solution = solve_exactly(&scene.expect("a scene")).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{at}: {}", solution.verdict);
        solution.state.supports.into_iter().map(|support| support.force).collect::<Vec<_>>()
    };
    for at in [1.2_f64.next_up(), 1.2_f64.next_down()] {
        let alike = |(found, expected): (&f64, &f64)| (found - expected).abs() <= 1e-9 * expected.abs();
        assert!(forces(at).iter().zip(&forces(1.2)).all(alike), "{:?} for {:?}", forces(at), forces(1.2));
    }
}

/// Ground so stiff that the places where it begins to press have no digits left: a search ends after as many solves as its work allows,
/// and does not go on through all stiffnesses up to the given one.
#[test]
fn a_search_on_ground_of_any_stiffness_ends() {
    for stiffness in [1e35, 1e38, 1e40] {
        let linear = vec![LinearLoad { from: 0.2, to: 4.5, start: -0.9, end: 1.3 }];
        let ground = Some(Foundation::Polyline { points: vec![[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [10.0, 1.0]] });
        let Given { draft, .. } = Given::lying(10.0, 1.7, stiffness, &[]);
        let scene = Draft { uniform: 9e-5, linear, ground, ..draft }.scene().expect("a scene");
        let exact = solve(&scene.on_springs(stiffness).expect("ground")).expect("an answer");
        assert!(!exact.solved && exact.iterations < 2500, "{stiffness:e}: {} solves", exact.iterations);
    }
}
