//! Beams on any supports and with own shapes, and bodies that merely lie there, up to the border at which they turn over.

use palkki::scene::{Foundation, PointLoad, Support};

use crate::authority::number::Number;
use crate::authority::statics::resultant_and_moment;
use crate::draft::Draft;
use crate::random::Random;

use super::near::beside;
use super::scenes::{ground, ordinary, power, rough, sag, ties};

fn beam(random: &mut Random) -> Draft {
    match random.below(4) {
        0 => ordinary(random),
        1 => rough(random),
        _ => ties(random),
    }
}

/// A place at which something is.
fn place(random: &mut Random, draft: &Draft) -> f64 {
    let places = draft.places();
    places[random.below(places.len())]
}

/// A support on the ground, above it, at the level of the unloaded beam, anywhere; now and then below the ground.
fn support(random: &mut Random, draft: &Draft, at: f64) -> Support {
    let unit = sag(draft) * power(random, -3.0, 0.0);
    let depth = |profile: &Option<Foundation>| profile.as_ref().map(|profile| profile.sides(at)[random.below(2)]);
    let [ground, own] = [&draft.ground, &draft.shape].map(depth);
    let level = match random.below(6) {
        0 | 1 => ground.map_or(0.0, |[depth, _]| depth),
        2 => own.map_or(0.0, |[depth, _]| depth),
        3 => 0.0,
        _ => unit * random.between(-0.3, 1.0),
    };
    let above = ground.map_or(level, |[depth, _]| level.min(depth));
    let slope = match random.below(9) {
        0 => Some(0.0),
        1 => ground.map(|[_, slope]| slope),
        2 => own.map(|[_, slope]| slope),
        3 => Some(unit / draft.length * random.between(-1.0, 1.0)),
        _ => None,
    };
    Support { level: if random.once_in(30) { level } else { above }, slope, ..Support::simple(at) }
}

/// So many supports, most of them where a coarse grid has a node.
pub(super) fn supports(random: &mut Random, draft: &Draft, count: usize) -> Vec<Support> {
    let parts = random.pick(&[2, 3, 4, 5, 6, 8, 12]);
    let places = (0..count).map(|_| match random.below(8) {
        0 => 0.0,
        1 => draft.length,
        2 => random.between(0.0, draft.length),
        3 => place(random, draft),
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        _ => draft.length * random.below(parts + 1) as f64 / parts as f64,
    });
    let mut places: Vec<f64> = places.collect();
    if !random.once_in(30) {
        places.sort_by(f64::total_cmp);
        places.dedup();
    }
    places.into_iter().map(|at| support(random, draft, at)).collect()
}

/// Straight beams on one to five supports.
pub(super) fn supported(random: &mut Random) -> Draft {
    let draft = beam(random);
    let count = 1 + random.below(5);
    Draft { supports: Some(supports(random, &draft, count)), ..draft }
}

/// Beams with an own shape of any kind, on the supports that are there by default or on any others.
pub(super) fn shaped(random: &mut Random) -> Draft {
    let mut draft = beam(random);
    let rise = sag(&draft) * power(random, -5.0, 0.3);
    draft.shape = Some(ground(random, draft.length, rise));
    let count = random.below(5);
    if !random.once_in(3) {
        draft.supports = Some(supports(random, &draft, count));
    }
    draft
}

/// Bodies on the ground, on it and one support, or in balance on one support without it.
pub(super) fn lying(random: &mut Random) -> Draft {
    let mut draft = beam(random);
    if random.once_in(3) {
        let rise = sag(&draft) * power(random, -5.0, 0.3);
        draft.shape = Some(ground(random, draft.length, rise));
    }
    let mut held = if random.once_in(3) { supports(random, &draft, 1) } else { Vec::new() };
    held.iter_mut().for_each(|support| support.slope = None);
    draft.supports = Some(held);
    draft
}

/// The same with a load at an end that brings the resultant to the outermost place that can carry it, or beside it, by as little
/// as the last digit of the loads.
pub(super) fn margins(random: &mut Random) -> Draft {
    let mut draft = lying(random);
    let about = match draft.supports.as_deref() {
        Some([support, ..]) => support.at,
        _ => random.pick(&[0.0, draft.length]),
    };
    if random.once_in(3) {
        // A weight just above that place, and nothing else.
        (draft.uniform, draft.linear, draft.point) = (0.0, Vec::new(), Vec::new());
    }
    draft.point.push(PointLoad { at: about, force: draft.length });
    let far = if about < 0.5 * draft.length { draft.length } else { 0.0 };
    let moment = draft.load().ok().and_then(|load| Some((resultant_and_moment(&load, draft.length, about)?, load)));
    if let Some(([_, moment], load)) = moment {
        let share = random.pick(&[0.0, 0.0, 1e-15, 1e-13, 1e-9, 1e-3]) * random.pick(&[1.0, -1.0]);
        let force = share * load.magnitude(draft.length) - moment.to_double() / (far - about);
        draft.point.push(PointLoad { at: far, force });
    }
    draft
}

/// Supports beside each other, beside loads and beside points of the ground, from the last bit to a millionth of the beam away, and
/// now and then beyond the end of the beam.
pub(super) fn crowded(random: &mut Random) -> Draft {
    let mut draft = if random.once_in(2) { supported(random) } else { shaped(random) };
    let mut all = draft.all_supports();
    for _ in 0..1 + random.below(2) {
        let near =
            if all.is_empty() || random.once_in(2) { place(random, &draft) } else { all[random.below(all.len())].at };
        let at = beside(random, near, draft.length);
        all.push(support(random, &draft, at));
    }
    if random.once_in(12) {
        let last = all.len() - 1;
        all[last].at = random.pick(&[draft.length.next_up(), -5e-324, -0.0, 2.0 * draft.length]);
    }
    draft.supports = Some(all);
    draft
}
