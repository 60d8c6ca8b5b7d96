//! Scenes of numbers that are close together, or far larger than what they add up to: places that nearly coincide, bumps that
//! tie, polynomials of high degree, waves without number.

use palkki::scene::{Foundation, PointLoad};

use crate::draft::Draft;
use crate::extremes::chebyshev;
use crate::random::Random;

use super::scenes::{beam_with_loads, ordinary, power, rough, sag, ties};

/// One unit in the last place up or down, or a share of the length.
pub(super) fn beside(random: &mut Random, x: f64, length: f64) -> f64 {
    let share = random.pick(&[1e-12, 1e-9, 1e-6]);
    let moved = match random.below(4) {
        0 => x.next_up(),
        1 => x.next_down(),
        2 => x + share * length,
        _ => x - share * length,
    };
    moved.clamp(0.0, length)
}

/// An ordinary scene, a rough one or one of ties, in which loads stand or end beside points of the ground, supports and other
/// loads.
pub(super) fn coincident(random: &mut Random) -> Draft {
    let mut draft = match random.below(3) {
        0 => ordinary(random),
        1 => rough(random),
        _ => ties(random),
    };
    let length = draft.length;
    if draft.point.is_empty() {
        draft.point.push(PointLoad { at: random.between(0.0, length), force: length * random.between(-0.3, 0.7) });
    }
    let mut places = draft.places();
    // Mostly points of the ground.
    places.extend(draft.points().iter().chain(draft.points()).map(|p| p[0]));
    let place = |random: &mut Random| {
        let x = places[random.below(places.len())];
        beside(random, x, length)
    };
    for point in &mut draft.point {
        point.at = place(random);
    }
    for part in &mut draft.linear {
        let moved = place(random);
        let end = if random.below(2) == 0 { &mut part.from } else { &mut part.to };
        *end = moved;
        (part.from, part.to) = (part.from.min(part.to), part.from.max(part.to));
    }
    draft
}

/// Bumps as high as each other but for a hundred-millionth, by points, waves or a polynomial.
pub(super) fn bumps(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 3);
    let l = draft.length;
    let depth = sag(&draft) * power(random, -4.0, 0.0);
    let tie = 1e-8 * random.pick(&[0.0, 1.0, -1.0]);
    let count = u32::try_from(2 + random.below(6)).unwrap_or(2);
    let ground = match random.below(3) {
        0 => {
            let place = |k: u32| l * f64::from(k) / f64::from(2 * count);
            let height = |k: u32| match k % 2 {
                1 => depth * if k < count { 1.0 + tie } else { 1.0 },
                _ => 3.0 * depth,
            };
            Foundation::Polyline { points: (0..=2 * count).map(|k| [place(k), height(k)]).collect() }
        }
        1 => {
            let wavelength = l / f64::from(count) * (1.0 + tie);
            Foundation::Cosine { mean: 2.0 * depth, amplitude: depth, wavelength, phase: 0.0 }
        }
        _ => {
            // Two bumps at the roots of (x − a)² (x − b)², one of them lower by a line through the other.
            let (a, b) = (l * random.between(0.1, 0.4), l * random.between(0.6, 0.9));
            let [sum, product] = [a + b, a * b];
            let unit = depth / (l * l * l * l);
            let square = [product * product, -2.0 * sum * product, sum * sum + 2.0 * product, -2.0 * sum, 1.0];
            let mut c: Vec<f64> = square.iter().map(|c| 16.0 * c * unit).collect();
            c[0] += depth;
            c[1] += tie * depth / l;
            Foundation::Polynomial { coefficients: c }
        }
    };
    Draft { ground: Some(ground), ..draft }
}

/// A sum of Chebyshev's polynomials up to a degree from 10 to 20, in powers of the place.
pub(super) fn high_degree(random: &mut Random) -> Draft {
    chebyshev_sum(random, |random| 10 + random.below(11))
}

/// The same up to a degree of any kind, which is drawn after the loads.
pub(super) fn chebyshev_sum(random: &mut Random, degree: impl Fn(&mut Random) -> usize) -> Draft {
    let mut draft = beam_with_loads(random, 3);
    // Coefficients without rounding, half of the time.
    if random.once_in(2) {
        draft.length = random.pick(&[1.0, 8.0, 1024.0]);
        let load = PointLoad { at: random.between(0.0, draft.length), force: draft.length };
        (draft.linear, draft.point) = (Vec::new(), vec![load]);
    }
    let degree = degree(random);
    let depth = sag(&draft) * power(random, -4.0, 1.0);
    let alone = random.once_in(2);
    let mut sum = vec![depth * random.between(1.0, 1.5)];
    sum.resize(degree + 1, 0.0);
    for k in 1..=degree {
        let share = if alone { f64::from(u8::from(k == degree)) } else { 0.5 * random.between(-1.0, 1.0) };
        sum.iter_mut().zip(chebyshev(k)).for_each(|(sum, c)| *sum += depth * share * c);
    }
    let mut unit = 1.0;
    for c in &mut sum {
        *c /= unit;
        unit *= draft.length;
    }
    Draft { ground: Some(Foundation::Polynomial { coefficients: sum }), ..draft }
}

/// Waves by the dozen, and now and then by the hundred and the thousand, which takes theory seconds.
pub(super) fn waves(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 3);
    let depth = sag(&draft) * power(random, -4.0, 0.0);
    let most = if random.once_in(50) { 3.0 } else { 2.0 };
    let wavelength = draft.length / power(random, 1.0, most);
    let amplitude = depth * power(random, -6.0, 0.0);
    let phase = random.between(0.0, 6.3);
    let ground = Foundation::Cosine { mean: depth + amplitude, amplitude, wavelength, phase };
    Draft { ground: Some(ground), ..draft }
}
