//! A beam in balance on a single place: forces are certain, and its position is one of an interval.
//!
//! ```text
//! v(x) = v₀(x) + θ (x − a)         v₀: in balance at a, with slope 0 there
//! h = g − v ≥ 0 at all nodes       an interval of slopes, which may be without end on a side
//! ```

use super::Discrete;
use super::answer::Nodal;
use super::contact_set;
use crate::state::{Discretisation, Motion};

/// Rounding of a clearance, in units in the last place of the numbers that it is a difference of.
const UNITS: f64 = 16.0;

/// Forces below this share of all others are rounding: what balances does not turn.
const IN_BALANCE: f64 = 1e-12;

/// The beam that is carried by one node alone, with the slope nearest to zero, and the slopes that it may have. [`None`] if the
/// ground beside holds it, or does not let it be.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub fn balanced(discrete: &Discrete, discretisation: Discretisation, node: usize) -> Option<(Nodal, Motion)> {
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
    let mut slope = [None::<f64>; 2];
    for (i, h) in nodes.clone().zip(clearances(&deflections(0.0)?)).filter(|(i, h)| *i != node && h.is_finite()) {
        let limit = h / (discrete.spacing * i.abs_diff(node) as f64);
        if node < i {
            slope[1] = Some(slope[1].map_or(limit, |most| most.min(limit)));
        } else {
            slope[0] = Some(slope[0].map_or(-limit, |least| least.max(-limit)));
        }
    }
    let [least, most] = [slope[0].unwrap_or(f64::NEG_INFINITY), slope[1].unwrap_or(f64::INFINITY)];
    if most < least || least.is_nan() || most.is_nan() {
        return None;
    }
    let deflection = deflections(0.0_f64.max(least).min(most))?;
    // Where the slope is the limit, rounding may be left of the clearance.
    let clearance = clearances(&deflection).into_iter().map(|h| h.max(0.0)).collect();
    let mut contact_force = vec![0.0; nodes.len()];
    if discrete.supports().at(node).is_none() {
        contact_force[node - nodes.start] = discrete.resultant()[0];
    }
    let about = discrete.grid.place(node);
    Some((Nodal { discretisation, deflection, clearance, contact_force }, Motion { about, slope }))
}

/// The only node that carries a beam which its supports do not hold, if there is one and the loads are in balance on it.
#[must_use]
pub fn single_contact(discrete: &Discrete, nodal: &Nodal) -> Option<usize> {
    if discrete.supports().lacking() == 0 {
        return None;
    }
    let [force, moment] = discrete.resultant();
    let size: f64 = discrete.loads.iter().map(|q| q.abs()).sum();
    let carries = |p: &f64| IN_BALANCE * size < *p;
    let mut touching = discrete.nodes().zip(&nodal.contact_force).filter(|(_, p)| carries(p)).map(|(node, _)| node);
    let node = match (discrete.supports().all().first(), touching.next()) {
        (Some(support), None) => support.node,
        (None, Some(node)) => node,
        _ => return None,
    };
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    let (place, intervals) = (node as f64, discrete.intervals as f64);
    (touching.next().is_none() && (moment - force * place).abs() <= IN_BALANCE * size * intervals).then_some(node)
}
