//! A span with changes of the beam inside: steps of its stiffness, joints or springs. It is a chain of spans with one stiffness each,
//! joined by their clearance `h` and `n = e h''` where they meet.
//!
//! With the fixed-end moments `G` and shear forces `S` of a part of length `ℓ` ([`super::span`]), `N = n'` and `f = ℓ/e`,
//!
//! ```text
//! h'_a = (h_b − h_a)/ℓ − f (2 n_a + n_b)/6 + f (2 G_a + G_b)/6         N_a = (n_b − n_a)/ℓ − S_a
//! h'_b = (h_b − h_a)/ℓ + f (n_a + 2 n_b)/6 − f (G_a + 2 G_b)/6         N_b = (n_b − n_a)/ℓ + S_b
//! ```
//!
//! Where two parts meet, `h`, `h'`, `n` and `N` jump because of the foundation, a couple, a load or a joint. A joint with the flexibility
//! `w` makes the slope of the beam jump by `w e v''`. This is a chain of [blocks](crate::qp::blocks) in `h` and `n`, solved by an
//! elimination that loses no digits. A span that is computed in its deflection is treated in the same way above a foundation at zero,
//! with `h = −v` and `n = −e v''`.
//!
//! The solution for a unit rotation of each end gives the response of `n` at both ends to the slopes there.
//!
//! At a spring `N` jumps by `k (v − d)`, at a rotational spring `n` jumps by `k (v' − φ)`. If springs restrain the beam beyond the
//! outermost node, or without any node, the chain ends at the outermost spring. Beyond it the beam overhangs.

mod chain;

use super::overhang::Overhang;
use super::piecewise::{Breakpoint, PiecewiseScene};
use super::span::{Drive, End, EndCondition, FixedEnd, Span, difference, fixed_end};
use super::tension::Tense;
use super::way::Way;
use chain::{Chain, Part, Place};

/// Response of the moments at both ends of a span to the slopes there.
pub(super) type Answer = [[f64; 2]; 2];

/// The parts of a span between two ends, with the joint at its right end. There is one part if the beam does not change and no axial
/// force acts.
pub(super) fn parts(given: &PiecewiseScene, [a, b]: [End; 2], joint: f64) -> Parts {
    let divisions = given.divisions_between(a.x, b.x);
    if divisions.is_empty() && joint == 0.0 && given.tension == 0.0 {
        return Parts::one(Span::between(given, a, b));
    }
    // For a mechanism the span has no known values.
    between(given, [a, b], divisions, joint).map_or_else(|| Parts::one(Span::between(given, a, b).unknown()), Parts::of)
}

/// The parts of a span between two ends with divisions at some breakpoints, from left to right; [`None`] if it is a mechanism.
pub(super) fn between(
    given: &PiecewiseScene,
    [a, b]: [End; 2],
    divisions: &[usize],
    joint_at_end: f64,
) -> Option<Vec<Span>> {
    let is_free = [a, b].map(|end| end.hold == EndCondition::Free);
    let way = match is_free {
        [true, true] => Way::afloat(given, [a, b], None),
        [false, false] => Way::of(given, &a, &b),
        [left, _] => Way::overhanging(given, [a, b], usize::from(!left)),
    };
    let place = |side: usize| match is_free[side] {
        true => {
            let line = [way.levels[side], way.incline];
            Place::at(given, if side == 0 { 0 } else { given.cells.len() }, way.in_beam, line)
        }
        false if side == 0 => Place::default(),
        false => Place::node(joint_at_end, profile_bend(given, &b, &way)),
    };
    let tips = [0, 1].map(|side| is_free[side].then(|| tip(given, &way, side)));
    let (mut spans, _) = chained(given, [a, b], divisions, &way, ([0, 1].map(place), tips))?;
    if let Some(first) = spans.first_mut() {
        way.set_known(0, &mut first.at_a, &mut first.beam_a);
    }
    // A joint at the right end makes the slope before it unknown.
    if let Some(last) = spans.last_mut().filter(|_| joint_at_end == 0.0) {
        way.set_known(1, &mut last.at_b, &mut last.beam_b);
    }
    Some(spans)
}

