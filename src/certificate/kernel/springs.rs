//! Elastic foundation, `p = k (v − g)₊`: a proven pair from parts on which the beam is pressed, each with a polynomial from any source.
//!
//! For any `v̂` that satisfies the supports, and any `p ≥ 0` in equilibrium with the loads and a moment field `M`, with `w = v̂ − g`
//!
//! ```text
//! J(v̂) − D(p, R) ≤ ½∫ (EI v̂'' + M)²/EI + ½∫ (k w − p)²/k over pressed parts + ½∫ k w₊² over the others = gap
//! ½∫ EI (v̂'' − v*'')² + ½∫ k (w₊ − w*₊)² ≤ gap
//! ```
//!
//! and in a joint `½ (k_j [v̂'] + M)²/k_j` in addition. Elastic supports are supports at a level from the candidate contact list
//! (`giving`). A hinge has no moment. `EI` and `k` are constant on a stretch. Where `k = 0` there is no contact pressure, and `v̂` is
//! free.
//!
//! Between pressed parts the beam hangs free, as on a rigid foundation. On a pressed part the polynomial `t` is given, and the cubics
//! `δ` and `r` adjust `v̂` and `M` to their values at its two ends:
//!
//! ```text
//! v̂ = g + t + δ,    M = ∬(k t − q) + r,    p = M'' + q = k t + r'':    k w − p = k δ − r''
//! ```
//!
//! Under an axial force (`tension`) `M'' = p − q − N v̂''`. Then `M + N (v̂ − v̂₀)` is `∬(k t − q) + r`, with the vertical forces as its
//! end slopes, and `p` is the same.
//!
//! Over a stretch far shorter than `(4 EI/k)^¼`, `δ` is a line and only one end is given (`walks`).
//!
//! It is not necessary to prove that `w ≥ 0` on pressed parts or `w ≤ 0` elsewhere. Tension is cut off. If the supports do not hold the
//! beam, a share `t` of the pressure on two parts is removed in exchange, which costs `t √(∫p²/k)`. If `w > e = √(2 gap/k|I|)` on such a
//! part `I`, then `|v̂ − v*| ≤ e` at some position of it; the same applies to groups of parts (`groups`).

mod groups;
mod held;
mod walks;

use self::walks::{Reached, Walk};
use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::polynomial::{Polynomial, TERMS, number};
use super::pressing::PullCutOff;
use super::proof::{Pair, Piece, Sprung};
use super::reference::Datum;
use super::span::Span;
use super::tension::Taut;

/// A part of the beam, from any source.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// Position of its left end.
    pub from: f64,
    /// Position of its right end.
    pub to: f64,
    /// Coefficients of `t(from + s)` where the foundation is pressed; empty where the beam hangs.
    pub sunk: Vec<f64>,
    /// At its two ends: the penetration where the foundation is pressed or the deflection where the beam hangs; its slope; moment; shear
    /// force.
    pub ends: [[f64; 4]; 2],
}

/// Largest number of coefficients of `t`, so that the moments it causes fit into a polynomial.
pub(crate) const MOST_TERMS: usize = TERMS - 2;

/// A scene on an elastic foundation, with stretches from end to end.
struct OnSprings<'a> {
    enclosed: &'a EnclosedScene<'a>,
    stretches: &'a [Stretch],
    /// For each node the state that was reached along a short stretch; empty before.
    reached: Vec<Option<Reached>>,
    /// For each node the shear forces on both sides that were reached along short stretches; empty before.
    sheared: Vec<Option<[Interval; 2]>>,
}

/// A pressed part: its position, its least penetration, a bound of `√(∫p²/k)` over its contact force, and `∫ k`.
struct Carrier {
    place: Datum,
    sunk: f64,
    cost: Interval,
    stiffness: Interval,
    /// `(4 EI/k)^¼`.
    length: f64,
}

/// The sums over all stretches.
#[derive(Default)]
struct Sums {
    pieces: Vec<Piece>,
    moments: Vec<([f64; 2], Polynomial)>,
    carriers: Vec<Carrier>,
    cut_off: PullCutOff,
    /// `∫ p²/k` of the negative part of the pressure.
    pull: Interval,
    /// Twice the gap, without the tension that is cut off.
    square: Interval,
    /// `∫ k w₊²`.
    energy: Interval,
    /// `Σ k_j [v̂']²`, and twice the energy of elastic supports.
    turned: Interval,
    /// The reactions of elastic supports, from left to right.
    forces: Vec<(f64, Interval)>,
}

