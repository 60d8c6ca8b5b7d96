//! Changes of a pattern that does not fit.

use super::fill::pressure;
use super::hold;
use super::joints::{Joint, Kind, Setting};
use super::load::cells;
use super::span::Span;

/// Changes the pattern where it does not fit: joints that pull go, a point at which the beam is bent more than the
/// foundation becomes a zone, zones that pull open, and the beam gets a joint where it is deepest in the foundation. True if anything changed.
pub(super) fn adjust(setting: &Setting<'_>, joints: &mut Vec<Joint>) -> bool {
    if hold::at_supports(setting, joints, true) {
        return true;
    }
    let spans: Vec<Option<Span>> = joints.windows(2).map(|w| setting.span(&w[0], &w[1])).collect();
    let shear = |span: &Option<Span>, jet: fn(&Span) -> f64| span.as_ref().map(|s| -setting.stiffness * jet(s));
    let mut pulls: Option<(usize, f64)> = None;
    let mut flat: Option<usize> = None;
    for i in 1..joints.len().saturating_sub(1) {
        let (left, right) = (&spans[i - 1], &spans[i]);
        if !matches!(joints[i].kind, Kind::Corner | Kind::Touch) {
            continue;
        }
        let before = shear(left, |s| s.end[3].middle()).unwrap_or_default();
        let after = shear(right, |s| s.start[3].middle()).unwrap_or_default();
        let force = after - before + setting.load.point(joints[i].x).map_or(0.0, |p| p.middle());
        if force < 0.0 && pulls.is_none_or(|(_, worst)| force < worst) {
            pulls = Some((i, force));
        }
        let bent = right.as_ref().map_or(0.0, |s| s.start[2].middle());
        if joints[i].kind == Kind::Touch && setting.ground.jet(joints[i].x)[2].middle() < bent {
            flat = Some(i);
        }
    }
    if let Some((i, _)) = pulls {
        joints.remove(i);
        return true;
    }
    if let Some(i) = flat {
        let half = 0.01 * (joints[i].x - joints[i - 1].x).min(joints[i + 1].x - joints[i].x).min(0.1 * setting.length);
        let x = joints[i].x;
        joints.splice(i..=i, [Joint::new(Kind::Start, x - half), Joint::new(Kind::End, x + half)]);
        return true;
    }
    if round(setting, joints, &spans) || cut(setting, joints) {
        return true;
    }
    let deepest = spans.iter().flatten().filter_map(|span| deepest(setting, span)).max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((x, _)) = deepest else { return false };
    let at = joints.partition_point(|j| j.x < x);
    let kind = if setting.ground.is_smooth_at(x) { Kind::Touch } else { Kind::Corner };
    joints.insert(at, Joint::new(kind, x));
    true
}

/// A corner over which the beam is more inclined than the foundation beside it gives way to a point of contact on that
/// side. Where it comes to lie is a guess from slope and curvature.
fn round(setting: &Setting<'_>, joints: &mut [Joint], spans: &[Option<Span>]) -> bool {
    let mut changed = false;
    for i in 1..joints.len().saturating_sub(1) {
        let Joint { kind: Kind::Corner, x, slope } = joints[i] else { continue };
        let [before, after] = setting.ground.slopes(x);
        let guess = |turn: f64, curvature: f64, neighbour: f64| {
            let room = 0.5 * (neighbour - x).abs();
            let far = (turn / curvature).abs();
            if far < room { far } else { 0.5 * room }
        };
        let curvature = spans[i].as_ref().map_or(0.0, |s| s.start[2].middle());
        let segment = |x: f64| setting.ground.segment(x).unwrap_or([0.0, setting.length]);
        // Rounding must not make a corner of nothing give way.
        let steep = |turn: f64| 1e-12 * (slope.abs() + 1e-3) < turn;
        let place = if let Some(after) = after.filter(|after| steep(slope - after)) {
            let end = joints[i + 1].x.min(segment(x)[1]);
            x + guess(slope - after, curvature, end)
        } else if let Some(before) = before.filter(|before| steep(before - slope)) {
            let end = joints[i - 1].x.max(segment(x.next_down())[0]);
            x - guess(before - slope, curvature, end)
        } else {
            continue;
        };
        joints[i] = Joint::new(Kind::Touch, place);
        changed = true;
    }
    changed
}

/// Opens a zone where it would have to pull: at a point load upwards, and where `q < EI u''''`. True if one was opened.
fn cut(setting: &Setting<'_>, joints: &mut Vec<Joint>) -> bool {
    /// Places at which the pressure is looked at.
    const SAMPLES: u32 = 128;
    for i in 1..joints.len() {
        let (from, to) = (joints[i - 1].x, joints[i].x);
        if joints[i - 1].kind != Kind::Start {
            continue;
        }
        let step = (to - from) / f64::from(SAMPLES);
        let lifts = |x: &f64| setting.load.point(*x).is_some_and(|p| p.hi() < 0.0);
        let at_load = setting.load.breaks(from, to).into_iter().find(lifts).map(|x| [x - step, x + step]);
        let pulls = |k: &u32| pressure(setting, from + f64::from(*k) * step) < 0.0;
        let stretch = || {
            let first = (1..SAMPLES).find(pulls)?;
            let last = (first..SAMPLES).take_while(pulls).last()?;
            Some([from + (f64::from(first) - 0.5) * step, from + (f64::from(last) + 0.5) * step])
        };
        if let Some([end, start]) = at_load.or_else(stretch)
            && from < end
            && start < to
        {
            joints.splice(i..i, [Joint::new(Kind::End, end), Joint::new(Kind::Start, start)]);
            return true;
        }
    }
    false
}

/// Where in a span the beam is deepest in the foundation, and how deep.
fn deepest(setting: &Setting<'_>, span: &Span) -> Option<(f64, f64)> {
    /// Places in a cell, and at least in a span.
    const SAMPLES: usize = 4;
    let mut breaks = setting.ground.breaks(span.from, span.to);
    let parts = 8 * SAMPLES;
    #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
    breaks.extend((1..parts).map(|k| span.from + span.length() * (k as f64 / parts as f64)));
    breaks.extend(setting.load.breaks(span.from, span.to));
    let all = cells(span.from, span.to, breaks.clone());
    let curve = span.curve(breaks, setting.load, setting.stiffness);
    let scale = span.start.iter().chain(&span.end).fold(0.0, |most: f64, j| most.max(j.magnitude()));
    // Below this it is rounding, which the proof has its own way with.
    let mut worst = 1e-11 * scale;
    let mut found = None;
    for (&[from, to], (_, v)) in all.iter().zip(&curve) {
        let h = setting.ground.cell(from, to).minus(v);
        for k in 0..SAMPLES {
            #[expect(clippy::cast_precision_loss, reason = "a few")]
            let s = (to - from) * (k as f64 / SAMPLES as f64);
            if span.from < from + s {
                let depth = -h.at(s.into()).middle();
                if worst < depth {
                    worst = depth;
                    found = Some((from + s, depth));
                }
            }
        }
    }
    found
}
