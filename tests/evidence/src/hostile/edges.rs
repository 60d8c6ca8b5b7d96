//! Scenes at the edges of what numbers can say: the ends of their range, borders between regimes, points that all but coincide.

use palkki::scene::Foundation;

use crate::draft::{Draft, Units};
use crate::random::Random;

use super::scenes::{beam_with_loads, ordinary, power, sag, ties};

/// A number from anywhere: mostly a power of ten, sometimes one of those that are special.
fn anything(random: &mut Random) -> f64 {
    match random.below(12) {
        0 => random.pick(&[0.0, -0.0, 1.0, 5e-324, 2.2250738585072014e-308, f64::MAX, f64::MIN, f64::EPSILON]),
        1 => f64::from_bits(random.bits()),
        2 => -power(random, -30.0, 30.0),
        3..=5 => power(random, -320.0, 308.0),
        6 | 7 => power(random, -150.0, 150.0),
        _ => power(random, -12.0, 12.0),
    }
}

pub(super) fn extreme(random: &mut Random) -> Draft {
    // An ordinary scene with one to four of its numbers replaced, or all of it in extreme units, so that it often is a scene.
    let mut draft = if random.once_in(2) { ordinary(random) } else { ties(random) };
    if random.once_in(2) {
        let two = |random: &mut Random, most: i32| {
            let exponent = i32::try_from(random.below(2 * usize::try_from(most).unwrap_or(1) + 1)).unwrap_or(0) - most;
            2.0_f64.powi(exponent)
        };
        let (length, force, depth) = (two(random, 250), two(random, 400), two(random, 250));
        draft = draft.in_units(Units { length, depth, force });
    }
    for _ in 0..random.below(4) {
        let value = anything(random);
        match (random.below(7), &mut draft.ground) {
            (0, _) => draft.length = value,
            (1, _) => draft.stiffness = value.abs(),
            (2, _) => draft.uniform = value,
            (3, _) => draft.linear.iter_mut().for_each(|part| part.end = value),
            (4, _) => draft.point.iter_mut().for_each(|part| part.force = value),
            (_, Some(Foundation::Flat { depth })) => *depth = value.abs(),
            (_, Some(Foundation::Polynomial { coefficients: c })) => {
                let i = random.below(c.len());
                c[i] = value;
            }
            (_, Some(Foundation::Cosine { mean, amplitude, wavelength, phase })) => {
                *[mean, amplitude, wavelength, phase][random.below(4)] = value.abs();
            }
            (_, Some(Foundation::Polyline { points })) => {
                let i = random.below(points.len());
                points[i][1] = value;
            }
            (_, None) => draft.ground = Some(Foundation::Flat { depth: value.abs() }),
        }
    }
    draft
}

pub(super) fn borders(random: &mut Random) -> Draft {
    let length = random.pick(&[1.0, 10.0, 3.0]);
    let stiffness = random.pick(&[1.0, 500.0 / 384.0, 0.7]);
    let uniform = random.pick(&[1.0, 0.3, 3.0]);
    let unit = uniform * length * length * length * length / (384.0 * stiffness);
    // Zone to point, point to nothing, and both ends of the scale; a few units in the last place beside them.
    let depth: f64 = unit * random.pick(&[1.0, 5.0, 0.0, 1e-16, 2.5]);
    let steps = random.below(7) as u64;
    let depth = if random.once_in(2) {
        f64::from_bits(depth.to_bits() + steps)
    } else {
        f64::from_bits(depth.to_bits().saturating_sub(steps))
    };
    let half = 0.5 * length;
    let c = unit * 16.0 / (5.0 * length * length * length);
    let ground = match random.below(4) {
        0 | 1 => Foundation::Flat { depth },
        // The free deflection itself, q (l³x − 2lx³ + x⁴)/24EI: contact everywhere, without pressure.
        2 => {
            let lowest = depth * random.pick(&[0.0, 1e-12, 1e-15]);
            let coefficients = vec![lowest, 5.0 * c * length * length, 0.0, -10.0 * c, 5.0 * c / length];
            Foundation::Polynomial { coefficients }
        }
        _ => Foundation::Polyline { points: vec![[0.0, depth], [half, depth], [length, depth]] },
    };
    Draft { length, stiffness, uniform, ground: Some(ground), ..Draft::default() }
}

/// A wavelength, as a share of the beam: a tenth to a hundredth, and now and then a thousandth, which takes theory seconds.
fn short(random: &mut Random) -> f64 {
    let least = if random.once_in(100) { -3.0 } else { -2.0 };
    power(random, least, -1.0)
}

pub(super) fn spiky(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 3);
    let l = draft.length;
    let depth = sag(&draft) * power(random, -4.0, 0.0);
    let ground = match random.below(4) {
        0 => {
            // Points one to a few units in the last place apart.
            let (mut points, mut x) = (vec![[0.0, depth]], random.between(0.1 * l, 0.8 * l));
            for _ in 0..2 + random.below(8) {
                points.push([x, depth * random.between(-1.0, 2.0)]);
                x = if random.once_in(3) {
                    x + random.between(0.0, 0.01 * l)
                } else {
                    f64::from_bits(x.to_bits() + 1 + random.below(3) as u64)
                };
            }
            points.push([l, depth]);
            Foundation::Polyline { points }
        }
        1 => Foundation::Cosine {
            mean: 2.0 * depth,
            amplitude: depth * power(random, -9.0, 0.0),
            wavelength: l * short(random),
            phase: anything(random),
        },
        2 => {
            // Needles up from far below.
            let count = u32::try_from(2 + random.below(20)).unwrap_or(2);
            let place = |k: u32| l * (f64::from(k) / f64::from(count));
            let top =
                |random: &mut Random, k: u32| if k % 2 == 1 { depth * random.between(-0.5, 1.0) } else { 1e3 * depth };
            let points = (0..=count).map(|k| [place(k), if k == count { depth } else { top(random, k) }]).collect();
            Foundation::Polyline { points }
        }
        _ => {
            // A Chebyshev-like polynomial with cancelling coefficients.
            let mut c: Vec<f64> = Vec::new();
            let mut unit = depth * power(random, 0.0, 6.0);
            for k in 0..10 + random.below(15) {
                c.push(if k % 2 == 0 { unit } else { -unit });
                unit *= random.between(0.3, 2.5) / l;
            }
            c.truncate(10);
            Foundation::Polynomial { coefficients: c }
        }
    };
    Draft { ground: Some(ground), ..draft }
}
