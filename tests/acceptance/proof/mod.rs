//! Proofs of answers before the checker that shares nothing with the library, `report/check.rs`.

mod forged;
mod general;
mod reactions;
mod right;

use palkki::proof::Fields;
use palkki::scene::Scene;
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::check::{self, check};
use palkki_evidence::draft::Draft;

/// The text of a scene file.
fn text(scene: &Scene) -> String {
    Draft::from(scene).text()
}

/// The scene as the checker reads it.
#[track_caller]
pub(crate) fn read(text: &str) -> check::Scene {
    check::Scene::read(text, &|name| Err(format!("there is no {name}"))).unwrap_or_else(|why| panic!("{why}: {text}"))
}

/// What a proof proves of a scene: both energies, or the condition that it does not meet.
#[track_caller]
pub(crate) fn bracket(scene: &Scene, proof: &Fields) -> Result<[RBig; 2], String> {
    let json = serde_json::from_str(&proof.json()).expect("JSON");
    check(&read(&text(scene)), &json)
}
