//! The solution of the chain of the parts of a span.

mod settled;

use super::Answer;
use crate::qp::blocks::{Block, PENALTY, factor, factor_under_tension, solve_towards};
use crate::theory::piecewise::{AtSpring, Breakpoint, PiecewiseScene};
use crate::theory::span::{End, FixedEnd};
use crate::theory::tension::Tense;
use crate::theory::way::{Prescribed, Way};
use settled::State;

/// A part of the span, with the effect of its load.
pub(super) struct Part {
    pub(super) ends: [End; 2],
    pub(super) stiffness: f64,
    pub(super) fixed: FixedEnd,
    /// The law of the part under an axial force, used instead of the fixed-end forces.
    pub(super) tense: Option<Tense>,
}

impl Part {
    fn length(&self) -> f64 {
        self.ends[1].x - self.ends[0].x
    }

    /// `h'`, the quantity in equilibrium where parts meet, and `N` at both ends, from `h` and `n` there. Without an axial force the
    /// latter two are the same.
    fn ends(&self, [h, k]: [f64; 2], [n, m]: [f64; 2]) -> [[f64; 3]; 2] {
        if let Some(tense) = &self.tense {
            return tense.ends([h, k], [n, m]);
        }
        let l = self.length();
        let (sixth, chord, rise) = (l / self.stiffness / 6.0, (k - h) / l, (m - n) / l);
        let [own_a, own_b] = self.own();
        let [shear_a, shear_b] = [rise + own_a[1], rise + own_b[1]];
        [
            [chord - sixth * (2.0 * n + m) + own_a[0], shear_a, shear_a],
            [chord + sixth * (n + 2.0 * m) + own_b[0], shear_b, shear_b],
        ]
    }

    /// The change of the quantity in equilibrium from end to end.
    fn loaded(&self) -> f64 {
        let [own_a, own_b] =
            self.tense.map_or_else(|| self.own().map(|own| own[1]), |tense| tense.own.map(|own| own[1]));
        own_b - own_a
    }

    /// `h'` and `N` caused by its load alone.
    fn own(&self) -> [[f64; 2]; 2] {
        let (sixth, [g, k], [r, s]) = (self.length() / self.stiffness / 6.0, self.fixed.moment, self.fixed.shear);
        [[sixth * (2.0 * g + k), -r], [-sixth * (g + 2.0 * k), s]]
    }
}

/// An end of the chain, or a position where two parts meet: the jumps of `h`, `h'`, `n` and `N`, the flexibility of a joint, and the
/// stiffness of springs.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Place {
    step: f64,
    kink: f64,
    /// Without the part that a rotational spring exerts in proportion to the slope of `h`.
    couple: f64,
    /// Without the part that a spring exerts in proportion to `h`.
    shear: f64,
    joint: f64,
    /// `n` of a beam without moment there: the slope of the beam jumps by `w e v'' = w (e g'' − n)`.
    straight: f64,
    spring: f64,
    turning: f64,
}

impl Place {
    /// A node with a joint, and `n` there of a beam without moment.
    pub(super) fn node(joint: f64, straight: f64) -> Self {
        Self { joint, straight, ..Self::default() }
    }

    /// The flexibility of a joint; zero for a hinge, whose rotation is computed separately from the chain.
    fn flexibility(&self) -> f64 {
        if self.joint.is_finite() { self.joint } else { 0.0 }
    }

    /// The jumps at a breakpoint of a span that is computed in its deflection (`in_beam`) relative to a `line`, given by its value and
    /// slope there, or in its clearance.
    pub(super) fn at(given: &PiecewiseScene, i: usize, in_beam: bool, line: [f64; 2]) -> Self {
        let Breakpoint { x, acts, step, kink, joint, .. } = given.breakpoints[i];
        let [couple, force] = acts.jumps();
        if in_beam {
            let place = Self { couple: -couple, shear: -force, joint, ..Self::default() };
            return place.on(given.spring_at(i), line);
        }
        let [left, right] = given.cells_beside(i).map(|cell| given.derivatives(cell, x));
        let broken = given.breaks_at(i);
        let place = Self {
            step: if broken { step } else { 0.0 },
            kink: if broken { kink } else { 0.0 },
            couple: right[2] - left[2] - couple,
            shear: right[3] - left[3] - force - if broken { given.tension * kink } else { 0.0 },
            joint,
            straight: right[2],
            ..Self::default()
        };
        place.on(given.spring_at(i), [right[0], left[1]])
    }

