//! Proofs of exact answers are accepted, and their brackets are sharp.

use std::collections::BTreeMap;

use palkki::proof::{Unproven, prove};
use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Foundation, Scene};
use palkki::theory::{self, Exact};
use palkki_evidence::authority::{RANDOM, RBig};
use palkki_evidence::practice::Family;
use palkki_evidence::random::{self, Feature, Random, general, rare_sample_of, sample_of};

use super::bracket;
use crate::scenes::{report, scene, uniform};

/// What a bracket is as wide as at most, and what the printed energy is off by, as a share of it.
const SHARP: f64 = 1e-12;

/// Random scenes on ground that gives.
const SOFT: usize = 300;

/// What a general beam has, on rigid ground, under tension or compression and on an elastic foundation, and how many scenes there are.
const RIGID: &[Feature] = &[
    Feature::Couple,
    Feature::Steps,
    Feature::Joint,
    Feature::Hinge,
    Feature::Spring,
    Feature::Turning,
    Feature::Stop,
];
const PULLED: &[Feature] = &[Feature::Hinge, Feature::Tension];
const SOIL: &[Feature] = &[Feature::Couple, Feature::Steps, Feature::Joint, Feature::SoilSteps];
const GENERAL_SCENES: usize = 240;
const COLUMNS: usize = 120;

/// Lines of the checker, prose included.
const LINES: usize = 250;

/// Of an energy that loads and bending leave next to nothing of, this share of each is rounding.
fn size(exact: &Exact, scene: &Scene) -> f64 {
    let length = scene.beam().length();
    let sunk = exact.state.deflection.max.abs().max(exact.state.deflection.min.abs());
    exact.state.energy.abs().max(1e-3 * scene.load().magnitude(length) * sunk)
}

/// The proof of an answer is accepted, and its energies are in order. True if they are next to each other and to the printed one.
#[track_caller]
fn is_sharp(name: &str, scene: &Scene, exact: &Exact) -> Result<bool, Unproven> {
    let proof = prove(scene, exact)?;
    let [low, up] = bracket(scene, &proof).unwrap_or_else(|why| panic!("{name}: {why}"));
    assert!(low <= up, "{name}: the energies are the wrong way round");
    let (size, near) = (size(exact, scene), |energy: &RBig| energy.to_f64().value() - exact.state.energy);
    Ok([&low, &up].iter().all(|energy| near(energy).abs() <= SHARP * size)
        && (&up - &low).to_f64().value() <= SHARP * size)
}

/// One support at an end of the beam and springs for the rest: the moment at that end is none, whatever rounding leaves beside it.
#[test]
fn a_support_at_an_end_is_all_that_holds() {
    for springs in [
        "{ at = 10.1, stiffness = 5.03 }",
        "{ at = 3, stiffness = 7.9, pushes_only = true }, { at = 10.1, stiffness = 51 }",
    ] {
        for end in [0.0, 10.1] {
            let text = format!(
                "[beam]\nlength = 10.1\nbending_stiffness = 1900\nsupports = [{{ at = {end:?} }}, {}]\n[load]\nuniform = 6.6\n",
                if end > 0.0 { springs.replace("10.1", "0") } else { springs.to_owned() }
            );
            let scene = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).expect("a scene");
            let exact = theory::solve(&scene).expect("an answer");
            assert_eq!(is_sharp(&text, &scene, &exact), Ok(true), "{text}");
        }
    }
}

/// A part without load beyond a hinge may be anywhere: there is no proof, and the message names a place.
#[test]
fn what_may_turn_has_a_place() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 20.0\nsupports = [{ at = 2.5, stiffness = 4.0 }]\n\
        joints = [{ at = 6.75 }, { at = 7.75 }]\n[load]\npoint = [{ at = 4.5, force = 0.5 }]\n\
        [foundation]\npolynomial = [0.2, 0.08, -0.008]\n";
    let scene = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a scene");
    let exact = theory::solve(&scene).expect("an answer");
    let why = prove(&scene, &exact).expect_err("a part without load");
    assert!(matches!(why, Unproven::Turns { at } if at.total_cmp(&6.75).is_eq()), "{why}");
}

