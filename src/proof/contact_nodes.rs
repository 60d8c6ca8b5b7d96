//! The nodes of a beam on a rigid foundation: the unchanged positions of its contacts, its supports, and the slopes that follow.

#![expect(clippy::float_cmp, reason = "a place is the same number wherever it is given")]

use dashu_ratio::RBig;

use super::Unproven;
use super::given::{Given, Support};
use super::polynomial::{exactly, magnitude};
use super::span::{Hanging, Span};
use crate::certificate::tridiagonal;
use crate::state::Contact;
use crate::theory::Exact;

/// The state of the beam to the right of a node.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Part {
    /// A span without contact.
    Span,
    /// In contact with a rigid foundation.
    Zone,
    /// Pressed into an elastic foundation; coefficients of `v − g` in powers of `x − from`.
    Pressed(Vec<RBig>),
}

/// A position that holds the beam, or where contact begins or ends.
#[derive(Debug, Clone)]
pub(super) struct HoldingNode {
    pub(super) x: f64,
    /// Whether the slope is that of the foundation on the left side (true) or on the right side (false); [`None`] if the beam has its
    /// own slope.
    pub(super) along: Option<bool>,
    /// Slopes to the left and to the right, which differ at a joint only.
    pub(super) slopes: [RBig; 2],
    pub(super) right: Part,
    /// On an elastic foundation, `v`, and `M` and `M'` on both sides. The slope is then known.
    pub(super) pressed: Option<Box<PressedEnd>>,
}

/// Known values at an end of a part that is pressed into an elastic foundation.
#[derive(Debug, Clone)]
pub(super) struct PressedEnd {
    pub(super) deflection: RBig,
    pub(super) moment: [RBig; 2],
    pub(super) shear: [RBig; 2],
}

