//! Answers as JSON.
//!
//! `serde_json` prints an `f64` with enough digits to read the same number back, and `null` for a number that is not finite: a
//! clearance where there is no foundation, or a difference relative to zero.
//!
//! Types whose fields are the same here as in the library are serialised there. This module contains what the contract orders or
//! names differently.

use palkki::adaptive::{End, Trial};
use palkki::certificate::{Certificate, Violation};
use palkki::route::Status;
use palkki::state::{Contact, Extremes, Nodes, Pressure, Regime, Standing, SupportForce, Touch};
use palkki::sweep::{AtPlace, Envelope, Event};
use palkki::theory::FreeSpan;
use serde::Serialize;

use super::answer::Answer;
use super::certify::Finding;
use super::compare::{Comparison, Difference};
use super::input::Input;
use super::local::Local;
use super::sweep::{Stopped, SweptRow};

/// Grids with more intervals are printed without their nodes, unless these are requested.
pub(super) const MOST_INTERVALS_WITH_NODES: usize = 10_000;

/// The output about the scene itself.
#[derive(Debug, Serialize)]
pub(super) struct SceneObject<'a> {
    pub(super) scene: &'a str,
    /// Warnings about the scene that do not prevent an answer.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    pub(super) warnings: &'a [String],
}

impl<'a, M> From<&'a Input<M>> for SceneObject<'a> {
    fn from(input: &'a Input<M>) -> Self {
        Self { scene: input.title(), warnings: input.warnings() }
    }
}

/// The answer of `solve`.
pub(super) fn solve(input: &Input, answer: &Answer, all_nodes: bool, local: &Local) -> String {
    #[derive(Debug, Serialize)]
    struct SolveObject<'a> {
        #[serde(flatten)]
        scene: SceneObject<'a>,
        #[serde(flatten)]
        route: RouteObject<'a>,
        /// Only for beam theory.
        #[serde(skip_serializing_if = "Option::is_none")]
        spans: Option<Vec<SpanObject>>,
        nodes: Option<&'a Nodes>,
        #[serde(flatten)]
        local: &'a Local,
    }
    let exact = answer.solution.exact.as_ref().filter(|_| answer.solution.has_answer());
    let spans = exact.map(|exact| exact.free_spans(input.scene.beam()).iter().map(SpanObject::from).collect());
    let few = answer.intervals.is_some_and(|intervals| intervals <= MOST_INTERVALS_WITH_NODES);
    let nodes = answer.nodes().filter(|_| few || all_nodes);
    let scene = SceneObject { scene: input.title(), warnings: &answer.warnings(input) };
    print(&SolveObject { scene, route: answer.into(), spans, nodes, local })
}

/// The result of `compare`.
pub(super) fn compare(input: &Input, comparison: &Comparison) -> String {
    #[derive(Debug, Serialize)]
    struct ComparisonObject<'a> {
        #[serde(flatten)]
        scene: SceneObject<'a>,
        intervals: usize,
        routes: Vec<ComparedObject<'a>>,
    }
    #[derive(Debug, Serialize)]
    struct ComparedObject<'a> {
        #[serde(flatten)]
        route: RouteObject<'a>,
        solver_error: Option<&'a Difference>,
        model_error: Option<&'a Difference>,
    }
    let routes = comparison.routes.iter().map(|compared| ComparedObject {
        route: (&compared.answer).into(),
        solver_error: compared.solver_error.as_ref(),
        model_error: compared.model_error.as_ref(),
    });
    print(&ComparisonObject { scene: input.into(), intervals: comparison.intervals, routes: routes.collect() })
}

/// The result of `certify`.
pub(super) fn certify(input: &Input, finding: &Finding) -> String {
    #[derive(Debug, Serialize)]
    struct FindingObject<'a> {
        #[serde(flatten)]
        scene: SceneObject<'a>,
        /// Only if the load was lumped at nodes.
        #[serde(skip_serializing_if = "Option::is_none")]
        intervals: Option<usize>,
        status: Status,
        reason: String,
        certificate: CertificateObject<'a>,
        violations: &'a [Violation],
    }
    // For forces from elsewhere, their own deflection may be far from the best one.
    let best_deflection_error = Some(finding.certificate.best_deflection_error);
    print(&FindingObject {
        scene: input.into(),
        intervals: finding.intervals,
        status: finding.verdict.status,
        reason: finding.verdict.to_string(),
        certificate: CertificateObject { best_deflection_error, ..CertificateObject::of(&finding.certificate, None) },
        violations: &finding.violations,
    })
}

