//! Rigid motions of a beam that its supports do not hold. This covers the rest position of a rigid beam, and a beam in balance on a
//! single contact. In the latter case the forces are unique, and the slope is any of an interval.
//!
//! ```text
//! v(x) = v₀(x) + θ (x − a)         v₀: in balance at a, with slope 0 there
//! h = g − v ≥ 0 at all nodes       an interval of slopes, which may be without end on a side
//! ```
//!
//! On a smooth foundation the beam has the slope of the foundation at its contact. The grid would let it rotate until a neighbouring
//! node touches, which is an effect of the grid. At a corner the slopes of its two sides are limits as well.

use std::sync::Arc;

use super::answer::Nodal;
use super::supports::NodeSupport;
use super::{Discrete, held_beam};
use crate::qp::FreeSet;
use crate::scene::{Balance, Foundation, Held};
use crate::state::{Discretisation, Motion};

/// Slopes, or depths, that differ by less than this fraction of their size are equal.
const SAME_SLOPE: f64 = 64.0 * f64::EPSILON;

impl Discrete {
    /// The slopes of the gap to the left and to the right of a node, which limit the slope of a beam in contact there. Infinite on
    /// the deeper side of a step and beyond an end of the beam. Slopes that differ by rounding only are made equal.
    fn slopes_at(&self, node: usize) -> [f64; 2] {
        // The foundation is lower on both sides.
        if self.supports().below(node).is_some() {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        let x = self.grid.place(node);
        let sides =
            |profile: &Option<Arc<Foundation>>| profile.as_ref().map_or([[0.0; 2]; 2], |profile| profile.sides(x));
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

    /// The same beam held at one node alone, at its support or contact level and at a given slope, above a foundation at level zero.
    fn turned_about(&self, node: usize, slope: f64) -> Self {
        let below = self.supports().at(node).map_or(0.0, |support| support.below);
        let (at, deflection) = (self.grid.place(node), self.level(node));
        let held =
            Held { at, deflection, slope: Some(slope), turning: None, at_level: [false; 2], tangent: [false; 2] };
        self.on(self.supports().holding(vec![NodeSupport { node, held, below }]), self.loads.clone())
    }

    /// The node of the single position about which the beam can rotate freely, if the loads are in balance there.
    fn pivot(&self, balance: &Balance) -> Option<usize> {
        match balance {
            Balance::Neutral { about, .. } => self.grid.node_at(*about),
            Balance::Held | Balance::Stands(_) => None,
        }
    }

    /// The resultant of the nodal loads: the force, and its moment about the left end, with lengths in intervals.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn resultant(&self) -> [f64; 2] {
        let force: f64 = self.loads.iter().sum();
        let moment: f64 = self.loads.iter().enumerate().map(|(node, q)| node as f64 * q).sum();
        [force, moment]
    }

    /// The places on which the beam would rest in addition to its supports if it were rigid. None if the supports hold it, and one if
    /// it rotates about its support. Otherwise two: the ends of that edge of the convex hull of the foundation that lies below the
    /// resultant.
    ///
    /// This is step 0° of the paper's algorithm for a beam with an unknown rigid motion: contacts in balance, from which the descent
    /// can start.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(crate) fn resting(&self) -> Vec<usize> {
        match self.supports().all() {
            _ if self.supports().lacking() == 0 => Vec::new(),
            [] => {
                let hull =
                    lower_hull(self.by_node().into_iter().map(|place| (self.node_of(place), self.depth_of(place))));
                let places = self.by_node();
                let place = |node: usize| places.iter().copied().find(|place| self.node_of(*place) == node);
                if hull.len() < 2 {
                    return hull.into_iter().filter_map(place).collect();
                }
                let [force, moment] = self.resultant();
                let right = hull.partition_point(|&node| (node as f64) < moment / force).clamp(1, hull.len() - 1);
                hull[right - 1..=right].iter().filter_map(|node| place(*node)).collect()
            }
            [support] if support.held.slope.is_none() => {
                let [force, moment] = self.resultant();
                let to_right = force * support.node as f64 <= moment;
                let slope = |place: &usize| {
                    let away = self.node_of(*place).abs_diff(support.node) as f64;
                    (self.depth_of(*place) - support.held.deflection) / away
                };
                let beside = |node: usize| if to_right { support.node < node } else { node < support.node };
                let beside = self.places().filter(|place| beside(self.node_of(*place)));
                beside.min_by(|a, b| slope(a).total_cmp(&slope(b))).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    /// The places at which the beam may be in contact, ordered by node. If two share a node, only the higher one.
    fn by_node(&self) -> Vec<usize> {
        let mut places: Vec<usize> = self.places().collect();
        if !self.supports().stops().is_empty() {
            let key = |place: &usize| (self.node_of(*place), self.depth_of(*place));
            places.sort_by(|a, b| key(a).0.cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
            places.dedup_by_key(|place| self.node_of(*place));
        }
        places
    }

    /// Makes the places of `resting` the only contacts if the present contacts do not hold the beam. The variable of a node in
    /// contact is free if `in_contact`; `place` is the place of a variable.
    pub(crate) fn hold(&self, free: &mut FreeSet, in_contact: bool, place: impl Fn(usize) -> usize) {
        let lacking = self.supports().lacking();
        if lacking == 0 {
            return;
        }
        // Contact at the node of the only elastic support does not prevent rotation.
        let is_free = |node: usize| {
            self.supports().at(node).is_none() && self.supports().springs().iter().all(|s| s.node != node)
        };
        let touches = |&(i, free): &(usize, bool)| free == in_contact && is_free(self.node_of(place(i)));
        let found = {
            let mut touched = free.iter().enumerate().filter(touches).map(|(i, _)| self.node_of(place(i)));
            let first = touched.next();
            usize::from(first.is_some()) + usize::from(touched.any(|node| Some(node) != first))
        };
        if found < lacking {
            let resting = self.resting();
            *free = (0..free.dimension()).map(|i| resting.contains(&place(i)) == in_contact).collect();
        }
    }

    /// The deflection of the rigid beam at rest at a node; zero if the supports hold the beam.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(super) fn resting_line(&self) -> impl Fn(usize) -> f64 {
        let mut nodes = self.resting();
        if !nodes.is_empty() {
            nodes.extend(self.supports().all().iter().map(|support| support.node));
        }
        let depth = |place: usize| if self.stop(place).is_some() { self.depth_of(place) } else { self.level(place) };
        let points: Vec<[f64; 2]> = nodes.into_iter().map(|place| [self.node_of(place) as f64, depth(place)]).collect();
        move |node: usize| match points.as_slice() {
            [[a, from], [b, to], ..] => from + (to - from) * ((node as f64 - a) / (b - a)),
            _ => 0.0,
        }
    }
}

/// The nodes of the lower convex hull of points given from left to right. For gaps, these are the points on which a rigid beam can rest.
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

/// Forces below this fraction of the sum of all forces are rounding, so that the beam does not rotate.
const IN_BALANCE: f64 = 1e-12;

/// The beam carried by one node alone, with the admissible slope nearest to zero, and the interval of admissible slopes if there is
/// more than one. [`None`] if no slope is admissible, because the foundation next to the node also holds the beam.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub(crate) fn balanced(
    discrete: &Discrete,
    discretisation: Discretisation,
    node: usize,
) -> Option<(Nodal, Option<Motion>)> {
    let nodes = discrete.nodes();
    let first = nodes.start;
    let deflections = |slope: f64| {
        let turned = discrete.turned_about(node, slope);
        let mut deflection = held_beam::on_supports(&turned, discretisation).ok()?.deflection();
        // If a free end carries the beam alone it is held here, so it is not among the nodes. The other end is free too, and node 0
        // is the first node.
        if deflection.len() < nodes.len() {
            deflection.insert(node, discrete.level(node));
        }
        Some(deflection)
    };
    let clearances = |deflection: &[f64]| -> Vec<f64> {
        let open = |((i, g), v): ((usize, &f64), &f64)| {
            let rounding = held_beam::UNITS * f64::EPSILON * (discrete.depth_rounding(i) + v.abs());
            if (g - v).abs() <= rounding { 0.0 } else { g - v }
        };
        nodes.clone().zip(&discrete.depths).zip(deflection).map(open).collect()
    };
    let mut least = f64::NEG_INFINITY;
    let mut most = f64::INFINITY;
    let level = deflections(0.0)?;
    let grounded = nodes.clone().zip(clearances(&level)).filter(|(i, _)| !discrete.is_open_at(*i));
    let stops = discrete.supports().stops().iter().map(|stop| (stop.node, stop.deflection - level[stop.node - first]));
    for (i, h) in grounded.chain(stops).filter(|(i, _)| *i != node) {
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
        // On a smooth foundation the contact may lie between nodes. The slope is then the nearest one that the grid allows.
        [least, most] = [left.clamp(least, most), right.clamp(least, most)];
    }
    let end = |slope: f64| slope.is_finite().then_some(slope);
    let motion = (least < most).then(|| Motion { about: discrete.grid.place(node), slope: [end(least), end(most)] });
    let deflection = deflections(0.0_f64.max(least).min(most))?;
    // Where the slope is at its limit, rounding may make the clearance negative.
    let clearance = clearances(&deflection).into_iter().map(|h| h.max(0.0)).collect();
    let mut contact_force = vec![0.0; nodes.len()];
    if discrete.supports().at(node).is_none() {
        contact_force[node - nodes.start] = discrete.resultant()[0];
    }
    let stop_force = vec![0.0; discrete.supports().stops().len()];
    let mut nodal = Nodal { discretisation, deflection, clearance, contact_force, stop_force };
    nodal.leave_open(discrete);
    Some((nodal, motion))
}

/// The node that alone carries a beam that its supports do not hold, if the loads are in balance on it. It is the node below their
/// resultant, or the only contact that was found.
#[must_use]
pub(crate) fn single_contact(discrete: &Discrete, balance: &Balance, nodal: &Nodal) -> Option<usize> {
    // An elastic support holds the beam together with any contact, and so does tension.
    let gives = !discrete.supports().springs().is_empty();
    let is_held = *balance == Balance::Held || gives || discrete.tension != 0.0;
    if is_held || nodal.contact_force.iter().any(|p| p.is_nan()) {
        return None;
    }
    let [force, moment] = discrete.resultant();
    let size: f64 = discrete.loads.iter().map(|q| q.abs()).sum();
    let carries = |p: &f64| IN_BALANCE * size < *p;
    let stops = discrete.supports().stops().iter().map(|stop| stop.node).zip(&nodal.stop_force);
    let touching = discrete.nodes().zip(&nodal.contact_force).chain(stops);
    let mut touching = touching.filter(|(_, p)| carries(p)).map(|(node, _)| node);
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

#[cfg(test)]
mod tests {
    use super::lower_hull;

    #[test]
    fn the_lower_hull_has_what_a_rigid_beam_can_touch() {
        let hull = |gaps: &[f64]| lower_hull(gaps.iter().copied().enumerate());
        assert_eq!(hull(&[0.0, 1.0, 0.0]), [0, 2]);
        assert_eq!(hull(&[1.0, 0.0, 1.0]), [0, 1, 2]);
        assert_eq!(hull(&[0.0, 0.0, 0.0]), [0, 2], "of a plane the ends");
        assert_eq!(hull(&[3.0, 1.0, 2.0, 0.0, 4.0, 1.0]), [0, 1, 3, 5]);
    }
}
