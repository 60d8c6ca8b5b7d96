//! The chain of links that forms a beam on springs: at a node `v'` is continuous and `V` jumps by the force, which gives
//! [blocks](crate::qp::blocks) of `h` and `M`. A part that is supported on one side only follows from statics. At a built-in support
//! one chain ends and another begins.

use super::Part;
use super::links::{Beam, Kind, Link};
use super::solved::{Ends, Solved};
use crate::qp::blocks::{Block, PENALTY, factor_towards, factor_under_tension, solve_towards};
use crate::theory::check::MOST;
use crate::theory::divided;
use crate::theory::overhang::Overhang;
use crate::theory::piecewise::PiecewiseScene;
use crate::theory::span::Span;

/// A node of the chain: its block, `Θ`, the right-hand sides, and the known ones of `h, h', M, V`. An inner rotational spring is a row
/// of its own before the row of its node.
#[derive(Default)]
struct Row {
    block: Block,
    theta: f64,
    right: [f64; 2],
    known: [Option<f64>; 4],
    /// `V` beyond an end of the chain, including the force at the end.
    beyond: f64,
    /// Stiffness of an elastic support, and `h` at which its force is zero.
    spring: [f64; 2],
    /// Stiffness of a rotational spring, `h'` at which its moment is zero, and at an end of the chain `M` beyond it.
    turning: Option<[f64; 3]>,
    /// `n`, the stiffness of the link to its right as a string under the axial force.
    pull: f64,
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

/// The beam on springs that press on stretches, from left to right; [`None`] if nothing holds it there. The penetration `sunk` of a
/// beam pressed on the same stretches, times a factor, is added to the load.
pub(super) fn solve<'a>(
    given: &'a PiecewiseScene,
    springs: f64,
    stretches: &[[f64; 2]],
    sunk: Option<(&[Part], f64)>,
) -> Option<Solved<'a>> {
    let mut beam = Beam { given, springs, links: Vec::new() };
    beam.join(stretches);
    if let Some((parts, factor)) = sunk {
        let pressed = beam.links.iter_mut().filter(|link| link.kind != Kind::Span);
        for (link, part) in pressed.zip(parts.iter().filter(|part| part.pressed)) {
            let factor = factor * part.ground;
            link.drive = part.penetration.iter().map(|c| factor * c).collect();
        }
    }
    for i in 0..beam.links.len() {
        beam.measure(i);
    }
    beam.solved()
}

impl<'a> Beam<'a> {
    /// The chain of links `lo` to `hi`, excluding `hi`: `h, h', M, V` at both ends of each link.
    fn chain(&self, lo: usize, hi: usize) -> Option<Vec<Ends>> {
        // `h` of a node is the value on its right side.
        let step = |i: usize| if i < hi { self.jump(i)[0] } else { 0.0 };
        let turns = |i: usize| if lo < i && i < hi { self.turns(i) } else { [0.0; 2] };
        let loaded = |i: usize| {
            let link = &self.links[i];
            link.ends(link.c, [0.0, -step(i + 1)], [turns(i)[1], -turns(i + 1)[0]])
        };
        let (mut rows, places) = self.rows([lo, hi]);
        for i in lo..hi {
            let [[turn_a, shear_a], [turn_b, shear_b]] = loaded(i);
            let [near, far] = [places[i - lo], places[i - lo + 1]];
            (rows[near].right[0], rows[near].right[1]) = (rows[near].right[0] - shear_a, rows[near].right[1] - turn_a);
            rows[far].right[0] += shear_b;
            let turned = far - usize::from(places[i - lo] + 1 < far);
            rows[turned].right[1] += turn_b;
        }
        // Next to a hinge, elimination must not begin in a part that could move without the rest.
        let hinge = (lo + 1..hi).rev().find(|i| self.joint(*i).is_infinite()).filter(|_| rows.len() == places.len());
        // Under an axial force, elimination goes towards a free end.
        let hangs = self.given.tension != 0.0 && self.links[lo].kind == Kind::Span && !self.is_supported(lo);
        let last = if hangs { 0 } else { rows.len() - 1 };
        let meeting = hinge.map_or(last, |i| places[i - lo]);
        let tension = self.given.tension;
        if tension == 0.0 {
            factor_towards(&mut rows, meeting, |row| row.theta);
        } else {
            let left = |Row { block: Block { c, off, .. }, pull, .. }: &Row| c * c - pull * off;
            factor_under_tension(&mut rows, meeting, |row| row.theta, left);
        }
        solve_towards(&mut rows, meeting, |row| row.right);
        // A part that only rounding holds moves by any amount.
        let moves = |row: &Row| row.block.step.iter().any(|value| MOST < value.abs());
        // In compression a part next to a free end has a negative pivot, which other parts make up for.
        let failed = |row: &Row| row.block.failed().is_some() && (0.0 <= tension || !row.block.is_finite());
        if rows.iter().any(|row| failed(row) || hinge.is_some() && moves(row)) {
            return None;
        }
        let at = |row: &Row| [0, 2].map(|j| row.known[j].unwrap_or(row.block.step[j / 2]));
        let mut ends: Vec<Ends> = (lo..hi)
            .map(|i| {
                // Before a rotational spring the moment is different.
                let ([h, m], [_, n]) = (at(&rows[places[i - lo]]), at(&rows[places[i - lo] + 1]));
                let [k, _] = at(&rows[places[i + 1 - lo]]);
                let (k, m, n) = (k - step(i + 1), m + turns(i)[1], n - turns(i + 1)[0]);
                let [[a1, a3], [b1, b3]] = self.links[i].ends(self.links[i].c, [h, k], [m, n]);
                [[h, a1, m, a3], [k, b1, n, b3]]
            })
            .collect();
        self.shear_over_short_links(lo, &mut ends);
        self.refine(lo, (&mut rows, &places), meeting, &mut ends);
        let last = ends.len() - 1;
        for (i, side, row) in [(0, 0, &rows[0]), (last, 1, &rows[rows.len() - 1])] {
            ends[i][side].iter_mut().zip(row.known).for_each(|(value, known)| *value = known.unwrap_or(*value));
        }
        Some(ends)
    }

