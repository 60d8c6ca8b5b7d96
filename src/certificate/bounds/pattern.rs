//! The pattern of contact that nodal forces show, as joints, and its refinement. Nothing here has to be right: what comes
//! out is proved, or not, in [`super::proof`].

use super::joints::{Joint, Kind, Setting, newton};
use super::load::cells;
use super::span::Span;

/// Newton steps and changes of the pattern together.
const MOST_STEPS: usize = 120;
/// Changes of the pattern.
const MOST_CHANGES: usize = 24;
/// A change of place or turn of this share of the beam's length ends Newton's method; what is missing enters squared.
const CONVERGED: f64 = 1e-13;
/// A zone that is shorter, as a share of the beam's length, becomes a point.
const SHORTEST_ZONE: f64 = 1e-7;

/// A zone that comes as near to a support at which the foundation is level with it begins there.
const NEAR_A_SUPPORT: f64 = 1e-4;

/// Forces at nodes, from left to right, all positive, and the least distance of nodes.
pub(super) fn of_forces(setting: &Setting<'_>, forces: &[(f64, f64)], spacing: f64) -> Vec<Joint> {
    let mut joints = Vec::new();
    for cluster in runs(forces, reach(setting.length, spacing)) {
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
            let (from, to) = (part[0].0, part[part.len() - 1].0);
            // One force may be shared by two nodes.
            if part.len() < 3 {
                let sum: f64 = part.iter().map(|f| f.1).sum();
                joints.push(Joint::new(Kind::Touch, part.iter().map(|f| f.0 * (f.1 / sum)).sum()));
            } else {
                joints.extend([Joint::new(Kind::Start, from), Joint::new(Kind::End, to)]);
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
    with_supports(setting, joints.collect(), 0.0)
}

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

/// How far forces of one contact may be apart. The discrete optimum leaves an open interval behind lift-off; in units of
/// the spacing it measures 2, 3, 5, 11 for 100, 300, 1000, 10⁴ intervals of the paper's example.
fn reach(length: f64, spacing: f64) -> f64 {
    spacing * (1.5 + 0.6 * (length / spacing).powf(0.35))
}

fn runs(forces: &[(f64, f64)], reach: f64) -> impl Iterator<Item = &[(f64, f64)]> {
    forces.chunk_by(move |a, b| b.0 - a.0 <= reach)
}

/// Newton's method, and changes of the pattern where it does not fit; the joints that come out are in order.
pub(super) fn refined(setting: &Setting<'_>, mut joints: Vec<Joint>) -> Option<Vec<Joint>> {
    let mut changes = 0;
    fill(setting, &mut joints);
    for _ in 0..MOST_STEPS {
        let change = newton(setting, &mut joints)?;
        if collapse(setting, &mut joints) {
            continue;
        }
        if change <= CONVERGED * setting.length {
            if changes == MOST_CHANGES || !adjust(setting, &mut joints) {
                break;
            }
            fill(setting, &mut joints);
            changes += 1;
        }
    }
    Some(joints)
}

/// Zones without length become points, and zones that reach for a support begin there.
fn collapse(setting: &Setting<'_>, joints: &mut Vec<Joint>) -> bool {
    let short = SHORTEST_ZONE * setting.length;
    let found = joints.windows(2).position(|w| w[0].kind == Kind::Start && w[1].x - w[0].x < short);
    if let Some(i) = found {
        let middle = 0.5 * (joints[i].x + joints[i + 1].x);
        joints.splice(i..i + 2, [Joint::new(Kind::Touch, middle)]);
        return true;
    }
    let near = NEAR_A_SUPPORT * setting.length;
    let lies = |x: f64| setting.ground.depth(x).magnitude() <= 0.0;
    let mut moved = false;
    if let [first, second, ..] = joints[..]
        && second.kind == Kind::Start
        && first.kind == Kind::Support
        && second.x < near
        && lies(0.0)
    {
        joints.remove(0);
        joints[0].x = 0.0;
        moved = true;
    }
    if let [.., before, last] = joints[..]
        && before.kind == Kind::End
        && last.kind == Kind::Support
        && last.x - before.x < near
        && lies(last.x)
    {
        joints.pop();
        if let Some(end) = joints.last_mut() {
            end.x = last.x;
        }
        moved = true;
    }
    moved
}

/// Changes the pattern where it does not fit: joints that pull go, a point at which the beam is bent more than the
/// foundation becomes a zone, and the beam gets a joint where it is deepest in the foundation. True if anything changed.
fn adjust(setting: &Setting<'_>, joints: &mut Vec<Joint>) -> bool {
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
        let half = 0.2 * (joints[i].x - joints[i - 1].x).min(joints[i + 1].x - joints[i].x).min(0.1 * setting.length);
        let x = joints[i].x;
        joints.splice(i..=i, [Joint::new(Kind::Start, x - half), Joint::new(Kind::End, x + half)]);
        return true;
    }
    let deepest = spans.iter().flatten().filter_map(|span| deepest(setting, span)).max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((x, _)) = deepest else { return false };
    let at = joints.partition_point(|j| j.x < x);
    let kind = if setting.ground.is_smooth_at(x) { Kind::Touch } else { Kind::Corner };
    joints.insert(at, Joint::new(kind, x));
    true
}

/// Makes one zone of neighbouring contacts between which the foundation is too even to leave the beam free: it deviates from
/// the cubic between the two joints by less than half of what the load makes the beam sag there. Nodes in contact that
/// stand alone, and the open interval that the discrete optimum leaves behind lift-off, are zones in truth.
fn fill(setting: &Setting<'_>, joints: &mut Vec<Joint>) {
    let mut i = 0;
    while i + 1 < joints.len() {
        let (left, right) = (joints[i], joints[i + 1]);
        let ends = matches!(left.kind, Kind::Touch | Kind::End) && matches!(right.kind, Kind::Touch | Kind::Start);
        if ends && setting.ground.is_smooth_between(left.x, right.x) && is_even(setting, left.x, right.x) {
            let start = (left.kind == Kind::Touch).then(|| Joint::new(Kind::Start, left.x));
            let end = (right.kind == Kind::Touch).then(|| Joint::new(Kind::End, right.x));
            let filled: Vec<Joint> = start.into_iter().chain(end).collect();
            let next = filled.iter().any(|j| j.kind == Kind::End);
            joints.splice(i..=i + 1, filled);
            // What came out ends a zone, which may be filled on, or lies within one.
            i = if next {
                (0..=i + 1).rev().find(|&k| joints.get(k).is_some_and(|j| j.kind == Kind::End)).unwrap_or(i)
            } else {
                i
            };
        } else {
            i += 1;
        }
    }
}

fn is_even(setting: &Setting<'_>, from: f64, to: f64) -> bool {
    let length = to - from;
    let middle = 0.5 * (from + to);
    let q = setting.load.cell(middle, middle).at(0.0.into()).middle();
    let sag = q * length * length * length * length / (384.0 * setting.stiffness);
    let ([u0, s0, ..], [u1, s1, ..]) = (setting.ground.jet(from), setting.ground.jet(to));
    let cubic = 0.5 * (u0.middle() + u1.middle()) + 0.125 * length * (s0.middle() - s1.middle());
    // What is lost in the difference of two depths.
    let rounding = 4.0 * f64::EPSILON * cubic.abs();
    let off = setting.ground.jet(middle)[0].middle() - cubic;
    off.abs() <= (0.5 * sag).max(rounding)
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

/// Joints whose places are known: only the slopes at supports and corners are found.
pub(super) fn with_slopes(setting: &Setting<'_>, mut joints: Vec<Joint>) -> Vec<Joint> {
    let places: Vec<f64> = joints.iter().map(|j| j.x).collect();
    // Linear in the slopes; the second step is for rounding.
    for _ in 0..3 {
        let mut moved = joints.clone();
        if newton(setting, &mut moved).is_none() {
            break;
        }
        for ((joint, moved), x) in joints.iter_mut().zip(moved).zip(&places) {
            joint.slope = moved.slope;
            joint.x = *x;
        }
    }
    joints
}
