//! Bounds and estimates for a beam above a foundation whose depth is known only to within `±δ`, independently at each position.
//!
//! A deeper foundation leaves the beam more room, so the least energy falls with every depth. With `J*` for a foundation moved as a
//! whole:
//!
//! ```text
//! J*(u + δ) ≤ J* ≤ J*(u − δ)                            proven, from the certificates of two solves
//! J_free < J*(u + δ)                                    the beam touches, whatever the depths are
//! its supports do not hold it                           it touches, whatever the depths are
//! the beam above u − δ touches nowhere                  nor does it touch for any depths within ±δ
//! |R − R(u)| ≈ δ Σ |∂R/∂u_i|  over the contacts i        an estimate: the list of contacts does not change
//! ```

use crate::route::Solution;
use crate::scene::{Balance, Scene};
use crate::state::Regime;
use crate::theory::{self, Exact, Spread};
use crate::verdict::{Demand, Status};

/// Bounds and estimates for the answer above a foundation whose depths may be off by a tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthTolerance {
    /// `δ` \[length\].
    pub tolerance: f64,
    /// Proven lower and upper bound of the energy; [`None`] if there is none, in particular if the foundation may be above a support.
    pub energy: [Option<f64>; 2],
    /// Whether the beam touches the foundation.
    pub contact: Touches,
    /// Estimates of how far forces may be off, from derivatives; [`None`] if there are none.
    pub estimates: Option<Spread>,
    /// What was left out of the estimates, and why.
    pub left_out: Option<&'static str>,
}

/// Whether a beam touches the foundation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Touches {
    /// It touches at any depths within the tolerance.
    Certainly,
    /// It touches at no depths within the tolerance.
    Nowhere,
    /// Contact depends on the depths, or neither of the other two could be shown.
    Perhaps,
}

impl Touches {
    /// The word used in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Certainly => "certainly",
            Self::Nowhere => "nowhere",
            Self::Perhaps => "perhaps",
        }
    }
}

impl DepthTolerance {
    /// Bounds and estimates for the exact solution of a scene if each depth of its foundation may be off by `tolerance`, positive
    /// \[length\].
    #[must_use]
    pub fn of(scene: &Scene, exact: &Exact, tolerance: f64) -> Self {
        let moved = |down: f64| scene.with_ground_moved(down).ok().and_then(|scene| judged(&scene));
        let certificate = |solution: &Option<Solution>| solution.as_ref().and_then(|s| s.verdict.certificate.clone());
        let (deep, shallow) = (moved(tolerance), moved(-tolerance));
        let finite = |value: f64| value.is_finite().then_some(value);
        let lower = certificate(&deep).and_then(|c| finite(c.energy_lower));
        let upper = certificate(&shallow).and_then(|c| finite(c.energy_upper));
        let free = Scene::new(scene.beam().clone(), scene.load().clone(), None).ok().and_then(|scene| judged(&scene));
        let free = certificate(&free).map_or(f64::INFINITY, |c| c.energy_upper);
        let apart =
            |solution: &Solution| solution.verdict.status == Status::Certified && solution.state.regime == Regime::None;
        let contact = match (lower, &shallow) {
            _ if leans(scene) => Touches::Certainly,
            (Some(lower), _) if free < lower => Touches::Certainly,
            (_, Some(shallow)) if apart(shallow) => Touches::Nowhere,
            _ => Touches::Perhaps,
        };
        let estimates = exact.spread(tolerance);
        let left_out = estimates.is_none().then_some(match scene.ground_stiffness() {
            Some(_) => "no estimates: they are for rigid ground",
            None if !scene.is_uniform() => "no estimates: they are for beams of one stiffness",
            None if !scene.has_no_tension() => "no estimates: they are for beams without an axial force",
            None if !scene.is_firm() => "no estimates: they are for supports that give nothing",
            None => "no estimates: the forces do not follow from the depths to first order",
        });
        Self { tolerance, energy: [lower, upper], contact, estimates, left_out }
    }
}

/// Whether the foundation must carry part of the loads whatever its depth, because the supports neither hold nor carry the beam.
fn leans(scene: &Scene) -> bool {
    if !scene.beam().bearings().is_empty() || !scene.beam().springs().is_empty() {
        return false;
    }
    match scene.scaled().map(|scaled| scaled.balance) {
        Ok(Balance::Stands(_)) => true,
        Ok(Balance::Neutral { .. }) => scene.beam().supports().is_empty(),
        _ => false,
    }
}

