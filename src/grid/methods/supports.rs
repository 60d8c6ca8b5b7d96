//! The supports of a beam on a grid: the nodes that they hold, and the deflection and slope there.

use std::ops::{Range, RangeInclusive};

use crate::scene::{Grid, Held, Quantity, Scene, SceneError, Spring, Support};

/// A support at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NodeSupport {
    /// Its node.
    pub(crate) node: usize,
    /// The deflection and slope that it prescribes.
    pub(crate) held: Held,
    /// Distance from the beam down to the foundation there, `g − d_s`; infinite without a foundation.
    pub(crate) below: f64,
}

/// A rigid compression-only support at a node. It counts as a point of the foundation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NodeBearing {
    /// Its node.
    pub(crate) node: usize,
    /// Its position.
    pub(crate) at: f64,
    /// Distance from the support down to the foundation; infinite without a foundation, negative if the foundation is higher than the
    /// support.
    below: f64,
}

/// An elastic support at a node: `R = k_s (v − d_s)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NodeSpring {
    /// Its node.
    pub(crate) node: usize,
    /// Its position.
    pub(super) at: f64,
    /// `k_s`.
    pub(super) stiffness: f64,
    /// `d_s`.
    pub(super) deflection: f64,
    /// `k_t` and `φ_s` of an additional rotational spring.
    pub(super) turning: Option<[f64; 2]>,
}

/// All supports of a beam, from left to right.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Supports {
    all: Vec<NodeSupport>,
    /// The supports strictly inside the beam.
    inner: Range<usize>,
    /// Rigid compression-only supports, which hold no node.
    bearings: Vec<NodeBearing>,
    /// Elastic supports that hold the beam both ways, and elastic compression-only supports.
    springs: Vec<NodeSpring>,
    stops: Vec<NodeSpring>,
    /// Whether tension prevents rotation of the beam.
    taut: bool,
    intervals: usize,
}

impl Supports {
    /// The supports of a scene.
    ///
    /// # Errors
    ///
    /// [`SceneError::BetweenNodes`] if a support is not at a node, or if two supports share a node.
    pub(super) fn on(grid: &Grid, scene: &Scene) -> Result<Self, SceneError> {
        let mut before = None;
        for support in scene.beam().all_supports() {
            let node = grid.node_at(support.at).filter(|node| before.is_none_or(|before| before < *node));
            if node.is_none() {
                let (at, intervals) = (support.at, grid.intervals());
                let (quantity, fits) = (Quantity::Supports, Grid::least_fitting(scene));
                return Err(SceneError::BetweenNodes { quantity, at, intervals, fits });
            }
            before = node;
        }
        let held = |held: Held| {
            let node = grid.nearest(held.at / scene.beam().length());
            NodeSupport { node, held, below: scene.gap(grid.place(node)) - held.deflection }
        };
        let bearing = |support: &Support| {
            let node = grid.nearest(support.at / scene.beam().length());
            NodeBearing { node, at: support.at, below: scene.depth(grid.place(node)) - support.level }
        };
        let bearings = scene.beam().bearings().iter().map(bearing).collect();
        let spring = |spring: Spring| {
            let Spring { at, stiffness, deflection, turning, .. } = spring;
            NodeSpring { node: grid.nearest(at / scene.beam().length()), at, stiffness, deflection, turning }
        };
        let springs = scene.springs().filter(|spring| !spring.pushes_only).map(spring).collect();
        let stops = scene.stops().map(spring).collect();
        let held = scene.held().into_iter().map(held).collect();
        let taut = 0.0 < scene.beam().tension();
        Ok(Self { bearings, springs, stops, taut, ..Self::of(held, grid.intervals()) })
    }

    /// The given supports, ascending, and no others.
    pub(super) fn of(all: Vec<NodeSupport>, intervals: usize) -> Self {
        let inner = all.partition_point(|s| s.node == 0)..all.partition_point(|s| s.node < intervals);
        Self { all, inner, bearings: Vec::new(), springs: Vec::new(), stops: Vec::new(), taut: false, intervals }
    }

