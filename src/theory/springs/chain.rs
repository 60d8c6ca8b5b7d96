//! The chain of links that a beam on springs is: at a node `v'` is continuous and `V` jumps by the force, which makes
//! [blocks](crate::qp::blocks) of `h` and `M`. What a beam is held by on one side only hangs there by statics, and where it is built in
//! one chain ends and another begins.

use super::Part;
use super::links::{Beam, Kind, Link};
use crate::qp::blocks::{Block, PENALTY, factor, solve as solve_blocks};
use crate::theory::divided::{self, Parts};
use crate::theory::overhang::Overhang;
use crate::theory::penetration::{by_blocks, is_clear};
use crate::theory::piece::{Piece, pieces_of};
use crate::theory::piecewise::PiecewiseScene;
use crate::theory::span::Span;

/// A node of the chain: its block, `Θ`, the right-hand sides, and what is known of `h, h', M, V`.
#[derive(Default)]
struct Row {
    block: Block,
    theta: f64,
    right: [f64; 2],
    known: [Option<f64>; 4],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

/// `h, h', M, V` at the two ends of a link.
type Ends = [[f64; 4]; 2];

/// A beam on springs, by the numbers at the ends of its links.
pub(super) struct Solved<'a> {
    beam: Beam<'a>,
    /// The first link between places that hold the beam, and those of all links from there on; what is beyond hangs by statics.
    held: usize,
    ends: Vec<Ends>,
    overhangs: [Vec<Span>; 2],
}

/// What a link does.
#[expect(clippy::large_enum_variant, reason = "there is one at a time")]
enum Course {
    /// By the spans between changes of the beam.
    Hangs(Parts),
    /// Taylor coefficients of `h` and `v` about its left end.
    Pressed([Vec<f64>; 2]),
}

