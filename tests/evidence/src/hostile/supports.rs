//! Scenes about what stands beside a support: loads and edges, other supports, forces that dwarf all others, ground at its level; bodies
//! in balance; and scenes in tiny units.

use palkki::scene::{Foundation, LinearLoad, PointLoad, Support};

use crate::draft::{Draft, Units};
use crate::random::Random;

use super::edges::spiky;
use super::held::{supported, supports};
use super::near::chebyshev_sum;
use super::scenes::{beam_with_loads, ground, ordinary, power, sag, ties};

/// On a place, or as much as a millionth of the length beside it, from the last bit on.
fn on_or_beside(random: &mut Random, x: f64, length: f64) -> f64 {
    let share = match random.below(8) {
        0..=3 => 0.0,
        4 => f64::EPSILON,
        _ => power(random, -13.0, -6.0),
    };
    (x + random.pick(&[share, -share]) * length).clamp(0.0, length)
}

/// A beam on two to four supports, an end or not, all of them level or nearly so, without ground yet.
fn beam(random: &mut Random, most: usize) -> Draft {
    let draft = if random.once_in(4) { ties(random) } else { beam_with_loads(random, 4) };
    let length = draft.length;
    let count = 2 + random.below(most - 1);
    let mut places: Vec<f64> = (0..count)
        .map(|_| match random.below(4) {
            0 => random.pick(&[0.0, 1.0]),
            1 => random.pick(&[0.2, 0.5, 0.8]),
            _ => random.between(0.0, 1.0),
        })
        .map(|share| share * length)
        .collect();
    places.sort_by(f64::total_cmp);
    places.dedup_by(|next, last| *next - *last < 1e-3 * length);
    let unit = sag(&draft) * power(random, -4.0, 0.0);
    let support = |at: f64| Support {
        level: if random.once_in(3) { unit * random.between(-1.0, 1.0) } else { 0.0 },
        slope: random.once_in(8).then_some(0.0),
        ..Support::simple(at)
    };
    Draft { supports: Some(places.into_iter().map(support).collect()), ground: None, ..draft }
}

/// Ground below all supports: what is above the level of one is lowered as a whole.
fn lowered(random: &mut Random, draft: &Draft, ground: Foundation) -> Foundation {
    let above = |s: &Support| {
        let [[left, _], [right, _]] = ground.sides(s.at);
        s.level - left.min(right)
    };
    let most = draft.all_supports().iter().map(above).fold(0.0, f64::max);
    let down = if random.once_in(4) { most } else { most * random.between(1.0, 1.5) };
    moved(&ground, if 0.0 < most { down.max(most.next_up()) } else { 0.0 })
}

/// The same profile, so much deeper.
pub(super) fn moved(ground: &Foundation, down: f64) -> Foundation {
    let mut ground = ground.clone();
    match &mut ground {
        Foundation::Flat { depth } => *depth += down,
        Foundation::Polynomial { coefficients } => coefficients[0] += down,
        Foundation::Cosine { mean, .. } => *mean += down,
        Foundation::Polyline { points } => points.iter_mut().for_each(|p| p[1] += down),
    }
    ground
}

/// Loads that start, end and stand at supports, and points and steps of the ground there.
pub(super) fn at_supports(random: &mut Random) -> Draft {
    let mut draft = beam(random, 4);
    let length = draft.length;
    let places: Vec<f64> = draft.all_supports().iter().map(|s| s.at).chain([0.0, length]).collect();
    let place = |random: &mut Random| {
        let at = places[random.below(places.len())];
        on_or_beside(random, at, length)
    };
    if draft.linear.is_empty() {
        draft.linear.push(LinearLoad { from: 0.0, to: length, start: 1.0, end: 1.0 });
    }
    for part in &mut draft.linear {
        let (a, b) = (place(random), place(random));
        if a < b || b < a {
            (part.from, part.to) = (a.min(b), a.max(b));
        }
    }
    for part in &mut draft.point {
        part.at = place(random);
    }
    if random.once_in(6) {
        // One load, and nothing else that bends the beam.
        (draft.uniform, draft.linear) = (0.0, Vec::new());
        draft.point = vec![PointLoad { at: place(random), force: 1.0 }];
    }
    if random.once_in(4) {
        return draft;
    }
    let depth = sag(&draft) * power(random, -3.0, 0.0);
    let mut profile = ground(random, length, depth);
    if let Foundation::Polyline { points } = &mut profile {
        for support in draft.all_supports() {
            let at = on_or_beside(random, support.at, length);
            let apart = points.iter().all(|p| p[0] < at || at < p[0]);
            if 0.0 < at && at < length && apart {
                let step = if random.once_in(2) { 2 } else { 1 };
                (0..step).for_each(|_| points.push([at, depth * random.between(0.0, 1.0)]));
            }
        }
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    }
    draft.ground = Some(lowered(random, &draft, profile));
    draft
}

