//! How every run ended: two questions for a library, and a map of routes over grids.

use super::{LIBRARIES, METHODS, SOLVERS, shown};
use crate::measure::line::{Line, Store};
use crate::measure::plan::EXAMPLE;
use crate::report::evidence::prelude::*;
use crate::report::evidence::verdict_map::{self, Tone};

/// Values, and the map.
pub(super) fn of(study: &Study<'_>, store: &Store) -> Result<(Value, Drawn), Cause> {
    let (title, figure) = map(study, store)?;
    Ok((context! { questions => questions(store), map => title }, figure))
}

/// Of all runs of the libraries that were measured: did they do what they were asked, and do their answers pass our check.
fn questions(store: &Store) -> Table {
    let header = [
        "library",
        "runs",
        "reported solved",
        "reported almost solved, fails our check",
        "own residuals within the tolerance",
        "of these pass our check",
    ];
    Table::new(header).rows(LIBRARIES.map(|library| {
        let runs = || {
            let of_library =
                store.lines.iter().filter(|line| line.solver == library && METHODS.contains(&line.method.as_str()));
            of_library.filter(|line| line.median_s.is_some())
        };
        let counts = [
            runs().count(),
            runs().filter(|line| line.says_solved == Some(true)).count(),
            runs().filter(|line| line.says_almost_solved()).count(),
            runs().filter(|line| line.did_as_asked == Some(true)).count(),
            runs().filter(|line| line.did_as_asked == Some(true) && line.succeeded()).count(),
        ];
        row![library].into_iter().chain(counts.map(count))
    }))
}

/// How a run ended.
fn outcome(line: Option<&Line>) -> (Tone, &'static str) {
    match line {
        None => (Tone::Absent, "–"),
        Some(line) if line.is_left_out() => (Tone::Absent, "–"),
        Some(line) if line.succeeded() => (Tone::Good, "S"),
        Some(line) if line.did_as_asked == Some(true) => (Tone::Fair, "A"),
        Some(line) if line.says_solved == Some(true) => (Tone::Bad, "C"),
        Some(line) if line.says_almost_solved() => (Tone::Fair, "N"),
        Some(_) => (Tone::Fair, "G"),
    }
}

/// A number of intervals in few characters: `300`, `10³`, `3·10⁴`.
fn short(intervals: usize) -> String {
    let exponent = intervals.checked_ilog10().unwrap_or(0);
    let mantissa = intervals / 10_usize.pow(exponent);
    match i32::try_from(exponent) {
        Ok(exponent) if 3 <= exponent && mantissa == 1 => power_of_ten(exponent),
        Ok(exponent) if 3 <= exponent => format!("{mantissa}·{}", power_of_ten(exponent)),
        _ => intervals.to_string(),
    }
}

/// Routes on the example over grids, sorted by solver: the title, the map and its numbers.
fn map(study: &Study<'_>, store: &Store) -> Result<(String, Drawn), Cause> {
    let lines: Vec<&Line> = store.lines.iter().filter(|line| line.scene == EXAMPLE).collect();
    let of_route = |method: &str, solver: &str| {
        lines.iter().filter(|line| shown(line) && line.is(method, solver)).copied().collect::<Vec<_>>()
    };
    let mut grids: Vec<usize> =
        METHODS.iter().flat_map(|method| of_route(method, SOLVERS[0])).map(|line| line.intervals).collect();
    grids.sort_unstable();
    grids.dedup();
    let (mut rows, mut finest) = (Vec::new(), Vec::new());
    let mut data = Table::new(["route", "intervals", "outcome"]);
    for solver in SOLVERS {
        // The finest grid up to which all methods solve their problem.
        let solved = |grid: &usize| {
            let ends = |method| of_route(method, solver).into_iter().find(|line| line.intervals == *grid);
            METHODS.into_iter().all(|method| outcome(ends(method)).1 == "S")
        };
        finest.push(grids.iter().take_while(|grid| solved(grid)).last().copied());
        for method in METHODS {
            let found = of_route(method, solver);
            let cells = grids.iter().map(|grid| {
                let (tone, text) = outcome(found.iter().copied().find(|line| line.intervals == *grid));
                data.push(row![format!("{method}/{solver}"), grid, text]);
                (tone, text.to_owned())
            });
            rows.push((format!("{solver}, {method}"), cells.collect::<Vec<_>>()));
        }
    }
    let finest: Vec<String> = finest.into_iter().map(|grid| grid.map_or_else(|| "none".to_owned(), short)).collect();
    let words = study.words("runs", context! { finest })?;
    // Between powers of ten there is no room for names of many characters.
    let named = |grid: usize| if short(grid).chars().count() < 4 { short(grid) } else { String::new() };
    let columns = grids.iter().map(|grid| named(*grid)).collect();
    let svg = verdict_map::drawn(&words, columns, rows)?;
    Ok((words.title, ("runs", svg, data)))
}