/// The edge of a step carries together with a stop at the same place.
#[test]
fn a_stop_beside_ground_that_carries_too() {
    let text = "[beam]\nlength = 12.0\nbending_stiffness = 1000.0\n\
        supports = [{ at = 0 }, { at = 4, pushes_only = true, level = 0.1, stiffness = 2.0 }, { at = 12 }]\n\
        [load]\nuniform = 10.0\n[foundation]\npoints = [[0, 1.0], [4, 0.5], [4, 3.0], [12, 3.0]]\n";
    let scene = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a scene");
    let exact = theory::solve(&scene).expect("an answer");
    let stop = exact.state.supports[1].force;
    let [edge] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    assert!((stop - 0.8).abs() <= 1e-12 && edge.from.total_cmp(&4.0).is_eq() && 0.0 < edge.force, "{edge:?}");
    assert_eq!(is_sharp(text, &scene, &exact), Ok(true));
}

/// All scenes of the report without a cosine. In one the ground is level with a support but for a rounding: in fractions it begins 2.8e-16
/// below it, and the energy is certain to the tenth digit only.
#[test]
fn scenes_of_the_report_are_proven() {
    let other = "held/cantilever held/overhang held/pipe-sleeper held/pipe-step held/settlement held/ski held/table-edge \
        held/two-spans held/balanced swept/hoist soft/bearings soft/lift-off taught/spans";
    let other = other.split_whitespace().map(|name| (name.to_owned(), scene(name)));
    let (mut cosines, mut wide) = (0, Vec::new());
    for (name, scene) in report().into_iter().chain(other) {
        let exact = theory::solve(&scene).expect("beam theory has an answer");
        match is_sharp(&name, &scene, &exact) {
            Err(Unproven::Cosine { .. }) => cosines += 1,
            Err(why) => panic!("{name}: {why}"),
            Ok(true) => {}
            Ok(false) => wide.push(name),
        }
    }
    assert_eq!((cosines, wide), (4, vec!["sill".to_owned()]));
}

/// Proves random scenes until so many are proven. Of the others all but one in fifty have a cosine, or ground that is above a support by a
/// rounding: in fractions nothing is admissible there.
#[track_caller]
fn proves(scenes: impl Iterator<Item = (String, Scene)>, count: usize) {
    let (mut proven, mut wide, mut why) = (0, Vec::new(), BTreeMap::<&str, usize>::new());
    for (name, scene) in scenes {
        let Ok(exact) = theory::solve(&scene) else { continue };
        if !exact.solved {
            continue;
        }
        match is_sharp(&name, &scene, &exact) {
            Err(Unproven::Cosine { .. } | Unproven::AboveSupport { .. }) => {}
            Err(_) => *why.entry("by rounding").or_default() += 1,
            Ok(sharp) => {
                proven += 1;
                if !sharp {
                    wide.push(name);
                }
            }
        }
        if proven == count {
            break;
        }
    }
    assert!(50 * why.values().sum::<usize>() <= proven, "{why:?} beside {proven}");
    // Ground that is below a support by a rounding, and zones so short that their places have no digits left.
    assert!(30 * wide.len() <= proven, "{wide:?} of {proven}");
}

#[test]
fn random_scenes_on_rigid_ground_are_proven() {
    let of = |i: u64| {
        [("plain", random::scene(i)), ("held", random::held(i)), ("lattice", random::on_lattice(i))]
            .map(|(kind, scene)| (format!("{kind} {i}"), scene))
    };
    proves((0..).flat_map(of), sample_of(RANDOM));
}

#[test]
fn random_scenes_on_ground_that_gives_are_proven() {
    let of = |i: u64| {
        let scene = if i.is_multiple_of(4) { random::held(i) } else { random::scene(i) };
        let stiffness = libm::pow(10.0, Random::new(i).between(-3.0, 6.0));
        let scene = scene.on_springs(stiffness).expect("positive");
        (scene.ground_stiffness().is_some() && scene.scaled().is_ok()).then_some((format!("soft {i}"), scene))
    };
    proves((0..).filter_map(of), sample_of(SOFT));
}

