//! A train that crosses a bridge: its sweep, and its envelope beside closed forms.

use palkki::plot::sweep;
use palkki::sweep::Sweep;

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
    let (mut walk, mut gathered, mut rows) = (swept.walk(), swept.gathered(), Vec::new());
    for value in swept.values() {
        let step = walk.solve(value)?;
        gathered.add(&step);
        rows.push(walk.row(step));
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
    let states: Vec<_> = rows.iter().map(|row| (row.value, &row.solution.state)).collect();
    let events = swept.events(&rows);
    let svg = sweep(&scene, swept.quantity(), &states, &events, &study.words("sweep-train", context! {})?.title)?;
    let data = Table::new(["first_axle", "deflection_max", "moment_max", "left", "right"]).rows(states.iter().map(
        |(value, state)| {
            let numbers = [state.deflection.max, state.moment.max, state.reactions.left, state.reactions.right];
            std::iter::once(fixed(*value, 5)).chain(numbers.map(|number| fixed(number, 5)))
        },
    ));
    let [from, to] = RANGE;
    let command = format!(
        "palkki sweep {}/bridge.toml --vary '{VARY}' --from {from} --to {to} --steps {STEPS} --envelope",
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
    .figure("sweep-train", svg, data)
}
