//! Random and adversarial scenes: by families, each with its own idea of what could go wrong.

use palkki::scene::{Foundation, LinearLoad, PointLoad};

use crate::draft::Draft;
use crate::random::Random;

use super::edges::{borders, extreme, spiky};
use super::general::general;
use super::held::{crowded, lying, margins, shaped, supported};
use super::near::{bumps, coincident, high_degree, waves};
use super::supports::{at_supports, balanced, dwarfed, in_tiny_units, level, many, middle_degree, washboard};

/// What a scene tries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
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
    /// Loads beside points of the ground, supports and other loads, from the last bit to a millionth of the beam away.
    Coincident,
    /// Bumps of the ground that tie but for a hundred-millionth.
    Bumps,
    /// Polynomials of degree 10 to 20, which are refused.
    HighDegree,
    /// From ten to a thousand waves.
    Waves,
    /// One to five supports, simple or built in, anywhere, at any level.
    Supported,
    /// Own shapes of every kind, on any supports.
    Shaped,
    /// Bodies that merely lie on the ground, or on it and one support.
    Lying,
    /// The same with the resultant at the outermost place that can carry it, or beside that.
    Margins,
    /// Supports beside each other, beside loads and points of the ground, and beyond the ends.
    Crowded,
    /// Loads and points of the ground at supports, or from the last bit to a millionth of the beam beside them.
    AtSupports,
    /// Up to forty supports.
    Many,
    /// One force that dwarfs all others.
    Dwarfed,
    /// Bodies in balance above a crest or a support.
    Balanced,
    /// Ground at the level of a support, or off it by next to nothing.
    Level,
    /// Deflections and forces of very small and very large numbers.
    Units,
    /// Polynomials of degree 2 to 9.
    MiddleDegree,
    /// Waves and a load that moves over them.
    Washboard,
    /// Couples, steps, joints, springs and axial forces of all sizes on the others, with numbers that must be refused: all of the fifth dice.
    General,
}

impl Family {
    /// Those that a seed below [`SECOND`](super::SECOND) chooses from: a longer list would give every seed another scene.
    pub(super) const FIRST: [Self; 7] =
        [Self::Ordinary, Self::Ties, Self::Rough, Self::Extreme, Self::Borders, Self::Spiky, Self::Lifting];
    /// Those that the seeds from there choose from.
    pub(super) const SECOND: [Self; 4] = [Self::Coincident, Self::Bumps, Self::HighDegree, Self::Waves];
    /// Those that the seeds from [`THIRD`](super::THIRD) choose from.
    pub(super) const THIRD: [Self; 5] = [Self::Supported, Self::Shaped, Self::Lying, Self::Margins, Self::Crowded];
    /// Those that the seeds from [`FOURTH`](super::FOURTH) choose from.
    pub(super) const FOURTH: [Self; 8] = [
        Self::AtSupports,
        Self::Many,
        Self::Dwarfed,
        Self::Balanced,
        Self::Level,
        Self::Units,
        Self::MiddleDegree,
        Self::Washboard,
    ];

    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary",
            Self::Ties => "ties",
            Self::Rough => "rough",
            Self::Extreme => "extreme",
            Self::Borders => "borders",
            Self::Spiky => "spiky",
            Self::Lifting => "lifting",
            Self::Coincident => "coincident",
            Self::Bumps => "bumps",
            Self::HighDegree => "high degree",
            Self::Waves => "waves",
            Self::Supported => "on any supports",
            Self::Shaped => "own shapes",
            Self::Lying => "free bodies",
            Self::Margins => "about to turn over",
            Self::Crowded => "crowded supports",
            Self::AtSupports => "at supports",
            Self::Many => "many supports",
            Self::Dwarfed => "dwarfed",
            Self::Balanced => "in balance",
            Self::Level => "level ground",
            Self::Units => "tiny units",
            Self::MiddleDegree => "middle degree",
            Self::Washboard => "washboard",
            Self::General => "general beam",
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
            Self::Coincident => coincident(random),
            Self::Bumps => bumps(random),
            Self::HighDegree => high_degree(random),
            Self::Waves => waves(random),
            Self::Supported => supported(random),
            Self::Shaped => shaped(random),
            Self::Lying => lying(random),
            Self::Margins => margins(random),
            Self::Crowded => crowded(random),
            Self::AtSupports => at_supports(random),
            Self::Many => many(random),
            Self::Dwarfed => dwarfed(random),
            Self::Balanced => balanced(random),
            Self::Level => level(random),
            Self::Units => in_tiny_units(random),
            Self::MiddleDegree => middle_degree(random),
            Self::Washboard => washboard(random),
            Self::General => general(random),
        }
    }
}

