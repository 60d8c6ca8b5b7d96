//! The gallery on one sheet: every scene with its exact solution, small.

use palkki::plot::{Curves, sheet};
use palkki::theory;

use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::scenes;
use crate::report::study::Study;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (mut solved, mut rows) = (Vec::new(), Vec::new());
    for (name, scene) in scenes::all(study.root)? {
        let curves = Curves::exact(&scene, &theory::solve(&scene)?);
        rows.extend(curves.point_forces.iter().map(|f| vec![name.clone(), fixed(f.at, 5), fixed(f.force, 5)]));
        solved.push((name, scene, curves));
    }
    let svg = sheet(
        "The gallery: the exact solution of every scene",
        "Small pictures of all scenes: ground, deflected beam, contact zones as thick lines, concentrated contact forces as \
         arrows, to scale within a picture.",
        solved.iter().map(|(name, scene, curves)| (name.as_str(), scene, curves)),
    )?;
    let values = minijinja::context! { scenes => solved.len() };
    Ok(Evidence::new(values).figure("sheet", svg, csv(&["scene", "x", "contact_force"], rows)))
}
