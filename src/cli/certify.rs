//! The command `certify`: error bounds for contact forces that any program computed.

use palkki::Witness;
use palkki::certificate::{Certificate, ContactLoad, Judged, Violation, ViolationKind, violations_at_nodes};
use palkki::route::Status;
use palkki::scene::file::{FileError, Problem};
use palkki::state::Contact;
use palkki::text::{magnitude, magnitude_at_most};
use palkki::verdict::Verdict;

use super::arguments::{Certify, LoadArgument};
use super::input::Input;
use super::output::Failure;
use super::table::{Row, list, table};
use super::text::{bounds, heading};

/// The findings on given contact forces.
#[derive(Debug)]
pub(super) struct Finding {
    /// The forces.
    pub(super) load: ContactLoad,
    /// Number of equal intervals at whose nodes the load was lumped, if it was.
    pub(super) intervals: Option<usize>,
    /// Number of equal intervals at whose nodes the load may have been lumped although `--load` does not say so.
    pub(super) perhaps: Option<usize>,
    /// The bounds.
    pub(super) certificate: Certificate,
    /// The verdict from these bounds.
    pub(super) verdict: Verdict,
    /// The violated conditions, the worst first.
    pub(super) violations: Vec<Violation>,
}

impl Finding {
    /// Reads the forces and bounds the error of the deflection that they cause.
    pub(super) fn of(input: &Input, arguments: &Certify) -> Result<Self, Failure> {
        let forces = &arguments.forces;
        let rows = input.forces(forces)?;
        let scene = &input.scene;
        let witness = Witness::of(scene);
        let lumped = witness.lumped(rows.iter().copied());
        let own: Vec<Contact> =
            rows.iter().filter(|row| 0.0 < row.1).map(|&(x, force)| Contact::at(x, force)).collect();
        if arguments.load == LoadArgument::Nodal {
            let lumped = lumped.map_err(|error| Failure::NotLumped { path: forces.clone(), error })?;
            let certificate = witness.judge(Judged::Nodes(&lumped.nodes), &own).map_err(|e| input.error(e))?;
            let violations = violations_at_nodes(&lumped);
            let intervals = Some(lumped.intervals());
            let verdict = Verdict::of_forces(certificate.clone());
            return Ok(Self { load: lumped.load, intervals, perhaps: None, certificate, verdict, violations });
        }
        // Reading the forces has already rejected invalid ones.
        let load = ContactLoad::new(scene.beam().length(), rows).map_err(|_| {
            let name = forces.display().to_string();
            Failure::File(Box::new(FileError::whole(&name, Problem::ForcesWithoutHeader)))
        })?;
        let (certificate, violations) = witness.judge_forces(&load, &own).map_err(|error| input.error(error))?;
        let verdict = Verdict::of_forces(certificate.clone());
        let refused = verdict.status != Status::Certified;
        let perhaps = lumped.ok().filter(|_| refused).map(|lumped| lumped.intervals());
        Ok(Self { load, intervals: None, perhaps, certificate, verdict, violations })
    }
}

/// The findings as text.
pub(super) fn text(input: &Input, finding: &Finding) -> String {
    let labels = input.labels();
    let mut text = heading(finding.verdict.status, &finding.verdict.to_string(), input);
    let cut: f64 = finding.load.pulling().iter().map(|f| -f.1).sum();
    let cut = match finding.load.pulling().len() {
        0 => "none".to_owned(),
        count => format!("{count}, together {}", labels.number(cut)),
    };
    let load = finding.intervals.map_or_else(
        || "distributed".to_owned(),
        |intervals| format!("lumped at the nodes of {intervals} equal intervals"),
    );
    let mut lines = vec![("load", load)];
    if input.scene.ground_stiffness().is_some() && finding.intervals.is_none() {
        lines.push(("forces", "each spread over half the distance to its neighbours, as its spring is".to_owned()));
    }
    if input.scene.ground_stiffness().is_some() && !input.scene.beam().is_held() {
        lines.push(("position", "where the springs exert these forces as nearly as possible".to_owned()));
    }
    if !input.scene.is_firm() {
        lines.push(("supports that give", "exert what their law gives for these forces".to_owned()));
    }
    let cut_off = labels.force.name("forces cut off");
    lines.push((&cut_off, cut));
    text += &list(&lines);
    text += &bounds(&finding.certificate, &labels);
    let best = magnitude_at_most(finding.certificate.best_deflection_error);
    text += &list(&[(&labels.length.name("error of the best deflection found"), best)]);
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
                ViolationKind::Tension => labels.force.name("a force pulls"),
                ViolationKind::Penetration => labels.length.name("the beam is in the foundation"),
                ViolationKind::Complementarity => labels.length.name("a force acts across a clearance"),
                ViolationKind::SpringLaw => labels.force.name("a force is not that of its spring"),
                ViolationKind::Balance => labels.force.name("the forces do not balance the loads"),
            };
            vec![what, magnitude(v.amount), magnitude(v.relative), labels.number(v.at)]
        })
        .collect();
    let title = if finding.intervals.is_some() { "Violations at the nodes" } else { "Violations" };
    let title = format!("{title}, the worst of each kind");
    text += &table(&title, &["", "amount", "relative", &labels.length.name("at")], &rows);
    text + &hint
}
