//! What `certify` found about contact forces that some program computed.

use palkki::certificate::bounds::ViolationKind;
use palkki::route::Status;

use super::super::certify::Finding;
use super::super::input::Input;
use super::super::labels::Labels;
use super::super::number::{magnitude, magnitude_at_most, result};
use super::super::table::{Row, list, table};
use super::{bounds, heading};

pub(in super::super) fn certify(input: &Input, finding: &Finding) -> String {
    let labels = Labels::of(input.scene.units());
    let mut text = heading(input);
    let share = finding.certificate.deflection_error / finding.certificate.deflection;
    let status = match finding.status() {
        Status::Certified => {
            format!("certified: the deflection is certain to {} of its largest value", magnitude_at_most(share))
        }
        status if share.is_finite() => {
            format!("{status}: the deflection may be off by {} of its largest value", magnitude_at_most(share))
        }
        status => format!("{status}: nothing could be shown about these forces"),
    };
    let cut: f64 = finding.load.pulling().iter().map(|f| -f.1).sum();
    let cut = match finding.load.pulling().len() {
        0 => "none".to_owned(),
        count => format!("{count}, together {}", result(cut)),
    };
    let load = finding.intervals.map_or_else(
        || "distributed".to_owned(),
        |intervals| format!("lumped at the nodes of {intervals} equal intervals"),
    );
    text += &list(&[("status", status), ("load", load), (&labels.force("forces cut off"), cut)]);
    text += &bounds(&finding.certificate, &labels);
    let best = magnitude_at_most(finding.certificate.best_deflection_error);
    text += &list(&[(&labels.length("error of the best deflection found"), best)]);
    let hint = finding.perhaps.map_or_else(String::new, |intervals| {
        format!(
            "\nHint: the forces lie at the nodes of {intervals} equal intervals. If the load was lumped there as well, use --load nodal.\n"
        )
    });
    if finding.violations.is_empty() {
        return text + "\nViolations: none\n" + &hint;
    }
    let rows: Vec<Row> = finding
        .violations
        .iter()
        .map(|v| {
            let what = match v.kind {
                ViolationKind::Tension => labels.force("a force pulls"),
                ViolationKind::Penetration => labels.length("the beam is in the foundation"),
                ViolationKind::Complementarity => labels.length("a force acts across a clearance"),
            };
            vec![what, magnitude(v.amount), magnitude(v.relative), result(v.at)]
        })
        .collect();
    let title = if finding.intervals.is_some() { "Violations at the nodes" } else { "Violations" };
    let title = format!("{title}, the worst of each kind");
    text += &table(&title, &["", "amount", "relative", &labels.length("at")], &rows);
    text + &hint
}
