//! A scene in other units has the same answer, to the bit where the units are powers of two.

use crate::draft::{Draft, Units};
use crate::random::Random;
use palkki::scene::Scene;
use palkki::state::ContactState;
use palkki::theory::{self, Exact};
use palkki::{Settings, solve_raw};

use super::laws::name;
use super::trial::{Trial, read};

/// The same bits in units that are powers of two, where neither scene leaves the range of 64-bit floating point on the way.
pub(super) fn in_other_units(
    trial: &mut Trial,
    draft: &Draft,
    scene: &Scene,
    exact: Option<&Exact>,
    settings: &Settings,
    random: &mut Random,
) {
    let mut unit = || random.pick(&[0.25, 8.0, 1024.0, 0.000_976_562_5]);
    let (length, force, depth) = (unit(), unit(), unit());
    let there = draft.in_units(Units { length, depth, force });
    let back = there.in_units(Units { length: 1.0 / length, depth: 1.0 / depth, force: 1.0 / force });
    // Subnormal numbers lose bits on the way.
    if back.text() != draft.text() {
        return;
    }
    let Ok(other) = read(&there.text()) else { return };
    let exactly_scaled = scene.scaled().ok().zip(other.scaled().ok()).is_some_and(|(a, b)| a.scene == b.scene);
    if !exactly_scaled {
        return;
    }
    let forces = |state: &ContactState| state.supports.iter().map(|s| s.force).collect::<Vec<f64>>();
    let bits = |state: &ContactState, unit: f64| {
        forces(state).into_iter().chain([state.contact_force()]).map(|f| (f * unit).to_bits()).collect::<Vec<u64>>()
    };
    let mut compare = |who: &str, a: (&ContactState, bool), b: (&ContactState, bool)| {
        let subnormal = |state: &ContactState| {
            let c = state.contacts.iter().map(|c| c.force);
            forces(state).into_iter().chain(c).any(f64::is_subnormal)
        };
        if subnormal(a.0) || subnormal(b.0) {
            return;
        }
        trial.rescaled = true;
        if a.1 != b.1 || bits(a.0, force) != bits(b.0, 1.0) {
            trial.wrong.push(format!("{who}: other units, other bits"));
        }
    };
    if let (Some(a), Ok(b)) = (exact, theory::solve(&other)) {
        compare("theory", (&a.state, a.solved), (&b.state, b.solved));
    }
    if let (Ok(a), Ok(b)) = (solve_raw(scene, settings), solve_raw(&other, settings)) {
        compare(&name(settings), (&a.state, a.solved), (&b.state, b.solved));
    }
}
