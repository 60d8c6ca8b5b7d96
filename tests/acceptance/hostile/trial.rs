//! One run of the whole program: text → scene → beam theory and one discretised route → certificates, and what must be true
//! of all of them together.
//!
//! Authorities that do not know each other: beam theory, guaranteed bounds (in interval arithmetic, from forces and scene
//! alone), the active set on the same grid, and the laws that every answer keeps (equilibrium, units).

use palkki::certificate::{CERTIFIED_RESIDUAL, Certificate, ContactLoad, Judged, certify};
use palkki::route::{Method, Outcome, Solver, Status};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::state::ContactState;
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, solve};

use super::draft::Draft;
use super::random::Random;
use super::scenes::Family;

/// Share of the forces to which a certified answer is in balance: what the judge of a discretised answer asks.
const BALANCE: f64 = 1e-9;

/// Share of the forces that the list of contacts leaves out: at most 1e-9 of them at each of 60 nodes.
const LISTED: f64 = 1e-7;

/// Share of the largest numbers to which two certified answers of one discrete problem agree. The residual of both is at
/// most 1e-9; forces are worse by the condition of the problem, on grids of up to [`MOST_INTERVALS`].
const SAME: f64 = 1e-4;

/// Share of the sizes that make up an energy, or of the largest deflection, that twelve digits of theory leave open.
const THEORY: f64 = 1e-9;

/// The least deflection that answers are measured by, as a share of what all forces together would cause: that of the judge,
/// sixteen units in the last place over what is certified.
const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

/// Intervals of the finest grid.
const MOST_INTERVALS: usize = 60;

/// What became of one run.
#[derive(Debug, Default)]
pub(crate) struct Trial {
    /// True if the text is a scene.
    pub(crate) accepted: bool,
    /// Verdict on beam theory, if it has an answer.
    pub(crate) exact: Option<Status>,
    /// Whether the program calls it certified in the end: its bounds are finite, and its deflection is that of its contacts.
    pub(crate) bounded: bool,
    /// Verdict on the reference on the same grid, force method or finite differences with the active set.
    pub(crate) reference: Option<Status>,
    /// Verdict on another route on that grid.
    pub(crate) route: Option<Status>,
    /// True if the route's solver says that it succeeded and the judge does not.
    pub(crate) contradicted: bool,
    /// Lists of contacts that theory tried, and iterations of the routes: the most.
    pub(crate) work: [usize; 2],
    /// What is wrong. Empty, or the program is.
    pub(crate) wrong: Vec<String>,
}

/// The draft of a run.
pub(crate) fn draft(seed: u64) -> (Family, Draft, Random) {
    let mut random = Random::new(seed);
    let family = random.pick(&Family::ALL);
    let draft = family.draft(&mut random);
    (family, draft, random)
}

fn read(text: &str) -> Option<Scene> {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).ok()
}

/// Run number `seed`.
pub(crate) fn run(seed: u64) -> (Family, Trial) {
    let (family, draft, mut random) = draft(seed);
    let mut trial = Trial::default();
    let Some(scene) = read(&draft.text()) else { return (family, trial) };
    trial.accepted = true;

    let exact = theory::solve(&scene).ok();
    let bounds = exact.as_ref().and_then(|exact| {
        trial.exact = Some(exact.status);
        trial.work[0] = exact.lists;
        let verdict = Verdict::of_exact(&scene, exact, &Demand::default());
        trial.bounded = verdict.status == Status::Certified;
        verdict.certificate
    });
    if let Some(exact) = exact.as_ref().filter(|exact| exact.status == Status::Certified) {
        balanced(&mut trial, "theory", &scene, &exact.state);
        if let Some(bounds) = &bounds {
            within(&mut trial, "theory", exact, bounds, &scene);
        }
    }

    let settings = settings(&mut random);
    let reference = Settings { solver: Solver::ActiveSet, method: same_optimum(settings.method), ..settings };
    let judged = |trial: &mut Trial, settings: &Settings| {
        let outcome = solve(&scene, settings).ok()?;
        let certificate = judge(trial, &scene, settings, &outcome, exact.as_ref());
        if let (Some(a), Some(b)) = (&bounds, &certificate) {
            overlap(trial, settings, a, b);
        }
        trial.contradicted |= outcome.solver_claims_success && outcome.status != Status::Certified;
        trial.work[1] = trial.work[1].max(outcome.iterations);
        Some(outcome)
    };
    let other = judged(&mut trial, &reference);
    trial.reference = other.as_ref().map(|outcome| outcome.status);
    if settings != reference
        && let Some(outcome) = judged(&mut trial, &settings)
    {
        trial.route = Some(outcome.status);
        if let Some(other) = other.as_ref().filter(|_| outcome.status == Status::Certified) {
            same(&mut trial, &settings, &scene, &outcome.state, other);
        }
    }
    if random.once_in(8) {
        in_other_units(&mut trial, &draft, &scene, exact.as_ref(), &reference, &mut random);
    }
    (family, trial)
}

