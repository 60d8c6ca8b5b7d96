//! What `solve` and each route of `compare` have in common: how an answer was found, what it is worth, and what it says.

use palkki::state::{Contact, ContactState, Extremes, Nodes};
use serde::Serialize;

use super::super::answer::Answer;
use super::certificate::CertificateObject;
use super::dial::DialObject;

#[derive(Debug, Serialize)]
pub(super) struct RouteObject<'a> {
    method: &'a str,
    solver: &'a str,
    intervals: Option<usize>,
    status: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    solver_status: &'a str,
    residual: Option<f64>,
    regime: &'a str,
    unknowns: usize,
    iterations: usize,
    seconds: f64,
    reactions: ReactionsObject,
    contacts: Vec<ContactObject>,
    contact_force: f64,
    deflection: DeflectionObject,
    moment: MomentObject,
    energy: f64,
    certificate: Option<CertificateObject>,
    /// What it took to find the grid; there if a tolerance was given and no grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    dial: Option<DialObject>,
}

impl<'a> From<&'a Answer> for RouteObject<'a> {
    fn from(answer: &'a Answer) -> Self {
        let ContactState { regime, reactions, contacts, deflection, moment, energy, .. } = &answer.state;
        Self {
            method: answer.method,
            solver: answer.solver,
            intervals: answer.intervals,
            status: answer.status.word(),
            reason: answer.refusal.map(|refusal| refusal.to_string()),
            solver_status: &answer.solver_status,
            residual: answer.residual,
            regime: regime.word(),
            unknowns: answer.unknowns,
            iterations: answer.iterations,
            seconds: answer.seconds,
            reactions: ReactionsObject { left: reactions.left, right: reactions.right },
            contacts: contacts.iter().map(ContactObject::from).collect(),
            contact_force: answer.state.contact_force(),
            deflection: deflection.into(),
            moment: moment.into(),
            energy: *energy,
            certificate: answer.certificate.as_ref().map(CertificateObject::from),
            dial: answer.search.as_ref().map(|search| DialObject::of(answer, search)),
        }
    }
}

#[derive(Debug, Serialize)]
struct ReactionsObject {
    left: f64,
    right: f64,
}

#[derive(Debug, Serialize)]
struct ContactObject {
    from: f64,
    to: f64,
    force: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_from: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_to: Option<f64>,
}

impl From<&Contact> for ContactObject {
    fn from(&Contact { from, to, force, end_forces }: &Contact) -> Self {
        let [force_from, force_to] = end_forces.map_or([None, None], |ends| ends.map(Some));
        Self { from, to, force, force_from, force_to }
    }
}

#[derive(Debug, Serialize)]
struct DeflectionObject {
    max: f64,
    at: f64,
    min: f64,
    min_at: f64,
}

impl From<&Extremes> for DeflectionObject {
    fn from(&Extremes { max, max_at, min, min_at }: &Extremes) -> Self {
        Self { max, at: max_at, min, min_at }
    }
}

#[derive(Debug, Serialize)]
struct MomentObject {
    max: f64,
    max_at: f64,
    min: f64,
    min_at: f64,
}

impl From<&Extremes> for MomentObject {
    fn from(&Extremes { max, max_at, min, min_at }: &Extremes) -> Self {
        Self { max, max_at, min, min_at }
    }
}

/// The values at the interior nodes of a grid.
#[derive(Debug, Serialize)]
pub(super) struct NodesObject<'a> {
    x: &'a [f64],
    deflection: &'a [f64],
    clearance: &'a [f64],
    contact_force: &'a [f64],
    moment: &'a [f64],
}

impl<'a> From<&'a Nodes> for NodesObject<'a> {
    fn from(nodes: &'a Nodes) -> Self {
        Self {
            x: &nodes.x,
            deflection: &nodes.deflection,
            clearance: &nodes.clearance,
            contact_force: &nodes.contact_force,
            moment: &nodes.moment,
        }
    }
}
