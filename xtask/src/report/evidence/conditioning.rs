//! Forward error, residual, and what the condition number promises: every route on the example, against eighty digits.

mod routes;

use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};

use self::routes::{Grid, MATRIX, NAMES, Run};
use super::prelude::*;

/// The method of the figure: its matrix is banded and can be factorised on every grid.
const DRAWN: Method = Method::Complementarity;
/// The solver whose errors are tabled.
const ACTIVE_SET: &str = "active-set";
/// The solvers that iterate.
const ITERATIVE: [&str; 3] = ["nsor", "clarabel", "osqp"];

/// The grids of one method.
type Measured = (Method, Vec<Grid>);

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let all = Method::ALL.into_iter().map(|method| Ok((method, routes::measured(method)?)));
    let all = all.collect::<Result<Vec<Measured>, Cause>>()?;
    let drawn = all.iter().find(|(method, _)| *method == DRAWN).ok_or("the method of the figure is measured")?;
    let finest = drawn.1.iter().map(|grid| grid.intervals).max().unwrap_or_default();
    let passes = |grid: &&Grid| grid.run(MATRIX).is_some_and(|run| run.certified);
    let matrix_until = drawn.1.iter().take_while(passes).last().map_or(0, |grid| grid.intervals);
    let values = context! {
        table => table(&all, &drawn.1),
        method => DRAWN.name(),
        finest, matrix_until,
        active_set => context! {
            reaction => worst(&all, |run, _| Some(run.reaction)),
            deflection => worst(&all, |run, _| Some(run.deflection)),
            force => worst(&all, |run, grid| (grid.intervals < finest).then_some(run.contact_force)),
            force_finest => worst(&all, |run, grid| (grid.intervals == finest).then_some(run.contact_force)),
            promised => worst(&all, |run, grid| Some(run.promised(grid))),
        },
        iterative => iterative(&all)?,
    };
    Ok(Evidence::new(values).figure("conditioning", figure(&drawn.1)?, data(&all)))
}

/// The largest of some powers of ten of the active set.
fn worst(all: &[Measured], of: impl Fn(&Run, &Grid) -> Option<i32>) -> String {
    let grids = all.iter().flat_map(|(_, grids)| grids);
    let found = grids.filter_map(|grid| of(grid.run(ACTIVE_SET)?, grid));
    power_of_ten(found.max().unwrap_or_default())
}

/// The certified runs of iterative solvers, and the one of them with the worst contact force.
fn iterative(all: &[Measured]) -> Result<Value, Cause> {
    let runs = all.iter().flat_map(|(method, grids)| {
        grids.iter().flat_map(move |grid| grid.runs.iter().map(move |run| (method, grid, run)))
    });
    let runs: Vec<_> = runs.filter(|(_, _, run)| run.certified && ITERATIVE.contains(&run.name)).collect();
    let worst = runs.iter().max_by_key(|(_, grid, run)| (run.contact_force, std::cmp::Reverse(grid.intervals)));
    let most = |of: fn(&Run) -> i32| runs.iter().map(|(_, _, run)| of(run)).max().unwrap_or_default();
    let (method, grid, run) = worst.ok_or("some run of an iterative solver is certified")?;
    Ok(context! {
        certified => runs.len(),
        reaction => power_of_ten(most(|run| run.reaction)),
        deflection => power_of_ten(most(|run| run.deflection)),
        route => format!("{}, {method} method", run.name),
        intervals => grid.intervals,
        residual => power_of_ten(run.residual),
        error => power_of_ten(run.contact_force),
    })
}

