//! A train that crosses a bridge: its sweep, and its envelope beside closed forms.

use palkki::plot;
use palkki::sweep::{Envelope, Sweep};

use super::prelude::*;

const VARY: &str = "load.point[*].at";
/// From where the first axle comes onto the bridge to where the last one leaves it.
const RANGE: [f64; 2] = [0.0, 25.8];
const STEPS: usize = 259;

/// Digits of the closed forms.
const AGREES: f64 = 1e-11;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = scenes::train(study.root, "bridge")?;
    let swept = Sweep::new(&scene, VARY, RANGE, STEPS)?;
    let (mut walk, mut gathered) = (swept.walk(), swept.gathered());
    for value in swept.values() {
        let step = walk.solve(value)?;
        gathered.add(&step);
        walk.row(step);
    }
    let envelope = gathered.envelope().ok_or("the train has no envelope")?;
    let axles = scene.point_loads();
    let (l, p, d) = (scene.beam().length(), axles[0].force, axles[0].at - axles[1].at);
    let (moment, reaction) = (0.5 * p * (l - 0.5 * d).powi(2) / l, p * (2.0 - d / l));
    let governing = &envelope.governing.moment_max;
    let forces = envelope.supports.iter().map(|support| (support.max - reaction).abs() / reaction);
    let off = largest(forces.chain([(governing.moment - moment).abs() / moment]));
    if AGREES < off {
        return Err(format!("the envelope of the train differs from its closed forms by {off:e}").into());
    }
    let svg = plot::envelope(&scene, VARY, &envelope)?;
    let header = ["x", "moment_max", "moment_min", "shear_max", "shear_min"];
    let data = Table::new(header).rows((0..envelope.x.len()).map(|i| {
        let Envelope { x, moment_max, moment_min, shear_max, shear_min, .. } = &envelope;
        [x, moment_max, moment_min, shear_max, shear_min].map(|values| fixed(values[i], 4))
    }));
    let [from, to] = RANGE;
    let command = format!(
        "palkki sweep {}/bridge.toml --vary '{VARY}' --from {from} --to {to} --steps {STEPS} --envelope --plot envelope-train.svg",
        scenes::TRAINS
    );
    Evidence::new(context! {
        command,
        moment => governing.moment,
        at => governing.at,
        value => governing.value,
        reaction,
        off => bound(off.max(f64::EPSILON)),
    })
    .figure("envelope-train", svg, data)
}
