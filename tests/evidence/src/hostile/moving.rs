//! What must be true of answers while a number of the scene varies: sweeps, and tolerances of the ground.

use palkki::scene::{Foundation, Scene};
use palkki::sweep::{Event, MOST_WORK, Row, Sweep};
use palkki::theory::{self, Exact};
use palkki::tolerance::{DepthTolerance, Touches};

use super::laws::{certified, exceeds, sizes};
use super::supports::moved;
use super::trial::Trial;
use crate::draft::Draft;
use crate::random::Random;

/// What an answer is made of, by the places of its contacts alone; [`None`] where a force is neither felt beside its contact nor not.
fn kinds(draft: &Draft, exact: &Exact) -> Option<Vec<(char, i64)>> {
    let length = draft.length;
    let mut kinds = Vec::new();
    for contact in &exact.state.contacts {
        let beside = |x: f64| exact.shear(x).into_iter().fold(0.0, |most: f64, shear| most.max(shear.abs()));
        let local = beside(contact.from).max(beside(contact.to)).max(contact.force.abs());
        let around = contact.from - 1e-3 * length..=contact.to + 1e-3 * length;
        if exact.state.supports.iter().any(|s| around.contains(&s.at)) || contact.force <= 1e-3 * local {
            return None;
        }
        let zone = contact.to - contact.from;
        // A stretch without weight carries nothing where it lies, and may be told as part of a zone or not.
        let idle = exact.pressure(0.5 * (contact.from + contact.to)) == 0.0;
        if 0.0 < zone && (idle || zone <= 1e-6 * length) {
            return None;
        }
        let kind = if 0.0 < zone { 'z' } else { 'p' };
        #[expect(clippy::cast_possible_truncation, reason = "crests are numbered by thousands at the most")]
        let place = match &draft.ground {
            Some(Foundation::Cosine { amplitude, wavelength, phase, .. }) if kind == 'p' && draft.shape.is_none() => {
                // Crests are where the depth is least.
                let crest = if *amplitude < 0.0 { 0.0 } else { 0.5 };
                let middle = 0.5 * (contact.from + contact.to);
                // Over waves that are bent less than the beam a contact slides from one to the next, through the trough.
                let number = 2.0 * std::f64::consts::PI / wavelength;
                let in_trough = 0.0 <= amplitude * libm::cos(number * middle + phase);
                if in_trough || amplitude.abs() * number * number * draft.stiffness <= exact.moment(middle).abs() {
                    return None;
                }
                (middle / wavelength + phase / (2.0 * std::f64::consts::PI) - crest).round() as i64
            }
            Some(Foundation::Polyline { points }) if kind == 'p' && draft.shape.is_none() => {
                points.iter().position(|p| (p[0] - contact.from).abs() <= 1e-9 * length).map_or(-1, |i| i as i64)
            }
            _ => 0,
        };
        kinds.push((kind, place));
    }
    Some(kinds)
}

/// A number of the scene to vary, with a range.
fn varied(draft: &Draft, scene: &Scene, random: &mut Random) -> Option<(String, [f64; 2])> {
    let length = draft.length;
    let size = 5.0 / 384.0 * scene.load().magnitude(length) / draft.stiffness * length * length * length;
    let mut paths: Vec<(String, [f64; 2])> = vec![
        ("beam.bending_stiffness".to_owned(), [draft.stiffness, draft.stiffness * random.pick(&[3.0, 10.0, 0.2])]),
        ("load.uniform".to_owned(), [draft.uniform, draft.uniform + scene.load().magnitude(length) / length]),
    ];
    for (i, load) in draft.point.iter().enumerate() {
        paths.push((
            format!("load.point[{i}].at"),
            [random.between(0.0, 0.4) * length, random.between(0.6, 1.0) * length],
        ));
        paths.push((format!("load.point[{i}].force"), [0.2 * load.force, 3.0 * load.force]));
    }
    for (i, support) in draft.supports.iter().flatten().enumerate() {
        paths.push((
            format!("beam.supports[{i}].level"),
            [support.level - size * random.between(0.01, 1.0), support.level],
        ));
    }
    match &draft.ground {
        Some(Foundation::Flat { depth }) => paths.push(("foundation.depth".to_owned(), [*depth, depth + size])),
        Some(Foundation::Cosine { mean, phase, .. }) => {
            paths.push(("foundation.cosine.mean".to_owned(), [*mean, mean + size]));
            paths.push(("foundation.cosine.phase".to_owned(), [*phase, phase + 3.0]));
        }
        _ => {}
    }
    let (path, [from, to]) = paths.swap_remove(random.below(paths.len()));
    (from.is_finite() && to.is_finite() && from < to || to < from)
        .then(|| (path, if random.once_in(2) { [from, to] } else { [to, from] }))
}

/// The events between rows, if they are found with the work that the program spends on them.
fn events(sweep: &Sweep<'_>, rows: &[Row]) -> Option<Vec<Event>> {
    let kinds: Vec<_> = rows.iter().map(|row| (row.value, row.pattern.clone())).collect();
    let found = sweep.events_within(&kinds, MOST_WORK);
    found.until.is_none().then_some(found.events)
}

