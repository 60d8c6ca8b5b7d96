//! A span over which the beam changes: its stiffness, or a joint. It is a chain of spans that each have one stiffness, joined by their
//! clearance `h` and `n = e h''` where they meet.
//!
//! With the fixed-end moments `G` and shear forces `S` of a part of length `ℓ` ([`super::span`]), `N = n'` and `f = ℓ/e`,
//!
//! ```text
//! h'_a = (h_b − h_a)/ℓ − f (2 n_a + n_b)/6 + f (2 G_a + G_b)/6         N_a = (n_b − n_a)/ℓ − S_a
//! h'_b = (h_b − h_a)/ℓ + f (n_a + 2 n_b)/6 − f (G_a + 2 G_b)/6         N_b = (n_b − n_a)/ℓ + S_b
//! ```
//!
//! and where two parts meet `h`, `h'`, `n` and `N` jump by what the ground, a couple, a load and a joint do; of a joint with the
//! flexibility `w` the slope of the beam by `w e v''`. That is a chain of [blocks](crate::qp::blocks) in `h` and `n`, by an elimination in
//! which no digit is lost. A span that is computed in its deflection is the same above ground at zero, with `h = −v` and `n = −e v''`.
//!
//! Solved for a unit turn of each end, the chain says how `n` at both ends answers to their slopes.

use super::overhang::Overhang;
use super::piecewise::{Breakpoint, PiecewiseScene};
use super::span::{Drive, End, EndCondition, FixedEnd, Span, difference, fixed_end};
use super::way::{Prescribed, Way};
use crate::qp::blocks::{Block, PENALTY, factor_towards, solve_towards};

/// How the moments at both ends of a span answer to the slopes there.
pub(super) type Answer = [[f64; 2]; 2];

/// No deflection or moment of a dimensionless beam is larger, the loads and the stiffness of which are of the order of one: a mechanism
/// that only rounding holds moves by far more.
const MOST: f64 = 1e12;

/// A part of the span, with what its load does.
struct Part {
    ends: [End; 2],
    stiffness: f64,
    fixed: FixedEnd,
}

impl Part {
    fn length(&self) -> f64 {
        self.ends[1].x - self.ends[0].x
    }

    /// `h'` and `N` at both ends, from `h` and `n` there; with or without its load.
    fn ends(&self, [h, k]: [f64; 2], [n, m]: [f64; 2], loaded: bool) -> [[f64; 2]; 2] {
        let l = self.length();
        let (sixth, chord, rise) = (l / self.stiffness / 6.0, (k - h) / l, (m - n) / l);
        let [own_a, own_b] = if loaded { self.own() } else { [[0.0; 2]; 2] };
        [
            [chord - sixth * (2.0 * n + m) + own_a[0], rise + own_a[1]],
            [chord + sixth * (n + 2.0 * m) + own_b[0], rise + own_b[1]],
        ]
    }

    /// The same of its load alone.
    fn own(&self) -> [[f64; 2]; 2] {
        let (sixth, [g, k], [r, s]) = (self.length() / self.stiffness / 6.0, self.fixed.moment, self.fixed.shear);
        [[sixth * (2.0 * g + k), -r], [-sixth * (g + 2.0 * k), s]]
    }
}

/// Where two parts meet: by how much `h`, `h'`, `n` and `N` jump, and the flexibility of a joint.
#[derive(Debug, Clone, Copy, Default)]
struct Place {
    step: f64,
    kink: f64,
    couple: f64,
    shear: f64,
    joint: f64,
    /// `n` of a beam without moment there.
    straight: f64,
}