/// The cubic that has given values and slopes at `0` and `w`, minus those of the polynomial `less`. `mean` is the mean slope, if it is
/// known other than as a quotient.
pub(super) fn cubic(ends: [[Interval; 2]; 2], less: &Polynomial, w: Interval, mean: Option<Interval>) -> Polynomial {
    let off = |k: usize, s: Interval| [ends[k][0] - less.at(s), ends[k][1] - less.derivative().at(s)];
    let ([y0, d0], [y1, d1]) = (off(0, Interval::ZERO), off(1, w));
    let a = mean.unwrap_or_else(|| (y1 - y0) / w);
    Polynomial::new(&[y0, d0, (number(3) * a - number(2) * d0 - d1) / w, (d0 + d1 - number(2) * a) / (w * w)])
}

impl OnSprings<'_> {
    fn x(&self, node: usize) -> f64 {
        self.stretches.get(node).map_or(self.enclosed.length, |stretch| stretch.from)
    }

    fn beside(&self, node: usize, left: bool) -> Option<&Stretch> {
        self.stretches.get(if left { node.checked_sub(1)? } else { node })
    }

    fn is_pressed(&self, node: usize, left: bool) -> bool {
        self.beside(node, left).is_some_and(|stretch| !stretch.sunk.is_empty())
    }

    /// `w` and `w'` at a node on one of its sides: the values given on its right side, or on its left side if the foundation is pressed
    /// only there; the values reached along a short stretch; or those of the support. [`None`] if the foundation is not pressed on
    /// either side.
    fn sunk(&self, node: usize, left: bool) -> Option<[Interval; 2]> {
        let own = [false, true].into_iter().find(|side| self.is_pressed(node, *side))?;
        let gap = self.enclosed.gap.jet(self.x(node), left);
        let is_smooth = self.enclosed.gap.is_smooth_at(self.x(node));
        let jump = |from: bool, j: usize| {
            if from == left || is_smooth {
                Interval::ZERO
            } else {
                self.enclosed.gap.jet(self.x(node), from)[j] - gap[j]
            }
        };
        let (side, [w, slope]) = match self.reached.get(node).copied().flatten() {
            Some(reached) => reached,
            None => (own, [self.said(node, own, 0)?, self.said(node, own, 1)?]),
        };
        // Beyond a joint the slope is a different one.
        let slope = match self.enclosed.joint(self.x(node)).filter(|_| side != left) {
            Some(_) => self.said(node, left, 1)? - if self.is_pressed(node, left) { Interval::ZERO } else { gap[1] },
            None => slope + jump(side, 1),
        };
        let free = [w + jump(side, 0), slope];
        let Some(support) = self.enclosed.support(self.x(node)) else { return Some(free) };
        Some([support.deflection - gap[0], support.slope.map_or(free[1], |slope| slope - gap[1])])
    }

    /// `v̂` and its slope at a node, at a joint the slope on its right side; [`None`] at a free end that hangs.
    fn end(&self, node: usize) -> Option<[Interval; 2]> {
        let (x, left) = (self.x(node), !self.is_pressed(node, false));
        // At a joint the slope is the one beyond it.
        let left = left && self.enclosed.joint(x).is_none();
        let own = self.sunk(node, left).map(|w| [0, 1].map(|j| self.enclosed.gap.jet(x, left)[j] + w[j]));
        let Some(support) = self.enclosed.support(x) else { return own };
        let slope = support.slope.or(own.map(|own| own[1])).or(self.said(node, false, 1)).or(self.said(node, true, 1));
        Some([support.deflection, slope?])
    }

    /// The value given on one side of a node.
    fn said(&self, node: usize, left: bool, which: usize) -> Option<Interval> {
        Some(Interval::exact(self.beside(node, left)?.ends[usize::from(left)][which]))
    }

    /// Whether the stretches cover the beam from end to end, each has one formula where the foundation is pressed, and `v̂` is
    /// determined where they meet.
    fn is_complete(&self) -> bool {
        let Self { enclosed, stretches, .. } = self;
        let chained = stretches.windows(2).all(|w| (w[0].to - w[1].from).abs() <= 0.0);
        let last = stretches.last().is_some_and(|last| (last.to - enclosed.length).abs() <= 0.0);
        let one_gap = |s: &Stretch| enclosed.gap.is_smooth_between(s.from, s.to);
        let one_load = |s: &Stretch| {
            let is_grounded = 0.0 < enclosed.ground_between([s.from, s.to]);
            enclosed.breaks(s.from, s.to).is_empty() && is_grounded && s.sunk.len() <= MOST_TERMS
        };
        let is_one = |s: &Stretch| s.from < s.to && (s.sunk.is_empty() || one_gap(s) && one_load(s));
        let whole = chained && self.x(0).abs() <= 0.0 && last && stretches.iter().all(is_one);
        whole && (1..stretches.len()).all(|i| self.end(i).is_some())
    }

    /// `k` and `EI` of a pressed stretch.
    fn stiffness(&self, i: usize) -> [Interval; 2] {
        let Stretch { from, to, .. } = self.stretches[i];
        let ends = [from, to];
        [self.enclosed.ground_between(ends), self.enclosed.stiffness_between(ends)].map(Interval::exact)
    }

    /// `(4 EI/k)^¼` of a stretch.
    fn length(&self, i: usize) -> Interval {
        let [k, stiffness] = self.stiffness(i);
        (number(4) * stiffness / k).sqrt().sqrt()
    }

    /// The width of a pressed stretch, and its `t`.
    fn polynomial(&self, i: usize) -> (Interval, Polynomial) {
        let Stretch { from, to, ref sunk, .. } = self.stretches[i];
        (Interval::length(from, to), Polynomial::of(sunk.iter().map(|&c| Interval::exact(c))))
    }

    /// `∬(k t − q)` of a pressed stretch.
    fn caused(&self, i: usize, t: &Polynomial) -> Polynomial {
        let Stretch { from, to, .. } = self.stretches[i];
        let load = Polynomial::new(&self.enclosed.load.line(from, [from, to]));
        t.times(self.stiffness(i)[0]).minus(&load).integral().integral()
    }

    /// `N (v̂₁ − v̂₀)` of a pressed stretch.
    fn pulled(&self, i: usize) -> Interval {
        if self.enclosed.tension == 0.0 {
            return Interval::ZERO;
        }
        let Stretch { from, to, .. } = self.stretches[i];
        let (width, gap) = (Interval::length(from, to), self.enclosed.gap.about(from, [from, to]));
        let sunk = [self.sunk(i, false), self.sunk(i + 1, true)].map(|w| w.map_or(Interval::WHOLE, |w| w[0]));
        (gap.divided(1).at(width) * width + (sunk[1] - sunk[0])) * Interval::exact(self.enclosed.tension)
    }

    /// `v₁ − v₀ − θ₀ L` of a part that hangs between two positions where the foundation is pressed, from the rise of the gap.
    fn rise(&self, i: usize) -> Option<Interval> {
        let is_free = |node: usize| self.enclosed.support(self.x(node)).is_none();
        let [left, right] = [self.sunk(i, false)?, self.sunk(i + 1, true)?];
        let risen = self.enclosed.risen([self.x(i), self.x(i + 1)], self.end(i)?[1]);
        Some(risen? + (right[0] - left[0])).filter(|_| is_free(i) && is_free(i + 1))
    }

    /// `M` at the inner end of an overhang, by statics.
    fn overhanging(&self, spans: &[Option<Span>], node: usize, left: bool) -> Option<Interval> {
        let (i, tip) = if left { (node.checked_sub(1)?, 0) } else { (node, spans.len()) };
        let span = spans.get(i)?.as_ref().filter(|_| node.abs_diff(tip) == 1 && self.end(tip).is_none())?;
        Some(-(self.enclosed.stiffness_beside(self.x(node), left) * if left { span.end } else { span.start }[2]))
    }

    /// `M` on the left and on the right of a node: by statics for an overhang, otherwise the given value.
    fn moments(&self, spans: &[Option<Span>], node: usize) -> [Interval; 2] {
        let by_statics = |left: bool| self.overhanging(spans, node, left);
        let own = |left: bool| by_statics(left).or(self.said(node, left, 2)).unwrap_or(Interval::ZERO);
        let couple = self.enclosed.load.couple(self.x(node));
        if self.enclosed.joint(self.x(node)) == Some(0.0) {
            return [Interval::ZERO; 2];
        }
        let left = match self.enclosed.support(self.x(node)).filter(|s| s.holds_slope()) {
            Some(_) => return [true, false].map(own),
            None if node == 0 => Interval::ZERO,
            None if node == spans.len() => -couple,
            None => by_statics(true).or(by_statics(false).map(|right| right - couple)).unwrap_or_else(|| {
                let from_the_left = !self.is_pressed(node, false);
                if from_the_left { own(true) } else { own(false) - couple }
            }),
        };
        [left, left + couple]
    }

    /// `V` on the left and on the right of a node: reached along a short stretch; else by statics where a part hangs; else the given
    /// value.
    fn shears(&self, spans: &[Option<Span>], moments: &[[Interval; 2]], node: usize) -> [Interval; 2] {
        if let Some(walked) = self.sheared[node] {
            return walked;
        }
        let hanging = |i: usize| {
            spans.get(i)?.as_ref().map(|span| span.shears(self.enclosed.tension, [moments[i][1], moments[i + 1][0]]))
        };
        let (load, is_free) = (self.enclosed.load.point(self.x(node)), self.enclosed.support(self.x(node)).is_none());
        let [before, behind] = [node.checked_sub(1).and_then(hanging).map(|v| v[1]), hanging(node).map(|v| v[0])];
        let [left, right] = [true, false].map(|left| self.said(node, left, 3).unwrap_or(Interval::ZERO));
        let in_balance = behind.map(|v| v + load).unwrap_or(if 0 < node { right + load } else { Interval::ZERO });
        let left = before.unwrap_or(if is_free { in_balance } else { left });
        [left, if is_free { left - load } else { behind.unwrap_or(right) }]
    }

    /// Adds a part that hangs, with the moments at its two ends: its misfit to these moments, and its penetration into the foundation.
    fn hang(&self, i: usize, span: &Span, moments: [Interval; 2], sums: &mut Sums) {
        sums.square = sums.square + number(2) * span.work(self.enclosed, moments);
        let hinges = span.hinges(self.enclosed, moments);
        hinges.into_iter().for_each(|(x, moment)| sums.cut_off.hinge(self.enclosed, x, moment));
        for &(x, kink) in span.kinks() {
            let k = Interval::exact(self.enclosed.joint(x).unwrap_or(0.0));
            sums.turned = sums.turned + k * kink.square();
        }
        sums.moments.extend(span.moments(self.enclosed, moments));
        for (cell, curves) in span.curves(self.enclosed, self.enclosed.gap.breaks(span.from, span.to)) {
            let k = Interval::exact(self.enclosed.ground_between(cell));
            let half = Interval::exact(0.5 * Interval::length(cell[0], cell[1]).hi());
            for (side, v) in curves.iter().enumerate() {
                let clearance = self.enclosed.gap.about(cell[side], cell).minus(v);
                let clearance = if side == 1 { clearance.mirrored() } else { clearance };
                // Next to a pressed part the clearance is known directly, not as a difference of two depths.
                let beside = self.sunk(i + side, side == 1).filter(|_| (cell[side] - self.x(i + side)).abs() <= 0.0);
                let mut known =
                    beside.map(|[w, w1]| [-w, if side == 1 { w1 } else { -w1 }]).unwrap_or([Interval::WHOLE; 2]);
                // A joint at the right end of the span changes the slope there.
                if side == 1 && self.enclosed.joint(cell[1]).is_some() {
                    known[1] = Interval::WHOLE;
                }
                if k.hi() <= 0.0 {
                    continue;
                }
                clearance.known(&known).negative(half, |w, [_, width], end| {
                    let is_taken = end.contains(&true);
                    let below = if is_taken { k * Interval::exact(w).square() * width } else { Interval::ZERO };
                    sums.square = sums.square + below;
                    sums.energy = sums.energy + below.hull(Interval::ZERO);
                    is_taken
                });
            }
            sums.pieces.push(Piece { from: cell[0], to: cell[1], v: curves[0], pressed: false });
        }
    }

    /// Adds a pressed stretch, with moment and shear force at its two ends; [`None`] if its ends are not known.
    fn press(&self, i: usize, held: [[Interval; 2]; 2], walks: [Option<Walk>; 2], sums: &mut Sums) -> Option<()> {
        let [k, stiffness] = self.stiffness(i);
        let Stretch { from, to, .. } = self.stretches[i];
        let (ends, (width, t)) = ([from, to], self.polynomial(i));
        let ends_sunk = [self.sunk(i, false)?, self.sunk(i + 1, true)?];
        let caused = self.caused(i, &t);
        let between = |ends: [[Interval; 2]; 2], less: &Polynomial, walk: Option<Walk>| match walk {
            Some(Walk { slope, is_all: true, .. }) => Polynomial::new(&[ends[0][0] - less.at(Interval::ZERO), slope]),
            _ => cubic(ends, less, width, walk.map(|walk| walk.slope)),
        };
        let delta = between(ends_sunk, &t, walks[0]);
        let w = t.plus(&delta);
        let v = self.enclosed.gap.about(from, ends).plus(&w);
        let [[left, first], [right, last]] = held;
        let r = between([[left, first], [right + self.pulled(i), last]], &caused, walks[1]);
        let (turn, mut moment) = (r.derivative().derivative(), caused.plus(&r));
        if self.enclosed.tension != 0.0 {
            let risen = v.minus(&Polynomial::new(&[v.at(Interval::ZERO)]));
            moment = moment.minus(&risen.known(&[Interval::ZERO]).times(Interval::exact(self.enclosed.tension)));
        }
        let p = t.times(k).plus(&turn);
        let bending = v.derivative().derivative().times(stiffness).plus(&moment);
        let of = |p: &Polynomial| p.integral_of_product(p, width).not_negative();
        sums.square = sums.square + of(&bending) / stiffness + of(&delta.times(k).minus(&turn)) / k;
        let (pressure, sunk) = (p.range(width), w.range(width));
        let above = Interval::exact(sunk.lo().min(0.0)).square() * width;
        sums.energy = sums.energy + k * (of(&w) - above.hull(Interval::ZERO));
        let before = sums.cut_off.pulls.len();
        sums.cut_off.pressure(&p, ends, width);
        let cut = sums.cut_off.pulls[before..].iter().fold(Interval::ZERO, |sum, pull| sum + Interval::exact(pull.1));
        sums.pull = sums.pull + cut * Interval::exact((-pressure.lo()).max(0.0)) / k;
        let presses = Interval::exact(pressure.lo()) * width;
        let cost = Interval::exact(pressure.hi()) * (width / k).sqrt() / presses;
        sums.carriers.push(Carrier {
            place: Datum { to, presses: presses.lo(), ..Datum::at(from) },
            sunk: sunk.lo(),
            cost,
            stiffness: k * width,
            length: self.length(i).hi(),
        });
        sums.pieces.push(Piece { from, to, v, pressed: true });
        sums.moments.push((ends, moment));
        Some(())
    }
}

