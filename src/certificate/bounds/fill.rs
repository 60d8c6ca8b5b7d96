//! Zones that forces show as single contacts.

use super::joints::{Joint, Kind, Setting};

/// Makes one zone of neighbouring contacts between which the foundation is too even to leave the beam free: held like the
/// foundation at both joints, the beam sags into it, and lying on it all the way it is pressed everywhere. Nodes in contact
/// that stand alone, and the open interval that the discrete optimum leaves behind lift-off, are zones in truth.
pub(super) fn fill(setting: &Setting<'_>, joints: &mut Vec<Joint>) {
    let mut filled: Vec<Joint> = Vec::with_capacity(joints.len());
    for right in joints.drain(..) {
        let left = filled.last().copied().filter(|left| {
            (matches!(left.kind, Kind::Touch | Kind::End) || lies_at(setting, left))
                && (matches!(right.kind, Kind::Touch | Kind::Start) || lies_at(setting, &right))
                && setting.ground.is_smooth_between(left.x, right.x)
                && is_even(setting, left.x, right.x)
        });
        let Some(left) = left else {
            filled.push(right);
            continue;
        };
        // A point becomes an end of the zone; the end of a zone on this side is none any more.
        filled.pop();
        if left.kind != Kind::End {
            filled.push(Joint::new(Kind::Start, left.x));
        }
        if right.kind != Kind::Start {
            filled.push(Joint::new(Kind::End, right.x));
        }
    }
    *joints = filled;
}

/// Whether a zone can begin at a support: where the foundation is level with it, and not bent the other way.
fn lies_at(setting: &Setting<'_>, joint: &Joint) -> bool {
    matches!(joint.kind, Kind::Support | Kind::Clamp)
        && setting.ground.depth(joint.x).magnitude() <= 0.0
        && 0.0 <= setting.ground.jet(joint.x)[2].hi()
}

/// Whether a zone between two places is possible, and the beam would otherwise be in the foundation between them.
pub(super) fn is_even(setting: &Setting<'_>, from: f64, to: f64) -> bool {
    /// Places at which the pressure is looked at.
    const SAMPLES: u32 = 8;
    let length = to - from;
    let lifted = setting.load.breaks(from, to).iter().any(|&x| setting.load.point(x).is_some_and(|p| p.hi() < 0.0));
    let presses =
        !lifted && (0..=SAMPLES).all(|k| 0.0 <= pressure(setting, from + length * (f64::from(k) / f64::from(SAMPLES))));
    let middle = 0.5 * (from + to);
    let q = setting.load.cell(middle, middle).at(0.0.into()).middle();
    let sag = q * length * length * length * length / (384.0 * setting.stiffness);
    let ([u0, s0, ..], [u1, s1, ..]) = (setting.ground.jet(from), setting.ground.jet(to));
    let cubic = 0.5 * (u0.middle() + u1.middle()) + 0.125 * length * (s0.middle() - s1.middle());
    // What is lost in the difference of two depths.
    let rounding = 4.0 * f64::EPSILON * cubic.abs();
    presses && setting.ground.jet(middle)[0].middle() - cubic <= sag + rounding
}

/// The pressure `q − EI u''''` in a zone, about.
pub(super) fn pressure(setting: &Setting<'_>, x: f64) -> f64 {
    let fourth = setting.ground.cell(x, x).coefficients().get(4).map_or(0.0, |c| 24.0 * c.middle());
    setting.load.cell(x, x).at(0.0.into()).middle() - setting.stiffness * fourth
}