/// The result of `sweep`: the varied number, its values with their answers, and the events.
pub(super) fn sweep<'a>(
    scene: SceneObject<'a>,
    vary: &str,
    rows: &'a [SweptRow],
    events: &[Event],
    envelope: Option<&Envelope>,
    stopped: Option<&Stopped>,
) -> String {
    #[derive(Debug, Serialize)]
    struct SweepObject<'a> {
        #[serde(flatten)]
        scene: SceneObject<'a>,
        vary: &'a str,
        rows: Vec<RowObject<'a>>,
        events: &'a [Event],
        #[serde(skip_serializing_if = "Option::is_none")]
        envelope: Option<&'a Envelope>,
        /// Only if the sweep is incomplete.
        #[serde(skip_serializing_if = "Option::is_none")]
        stopped: Option<&'a Stopped>,
    }
    #[derive(Debug, Serialize)]
    struct RowObject<'a> {
        value: f64,
        #[serde(flatten)]
        route: RouteObject<'a>,
        /// Only with `--at`.
        #[serde(skip_serializing_if = "<[_]>::is_empty")]
        at: &'a [AtPlace],
    }
    let row = |row: &'a SweptRow| RowObject { value: row.value, route: (&row.answer).into(), at: &row.at };
    let rows = rows.iter().map(row).collect();
    print(&SweepObject { scene, vary, rows, events, envelope, stopped })
}

/// The version of the keys and their meaning. It changes when a key is removed or changes its meaning.
const VERSION: u32 = 1;

pub(super) fn print(value: &impl Serialize) -> String {
    #[derive(Debug, Serialize)]
    struct Versioned<'a, T> {
        version: u32,
        #[serde(flatten)]
        value: &'a T,
    }
    // Structs of numbers and texts cannot fail to serialise.
    serde_json::to_string_pretty(&Versioned { version: VERSION, value }).unwrap_or_default() + "\n"
}

/// The fields that `solve` and each route of `compare` have in common: method, verdict and results.
#[derive(Debug, Serialize)]
pub(super) struct RouteObject<'a> {
    method: &'a str,
    solver: &'a str,
    intervals: Option<usize>,
    status: Status,
    /// The error bound of the deflection, or any other flaw.
    reason: String,
    solver_status: &'a str,
    residual: f64,
    regime: Regime,
    unknowns: usize,
    iterations: usize,
    seconds: f64,
    reactions: EndsObject,
    supports: &'a [SupportForce],
    /// For a beam that its supports do not hold: `resultant`, `margin`, and `motion` if its position is not determined.
    #[serde(flatten)]
    standing: Option<Standing>,
    contacts: Vec<ContactObject>,
    /// Only if the beam touches the foundation somewhere without pressing.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    touches: &'a [Touch],
    contact_force: f64,
    deflection: DeflectionObject,
    moment: Extremes,
    energy: f64,
    /// Only for an elastic foundation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pressure: Option<Pressure>,
    certificate: Option<CertificateObject<'a>>,
    /// The search for the grid; present if a tolerance was given and no grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    refinement: Option<GridsObject<'a>>,
}

impl<'a> From<&'a Answer> for RouteObject<'a> {
    fn from(answer: &'a Answer) -> Self {
        let (solution, state, verdict) = (&answer.solution, &answer.solution.state, &answer.solution.verdict);
        Self {
            method: answer.method,
            solver: answer.solver,
            intervals: answer.intervals,
            status: verdict.status,
            reason: answer.reason(),
            solver_status: &solution.run.message,
            residual: solution.residual,
            regime: state.regime,
            unknowns: solution.unknowns,
            iterations: solution.run.iterations,
            seconds: answer.seconds,
            reactions: EndsObject::of(answer.length, &state.supports, |i| state.supports[i].force),
            supports: &state.supports,
            standing: state.standing,
            contacts: state.contacts.iter().map(ContactObject::from).collect(),
            touches: &state.touches,
            contact_force: state.contact_force(),
            deflection: (&state.deflection).into(),
            moment: state.moment,
            energy: state.energy,
            pressure: state.pressure,
            certificate: verdict.certificate.as_ref().map(|c| CertificateObject::of(c, c.moments_beside(state))),
            refinement: answer.grids.as_ref().map(|grids| GridsObject {
                tolerance: grids.demanded,
                reached: grids.end == End::Reached,
                end: grids.end.to_string(),
                error: verdict.largest_error(),
                seconds: grids.seconds,
                grids: grids.trials.iter().map(|(trial, seconds)| GridObject { trial, seconds: *seconds }).collect(),
            }),
        }
    }
}

/// One number each for the supports at the two ends of the beam; `null` where there is no support.
#[derive(Debug, Serialize)]
pub(super) struct EndsObject {
    left: Option<f64>,
    right: Option<f64>,
}