/// The method that has the same optimum as this one, and the best conditioned programme.
fn same_optimum(method: Method) -> Method {
    if method == Method::Complementarity { method } else { Method::Force }
}

fn settings(random: &mut Random) -> Settings {
    let method = random.pick(&Method::ALL);
    let solver = random.pick(&[
        Solver::ActiveSet,
        Solver::ActiveSet,
        Solver::ActiveSet,
        Solver::FourStep,
        Solver::Clarabel,
        Solver::Clarabel,
        Solver::Osqp,
        Solver::Nsor,
    ]);
    // Iterations of these two can be very many.
    let most = if matches!(solver, Solver::Osqp | Solver::Nsor) { 12 } else { MOST_INTERVALS };
    Settings::new(method, solver, 2 + random.below(most - 1))
}

/// Deflection in the middle by a force of one there, `l³/48EI`.
fn flexibility(scene: &Scene) -> f64 {
    let length = scene.beam().length();
    length / scene.beam().bending_stiffness() * length * length / 48.0
}

/// Forces and deflections of a state, as sizes. Without loads it is the depth of the foundation that sets them, as it does for
/// the judge; and a beam that cannot move has a deflection of rounding.
fn sizes(scene: &Scene, state: &ContactState) -> (f64, f64) {
    let contacts: f64 = state.contacts.iter().map(|c| c.force.abs()).sum();
    let reactions = state.reactions.left.abs() + state.reactions.right.abs();
    let load = scene.load().magnitude(scene.beam().length());
    let deflection = state.deflection.max.abs().max(state.deflection.min.abs());
    let idle = match scene.foundation() {
        Some(foundation) if load == 0.0 => foundation.magnitude(scene.beam().length()),
        _ => 0.0,
    };
    let force = load.max(contacts).max(reactions).max(idle / flexibility(scene));
    (force, deflection.max(idle).max(ROUNDING * flexibility(scene) * force))
}

fn forces(scene: &Scene, state: &ContactState) -> f64 {
    sizes(scene, state).0
}

/// True also for what is no number.
fn exceeds(value: f64, limit: f64) -> bool {
    value.is_nan() || limit < value
}

/// A certified state consists of numbers, and its forces are in balance.
fn balanced(trial: &mut Trial, who: &str, scene: &Scene, state: &ContactState) {
    let ContactState { reactions, deflection, moment, energy, .. } = state;
    let numbers = [reactions.left, reactions.right, deflection.max, deflection.min, moment.max, moment.min, *energy];
    let contacts = state.contacts.iter().flat_map(|c| [c.from, c.to, c.force]);
    if !numbers.into_iter().chain(contacts).all(f64::is_finite) {
        trial.wrong.push(format!("{who}: certified, but not all numbers: {numbers:?}"));
    }
    let load = scene.load().resultant(scene.beam().length());
    // The list of contacts leaves out forces that are next to nothing; at the nodes they are all there.
    let contact = state.nodes.as_ref().map_or_else(|| state.contact_force(), |nodes| nodes.contact_force.iter().sum());
    let rest = load - reactions.left - reactions.right - contact;
    let size = forces(scene, state);
    if exceeds(rest.abs(), BALANCE * size) {
        trial.wrong.push(format!("{who}: certified, but {rest:e} of {size:e} is not in balance"));
    }
    let listed = (contact - state.contact_force()).abs();
    if exceeds(listed, LISTED * size) {
        trial.wrong.push(format!("{who}: certified, but contacts of {listed:e} of {size:e} are not listed"));
    }
    let outside = |c: &palkki::state::Contact| !(0.0 <= c.from && c.from <= c.to && c.to <= scene.beam().length());
    if state.contacts.iter().any(outside) {
        trial.wrong.push(format!("{who}: certified, but a contact is not on the beam"));
    }
    if state.contacts.iter().any(|c| c.force < -BALANCE * size) {
        trial.wrong.push(format!("{who}: certified, but a contact pulls"));
    }
}

/// Sizes of the terms that an energy is the sum of.
fn energy_size(scene: &Scene, state: &ContactState) -> f64 {
    let (force, deflection) = sizes(scene, state);
    let depth = scene.foundation().map_or(0.0, |f| {
        state.contacts.iter().map(|c| f.depth(c.from).abs().max(f.depth(c.to).abs())).fold(0.0, f64::max)
    });
    force * deflection.max(depth)
}

/// The energy of a certified theory lies within guaranteed bounds.
fn within(trial: &mut Trial, who: &str, exact: &Exact, bounds: &Certificate, scene: &Scene) {
    let (energy, slack) = (exact.state.energy, THEORY * energy_size(scene, &exact.state));
    if bounds.energy_upper < energy - slack || energy + slack < bounds.energy_lower {
        let (lower, upper) = (bounds.energy_lower, bounds.energy_upper);
        trial.wrong.push(format!("{who}: J = {energy:e} of theory is not between {lower:e} and {upper:e}"));
    }
}

