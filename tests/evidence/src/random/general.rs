//! Random scenes of the general beam, as scene files: whatever a beam may have, one to four of it at a time, over ground of every kind.

use std::fmt::Write as _;

use super::Random;

/// What a general beam may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Feature {
    /// Couples.
    Couple,
    /// Bending stiffness in steps.
    Steps,
    /// Joints that turn by their moment over a stiffness.
    Joint,
    /// Hinges.
    Hinge,
    /// Supports on springs.
    Spring,
    /// Springs against turning.
    Turning,
    /// Springs that only push.
    Stop,
    /// A foundation whose stiffness changes.
    SoilSteps,
    /// Tension, or compression.
    Tension,
}

impl Feature {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Couple,
        Self::Steps,
        Self::Joint,
        Self::Hinge,
        Self::Spring,
        Self::Turning,
        Self::Stop,
        Self::SoilSteps,
        Self::Tension,
    ];
}

/// A drawn scene file.
#[derive(Debug, Clone)]
pub struct General {
    /// The file.
    pub text: String,
    /// What it has.
    pub features: Vec<Feature>,
}

/// Scene number `i` with some of these features, over rigid ground or none, or on an elastic foundation.
#[must_use]
pub fn general(i: u64, of: &[Feature], on_soil: bool) -> General {
    drawn(Draw::of(i, of), on_soil)
}

/// The same with supports, joints, changes and couples at nodes of a grid of so many intervals.
#[must_use]
pub fn general_on_grid(i: u64, of: &[Feature], on_soil: bool, intervals: f64) -> General {
    let draw = Draw::of(i, of);
    drawn(Draw { intervals: Some(intervals), ..draw }, on_soil)
}

fn drawn(mut draw: Draw, on_soil: bool) -> General {
    draw.beam(on_soil);
    General { text: draw.text(), features: draw.features }
}

/// The parts of a file as they are drawn.
struct Draw {
    random: Random,
    /// Of the grid whose nodes places are, if they are.
    intervals: Option<f64>,
    features: Vec<Feature>,
    length: f64,
    stiffness: f64,
    uniform: f64,
    /// A deflection that the load may cause.
    sag: f64,
    beam: String,
    supports: Vec<String>,
    /// Places of supports and joints, which keep their distance.
    places: Vec<f64>,
    load: String,
    ground: String,
}

/// A number of few digits, so that a scene can be read.
fn short(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let unit = 10.0_f64.powf(value.abs().log10().floor() - 3.0);
    (value / unit).round() * unit
}

impl Draw {
    fn of(i: u64, of: &[Feature]) -> Self {
        let mut random = Random::new(0x006e_6e00_0000 + i);
        let mut features: Vec<Feature> = (0..1 + random.below(4)).map(|_| of[random.below(of.len())]).collect();
        features.sort();
        features.dedup();
        Self::new(random, features)
    }

    fn new(mut random: Random, features: Vec<Feature>) -> Self {
        let length = random.pick(&[4.0, 10.0, 12.0, 20.0]);
        let stiffness = short(10.0_f64.powf(random.between(0.0, 3.0)));
        let uniform = random.pick(&[0.2, 1.0, 1.0, 2.0]);
        let sag = 5.0 / 384.0 * uniform * length * length * length * length / stiffness;
        Self {
            random,
            intervals: None,
            features,
            length,
            stiffness,
            uniform,
            sag,
            beam: String::new(),
            supports: Vec::new(),
            places: Vec::new(),
            load: String::new(),
            ground: String::new(),
        }
    }

    fn has(&self, feature: Feature) -> bool {
        self.features.contains(&feature)
    }

    /// A power of ten between two, with few digits.
    fn power(&mut self, from: f64, to: f64) -> f64 {
        short(10.0_f64.powf(self.random.between(from, to)))
    }

    /// A place with few digits, or at a node.
    fn at(&self, x: f64) -> f64 {
        self.intervals.map_or_else(|| short(x), |n| self.length * (x / self.length * n).round() / n)
    }

    /// A place inside the beam, by thirds of a percent of it, away from those that are taken.
    fn place(&mut self) -> f64 {
        loop {
            let share = (300.0 * self.random.between(0.04, 0.96)).round() / 300.0;
            let x = self.at(share * self.length);
            if self.places.iter().all(|other| 0.01 * self.length < (other - x).abs()) {
                self.places.push(x);
                return x;
            }
        }
    }

