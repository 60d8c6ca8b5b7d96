//! Supports that give: springs against sinking and turning, and elastic stops. Scenes are files, as a user writes them.

mod elements;
mod random;

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::state::ContactState;
use palkki::verdict::Status;

/// What is asked for beside numbers of 16 digits and closed forms.
const DIGITS: f64 = 1e-11;

fn read(text: &str) -> Result<Scene, String> {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).map_err(|error| error.to_string())
}

/// The exact answer, which has to be certified.
#[track_caller]
fn certified(text: &str) -> ContactState {
    let scene = read(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let solution = palkki::solve_exactly(&scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}\n{text}", solution.verdict);
    solution.state
}

/// A beam of length 10 with `EI = 2` on some supports.
fn beam(supports: &str, rest: &str) -> String {
    format!("[beam]\nlength = 10.0\nbending_stiffness = 2.0\nsupports = [{supports}]\n{rest}")
}

#[track_caller]
fn check(what: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= DIGITS * expected.abs(), "{what}: {found} instead of {expected}, off by {error:e}");
}

const UNIFORM: &str = "[load]\nuniform = 1.0\n";

/// A scene with the forces of its supports, its contacts from, to and force, and its largest moment, least moment and energy.
type Case<'a> = (&'a str, &'a [f64], &'a [[f64; 3]], [f64; 3]);

/// Scenes with springs, and numbers of 16 digits from a 40-digit computation by an engine that shares no code with this one: an end held by
/// a turning spring, springs with steps and an overhang, three springs under a couple.
#[test]
fn springs_on_rigid_ground() {
    let turning = "[beam]\nlength = 10.0\nbending_stiffness = 1.3020833333333333\n\
                   supports = [{ at = 0.0, turning_stiffness = 3.0 }, { at = 10.0 }]\n\n[load]\nuniform = 1.0\n\n[foundation]\ndepth = 1.0\n";
    let overhang = "[beam]\nlength = 10.0\nbending_stiffness = { steps = [[0, 2.0], [4, 1.0], [7, 4.0]] }\n\
                    supports = [{ at = 1.0, stiffness = 2.0, level = 0.1 }, { at = 6.0, stiffness = 8.0, turning_stiffness = 5.0, slope = 0.01 }]\n\n\
                    [load]\nuniform = 0.3\npoint = [{ at = 10.0, force = 1.0 }]\n\n[foundation]\ndepth = 1.0\n";
    let three = "[beam]\nlength = 10.0\nbending_stiffness = 30.0\n\
                 supports = [{ at = 0.0, stiffness = 4.0 }, { at = 5.0, stiffness = 2.0 }, { at = 10.0, stiffness = 4.0 }]\n\n\
                 [load]\nuniform = 1.0\ncouple = [{ at = 7.0, moment = -3.0 }]\n\n[foundation]\ndepth = 1.5\n";
    let cases: [Case<'_>; 3] = [
        (
            turning,
            &[1.773_290_194_932_917, 1.182_177_011_253_969_8],
            &[[2.825_953_059_867_156_3, 7.635_645_977_492_061, 7.044_532_793_813_113]],
            [0.698_771_242_968_684_3, -1.018_229_504_116_831_2, -7.670_185_945_818_957],
        ),
        (
            overhang,
            &[0.924_117_018_936_323_4, 1.633_752_030_014_169_7],
            &[[10.0, 10.0, 1.442_130_951_049_506_8]],
            [0.499_203_422_209_938_46, -0.779_414_905_318_382_9, -2.231_453_179_516_192_3],
        ),
        (
            three,
            &[2.509_648_990_790_862_6, 2.999_354_121_945_154, 2.005_643_408_406_336],
            &[[4.806_879_748_832_356, 4.806_879_748_832_356, 2.485_353_478_857_647_7]],
            [4.516_930_225_219_007, 0.0, -8.156_006_678_399_653],
        ),
    ];
    for (text, supports, contacts, [most, least, energy]) in cases {
        let state = certified(text);
        for (found, expected) in state.supports.iter().zip(supports) {
            check("force of a support", found.force, *expected);
        }
        for (found, [from, to, force]) in state.contacts.iter().zip(contacts) {
            check("from", found.from, *from);
            check("to", found.to, *to);
            check("force", found.force, *force);
        }
        assert_eq!([state.supports.len(), state.contacts.len()], [supports.len(), contacts.len()]);
        check("largest moment", state.moment.max, most);
        assert!((state.moment.min - least).abs() <= DIGITS * most, "least moment {}", state.moment.min);
        check("energy", state.energy, energy);
    }
}

