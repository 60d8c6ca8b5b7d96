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

use std::ops::Range;

use super::span::{Span, links};
use super::{Discrete, statics};
use crate::qp::{Band, FreeSet, NotPositiveDefinite, Row};
use crate::state::Discretisation;

/// Rounding of a contact force or a clearance, in units in the last place of the numbers that it is a difference of: a
/// profile is evaluated, a chord drawn, sums of loads are taken in blocks.
const UNITS: f64 = 16.0;

/// Negative clearances below this share of their size are looked at twice.
const NEAR_ZERO: f64 = 1e-12;

/// Nodes at which the beam touches the foundation, ascending, with the two ends of the beam.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ContactSet {
    nodes: Vec<usize>,
}

/// Contact forces and clearances at the nodes of a range.
pub(crate) struct OnContacts {
    pub(crate) contact_force: Vec<f64>,
    pub(crate) clearance: Vec<f64>,
}

impl ContactSet {
    /// Contact where a variable is free: variables are contact forces. Variable `i` belongs to node `i + 1`.
    pub(crate) fn where_free(forces: &FreeSet) -> Self {
        let ends = [0, forces.dimension() + 1];
        Self { nodes: std::iter::once(ends[0]).chain(forces.variables().map(|i| i + 1)).chain([ends[1]]).collect() }
    }

    /// Contact where no variable is free: variables are clearances.
    pub(crate) fn where_held(clearances: &FreeSet) -> Self {
        Self::where_free(&clearances.iter().map(|free| !free).collect())
    }

    /// Contact at nodes of a part of the beam, the first and the last of which are the ends of that part.
    pub(crate) fn of_part(nodes: Vec<usize>) -> Self {
        Self { nodes }
    }

    /// Contact forces and clearances at all interior nodes of the beam that touches here.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if a number is not finite.
    pub(crate) fn solve(
        self,
        discrete: &Discrete,
        discretisation: Discretisation,
    ) -> Result<OnContacts, NotPositiveDefinite> {
        let span = |first: usize, last: usize| Span::under(&discrete.loads[first + 1..last]);
        self.solve_at(discrete, discretisation, span, 1..discrete.intervals)
    }

    /// The same at the interior nodes of a range, with what is known of the spans between any two nodes.
    pub(crate) fn solve_at(
        self,
        discrete: &Discrete,
        discretisation: Discretisation,
        span: impl Fn(usize, usize) -> Span,
        range: Range<usize>,
    ) -> Result<OnContacts, NotPositiveDefinite> {
        let span = |first, last| if first + 1 == last { Span::INTERVAL } else { span(first, last) };
        let moments = self.moments(discrete, discretisation, &span)?;
        let beam = Beam { discrete, discretisation, span, nodes: self.nodes, moments };
        let mut nodal = OnContacts { contact_force: vec![0.0; range.len()], clearance: vec![0.0; range.len()] };
        beam.contact_forces(&range, &mut nodal.contact_force);
        beam.clearances(&range, &mut nodal.clearance);
        Ok(nodal)
    }

    /// Moments at the contacts, zero at the two ends.
    fn moments(
        &self,
        discrete: &Discrete,
        discretisation: Discretisation,
        span: &impl Fn(usize, usize) -> Span,
    ) -> Result<Vec<f64>, NotPositiveDefinite> {
        let (nodes, end) = (&self.nodes, self.nodes.len() - 1);
        let free = Row { diagonal: 1.0, above: [0.0], right: 0.0 };
        let mut equations = Band::with_capacity(nodes.len());
        equations.push(free)?;
        // Report: three-moments
        let unit = 6.0 * discrete.stiffness / (discrete.spacing * discrete.spacing);
        let mut left = span(nodes[0], nodes[1]);
        for i in 1..end {
            let right = span(nodes[i], nodes[i + 1]);
            let (a, b) = (left.steps, right.steps);
            // Zero for a beam, 1/a and 1/b for a chain of links.
            let [at_left, at_right] = [a, b].map(|steps| links(discretisation, steps));
            let bend = discrete.bend(nodes[i - 1], nodes[i], nodes[i + 1]);
            equations.push(Row {
                diagonal: 2.0 * (a + b) + (at_left + at_right),
                // The ends of the beam are free of moment.
                above: [if i + 1 == end { 0.0 } else { b - at_right }],
                right: -(left.rotations[1] + right.rotations[0]) - unit * bend,
            })?;
            left = right;
        }
        // Report: end
        equations.push(free)?;
        Ok(equations.solve())
    }
}

