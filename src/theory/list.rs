//! The list of nodes from left to right, and the spans between them: every beam is a free beam that is held by nodes.
//!
//! A node is a position at which the beam is held. It has a slope condition, and it says whether the beam is in contact from there to
//! the next node. The scene says whether the node is a support, an edge or a free end.
//!
//! | node | slope | lies | given | unknown | equation | force |
//! |---|---|---|---|---|---|---|
//! | support | free | no | `v` | slope | `v''` the same on both sides | of either sign |
//! | built-in support | of the support | no | `v`, `v'` | – | – | of either sign, and a couple |
//! | support with the foundation at its level | of the foundation | either | `v`, `v'` | – | – | of either sign, and a couple |
//! | edge (kink, step, compression-only support, touching free end) | free | no | `v = g` | slope | `v''` the same on both sides | ≥ 0 |
//! | smooth point | of the foundation | no | `h = h' = 0` | position | `h''` the same on both sides | ≥ 0 |
//! | start of a zone | of the foundation | yes | `h = h' = 0` | position | `h'' = 0` in the span | ≥ 0 |
//! | end of a zone | of the foundation, from its left | no | `h = h' = 0` | position | `h'' = 0` in the span | ≥ 0 |
//! | free end in a zone | of the foundation | left: yes | `h = h' = 0` | – | `g'' = 0` there, or it lifts | ≥ 0 |
//!
//! Beyond the outermost nodes the beam overhangs: moment and shear force there follow from its loads. So the outermost node, if it
//! leaves the slope free, is a hinge with a given moment and has no unknown. A free end in a zone has no unknown position: next to a
//! zone on a straight foundation the moment of an overhang vanishes doubly at the free end, which would make the equation singular. If
//! springs support the beam beyond the node, or a rotational spring acts at it, statics does not determine its moment, and its slope is
//! unknown.
//!
//! A foundation at the level of a support may fix the slope of the beam there: it pushes up next to the support, which pulls down, and
//! the two forces form a couple. If a zone begins or ends there, only the sum of its force and the support force is unique. All of it
//! is assigned to the support.

mod spans;

use super::overhang::Overhang;
use super::piecewise::PiecewiseScene;
use super::span::{End, EndCondition};
use crate::certificate::Slope;

/// The unknown of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unknown {
    /// The position.
    Place,
    /// The slope of the beam.
    Slope,
}

/// A position at which the beam is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    /// Position.
    pub(super) x: f64,
    /// Condition on the slope `v'` of the beam. At a built-in support the slope is given by the support.
    pub(super) slope: Slope,
    /// Whether the beam is in contact from here to the next node.
    pub(super) lies: bool,
    /// The low-order part of the position, or of a free slope, which is less than a unit in the last place. The forces of contacts that
    /// are close together depend on it.
    pub(super) low: f64,
    /// A cell of the smooth piece of the profile that contains the node; at a breakpoint the cell to its right.
    pub(super) cell: usize,
    /// The breakpoint of the node; [`None`] if the node moves along a smooth piece of the profile.
    pub(super) breakpoint: Option<usize>,
}

/// The nodes from left to right, including every support.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct List {
    /// From left to right.
    pub(super) nodes: Vec<Node>,
}

/// A zone of a list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zone {
    /// Index of the node to its right.
    pub(super) node: usize,
    /// Start.
    pub(super) from: f64,
    /// End.
    pub(super) to: f64,
}

impl List {
    /// The beam without contact.
    pub(super) fn free(given: &PiecewiseScene) -> Self {
        Self { nodes: given.supports.iter().map(|support| Node::at(given, support.breakpoint)).collect() }
    }