    fn beam(&mut self, on_soil: bool) {
        let free = self.hold(on_soil);
        self.ground(on_soil, free);
        self.stiff();
        self.join();
        self.act();
        if self.has(Feature::Tension) {
            let tension = self.power(-1.0, 2.5) * self.stiffness / (self.length * self.length);
            let _ = writeln!(self.beam, "tension = {:?}", short(tension));
        }
    }

    /// What holds the beam. True if nothing does but the ground.
    fn hold(&mut self, on_soil: bool) -> bool {
        let (l, unit) = (self.length, self.stiffness / (self.length * self.length * self.length));
        let springs = self.has(Feature::Spring);
        let turning = self.has(Feature::Turning);
        let stops = self.has(Feature::Stop);
        let free = !(springs || turning) && self.random.once_in(4);
        let mut holds: Vec<f64> = Vec::new();
        if !free {
            match self.random.below(4) {
                0 => holds.push(0.0),
                1 => {
                    let x = l * self.random.between(0.6, 0.9);
                    holds.extend([0.0, self.at(x)]);
                }
                _ => holds.extend([0.0, l]),
            }
            if self.random.once_in(3) {
                let x = l * self.random.between(0.2, 0.55);
                holds.push(self.at(x));
            }
        }
        self.places.extend_from_slice(&holds);
        let single = holds.len() == 1;
        for (i, at) in holds.into_iter().enumerate() {
            let level =
                if self.random.once_in(5) { short(0.1 * self.sag * self.random.between(-1.0, 1.0)) } else { 0.0 };
            let mut keys = format!("at = {at:?}, level = {level:?}");
            let on_spring = springs && (i == 0 || self.random.once_in(2));
            let turns = turning && (i == 0 || self.random.once_in(2));
            if on_spring {
                let _ = write!(keys, ", stiffness = {:?}", short(unit * self.power(0.5, 4.0)));
            }
            if turns {
                let stiffness = short(unit * l * l * self.power(-1.0, 2.0));
                let _ = write!(keys, ", turning_stiffness = {stiffness:?}");
            } else if !on_spring && (single || self.random.once_in(5)) {
                let slope = if on_soil && self.random.once_in(3) { short(0.1 * self.sag / l) } else { 0.0 };
                let _ = write!(keys, ", built_in = true, slope = {slope:?}");
            }
            self.supports.push(format!("{{ {keys} }}"));
        }
        for _ in 0..if stops { 1 + self.random.below(2) } else { 0 } {
            let (at, level) = (self.place(), short(0.4 * self.sag * self.random.between(-0.2, 1.0)));
            let stiffness = short(unit * self.power(1.0, 4.0));
            let stop = format!("{{ at = {at:?}, level = {level:?}, stiffness = {stiffness:?}, pushes_only = true }}");
            self.supports.push(stop);
        }
        free
    }

    fn ground(&mut self, on_soil: bool, free: bool) {
        let (l, sag) = (self.length, self.sag);
        if !(on_soil || free) && self.random.once_in(6) {
            return;
        }
        let mean = sag * self.power(-2.0, 0.0);
        let part = |random: &mut Random| short(mean * random.between(-0.6, 0.6));
        let base = short(mean + 0.12 * sag);
        self.ground = match self.random.below(4) {
            0 => format!("depth = {base:?}\n"),
            1 => {
                let rise = part(&mut self.random);
                let coefficients = [base, short(-4.0 * rise / l), short(4.0 * rise / (l * l))];
                format!("polynomial = {coefficients:?}\n")
            }
            2 => {
                let (amplitude, phase) = (part(&mut self.random), short(self.random.between(0.0, 6.0)));
                let wavelength = short(l * self.random.between(0.4, 2.0));
                let wave = [("mean", base), ("amplitude", amplitude), ("wavelength", wavelength), ("phase", phase)];
                let wave = wave.map(|(key, value)| format!("{key} = {value:?}")).join(", ");
                format!("cosine = {{ {wave} }}\n")
            }
            _ => {
                let mut x: Vec<f64> =
                    (0..2 + self.random.below(4)).map(|_| short(self.random.between(0.0, l))).collect();
                x.extend([0.0, l]);
                x.sort_by(f64::total_cmp);
                x.dedup();
                let points: Vec<[f64; 2]> = x.into_iter().map(|x| [x, short(base + part(&mut self.random))]).collect();
                format!("points = {points:?}\n")
            }
        };
        if on_soil {
            let unit = self.stiffness / (l * l * l * l);
            let stiffness = short(unit * self.power(1.0, 5.0));
            let given = if self.has(Feature::SoilSteps) {
                let mut steps = vec![[0.0, stiffness]];
                for _ in 0..=self.random.below(2) {
                    let (at, none) = (self.place(), !free && self.random.once_in(4));
                    steps.push([at, if none { 0.0 } else { short(stiffness * self.power(-1.5, 1.5)) }]);
                }
                steps.sort_by(|a, b| a[0].total_cmp(&b[0]));
                format!("{{ steps = {steps:?} }}")
            } else {
                format!("{stiffness:?}")
            };
            let _ = writeln!(self.ground, "stiffness = {given}");
        }
    }