impl HoldingNode {
    pub(super) fn new(x: f64, along: Option<bool>, right: Part) -> Self {
        Self { x, along, slopes: [RBig::ZERO, RBig::ZERO], right, pressed: None }
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
        let pair = nodes.windows(2).find(|pair| pair[1].x <= pair[0].x);
        if let Some(wrong) = pair.map(|pair| &pair[1]).or(nodes.last().filter(|last| !last.hangs())) {
            return Err(Unproven::Place { at: wrong.x });
        }
        if let ([node], Some(exact)) = (&mut nodes[..], exact)
            && self.elastic.is_empty()
            && self.turning(node.x).is_none()
            && self.tension.is_zero()
            && self.turns(node, 0)
        {
            node.slopes = [(); 2].map(|()| exactly(exact.slope(node.x)));
            return Ok(nodes);
        }
        // At a support level with the foundation the beam must not be steeper than the foundation.
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
            // Zones that share an end are merged.
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

    /// Whether the beam may rotate at a contact: at a joint, at an end of the beam, without a foundation, and where the two sides of
    /// the foundation differ.
    fn is_corner(&self, x: f64) -> bool {
        let [left, right] = [true, false].map(|left| self.gap_beside(x, left));
        self.joint(x).is_some()
            || left.is_none() && right.is_none()
            || x <= 0.0
            || self.length <= x
            || left != right
            || left.is_some_and(|[g, _]| Some(g) != self.depth(x))
    }

    /// Whether the slope on a side of a node has to be computed from the other values.
    fn turns(&self, node: &HoldingNode, side: usize) -> bool {
        // At a joint the beam follows the foundation on one side only.
        let follows = node.along.is_some_and(|left| self.joint(node.x).is_none() || left == (side == 0));
        !follows && node.pressed.is_none() && self.support(node.x).is_none_or(|s| s.slope.is_none())
    }

    /// `v` and `v'` at a node, on its left or on its right.
    pub(super) fn end(&self, node: &HoldingNode, side: usize) -> Result<[RBig; 2], Unproven> {
        let support = self.support(node.x);
        let given = support.map(|s| s.level.clone()).or(node.pressed.as_ref().map(|end| end.deflection.clone()));
        let level = given.or_else(|| self.depth(node.x)).ok_or(Unproven::Place { at: node.x })?;
        let built_in = support.and_then(|s| s.slope.clone());
        let along = node.along.filter(|_| !self.turns(node, side));
        let ground = along.and_then(|left| self.gap_beside(node.x, left)).map(|[_, slope]| slope);
        Ok([level, built_in.or(ground).unwrap_or_else(|| node.slopes[side].clone())])
    }

    /// The part without contact to the left of node `i`; [`None`] where the beam is in contact or does not exist.
    fn hanging(&self, nodes: &[HoldingNode], i: usize) -> Option<Hanging<'_>> {
        let ends = [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
        let places = [ends[0].map_or(0.0, |node| node.x), ends[1].map_or(self.length, |node| node.x)];
        let hangs = places[0] < places[1] && ends[0].is_none_or(HoldingNode::hangs);
        hangs.then(|| Hanging::new(self, places, ends.map(|node| node.is_none())))
    }

    /// The span on the left of node `i`, if there is one.
    pub(super) fn span(&self, nodes: &[HoldingNode], i: usize) -> Result<Option<Span>, Unproven> {
        let Some(hanging) = self.hanging(nodes, i) else { return Ok(None) };
        let end = |node: Option<&HoldingNode>, side: usize| {
            node.map_or(Ok([RBig::ZERO, RBig::ZERO]), |node| self.end(node, side))
        };
        let ends = [end(i.checked_sub(1).map(|i| &nodes[i]), 1)?, end(nodes.get(i), 0)?];
        hanging.span(&ends).map(Some).ok_or(Unproven::Turns { at: self.beside_span(nodes, i) })
    }

    /// A place that holds the span on the left of node `i`, if anything does.
    fn beside_span(&self, nodes: &[HoldingNode], i: usize) -> f64 {
        let node = nodes.get(i).or(nodes.last()).map(|node| node.x);
        node.or(self.elastic.first().map(|spring| spring.x)).unwrap_or(0.0)
    }

    /// Solves for the slopes at which moments balance at each node. The system is tridiagonal, and its right-hand side is the
    /// residual without rounding.
    ///
    /// ```text
    /// M_right − M_left − C + k_t (ψ − φ) = 0;     at a joint  M_left = M_right = −k_j (ψ_right − ψ_left)
    /// ```
    pub(super) fn turn(&self, nodes: &mut [HoldingNode]) -> Result<(), Unproven> {
        /// Each solve adds as many correct digits as 64 bits have. A slope is stored in 64 bits.
        const SOLVES: usize = 2;
        let is_joint: Vec<bool> = nodes.iter().map(|node| self.joint(node.x).is_some()).collect();
        // A joint has a row for each side.
        let rows: Vec<(usize, usize)> =
            (0..nodes.len()).flat_map(|i| (0..if is_joint[i] { 2 } else { 1 }).map(move |side| (i, side))).collect();
        let row = |i: usize, side: usize| rows.partition_point(|row| *row < (i, if is_joint[i] { side } else { 0 }));
        let free: Vec<bool> = rows.iter().map(|&(i, side)| self.turns(&nodes[i], side)).collect();
        if !free.contains(&true) {
            return Ok(());
        }
        let stiffness = (0..=nodes.len())
            .map(|i| {
                let turns = || Unproven::Turns { at: self.beside_span(nodes, i) };
                self.hanging(nodes, i).map(|hanging| hanging.stiffness().ok_or_else(turns))
            })
            .map(Option::transpose)
            .collect::<Result<Vec<_>, _>>()?;
        for _ in 0..SOLVES {
            let mut system: Vec<[f64; 4]> = vec![[0.0; 4]; rows.len()];
            let mut left = vec![RBig::ZERO; rows.len()];
            for (i, stiffness) in stiffness.iter().enumerate() {
                let (Some(span), Some([a, b, c])) = (self.span(nodes, i)?, *stiffness) else { continue };
                let at_ends = [i.checked_sub(1).map(|i| row(i, 1)), (i < nodes.len()).then(|| row(i, 0))];
                if let Some(start) = at_ends[0] {
                    (system[start][1], system[start][2]) = (system[start][1] + a, b);
                    left[start] += &span.moments[0];
                }
                if let Some(end) = at_ends[1] {
                    (system[end][1], system[end][0]) = (system[end][1] + c, b);
                    left[end] -= &span.moments[1];
                }
            }
            for (i, node) in nodes.iter().enumerate() {
                self.hold_turning(node, &mut system[row(i, 0)..=row(i, 1)], &mut left[row(i, 0)..=row(i, 1)]);
            }
            let mut system: Vec<[f64; 4]> =
                system.into_iter().zip(&left).map(|([l, d, r, _], m)| [l, d, r, -m.to_f64().value()]).collect();
            for (k, is_free) in free.iter().enumerate() {
                if !is_free {
                    system[k] = [0.0, 1.0, 0.0, 0.0];
                }
            }
            if let Some(k) = system.iter().position(|row| row[1] <= 0.0) {
                return Err(Unproven::Turns { at: nodes[rows[k].0].x });
            }
            let changes = tridiagonal(system).ok_or(Unproven::Turns { at: nodes[0].x })?;
            for (i, node) in nodes.iter_mut().enumerate() {
                let changed =
                    |side: usize| super::polynomial::short(&(&node.slopes[side] + exactly(changes[row(i, side)])));
                node.slopes = [changed(0), changed(1)];
            }
        }
        Ok(())
    }

    /// Adds the contribution of a joint, couple or rotational spring at a node to its rows.
    fn hold_turning(&self, node: &HoldingNode, rows: &mut [[f64; 4]], left: &mut [RBig]) {
        if let ([first, second], [m0, m1], Some(stiffness)) = (&mut *rows, &mut *left, self.joint(node.x)) {
            let Some(k) = stiffness else { return };
            let moment = -k * (&node.slopes[1] - &node.slopes[0]);
            let k = k.to_f64().value();
            (first[1], first[2], second[1], second[0]) = (first[1] + k, -k, second[1] + k, -k);
            (*m0, *m1) = (&*m0 + &moment, &*m1 - &moment);
            return;
        }
        let [_, couple] = self.acting(node.x);
        left[0] -= couple;
        if let Some([k, rest]) = self.turning(node.x) {
            rows[0][1] += k.to_f64().value();
            left[0] += k * (&node.slopes[0] - rest);
        }
    }

    /// Sets the slope of the beam to that of a foundation which begins at a support, where the beam would be steeper than the
    /// foundation or as steep up to rounding. Returns whether it changed any.
    fn follow(&self, nodes: &mut [HoldingNode]) -> bool {
        /// Slopes that differ by less than this fraction of their size count as equal, because the solution has so many digits.
        const ALIKE: f64 = 1e-12;
        let mut changed = false;
        for i in 0..nodes.len() {
            let beside_zone = !nodes[i].hangs() || (0 < i && !nodes[i - 1].hangs());
            let is_open = |s: &&Support| s.slope.is_none() && nodes[i].along.is_none() && !beside_zone;
            let Some(support) = self.support(nodes[i].x).filter(is_open) else { continue };
            for left in [true, false].into_iter().filter(|left| support.tangent[usize::from(!left)]) {
                let node = &mut nodes[i];
                let Some([_, ground]) = self.gap_beside(node.x, left) else { continue };
                let slope = &node.slopes[usize::from(!left)];
                let steeper = if left { &ground - slope } else { slope - &ground };
                if exactly(-ALIKE) * (magnitude(&ground) + magnitude(slope)) <= steeper {
                    node.along = Some(left);
                    changed = true;
                }
            }
        }
        changed
    }
}