/// Worst contact forces over the load: what residual and condition number promise, the factorised matrix, and the active set.
fn table(all: &[Measured], drawn: &[Grid]) -> Table {
    let methods = Method::ALL.map(|method| format!("active set, {method}"));
    let header = ["intervals", "cond(A)", "residual · cond(A)", "A factorised"].map(str::to_owned);
    let dash = || "–".to_owned();
    let rows = drawn.iter().enumerate().map(|(k, grid)| {
        let error = |run: Option<&Run>| run.map_or_else(dash, |run| power_of_ten(run.contact_force));
        let promised = grid.run(ACTIVE_SET).map_or_else(dash, |run| power_of_ten(run.promised(grid)));
        let row = [count(grid.intervals), power_of_ten(grid.condition), promised, error(grid.run(MATRIX))];
        let of_methods = all.iter().map(move |(_, grids)| error(grids.get(k).and_then(|grid| grid.run(ACTIVE_SET))));
        row.into_iter().chain(of_methods)
    });
    Table::new(header.into_iter().chain(methods)).rows(rows)
}

fn figure(grids: &[Grid]) -> Result<String, PlotError> {
    let y = Axis::new("error of a contact force over the load").log();
    let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(760.0);
    let line = |name: &str, of: fn(&Run, &Grid) -> i32| {
        // Answers of solvers count if they are certified; the matrix is no solver. No error counts for more than the whole load.
        let drawn = |grid: &Grid| grid.run(name).filter(|run| name == MATRIX || run.certified).map(|run| of(run, grid));
        let point = |grid: &Grid| Some([as_number(grid.intervals), ten_to(drawn(grid)?.min(0))]);
        grids.iter().filter_map(point).collect::<Vec<_>>()
    };
    for (i, name) in NAMES.into_iter().enumerate() {
        let points = line(name, |run, _| run.contact_force);
        panel = panel.with(Layer::Series { points, style: Style::of_series(i), label: name.to_owned() });
    }
    let points = line(ACTIVE_SET, Run::promised);
    let label = format!("residual · cond, {ACTIVE_SET}");
    panel = panel.with(Layer::Series { points, style: Style::theory(), label });
    Figure::new(
        "The factorised matrix loses digits with its condition number, the active set does not",
        "Finite differences: error of the worst contact force against eighty digits over the number of intervals, both axes \
         logarithmic, rounded up to powers of ten; one line for the certified answers of each solver, one for the factorised matrix, which rises with the \
         fourth power of the number of intervals, and dashed what residual times condition number promises for the active set.",
        vec![panel],
    )
    .svg()
}

fn data(all: &[Measured]) -> Table {
    let header = ["method", "solver", "intervals", "certified", "log10_condition", "log10_residual", "log10_promised"];
    let errors = ["log10_reaction_error", "log10_deflection_error", "log10_contact_force_error"];
    let rows = all.iter().flat_map(|(method, grids)| {
        grids.iter().flat_map(move |grid| {
            grid.runs.iter().map(move |run| {
                let Run { name, certified, residual, reaction, deflection, contact_force } = run;
                let (intervals, condition, promised) = (grid.intervals, grid.condition, run.promised(grid));
                row![
                    method,
                    name,
                    intervals,
                    certified,
                    condition,
                    residual,
                    promised,
                    reaction,
                    deflection,
                    contact_force
                ]
            })
        })
    });
    Table::new(header.into_iter().chain(errors)).rows(rows)
}

#[cfg(test)]
mod tests {
    use palkki::methods::Method;

    use super::routes;

    /// Certified, every power of ten of the condition number in its residual, and nothing of it in its error.
    #[test]
    fn the_active_set_has_an_error_of_rounding_where_the_condition_number_promises_nothing() {
        for method in Method::ALL {
            let grid =
                routes::grid(&palkki_evidence::paper::example().expect("well posed"), method, 1000).expect("a grid");
            let run = grid.run(super::ACTIVE_SET).expect("it goes that far");
            assert!(run.certified && -4 < run.promised(&grid), "{method}: {run:?}");
            // Contact forces near lift-off lose a factor n; a few units in the last place of that, and the margin of three.
            assert!(run.contact_force <= -12 && run.reaction.max(run.deflection) <= -14, "{method}: {run:?}");
        }
    }
}
