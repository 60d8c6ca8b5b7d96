//! What a digit costs: the quickest solved run for each number of correct digits, solver by solver.

use palkki::adaptive::observed_order;
use palkki::plot::{Axis, Color, Dash, Layer, Marker, Panel, Place, Style};

use super::{SOLVERS, ended, milliseconds};
use crate::measure::line::{Line, Store};
use crate::measure::plan::{EXAMPLE, GRIDS};
use crate::report::evidence::prelude::*;

/// The two kinds of ground: the paper's example, and smooth crests that fall between the nodes.
const GROUNDS: [(&str, &str); 2] = [(EXAMPLE, "flat foundation"), ("wave", "smooth crests")];

/// Correct digits of the table.
const DIGITS: [f64; 5] = [2.0, 3.0, 4.0, 6.0, 8.0];

/// Digits that are claimed for the exact solution, whose residuals are below 10⁻¹⁴.
const EXACT: f64 = 14.0;

/// Values, and the figure.
pub(super) fn of(study: &Study<'_>, store: &Store) -> Result<(Value, Drawn), Cause> {
    let grounds = GROUNDS.map(|(scene, _)| ended(store, scene));
    let fronts = grounds.each_ref().map(|lines| SOLVERS.map(|solver| front(lines, solver)));
    let exact =
        grounds.each_ref().map(|lines| lines.iter().find(|line| line.method == "exact").map(|l| milliseconds(l)));
    let [flat, uneven] = [0, 1].map(|k| {
        context! {
            table => table(&grounds[k], exact[k]),
            one_digit => one_digit(&fronts[k][0]).map(|[time, intervals]| context! { time, intervals }),
            exact => exact[k],
            certified => certified(&grounds[k]),
        }
    });
    let rows = GROUNDS.iter().zip(&fronts).flat_map(|((scene, _), fronts)| {
        fronts.iter().flatten().map(|line| {
            let Line { method, solver, intervals, tolerance, .. } = line;
            let [digits, milliseconds] = place(line);
            let (digits, milliseconds) = (fixed(digits, 2), scientific(milliseconds, 3));
            row![scene, format!("{method}/{solver}"), intervals, format!("{tolerance:e}"), digits, milliseconds]
        })
    });
    let header = ["scene", "route", "intervals", "tolerance", "digits", "milliseconds"];
    let data = Table::new(header).rows(rows);
    let figure = study.drawn("price", context! {}, 1, panels(&fronts, exact), data)?;
    let tried = format!("{}, …", GRIDS.iter().take(4).map(count).collect::<Vec<_>>().join(", "));
    Ok((context! { flat, uneven, tried }, figure))
}

/// The solved runs of a solver, by any method and asked for anything, that are more accurate than all quicker ones.
fn front<'a>(lines: &[&'a Line], solver: &str) -> Vec<&'a Line> {
    let has_digits = |line: &&&Line| line.solver == solver && line.succeeded() && line.digits().is_some();
    let mut front: Vec<&Line> = lines.iter().filter(has_digits).copied().collect();
    front.sort_by(|a, b| milliseconds(a).total_cmp(&milliseconds(b)));
    let mut best = f64::NEG_INFINITY;
    front.retain(|line| {
        let better = best < place(line)[0];
        best = best.max(place(line)[0]);
        better
    });
    front
}

/// Digits and milliseconds of a run.
fn place(line: &Line) -> Place {
    [line.digits().unwrap_or(f64::NAN), milliseconds(line)]
}

/// Milliseconds of the quickest solved run with so many digits, and the fewest intervals with which the active set has them.
fn table(lines: &[&Line], exact: Option<f64>) -> Table {
    let solved = |solver: &str, digits: f64| {
        let has = move |line: &&&Line| line.succeeded() && line.digits().is_some_and(|found| digits <= found);
        let solver = solver.to_owned();
        lines.iter().filter(has).filter(move |line| line.solver == solver).copied().collect::<Vec<_>>()
    };
    let header = row!["for correct digits"].into_iter().chain(DIGITS.map(|digits| format!("{digits} digits")));
    let intervals = DIGITS.map(|digits| {
        let fewest = solved("active-set", digits).into_iter().map(|line| line.intervals).min();
        fewest.map_or_else(|| "–".to_owned(), count)
    });
    let mut table = Table::new(header);
    table.push(row!["intervals"].into_iter().chain(intervals));
    for solver in SOLVERS {
        let quickest = |digits| solved(solver, digits).into_iter().map(milliseconds).min_by(f64::total_cmp);
        table.push([format!("{solver}, ms")].into_iter().chain(DIGITS.map(|digits| cell(quickest(digits), 2))));
    }
    table.push(row!["nsor with the best factor, ms"].into_iter().chain(DIGITS.map(|digits| {
        // All sweeps of a run take the same time.
        let share = |line: &Line| Some(as_number(line.own_sweeps?) / as_number(line.iterations?));
        let own = solved("nsor", digits).into_iter().filter_map(|line| Some(share(line)? * milliseconds(line)));
        cell(own.min_by(f64::total_cmp), 2)
    })));
    let certified = certified(lines);
    table.push(row!["grid-free solution, ms"].into_iter().chain(DIGITS.map(|_| cell(exact, 2))));
    table.push(row!["grid-free with bounds, ms"].into_iter().chain(DIGITS.map(|_| cell(certified, 2))));
    table
}

