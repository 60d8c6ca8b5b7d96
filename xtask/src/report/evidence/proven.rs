//! A proof that anybody can check: `report/check.rs` as a page, and the proof of the example, whole.

use palkki::proof::prove;
use palkki_evidence::authority::check::{Scene, check};
use palkki_evidence::paper;

use super::in_one_file::page;
use super::prelude::*;
use crate::report::files;

/// The checker, and the scene whose proof is printed, below the root.
const PATH: &str = "report/check.rs";
const SCENE: &str = "report/scenes/heinisuo-1984.toml";

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (source, text) = (files::text(study.root, PATH)?, files::text(study.root, SCENE)?);
    let scene = paper::example()?;
    let proof = prove(&scene, &theory::solve(&scene)?)?;
    let read = Scene::read(&text, &|name| Err(format!("there is no {name}")))?;
    let bracket = check(&read, &serde_json::from_str(&proof.json())?)?;
    let [low, up] = bracket.each_ref().map(|energy| energy.to_f64().value());
    let values = context! {
        page => page(&source),
        lines => source.lines().count(),
        scene => SCENE,
        proof => proof.json().trim_end(),
        cells => proof.cells.len(),
        low => format!("{low:?}"),
        up => format!("{up:?}"),
        apart => (&bracket[1] - &bracket[0]).to_f64().value(),
        error => read.error(&bracket).ok_or("the example is held by two supports")?,
    };
    Ok(Evidence::new(values))
}
