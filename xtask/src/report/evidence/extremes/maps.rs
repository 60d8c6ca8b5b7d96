//! Maps of verdicts, parameter against parameter.

use palkki::certificate::certify_contacts;
use palkki::extremes::{Extreme, POWERS, deep};
use palkki::plot::table::{Cell, Row, Tone, verdict_map};
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::theory;
use serde::Serialize;

use super::{Count, NSOR, Verdict, judged, reference};
use crate::report::csv::csv;
use crate::report::error::Cause;

/// Grids of the maps: the fewest intervals, odd and even ones, one more than the paper's.
const GRIDS: [usize; 5] = [2, 3, 5, 8, 31];
/// Amplitudes of waves over their mean depth.
const AMPLITUDES: [f64; 7] = [0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.5, 1.0];
/// A bound of this share of the deflection says that the answer is the right one.
const TIGHT: f64 = 0.01;
/// Waves on the beam.
const WAVES: f64 = 5.0;

/// How a method did over the map of its solvers.
#[derive(Debug, Serialize)]
pub(super) struct Map {
    method: &'static str,
    pub(super) runs: usize,
    right: usize,
    labelled: usize,
    pub(super) wrong: usize,
}

/// How beam theory did over waves.
#[derive(Debug, Serialize)]
pub(super) struct Waves {
    pub(super) runs: usize,
    certified: usize,
    /// How many of the certified answers the bounds of the judge reach, and the worst of these bounds on the error of the
    /// deflection, over the largest deflection.
    bounded: usize,
    bound: f64,
    pub(super) shallowest: i32,
}

fn cell(verdict: Verdict) -> Cell {
    let (tone, text) = match verdict {
        Verdict::Right => (Tone::Good, "R"),
        Verdict::Labelled => (Tone::Fair, "L"),
        Verdict::Wrong => (Tone::Bad, "W"),
    };
    Cell { tone, text: text.to_owned() }
}

fn columns() -> Vec<String> {
    POWERS.iter().map(|power| format!("1e{power}")).collect()
}

fn drawn(title: &str, description: &str, rows: &[(String, Vec<Cell>)]) -> Result<String, Cause> {
    let legend = [
        (cell(Verdict::Right), "right and certified"),
        (cell(Verdict::Labelled), "labelled: not certified"),
        (cell(Verdict::Wrong), "wrong and certified"),
    ];
    let columns = columns();
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let rows: Vec<Row<'_>> = rows.iter().map(|(name, cells)| (name.as_str(), cells.clone())).collect();
    Ok(verdict_map(title, description, &columns, &rows, &legend)?)
}

/// Solvers and grids against the depth of flat ground.
pub(super) fn depth_against_grid(method: Method) -> Result<(Map, String, String), Cause> {
    let (mut count, mut rows, mut data) = (Count::default(), Vec::new(), Vec::new());
    let extremes = POWERS.map(deep).into_iter().collect::<Result<Vec<_>, _>>()?;
    for solver in Solver::ALL {
        for intervals in GRIDS {
            if solver == Solver::Nsor && NSOR < intervals {
                continue;
            }
            let mut cells = Vec::new();
            for (extreme, power) in extremes.iter().zip(POWERS) {
                let extreme = Extreme { intervals, ..extreme.clone() };
                let verdict = judged(&extreme, method, solver, &reference(&extreme, method)?)?;
                count.add(verdict);
                let line =
                    [solver.word().to_owned(), intervals.to_string(), power.to_string(), verdict.word().to_owned()];
                data.push(line.to_vec());
                cells.push(cell(verdict));
            }
            rows.push((format!("{solver}, {intervals}"), cells));
        }
    }
    let svg = drawn(
        &format!("The {method} method: solver and intervals over EI u₀/(q l⁴)"),
        "A map: rows are solvers and numbers of intervals, columns are depths. R right and certified, L labelled, W wrong and certified.",
        &rows,
    )?;
    let map = Map {
        method: method.word(),
        runs: count.runs(),
        right: count.right,
        labelled: count.labelled,
        wrong: count.wrong,
    };
    Ok((map, svg, csv(&["solver", "intervals", "power_of_ten_of_depth", "verdict"], data)))
}

/// Waves against their mean depth, by beam theory; the judge of the bounds is the authority.
pub(super) fn amplitude_against_depth() -> Result<(Waves, String, String), Cause> {
    let beam = Beam::new(1.0, 1.0)?;
    let (mut rows, mut data) = (Vec::new(), Vec::new());
    let (mut certified, mut bounded, mut bound, mut shallowest) = (0, 0, 0.0_f64, i32::MAX);
    for share in AMPLITUDES {
        let mut cells = Vec::new();
        for power in POWERS {
            let depth = deep(power)?.scene.depth(0.0);
            let load = Load::uniform_on(&beam, 1.0)?;
            let waves =
                Foundation::Cosine { mean: depth, amplitude: share * depth, wavelength: 1.0 / WAVES, phase: 0.0 };
            let scene = Scene::new(beam, load, Some(waves))?;
            let exact = theory::solve(&scene)?;
            let verdict = if exact.status == Status::Certified {
                certified += 1;
                if share == 0.0 {
                    shallowest = shallowest.min(power);
                }
                let error = certify_contacts(&scene, &exact.state.contacts)?.deflection_error;
                // Squares of numbers near the ends of the range of `f64` leave it, and then there is no bound.
                let share = error / exact.state.deflection.max;
                if share <= TIGHT {
                    bounded += 1;
                    bound = bound.max(share);
                }
                Verdict::Right
            } else {
                Verdict::Labelled
            };
            data.push(vec![format!("{share:e}"), power.to_string(), verdict.word().to_owned()]);
            cells.push(cell(verdict));
        }
        // As a person writes it: 0, 0.5 and 1, but 1e-12.
        let amplitude = if 0.0 < share && share < AMPLITUDES[4] { format!("{share:e}") } else { share.to_string() };
        rows.push((format!("amplitude {amplitude}"), cells));
    }
    let svg = drawn(
        "Beam theory: amplitude of waves over EI u₀/(q l⁴)",
        "A map: rows are amplitudes of waves over their mean depth, columns are mean depths. R certified, L labelled.",
        &rows,
    )?;
    let runs = data.len();
    let waves = Waves { runs, certified, bounded, bound, shallowest };
    Ok((waves, svg, csv(&["amplitude_over_depth", "power_of_ten_of_depth", "verdict"], data)))
}
