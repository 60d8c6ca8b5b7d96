//! The pattern of contact that nodal forces show, as joints. It does not have to be right: what comes of it is proved, or
//! not, in [`super::proof`].

use super::fill::is_even;
use super::joints::{Joint, Kind, Setting};

/// Forces at nodes, from left to right, all positive, and the least distance of nodes.
pub(super) fn of_forces(setting: &Setting<'_>, forces: &[(f64, f64)], spacing: f64) -> Vec<Joint> {
    let mut joints = Vec::new();
    for cluster in runs(forces, 1.5 * spacing) {
        let (first, last) = (cluster[0].0, cluster[cluster.len() - 1].0);
        // Forces beside a corner are its own, shared by the nodes around it.
        let near = 1.001 * spacing;
        let corners: Vec<f64> = setting.ground.corners(first - near, last + near);
        let is_free = |x: f64| {
            let after = corners.partition_point(|c| *c < x);
            let close = |k: Option<&f64>| k.is_some_and(|c| (c - x).abs() <= near);
            !close(corners.get(after)) && !close(after.checked_sub(1).and_then(|k| corners.get(k)))
        };
        let touched = |c: &&f64| {
            let beside = cluster.partition_point(|f| f.0 < **c - near);
            cluster.get(beside).is_some_and(|f| f.0 <= **c + near)
        };
        joints.extend(corners.iter().filter(touched).map(|&x| Joint::new(Kind::Corner, x)));
        for part in cluster.chunk_by(|a, b| is_free(a.0) == is_free(b.0)).filter(|part| is_free(part[0].0)) {
            // One force may be shared by two nodes.
            if part.len() < 3 {
                let sum: f64 = part.iter().map(|f| f.1).sum();
                joints.push(Joint::new(Kind::Touch, part.iter().map(|f| f.0 * (f.1 / sum)).sum()));
            } else if is_even(setting, part[0].0, part[part.len() - 1].0) {
                joints.extend([Joint::new(Kind::Start, part[0].0), Joint::new(Kind::End, part[part.len() - 1].0)]);
            } else {
                joints.extend(part.iter().map(|f| Joint::new(Kind::Touch, f.0)));
            }
        }
    }
    joints.sort_by(|a, b| a.x.total_cmp(&b.x));
    with_supports(setting, joints, 1.5 * spacing)
}

/// Joints of known contacts, `[from, to]` from left to right.
pub(super) fn of_contacts(setting: &Setting<'_>, contacts: &[[f64; 2]]) -> Vec<Joint> {
    let joints = contacts.iter().flat_map(|&[from, to]| {
        if from < to {
            vec![Joint::new(Kind::Start, from), Joint::new(Kind::End, to)]
        } else if setting.ground.corners(from.next_down(), from.next_up()).is_empty() {
            vec![Joint::new(Kind::Touch, from)]
        } else {
            vec![Joint::new(Kind::Corner, from)]
        }
    });
    with_supports(setting, joints.collect(), AT_A_SUPPORT * setting.length)
}

/// A share of the beam's length: a zone that begins so near to a support, where the foundation is level with it, begins there
/// but for rounding.
const AT_A_SUPPORT: f64 = 1e-12;

/// Adds the supports. A zone that begins within `near` of a support at which the foundation is level with it begins there.
fn with_supports(setting: &Setting<'_>, mut joints: Vec<Joint>, near: f64) -> Vec<Joint> {
    let length = setting.length;
    let lies = |x: f64| setting.ground.depth(x).magnitude() <= 0.0;
    match joints.first_mut() {
        Some(joint) if joint.kind == Kind::Start && joint.x <= near && lies(0.0) => joint.x = 0.0,
        _ => joints.insert(0, Joint::new(Kind::Support, 0.0)),
    }
    match joints.last_mut() {
        Some(joint) if joint.kind == Kind::End && length - joint.x <= near && lies(length) => joint.x = length,
        _ => joints.push(Joint::new(Kind::Support, length)),
    }
    joints
}

fn runs(forces: &[(f64, f64)], reach: f64) -> impl Iterator<Item = &[(f64, f64)]> {
    forces.chunk_by(move |a, b| b.0 - a.0 <= reach)
}
