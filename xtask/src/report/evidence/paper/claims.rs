//! The claims of the paper and its advice, beside what was measured.

use minijinja::value::Serde;
use palkki::plot::{Axis, Layer, Panel, Style};
use palkki::scene::SceneError;
use palkki_evidence::paper::claims::accuracy::{Errors, errors};
use palkki_evidence::paper::claims::four_step::FINEST;
use palkki_evidence::paper::claims::nsor::GRIDS;
use palkki_evidence::paper::claims::{Claim, Verdict, four_step, nsor};

use crate::report::evidence::prelude::*;

/// The ledger: every claim of the paper, its verdict and the numbers of its words.
pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let claims = &ledger.claims;
    let count = |verdict| claims.iter().filter(|claim| claim.verdict == verdict).count();
    let by_grid = ledger.four_step.iter().flat_map(|count| &count.by_grid).map(|(n, _)| *n);
    let of = |claim: &Claim| {
        (claim.name, context! { verdict => claim.verdict.name(), ..Value::from(Serde(&claim.numbers)) })
    };
    let values = context! {
        total => claims.iter().filter(|claim| claim.verdict != Verdict::Outlook).count(),
        confirmed => count(Verdict::Confirmed),
        qualified => count(Verdict::Qualified),
        refuted => count(Verdict::Refuted),
        open => count(Verdict::Open),
        four_step => context! { coarsest => by_grid.min().unwrap_or(0), finest => FINEST },
        nsor => context! { coarsest => GRIDS[0], finest => GRIDS[GRIDS.len() - 1] },
        ..Value::from_pairs(claims.iter().map(of))
    };
    let sweeps = sweeps(study, &ledger.nsor)?;
    let successes = successes(study, &ledger.four_step)?;
    Evidence::new(values).figures([sweeps, successes])
}

/// Sweeps over intervals, both logarithmic.
fn sweeps(study: &Study<'_>, found: &[nsor::Count]) -> Result<Drawn, Cause> {
    let mut panel =
        Panel::new(Axis::new("intervals N").log(), Axis::new("sweeps of NSOR, all factors together").log()).tall(700.0);
    let mut data = Table::new(["method", "intervals", "sweeps", "sweeps_of_the_first_to_converge"]);
    for (i, count) in found.iter().enumerate() {
        let points = count.sweeps.iter().map(|&(n, s)| [as_number(n), as_number(s)]).collect();
        panel = panel.with(Layer::named(points, Style::of_series(i), count.method.to_string()));
        // Three digits: the last sweeps before the stopping rule holds depend on rounding.
        let digits = |sweeps: usize| scientific(as_number(sweeps), 2);
        let rows = count.sweeps.iter().zip(&count.own);
        data = data.rows(rows.map(|((n, all), (_, own))| row![count.method, n, digits(*all), digits(*own)]));
    }
    let [least, most] = range(found.iter().map(|count| count.exponent)).ok_or("no method")?;
    study.drawn("nsor-sweeps", context! { least, most }, 1, vec![panel], data)
}

/// Of all grids of at most so many intervals, the share on which the four steps end at the optimum.
fn successes(study: &Study<'_>, found: &[four_step::Count]) -> Result<Drawn, Cause> {
    let y = Axis::new("optimal, of all grids up to N, in per cent").including(&[0.0, 100.0]);
    let mut panel = Panel::new(Axis::new("intervals N"), y).tall(620.0);
    let mut data = Table::new(["method", "intervals", "end_point", "optimal_up_to_here_in_percent"]);
    for (i, count) in found.iter().enumerate() {
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
        data = data.rows(count.by_grid.iter().zip(&shares).map(|((n, is), share)| {
            row![count.method, n, if *is { "optimal" } else { "not optimal" }, fixed(share[1], 1)]
        }));
        let style = Style { marker: None, ..Style::of_series(i) };
        panel = panel.with(Layer::named(shares, style, count.method.to_string()));
    }
    let optimal = || found.iter().map(|count| count.grids);
    let values = context! { least => optimal().min(), most => optimal().max(), grids => four_step::GRIDS };
    study.drawn("four-step-success", values, 1, vec![panel], data)
}

/// Every grid of the example between these numbers of intervals is looked at.
const COARSEST_LOOKED_AT: usize = 12;
const FINEST_LOOKED_AT: usize = 200;

/// What an engineer calls usable without asking.
const USABLE: f64 = 0.01;

/// The paper's advice, and what was measured of it.
pub(crate) fn recommendation(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let [paper, coarse, _] = &ledger.grids;
    let solved = |count: &four_step::Count| count.uneven.iter().sum::<usize>();
    let grid = |grid: &Errors| context! { intervals => grid.intervals, worst => grid.worst(), first_force => grid.first_force };
    let four_steps = || ledger.four_step.iter().map(solved);
    let of_nsor = |k: usize| {
        let thousands = ledger.nsor.iter().map(|count| 1e-3 * as_number(count.on_the_paper_grid()[k]));
        least_most(thousands)
    };
    Ok(Evidence::new(context! {
        usable => USABLE,
        coarsest => COARSEST_LOOKED_AT,
        finest => FINEST_LOOKED_AT,
        // From this many intervals on, end reaction, largest moment and deflection are usable on every grid looked at.
        safe => safe()?,
        paper => grid(paper),
        coarse => grid(coarse),
        uneven_scenes => 2 * four_step::SCENES,
        four_steps_fewest => four_steps().min(),
        four_steps_most => four_steps().max(),
        // Thousands of sweeps of NSOR: of all factors of the race for the best one, and of that one.
        race => of_nsor(0),
        sweeps => of_nsor(1),
    }))
}

/// One more than the finest grid that is not usable.
fn safe() -> Result<usize, SceneError> {
    for intervals in (COARSEST_LOOKED_AT..=FINEST_LOOKED_AT).rev() {
        if USABLE < errors(intervals)?.worst() {
            return Ok(intervals + 1);
        }
    }
    Ok(COARSEST_LOOKED_AT)
}