    /// The unknown of node `i`, if it has one.
    pub(super) fn unknown(&self, given: &PiecewiseScene, i: usize) -> Option<Unknown> {
        let node = self.nodes.get(i)?;
        if node.can_move() {
            return Some(Unknown::Place);
        }
        // Under an axial force the moment of an overhang depends on its slope.
        let bends = match given.tension == 0.0 {
            true => !self.overhangs(given, i).contains(&true),
            false => 0.0 < node.x && node.x < given.length,
        };
        let bends = bends || node.turning(given).is_some();
        (bends && node.held_slope(given).is_none()).then_some(Unknown::Slope)
    }

    /// The number of unknowns.
    pub(super) fn unknowns(&self, given: &PiecewiseScene) -> usize {
        (0..self.nodes.len()).filter(|&i| self.unknown(given, i).is_some()).count()
    }

    /// The zones from left to right.
    pub(super) fn zones(&self) -> impl Iterator<Item = Zone> {
        let zone = |i: usize| Zone { node: i, from: self.nodes[i - 1].x, to: self.nodes[i].x };
        (1..self.nodes.len()).filter(|&i| self.in_zone_before(i)).map(zone)
    }

    /// Whether the stretch that ends at node `i` is a zone.
    pub(super) fn in_zone_before(&self, i: usize) -> bool {
        i < self.nodes.len() && i.checked_sub(1).is_some_and(|left| self.nodes[left].lies)
    }

    /// On which sides of node `i` the foundation fixes the slope of the beam.
    pub(super) fn follows_foundation(&self, i: usize) -> [bool; 2] {
        let held = |left: bool| self.nodes[i].slope == Slope::OfGround { from_the_left: left };
        [self.in_zone_before(i) || held(true), self.in_zone_before(i + 1) || held(false)]
    }
}

impl Node {
    /// A point contact at `x`, on the smooth piece of the profile that `cell` belongs to.
    pub(super) fn touch(x: f64, cell: usize) -> Self {
        Self { x, slope: Slope::OfGround { from_the_left: false }, lies: false, low: 0.0, cell, breakpoint: None }
    }

    /// The start of a zone.
    pub(super) fn start(x: f64, cell: usize) -> Self {
        Self { lies: true, ..Self::touch(x, cell) }
    }

    /// The end of a zone.
    pub(super) fn end(x: f64, cell: usize) -> Self {
        Self { slope: Slope::OfGround { from_the_left: true }, ..Self::touch(x, cell) }
    }

    /// A node at a breakpoint that leaves the slope free.
    pub(super) fn at(given: &PiecewiseScene, breakpoint: usize) -> Self {
        let [_, cell] = given.cells_beside(breakpoint);
        let free = Self { slope: Slope::Free(0.0), ..Self::touch(given.breakpoints[breakpoint].x, cell) };
        Self { breakpoint: Some(breakpoint), ..free }
    }

    /// A free end of the beam at which a zone starts or ends.
    pub(super) fn tip(given: &PiecewiseScene, at_left: bool) -> Self {
        let breakpoint = if at_left { 0 } else { given.cells.len() };
        Self { slope: Slope::OfGround { from_the_left: !at_left }, lies: at_left, ..Self::at(given, breakpoint) }
    }

    /// A hinge on a straight foundation at which a zone starts or ends.
    pub(super) fn hinge_of_zone(given: &PiecewiseScene, breakpoint: usize, starts: bool) -> Self {
        Self { slope: Slope::OfGround { from_the_left: !starts }, lies: starts, ..Self::at(given, breakpoint) }
    }

    /// Whether the node can move along a smooth piece of the profile.
    pub(super) fn can_move(&self) -> bool {
        self.breakpoint.is_none()
    }

    /// Whether a zone starts or ends at the node, and moves with it.
    pub(super) fn is_of_zone(&self) -> bool {
        self.starts_zone() || self.ends_zone()
    }

    /// Whether a zone starts at the node, and moves with it.
    pub(super) fn starts_zone(&self) -> bool {
        self.can_move() && self.lies
    }

    /// Whether a zone ends at the node, and moves with it.
    pub(super) fn ends_zone(&self) -> bool {
        self.can_move() && self.slope == Slope::OfGround { from_the_left: true }
    }