    /// Adds a spring. The deflection is measured from a line with this value and slope.
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
    /// Under an axial force `c² − n ω`.
    left: f64,
    right: [f64; 2],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

/// The members, the actions on each, and the members of each position: before a rotational spring there, and after it.
struct Rows {
    rows: Vec<Row>,
    right: Vec<[f64; 2]>,
    at: Vec<[usize; 2]>,
}

pub(super) struct Chain<'a> {
    pub(super) parts: &'a [Part],
    /// One more than there are parts.
    pub(super) places: &'a [Place],
    pub(super) way: &'a Way,
    /// `n` and `N` beyond an end that a spring holds instead of a node; under an axial force also beyond a free end.
    pub(super) beyond: [Option<[f64; 2]>; 2],
}

impl Chain<'_> {
    /// `h, h', n, N` at both ends of each part, and the response.
    pub(super) fn solve(&self) -> Option<(Vec<[[f64; 4]; 2]>, Answer)> {
        let Rows { mut rows, right, at } = self.rows();
        let axial = self.parts[0].tense.map(|tense| tense.force);
        let meeting = if axial.is_some_and(|force| self.ends_at_left(force)) { at[0][1] } else { rows.len() - 1 };
        match axial {
            Some(_) => factor_under_tension(&mut rows, meeting, |row| row.theta, |row| row.left),
            None => factor(&mut rows, |row| row.theta),
        }
        let hinges = Hinges::of(&mut rows, self.hinges(&at), meeting)?;
        let mut of = |right: &dyn Fn(usize) -> [f64; 2], loaded: bool| {
            rows.iter_mut().enumerate().for_each(|(i, row)| row.right = right(i));
            solve_towards(&mut rows, meeting, |row| row.right);
            hinges.turn(&mut rows, loaded);
            // Under compression a part next to a free end has a negative pivot, and other parts compensate for it.
            let is_compressed = axial.is_some_and(|force| force < 0.0);
            let bears = |row: &Row| row.block.failed().is_none() || is_compressed && row.block.is_finite();
            let sound = rows.iter().all(bears);
            sound.then(|| rows.iter().map(|row| row.block.step).collect::<Vec<_>>())
        };
        let found = of(&|i| right[i], true)?;
        let n = self.parts.len();
        let ends = [at[0][1], at[n][0]];
        let mut turned = |side: usize| {
            let unit = if side == 0 { 1.0 } else { -1.0 };
            let bent = match self.beyond[side] {
                Some(_) => return Some([0.0; 2]),
                None => of(&|i| [0.0, if i == ends[side] { unit } else { 0.0 }], false)?,
            };
            Some(ends.map(|end| bent[end][1]))
        };
        let [first, last] = [turned(0)?, turned(1)?];
        let answer = [0, 1].map(|end| [first[end], last[end]]);
        let state = |i: usize| {
            let Place { step, couple, .. } = self.places[i + 1];
            let ([h, m], [k, o]) = (found[at[i][1]], found[at[i + 1][0]]);
            let (hs, ns) = ([h, k - step], [m, o - couple]);
            let ends = self.parts[i].ends(hs, ns);
            State {
                h: hs,
                n: ns,
                slope: ends.map(|end| end[0]),
                shear: ends.map(|end| end[1]),
                third: ends.map(|end| end[2]),
            }
        };
        let states = self.settled((0..n).map(state).collect());
        let both = |State { h, n, slope, third, .. }: State| [0, 1].map(|end| [h[end], slope[end], n[end], third[end]]);
        Some((states.into_iter().map(both).collect(), answer))
    }

    /// Whether elimination under an axial force proceeds towards the left end. This end is free, or, between two nodes under tension, the
    /// part next to it is shorter than the part at the other end. The moment at the other node is a difference of slopes over the length
    /// of the part next to it, the moment at this node a difference over the length of the span.
    fn ends_at_left(&self, force: f64) -> bool {
        let length = |part: Option<&Part>| part.map_or(0.0, Part::length);
        match self.beyond {
            [Some(_), _] => true,
            [None, Some(_)] => false,
            [None, None] => 0.0 < force && length(self.parts.first()) < length(self.parts.last()),
        }
    }

    /// The rows of the hinges, and `n` there.
    fn hinges(&self, at: &[[usize; 2]]) -> Vec<(usize, f64)> {
        // If `n` is given at the right end, a hinge there is already free of moment.
        let free = if matches!(self.way.held[1], Prescribed::Curvature(_)) { self.parts.len() } else { at.len() };
        let hinges = self.places[..free].iter().zip(at).filter(|(place, _)| place.joint.is_infinite());
        hinges.map(|(place, [_, main])| (*main, place.straight)).collect()
    }

    /// The members; `h` and `n` of a position are the values on its right side.
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
            let Place { step, couple, .. } = self.places[i + 1];
            let [[turn_a, shear_a, _], [turn_b, shear_b, _]] = part.ends([0.0, -step], [0.0, -couple]);
            let ([_, from], [to, _]) = (at[i], at[i + 1]);
            let third = part.length() / part.stiffness / 3.0;
            let law = part.tense.map_or([1.0 / part.length(), 0.0, third, 0.5 * third, 0.0], |tense| tense.law);
            let [c, pull, third, off, left] = law;
            let w = rows[from].block.w + third;
            rows[from].block = Block::new(c, w, off).on_springs(-pull, 0.0);
            rows[from].left = left;
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

    /// Adds the conditions at an end.
    fn end(&self, Rows { rows, right, at }: &mut Rows, side: usize) {
        let (n, sign) = (self.parts.len(), if side == 0 { 1.0 } else { -1.0 });
        let (place, [first, end]) = if side == 0 { (&self.places[0], at[0]) } else { (&self.places[n], at[n]) };
        if let Some([bent, shear]) = self.beyond[side] {
            rows[end].theta = place.spring;
            right[end][0] += place.shear + sign * shear;
            // On the left, the known `n` is before the actions at the position; on the right, it is behind them.
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
        // A joint at the right end belongs to the span.
        let joint = place.flexibility();
        rows[end].block.w += joint;
        right[end][1] -= joint * place.straight;
    }
}

