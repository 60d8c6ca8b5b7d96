//! Random scenes in which things stand at one place: supports, ends of line loads, point loads, kinks of the ground and of the own
//! shape are drawn from a few places.

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene, Support};

use super::{Random, first};

/// A scene that its constructors accept; whether its loads are balanced is another question.
#[must_use]
pub fn coinciding(i: u64) -> Scene {
    first(0x00c0_1c1d_0000 + i, attempt)
}

fn attempt(random: &mut Random) -> Option<Scene> {
    let length = random.between(1.0, 20.0);
    let beam = Beam::new(length, libm::exp2(random.between(-4.0, 8.0))).ok()?;
    let mut places: Vec<f64> = (0..4).map(|_| random.between(0.0, length)).collect();
    places.extend([0.0, length]);
    places.sort_by(f64::total_cmp);
    let load = load(random, &beam, &places)?;
    let sag = load.magnitude(length) * length * length * length / (77.0 * beam.bending_stiffness());
    let depth = sag * libm::exp2(random.between(-6.0, 0.0));
    let foundation = if random.once_in(12) { None } else { Some(profile(random, &places, depth, depth)) };
    let beam = match random.once_in(3).then(|| profile(random, &places, 0.0, 0.5 * depth)) {
        Some(shape) => beam.with_shape(shape).ok()?,
        None => beam,
    };
    let mut free = places.clone();
    let supports = (0..random.below(5)).map(|_| {
        let at = free.swap_remove(random.below(free.len()));
        let ground = foundation.as_ref().map_or(depth, |foundation| foundation.depth(at));
        let level = match random.below(5) {
            0 => ground,
            1 | 2 => 0.0,
            _ => random.between(-0.3, 1.0) * depth,
        };
        let slope =
            random.once_in(4).then(|| if random.once_in(2) { 0.0 } else { random.between(-1.0, 1.0) * depth / length });
        Support { level: level.min(ground), slope, ..Support::simple(at) }
    });
    let supports = supports.collect();
    Scene::new(beam.with_supports(supports).ok()?, load, foundation).ok()
}

fn load(random: &mut Random, beam: &Beam, places: &[f64]) -> Option<Load> {
    let length = beam.length();
    let uniform = if random.once_in(3) { 0.0 } else { random.between(0.1, 2.0) };
    let linear = (0..random.below(4)).filter_map(|_| {
        let [a, b] = [0; 2].map(|_| places[random.below(places.len())]);
        let [start, end] = [0; 2].map(|_| random.between(-0.3, 2.0));
        let end = if random.once_in(2) { start } else { end };
        (a < b).then_some(LinearLoad { from: a, to: b, start, end })
    });
    let linear = linear.collect();
    let point = (0..random.below(3)).map(|_| {
        let at = if random.once_in(3) { random.between(0.0, length) } else { places[random.below(places.len())] };
        let pulls = random.once_in(6);
        PointLoad { at, force: random.between(0.2, 3.0) * if pulls { -0.3 } else { 1.0 } * length / 4.0 }
    });
    let load = Load::new(beam, uniform, linear, point.collect()).ok()?;
    (0.0 < load.magnitude(length)).then_some(load)
}

/// A profile about `mean`, as high as `height` or so; one in two has its kinks at the places.
fn profile(random: &mut Random, places: &[f64], mean: f64, height: f64) -> Foundation {
    let length = places[places.len() - 1];
    let part = |random: &mut Random| height * random.between(-0.5, 0.5);
    match random.below(8) {
        0 | 1 => Foundation::Flat { depth: mean + if random.once_in(2) { 0.0 } else { part(random) } },
        2 => {
            let coefficients = [1.0, 1.0 / length, 2.0 / (length * length), 2.0 / (length * length * length)];
            let mut coefficients: Vec<f64> = coefficients.map(|size| size * part(random)).to_vec();
            coefficients[0] += mean;
            coefficients.truncate(2 + random.below(3));
            Foundation::Polynomial { coefficients }
        }
        3 => Foundation::Cosine {
            mean,
            amplitude: 0.3 * part(random),
            wavelength: length * random.between(0.3, 2.0),
            phase: random.between(0.0, 6.0),
        },
        _ => {
            // Level beside a place, now and then.
            let mut depth = mean + 0.5 * part(random);
            let points = places.iter().map(|&x| {
                if !random.once_in(3) {
                    depth = mean + 0.5 * part(random);
                }
                [x, depth]
            });
            Foundation::Polyline { points: points.collect() }
        }
    }
}
