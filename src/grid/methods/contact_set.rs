//! A beam on a set of contacts, for every method: Clapeyron's three-moment equations (1857) of a continuous beam whose supports settle.
//!
//! ```text
//! a M_{i−1} + 2 (a + b) M_i + b M_{i+1} = −(ϑ_right + ϑ_left) − (6 EI/Δ²) bend_i
//! bend_i = (d_{i+1} − d_i)/(b Δ) − (d_i − d_{i−1})/(a Δ)                        the change of slope from chord to chord
//! ```
//!
//! Here `i` is a contact node at the level `d_i`, which is its gap or the level of its support. The neighbouring spans have `a` and
//! `b` intervals and the end rotations `ϑ` of a [`Span`]. Moments have the unit `force · Δ`. Finite differences concentrate all
//! curvature at the nodes, which makes the beam a chain of rigid links with springs in its joints (Hencky 1920). Its equations have
//! [`a − 1/a` for `a`, `b − 1/b` for `b` and `1/a + 1/b` more in the middle](links). In dense contact, `a = b = 1`, the neighbours
//! drop out and the difference equation itself remains, `M_i = −(EI/Δ²) bend_i`.
//!
//! If the stiffness changes between contacts, or the beam has joints there, `springs.rs` solves it with these places as additional
//! nodes of free deflection. Under an axial force `axial.rs` solves it with all nodes.
//!
//! Supports are nodes of this list like contacts, at their own levels and with forces of any sign. Two kinds of node have another
//! equation. Beyond the *outermost* nodes the beam is an overhang: its moment there is known from statics, and is zero at an end. A
//! *built-in* support is in the list twice, with a span of length zero between. On each of its sides half of the equation remains,
//! which gives the beam the slope `φ` there,
//!
//! ```text
//! (b − 1/b) M_{i+1} + (2b + 1/b) M_i = −ϑ_left − (6 EI/Δ²) ((d_{i+1} − d_i)/(b Δ) − φ)        1/b for finite differences only
//! ```
//!
//! so that finite differences have half a cell there. The deflection of an overhang follows from the slope at its root.
//!
//! `held_beam.rs` derives everything else from the moments. Eliminating the moments would lead back to `A x = b` on the free
//! variables, (33), of each of the three methods. The condition number of `A` grows like `n⁴`. The matrix here is strictly diagonally
//! dominant instead: scaled by its diagonal it has a condition number of at most 3, whatever the number of contacts. A formula
//! without cancellation gives the bend on the right-hand side ([`crate::scene::Foundation::bend`]). Differences of rounded depths,
//! divided by `Δ³`, would destroy the contact forces on a fine grid. Deflections are sums of moments, and are never differenced.

use std::ops::{Range, RangeInclusive};

use super::discrete::as_float;
use super::held_beam::Beam;
use super::overhang::Overhang;
use super::span::{Span, links};
use super::springs;
use super::supports::{NodeSpring, NodeSupport};
use super::{Discrete, axial};
use crate::memory::zeros;
use crate::qp::{Band, NotPositiveDefinite, Row};
use crate::state::Discretisation;

/// The nodes at which supports and foundation hold the beam, ascending, and the nodes at which the beam changes. A built-in node is
/// in the list twice.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactSet {
    nodes: Vec<usize>,
    /// The nodes among them that nothing holds, where the beam changes.
    free: Vec<usize>,
    /// Elastic supports that act on the beam: those that hold it both ways, and compression-only ones that are pressed.
    springs: Vec<NodeSpring>,
    /// The nodes that only an elastic support holds.
    sprung: Vec<usize>,
    /// Whether the beam continues as an overhang beyond the first and the last node. Otherwise it is cut there, with zero moment.
    overhangs: [bool; 2],
}

/// Contact forces and clearances at the nodes of a range, both zero at supports, followed by the values of all stops (elastic
/// compression-only supports). A pressed stop has clearance zero, any other has force zero.
pub(crate) struct OnContacts {
    pub(crate) contact_force: Vec<f64>,
    pub(crate) clearance: Vec<f64>,
}

impl ContactSet {
    /// Contact at the given [places](Discrete::place), ascending.
    pub(crate) fn at(discrete: &Discrete, contacts: impl Iterator<Item = usize>) -> Self {
        let count = contacts.size_hint().0;
        Self::part(discrete, contacts, count, &(0..=discrete.intervals), [true; 2])
    }

