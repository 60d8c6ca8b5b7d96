//! A scene on a grid: what the three methods have in common before they choose an unknown.
//!
//! Unknowns belong to the nodes without a support. Of the paper's beam these are the interior nodes; an end without a support is
//! one of them, and a node inside with a support is none.

use std::ops::Range;

use super::contact_set::ContactSet;
use super::statics;
use super::supports::{NodeSupport, Supports};
use crate::qp::{FreeSet, Sizes};
use crate::scene::{Balance, Foundation, Grid, Held, Scene, SceneError};
use crate::state::Discretisation;

/// Nodal data of a scene on a grid. The scene is dimensionless and has a foundation.
#[derive(Debug, Clone, PartialEq)]
pub struct Discrete {
    /// The grid.
    pub grid: Grid,
    /// Number `N` of intervals.
    pub intervals: usize,
    /// Spacing `Δ`.
    pub spacing: f64,
    /// Bending stiffness `EI`.
    pub stiffness: f64,
    /// Loads on all nodes, `q_0 … q_{n+1}`, supports included: forces, not densities.
    pub loads: Vec<f64>,
    /// Gaps `g` below the undeflected beam, of a straight one the depths `u`, at [all nodes but supported ends](Self::nodes).
    pub depths: Vec<f64>,
    supports: Supports,
    /// The profiles of ground and own shape that the gaps are taken from.
    profile: Option<Foundation>,
    shape: Option<Foundation>,
    /// Whether the beam is the paper's.
    simple: bool,
    sizes: Sizes,
}

/// Intervals of the grid on which sizes are measured, if it is not coarser anyway: a size needs two digits.
const SIZING: usize = 4096;

/// Slopes, and depths, that differ by less than this share of their size are equal.
const SAME_SLOPE: f64 = 64.0 * f64::EPSILON;

/// Size of a clearance over ground that leaves no room to deflect, as a share of the free deflection.
const ON_THE_GROUND: f64 = 1e-6;

impl Discrete {
    /// The nodal data of `scene` on `intervals` equal intervals.
    ///
    /// # Errors
    ///
    /// [`SceneError::TooFewIntervals`], and [`SceneError::SupportBetweenNodes`].
    pub fn new(scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        let discrete = Self::unmeasured(scene, intervals)?;
        if discrete.simple {
            return Ok(Self { sizes: sizes(scene, intervals.min(SIZING))?, ..discrete });
        }
        // A coarser grid with the supports among its nodes, if there is one.
        let step = Grid::least_fitting(scene).unwrap_or(intervals);
        let coarse = SIZING / step * step;
        let sizes = match coarse {
            2.. if coarse < intervals => Self::unmeasured(scene, coarse)?.measured(),
            _ => discrete.measured(),
        };
        Ok(Self { sizes, ..discrete })
    }

    fn unmeasured(scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        let grid = Grid::uniform(scene, intervals)?;
        let supports = Supports::on(&grid, scene)?;
        Ok(Self {
            grid,
            intervals,
            spacing: grid.spacing(),
            stiffness: scene.beam().bending_stiffness(),
            depths: grid.gaps_at(scene, supports.nodes()),
            supports,
            profile: scene.foundation().cloned(),
            shape: scene.beam().shape().cloned(),
            simple: scene.beam().is_simple(),
            sizes: Sizes { x: 1.0, gradient: 1.0 },
            loads: grid.nodal_loads(scene.load()),
        })
    }

    /// `n`, the number of interior nodes.
    #[must_use]
    pub fn interior(&self) -> usize {
        self.intervals - 1
    }

    /// Loads `q_1 … q_n` on the interior nodes.
    #[must_use]
    pub fn interior_loads(&self) -> &[f64] {
        &self.loads[1..self.intervals]
    }

    /// The loads on all nodes; the memory of everything else is given back.
    pub(super) fn into_loads(self) -> Vec<f64> {
        self.loads
    }