impl Rows {
    /// Adds an inner position.
    fn join(&mut self, i: usize, place: &Place) {
        let [_, main] = self.at[i];
        self.rows[main].theta = place.spring;
        let joint = place.flexibility();
        self.rows[main].block.w += joint;
        let bend = place.kink - joint * place.straight;
        self.right[main] = [self.right[main][0] + place.shear, self.right[main][1] + bend];
    }
}

/// The hinges of a chain that is factored without them: their rotations for which all moments in hinges are zero. If the elimination
/// included hinges, it would divide zero by zero where a part is suspended from one.
struct Hinges {
    /// The row of each hinge, and `n` there of a beam without moment.
    rows: Vec<(usize, f64)>,
    /// The inverse of the moments in all hinges under a unit rotation of each.
    turns: Vec<Vec<f64>>,
    /// The row towards which the chain is factored.
    meeting: usize,
}

impl Hinges {
    /// Computes the inverse; [`None`] for a mechanism.
    fn of(rows: &mut [Row], hinges: Vec<(usize, f64)>, meeting: usize) -> Option<Self> {
        let mut bent = Vec::with_capacity(hinges.len());
        for &(hinge, _) in &hinges {
            rows.iter_mut().for_each(|row| row.right = [0.0; 2]);
            rows[hinge].right[1] = 1.0;
            solve_towards(rows, meeting, |row| row.right);
            bent.push(hinges.iter().map(|&(other, _)| rows[other].block.step[1]).collect());
        }
        Some(Self { turns: inverse(bent)?, rows: hinges, meeting })
    }

    /// Adds the rotations to a solution of the rows.
    fn turn(&self, rows: &mut [Row], loaded: bool) {
        /// The second pass removes rounding.
        const TURNS: usize = 2;
        if self.rows.is_empty() {
            return;
        }
        for _ in 0..TURNS {
            let off =
                |&(hinge, straight): &(usize, f64)| rows[hinge].block.step[1] - if loaded { straight } else { 0.0 };
            let off: Vec<f64> = self.rows.iter().map(off).collect();
            for (k, (hinge, _)) in self.rows.iter().enumerate() {
                let turn: f64 = self.turns.iter().zip(&off).map(|(of, off)| of[k] * off).sum();
                rows[*hinge].right[1] -= turn;
            }
            solve_towards(rows, self.meeting, |row| row.right);
        }
    }
}

/// The inverse of a small matrix, by rows; [`None`] if it is singular within rounding.
fn inverse(mut rows: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    /// Lower limit of a pivot, as a share of the largest entry.
    const ROUNDING: f64 = 1e-11;
    let n = rows.len();
    let most = rows.iter().flatten().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    let unit = |i: usize| (0..n).map(move |j| f64::from(u8::from(i == j)));
    rows.iter_mut().enumerate().for_each(|(i, row)| row.extend(unit(i)));
    for column in 0..n {
        let pivot = (column..n).max_by(|i, j| rows[*i][column].abs().total_cmp(&rows[*j][column].abs()))?;
        rows.swap(column, pivot);
        let pivot = rows[column][column];
        if pivot.abs() <= ROUNDING * most || !pivot.is_finite() {
            return None;
        }
        rows[column].iter_mut().for_each(|entry| *entry /= pivot);
        let above = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = row[column];
            row.iter_mut().zip(&above).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}