/// A power of ten with an exponent between two bounds.
pub(super) fn power(random: &mut Random, least: f64, most: f64) -> f64 {
    10.0_f64.powf(random.between(least, most))
}

/// A deflection that the load can cause, to measure depths by.
pub(super) fn sag(draft: &Draft) -> f64 {
    let Draft { length, stiffness, uniform, linear, point, .. } = draft;
    let parts: f64 = linear.iter().map(|p| (p.to - p.from).abs() * p.start.abs().max(p.end.abs())).sum();
    let load = uniform.abs() * length + parts + point.iter().map(|p| p.force.abs()).sum::<f64>();
    5.0 / 384.0 * load * length * length * length / stiffness
}

pub(super) fn beam_with_loads(random: &mut Random, parts: usize) -> Draft {
    let length = random.between(1.0, 20.0);
    let stiffness = power(random, -2.0, 4.0);
    let linear = (0..random.below(parts)).map(|_| {
        let (a, b) = (random.between(0.0, length), random.between(0.0, length));
        let (start, end) = (random.between(-1.0, 3.0), random.between(-1.0, 3.0));
        LinearLoad { from: a.min(b), to: a.max(b), start, end }
    });
    let linear = linear.collect();
    let point = (0..random.below(parts))
        .map(|_| PointLoad { at: random.between(0.0, length), force: length * random.between(-0.3, 0.7) })
        .collect();
    let uniform = random.pick(&[0.0, 1.0, 1.0, 1.0, -0.5]);
    Draft { length, stiffness, uniform, linear, point, ..Draft::default() }
}

/// Coefficients of the size of `depth` over the beam, up to `spread` times, and the depth at the higher end.
fn polynomial(random: &mut Random, l: f64, depth: f64, count: usize, spread: f64) -> (Vec<f64>, f64) {
    let mut unit = depth;
    let coefficients = (0..count).map(|_| {
        let coefficient = unit * random.between(-spread, spread);
        unit /= l;
        coefficient
    });
    let c: Vec<f64> = coefficients.collect();
    let end = c.iter().rev().fold(0.0, |sum, c| sum * l + c);
    let higher = c[0].min(end);
    (c, higher)
}

/// A foundation of depths around `depth`, not above the supports.
pub(super) fn ground(random: &mut Random, l: f64, depth: f64) -> Foundation {
    match random.below(5) {
        0 => Foundation::Flat { depth },
        1 => {
            let amplitude = depth * random.between(0.0, 1.0);
            let (wavelength, phase) = (l * power(random, -1.2, 0.5), random.between(0.0, 6.3));
            Foundation::Cosine { mean: depth + amplitude, amplitude, wavelength, phase }
        }
        2 => {
            let count = 1 + random.below(7);
            let (mut c, end) = polynomial(random, l, depth, count, 3.0);
            // Both ends are raised to the line of the supports, or left deeper.
            c[0] += depth * random.between(0.0, 1.0) - end.min(0.0);
            Foundation::Polynomial { coefficients: c }
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
            Foundation::Polyline { points }
        }
    }
}

pub(super) fn ordinary(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 3);
    let depth = sag(&draft) * power(random, -3.0, 0.3);
    Draft { ground: Some(ground(random, draft.length, depth)), ..draft }
}

