//! The general beam: couples, and bending stiffness in steps. Scenes are files, as a user writes them; numbers of 16 digits come from a 40-digit computation by an
//! engine that shares no code with this one, checked there by finite elements.

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::state::ContactState;
use palkki::verdict::Status;

/// What is asked for beside numbers of 16 digits.
const DIGITS: f64 = 1e-11;

pub(super) fn scene(text: &str) -> Scene {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The exact answer, which has to be certified.
#[track_caller]
pub(super) fn certified(text: &str) -> ContactState {
    let solution = palkki::solve_exactly(&scene(text)).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{text}");
    solution.state
}

#[track_caller]
pub(super) fn check(what: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= DIGITS * expected.abs(), "{what}: {found} instead of {expected}, off by {error:e}");
}

/// `v = −C x (l² − 3 b² − x²)/6 EI l` to the left of a couple at `a = l − b` on two supports: reactions `∓C/l`, and of the beam built in
/// at its left end `v = C x²/2 EI` up to the couple.
#[test]
fn a_couple_on_a_beam_without_ground() {
    for at in [0.0, 1.0, 2.5, 3.0] {
        let couple = format!("[load]\ncouple = [{{ at = {at:?}, moment = 5.0 }}]\n");
        let simple = certified(&format!("[beam]\nlength = 3.0\nbending_stiffness = 2.0\n{couple}"));
        check("force at the left end", simple.reactions.left, -5.0 / 3.0);
        check("force at the right end", simple.reactions.right, 5.0 / 3.0);
        let (a, b) = (at, 3.0 - at);
        check("largest moment", simple.moment.max - simple.moment.min, 5.0);
        // Its work is half of C times the slope there, C (a³ + b³)/3 EI l² on two supports.
        check("energy", simple.energy, -0.5 * 25.0 * (a * a * a + b * b * b) / (3.0 * 2.0 * 9.0));
        if a > 0.0 {
            let wall = "supports = [{ at = 0.0, built_in = true }]\n";
            let held = certified(&format!("[beam]\nlength = 3.0\nbending_stiffness = 2.0\n{wall}{couple}"));
            check("deflection of the tip", held.deflection.max, 5.0 * a * (0.5 * a + b) / 2.0);
            check("moment at the wall", held.supports[0].moment.expect("built in"), -5.0);
        }
    }
}

/// A couple `C` in flat contact under a load `q` lifts the beam over `ℓ = √(2√3 C/q)`, of which `(3 + √3)/6` is on the side towards which
/// it does not turn; the ends of the gap press with these shares of `q ℓ`, the longer side with the lesser one.
#[test]
fn a_couple_opens_a_gap_in_contact() {
    let root = 3.0_f64.sqrt();
    for moment in [1e-9, 1e-4, 0.2, 1.0, -0.3_f64] {
        let load = format!("[load]\nuniform = 1.0\ncouple = [{{ at = 5.0, moment = {moment:?} }}]\n");
        let text = format!("[beam]\nlength = 10.0\nbending_stiffness = 1.3\n{load}[foundation]\ndepth = 1.0\n");
        let state = certified(&text);
        let [left, right] = [&state.contacts[0], &state.contacts[1]];
        let length = (2.0 * root * moment.abs()).sqrt();
        let [long, short] = [(3.0 + root) / 6.0, (3.0 - root) / 6.0];
        let [before, behind] = if moment > 0.0 { [long, short] } else { [short, long] };
        // Places have the digits of the beam.
        for (what, found, expected) in
            [("left part", 5.0 - left.to, before * length), ("right part", right.from - 5.0, behind * length)]
        {
            assert!((found - expected).abs() < 1e-14 * 10.0, "{what}: {found}, not {expected}");
        }
        let [from, to] = [left.end_forces.expect("a zone")[1], right.end_forces.expect("a zone")[0]];
        for (what, found, expected) in [("left force", from, behind * length), ("right force", to, before * length)] {
            assert!((found - expected).abs() < 1e-13 * 10.0, "{what}: {found}, not {expected}");
        }
    }
}

