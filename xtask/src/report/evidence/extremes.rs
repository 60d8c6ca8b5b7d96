//! Every route at the extremes of sizes, units and regimes, judged by authorities that solve nothing.

mod cases;
mod maps;

use palkki::extremes::{Extreme, POWERS, borders, sizes, units};
use palkki::route::{Method, Outcome, Solver, Status};
use palkki::{Settings, solve, theory};
use serde::Serialize;

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers;
use crate::report::study::Study;

/// What beam theory is held to, over the load.
const DIGITS: f64 = 1e-12;
/// How far two certified answers to one programme may be apart, over the load: what a residual of 10⁻⁹ leaves of nodal
/// forces, see [`palkki::certificate::CERTIFIED_RESIDUAL`].
const SAME: f64 = 1e-6;

#[derive(Debug, Serialize)]
struct Values {
    digits: String,
    same: String,
    judged: usize,
    wrong: usize,
    nsor: usize,
    decades: i32,
    maps: Vec<maps::Map>,
    waves: maps::Waves,
    cases: usize,
    exact: Count,
    force: Count,
    groups: Vec<cases::Group>,
    hardest: Vec<cases::Row>,
    /// The least power of ten of the map at which beam theory is certified.
    shallowest: i32,
    force_limits: Vec<String>,
}

/// How many runs ended how.
#[derive(Debug, Clone, Copy, Default, Serialize)]
struct Count {
    right: usize,
    labelled: usize,
    wrong: usize,
}

impl Count {
    fn add(&mut self, verdict: Verdict) {
        match verdict {
            Verdict::Right => self.right += 1,
            Verdict::Labelled => self.labelled += 1,
            Verdict::Wrong => self.wrong += 1,
        }
    }

    fn join(&mut self, other: Self) {
        self.right += other.right;
        self.labelled += other.labelled;
        self.wrong += other.wrong;
    }

    fn runs(&self) -> usize {
        self.right + self.labelled + self.wrong
    }
}

/// What a run turned out to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    Right,
    Labelled,
    Wrong,
}

impl Verdict {
    fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Labelled => "labelled",
            Self::Wrong => "wrong and certified",
        }
    }
}

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let mut evidence_files = Vec::new();
    let mut maps = Vec::new();
    let (mut judged, mut wrong) = (0, 0);
    for method in Method::ALL {
        let (map, svg, csv) = maps::depth_against_grid(method)?;
        (judged, wrong) = (judged + map.runs, wrong + map.wrong);
        evidence_files.push((format!("extremes-{method}"), svg, csv));
        maps.push(map);
    }
    let (waves, svg, csv) = maps::amplitude_against_depth()?;
    evidence_files.push(("extremes-exact".to_owned(), svg, csv));
    let in_units = units()?.into_iter().map(|(_, extreme)| extreme).collect();
    let tried = cases::tried(vec![("sizes", sizes()?), ("borders", borders()?), ("units", in_units)])?;
    judged += waves.runs + tried.runs;
    wrong += tried.wrong;
    let values = Values {
        digits: numbers::bound(DIGITS),
        same: numbers::bound(SAME),
        judged,
        wrong,
        nsor: NSOR,
        decades: POWERS[POWERS.len() - 1] - POWERS[0],
        maps,
        shallowest: waves.shallowest,
        waves,
        cases: tried.cases,
        exact: tried.exact,
        force: tried.force,
        groups: tried.groups,
        hardest: tried.hardest,
        force_limits: tried.force_limits,
    };
    let mut evidence = Evidence::new(values).data("extremes", tried.csv);
    for (name, svg, csv) in evidence_files {
        evidence = evidence.figure(&name, svg, csv);
    }
    Ok(evidence)
}

/// The finest grid on which NSOR runs: on finer ones most runs use up a budget of seconds, which other chapters show.
const NSOR: usize = 8;

/// A run of a discretised route, and what it is beside the active set on the same programme.
fn judged(extreme: &Extreme, method: Method, solver: Solver, reference: &Outcome) -> Result<Verdict, Cause> {
    let outcome = solve(&extreme.scene, &Settings::new(method, solver, extreme.intervals))?;
    if outcome.status != Status::Certified {
        return Ok(Verdict::Labelled);
    }
    let beside = Extreme {
        truth: palkki::extremes::Truth {
            reactions: [reference.state.reactions.left, reference.state.reactions.right],
            contact_force: reference.state.contact_force(),
            energy: None,
        },
        ..extreme.clone()
    };
    let same = reference.status != Status::Certified || beside.error(&outcome.state) <= SAME;
    let near = extreme.error(&outcome.state) <= extreme.allowance();
    Ok(if same && near { Verdict::Right } else { Verdict::Wrong })
}

/// The active set on the same programme.
fn reference(extreme: &Extreme, method: Method) -> Result<Outcome, Cause> {
    Ok(solve(&extreme.scene, &Settings::new(method, Solver::ActiveSet, extreme.intervals))?)
}

/// Beam theory, with its error where it is certified.
fn exact(extreme: &Extreme) -> Result<(Verdict, f64), Cause> {
    let exact = theory::solve(&extreme.scene)?;
    let error = extreme.error(&exact.state);
    if exact.status != Status::Certified {
        return Ok((Verdict::Labelled, 0.0));
    }
    let right = error <= DIGITS && extreme.energy_error(exact.state.energy) <= DIGITS;
    Ok((if right { Verdict::Right } else { Verdict::Wrong }, error))
}
