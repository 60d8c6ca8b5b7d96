//! A population of scenes to measure on: families of ground and of supports, each drawn from fixed seeds, every beam on the ground.

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene, Support};
use palkki::theory;

use super::{Random, first};

/// What the scenes of a family have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Level ground.
    Flat,
    /// A polyline of four to nine segments.
    Kinked,
    /// Waves, and humps that are parabolas.
    Crests,
    /// Polylines through 50 to 200 readings of a rough profile.
    Surveys,
    /// Two to six levels.
    Steps,
    /// Built-in, free and more than two supports, own shapes; above ground of the first three families.
    Held,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Flat, Self::Kinked, Self::Crests, Self::Surveys, Self::Steps, Self::Held];

    /// As data and tables have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Kinked => "kinked",
            Self::Crests => "smooth crests",
            Self::Surveys => "surveys",
            Self::Steps => "steps",
            Self::Held => "other supports",
        }
    }

    /// Scene number `i` of draw 1 or 2, which have seeds of their own: a beam that touches the ground, or one that beam theory does not solve. All
    /// supports stand at tenths of the beam, and are nodes of every grid of a multiple of ten intervals.
    #[must_use]
    pub fn scene(self, draw: u8, i: u32) -> Scene {
        let of_draw = if draw == 1 { 0x0904_0100_0000 } else { 0x2f1d_0000_0000 };
        let seed = of_draw + ((self as u64) << 16) + u64::from(i);
        let made = |random: &mut Random| {
            let scene = self.attempt(random)?;
            let lifts = theory::solve(&scene).is_ok_and(|exact| exact.solved && exact.state.contacts.is_empty());
            (!lifts).then_some(scene)
        };
        first(seed, made).labelled(format!("{} {draw}/{i}", self.name()), Default::default())
    }

    fn attempt(self, random: &mut Random) -> Option<Scene> {
        let length = random.between(2.0, 20.0);
        let beam = Beam::new(length, libm::exp2(random.between(-4.0, 10.0))).ok()?;
        let load = load(random, &beam)?;
        // What the loads would do to a simple beam; the ground lies this deep, or up to a hundredth of it.
        let sag = 5.0 / 384.0 * load.magnitude(length) * length * length * length / beam.bending_stiffness();
        let height = sag * libm::exp2(random.between(-7.0, -0.5));
        let beam = if self == Self::Held { held(random, beam, height)? } else { beam };
        Scene::new(beam, load, Some(self.ground(random, length, height))).ok()
    }

    /// Depths about `height`.
    fn ground(self, random: &mut Random, length: f64, height: f64) -> Foundation {
        let depth = |random: &mut Random| height * random.between(0.5, 1.5);
        match self {
            Self::Flat => Foundation::Flat { depth: height },
            Self::Kinked => {
                let mut places = places(random, length, 3, 9);
                places.extend([0.0, length]);
                places.sort_by(f64::total_cmp);
                Foundation::Polyline { points: places.into_iter().map(|x| [x, depth(random)]).collect() }
            }
            Self::Crests if random.once_in(3) => {
                let rise = 4.0 * height * random.between(0.2, 0.9);
                Foundation::Polynomial { coefficients: vec![height, -rise / length, rise / (length * length)] }
            }
            Self::Crests => Foundation::Cosine {
                mean: height,
                amplitude: height * random.between(0.05, 0.5),
                wavelength: length * libm::exp2(random.between(-3.0, 1.0)),
                phase: random.between(0.0, 6.0),
            },
            Self::Surveys => survey(random, length, height),
            Self::Steps => {
                let mut level = depth(random);
                let mut points = vec![[0.0, level]];
                for x in places(random, length, 1, 6) {
                    points.push([x, level]);
                    level = depth(random);
                    points.push([x, level]);
                }
                points.push([length, level]);
                Foundation::Polyline { points }
            }
            Self::Held => Self::ALL[random.below(3)].ground(random, length, height),
        }
    }
}

/// From `least` to `below` places between the ends, in order.
fn places(random: &mut Random, length: f64, least: usize, below: usize) -> Vec<f64> {
    let count = least + random.below(below - least);
    let mut places: Vec<f64> = (0..count).map(|_| length * random.between(0.02, 0.98)).collect();
    places.sort_by(f64::total_cmp);
    places
}

/// A uniform load; one in three has a line load besides, one in three a point load, both downwards.
fn load(random: &mut Random, beam: &Beam) -> Option<Load> {
    let length = beam.length();
    let ends = places(random, length, 2, 3);
    let [start, end] = [0; 2].map(|_| random.between(0.0, 3.0));
    let line = LinearLoad { from: ends[0], to: ends[1], start, end };
    let point = PointLoad { at: length * random.between(0.1, 0.9), force: length * random.between(0.1, 0.6) };
    let [with_line, with_point] = [0; 2].map(|_| random.once_in(3));
    Load::new(
        beam,
        1.0,
        with_line.then_some(line).into_iter().collect(),
        with_point.then_some(point).into_iter().collect(),
    )
    .ok()
}

/// Readings at equal distances of a dozen waves of random heights, lower the shorter, with an error of reading.
fn survey(random: &mut Random, length: f64, height: f64) -> Foundation {
    const TURN: f64 = std::f64::consts::TAU;
    let waves: Vec<[f64; 3]> =
        (1..=12).map(f64::from).map(|k| [random.between(-0.3, 0.3) / k, TURN * k, random.between(0.0, TURN)]).collect();
    let count = u32::try_from(50 + random.below(151)).unwrap_or(50);
    let reading = |i: u32| {
        let s = f64::from(i) / f64::from(count);
        let rise: f64 = waves.iter().map(|[a, rate, phase]| a * libm::sin(rate * s + phase)).sum();
        [length * s, height * (1.0 + rise.max(-0.9) + random.between(-0.01, 0.01))]
    };
    Foundation::Polyline { points: (0..=count).map(reading).collect() }
}

/// The beam with other supports than one at each end, or with a shape of its own.
fn held(random: &mut Random, beam: Beam, height: f64) -> Option<Beam> {
    let length = beam.length();
    let built_in = Support::built_in;
    let simple = Support::simple;
    let inside = 0.1 * length * [2.0, 3.0, 4.0, 6.0][random.below(4)];
    let supports = match random.below(6) {
        0 => vec![built_in(0.0), simple(length)],
        1 => vec![built_in(0.0), built_in(length)],
        2 => vec![built_in(0.0)],
        3 => vec![simple(0.0), simple(inside), simple(length)],
        4 => vec![simple(inside), simple(length)],
        _ => {
            // A bow, up or down.
            let rise = 4.0 * height * random.between(-0.5, 0.5);
            let bow = vec![0.0, rise / length, -rise / (length * length)];
            return beam.with_shape(Foundation::Polynomial { coefficients: bow }).ok();
        }
    };
    beam.with_supports(supports).ok()
}