    /// Whether it is a point contact on a smooth piece of the profile.
    pub(super) fn is_smooth(&self) -> bool {
        self.can_move() && !self.is_of_zone()
    }

    /// Whether it is an edge of the profile, a compression-only support or a free end of the beam, on which the beam can rotate.
    pub(super) fn is_edge(&self, given: &PiecewiseScene) -> bool {
        !self.can_move() && !self.is_held() && self.support(given).is_none()
    }

    /// Whether it is a free end of the beam in a zone, or a hinge at which a zone starts or ends.
    pub(super) fn is_tip(&self, given: &PiecewiseScene) -> bool {
        !self.can_move() && self.is_held() && self.support(given).is_none()
    }

    /// Whether the foundation fixes the slope of the beam.
    pub(super) fn is_held(&self) -> bool {
        matches!(self.slope, Slope::OfGround { .. })
    }

    /// Whether it is a support at which the foundation fixes the slope of the beam.
    pub(super) fn rests_at_support(&self, given: &PiecewiseScene) -> bool {
        let support = self.support(given).map(|support| &given.supports[support]);
        support.is_some_and(|support| self.is_held() || support.slope.is_some() && !support.built_in)
    }

    /// The index of the support at the node, if there is one.
    pub(super) fn support(&self, given: &PiecewiseScene) -> Option<usize> {
        given.support_at(self.breakpoint?)
    }

    /// The index of any support at the node; compression-only supports are counted after the others.
    pub(super) fn any_support(&self, given: &PiecewiseScene) -> Option<usize> {
        self.support(given).or_else(|| given.bearing_index(self.breakpoint.filter(|_| !self.is_held())?))
    }

    /// Whether it is a point contact, with the foundation or with a compression-only support.
    pub(super) fn is_point(&self, given: &PiecewiseScene) -> bool {
        self.is_smooth() || self.is_edge(given)
    }

    /// Whether it is a point contact with the foundation.
    pub(super) fn is_ground(&self, given: &PiecewiseScene) -> bool {
        self.is_point(given) && self.any_support(given).is_none()
    }

    /// Moves the node to the sum of `x` and `low`, of which `x` is much the larger.
    pub(super) fn move_to(&mut self, x: f64, low: f64) {
        self.x = x + low;
        self.low = low - (self.x - x);
    }

    /// Adds to the slope if it is free.
    pub(super) fn turn_by(&mut self, step: f64) {
        let Slope::Free(before) = self.slope else { return };
        let low = self.low + step;
        let slope = before + low;
        self.low = low - (slope - before);
        self.slope = Slope::Free(slope);
    }

    /// Lets the foundation on one side fix the slope, if the slope is free.
    pub(super) fn hold(&mut self, from_the_left: bool) {
        if !self.is_held() {
            (self.slope, self.low) = (Slope::OfGround { from_the_left }, 0.0);
        }
    }

    /// A free slope and its low-order part.
    fn free_slope(&self) -> [f64; 2] {
        match self.slope {
            Slope::Free(slope) => [slope, self.low],
            Slope::OfGround { .. } => [0.0; 2],
        }
    }

    /// The slope of the beam where it is fixed, by a built-in support or by the foundation.
    pub(super) fn held_slope(&self, given: &PiecewiseScene) -> Option<f64> {
        let own = self.support(given).and_then(|support| given.supports[support].slope);
        own.or_else(|| match self.slope {
            Slope::Free(_) => None,
            // The slope of the piece that contains the node, which may end just there.
            Slope::OfGround { from_the_left } => {
                let cell = self.breakpoint.map_or(self.cell, |i| given.cells_beside(i)[usize::from(!from_the_left)]);
                Some(given.derivative(cell, self.x, 1))
            }
        })
    }

    /// The flexibility of the joint at the node; the joint belongs to the span on its left.
    fn joint(&self, given: &PiecewiseScene) -> f64 {
        self.breakpoint.map_or(0.0, |i| given.breakpoints[i].joint)
    }