    fn stiff(&mut self) {
        let stiffness = self.stiffness;
        if !self.has(Feature::Steps) {
            let _ = writeln!(self.beam, "bending_stiffness = {stiffness:?}");
            return;
        }
        let mut steps = vec![[0.0, stiffness]];
        for _ in 0..=self.random.below(3) {
            let at = self.place();
            steps.push([at, short(stiffness * self.power(0.0, 1.3))]);
        }
        steps[1..].sort_by(|a, b| a[0].total_cmp(&b[0]));
        if self.random.once_in(2) {
            let last = steps.len() - 1;
            (steps[0][1], steps[last][1]) = (steps[last][1], steps[0][1]);
        }
        let _ = writeln!(self.beam, "bending_stiffness = {{ steps = {steps:?} }}");
    }

    fn join(&mut self) {
        let mut joints = Vec::new();
        if self.has(Feature::Joint) {
            for _ in 0..=self.random.below(2) {
                let (at, stiffness) = (self.place(), short(self.stiffness / self.length * self.power(-1.0, 2.0)));
                joints.push(format!("{{ at = {at:?}, stiffness = {stiffness:?} }}"));
            }
        }
        if self.has(Feature::Hinge) {
            let at = self.place();
            joints.push(format!("{{ at = {at:?} }}"));
        }
        if !joints.is_empty() {
            let _ = writeln!(self.beam, "joints = [{}]", joints.join(", "));
        }
    }

    fn act(&mut self) {
        let (l, total) = (self.length, self.uniform * self.length);
        let _ = writeln!(self.load, "uniform = {:?}", self.uniform);
        if self.random.once_in(3) {
            let [a, b] = [self.random.between(0.0, 0.5), self.random.between(0.5, 1.0)].map(|x| short(x * l));
            let [start, end] = [(); 2].map(|()| short(self.uniform * self.random.between(0.0, 2.0)));
            let _ = writeln!(self.load, "linear = [{{ from = {a:?}, to = {b:?}, start = {start:?}, end = {end:?} }}]");
        }
        if self.random.once_in(2) {
            let (at, force) = (short(l * self.random.between(0.1, 0.9)), short(total * self.random.between(0.1, 0.6)));
            let _ = writeln!(self.load, "point = [{{ at = {at:?}, force = {force:?} }}]");
        }
        if self.has(Feature::Couple) {
            let couple = |draw: &mut Self| {
                let (at, moment) = (draw.place(), short(0.1 * total * l * draw.random.between(-1.0, 1.0)));
                format!("{{ at = {at:?}, moment = {moment:?} }}")
            };
            let couples: Vec<String> = (0..=self.random.below(2)).map(|_| couple(self)).collect();
            let _ = writeln!(self.load, "couple = [{}]", couples.join(", "));
        }
    }

    fn text(&self) -> String {
        let Self { length, beam, supports, load, ground, .. } = self;
        let supports = supports.join(", ");
        let mut text = format!("[beam]\nlength = {length:?}\n{beam}supports = [{supports}]\n[load]\n{load}");
        if !ground.is_empty() {
            let _ = write!(text, "[foundation]\n{ground}");
        }
        text
    }
}
