//! Beams under an axial force. Numbers of 16 digits come from a 40-digit computation by an engine that shares no code with this one.

mod centred;
mod giving;
mod random;

use std::f64::consts::PI;

use palkki::scene::file::{ReadProblem, parse};
use palkki::sweep::Sweep;
use palkki::theory;
use palkki::verdict::Status;

use super::general::{certified, check, scene};

/// The example under tension.
#[test]
fn the_example_under_tension() {
    let state = certified(
        "[beam]\n\
         length = 10.0\n\
         bending_stiffness = 1.3020833333333333\n\
         tension = 2.0\n\
         [load]\n\
         uniform = 1.0\n\
         [foundation]\n\
         depth = 1.0\n",
    );
    for (what, found, expected) in [
        ("supports[0].force", state.supports[0].force, 2.140_942_276_161_617),
        ("contacts[0].from", state.contacts[0].from, 2.904_901_587_811_188),
        ("contacts[0].force", state.contacts[0].force, 5.718_115_447_676_766),
        ("moment.max", state.moment.max, 0.441_553_455_963_641_7),
        ("energy", state.energy, -6.979_740_129_532_29),
    ] {
        check(what, found, expected);
    }
}

/// A tensioned pipe over a sleeper.
#[test]
fn a_tensioned_pipe_over_a_sleeper() {
    let state = certified(
        "[beam]\n\
         length = 100.0\n\
         bending_stiffness = 8000.0\n\
         tension = 60.0\n\
         supports = []\n\
         [load]\n\
         uniform = 0.5\n\
         [foundation]\n\
         points = [[0.0, 0.8], [49.0, 0.8], [49.0, 0.0], [51.0, 0.0], [51.0, 0.8], [100.0, 0.8]]\n",
    );
    for (what, found, expected) in [
        ("contacts[0].to", state.contacts[0].to, 16.967_794_031_469_023),
        ("contacts[0].force", state.contacts[0].force, 12.825_547_103_138_307),
        ("contacts[1].force", state.contacts[1].force, 12.174_452_896_861_693),
        ("moment.max", state.moment.max, 22.722_144_289_954_855),
        ("moment.min", state.moment.min, -69.442_924_959_588_95),
        ("energy", state.energy, -25.020_484_418_975_14),
    ] {
        check(what, found, expected);
    }
}

/// A ridge under tension.
#[test]
fn a_ridge_under_tension() {
    let state = certified(
        "[beam]\n\
         length = 10.0\n\
         bending_stiffness = 1.3020833333333333\n\
         tension = 1.0\n\
         [load]\n\
         uniform = 1.0\n\
         [foundation]\n\
         points = [[0, 1.0], [3, 1.0], [4, 0.5], [5, 1.0], [10, 1.0]]\n",
    );
    for (what, found, expected) in [
        ("supports[0].force", state.supports[0].force, 1.820_223_584_741_618_4),
        ("supports[1].force", state.supports[1].force, 1.694_684_740_147_637_3),
        ("contacts[0].force", state.contacts[0].force, 4.186_453_502_764_349_5),
        ("contacts[1].from", state.contacts[1].from, 6.773_841_744_834_746),
        ("contacts[1].force", state.contacts[1].force, 2.298_638_172_346_395),
        ("moment.min", state.moment.min, -1.219_105_661_033_527),
        ("energy", state.energy, -5.917_506_539_620_583),
    ] {
        check(what, found, expected);
    }
}

/// Nine tenths of buckling, no contact.
#[test]
fn nine_tenths_of_buckling_no_contact() {
    let state = certified(
        "[beam]\n\
         length = 10.0\n\
         bending_stiffness = 1.0\n\
         tension = -0.08882643960980423\n\
         [load]\n\
         uniform = 0.001\n\
         linear = [{ from = 0.0, to = 10.0, start = 0.0, end = 0.001 }]\n\
         [foundation]\n\
         depth = 3.0\n",
    );
    for (what, found, expected) in [
        ("supports[0].force", state.supports[0].force, 0.006_666_666_666_666_667),
        ("supports[1].force", state.supports[1].force, 0.008_333_333_333_333_333),
        ("deflection.max", state.deflection.max, 1.959_823_872_487_772_6),
        ("moment.max", state.moment.max, 0.192_841_935_379_469_53),
        ("energy", state.energy, -0.009_365_079_892_944_283),
    ] {
        check(what, found, expected);
    }
}

