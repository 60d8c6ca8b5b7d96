//! Inverse questions on elastic foundations and with supports that only push.

use palkki::route::Status;
use palkki::scene::{Beam, Foundation, Load, Scene, Support};
use palkki::sweep::{Sweep, Until};
use palkki_evidence::closed::stiff;

use super::regimes;
use crate::scenes::{ends, on_supports};

const L: f64 = 10.0;
const EI: f64 = 1000.0;

/// The single value at which a condition is met, with certified answers on both sides; looked for forth and back.
#[track_caller]
fn found(scene: &Scene, path: &str, [from, to]: [f64; 2], until: &str) -> f64 {
    let condition = Until::parse(until, scene).expect("a condition");
    let [forth, back] = [[from, to], [to, from]].map(|range| {
        let sweep = Sweep::new(scene, path, range, 2).expect("a sweep");
        let finding = sweep.find(&condition, u64::MAX).expect("answers");
        let [found] = &finding.found[..] else { panic!("{path} until {until}: {finding:?}") };
        for beside in [found.below, found.above].into_iter().flatten() {
            let mut walk = sweep.walk();
            let step = walk.solve(beside.value).expect("an answer");
            assert_eq!(walk.row(step).solution.verdict.status, Status::Certified, "{path} until {until}: {found:?}");
        }
        assert!(finding.is_whole && !found.jumps, "{path} until {until}: {found:?}");
        found.value
    });
    assert!((forth - back).abs() <= 1e-9 * forth.abs(), "{path} until {until}: {forth}, backwards {back}");
    forth
}

#[track_caller]
fn near(found: f64, expected: f64, digits: f64, what: &str) {
    assert!((found - expected).abs() <= digits * expected.abs(), "{what}: {found} instead of {expected}");
}

/// A free beam under a uniform load sinks by `q/k`. On two supports the end reaction is that of its closed form, and contact begins at the load
/// at which a beam without a foundation touches it.
#[test]
fn inverse_questions_on_an_elastic_foundation_have_their_closed_form() {
    let flat = |depth: f64| Some(Foundation::Flat { depth });
    let free = on_supports([L, EI], &[], (2.0, &[]), flat(0.1)).on_springs(50.0).expect("springs");
    near(found(&free, "load.uniform", [0.1, 9.0], "deflection(5) = 0.17"), 0.07 * 50.0, 1e-11, "load of a free beam");
    let stiffness = found(&free, "foundation.stiffness", [10.0, 90.0], "deflection(2) = 0.15");
    near(stiffness, 2.0 / 0.05, 1e-11, "stiffness below a free beam");
    near(
        found(&free, "foundation.depth", [0.0, 1.0], "deflection(8) = 0.3"),
        0.3 - 2.0 / 50.0,
        1e-11,
        "depth below a free beam",
    );

    let scene = regimes(1.0);
    let (bending, ground) = (scene.beam().bending_stiffness(), 5e5);
    let soft = scene.on_springs(ground).expect("springs");
    let reaction = stiff(bending, 1.0, 1.0, ground).reaction;
    let until = format!("support[0] = {reaction:?}");
    // A ten-thousandth of the stiffness is about a hundred-millionth of the reaction.
    near(
        found(&soft, "foundation.stiffness", [0.5 * ground, 2.0 * ground], &until),
        ground,
        1e-7,
        "stiffness for a reaction",
    );
    let touched = 384.0 * bending / (5.0 * L.powi(4));
    near(found(&soft, "load.uniform", [0.001, 1.0], "contact"), touched, 1e-11, "load at which contact begins");
}

/// A support that only pushes, at `δ` below the middle of a simple beam: `R = (5 q l⁴/384 EI − δ) 48 EI/l³` once it is positive.
#[test]
fn inverse_questions_of_a_support_that_only_pushes_have_their_closed_form() {
    let [left, right] = ends(L);
    let level = 0.05;
    let middle = Support { level, ..Support::pushing(5.0) };
    let scene = on_supports([L, EI], &[left, middle, right], (1.0, &[]), None);
    let sag = 5.0 * L.powi(4) / (384.0 * EI);
    let spring = 48.0 * EI / L.powi(3);
    let load = found(&scene, "load.uniform", [0.01, 5.0], "support[1] = 3");
    near(load, (3.0 / spring + level) / sag, 1e-11, "load for its force");
    let deeper = found(&scene, "beam.supports[1].level", [0.0, 0.2], "support[1] = 2");
    near(deeper, sag - 2.0 / spring, 1e-11, "level for its force");
}

/// Below the middle of a free beam on an elastic foundation, which a force sinks there by `P λ/2k (cosh λl + cos λl + 2)/(sinh λl + sin λl)`.
#[test]
fn inverse_questions_of_a_support_that_only_pushes_beside_an_elastic_foundation_have_their_closed_form() {
    let (depth, ground, level): (f64, f64, f64) = (0.1, 50.0, 0.12);
    let middle = Support { level, ..Support::pushing(5.0) };
    let beam = Beam::new(L, EI).and_then(|beam| beam.with_supports(vec![middle])).expect("a beam");
    let load = Load::uniform_on(&beam, 2.0).expect("a load");
    // The support stands in the foundation.
    let scene = Scene::above(beam, load, Some(Foundation::Flat { depth }), Some(ground)).expect("a scene");
    let decay = (0.25 * ground / EI).sqrt().sqrt();
    let x = decay * L;
    let sunk = 0.5 * decay / ground * (x.cosh() + x.cos() + 2.0) / (x.sinh() + x.sin());
    let load = found(&scene, "load.uniform", [1.1, 4.0], "support[0] = 3");
    near(load, ground * (level - depth + 3.0 * sunk), 1e-10, "load for its force");
    let deeper = found(&scene, "beam.supports[0].level", [0.11, 0.15], "support[0] = 1.5");
    near(deeper, depth + 2.0 / ground - 1.5 * sunk, 1e-10, "level for its force");
}