/// The beam on springs that press on stretches, from left to right; [`None`] if nothing holds it there. To the load comes the penetration
/// of a beam that is pressed on the same stretches, times a factor.
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
    /// The chain of links `lo` to `hi`, without `hi`: `h, h', M, V` at both ends of each.
    fn chain(&self, lo: usize, hi: usize) -> Option<Vec<Ends>> {
        // `h` of a node is that on its right side.
        let step = |i: usize| if i < hi { self.jump(i)[0] } else { 0.0 };
        let turns = |i: usize| if lo < i && i < hi { self.turns(i) } else { [0.0; 2] };
        let loaded = |i: usize| {
            let link = &self.links[i];
            link.ends(link.c, [0.0, -step(i + 1)], [turns(i)[1], -turns(i + 1)[0]])
        };
        let mut rows: Vec<Row> = (lo..=hi).map(|i| self.row(i, [lo, hi])).collect();
        for i in lo..hi {
            let [[turn_a, shear_a], [turn_b, shear_b]] = loaded(i);
            let [near, far] = [i - lo, i - lo + 1];
            (rows[near].right[0], rows[near].right[1]) = (rows[near].right[0] - shear_a, rows[near].right[1] - turn_a);
            (rows[far].right[0], rows[far].right[1]) = (rows[far].right[0] + shear_b, rows[far].right[1] + turn_b);
        }
        factor(&mut rows, |row| row.theta);
        solve_blocks(&mut rows, |row| row.right);
        if rows.iter().any(|row| row.block.failed().is_some()) {
            return None;
        }
        let at = |row: &Row| [0, 2].map(|j| row.known[j].unwrap_or(row.block.step[j / 2]));
        let mut ends: Vec<Ends> = (lo..hi)
            .map(|i| {
                let ([h, m], [k, n]) = (at(&rows[i - lo]), at(&rows[i - lo + 1]));
                let (k, m, n) = (k - step(i + 1), m + turns(i)[1], n - turns(i + 1)[0]);
                let [[a1, a3], [b1, b3]] = self.links[i].ends(self.links[i].c, [h, k], [m, n]);
                [[h, a1, m, a3], [k, b1, n, b3]]
            })
            .collect();
        self.shear_over_short_links(lo, &mut ends);
        self.refine(lo, &mut rows, &mut ends);
        let last = ends.len() - 1;
        for (i, side, row) in [(0, 0, &rows[0]), (last, 1, &rows[last + 1])] {
            ends[i][side].iter_mut().zip(row.known).for_each(|(value, known)| *value = known.unwrap_or(*value));
        }
        Some(ends)
    }

    /// By what `M` of node `i` is more than `M` just left of it, and less than `M` just right of it: a couple is a load of the longer one of
    /// both links. Over a short one it would be two forces that are the larger the shorter it is, and cancel.
    fn turns(&self, i: usize) -> [f64; 2] {
        let ([left, right], turn) = ([&self.links[i - 1], &self.links[i]], self.acts(i)[1]);
        if left.hi - left.lo < right.hi - right.lo { [0.0, turn] } else { [turn, 0.0] }
    }

    /// A node of the chain from node `lo` to node `hi`, but for what loads on links do.
    fn row(&self, i: usize, [lo, hi]: [usize; 2]) -> Row {
        let (left, right) = ((lo < i).then(|| &self.links[i - 1]), (i < hi).then(|| &self.links[i]));
        let sum = |of: fn(&Link) -> f64| left.map_or(0.0, of) + right.map_or(0.0, of);
        let [c, off, sigma] = right.map_or([0.0; 3], |link| [link.c, link.off, link.sigma]);
        let joint = if lo < i && i < hi { self.joint(i) } else { 0.0 };
        let mut w = sum(|link| link.w) + if joint.is_finite() { joint } else { PENALTY };
        let (mut theta, [force, couple]) = (sum(|link| link.a), self.acts(i));
        let (mut known, mut bend) = ([None; 4], if lo < i && i < hi { self.jump(i)[1] } else { 0.0 });
        if joint == f64::INFINITY {
            (known[2], bend) = (Some(0.0), 0.0);
        }
        let mut pushed = force;
        let [depth, slope] = right.map_or_else(|| self.links[i - 1].base[1], |link| link.base[0]);
        if i == lo || i == hi {
            let sign = if i == lo { 1.0 } else { -1.0 };
            if let Some(built_in) = self.built_in(i) {
                known[1] = Some(slope - built_in);
                bend = sign * (slope - built_in);
            } else {
                let x = if i == lo { self.links[i].lo } else { self.links[i - 1].hi };
                let hanging = Overhang::of(self.given, x, i == lo);
                let moment = sign * couple - hanging.moment;
                known[2] = Some(moment);
                (w, bend) = (w + PENALTY, -PENALTY * moment);
                pushed -= hanging.force;
                known[3] = self.support(i).is_none().then_some(sign * pushed);
            }
        }
        if let Some(support) = self.support(i) {
            known[0] = Some(depth - support.level);
            (theta, pushed) = (PENALTY, PENALTY * (depth - support.level));
        }
        let block = Block::new(c, w, off).on_springs(sigma, sum(|link| link.eta));
        Row { block, theta, right: [pushed, bend], known }
    }

    /// Over a short link the shear force, the difference of two moments over its length, has few digits: it is what comes from a longer
    /// one beside it.
    fn shear_over_short_links(&self, lo: usize, ends: &mut [Ends]) {
        let count = ends.len();
        let mut length: Vec<f64> = self.links[lo..lo + count].iter().map(|link| link.hi - link.lo).collect();
        for (from, to) in (1..count).map(|i| (i - 1, i)).chain((1..count).rev().map(|i| (i, i - 1))) {
            let (node, link) = (lo + from.max(to), &self.links[lo + to]);
            // A support takes a share of it.
            if length[from] <= 2.0 * length[to] || self.support(node).is_some() || link.kind == Kind::Deep {
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

    /// One more solve for what remains: with the shear forces over short links it takes the answer to the rounding of its own terms
    /// (Skeel 1980).
    fn refine(&self, lo: usize, rows: &mut [Row], ends: &mut [Ends]) {
        let last = rows.len() - 1;
        for (i, row) in rows.iter_mut().enumerate() {
            let jump = if 0 < i && i < last {
                let joint = self.joint(lo + i);
                let turned = if joint.is_finite() { joint * ends[i - 1][1][2] } else { 0.0 };
                [self.jump(lo + i)[1] + turned, self.acts(lo + i)[0]]
            } else {
                [0.0; 2]
            };
            row.right = [3, 1].map(|j| {
                let known = row.known[j].unwrap_or(0.0);
                let left = if 0 < i { ends[i - 1][1][j] } else { known };
                let right = if i < last { ends[i][0][j] } else { known };
                left + jump[usize::from(j == 3)] - right
            });
            for j in [0, 2] {
                if row.known[j].is_some() {
                    row.right[j / 2] = 0.0;
                }
            }
        }
        solve_blocks(rows, |row| row.right);
        for (i, end) in ends.iter_mut().enumerate() {
            let [[h, m], [k, n]] = [rows[i].block.step, rows[i + 1].block.step];
            let [near, far] = self.links[lo + i].bent(self.links[lo + i].c, [h, k], [m, n]);
            for (value, more) in end.iter_mut().flatten().zip([h, near[0], m, near[1], k, far[0], n, far[1]]) {
                *value += more;
            }
        }
    }

    fn solved(self) -> Option<Solved<'a>> {
        let n = self.links.len();
        let hangs = [0, n].map(|i| self.links[i.min(n - 1)].kind == Kind::Span && self.support(i).is_none());
        let (lo, hi) = (usize::from(hangs[0]), n.checked_sub(usize::from(hangs[1]))?);
        if hi < lo || lo == hi && self.built_in(lo).is_none() {
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

    /// A link that hangs between two nodes.
    fn between(&self, i: usize, ends: &Ends) -> Span {
        let link = &self.links[i];
        let [at, beam] = [0, 1].map(|which| {
            [0, 1].map(|side| {
                let ([h, h1, m, v], [depth, slope]) = (ends[side], link.base[side]);
                let ([more, turn], [_, _, g2, g3]) = (self.below(i, side), self.profile(link, side));
                if which == 0 { [h + more, h1 + turn, g2 + m, g3 + v] } else { [depth - h, slope - h1, -m, -v] }
            })
        });
        let [a, b] = [0, 1].map(|side| link.end(side, at[side][0], beam[side][0]));
        let stiffness = self.given.cells[link.cells[0]].stiffness;
        Span { a, b, at_a: at[0], at_b: at[1], beam_a: beam[0], beam_b: beam[1], stiffness, answer: None }
    }

    /// The first or the last link, of which an end is free, from what the beam is on the other side of where it is held.
    fn overhang(&self, i: usize, held: usize, beside: Option<(&Link, usize, [f64; 4])>) -> Option<Vec<Span>> {
        let (link, node) = (&self.links[i], i + held);
        let beside = beside.map(|(link, side, [h, h1, ..])| [h, link.base[side][0] - h, link.base[side][1] - h1]);
        let slope = self.built_in(node).or(beside.map(|[_, _, slope]| slope))?;
        let (joint, at_left) = (self.joint(node), held == 1);
        let bent = Overhang::of(self.given, [link.lo, link.hi][held], at_left).moment;
        let turned = if joint == 0.0 { 0.0 } else { joint * bent };
        let slope = if at_left { slope - turned } else { slope + turned };
        let [more, _] = self.below(i, held);
        let (height, level) = match self.support(node) {
            Some(support) => (more, support.level),
            None => beside.map(|[h, level, _]| (h + more, level))?,
        };
        Some(divided::overhang(self.given, link.end(held, height, level), slope, at_left))
    }
}

impl Solved<'_> {
    /// How many links it has.
    pub(super) fn size(&self) -> usize {
        self.beam.links.len()
    }

    fn course(&self, i: usize) -> Option<Course> {
        let link = &self.beam.links[i];
        let Some(ends) = i.checked_sub(self.held).map(|i| self.ends.get(i)) else {
            return Some(Course::Hangs(Parts::of(self.overhangs[0].clone())));
        };
        let Some(ends) = ends else { return Some(Course::Hangs(Parts::of(self.overhangs[1].clone()))) };
        Some(match link.kind {
            Kind::Span => Course::Hangs(Parts::one(self.beam.between(i, ends))),
            Kind::Pressed => Course::Pressed(self.beam.taylor(link, ends[0])),
            Kind::Deep => Course::Pressed(self.beam.following(link)),
        })
    }

    /// Its parts, from left to right; [`None`] if numbers leave the range of `f64`.
    pub(super) fn parts(&self) -> Option<Vec<Part>> {
        let mut parts = Vec::new();
        for (i, link) in self.beam.links.iter().enumerate() {
            match self.course(i)? {
                Course::Hangs(spans) => spans.into_iter().for_each(|span| self.hanging(&span, &mut parts)),
                Course::Pressed([h, deflection]) => {
                    let penetration = h.into_iter().map(|c| -c).collect();
                    let piece = Piece::of_part([link.lo, link.hi], link.lo, link.cells[0]);
                    parts.push(Part::new(self.beam.given, piece, true, [deflection, penetration]));
                }
            }
        }
        parts.iter().all(|part| (part.deflection[0] + part.deflection[3]).is_finite()).then_some(parts)
    }

    /// The parts of the beam where nothing presses.
    fn hanging(&self, span: &Span, parts: &mut Vec<Part>) {
        let given = self.beam.given;
        let mut pieces = Vec::new();
        pieces_of(given, span, &mut pieces);
        let mut pieces: Vec<Piece> = pieces.iter().flat_map(|piece| piece.parts(given)).collect();
        pieces.retain(|piece| piece.lo < piece.hi);
        pieces.sort_by(|a, b| a.lo.total_cmp(&b.lo));
        parts.extend(pieces.into_iter().map(|piece| {
            let (mut deflection, mut penetration) = (vec![0.0; given.terms], vec![0.0; given.terms]);
            piece.deflection(given, &mut deflection);
            piece.clearance(given, &mut penetration);
            penetration.iter_mut().for_each(|c| *c = -*c);
            Part::new(given, piece, false, [deflection, penetration])
        }));
    }

    /// The largest penetration at an end of a link on which the ground presses.
    pub(super) fn deepest(&self) -> f64 {
        let links = self.beam.links.iter().skip(self.held).zip(&self.ends);
        let pressed = links.filter(|(link, _)| link.kind != Kind::Span).flat_map(|(_, ends)| ends);
        pressed.fold(0.0, |most, [h, ..]| h.abs().max(most))
    }

    /// Each part on which the ground presses, and of those that hang each one that is not clear of the ground by more than rounding, from
    /// left to right: its piece, whether it presses, and the Taylor coefficients of `h` about its anchor. [`None`] as for `parts`.
    pub(super) fn near_ground(&self, mut see: impl FnMut(&Piece, bool, &mut [f64])) -> Option<()> {
        /// Of the depth of the beam: a deflection is a sum of a handful of terms.
        const ROUNDING: f64 = 64.0 * f64::EPSILON;
        let given = self.beam.given;
        let (mut taylor, mut pieces) = (vec![0.0; given.terms], Vec::new());
        for (i, link) in self.beam.links.iter().enumerate() {
            let spans = match self.course(i)? {
                Course::Hangs(spans) => spans,
                Course::Pressed([mut h, v]) if (v[0] + v[3]).is_finite() => {
                    see(&Piece::of_part([link.lo, link.hi], link.lo, link.cells[0]), true, &mut h);
                    continue;
                }
                Course::Pressed(_) => return None,
            };
            for span in spans {
                if !(span.beam_a[0] + span.beam_a[3] + span.beam_b[0] + span.beam_b[3]).is_finite() {
                    return None;
                }
                let rounding = ROUNDING * span.beam_a[0].abs().max(span.beam_b[0].abs());
                pieces.clear();
                pieces_of(given, &span, &mut pieces);
                for piece in &pieces {
                    by_blocks(given, piece, 0, |part| {
                        if 1 < part.count() {
                            return is_clear(given, part, -rounding, &mut taylor);
                        }
                        if part.lo < part.hi && 0.0 < given.cells[part.cell].ground {
                            part.clearance(given, &mut taylor);
                            see(part, false, &mut taylor);
                        }
                        true
                    });
                }
            }
        }
        Some(())
    }
}
