//! Answers as JSON. `serde_json` prints an `f64` with as many digits as it takes to read the same number back, and
//! `null` for one that is not finite: the clearance where there is no foundation, a difference relative to zero.

use palkki::certificate::Certificate;
use palkki::dial::{End, Try};
use palkki::state::{Contact, ContactState, Extremes, Nodes};
use serde::Serialize;

use super::answer::{Answer, Search};
use super::certify::Judgement;
use super::compare::{Comparison, Difference};
use super::input::Input;

/// Grids with more intervals are printed without their nodes, unless these are asked for.
pub(super) const MOST_INTERVALS_WITH_NODES: usize = 10_000;

/// The answer of `solve`.
#[derive(Debug, Serialize)]
struct Object<'a> {
    scene: &'a str,
    #[serde(flatten)]
    route: RouteObject<'a>,
    nodes: Option<NodesObject<'a>>,
}

/// What `solve` and each route of `compare` have in common.
#[derive(Debug, Serialize)]
struct RouteObject<'a> {
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
    #[serde(skip_serializing_if = "Option::is_none")]
    dial: Option<DialObject>,
}

/// What it took to find the grid; there if a tolerance was given and no grid.
#[derive(Debug, Serialize)]
struct DialObject {
    tolerance: f64,
    reached: bool,
    end: String,
    error: f64,
    seconds: f64,
    grids: Vec<GridObject>,
}

/// A grid that was tried; `error` is the guaranteed one, over the largest deflection, and `null` if there is none.
#[derive(Debug, Serialize)]
struct GridObject {
    intervals: usize,
    solver_tolerance: f64,
    unknowns: usize,
    iterations: usize,
    residual: f64,
    error: f64,
    seconds: f64,
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

#[derive(Debug, Serialize)]
struct DeflectionObject {
    max: f64,
    at: f64,
    min: f64,
    min_at: f64,
}

#[derive(Debug, Serialize)]
struct MomentObject {
    max: f64,
    max_at: f64,
    min: f64,
    min_at: f64,
}

#[derive(Debug, Serialize)]
struct NodesObject<'a> {
    x: &'a [f64],
    deflection: &'a [f64],
    clearance: &'a [f64],
    contact_force: &'a [f64],
    moment: &'a [f64],
}

/// Bounds; `null` where there is none.
#[derive(Debug, Serialize)]
struct CertificateObject {
    energy_lower: f64,
    energy_upper: f64,
    gap: f64,
    deflection_error: f64,
    deflection_error_at: f64,
    /// For forces that somebody else computed, whose own deflection may be far from the best one.
    #[serde(skip_serializing_if = "Option::is_none")]
    best_deflection_error: Option<f64>,
    reactions: BracketsObject,
    stiffness: Option<[f64; 2]>,
}

#[derive(Debug, Serialize)]
struct BracketsObject {
    left: Option<[f64; 2]>,
    right: Option<[f64; 2]>,
}

/// What `certify` found.
#[derive(Debug, Serialize)]
struct JudgementObject<'a> {
    scene: &'a str,
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

pub(super) fn solve(input: &Input, answer: &Answer, all_nodes: bool) -> String {
    let few = answer.intervals.is_some_and(|intervals| intervals <= MOST_INTERVALS_WITH_NODES);
    let nodes = answer.nodes().filter(|_| few || all_nodes).map(nodes);
    print(&Object { scene: input.title(), route: route(answer), nodes })
}

pub(super) fn compare(input: &Input, comparison: &Comparison) -> String {
    let routes = comparison.routes.iter().map(|compared| ComparedObject {
        route: route(&compared.answer),
        solver_error: compared.solver_error.as_ref().map(difference),
        model_error: compared.model_error.as_ref().map(difference),
    });
    print(&ComparisonObject { scene: input.title(), intervals: comparison.intervals, routes: routes.collect() })
}

pub(super) fn certify(input: &Input, judgement: &Judgement) -> String {
    let violations = judgement.violations.iter().map(|v| ViolationObject {
        condition: v.kind.word(),
        at: v.at,
        amount: v.amount,
        relative: v.relative,
    });
    print(&JudgementObject {
        scene: input.title(),
        status: judgement.status().word(),
        certificate: CertificateObject {
            best_deflection_error: Some(judgement.certificate.best_deflection_error),
            ..certificate_of(&judgement.certificate)
        },
        violations: violations.collect(),
    })
}

fn print(value: &impl Serialize) -> String {
    // Structs of numbers and texts have nothing that serialising could refuse.
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}

fn route(answer: &Answer) -> RouteObject<'_> {
    let ContactState { regime, reactions, contacts, deflection, moment, energy, .. } = &answer.state;
    RouteObject {
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
        contacts: contacts.iter().map(contact).collect(),
        contact_force: answer.state.contact_force(),
        deflection: deflection_of(deflection),
        moment: moment_of(moment),
        energy: *energy,
        certificate: answer.certificate.as_ref().map(certificate_of),
        dial: answer.search.as_ref().map(|search| dial(answer, search)),
    }
}

fn dial(answer: &Answer, search: &Search) -> DialObject {
    let grid = |(t, seconds): &(Try, f64)| GridObject {
        intervals: t.intervals,
        solver_tolerance: t.tolerance,
        unknowns: t.unknowns,
        iterations: t.iterations,
        residual: t.residual,
        error: t.error,
        seconds: *seconds,
    };
    DialObject {
        tolerance: search.demanded,
        reached: search.end == End::Reached,
        end: search.end.to_string(),
        error: answer.error,
        seconds: search.seconds,
        grids: search.tries.iter().map(grid).collect(),
    }
}

fn certificate_of(certificate: &Certificate) -> CertificateObject {
    let [left, right] = certificate.reactions;
    CertificateObject {
        energy_lower: certificate.energy_lower,
        energy_upper: certificate.energy_upper,
        gap: certificate.gap,
        deflection_error: certificate.deflection_error,
        deflection_error_at: certificate.deflection_error_at,
        best_deflection_error: None,
        reactions: BracketsObject { left, right },
        stiffness: certificate.stiffness,
    }
}

fn contact(&Contact { from, to, force, end_forces }: &Contact) -> ContactObject {
    let [force_from, force_to] = end_forces.map_or([None, None], |ends| ends.map(Some));
    ContactObject { from, to, force, force_from, force_to }
}

fn deflection_of(&Extremes { max, max_at, min, min_at }: &Extremes) -> DeflectionObject {
    DeflectionObject { max, at: max_at, min, min_at }
}

fn moment_of(&Extremes { max, max_at, min, min_at }: &Extremes) -> MomentObject {
    MomentObject { max, max_at, min, min_at }
}

fn nodes(nodes: &Nodes) -> NodesObject<'_> {
    NodesObject {
        x: &nodes.x,
        deflection: &nodes.deflection,
        clearance: &nodes.clearance,
        contact_force: &nodes.contact_force,
        moment: &nodes.moment,
    }
}

fn difference(difference: &Difference) -> DifferenceObject<'_> {
    let Difference { reference, reaction, energy, deflection } = difference;
    DifferenceObject { reference, reaction: *reaction, energy: *energy, deflection: *deflection }
}
