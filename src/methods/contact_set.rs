//! A beam on a set of contacts, by whichever method: Clapeyron's three-moment equations (1857) of a continuous beam over
//! sinking supports.
//!
//! ```text
//! a M_{i−1} + 2 (a + b) M_i + b M_{i+1} = −(ϑ_right + ϑ_left) − (6 EI/Δ²) bend_i
//! bend_i = (u_{i+1} − u_i)/(b Δ) − (u_i − u_{i−1})/(a Δ)                        the slope of the chord grows by that much
//! ```
//!
//! at contact node `i`, for neighbouring spans of `a` and `b` intervals with the end rotations `ϑ` of a [`Span`]; moments
//! count in `force · Δ`. Finite differences put all curvature at the nodes: a chain of rigid links with springs in its
//! joints (Hencky 1920). Its equations have [`a − 1/a` for `a`, `b − 1/b` for `b` and `1/a + 1/b` more in the middle](links).
//! In dense contact, `a = b = 1`, neighbours drop out, and the difference equation itself is left, `M_i = −(EI/Δ²) bend_i`.
//!
//! Supports are nodes of this list like contacts, at their own levels and with forces of any sign. Two kinds of node have less
//! to ask for. Beyond the *outermost* nodes the beam hangs over: its moment there is known from statics, zero at an end. A
//! *built-in* support stands in the list twice, with a span of no length between: on each of its sides one half of the equation
//! is left, which says that the beam has the given slope there,
//!
//! ```text
//! (b − 1/b) M_{i+1} + (2b + 1/b) M_i = −ϑ_left − (6 EI/Δ²) ((u_{i+1} − u_i)/(b Δ) − φ)        1/b for finite differences only
//! ```
//!
//! so that finite differences have half a cell there. The deflection of an overhang follows from the slope at its node.
//!
//! Contact forces and clearances follow from the moments:
//!
//! ```text
//! p_i = q_i + (M_{i+1} − M_i)/b − (M_i − M_{i−1})/a + what the spans on both sides leave at their ends
//! h = (u − chord) − sag,    −δ²sag_k = (Δ³/EI) c(M)_k   between two contacts                        (Mohr's analogy)
//! c(M)_k = M_k   by finite differences,   (M_{k−1} + 4 M_k + M_{k+1})/6   with beam elements
//! ```
//!
//! Eliminating the moments would give back `A x = b` on the free variables, (33), of each of the three methods. But the
//! condition number of `A` grows like `n⁴`, and this matrix is strictly diagonally dominant: scaled by its diagonal it has
//! a condition number of at most 3, whatever the number of contacts. What it is applied to is the bend of the foundation,
//! which is asked for that bend itself ([`crate::scene::Foundation::bend`]): differences of rounded depths, divided by `Δ³`,
//! would leave nothing of the contact forces on a fine grid. Deflections are summed up from moments and never differenced.

use std::ops::{Range, RangeInclusive};

use super::span::{Span, links};
use super::supports::NodeSupport;
use super::{Discrete, statics};
use crate::qp::{Band, FreeSet, NotPositiveDefinite, Row};
use crate::state::Discretisation;

/// Rounding of a contact force or a clearance, in units in the last place of the numbers that it is a difference of: a
/// profile is evaluated, a chord drawn, sums of loads are taken in blocks.
const UNITS: f64 = 16.0;

/// Negative clearances below this share of their size are looked at twice.
const NEAR_ZERO: f64 = 1e-12;

/// Nodes at which the beam is held, by supports and by the foundation, ascending; those in which it is built in twice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ContactSet {
    nodes: Vec<usize>,
    /// Whether the beam hangs over beyond the first and the last of them. Otherwise it is cut there, and free of moment.
    overhangs: [bool; 2],
}

/// Contact forces and clearances at the nodes of a range, both zero at supports.
pub(crate) struct OnContacts {
    pub(crate) contact_force: Vec<f64>,
    pub(crate) clearance: Vec<f64>,
}