    /// The excess of `M` at node `i` over `M` just left of it, and of `M` just right of it over `M` at the node. A couple is a load of
    /// the longer of the two links. Over a short link it would be a pair of forces that grow as the link shortens, and cancel.
    fn turns(&self, i: usize) -> [f64; 2] {
        let ([left, right], turn) = ([&self.links[i - 1], &self.links[i]], self.acts(i)[1]);
        if left.hi - left.lo < right.hi - right.lo { [0.0, turn] } else { [turn, 0.0] }
    }

    /// The rows of the chain from node `lo` to node `hi`, and the row index of each node.
    fn rows(&self, [lo, hi]: [usize; 2]) -> (Vec<Row>, Vec<usize>) {
        let (mut rows, mut places) = (Vec::with_capacity(hi - lo + 1), Vec::with_capacity(hi - lo + 1));
        for i in lo..=hi {
            let turning = self.turning(i).filter(|_| lo < i && i < hi);
            if let Some([k, without]) = turning {
                let left = &self.links[i - 1];
                let without = left.base[1][1] - without;
                let block = Block::new(0.0, left.w, 0.0).on_springs(0.0, left.eta).turning(k);
                rows.push(Row { block, right: [0.0, -without], turning: Some([k, without, 0.0]), ..Row::default() });
            }
            places.push(rows.len());
            rows.push(self.row(i, [lo, hi], turning.is_some()));
        }
        (rows, places)
    }

    /// The row of a node in the chain from node `lo` to node `hi`, without the loads of links. The rotation of the link on its left may
    /// be in a row of its own.
    fn row(&self, i: usize, [lo, hi]: [usize; 2], is_turning: bool) -> Row {
        let (left, right) = ((lo < i).then(|| &self.links[i - 1]), (i < hi).then(|| &self.links[i]));
        let turned = |of: fn(&Link) -> f64| left.filter(|_| !is_turning).map_or(0.0, of) + right.map_or(0.0, of);
        let sum = |of: fn(&Link) -> f64| left.map_or(0.0, of) + right.map_or(0.0, of);
        let [c, off, sigma, pull] = right.map_or([0.0; 4], |link| [link.c, link.off, link.sigma, link.pull]);
        let joint = if lo < i && i < hi { self.joint(i) } else { 0.0 };
        let mut w = turned(|link| link.w) + if joint.is_finite() { joint } else { PENALTY };
        let (mut theta, [force, couple]) = (sum(|link| link.a), self.acts(i));
        let (mut known, mut bend) = ([None; 4], if lo < i && i < hi { self.jump(i)[1] } else { 0.0 });
        if joint == f64::INFINITY {
            (known[2], bend) = (Some(0.0), 0.0);
        }
        let mut pushed = force;
        let [depth, slope] = right.map_or_else(|| self.links[i - 1].base[1], |link| link.base[0]);
        if let Some([_, without]) = self.turning(i).filter(|_| is_turning) {
            bend += self.links[i - 1].base[1][1] - without;
        }
        let (mut beyond, mut turning) = (0.0, None);
        if i == lo || i == hi {
            let sign = if i == lo { 1.0 } else { -1.0 };
            if let Some(built_in) = self.built_in(i) {
                known[1] = Some(slope - built_in);
                bend = sign * (slope - built_in);
            } else {
                let x = if i == lo { self.links[i].lo } else { self.links[i - 1].hi };
                let hanging = Overhang::of(self.given, x, i == lo);
                let moment = sign * couple - hanging.moment;
                if let Some([k, without]) = self.turning(i) {
                    turning = Some([k, slope - without, moment]);
                    (w, bend) = (w + 1.0 / k, sign * (slope - without) - moment / k);
                } else {
                    known[2] = Some(moment);
                    (w, bend) = (w + PENALTY, -PENALTY * moment);
                }
                pushed -= hanging.force;
                beyond = sign * pushed;
                known[3] = (!self.is_supported(i)).then_some(beyond);
            }
        }
        let mut spring = [0.0; 2];
        if let Some(at) = self.spring(i) {
            spring = [at.stiffness, depth - at.level];
            (theta, pushed) = (theta + spring[0], pushed + spring[0] * spring[1]);
        }
        if let Some(support) = self.support(i) {
            known[0] = Some(depth - support.level);
            (theta, pushed) = (PENALTY, PENALTY * (depth - support.level));
        }
        let sigma = if pull == 0.0 { sigma } else { sigma - pull };
        let block = Block::new(c, w, off).on_springs(sigma, turned(|link| link.eta));
        Row { block, theta, right: [pushed, bend], known, beyond, spring, turning, pull }
    }