impl EndsObject {
    /// Selects from one number for each support.
    pub(super) fn of(length: f64, supports: &[SupportForce], number: impl Fn(usize) -> f64) -> Self {
        #[expect(clippy::float_cmp, reason = "a support at an end is exactly there")]
        let at = |end: f64| supports.iter().position(|support| support.at == end).map(&number);
        Self { left: at(0.0), right: at(length) }
    }
}

/// A contact, or the derivatives of its numbers.
#[derive(Debug, Serialize)]
pub(super) struct ContactObject {
    from: f64,
    to: f64,
    pub(super) force: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_from: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_to: Option<f64>,
}

impl ContactObject {
    pub(super) fn new(from: f64, to: f64, force: f64, end_forces: Option<[f64; 2]>) -> Self {
        let [force_from, force_to] = end_forces.map_or([None, None], |ends| ends.map(Some));
        Self { from, to, force, force_from, force_to }
    }
}

impl From<&Contact> for ContactObject {
    fn from(&Contact { from, to, force, end_forces }: &Contact) -> Self {
        Self::new(from, to, force, end_forces)
    }
}

/// A span without contact; `clearance` is `null` where there is no foundation.
#[derive(Debug, Serialize)]
struct SpanObject {
    from: f64,
    to: f64,
    length: f64,
    clearance: Option<LargestObject>,
    position: Option<f64>,
    moment: RangeObject,
}

#[derive(Debug, Serialize)]
struct LargestObject {
    max: f64,
    at: f64,
}

#[derive(Debug, Serialize)]
struct RangeObject {
    max: f64,
    min: f64,
}

impl From<&FreeSpan> for SpanObject {
    fn from(&FreeSpan { from, to, clearance, position, moment }: &FreeSpan) -> Self {
        let clearance = clearance.map(|clearance| LargestObject { max: clearance.max, at: clearance.max_at });
        let moment = RangeObject { max: moment.max, min: moment.min };
        Self { from, to, length: to - from, clearance, position, moment }
    }
}

/// Extremes of the deflection, where the position of the largest value is called `at`.
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
struct GridsObject<'a> {
    tolerance: f64,
    reached: bool,
    end: String,
    error: f64,
    seconds: f64,
    grids: Vec<GridObject<'a>>,
}

/// A grid that was tried. `error` is its largest error bound, over the largest value of that quantity, and `null` if there is none.
#[derive(Debug, Serialize)]
struct GridObject<'a> {
    #[serde(flatten)]
    trial: &'a Trial,
    seconds: f64,
}

/// Two-sided bounds; `null` where there is none.
#[derive(Debug, Serialize)]
struct CertificateObject<'a> {
    energy_lower: f64,
    energy_upper: f64,
    gap: f64,
    deflection_error: f64,
    deflection_error_at: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    best_deflection_error: Option<f64>,
    /// Brackets of the reactions, from left to right.
    supports: &'a [Option<[f64; 2]>],
    contact_force: Option<[f64; 2]>,
    deflection_max: Option<[f64; 2]>,
    /// Only for beam theory.
    #[serde(flatten)]
    moments: Option<MomentsObject>,
    /// The position about which the beam can rotate, only if the deflection is known up to a rotation.
    #[serde(skip_serializing_if = "Option::is_none")]
    up_to_a_turn: Option<f64>,
    stiffness: Option<[f64; 2]>,
    /// Present only if no contact list was proven to be that of the beam.
    #[serde(skip_serializing_if = "Option::is_none")]
    coarse: Option<bool>,
}

#[derive(Debug, Serialize)]
struct MomentsObject {
    moment_max: Option<[f64; 2]>,
    moment_min: Option<[f64; 2]>,
}

impl<'a> CertificateObject<'a> {
    /// The fields of a certificate, with brackets of the moments if there are any.
    fn of(certificate: &'a Certificate, moments: Option<[Option<[f64; 2]>; 2]>) -> Self {
        Self {
            energy_lower: certificate.energy_lower,
            energy_upper: certificate.energy_upper,
            gap: certificate.gap,
            deflection_error: certificate.deflection_error,
            deflection_error_at: certificate.deflection_error_at,
            best_deflection_error: None,
            supports: &certificate.reactions,
            contact_force: certificate.contact_force,
            deflection_max: certificate.deflection_max,
            moments: moments.map(|[moment_max, moment_min]| MomentsObject { moment_max, moment_min }),
            up_to_a_turn: certificate.up_to_a_turn,
            stiffness: certificate.stiffness,
            coarse: (!certificate.contacts_proven).then_some(true),
        }
    }
}
