//! Axial forces with hinges, supports that give and ground that gives. Numbers of 16 digits come from an engine that shares no code with this
//! one.

use super::tied;
use crate::theory::general::{certified, check};

/// A number of an answer.
fn number(state: &palkki::state::ContactState, what: &str) -> f64 {
    let index = |of: &str| -> usize { what[of.len() + 1..of.len() + 2].parse().expect("a number") };
    match what {
        "deflection.max" => state.deflection.max,
        "deflection.min" => state.deflection.min,
        "moment.max" => state.moment.max,
        "moment.min" => state.moment.min,
        "energy" => state.energy,
        _ if what.starts_with("supports") => state.supports[index("supports")].force,
        _ if what.ends_with("from") => state.contacts[index("contacts")].from,
        _ if what.ends_with("to") => state.contacts[index("contacts")].to,
        _ => state.contacts[index("contacts")].force,
    }
}

fn has(text: &str, numbers: &[(&str, f64)]) {
    let state = certified(text);
    for (what, expected) in numbers {
        check(what, number(&state, what), *expected);
    }
}

/// Under tension on soft ground.
#[test]
fn under_tension_on_soft_ground() {
    has(
        "[beam]\nlength = 10.0\nbending_stiffness = 1.3020833333333333\ntension = 30.0\n\
         [load]\nuniform = 1.0\npoint = [{ at = 4.0, force = 1.0 }]\n\
         [foundation]\ndepth = 0.05\nstiffness = { steps = [[0, 20.0], [6, 5.0]] }\n",
        &[
            ("supports[0].force", 2.185_363_371_090_343),
            ("supports[1].force", 2.611_805_834_205_421_6),
            ("contacts[0].from", 0.882_601_864_344_234_7),
            ("contacts[0].to", 9.322_283_832_015_344),
            ("contacts[0].force", 6.202_830_794_704_235),
            ("deflection.max", 0.127_879_121_905_591_56),
            ("moment.max", 0.089_877_342_543_327_52),
            ("moment.min", -0.014_798_783_015_676_416),
            ("energy", -0.672_563_812_564_155_5),
        ],
    );
}

/// Springs under tension on flat ground.
#[test]
fn springs_under_tension_on_flat_ground() {
    has(
        "[beam]\nlength = 10.0\nbending_stiffness = 30.0\ntension = 20.0\n\
         supports = [{ at = 0.0, stiffness = 50.0 }, { at = 7.0, stiffness = 3.0, turning_stiffness = 40.0, slope = 0.02 }, \
         { at = 10.0, turning_stiffness = 9.0 }]\n\
         [load]\nuniform = 1.0\ncouple = [{ at = 8.5, moment = 2.0 }]\n[foundation]\ndepth = 0.3\n",
        &[
            ("supports[0].force", 3.286_825_078_002_144_6),
            ("supports[1].force", 0.700_456_184_837_349_8),
            ("supports[2].force", 4.525_400_800_156_93),
            ("contacts[0].force", 1.487_317_937_003_574_5),
            ("contacts[0].from", 4.150_955_779_350_011),
            ("moment.max", 1.850_692_008_449_987),
            ("moment.min", -0.903_535_391_576_772),
            ("energy", -1.194_767_176_140_096_9),
        ],
    );
}

/// A hinge and an elastic joint under tension above a ridge, with a zone that ends in the hinge.
#[test]
fn hinges_under_tension_above_a_ridge() {
    let state = certified(
        "[beam]\nlength = 10.0\nbending_stiffness = { steps = [[0, 1.3], [6, 2.6]] }\ntension = 3.0\n\
         joints = [{ at = 2.0, stiffness = 2.0 }, { at = 7.5 }]\n[load]\nuniform = 1.0\n\
         [foundation]\npoints = [[0, 1.0], [3, 1.0], [4, 0.5], [5, 1.0], [10, 1.0]]\n",
    );
    check("contacts[0].force", state.contacts[0].force, 4.199_171_220_141_743);
    check("contacts[1].from", state.contacts[1].from, 7.068_413_843_113_673);
    check("contacts[1].to", state.contacts[1].to, 7.5);
    check("contacts[1].end_forces", state.contacts[1].end_forces.expect("a zone")[0], 0.733_481_706_542_200_4);
}

