//! Moments in equilibrium: those at nodes and the forces of springs are chosen near the truth, and a few are corrected without rounding so that
//! free ends and hinges have none.
//!
//! ```text
//! T = M + N v       T'' = p − q       force of a place on the beam  F = [T'] + P       couple  [T] − C
//! ```
//!
//! So tension drops out of equilibrium: `M` is `T − N v` in the end.

use std::collections::BTreeMap;

use dashu_ratio::RBig;

use super::given::Given;
use super::polynomial::{Polynomial, jet, magnitude, plus};
use super::span::{Span, on_curve, width};
use super::{Unproven, contact_nodes::HoldingNode};

/// What is chosen: `T` on both sides of each node, and force and couple of each support that gives.
#[derive(Debug, Clone, Default)]
pub(super) struct Chosen {
    pub(super) nodes: Vec<[RBig; 2]>,
    pub(super) springs: Vec<[RBig; 2]>,
}

/// One of these numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Number {
    /// `T` on a side of a node, or on both, which differ by the couple there.
    Node(usize, Option<usize>),
    Spring(usize, usize),
}

impl Number {
    fn add(self, chosen: &mut Chosen, by: &RBig) {
        match self {
            Self::Node(i, Some(side)) => chosen.nodes[i][side] += by,
            Self::Node(i, None) => chosen.nodes[i].iter_mut().for_each(|moment| *moment += by),
            Self::Spring(i, what) => chosen.springs[i][what] += by,
        }
    }
}

/// What has to be zero.
#[derive(Debug, Clone, Copy)]
enum Condition {
    /// The moment in a hinge within a span.
    Hinge(usize, f64),
    /// The moment on a side of a node that is a hinge.
    HingedNode(usize, usize),
    /// What is left at the free end of a span, carried to its node.
    End(usize),
    /// The force that is left of a beam without nodes.
    Balance,
}

/// Nodes and spans with their deflection.
#[derive(Debug)]
pub(super) struct Equilibrium<'a> {
    pub(super) given: &'a Given,
    pub(super) nodes: &'a [HoldingNode],
    pub(super) spans: &'a [Option<Span>],
}

impl Equilibrium<'_> {
    /// What acts at a place of a span: force, and couple.
    fn acting(&self, x: f64, chosen: &Chosen) -> [RBig; 2] {
        let [force, couple] = self.given.acting(x);
        let spring = self.given.elastic.iter().position(|spring| spring.x.total_cmp(&x).is_eq());
        let [push, turn] = spring.map_or([RBig::ZERO, RBig::ZERO], |i| chosen.springs[i].clone());
        [force - push, couple + turn]
    }

    /// `N v` at a place of a span.
    fn pull(&self, span: &Span, x: f64) -> RBig {
        let tension = &self.given.tension;
        if tension.is_zero() { RBig::ZERO } else { tension * &on_curve(&span.curve, x)[0] }
    }

    /// `T` on the parts of a span from `T` and `T'` at its left end, and what these are at its right end.
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

    /// `T` on the parts of span `i`, and what is left over at its free end, or of one of two free ends.
    pub(super) fn moments(&self, i: usize, chosen: &Chosen) -> (Vec<Polynomial>, [RBig; 2]) {
        let Some(span) = &self.spans[i] else { return (Vec::new(), [RBig::ZERO, RBig::ZERO]) };
        let ends = [span.curve[0].0[0], span.curve[span.curve.len() - 1].0[1]];
        let beside = |node: Option<usize>, side: usize| Some(chosen.nodes.get(node?)?[side].clone());
        let at_nodes = [beside(i.checked_sub(1), 1), beside(Some(i), 0)];
        // Beyond a free end there is nothing.
        let free = |end: usize| {
            let [force, couple] = self.acting(ends[end], chosen);
            let pull = self.pull(span, ends[end]);
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

    /// What a condition lacks.
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
                moment - self.pull(span, x)
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

    /// The numbers that count for a condition.
    fn numbers(&self, condition: Condition) -> Vec<Number> {
        // At an end of the beam nothing is chosen, unless something takes a couple there.
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
        ends.into_iter().flatten().chain(springs).collect()
    }

    /// Whether something at a node takes a couple.
    pub(super) fn is_split(&self, i: usize) -> bool {
        let x = self.nodes[i].x;
        self.given.turning(x).is_some()
            || self.given.support(x).is_some_and(|s| s.slope.is_some() || self.nodes[i].along.is_some())
    }

    /// The chosen numbers with corrections that meet all conditions: each is met by the number that it hangs on most.
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

    /// How much a condition hangs on a number: of a force, the length counts that it has to turn by.
    fn weight(&self, number: Number, coefficient: &RBig) -> RBig {
        let size = magnitude(coefficient);
        if matches!(number, Number::Spring(_, 0)) { size / super::polynomial::exactly(self.given.length) } else { size }
    }

    /// Force and couple of each support that gives, rounded.
    pub(super) fn springs(&self) -> Vec<[RBig; 2]> {
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