/// Five to forty supports, some of them a ten-thousandth of the length apart.
pub(super) fn many(random: &mut Random) -> Draft {
    let mut draft = beam(random, 2);
    let length = draft.length;
    let count = u32::try_from(5 + random.below(36)).unwrap_or(5);
    let mut places: Vec<f64> = (0..count)
        .map(|k| match random.below(3) {
            0 => random.between(0.0, length),
            _ => length * f64::from(k) / f64::from(count - 1),
        })
        .collect();
    for _ in 0..random.below(3) {
        let at = places[random.below(places.len())];
        places.push((at + length * power(random, -4.0, -2.0)).min(length));
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    let span = 1.0 / f64::from(count);
    let unit = sag(&draft) * span * span * span;
    let levels = random.pick(&[0.0, 0.0, 0.1, 1.0]);
    let support = |at| Support { level: unit * levels * random.between(-1.0, 1.0), ..Support::simple(at) };
    draft.supports = Some(places.into_iter().map(support).collect());
    if !random.once_in(4) {
        let depth = unit * power(random, -2.0, 0.5);
        let profile = ground(random, length, depth);
        draft.ground = Some(lowered(random, &draft, profile));
    }
    draft
}

/// Forces of `10¹³` on a support or beside it, or by two built-in supports close together.
pub(super) fn dwarfed(random: &mut Random) -> Draft {
    let mut draft = at_supports(random);
    let length = draft.length;
    let mut all = draft.all_supports();
    let beside = all[random.below(all.len())].at;
    if random.once_in(3) {
        let near = (beside + 2e-4 * length * random.pick(&[1.0, -1.0])).clamp(0.0, length);
        let level = all.iter().map(|s| s.level).fold(f64::INFINITY, f64::min);
        all.push(Support { level, slope: Some(0.0), ..Support::simple(near) });
        draft.supports = Some(all);
    } else {
        let at = if random.once_in(2) { beside } else { on_or_beside(random, beside, length) };
        draft.point.push(PointLoad { at, force: power(random, 6.0, 13.0) * random.pick(&[1.0, 1.0, -1.0]) });
    }
    draft
}

/// Bodies whose resultant is exactly above a crest of the ground or a support, mostly weightless.
pub(super) fn balanced(random: &mut Random) -> Draft {
    let length = random.pick(&[8.0, 10.0, 16.0]);
    let stiffness = power(random, 0.0, 4.0);
    let parts = 4 + 2 * random.below(4);
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let place = |k: usize| length * k as f64 / parts as f64;
    // Crests at the odd places; one of them higher than the line between any others.
    let crest = 1 + 2 * random.below(parts / 2);
    let deep = |random: &mut Random| 0.125 * (8 + random.below(24)) as f64;
    let points: Vec<[f64; 2]> = (0..=parts)
        .map(|k| match k {
            _ if k == crest => [place(k), 0.125],
            _ if k % 2 == 1 => [place(k), 0.125 * (1 + random.below(8)) as f64],
            _ => [place(k), deep(random)],
        })
        .collect();
    let at = place(crest);
    let draft = Draft { length, stiffness, ground: Some(Foundation::Polyline { points }), ..Draft::default() };
    let draft = Draft { supports: Some(Vec::new()), ..draft };
    let size = random.pick(&[1.0, 3.0, 0.7]);
    let arm = random.pick(&[0.25, 0.5, 1.0]);
    match random.below(5) {
        // The load on the crest.
        0 | 1 => draft.with_points(&[(at, size)]),
        // Two loads, one at each side of it.
        2 => draft.with_points(&[(at - arm, size), (at + arm, size)]),
        // A seesaw: a support in the place of the crest.
        3 => {
            let supports = Some(vec![Support::simple(at)]);
            Draft { supports, ..draft.with_points(&[(at, size)]) }
        }
        // A load at each side of the highest, or a load for each post.
        _ => {
            let other = place(1 + 2 * random.below(parts / 2));
            draft.with_points(&[(at, size), (other, size * random.pick(&[0.0, 1.0]))])
        }
    }
}

/// Ground at the level of a support, tangent to the beam there, or off it by next to nothing.
pub(super) fn level(random: &mut Random) -> Draft {
    let mut draft = beam(random, 3);
    let length = draft.length;
    let mut all = draft.all_supports();
    let unit = sag(&draft).max(power(random, -3.0, 0.0));
    let off = unit * random.pick(&[0.0, 1e-16, 1e-14, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3]);
    let chosen = random.below(all.len());
    let (at, depth) = (all[chosen].at, all[chosen].level);
    // The other supports are above that, and lift the beam off the ground by what it takes.
    for (i, support) in all.iter_mut().enumerate() {
        support.slope = None;
        if i != chosen {
            support.level =
                (support.level).min(depth) - unit * random.pick(&[0.0, 0.1, 1.0]) * random.between(0.0, 1.0);
        }
    }
    draft.supports = Some(all);
    let curvature = unit / (length * length) * random.pick(&[0.0, 0.1, 1.0]);
    let profile = match random.below(3) {
        0 => Foundation::Flat { depth: depth + off },
        1 => {
            // It touches the level of the support from below.
            let coefficients = vec![depth + off + curvature * at * at, -2.0 * curvature * at, curvature];
            Foundation::Polynomial { coefficients }
        }
        _ => {
            let fall = unit * random.pick(&[0.0, 1e-9, 1e-3, 0.3]);
            let mut points = vec![[0.0, depth + fall + off], [at, depth + off], [length, depth + fall + off]];
            points.dedup_by(|a, b| a[0] <= b[0]);
            Foundation::Polyline { points }
        }
    };
    draft.ground = Some(profile);
    if random.once_in(2) {
        let amplitude = unit * random.pick(&[0.01, 0.05, 0.3]);
        let wavelength = length * random.pick(&[1.0, 2.0, 0.7]);
        draft.shape = Some(Foundation::Cosine { mean: 0.0, amplitude, wavelength, phase: 0.0 });
    }
    draft
}

/// Any of these and ordinary scenes in units of depth, of length and of force from `10⁻¹⁵⁰` to `10¹⁵⁰`.
pub(super) fn in_tiny_units(random: &mut Random) -> Draft {
    let draft = match random.below(5) {
        0 => at_supports(random),
        1 => supported(random),
        2 => ties(random),
        3 => spiky(random),
        _ => ordinary(random),
    };
    let two = |random: &mut Random, most: f64| libm::exp2(random.between(-most, most).round());
    let (mut depth, force) = (two(random, 500.0), two(random, 300.0));
    if random.once_in(3) {
        depth = libm::exp2(random.between(-500.0, -465.0).round());
    }
    let length = if random.once_in(3) { two(random, 60.0) } else { 1.0 };
    draft.in_units(Units { length, depth, force })
}

/// A sum of Chebyshev's polynomials up to a degree from 2 to 9, below any supports.
pub(super) fn middle_degree(random: &mut Random) -> Draft {
    let draft = chebyshev_sum(random, |random| 2 + random.below(8));
    if random.once_in(2) {
        return draft;
    }
    let count = 1 + random.below(3);
    Draft { supports: Some(supports(random, &draft, count)), ..draft }
}

/// Waves, and one load that is there to be moved.
pub(super) fn washboard(random: &mut Random) -> Draft {
    let mut draft = beam_with_loads(random, 3);
    let load = PointLoad { at: random.between(0.0, draft.length), force: draft.length * random.between(0.1, 0.7) };
    draft.point.push(load);
    let depth = sag(&draft) * power(random, -2.0, -0.5);
    let wavelength = draft.length / random.between(3.0, 25.0);
    let amplitude = depth * random.between(0.1, 0.9);
    let phase = random.between(0.0, 6.3);
    let ground = Foundation::Cosine { mean: depth + amplitude, amplitude, wavelength, phase };
    Draft { ground: Some(ground), ..draft }
}