    /// The jump of `v''` at the node, from a couple and a rotational spring.
    pub(super) fn couple(&self, given: &PiecewiseScene) -> f64 {
        let at = self.breakpoint.or_else(|| given.exactly_at(self.x, self.cell));
        let couple = at.map_or(0.0, |i| given.breakpoints[i].acts.couple());
        let Some([k, without]) = self.turning(given) else { return couple };
        let [slope, low] = self.held_slope(given).map_or_else(|| self.free_slope(), |slope| [slope, 0.0]);
        couple + k * ((slope - without) + low)
    }

    /// The rotational spring at the node: its stiffness, and the slope at which its moment is zero.
    pub(super) fn turning(&self, given: &PiecewiseScene) -> Option<[f64; 2]> {
        let moved = || given.exactly_at(self.x, self.cell).filter(|_| !given.springs.is_empty());
        given.turning_at(self.breakpoint.or_else(moved)?)
    }

    /// The cells to the right and to the left of the node.
    fn cells(&self, given: &PiecewiseScene) -> [usize; 2] {
        match self.breakpoint {
            Some(breakpoint) => {
                let [left, right] = given.cells_beside(breakpoint);
                [right, left]
            }
            None => given.cells_at(self.x, self.cell),
        }
    }

    /// The end of a span at the node; the span starts in `cell`.
    fn span_end(&self, given: &PiecewiseScene, cell: usize) -> End {
        End { x: self.x, low: self.low, cell, hold: self.end_condition(given, cell) }
    }

    /// Makes the end of a span at the outermost node a hinge, if the node leaves the slope free.
    fn hinge(&self, given: &PiecewiseScene, end: &mut End, at_left: bool) {
        if let EndCondition::Edge { height, level, .. } = end.hold
            && self.held_slope(given).is_none()
            && self.turning(given).is_none()
            && (given.tension == 0.0 || self.x <= 0.0 || given.length <= self.x)
        {
            let couple = if at_left { self.couple(given) } else { -self.couple(given) };
            let curvature = Overhang::of(given, self.x, at_left).moment + couple;
            end.hold = EndCondition::Hinge { height, level, curvature };
        }
    }

    /// The end condition of a span at the node.
    fn end_condition(&self, given: &PiecewiseScene, cell: usize) -> EndCondition {
        let Some(breakpoint) = self.breakpoint else { return self.moving_end(given, cell) };
        let [left, _] = given.cells_beside(breakpoint);
        let on_the_right = cell != left || self.x <= 0.0;
        if self.slope == (Slope::OfGround { from_the_left: !on_the_right }) {
            return EndCondition::Resting;
        }
        if self.is_tip(given) && given.breakpoints[breakpoint].is_hinge() {
            // Next to a zone the span rotates freely in the hinge.
            return EndCondition::Hinge { height: 0.0, level: given.breakpoints[breakpoint].depth, curvature: 0.0 };
        }
        let (height, level) = match self.support(given).map(|support| &given.supports[support]) {
            Some(support) => (support.clearance[usize::from(on_the_right)], support.level),
            // The lower side of a step is below the beam, which rests on the upper side.
            None => (given.height(breakpoint, cell), given.breakpoints[breakpoint].depth),
        };
        EndCondition::Edge {
            height,
            level,
            slope: self.held_slope(given).map_or_else(|| self.free_slope(), |slope| [slope, 0.0]),
        }
    }

    /// The end condition at a node that can move. At the very end of its piece of the profile, its other side is on the next piece.
    fn moving_end(&self, given: &PiecewiseScene, cell: usize) -> EndCondition {
        if given.cells[cell].shape == given.cells[self.cell].shape {
            return EndCondition::Resting;
        }
        let [level, slope] = [0, 1].map(|order| given.derivative(self.cell, self.x, order));
        EndCondition::Edge { height: given.derivative(cell, self.x, 0) - level, level, slope: [slope, 0.0] }
    }
}