impl ContactSet {
    /// Contact at some nodes, ascending.
    pub(crate) fn at(discrete: &Discrete, contacts: impl Iterator<Item = usize>) -> Self {
        Self::part(discrete, contacts, &(0..=discrete.intervals), [true; 2])
    }

    /// Contact where a variable is free: variables are contact forces of nodes without a support.
    pub(crate) fn where_free(discrete: &Discrete, forces: &FreeSet) -> Self {
        Self::at(discrete, forces.variables().map(|i| discrete.node(i)))
    }

    /// Contact where no variable is free: variables are clearances of nodes without a support.
    pub(crate) fn where_held(discrete: &Discrete, clearances: &FreeSet) -> Self {
        Self::where_free(discrete, &clearances.iter().map(|free| !free).collect())
    }

    /// Contact at nodes of a part of the beam, and the supports there.
    pub(crate) fn part(
        discrete: &Discrete,
        contacts: impl Iterator<Item = usize>,
        part: &RangeInclusive<usize>,
        overhangs: [bool; 2],
    ) -> Self {
        let mut supports = discrete.supports().within(part).iter().peekable();
        let mut nodes = Vec::with_capacity(contacts.size_hint().0 + supports.len() + 1);
        let hold = |nodes: &mut Vec<usize>, support: &NodeSupport| {
            nodes.push(support.node);
            if support.held.slope.is_some() {
                nodes.push(support.node);
            }
        };
        for contact in contacts {
            while let Some(support) = supports.next_if(|support| support.node <= contact) {
                hold(&mut nodes, support);
            }
            if nodes.last() != Some(&contact) {
                nodes.push(contact);
            }
        }
        supports.for_each(|support| hold(&mut nodes, support));
        Self { nodes, overhangs }
    }

    /// Contact forces and clearances at all nodes but supported ends, of the beam that touches here.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if a number is not finite, or if nothing keeps the beam from moving.
    pub(crate) fn solve(
        self,
        discrete: &Discrete,
        discretisation: Discretisation,
    ) -> Result<OnContacts, NotPositiveDefinite> {
        let span = |first: usize, last: usize| Span::under(&discrete.loads[first + 1..last]);
        self.solve_at(discrete, discretisation, span, discrete.nodes())
    }

    /// The same at the nodes of a range, with what is known of the spans between any two nodes.
    pub(crate) fn solve_at(
        self,
        discrete: &Discrete,
        discretisation: Discretisation,
        span: impl Fn(usize, usize) -> Span,
        range: Range<usize>,
    ) -> Result<OnContacts, NotPositiveDefinite> {
        let beam = self.beam(discrete, discretisation, span)?;
        let mut nodal = OnContacts { contact_force: vec![0.0; range.len()], clearance: vec![0.0; range.len()] };
        beam.forces(|node, force| {
            if range.contains(&node) && discrete.supports().at(node).is_none() {
                nodal.contact_force[node - range.start] = force;
            }
        });
        beam.clearances(&range, &mut nodal.clearance);
        Ok(nodal)
    }

