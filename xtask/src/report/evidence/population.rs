//! What is told of the families of a population: errors on each grid, orders, and the intervals that one more digit takes.

use palkki::adaptive::observed_order;
use palkki::plot::{Axis, Layer, Marker, Panel, Place, Style};
use palkki_evidence::observables::NAMES;
use palkki_evidence::random::Family;

use super::prelude::*;
use crate::data;
use crate::measure::population::{GRIDS, Line, METHODS, PATH, SCENES};

/// Errors below this are rounding of the answers, and no slope is fitted to them.
const MEANINGLESS: f64 = 1e-12;

/// The grid and the observables on which the two discretisations stand side by side: reactions, moment and energy.
const COMPARED_ON: usize = 100;
const COMPARED: [(usize, &str); 3] = [(0, "reactions"), (3, "moment"), (4, "energy")];

/// Which of the observables the figure draws.
const DRAWN: [usize; 3] = [0, 3, 4];

/// The median of some numbers and the worst of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spread {
    pub(super) least: f64,
    pub(super) median: f64,
    pub(super) worst: f64,
    pub(super) count: usize,
}

impl Spread {
    /// None if there are no numbers.
    pub(super) fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut numbers: Vec<f64> = numbers.into_iter().collect();
        numbers.sort_by(f64::total_cmp);
        let (&least, &worst) = (numbers.first()?, numbers.last()?);
        Some(Self { least, median: data::median(&numbers)?, worst, count: numbers.len() })
    }

    /// `median (least–most)`.
    fn range(spread: Option<Self>) -> String {
        let [least, median, worst] =
            [|s: Self| s.least, |s: Self| s.median, |s: Self| s.worst].map(|of| cell(spread.map(of), 2));
        format!("{median} ({least}–{worst})")
    }
}

/// The lines of the file.
pub(super) fn lines(study: &Study<'_>) -> Result<Vec<Line>, Cause> {
    Ok(data::read(study.root, PATH)?.1)
}

/// The lines of a draw of one family by a method.
pub(super) fn of_family(lines: &[Line], family: Family, method: Method) -> impl Iterator<Item = &Line> + Clone {
    lines.iter().filter(move |line| line.draw == 1 && line.family == family.name() && line.method == method.name())
}

/// The errors of an observable on a grid, over the scenes that are solved.
pub(super) fn on(lines: &[Line], family: Family, method: Method, intervals: usize, of: usize) -> Option<Spread> {
    let on_grid = of_family(lines, family, method).filter(|line| line.intervals == intervals && line.succeeded());
    Spread::of(on_grid.filter_map(|line| Some(line.errors()?[of])))
}

/// The order of an observable, scene by scene, over all grids.
pub(super) fn orders(lines: &[Line], family: Family, method: Method, of: usize) -> Option<Spread> {
    let scenes = 0..SCENES[0];
    Spread::of(scenes.filter_map(|scene| {
        let of_scene = of_family(lines, family, method).filter(|line| line.scene == scene && line.succeeded());
        let pairs = of_scene.filter_map(|line| Some((1.0 / as_number(line.intervals), line.errors()?[of])));
        let pairs: Vec<(f64, f64)> = pairs.filter(|(_, error)| MEANINGLESS < *error).collect();
        // Two points prove nothing.
        (3 <= pairs.len()).then(|| observed_order(&pairs)).filter(|order| order.is_finite())
    }))
}

/// The factor in intervals that one more digit takes, of an order.
fn one_digit(order: Spread) -> Spread {
    let factor = |order: f64| 10.0_f64.powf(1.0 / order);
    Spread { least: factor(order.worst), median: factor(order.median), worst: factor(order.least), ..order }
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (file, lines): (_, Vec<Line>) = data::read(study.root, PATH)?;
    let force = Method::Force;
    let header = |first: &str, others: Vec<String>| [first.to_owned()].into_iter().chain(others).collect::<Vec<_>>();
    let all = |first: &str| header(first, NAMES.map(str::to_owned).to_vec());
    let rows = |cells: &dyn Fn(Family) -> Vec<String>| {
        Family::ALL.map(|family| [family.name().to_owned()].into_iter().chain(cells(family)).collect::<Vec<_>>())
    };
    let digit = |family: Family, of: usize| orders(&lines, family, force, of).map(one_digit);
    let rule =
        Table::new(all("foundation")).rows(rows(&|family| (0..5).map(|of| Spread::range(digit(family, of))).collect()));
    let orders = Table::new(all("foundation"))
        .rows(rows(&|family| (0..5).map(|of| Spread::range(orders(&lines, family, force, of))).collect()));
    let [side_by_side, side_by_side_most] =
        [|s: Spread| s.median, |s: Spread| s.worst].map(|of| side_by_side(&lines, of));
    let medians = |of: usize| Family::ALL.map(|family| digit(family, of).map_or(f64::NAN, |s| s.median));
    let digits = |of: usize| {
        let uneven = range(medians(of)[1..].iter().copied());
        context! { flat => medians(of)[0], least => uneven.map(|r| r[0]), most => uneven.map(|r| r[1]) }
    };
    let median = |family, grid| on(&lines, family, force, grid, 0).map(|s| s.median);
    let hundredfold = range(
        Family::ALL
            .into_iter()
            .filter_map(|family| Some(median(family, GRIDS[2])? / median(family, GRIDS[GRIDS.len() - 1])?)),
    );
    let adaptive = lines.iter().filter(|line| line.solver.ends_with("-adaptive") && line.succeeded());
    // Of the moment nothing is guaranteed.
    let errors = adaptive.clone().filter_map(|line| line.errors()).flat_map(|[a, b, c, _, d]| [a, b, c, d]);
    let second = lines.iter().filter(|line| line.draw == 2 && line.method == "exact");
    let values = context! {
        scenes => SCENES[0],
        families => Family::ALL.len(),
        coarsest => GRIDS[0],
        finest => GRIDS[GRIDS.len() - 1],
        rule, orders, side_by_side, side_by_side_most,
        advice => advised(&lines),
        digit => context! { supports => digits(0), moment => digits(3), energy => digits(4) },
        hundredfold => context! { least => hundredfold.map(|r| r[0]), most => hundredfold.map(|r| r[1]) },
        adaptive => context! { reached => adaptive.count(), worst => largest(errors) },
        second => second.count(),
        solved => lines.iter().filter(|line| line.draw == 1 && line.succeeded()).count(),
        answers => lines.iter().filter(|line| line.draw == 1).count(),
    };
    Evidence::new(values.clone()).file("population", file).figures([drawn(study, &lines, values)?])
}

