//! A beam without supports that the foundation carries at one position and its tension keeps from turning.

use super::*;
use crate::certificate::kernel::tension::Hung;

/// A nearly rigid beam touches the crest of `u = 1 + c (x − m)²` at `m + t` and is the tangent there. With the total load `F`, its moment
/// `C` about the crest and the tension `N`
///
/// ```text
/// J(t) = c (F + 2 c N l) t² − 2 c C t + const,    t* = C/(F + 2 c N l),    J(t) − J(t*) = c (F + 2 c N l) (t − t*)²
/// ```
///
/// The gap of a pair with contact at `m + t` is at least this difference, since a beam of finite stiffness has an energy below that of the
/// rigid one. The couple that the contact lacks is left to the tension.
#[test]
fn a_wrong_position_on_a_crest_costs_the_couple_that_it_lacks() {
    const RIGID: f64 = 1e12;
    let (tension, curvature, middle, [at, force]) = (6.0, 0.01, 0.5 * LENGTH, [14.0, 5.0]);
    let beam = Beam::new(LENGTH, RIGID).and_then(|beam| beam.with_supports(Vec::new())).expect("no supports");
    let beam = beam.with_tension(tension).expect("finite");
    let load = Load::new(&beam, LOAD, Vec::new(), vec![PointLoad { at, force }]).expect("finite");
    let coefficients = vec![1.0 + curvature * middle * middle, -2.0 * curvature * middle, curvature];
    let scene = Scene::new(beam, load, Some(Foundation::Polynomial { coefficients })).expect("well posed");
    let total = LOAD * LENGTH + force;
    let rate = total + 2.0 * curvature * tension * LENGTH;
    let truth = force * (at - middle) / rate;
    for off in [-4.0, -0.5, -1e-2, -1e-4, 1e-4, 1e-2, 0.5, 4.0] {
        let x = middle + truth + off;
        let slope = 2.0 * curvature * (x - middle);
        let line = |from: f64, to: f64| {
            let depth = 1.0 + 0.5 * (x - middle) * slope + slope * (from - x);
            Hung { from, to, deflection: vec![depth, slope] }
        };
        let hung = [line(0.0, x), line(x, LENGTH)];
        let pair = in_intervals(&scene, Balance::Held, |enclosed| {
            pair(&EnclosedScene { hung: &hung, ..*enclosed }, &[node(Kind::Touch, x, 0.0)])
        });
        let gap = pair.expect("the tension carries it").gap;
        let least = curvature * rate * off * off;
        assert!(least <= gap && gap.is_finite(), "off by {off}: {gap} for at least {least}");
    }
}
