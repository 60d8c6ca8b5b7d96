//! Slopes that the foundation allows: between those of the two sides of a corner, and away from it at a support.

use super::joints::{Joint, Kind, Setting};
use super::span::Span;

/// A slope that is off by less, as a share, is off by rounding.
const ROUNDING: f64 = 1e-12;
/// How far slopes at corners stay inside what is allowed, as a share: just enough for rounding.
const INSIDE: f64 = 1e-14;

/// Turns slopes at corners into the range that the foundation allows.
pub(super) fn at_corners(setting: &Setting<'_>, joints: &mut [Joint]) {
    for joint in joints.iter_mut().filter(|j| j.kind == Kind::Corner) {
        let [before, after] = setting.ground.slopes(joint.x);
        let margin = |bound: f64| INSIDE * (bound.abs() + joint.slope.abs());
        let least = before.map_or(f64::NEG_INFINITY, |b| b + margin(b));
        let most = after.map_or(f64::INFINITY, |a| a - margin(a));
        joint.slope = if least <= most { joint.slope.max(least).min(most) } else { 0.5 * (least + most) };
    }
}

/// A support that the foundation is level with holds a beam that would be steeper than the foundation, and lets go of one
/// that it would have to pull. True if one of them changed.
pub(super) fn at_supports(setting: &Setting<'_>, joints: &mut [Joint], may_let_go: bool) -> bool {
    let mut changed = false;
    let last = joints.len() - 1;
    for (i, sign) in [(0, 1.0), (last, -1.0)] {
        let Joint { kind, x, slope } = joints[i];
        let level = setting.ground.depth(x).magnitude() <= 0.0
            && setting.ground.side(x, i == last).is_none_or(|u| u.abs() <= 0.0);
        let ground = setting.ground.jet(x)[1].middle();
        match kind {
            Kind::Support if level && ROUNDING * (slope.abs() + ground.abs()) < sign * (slope - ground) => {
                joints[i].kind = Kind::Clamp;
                changed = true;
            }
            Kind::Clamp if may_let_go && bend(setting, joints, i) < 0.0 => {
                joints[i] = Joint::new(Kind::Support, x);
                changed = true;
            }
            _ => {}
        }
    }
    changed
}

/// `v''` of the beam at one of the ends.
fn bend(setting: &Setting<'_>, joints: &[Joint], end: usize) -> f64 {
    let span = |a: usize| setting.span(&joints[a], &joints[a + 1]);
    let jet =
        |s: Option<Span>, start: bool| s.map_or(0.0, |s| if start { s.start[2].middle() } else { s.end[2].middle() });
    if end == 0 { jet(span(0), true) } else { jet(span(end - 1), false) }
}

#[cfg(test)]
mod tests;