    /// All nodes but the ends of the beam that have a support.
    #[must_use]
    pub fn nodes(&self) -> Range<usize> {
        self.supports.nodes()
    }

    /// Which of the two ends of the beam have a support.
    pub(crate) fn held_ends(&self) -> [bool; 2] {
        [0, self.intervals].map(|node| self.supports.at(node).is_some())
    }

    /// The supports.
    pub(crate) fn supports(&self) -> &Supports {
        &self.supports
    }

    /// Whether the beam is the paper's: straight, on two simple supports at its ends, at level 0.
    pub(super) fn is_simple(&self) -> bool {
        self.simple
    }

    /// Number of nodes without a support.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.nodes().len() - self.supports.inner().len()
    }

    /// The node of an unknown.
    pub(super) fn node(&self, unknown: usize) -> usize {
        let first = self.nodes().start + unknown;
        self.supports.inner().iter().fold(first, |node, support| node + usize::from(support.node <= node))
    }

    /// Values at [`nodes`](Self::nodes) without those at supports.
    pub(super) fn without_supports(&self, mut values: Vec<f64>) -> Vec<f64> {
        let first = self.nodes().start;
        for support in self.supports.inner().iter().rev() {
            values.remove(support.node - first);
        }
        values
    }

    /// Values of unknowns, and zero at inner supports.
    pub(super) fn with_supports(&self, mut values: Vec<f64>) -> Vec<f64> {
        let first = self.nodes().start;
        for support in self.supports.inner() {
            values.insert(support.node - first, 0.0);
        }
        values
    }

    /// Deflection at the interior nodes under nodal forces `t_1 … t_n` of the paper's beam: `v = C t`, (25), by statics and without
    /// `C`.
    #[must_use]
    pub fn deflection(&self, forces: &[f64], discretisation: Discretisation) -> Vec<f64> {
        deflection(forces, self.spacing, self.stiffness, discretisation)
    }

    /// Clearances `h = g − v` at [`nodes`](Self::nodes).
    #[must_use]
    pub fn clearances(&self, deflection: &[f64]) -> Vec<f64> {
        self.depths.iter().zip(deflection).map(|(u, v)| u - v).collect()
    }

    /// Sizes of deflection (or clearance) and of nodal force in this scene, for dimensionless residuals.
    ///
    /// The deflection is limited by the beam without ground and by the foundation, whichever is nearer:
    /// `max_i min(|g_i|, |v_free,i|)`. Over ground at the line of the supports it cannot move at all, and a small part of the
    /// free deflection has to do. Of a beam that its supports do not hold, gaps count from where it would rest if it were
    /// rigid, and the free deflection is that of a beam held at its ends. Forces are measured by the sum of the nodal loads;
    /// without loads, by the force that deflects a simple beam by that much, `48 EI v / l³`.
    #[must_use]
    pub fn sizes(&self) -> Sizes {
        self.sizes
    }

    /// [`sizes`](Self::sizes) of any beam.
    fn measured(&self) -> Sizes {
        let basic = self.basic(self.loads.clone());
        let nothing: FreeSet = FreeSet::none(basic.unknowns());
        let free = ContactSet::where_free(&basic, &nothing).solve(&basic, Discretisation::BeamElements);
        // Above ground at zero, a clearance is a deflection upwards.
        let free = free.map_or_else(|_| Vec::new(), |free| free.clearance);
        let offset = basic.nodes().start - self.nodes().start;
        let line = self.resting_line();
        let room: Vec<f64> = self.nodes().zip(&self.depths).map(|(node, gap)| gap - line(node)).collect();
        let loads = self.nodes().filter(|node| self.supports.at(*node).is_none()).map(|node| self.loads[node]);
        let length = self.grid.place(self.intervals);
        size(&free, &room[offset..], loads, self.stiffness, length)
    }

    /// Gap below a node that is no supported end.
    pub(super) fn gap(&self, node: usize) -> f64 {
        self.depths[node - self.supports.first()]
    }

    /// Level at which a node is held: that of its support, or of the ground.
    pub(super) fn level(&self, node: usize) -> f64 {
        self.supports.at(node).map_or_else(|| self.gap(node), |support| support.held.deflection)
    }

    /// Size of the numbers from which the gap below a node, or below a chord beside it, is computed.
    pub(super) fn depth_rounding(&self, node: usize) -> f64 {
        let size = |profile: &Option<Foundation>| {
            profile.as_ref().map_or(0.0, |profile| profile.magnitude_at(self.grid.place(node)))
        };
        size(&self.profile) + size(&self.shape)
    }

    /// By how much the slope of the polyline through three nodes, held on the foundation or by supports, grows at the middle one.
    /// Where a built-in support holds that one, it is on one side of it twice, and the slope there is that of the support.
    #[inline]
    pub(super) fn bend(&self, left: usize, node: usize, right: usize) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let [before, behind] = [node - left, right - node].map(|steps| self.spacing * steps as f64);
        let place = |i: usize| self.grid.place(i);
        let chord = |from: usize, to: usize, length: f64| (self.level(to) - self.level(from)) / length;
        if left == node || node == right {
            let held = self.supports.at(node).and_then(|support| support.held.slope).unwrap_or(0.0);
            return if left == node { chord(node, right, behind) - held } else { held - chord(left, node, before) };
        }
        let Some(profile) = &self.profile else { return chord(node, right, behind) - chord(left, node, before) };
        let below = [left, node, right].map(|i| self.supports.at(i).map(|support| support.below));
        if below != [None; 3] && self.drops_off([left, node, right], below, [before, behind]) {
            return chord(node, right, behind) - chord(left, node, before);
        }
        let mut bend = match profile {
            Foundation::Flat { .. } => 0.0,
            profile => profile.bend(place(node), before, behind, [place(left), place(right)]),
        };
        if let Some(shape) = &self.shape {
            bend -= shape.bend(place(node), before, behind, [place(left), place(right)]);
        }
        // Supports are not on the foundation.
        if let Some(below) = below[0] {
            bend -= below / before;
        }
        if let Some(below) = below[2] {
            bend -= below / behind;
        }
        below[1].map_or(bend, |below| bend + (below / before + below / behind))
    }

    /// Whether the ground lies so far below one of three nodes with a support that slopes to its depth there, which the beam does
    /// not feel, would cost more digits than the plain differences of the levels at which the nodes are held.
    fn drops_off(&self, nodes: [usize; 3], below: [Option<f64>; 3], [before, behind]: [f64; 2]) -> bool {
        let [u0, u1, u2] = nodes.map(|i| self.level(i).abs());
        let plain = (u0 + u1) / before + (u1 + u2) / behind;
        let [left, middle, right] = below.map(|below| below.unwrap_or(0.0).abs());
        plain < (left.max(middle) / before).max(right.max(middle) / behind)
    }

    /// Slopes of the gap to the left and to the right of a node, between which a beam may lie that touches there; infinite on the
    /// deeper side of a step, and beyond an end of the beam. Equal but for rounding are equal.
    pub(super) fn slopes_at(&self, node: usize) -> [f64; 2] {
        let x = self.grid.place(node);
        let sides = |profile: &Option<Foundation>| profile.as_ref().map_or([[0.0; 2]; 2], |profile| profile.sides(x));
        let (ground, own) = (sides(&self.profile), sides(&self.shape));
        let gap = |side: usize| ground[side][0] - own[side][0];
        let slope = |side: usize| ground[side][1] - own[side][1];
        let size = [ground, own].as_flattened().iter().fold(0.0, |size: f64, [_, slope]| size.max(slope.abs()));
        let slopes = if slope(1) - slope(0) <= SAME_SLOPE * size {
            [0.5 * (slope(0) + slope(1)); 2]
        } else {
            [slope(0), slope(1)]
        };
        let falls = |side: usize| self.gap(node) < gap(side) - SAME_SLOPE * self.depth_rounding(node);
        [
            if node == 0 || falls(0) { f64::NEG_INFINITY } else { slopes[0] },
            if node == self.intervals || falls(1) { f64::INFINITY } else { slopes[1] },
        ]
    }

    /// The same beam under other loads.
    pub(super) fn under(&self, loads: Vec<f64>) -> Self {
        Self { loads, ..self.clone() }
    }

    /// The same beam above ground that is known at the nodes only.
    pub(super) fn above(&self, depths: Vec<f64>) -> Self {
        Self { depths, profile: None, shape: None, ..self.clone() }
    }

    /// The beam on its supports, with more if they do not hold it, above ground at zero and under other loads: the basic
    /// structure for forces in balance.
    pub(super) fn basic(&self, loads: Vec<f64>) -> Self {
        self.on(self.supports.completed()).above_zero().under(loads)
    }

    /// The same without loads, and with all supports and slopes at zero: what is left is linear in contact forces.
    pub(super) fn bare(&self) -> Self {
        let mut all = self.supports.all().to_vec();
        for support in &mut all {
            support.held.deflection = 0.0;
            support.held.slope = support.held.slope.map(|_| 0.0);
        }
        self.on(Supports::of(all, self.intervals)).above_zero().under(vec![0.0; self.loads.len()])
    }

    fn above_zero(&self) -> Self {
        self.above(vec![0.0; self.nodes().len()])
    }

    /// The same beam on other supports, of which all are among the nodes that are not held now, or are held now.
    fn on(&self, supports: Supports) -> Self {
        let (old, new) = (self.nodes(), supports.nodes());
        let depths = self.depths[new.start - old.start..new.end - old.start].to_vec();
        Self { depths, supports, simple: false, ..self.clone() }
    }

    /// The same beam, held at one node alone at a given slope, where it is held or touches the ground now.
    pub(super) fn turned_about(&self, node: usize, slope: f64) -> Self {
        let below = self.supports.at(node).map_or(0.0, |support| support.below);
        let (at, deflection) = (self.grid.place(node), self.level(node));
        let held = Held { at, deflection, slope: Some(slope), grounded: [false; 2] };
        self.on(Supports::of(vec![NodeSupport { node, held, below }], self.intervals))
    }

    /// The node at the one place about which the beam is free to turn, if the loads are in balance there.
    pub(super) fn pivot(&self, balance: &Balance) -> Option<usize> {
        match balance {
            Balance::Neutral { about, .. } => self.grid.node_at(*about),
            Balance::Held | Balance::Stands(_) => None,
        }
    }

    /// The resultant of the nodal loads: the force, and its moment about the left end, with lengths in intervals.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(super) fn resultant(&self) -> [f64; 2] {
        let force: f64 = self.loads.iter().sum();
        let moment: f64 = self.loads.iter().enumerate().map(|(node, q)| node as f64 * q).sum();
        [force, moment]
    }

    /// The nodes on which the beam would rest besides its supports if it were rigid: none if these hold it, one if it turns about
    /// its support, and otherwise two, the ends of the edge of the convex hull of the ground that lies below the resultant.
    ///
    /// This is step 0° of the paper's algorithm for a beam whose rigid motion is not known: contacts in balance, from where the
    /// descent can start.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(crate) fn resting(&self) -> Vec<usize> {
        let [force, moment] = self.resultant();
        match self.supports.all() {
            [] => {
                let hull = lower_hull(self.nodes().map(|node| (node, self.depths[node])));
                let right = hull.partition_point(|&node| (node as f64) < moment / force).clamp(1, hull.len() - 1);
                hull[right - 1..=right].to_vec()
            }
            [support] if support.held.slope.is_none() => {
                let to_right = force * support.node as f64 <= moment;
                let slope =
                    |node: &usize| (self.level(*node) - support.held.deflection) / node.abs_diff(support.node) as f64;
                let beside =
                    self.nodes().filter(|&node| if to_right { support.node < node } else { node < support.node });
                beside.min_by(|a, b| slope(a).total_cmp(&slope(b))).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    /// Makes contact at these nodes the only one, if the nodes in contact do not hold the beam. The variable of a node in contact is
    /// free if `in_contact`; `node` is that of a variable.
    pub(crate) fn hold(&self, free: &mut FreeSet, in_contact: bool, node: impl Fn(usize) -> usize) {
        let lacking = self.supports.lacking();
        let touches = |&(i, free): &(usize, bool)| free == in_contact && self.supports.at(node(i)).is_none();
        if 0 < lacking && free.iter().enumerate().filter(touches).take(lacking).count() < lacking {
            let resting = self.resting();
            *free = (0..free.dimension()).map(|i| resting.contains(&node(i)) == in_contact).collect();
        }
    }

    /// The deflection of that rigid beam at a node; zero of a beam that its supports hold.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn resting_line(&self) -> impl Fn(usize) -> f64 {
        let mut nodes = self.resting();
        if !nodes.is_empty() {
            nodes.extend(self.supports.all().iter().map(|support| support.node));
        }
        let points: Vec<[f64; 2]> = nodes.into_iter().map(|node| [node as f64, self.level(node)]).collect();
        move |node: usize| match points.as_slice() {
            [[a, from], [b, to], ..] => from + (to - from) * ((node as f64 - a) / (b - a)),
            _ => 0.0,
        }
    }
}