/// The parts of a span between two ends that is divided at some breakpoints, from left to right; [`None`] if it is a mechanism.
pub(super) fn between(
    given: &PiecewiseScene,
    [a, b]: [End; 2],
    divisions: &[usize],
    joint_at_end: f64,
) -> Option<Vec<Span>> {
    let way = Way::of(given, &a, &b);
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
        // Of the deflection the load is that of `−v`.
        let fixed = FixedEnd { moment: moment.map(|m| sign * m), shear: shear.map(|s| sign * s), clamped };
        Part { ends, stiffness, fixed }
    };
    let parts: Vec<Part> = starts.zip(ends).map(part).collect();
    let places: Vec<Place> = divisions.iter().map(|&i| place(given, i, way.in_beam)).collect();
    let chain = Chain { parts: &parts, places: &places, way: &way, joint_at_end, last: profile_bend(given, &b, &way) };
    let (states, answer) = chain.solve()?;
    let span = |(part, at): (&Part, &[[f64; 4]; 2])| {
        let profiles = [0, 1].map(|side| given.derivatives(part.ends[side].cell, part.ends[side].x));
        // What is computed is below the straight line through both ends.
        let line = |x: f64| {
            let [from, to] = [x - a.x, b.x - x];
            if from < to { way.levels[0] + way.incline * from } else { way.levels[1] - way.incline * to }
        };
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
    let mut spans: Vec<Span> = parts.iter().zip(&states).map(span).collect();
    if let Some(first) = spans.first_mut() {
        way.know(0, &mut first.at_a, &mut first.beam_a);
    }
    // Beyond a joint the slope is another one.
    if let Some(last) = spans.last_mut().filter(|_| joint_at_end == 0.0) {
        way.know(1, &mut last.at_b, &mut last.beam_b);
    }
    Some(spans)
}

/// The parts of the overhang between a free end of the beam and a node, from left to right: from part to part the beam is known at the
/// nearer end of it, and its moments at both by statics.
pub(super) fn overhang(given: &PiecewiseScene, held: End, slope: f64, at_left: bool) -> Vec<Span> {
    let divisions =
        if at_left { given.divisions_between(0.0, held.x) } else { given.divisions_between(held.x, given.length) };
    let sign = if at_left { 1.0 } else { -1.0 };
    let (mut spans, mut near, mut slope) = (Vec::new(), held, slope);
    let outwards: Vec<usize> = if at_left { divisions.iter().rev().copied().collect() } else { divisions.to_vec() };
    for i in outwards {
        let Breakpoint { x, force, couple, joint, .. } = given.breakpoints[i];
        let [left, right] = given.cells_beside(i);
        let (inside, outside) = if at_left { (right, left) } else { (left, right) };
        let far = End { x, low: 0.0, cell: inside, hold: EndCondition::Within };
        let (l, e) = ((near.x - x).abs(), given.cells[inside].stiffness);
        let (here, beyond) = (Overhang::of(given, near.x, at_left), Overhang::of(given, x, at_left));
        let bent = [here.moment, beyond.moment + sign * couple];
        let fixed = if at_left {
            fixed_end(given, &far, &near, Drive::Load)
        } else {
            fixed_end(given, &near, &far, Drive::Load)
        };
        let [g, k] = if at_left { [fixed.moment[1], fixed.moment[0]] } else { fixed.moment };
        // Turns from the chord, both counted outwards.
        let sixth = l / e / 6.0;
        let near_turn = sixth * (2.0 * (g - bent[0]) + (k - bent[1]));
        let far_turn = -sixth * ((g - bent[0]) + 2.0 * (k - bent[1]));
        let profiles = [given.derivatives(near.cell, near.x), given.derivatives(inside, x)];
        let level = near.hold.level(profiles[0][0]);
        let chord = -sign * slope - near_turn;
        let (next, turned) = (level + chord * l, -sign * (chord + far_turn));
        let beam = [[level, slope, bent[0], sign * here.force], [next, turned, bent[1], sign * (beyond.force + force)]];
        let mut at = [difference(&profiles[0], &beam[0]), difference(&profiles[1], &beam[1])];
        if near.hold == EndCondition::Resting {
            (at[0][0], at[0][1]) = (0.0, 0.0);
        }
        let order = if at_left { [1, 0] } else { [0, 1] };
        let ends = [near, far];
        spans.push(Span::of(order.map(|i| ends[i]), order.map(|i| at[i]), order.map(|i| beam[i]), e));
        // A hinge leaves it to what follows how it turns.
        let kink = if joint == 0.0 { 0.0 } else { joint * beyond.moment };
        slope = turned - sign * kink;
        let height = given.derivative(outside, x, 0) - next;
        near = End { x, low: 0.0, cell: outside, hold: EndCondition::Hinge { height, level: next, curvature: 0.0 } };
    }
    let mut last = Span::overhang(given, near, slope, at_left);
    if !spans.is_empty() {
        if at_left { last.b.hold = EndCondition::Within } else { last.a.hold = EndCondition::Within }
    }
    for span in &mut spans {
        for end in [&mut span.a, &mut span.b] {
            if matches!(end.hold, EndCondition::Hinge { .. }) && end.x.total_cmp(&held.x).is_ne() {
                end.hold = EndCondition::Within;
            }
        }
    }
    spans.push(last);
    if at_left {
        spans.reverse();
    }
    spans
}