/// The errors of both discretisations on one grid, in per cent: a row for each family, two columns for each observable.
fn side_by_side(lines: &[Line], of: fn(Spread) -> f64) -> Table {
    let names =
        COMPARED.iter().flat_map(|(_, name)| ["FD", "energy methods"].map(|method| format!("{name}, {method}")));
    let cells = |family: Family| {
        let errors = COMPARED.iter().flat_map(move |&(observable, _)| {
            METHODS.map(|method| on(lines, family, method, COMPARED_ON, observable).map(of))
        });
        let errors = errors.map(|error| cell(error.map(|error| 100.0 * error), 2));
        [family.name().to_owned()].into_iter().chain(errors).collect::<Vec<_>>()
    };
    Table::new(["foundation".to_owned()].into_iter().chain(names)).rows(Family::ALL.map(cells))
}

/// The paper's advice, energy methods rather than finite differences, as quotients of median errors on [`COMPARED_ON`] intervals: of the
/// moment, energy methods over finite differences, on smooth foundations and on the others; of the energy the other way round, with other
/// supports.
fn advised(lines: &[Line]) -> Value {
    let quotient = |family: Family, observable: usize| {
        let [differences, energy] = METHODS.map(|method| on(lines, family, method, COMPARED_ON, observable));
        Some(energy?.median / differences?.median)
    };
    let is_smooth = |family: &Family| matches!(family, Family::Flat | Family::Crests);
    let [smooth, other] = [true, false].map(|smooth| {
        let families = Family::ALL.into_iter().filter(|family| is_smooth(family) == smooth);
        least_most(families.filter_map(|family| quotient(family, 3)))
    });
    context! { smooth, other, held_energy => quotient(Family::Held, 4).map(f64::recip) }
}

/// A panel for each family: medians as lines and the worst as marks, over the number of intervals.
fn drawn(study: &Study<'_>, lines: &[Line], values: Value) -> Result<Drawn, Cause> {
    let mut data = Table::new(["family", "observable", "intervals", "median", "worst", "scenes"]);
    let mut panels = Vec::new();
    for family in Family::ALL {
        let y = Axis::new(format!("{}: relative error", family.name())).log().including(&[1e-8, 1.0]);
        let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(620.0);
        for (k, of) in DRAWN.into_iter().enumerate() {
            let found = || GRIDS.into_iter().filter_map(|n| Some((n, on(lines, family, Method::Force, n, of)?)));
            let places = |value: fn(Spread) -> f64| -> Vec<Place> {
                found().map(|(n, s)| [as_number(n), value(s)]).filter(|place| MEANINGLESS < place[1]).collect()
            };
            let style = Style { marker: None, ..Style::of_series(k) };
            let marks = Style::marks(style.color, Marker::OpenCircle);
            panel = panel
                .with(Layer::named(places(|s| s.median), style, NAMES[of]))
                .with(Layer::line(places(|s| s.worst), marks));
            data = data.rows(found().map(|(n, s)| {
                row![family.name(), NAMES[of], n, scientific(s.median, 2), scientific(s.worst, 2), s.count]
            }));
        }
        panels.push(panel);
    }
    study.drawn("population-errors", values, 2, panels, data)
}

/// The rule of thumb in one sentence, for the front page of the repository.
#[cfg(test)]
fn sentence(lines: &[Line]) -> String {
    let digits = |family: Family| {
        let factor = orders(lines, family, Method::Force, 0).map(one_digit);
        format!("{} ({})", cell(factor.map(|s| s.median), 2), family.name())
    };
    format!(
        "**On a grid multiply the intervals for one more correct digit of the reactions by** {}, the medians of {} problems each.",
        Family::ALL.map(digits).join(", "),
        SCENES[0]
    )
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn the_front_page_has_the_price_of_a_digit() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let (_, lines): (_, Vec<Line>) = data::read(&root, PATH).expect("the population can be read");
        let sentence = sentence(&lines);
        let readme = std::fs::read_to_string(root.join("README.md")).expect("the README can be read");
        assert!(readme.lines().any(|line| line == sentence), "README.md lacks the line\n{sentence}");
    }
}
