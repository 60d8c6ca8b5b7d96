//! A beam under an axial force `N`, tension positive, on a set of contacts. All nodes are members of a chain of 2 × 2 [blocks].
//!
//! Let `y` be the sag of the beam above the polyline through the nodes that hold it, in units of force as in `springs.rs`. With
//! moments `M` in `force · Δ` and loads at the nodes,
//!
//! ```text
//! δ²y_i − c(M)_i = (EI/Δ²) bend_i
//! δ²M_i − ν δ²y_i + κ y_i = −q_i − N bend_i,                ν = N Δ²/EI
//! c(M)_i = ω M_{i−1} + 2 w M_i + ω M_{i+1}                  w, ω = ½, 0 of finite differences, s₁(ν), s₂(ν) of beam elements
//! ```
//!
//! Under forces at nodes alone such an element is exact ([`crate::scene::axial`]). Without an axial force both equations are the
//! chain of `springs.rs`. A span of many nodes would also be one element, but the effect of its loads depends on their positions in
//! it. So all nodes stay in the chain, and a solve takes time proportional to their number.

use std::f64::consts::PI;

use super::contact_set::ContactSet;
use super::discrete::as_float;
use super::held_beam::{Beam, SpanEnd};
use super::overhang::Overhang;
use super::span::Span;
use super::springs::{Row, held};
use super::statics;
use super::turns::{SOFT, turn};
use super::{Discrete, held_beam};
use crate::qp::NotPositiveDefinite;
use crate::qp::blocks::{self, Block, PENALTY};
use crate::scene::{SceneError, Unstable, axial};
use crate::state::Discretisation;

/// The coefficients of an interval: `w` of each end, `ω`, and `1 − ν ω` without cancellation.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Link {
    pub(crate) near: f64,
    pub(crate) far: f64,
    fall: f64,
}

impl Link {
    /// The link of an interval with the relative softness `e`, for the `ν` of the least bending stiffness.
    pub(crate) fn of(discretisation: Discretisation, nu: f64, e: f64) -> Self {
        match discretisation {
            Discretisation::FiniteDifferences => Self { near: 0.5 * e, far: 0.0, fall: 1.0 },
            Discretisation::BeamElements => {
                let [near, far, fall] = axial::end_rotations_of_any(nu * e);
                Self { near: e * near, far: e * far, fall }
            }
        }
    }
}

/// The solution for a beam under an axial force on a list of nodes.
pub(super) struct Pulled {
    /// Moments at the nodes \[force · Δ\].
    pub(super) moments: Vec<f64>,
    /// Settlement of whatever holds each node; at nodes that nothing holds, the deflection.
    pub(super) sunk: Vec<f64>,
    /// For each node that holds the beam, the force by which the axial force presses it down, along straight lines from one such node
    /// to the next, and the size of the terms of which this force is a difference.
    pub(super) pulled: Vec<[f64; 2]>,
}

impl Discrete {
    /// `ν`.
    pub(super) fn pull(&self) -> f64 {
        self.tension * self.spacing * self.spacing / self.stiffness
    }

    /// How moments at the near and the far end bend an interval, relative to an interval with the least bending stiffness and no
    /// axial force.
    pub(super) fn bent_by(&self, interval: usize) -> [f64; 2] {
        let e = self.divisions().softness(interval);
        if self.tension == 0.0 { [e, 0.0] } else { axial::as_cubic(self.pull() * e).map(|share| e * share) }
    }

    /// The most that any interval bends, in the same measure.
    pub(super) fn bends_at_most(&self) -> f64 {
        if self.tension < 0.0 { axial::as_cubic(self.pull()).iter().sum() } else { 1.0 }
    }

