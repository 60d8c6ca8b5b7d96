//! Guaranteed bounds for the continuous beam beside the true errors, on every scene of the gallery; and for contact forces
//! that other programs could have computed.

mod brought;
mod springs;

use minijinja::context;
use palkki::certificate::ACCEPTED_ERROR;
use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::{Settings, solve};
use palkki_evidence::faults::{THEORY, Truth};

use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::cell;
use crate::report::scenes;
use crate::report::study::Study;
use crate::report::table::Table;

/// Grids of the table.
const GRIDS: [usize; 3] = [30, 100, 300];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let header = GRIDS.iter().flat_map(|n| [format!("{n}, true"), format!("{n}, certified")]);
    let mut table = Table::new(std::iter::once("scene".to_owned()).chain(header));
    let (mut data, mut runs, mut held, mut sharp) = (Vec::new(), 0, 0, 0);
    for (_, scene) in scenes::all(study.root)? {
        let mut row = vec![scene.title().to_owned()];
        for intervals in GRIDS {
            let [truth, certified] = errors(&scene, intervals)?;
            let title = scene.title().replace(',', ";");
            data.push(vec![title, intervals.to_string(), scientific(truth, 2), scientific(certified, 2)]);
            row.extend([if truth == 0.0 { "0".to_owned() } else { cell(Some(truth), 2) }, cell(Some(certified), 2)]);
            runs += 1;
            held += usize::from(truth <= certified);
            sharp += usize::from(certified <= 1.1 * truth);
        }
        table = table.row(row);
    }
    let springs = brought::of_springs()?;
    let first_stiff = springs.iter().find(|spring| spring.accepted()).ok_or("some springs are stiff enough")?.exponent;
    let (svg, springs_csv) = springs::figure(&springs, first_stiff)?;
    let paper = brought::of_the_paper()?;
    let (libraries, met, passed, accepted) = brought::of_libraries(study)?;
    let values = context! {
        table => table.to_string(),
        runs, held, sharp,
        accepted => ACCEPTED_ERROR,
        sags => brought::sags()?.to_string(),
        forces => brought::table(paper.iter().chain(&springs)).to_string(),
        spaced => brought::SPACED,
        first_stiff => crate::report::numbers::power(first_stiff),
        libraries => libraries.to_string(),
        library_runs => context! { met, passed, accepted },
    };
    let header = ["scene", "intervals", "true_error", "certified_error"];
    Ok(Evidence::new(values).data("bounds", csv(&header, data)).figure("springs", svg, springs_csv))
}

/// The force method with the active set on one grid: how far its deflection is from beam theory, and how far it can be, over
/// the largest deflection.
fn errors(scene: &Scene, intervals: usize) -> Result<[f64; 2], Cause> {
    let truth = Truth::of(scene)?;
    let state = solve(scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals))?.state;
    let found = state.nodes.as_ref().and_then(|nodes| truth.nodes(nodes)).ok_or("an answer has nodes")?;
    let [error, certified] = [found.error, found.certificate.deflection_error].map(|e| e / truth.deflection);
    // Digits of an error that is rounding differ between machines.
    Ok([if error < THEORY { 0.0 } else { error }, certified])
}