    /// Replaces the shear force over short links, the difference of two moments over a small length, by the value from a longer
    /// neighbouring link, which has more digits.
    fn shear_over_short_links(&self, lo: usize, ends: &mut [Ends]) {
        let count = ends.len();
        let mut length: Vec<f64> = self.links[lo..lo + count].iter().map(|link| link.hi - link.lo).collect();
        for (from, to) in (1..count).map(|i| (i - 1, i)).chain((1..count).rev().map(|i| (i, i - 1))) {
            let (node, link) = (lo + from.max(to), &self.links[lo + to]);
            // A support takes a share of the shear force.
            if length[from] <= 2.0 * length[to] || self.is_supported(node) || link.kind == Kind::Deep {
                continue;
            }
            length[to] = length[from];
            let (near, far, sign) = if from < to { (0, 1, 1.0) } else { (1, 0, -1.0) };
            let [[h, _, m, _], [k, _, n, _]] = ends[to];
            let curved = link.ends(0.0, [h, k], [m, n]);
            let shear = ends[from][far][3] + sign * self.acts(node)[0];
            (ends[to][near][3], ends[to][far][3]) = (shear, shear + (curved[far][1] - curved[near][1]));
        }
    }

    /// Solves once more for the residual. With the shear forces over short links this makes the answer accurate to the rounding of its
    /// own terms (Skeel 1980).
    fn refine(&self, lo: usize, (rows, places): (&mut [Row], &[usize]), meeting: usize, ends: &mut [Ends]) {
        let last = places.len() - 1;
        for (i, &place) in places.iter().enumerate() {
            let inside = 0 < i && i < last;
            let jump = if inside {
                let joint = self.joint(lo + i);
                let turned = if joint.is_finite() { joint * ends[i - 1][1][2] } else { 0.0 };
                [self.jump(lo + i)[1] + turned, self.acts(lo + i)[0]]
            } else {
                [0.0; 2]
            };
            let row = &rows[place];
            let here = if i < last { ends[i][0] } else { ends[i - 1][1] };
            // The slope that a rotational spring leaves at an end.
            let held = row
                .turning
                .map(|[k, without, moment]| without + if i == 0 { here[2] - moment } else { moment - here[2] } / k);
            let mut residual = [3, 1].map(|j| {
                let known = if j == 3 { row.beyond } else { row.known[j].or(held).unwrap_or(0.0) };
                let left = if 0 < i { ends[i - 1][1][j] } else { known };
                let right = if i < last { ends[i][0][j] } else { known };
                left + jump[usize::from(j == 3)] - right
            });
            residual[0] += row.spring[0] * (row.spring[1] - here[0]);
            for j in [0, 2] {
                if row.known[j].is_some() {
                    residual[j / 2] = 0.0;
                }
            }
            let own_row = inside && places[i - 1] + 1 < place;
            if let Some([k, without, _]) = own_row.then(|| rows[place - 1].turning).flatten() {
                let rise = ends[i][0][2] - ends[i - 1][1][2] - self.acts(lo + i)[1];
                let off = ends[i - 1][1][1] - without - rise / k;
                rows[place - 1].right = [0.0, off];
                residual[1] -= off;
            }
            rows[place].right = residual;
        }
        solve_towards(rows, meeting, |row| row.right);
        for (i, end) in ends.iter_mut().enumerate() {
            let [[h, m], [k, n]] = [rows[places[i]].block.step, rows[places[i] + 1].block.step];
            let [near, far] = self.links[lo + i].bent(self.links[lo + i].c, [h, k], [m, n]);
            for (value, more) in end.iter_mut().flatten().zip([h, near[0], m, near[1], k, far[0], n, far[1]]) {
                *value += more;
            }
        }
    }

