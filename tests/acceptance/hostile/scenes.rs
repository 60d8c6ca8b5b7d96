//! Random and adversarial scenes: by families, each with its own idea of what could go wrong.

use palkki::verification::Random;

use super::draft::{Draft, Ground};

/// What a scene tries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Family {
    /// What engineers have: waves, polynomials, kinks and steps, loads of every kind.
    Ordinary,
    /// Few numbers to choose from: ties, symmetry, supports on the foundation, loads on edges.
    Ties,
    /// Hundreds of points, a dozen loads, foundations far shallower than the free deflection.
    Rough,
    /// Numbers from one end of 64-bit floating point to the other.
    Extreme,
    /// One unit in the last place to either side of a change of regime.
    Borders,
    /// Points of a polyline that all but coincide, spikes, waves far shorter than the beam.
    Spiky,
    /// Loads that push up, cancel, stand on supports; a foundation that pushes the beam up.
    Lifting,
}

impl Family {
    pub(crate) const ALL: [Self; 7] =
        [Self::Ordinary, Self::Ties, Self::Rough, Self::Extreme, Self::Borders, Self::Spiky, Self::Lifting];

    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary",
            Self::Ties => "ties",
            Self::Rough => "rough",
            Self::Extreme => "extreme",
            Self::Borders => "borders",
            Self::Spiky => "spiky",
            Self::Lifting => "lifting",
        }
    }

    /// A scene of this family.
    pub(crate) fn draft(self, random: &mut Random) -> Draft {
        match self {
            Self::Ordinary => ordinary(random),
            Self::Ties => ties(random),
            Self::Rough => rough(random),
            Self::Extreme => extreme(random),
            Self::Borders => borders(random),
            Self::Spiky => spiky(random),
            Self::Lifting => lifting(random),
        }
    }
}

/// A power of ten with an exponent between two bounds.
fn power(random: &mut Random, least: f64, most: f64) -> f64 {
    10.0_f64.powf(random.between(least, most))
}

/// A deflection that the load can cause, to measure depths by.
fn sag(draft: &Draft) -> f64 {
    let Draft { length, stiffness, uniform, linear, point, .. } = draft;
    let parts: f64 = linear.iter().map(|p| (p[1] - p[0]).abs() * p[2].abs().max(p[3].abs())).sum();
    let load = uniform.abs() * length + parts + point.iter().map(|p| p[1].abs()).sum::<f64>();
    5.0 / 384.0 * load * length * length * length / stiffness
}

fn beam_with_loads(random: &mut Random, parts: usize) -> Draft {
    let length = random.between(1.0, 20.0);
    let stiffness = power(random, -2.0, 4.0);
    let linear = (0..random.below(parts)).map(|_| {
        let (a, b) = (random.between(0.0, length), random.between(0.0, length));
        [a.min(b), a.max(b), random.between(-1.0, 3.0), random.between(-1.0, 3.0)]
    });
    let linear = linear.collect();
    let point =
        (0..random.below(parts)).map(|_| [random.between(0.0, length), length * random.between(-0.3, 0.7)]).collect();
    let uniform = random.pick(&[0.0, 1.0, 1.0, 1.0, -0.5]);
    Draft { length, stiffness, uniform, linear, point, ground: Ground::None }
}

/// A foundation of depths around `depth`, not above the supports.
fn ground(random: &mut Random, l: f64, depth: f64) -> Ground {
    match random.below(5) {
        0 => Ground::Flat(depth),
        1 => {
            let amplitude = depth * random.between(0.0, 1.0);
            Ground::Cosine([depth + amplitude, amplitude, l * power(random, -1.2, 0.5), random.between(0.0, 6.3)])
        }
        2 => {
            let mut c: Vec<f64> = Vec::new();
            let mut unit = depth;
            for _ in 0..=random.below(7) {
                c.push(unit * random.between(-3.0, 3.0));
                unit /= l;
            }
            let end = c.iter().rev().fold(0.0, |sum, c| sum * l + c);
            // Both ends are raised to the line of the supports, or left deeper.
            let lift = c[0].min(end).min(0.0);
            c[0] += depth * random.between(0.0, 1.0) - lift;
            Ground::Polynomial(c)
        }
        steps => {
            let mut places: Vec<f64> = (0..random.below(9)).map(|_| random.between(0.02 * l, 0.98 * l)).collect();
            places.sort_by(f64::total_cmp);
            let mut points = vec![[0.0, depth * random.between(0.0, 2.0)]];
            for x in places {
                points.push([x, depth * random.between(-0.5, 2.0)]);
                if steps == 4 && random.once_in(2) {
                    points.push([x, depth * random.between(-0.5, 2.0)]);
                }
            }
            points.push([l, depth * random.between(0.0, 2.0)]);
            Ground::Points(points)
        }
    }
}