/// The parts and the response of a span, with the conditions at both ends and, where springs end the chain, `n` and `N` beyond them.
fn chained(
    given: &PiecewiseScene,
    [a, b]: [End; 2],
    divisions: &[usize],
    way: &Way,
    ([first, last], beyond): ([Place; 2], [Option<[f64; 2]>; 2]),
) -> Option<(Vec<Span>, Answer)> {
    let of = if way.in_beam { Drive::Load } else { Drive::Clearance };
    let sign = if way.in_beam { -1.0 } else { 1.0 };
    let within = |breakpoint: usize, cell: usize| End {
        x: given.breakpoints[breakpoint].x,
        low: 0.0,
        cell,
        hold: EndCondition::Within,
    };
    let starts = std::iter::once(a).chain(divisions.iter().map(|&i| within(i, i)));
    let ends = divisions.iter().map(|&i| within(i, i - 1)).chain([b]);
    let part = |ends: (End, End)| {
        let (ends, stiffness) = ([ends.0, ends.1], given.cells[ends.0.cell].stiffness);
        let FixedEnd { moment, shear, clamped } = fixed_end(given, &ends[0], &ends[1], of);
        // In the deflection, the load is the load of `−v`.
        let fixed = FixedEnd { moment: moment.map(|m| sign * m), shear: shear.map(|s| sign * s), clamped };
        let tense = Tense::of(given, &ends, of, sign);
        Part { ends, stiffness, fixed, tense }
    };
    let parts: Vec<Part> = starts.zip(ends).map(part).collect();
    // The unknown is measured from the straight line through both ends.
    let line = |x: f64| {
        let [from, to] = [x - a.x, b.x - x];
        if from < to { way.levels[0] + way.incline * from } else { way.levels[1] - way.incline * to }
    };
    let at = |&i: &usize| Place::at(given, i, way.in_beam, [line(given.breakpoints[i].x), way.incline]);
    let places: Vec<Place> = std::iter::once(first).chain(divisions.iter().map(at)).chain([last]).collect();
    let (states, answer) = Chain { parts: &parts, places: &places, way, beyond }.solve()?;
    let span = |(part, at): (&Part, &[[f64; 4]; 2])| {
        let profiles = [0, 1].map(|side| given.derivatives(part.ends[side].cell, part.ends[side].x));
        let both = [0, 1].map(|side| {
            let ([h, h1, n, shear], profile) = (at[side], &profiles[side]);
            if way.in_beam {
                let beam = [line(part.ends[side].x) - h, way.incline - h1, -n, -shear];
                (difference(profile, &beam), beam)
            } else {
                (at[side], difference(profile, &at[side]))
            }
        });
        let span = Span::of(part.ends, both.map(|both| both.0), both.map(|both| both.1), part.stiffness);
        Span { answer: Some(answer), ..span }
    };
    Some((parts.iter().zip(&states).map(span).collect(), answer))
}

/// The beam from a node to the outermost spring beyond it, including the overhang behind that spring; without nodes the whole beam. Parts
/// are ordered from left to right.
pub(super) fn on_springs(given: &PiecewiseScene, nodes: [Option<End>; 2], joint_at_end: f64) -> Vec<Span> {
    let ends = [(0.0, 0), (given.length, given.cells.len() - 1)].map(|(x, cell)| End::free(x, cell));
    let whole = [0, 1].map(|side| nodes[side].unwrap_or(ends[side]));
    sprung(given, nodes, joint_at_end).unwrap_or_else(|| {
        // For a mechanism the span has no known values.
        vec![Span::of(whole, [[0.0; 4]; 2], [[0.0; 4]; 2], 1.0).unknown()]
    })
}

