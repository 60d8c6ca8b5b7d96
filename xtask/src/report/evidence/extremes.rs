//! Every route at the extremes of sizes, units and regimes, beside references that solve nothing.

mod map;

use palkki::route::RawSolution;
use palkki_evidence::extremes::{Extreme, POWERS, borders, sizes, units};

use super::prelude::*;

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

    fn of<'a>(counts: impl IntoIterator<Item = &'a Self>) -> Self {
        let mut sum = Self::default();
        counts.into_iter().for_each(|count| sum.join(*count));
        sum
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
    fn name(self) -> &'static str {
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
    let tried = tried(vec![("sizes", sizes()?), ("borders", borders()?), ("units", in_units)])?;
    let mut count = map.count;
    count.join(tried.count);
    let values = context! {
        digits => bound(DIGITS),
        same => bound(SAME),
        runs => count.runs(),
        wrong => count.wrong,
        nsor => NSOR,
        decades => POWERS[POWERS.len() - 1] - POWERS[0],
        map => map.values,
        cases => tried.values,
    };
    Ok(Evidence::new(values).figure("extremes", map.svg, map.data).data("extremes-cases", tried.data))
}

/// The finest grid on which NSOR runs: on finer ones most runs use up a budget of seconds, which other pages show.
const NSOR: usize = 8;

/// A run of a discretised route, and what it is beside the active set on the same quadratic program.
fn checked(extreme: &Extreme, method: Method, solver: Solver, reference: &RawSolution) -> Result<Verdict, Cause> {
    let outcome = on_grid(&extreme.scene, method, solver, extreme.intervals)?;
    if !outcome.solved {
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
    let same = !reference.solved || beside.error(&outcome.state) <= SAME;
    let near = extreme.error(&outcome.state) <= extreme.allowance();
    Ok(if same && near { Verdict::Right } else { Verdict::Wrong })
}

/// The active set on the same quadratic program.
fn reference(extreme: &Extreme, method: Method) -> Result<RawSolution, Cause> {
    on_grid(&extreme.scene, method, Solver::ActiveSet, extreme.intervals)
}

/// Beam theory, with its error where it is certified.
fn exact(extreme: &Extreme) -> Result<(Verdict, f64), Cause> {
    let exact = theory::solve(&extreme.scene)?;
    let error = extreme.error(&exact.state);
    if !exact.solved {
        return Ok((Verdict::NotCertified, 0.0));
    }
    let right = error <= DIGITS && extreme.energy_error(exact.state.energy) <= DIGITS;
    Ok((if right { Verdict::Right } else { Verdict::Wrong }, error))
}

/// Errors below this differ between machines.
const ROUNDING: f64 = 1e-13;

/// Everything that was tried.
struct Tried {
    count: Count,
    values: Value,
    data: Table,
}

/// What became of one scene: by beam theory, by the force method with the active set, by the other routes.
struct Case {
    theory: Verdict,
    theory_error: f64,
    force: Verdict,
    others: Count,
    /// The other routes whose answers are not certified.
    not_certified: Vec<String>,
}

/// Runs every route on every scene.
fn tried(groups: Vec<(&'static str, Vec<Extreme>)>) -> Result<Tried, Cause> {
    let header = ["group", "scenes", "beam theory: right", "its worst error", "force, active set: right"];
    let mut table = Table::new(header.into_iter().chain(["other routes: right", "not certified"]));
    let header = ["scene", "group", "reference", "exact", "force_active_set", "others_right", "others_not_certified"];
    let mut data = Table::new(header.into_iter().chain(["others_wrong_and_certified", "which_are_not_certified"]));
    let (mut force_limits, mut cases) = (Vec::new(), 0);
    let (mut all, mut all_theory, mut all_force) = (Count::default(), Count::default(), Count::default());
    for (name, extremes) in groups {
        let (mut theory, mut force, mut others) = (Count::default(), Count::default(), Count::default());
        let mut worst = 0.0_f64;
        cases += extremes.len();
        let scenes = extremes.len();
        for extreme in extremes {
            let case = run(&extreme)?;
            worst = worst.max(case.theory_error);
            theory.add(case.theory);
            force.add(case.force);
            others.join(case.others);
            let (theory, force, names) = (case.theory.name(), case.force.name(), case.not_certified.join(" "));
            let Count { right, not_certified, wrong } = case.others;
            data.push(row![extreme.name, name, extreme.authority, theory, force, right, not_certified, wrong, names]);
            if case.force == Verdict::NotCertified {
                force_limits.push(extreme.name);
            }
        }
        let error = bound(worst.max(ROUNDING));
        table.push(row![name, scenes, theory.right, error, force.right, others.right, others.not_certified]);
        all.join(Count::of([&theory, &force, &others]));
        all_theory.join(theory);
        all_force.join(force);
    }
    let values = context! {
        table,
        scenes => cases,
        theory => context! { right => all_theory.right, not_certified => all_theory.not_certified },
        force => context! { right => all_force.right, not_certified => all_force.not_certified },
        force_limits,
    };
    Ok(Tried { count: all, values, data })
}

/// Runs every route on one scene.
fn run(extreme: &Extreme) -> Result<Case, Cause> {
    let (theory, theory_error) = exact(extreme)?;
    let (mut force, mut others, mut not_certified) = (Verdict::NotCertified, Count::default(), Vec::new());
    for method in Method::ALL {
        let active = reference(extreme, method)?;
        for solver in Solver::ALL {
            let verdict = if solver == Solver::Nsor && NSOR < extreme.intervals {
                let coarse = Extreme { intervals: NSOR, ..extreme.clone() };
                checked(&coarse, method, solver, &reference(&coarse, method)?)?
            } else {
                checked(extreme, method, solver, &active)?
            };
            if method == Method::Force && solver == Solver::ActiveSet {
                force = verdict;
                continue;
            }
            others.add(verdict);
            if verdict == Verdict::NotCertified {
                not_certified.push(format!("{method}/{solver}"));
            }
        }
    }
    Ok(Case { theory, theory_error, force, others, not_certified })
}