/// Numbers of 16 digits from another engine.
#[test]
fn a_couple_inside_contact() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 1.3020833333333333\n\n[load]\nuniform = 1.0\n\
                couple = [{ at = 5.0, moment = 0.2 }]\n\n[foundation]\ndepth = 1.0\n";
    let state = certified(text);
    for (what, found, expected) in [
        ("reaction", state.reactions.left, 1.182_177_011_253_969_8),
        ("to", state.contacts[0].to, 4.343_539_713_557_742_5),
        ("from", state.contacts[1].from, 5.175_898_003_615_306),
        ("force", state.contacts[0].force, 3.337_260_705_919_079_3),
        ("force", state.contacts[1].force, 4.298_385_271_572_982),
        ("moment", state.moment.max, 0.698_771_242_968_684_3),
        ("moment", state.moment.min, -0.1),
        ("energy", state.energy, -8.109_085_005_252_995),
    ] {
        check(what, found, expected);
    }
}

/// Wherever a couple acts and however large it is, on symmetric grounds and beams: certified, and mirrored the same.
#[test]
fn couples_anywhere_are_certified_and_may_be_mirrored() {
    let grounds = [
        "",
        "[foundation]\ndepth = 0.4\n",
        "[foundation]\npolynomial = [1.1, -0.08, 0.008]\n",
        "[foundation]\npolynomial = [0.6, 0.16, -0.016]\n",
        "[foundation]\npoints = [[0, 0.7], [4, 0.7], [5, 0.4], [6, 0.7], [10, 0.7]]\n",
        "[foundation]\ncosine = { mean = 0.6, amplitude = 0.2, wavelength = 5.0 }\n",
        "[foundation]\ndepth = 0.1\nstiffness = 20.0\n",
    ];
    let held = ["", "supports = []\n", "supports = [{ at = 2.0 }, { at = 8.0 }]\n"];
    for (ground, supports) in grounds.iter().flat_map(|ground| held.map(|supports| (ground, supports))) {
        if ground.is_empty() && supports.contains("[]") {
            continue;
        }
        for (at, moment) in [0.0, 0.5, 2.0, 4.0, 4.7, 5.0].into_iter().flat_map(|at| [1e-3, -0.1, 0.5].map(|c| (at, c)))
        {
            let of = |at: f64, moment: f64| {
                let load = format!("[load]\nuniform = 1.0\ncouple = [{{ at = {at:?}, moment = {moment:?} }}]\n");
                certified(&format!("[beam]\nlength = 10.0\nbending_stiffness = 4.0\n{supports}{load}{ground}"))
            };
            let (one, other) = (of(at, moment), of(10.0 - at, -moment));
            let same = |what: &str, a: f64, b: f64| {
                assert!(
                    (a - b).abs() < 1e-10 * (1.0 + a.abs()),
                    "{what}: {a} and {b}, couple {moment} at {at} on {ground}"
                );
            };
            same("energy", one.energy, other.energy);
            same("moment", one.moment.max, other.moment.max);
            same("moment", one.moment.min, other.moment.min);
            assert_eq!(one.contacts.len(), other.contacts.len());
        }
    }
}

/// Two opposite forces close to each other are a couple, the closer the more so.
#[test]
fn a_couple_is_two_opposite_forces() {
    let of = |load: &str| {
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = 4.0\n[load]\nuniform = 1.0\n{load}[foundation]\npolynomial = [1.1, -0.08, 0.008]\n"
        );
        palkki::theory::solve(&scene(&text)).expect("an answer").state.energy
    };
    let couple = of("couple = [{ at = 3.0, moment = 0.7 }]\n");
    let mut last = f64::INFINITY;
    for distance in [1e-2, 1e-3, 1e-4] {
        let (force, half) = (0.7 / distance, 0.5 * distance);
        let (before, behind) = (3.0 - half, 3.0 + half);
        let pair = format!(
            "point = [{{ at = {before:?}, force = {:?} }}, {{ at = {behind:?}, force = {force:?} }}]\n",
            -force
        );
        let off = (of(&pair) - couple).abs();
        assert!(off < 0.2 * last && off < 10.0 * distance, "{off:e} at a distance of {distance}");
        last = off;
    }
}

/// On finer grids the methods come nearer to the exact energy, with the first order of what a couple does in itself.
#[test]
fn couples_on_grids() {
    use palkki::methods::Method;
    use palkki::solvers::Solver;
    use palkki::{Settings, solve};
    let scene = scene(
        "[beam]\nlength = 10.0\nbending_stiffness = 4.0\n[load]\nuniform = 1.0\ncouple = [{ at = 2.2, moment = 0.7 }, { at = 10.0, moment = -0.4 }]\n\
         [foundation]\npolynomial = [1.1, -0.08, 0.008]\n",
    );
    let exact = palkki::theory::solve(&scene).expect("an answer").state.energy;
    for method in Method::ALL {
        let off = |intervals: usize| {
            let solution = solve(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).expect("an answer");
            (solution.state.energy - exact).abs()
        };
        let [coarse, fine] = [off(20), off(320)];
        assert!(fine < 0.1 * coarse && fine < 2e-3 * exact.abs(), "{method:?}: {coarse:e} and {fine:e} of {exact}");
    }
}

