//! Snapshots: one page for each scene file of the report, with all that is pinned about it. They guard against unnoticed change, and
//! are never the only test of a number.

use std::fmt::Write as _;
use std::fs;

use palkki::adaptive::{End, Request, adapt};
use palkki::route::{Method, Solution, Solver};
use palkki::scene::file::{ReadProblem, parse};
use palkki::scene::{Grid, Scene};
use palkki::state::{Contact, ContactState};
use palkki::text::decade;
use palkki::theory::Exact;
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, Witness, solve_raw, theory};
use palkki_evidence::numdiff::numdiff;

use crate::scenes::run;
use crate::support::{Numdiff, with_our_settings};

/// Intervals of the answers that are shown, and of the certified errors. Where a support inside asks for it, the next finer
/// grid that has a node at each support.
const SHOWN: usize = 30;
const GRIDS: [usize; 5] = [10, SHOWN, 100, 300, 1000];
const DEMANDED: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];

/// Share of the largest number of its kind below which a number is rounding and has no digits of its own: 1e-12 of the largest is
/// what answers are certified to, and six digits are shown.
const ROUNDING: f64 = 1e-9;

/// Six significant digits with a decimal point, so that they are compared as a number with digits; `size` is the largest of its kind.
fn six(value: f64, size: f64) -> String {
    if value.abs() <= ROUNDING * size.abs() {
        return "0.00000".to_owned();
    }
    match usize::try_from(5 - decade(value)) {
        Ok(decimals @ 0..=8) => format!("{value:.*}", decimals.max(1)),
        _ => format!("{value:.5e}"),
    }
}

/// One way to solve a scene, and the column of its numbers.
struct Column {
    head: String,
    cells: Vec<String>,
    contacts: String,
}

/// Place and force of each contact, and what a zone has at its ends.
fn contacts(state: &ContactState, length: f64, inside: &[(f64, f64)]) -> String {
    let largest = state.contacts.iter().map(|c| c.force).fold(0.0, f64::max);
    let mut lines = String::new();
    for Contact { from, to, force, end_forces } in &state.contacts {
        let [from_, to_] = [from, to].map(|x| six(*x, length));
        let place = if from < to { format!("{from_} … {to_}") } else { from_ };
        let _ = write!(lines, "    {place:<22} force {:>9}", six(*force, largest));
        if let Some([left, right]) = end_forces {
            let _ = write!(lines, "   at its ends {} and {}", six(*left, largest), six(*right, largest));
        }
        lines.push('\n');
    }
    for (at, force) in inside {
        let _ =
            writeln!(lines, "    point load at {} carried by the ground, {}", six(*at, length), six(*force, largest));
    }
    if lines.is_empty() { "    none\n".to_owned() } else { lines }
}

/// What the rows are: their names are those of the first column.
fn rows(
    scene: &Scene,
    state: &ContactState,
    ended: &str,
    intervals: Option<usize>,
    unknowns: usize,
) -> Vec<[String; 2]> {
    let length = scene.beam().length();
    let force = state.supports.iter().map(|s| s.force.abs()).fold(state.contact_force(), f64::max);
    let mut rows = vec![
        ["ended".to_owned(), ended.to_owned()],
        ["regime".to_owned(), state.regime.name().to_owned()],
        ["intervals".to_owned(), intervals.map_or("–".to_owned(), |n| n.to_string())],
        ["unknowns".to_owned(), unknowns.to_string()],
    ];
    for support in &state.supports {
        rows.push([format!("force of the support at {}", six(support.at, length)), six(support.force, force)]);
        if let Some(moment) = support.moment {
            rows.push(["  moment beside it".to_owned(), six(moment, state.moment.magnitude())]);
        }
    }
    rows.push(["contact force".to_owned(), six(state.contact_force(), force)]);
    rows.push(["energy".to_owned(), six(state.energy, state.energy)]);
    for (name, values) in [("deflection", &state.deflection), ("moment", &state.moment)] {
        let size = values.magnitude();
        // Of two places that mirror each other, rounding picks one.
        for (which, value, at) in [("largest", values.max, values.max_at), ("least", values.min, values.min_at)] {
            rows.push([format!("{which} {name}"), six(value, size)]);
            rows.push(["  at, from the nearer end".to_owned(), six(at.min(length - at), length)]);
        }
    }
    rows
}

fn exact_column(scene: &Scene, exact: &Exact) -> (Vec<String>, Column) {
    let rows = rows(scene, &exact.state, exact.ended(), None, exact.unknowns);
    let inside: Vec<_> = exact.forces_inside_zones().collect();
    let contacts = contacts(&exact.state, scene.beam().length(), &inside);
    let (names, cells) = rows.into_iter().map(|[name, cell]| (name, cell)).unzip();
    (names, Column { head: "exact".to_owned(), cells, contacts })
}

fn column(scene: &Scene, method: Method, raw: &Solution<()>, intervals: usize) -> Column {
    let rows = rows(scene, &raw.state, raw.ended(), Some(intervals), raw.unknowns);
    let contacts = contacts(&raw.state, scene.beam().length(), &[]);
    Column { head: method.to_string(), cells: rows.into_iter().map(|[_, cell]| cell).collect(), contacts }
}