fn ordinary(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 3);
    let depth = sag(&draft) * power(random, -3.0, 0.3);
    Draft { ground: ground(random, draft.length, depth), ..draft }
}

fn ties(random: &mut Random) -> Draft {
    let parts = random.pick(&[4, 6, 8]);
    let length = random.pick(&[1.0, 8.0, 10.0]);
    let stiffness = random.pick(&[1.0, 0.01, 500.0 / 384.0]);
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let place = |k: usize| length * k as f64 / parts as f64;
    let uniform = random.pick(&[0.0, 1.0, 1.0, -1.0]);
    let linear = (0..random.below(3)).map(|_| {
        let from = random.below(parts);
        let to = from + 1 + random.below(parts - from);
        [place(from), place(to), random.pick(&[-1.0, 0.0, 1.0]), random.pick(&[-1.0, 0.0, 1.0, 2.0])]
    });
    let linear = linear.collect();
    let point = (0..random.below(3))
        .map(|_| [place(random.below(parts + 1)), length * random.pick(&[-0.5, 0.5, 1.0])])
        .collect();
    let unit = length * length * length * length / 384.0 / stiffness * random.pick(&[1e-6, 0.01, 0.5, 1.0]);
    let ground = match random.below(5) {
        0 => Ground::Flat(unit * random.pick(&[0.0, 1.0, 5.0])),
        1 => {
            let wavelength = length * random.pick(&[0.25, 0.5, 1.0, 2.0]);
            Ground::Cosine([unit * random.pick(&[1.0, 1.5]), unit * random.pick(&[1.0, -1.0]), wavelength, 0.0])
        }
        2 => {
            let c = unit * random.pick(&[4.0, -4.0, 1.0]) / (length * length);
            Ground::Polynomial(vec![unit * random.pick(&[0.0, 1.0]), c * length, -c])
        }
        _ => {
            let mut points = Vec::new();
            for k in 0..=parts {
                let inner = 0 < k && k < parts;
                if inner && random.once_in(3) {
                    continue;
                }
                points.push([
                    place(k),
                    unit * random.pick(if inner { &[-0.5, 0.0, 0.5, 1.0] } else { &[0.0, 0.0, 0.5, 1.0] }),
                ]);
                if inner && random.once_in(4) {
                    points.push([place(k), unit * random.pick(&[-0.5, 0.0, 0.5, 1.0])]);
                }
            }
            Ground::Points(points)
        }
    };
    Draft { length, stiffness, uniform, linear, point, ground }
}

fn rough(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 12);
    let l = draft.length;
    let depth = sag(&draft) * power(random, -7.0, 0.0);
    let amplitude = depth * power(random, -4.0, 0.0);
    let ground = match random.below(3) {
        0 => Ground::Cosine([depth, amplitude, l * power(random, -2.0, -0.7), random.between(0.0, 6.3)]),
        1 => {
            let mut c: Vec<f64> = Vec::new();
            let mut unit = depth;
            for _ in 0..5 + random.below(8) {
                c.push(unit * random.between(-9.0, 9.0));
                unit /= l;
            }
            let end = c.iter().rev().fold(0.0, |sum, c| sum * l + c);
            c[0] += depth * random.between(0.0, 1.0) - c[0].min(end);
            Ground::Polynomial(c)
        }
        _ => {
            let count = u32::try_from(10 + random.below(190)).unwrap_or(10);
            let place = |k: u32| l * (f64::from(k) / f64::from(count));
            Ground::Points((0..=count).map(|k| [place(k), depth + amplitude * random.between(-1.0, 1.0)]).collect())
        }
    };
    Draft { ground, ..draft }
}

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

