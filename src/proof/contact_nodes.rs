//! Where a beam on rigid ground is held: the places of its contacts as they are, its supports, and the slopes that follow.

#![expect(clippy::float_cmp, reason = "a place is the same number wherever it is given")]

use dashu_ratio::RBig;

use super::Unproven;
use super::given::{Given, Support};
use super::polynomial::{exactly, magnitude};
use super::span::{Curve, bends, width};
use crate::certificate::tridiagonal;
use crate::state::Contact;
use crate::theory::Exact;

/// What the beam does to the right of a place.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Part {
    /// It hangs.
    Span,
    /// It lies on rigid ground.
    Zone,
    /// It is pressed into ground that gives; coefficients of `v − g` in powers of `x − from`.
    Pressed(Vec<RBig>),
}

/// A place that holds the beam, or where it begins or ceases to lie on the ground.
#[derive(Debug, Clone)]
pub(super) struct HoldingNode {
    pub(super) x: f64,
    /// The slope is that of the ground on its left side, if true, or on its right side; none where it is the beam's own.
    pub(super) along: Option<bool>,
    pub(super) slope: RBig,
    pub(super) right: Part,
    /// Of ground that gives: `v`, and on its two sides `M` and `M'`. The slope is known.
    pub(super) pressed: Option<Box<PressedEnd>>,
}

/// What is known at an end of a part that is pressed into ground that gives.
#[derive(Debug, Clone)]
pub(super) struct PressedEnd {
    pub(super) deflection: RBig,
    pub(super) moment: [RBig; 2],
    pub(super) shear: [RBig; 2],
}

impl HoldingNode {
    pub(super) fn new(x: f64, along: Option<bool>, right: Part) -> Self {
        Self { x, along, slope: RBig::ZERO, right, pressed: None }
    }

    pub(super) fn hangs(&self) -> bool {
        self.right == Part::Span
    }
}

impl Given {
    /// The nodes of a list of contacts, with their slopes.
    pub(super) fn nodes(&self, contacts: &[Contact], exact: Option<&Exact>) -> Result<Vec<HoldingNode>, Unproven> {
        let mut nodes = self.places(contacts);
        if let Some(motion) = exact.and_then(|exact| exact.state.standing?.motion)
            && nodes.is_empty()
        {
            nodes.push(HoldingNode::new(motion.about, None, Part::Span));
        }
        let last = nodes.last().ok_or(Unproven::Turns { at: f64::NAN })?;
        let pair = nodes.windows(2).find(|pair| pair[1].x <= pair[0].x);
        if let Some(wrong) = pair.map(|pair| &pair[1]).or(Some(last).filter(|last| !last.hangs())) {
            return Err(Unproven::Place { at: wrong.x });
        }
        if let ([node], Some(exact)) = (&mut nodes[..], exact)
            && node.along.is_none()
            && self.support(node.x).is_none_or(|s| s.slope.is_none())
        {
            node.slope = exactly(exact.slope(node.x));
            return Ok(nodes);
        }
        // At a support that is level with the ground the beam is not steeper than the ground.
        for _ in 0..3 {
            self.turn(&mut nodes)?;
            if !self.follow(&mut nodes) {
                break;
            }
        }
        Ok(nodes)
    }

    fn places(&self, contacts: &[Contact]) -> Vec<HoldingNode> {
        let node = HoldingNode::new;
        let mut nodes: Vec<HoldingNode> = Vec::new();
        for &Contact { from, to, .. } in contacts {
            // Zones that share an end are one.
            if from < to && nodes.last().is_some_and(|last| last.x == from) {
                nodes.pop();
                nodes.push(node(to, Some(true), Part::Span));
            } else if from < to {
                nodes.extend([node(from, Some(false), Part::Zone), node(to, Some(true), Part::Span)]);
            } else if self.support(from).is_none() {
                nodes.push(node(from, (!self.is_corner(from)).then_some(false), Part::Span));
            }
        }
        for support in &self.supports {
            let i = nodes.iter().position(|node| support.x <= node.x).unwrap_or(nodes.len());
            if nodes.get(i).is_none_or(|node| node.x != support.x) {
                let right = i.checked_sub(1).map_or(Part::Span, |i| nodes[i].right.clone());
                nodes.insert(i, node(support.x, (right == Part::Zone).then_some(false), right));
            }
        }
        nodes
    }

    /// Whether the beam may turn where it touches: at an end, and where no side has the slope of the other.
    fn is_corner(&self, x: f64) -> bool {
        let [left, right] = [true, false].map(|left| self.side(x, left));
        x <= 0.0 || self.length <= x || left != right || left.is_some_and(|[g, _]| Some(g) != self.depth(x))
    }

