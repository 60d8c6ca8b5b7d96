//! The witness of a scene: the contacts from which its certificates are proven, found once for all answers.
//!
//! A certificate is as true with any witness and as sharp as its witness is right ([`crate::certificate`]). The exact contacts
//! come from beam theory. Looking for them may cost no more than in proportion to the solve that is certified; where it would,
//! or where beam theory has no answer, the answer's own contacts serve, which are at nodes of its grid, and the bounds are
//! coarse: [`contacts_proven`](crate::certificate::Certificate::contacts_proven) is false then.

use std::sync::OnceLock;

use crate::scene::{Foundation, Scene};
use crate::state::Contact;
use crate::theory::{self, Exact};

/// Points of a polyline with which beam theory is asked whatever the grid: it takes milliseconds on most profiles.
const ALWAYS: usize = 2_000;

/// Points more for each node of the grid that is certified: on a point beam theory spends about what a solver spends on a few
/// nodes.
const PER_NODE: usize = 20;

/// Contacts that certificates of one scene are proven from.
#[derive(Debug)]
pub struct Witness<'a> {
    scene: &'a Scene,
    theory: OnceLock<Option<Vec<Contact>>>,
}

impl<'a> Witness<'a> {
    /// Of a scene that has not been looked at yet: beam theory is asked when the first certificate needs it.
    #[must_use]
    pub fn of(scene: &'a Scene) -> Self {
        Self { scene, theory: OnceLock::new() }
    }

    /// The contacts of a solution that is already there, if it is one.
    #[must_use]
    pub fn known(scene: &'a Scene, exact: &Exact) -> Self {
        let witness = Self::of(scene);
        // Nothing was found before.
        let _ = witness.theory.set(solved(exact));
        witness
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// The contacts for the certificate of an answer on so many nodes: those of beam theory, if they are worth the search, and
    /// otherwise the answer's own.
    #[must_use]
    pub fn contacts<'s>(&'s self, nodes: usize, own: &'s [Contact]) -> &'s [Contact] {
        let found = match self.theory.get() {
            None if points(self.scene) <= ALWAYS + PER_NODE * nodes => {
                self.theory.get_or_init(|| theory::solve(self.scene).ok().as_ref().and_then(solved))
            }
            found => found.unwrap_or(&None),
        };
        found.as_deref().unwrap_or(own)
    }
}

/// The contacts of an exact solution.
fn solved(exact: &Exact) -> Option<Vec<Contact>> {
    (exact.solved).then(|| exact.state.contacts.clone())
}

/// What beam theory has to look at.
fn points(scene: &Scene) -> usize {
    match scene.foundation() {
        Some(Foundation::Polyline { points }) => points.len(),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Load};

    /// Level ground with one point that carries the beam, in so many points.
    fn survey(points: u32) -> Scene {
        let beam = Beam::new(1.0, 1.0).expect("positive");
        let load = Load::uniform_on(&beam, 384.0).expect("finite");
        // Level points would be one segment.
        let depth = |k: u32| if 2 * k == points { 0.5 } else { 20.0 + 0.1 * f64::from(k % 3) };
        let points = (0..=points).map(|k| [f64::from(k) / f64::from(points), depth(k)]).collect();
        Scene::new(beam, load, Some(Foundation::Polyline { points })).expect("well posed")
    }

    /// Beam theory is asked where that is in proportion to the grid, once, and otherwise the answer's own contacts serve.
    #[test]
    fn the_search_is_in_proportion_to_the_solve() {
        let own = [Contact::at(0.25, 1.0)];
        let small = survey(100);
        let exact = [0.5, 0.5];
        let places = |contacts: &[Contact]| contacts.iter().map(|c| [c.from, c.to]).collect::<Vec<_>>();
        assert_eq!(places(Witness::of(&small).contacts(0, &own)), [exact]);
        let large = survey(6_000);
        let witness = Witness::of(&large);
        assert_eq!(places(witness.contacts(30, &own)), [[0.25; 2]], "too few nodes");
        assert_eq!(places(witness.contacts(300, &own)), [exact], "enough");
        assert_eq!(places(witness.contacts(30, &own)), [exact], "it is found already");
        let mut solution = theory::solve(&small).expect("theory has an answer");
        assert_eq!(places(Witness::known(&large, &solution).contacts(30, &own)), [exact]);
        solution.solved = false;
        assert_eq!(places(Witness::known(&large, &solution).contacts(300, &own)), [[0.25; 2]], "not solved");
    }
}
