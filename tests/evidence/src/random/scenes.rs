//! Random scenes from a fixed seed: waves, polynomials, polylines with kinks and steps, loads of every kind.

use super::Random;
use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};

/// Scene number `i` of the series.
pub fn scene(i: u64) -> Scene {
    let mut random = Random::new(0x5eed_0000 + i);
    let length = random.between(1.0, 20.0);
    let stiffness = 10.0_f64.powf(random.between(-2.0, 4.0));
    let beam = Beam::new(length, stiffness).expect("a beam");
    let load = load(&mut random, &beam);
    // Depths of the order of the deflection that the load can cause, from far less to somewhat more.
    let deflection = 5.0 / 384.0 * load.magnitude(length) * length * length * length / stiffness;
    let depth = deflection * 10.0_f64.powf(random.between(-3.0, 0.3));
    let foundation = foundation(&mut random, length, depth);
    Scene::new(beam, load, Some(foundation))
        .expect("a well-posed scene")
        .labelled(format!("random {i}"), Default::default())
}

fn load(random: &mut Random, beam: &Beam) -> Load {
    let l = beam.length();
    let uniform = match random.below(6) {
        0 => 0.0,
        1 => -0.5,
        _ => 1.0,
    };
    let linear = (0..random.below(3)).map(|_| {
        let (a, b) = (random.between(0.0, l), random.between(0.0, l));
        let (start, end) = (random.between(-1.0, 3.0), random.between(-1.0, 3.0));
        LinearLoad { from: a.min(b), to: a.max(b), start, end }
    });
    let linear: Vec<LinearLoad> = linear.collect();
    let mut point: Vec<PointLoad> = (0..random.below(3))
        .map(|_| PointLoad { at: random.between(0.0, l), force: l * random.between(-0.3, 0.7) })
        .collect();
    if uniform == 0.0 && linear.is_empty() && point.is_empty() {
        point.push(PointLoad { at: random.between(0.1 * l, 0.9 * l), force: 1.0 });
    }
    Load::new(beam, uniform, linear, point).expect("a load")
}

fn foundation(random: &mut Random, l: f64, depth: f64) -> Foundation {
    match random.below(4) {
        0 => cosine(random, l, depth),
        1 => polynomial(random, l, depth),
        2 => polyline(random, l, depth, false),
        _ => polyline(random, l, depth, true),
    }
}

fn cosine(random: &mut Random, l: f64, depth: f64) -> Foundation {
    let amplitude = depth * random.between(0.05, 1.0);
    let wavelength = l * 10.0_f64.powf(random.between(-1.2, 0.5));
    let phase = random.between(0.0, 6.0);
    let made = |mean: f64| Foundation::Cosine { mean, amplitude, wavelength, phase };
    let ends = made(0.0).depth(0.0).min(made(0.0).depth(l));
    // Above the supports, or with its lower end just at them.
    made(-ends + if random.below(4) == 0 { 0.0 } else { depth * random.between(0.0, 1.0) } + 1e-12 * depth)
}

fn polynomial(random: &mut Random, l: f64, depth: f64) -> Foundation {
    let degree = random.below(7);
    let mut coefficients: Vec<f64> = (0..=degree)
        .map(|j| depth * random.between(-3.0, 3.0) / l.powi(i32::try_from(j).expect("a small number")))
        .collect();
    let ends = {
        let shape = Foundation::Polynomial { coefficients: coefficients.clone() };
        shape.depth(0.0).min(shape.depth(l))
    };
    coefficients[0] += depth * random.between(0.0, 1.0) - ends;
    Foundation::Polynomial { coefficients }
}

