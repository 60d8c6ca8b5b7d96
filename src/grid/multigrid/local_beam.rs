//! Solves parts of a beam on its contacts. At most half of the moment at one contact is carried over to the next (0.268 of it between
//! equal spans). A change [`FAR`] contacts away is therefore less than a unit in the last place here. A part of the beam is solved as
//! a separate beam that begins and ends that many contacts outside, with zero moments at its ends.

use std::ops::Range;

use super::spans::Spans;
use crate::methods::Discrete;
use crate::methods::contact_set::{ContactSet, OnContacts};
use crate::qp::{FreeSet, NotPositiveDefinite, Stationary};
use crate::state::Discretisation;

/// `2^−FAR` is less than half a unit in the last place.
const FAR: usize = 54;

/// A beam of which any part can be solved in a time that hardly depends on the rest.
pub(super) struct LocalBeam<'a> {
    discrete: &'a Discrete,
    discretisation: Discretisation,
    spans: Spans,
}

impl<'a> LocalBeam<'a> {
    pub(super) fn new(discrete: &'a Discrete, discretisation: Discretisation) -> Self {
        Self { discrete, discretisation, spans: Spans::new(&discrete.loads) }
    }

    /// Contact forces and clearances of a range of variables, with contact at all nodes whose forces are free.
    pub(super) fn point(&self, free: &FreeSet, range: Range<usize>) -> Result<Stationary, NotPositiveDefinite> {
        let Discrete { loads, .. } = self.discrete;
        let span = |first, last| self.spans.between(loads, first, last);
        let first = self.discrete.nodes().start;
        let nodes = range.start + first..range.end + first;
        let contacts = self.contacts(free, range);
        let OnContacts { contact_force, clearance } =
            contacts.solve_at(self.discrete, self.discretisation, span, nodes)?;
        Ok(Stationary { x: contact_force, gradient: clearance })
    }

    /// The nodes on which some variables depend: the contacts between them, [`FAR`] contacts on both sides, and the supports between
    /// all of these.
    fn contacts(&self, free: &FreeSet, range: Range<usize>) -> ContactSet {
        let first = self.discrete.nodes().start;
        let left: Vec<usize> = free.before(range.start).take(FAR).collect();
        let right: Vec<usize> = free.within(range.end..free.dimension()).take(FAR).collect();
        // Where there are fewer contacts, the part extends to the end of the beam.
        let ends = [left.len() < FAR, right.len() < FAR];
        let from = if ends[0] { 0 } else { left[FAR - 1] + first };
        let to = if ends[1] { self.discrete.intervals } else { right[FAR - 1] + first };
        let count = left.len() + free.count(range.clone()) + right.len();
        let contacts = left.into_iter().rev().chain(free.within(range)).chain(right).map(|i| i + first);
        ContactSet::part(self.discrete, contacts, count, &(from..=to), ends)
    }

    /// If the contacts do not hold the beam, replaces them by the nodes on which a rigid beam would rest.
    pub(super) fn hold(&self, free: &mut FreeSet) {
        let first = self.discrete.nodes().start;
        self.discrete.hold(free, true, |i| i + first);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::Method;
    use crate::multigrid::tests::{scenes, spread};
    use crate::qp::Sizes;

    /// Relative to the sizes: systems of condition number 3, and the neglected part far away.
    const ROUNDED: f64 = 1e-11;

    /// On random contact sets, parts of a beam and of a chain of links agree with the whole, for every method.
    #[test]
    fn a_part_is_that_of_the_whole() {
        let mut drawn = 0_u32;
        let mut once_in = |share: u32| {
            drawn += 1;
            spread(drawn * (drawn % 61)) * f64::from(share) < 1.0
        };
        for scene in scenes().step_by(4) {
            let scaled = scene.scaled().expect("in range");
            let discrete = Discrete::new(&scaled.scene, 400).expect("a grid");
            for method in Method::ALL {
                let qp = method.qp(&discrete);
                let parts = LocalBeam::new(&discrete, method.discretisation());
                let Sizes { x: depth, gradient: force } = discrete.sizes();
                for share in [2, 5, 40] {
                    let contact: FreeSet = (0..qp.dimension()).map(|_| once_in(share)).collect();
                    let free = contact.iter().map(|contact| contact == method.is_free_in_contact()).collect();
                    let whole = qp.stationary(&free).expect("definite");
                    let whole = method.nodal(&discrete, whole.x, whole.gradient);
                    for range in [0..qp.dimension(), 120..190, 300..301] {
                        let part = parts.point(&contact, range.clone()).expect("definite");
                        for (k, i) in range.enumerate() {
                            let [p, h] = [whole.contact_force[i], whole.clearance[i]];
                            // A beam held at random positions carries more than its load.
                            let scale = 1.0 + p.abs() / force + h.abs() / depth;
                            let apart = ((part.x[k] - p) / force).abs().max(((part.gradient[k] - h) / depth).abs());
                            assert!(apart <= ROUNDED * scale, "{method}, node {}: {apart:.1e} of {scale:.1e}", i + 1);
                        }
                    }
                }
            }
        }
    }
}
