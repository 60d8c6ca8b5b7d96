//! Families of beams: sections, spans, loads and play as handbooks and catalogues have them. Places are multiples of centimetres or of
//! tenths of a metre, as people write them.

use palkki::scene::{Foundation, LinearLoad, PointLoad, Support};

use super::beds::{Bed, bed};
use crate::draft::Draft;
use crate::random::Random;

/// Bending stiffness and weight of a metre \[N m², N/m\].
type Section = [f64; 2];

/// Particle board 19 × 300, glass 10 × 250, MDF 25 × 400, spruce 27 × 250, scaffold plank 38 × 225, oak 40 × 600.
const BOARDS: [Section; 6] =
    [[429.0, 36.0], [1458.0, 61.0], [1562.0, 74.0], [4510.0, 30.0], [10_288.0, 38.0], [38_400.0, 165.0]];

/// IPE 300, HEA 400, HEB 600, a composite girder, a concrete T.
const GIRDERS: [Section; 5] = [[1.755e7, 414.0], [9.46e7, 1226.0], [3.59e8, 2080.0], [5.25e9, 25e3], [8.25e9, 40e3]];

/// 60E1, 54E1, 49E1, crane rail A100.
const RAILS: [Section; 4] = [[6.42e6, 591.0], [4.91e6, 536.0], [3.82e6, 485.0], [1.8e6, 730.0]];

/// Strips of concrete 0.6 × 0.3, 1.0 × 0.5, 2.0 × 0.8.
const STRIPS: [Section; 3] = [[4.05e7, 4500.0], [3.125e8, 12_500.0], [2.56e9, 40e3]];

/// Width of these strips \[m\].
const WIDTHS: [f64; 3] = [0.6, 1.0, 2.0];

/// PE 110, PE 315, steel 219 × 6.3, 508 × 8, 1016 × 12, each with what is in it.
const PIPES: [Section; 5] = [[4e3, 90.0], [2.7e5, 750.0], [5e6, 700.0], [8.25e7, 2800.0], [1e9, 10_300.0]];

/// Loose sand, clay, dense sand, gravel \[N/m³\].
const SUBGRADES: [f64; 4] = [5e6, 2e7, 8e7, 1.5e8];

/// Soft, usual and stiff track, a rail on concrete \[N/m²\].
const TRACKS: [f64; 4] = [1e7, 3e7, 7e7, 4e8];

/// Peat, clay, sand, gravel under a pipe \[N/m²\].
const TRENCHES: [f64; 4] = [1e4, 1e5, 5e5, 1e7];

/// What the beams of a family have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Boards on pins or bricks, with what lies on them, above a shelf or the floor.
    Shelves,
    /// Girders of one to five spans on supports that have settled or not, with abutments that they may touch.
    Bridges,
    /// Girders on bearings that only push, under a row of axles.
    Trains,
    /// Beams that reach a stop after some play.
    Stops,
    /// Strip footings under columns, on soil that is level or has hollows.
    Footings,
    /// Rails under wheels, on ballast with or without hollows.
    Rails,
    /// Pipes on rock, by a survey of 20 to 2,000 readings.
    PipesOnRock,
    /// Pipes in trenches of soil, by such a survey; some of them end in a wall or at a support.
    PipesOnSoil,
    /// Beams without supports on soil, with forces at one end or both.
    FreeBeams,
}

impl Family {
    /// All of them, and how many of each are drawn.
    pub const ALL: [(Self, u32); 9] = [
        (Self::Shelves, 250),
        (Self::Bridges, 350),
        (Self::Trains, 200),
        (Self::Stops, 200),
        (Self::Footings, 250),
        (Self::Rails, 250),
        (Self::PipesOnRock, 250),
        (Self::PipesOnSoil, 250),
        (Self::FreeBeams, 400),
    ];

    /// As tables have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shelves => "shelves",
            Self::Bridges => "bridges",
            Self::Trains => "bearings under trains",
            Self::Stops => "stops with play",
            Self::Footings => "footings",
            Self::Rails => "rails",
            Self::PipesOnRock => "pipes on rock",
            Self::PipesOnSoil => "pipes on soil",
            Self::FreeBeams => "free beams on soil",
        }
    }

    /// Draft number `i`.
    #[must_use]
    pub fn case(self, i: u32) -> Draft {
        let random = &mut Random::new(0x9a1c_0000_0000 + ((self as u64) << 20) + u64::from(i));
        match self {
            Self::Shelves => shelf(random),
            Self::Bridges => bridge(random),
            Self::Trains => train(random),
            Self::Stops => stop(random),
            Self::Footings => footing(random),
            Self::Rails => rail(random),
            Self::PipesOnRock => pipe(random, None),
            Self::PipesOnSoil => {
                let soil = random.pick(&TRENCHES);
                pipe(random, Some(soil))
            }
            Self::FreeBeams => free_beam(random),
        }
    }
}