fn polyline(random: &mut Random, l: f64, depth: f64, steps: bool) -> Foundation {
    let inner = random.below(9);
    let mut places: Vec<f64> = (0..inner).map(|_| random.between(0.02 * l, 0.98 * l)).collect();
    places.sort_by(f64::total_cmp);
    let base = depth * random.between(0.0, 1.0);
    let mut points = vec![[0.0, base + depth * random.between(0.0, 1.0)]];
    for x in places {
        points.push([x, base + depth * random.between(-0.5, 1.0)]);
        if steps && random.below(2) == 0 {
            points.push([x, base + depth * random.between(-0.5, 1.0)]);
        }
    }
    points.push([l, base + depth * random.between(0.0, 1.0)]);
    Foundation::Polyline { points }
}

/// Dense contact: 39 waves of random heights and phases, surveyed at equal distances as a polyline of so many segments, under a
/// uniform load that presses the beam onto many of its points.
///
/// ```text
/// u = d + h Σ a_k sin(2πk x/l + φ_k),   k = 1 … 39,   |a_k| ≤ 1,   h = 3e-4,   d such that the lower end lies 0.02 deep
/// ```
pub fn smooth(segments: u32, load: f64, seed: u64) -> Scene {
    const HEIGHT: f64 = 3e-4;
    const TURN: f64 = std::f64::consts::TAU;
    let mut random = Random::new(seed);
    let waves: Vec<[f64; 3]> =
        (1..40).map(|k| [HEIGHT * random.between(-1.0, 1.0), TURN * f64::from(k), random.between(0.0, TURN)]).collect();
    let rise = |s: f64| waves.iter().map(|[a, rate, phase]| a * libm::sin(rate * s + phase)).sum::<f64>();
    let base = 0.02 - rise(0.0).min(rise(1.0));
    let shares = (0..=segments).map(|i| f64::from(i) / f64::from(segments));
    let points = shares.map(|s| [10.0 * s, base + rise(s)]).collect();
    let beam = Beam::new(10.0, 1.3).expect("a beam");
    let load = Load::uniform_on(&beam, load).expect("a load");
    Scene::new(beam, load, Some(Foundation::Polyline { points }))
        .expect("a well-posed scene")
        .labelled(format!("smooth {segments} {seed}"), Default::default())
}

/// Scene number `i` of a series on a lattice: few places, depths and loads to choose from, so that ties, symmetry, depth 0
/// at the supports, straight stretches without load and loads on edges are the rule.
pub fn on_lattice(i: u64) -> Scene {
    let mut random = Random::new(0x1a77_1ce0 + i);
    let parts = [4, 6, 8][random.below(3)];
    let length = [1.0, 8.0, 10.0][random.below(3)];
    let beam = Beam::new(length, [1.0, 0.01, 500.0 / 384.0][random.below(3)]).expect("a beam");
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let place = |k: usize| length * k as f64 / parts as f64;
    let uniform = [0.0, 1.0, 1.0, -1.0][random.below(4)];
    let linear: Vec<LinearLoad> = (0..random.below(3))
        .map(|_| {
            let from = random.below(parts);
            let to = from + 1 + random.below(parts - from);
            let intensity = [-1.0, 0.0, 1.0, 2.0];
            let (start, end) = (intensity[random.below(4)], intensity[random.below(4)]);
            LinearLoad { from: place(from), to: place(to), start, end }
        })
        .collect();
    let point: Vec<PointLoad> = (0..random.below(3))
        .map(|_| PointLoad { at: place(random.below(parts + 1)), force: length * [-0.5, 0.5, 1.0][random.below(3)] })
        .collect();
    let load = Load::new(&beam, uniform, linear, point).expect("a load");
    let unit = length * length * length * length / 384.0 / beam.bending_stiffness();
    let depth = unit * [1e-6, 0.01, 0.5, 1.0][random.below(4)];
    let foundation = match random.below(5) {
        0 => Foundation::Flat { depth: depth * [0.0, 1.0, 5.0][random.below(3)] },
        1 => {
            let amplitude = depth * [1.0, -1.0][random.below(2)];
            let wavelength = [length, 0.5 * length, 2.0 * length, 0.25 * length][random.below(4)];
            // At a crest or a trough at the left support, and at depth 0 or above it.
            let mean = depth * [1.0, 1.5][random.below(2)];
            Foundation::Cosine { mean, amplitude, wavelength, phase: 0.0 }
        }
        2 => {
            // c x (l − x), a dish or (with its constant) a crest.
            let c = depth * [4.0, -4.0, 1.0][random.below(3)] / (length * length);
            let constant = depth * [0.0, 1.0][random.below(2)];
            Foundation::Polynomial { coefficients: vec![constant, c * length, -c] }
        }
        _ => {
            let mut points = Vec::new();
            for k in 0..=parts {
                let inner = 0 < k && k < parts;
                if inner && random.below(3) == 0 {
                    continue;
                }
                let depths = if inner { [-0.5, 0.0, 0.5, 1.0] } else { [0.0, 0.0, 0.5, 1.0] };
                points.push([place(k), depth * depths[random.below(4)]]);
                if inner && random.below(4) == 0 {
                    points.push([place(k), depth * depths[random.below(4)]]);
                }
            }
            Foundation::Polyline { points }
        }
    };
    Scene::new(beam, load, Some(foundation))
        .expect("a well-posed scene")
        .labelled(format!("lattice {i}"), Default::default())
}

