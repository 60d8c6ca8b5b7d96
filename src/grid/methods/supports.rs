//! The supports of a beam on a grid: which nodes they hold, at which deflection and slope.

use std::ops::{Range, RangeInclusive};

use crate::scene::{Grid, Held, Quantity, Scene, SceneError, Spring, Support};

/// A support at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NodeSupport {
    /// Its node.
    pub(crate) node: usize,
    /// What it prescribes.
    pub(crate) held: Held,
    /// How far the ground lies below the beam there, `g − d_s`; infinite where there is none.
    pub(crate) below: f64,
}

/// A support that only pushes, at a node: a place of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NodeBearing {
    /// Its node.
    pub(crate) node: usize,
    /// Where it stands.
    pub(crate) at: f64,
    /// How far the ground lies below it; infinite where there is none, and negative where it stands in the ground.
    below: f64,
}

/// A support that gives, at a node: `R = k_s (v − d_s)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NodeSpring {
    /// Its node.
    pub(crate) node: usize,
    /// Where it stands.
    pub(super) at: f64,
    /// `k_s`.
    pub(super) stiffness: f64,
    /// `d_s`.
    pub(super) deflection: f64,
    /// `k_t` and `φ_s` of a spring against turning besides.
    pub(super) turning: Option<[f64; 2]>,
}

/// All supports of a beam, from left to right.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Supports {
    all: Vec<NodeSupport>,
    /// Those between the two end nodes.
    inner: Range<usize>,
    /// Those that only push, which hold no node.
    bearings: Vec<NodeBearing>,
    /// Those that give and hold the beam both ways, and those that give and only push.
    springs: Vec<NodeSpring>,
    stops: Vec<NodeSpring>,
    /// Whether tension holds the beam against turning.
    taut: bool,
    intervals: usize,
}

impl Supports {
    /// Those of a scene.
    ///
    /// # Errors
    ///
    /// [`SceneError::BetweenNodes`] if no node lies on one of them, or two share a node.
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

    /// Given ones, ascending.
    pub(super) fn of(all: Vec<NodeSupport>, intervals: usize) -> Self {
        let inner = all.partition_point(|s| s.node == 0)..all.partition_point(|s| s.node < intervals);
        Self { all, inner, bearings: Vec::new(), springs: Vec::new(), stops: Vec::new(), taut: false, intervals }
    }

    /// The same with others that hold the beam and do not give.
    fn with(&self, all: Vec<NodeSupport>) -> Self {
        let Self { bearings, springs, stops, taut, .. } = self.clone();
        Self { bearings, springs, stops, taut, ..Self::of(all, self.intervals) }
    }

    /// The same with others that hold the beam.
    pub(super) fn holding(&self, all: Vec<NodeSupport>) -> Self {
        Self { springs: Vec::new(), ..self.with(all) }
    }

    /// The same of a beam that tension does not hold.
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

    /// The same with the stops raised by so much.
    pub(super) fn raised(&self, by: &[f64]) -> Self {
        let mut raised = self.clone();
        raised.stops.iter_mut().zip(by).for_each(|(stop, by)| stop.deflection -= by);
        raised
    }

    /// Those that give and hold the beam both ways, from left to right.
    pub(crate) fn springs(&self) -> &[NodeSpring] {
        &self.springs
    }

    /// Those that give and only push, from left to right.
    pub(crate) fn stops(&self) -> &[NodeSpring] {
        &self.stops
    }

    /// Whether any gives: a beam on it is no chain of spans with given ends.
    pub(super) fn give(&self) -> bool {
        !(self.springs.is_empty() && self.stops.is_empty() && self.all.iter().all(|s| s.held.turning.is_none()))
    }

    /// `k_t` and `φ_s` of a spring against turning at a node.
    pub(super) fn turning(&self, node: usize) -> Option<[f64; 2]> {
        let spring = || self.springs.binary_search_by_key(&node, |spring| spring.node).ok();
        self.at(node).map_or_else(|| self.springs[spring()?].turning, |support| support.held.turning)
    }

