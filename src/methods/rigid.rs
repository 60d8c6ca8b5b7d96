//! The motion of a beam as a whole, where its supports leave it free: where it would rest if it were rigid, and whether one place alone
//! carries it. There the forces are certain, and of its position a grid knows nothing: beam theory alone has that.

use super::Discrete;
use super::answer::Nodal;
use crate::qp::FreeSet;
use crate::scene::Balance;

impl Discrete {
    /// The resultant of the nodal loads: the force, and its moment about the left end, with lengths in intervals.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn resultant(&self) -> [f64; 2] {
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
        match self.supports().all() {
            [] => {
                let hull = lower_hull(self.touchable().map(|node| (node, self.depths[node])));
                if hull.len() < 2 {
                    return hull;
                }
                let [force, moment] = self.resultant();
                let right = hull.partition_point(|&node| (node as f64) < moment / force).clamp(1, hull.len() - 1);
                hull[right - 1..=right].to_vec()
            }
            [support] if support.held.slope.is_none() => {
                let [force, moment] = self.resultant();
                let to_right = force * support.node as f64 <= moment;
                let slope =
                    |node: &usize| (self.level(*node) - support.held.deflection) / node.abs_diff(support.node) as f64;
                let beside =
                    self.touchable().filter(|&node| if to_right { support.node < node } else { node < support.node });
                beside.min_by(|a, b| slope(a).total_cmp(&slope(b))).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    /// Makes contact at these nodes the only one, if the nodes in contact do not hold the beam. The variable of a node in contact is
    /// free if `in_contact`; `node` is that of a variable.
    pub(crate) fn hold(&self, free: &mut FreeSet, in_contact: bool, node: impl Fn(usize) -> usize) {
        let lacking = self.supports().lacking();
        let touches = |&(i, free): &(usize, bool)| free == in_contact && self.supports().at(node(i)).is_none();
        if 0 < lacking && free.iter().enumerate().filter(touches).take(lacking).count() < lacking {
            let resting = self.resting();
            *free = (0..free.dimension()).map(|i| resting.contains(&node(i)) == in_contact).collect();
        }
    }

    /// The deflection of that rigid beam at a node; zero of a beam that its supports hold.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(super) fn resting_line(&self) -> impl Fn(usize) -> f64 {
        let mut nodes = self.resting();
        if !nodes.is_empty() {
            nodes.extend(self.supports().all().iter().map(|support| support.node));
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

/// Forces below this share of all others are rounding: what balances does not turn.
const IN_BALANCE: f64 = 1e-12;

/// Whether one node alone carries a beam that its supports do not hold, with the loads in balance above it.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub(crate) fn is_on_one_node(discrete: &Discrete, balance: &Balance, nodal: &Nodal) -> bool {
    if *balance == Balance::Held || nodal.contact_force.iter().any(|p| p.is_nan()) {
        return false;
    }
    let [force, moment] = discrete.resultant();
    let size: f64 = discrete.loads.iter().map(|q| q.abs()).sum();
    let carries = |p: &f64| IN_BALANCE * size < *p;
    let mut touching = discrete.nodes().zip(&nodal.contact_force).filter(|(_, p)| carries(p)).map(|(node, _)| node);
    let only = match (discrete.supports().all().first(), touching.next(), touching.next()) {
        (Some(support), None, _) => support.node,
        (None, Some(node), None) => node,
        _ => return false,
    };
    (moment - force * only as f64).abs() <= IN_BALANCE * size * discrete.intervals as f64
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