/// Compression on springs with overhangs.
#[test]
fn compression_on_springs_with_overhangs() {
    has(
        "[beam]\nlength = 10.0\nbending_stiffness = 30.0\ntension = -1.0\n\
         supports = [{ at = 1.0, stiffness = 5.0 }, { at = 6.0, stiffness = 3.0, turning_stiffness = 40.0 }]\n\
         [load]\nuniform = 1.0\npoint = [{ at = 8.0, force = 2.0 }]\n",
        &[
            ("supports[0].force", 2.762_573_900_995_902_5),
            ("supports[1].force", 9.237_426_099_004_097),
            ("deflection.max", 6.792_471_988_330_408),
            ("deflection.min", -0.125_928_033_569_113),
            ("moment.max", 3.000_007_543_589_589_4),
            ("moment.min", -15.713_329_955_329_039),
            ("energy", -19.038_707_902_996_162),
        ],
    );
}

/// Tension on soft ground with a hole, a hinge, a joint and a couple.
#[test]
fn tension_on_soft_ground_with_a_hole() {
    has(
        "[beam]\nlength = 12.0\nbending_stiffness = { steps = [[0, 30.0], [6, 60.0]] }\ntension = 40.0\n\
         joints = [{ at = 4.0 }, { at = 8.0, stiffness = 30.0 }]\n\
         supports = [{ at = 0.0, stiffness = 10.0 }, { at = 12.0, turning_stiffness = 20.0 }]\n\
         [load]\nuniform = 1.0\ncouple = [{ at = 3.0, moment = 4.0 }]\n\
         [foundation]\ndepth = 0.1\nstiffness = { steps = [[0, 50.0], [5, 0.0], [7, 15.0]] }\n",
        &[
            ("supports[0].force", 0.955_740_574_253_817_6),
            ("supports[1].force", 3.735_937_246_416_474),
            ("contacts[0].from", 0.525_662_781_967_015_7),
            ("contacts[1].to", 9.910_166_980_224_641),
            ("deflection.max", 0.170_464_995_681_206_9),
            ("moment.max", 1.824_526_735_231_015),
            ("moment.min", -2.175_473_264_768_984_7),
            ("energy", -1.182_553_783_331_886_9),
        ],
    );
}

/// Compression on soft ground with an overhang.
#[test]
fn compression_on_soft_ground_with_an_overhang() {
    has(
        "[beam]\nlength = 12.0\nbending_stiffness = 30.0\ntension = -0.5\nsupports = [{ at = 1.0 }, { at = 9.0 }]\n\
         [load]\nuniform = 1.0\npoint = [{ at = 5.0, force = 2.0 }]\n[foundation]\ndepth = 0.3\nstiffness = 5.0\n",
        &[
            ("supports[0].force", 3.235_736_968_477_382),
            ("supports[1].force", 6.614_230_165_749_784),
            ("contacts[0].from", 2.291_718_825_139_828_4),
            ("contacts[0].to", 7.100_853_159_294_77),
            ("deflection.max", 0.566_449_651_194_512_8),
            ("deflection.min", -0.240_081_708_813_839_67),
            ("moment.max", 3.418_815_683_144_584),
            ("moment.min", -4.556_062_509_894_559),
            ("energy", -2.518_246_955_923_478_6),
        ],
    );
}

