//! Random beams on random supports: none to five, built in or not, at levels of their own, some with an own shape, above all kinds
//! of ground or none.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};

use super::{Random, first};

/// A scene that its constructors accept; whether its loads are balanced is another question.
#[must_use]
pub fn held(i: u64) -> Scene {
    first(0x0005_4e1d_0000 + i, attempt)
}

fn attempt(random: &mut Random) -> Option<Scene> {
    let length = random.between(1.0, 20.0);
    let beam = Beam::new(length, libm::exp2(random.between(-4.0, 10.0))).ok()?;
    let load = load(random, &beam)?;
    // What the loads do to a simple beam, from far less to somewhat more.
    let sag = load.magnitude(length) * length * length * length / (77.0 * beam.bending_stiffness());
    let depth = sag * libm::exp2(random.between(-6.0, 1.0));
    let foundation = if random.once_in(12) { None } else { Some(profile(random, length, depth, depth)) };
    let shape = random.once_in(3).then(|| profile(random, length, 0.0, 0.5 * depth));
    let beam = match shape {
        Some(shape) => beam.with_shape(shape).ok()?,
        None => beam,
    };
    let count = random.below(6);
    let mut places: Vec<f64> = (0..count).map(|_| random.between(0.0, length)).collect();
    if random.once_in(2) && 0 < count {
        places[0] = 0.0;
    }
    if random.once_in(2) && 1 < count {
        places[1] = length;
    }
    let supports = places.into_iter().map(|at| {
        let ground = foundation.as_ref().map_or(depth, |foundation| foundation.depth(at));
        let level = match random.below(4) {
            0 => ground,
            1 => 0.0,
            _ => random.between(-0.3, 1.0) * depth,
        };
        let slope =
            random.once_in(4).then(|| if random.once_in(2) { 0.0 } else { random.between(-1.0, 1.0) * depth / length });
        Support { level: level.min(ground), slope, ..Support::simple(at) }
    });
    let supports = supports.collect();
    let beam = beam.with_supports(supports).ok()?;
    Scene::new(beam, load, foundation).ok()
}

fn load(random: &mut Random, beam: &Beam) -> Option<Load> {
    let length = beam.length();
    let uniform = if random.once_in(4) { 0.0 } else { random.between(0.1, 2.0) };
    let count = random.below(4);
    let point = (0..count).map(|_| {
        let at = if random.once_in(8) { length } else { random.between(0.0, length) };
        let pulls = random.once_in(5);
        PointLoad { at, force: random.between(0.2, 3.0) * if pulls { -0.3 } else { 1.0 } * length / 4.0 }
    });
    let load = Load::new(beam, uniform, Vec::new(), point.collect()).ok()?;
    (0.0 < load.magnitude(length)).then_some(load)
}

/// A profile about `mean`, as high as `height` or so.
fn profile(random: &mut Random, length: f64, mean: f64, height: f64) -> Foundation {
    let part = |random: &mut Random| height * random.between(-0.5, 0.5);
    match random.below(5) {
        0 => Foundation::Flat { depth: mean + if random.once_in(2) { 0.0 } else { part(random) } },
        1 => Foundation::Polynomial { coefficients: vec![mean + part(random), part(random) / length] },
        2 => {
            // A parabola, or a cubic.
            let mut coefficients =
                vec![mean + part(random), part(random) / length, 2.0 * part(random) / (length * length)];
            if random.once_in(2) {
                coefficients.push(2.0 * part(random) / (length * length * length));
            }
            Foundation::Polynomial { coefficients }
        }
        3 => Foundation::Cosine {
            mean,
            amplitude: 0.3 * part(random),
            wavelength: length * random.between(0.3, 2.0),
            phase: random.between(0.0, 6.0),
        },
        _ => {
            let count = 2 + random.below(6);
            let mut x: Vec<f64> = (0..count).map(|_| random.between(0.0, length)).collect();
            x.extend([0.0, length]);
            x.sort_by(f64::total_cmp);
            Foundation::Polyline { points: x.into_iter().map(|x| [x, mean + 0.5 * part(random)]).collect() }
        }
    }
}
