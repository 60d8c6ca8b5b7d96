//! Two claims as curves: sweeps of NSOR, and how often the four steps end at the optimum, over the number of intervals.

use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
use palkki_evidence::paper::claims::{four_step, nsor};

use crate::report::csv::{csv, fixed, scientific};
use crate::report::numbers::as_number;

/// A figure and its numbers.
type Drawn = (String, String);

/// Sweeps over intervals, both logarithmic.
pub(super) fn sweeps(found: &nsor::Evidence) -> Result<Drawn, PlotError> {
    let mut panel = Panel::new(Axis::new("intervals N").log(), Axis::new("sweeps of NSOR").log()).tall(700.0);
    let mut rows = Vec::new();
    for (i, count) in found.counts.iter().enumerate() {
        let points = count.sweeps.iter().map(|&(n, s)| [as_number(n), as_number(s)]).collect();
        let label = count.method.to_string();
        panel = panel.with(Layer::Series { points, style: Style::of_series(i), label });
        // Three digits: the last sweeps before the stopping rule holds depend on rounding.
        let row = |&(n, s): &(usize, usize)| vec![count.method.to_string(), n.to_string(), scientific(as_number(s), 2)];
        rows.extend(count.sweeps.iter().map(row));
    }
    let of = |best: fn(f64, f64) -> f64| found.counts.iter().map(|c| c.exponent).reduce(best).unwrap_or(f64::NAN);
    let svg = Figure::new(
        format!("On the example, sweeps of NSOR grow like n^{:.1} to n^{:.1}", of(f64::min), of(f64::max)),
        "Number of sweeps over the number of intervals, both axes logarithmic, one line for each method. All rise; the force \
         method needs the most.",
        vec![panel],
    )
    .svg()?;
    Ok((svg, csv(&["method", "intervals", "sweeps"], rows)))
}

/// Of all grids of at most so many intervals, the share on which the four steps end at the optimum.
pub(super) fn successes(found: &four_step::Evidence) -> Result<Drawn, PlotError> {
    let y = Axis::new("optimal, of all grids up to N, in per cent").including(&[0.0, 100.0]);
    let mut panel = Panel::new(Axis::new("intervals N"), y).tall(620.0);
    let mut rows = Vec::new();
    for (i, count) in found.counts.iter().enumerate() {
        let mut optimal = 0;
        let shares: Vec<[f64; 2]> = count
            .by_grid
            .iter()
            .enumerate()
            .map(|(k, &(n, is))| {
                optimal += usize::from(is);
                [as_number(n), 100.0 * as_number(optimal) / as_number(k + 1)]
            })
            .collect();
        let row = |(&(n, is), share): (&(usize, bool), &[f64; 2])| {
            let word = if is { "optimal" } else { "not optimal" };
            vec![count.method.to_string(), n.to_string(), word.to_owned(), fixed(share[1], 1)]
        };
        rows.extend(count.by_grid.iter().zip(&shares).map(row));
        let style = Style { marker: None, ..Style::of_series(i) };
        panel = panel.with(Layer::Series { points: shares, style, label: count.method.to_string() });
    }
    let grids = || found.counts.iter().map(|count| count.grids);
    let svg = Figure::new(
        format!(
            "The four steps end at the optimum on {} to {} of {} grids of the example",
            grids().min().unwrap_or(0),
            grids().max().unwrap_or(0),
            found.grids
        ),
        "Share of the grids of at most N intervals on which the four steps end at the optimum, one line for each method. It is 100 \
         per cent on coarse grids and falls on finer ones.",
        vec![panel],
    )
    .svg()?;
    Ok((svg, csv(&["method", "intervals", "end_point", "optimal_up_to_here_in_percent"], rows)))
}

/// A count in thousands.
pub(in crate::report::evidence) fn thousands(count: usize) -> f64 {
    1e-3 * as_number(count)
}
