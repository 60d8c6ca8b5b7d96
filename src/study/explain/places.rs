//! The positions at which an explanation has nodes, and what is there.

use super::What;
use crate::scene::{Foundation, Scene};
use crate::state::SupportForce;
use crate::theory::Exact;

/// Positions closer than this share of the length of the beam are the same.
pub(super) const SAME: f64 = 1e-12;

/// A position, what is there, the force of a support or contact, and whether the slope is given there.
pub(super) type Place = (f64, What, f64, bool);

/// Whether two positions on the beam are the same.
pub(super) fn is_same(scene: &Scene, a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * scene.beam().length()
}

/// The stiffness of the joint at a position, zero for a hinge.
pub(super) fn joint_at(scene: &Scene, x: f64) -> Option<f64> {
    let joint = scene.beam().joints().iter().find(|joint| is_same(scene, joint.at, x))?;
    Some(joint.stiffness.unwrap_or(0.0))
}

/// The points of foundation and initial shape at which they may have corners.
pub(super) fn corners(scene: &Scene) -> impl Iterator<Item = f64> + '_ {
    fn points(profile: &Foundation) -> &[[f64; 2]] {
        match profile {
            Foundation::Polyline { points } => points,
            _ => &[],
        }
    }
    scene.foundation().into_iter().chain(scene.beam().shape()).flat_map(points).map(|point| point[0])
}

/// Whether a position is inside a contact zone.
pub(super) fn is_in_zone(exact: &Exact, x: f64) -> bool {
    exact.state.contacts.iter().any(|contact| contact.from < x && x < contact.to)
}

/// Whether this is a support that the beam has lifted off.
pub(super) fn has_lifted(support: &SupportForce) -> bool {
    support.pushes_only && support.force <= 0.0
}

/// The positions of supports that the beam has lifted off.
pub(super) fn lifted(exact: &Exact) -> Vec<f64> {
    exact.state.supports.iter().filter(|support| has_lifted(support)).map(|support| support.at).collect()
}

/// The positions of the nodes from left to right, each with its kind, its force, and whether the beam follows the slope of the
/// foundation or of a built-in support there.
pub(super) fn found(scene: &Scene, exact: &Exact) -> Vec<Place> {
    let (beam, state) = (scene.beam(), &exact.state);
    let length = beam.length();
    let is_corner = |x: f64| corners(scene).any(|corner| is_same(scene, corner, x));
    let mut found = Vec::new();
    for support in state.supports.iter().filter(|support| !has_lifted(support)) {
        let what = What::of_support(scene, support);
        // In a zone the foundation carries the force of an elastic support.
        let gives = beam.springs().iter().any(|spring| is_same(scene, spring.at, support.at));
        if !(gives && is_in_zone(exact, support.at)) {
            found.push((support.at, what, support.force, support.moment.is_some()));
        }
    }
    for contact in &state.contacts {
        match contact.end_forces {
            Some([left, right]) if contact.from < contact.to => {
                found.extend([(contact.from, left), (contact.to, right)].map(|(x, f)| (x, What::ZoneEnd, f, true)));
            }
            _ if contact.from <= 0.0 || length <= contact.from => {
                found.push((contact.from, What::Tip, contact.force, false));
            }
            // A joint is a corner of the beam.
            _ if is_corner(contact.from) || joint_at(scene, contact.from).is_some() => {
                found.push((contact.from, What::Corner, contact.force, false))
            }
            _ => found.push((contact.from, What::Point, contact.force, true)),
        }
    }
    let hinges = beam.joints().iter().filter(|joint| joint.stiffness.is_none());
    found.extend(hinges.map(|hinge| (hinge.at, What::Hinge, 0.0, false)));
    found.extend([0.0, length].map(|end| (end, What::End, 0.0, false)));
    // Several nodes at one position become one, of the kind of the first; their forces add up.
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.dedup_by(|next, kept| {
        let same = is_same(scene, next.0, kept.0);
        if same {
            // A support or a contact takes precedence over an end of the beam or a hinge.
            let what = if matches!(kept.1, What::End | What::Hinge) { next.1 } else { kept.1 };
            *kept = (kept.0, what, kept.2 + next.2, kept.3 || next.3);
        }
        same
    });
    found
}