    fn turns(&self, node: &HoldingNode) -> bool {
        node.along.is_none() && node.pressed.is_none() && self.support(node.x).is_none_or(|s| s.slope.is_none())
    }

    /// `v` and `v'` at a node.
    pub(super) fn end(&self, node: &HoldingNode) -> Result<[RBig; 2], Unproven> {
        let support = self.support(node.x);
        let given = support.map(|s| s.level.clone()).or(node.pressed.as_ref().map(|end| end.deflection.clone()));
        let level = given.or_else(|| self.depth(node.x)).ok_or(Unproven::Place { at: node.x })?;
        let built_in = support.and_then(|s| s.slope.clone());
        let along = node.along.and_then(|left| self.side(node.x, left)).map(|[_, slope]| slope);
        Ok([level, built_in.or(along).unwrap_or_else(|| node.slope.clone())])
    }

    /// The span on the left of node `i`; none where the beam is on the ground, and where there is no beam.
    pub(super) fn hanging(&self, nodes: &[HoldingNode], i: usize) -> Result<Option<Curve>, Unproven> {
        let ends = [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
        let places = [ends[0].map_or(0.0, |node| node.x), ends[1].map_or(self.length, |node| node.x)];
        if places[1] <= places[0] || ends[0].is_some_and(|node| !node.hangs()) {
            return Ok(None);
        }
        let [left, right] = ends.map(|node| node.map(|node| self.end(node)).transpose());
        Ok(Some(self.span(places, [left?, right?])))
    }

    /// The slopes at which `v''` is the same on both sides: a system with three diagonals, whose right-hand side is what is left of
    /// it without rounding.
    pub(super) fn turn(&self, nodes: &mut [HoldingNode]) -> Result<(), Unproven> {
        /// Each solve adds the digits of 64 bits to those that are right; a slope has no more.
        const SOLVES: usize = 2;
        let free: Vec<bool> = nodes.iter().map(|node| self.turns(node)).collect();
        if !free.contains(&true) {
            return Ok(());
        }
        for _ in 0..SOLVES {
            let mut rows: Vec<[f64; 4]> = free.iter().map(|free| [0.0, f64::from(u8::from(!free)), 0.0, 0.0]).collect();
            let mut left = vec![RBig::ZERO; nodes.len()];
            for i in 0..=nodes.len() {
                let Some(curve) = self.hanging(nodes, i)? else { continue };
                let both = 0 < i && i < nodes.len();
                let l = if both { width([nodes[i - 1].x, nodes[i].x]).to_f64().value() } else { f64::INFINITY };
                let ([start, end], stiff) = (bends(&curve), 2.0 / l);
                if 0 < i && free[i - 1] {
                    rows[i - 1][1] += 2.0 * stiff;
                    rows[i - 1][2] += stiff;
                    left[i - 1] += start;
                }
                if i < nodes.len() && free[i] {
                    rows[i][0] += stiff;
                    rows[i][1] += 2.0 * stiff;
                    left[i] -= end;
                }
            }
            if let Some(i) = rows.iter().position(|row| row[1] <= 0.0) {
                return Err(Unproven::Turns { at: nodes[i].x });
            }
            rows.iter_mut().zip(left).for_each(|(row, left)| row[3] = left.to_f64().value());
            let changes = tridiagonal(rows).ok_or(Unproven::Turns { at: nodes[0].x })?;
            for (node, change) in nodes.iter_mut().zip(changes) {
                node.slope = super::polynomial::short(&(&node.slope + exactly(change)));
            }
        }
        Ok(())
    }

    /// Puts the beam along ground that begins at a support, where it would be steeper or as steep but for rounding. True if it does.
    fn follow(&self, nodes: &mut [HoldingNode]) -> bool {
        /// Slopes that are as good as one, as a share of their size: digits of their solution.
        const ALIKE: f64 = 1e-12;
        let mut changed = false;
        for i in 0..nodes.len() {
            let beside_zone = !nodes[i].hangs() || (0 < i && !nodes[i - 1].hangs());
            let is_open = |s: &&Support| s.slope.is_none() && nodes[i].along.is_none() && !beside_zone;
            let Some(support) = self.support(nodes[i].x).filter(is_open) else { continue };
            for left in [true, false].into_iter().filter(|left| support.tangent[usize::from(!left)]) {
                let node = &mut nodes[i];
                let Some([_, ground]) = self.side(node.x, left) else { continue };
                let steeper = if left { &ground - &node.slope } else { &node.slope - &ground };
                if exactly(-ALIKE) * (magnitude(&ground) + magnitude(&node.slope)) <= steeper {
                    node.along = Some(left);
                    changed = true;
                }
            }
        }
        changed
    }
}