/// The nodes of the lower convex hull of points from left to right: of gaps, where a rigid beam can rest.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn lower_hull(points: impl Iterator<Item = (usize, f64)>) -> Vec<usize> {
    let mut hull: Vec<(usize, f64)> = Vec::new();
    let slope = |a: (usize, f64), b: (usize, f64)| (b.1 - a.1) / (b.0 - a.0) as f64;
    for point in points {
        while let [.., before, last] = hull.as_slice()
            && slope(*last, point) <= slope(*before, *last)
        {
            hull.pop();
        }
        hull.push(point);
    }
    hull.into_iter().map(|(node, _)| node).collect()
}

/// See [`Discrete::sizes`]; of the paper's beam.
fn sizes(scene: &Scene, intervals: usize) -> Result<Sizes, SceneError> {
    let grid = Grid::uniform(scene, intervals)?;
    let (loads, depths) = (grid.nodal_loads(scene.load()), grid.gaps(scene));
    let stiffness = scene.beam().bending_stiffness();
    let free = deflection(&loads[1..intervals], grid.spacing(), stiffness, Discretisation::BeamElements);
    Ok(size(&free, &depths, loads[1..intervals].iter().copied(), stiffness, scene.beam().length()))
}

/// See [`Discrete::sizes`]: from the free deflection, the room below it, and the loads.
fn size(free: &[f64], room: &[f64], loads: impl Iterator<Item = f64>, stiffness: f64, length: f64) -> Sizes {
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
    let mut deflection = largest(&mut free.iter().zip(room).map(|(v, u)| v.abs().min(u.abs())));
    if deflection <= 0.0 {
        deflection = largest(&mut room.iter().map(|u| u.abs()));
    }
    if deflection <= 0.0 {
        deflection = ON_THE_GROUND * largest(&mut free.iter().map(|v| v.abs()));
    }
    if !(0.0 < deflection && deflection < f64::INFINITY) {
        deflection = 1.0;
    }
    let mut force: f64 = loads.map(f64::abs).sum();
    if force <= 0.0 {
        force = 48.0 * stiffness * deflection / (length * length * length);
    }
    Sizes { x: deflection, gradient: force }
}

/// Deflection at the interior nodes under nodal forces.
fn deflection(forces: &[f64], spacing: f64, stiffness: f64, discretisation: Discretisation) -> Vec<f64> {
    statics::deflections(statics::moments(forces, spacing), spacing, stiffness, discretisation)
}