    /// Contact at places in a part of the beam, about `count` of them, together with the supports there.
    pub(crate) fn part(
        discrete: &Discrete,
        contacts: impl Iterator<Item = usize>,
        count: usize,
        part: &RangeInclusive<usize>,
        overhangs: [bool; 2],
    ) -> Self {
        let mut supports = discrete.supports().within(part);
        let mut nodes = Vec::with_capacity(count + 2 * supports.len());
        let hold = |nodes: &mut Vec<usize>, support: &NodeSupport| {
            nodes.push(support.node);
            if support.held.slope.is_some() || support.held.turning.is_some() {
                nodes.push(support.node);
            }
        };
        let mut springs = discrete.supports().springs().to_vec();
        // Most contacts lie before the next support, and at no node that is already held.
        let next = |supports: &[NodeSupport]| supports.first().map_or(usize::MAX, |support| support.node);
        let (mut support, mut held) = (next(supports), usize::MAX);
        contacts.for_each(|contact| {
            if let Some(stop) = discrete.stop(contact) {
                springs.push(discrete.supports().stops()[stop]);
                return;
            }
            while support <= contact {
                hold(&mut nodes, &supports[0]);
                held = support;
                supports = &supports[1..];
                support = next(supports);
            }
            if contact != held {
                nodes.push(contact);
            }
        });
        supports.iter().for_each(|support| hold(&mut nodes, support));
        springs.retain(|spring| part.contains(&spring.node));
        springs.sort_by_key(|spring| spring.node);
        let alone = springs.iter().filter(|spring| nodes.binary_search(&spring.node).is_err());
        let sprung: Vec<usize> = alone.map(|spring| spring.node).collect();
        let twice = springs.iter().filter(|spring| spring.turning.is_some()).map(|spring| spring.node);
        let nodes = merged(merged(nodes, &sprung), &twice.collect::<Vec<_>>());
        // Under an axial force a span is not a simple beam, so all nodes are in the list.
        let all = if discrete.tension == 0.0 { 0..0 } else { *part.start()..*part.end() + 1 };
        let changes = discrete.divisions().nodes().iter().copied().filter(|node| all.is_empty() && part.contains(node));
        let free: Vec<usize> = changes.chain(all.clone()).filter(|node| nodes.binary_search(node).is_err()).collect();
        Self { nodes: merged(nodes, &free), free, springs, sprung, overhangs }
    }

    /// Contact forces and clearances at all nodes except supported ends, for the beam in contact at this set.
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

    /// The same at the nodes of a range, with a function that gives the span between two nodes.
    pub(crate) fn solve_at(
        self,
        discrete: &Discrete,
        discretisation: Discretisation,
        span: impl Fn(usize, usize) -> Span,
        range: Range<usize>,
    ) -> Result<OnContacts, NotPositiveDefinite> {
        let beam = self.beam(discrete, discretisation, span)?;
        let mut nodal = OnContacts { contact_force: zeros(range.len()), clearance: zeros(range.len()) };
        let at = |node: usize| node.wrapping_sub(range.start);
        let set = |node: usize, force: f64, all: &mut [f64]| {
            if let Some(contact_force) = all.get_mut(at(node)) {
                *contact_force = force;
            }
        };
        let OnContacts { contact_force: all, .. } = &mut nodal;
        beam.forces(|node, force| set(node, force, all));
        for spring in &beam.springs {
            let whole = all.get(at(spring.node)).copied().unwrap_or(0.0);
            set(spring.node, beam.beside_spring(spring, whole), all);
        }
        beam.pressed(|node, force| set(node, force, all));
        discrete.supports().all().iter().for_each(|support| set(support.node, 0.0, all));
        beam.clearances(&range, &mut nodal.clearance);
        let [forces, feet] = beam.stops(&range, &nodal.clearance);
        nodal.contact_force.extend(forces);
        nodal.clearance.extend(feet);
        Ok(nodal)
    }