    /// The beam that is held at these nodes.
    fn beam<'a>(
        self,
        discrete: &'a Discrete,
        discretisation: Discretisation,
        span: impl Fn(usize, usize) -> Span,
    ) -> Result<Beam<'a, impl Fn(usize, usize) -> Span>, NotPositiveDefinite> {
        let (Some(&first), Some(&last)) = (self.nodes.first(), self.nodes.last().filter(|_| 1 < self.nodes.len()))
        else {
            return Err(NotPositiveDefinite { index: 0, pivot: 0.0 });
        };
        let span = move |first: usize, last: usize| match last - first {
            0 => Span::default(),
            1 => Span::INTERVAL,
            _ => span(first, last),
        };
        let end = discrete.intervals;
        let left = (self.overhangs[0] && 0 < first).then(|| Overhang::of(span(0, first), 0, discrete.loads[0]));
        let right = (self.overhangs[1] && last < end).then(|| Overhang::of(span(last, end), 1, discrete.loads[end]));
        let overhangs = [left, right];
        let outermost = overhangs.map(|overhang| overhang.map_or(0.0, |overhang| overhang.moment));
        let moments = self.moments(discrete, discretisation, &span, outermost)?;
        Ok(Beam { discrete, discretisation, span, nodes: self.nodes, moments, overhangs })
    }

    /// Moments at the nodes; those at the two outermost are given.
    fn moments(
        &self,
        discrete: &Discrete,
        discretisation: Discretisation,
        span: &impl Fn(usize, usize) -> Span,
        outermost: [f64; 2],
    ) -> Result<Vec<f64>, NotPositiveDefinite> {
        let (nodes, end) = (&self.nodes, self.nodes.len() - 1);
        let given = |moment: f64| Row { diagonal: 1.0, above: [0.0], right: moment };
        let mut equations = Band::with_capacity(nodes.len());
        equations.push(given(outermost[0]))?;
        // Report: three-moments
        let unit = 6.0 * discrete.stiffness / (discrete.spacing * discrete.spacing);
        let mut left = span(nodes[0], nodes[1]);
        for i in 1..end {
            let right = span(nodes[i], nodes[i + 1]);
            let (a, b) = (left.steps, right.steps);
            // Zero for a beam, 1/a and 1/b for a chain of links.
            let [at_left, at_right] = [a, b].map(|steps| links(discretisation, steps));
            let bend = discrete.bend(nodes[i - 1], nodes[i], nodes[i + 1]);
            // Beside the outermost nodes one moment is known.
            let from_left = if i == 1 { (a - at_left) * outermost[0] } else { 0.0 };
            let (above, from_right) =
                if i < end - 1 { (b - at_right, 0.0) } else { (0.0, (b - at_right) * outermost[1]) };
            equations.push(Row {
                diagonal: 2.0 * (a + b) + (at_left + at_right),
                above: [above],
                right: -(left.rotations[1] + right.rotations[0]) - unit * bend - (from_left + from_right),
            })?;
            left = right;
        }
        // Report: end
        equations.push(given(outermost[1]))?;
        Ok(equations.solve())
    }
}

/// What an overhang leaves at the node from which it hangs: the sum of its loads, and their moment, negative where they bend it
/// down.
#[derive(Debug, Clone, Copy)]
struct Overhang {
    span: Span,
    force: f64,
    moment: f64,
}

impl Overhang {
    /// From the span between its tip and its node, the side on which the tip is, and the load on the tip.
    fn of(span: Span, side: usize, tip: f64) -> Self {
        let at_tip = span.shares[side] + tip;
        Self { span, force: at_tip + span.shares[1 - side], moment: -at_tip * span.steps }
    }
}

/// A beam on its contacts and supports, with the moments there \[force · Δ\].
struct Beam<'a, S> {
    discrete: &'a Discrete,
    discretisation: Discretisation,
    /// The span between two nodes.
    span: S,
    nodes: Vec<usize>,
    moments: Vec<f64>,
    overhangs: [Option<Overhang>; 2],
}

/// A stretch of the beam between two held nodes, or from one to a tip.
#[derive(Clone, Copy)]
struct Stretch {
    nodes: [usize; 2],
    /// Moments and deflections at its ends.
    moments: [f64; 2],
    levels: [f64; 2],
    /// How far the tip of an overhang turns with its root.
    lever: f64,
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// The force that holds the beam at each of its nodes: the loads that go there, and the jump of the shear force.
    fn forces(&self, mut visit: impl FnMut(usize, f64)) {
        let [before, behind] = self.overhangs.map(|overhang| overhang.map_or(0.0, |overhang| overhang.force));
        let mut left = SpanEnd { share: before, ..SpanEnd::default() };
        for (pair, moments) in self.nodes.windows(2).zip(self.moments.windows(2)) {
            if pair[0] == pair[1] {
                continue;
            }
            let span = (self.span)(pair[0], pair[1]);
            let shear = moments[1] - moments[0];
            let shear = if pair[0] + 1 == pair[1] { shear } else { shear / span.steps };
            let right = SpanEnd { share: span.shares[1], shear, moments: [moments[0], moments[1]], steps: span.steps };
            let load = span.shares[0] + self.discrete.loads[pair[0]];
            visit(pair[0], left.contact_force(&right, load));
            left = right;
        }
        let last = self.nodes[self.nodes.len() - 1];
        visit(last, left.contact_force(&SpanEnd::default(), behind + self.discrete.loads[last]));
    }