fn sprung(given: &PiecewiseScene, nodes: [Option<End>; 2], joint_at_end: f64) -> Option<Vec<Span>> {
    let outermost = [given.acting().next()?.breakpoint, given.acting().next_back()?.breakpoint];
    let end = |side: usize| {
        let (i, cells) = (outermost[side], given.cells_beside(outermost[side]));
        let is_end = if side == 0 { i == 0 } else { i == given.cells.len() };
        let hold = if is_end { EndCondition::Free } else { EndCondition::Within };
        End { hold, ..End::free(given.breakpoints[i].x, cells[1 - side]) }
    };
    let ends = [0, 1].map(|side| nodes[side].unwrap_or_else(|| end(side)));
    let level = nodes.into_iter().flatten().next();
    let way = Way::afloat(given, ends, level);
    let overhangs = [true, false].map(|left| Overhang::of(given, ends[usize::from(!left)].x, left));
    let hangs = [0, 1].map(|side| nodes[side].is_none());
    // Beyond a hinge no moment can be carried.
    let is_hinged = |side: usize| hangs[side] && given.breakpoints[outermost[side]].is_hinge();
    if is_hinged(0) || is_hinged(1) {
        return None;
    }
    let (mut spans, answer) = if ends[0].x < ends[1].x {
        let beyond = [0, 1].map(|side| {
            let Overhang { force, moment, .. } = overhangs[side];
            hangs[side].then_some([-moment, if side == 0 { -force } else { force }])
        });
        let held = [Place::default(), Place::node(joint_at_end, 0.0)];
        let line = [way.levels[0], 0.0];
        let places =
            [0, 1].map(|side| if hangs[side] { Place::at(given, outermost[side], true, line) } else { held[side] });
        let divisions = given.divisions_between(ends[0].x, ends[1].x);
        chained(given, ends, divisions, &way, (places, beyond))?
    } else {
        (Vec::new(), Answer::default())
    };
    // The state on both sides of a spring that holds the beam alone, otherwise of the outermost springs.
    let alone = spans.is_empty().then(|| alone(given, outermost[0], &overhangs)).flatten();
    let states = [spans.first().map(|span| span.beam_a), spans.last().map(|span| span.beam_b)];
    for side in (0..2).filter(|&side| hangs[side] && ends[side].hold == EndCondition::Within) {
        let [level, slope] = states[side].map(|beam| [beam[0], beam[1]]).or(alone)?;
        let bent = states[side].map_or(0.0, |beam| beam[2]);
        let beyond = beyond(given, outermost[side], side, [level, slope, bent]);
        let beyond = beyond.into_iter().map(|span| Span { answer: Some(answer), ..span });
        spans.splice(if side == 0 { 0..0 } else { spans.len()..spans.len() }, beyond);
    }
    Some(spans)
}

/// The overhang beyond the outermost spring on a side, from deflection, slope and `e v''` there.
fn beyond(given: &PiecewiseScene, i: usize, side: usize, [level, slope, bent]: [f64; 3]) -> Vec<Span> {
    let Breakpoint { x, joint, acts, .. } = given.breakpoints[i];
    // A joint belongs to the part on its left.
    let slope = match side {
        _ if joint <= 0.0 => slope,
        0 => slope - joint * (bent - acts.couple()),
        _ => slope + joint * bent,
    };
    let cell = given.cells_beside(i)[side];
    let height = given.derivative(cell, x, 0) - level;
    let hold = EndCondition::Hinge { height, level, curvature: 0.0 };
    let mut beyond = overhang(given, End { hold, ..End::free(x, cell) }, slope, side == 0);
    for end in beyond.iter_mut().flat_map(|span| [&mut span.a, &mut span.b]) {
        if end.hold.is_hinged() && end.hold != EndCondition::Free {
            end.hold = EndCondition::Within;
        }
    }
    beyond
}

/// Deflection and slope at a single spring with a rotational spring that holds a beam; [`None`] if it cannot hold the beam.
fn alone(given: &PiecewiseScene, i: usize, [left, right]: &[Overhang; 2]) -> Option<[f64; 2]> {
    let (spring, at) = (given.spring_at(i)?, &given.breakpoints[i]);
    let [k, without] = spring.turning?;
    let force = left.force + right.force + at.acts.force();
    // `M` jumps by the couple and by `−k (v' − φ)`.
    Some([spring.level + force / spring.stiffness, without - (left.moment - right.moment + at.acts.couple()) / k])
}