    /// Checks that the discrete beam, with this shape between its nodes, carries its compression on its supports without buckling.
    ///
    /// # Errors
    ///
    /// [`SceneError::Unstable`] if the discrete beam buckles, although the beam of the scene does not.
    pub(crate) fn check_compression(&self, discretisation: Discretisation) -> Result<(), SceneError> {
        let &Self { tension, intervals, .. } = self;
        let is_long = || self.pull() <= -PI * PI && discretisation == Discretisation::BeamElements;
        let bears = || held_beam::on_supports(&self.basic(self.loads.clone()), discretisation).is_ok();
        if 0.0 <= tension || !is_long() && bears() {
            return Ok(());
        }
        Err(Unstable::OnGrid { tension, intervals }.into())
    }
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// The force at each node that holds the beam, from the balance of the stretches between them. A difference of moments next to a
    /// node would have an error proportional to the number of nodes.
    pub(super) fn forces_under_tension(&self, mut visit: impl FnMut(usize, f64)) {
        let (loads, end) = (&self.discrete.loads, self.discrete.intervals);
        let held: Vec<usize> = (0..self.nodes.len()).filter(|i| !self.is_free(self.nodes[*i])).collect();
        let (Some(&first), Some(&last)) = (held.first(), held.last()) else { return };
        let hangs = |side: usize, from: usize, to: usize, tip: usize| match from < to {
            true => Overhang::of(Span::under(&loads[from + 1..to]), side, loads[tip]).force,
            false => 0.0,
        };
        let [before, behind] = [hangs(0, 0, self.nodes[first], 0), hangs(1, self.nodes[last], end, end)];
        let (mut left, mut pulled) = (SpanEnd { share: before, ..SpanEnd::default() }, [0.0; 2]);
        for (k, &i) in held.iter().enumerate() {
            let node = self.nodes[i];
            (0..2).for_each(|part| pulled[part] += self.pulled[i][part]);
            let Some(&j) = held.get(k + 1) else {
                visit(node, left.pulled_force(&SpanEnd::default(), behind + loads[node], pulled));
                return;
            };
            if self.nodes[j] == node {
                continue;
            }
            let span = match self.nodes[j] - node {
                1 => Span::INTERVAL,
                _ => Span::under(&loads[node + 1..self.nodes[j]]),
            };
            let moments = [self.moments[i], self.moments[j]];
            let shear = (moments[1] - moments[0]) / span.steps;
            let right = SpanEnd { share: span.shares[1], shear, moments, steps: span.steps };
            visit(node, left.pulled_force(&right, span.shares[0] + loads[node], pulled));
            (left, pulled) = (right, [0.0; 2]);
        }
    }

    /// Under an axial force, for each node: how far moments bend the span around it, between the nodes that hold the beam, and how
    /// far the span hangs if it ends in a tip. Empty without an axial force.
    pub(super) fn bent_between(&self) -> Vec<f64> {
        let Discrete { spacing, stiffness, .. } = self.discrete;
        let (unit, end) = (spacing * spacing * spacing / stiffness, self.pulled.len());
        let mut all = vec![0.0; end];
        let held = |i: usize| !self.is_free(self.nodes[i]);
        let mut from = 0;
        while from + 1 < end {
            let to = (from + 1..end).find(|i| held(*i)).unwrap_or(end - 1);
            let largest = self.moments[from..=to].iter().fold(0.0, |most: f64, moment| most.max(moment.abs()));
            let steps = as_float(self.nodes[to] - self.nodes[from]);
            let hangs = if held(from) && held(to) { 0.0 } else { (self.level(to) - self.level(from)).abs() };
            let bent = unit * largest * (steps * steps) + hangs;
            all[from..=to].iter_mut().for_each(|all| *all = bent.max(*all));
            from = to;
        }
        all
    }
}

/// The polyline through the nodes that hold a beam, at all nodes of a list: its level and its change of slope. It is horizontal
/// beyond the outermost holding nodes.
struct Polyline {
    levels: Vec<f64>,
    bends: Vec<f64>,
}

impl Polyline {
    fn of(discrete: &Discrete, list: &ContactSet) -> Self {
        let nodes = list.nodes();
        let held: Vec<usize> = (0..nodes.len()).filter(|i| !list.is_free(nodes[*i])).collect();
        let mut line = Self { levels: vec![0.0; nodes.len()], bends: vec![0.0; nodes.len()] };
        let level = |i: usize| list.level(discrete, nodes[i]);
        for (k, &i) in held.iter().enumerate() {
            let [before, next] = [k.checked_sub(1), Some(k + 1)].map(|k| held.get(k?).copied());
            line.bends[i] = match (before, next) {
                (Some(before), Some(next)) => list.bend(discrete, [before, i, next].map(|i| nodes[i])),
                (None, Some(next)) => beside(discrete, list, [i, next]),
                (Some(before), None) => -beside(discrete, list, [i, before]),
                (None, None) => 0.0,
            };
            let (to, end) = (next.unwrap_or(nodes.len() - 1), next.map_or_else(|| level(i), level));
            let rise = |j: usize| as_float(nodes[j] - nodes[i]) / as_float((nodes[to] - nodes[i]).max(1));
            (i..=to).for_each(|j| line.levels[j] = level(i) + (end - level(i)) * rise(j));
        }
        if let Some(&first) = held.first() {
            line.levels[..first].fill(level(first));
        }
        line
    }
}