/// Two spans, compressed.
#[test]
fn two_spans_compressed() {
    let state = certified(
        "[beam]\n\
         length = 20.0\n\
         bending_stiffness = 30.0\n\
         tension = -1.5\n\
         supports = [{ at = 0.0 }, { at = 8.0 }, { at = 20.0 }]\n\
         [load]\n\
         uniform = 0.5\n\
         point = [{ at = 4.0, force = 2.0 }]\n\
         [foundation]\n\
         depth = 0.6\n",
    );
    for (what, found, expected) in [
        ("supports[0].force", state.supports[0].force, 1.542_385_967_674_659_9),
        ("supports[1].force", state.supports[1].force, 5.356_166_030_174_944),
        ("contacts[0].from", state.contacts[0].from, 3.577_539_876_213_361_2),
        ("contacts[1].force", state.contacts[1].force, 2.460_999_945_878_613),
        ("deflection.min", state.deflection.min, -0.007_836_658_808_111_375),
        ("moment.max", state.moment.max, 3.688_512_189_677_185),
        ("moment.min", state.moment.min, -5.023_229_472_907_182),
        ("energy", state.energy, -3.578_780_443_110_305),
    ] {
        check(what, found, expected);
    }
}

/// The message of a scene that is refused.
fn refused(text: &str) -> String {
    let error = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).err();
    error.map(|error| error.to_string()).unwrap_or_default()
}

/// A beam of length 10 and stiffness 30 under a uniform load and this axial force.
fn tied(force: f64, more: &str) -> String {
    format!("[beam]\nlength = 10.0\nbending_stiffness = 30.0\ntension = {force:?}\n{more}\n[load]\nuniform = 1.0\n")
}

/// Timoshenko's tie rod: with `u = √(N/EI) l/2`
///
/// ```text
/// M = q l²/4 · (1 − 1/cosh u)/u²·½,    v = (q l²/8 − M)/N,    θ = q l³/EI · (u − tanh u)/8u³,    −2 J = ∫ q v
/// ```
#[test]
fn a_tie_rod_without_ground() {
    for share in [1e-3, 0.5, 7.0, 300.0, 1e4, 1e6_f64] {
        let force = share * 30.0 / 100.0;
        let state = certified(&tied(force, ""));
        let u = 0.5 * share.sqrt();
        // Below u = 0.3 by its series, which the differences would lose.
        let fall = if u < 0.3 {
            series([0.5, -5.0 / 24.0, 61.0 / 720.0, -277.0 / 8064.0], u)
        } else {
            (1.0 - 1.0 / u.cosh()) / (u * u)
        };
        let moment = 100.0 / 4.0 * fall;
        // A difference of numbers that are an eighth of the share as large.
        let rounding = (1e-15 * share).max(1e-11);
        assert!((state.moment.max - moment).abs() <= rounding * moment, "{share}: {} and {moment}", state.moment.max);
        check("reaction", state.reactions.left, 5.0);
        let sag = if u < 0.3 {
            100.0 * 100.0 / 30.0 / 16.0
                * series([5.0 / 24.0, -61.0 / 720.0, 277.0 / 8064.0, -50_521.0 / 3_628_800.0], u)
        } else {
            (100.0 / 8.0 - moment) / force
        };
        assert!((state.deflection.max - sag).abs() <= 1e-9 * sag, "{share}: {} and {sag}", state.deflection.max);
        let slope = 1000.0 / 30.0
            * if u < 0.3 {
                series([1.0 / 24.0, -1.0 / 60.0, 17.0 / 2520.0, -31.0 / 11_340.0], u)
            } else {
                (u - u.tanh()) / (8.0 * u * u * u)
            };
        let exact = theory::solve(&scene(&tied(force, ""))).expect("an answer");
        assert!((exact.slope(0.0) - slope).abs() <= 1e-10 * slope, "{share}: {} and {slope}", exact.slope(0.0));
    }
}

/// `Σ c_k u^2k`.
fn series(coefficients: [f64; 4], u: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * u * u + c)
}

/// The strut: `M = q l²/4 · (1/cos u − 1)/u²`, up to a thousandth below the load at which it buckles.
#[test]
fn a_strut_without_ground() {
    for share in [0.1, 0.5, 0.9, 0.999] {
        let force = -share * PI * PI * 30.0 / 100.0;
        let u = 0.5 * (force.abs() / 30.0).sqrt() * 10.0;
        let moment = 25.0 * (1.0 / u.cos() - 1.0) / (u * u);
        let state = certified(&tied(force, ""));
        let close = 1e-12 / (1.0 - share);
        assert!((state.moment.max - moment).abs() <= close * moment, "{share}: {} and {moment}", state.moment.max);
        let sag = (moment - 12.5) / force.abs();
        assert!((state.deflection.max - sag).abs() <= close * sag, "{share}: {} and {sag}", state.deflection.max);
    }
}

