//! One map: every solver, and beam theory over waves, against the depth of the ground.

use palkki::certificate::{Judged, certify};
use palkki::plot::table::{Cell, Tone, verdict_map};
use palkki::scene::{Beam, Load};
use palkki_evidence::extremes::{Extreme, POWERS, deep};

use super::{Count, NSOR, Verdict, checked, reference};
use crate::report::evidence::prelude::*;

/// Grids of every method: the fewest intervals, odd and even ones, one more than the paper's.
const GRIDS: [usize; 5] = [2, 3, 5, 8, 31];
/// Amplitudes of waves over their mean depth.
const AMPLITUDES: [f64; 7] = [0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.5, 1.0];
/// A bound of this share of the deflection says that the answer is the right one.
const TIGHT: f64 = 0.01;
/// Waves on the beam.
const WAVES: f64 = 5.0;
/// What the rows of beam theory are called.
const THEORY: &str = "beam theory";

/// The map.
pub(super) struct Map {
    pub(super) count: Count,
    pub(super) values: Value,
    pub(super) svg: String,
    pub(super) data: Table,
}

/// A row of the map, and its runs one by one.
struct Strip {
    name: String,
    counts: [Count; POWERS.len()],
    data: Vec<[String; 5]>,
}

impl Strip {
    fn new(name: impl ToString) -> Self {
        Self { name: name.to_string(), counts: [Count::default(); POWERS.len()], data: Vec::new() }
    }

    fn add(&mut self, column: usize, method: &str, which: String, verdict: Verdict) {
        self.counts[column].add(verdict);
        self.data.push(row![self.name, method, which, POWERS[column], verdict.name()]);
    }

    fn sum(&self) -> Count {
        Count::of(&self.counts)
    }
}

pub(super) fn measured() -> Result<Map, Cause> {
    let mut strips = Solver::ALL.into_iter().map(of_solver).collect::<Result<Vec<_>, _>>()?;
    let (waves, values) = of_waves()?;
    strips.push(waves);
    let count = Count::of(&strips.iter().map(Strip::sum).collect::<Vec<_>>());
    let header = ["solver", "runs", "right", "not certified", "wrong and certified"];
    let table = Table::new(header).rows(strips.iter().map(|strip| {
        let sum = strip.sum();
        row![strip.name, sum.runs(), sum.right, sum.not_certified, sum.wrong]
    }));
    let values = context! { table, grids => GRIDS.to_vec(), waves => values };
    let svg = drawn(&strips)?;
    let header = ["solver", "method", "intervals_or_amplitude", "power_of_ten_of_depth", "outcome"];
    let data = Table::new(header).rows(strips.into_iter().flat_map(|strip| strip.data));
    Ok(Map { count, values, svg, data })
}

/// All methods and grids of a solver on flat ground.
fn of_solver(solver: Solver) -> Result<Strip, Cause> {
    let mut strip = Strip::new(solver);
    for (column, power) in POWERS.into_iter().enumerate() {
        let flat = deep(power)?;
        for method in Method::ALL {
            for intervals in GRIDS.into_iter().filter(|&intervals| solver != Solver::Nsor || intervals <= NSOR) {
                let extreme = Extreme { intervals, ..flat.clone() };
                let verdict = checked(&extreme, method, solver, &reference(&extreme, method)?)?;
                strip.add(column, method.name(), intervals.to_string(), verdict);
            }
        }
    }
    Ok(strip)
}

/// Beam theory over waves of every amplitude, beside the guaranteed bounds of its forces.
fn of_waves() -> Result<(Strip, Value), Cause> {
    let beam = Beam::new(1.0, 1.0)?;
    let mut strip = Strip::new(THEORY);
    let (mut bounded, mut bound, mut shallowest) = (0_usize, 0.0_f64, i32::MAX);
    for (column, power) in POWERS.into_iter().enumerate() {
        let depth = deep(power)?.scene.depth(0.0);
        for share in AMPLITUDES {
            let load = Load::uniform_on(&beam, 1.0)?;
            let waves =
                Foundation::Cosine { mean: depth, amplitude: share * depth, wavelength: 1.0 / WAVES, phase: 0.0 };
            let scene = Scene::new(beam.clone(), load, Some(waves))?;
            let exact = theory::solve(&scene)?;
            let verdict = if exact.solved {
                if share == 0.0 {
                    shallowest = shallowest.min(power);
                }
                let contacts = &exact.state.contacts;
                let error = certify(&scene, Judged::Witness, contacts)?.deflection_error;
                // Squares of numbers near the ends of the range of `f64` leave it, and then there is no bound.
                let share = error / exact.state.deflection.max;
                if share <= TIGHT {
                    bounded += 1;
                    bound = bound.max(share);
                }
                Verdict::Right
            } else {
                Verdict::NotCertified
            };
            strip.add(column, "exact", format!("{share:e}"), verdict);
        }
    }
    let Count { right, .. } = strip.sum();
    let values = context! {
        runs => strip.data.len(),
        certified => right,
        amplitudes => AMPLITUDES.len(),
        bounded,
        bound => cell(Some(bound), 1),
        shallowest => power_of_ten(shallowest),
    };
    Ok((strip, values))
}

/// A cell says how many of its runs are not right; the worst of them gives its colour.
fn drawn(strips: &[Strip]) -> Result<String, Cause> {
    let shown = |count: &Count| {
        let (tone, number) = match count {
            Count { wrong: 1.., .. } => (Tone::Bad, count.wrong),
            Count { not_certified: 1.., .. } => (Tone::Fair, count.not_certified),
            _ => (Tone::Good, 0),
        };
        Cell { tone, text: number.to_string() }
    };
    let legend = [Tone::Good, Tone::Fair, Tone::Bad].map(|tone| Cell { tone, text: "n".to_owned() });
    let words = ["all runs right (n = 0)", "n runs not certified", "n runs wrong and certified"];
    let legend: Vec<(Cell, &str)> = legend.into_iter().zip(words).collect();
    let columns = POWERS.map(|power| format!("1e{power}"));
    let rows: Vec<_> =
        strips.iter().map(|strip| (strip.name.as_str(), strip.counts.iter().map(shown).collect())).collect();
    let wrong: usize = strips.iter().map(|strip| strip.sum().wrong).sum();
    let title = match wrong {
        0 => format!(
            "No certified answer is wrong, for EI u₀/(q l⁴) from 1e{} to 1e{}",
            POWERS[0],
            POWERS[POWERS.len() - 1]
        ),
        _ => format!("{wrong} certified answers are wrong"),
    };
    Ok(verdict_map(
        &title,
        "A map: rows are solvers, on all methods and grids, and beam theory over waves; columns are EI u₀/(q l⁴). Each cell has \
         the number of runs that are not right.",
        &columns.each_ref().map(String::as_str),
        &rows,
        &legend,
    )?)
}