/// A number between two, in so many parts of a unit: 100 for centimetres.
fn rounded(random: &mut Random, from: f64, to: f64, parts: f64) -> f64 {
    (random.between(from, to) * parts).round() / parts
}

/// A beam of a section under its weight.
/// Soil of one stiffness, if it gives.
fn evenly(soil: Option<f64>) -> Vec<[f64; 2]> {
    soil.map(|k| [0.0, k]).into_iter().collect()
}

fn beam(length: f64, [stiffness, uniform]: Section) -> Draft {
    Draft { length, stiffness, uniform, ..Draft::default() }
}

fn shelf(random: &mut Random) -> Draft {
    let length = rounded(random, 0.6, 2.4, 100.0);
    let draft = beam(length, random.pick(&BOARDS));
    let inset = random.pick(&[0.0, 0.0, 0.05, 0.2]);
    let pushes = random.once_in(2);
    let mut supports: Vec<Support> =
        [inset, length - inset].map(|at| Support { pushes_only: pushes, ..Support::simple(at) }).into();
    if random.once_in(3) {
        // A pin in the middle that stands lower by millimetres.
        let level = rounded(random, 0.0, 0.006, 1000.0);
        supports.push(Support::pushing(rounded(random, 0.4 * length, 0.6 * length, 100.0)).at_level(level));
    }
    let books = rounded(random, 0.2, 0.8, 10.0) * length;
    let weight = rounded(random, 100.0, 600.0, 0.1);
    let linear = vec![LinearLoad { from: 0.0, to: books, start: weight, end: weight }];
    let things = (0..random.below(3)).map(|_| PointLoad {
        at: rounded(random, inset, length - inset, 100.0),
        force: rounded(random, 20.0, 300.0, 0.1),
    });
    let point = things.collect();
    let below = rounded(random, 0.007, 0.03, 1000.0);
    let ground = match random.below(3) {
        0 => None,
        1 => Some(Foundation::Flat { depth: below }),
        // Something stands below it.
        _ => {
            let [from, to] = [0.3 * length, 0.7 * length].map(|x| (100.0 * x).round() / 100.0);
            let points = [[0.0, 0.3], [from, 0.3], [from, below], [to, below], [to, 0.3], [length, 0.3]];
            Some(Foundation::Polyline { points: points.into() })
        }
    };
    Draft { linear, point, supports: Some(supports), ground, ..draft }
}

/// Places of the supports of one to five spans.
fn spans(random: &mut Random, from: f64, to: f64) -> Vec<f64> {
    let mut places = vec![0.0];
    for _ in 0..=random.below(5) {
        places.push(places[places.len() - 1] + rounded(random, from, to, 2.0));
    }
    places
}

/// Axles from a place on, as far as the beam goes.
fn axles(random: &mut Random, length: f64, forces: &[f64; 3]) -> Vec<PointLoad> {
    let force = random.pick(forces);
    let first = rounded(random, 0.0, 0.8 * length, 10.0);
    let apart = random.pick(&[1.8, 2.5, 6.0]);
    let count = 1 + random.below(8) as u32;
    let places = (0..count).map(|k| first + f64::from(k) * apart).take_while(|at| *at <= length);
    places.map(|at| PointLoad { at, force }).collect()
}

fn bridge(random: &mut Random) -> Draft {
    let places = spans(random, 8.0, 40.0);
    let length = places[places.len() - 1];
    let draft = beam(length, random.pick(&GIRDERS));
    let settled = random.once_in(2);
    let seat = rounded(random, 0.0, 0.05, 100.0);
    let supports = places.iter().map(|&at| {
        let level = if settled { rounded(random, 0.0, 0.05, 100.0).min(seat) } else { 0.0 };
        Support::simple(at).at_level(level)
    });
    let supports: Vec<Support> = supports.collect();
    let point = axles(random, length, &[60e3, 150e3, 225e3]);
    // The abutments reach into the end spans by 1 m, and the valley is deep.
    let ground = random.once_in(2).then(|| {
        let [from, to] = [1.0, length - 1.0];
        let points =
            [[0.0, seat], [from, seat], [from, 5.0], [0.5 * length, 8.0], [to, 5.0], [to, seat], [length, seat]];
        Foundation::Polyline { points: points.into() }
    });
    Draft { point, supports: Some(supports), ground, ..draft }
}

fn train(random: &mut Random) -> Draft {
    let places = spans(random, 4.0, 20.0);
    let length = places[places.len() - 1];
    let draft = beam(length, random.pick(&GIRDERS));
    let supports = places.iter().map(|&at| {
        let play = if random.once_in(4) { rounded(random, 0.001, 0.005, 1000.0) } else { 0.0 };
        Support::pushing(at).at_level(play)
    });
    let supports = Some(supports.collect());
    let point = axles(random, length, &[112.5e3, 225e3, 250e3]);
    Draft { point, supports, ..draft }
}