/// On two springs a beam is that on two supports, moved and turned: `−2J = q² l⁵/120 EI + (q l/2)² (1/k₁ + 1/k₂)`. On one that holds the slope
/// as well the tip of a beam of length `l` sinks by `q l/k + q l³/2 k_t + q l⁴/8 EI`.
#[test]
fn springs_alone_hold_a_beam() {
    for [k, other] in [[1e-6, 2e-6], [0.3, 7.0], [4.0, 4.0], [1e9, 0.5]] {
        let two = format!("{{ at = 0, stiffness = {k:?} }}, {{ at = 10, stiffness = {other:?} }}");
        let state = certified(&beam(&two, UNIFORM));
        check("energy on two springs", state.energy, -0.5 * (1e5 / 240.0 + 25.0 / k + 25.0 / other));
        check("force", state.reactions.left, 5.0);
        let one = format!("{{ at = 0, stiffness = {k:?}, turning_stiffness = {other:?} }}");
        let state = certified(&beam(&one, UNIFORM));
        check("tip on one", state.deflection.max, 10.0 / k + 500.0 / other + 1e4 / 16.0);
        check("moment", state.supports[0].moment.expect("it holds the slope"), -50.0);
        let middle = format!("{{ at = 5, stiffness = {k:?}, turning_stiffness = {other:?} }}");
        let state = certified(&beam(&middle, UNIFORM));
        check("both tips", state.deflection.max, 10.0 / k + 625.0 / 16.0);
    }
}

/// What was lifted does not pull when contacts are carried over to another scene, and the beam does not go through it.
#[test]
fn a_stop_that_is_lifted_stays_lifted_in_a_scene_beside() {
    let of = |load: f64| {
        let stop = "{ at = 0 }, { at = 5, stiffness = 100.0, pushes_only = true, level = 0.5 }, { at = 10 }";
        super::general::scene(&beam(stop, &format!("[load]\nuniform = {load:?}\n")))
    };
    let sag = |scene: &palkki::scene::Scene| palkki::theory::solve(scene).expect("an answer").deflection(5.0);
    let lifted = 0.5 / sag(&of(0.001)) * 0.001;
    let [near, beside, beyond] = [0.8, 0.9, 1.1].map(|share| of(share * lifted));
    let exact = palkki::theory::solve(&near).expect("an answer");
    let moved = exact.moved(&beside).expect("the same contacts");
    assert_eq!(moved.state.supports[1].force.to_bits(), 0.0_f64.to_bits());
    super::general::check("deflection", moved.deflection(5.0), sag(&beside));
    assert!(exact.moved(&beyond).is_none(), "it comes down on the stop");
}

/// A stop with a play `d` below the middle of a beam on two supports: `R = (5 q l⁴/384 EI − d)/(l³/48 EI + 1/k)`, or nothing.
#[test]
fn a_stop_is_pressed_beyond_its_play() {
    let sag: f64 = 5.0 * 1e4 / 768.0;
    for (k, play) in [0.1, 3.0, 1e6_f64].into_iter().flat_map(|k| [-1.0, 0.0, 10.0, 65.0, 66.0, 1e3].map(|d| (k, d))) {
        let stop = format!(
            "{{ at = 0 }}, {{ at = 5, stiffness = {k:?}, level = {play:?}, pushes_only = true }}, {{ at = 10 }}"
        );
        let state = certified(&beam(&stop, UNIFORM));
        let force = ((sag - play) / (1e3 / 96.0 + 1.0 / k)).max(0.0);
        assert!((state.supports[1].force - force).abs() <= DIGITS * 10.0, "{} for {force}", state.supports[1].force);
    }
}

/// Stops alone carry a beam that its loads press on them, and let it go where they would have to pull.
#[test]
fn stops_alone_carry_a_beam() {
    let stops = "{ at = 1, stiffness = 2.0, pushes_only = true }, { at = 6, stiffness = 3.0, pushes_only = true }, \
                 { at = 9, stiffness = 5.0, level = 0.5, pushes_only = true }";
    let pressed = certified(&beam(stops, "[load]\npoint = [{ at = 3.0, force = 4.0 }]\n"));
    let forces: Vec<f64> = pressed.supports.iter().map(|support| support.force).collect();
    check("left", forces[0], 4.0 * 3.0 / 5.0);
    check("right", forces[1], 4.0 * 2.0 / 5.0);
    assert!(forces[2].abs() <= 0.0);
}