fn extreme(random: &mut Random) -> Draft {
    // An ordinary scene with one to four of its numbers replaced, or all of it in extreme units, so that it often is a scene.
    let mut draft = if random.once_in(2) { ordinary(random) } else { ties(random) };
    if random.once_in(2) {
        let two = |random: &mut Random, most: i32| {
            let exponent = i32::try_from(random.below(2 * usize::try_from(most).unwrap_or(1) + 1)).unwrap_or(0) - most;
            2.0_f64.powi(exponent)
        };
        draft = draft.in_units(two(random, 250), two(random, 400), two(random, 250));
    }
    for _ in 0..random.below(4) {
        let value = anything(random);
        match (random.below(7), &mut draft.ground) {
            (0, _) => draft.length = value,
            (1, _) => draft.stiffness = value.abs(),
            (2, _) => draft.uniform = value,
            (3, _) => draft.linear.iter_mut().for_each(|part| part[3] = value),
            (4, _) => draft.point.iter_mut().for_each(|part| part[1] = value),
            (_, Ground::Flat(depth)) => *depth = value.abs(),
            (_, Ground::Polynomial(c)) => {
                let i = random.below(c.len());
                c[i] = value;
            }
            (_, Ground::Cosine(c)) => c[random.below(4)] = value.abs(),
            (_, Ground::Points(points)) => {
                let i = random.below(points.len());
                points[i][1] = value;
            }
            (_, Ground::None) => draft.ground = Ground::Flat(value.abs()),
        }
    }
    draft
}

fn borders(random: &mut Random) -> Draft {
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
        0 | 1 => Ground::Flat(depth),
        // The free deflection itself, q (l³x − 2lx³ + x⁴)/24EI: contact everywhere, without pressure.
        2 => Ground::Polynomial(vec![
            depth * random.pick(&[0.0, 1e-12, 1e-15]),
            5.0 * c * length * length,
            0.0,
            -10.0 * c,
            5.0 * c / length,
        ]),
        _ => Ground::Points(vec![[0.0, depth], [half, depth], [length, depth]]),
    };
    Draft { length, stiffness, uniform, linear: Vec::new(), point: Vec::new(), ground }
}

/// A wavelength, as a share of the beam: a tenth to a hundredth, and now and then a thousandth, which takes theory seconds.
fn short(random: &mut Random) -> f64 {
    let least = if random.once_in(100) { -3.0 } else { -2.0 };
    power(random, least, -1.0)
}

fn spiky(random: &mut Random) -> Draft {
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
            Ground::Points(points)
        }
        1 => Ground::Cosine([2.0 * depth, depth * power(random, -9.0, 0.0), l * short(random), anything(random)]),
        2 => {
            // Needles up from far below.
            let count = u32::try_from(2 + random.below(20)).unwrap_or(2);
            let place = |k: u32| l * (f64::from(k) / f64::from(count));
            let top =
                |random: &mut Random, k: u32| if k % 2 == 1 { depth * random.between(-0.5, 1.0) } else { 1e3 * depth };
            Ground::Points((0..=count).map(|k| [place(k), if k == count { depth } else { top(random, k) }]).collect())
        }
        _ => {
            // A Chebyshev-like polynomial with cancelling coefficients.
            let mut c: Vec<f64> = Vec::new();
            let mut unit = depth * power(random, 0.0, 6.0);
            for k in 0..10 + random.below(15) {
                c.push(if k % 2 == 0 { unit } else { -unit });
                unit *= random.between(0.3, 2.5) / l;
            }
            Ground::Polynomial(c)
        }
    };
    Draft { ground, ..draft }
}

fn lifting(random: &mut Random) -> Draft {
    let mut draft = beam_with_loads(random, 3);
    let l = draft.length;
    match random.below(4) {
        0 => draft.uniform = -1.0,
        1 => {
            // In balance with itself.
            (draft.uniform, draft.linear) = (0.0, Vec::new());
            draft.point = vec![[0.25 * l, 1.0], [0.5 * l, -2.0], [0.75 * l, 1.0]];
        }
        2 => draft.point = vec![[0.0, l], [l, -l], [random.between(0.0, l), random.between(-l, l)]],
        // No load at all: only the foundation can bend the beam.
        _ => (draft.uniform, draft.linear, draft.point) = (0.0, Vec::new(), Vec::new()),
    }
    let depth = sag(&draft).max(power(random, -6.0, 0.0));
    draft.ground = match random.below(3) {
        0 => ground(random, l, depth),
        1 => Ground::Points(vec![
            [0.0, 0.0],
            [random.between(0.1 * l, 0.9 * l), -depth],
            [l, random.pick(&[0.0, depth])],
        ]),
        _ => Ground::Polynomial(vec![0.0, -depth / l, depth / (l * l)]),
    };
    draft
}