    /// The same with other rigid supports that hold the beam.
    fn with(&self, all: Vec<NodeSupport>) -> Self {
        let Self { bearings, springs, stops, taut, .. } = self.clone();
        Self { bearings, springs, stops, taut, ..Self::of(all, self.intervals) }
    }

    /// The same with other supports that hold the beam, all of them rigid.
    pub(super) fn holding(&self, all: Vec<NodeSupport>) -> Self {
        Self { springs: Vec::new(), ..self.with(all) }
    }

    /// The same for a beam that tension does not hold.
    pub(super) fn slack(&self) -> Self {
        Self { taut: false, ..self.clone() }
    }

    /// The same with all levels and slopes at zero.
    pub(super) fn at_zero(&self) -> Self {
        let mut zero = self.clone();
        for Held { deflection, slope, turning, .. } in zero.all.iter_mut().map(|support| &mut support.held) {
            *deflection = 0.0;
            *slope = slope.map(|_| 0.0);
            *turning = turning.map(|[k, _]| [k, 0.0]);
        }
        for spring in zero.springs.iter_mut().chain(&mut zero.stops) {
            spring.deflection = 0.0;
            spring.turning = spring.turning.map(|[k, _]| [k, 0.0]);
        }
        zero
    }

    /// The same with the stops raised by the given amounts.
    pub(super) fn raised(&self, by: &[f64]) -> Self {
        let mut raised = self.clone();
        raised.stops.iter_mut().zip(by).for_each(|(stop, by)| stop.deflection -= by);
        raised
    }

    /// Elastic supports that hold the beam both ways, from left to right.
    pub(crate) fn springs(&self) -> &[NodeSpring] {
        &self.springs
    }

    /// Elastic compression-only supports, from left to right.
    pub(crate) fn stops(&self) -> &[NodeSpring] {
        &self.stops
    }

    /// Whether any support is elastic. The beam is then no chain of spans with known levels and slopes at their ends.
    pub(super) fn give(&self) -> bool {
        !(self.springs.is_empty() && self.stops.is_empty() && self.all.iter().all(|s| s.held.turning.is_none()))
    }

    /// `k_t` and `φ_s` of the rotational spring at a node.
    pub(super) fn turning(&self, node: usize) -> Option<[f64; 2]> {
        let spring = || self.springs.binary_search_by_key(&node, |spring| spring.node).ok();
        self.at(node).map_or_else(|| self.springs[spring()?].turning, |support| support.held.turning)
    }

    /// The slope that a support prescribes at a node, rigidly or by a rotational spring.
    pub(super) fn slope(&self, node: usize) -> Option<f64> {
        let held = self.at(node).and_then(|support| support.held.slope);
        held.or_else(|| self.turning(node).map(|[_, slope]| slope))
    }

    /// Rigid compression-only supports, from left to right.
    pub(crate) fn bearings(&self) -> &[NodeBearing] {
        &self.bearings
    }

    /// The rigid compression-only support at a node.
    pub(super) fn pushing(&self, node: usize) -> Option<&NodeBearing> {
        self.bearings.binary_search_by_key(&node, |bearing| bearing.node).ok().map(|i| &self.bearings[i])
    }

    /// Whether a rigid compression-only support at a node lies below the foundation surface.
    pub(super) fn is_sunk(&self, node: usize) -> bool {
        self.pushing(node).is_some_and(|bearing| bearing.below < 0.0)
    }

    /// Distance from the beam down to the foundation if the beam rests on the support at a node.
    pub(super) fn below(&self, node: usize) -> Option<f64> {
        self.at(node).map(|support| support.below).or_else(|| Some(self.pushing(node)?.below))
    }