/// `e g''` at the right end of a span, which its joint turns by; nothing where the span is computed in its deflection.
fn profile_bend(given: &PiecewiseScene, end: &End, way: &Way) -> f64 {
    if way.in_beam { 0.0 } else { given.bent(end.cell, end.x, 2) }
}

/// What happens at a breakpoint inside.
fn place(given: &PiecewiseScene, i: usize, in_beam: bool) -> Place {
    let Breakpoint { x, force, couple, step, kink, joint, .. } = given.breakpoints[i];
    if in_beam {
        return Place { couple: -couple, shear: -force, joint, ..Place::default() };
    }
    let [left, right] = [i - 1, i].map(|cell| given.derivatives(cell, x));
    // The slope of the beam jumps by `w e v'' = w (e g'' − n)`.
    let turned = if joint.is_finite() { joint * right[2] } else { 0.0 };
    let broken = given.breaks_at(i);
    Place {
        step: if broken { step } else { 0.0 },
        kink: if broken { kink } else { 0.0 } - turned,
        couple: right[2] - left[2] - couple,
        shear: right[3] - left[3] - force,
        joint,
        straight: right[2],
    }
}

/// A member of the chain with its right-hand sides.
#[derive(Default)]
struct Row {
    block: Block,
    theta: f64,
    right: [f64; 2],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

struct Chain<'a> {
    parts: &'a [Part],
    places: &'a [Place],
    way: &'a Way,
    joint_at_end: f64,
    last: f64,
}

