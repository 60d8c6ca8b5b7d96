//! The first nodal contact force jumps from grid to grid; the resultant at the lift-off point converges.

use palkki::methods::Method;
use palkki::plot::study::{Named, first_force};
use palkki::solvers::Solver;
use palkki::{Settings, solve};
use palkki_evidence::paper::convergence::Quantity;
use palkki_evidence::paper::example;

use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

/// All numbers of intervals from the coarsest to the finest.
const GRIDS: std::ops::RangeInclusive<u32> = 8..=400;
/// From here on the words speak of the range.
const FINE: u32 = 30;

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let theory = Quantity::PointForce.exact();
    let (mut first, mut resultant) = (Vec::new(), Vec::new());
    for n in GRIDS {
        let state = solve(&scene, &Settings::new(Method::Force, Solver::ActiveSet, usize::try_from(n)?))?.state;
        let shared = Quantity::PointForce.of(&state) / theory;
        let nodes = state.nodes.ok_or("a discretised state has nodes")?;
        let force = nodes.contact_force.into_iter().find(|force| 0.0 < *force).unwrap_or_default() / theory;
        first.push([f64::from(n), force]);
        resultant.push([f64::from(n), shared]);
    }
    let rows = first.iter().zip(&resultant).map(|(a, b)| vec![a[0].to_string(), fixed(a[1], 5), fixed(b[1], 5)]);
    let table = csv(&["intervals", "first_force_over_t", "resultant_over_t"], rows);
    let fine = |points: &[[f64; 2]], off: fn(f64) -> f64| -> [f64; 2] {
        let values = points.iter().filter(|p| f64::from(FINE) <= p[0]).map(|p| off(p[1]));
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], v| [least.min(v), most.max(v)])
    };
    let ([least, most], [_, worst]) = (fine(&first, |force| force), fine(&resultant, |force| (force - 1.0).abs()));
    let values = minijinja::context! {
        coarsest => GRIDS.start(), finest => GRIDS.end(), grids => first.len(), fine => FINE,
        least, most, worst, last => resultant.last().map(|p| (p[1] - 1.0).abs()),
    };
    let svg = first_force(
        "The first nodal force jumps from grid to grid, the resultant does not",
        "Circles: contact force at the first node in contact over the point force T of beam theory, one for each number of \
         intervals; they scatter and do not settle. Line: the resultant of the contact forces at the lift-off point over T, \
         which tends to the dashed line at one.",
        &Named { label: "first nodal force", points: first },
        &Named { label: "resultant", points: resultant },
    )?;
    Ok(Evidence::new(values).figure("first-force", svg, table))
}