/// Milliseconds of the grid-free solution with the bounds of all its numbers.
fn certified(lines: &[&Line]) -> Option<f64> {
    lines.iter().find(|line| line.solver == "free-boundary-certified").map(|line| milliseconds(line))
}

/// The factors in time and in intervals of one more digit, fitted to the runs between 2 and 9 digits.
fn one_digit(front: &[&Line]) -> Option<[f64; 2]> {
    let fitted = || front.iter().filter(|line| (2.0..9.0).contains(&place(line)[0]));
    let factor = |of: &dyn Fn(&Line) -> f64| {
        let pairs: Vec<(f64, f64)> = fitted().filter_map(|line| Some((line.worst()?, of(line)))).collect();
        // One digit is a tenth of the error. Two points prove nothing.
        let order = if pairs.len() < 3 { f64::NAN } else { observed_order(&pairs) };
        Some(10.0_f64.powf(-order)).filter(|factor| factor.is_finite())
    };
    Some([factor(&milliseconds)?, factor(&|line| as_number(line.intervals))?])
}

/// Two panels on the same axes: time over correct digits, a line for each solver, a star for the exact solution.
fn panels(fronts: &[[Vec<&Line>; 5]; 2], exact: [Option<f64>; 2]) -> Vec<Panel> {
    let exact = exact.map(|ms| [EXACT, ms.unwrap_or(f64::NAN)]);
    let all: Vec<Place> = fronts.iter().flatten().flatten().map(|line| place(line)).chain(exact).collect();
    let [digits, times]: [Vec<f64>; 2] = [0, 1].map(|k| all.iter().map(|p| p[k]).collect());
    let panels = fronts.iter().zip(exact).zip(GROUNDS).map(|((fronts, exact), (_, ground))| {
        let x = Axis::new("correct digits").including(&digits).including(&[0.0]);
        let y = Axis::new(format!("{ground}: time")).unit(Some("ms".to_owned()));
        let mut panel = Panel::new(x, y.log().including(&times)).tall(800.0).room(110.0, 70.0);
        // Names are placed in this order; from left to right each has room at the end of its line.
        let mut lines: Vec<_> = fronts.iter().zip(SOLVERS).enumerate().collect();
        let end = |front: &[&Line]| front.last().map_or(0.0, |line| place(line)[0]);
        lines.sort_by(|(_, (a, _)), (_, (b, _))| end(a).total_cmp(&end(b)));
        for (k, (front, solver)) in lines {
            let style = Style { dash: Some(Dash::Solid), ..Style::of_series(k) };
            let factor = one_digit(front).map(|[time, _]| format!(" × {}", significant(time, 2))).unwrap_or_default();
            let places = front.iter().map(|line| place(line)).collect();
            panel = panel.with(Layer::named(places, style, format!("{solver}{factor}")));
        }
        panel.with(Layer::named(vec![exact], Style::marks(Color::BLACK, Marker::Star), "grid-free"))
    });
    panels.collect()
}

/// What the front page says of the cost of a solve.
#[cfg(test)]
fn sentence(store: &Store) -> Option<String> {
    let of = |scene: &str| Some(significant(certified(&ended(store, scene))?, 2));
    let [example, waves] = [of(GROUNDS[0].0)?, of(GROUNDS[1].0)?];
    Some(format!(
        "**Cost.** A solve with its bounds needs {example} ms for the paper's example and {waves} ms for a beam on waves, the median on one machine."
    ))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn the_front_page_has_the_cost_of_a_solve() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let (_, store) = Store::read(&root).expect("the measurements can be read");
        let sentence = sentence(&store).expect("both scenes are measured");
        let readme = std::fs::read_to_string(root.join("README.md")).expect("the README can be read");
        assert!(readme.lines().any(|line| line == sentence), "README.md lacks the line\n{sentence}");
    }
}
