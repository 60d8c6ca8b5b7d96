//! Answers as JSON. `serde_json` prints an `f64` with as many digits as it takes to read the same number back, and
//! `null` for one that is not finite: the clearance where there is no foundation, a difference relative to zero.

mod certificate;
mod dial;
mod route;

use palkki::certificate::bounds::Violation;
use serde::Serialize;

use self::certificate::CertificateObject;
use self::route::{NodesObject, RouteObject};
use super::answer::Answer;
use super::certify::Finding;
use super::compare::{Compared, Comparison, Difference};
use super::input::Input;

/// Grids with more intervals are printed without their nodes, unless these are asked for.
pub(super) const MOST_INTERVALS_WITH_NODES: usize = 10_000;

/// The answer of `solve`.
#[derive(Debug, Serialize)]
struct SolveObject<'a> {
    scene: &'a str,
    #[serde(flatten)]
    route: RouteObject<'a>,
    nodes: Option<NodesObject<'a>>,
}

pub(super) fn solve(input: &Input, answer: &Answer, all_nodes: bool) -> String {
    let few = answer.intervals.is_some_and(|intervals| intervals <= MOST_INTERVALS_WITH_NODES);
    let nodes = answer.nodes().filter(|_| few || all_nodes).map(NodesObject::from);
    print(&SolveObject { scene: input.title(), route: answer.into(), nodes })
}

/// What `compare` found.
#[derive(Debug, Serialize)]
struct ComparisonObject<'a> {
    scene: &'a str,
    intervals: usize,
    routes: Vec<ComparedObject<'a>>,
}

#[derive(Debug, Serialize)]
struct ComparedObject<'a> {
    #[serde(flatten)]
    route: RouteObject<'a>,
    solver_error: Option<DifferenceObject<'a>>,
    model_error: Option<DifferenceObject<'a>>,
}

#[derive(Debug, Serialize)]
struct DifferenceObject<'a> {
    reference: &'a str,
    reaction: f64,
    energy: f64,
    deflection: f64,
}

pub(super) fn compare(input: &Input, comparison: &Comparison) -> String {
    let routes = comparison.routes.iter().map(ComparedObject::from).collect();
    print(&ComparisonObject { scene: input.title(), intervals: comparison.intervals, routes })
}

impl<'a> From<&'a Compared> for ComparedObject<'a> {
    fn from(compared: &'a Compared) -> Self {
        let Compared { answer, solver_error, model_error } = compared;
        Self {
            route: answer.into(),
            solver_error: solver_error.as_ref().map(DifferenceObject::from),
            model_error: model_error.as_ref().map(DifferenceObject::from),
        }
    }
}

impl<'a> From<&'a Difference> for DifferenceObject<'a> {
    fn from(difference: &'a Difference) -> Self {
        let Difference { reference, reaction, energy, deflection } = difference;
        Self { reference, reaction: *reaction, energy: *energy, deflection: *deflection }
    }
}

/// What `certify` found.
#[derive(Debug, Serialize)]
struct FindingObject<'a> {
    scene: &'a str,
    /// Only where the load was lumped at nodes.
    #[serde(skip_serializing_if = "Option::is_none")]
    intervals: Option<usize>,
    status: &'a str,
    certificate: CertificateObject,
    violations: Vec<ViolationObject>,
}

#[derive(Debug, Serialize)]
struct ViolationObject {
    condition: &'static str,
    at: f64,
    amount: f64,
    relative: f64,
}

pub(super) fn certify(input: &Input, finding: &Finding) -> String {
    print(&FindingObject {
        scene: input.title(),
        intervals: finding.intervals,
        status: finding.status().word(),
        certificate: CertificateObject::of_forces(&finding.certificate),
        violations: finding.violations.iter().map(ViolationObject::from).collect(),
    })
}

impl From<&Violation> for ViolationObject {
    fn from(violation: &Violation) -> Self {
        let Violation { kind, at, amount, relative } = *violation;
        Self { condition: kind.word(), at, amount, relative }
    }
}

fn print(value: &impl Serialize) -> String {
    // Structs of numbers and texts have nothing that serialising could refuse.
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}