/// The slope of the polyline from an outermost node to the next one. Between the two sides of one node it is the slope held there.
fn beside(discrete: &Discrete, list: &ContactSet, [i, other]: [usize; 2]) -> f64 {
    let [here, there] = [i, other].map(|i| list.nodes()[i]);
    if here == there {
        return discrete.supports().slope(here).unwrap_or(0.0);
    }
    let rise = list.level(discrete, there) - list.level(discrete, here);
    let slope = rise / (discrete.spacing * as_float(here.abs_diff(there)));
    if here < there { slope } else { -slope }
}

/// The members of a chain, and the link from each to the next.
struct Chain {
    rows: Vec<Row>,
    links: Vec<Link>,
    /// The soft joints, which are not part of the chain, with `1/κ`.
    soft: Vec<(usize, f64)>,
}

/// Moments and deflections of a beam on contacts.
///
/// # Errors
///
/// [`NotPositiveDefinite`] if a number is not finite, if nothing holds the beam, or if it buckles.
pub(super) fn solve(
    discrete: &Discrete,
    discretisation: Discretisation,
    list: &ContactSet,
) -> Result<Pulled, NotPositiveDefinite> {
    let (nodes, nu) = (list.nodes(), discrete.pull());
    let unit = discrete.spacing * discrete.spacing * discrete.spacing / discrete.stiffness;
    let line = Polyline::of(discrete, list);
    // Elimination ends at a node that holds the beam: a tip has no stiffness except from the axial force.
    let held = (0..nodes.len()).rev().find(|i| !list.is_free(nodes[*i]));
    let held = held.ok_or(NotPositiveDefinite { index: 0, pivot: 0.0 })?;
    let Chain { mut rows, links, soft } = chain(discrete, discretisation, list, &line);
    let meeting = if 0.0 < nu { held } else { blocks::best_meeting(&mut rows, |row| row.spring, |row| row.fall) };
    let right: Vec<f64> = rows.iter().map(|row| row.right[1]).collect();
    blocks::factor_under_tension(&mut rows, meeting, |row| row.spring, |row| row.fall);
    blocks::solve_towards(&mut rows, meeting, |row| row.right);
    turn(&mut rows, &soft, meeting)?;
    let negative: usize = rows.iter().map(|row| row.block.negative_pivots()).sum();
    if let Some(index) = rows.iter().position(|row| !row.block.is_finite()).or((negative != rows.len()).then_some(0)) {
        return Err(NotPositiveDefinite { index, pivot: f64::NAN });
    }
    if soft.is_empty() {
        hang(&mut rows, discrete, list, (&links, &right));
    }
    let y: Vec<f64> = rows.iter().map(|row| if row.spring < PENALTY { row.block.step[0] } else { 0.0 }).collect();
    let mut pulled = vec![[0.0; 2]; y.len()];
    let held: Vec<usize> = (0..y.len()).filter(|i| !list.is_free(nodes[*i])).collect();
    for (k, &i) in held.iter().enumerate() {
        let rise =
            |j: usize| if nodes[i] == nodes[j] { 0.0 } else { (y[j] - y[i]) / as_float(nodes[i].abs_diff(nodes[j])) };
        let beside = [k.checked_sub(1), Some(k + 1)].map(|k| held.get(k?)).map(|j| j.map_or(0.0, |j| rise(*j)));
        let along = discrete.tension * line.bends[i];
        pulled[i] =
            [along - nu * (beside[0] + beside[1]), along.abs() + nu.abs() * (beside[0].abs() + beside[1].abs())];
    }
    let sunk = |i: usize| -y[i] * unit + if list.is_free(nodes[i]) { line.levels[i] } else { 0.0 };
    // Adding zero removes the sign of a negative zero.
    let moment = |i: usize| {
        let none = i == 0 || i + 1 == rows.len() || discrete.divisions().is_hinge(nodes[i]);
        if none { 0.0 } else { rows[i].block.step[1] + 0.0 }
    };
    Ok(Pulled { moments: (0..rows.len()).map(moment).collect(), sunk: (0..y.len()).map(sunk).collect(), pulled })
}

