//! Surveys on soil: the grid-free solution with its bounds beside finite elements with springs that are switched on and off, one after
//! the other on the same readings.

use std::path::Path;

use palkki::route::Status;
use palkki::{solve_exactly, theory};
use palkki_evidence::compare::largest;
use palkki_evidence::soil::Pipe;
use serde::{Deserialize, Serialize};

use super::instruments;
use super::job::timed;
use crate::data::{rounded, spread};
use crate::report::files;
use crate::{Cause, data, tell};

/// What `--only` calls it.
pub(super) const NAME: &str = "soil";

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/soil-surveys.csv";

/// A reading every 0.3 m \[m\].
const SPACING: f64 = 0.3;

/// Readings, and stiffnesses of the soil in N/m²: mud, sand, stiff clay, and what is nearly rock.
const READINGS: [u32; 5] = [1000, 3000, 10_000, 30_000, 100_000];
const SOILS: [f64; 4] = [1e4, 5e5, 1e7, 1e9];

/// The bed of all of them.
const SEED: u64 = 1;

/// One survey on one soil. Differences are shares of the largest value by the grid-free solution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) readings: u32,
    pub(crate) soil: f64,
    pub(crate) status: String,
    /// The largest proven error, as the verdict has it; none where there is no bound.
    pub(crate) proven: Option<f64>,
    pub(crate) contacts: usize,
    /// Seconds of the grid-free solution, and with its bounds.
    pub(crate) exact_s: Option<f64>,
    pub(crate) certified_s: Option<f64>,
    /// Seconds of the elements, linear systems that they solve, and whether their springs settle.
    pub(crate) elements_s: Option<f64>,
    pub(crate) steps: u32,
    pub(crate) settled: bool,
    pub(crate) deflection_off: Option<f64>,
    pub(crate) moment_off: Option<f64>,
}

fn line(readings: u32, soil: f64) -> Result<Line, Cause> {
    let pipe = Pipe { length: SPACING * f64::from(readings), readings, seed: SEED, soil };
    let scene = pipe.scene()?;
    let (exact_s, exact) = timed(|| Ok(theory::solve(&scene)?))?;
    let (certified_s, certified) = timed(|| Ok(solve_exactly(&scene)?))?;
    let (elements_s, elements) = timed(|| Ok(pipe.by_elements()))?;
    let deflections = || elements.nodes.iter().zip(&elements.values).map(|(x, value)| (exact.deflection(*x), value[0]));
    let moments = || elements.moments().map(|(x, moment)| (exact.moment(x), moment));
    let off = |pairs: &mut dyn Iterator<Item = (f64, f64)>, size: f64| {
        rounded(largest(pairs.map(|(exact, found)| found - exact)) / size, 1)
    };
    let proven = certified.verdict.largest_error();
    Ok(Line {
        readings,
        soil,
        status: certified.verdict.status.name().to_owned(),
        proven: rounded(proven, 1),
        contacts: exact.state.contacts.len(),
        exact_s: spread(exact_s)[0],
        certified_s: spread(certified_s)[0],
        elements_s: spread(elements_s)[0],
        steps: elements.steps,
        settled: elements.settled,
        deflection_off: off(&mut deflections(), largest(deflections().map(|(exact, _)| exact))),
        moment_off: off(&mut moments(), largest(moments().map(|(exact, _)| exact))),
    })
}

/// Measures all of them.
pub(super) fn run(root: &Path) -> Result<(), Cause> {
    let mut lines = Vec::new();
    for soil in SOILS {
        for readings in READINGS {
            tell(&format!("{readings} readings on soil of {soil:e}"));
            lines.push(line(readings, soil)?);
        }
    }
    let text = instruments::heading(&instruments::describe(root)) + &data::text(&lines)?;
    Ok(files::replace(&root.join(PATH), &text)?)
}

impl Line {
    pub(crate) fn is_certified(&self) -> bool {
        self.status == Status::Certified.name()
    }
}
