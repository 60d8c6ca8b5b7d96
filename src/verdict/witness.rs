//! The candidate contact list of a scene, from which its certificates are proven; found and proven once for all answers.
//!
//! A certificate is true with any candidate contact list, and sharp if the list is right ([`crate::certificate`]). The exact contacts
//! come from beam theory. Solving by theory must cost no more than in proportion to the solve that is certified. Where it would cost
//! more, or where theory has no solution, the answer's own contacts are used. These are at nodes of its grid, so the bounds are
//! coarse, and [`contacts_proven`](crate::certificate::Certificate::contacts_proven) is false. On an elastic foundation the answer of
//! theory is always used, solved or not, because values at nodes do not determine the deflection between them well enough.
//!
//! Where a survey has points between the nodes of coarser grids, the active-set solver starts from the same contacts. A discrete
//! problem has one solution, so the start changes the number of exchanges and not the result.

use std::sync::OnceLock;

use super::caused::Caused;
use crate::certificate::{
    Certificate, ContactLoad, Hung, Judged, Lumped, NotLumped, Proof, Stretch, Violation, certify, violations,
    violations_by,
};
use crate::scene::{Foundation, Scale, Scene, SceneError};
use crate::state::Contact;
use crate::theory::{self, Exact};

/// Number of polyline points up to which theory solves the scene on any grid: this takes milliseconds on most profiles.
const ALWAYS: usize = 2_000;

/// Additional polyline points allowed per node of the certified grid: theory needs about as long for a point as a solver for a few nodes.
const PER_NODE: usize = 20;

/// The contacts from which the certificates of one scene are proven.
#[derive(Debug)]
pub struct Witness<'a> {
    scene: &'a Scene,
    /// The contacts of beam theory, if it has an answer.
    theory: OnceLock<Option<ExactContacts>>,
    /// The proof from these contacts.
    proof: OnceLock<Option<Proof>>,
}

/// Contacts of an exact answer; supports at which the foundation fixes the slope; force and moment jump of each elastic support;
/// under an axial force the deflection between contacts; and on an elastic foundation the stretches from end to end.
#[derive(Debug)]
pub(crate) struct ExactContacts {
    contacts: Vec<Contact>,
    held: Vec<(f64, bool)>,
    springs: Vec<[f64; 2]>,
    hung: Vec<Hung>,
    stretches: Option<Vec<Stretch>>,
}

impl ExactContacts {
    /// The contacts of an answer of theory, whether it is a solution or not.
    pub(crate) fn of(exact: &Exact) -> Self {
        let (springs, hung) = (exact.sprung(), exact.hung());
        Self { contacts: exact.witness(), held: exact.held(), springs, hung, stretches: exact.stretches() }
    }

    /// The proof from these contacts, if the scene can be scaled.
    pub(crate) fn proof(&self, scene: &Scene) -> Option<Proof> {
        match &self.stretches {
            Some(stretches) => Proof::of_stretches_on(scene, stretches, (&self.springs, &self.hung)).ok(),
            None => Proof::of_held(scene, &self.contacts, &self.held, &self.springs, &self.hung).ok(),
        }
    }
}

impl<'a> Witness<'a> {
    /// The candidate contact list of a scene that is not solved yet. Theory solves it when the first certificate needs it.
    #[must_use]
    pub fn of(scene: &'a Scene) -> Self {
        Self { scene, theory: OnceLock::new(), proof: OnceLock::new() }
    }

    /// The candidate contact list from an exact answer that is already known, if it is a solution.
    #[must_use]
    pub fn known(scene: &'a Scene, exact: &Exact) -> Self {
        let witness = Self::of(scene);
        // Cannot fail: nothing was set before.
        let _ = witness.theory.set(found(exact));
        witness
    }

    /// The scene.
    #[must_use]
    pub(crate) fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Bounds for a deflection, proven from the contacts of theory if the grid is fine enough for their cost, and otherwise from its
    /// `own`.
    ///
    /// # Errors
    ///
    /// The errors of [`certify`].
    pub fn judge(&self, judged: Judged<'_>, own: &[Contact]) -> Result<Certificate, SceneError> {
        if let Judged::Forces(forces) = judged
            && self.is_bent_in_theory()
        {
            let caused = Caused::of(self.scene, forces, &self.scene.scaled()?.scale, false);
            return self.judge_caused(caused.as_ref(), judged.places(), own);
        }
        match self.proven(judged.places()) {
            Some(proof) => Ok(proof.judge(judged)),
            None if self.scene.ground_stiffness().is_some() => Ok(Proof::of_stretches(self.scene, &[])?.judge(judged)),
            None => certify(self.scene, judged, own),
        }
    }

    /// The same for contact forces on any beam, with what they violate, as [`certificate::violations`](crate::certificate::violations) has it.
    ///
    /// # Errors
    ///
    /// The errors of [`Self::judge`].
    pub fn judge_forces(
        &self,
        forces: &ContactLoad,
        own: &[Contact],
    ) -> Result<(Certificate, Vec<Violation>), SceneError> {
        let judged = Judged::Forces(forces);
        if !self.is_bent_in_theory() {
            return Ok((self.judge(judged, own)?, violations(self.scene, forces)?));
        }
        let caused = Caused::of(self.scene, forces, &self.scene.scaled()?.scale, false);
        let certificate = self.judge_caused(caused.as_ref(), judged.places(), own)?;
        let curve = caused.as_ref().map_or(&[][..], |caused| &caused.curve);
        let mut found = violations_by(self.scene, forces, Some(curve))?;
        if let Some(caused) = caused {
            found.extend(caused.violations);
            found.sort_by(|a, b| b.relative.total_cmp(&a.relative));
        }
        Ok((certificate, found))
    }