fn chain(discrete: &Discrete, discretisation: Discretisation, list: &ContactSet, line: &Polyline) -> Chain {
    let (nodes, nu) = (list.nodes(), discrete.pull());
    let spacing = discrete.spacing;
    let (unit, curved) = (spacing * spacing * spacing / discrete.stiffness, discrete.stiffness / (spacing * spacing));
    let mut known: Option<(f64, Link)> = None;
    let mut link = |i: usize| match nodes.get(i + 1) {
        Some(next) if *next != nodes[i] => {
            let e = discrete.divisions().softness(nodes[i]);
            let same = known.filter(|(soft, _)| soft.total_cmp(&e).is_eq());
            known = same.or_else(|| Some((e, Link::of(discretisation, nu, e))));
            known.map_or(Link::default(), |known| known.1)
        }
        _ => Link::default(),
    };
    let links: Vec<Link> = (0..nodes.len()).map(&mut link).collect();
    let (mut rows, mut soft, end) = (Vec::with_capacity(nodes.len()), Vec::new(), nodes.len() - 1);
    for (i, &node) in nodes.iter().enumerate() {
        // A node with a rotational spring is in the list twice. Its left row belongs to that spring.
        let turning = discrete.supports().turning(node).filter(|_| nodes.get(i + 1) == Some(&node));
        let is_tip = i == 0 || i == end;
        let before = if 0 < i { links[i - 1].near } else { 0.0 };
        // A joint belongs to the left side of its node.
        let is_first = i == 0 || nodes[i - 1] != node;
        let joint = if is_tip || !is_first { 0.0 } else { discrete.divisions().joint(node) };
        if SOFT < joint {
            soft.push((i, 1.0 / joint));
        }
        let w = match is_tip {
            true => PENALTY,
            false => before + links[i].near + if SOFT < joint { 0.0 } else { joint },
        };
        let load = if turning.is_some() { 0.0 } else { discrete.loads[node] } + discrete.tension * line.bends[i];
        let [spring, preload] = if turning.is_some() { [0.0; 2] } else { held(discrete, list, node, unit) };
        let has_link = nodes.get(i + 1).is_some_and(|next| *next != node);
        let [c, sigma] = if has_link { [1.0, -nu] } else { [0.0; 2] };
        let block = Block::new(c, w, links[i].far).on_springs(sigma, 0.0);
        let block = turning.map_or(block, |[k, _]| block.turning(k / curved / spacing));
        let bent = if is_tip { 0.0 } else { curved * line.bends[i] };
        rows.push(Row { block, spring, fall: links[i].fall, right: [preload - load, bent] });
    }
    Chain { rows, links, soft }
}

/// Deflections of overhangs, computed from the root, where the moments are known. In the chain only the axial force determines the
/// position of a tip, and a small axial force would lose its digits.
fn hang(rows: &mut [Row], discrete: &Discrete, list: &ContactSet, (links, right): (&[Link], &[f64])) {
    /// Limit of `N a²/EI` for an overhang of length `a`: at most three of sixteen digits may be lost.
    const SMALL: f64 = 1e-3;
    let (nodes, end) = (list.nodes(), rows.len() - 1);
    let held = |i: &usize| !list.is_free(nodes[*i]);
    let (Some(first), Some(last)) = ((0..=end).find(held), (0..=end).rev().find(held)) else { return };
    // With a single holding node, the axial force or a rotational spring determines the slope there.
    let alone = nodes[first] == nodes[last];
    for (root, tip) in [(first, 0), (last, end)] {
        let steps = as_float(nodes[root].abs_diff(nodes[tip]));
        if first == last || steps == 0.0 || SMALL <= discrete.pull().abs() * steps * steps {
            continue;
        }
        let inwards = |i: usize| if root < tip { i.wrapping_sub(1) } else { i + 1 };
        let at = |k: usize| if root < tip { root + k } else { root - k };
        let moment = |i: usize| rows[i].block.step[1];
        let y = |i: usize| rows[i].block.step[0];
        let bent = |i: usize| {
            let left = if 0 < i { links[i - 1].far * moment(i - 1) } else { 0.0 };
            let behind = if i < end { links[i].far * moment(i + 1) } else { 0.0 };
            rows[i].block.w * moment(i) + left + behind + right[i]
        };
        let other = inwards(root);
        let slope = match discrete.supports().turning(nodes[root]) {
            _ if nodes.get(other) != Some(&nodes[root]) => bent(root) + (y(root) - y(other)),
            Some([k, _]) if alone => {
                bent(root) + (moment(root) - moment(other)) * (discrete.stiffness / discrete.spacing / k)
            }
            Some(_) => bent(root) + bent(other) + (y(root) - y(inwards(other))),
            None => bent(root),
        };
        let count = root.abs_diff(tip);
        let falls: Vec<f64> = (1..count).map(|k| -bent(at(k))).collect();
        let far: f64 = falls.iter().enumerate().map(|(k, fall)| as_float(count - 1 - k) * fall).sum();
        let ends = [y(root), y(root) + as_float(count) * slope - far];
        let mut heights = vec![0.0; falls.len()];
        statics::funicular(&falls, ends, 1.0, &mut heights);
        heights.into_iter().chain([ends[1]]).enumerate().for_each(|(k, y)| rows[at(k + 1)].block.step[0] = y);
    }
}