/// The parts of the overhang between a free end of the beam and a node, from left to right. From part to part, the state of the beam is
/// known at the nearer end, and statics gives the moments at both ends.
pub(super) fn overhang(given: &PiecewiseScene, held: End, slope: f64, at_left: bool) -> Vec<Span> {
    let divisions =
        if at_left { given.divisions_between(0.0, held.x) } else { given.divisions_between(held.x, given.length) };
    let sign = if at_left { 1.0 } else { -1.0 };
    let (mut spans, mut near, mut slope) = (Vec::new(), held, slope);
    let outwards: Vec<usize> = if at_left { divisions.iter().rev().copied().collect() } else { divisions.to_vec() };
    for i in outwards {
        let Breakpoint { x, acts, joint, .. } = given.breakpoints[i];
        let [left, right] = given.cells_beside(i);
        let (inside, outside) = if at_left { (right, left) } else { (left, right) };
        let far = End { x, low: 0.0, cell: inside, hold: EndCondition::Within };
        let (l, e) = ((near.x - x).abs(), given.cells[inside].stiffness);
        let (here, beyond) = (Overhang::of(given, near.x, at_left), Overhang::of(given, x, at_left));
        let bent = [here.moment, beyond.moment + sign * acts.couple()];
        let fixed = if at_left {
            fixed_end(given, &far, &near, Drive::Load)
        } else {
            fixed_end(given, &near, &far, Drive::Load)
        };
        let [g, k] = if at_left { [fixed.moment[1], fixed.moment[0]] } else { fixed.moment };
        // Rotations relative to the chord, both counted outwards.
        let sixth = l / e / 6.0;
        let near_turn = sixth * (2.0 * (g - bent[0]) + (k - bent[1]));
        let far_turn = -sixth * ((g - bent[0]) + 2.0 * (k - bent[1]));
        let profiles = [given.derivatives(near.cell, near.x), given.derivatives(inside, x)];
        let level = near.hold.level(profiles[0][0]);
        let chord = -sign * slope - near_turn;
        let (next, turned) = (level + chord * l, -sign * (chord + far_turn));
        let beam =
            [[level, slope, bent[0], sign * here.force], [next, turned, bent[1], sign * (beyond.force + acts.force())]];
        let mut at = [difference(&profiles[0], &beam[0]), difference(&profiles[1], &beam[1])];
        at[0][0] = near.hold.height();
        if near.hold == EndCondition::Resting {
            at[0][1] = 0.0;
        }
        let order = if at_left { [1, 0] } else { [0, 1] };
        let ends = [near, far];
        spans.push(Span::of(order.map(|i| ends[i]), order.map(|i| at[i]), order.map(|i| beam[i]), e));
        // The rotation of a hinge is determined by the parts beyond it.
        let kink = if joint == 0.0 || beyond.moment == 0.0 { 0.0 } else { joint * beyond.moment };
        slope = turned - sign * kink;
        let height = given.derivative(outside, x, 0) - next;
        near = End { x, low: 0.0, cell: outside, hold: EndCondition::Hinge { height, level: next, curvature: 0.0 } };
    }
    let mut last = Span::overhang(given, near, slope, at_left);
    if !spans.is_empty() {
        if at_left { last.b.hold = EndCondition::Within } else { last.a.hold = EndCondition::Within }
    }
    for end in spans.iter_mut().flat_map(|span| [&mut span.a, &mut span.b]) {
        if matches!(end.hold, EndCondition::Hinge { .. }) && end.x.total_cmp(&held.x).is_ne() {
            end.hold = EndCondition::Within;
        }
    }
    spans.push(last);
    if at_left {
        spans.reverse();
    }
    spans
}

/// `e g''` at the right end of a span, as the joint there needs it; zero if the span is computed in its deflection.
fn profile_bend(given: &PiecewiseScene, end: &End, way: &Way) -> f64 {
    if way.in_beam { 0.0 } else { given.bent(end.cell, end.x, 2) }
}

/// `n` and the vertical force, in the sign convention of the chain, beyond a free end of the beam under an axial force.
fn tip(given: &PiecewiseScene, way: &Way, side: usize) -> [f64; 2] {
    if way.in_beam {
        return [0.0, -given.tension * way.incline];
    }
    let [_, slope, bent, third] = way.profiles[side];
    [bent, third - given.tension * slope]
}

/// The parts of a span from left to right: usually one.
pub(super) struct Parts {
    pub(super) first: Span,
    others: Vec<Span>,
}

impl Parts {
    /// A span of one part.
    pub(super) fn one(first: Span) -> Self {
        Self { first, others: Vec::new() }
    }

    /// A span of at least one part.
    pub(super) fn of(mut parts: Vec<Span>) -> Self {
        let others = parts.split_off(1);
        Self { first: parts[0], others }
    }

    /// All parts, from left to right.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Span> {
        std::iter::once(&self.first).chain(&self.others)
    }

    /// The last part.
    pub(super) fn last(&self) -> &Span {
        self.others.last().unwrap_or(&self.first)
    }
}
