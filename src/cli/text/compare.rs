//! The routes of `compare`, one a row.

use super::super::compare::{Comparison, Difference};
use super::super::input::Input;
use super::super::labels::Labels;
use super::super::number::{magnitude, magnitude_at_most, result};
use super::super::table::{Row, table};

pub(in super::super) fn compare(input: &Input, comparison: &Comparison) -> String {
    let error =
        |difference: &Option<Difference>| difference.as_ref().map_or_else(|| "–".to_owned(), |d| magnitude(d.worst()));
    let rows: Vec<Row> = comparison
        .routes
        .iter()
        .map(|compared| {
            let answer = &compared.answer;
            vec![
                answer.method.to_owned(),
                answer.solver.to_owned(),
                answer.status.to_string(),
                answer.residual.map_or_else(|| "–".to_owned(), magnitude),
                answer.iterations.to_string(),
                magnitude(answer.seconds),
                result(answer.state.reactions.left),
                certified(answer.error),
                error(&compared.solver_error),
                error(&compared.model_error),
            ]
        })
        .collect();
    let reaction = Labels::of(input.scene.units()).force("left reaction");
    let header = [
        "method",
        "solver",
        "status",
        "residual",
        "iterations",
        "seconds",
        &reaction,
        "certified error",
        "solver error",
        "model error",
    ];
    let title = format!("{}, {} intervals", input.title(), comparison.intervals);
    let mut text = table(&title, &header, &rows).trim_start().to_owned();
    text.push_str(
        "\nCertified error: at most this far is the deflection from that of the beam, relative to its largest value.\n\
         Solver error: against the active-set answer on the same grid; model error: against beam theory.\n\
         These two are the worst relative difference among end reactions, energy and largest deflection.\n",
    );
    text
}

/// An error that is guaranteed, if there is one.
fn certified(error: f64) -> String {
    if error.is_finite() { magnitude_at_most(error) } else { "–".to_owned() }
}