/// The pair of a list of stretches, if there is one.
pub(crate) fn pair(enclosed: &EnclosedScene<'_>, stretches: &[Stretch]) -> Option<Pair> {
    let n = stretches.len();
    let mut on = OnSprings { enclosed, stretches, reached: Vec::new(), sheared: Vec::new() };
    let nodes = enclosed.supports.iter().map(|s| (0..=n).find(|node| (on.x(*node) - s.x).abs() <= 0.0));
    let nodes: Vec<usize> = nodes.collect::<Option<_>>().filter(|_| on.is_complete())?;
    let sinks = on.walk();
    let hangs = |i: usize| Span::new(enclosed, [on.x(i), on.x(i + 1)], [on.end(i), on.end(i + 1)], on.rise(i));
    let spans: Vec<Option<Span>> = (0..n).map(|i| (!on.is_pressed(i, false)).then(|| hangs(i))).collect();
    let mut moments: Vec<_> = (0..=n).map(|node| on.moments(&spans, node)).collect();
    let bends = on.walk_moments(&spans, &mut moments);
    let shears: Vec<_> = (0..=n).map(|node| on.shears(&spans, &moments, node)).collect();
    let mut sums = Sums::default();
    for (i, span) in spans.iter().enumerate() {
        let held = [(i, 1), (i + 1, 0)].map(|(node, side)| [moments[node][side], shears[node][side]]);
        match span {
            Some(span) => on.hang(i, span, held.map(|[moment, _]| moment), &mut sums),
            None => on.press(i, held, [sinks[i], bends[i]], &mut sums)?,
        }
    }
    on.turn(&moments, &mut sums);
    on.give(&moments, &shears, &mut sums)?;
    let (gap, share, lines) = on.held(&sums)?;
    let force = |&node: &usize| shears[node][1] - shears[node][0] + enclosed.load.point(on.x(node));
    let carried = nodes.iter().map(|node| (on.x(*node), force(node) + Interval::around_zero(share.hi()))).collect();
    let zones = on.held_by_groups(&sums, gap);
    let taut = Taut::of(enclosed, on.supports(&sums), gap, share);
    let ground = Some(Sprung { energy: sums.energy / number(2), moments: sums.moments });
    let (pieces, turned, soft) = (sums.pieces, sums.turned / number(2), enclosed.soft());
    Some(Pair { pieces, gap, carried, lines, zones, turns_about: None, lifted: 0.0, ground, turned, soft, taut })
}

#[cfg(test)]
mod tests;