/// A scene with from, to and force of its contacts, and its largest moment, least moment and energy.
type Case<'a> = (&'a str, &'a [[f64; 3]], [f64; 3]);

#[track_caller]
fn check_case((text, contacts, [most, least, energy]): Case<'_>) {
    let state = certified(text);
    // Of a symmetric beam the left half is listed.
    assert!(contacts.len() <= state.contacts.len(), "{text}");
    for (found, [from, to, force]) in state.contacts.iter().zip(contacts) {
        for (what, found, expected) in
            [("from", found.from, *from), ("to", found.to, *to), ("force", found.force, *force)]
        {
            check(what, found, expected);
        }
    }
    check("largest moment", state.moment.max, most);
    assert!((state.moment.min - least).abs() <= DIGITS * most.max(least.abs()), "least moment {}", state.moment.min);
    if energy.is_finite() {
        check("energy", state.energy, energy);
    }
}

/// Scenes with a stiffness in steps, and numbers of 16 digits from another engine: two stiffnesses on flat ground, a ski, a pipe with a
/// thick piece over a sleeper, a step on a wave.
#[test]
fn steps_of_the_bending_stiffness() {
    let flat = "[beam]\nlength = 10.0\nbending_stiffness = { steps = [[0, 1.3020833333333333], [5, 5.208333333333333]] }\n\n[load]\n\
                uniform = 1.0\n\n[foundation]\ndepth = 1.0\n";
    let ski = "[beam]\nlength = 1.8\n\
               bending_stiffness = { steps = [[0, 60.0], [0.4, 150.0], [0.7, 300.0], [1.1, 150.0], [1.4, 60.0]] }\n\
               shape = { polynomial = [0.0, -0.03333333333333333, 0.018518518518518517] }\nsupports = []\n\n[load]\n\
               linear = [{ from = 0.75, to = 1.05, start = 1000.0, end = 1000.0 }]\n\n[foundation]\ndepth = 0.0\n";
    let pipe = "[beam]\nlength = 100.0\nbending_stiffness = { steps = [[0, 8000.0], [46, 14000.0], [54, 8000.0]] }\nsupports = []\n\n\
                [load]\nuniform = 0.5\n\n[foundation]\n\
                points = [[0.0, 0.8], [49.0, 0.8], [49.0, 0.0], [51.0, 0.0], [51.0, 0.8], [100.0, 0.8]]\n";
    let wave = "[beam]\nlength = 12.0\nbending_stiffness = { steps = [[0, 40.0], [4.1, 60.0]] }\n\n[load]\nuniform = 2.0\n\
                linear = [{ from = 6.0, to = 12.0, start = 0.0, end = 3.0 }]\n\n[foundation]\n\
                cosine = { mean = 0.5, amplitude = 0.15, wavelength = 4.0 }\n";
    let cases: [Case<'_>; 4] = [
        (
            flat,
            &[[2.364_354_022_507_939_6, 6.656_298_475_117_889_5, 7.145_972_226_304_975]],
            [1.397_542_485_937_368_6, 0.0, -7.716_777_781_043_98],
        ),
        (
            ski,
            &[
                [0.0, 0.0, 9.158_898_288_244_36],
                [0.363_944_792_094_889_5, 0.363_944_792_094_889_5, 1.166_304_664_040_281_9],
                [0.676_386_234_133_333_7, 0.676_386_234_133_333_7, 41.728_798_215_494_535],
                [0.837_689_491_767_721_6, 0.962_310_508_232_278_5, 195.891_997_664_441_7],
            ],
            [11.746_055_206_260_401, 0.0, f64::NAN],
        ),
        (
            pipe,
            &[[0.0, 17.653_385_524_920_79, 13.967_455_580_375_507], [49.0, 49.0, 11.032_544_419_624_493]],
            [26.427_442_350_058_527, -84.507_049_601_304_5, -25.721_362_261_796_337],
        ),
        (
            wave,
            &[
                [2.254_860_153_354_908_6, 2.254_860_153_354_908_6, 2.786_578_287_300_370_6],
                [6.027_683_425_442_477, 6.027_683_425_442_477, 13.087_720_605_018_548],
                [9.738_981_523_344_58, 9.738_981_523_344_58, 7.493_392_537_594_403],
            ],
            [4.414_199_917_257_202, -5.859_181_261_383_195, -9.287_179_930_948_229],
        ),
    ];
    cases.into_iter().for_each(check_case);
}