/// A cable on the ground: the part that hangs between a support and level ground `d` deeper is a parabola, `x₀² = 2 N d/q`, but for two
/// layers of the length `1/μ`, in which it turns at the ground.
#[test]
fn a_cable_lies_on_the_ground() {
    let force: f64 = 3.0e5;
    let state = certified(&format!("{}[foundation]\ndepth = 1e-5\n", tied(force, "")));
    let layer = (30.0 / force).sqrt();
    let hangs = (2.0 * force * 1e-5_f64).sqrt();
    let [zone] = &state.contacts[..] else { panic!("{:?}", state.contacts) };
    assert!((zone.from - hangs).abs() < 2.0 * layer, "{} and {hangs}", zone.from);
    // The support and the end of the zone carry what hangs.
    check("reaction", state.reactions.left, zone.from - zone.end_forces.expect("a zone")[0]);
}

/// Without the key, with zero, and with next to nothing: the same, to the last bit or to rounding.
#[test]
fn no_axial_force_is_none() {
    for more in
        ["", "joints = [{ at = 4.0, stiffness = 9.0 }]", "supports = []", "supports = [{ at = 1.0 }, { at = 8.0 }]"]
    {
        for ground in ["", "[foundation]\ndepth = 1.0\n", "[foundation]\npoints = [[0, 1.5], [4, 0.5], [10, 1.5]]\n"] {
            if ground.is_empty() && more.contains("[]") {
                continue;
            }
            let with = |force: f64| certified(&format!("{}{ground}", tied(force, more)));
            let none = certified(&format!("{}{ground}", tied(0.0, more)).replace("tension = 0.0\n", ""));
            assert_eq!(with(0.0), none, "{more} {ground}");
            for force in [1e-14, -1e-14].into_iter().filter(|force| 0.0 < *force || !more.contains("[]")) {
                let next = with(force);
                let same =
                    |a: f64, b: f64| assert!((a - b).abs() <= 1e-12 * (1.0 + a.abs()), "{a} and {b}: {more} {ground}");
                same(next.energy, none.energy);
                same(next.moment.max, none.moment.max);
                same(next.deflection.max, none.deflection.max);
                assert_eq!(next.contacts.len(), none.contacts.len());
                next.supports.iter().zip(&none.supports).for_each(|(a, b)| same(a.force, b.force));
            }
        }
    }
}

/// Stiffness, axial force, loads and stiffness of joints ten times as large: the same deflection. And deflections fall as tension grows.
#[test]
fn an_axial_force_scales_with_the_stiffness() {
    let of = |size: f64, share: f64| {
        let (stiffness, force, joint) = (size * 30.0, size * share, size * 5.0);
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = {stiffness:?}\ntension = {force:?}\n\
             joints = [{{ at = 7.0, stiffness = {joint:?} }}]\n[load]\nuniform = {size:?}\n[foundation]\ndepth = 2.0\n"
        );
        certified(&text)
    };
    let mut last = f64::INFINITY;
    for share in [-0.5, 0.0, 1.0, 20.0, 800.0] {
        let [one, ten] = [1.0, 10.0].map(|size| of(size, share));
        check("deflection", ten.deflection.max, one.deflection.max);
        check("energy", ten.energy, 10.0 * one.energy);
        assert!(one.deflection.max <= last);
        last = one.deflection.max;
    }
}

/// Tension holds a beam that nothing else does: on one support, whatever its loads, and on the ground with its resultant beyond it.
#[test]
fn tension_holds_against_turning() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 30.0\ntension = 20.0\nsupports = [{ at = 2.0 }]\n\
                [load]\npoint = [{ at = 7.0, force = 1.0 }]\n";
    let state = certified(text);
    check("reaction", state.supports[0].force, 1.0);
    let bearings = "supports = [{ at = 3.0, pushes_only = true }, { at = 5.0, pushes_only = true }]";
    let beyond = text.replace("supports = [{ at = 2.0 }]", bearings);
    let state = certified(&beyond);
    let [left, right] = [0, 1].map(|i| state.supports[i].force);
    assert!((left + right - 1.0).abs() < 1e-12 && 0.0 <= left && 0.0 < right, "{left} and {right}");
    // Without it the beam turns over its support.
    assert!(refused(&beyond.replace("tension = 20.0\n", "")).contains("turns over"));
    assert!(refused(&beyond.replace("force = 1.0", "force = -1.0")).contains("pull upwards"));
}

