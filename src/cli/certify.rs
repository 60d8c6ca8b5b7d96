//! `certify`: how good are contact forces that somebody else computed?

use palkki::certificate::bounds::{Violation, violations};
use palkki::certificate::{Certificate, ContactLoad, Judged, certify};
use palkki::route::Status;
use palkki::scene::file::{FileError, Problem};
use palkki::verdict::accepts;
use std::path::Path;

use super::failure::Failure;
use super::input::Input;

/// What is to be said about some contact forces.
#[derive(Debug)]
pub(super) struct Judgement {
    /// The forces.
    pub(super) load: ContactLoad,
    /// The bounds.
    pub(super) certificate: Certificate,
    /// What they violate, the worst first.
    pub(super) violations: Vec<Violation>,
}

impl Judgement {
    /// Reads the forces and judges them.
    pub(super) fn of(input: &Input, forces: &Path) -> Result<Self, Failure> {
        let rows = input.forces(forces)?;
        let scene = &input.scene;
        // The reader has refused whatever this refuses.
        let load = ContactLoad::new(scene.beam().length(), rows).map_err(|_| {
            let name = forces.display().to_string();
            Failure::File(Box::new(FileError::whole(&name, Problem::ForcesWithoutHeader)))
        })?;
        let certificate = certify(scene, &load, Judged::Caused).map_err(|error| input.error(error))?;
        let violations = violations(scene, &load).map_err(|error| input.error(error))?;
        Ok(Self { load, certificate, violations })
    }

    /// Certified if the deflection that the forces cause is certain enough, see [`accepts`].
    pub(super) fn status(&self) -> Status {
        if accepts(&self.certificate) { Status::Certified } else { Status::NotCertified }
    }
}