pub(super) fn ties(random: &mut Random) -> Draft {
    let parts = random.pick(&[4, 6, 8]);
    let length = random.pick(&[1.0, 8.0, 10.0]);
    let stiffness = random.pick(&[1.0, 0.01, 500.0 / 384.0]);
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let place = |k: usize| length * k as f64 / parts as f64;
    let uniform = random.pick(&[0.0, 1.0, 1.0, -1.0]);
    let linear = (0..random.below(3)).map(|_| {
        let from = random.below(parts);
        let to = from + 1 + random.below(parts - from);
        let (start, end) = (random.pick(&[-1.0, 0.0, 1.0]), random.pick(&[-1.0, 0.0, 1.0, 2.0]));
        LinearLoad { from: place(from), to: place(to), start, end }
    });
    let linear = linear.collect();
    let point = (0..random.below(3))
        .map(|_| PointLoad { at: place(random.below(parts + 1)), force: length * random.pick(&[-0.5, 0.5, 1.0]) })
        .collect();
    let unit = length * length * length * length / 384.0 / stiffness * random.pick(&[1e-6, 0.01, 0.5, 1.0]);
    let ground = match random.below(5) {
        0 => Foundation::Flat { depth: unit * random.pick(&[0.0, 1.0, 5.0]) },
        1 => {
            let wavelength = length * random.pick(&[0.25, 0.5, 1.0, 2.0]);
            let (mean, amplitude) = (unit * random.pick(&[1.0, 1.5]), unit * random.pick(&[1.0, -1.0]));
            Foundation::Cosine { mean, amplitude, wavelength, phase: 0.0 }
        }
        2 => {
            let c = unit * random.pick(&[4.0, -4.0, 1.0]) / (length * length);
            Foundation::Polynomial { coefficients: vec![unit * random.pick(&[0.0, 1.0]), c * length, -c] }
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
            Foundation::Polyline { points }
        }
    };
    Draft { length, stiffness, uniform, linear, point, ground: Some(ground), ..Draft::default() }
}

pub(super) fn rough(random: &mut Random) -> Draft {
    let draft = beam_with_loads(random, 12);
    let l = draft.length;
    let depth = sag(&draft) * power(random, -7.0, 0.0);
    let amplitude = depth * power(random, -4.0, 0.0);
    let ground = match random.below(3) {
        0 => {
            let (wavelength, phase) = (l * power(random, -2.0, -0.7), random.between(0.0, 6.3));
            Foundation::Cosine { mean: depth, amplitude, wavelength, phase }
        }
        1 => {
            let count = 5 + random.below(8);
            let (mut c, end) = polynomial(random, l, depth, count, 9.0);
            c[0] += depth * random.between(0.0, 1.0) - end;
            Foundation::Polynomial { coefficients: c }
        }
        _ => {
            let count = u32::try_from(10 + random.below(190)).unwrap_or(10);
            let place = |k: u32| l * (f64::from(k) / f64::from(count));
            let points = (0..=count).map(|k| [place(k), depth + amplitude * random.between(-1.0, 1.0)]).collect();
            Foundation::Polyline { points }
        }
    };
    Draft { ground: Some(ground), ..draft }
}

fn lifting(random: &mut Random) -> Draft {
    let mut draft = beam_with_loads(random, 3);
    let l = draft.length;
    match random.below(4) {
        0 => draft.uniform = -1.0,
        1 => {
            // In balance with itself.
            (draft.uniform, draft.linear) = (0.0, Vec::new());
            draft = draft.with_points(&[(0.25 * l, 1.0), (0.5 * l, -2.0), (0.75 * l, 1.0)]);
        }
        2 => draft = draft.with_points(&[(0.0, l), (l, -l), (random.between(0.0, l), random.between(-l, l))]),
        // No load at all: only the foundation can bend the beam.
        _ => (draft.uniform, draft.linear, draft.point) = (0.0, Vec::new(), Vec::new()),
    }
    let depth = sag(&draft).max(power(random, -6.0, 0.0));
    let ground = match random.below(3) {
        0 => ground(random, l, depth),
        1 => {
            let crest = [random.between(0.1 * l, 0.9 * l), -depth];
            Foundation::Polyline { points: vec![[0.0, 0.0], crest, [l, random.pick(&[0.0, depth])]] }
        }
        _ => Foundation::Polynomial { coefficients: vec![0.0, -depth / l, depth / (l * l)] },
    };
    Draft { ground: Some(ground), ..draft }
}