/// Two columns whose numbers are the same to the last printed digit are one column with two names.
fn merged(columns: Vec<Column>) -> Vec<Column> {
    let mut merged: Vec<Column> = Vec::new();
    for column in columns {
        let text = |column: &Column| column.cells.join("\n") + &column.contacts;
        match merged.iter_mut().find(|other| numdiff(&text(other), &text(&column)).is_ok()) {
            Some(other) => other.head = format!("{}, {}", other.head, column.head),
            None => merged.push(column),
        }
    }
    merged
}

/// Rows of methods: two methods with the same numbers share one row.
fn by_method(row: impl Fn(Method) -> Vec<String>) -> String {
    let columns = Method::ALL.map(|m| Column { head: m.to_string(), cells: row(m), contacts: String::new() }).into();
    merged(columns).iter().fold(String::new(), |mut text, Column { head, cells, .. }| {
        let _ = write!(text, "\n  {head:<24}");
        text.extend(cells.iter().map(|cell| format!("{cell:>10}")));
        text
    })
}

fn page(scene: &Scene) -> String {
    let exact = theory::solve(scene).expect("the scene is in range");
    // With a node at each support, joint and change of the stiffness.
    let least = Grid::least_fitting(scene).expect("a grid that fits");
    let fits = |intervals: usize| intervals.is_multiple_of(least);
    let fitting = |intervals: usize| (intervals..=2 * intervals).find(|n| fits(*n)).expect("a grid that fits");
    let solved = |method, intervals| run(scene, method, Solver::ActiveSet, fitting(intervals));

    let (names, first) = exact_column(scene, &exact);
    // What grids do not know yet.
    let refused = solve_raw(scene, &Settings::new(Method::Force, Solver::ActiveSet, fitting(SHOWN))).err();
    let methods = Method::ALL.into_iter().filter(|_| refused.is_none());
    let shown = methods.map(|method| column(scene, method, &solved(method, SHOWN), fitting(SHOWN)));
    let columns = merged(std::iter::once(first).chain(shown).collect());
    let mut page = format!("{}\n\n{:<32}", scene.title(), "");
    page.extend(columns.iter().map(|column| format!("  {:>20}", column.head)));
    for (i, name) in names.iter().enumerate() {
        let _ = write!(page, "\n{name:<32}");
        page.extend(columns.iter().map(|column| format!("  {:>20}", column.cells[i])));
    }
    page += "\n\nContacts\n";
    for Column { head, contacts, .. } in &columns {
        let _ = write!(page, "  {head}\n{contacts}");
    }
    match refused {
        Some(error) => page + &format!("\nOn grids: {error}\n"),
        None => page + &errors(scene, &exact, solved, fitting) + "\n",
    }
}

/// The certified error on each grid, and the grid of each error that is demanded.
fn errors(
    scene: &Scene,
    exact: &Exact,
    solved: impl Fn(Method, usize) -> Solution<()>,
    fitting: impl Fn(usize) -> usize,
) -> String {
    let witness = Witness::known(scene, exact);
    let mut page = format!("\n{:<26}", "Certified error, intervals");
    page.extend(GRIDS.map(|n| format!("{:>10}", fitting(n))));
    page += &by_method(|method| {
        let error = |n| Verdict::of_raw(&solved(method, n), &witness, &Demand::default()).error;
        GRIDS.iter().map(|&n| format!("{:.2e}", error(n))).collect()
    });
    let _ = write!(page, "\n\n{:<26}", "Intervals, error demanded");
    page.extend(DEMANDED.map(|error| format!("{error:>10.0e}")));
    page + &by_method(|method| {
        let taken = |error| adapt(scene, &Request::new(method, Solver::ActiveSet, error)).expect("in range");
        let reached =
            DEMANDED.map(taken).into_iter().map(|taken| (taken.end == End::Reached, taken.settings.intervals));
        reached.map(|(reached, intervals)| if reached { intervals.to_string() } else { "–".to_owned() }).collect()
    })
}

/// Beside them stand the authorities: closed forms and bounds for the exact solution, agreement and order for the methods
/// (`methods`, `theory`), true errors beside certified ones (`certificate::truth`) and beside demanded ones (`solvers::adaptive`).
#[test]
fn every_scene_has_its_page() {
    with_our_settings!("All that is pinned about one scene, by the active set", Numdiff, {
        insta::glob!("../../report/scenes", "**/*.toml", |path| {
            // A body has no beam, and a train that is not on its bridge yet has no answer.
            if path.components().any(|part| ["bodies", "trains"].iter().any(|folder| part.as_os_str() == *folder)) {
                return;
            }
            let text = fs::read_to_string(path).expect("a scene file");
            let survey = |name: &str| fs::read_to_string(path.with_file_name(name)).map_err(|_| ReadProblem::Missing);
            insta::assert_snapshot!(
                "page",
                page(&parse(&path.to_string_lossy(), &text, survey).unwrap_or_else(|e| panic!("{e}")))
            );
        });
    });
}
