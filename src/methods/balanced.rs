//! A beam in balance on a single place: forces are certain, and its position is one of an interval.
//!
//! ```text
//! v(x) = v₀(x) + θ (x − a)         v₀: in balance at a, with slope 0 there
//! h = g − v ≥ 0 at all nodes       an interval of slopes, which may be without end on a side
//! ```
//!
//! Where a smooth place of the ground carries it, the beam has the slope of the ground there: that it could turn by a part of an
//! interval is a matter of the grid. At a corner the slopes of its two sides are limits as well.

use super::Discrete;
use super::answer::Nodal;
use super::contact_set;
use crate::scene::Balance;
use crate::state::{Discretisation, Motion};

/// Rounding of a clearance, in units in the last place of the numbers that it is a difference of.
const UNITS: f64 = 16.0;

/// Forces below this share of all others are rounding: what balances does not turn.
const IN_BALANCE: f64 = 1e-12;

/// The beam that is carried by one node alone, with the slope nearest to zero of those that it may have, and these if there is more
/// than one. [`None`] if the ground beside holds it.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub fn balanced(discrete: &Discrete, discretisation: Discretisation, node: usize) -> Option<(Nodal, Option<Motion>)> {
    let nodes = discrete.nodes();
    let deflections = |slope: f64| {
        let turned = discrete.turned_about(node, slope);
        let mut deflection =
            contact_set::on_supports(&turned.basic(turned.loads.clone()), discretisation).ok()?.deflection;
        // An end of the beam that is held is none of its nodes.
        if deflection.len() < nodes.len() {
            deflection.insert(node - nodes.start, discrete.level(node));
        }
        Some(deflection)
    };
    let clearances = |deflection: &[f64]| -> Vec<f64> {
        let open = |((i, g), v): ((usize, &f64), &f64)| {
            let rounding = UNITS * f64::EPSILON * (discrete.depth_rounding(i) + v.abs());
            if (g - v).abs() <= rounding { 0.0 } else { g - v }
        };
        nodes.clone().zip(&discrete.depths).zip(deflection).map(open).collect()
    };
    let mut least = f64::NEG_INFINITY;
    let mut most = f64::INFINITY;
    for (i, h) in nodes.clone().zip(clearances(&deflections(0.0)?)).filter(|(i, _)| *i != node) {
        let limit = h / (discrete.spacing * i.abs_diff(node) as f64);
        if node < i {
            most = most.min(limit);
        } else {
            least = least.max(-limit);
        }
    }
    if most < least || least.is_nan() || most.is_nan() {
        return None;
    }
    if discrete.supports().at(node).is_none() {
        let [left, right] = discrete.slopes_at(node);
        // A smooth place may lie between nodes: of the slopes that the grid leaves, the nearest one.
        [least, most] = [left.clamp(least, most), right.clamp(least, most)];
    }
    let end = |slope: f64| slope.is_finite().then_some(slope);
    let motion = (least < most).then(|| Motion { about: discrete.grid.place(node), slope: [end(least), end(most)] });
    let deflection = deflections(0.0_f64.max(least).min(most))?;
    // Where the slope is the limit, rounding may be left of the clearance.
    let clearance = clearances(&deflection).into_iter().map(|h| h.max(0.0)).collect();
    let mut contact_force = vec![0.0; nodes.len()];
    if discrete.supports().at(node).is_none() {
        contact_force[node - nodes.start] = discrete.resultant()[0];
    }
    Some((Nodal { discretisation, deflection, clearance, contact_force }, motion))
}

/// The node that carries a beam alone which its supports do not hold, if there is one and the loads are in balance on it: the place
/// above which their resultant is, or the only contact that was found.
#[must_use]
pub fn single_contact(discrete: &Discrete, balance: &Balance, nodal: &Nodal) -> Option<usize> {
    if *balance == Balance::Held || nodal.contact_force.iter().any(|p| p.is_nan()) {
        return None;
    }
    let [force, moment] = discrete.resultant();
    let size: f64 = discrete.loads.iter().map(|q| q.abs()).sum();
    let carries = |p: &f64| IN_BALANCE * size < *p;
    let mut touching = discrete.nodes().zip(&nodal.contact_force).filter(|(_, p)| carries(p)).map(|(node, _)| node);
    let only = match (discrete.supports().all().first(), touching.next(), touching.next()) {
        (Some(support), None, _) => Some(support.node),
        (None, Some(node), None) => Some(node),
        _ => None,
    };
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    let in_balance =
        |node: &usize| (moment - force * *node as f64).abs() <= IN_BALANCE * size * discrete.intervals as f64;
    discrete.pivot(balance).or(only.filter(in_balance))
}
