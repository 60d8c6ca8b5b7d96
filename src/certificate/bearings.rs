//! Compression-only supports with an elastic foundation: a proof for the beam on the pressed supports is a proof for the scene.
//!
//! Let `v°` be the deflection of the beam if some of these supports hold it in both directions and the others are omitted. Let `R` be
//! the reactions of those that hold. If
//!
//! ```text
//! R ≥ 0 at those that hold,      v° ≤ level at the others
//! ```
//!
//! then `v°` is the deflection of the scene. It is admissible, and with `R` and the pressure `k (v° − g)₊` it satisfies all conditions
//! of the minimum of a convex `J`. No other deflection does: with `R > 0` it would rest on the same supports, where `v°` is the only
//! solution, and a beam held by its other supports has only one solution in any case. Both conditions are checked with brackets. The
//! candidate contact list states which supports hold. If it is wrong, or if the brackets do not decide, nothing is proven.

use super::Certificate;
use super::kernel::contact_node::EnclosedScene;
use super::kernel::distance::{factor, on_part};
use super::kernel::interval::Interval;
use super::kernel::proof::Pair;
use super::kernel::springs::Stretch;
use super::support_forces::piece_at;
use crate::scene::{Bearing, Scene, SceneError, Support, is_same_place};

/// A deflection reaches a support if it is less than its level by at most this share of the larger of level and largest deflection: some
/// thousand units in the last place.
const SAME: f64 = 1e-12;

/// A dimensionless scene in which the compression-only supports that the beam touches, according to the given stretches, hold in both
/// directions.
///
/// # Errors
///
/// The errors of [`Scene::new`].
pub(super) fn held(scene: &Scene, witness: &[Stretch]) -> Result<Scene, SceneError> {
    let length = scene.beam().length();
    let shape = |x: f64| scene.beam().shape().map_or(0.0, |shape| shape.depth(x));
    // For a pressed stretch the given values are penetrations.
    let deflection = |s: &Stretch, x: f64, end: [f64; 4]| {
        let ground = if s.sunk.is_empty() { 0.0 } else { scene.depth(x) - shape(x) };
        (x, ground + end[0])
    };
    let ends = || witness.iter().flat_map(|s| [deflection(s, s.from, s.ends[0]), deflection(s, s.to, s.ends[1])]);
    let size = ends().fold(0.0, |most: f64, (_, v)| most.max(v.abs()));
    let touches = |Bearing { at, gap }: Bearing| {
        ends().any(|(x, v)| is_same_place(x, at, length) && gap - SAME * size.max(gap.abs()) <= v)
    };
    let touched: Vec<f64> = scene.bearings().filter(|bearing| touches(*bearing)).map(|bearing| bearing.at).collect();
    scene.held_where(|bearing| touched.iter().any(|at| (bearing.at - at).abs() <= 0.0))
}

/// The certificate of the scene from that of the beam on supports that hold; [`None`] if the two may not be the same beam.
pub(super) fn of_scene(
    scene: &Scene,
    enclosed: &EnclosedScene<'_>,
    pair: &Pair,
    known: &Certificate,
) -> Option<Certificate> {
    let all = scene.beam().all_supports();
    let is_held = scene.beam().is_held();
    let mut brackets = known.reactions.iter();
    let mut bracket = |support: &Support| {
        if support.stiffness.is_some() {
            let bracket = *brackets.next()?;
            // A compression-only support that the beam is clear of has no reaction.
            let is_clear = support.pushes_only && clears(enclosed, pair, support);
            return Some(if is_clear { Some([0.0; 2]) } else { bracket });
        }
        if enclosed.support(support.at).is_none() {
            return clears(enclosed, pair, support).then_some(Some([0.0; 2]));
        }
        let bracket = *brackets.next()?;
        if support.pushes_only {
            let [least, _] = bracket?;
            return (0.0 < least || is_held && 0.0 <= least).then_some(bracket);
        }
        Some(bracket)
    };
    let reactions = all.iter().map(&mut bracket).collect::<Option<_>>()?;
    Some(Certificate { reactions, ..known.clone() })
}

/// Whether the beam is proven to be above a support that does not hold it.
fn clears(enclosed: &EnclosedScene<'_>, pair: &Pair, support: &Support) -> bool {
    let (x, piece) = (support.at, piece_at(pair, support.at));
    let level = Interval::exact(support.level) - enclosed.gap.shape.depth(x);
    let clearance = level - piece.v.at(Interval::length(piece.from, x));
    on_part(pair, factor(pair.gap, enclosed.stiffness), [x, x]) <= clearance.lo()
}