/// The rows of a sweep are the answers of their scenes, between two of another kind there is an event, and events do not depend on
/// the number of rows.
pub(super) fn sweep(trial: &mut Trial, draft: &Draft, scene: &Scene, random: &mut Random) {
    let Some((path, range)) = varied(draft, scene, random) else { return };
    let steps = random.pick(&[5, 12, 31]);
    let Ok(sweep) = Sweep::new(scene, &path, range, steps) else { return };
    let Ok(rows) = sweep.rows() else { return };
    let Some(events) = events(&sweep, &rows) else { return };
    let span = (range[1] - range[0]).abs();
    let mut last: Option<(f64, Vec<(char, i64)>)> = None;
    for row in &rows {
        let fresh = sweep.scene(row.value).ok().and_then(|scene| Some((theory::solve(&scene).ok()?, scene)));
        let Some((exact, scene)) = fresh.filter(|(exact, _)| exact.solved && row.solution.verdict.refusal.is_none())
        else {
            last = None;
            continue;
        };
        let (force, _) = sizes(&scene, &exact.state);
        let pairs = exact.state.supports.iter().zip(&row.solution.state.supports);
        let off = pairs.fold(0.0_f64, |off, (a, b)| off.max((a.force - b.force).abs()));
        if exceeds(off, 1e-6 * force) {
            trial.wrong.push(format!("sweep of {path}: the row of {} is off by {off:e} of {force:e}", row.value));
        }
        let kind = kinds(draft, &exact).filter(|_| path != "foundation.cosine.phase");
        let now = kind.map(|kind| (row.value, kind));
        if let (Some((before, old)), Some((value, new))) = (&last, &now) {
            let reach = [before.min(*value) - 1e-9 * span, before.max(*value) + 1e-9 * span];
            let seen = events.iter().any(|event| reach[0] <= event.value && event.value <= reach[1]);
            if old != new && !seen {
                trial.wrong.push(format!("sweep of {path} over {range:?} in {steps}: from {old:?} at {before} to {new:?} at {value} without an event"));
            }
        }
        last = now;
    }
    trial.swept = true;
    in_other_steps(trial, scene, &path, range, steps, random);
}

/// Events do not depend on the number of rows.
fn in_other_steps(trial: &mut Trial, scene: &Scene, path: &str, range: [f64; 2], steps: usize, random: &mut Random) {
    let span = (range[1] - range[0]).abs();
    let finer = 2 * steps + random.below(40);
    // A sweep in 1009 steps costs as much as a hundred runs.
    let counts: &[usize] = match random.below(12) {
        0 if finer.is_multiple_of(4) => &[3, 101, 1009],
        0 => &[3, 101],
        1..=4 => &[steps, finer],
        _ => &[],
    };
    let found: Vec<(usize, Vec<Event>)> = counts
        .iter()
        .filter_map(|&count| {
            let sweep = Sweep::new(scene, path, range, count).ok()?;
            Some((count, events(&sweep, &sweep.rows().ok()?)?))
        })
        .collect();
    let alike = |a: f64, b: f64| (a - b).abs() <= 1e-9 * span + 1e-9 * a.abs();
    let missing =
        |some: &[Event], all: &[Event]| some.iter().find(|a| !all.iter().any(|b| alike(a.value, b.value))).cloned();
    for pair in found.windows(2) {
        let [(few, coarse), (more, fine)] = pair else { continue };
        // More rows may find what appears and goes again within a step; fewer may not find more.
        if let Some(event) = missing(coarse, fine) {
            trial.wrong.push(format!("sweep of {path} over {range:?}: in {few} there is {event:?}, in {more} not"));
        }
        if let Some(event) = missing(fine, coarse).filter(|_| fine.len() <= coarse.len()) {
            trial.wrong.push(format!("sweep of {path} over {range:?}: in {more} there is {event:?}, in {few} not"));
        }
    }
}

/// What is said of ground within a tolerance holds for ground that is drawn from it.
pub(super) fn tolerance(trial: &mut Trial, draft: &Draft, scene: &Scene, exact: &Exact, random: &mut Random) {
    let Some(ground) = &draft.ground else { return };
    let (_, size) = sizes(scene, &exact.state);
    let tolerance = size * random.pick(&[1e-6, 1e-3, 0.03, 0.3]);
    let told = DepthTolerance::of(scene, exact, tolerance);
    let carried = exact.state.standing.is_some() && draft.supports.as_ref().is_some_and(Vec::is_empty);
    if carried && told.contact != Touches::Certainly {
        trial.wrong.push(format!("tolerance: a free body touches {}", told.contact.name()));
    }
    for _ in 0..4 {
        let mut other = moved(ground, tolerance * random.pick(&[-1.0, 1.0, 0.5, -0.5]));
        if let Foundation::Polyline { points } = &mut other
            && random.once_in(2)
        {
            // Each depth by itself.
            let given = draft.points().iter().map(|p| p[1]);
            points.iter_mut().zip(given).for_each(|(p, depth)| p[1] = depth + tolerance * random.between(-1.0, 1.0));
        }
        let other = Draft { ground: Some(other), ..draft.clone() };
        let Some(there) = other.scene().ok().as_ref().and_then(certified) else { continue };
        let pressed = there.state.contact_force();
        let (force, _) = sizes(scene, &there.state);
        let touches = 1e-9 * force < pressed;
        let lifted = there.state.contacts.is_empty();
        if told.contact == Touches::Nowhere && touches || told.contact == Touches::Certainly && lifted {
            trial.wrong.push(format!("tolerance: {}, but {pressed:e} of {force:e} is carried", told.contact.name()));
        }
        let slack = 1e-9 * force * (size + tolerance);
        let [lower, upper] = told.energy;
        let energy = there.state.energy;
        if lower.is_some_and(|lower| energy + slack < lower) || upper.is_some_and(|upper| upper + slack < energy) {
            trial.wrong.push(format!("tolerance: an energy of {energy:e}, and not in [{lower:?}, {upper:?}]"));
        }
    }
}