/// `P l³/3 EI` by parts, and what is nothing: a step of no height changes no number, nor does any scale of forces.
#[test]
fn a_cantilever_in_steps_and_steps_of_no_height() {
    let wall = "supports = [{ at = 0.0, built_in = true }]\n[load]\npoint = [{ at = 2.0, force = 3.0 }]\n";
    let two =
        certified(&format!("[beam]\nlength = 2.0\nbending_stiffness = {{ steps = [[0, 2.0], [1, 1.0]] }}\n{wall}"));
    check("tip", two.deflection.max, 3.0 * (7.0 / 3.0 / 2.0 + 1.0 / 3.0));
    for ground in [
        "depth = 0.3",
        "polynomial = [0.8, -0.08, 0.008]",
        "cosine = { mean = 0.6, amplitude = 0.2, wavelength = 5.0 }",
    ] {
        let of = |stiffness: &str, times: f64| {
            certified(&format!(
                "[beam]\nlength = 10.0\nbending_stiffness = {stiffness}\n[load]\nuniform = {:?}\n[foundation]\n{ground}\n",
                times
            ))
        };
        let (one, same) = (of("4.0", 1.0), of("{ steps = [[0, 4.0], [3, 4.0]] }", 1.0));
        assert_eq!(one, same, "on {ground}");
        let (stepped, tenfold) =
            (of("{ steps = [[0, 4.0], [3, 6.0]] }", 1.0), of("{ steps = [[0, 40.0], [3, 60.0]] }", 10.0));
        check("ten times all", tenfold.energy, 10.0 * stepped.energy);
        check("ten times all", tenfold.deflection.max, stepped.deflection.max);
    }
}

/// On curved ground a change of the stiffness by `ΔEI` is a couple `ΔEI g''` of the clearance: it opens the gap of such a couple, whose
/// parts are those of `√(2√3 ΔEI g''/p)` as the change gets smaller.
#[test]
fn a_change_of_the_stiffness_on_curved_ground_opens_a_gap() {
    let root = 3.0_f64.sqrt();
    let mut last = f64::INFINITY;
    for change in [1e-2, 1e-3, 1e-4, 1e-5_f64] {
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = {{ steps = [[0, 4.0], [5, {:?}]] }}\nsupports = []\n[load]\nuniform = 1.0\n\
             [foundation]\npolynomial = [0.8, -0.08, 0.008]\n",
            4.0 + change
        );
        let state = certified(&text);
        let at = state.contacts.iter().position(|zone| zone.to < 5.0 && 4.0 < zone.to).expect("a zone up to the gap");
        let (left, right) = (5.0 - state.contacts[at].to, state.contacts[at + 1].from - 5.0);
        let length = (2.0 * root * change * 0.016).sqrt();
        let off =
            (left / ((3.0 + root) / 6.0 * length) - 1.0).abs().max((right / ((3.0 - root) / 6.0 * length) - 1.0).abs());
        assert!(off < 0.5 * last && off < 2.0 * change, "{off:e} for a change of {change}");
        last = off;
    }
}

/// A joint of stiffness `k` in the middle of a beam on two supports turns by `M/k`: `P l³/48 EI + P l²/16 k` under the force above it. One
/// of 10¹² of the beam changes nothing, and one where there is no moment neither.
#[test]
fn a_joint_turns_by_its_moment() {
    let of = |joint: &str| {
        certified(&format!(
            "[beam]\nlength = 4.0\nbending_stiffness = 2.0\n{joint}[load]\npoint = [{{ at = 2.0, force = 3.0 }}]\n"
        ))
    };
    let free = of("");
    for stiffness in [0.5, 3.0, 1e3_f64] {
        let jointed = of(&format!("joints = [{{ at = 2.0, stiffness = {stiffness:?} }}]\n"));
        check("deflection", jointed.deflection.max, 3.0 * 64.0 / 96.0 + 3.0 * 16.0 / (16.0 * stiffness));
        check("energy", jointed.energy, -0.5 * 3.0 * jointed.deflection.max);
    }
    let rigid = of("joints = [{ at = 1.0, stiffness = 2e12 }]\n");
    check("a rigid joint", rigid.deflection.max, free.deflection.max);
    let flat = "[load]\nuniform = 1.0\n[foundation]\ndepth = 0.4\n";
    let in_contact = |joint: &str| certified(&format!("[beam]\nlength = 10.0\nbending_stiffness = 1.3\n{joint}{flat}"));
    let (with, without) = (in_contact("joints = [{ at = 5.0, stiffness = 0.1 }]\n"), in_contact(""));
    check("energy", with.energy, without.energy);
    check("lift-off", with.contacts[0].from, without.contacts[0].from);
}

