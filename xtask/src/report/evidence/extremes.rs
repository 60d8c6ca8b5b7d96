//! Every route at the extremes of sizes, units and regimes, beside references that solve nothing.

mod cases;
mod map;

use minijinja::context;
use palkki::route::{Method, Outcome, Solver, Status};
use palkki::{Settings, solve, theory};
use palkki_evidence::extremes::{Extreme, POWERS, borders, sizes, units};

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers;
use crate::report::study::Study;

/// What beam theory is held to, over the load.
const DIGITS: f64 = 1e-12;
/// How far two certified answers to one quadratic program may be apart, over the load: what a residual of 10⁻⁹ leaves of nodal
/// forces, see [`palkki::certificate::CERTIFIED_RESIDUAL`].
const SAME: f64 = 1e-6;

/// How many runs ended how.
#[derive(Debug, Clone, Copy, Default)]
struct Count {
    right: usize,
    not_certified: usize,
    wrong: usize,
}

impl Count {
    fn add(&mut self, verdict: Verdict) {
        match verdict {
            Verdict::Right => self.right += 1,
            Verdict::NotCertified => self.not_certified += 1,
            Verdict::Wrong => self.wrong += 1,
        }
    }

    fn join(&mut self, other: Self) {
        self.right += other.right;
        self.not_certified += other.not_certified;
        self.wrong += other.wrong;
    }

    fn runs(&self) -> usize {
        self.right + self.not_certified + self.wrong
    }
}

/// What a run turned out to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    Right,
    NotCertified,
    Wrong,
}

impl Verdict {
    fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::NotCertified => "not certified",
            Self::Wrong => "wrong and certified",
        }
    }
}

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let map = map::measured()?;
    let in_units = units()?.into_iter().map(|(_, extreme)| extreme).collect();
    let tried = cases::tried(vec![("sizes", sizes()?), ("borders", borders()?), ("units", in_units)])?;
    let mut count = map.count;
    count.join(tried.count);
    let values = context! {
        digits => numbers::bound(DIGITS),
        same => numbers::bound(SAME),
        runs => count.runs(),
        wrong => count.wrong,
        nsor => NSOR,
        decades => POWERS[POWERS.len() - 1] - POWERS[0],
        map => map.values,
        cases => tried.values,
    };
    Ok(Evidence::new(values).figure("extremes", map.svg, map.csv).data("extremes-cases", tried.csv))
}

/// The finest grid on which NSOR runs: on finer ones most runs use up a budget of seconds, which other pages show.
const NSOR: usize = 8;

/// A run of a discretised route, and what it is beside the active set on the same quadratic program.
fn checked(extreme: &Extreme, method: Method, solver: Solver, reference: &Outcome) -> Result<Verdict, Cause> {
    let outcome = solve(&extreme.scene, &Settings::new(method, solver, extreme.intervals))?;
    if outcome.status != Status::Certified {
        return Ok(Verdict::NotCertified);
    }
    let beside = Extreme {
        truth: palkki_evidence::extremes::Truth {
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

/// The active set on the same quadratic program.
fn reference(extreme: &Extreme, method: Method) -> Result<Outcome, Cause> {
    Ok(solve(&extreme.scene, &Settings::new(method, Solver::ActiveSet, extreme.intervals))?)
}

/// Beam theory, with its error where it is certified.
fn exact(extreme: &Extreme) -> Result<(Verdict, f64), Cause> {
    let exact = theory::solve(&extreme.scene)?;
    let error = extreme.error(&exact.state);
    if exact.status != Status::Certified {
        return Ok((Verdict::NotCertified, 0.0));
    }
    let right = error <= DIGITS && extreme.energy_error(exact.state.energy) <= DIGITS;
    Ok((if right { Verdict::Right } else { Verdict::Wrong }, error))
}