    /// Bounds for what forces cause, none of which hold the beam if there is nothing.
    fn judge_caused(&self, caused: Option<&Caused>, nodes: usize, own: &[Contact]) -> Result<Certificate, SceneError> {
        let curve = caused.map_or(&[][..], |caused| &caused.curve);
        Ok(match self.proven(nodes) {
            Some(proof) => proof.judge_curve(curve),
            None if self.scene.ground_stiffness().is_some() => Proof::of_stretches(self.scene, &[])?.judge_curve(curve),
            None => Proof::of(self.scene, own)?.judge_curve(curve),
        })
    }

    /// What the contacts of theory prove, if it may be solved for so many nodes.
    fn proven(&self, nodes: usize) -> Option<&Proof> {
        let found = self.found(nodes)?;
        self.proof.get_or_init(|| found.proof(self.scene)).as_ref()
    }

    /// The beam under contact forces and a load lumped at the same nodes, as in [`Lumped::new`], for any beam.
    ///
    /// # Errors
    ///
    /// The errors of [`Lumped::new`] except the last one.
    pub fn lumped(&self, forces: impl IntoIterator<Item = (f64, f64)>) -> Result<Lumped, NotLumped> {
        const DIMENSIONLESS: Scale = Scale { length: 1.0, depth: 1.0, force: 1.0 };
        if !self.is_bent_in_theory() {
            return Lumped::new(self.scene, forces);
        }
        Lumped::bent_by(self.scene, forces, |lumped, pressing| {
            let caused = Caused::of(lumped, pressing, &DIMENSIONLESS, true)?;
            Some(caused.curve.iter().map(Hung::curve).collect())
        })
    }

    /// Whether beam theory is needed to find the deflection under given forces, because statics alone does not determine it.
    fn is_bent_in_theory(&self) -> bool {
        !self.scene.bends_under_forces()
    }

    /// The contacts of theory as a start for the active-set solver, if a survey has points between the nodes of a `coarser` grid.
    pub(crate) fn start(&self, intervals: usize, coarser: usize) -> Option<&[Contact]> {
        if points(self.scene) <= coarser { None } else { Some(&self.found(intervals)?.contacts) }
    }

    /// The contacts of theory, if theory may be solved for this number of nodes.
    fn found(&self, nodes: usize) -> Option<&ExactContacts> {
        let is_rigid = self.scene.ground_stiffness().is_none();
        match self.theory.get() {
            None if is_rigid && ALWAYS + PER_NODE * nodes < points(self.scene) => None,
            _ => self.theory.get_or_init(|| theory::solve(self.scene).ok().and_then(|exact| found(&exact))).as_ref(),
        }
    }
}

/// The contacts of an exact answer, if it is a solution or the foundation is elastic.
fn found(exact: &Exact) -> Option<ExactContacts> {
    let found = ExactContacts::of(exact);
    (exact.solved || found.stretches.is_some()).then_some(found)
}

/// The number of polyline points of the foundation, from which the cost of theory is estimated.
fn points(scene: &Scene) -> usize {
    match scene.foundation() {
        Some(Foundation::Polyline { points }) => points.len(),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::route::{Method, Solver};
    use crate::scene::{Beam, Load};
    use crate::{Settings, solve_raw};

    /// A foundation of about this many points that are nearly level; one of them, at midspan, carries the beam.
    fn survey(points: u32) -> Scene {
        let beam = Beam::new(1.0, 1.0).expect("positive");
        let load = Load::uniform_on(&beam, 384.0).expect("finite");
        // Exactly level points would be one segment.
        let depth = |k: u32| if 2 * k == points { 0.5 } else { 20.0 + 0.1 * f64::from(k % 3) };
        let points = (0..=points).map(|k| [f64::from(k) / f64::from(points), depth(k)]).collect();
        Scene::new(beam, load, Some(Foundation::Polyline { points })).expect("well posed")
    }

    /// Theory solves the scene where the cost is in proportion to the grid, once; otherwise the answer's own contacts are used.
    #[test]
    fn the_search_is_in_proportion_to_the_solve() {
        let own = [Contact::at(0.25, 1.0)];
        // Whether a deflection on so many intervals is judged from the right contacts.
        let exactly = |witness: &Witness<'_>, intervals: usize| {
            let settings = Settings::new(Method::Force, Solver::ActiveSet, intervals);
            let raw = solve_raw(witness.scene(), &settings).expect("an answer");
            let nodes = raw.state.nodes.expect("it has nodes");
            witness.judge(Judged::Nodes(&nodes), &own).expect("in range").contacts_proven
        };
        let small = survey(100);
        assert!(exactly(&Witness::of(&small), 2));
        let large = survey(6_000);
        let witness = Witness::of(&large);
        assert!(!exactly(&witness, 30), "too few nodes");
        assert!(exactly(&witness, 300), "enough");
        assert!(exactly(&witness, 30), "it is found already");
        let mut solution = theory::solve(&large).expect("theory has an answer");
        assert!(exactly(&Witness::known(&large, &solution), 30));
        solution.solved = false;
        assert!(!exactly(&Witness::known(&large, &solution), 300), "not solved");
    }
}
