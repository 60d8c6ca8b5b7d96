//! Every route at the extremes of sizes, units and regimes, beside references that solve nothing.

use palkki::route::Solution;
use palkki_evidence::extremes::{Extreme, Known, POWERS, borders, deep, sizes, units};

use crate::report::evidence::prelude::*;
use crate::report::evidence::verdict_map::{self, Tone};

/// What beam theory is held to, over the load.
const DIGITS: f64 = 1e-12;
/// How far two solved answers to one quadratic program may be apart, over the load: what a residual of 10⁻⁹ leaves of nodal
/// forces, see [`palkki::certificate::CERTIFIED_RESIDUAL`].
const SAME: f64 = 1e-6;
/// Grids on flat ground of every depth: the fewest intervals, odd and even ones, one more than the paper's.
const GRIDS: [usize; 5] = [2, 3, 5, 8, 31];
/// The finest grid on which NSOR runs: on finer ones most runs use up their budget, which other pages show.
const NSOR: usize = 8;
/// What the row of beam theory is called.
const THEORY: &str = "grid-free";
/// The group of the map.
const DEPTHS: &str = "depths";

/// How many runs are right, not solved, and wrong though called solved.
type Count = [usize; 3];
const RIGHT: Count = [1, 0, 0];
const NOT_SOLVED: Count = [0, 1, 0];
const WRONG: Count = [0, 0, 1];

/// All runs of a solver on one scene.
struct Row {
    group: &'static str,
    scene: String,
    authority: &'static str,
    solver: &'static str,
    count: Count,
}

fn sum(counts: impl IntoIterator<Item = Count>) -> Count {
    counts.into_iter().fold(Count::default(), |sum, count| std::array::from_fn(|k| sum[k] + count[k]))
}

pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut rows = Vec::new();
    for power in POWERS {
        rows.extend(tried(DEPTHS, &deep(power)?, &GRIDS)?);
    }
    let in_units = units()?.into_iter().map(|(_, extreme)| extreme).collect();
    let groups = [("sizes", sizes()?), ("borders", borders()?), ("units", in_units)];
    let scenes: usize = groups.iter().map(|(_, extremes)| extremes.len()).sum();
    let names = std::iter::once(DEPTHS).chain(groups.each_ref().map(|(group, _)| *group)).collect::<Vec<_>>();
    for (group, extremes) in groups {
        for extreme in extremes {
            rows.extend(tried(group, &extreme, &[extreme.intervals])?);
        }
    }
    let count = sum(rows.iter().map(|row| row.count));
    let header = ["group", "scene", "reference", "solver", "right", "not_solved", "wrong_and_solved"];
    let data = Table::new(header).rows(rows.iter().map(|row| {
        let [right, not_solved, wrong] = row.count;
        row![row.group, row.scene, row.authority, row.solver, right, not_solved, wrong]
    }));
    let values = context! {
        digits => bound(DIGITS),
        same => bound(SAME),
        runs => count.iter().sum::<usize>(),
        wrong => count[2],
        nsor => NSOR,
        grids => GRIDS,
        scenes,
        decades => POWERS[POWERS.len() - 1] - POWERS[0],
        table => table(&rows, &names),
    };
    Evidence::new(values).figures([drawn(study, &rows, count[2], data)?])
}

/// Runs every solver with every method on some grids of one scene, and beam theory.
fn tried(group: &'static str, extreme: &Extreme, grids: &[usize]) -> Result<Vec<Row>, Cause> {
    let row = |solver, count| Row { group, scene: extreme.name.clone(), authority: extreme.authority, solver, count };
    let mut rows = vec![row(THEORY, exact(extreme)?)];
    for solver in Solver::ALL {
        let finest = if solver == Solver::Nsor { NSOR } else { usize::MAX };
        let mut grids: Vec<usize> = grids.iter().map(|&intervals| intervals.min(finest)).collect();
        grids.dedup();
        let mut verdicts = Vec::new();
        for intervals in grids {
            let extreme = Extreme { intervals, ..extreme.clone() };
            for method in Method::ALL {
                verdicts.push(checked(&extreme, method, solver)?);
            }
        }
        rows.push(row(solver.name(), sum(verdicts)));
    }
    Ok(rows)
}

/// A run of a discretised route, and what it is beside the active set on the same quadratic program.
fn checked(extreme: &Extreme, method: Method, solver: Solver) -> Result<Count, Cause> {
    let run = |solver| -> Result<Solution<()>, Cause> { on_grid(&extreme.scene, method, solver, extreme.intervals) };
    let outcome = run(solver)?;
    if !outcome.solved {
        return Ok(NOT_SOLVED);
    }
    let reference = run(Solver::ActiveSet)?;
    let known = Known {
        reactions: [reference.state.reactions.left, reference.state.reactions.right],
        contact_force: reference.state.contact_force(),
        energy: None,
    };
    let beside = Extreme { known, ..extreme.clone() };
    let same = !reference.solved || beside.error(&outcome.state) <= SAME;
    let near = extreme.error(&outcome.state) <= extreme.allowance();
    Ok(if same && near { RIGHT } else { WRONG })
}

/// Beam theory.
fn exact(extreme: &Extreme) -> Result<Count, Cause> {
    let exact = theory::solve(&extreme.scene)?;
    if !exact.solved {
        return Ok(NOT_SOLVED);
    }
    let right = extreme.error(&exact.state) <= DIGITS && extreme.energy_error(exact.state.energy) <= DIGITS;
    Ok(if right { RIGHT } else { WRONG })
}

/// The names of the rows of map and table.
fn solvers() -> impl Iterator<Item = &'static str> {
    Solver::ALL.into_iter().map(Solver::name).chain([THEORY])
}

/// Of each solver and each group, how many runs are right.
fn table(rows: &[Row], groups: &[&str]) -> Table {
    let header = ["solver"].into_iter().chain(groups.iter().copied()).chain(["wrong and solved"]);
    Table::new(header).rows(solvers().map(|solver| {
        let of = |group| sum(rows.iter().filter(|row| row.solver == solver && row.group == group).map(|row| row.count));
        let cells = groups.iter().map(|group| format!("{} of {}", of(*group)[0], of(*group).iter().sum::<usize>()));
        let wrong: usize = groups.iter().map(|group| of(*group)[2]).sum();
        row![solver].into_iter().chain(cells).chain([wrong.to_string()]).collect::<Vec<_>>()
    }))
}

/// A cell says how many of its runs are not right; the worst of them gives its colour.
fn drawn(study: &Study<'_>, rows: &[Row], wrong: usize, data: Table) -> Result<Drawn, Cause> {
    let shown = |row: &Row| {
        let (tone, number) = match row.count {
            [_, _, wrong] if 0 < wrong => (Tone::Bad, wrong),
            [_, not_solved, _] if 0 < not_solved => (Tone::Fair, not_solved),
            _ => (Tone::Good, 0),
        };
        (tone, number.to_string())
    };
    let of =
        |power: usize, solver| rows.iter().filter(move |row| row.group == DEPTHS && row.solver == solver).nth(power);
    let cells = |power| solvers().filter_map(|solver| of(power, solver).map(shown)).collect();
    let map = POWERS.iter().enumerate().map(|(k, power)| (power_of_ten(*power), cells(k))).collect();
    let [from, to] = [POWERS[0], POWERS[POWERS.len() - 1]].map(power_of_ten);
    let words = study.words("extremes", context! { wrong, from, to })?;
    let svg = verdict_map::drawn(&words, solvers().map(str::to_owned).collect(), map)?;
    Ok(("extremes", svg, data))
}
