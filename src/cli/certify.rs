//! `certify`: how good are contact forces that some program computed?

use palkki::Witness;
use palkki::certificate::bounds::{Lumped, Violation, violations, violations_at_nodes};
use palkki::certificate::{Certificate, ContactLoad, Judged, certify};
use palkki::route::Status;
use palkki::scene::file::{FileError, Problem};
use palkki::state::Contact;
use palkki::verdict::accepts;

use super::arguments::Certify;
use super::failure::Failure;
use super::input::Input;
use super::values::LoadArgument;

/// What is to be said about some contact forces.
#[derive(Debug)]
pub(super) struct Finding {
    /// The forces.
    pub(super) load: ContactLoad,
    /// Equal intervals at whose nodes the load was lumped, if it was.
    pub(super) intervals: Option<usize>,
    /// Equal intervals at whose nodes the load may have been lumped, which nobody said.
    pub(super) perhaps: Option<usize>,
    /// The bounds.
    pub(super) certificate: Certificate,
    /// What they violate, the worst first.
    pub(super) violations: Vec<Violation>,
}

impl Finding {
    /// Reads the forces and bounds the error of the deflection that they cause.
    pub(super) fn of(input: &Input, arguments: &Certify) -> Result<Self, Failure> {
        let forces = &arguments.forces;
        let rows = input.forces(forces)?;
        let scene = &input.scene;
        let lumped = Lumped::new(scene, rows.iter().copied());
        let own: Vec<Contact> =
            rows.iter().filter(|row| 0.0 < row.1).map(|&(x, force)| Contact::at(x, force)).collect();
        let witness = Witness::of(scene);
        let contacts = witness.contacts(rows.len(), &own);
        if arguments.load == LoadArgument::Nodal {
            let lumped = lumped.map_err(|error| Failure::NotLumped { path: forces.clone(), error })?;
            let certificate = certify(scene, Judged::Nodes(&lumped.nodes), contacts).map_err(|e| input.error(e))?;
            let violations = violations_at_nodes(&lumped);
            let intervals = Some(lumped.intervals());
            return Ok(Self { load: lumped.load, intervals, perhaps: None, certificate, violations });
        }
        // The reader has refused whatever this refuses.
        let load = ContactLoad::new(scene.beam().length(), rows).map_err(|_| {
            let name = forces.display().to_string();
            Failure::File(Box::new(FileError::whole(&name, Problem::ForcesWithoutHeader)))
        })?;
        let certificate = certify(scene, Judged::Forces(&load), contacts).map_err(|error| input.error(error))?;
        let violations = violations(scene, &load).map_err(|error| input.error(error))?;
        let perhaps = lumped.ok().filter(|_| !accepts(&certificate)).map(|lumped| lumped.intervals());
        Ok(Self { load, intervals: None, perhaps, certificate, violations })
    }

    /// Certified if the deflection that the forces cause is certain enough, see [`accepts`].
    pub(super) fn status(&self) -> Status {
        if accepts(&self.certificate) { Status::Certified } else { Status::NotCertified }
    }
}