    /// The slope that a support at a node holds, stiffly or by a spring.
    pub(super) fn slope(&self, node: usize) -> Option<f64> {
        let held = self.at(node).and_then(|support| support.held.slope);
        held.or_else(|| self.turning(node).map(|[_, slope]| slope))
    }

    /// Those that only push, from left to right.
    pub(crate) fn bearings(&self) -> &[NodeBearing] {
        &self.bearings
    }

    /// The one that only pushes at a node.
    pub(super) fn pushing(&self, node: usize) -> Option<&NodeBearing> {
        self.bearings.binary_search_by_key(&node, |bearing| bearing.node).ok().map(|i| &self.bearings[i])
    }

    /// Whether one that only pushes stands at a node in the ground.
    pub(super) fn is_sunk(&self, node: usize) -> bool {
        self.pushing(node).is_some_and(|bearing| bearing.below < 0.0)
    }

    /// How far the ground lies below the beam where it is on the support at a node.
    pub(super) fn below(&self, node: usize) -> Option<f64> {
        self.at(node).map(|support| support.below).or_else(|| Some(self.pushing(node)?.below))
    }

    /// All of them.
    pub(crate) fn all(&self) -> &[NodeSupport] {
        &self.all
    }

    /// Those between the two end nodes.
    pub(crate) fn inner(&self) -> &[NodeSupport] {
        &self.all[self.inner.clone()]
    }

    /// Those at the nodes of a range.
    pub(crate) fn within(&self, nodes: &RangeInclusive<usize>) -> &[NodeSupport] {
        let from = self.all.partition_point(|s| s.node < *nodes.start());
        let to = self.all.partition_point(|s| s.node <= *nodes.end());
        &self.all[from..to.max(from)]
    }

    /// The one at a node. Most nodes have none, and most beams none inside.
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

    /// Whether a range of nodes, the last one included, certainly has none; a quick test, as most beams have none inside.
    #[inline]
    pub(crate) fn are_outside(&self, first: usize, last: usize) -> bool {
        self.inner.is_empty()
            && self.bearings.is_empty()
            && self.springs.is_empty()
            && self.stops.is_empty()
            && self.first() <= first
            && last < self.nodes().end
    }

    /// The first node that is no supported end.
    #[inline]
    pub(crate) fn first(&self) -> usize {
        usize::from(self.inner.start != 0)
    }

    /// The nodes but those ends of the beam that are held.
    pub(crate) fn nodes(&self) -> Range<usize> {
        self.first()..self.intervals + usize::from(self.inner.end == self.all.len())
    }

    /// How many more places have to carry the beam before it is held: none, one, or two.
    pub(crate) fn lacking(&self) -> usize {
        let needed: usize = if self.taut { 1 } else { 2 };
        needed.saturating_sub(self.holds().iter().map(|(_, holds)| holds).sum())
    }

    /// The nodes that they hold, ascending, with the number of motions that each prevents.
    pub(super) fn holds(&self) -> Vec<(usize, usize)> {
        let held =
            self.all.iter().map(|support| (support.node, support.held.slope.or(support.held.turning.map(|t| t[1]))));
        let springs = self.springs.iter().map(|spring| (spring.node, spring.turning.map(|t| t[1])));
        let mut all: Vec<_> =
            held.chain(springs).map(|(node, slope)| (node, 1 + usize::from(slope.is_some()))).collect();
        all.sort_unstable();
        all
    }

    /// The same with simple supports at level zero at such ends of the beam that it is held: a basic structure for forces that
    /// are in balance without these.
    pub(super) fn completed(&self) -> Self {
        match (self.lacking(), self.holds().first().map(|held| held.0)) {
            (0, _) => self.clone(),
            (1, Some(node)) if 2 * node < self.intervals => self.and_at(&[self.intervals]),
            (1, _) => self.and_at(&[0]),
            _ => self.and_at(&[0, self.intervals]),
        }
    }

    /// The same with simple supports at level zero at some other nodes.
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
