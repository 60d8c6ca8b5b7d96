//! The chain of the parts of a span, solved.

use super::Answer;
use crate::qp::blocks::{Block, PENALTY, factor_towards, solve_towards};
use crate::theory::piecewise::{AtSpring, Breakpoint, PiecewiseScene};
use crate::theory::span::{End, FixedEnd};
use crate::theory::way::{Prescribed, Way};

/// No deflection or moment of a dimensionless beam is larger, the loads and the stiffness of which are of the order of one: a mechanism
/// that only rounding holds moves by far more.
const MOST: f64 = 1e12;

/// A part of the span, with what its load does.
pub(super) struct Part {
    pub(super) ends: [End; 2],
    pub(super) stiffness: f64,
    pub(super) fixed: FixedEnd,
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

/// An end of the chain, or where two parts meet: by how much `h`, `h'`, `n` and `N` jump, the flexibility of a joint, and the stiffness
/// of springs.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Place {
    step: f64,
    kink: f64,
    /// Less what a spring against turning makes of the slope of `h`.
    couple: f64,
    /// Less what a spring makes of `h`.
    shear: f64,
    joint: f64,
    /// `n` of a beam without moment there.
    straight: f64,
    spring: f64,
    turning: f64,
}

impl Place {
    /// A node with a joint, and `n` there of a beam without moment.
    pub(super) fn node(joint: f64, straight: f64) -> Self {
        Self { joint, straight, ..Self::default() }
    }

    /// What happens at a breakpoint of a span that is computed in one `way`, or in its deflection from a `line`, there with its slope.
    pub(super) fn at(given: &PiecewiseScene, i: usize, in_beam: bool, line: [f64; 2]) -> Self {
        let Breakpoint { x, force, couple, step, kink, joint, .. } = given.breakpoints[i];
        if in_beam {
            let place = Self { couple: -couple, shear: -force, joint, ..Self::default() };
            return place.on(given.spring_at(i), line);
        }
        let [left, right] = given.cells_beside(i).map(|cell| given.derivatives(cell, x));
        // The slope of the beam jumps by `w e v'' = w (e g'' − n)`.
        let turned = if joint.is_finite() { joint * right[2] } else { 0.0 };
        let broken = given.breaks_at(i);
        let place = Self {
            step: if broken { step } else { 0.0 },
            kink: if broken { kink } else { 0.0 } - turned,
            couple: right[2] - left[2] - couple,
            shear: right[3] - left[3] - force,
            joint,
            straight: right[2],
            ..Self::default()
        };
        place.on(given.spring_at(i), [right[0], left[1]])
    }

    /// The same on a spring, below a deflection from `line`, with its slope.
    fn on(self, spring: Option<&AtSpring>, [depth, slope]: [f64; 2]) -> Self {
        let Some(AtSpring { stiffness, level, turning, .. }) = spring else { return self };
        let [turning, without] = turning.unwrap_or_default();
        let couple = if 0.0 < turning { self.couple - turning * (slope - without) } else { self.couple };
        Self { couple, shear: self.shear + stiffness * (depth - level), spring: *stiffness, turning, ..self }
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

/// The members, what acts on each, and those of each place: before a spring against turning there, and behind it.
struct Rows {
    rows: Vec<Row>,
    right: Vec<[f64; 2]>,
    at: Vec<[usize; 2]>,
}

pub(super) struct Chain<'a> {
    pub(super) parts: &'a [Part],
    /// One more than parts.
    pub(super) places: &'a [Place],
    pub(super) way: &'a Way,
    /// `n` and `N` beyond an end that a spring holds, and no node.
    pub(super) beyond: [Option<[f64; 2]>; 2],
}

impl Chain<'_> {
    /// `h, h', n, N` at both ends of each part, and the answer.
    pub(super) fn solve(&self) -> Option<(Vec<[[f64; 4]; 2]>, Answer)> {
        let Rows { mut rows, right, at } = self.rows();
        // With at most two hinges, of which the link between hangs by nothing else, each side of the last one holds itself.
        let inside = &self.places[..self.parts.len()];
        let last_hinge = inside.iter().skip(1).rposition(|place| place.joint.is_infinite());
        let meeting = last_hinge.map_or(rows.len() - 1, |before| at[before + 1][1]);
        factor_towards(&mut rows, meeting, |row| row.theta);
        let mut of = |right: &dyn Fn(usize) -> [f64; 2]| {
            rows.iter_mut().enumerate().for_each(|(i, row)| row.right = right(i));
            solve_towards(&mut rows, meeting, |row| row.right);
            let sound = rows.iter().all(|row| row.block.failed().is_none());
            sound.then(|| rows.iter().map(|row| row.block.step).collect::<Vec<_>>())
        };
        let found = of(&|i| right[i])?;
        // What nothing holds but rounding moves by any amount.
        let hinged = self.places.iter().any(|place| place.joint.is_infinite());
        if hinged && found.iter().flatten().any(|value| MOST < value.abs()) {
            return None;
        }
        let n = self.parts.len();
        let ends = [at[0][1], at[n][0]];
        let mut turned = |side: usize| {
            let unit = if side == 0 { 1.0 } else { -1.0 };
            let bent = match self.beyond[side] {
                Some(_) => return Some([0.0; 2]),
                None => of(&|i| [0.0, if i == ends[side] { unit } else { 0.0 }])?,
            };
            Some(ends.map(|end| bent[end][1]))
        };
        let [first, last] = [turned(0)?, turned(1)?];
        let answer = [0, 1].map(|end| [first[end], last[end]]);
        let state = |i: usize| {
            let Place { step, couple, .. } = self.places[i + 1];
            let ([h, m], [k, o]) = (found[at[i][1]], found[at[i + 1][0]]);
            let (hs, ns) = ([h, k - step], [m, o - couple]);
            let [[a1, a3], [b1, b3]] = self.parts[i].ends(hs, ns, true);
            [[hs[0], a1, ns[0], a3], [hs[1], b1, ns[1], b3]]
        };
        Some(((0..n).map(state).collect(), answer))
    }