fn judged(scene: &Scene) -> Option<Solution> {
    Some(theory::solve(scene).ok()?.judged(scene, &Demand::default()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load, Support};

    fn scene(depth: f64) -> Scene {
        let beam = Beam::new(10.0, 10_000.0 / 384.0 / 20.0).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        Scene::new(beam, load, Some(Foundation::Flat { depth })).expect("a scene")
    }

    /// Contact is lost at a depth of 100.
    #[test]
    fn contact_is_certain_or_excluded_as_far_as_the_depth_is_known() {
        let of = |depth: f64, tolerance: f64| {
            let scene = scene(depth);
            DepthTolerance::of(&scene, &theory::solve(&scene).expect("an answer"), tolerance)
        };
        assert_eq!(of(90.0, 9.0).contact, Touches::Certainly);
        assert_eq!(of(90.0, 11.0).contact, Touches::Perhaps);
        assert_eq!(of(110.0, 9.0).contact, Touches::Nowhere);
        assert_eq!(of(110.0, 11.0).contact, Touches::Perhaps);
        // Only the foundation carries a beam without supports, or a beam that would rotate about its only support.
        for supports in [Vec::new(), vec![Support::simple(2.0)]] {
            let scene = scene(90.0);
            let beam = scene.beam().clone().with_supports(supports).expect("a beam");
            let scene = Scene::new(beam, scene.load().clone(), scene.foundation().cloned()).expect("a scene");
            let exact = theory::solve(&scene).expect("an answer");
            for tolerance in [9.0, 90.0, 900.0] {
                assert_eq!(DepthTolerance::of(&scene, &exact, tolerance).contact, Touches::Certainly);
            }
        }
        // Compression-only supports may carry the beam alone.
        let on_bearings = |depth: f64| {
            let scene = scene(depth);
            let supports = vec![Support::pushing(0.0), Support::pushing(10.0)];
            let beam = scene.beam().clone().with_supports(supports).expect("a beam");
            Scene::new(beam, scene.load().clone(), scene.foundation().cloned()).expect("a scene")
        };
        for (depth, expected) in [(90.0, Touches::Certainly), (100.0, Touches::Perhaps), (110.0, Touches::Nowhere)] {
            let scene = on_bearings(depth);
            let exact = theory::solve(&scene).expect("an answer");
            assert_eq!(DepthTolerance::of(&scene, &exact, 9.0).contact, expected);
        }
        // A foundation above the supports has no energy bound.
        assert_eq!(of(1.0, 2.0).energy[1], None);
    }

    /// On an elastic foundation the energy also falls with every depth.
    #[test]
    fn ground_that_gives_is_bounded_too() {
        let soft = |depth: f64| scene(depth).on_springs(0.03).expect("ground");
        let found = DepthTolerance::of(&soft(50.0), &theory::solve(&soft(50.0)).expect("an answer"), 0.5);
        let [Some(lower), Some(upper)] = found.energy else { panic!("{found:?}") };
        assert_eq!((found.contact, found.estimates), (Touches::Certainly, None));
        for depth in [49.6, 50.0, 50.4] {
            let energy = theory::solve(&soft(depth)).expect("an answer").state.energy;
            assert!(lower <= energy && energy <= upper, "{depth}: {energy} from {lower} to {upper}");
        }
    }

    /// For any foundation within the tolerance the energy is between the bounds, and forces differ by at most the estimates.
    #[test]
    fn answers_within_the_tolerance_are_within_the_bounds() {
        let scene = scene(50.0);
        let exact = theory::solve(&scene).expect("an answer");
        let found = DepthTolerance::of(&scene, &exact, 0.5);
        let [Some(lower), Some(upper)] = found.energy else { panic!("{found:?}") };
        for tilt in [-0.08, 0.0, 0.05] {
            // A polynomial within ±0.5 of the depth.
            let ground = Foundation::Polynomial { coefficients: vec![50.1 - 5.0 * tilt, tilt] };
            let other = Scene::new(scene.beam().clone(), scene.load().clone(), Some(ground)).expect("a scene");
            let other = theory::solve(&other).expect("an answer");
            assert!(lower <= other.state.energy && other.state.energy <= upper, "{tilt}");
            let estimate = found.estimates.as_ref().expect("derivatives").supports[0];
            let off = (other.state.reactions.left - exact.state.reactions.left).abs();
            assert!(off <= estimate * (1.0 + 1e-9), "{tilt}: {off} for {estimate}");
        }
    }
}
