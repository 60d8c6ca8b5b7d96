//! Derivatives by the steps of the stiffness of an elastic foundation.

use palkki::scene::{Quantity, file};
use palkki::theory::{self, By};
use palkki_evidence::differences::Trial;

/// By the steps of an elastic foundation the energy changes by `½∫ (v − g)₊²` over each, and all forces as differences say.
#[test]
fn derivatives_by_the_steps_of_an_elastic_foundation() {
    const PARTS: u32 = 20_000;
    let steps = [[0.0, 40.0], [2.5, 90.0], [4.0, 0.0], [7.0, 25.0]];
    for joint in ["", "joints = [{ at = 5.0, stiffness = 8.0 }]\n"] {
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = 20.0\nsupports = [{{ at = 0, level = -0.1 }}]\n{joint}\
             [load]\nuniform = 1.0\npoint = [{{ at = 8.0, force = 6.0 }}]\n\
             [foundation]\npolynomial = [0.02, 0.01]\nstiffness = {{ steps = {steps:?} }}\n"
        );
        let scene = file::parse("scene.toml", &text, |_| unreachable!("no survey")).expect("a scene");
        let exact = theory::solve(&scene).expect("an answer");
        let all = exact.derivatives(&scene);
        let of = |i: usize| all.iter().find(|d| d.by == By::Number(Quantity::GroundStepStiffness(i)));
        assert!(of(2).is_none(), "a hole has no stiffness to grow");
        for (i, to) in [(0, 2.5), (1, 4.0), (3, 10.0)] {
            let [from, k] = steps[i];
            let width = (to - from) / f64::from(PARTS);
            let sunk = (0..PARTS).map(|part| exact.pressure(from + width * (f64::from(part) + 0.5)) / k);
            let expected = sunk.map(|sunk| 0.5 * sunk * sunk * width).sum::<f64>();
            let found = of(i).expect("by this step");
            assert!(0.0 < expected && (found.energy - expected).abs() <= 1e-6 * expected, "{i}: {found:?}, {expected}");
            assert!(!found.one_sided && found.missing.is_none(), "{found:?}");
            // All of the ground and the support together carry the load.
            let forces = found.supports.iter().chain(found.contacts.iter().map(|contact| &contact.force));
            assert!(forces.sum::<f64>().abs() <= 1e-6 * found.supports[0].abs(), "{found:?}");
        }
        let mut trial = Trial::default();
        trial.compare(&text, &scene);
        assert!(trial.wrong.is_empty(), "{}", trial.wrong.join("\n"));
    }
}