fn stop(random: &mut Random) -> Draft {
    let length = rounded(random, 2.0, 12.0, 10.0);
    let draft = beam(length, GIRDERS[random.below(3)]);
    let mut supports = vec![if random.once_in(2) { Support::built_in(0.0) } else { Support::simple(0.0) }];
    if supports[0].slope.is_none() {
        supports.push(Support::simple(rounded(random, 0.5 * length, length, 10.0)));
    }
    for _ in 0..=random.below(3) {
        let at = rounded(random, 0.1 * length, length, 10.0);
        if supports.iter().all(|support| (support.at - at).abs() > 0.05) {
            supports.push(Support::pushing(at).at_level(rounded(random, 0.0, 0.02, 1000.0)));
        }
    }
    let force = rounded(random, 1e3, 200e3, 1e-3);
    let point = (0..=random.below(2)).map(|_| PointLoad { at: rounded(random, 0.3 * length, length, 10.0), force });
    let point = point.collect();
    Draft { point, supports: Some(supports), ..draft }
}

fn footing(random: &mut Random) -> Draft {
    let kind = random.below(3);
    let length = rounded(random, 3.0, 30.0, 10.0);
    let draft = beam(length, STRIPS[kind]);
    let apart = rounded(random, 2.0, 6.0, 2.0);
    // Columns from the edge, or from half a metre beside it.
    let first = random.pick(&[0.0, 0.5, 1.0]);
    let count = ((length - first) / apart) as u32;
    let point =
        (0..=count).map(|k| PointLoad { at: first + f64::from(k) * apart, force: rounded(random, 1e5, 2e6, 1e-4) });
    let point = point.collect();
    let hollows = random.pick(&[Bed::Level, Bed::Level, Bed::Steps { apart: 1.0, high: 0.01 }]);
    let ground = Some(bed(random, length, hollows));
    let soil = Some(random.pick(&SUBGRADES) * WIDTHS[kind]);
    Draft { point, supports: Some(Vec::new()), ground, soil: evenly(soil), ..draft }
}

fn rail(random: &mut Random) -> Draft {
    let length = rounded(random, 6.0, 60.0, 1.0);
    let draft = beam(length, random.pick(&RAILS));
    let point = axles(random, length, &[50e3, 80e3, 125e3]);
    let beds = [
        Bed::Level,
        Bed::Steps { apart: 0.6, high: 0.003 },
        Bed::Waves { readings: (length / 0.6) as u32, high: 0.004, rough: 0.0005, datum: 0.0 },
        Bed::Corrugated { high: 0.002, wavelength: 3.0 },
    ];
    let kind = random.pick(&beds);
    let ground = Some(bed(random, length, kind));
    let soil = Some(random.pick(&TRACKS));
    Draft { point, supports: Some(Vec::new()), ground, soil: evenly(soil), ..draft }
}

fn pipe(random: &mut Random, soil: Option<f64>) -> Draft {
    let length = random.pick(&[60.0, 200.0, 1000.0]);
    let draft = beam(length, random.pick(&PIPES));
    let readings = libm::round(20.0 * libm::pow(100.0, random.between(0.0, 1.0))) as u32;
    let high = random.pick(&[0.05, 0.5, 1.5]);
    let kind = Bed::Waves {
        readings,
        high,
        rough: high * random.pick(&[0.0, 0.03, 0.2]),
        datum: random.pick(&[0.0, 3.2, 100.0]),
    };
    let ground = bed(random, length, kind);
    let mut supports = Vec::new();
    if soil.is_some() && random.once_in(5) {
        // It ends in a wall or on a support, above the soil or settled into it.
        let level = ground.depth(0.0) + rounded(random, -0.1, 0.05, 100.0);
        let slope = random.once_in(2).then_some(0.0);
        supports.push(Support { slope, ..Support::simple(0.0).at_level(level) });
    }
    let valves =
        (0..random.below(3)).map(|_| PointLoad { at: rounded(random, 0.0, length, 1.0), force: 5.0 * draft.uniform });
    let point = valves.collect();
    Draft { point, supports: Some(supports), ground: Some(ground), soil: evenly(soil), ..draft }
}

fn free_beam(random: &mut Random) -> Draft {
    let length = rounded(random, 1.0, 20.0, 10.0);
    let section = if random.once_in(2) { random.pick(&RAILS) } else { random.pick(&STRIPS) };
    let draft = beam(length, section);
    // From a beam that stays straight to one of many waves: `k l⁴/EI`.
    let ratio = libm::pow(10.0, random.between(-2.0, 5.0));
    let soil = Some(ratio * draft.stiffness / (length * length * length * length));
    let weight = draft.uniform * length;
    let inside = rounded(random, 0.0, length, 10.0);
    let places: &[f64] = match random.below(3) {
        0 => &[length],
        1 => &[0.0, length],
        _ => &[0.0, inside],
    };
    let point = places.iter().map(|&at| PointLoad { at, force: weight * random.between(0.1, 10.0) }).collect();
    let ground = Some(bed(random, length, Bed::Level));
    Draft { point, supports: Some(Vec::new()), ground, soil: evenly(soil), ..draft }
}