/// A Gerber beam: statics give its forces, and a bound is proven from the hinge as a support.
#[test]
fn a_hinge_has_no_moment() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 2.0\njoints = [{ at = 6.0 }]\n\
                supports = [{ at = 0.0 }, { at = 4.0 }, { at = 10.0 }]\n[load]\nuniform = 1.0\n";
    let exact = super::solved(&scene(text));
    let forces: Vec<f64> = exact.state.supports.iter().map(|support| support.force).collect();
    // The part beyond the hinge is a simple beam of 4, and its reaction hangs on the other one.
    for (found, expected) in forces.iter().zip([0.5, 7.5, 2.0]) {
        check("reaction", *found, expected);
    }
    check("least moment", exact.state.moment.min, -6.0);
    assert!(exact.moment(6.0).abs() < 1e-14, "{:e}", exact.moment(6.0));
    certified(text);
}

/// What a bending stiffness in steps, a joint and a couple may not be, with words of the message.
#[test]
fn what_is_no_general_beam_is_refused() {
    let wall = "supports = [{ at = 0.0 }, { at = 4.0, built_in = true }]\n";
    for (beam, load, words) in [
        ("bending_stiffness = [[0, 1.3], [4, 2.6]]\n", "", &["bending_stiffness", "steps"][..]),
        ("bending_stiffness = { steps = [[1, 1.3], [4, 2.6]] }\n", "", &["steps[0][0]", "be 0"]),
        ("bending_stiffness = { steps = [[0, 1.3], [4, 2.6], [4, 1.0]] }\n", "", &["steps[2]"]),
        ("bending_stiffness = { steps = [[0, 1.3], [10, 2.6]] }\n", "", &["steps[1][0]", "less than the length"]),
        ("bending_stiffness = { steps = [] }\n", "", &["steps"]),
        ("bending_stiffness = { steps = [[0, 1.3], [4, 0.0]] }\n", "", &["positive", "joints"]),
        ("bending_stiffness = { steps = [[0, 1.3], [4, nan]] }\n", "", &["nan"]),
        ("bending_stiffness = 1.3\njoints = [{ at = 4.0 }, { at = 4.0 }]\n", "", &["joints[1].at"]),
        ("bending_stiffness = 1.3\njoints = [{ at = 0.0 }]\n", "", &["joints[0].at", "inside the beam"]),
        (
            "bending_stiffness = 1.3\njoints = [{ at = 4.0 }]\n",
            "couple = [{ at = 4.0, moment = 1.0 }]\n",
            &["couple[0].at"],
        ),
        (&format!("bending_stiffness = 1.3\njoints = [{{ at = 4.0 }}]\n{wall}"), "", &["built_in"]),
        ("bending_stiffness = 1.3\n", "couple = [{ at = 11.0, moment = 1.0 }]\n", &["couple[0].at"]),
        ("bending_stiffness = 1.3\n", "couple = [{ at = 1.0, force = 1.0 }]\n", &["force"]),
        ("bending_stiffness = 1.3\nsupports = [{ at = 5.0 }]\n", "couple = [{ at = 2.0, moment = 1.0 }]\n", &["turn"]),
        ("bending_stiffness = 1.3\njoints = [{ at = 4.0 }]\n", "uniform = 1.0\n", &["mechanism"]),
    ] {
        let text = format!("[beam]\nlength = 10.0\n{beam}[load]\n{load}");
        let error = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).err().map(|error| error.to_string());
        let Some(message) = error else { panic!("{text}") };
        for word in words {
            assert!(message.to_lowercase().contains(word), "{word} is not in {message}");
        }
    }
}