/// Scene number `i` of a series of rough scenes: surveys of up to 200 points, up to a hundred waves, polynomials up to
/// degree 6, a dozen loads, foundations up to ten million times shallower than the free deflection.
pub fn rough(i: u64) -> Scene {
    let mut random = Random::new(0x0000_b0b0 + i);
    let length = random.between(1.0, 20.0);
    let stiffness = 10.0_f64.powf(random.between(-2.0, 4.0));
    let beam = Beam::new(length, stiffness).expect("a beam");
    let (few, many) = (random.below(12), random.below(12));
    let linear: Vec<LinearLoad> = (0..few)
        .map(|_| {
            let (a, b) = (random.between(0.0, length), random.between(0.0, length));
            let (start, end) = (random.between(-1.0, 2.0), random.between(-1.0, 2.0));
            LinearLoad { from: a.min(b), to: a.max(b), start, end }
        })
        .collect();
    let point: Vec<PointLoad> = (0..many)
        .map(|_| PointLoad { at: random.between(0.0, length), force: length * random.between(-0.05, 0.1) })
        .collect();
    let load = Load::new(&beam, random.between(-0.5, 2.0), linear, point).expect("a load");
    let deflection = 5.0 / 384.0 * load.magnitude(length) * length * length * length / stiffness;
    let depth = deflection * 10.0_f64.powf(random.between(-7.0, 0.0));
    let foundation = match random.below(3) {
        0 => {
            let wavelength = length * 10.0_f64.powf(random.between(-2.0, -0.7));
            let amplitude = depth * 10.0_f64.powf(random.between(-4.0, 0.0));
            Foundation::Cosine { mean: depth, amplitude, wavelength, phase: random.between(0.0, 6.0) }
        }
        1 => {
            let degree = 5 + random.below(8);
            let mut coefficients: Vec<f64> = (0..=degree)
                .map(|j| depth * random.between(-9.0, 9.0) / length.powi(i32::try_from(j).expect("a small number")))
                .collect();
            coefficients.truncate(7);
            let shape = Foundation::Polynomial { coefficients: coefficients.clone() };
            coefficients[0] += depth * random.between(0.0, 1.0) - shape.depth(0.0).min(shape.depth(length));
            Foundation::Polynomial { coefficients }
        }
        _ => {
            let count = 10 + random.below(190);
            let amplitude = depth * 10.0_f64.powf(random.between(-4.0, 0.0));
            #[expect(clippy::cast_precision_loss, reason = "small numbers")]
            let points = (0..=count)
                .map(|k| [length * (k as f64 / count as f64), depth + amplitude * random.between(-1.0, 1.0)])
                .collect();
            Foundation::Polyline { points }
        }
    };
    Scene::new(beam, load, Some(foundation))
        .expect("a well-posed scene")
        .labelled(format!("rough {i}"), Default::default())
}