/// A support is a spring of `10¹²` times the stiffness of the beam, and being built in is one against turning.
#[test]
fn stiff_springs_are_supports() {
    for ground in ["", "[foundation]\ndepth = 0.9\n", "[foundation]\npolynomial = [1.1, -0.08, 0.008]\n"] {
        let load = format!("[load]\nuniform = 1.0\npoint = [{{ at = 3.0, force = 2.0 }}]\n{ground}");
        let of = |supports: &str| certified(&beam(supports, &load));
        let rigid = of("{ at = 1, built_in = true, slope = 0.01 }, { at = 6, level = 0.2 }, { at = 9 }");
        for stiff in [
            "{ at = 1, built_in = true, slope = 0.01 }, { at = 6, level = 0.2, stiffness = 2e12 }, { at = 9, stiffness = 2e12 }",
            "{ at = 1, turning_stiffness = 2e12, slope = 0.01 }, { at = 6, level = 0.2 }, { at = 9 }",
            "{ at = 1, stiffness = 2e12, turning_stiffness = 2e12, slope = 0.01 }, { at = 6, level = 0.2 }, { at = 9, stiffness = 2e12 }",
        ] {
            let found = of(stiff);
            check("energy", found.energy, rigid.energy);
            check("largest moment", found.moment.max, rigid.moment.max);
            check("least moment", found.moment.min, rigid.moment.min);
            for (a, b) in found.supports.iter().zip(&rigid.supports) {
                assert!((a.force - b.force).abs() <= DIGITS * 10.0, "{} for {}", a.force, b.force);
            }
        }
    }
}

/// From no spring to a support: the energy grows with the stiffness, between that of the beam without and that with a support.
#[test]
fn energy_grows_with_the_stiffness() {
    let ends = "{ at = 0 }, { at = 10 }";
    for (kind, held) in [("stiffness", ""), ("turning_stiffness", ", built_in = true")] {
        let rest = format!("{UNIFORM}[foundation]\ndepth = 1.0\n");
        let of = |support: &str| certified(&beam(&format!("{ends}, {{ at = 4{support} }}"), &rest)).energy;
        let bare = if kind == "stiffness" { certified(&beam(ends, &rest)).energy } else { of("") };
        let mut last = bare;
        for power in -6..8 {
            let energy = of(&format!(", {kind} = {:?}", 10.0_f64.powi(power)));
            assert!(last * (1.0 + DIGITS) < energy, "{energy} after {last} for {kind} 1e{power}");
            last = energy;
        }
        assert!(last < of(held), "{kind}");
    }
}

/// A spring that stands where a zone of contact would be lifts the beam off around it if it pushes, and one that pulls is a load on the
/// ground.
#[test]
fn springs_in_contact() {
    let ground = format!("{UNIFORM}[foundation]\ndepth = 1.0\n");
    let of = |level: f64| {
        certified(&beam(
            &format!("{{ at = 0 }}, {{ at = 5, stiffness = 0.2, level = {level:?} }}, {{ at = 10 }}"),
            &ground,
        ))
    };
    let pulls = of(1.5);
    let [zone] = pulls.contacts[..] else { panic!("{:?}", pulls.contacts) };
    check("the spring pulls", pulls.supports[1].force, -0.1);
    let contact = pulls.contact_force() + pulls.supports.iter().map(|support| support.force).sum::<f64>();
    check("balance", contact, 10.0);
    assert!(zone.from < 5.0 && 5.0 < zone.to);
    let pushes = of(0.5);
    let [left, right] = pushes.contacts[..] else { panic!("{:?}", pushes.contacts) };
    check("it is symmetric", 10.0 - right.from, left.to);
    assert!(pushes.supports[1].force < 0.1 && left.to < 5.0, "{:?}", pushes.supports);
}

/// A symmetric beam that touches just where a spring is.
#[test]
fn a_contact_on_a_spring() {
    let springs = "{ at = 0, stiffness = 4.0 }, { at = 5, stiffness = 2.0 }, { at = 10, stiffness = 4.0 }";
    let text = beam(springs, "[load]\nuniform = 1.0\n[foundation]\npoints = [[0, 2.5], [5, 1.2], [10, 2.5]]\n");
    let state = certified(&text.replace("bending_stiffness = 2.0", "bending_stiffness = 200.0"));
    check("the spring", state.supports[1].force, 2.4);
    check("the contact", state.contacts[0].from, 5.0);
    check("balance", state.contact_force() + 2.4 + 2.0 * state.reactions.left, 10.0);
}

