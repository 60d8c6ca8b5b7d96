//! Moments in equilibrium. The moments at nodes and the forces of springs are chosen near the truth. A few are then corrected without
//! rounding, so that the moments at free ends and hinges are zero.
//!
//! ```text
//! T = M + N v       T'' = p − q       force of a place on the beam  F = [T'] + P       couple  [T] − C
//! ```
//!
//! Tension therefore drops out of equilibrium, and `M` is `T − N v` in the end. Where tension alone holds a hinge or a free end, its
//! `v` is corrected.

use std::collections::BTreeMap;

use dashu_ratio::RBig;

use super::given::Given;
use super::polynomial::{Polynomial, at, derivative, jet, magnitude, plus, product, short};
use super::span::{Curve, Span, on_curve, width};
use super::{Unproven, contact_nodes::HoldingNode};

/// The chosen numbers: `T` on both sides of each node, force and couple of each elastic support, and the increase of `v` at each
/// loose position of each span.
#[derive(Debug, Clone, Default)]
pub(super) struct Chosen {
    pub(super) nodes: Vec<[RBig; 2]>,
    pub(super) springs: Vec<[RBig; 2]>,
    pub(super) sunk: Vec<Vec<RBig>>,
}

/// One of the chosen numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Number {
    /// `T` on one side of a node, or on both sides, which differ by the couple there.
    Node(usize, Option<usize>),
    Spring(usize, usize),
    /// `v` at a loose position of a span.
    Loose(usize, usize),
}

impl Number {
    fn add(self, chosen: &mut Chosen, by: &RBig) {
        match self {
            Self::Node(i, Some(side)) => chosen.nodes[i][side] += by,
            Self::Node(i, None) => chosen.nodes[i].iter_mut().for_each(|moment| *moment += by),
            Self::Spring(i, what) => chosen.springs[i][what] += by,
            Self::Loose(i, k) => chosen.sunk[i][k] += by,
        }
    }
}

/// A quantity that must be zero.
#[derive(Debug, Clone, Copy)]
enum Condition {
    /// The moment in a hinge inside a span.
    Hinge(usize, f64),
    /// The moment on a side of a node that is a hinge.
    HingedNode(usize, usize),
    /// The moment left over in a span with a free end.
    End(usize),
    /// The force left over for a beam without nodes.
    Balance,
}

/// Nodes, and spans with their deflections.
#[derive(Debug)]
pub(super) struct Equilibrium<'a> {
    pub(super) given: &'a Given,
    pub(super) nodes: &'a [HoldingNode],
    pub(super) spans: &'a [Option<Span>],
}