/// Compression beyond what the beam bears, to six digits of the force at which it buckles; of a beam that is not held at all.
#[test]
fn what_buckles_is_refused() {
    let ground = "[foundation]\ndepth = 1.0\n";
    let of_beam = |force: f64, beam: &str| format!("{}{ground}", tied(force, beam));
    for (beam, at) in [
        ("", PI * PI * 0.3),
        ("supports = [{ at = 0.0, built_in = true }]", PI * PI * 0.3 / 4.0),
        ("supports = [{ at = 0.0, built_in = true }, { at = 10.0, built_in = true }]", 4.0 * PI * PI * 0.3),
        // tan u = u.
        ("supports = [{ at = 0.0, built_in = true }, { at = 10.0 }]", 20.190_728_556_426_63 * 0.3),
        ("supports = [{ at = 0.0 }, { at = 5.0 }, { at = 10.0 }]", 4.0 * PI * PI * 0.3),
        // An elastic joint in the middle: `u tan u = k l/EI`, here 1, with `u² = N l²/4 EI`.
        ("joints = [{ at = 5.0, stiffness = 3.0 }]", 4.0 * 0.3 * 0.860_333_589_019_379_8_f64.powi(2)),
    ] {
        let of = |force: f64| of_beam(force, beam);
        assert!(refused(&of(-at * (1.0 - 1e-9))).is_empty(), "{beam}: {}", refused(&of(-at * (1.0 - 1e-9))));
        let message = refused(&of(-at * (1.0 + 1e-9)));
        let rounded: f64 = format!("{at:.3e}").parse().expect("a number");
        assert!(message.contains("the beam buckles at") && message.contains(&format!("-{rounded}")), "{message}");
    }
    // On two springs it tilts at `k₁ k₂ l/(k₁ + k₂)`, however stiff it is.
    let tilts = "supports = [{ at = 0.0, stiffness = 0.3 }, { at = 10.0, stiffness = 0.1 }]";
    assert!(refused(&of_beam(-0.75 * (1.0 - 1e-9), tilts)).is_empty());
    assert!(refused(&of_beam(-0.75 * (1.0 + 1e-9), tilts)).contains("buckles at -0.75"));
    for beam in ["supports = []", "supports = [{ at = 3.0 }]", "joints = [{ at = 5.0 }]"] {
        let message = refused(&format!("{}{ground}", tied(-0.01, beam)));
        assert!(message.contains("`beam.tension`") && message.contains("support"), "{message}");
    }
}

/// A sweep over the axial force has its events, and ends where the beam buckles.
#[test]
fn a_sweep_over_the_axial_force() {
    let scene = scene(&format!("{}[foundation]\ndepth = 0.9\n", tied(0.0, "")));
    let sweep = Sweep::new(&scene, "beam.tension", [-2.5, 15.0], 16).expect("a sweep");
    let rows = sweep.rows().expect("answers");
    assert!(rows.iter().all(|row| row.solution.verdict.status == Status::Certified));
    let values: Vec<f64> = sweep.events(&rows).iter().map(|event| event.value).collect();
    // From a zone to a point where `h'' = 0` in the middle, and to none where the sag is 0.9.
    assert_eq!(values.len(), 2, "{values:?}");
    let apart = |force: f64| {
        palkki::solve_exactly(&scene.with_number(sweep.quantity(), force).expect("a scene")).expect("an answer")
    };
    let last = values[1];
    assert_eq!(apart(last - 1e-6).state.contacts.len(), 1);
    assert!(apart(last + 1e-6).state.contacts.is_empty());
    // Rows go on to where it buckles, in both directions.
    let at = -PI * PI * 0.3;
    let beyond = Sweep::new(&scene, "beam.tension", [0.0, -4.0], 9).expect("a sweep");
    let rows = beyond.rows().expect("answers");
    assert_eq!(rows.len(), 6, "to -2.5");
    let last = beyond.events(&rows).pop().expect("it buckles");
    assert!(last.what == "the beam buckles" && (last.value - at).abs() < 1e-11, "{last:?}");
    let back = Sweep::new(&scene, "beam.tension", [-4.0, 0.0], 9).expect("a sweep");
    let message = back.rows().err().map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("buckles"), "{message}");
    let (mut walk, mut rows) = (back.walk(), Vec::new());
    for value in back.values() {
        rows.extend(walk.solve(value).ok().map(|step| walk.row(step)));
    }
    let first = back.events(&rows).swap_remove(0);
    assert!(first.what == "the beam no longer buckles" && (first.value - at).abs() < 1e-11, "{first:?}");
}