/// Of these some three in four have no cosine. Tension alone holds one beam with a hinge in twelve.
#[test]
fn random_general_scenes_are_proven() {
    for (of, on_soil) in
        [(RIGID, false), (PULLED, false), (&Feature::ALL, false), (SOIL, true), (PULLED, true), (&Feature::ALL, true)]
    {
        let scene = |i: u64| {
            let scene = parse("scene.toml", &general(i, of, on_soil).text, |_| Err(ReadProblem::Missing)).ok()?;
            Some((format!("general {i}, soil {on_soil}, {of:?}"), scene))
        };
        proves((0..).filter_map(scene), rare_sample_of(GENERAL_SCENES));
    }
}

/// Under a compression of a few shares of what they bear.
#[test]
fn random_columns_are_proven() {
    const SHARES: [f64; 4] = [0.1, 0.5, 0.9, 0.97];
    for on_soil in [false, true] {
        let scene = |i: u64| {
            let text = general(i, &Feature::ALL, on_soil).text;
            let line = text.lines().find(|line| line.starts_with("tension = "))?;
            let under = |force: f64| {
                let text = text.replace(line, &format!("tension = {force:?}"));
                parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).ok().filter(|scene| scene.scaled().is_ok())
            };
            let (mut borne, mut buckles) = (0.0, 1e6);
            for _ in 0..40 {
                let middle = 0.5 * (borne + buckles);
                *if under(-middle).is_some() { &mut borne } else { &mut buckles } = middle;
            }
            let share = SHARES[usize::try_from(i).ok()? % SHARES.len()];
            Some((format!("column {i}, soil {on_soil}, {share}"), under(-share * borne).filter(|_| 0.0 < borne)?))
        };
        proves((0..).filter_map(scene), sample_of(COLUMNS));
    }
}

/// Of each family this many cases, of which some have a cosine. In zones and pressed parts the ground is often straight but for rounding.
#[test]
fn beams_in_practice_are_proven() {
    const CASES: u32 = 48;
    let scenes = Family::ALL.iter().flat_map(|(family, _)| {
        // The longest proofs: up to 2,000 readings, with a polynomial of twenty terms between them.
        let cases = if *family == Family::PipesOnSoil { CASES / 6 } else { CASES };
        (0..sample_of(cases)).filter_map(|i| {
            let scene = parse("scene.toml", &family.case(i).text(), |_| Err(ReadProblem::Missing)).ok()?;
            Some((format!("{} {i}", family.name()), scene))
        })
    });
    proves(scenes, usize::MAX);
}

/// Readings of a rough profile, on which the beam touches single points.
#[test]
fn a_survey_of_two_thousand_points_is_proven() {
    let (mut random, count, length) = (Random::new(0x0005_e4e7), 2_000_u32, 100.0);
    let wave = |x: f64| 0.02 * libm::sin(0.37 * x) + 0.01 * libm::sin(1.9 * x);
    let points = (0..count).map(|i| {
        let x = length * f64::from(i) / f64::from(count - 1);
        [x, 0.1 + wave(x) + random.between(-2e-3, 2e-3)]
    });
    let scene = uniform(length, 50.0, 1.0, Foundation::Polyline { points: points.collect() });
    let exact = theory::solve(&scene).expect("an answer");
    assert!(10 < exact.state.contacts.len(), "{:?}", exact.state.contacts.len());
    assert_eq!(is_sharp("survey", &scene, &exact), Ok(true));
    let bytes = prove(&scene, &exact).expect("a proof").json().len();
    assert!(bytes < 400_000, "{bytes} bytes");
}

#[test]
fn the_checker_is_short_and_shares_nothing_with_the_library() {
    let text = include_str!("../../../report/check.rs");
    let lines = text.lines().count();
    assert!(lines <= LINES, "{lines} lines; README promises {LINES}");
    let uses: Vec<&str> = text.lines().filter(|line| line.starts_with("use ")).collect();
    assert_eq!(uses.len(), 3, "{uses:?}");
    assert!(!text.contains("palkki"), "it uses the library");
}