    /// The stretch from node `i` of the list to the next one.
    fn stretch(&self, i: usize) -> Stretch {
        let nodes = [self.nodes[i], self.nodes[i + 1]];
        let levels = nodes.map(|node| self.discrete.level(node));
        Stretch { nodes, moments: [self.moments[i], self.moments[i + 1]], levels, lever: 0.0 }
    }

    /// The overhang on one side, if there is one.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn overhang(&self, side: usize) -> Option<Stretch> {
        let Discrete { stiffness, spacing, intervals, .. } = self.discrete;
        let Overhang { span, moment, .. } = self.overhangs[side]?;
        let end = self.nodes.len() - 1;
        let ([here, next], next_moment) = match side {
            0 => ([self.nodes[0], self.nodes[1]], self.moments[1]),
            _ => ([self.nodes[end], self.nodes[end - 1]], self.moments[end - 1]),
        };
        let level = |node: usize| self.discrete.level(node);
        let unit = 6.0 * stiffness / (spacing * spacing);
        let turned = |steps: f64| 2.0 * steps + links(self.discretisation, steps);
        // Slopes count in the direction away from the tip.
        let slope = if here == next {
            let slope = self.discrete.supports().at(here).and_then(|support| support.held.slope).unwrap_or(0.0);
            if side == 0 { slope } else { -slope }
        } else {
            let inner = (self.span)(here.min(next), here.max(next));
            let steps = here.abs_diff(next) as f64;
            let beside = inner.steps - links(self.discretisation, inner.steps);
            (level(next) - level(here)) / (spacing * steps)
                + (turned(inner.steps) * moment + beside * next_moment + inner.rotations[side]) / unit
        };
        let chord = slope + (turned(span.steps) * moment + span.rotations[1 - side]) / unit;
        let drop = chord * spacing * span.steps;
        let [tip, root] = [level(here) - drop, level(here)];
        let (nodes, moments, levels) = match side {
            0 => ([0, here], [0.0, moment], [tip, root]),
            _ => ([here, *intervals], [moment, 0.0], [root, tip]),
        };
        Some(Stretch { nodes, moments, levels, lever: drop.abs() })
    }

    /// Clearances at the nodes of a range that nothing holds; zero where they are negative by less than the rounding of what they
    /// are differences of.
    ///
    /// That is a local measure. Near a support of the beam, over ground that begins at its depth, all numbers are small, and
    /// by the measure of the whole beam the beam could hang free, or pass through the ground, over thousands of nodes.
    fn clearances(&self, range: &Range<usize>, clearance: &mut [f64]) {
        let mut buffer = Vec::new();
        for (i, pair) in self.nodes.windows(2).enumerate() {
            // In dense contact there is nothing between.
            if range.start.max(pair[0] + 1) < range.end.min(pair[1]) {
                self.clearances_in(&self.stretch(i), range, clearance, &mut buffer);
            }
        }
        for (side, tip) in [(0, 0), (1, self.discrete.intervals)] {
            let Some(overhang) = self.overhang(side) else { continue };
            self.clearances_in(&overhang, range, clearance, &mut buffer);
            if range.contains(&tip) {
                let bent = self.bent(&overhang);
                clearance[tip - range.start] = self.open(tip, overhang.levels[side], 0.0, bent);
            }
        }
    }

    /// What the end moments of a stretch bend, `M L²/EI`, and how far an overhang turns with its root.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn bent(&self, stretch: &Stretch) -> f64 {
        let Discrete { spacing, stiffness, .. } = self.discrete;
        let [first, last] = stretch.nodes;
        let steps = (last - first) as f64;
        let unit = spacing * spacing * spacing / stiffness;
        unit * stretch.moments[0].abs().max(stretch.moments[1].abs()) * (steps * steps) + stretch.lever
    }

    /// The clearance of a node that hangs by `sag` below the level of its chord.
    #[inline]
    fn open(&self, node: usize, chord: f64, sag: f64, bent: f64) -> f64 {
        let discrete = self.discrete;
        let open = (discrete.gap(node) - chord) - sag;
        // Hardly any clearance is negative by so little; for those it is worth to know how far they can be trusted.
        let small = NEAR_ZERO * discrete.sizes().x;
        let is_rounding =
            open < 0.0 && -small < open && -open <= UNITS * f64::EPSILON * (discrete.depth_rounding(node) + bent);
        if is_rounding { 0.0 } else { open }
    }

    /// The same strictly between the ends of a stretch.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn clearances_in(&self, stretch: &Stretch, range: &Range<usize>, clearance: &mut [f64], curvature: &mut Vec<f64>) {
        let discrete = self.discrete;
        let &Stretch { nodes: [first, last], moments: ends, levels: [from, to], .. } = stretch;
        let inner = range.start.max(first + 1)..range.end.min(last);
        if inner.is_empty() {
            return;
        }
        let cube = discrete.spacing * discrete.spacing * discrete.spacing;
        let sixth = cube / (6.0 * discrete.stiffness);
        // Moments and sags at the ends of the stretch within the range, which are those of the span as a rule.
        let at = |node: usize| match node {
            _ if node == first => [ends[0], 0.0],
            _ if node == last => [ends[1], 0.0],
            _ => {
                let parts = [first..node, node..last].map(|part| (self.span)(part.start, part.end));
                parts[0].between(parts[1], discrete.loads[node], ends, self.discretisation)
            }
        };
        let [[m0, sag0], [m1, sag1]] = [inner.start - 1, inner.end].map(at);
        curvature.resize(inner.len(), 0.0);
        statics::funicular(&discrete.loads[inner.clone()], [m0, m1], 1.0, curvature);
        // Mohr's analogy, in 6 EI / Δ³.
        statics::curvatures(curvature, [m0, m1], |m| match self.discretisation {
            Discretisation::FiniteDifferences => 6.0 * m[1],
            Discretisation::BeamElements => m[0] + 4.0 * m[1] + m[2],
        });
        let sags = &mut clearance[inner.start - range.start..inner.end - range.start];
        statics::funicular(curvature, [sag0, sag1], sixth, sags);

        let (steps, bent) = ((last - first) as f64, self.bent(stretch));
        // Clearances take the place of the sags.
        for (node, h) in inner.zip(sags) {
            let chord = from + (to - from) * ((node - first) as f64 / steps);
            *h = self.open(node, chord, *h, bent);
        }
    }

    /// The moments beside each support, with its force.
    fn support_forces(&self) -> Vec<HeldNode> {
        let mut held: Vec<HeldNode> = Vec::new();
        self.forces(|node, force| held.push(HeldNode { node, force, moments: [0.0; 2] }));
        let mut i = 0;
        for held in &mut held {
            let left = self.moments[i];
            i += 1;
            let twice = self.nodes.get(i) == Some(&held.node);
            held.moments = [left, if twice { self.moments[i] } else { left }];
            i += usize::from(twice);
        }
        held
    }

    /// Moments at all nodes \[force · Δ\]; beside a built-in support that of the side where it is larger.
    fn nodal_moments(&self) -> Vec<f64> {
        let mut moments = vec![0.0; self.discrete.intervals + 1];
        let stretches = (0..self.nodes.len() - 1).map(|i| self.stretch(i));
        for Stretch { nodes: [first, last], moments: ends, .. } in
            stretches.chain([0, 1].into_iter().filter_map(|side| self.overhang(side)))
        {
            if first < last {
                let (loads, inner) = (&self.discrete.loads[first + 1..last], &mut moments[first + 1..last]);
                statics::funicular(loads, ends, 1.0, inner);
            }
        }
        for (&node, &moment) in self.nodes.iter().zip(&self.moments) {
            moments[node] = larger(moments[node], moment);
        }
        moments
    }
}

