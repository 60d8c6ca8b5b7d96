//! `cargo xtask certificates`: the certificates of every route on every grid beside the truth, and fault injection: every fault
//! put into the answers. It takes minutes, so what comes out is kept in two files of data; the report computes a stated part of
//! them again each time.
//!
//! The name of a scene says where it is from, and so what its truth is: `NAME` is a scene of the gallery and `held/NAME` one that is
//! held otherwise, both beside beam theory; `closed/NAME` is one of [`palkki_evidence::closed`], beside its closed form.

pub(crate) mod answers;
pub(crate) mod faults;

use std::collections::BTreeSet;
use std::path::Path;

use palkki::route::{Method, Solver};
use palkki::scene::{Grid, Scene};
use palkki::{Settings, solve_raw};
use palkki_evidence::closed::{self, Closed};
use palkki_evidence::faults::Truth;
use rayon::prelude::*;

use crate::{Cause, data, scenes, tell};

/// The least number of intervals of which all grids here are multiples.
const DIVIDES: usize = 10;

/// What the names of scenes begin with that are held otherwise than by two supports at the ends.
pub(crate) const HELD: &str = "held/";
/// The same of those whose truth is a closed form.
pub(crate) const CLOSED: &str = "closed/";

/// A scene of the trial.
pub(crate) struct Subject {
    pub(crate) name: String,
    pub(crate) scene: Scene,
    closed: Option<Closed>,
}

impl Subject {
    pub(crate) fn truth(&self) -> Result<Truth<'_>, Cause> {
        Ok(match &self.closed {
            Some(closed) => Truth::closed(closed),
            None => Truth::of(&self.scene)?,
        })
    }
}

fn beside_theory((name, scene): (String, Scene)) -> Subject {
    Subject { name, scene, closed: None }
}

/// The gallery.
pub(crate) fn gallery(root: &Path) -> Result<Vec<Subject>, Cause> {
    Ok(scenes::all(root)?.into_iter().map(beside_theory).collect())
}

/// The scenes that are held otherwise and whose supports are at nodes of all grids.
fn held(root: &Path) -> Result<Vec<Subject>, Cause> {
    let on_grids =
        |scene: &Scene| Grid::least_fitting(scene).is_some_and(|intervals| DIVIDES.is_multiple_of(intervals));
    let held = scenes::held(root)?.into_iter().filter(|(_, scene)| on_grids(scene));
    Ok(held.map(|(name, scene)| beside_theory((format!("{HELD}{name}"), scene))).collect())
}

/// The names of the scenes that nothing holds, in which the beam touches at one node of the grid of the faults: it may turn about
/// it, and answers of two solvers may be two positions.
pub(crate) fn turning(root: &Path) -> Result<BTreeSet<String>, Cause> {
    let mut all = held(root)?;
    all.extend(in_closed_form()?);
    let settings = Settings::new(Method::Displacement, Solver::ActiveSet, faults::INTERVALS);
    let mut turning = BTreeSet::new();
    for Subject { name, scene, .. } in all {
        let state = solve_raw(&scene, &settings)?.state;
        if let [contact] = &state.contacts[..]
            && contact.to <= contact.from
            && state.standing.is_some()
        {
            turning.insert(name);
        }
    }
    Ok(turning)
}

fn in_closed_form() -> Result<Vec<Subject>, Cause> {
    let subject = |closed: Closed| Subject {
        name: format!("{CLOSED}{}", closed.name),
        scene: closed.scene.clone(),
        closed: Some(closed),
    };
    Ok(closed::held()?.into_iter().map(subject).collect())
}

/// Computes both files, as many scenes at once as the machine has cores. The rows are in the order of the scenes.
pub(crate) fn run(root: &Path) -> Result<(), Cause> {
    let (mut judged, mut broken) = (Vec::new(), Vec::new());
    for group in [gallery(root)?, held(root)?, in_closed_form()?] {
        let found = group.par_iter().with_max_len(1).map(|subject| -> Result<_, Cause> {
            let mut judged = Vec::new();
            for intervals in answers::GRIDS {
                tell(&format!("{}: every route on {intervals} intervals", subject.name));
                judged.extend(answers::rows(subject, &[intervals])?);
            }
            tell(&format!("{}: every fault", subject.name));
            Ok((judged, faults::rows(subject, &group)?))
        });
        for found in found.collect::<Vec<_>>() {
            let (answers, faults) = found?;
            judged.extend(answers);
            broken.extend(faults);
        }
    }
    data::write(root, answers::PATH, &judged)?;
    data::write(root, faults::PATH, &broken)?;
    tell("`cargo xtask report` renders the page from it");
    Ok(())
}