impl Equilibrium<'_> {
    /// Force and couple that act at a position in a span.
    fn acting(&self, x: f64, chosen: &Chosen) -> [RBig; 2] {
        let [force, couple] = self.given.acting(x);
        let spring = self.given.elastic.iter().position(|spring| spring.x.total_cmp(&x).is_eq());
        let [push, turn] = spring.map_or([RBig::ZERO, RBig::ZERO], |i| chosen.springs[i].clone());
        [force - push, couple + turn]
    }

    /// `N v` at a position in span `i`.
    fn pull(&self, i: usize, x: f64, chosen: &Chosen) -> RBig {
        let (tension, Some(span)) = (&self.given.tension, &self.spans[i]) else { return RBig::ZERO };
        if tension.is_zero() {
            return RBig::ZERO;
        }
        let more = self.loose(i).iter().position(|place| place.total_cmp(&x).is_eq());
        let [v, _] = on_curve(&span.curve, x);
        tension * more.map_or(v.clone(), |k| v + &chosen.sunk[i][k])
    }

    /// The loose positions of a span: its hinges and free ends, under an axial force.
    fn loose(&self, i: usize) -> Vec<f64> {
        let Some(Span { curve, .. }) = self.spans[i].as_ref().filter(|_| !self.given.tension.is_zero()) else {
            return Vec::new();
        };
        let hinges = curve.iter().skip(1).map(|(part, _)| part[0]);
        let hinges = hinges.filter(|x| self.given.joint(*x).is_some_and(Option::is_none));
        let ends = [(i == 0).then_some(curve[0].0[0]), (i == self.nodes.len()).then_some(curve[curve.len() - 1].0[1])];
        ends[0].into_iter().chain(hinges).chain(ends[1]).collect()
    }

    /// Span `i` with its chosen `v` at loose positions. The change grows by `s⁴` from the positions before and behind, which is far
    /// less than the clearance where the beam lifts off.
    pub(super) fn with_chosen(&self, i: usize, chosen: &Chosen) -> Option<Curve> {
        let curve = &self.spans[i].as_ref()?.curve;
        let (loose, ends) = (self.loose(i), [curve[0].0[0], curve[curve.len() - 1].0[1]]);
        let none = RBig::ZERO;
        let mut places: Vec<(f64, &RBig)> = loose.into_iter().zip(&chosen.sunk[i]).collect();
        if places.iter().all(|(_, by)| by.is_zero()) {
            return None;
        }
        // A loose end is listed once, with its chosen value.
        places.extend(ends.map(|x| (x, &none)));
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        places.dedup_by_key(|place| place.0.to_bits());
        let moved = |(part, v): &([f64; 2], Polynomial)| {
            let right = places.partition_point(|place| place.0 <= part[0]);
            let ([(from, first), (to, second)], start) = ([places[right - 1], places[right]], part[0]);
            let l = width([from, to]);
            let up = [width([from, start]) / &l, RBig::ONE / &l];
            let down = [width([start, to]) / &l, -RBig::ONE / &l];
            let power = |line: &[RBig; 2]| product(&product(line, line), &product(line, line));
            (*part, plus(&plus(v, first, &power(&down)), second, &power(&up)))
        };
        Some(curve.iter().map(moved).collect())
    }

    /// `T` on the parts of a span from `T` and `T'` at its left end, and their values at its right end.
    fn march(&self, span: &Span, [mut moment, mut shear]: [RBig; 2], chosen: &Chosen) -> (Vec<Polynomial>, [RBig; 2]) {
        let mut all = Vec::new();
        for (i, (part, _)) in span.curve.iter().enumerate() {
            if 0 < i {
                let [force, couple] = self.acting(part[0], chosen);
                (moment, shear) = (moment + couple, shear - force);
            }
            let load = self.given.load(*part).into_iter().zip([2, 6]);
            let loaded = load.map(|(q, below)| -q / RBig::from(below));
            let p: Polynomial = [moment, shear].into_iter().chain(loaded).collect();
            [moment, shear] = jet(&p, &width(*part));
            all.push(p);
        }
        (all, [moment, shear])
    }

    /// `T` on the parts of span `i`, and the moment and force left over in a span with one or two free ends.
    pub(super) fn moments(&self, i: usize, chosen: &Chosen) -> (Vec<Polynomial>, [RBig; 2]) {
        let Some(span) = &self.spans[i] else { return (Vec::new(), [RBig::ZERO, RBig::ZERO]) };
        let ends = [span.curve[0].0[0], span.curve[span.curve.len() - 1].0[1]];
        let beside = |node: Option<usize>, side: usize| Some(chosen.nodes.get(node?)?[side].clone());
        let at_nodes = [beside(i.checked_sub(1), 1), beside(Some(i), 0)];
        // Nothing acts beyond a free end.
        let free = |end: usize| {
            let [force, couple] = self.acting(ends[end], chosen);
            let pull = self.pull(i, ends[end], chosen);
            if end == 0 { [pull + couple, -force] } else { [pull - couple, force] }
        };
        let l = width(ends);
        match at_nodes {
            [Some(left), right] => {
                let (_, [moment, shear]) = self.march(span, [left.clone(), RBig::ZERO], chosen);
                let start = match &right {
                    Some(right) => (right - &moment) / &l,
                    None => &free(1)[1] - &shear,
                };
                let (all, [end, _]) = self.march(span, [left, start], chosen);
                let over = if right.is_none() { &end - &free(1)[0] } else { RBig::ZERO };
                (all, [over, RBig::ZERO])
            }
            [None, Some(right)] => {
                let (all, [end, _]) = self.march(span, free(0), chosen);
                (all, [end - right, RBig::ZERO])
            }
            [None, None] => {
                let (all, [end, shear]) = self.march(span, free(0), chosen);
                let [moment, force] = free(1);
                (all, [end - moment, shear - force])
            }
        }
    }

    /// The value of a condition, which must be zero.
    fn lacks(&self, condition: Condition, chosen: &Chosen) -> RBig {
        match condition {
            Condition::End(i) => self.moments(i, chosen).1[0].clone(),
            Condition::Balance => self.moments(0, chosen).1[1].clone(),
            Condition::HingedNode(i, side) => {
                let level = self.given.end(&self.nodes[i], side).map_or(RBig::ZERO, |[level, _]| level);
                &chosen.nodes[i][side] - &self.given.tension * level
            }
            Condition::Hinge(i, x) => {
                let Some(span) = &self.spans[i] else { return RBig::ZERO };
                let (all, _) = self.moments(i, chosen);
                let part = span.curve.iter().position(|(part, _)| part[1].total_cmp(&x).is_eq()).unwrap_or(0);
                let [moment, _] = jet(&all[part], &width(span.curve[part].0));
                moment - self.pull(i, x, chosen)
            }
        }
    }

    fn conditions(&self) -> Vec<Condition> {
        let mut conditions = Vec::new();
        for (i, span) in self.spans.iter().enumerate().filter_map(|(i, span)| Some((i, span.as_ref()?))) {
            if i == 0 || i == self.nodes.len() {
                conditions.push(Condition::End(i));
            }
            let inside = span.curve.iter().skip(1).map(|(part, _)| part[0]);
            let hinges = inside.filter(|x| self.given.joint(*x).is_some_and(Option::is_none));
            conditions.extend(hinges.map(|x| Condition::Hinge(i, x)));
        }
        if self.nodes.is_empty() {
            conditions.push(Condition::Balance);
        }
        let is_hinge = |i: &usize| self.given.joint(self.nodes[*i].x).is_some_and(Option::is_none);
        let hinged = (0..self.nodes.len()).filter(is_hinge);
        conditions.extend(hinged.flat_map(|i| [0, 1].map(|side| Condition::HingedNode(i, side))));
        conditions
    }

    /// The numbers that affect a condition.
    fn numbers(&self, condition: Condition) -> Vec<Number> {
        // At an end of the beam nothing is chosen, unless the node can take a couple.
        let side = |i: usize, side: usize| match self.is_split(i) {
            true => Some(Number::Node(i, Some(side))),
            false => (0.0 < self.nodes[i].x && self.nodes[i].x < self.given.length).then_some(Number::Node(i, None)),
        };
        let i = match condition {
            Condition::HingedNode(i, at) => return side(i, at).into_iter().collect(),
            Condition::Hinge(i, _) | Condition::End(i) => i,
            Condition::Balance => 0,
        };
        let ends =
            [i.checked_sub(1).and_then(|node| side(node, 1)), if i < self.nodes.len() { side(i, 0) } else { None }];
        let within = self.spans[i].as_ref().map_or([0.0; 2], |s| [s.curve[0].0[0], s.curve[s.curve.len() - 1].0[1]]);
        let springs = (0..self.given.elastic.len()).filter(|k| {
            let x = self.given.elastic[*k].x;
            within[0] <= x && x <= within[1] && !self.nodes.iter().any(|node| node.x.total_cmp(&x).is_eq())
        });
        let turns = |k: usize| if self.given.elastic[k].turning.is_some() { 2 } else { 1 };
        let springs = springs.flat_map(|k| (0..turns(k)).map(move |what| Number::Spring(k, what)));
        let loose = (0..self.loose(i).len()).map(|k| Number::Loose(i, k));
        ends.into_iter().flatten().chain(springs).chain(loose).collect()
    }

    /// Whether something at a node can take a couple.
    fn is_split(&self, i: usize) -> bool {
        let x = self.nodes[i].x;
        self.given.turning(x).is_some()
            || self.given.support(x).is_some_and(|s| s.slope.is_some() || self.nodes[i].along.is_some())
    }

    /// The chosen numbers, corrected so that they satisfy all conditions. Each condition is satisfied by the number on which it
    /// depends most.
    pub(super) fn corrected(&self, mut chosen: Chosen) -> Result<Chosen, Unproven> {
        let mut rows: Vec<(Number, BTreeMap<Number, RBig>, RBig)> = Vec::new();
        let at = |condition: Condition| match condition {
            Condition::Hinge(_, x) => x,
            Condition::HingedNode(i, _) => self.nodes[i].x,
            Condition::End(i) if 0 < i => self.given.length,
            Condition::End(_) | Condition::Balance => 0.0,
        };
        for condition in self.conditions() {
            let mut lacks = self.lacks(condition, &chosen);
            let mut row = BTreeMap::new();
            for number in self.numbers(condition) {
                let mut moved = chosen.clone();
                number.add(&mut moved, &RBig::ONE);
                row.insert(number, self.lacks(condition, &moved) - &lacks);
            }
            for (pivot, own, value) in &rows {
                let Some(share) = row.get(pivot).cloned().filter(|share| !share.is_zero()) else { continue };
                lacks -= &share * value;
                for (number, coefficient) in own {
                    let entry = row.entry(*number).or_insert(RBig::ZERO);
                    *entry -= &share * coefficient;
                }
            }
            let pivot =
                row.iter().filter(|(_, c)| !c.is_zero()).max_by_key(|(n, c)| self.weight(**n, c)).map(|(n, _)| *n);
            let Some(pivot) = pivot else {
                if lacks.is_zero() {
                    continue;
                }
                return Err(Unproven::Couple { at: at(condition) });
            };
            let own = row[&pivot].clone();
            row.values_mut().for_each(|c| *c /= &own);
            lacks /= &own;
            for (_, other, value) in &mut rows {
                let Some(share) = other.get(&pivot).cloned().filter(|share| !share.is_zero()) else { continue };
                *value -= &share * &lacks;
                for (number, coefficient) in &row {
                    let entry = other.entry(*number).or_insert(RBig::ZERO);
                    *entry -= &share * coefficient;
                }
            }
            rows.push((pivot, row, lacks));
        }
        rows.iter().for_each(|(pivot, _, value)| pivot.add(&mut chosen, &-value));
        Ok(chosen)
    }

    /// How much a condition depends on a number. The coefficient of a force is divided by the length over which it turns. Deflections
    /// are used only if nothing else is available.
    fn weight(&self, number: Number, coefficient: &RBig) -> (bool, RBig) {
        let size = magnitude(coefficient);
        let is_force = matches!(number, Number::Spring(_, 0));
        let size = if is_force { size / super::polynomial::exactly(self.given.length) } else { size };
        (!matches!(number, Number::Loose(..)), size)
    }

    /// Numbers near the truth.
    pub(super) fn near(&self) -> Result<Chosen, Unproven> {
        let nodes = (0..self.nodes.len()).map(|i| self.moments_at(i)).collect::<Result<_, _>>()?;
        let sunk = (0..self.spans.len()).map(|i| vec![RBig::ZERO; self.loose(i).len()]).collect();
        Ok(Chosen { nodes, springs: self.springs(), sunk })
    }

    /// `T` on both sides of node `i`, from its two neighbouring parts. The sides are independent if something there can take a couple.
    fn moments_at(&self, i: usize) -> Result<[RBig; 2], Unproven> {
        let (node, given) = (&self.nodes[i], self.given);
        let outside = [i == 0, i + 1 == self.nodes.len()];
        let mut own = node.pressed.as_ref().map_or([RBig::ZERO, RBig::ZERO], |end| end.moment.clone());
        for side in [0, 1] {
            own[side] = match &self.spans[i + side] {
                Some(span) => short(&span.moments[1 - side]),
                None if outside[side] || node.pressed.is_some() => own[side].clone(),
                None => {
                    let about = given.about(node.x, side == 0).ok_or(Unproven::Place { at: node.x })?;
                    -given.bending_beside(node.x, side == 0) * at(&derivative(&derivative(&about)), &RBig::ZERO)
                }
            };
            let [level, _] = given.end(node, side)?;
            own[side] += &given.tension * level;
        }
        if self.is_split(i) {
            return Ok(own);
        }
        let [_, couple] = given.acting(node.x);
        let is_given = [0, 1].map(|side| outside[side] || self.spans[i + side].is_none());
        let left = match is_given {
            // At an end of the beam nothing acts outside, whatever rounding leaves inside.
            _ if node.x <= 0.0 => own[0].clone(),
            _ if given.length <= node.x => &own[1] - &couple,
            [true, false] => own[0].clone(),
            [false, true] => &own[1] - &couple,
            [true, true] if self.spans[i].is_none() && !outside[0] => own[0].clone(),
            [true, true] => &own[1] - &couple,
            [false, false] => short(&((&own[0] + &own[1] - &couple) / RBig::from(2))),
        };
        let right = &left + couple;
        Ok([left, right])
    }

    /// Force and couple of each elastic support, rounded.
    fn springs(&self) -> Vec<[RBig; 2]> {
        let pushed = |spring: &super::given::Elastic| {
            let span = self.spans.iter().flatten().find(|span| {
                let ends = [span.curve[0].0[0], span.curve[span.curve.len() - 1].0[1]];
                ends[0] <= spring.x && spring.x <= ends[1]
            });
            let [v, slope] = span.map_or([RBig::ZERO, RBig::ZERO], |span| on_curve(&span.curve, spring.x));
            let turn = spring.turning.as_ref().map_or(RBig::ZERO, |[k, rest]| -k * (slope - rest));
            [&spring.stiffness * (v - &spring.level), turn].map(|value| super::polynomial::short(&value))
        };
        self.given.elastic.iter().map(pushed).collect()
    }
}

/// `M` from `T`.
pub(super) fn without_pull(moment: &[RBig], tension: &RBig, v: &[RBig]) -> Polynomial {
    if tension.is_zero() { moment.to_vec() } else { plus(moment, &-tension, v) }
}