/// Bounds of two certificates for one scene hold for the same number.
fn overlap(trial: &mut Trial, settings: &Settings, a: &Certificate, b: &Certificate) {
    if a.energy_upper < b.energy_lower || b.energy_upper < a.energy_lower {
        let brackets = [a.energy_lower, a.energy_upper, b.energy_lower, b.energy_upper];
        trial.wrong.push(format!("{}: bounds exclude each other: {brackets:?}", name(settings)));
    }
}

/// A discretised answer against its own certificate and theory.
fn judge(
    trial: &mut Trial,
    scene: &Scene,
    settings: &Settings,
    outcome: &Outcome,
    exact: Option<&Exact>,
) -> Option<Certificate> {
    let who = name(settings);
    if outcome.status == Status::Certified {
        balanced(trial, &who, scene, &outcome.state);
    }
    let nodes = outcome.state.nodes.as_ref()?;
    let forces = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied());
    let load = ContactLoad::new(scene.beam().length(), forces).ok()?;
    let certificate = certify(scene, &load, Judged::Nodes(nodes)).ok()?;
    if certificate.gap < 0.0 || certificate.energy_upper < certificate.energy_lower {
        trial.wrong.push(format!("{who}: bounds are upside down: {certificate:?}"));
    }
    if let Some(exact) = exact.filter(|exact| exact.status == Status::Certified) {
        within(trial, &who, exact, &certificate, scene);
        let (_, size) = sizes(scene, &exact.state);
        for (x, v) in nodes.x.iter().zip(&nodes.deflection) {
            let difference = (v - exact.deflection(*x)).abs();
            if certificate.deflection_error + THEORY * size.max(v.abs()) < difference {
                let bound = certificate.deflection_error;
                trial.wrong.push(format!("{who}: off by {difference:e} at {x}, guaranteed are {bound:e}"));
                break;
            }
        }
    }
    Some(certificate)
}

/// Two certified answers to one discrete problem.
fn same(trial: &mut Trial, settings: &Settings, scene: &Scene, state: &ContactState, reference: &Outcome) {
    if reference.status != Status::Certified {
        return;
    }
    let other = &reference.state;
    let (force, size) = sizes(scene, other);
    let off =
        (state.reactions.left - other.reactions.left).abs().max((state.reactions.right - other.reactions.right).abs());
    if exceeds(off, SAME * force) {
        trial.wrong.push(format!("{}: certified, but reactions are off by {:e}", name(settings), off / force));
    }
    let (Some(a), Some(b)) = (&state.nodes, &other.nodes) else { return };
    let off = a.deflection.iter().zip(&b.deflection).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    if exceeds(off, SAME * size) {
        trial.wrong.push(format!("{}: certified, but deflections are off by {:e}", name(settings), off / size));
    }
}

/// The same bits in units that are powers of two, where neither scene leaves the range of 64-bit floating point on the way.
fn in_other_units(
    trial: &mut Trial,
    draft: &Draft,
    scene: &Scene,
    exact: Option<&Exact>,
    settings: &Settings,
    random: &mut Random,
) {
    let mut unit = || random.pick(&[0.25, 8.0, 1024.0, 0.000_976_562_5]);
    let (length, force, depth) = (unit(), unit(), unit());
    let there = draft.in_units(length, force, depth);
    let back = there.in_units(1.0 / length, 1.0 / force, 1.0 / depth);
    // Subnormal numbers lose bits on the way.
    if back.text() != draft.text() {
        return;
    }
    let Some(other) = read(&there.text()) else { return };
    let exactly_scaled = scene.scaled().ok().zip(other.scaled().ok()).is_some_and(|(a, b)| a.scene == b.scene);
    if !exactly_scaled {
        return;
    }
    let bits = |state: &ContactState, unit: f64| {
        [state.reactions.left, state.reactions.right, state.contact_force()].map(|f| (f * unit).to_bits())
    };
    let mut compare = |who: &str, a: (&ContactState, Status), b: (&ContactState, Status)| {
        let subnormal = |state: &ContactState| {
            let c = state.contacts.iter().map(|c| c.force);
            [state.reactions.left, state.reactions.right].into_iter().chain(c).any(f64::is_subnormal)
        };
        if subnormal(a.0) || subnormal(b.0) {
            return;
        }
        if a.1 != b.1 || bits(a.0, force) != bits(b.0, 1.0) {
            trial.wrong.push(format!("{who}: other units, other bits"));
        }
    };
    if let (Some(a), Ok(b)) = (exact, theory::solve(&other)) {
        compare("theory", (&a.state, a.status), (&b.state, b.status));
    }
    if let (Ok(a), Ok(b)) = (solve(scene, settings), solve(&other, settings)) {
        compare(&name(settings), (&a.state, a.status), (&b.state, b.status));
    }
}

fn name(settings: &Settings) -> String {
    format!("{}/{}, {} intervals", settings.method, settings.solver, settings.intervals)
}
