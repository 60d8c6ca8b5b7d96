//! What `certify` found about forces that somebody else computed.

use palkki::certificate::bounds::ViolationKind;
use palkki::route::Status;

use super::super::certify::Judgement;
use super::super::input::Input;
use super::super::labels::Labels;
use super::super::number::{magnitude, magnitude_at_most, result};
use super::super::table::{Row, list, table};
use super::{bounds, heading};

pub(in super::super) fn certify(input: &Input, judgement: &Judgement) -> String {
    let labels = Labels::of(input.scene.units());
    let mut text = heading(input);
    let share = judgement.certificate.deflection_error / judgement.certificate.deflection;
    let status = match judgement.status() {
        Status::Certified => {
            format!("certified: the deflection is certain to {} of its largest value", magnitude_at_most(share))
        }
        status if share.is_finite() => {
            format!("{status}: the deflection may be off by {} of its largest value", magnitude_at_most(share))
        }
        status => format!("{status}: nothing could be shown about these forces"),
    };
    let cut: f64 = judgement.load.pulling().iter().map(|f| -f.1).sum();
    let cut = match judgement.load.pulling().len() {
        0 => "none".to_owned(),
        count => format!("{count}, together {}", result(cut)),
    };
    text += &list(&[("status", status), (&labels.force("forces cut off"), cut)]);
    text += &bounds(&judgement.certificate, &labels);
    let best = magnitude_at_most(judgement.certificate.best_deflection_error);
    text += &list(&[(&labels.length("error of the best deflection found"), best)]);
    if judgement.violations.is_empty() {
        text += "\nViolations: none\n";
        return text;
    }
    let rows: Vec<Row> = judgement
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
    text += &table("Violations, the worst of each kind", &["", "amount", "relative", &labels.length("at")], &rows);
    text
}
