//! Derivatives of the paper's example beside those of its closed form.

use super::*;
use crate::scene::{Beam, Foundation, Load, Support};
use crate::theory::solve;

/// The paper's example: T = q a/2 with a⁴ = 24 EI u₀/q, so that ∂T/∂u₀ = T/4u₀, ∂T/∂q = 3T/4q, ∂T/∂EI = T/4EI.
#[test]
fn the_example_has_those_of_its_closed_form() {
    let stiffness = 500.0 / 384.0;
    let beam = Beam::new(10.0, stiffness).expect("a beam");
    let load = Load::uniform_on(&beam, 1.0).expect("a load");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
    let exact = solve(&scene).expect("an answer");
    let t = exact.state.reactions.left;
    let derivatives = exact.derivatives(&scene);
    let of = |by: &str| derivatives.iter().find(|d| d.by.to_string() == by).expect("a derivative");
    for (by, expected) in
        [("depth", t / 4.0), ("load.uniform", 3.0 * t / 4.0), ("beam.bending_stiffness", t / 4.0 / stiffness)]
    {
        let derivative = of(by);
        assert!(!derivative.one_sided, "{by}");
        let ends = derivative.contacts[0].end_forces.expect("a zone");
        for found in [derivative.supports[0], derivative.supports[1], ends[0], ends[1]] {
            assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{by}: {found} for {expected}");
        }
    }
    let energy = of("depth").energy;
    assert!((energy + 10.0 - 2.0 * t).abs() <= 1e-12 * energy.abs(), "{energy}");
    let from = of("depth").contacts[0].from;
    assert!((from - t / 2.0).abs() <= 1e-12, "a = 2T/q");
}

/// Where no answers beside it may be had, the derivatives are those that need none, the same as with them: the depth, the stiffness, the
/// uniform load, and the places of the outermost supports are left out.
#[test]
fn what_takes_too_many_answers_is_left_out() {
    const FIELDS: u32 = 20;
    let supports = (0..=FIELDS).map(|i| Support::simple(f64::from(i)).at_level(0.01 * f64::from(i % 3))).collect();
    let beam = Beam::new(f64::from(FIELDS), 1.0).and_then(|beam| beam.with_supports(supports)).expect("a beam");
    let load = Load::uniform_on(&beam, 1.0).expect("a load");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
    let exact = solve(&scene).expect("an answer");
    let within = |pieces| exact.derivatives_within(&scene, exact.variations(&scene), pieces).expect("derivatives");
    let (none, all) = (within(0), within(usize::MAX));
    assert_eq!((all.len(), all.len() - none.len()), (3 + 2 * (FIELDS as usize + 1), 5));
    assert!(none.iter().all(|derivative| all.contains(derivative)));
    assert_eq!(exact.derivatives_and_left_out(&scene), (all, 0));
}
