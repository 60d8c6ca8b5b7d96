//! What a witness says, as contact nodes. Nothing is added to its contacts but the supports, and no place is moved: what is
//! wrong stays wrong, and is paid for in [`super::proof`].

use super::joints::{Joint, Kind, Setting};
use super::slopes;
use crate::scene::Scale;
use crate::state::Contact;

/// A share of the beam's length: a zone that begins so near to a support, where the foundation is level with it, begins there
/// but for rounding.
const AT_A_SUPPORT: f64 = 1e-12;

/// The contact nodes of a list of contacts in the units of the scene, from left to right, with the slopes that follow from
/// their places. A single place is a corner of the foundation if there is one, and otherwise a point of tangency.
pub(super) fn joints(setting: &Setting<'_>, contacts: &[Contact], scale: &Scale) -> Vec<Joint> {
    let length = setting.length;
    let places = contacts.iter().map(|c| [c.from / scale.length, c.to / scale.length]);
    // A single contact at a support says nothing that the support does not say.
    let inside = places.filter(|c| c[0] != c[1] || !(c[0] == 0.0 || c[0] == length));
    let mut joints: Vec<Joint> = Vec::with_capacity(2 * contacts.len() + 2);
    joints.push(Joint::new(Kind::Support, 0.0));
    for [from, to] in inside {
        if from != to {
            joints.extend([Joint::new(Kind::Start, from), Joint::new(Kind::End, to)]);
        } else if setting.ground.corners(from.next_down(), from.next_up()).is_empty() {
            joints.push(Joint::new(Kind::Touch, from));
        } else {
            joints.push(Joint::new(Kind::Corner, from));
        }
    }
    joints.push(Joint::new(Kind::Support, length));
    let near = AT_A_SUPPORT * length;
    let level = |x: f64| setting.ground.depth(x).magnitude() <= 0.0;
    if joints[1].kind == Kind::Start && joints[1].x <= near && level(0.0) {
        joints[1].x = 0.0;
        joints.remove(0);
    }
    let last = joints.len() - 1;
    if joints[last - 1].kind == Kind::End && length - joints[last - 1].x <= near && level(length) {
        joints[last - 1].x = length;
        joints.pop();
    }
    slopes::find(setting, &mut joints);
    joints
}