/// A stiff spring against turning at the end of a span that is lifted clear of the ground by its rounding. The energy is one of a proof in
/// fractions, by a checker that shares no code with this one; a lift that turned the spring excluded it by 3e-12.
#[test]
fn a_lift_turns_no_spring() {
    const ENERGY: f64 = -12.483_933_046_387_317;
    let text = "[beam]\nlength = 8.0\nbending_stiffness = { steps = [[0.0, 0.000030517578125], [5.5, 1.0]] }\n\
                supports = [{ at = 0.0 }, { at = 8.0, turning_stiffness = 131072.0 }]\n[load]\nuniform = 1.0\n\
                [foundation]\ndepth = 2.0\n";
    let solution = palkki::solve_exactly(&read(text).expect("a scene")).expect("an answer");
    let certificate = solution.verdict.certificate.expect("bounds");
    let [least, most] = [certificate.energy_lower, certificate.energy_upper];
    assert!(least <= ENERGY && ENERGY <= most, "[{least}, {most}] excludes {ENERGY}");
    assert!(most - least <= DIGITS * ENERGY.abs(), "[{least}, {most}] is wide");
}

/// Ten times the stiffness of all and ten times the loads: the same deflection.
#[test]
fn all_ten_times() {
    let of = |times: f64| {
        let scaled = |value: f64| value * times;
        certified(&format!(
            "[beam]\nlength = 10.0\nbending_stiffness = {:?}\n\
             supports = [{{ at = 1.0, stiffness = {:?} }}, {{ at = 6.0, stiffness = {:?}, turning_stiffness = {:?}, slope = 0.01 }}]\n\
             [load]\nuniform = {:?}\n[foundation]\ndepth = 1.0\n",
            scaled(2.0),
            scaled(3.0),
            scaled(8.0),
            scaled(5.0),
            scaled(0.4)
        ))
    };
    let (one, ten) = (of(1.0), of(10.0));
    check("deflection", ten.deflection.max, one.deflection.max);
    check("energy", ten.energy, 10.0 * one.energy);
    check("force", ten.supports[0].force, 10.0 * one.supports[0].force);
}

/// What a support that gives may not be, with words of the message.
#[test]
fn what_is_no_spring_is_refused() {
    for (supports, joints, words) in [
        ("{ at = 0.0, built_in = true, stiffness = 2.0 }, { at = 10.0 }", "", &["built_in", "turning_stiffness"][..]),
        (
            "{ at = 0.0, built_in = true, turning_stiffness = 2.0 }, { at = 10.0 }",
            "",
            &["turning_stiffness", "built_in"],
        ),
        ("{ at = 0.0, stiffness = 0.0 }, { at = 10.0 }", "", &["supports[0].stiffness", "positive"]),
        ("{ at = 10.0 }, { at = 0.0, stiffness = -1.0 }", "", &["supports[1].stiffness", "positive"]),
        ("{ at = 0.0, turning_stiffness = 0.0 }, { at = 10.0 }", "", &["supports[0].turning_stiffness", "positive"]),
        ("{ at = 0.0, stiffness = nan }, { at = 10.0 }", "", &["nan"]),
        ("{ at = 0.0, stiffness = 'soft' }, { at = 10.0 }", "", &["supports[0].stiffness", "number"]),
        ("{ at = 0.0, stiffness = 2.0, slope = 0.1 }, { at = 10.0 }", "", &["slope", "turning_stiffness"]),
        (
            "{ at = 0.0 }, { at = 5.0, turning_stiffness = 2.0, pushes_only = true }, { at = 10.0 }",
            "",
            &["turning_stiffness"],
        ),
        ("{ at = 0.0 }, { at = 4.0, turning_stiffness = 2.0 }", "joints = [{ at = 4.0 }]\n", &["joints[0].at"]),
        ("{ at = 4.0, stiffness = 2.0 }", "", &["turn", "4"]),
        ("{ at = 4.0, stiffness = 2.0, pushes_only = true }", "", &["turns over"]),
        ("{ at = 5.0, stiffness = 2.0 }", "", &["5", "rest"]),
        ("{ at = 0.0, stiffness = 1e300 }, { at = 10.0 }", "joints = [{ at = 4.0 }]\n", &["mechanism"]),
    ] {
        let text =
            format!("[beam]\nlength = 10.0\nbending_stiffness = 1.3\n{joints}supports = [{supports}]\n{UNIFORM}");
        let Err(message) = read(&text) else { panic!("{text}") };
        for word in words {
            assert!(message.to_lowercase().contains(word), "{word} is not in {message}");
        }
    }
}

/// What holds a beam together does so alone: two springs, a spring that is one against turning as well, a support and a turning spring.
#[test]
fn springs_hold_a_beam() {
    for supports in [
        "{ at = 1.0, stiffness = 2.0 }, { at = 7.0, stiffness = 2.0 }",
        "{ at = 1.0, stiffness = 2.0 }, { at = 7.0 }",
        "{ at = 1.0, stiffness = 2.0, turning_stiffness = 3.0 }",
        "{ at = 1.0, turning_stiffness = 3.0, slope = 0.1 }",
    ] {
        assert!(read(&beam(supports, UNIFORM)).expect("a scene").beam().is_held(), "{supports}");
    }
}