impl Chain<'_> {
    /// `h, h', n, N` at both ends of each part, and the answer.
    fn solve(&self) -> Option<(Vec<[[f64; 4]; 2]>, Answer)> {
        let (mut rows, right) = self.rows();
        // With at most two hinges, of which the link between hangs by nothing else, each side of the last one holds itself.
        let last_hinge = self.places.iter().rposition(|place| place.joint.is_infinite());
        let meeting = last_hinge.map_or(self.parts.len(), |place| place + 1);
        factor_towards(&mut rows, meeting, |row| row.theta);
        let mut of = |right: &dyn Fn(usize) -> [f64; 2]| {
            rows.iter_mut().enumerate().for_each(|(i, row)| row.right = right(i));
            solve_towards(&mut rows, meeting, |row| row.right);
            let sound = rows.iter().all(|row| row.block.failed().is_none());
            sound.then(|| rows.iter().map(|row| row.block.step).collect::<Vec<_>>())
        };
        let found = of(&|i| right[i])?;
        // What nothing holds but rounding moves by any amount.
        if found.iter().flatten().any(|value| MOST < value.abs()) {
            return None;
        }
        let n = self.parts.len();
        let unit = |end: usize| move |i: usize| [0.0, if i == end { if end == 0 { 1.0 } else { -1.0 } } else { 0.0 }];
        let turned = [of(&unit(0))?, of(&unit(n))?];
        let answer = [[turned[0][0][1], turned[1][0][1]], [turned[0][n][1], turned[1][n][1]]];
        let state = |i: usize| {
            let Place { step, couple, .. } = if i + 1 < n { self.places[i] } else { Place::default() };
            let ([h, m], [k, o]) = (found[i], found[i + 1]);
            let (hs, ns) = ([h, k - step], [m, o - couple]);
            let [[a1, a3], [b1, b3]] = self.parts[i].ends(hs, ns, true);
            [[hs[0], a1, ns[0], a3], [hs[1], b1, ns[1], b3]]
        };
        Some(((0..n).map(state).collect(), answer))
    }

    /// The members, and what acts on each; `h` and `n` of a place are those on its right side.
    fn rows(&self) -> (Vec<Row>, Vec<[f64; 2]>) {
        let n = self.parts.len();
        let mut rows: Vec<Row> = (0..=n).map(|_| Row::default()).collect();
        let mut right = vec![[0.0; 2]; n + 1];
        for (i, part) in self.parts.iter().enumerate() {
            let third = part.length() / part.stiffness / 3.0;
            let Place { step, couple, .. } = if i + 1 < n { self.places[i] } else { Place::default() };
            let [[turn_a, shear_a], [turn_b, shear_b]] = part.ends([0.0, -step], [0.0, -couple], true);
            let w = rows[i].block.w + third;
            rows[i].block = Block::new(1.0 / part.length(), w, 0.5 * third);
            rows[i + 1].block.w += third;
            right[i] = [right[i][0] - shear_a, right[i][1] - turn_a];
            right[i + 1] = [right[i + 1][0] + shear_b, right[i + 1][1] + turn_b];
        }
        for (i, place) in self.places.iter().enumerate() {
            rows[i + 1].block.w += if place.joint.is_finite() { place.joint } else { PENALTY };
            let [pushed, bend] =
                [place.shear, if place.joint.is_finite() { place.kink } else { -PENALTY * place.straight }];
            right[i + 1] = [right[i + 1][0] + pushed, right[i + 1][1] + bend];
        }
        for (end, side) in [(0, 0), (n, 1)] {
            rows[end].theta = PENALTY;
            right[end][0] = PENALTY * if self.way.in_beam { 0.0 } else { self.way.heights[side] };
            let sign = if side == 0 { 1.0 } else { -1.0 };
            let (turned, bent) = if self.way.in_beam { (-1.0, 0.0) } else { (1.0, self.way.incline) };
            match self.way.held[side] {
                Prescribed::Slope(slope) => right[end][1] += sign * (turned * slope + bent),
                Prescribed::Curvature(bent) => {
                    rows[end].block.w += PENALTY;
                    right[end][1] = -PENALTY * turned * bent;
                }
            }
        }
        if self.joint_at_end.is_finite() {
            rows[n].block.w += self.joint_at_end;
            right[n][1] -= self.joint_at_end * self.last;
        } else {
            rows[n].block.w += PENALTY;
            right[n][1] = -PENALTY * self.last;
        }
        (rows, right)
    }
}

/// The parts of a span from left to right: mostly one.
pub(super) struct Parts {
    pub(super) first: Span,
    others: Vec<Span>,
}

impl Parts {
    /// One part.
    pub(super) fn one(first: Span) -> Self {
        Self { first, others: Vec::new() }
    }

    /// Of at least one.
    pub(super) fn of(mut parts: Vec<Span>) -> Self {
        let others = parts.split_off(1);
        Self { first: parts[0], others }
    }

    /// The last one.
    pub(super) fn last(&self) -> &Span {
        self.others.last().unwrap_or(&self.first)
    }
}

impl IntoIterator for Parts {
    type Item = Span;
    type IntoIter = std::iter::Chain<std::iter::Once<Span>, std::vec::IntoIter<Span>>;

    fn into_iter(self) -> Self::IntoIter {
        std::iter::once(self.first).chain(self.others)
    }
}