    fn solved(self) -> Option<Solved<'a>> {
        let n = self.links.len();
        // With an axial force, overhangs are part of the chain.
        let is_slack = self.given.tension == 0.0;
        let hangs = [0, n].map(|i| is_slack && self.links[i.min(n - 1)].kind == Kind::Span && !self.is_supported(i));
        let (lo, hi) = (usize::from(hangs[0]), n.checked_sub(usize::from(hangs[1]))?);
        if hi < lo || lo == hi && self.built_in(lo).is_none() && self.turning(lo).is_none() {
            return None;
        }
        let mut ends = Vec::with_capacity(hi - lo);
        while lo + ends.len() < hi {
            let from = lo + ends.len();
            let to = (from + 1..hi).find(|i| self.built_in(*i).is_some()).unwrap_or(hi);
            ends.extend(self.chain(from, to)?);
        }
        let mut overhangs = [Vec::new(), Vec::new()];
        if hangs[0] {
            let beside = ends.first().map(|ends: &Ends| (&self.links[lo], 0, ends[0]));
            overhangs[0] = self.overhang(0, 1, beside)?;
        }
        if hangs[1] {
            let beside = ends.last().map(|ends| (&self.links[hi - 1], 1, ends[1]));
            overhangs[1] = self.overhang(hi, 0, beside)?;
        }
        Some(Solved { beam: self, held: lo, ends, overhangs })
    }

    /// A link without pressure between two nodes.
    pub(super) fn between(&self, i: usize, ends: &Ends) -> Span {
        let link = &self.links[i];
        let [at, beam] = [0, 1].map(|which| {
            [0, 1].map(|side| {
                let ([h, h1, m, v], [depth, slope]) = (self.sheared(ends[side]), link.base[side]);
                let ([more, turn], [_, _, g2, g3]) = (self.below(i, side), self.profile(link, side));
                if which == 0 { [h + more, h1 + turn, g2 + m, g3 + v] } else { [depth - h, slope - h1, -m, -v] }
            })
        });
        let [a, b] = [0, 1].map(|side| link.end(side, at[side][0], beam[side][0]));
        let stiffness = self.stiffness(link);
        Span { a, b, at_a: at[0], at_b: at[1], beam_a: beam[0], beam_b: beam[1], stiffness, answer: None }
    }

    /// The loads on both sides of the only node that holds the beam, and on the node.
    fn alone(&self, node: usize) -> ([Overhang; 2], f64, [f64; 2]) {
        let x = self.links.get(node).map_or(self.given.length, |link| link.lo);
        ([true, false].map(|left| Overhang::of(self.given, x, left)), x, self.acts(node))
    }

    /// The slope of a beam that one rotational spring holds alone.
    fn turned_alone(&self, node: usize) -> Option<f64> {
        let ([k, without], ([left, right], _, [_, couple])) = (self.turning(node)?, self.alone(node));
        Some(without - (left.moment - right.moment - couple) / k)
    }

    /// `h` and `v` at the only support, which is elastic.
    fn sunk_alone(&self, node: usize) -> Option<(f64, f64)> {
        let (spring, ([left, right], x, [force, _])) = (self.spring(node)?, self.alone(node));
        let level = spring.level + (left.force + right.force - force) / spring.stiffness;
        Some((self.given.depth(x) - level, level))
    }

    /// The first or the last link, which has a free end, from the beam on the other side of its node.
    fn overhang(&self, i: usize, held: usize, beside: Option<(&Link, usize, [f64; 4])>) -> Option<Vec<Span>> {
        let (link, node) = (&self.links[i], i + held);
        let beside = beside.map(|(link, side, [h, h1, ..])| [h, link.base[side][0] - h, link.base[side][1] - h1]);
        let slope = self.built_in(node).or(beside.map(|[_, _, slope]| slope)).or_else(|| self.turned_alone(node))?;
        let (joint, at_left) = (self.joint(node), held == 1);
        let bent = Overhang::of(self.given, [link.lo, link.hi][held], at_left).moment;
        let turned = if joint == 0.0 { 0.0 } else { joint * bent };
        let slope = if at_left { slope - turned } else { slope + turned };
        let [more, _] = self.below(i, held);
        let (height, level) = match self.support(node) {
            Some(support) => (more, support.level),
            None => match beside {
                Some([h, level, _]) => (h + more, level),
                None => self.sunk_alone(node)?,
            },
        };
        Some(divided::overhang(self.given, link.end(held, height, level), slope, at_left))
    }
}