/// A node that is held: the force that does it, upwards, and the moments beside it \[force · Δ\].
#[derive(Debug, Clone, Copy)]
pub(super) struct HeldNode {
    pub(super) node: usize,
    pub(super) force: f64,
    pub(super) moments: [f64; 2],
}

/// A beam on its supports alone.
pub(super) struct Carried {
    /// Its supports.
    pub(super) supports: Vec<HeldNode>,
    /// Moments at all nodes \[force · length\].
    pub(super) moments: Vec<f64>,
    /// Deflections at all nodes but supported ends.
    pub(super) deflection: Vec<f64>,
}

impl Carried {
    /// What is known where a number is not finite.
    pub(super) fn unknown(discrete: &Discrete) -> Self {
        let unknown = |n: usize| vec![f64::NAN; n];
        let supports = discrete.supports().all().iter();
        Self {
            supports: supports
                .map(|support| HeldNode { node: support.node, force: f64::NAN, moments: [f64::NAN; 2] })
                .collect(),
            moments: unknown(discrete.intervals + 1),
            deflection: unknown(discrete.nodes().len()),
        }
    }
}

/// The beam on its supports alone, above ground at zero.
pub(super) fn on_supports(discrete: &Discrete, discretisation: Discretisation) -> Result<Carried, NotPositiveDefinite> {
    let span = |first: usize, last: usize| Span::under(&discrete.loads[first + 1..last]);
    let beam = ContactSet::at(discrete, std::iter::empty()).beam(discrete, discretisation, span)?;
    let nodes = discrete.nodes();
    let mut deflection = vec![0.0; nodes.len()];
    beam.clearances(&nodes, &mut deflection);
    deflection.iter_mut().for_each(|value| *value = -*value);
    for support in discrete.supports().inner() {
        deflection[support.node - nodes.start] = support.held.deflection;
    }
    let supports = beam.support_forces();
    let in_units = |moment: f64| moment * discrete.spacing;
    Ok(Carried {
        supports: supports.into_iter().map(|held| HeldNode { moments: held.moments.map(in_units), ..held }).collect(),
        moments: beam.nodal_moments().into_iter().map(in_units).collect(),
        deflection,
    })
}

/// The one that is larger in magnitude.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a.abs() < b.abs() { b } else { a }
}

/// What a span leaves at one of its ends.
#[derive(Default)]
struct SpanEnd {
    /// A share of its loads, and a shear force.
    share: f64,
    shear: f64,
    /// Moments at its two ends, and its length.
    moments: [f64; 2],
    steps: f64,
}

impl SpanEnd {
    /// The contact force between this span and the next one, for the load on the node with the share of the next span; zero
    /// where it is negative by less than the rounding of what it is a difference of.
    ///
    /// The jump of the shear force comes first. In dense contact it is a small difference of numbers with the same exponent,
    /// and exact; a load, or a share of the loads of a span, that is added to a shear force before would be rounded in the same
    /// way at each of a million nodes.
    #[inline]
    fn contact_force(&self, next: &Self, load: f64) -> f64 {
        let carried = self.share + load;
        let force = (next.shear - self.shear) + carried;
        let bent = |span: &Self| (span.moments[0].abs() + span.moments[1].abs()) / span.steps.max(1.0);
        let is_rounding = force < 0.0 && -force <= UNITS * f64::EPSILON * (carried.abs() + bent(self) + bent(next));
        if is_rounding { 0.0 } else { force }
    }
}
