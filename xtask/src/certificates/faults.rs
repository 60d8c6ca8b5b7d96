//! Fault injection: faults put into the answers of every route, and what our check and the certificate make of them.

use std::collections::BTreeMap;

use palkki::certificate::{CERTIFIED_RESIDUAL, Kkt};
use palkki::methods::Method;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::state::ContactState;
use palkki::{Settings, solve_raw};
use palkki_evidence::faults::{
    CONTACT_FAULTS, Certified, Distance, FAULTS, SIZES, Truth, every_contact_fault, every_fault, every_second,
    scaled_ground, scaled_load,
};

use serde::{Deserialize, Serialize};

use super::Subject;
use crate::{Cause, data};

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/faults.csv";

/// Intervals of the grid: few, so that every solver takes part.
pub(crate) const INTERVALS: usize = 20;

/// The scene that is computed with every report.
pub(crate) const AGAIN: &str = "heinisuo-1984";

/// Sizes of the faults for which a scene has to be solved anew.
const FOREIGN_SIZES: [f64; 5] = [1e-10, 1e-8, 1e-6, 1e-4, 1e-2];

/// What the names of faults in exact answers begin with.
pub(crate) const EXACT: &str = "exact: ";

/// Whether a fault is tried in several sizes.
pub(crate) fn is_sized(fault: &str) -> bool {
    let named = FAULTS.iter().any(|f| f.sized && f.name == fault);
    let exact = fault.strip_prefix(EXACT).is_some_and(|name| CONTACT_FAULTS.iter().any(|f| f.sized && f.name == name));
    named || exact || fault == DEEPER || fault == HEAVIER
}

/// Answers that were not computed again.
const DEEPER: &str = "the answer for ground so much deeper";
const HEAVIER: &str = "the answer for so much more load";

/// What became of one fault in the answers of one scene.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) scene: String,
    pub(crate) fault: String,
    /// All answers with this fault.
    answers: usize,
    /// Answers that the check of the discrete problem refused, and that it let pass.
    pub(crate) refused: usize,
    pub(crate) passed: usize,
    /// The largest size of the fault that passed; 0 if none did, or if it has no size.
    #[serde(serialize_with = "data::power")]
    pub(crate) largest_passed: f64,
    /// How far what passed was from the solution, forces excepted.
    #[serde(serialize_with = "data::three_digits")]
    pub(crate) off_by: f64,
    /// Answers whose certificate is a finite number and true, is infinite, is none.
    pub(crate) bounded: usize,
    pub(crate) unbounded: usize,
    pub(crate) no_numbers: usize,
    /// Answers about which something untrue was guaranteed.
    pub(crate) exceptions: usize,
}

impl Row {
    fn verdict(&mut self, passed: Option<Distance>, size: f64) {
        self.answers += 1;
        match passed {
            None => self.refused += 1,
            Some(distance) => {
                self.passed += 1;
                self.largest_passed = self.largest_passed.max(size);
                self.off_by = self.off_by.max(distance.shape());
            }
        }
    }

    fn certified(&mut self, judged: Option<&Certified>) {
        match judged {
            None => self.no_numbers += 1,
            Some(judged) if !judged.false_bounds.is_empty() => self.exceptions += 1,
            Some(judged) if judged.certificate.deflection_error.is_finite() => self.bounded += 1,
            Some(_) => self.unbounded += 1,
        }
    }
}

/// Every fault in the answers of one scene by all routes; `all` are the scenes whose answers are put into its place.
pub(crate) fn rows(subject: &Subject, all: &[Subject]) -> Result<Vec<Row>, Cause> {
    let (name, scene) = (subject.name.as_str(), &subject.scene);
    let mut trial = Trial { truth: subject.truth()?, rows: Vec::new(), places: BTreeMap::new(), name };
    for method in Method::ALL {
        let sound = answer(scene, method, Solver::ActiveSet, INTERVALS)?;
        for solver in Solver::ALL {
            let state = answer(scene, method, solver, INTERVALS)?;
            for (fault, size, broken) in every_fault(&state, scene) {
                trial.judge(fault.name, size, &sound, &broken);
            }
            for size in FOREIGN_SIZES {
                let stale = [(DEEPER, scaled_ground(scene, size)), (HEAVIER, scaled_load(scene, size))];
                for (fault, other) in stale {
                    let other = match other {
                        // Ground at a negative depth comes up, and may come above a support.
                        Err(SceneError::AboveSupport { .. }) => continue,
                        other => other?,
                    };
                    trial.judge(fault, size, &sound, &answer(&other, method, solver, INTERVALS)?);
                }
            }
            let finer = answer(scene, method, solver, 2 * INTERVALS)?;
            trial.judge("every second node of a finer grid", 0.0, &sound, &every_second(&finer));
            for other in all {
                if other.name != name {
                    trial.judge(
                        "the answer of another scene",
                        0.0,
                        &sound,
                        &answer(&other.scene, method, solver, INTERVALS)?,
                    );
                }
            }
        }
    }
    trial.contacts();
    Ok(trial.rows)
}

fn answer(scene: &Scene, method: Method, solver: Solver, intervals: usize) -> Result<ContactState, Cause> {
    Ok(solve_raw(scene, &Settings::new(method, solver, intervals))?.state)
}

struct Trial<'a> {
    name: &'a str,
    truth: Truth<'a>,
    rows: Vec<Row>,
    /// Where the row of each fault is.
    places: BTreeMap<String, usize>,
}

impl Trial<'_> {
    fn row(&mut self, fault: &str) -> &mut Row {
        let next = self.rows.len();
        let place = *self.places.entry(fault.to_owned()).or_insert(next);
        if place == next {
            self.rows.push(Row { scene: self.name.to_owned(), fault: fault.to_owned(), ..Row::default() });
        }
        &mut self.rows[place]
    }

    fn judge(&mut self, fault: &str, size: f64, sound: &ContactState, broken: &ContactState) {
        let scene = self.truth.scene;
        let length = scene.beam().length();
        let passes = Kkt::of(scene, broken).is_some_and(|kkt| kkt.holds());
        let distance = passes.then(|| Distance::between(sound, broken, length, scene.load().magnitude(length)));
        let judged = broken.nodes.as_ref().and_then(|nodes| self.truth.nodes(nodes));
        let row = self.row(fault);
        row.verdict(distance, size);
        row.certified(judged.as_ref());
    }

    /// The contacts of the truth. They pass if the deflection that they make is certain to the share that the check
    /// of a discrete problem asks for.
    fn contacts(&mut self) {
        let contacts = self.truth.contacts.clone();
        let length = self.truth.scene.beam().length();
        for (fault, size, broken) in every_contact_fault(&contacts, length, &SIZES) {
            let judged = self.truth.contacts(&broken);
            let share = judged
                .as_ref()
                .map_or(f64::INFINITY, |judged| judged.certificate.deflection_error / self.truth.deflection);
            let passed = share <= CERTIFIED_RESIDUAL;
            let row = self.row(&format!("{EXACT}{}", fault.name));
            row.verdict(passed.then(|| Distance { deflection: share, ..Distance::default() }), size);
            row.certified(judged.as_ref());
        }
    }
}