    /// The beam held at these nodes.
    pub(super) fn beam<'a>(
        mut self,
        discrete: &'a Discrete,
        discretisation: Discretisation,
        span: impl Fn(usize, usize) -> Span,
    ) -> Result<Beam<'a, impl Fn(usize, usize) -> Span>, NotPositiveDefinite> {
        let is_pulled = discrete.tension != 0.0;
        let beyond = if is_pulled { Default::default() } else { self.take_beyond() };
        let (Some(&first), Some(&last)) = (self.nodes.first(), self.nodes.last().filter(|_| 1 < self.nodes.len()))
        else {
            return Err(NotPositiveDefinite { index: 0, pivot: 0.0 });
        };
        let span = move |first: usize, last: usize| {
            let span = match last - first {
                0 => return Span::default(),
                1 => Span::INTERVAL,
                _ => span(first, last),
            };
            span.softened(discrete.divisions().softness(first))
        };
        let end = discrete.intervals;
        let hangs = self.overhangs.map(|hangs| hangs && !is_pulled);
        let left = (hangs[0] && 0 < first).then(|| Overhang::of(span(0, first), 0, discrete.loads[0]));
        let right = (hangs[1] && last < end).then(|| Overhang::of(span(last, end), 1, discrete.loads[end]));
        let overhangs = [left, right];
        let outermost = overhangs.map(|overhang| overhang.map_or(0.0, |overhang| overhang.moment));
        let changes = !discrete.divisions().nodes().is_empty() || discrete.supports().give();
        let mut pulled = Vec::new();
        let [moments, sunk] = if is_pulled {
            let found = axial::solve(discrete, discretisation, &self)?;
            pulled = found.pulled;
            [found.moments, found.sunk]
        } else if discrete.gives() || changes {
            let forces = overhangs.map(|overhang| overhang.map_or(0.0, |overhang| overhang.force));
            let left = [0, 1].map(|side| [outermost[side], forces[side]]);
            springs::solve(discrete, discretisation, &self, &span, left)?
        } else {
            [self.moments(discrete, discretisation, &span, outermost)?, Vec::new()]
        };
        Ok(Beam {
            discrete,
            discretisation,
            span,
            nodes: self.nodes,
            free: self.free,
            springs: self.springs,
            sprung: self.sprung,
            moments,
            sunk,
            pulled,
            overhangs,
            beyond,
        })
    }

    /// Removes the free nodes beyond the outermost nodes that hold the beam. Returns those of both sides, ordered outwards.
    fn take_beyond(&mut self) -> [Vec<usize>; 2] {
        let is_free = |node: &&usize| self.free.binary_search(node).is_ok();
        let right = self.nodes.iter().rev().take_while(is_free).count();
        let left = self.nodes.iter().take_while(is_free).count();
        let right = self.nodes.split_off(self.nodes.len() - right);
        let mut left: Vec<usize> = self.nodes.drain(..left.min(self.nodes.len())).collect();
        left.reverse();
        [left, right]
    }

    /// The elastic support that acts on the beam at a node.
    pub(super) fn spring(&self, node: usize) -> Option<&NodeSpring> {
        self.springs.binary_search_by_key(&node, |spring| spring.node).ok().map(|i| &self.springs[i])
    }

    /// The level from which the deflection of a held node counts.
    pub(super) fn level(&self, discrete: &Discrete, node: usize) -> f64 {
        let spring = self.spring(node).filter(|_| self.is_sprung(node));
        spring.map_or_else(|| discrete.level(node), |spring| spring.deflection)
    }

    /// Whether only an elastic support holds a node.
    #[inline]
    pub(super) fn is_sprung(&self, node: usize) -> bool {
        !self.sprung.is_empty() && self.sprung.binary_search(&node).is_ok()
    }

    /// The change of slope, at the middle one of three held nodes, of the polyline through them.
    pub(super) fn bend(&self, discrete: &Discrete, [left, node, right]: [usize; 3]) -> f64 {
        if [left, node, right].iter().all(|node| !self.is_sprung(*node)) {
            return discrete.bend(left, node, right);
        }
        let levels = [left, node, right].map(|node| self.level(discrete, node));
        let chord = |from: f64, to: f64, steps: usize| (to - from) / (discrete.spacing * as_float(steps));
        let held = || discrete.supports().slope(node).unwrap_or(0.0);
        let before = if left == node { held() } else { chord(levels[0], levels[1], node - left) };
        let behind = if right == node { held() } else { chord(levels[1], levels[2], right - node) };
        behind - before
    }

    /// The nodes.
    pub(super) fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Whether nothing holds a node.
    #[inline]
    pub(super) fn is_free(&self, node: usize) -> bool {
        !self.free.is_empty() && self.free.binary_search(&node).is_ok()
    }

    /// Moments at the nodes. The moments at the two outermost nodes are given.
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
        // What the right end of a span needs: its length, 0 of a beam or 1/a of a chain of links, its rotation. Two nodes need no span.
        let at_end = |span: Span| (span.steps, links(discretisation, span.steps), span.rotations[1]);
        let mut left = at_end(if 1 < end { span(nodes[0], nodes[1]) } else { Span::INTERVAL });
        for i in 1..end {
            let right = span(nodes[i], nodes[i + 1]);
            let (a, at_left, rotation) = left;
            left = at_end(right);
            let (b, at_right, _) = left;
            let bend = discrete.bend(nodes[i - 1], nodes[i], nodes[i + 1]);
            // Beside the outermost nodes one moment is known.
            let from_left = if i == 1 { (a - at_left) * outermost[0] } else { 0.0 };
            let (above, from_right) =
                if i < end - 1 { (b - at_right, 0.0) } else { (0.0, (b - at_right) * outermost[1]) };
            equations.push(Row {
                diagonal: 2.0 * (a + b) + (at_left + at_right),
                above: [above],
                right: -(rotation + right.rotations[0]) - unit * bend - (from_left + from_right),
            })?;
        }
        // Report: end
        equations.push(given(outermost[1]))?;
        Ok(equations.solve())
    }
}

/// Merges two ascending lists.
fn merged(nodes: Vec<usize>, more: &[usize]) -> Vec<usize> {
    if more.is_empty() {
        return nodes;
    }
    let mut all = Vec::with_capacity(nodes.len() + more.len());
    let mut more = more.iter().copied().peekable();
    for node in nodes {
        while let Some(before) = more.next_if(|before| *before < node) {
            all.push(before);
        }
        all.push(node);
    }
    all.extend(more);
    all
}
