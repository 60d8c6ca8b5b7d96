//! What a witness says, as contact nodes. Nothing is added to its contacts but the supports, and no place is moved: what is
//! wrong stays wrong, and is paid for in [`super::proof`].

use super::contact_node::{ContactNode, EnclosedScene, Kind};
use super::ground::Ground;
use super::slopes;
use crate::scene::{Foundation, Scale};
use crate::state::Contact;

/// The contact nodes of a list of contacts in the units of the scene, in its order, with the slopes that follow from their
/// places. A contact at a single place is a corner of the foundation if there is one, and otherwise a point of tangency.
#[expect(clippy::float_cmp, reason = "a contact from a place to the same place is a point")]
pub(super) fn nodes(enclosed: &EnclosedScene<'_>, contacts: &[Contact], scale: &Scale) -> Vec<ContactNode> {
    let length = enclosed.length;
    let mut nodes: Vec<ContactNode> = Vec::with_capacity(2 * contacts.len() + 2);
    for contact in contacts {
        let [from, to] = [contact.from / scale.length, contact.to / scale.length];
        if from != to {
            nodes.extend([ContactNode::new(Kind::Start, from), ContactNode::new(Kind::End, to)]);
        } else if from == 0.0 || from == length {
            // A point at a support says nothing that the support does not say.
        } else if enclosed.ground.corners(from.next_down(), from.next_up()).is_empty() {
            nodes.push(ContactNode::new(Kind::Touch, from));
        } else {
            nodes.push(ContactNode::new(Kind::Corner, from));
        }
    }
    // A zone that begins or ends at a support takes its place.
    if nodes.first().is_none_or(|node| node.x != 0.0) {
        nodes.insert(0, ContactNode::new(Kind::Support, 0.0));
    }
    if nodes.last().is_none_or(|node| node.x != length) {
        nodes.push(ContactNode::new(Kind::Support, length));
    }
    slopes::find(enclosed, &mut nodes);
    nodes
}

impl ContactNode {
    pub(super) fn new(kind: Kind, x: f64) -> Self {
        Self { kind, x, slope: 0.0 }
    }
}

impl Ground<'_> {
    /// Places strictly between two others at which the foundation can carry a concentrated force because it has a corner
    /// there that points upwards: the upper edges of steps, and kinks after which it falls more than before.
    pub(super) fn corners(&self, from: f64, to: f64) -> Vec<f64> {
        let Foundation::Polyline { points } = self.foundation else { return Vec::new() };
        let first = points.partition_point(|p| p[0] <= from).max(1);
        let beyond = points.partition_point(|p| p[0] < to).min(points.len() - 1);
        // Of a step infinite, in the direction in which it goes.
        let slope = |a: [f64; 2], b: [f64; 2]| (b[1] - a[1]) / (b[0] - a[0]);
        let corner = |i: usize| slope(points[i - 1], points[i]) < slope(points[i], points[i + 1]);
        let mut corners: Vec<f64> = (first..beyond.max(first)).filter(|&i| corner(i)).map(|i| points[i][0]).collect();
        corners.dedup();
        corners
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::bounds::load::Pieces;
    use crate::scene::{Beam, Load, Scene};

    /// Right or wrong, in order or not, contacts stay where they are, and become no others.
    #[test]
    fn a_list_stays_as_it_is_given() {
        const LENGTH: f64 = 8.0;
        let beam = Beam::new(LENGTH, 70.0).expect("positive");
        let load = Load::uniform_on(&beam, 3.0).expect("finite");
        let ground = Foundation::Polyline { points: vec![[0.0, 1.0], [3.0, 2.0], [5.0, 1.0], [8.0, 2.0]] };
        let scaled = Scene::new(beam, load, Some(ground)).expect("well posed").scaled().expect("in range");
        let (scene, scale, unit) = (&scaled.scene, scaled.scale, scaled.scale.length);
        let pieces = Pieces::of(scene);
        let ground = Ground::of(scene).expect("there is a foundation");
        let stiffness = scene.beam().bending_stiffness();
        let enclosed = EnclosedScene { ground, load: &pieces, stiffness, length: scene.beam().length() };
        use Kind::{Corner, End, Start, Support, Touch};
        for (given, kinds) in [
            (&[][..], &[Support, Support][..]),
            (&[[5.0, 5.0], [5.5, 5.5]], &[Support, Corner, Touch, Support]),
            (&[[3.0, 3.0], [4.0, 7.0]], &[Support, Touch, Start, End, Support]),
            (&[[0.0, 1.0], [7.5, 8.0]], &[Start, End, Start, End]),
            (&[[1e-12, 1.0]], &[Support, Start, End, Support]),
            (&[[0.0, 0.0], [8.0, 8.0]], &[Support, Support]),
            (&[[6.0, 2.0], [1.0, 1.0], [1.0, 1.0], [9.0, 9.0]], &[Support, Start, End, Touch, Touch, Touch, Support]),
            (&[[f64::NAN, f64::NAN], [2.0, f64::INFINITY]], &[Support, Start, End, Start, End, Support]),
        ] {
            let contacts: Vec<Contact> =
                given.iter().map(|&[from, to]| Contact { from, to, force: 1.0, end_forces: None }).collect();
            let found = nodes(&enclosed, &contacts, &scale);
            assert!(found.iter().map(|j| j.kind).eq(kinds.iter().copied()), "{given:?}: {found:?}");
            let inside = found.iter().filter(|j| j.kind != Support).map(|j| (j.x * unit).to_bits());
            let all = given.iter().flat_map(|&[from, to]| {
                if from.total_cmp(&to).is_eq() && !from.is_nan() { vec![from] } else { vec![from, to] }
            });
            let expected: Vec<u64> = all.map(f64::to_bits).collect();
            let found: Vec<u64> = inside.collect();
            assert!(found == expected || given == [[0.0, 0.0], [8.0, 8.0]], "{given:?}: {found:?}");
        }
    }
}