    /// The members; `h` and `n` of a place are those on its right side.
    fn rows(&self) -> Rows {
        let (n, mut count) = (self.parts.len(), 0);
        let of = |place: &Place| {
            let first = count;
            count += 1 + usize::from(0.0 < place.turning);
            [first, count - 1]
        };
        let at: Vec<[usize; 2]> = self.places.iter().map(of).collect();
        let mut rows: Vec<Row> = (0..count).map(|_| Row::default()).collect();
        let mut right = vec![[0.0; 2]; count];
        for (i, part) in self.parts.iter().enumerate() {
            let third = part.length() / part.stiffness / 3.0;
            let Place { step, couple, .. } = self.places[i + 1];
            let [[turn_a, shear_a], [turn_b, shear_b]] = part.ends([0.0, -step], [0.0, -couple], true);
            let ([_, from], [to, _]) = (at[i], at[i + 1]);
            let w = rows[from].block.w + third;
            rows[from].block = Block::new(1.0 / part.length(), w, 0.5 * third);
            rows[to].block.w += third;
            right[from] = [right[from][0] - shear_a, right[from][1] - turn_a];
            right[to] = [right[to][0] + shear_b, right[to][1] + turn_b];
        }
        let mut all = Rows { rows, right, at };
        self.places[1..n].iter().enumerate().for_each(|(i, place)| all.join(i + 1, place));
        for (place, [first, _]) in self.places.iter().zip(&all.at).filter(|(place, _)| 0.0 < place.turning) {
            all.rows[*first].block = all.rows[*first].block.turning(place.turning);
        }
        self.end(&mut all, 0);
        self.end(&mut all, 1);
        all
    }

    /// What holds an end.
    fn end(&self, Rows { rows, right, at }: &mut Rows, side: usize) {
        let (n, sign) = (self.parts.len(), if side == 0 { 1.0 } else { -1.0 });
        let (place, [first, end]) = if side == 0 { (&self.places[0], at[0]) } else { (&self.places[n], at[n]) };
        if let Some([bent, shear]) = self.beyond[side] {
            rows[end].theta = place.spring;
            right[end][0] += place.shear + sign * shear;
            // On the left `n` is known before what acts at the place, on the right behind it.
            let (row, bent) = if side == 0 { (first, bent + place.couple) } else { (end, bent) };
            rows[row].block.w += PENALTY;
            right[row][1] = -PENALTY * bent;
            return;
        }
        rows[end].theta = PENALTY;
        right[end][0] = PENALTY * if self.way.in_beam { 0.0 } else { self.way.heights[side] };
        let (turned, bent) = if self.way.in_beam { (-1.0, 0.0) } else { (1.0, self.way.incline) };
        match self.way.held[side] {
            Prescribed::Slope(slope) => right[end][1] += sign * (turned * slope + bent),
            Prescribed::Curvature(bent) => {
                rows[end].block.w += PENALTY;
                right[end][1] = -PENALTY * turned * bent;
            }
        }
        // A joint at the right end is a part of the span.
        if place.joint.is_finite() {
            rows[end].block.w += place.joint;
            right[end][1] -= place.joint * place.straight;
        } else {
            rows[end].block.w += PENALTY;
            right[end][1] = -PENALTY * place.straight;
        }
    }
}

impl Rows {
    /// A place inside.
    fn join(&mut self, i: usize, place: &Place) {
        let [_, main] = self.at[i];
        self.rows[main].theta = place.spring;
        self.rows[main].block.w += if place.joint.is_finite() { place.joint } else { PENALTY };
        let bend = if place.joint.is_finite() { place.kink } else { -PENALTY * place.straight };
        self.right[main] = [self.right[main][0] + place.shear, self.right[main][1] + bend];
    }
}