/// A free beam under tension on a soft wave.
#[test]
fn a_free_beam_under_tension_on_a_soft_wave() {
    has(
        "[beam]\nlength = 20.0\nbending_stiffness = 4.0\ntension = 6.0\nsupports = []\n\
         [load]\nuniform = 1.0\npoint = [{ at = 7.0, force = 3.0 }]\n\
         [foundation]\ncosine = { mean = 0.5, amplitude = 0.2, wavelength = 9.0 }\nstiffness = 80.0\n",
        &[
            ("deflection.max", 0.718_828_115_227_455_9),
            ("deflection.min", 0.321_166_341_460_538_63),
            ("moment.max", 0.528_727_776_460_795_7),
            ("moment.min", -0.379_818_645_083_127_8),
            ("energy", -11.376_693_800_979_293),
        ],
    );
}

/// An endless beam on springs under a force: with `s² = 2 √(k/EI) + N/EI` it sags by `P √(k/EI)/2 k s` below it, with the moment `P/2 s`.
#[test]
fn a_force_on_an_endless_beam() {
    let (stiffness, k, force) = (30.0_f64, 4000.0_f64, 5.0);
    let root = (k / stiffness).sqrt();
    for tension in [0.0, 1e-9, 40.0, 900.0, 2000.0] {
        let state = certified(&format!(
            "[beam]\nlength = 40.0\nbending_stiffness = {stiffness:?}\ntension = {tension:?}\n\
             supports = [{{ at = 0.0 }}, {{ at = 40.0 }}]\n\
             [load]\nuniform = 1.0\npoint = [{{ at = 20.0, force = {force:?} }}]\n[foundation]\ndepth = 0.0\nstiffness = {k:?}\n",
        ));
        let s = (2.0 * root + tension / stiffness).sqrt();
        let (sag, moment) = (1.0 / k + force * root / (2.0 * k * s), force / (2.0 * s));
        assert!((state.deflection.max - sag).abs() < 1e-9 * sag, "{tension}: {} and {sag}", state.deflection.max);
        assert!((state.moment.max - moment).abs() < 1e-9 * moment, "{tension}: {} and {moment}", state.moment.max);
    }
}

/// Rigid supports are springs of great stiffness, and built-in ends those that are stiff against turning.
#[test]
fn stiff_springs_are_supports() {
    for (force, ground) in [
        (-2.0, ""),
        (7.0, "[foundation]\ndepth = 0.9\n"),
        (60.0, ""),
        (7.0, "[foundation]\ndepth = 0.9\nstiffness = 4.0\n"),
    ] {
        let of = |more: &str| certified(&format!("{}{ground}", tied(force, more)));
        let rigid = of("supports = [{ at = 0.0, built_in = true }, { at = 6.0 }, { at = 10.0 }]");
        let stiff = of(
            "supports = [{ at = 0.0, turning_stiffness = 1e9 }, { at = 6.0, stiffness = 1e9 }, { at = 10.0, stiffness = 1e9 }]",
        );
        for (a, b) in rigid.supports.iter().zip(&stiff.supports) {
            assert!((a.force - b.force).abs() < 1e-6, "{a:?} and {b:?}");
        }
        assert!((rigid.energy - stiff.energy).abs() < 1e-6 * rigid.energy.abs());
    }
}

/// Next to no axial force: the answers of none, on springs with overhangs on both sides and on soft ground.
#[test]
fn next_to_no_axial_force_on_what_gives() {
    let beam = "supports = [{ at = 2.0, stiffness = 5.0 }, { at = 7.0, stiffness = 3.0 }]";
    for ground in ["", "[foundation]\ndepth = 1.0\n", "[foundation]\ndepth = 0.5\nstiffness = 3.0\n"] {
        let with = |force: f64| certified(&format!("{}{ground}", tied(force, beam)));
        let (none, next) = (with(0.0), with(1e-6));
        assert!((none.energy - next.energy).abs() < 1e-5 * none.energy.abs());
        for (a, b) in none.supports.iter().zip(&next.supports) {
            assert!((a.force - b.force).abs() < 1e-5);
        }
    }
}