    /// All supports that hold the beam rigidly.
    pub(crate) fn all(&self) -> &[NodeSupport] {
        &self.all
    }

    /// The supports strictly inside the beam.
    pub(crate) fn inner(&self) -> &[NodeSupport] {
        &self.all[self.inner.clone()]
    }

    /// The supports at the nodes of a range.
    pub(crate) fn within(&self, nodes: &RangeInclusive<usize>) -> &[NodeSupport] {
        let from = self.all.partition_point(|s| s.node < *nodes.start());
        let to = self.all.partition_point(|s| s.node <= *nodes.end());
        &self.all[from..to.max(from)]
    }

    /// The support at a node. Most nodes have none, and most beams have none inside.
    #[inline]
    pub(crate) fn at(&self, node: usize) -> Option<&NodeSupport> {
        if node == 0 {
            self.all.first().filter(|s| s.node == 0)
        } else if node == self.intervals {
            self.all.last().filter(|s| s.node == node)
        } else if self.inner.is_empty() {
            None
        } else {
            self.inner().binary_search_by_key(&node, |s| s.node).ok().map(|i| &self.inner()[i])
        }
    }

    /// Whether a range of nodes, including the last one, certainly has no support. A quick test, because most beams have none inside.
    #[inline]
    pub(crate) fn are_outside(&self, first: usize, last: usize) -> bool {
        self.inner.is_empty()
            && self.bearings.is_empty()
            && self.springs.is_empty()
            && self.stops.is_empty()
            && self.first() <= first
            && last < self.nodes().end
    }

    /// The first node that is not a supported end.
    #[inline]
    pub(crate) fn first(&self) -> usize {
        usize::from(self.inner.start != 0)
    }

    /// All nodes except the ends of the beam that are held.
    pub(crate) fn nodes(&self) -> Range<usize> {
        self.first()..self.intervals + usize::from(self.inner.end == self.all.len())
    }

    /// How many more nodes must carry the beam before it is held: none, one or two.
    pub(crate) fn lacking(&self) -> usize {
        let needed: usize = if self.taut { 1 } else { 2 };
        needed.saturating_sub(self.held_nodes().iter().map(|(_, holds)| holds).sum())
    }

    /// The nodes that the supports hold, ascending, each with the number of motions that it prevents.
    pub(super) fn held_nodes(&self) -> Vec<(usize, usize)> {
        let held =
            self.all.iter().map(|support| (support.node, support.held.slope.or(support.held.turning.map(|t| t[1]))));
        let springs = self.springs.iter().map(|spring| (spring.node, spring.turning.map(|t| t[1])));
        let mut all: Vec<_> =
            held.chain(springs).map(|(node, slope)| (node, 1 + usize::from(slope.is_some()))).collect();
        all.sort_unstable();
        all
    }

    /// The same with additional simple supports at level zero at one or both ends, so that the beam is held. This is a basic
    /// structure for forces that are in balance without them.
    pub(super) fn completed(&self) -> Self {
        match (self.lacking(), self.held_nodes().first().map(|held| held.0)) {
            (0, _) => self.clone(),
            (1, Some(node)) if 2 * node < self.intervals => self.and_at(&[self.intervals]),
            (1, _) => self.and_at(&[0]),
            _ => self.and_at(&[0, self.intervals]),
        }
    }

    /// The same with additional simple supports at level zero at the given nodes.
    pub(super) fn and_at(&self, nodes: &[usize]) -> Self {
        let ghost = |node: &usize| NodeSupport {
            node: *node,
            held: Held {
                at: 0.0,
                deflection: 0.0,
                slope: None,
                turning: None,
                at_level: [false; 2],
                tangent: [false; 2],
            },
            below: 0.0,
        };
        let mut all: Vec<NodeSupport> = self.all.iter().copied().chain(nodes.iter().map(ghost)).collect();
        all.sort_by_key(|support| support.node);
        self.with(all)
    }
}
