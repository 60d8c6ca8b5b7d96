//! `cargo xtask certificates`: the certificates of every route on every grid for every scene of the gallery beside beam theory,
//! and fault injection: every fault put into the answers. It takes minutes, so what comes out is kept in two files of data; the
//! report computes a stated part of them again each time.

pub(crate) mod answers;
pub(crate) mod faults;

use std::path::Path;

use crate::{Cause, data, scenes, tell, workers};

/// Computes both files, as many scenes at once as the machine has cores. The rows are in the order of the scenes.
pub(crate) fn run(root: &Path) -> Result<(), Cause> {
    let scenes = scenes::all(root)?;
    let found = workers::each(&scenes, |(name, scene)| -> Result<_, Cause> {
        let mut judged = Vec::new();
        for intervals in answers::GRIDS {
            tell(&format!("{name}: every route on {intervals} intervals"));
            judged.extend(answers::rows(name, scene, &[intervals])?);
        }
        tell(&format!("{name}: every fault"));
        Ok((judged, faults::rows(name, scene, &scenes)?))
    });
    let (mut judged, mut broken) = (Vec::new(), Vec::new());
    for found in found {
        let (answers, faults) = found?;
        judged.extend(answers);
        broken.extend(faults);
    }
    data::write(root, answers::PATH, &judged)?;
    data::write(root, faults::PATH, &broken)?;
    tell("`cargo xtask report` renders the page from it");
    Ok(())
}
