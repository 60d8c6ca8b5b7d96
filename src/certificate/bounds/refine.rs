//! From a pattern of contact to the places of its joints: Newton's method, with changes of the pattern where it does not
//! fit. Nothing here has to succeed: what comes out is proved, or not, in [`super::proof`].

use super::adjust::adjust;
use super::fill::fill;
use super::hold;
use super::joints::{Joint, Kind, Places, Setting, newton};

/// Newton steps and changes of the pattern together.
const MOST_STEPS: usize = 120;
/// Newton steps after which a pattern that does not settle is looked through.
const PATIENCE: usize = 12;
/// Changes of the pattern.
const MOST_CHANGES: usize = 24;
/// A change of place or turn of this share of the beam's length ends Newton's method; what is missing enters squared.
const CONVERGED: f64 = 1e-13;
/// A zone that is shorter, as a share of the beam's length, becomes a point.
const SHORTEST_ZONE: f64 = 1e-7;

/// Newton's method, and changes of the pattern where it does not fit; the joints that come out are in order.
pub(super) fn refined(setting: &Setting<'_>, mut joints: Vec<Joint>) -> Option<Vec<Joint>> {
    let (mut changes, mut steps) = (0, 0);
    fill(setting, &mut joints);
    for _ in 0..MOST_STEPS {
        let before = joints.clone();
        let change = newton(setting, &mut joints, Places::Free)?;
        let confined = confine(setting, &before, &mut joints);
        if confined || collapse(setting, &mut joints) {
            continue;
        }
        steps += 1;
        let converged = change <= CONVERGED * setting.length;
        if converged || PATIENCE <= steps {
            steps = 0;
            if changes == MOST_CHANGES || !adjust(setting, &mut joints) {
                if converged {
                    break;
                }
                continue;
            }
            fill(setting, &mut joints);
            changes += 1;
        }
    }
    Some(joints)
}

/// Keeps joints on the segment of a polyline on which they were. A point of contact that would leave it over a corner stays
/// at the corner; so does the end of a zone, and the other end becomes a point. Whatever would leave it elsewhere goes half
/// the way. True if a joint became another one.
fn confine(setting: &Setting<'_>, before: &[Joint], joints: &mut [Joint]) -> bool {
    let mut changed = false;
    for i in 0..joints.len() {
        let (old, joint) = (before[i].x, joints[i]);
        let Some([from, to]) = setting.ground.segment(old) else { continue };
        let moves = matches!(joint.kind, Kind::Touch | Kind::Start | Kind::End) && before[i].kind == joint.kind;
        let inside = from < joint.x && joint.x < to;
        let smooth = || {
            setting.ground.is_smooth_between(old.min(joint.x), old.max(joint.x)) && setting.ground.is_smooth_at(joint.x)
        };
        if !moves || inside || smooth() {
            continue;
        }
        let end = if joint.x <= from { from } else { to };
        if setting.ground.corners(end.next_down(), end.next_up()).is_empty() {
            joints[i].x = 0.5 * (old + end);
            continue;
        }
        let partner = match joint.kind {
            Kind::Start => Some(i + 1),
            Kind::End => i.checked_sub(1),
            _ => None,
        };
        if let Some(partner) = partner.and_then(|k| joints.get_mut(k)) {
            *partner = Joint::new(Kind::Touch, partner.x);
        }
        joints[i] = Joint::new(Kind::Corner, end);
        changed = true;
    }
    changed
}

/// Zones without length become points.
fn collapse(setting: &Setting<'_>, joints: &mut Vec<Joint>) -> bool {
    let short = SHORTEST_ZONE * setting.length;
    let found = joints.windows(2).position(|w| w[0].kind == Kind::Start && w[1].x - w[0].x < short);
    let Some(i) = found else { return false };
    let middle = 0.5 * (joints[i].x + joints[i + 1].x);
    joints.splice(i..i + 2, [Joint::new(Kind::Touch, middle)]);
    true
}

/// Joints whose places are known: only the slopes at supports and corners are found.
pub(super) fn with_slopes(setting: &Setting<'_>, mut joints: Vec<Joint>) -> Vec<Joint> {
    find_slopes(setting, &mut joints);
    if hold::at_supports(setting, &mut joints, false) {
        find_slopes(setting, &mut joints);
    }
    joints
}

fn find_slopes(setting: &Setting<'_>, joints: &mut [Joint]) {
    // Linear in the slopes; the second step is for rounding.
    for _ in 0..2 {
        let mut turned = joints.to_vec();
        if newton(setting, &mut turned, Places::Given).is_none() {
            break;
        }
        joints.copy_from_slice(&turned);
    }
}