/// A beam on its contacts, with the moments there \[force · Δ\].
struct Beam<'a, S> {
    discrete: &'a Discrete,
    discretisation: Discretisation,
    /// The span between two nodes.
    span: S,
    nodes: Vec<usize>,
    moments: Vec<f64>,
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// Contact forces at the contacts of a range: the loads that go there, and the jump of the shear force.
    fn contact_forces(&self, range: &Range<usize>, forces: &mut [f64]) {
        let mut left = SpanEnd::default();
        for (pair, moments) in self.nodes.windows(2).zip(self.moments.windows(2)) {
            let span = (self.span)(pair[0], pair[1]);
            let shear = moments[1] - moments[0];
            let shear = if pair[0] + 1 == pair[1] { shear } else { shear / span.steps };
            let right = SpanEnd { share: span.shares[1], shear, moments: [moments[0], moments[1]], steps: span.steps };
            if range.contains(&pair[0]) {
                let load = span.shares[0] + self.discrete.loads[pair[0]];
                forces[pair[0] - range.start] = left.contact_force(&right, load);
            }
            left = right;
        }
    }

    /// Clearances between the contacts of a range; zero where they are negative by less than the rounding of what they are
    /// differences of.
    ///
    /// That is a local measure. Near a support of the beam, over ground that begins at its depth, all numbers are small, and
    /// by the measure of the whole beam the beam could hang free, or pass through the ground, over thousands of nodes.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn clearances(&self, range: &Range<usize>, clearance: &mut [f64]) {
        let discrete = self.discrete;
        let cube = discrete.spacing * discrete.spacing * discrete.spacing;
        let (unit, sixth) = (cube / discrete.stiffness, cube / (6.0 * discrete.stiffness));
        // Hardly any clearance is negative by so little; for those it is worth to know how far they can be trusted.
        let small = NEAR_ZERO * discrete.sizes().x;
        let mut curvature = Vec::new();
        for (pair, ends) in self.nodes.windows(2).zip(self.moments.windows(2)) {
            let (first, last, ends) = (pair[0], pair[1], [ends[0], ends[1]]);
            let inner = range.start.max(first + 1)..range.end.min(last);
            if inner.is_empty() {
                continue;
            }
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
            statics::funicular(&discrete.loads[inner.clone()], [m0, m1], 1.0, &mut curvature);
            // Mohr's analogy, in 6 EI / Δ³.
            statics::curvatures(&mut curvature, [m0, m1], |m| match self.discretisation {
                Discretisation::FiniteDifferences => 6.0 * m[1],
                Discretisation::BeamElements => m[0] + 4.0 * m[1] + m[2],
            });
            let sags = &mut clearance[inner.start - range.start..inner.end - range.start];
            statics::funicular(&curvature, [sag0, sag1], sixth, sags);

            let [from, to] = [first, last].map(|node| discrete.support_depth(node));
            let steps = (last - first) as f64;
            // What the end moments bend: `M L²/EI`.
            let bent = unit * ends[0].abs().max(ends[1].abs()) * (steps * steps);
            // Clearances take the place of the sags.
            let depths = &discrete.depths[inner.start - 1..];
            for ((node, h), depth) in inner.zip(sags).zip(depths) {
                let chord = from + (to - from) * ((node - first) as f64 / steps);
                let open = (depth - chord) - *h;
                let is_rounding = open < 0.0
                    && -small < open
                    && -open <= UNITS * f64::EPSILON * (discrete.depth_rounding(node) + bent);
                *h = if is_rounding { 0.0 } else { open };
            }
        }
    }
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
