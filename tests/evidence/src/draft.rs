//! A scene that is only numbers yet, good or bad: as a scene, as the file that says so, in other units.

use std::fmt::Write as _;

use palkki::scene::{Beam, CoupleLoad, Foundation, Joint, LinearLoad, Load, PointLoad, Scene, SceneError, Support};

use crate::paper::{LENGTH, STIFFNESS, UNIFORM};

/// What a scene file could say; nothing of it is checked.
#[derive(Debug, Clone, Default)]
pub struct Draft {
    /// Length of the beam.
    pub length: f64,
    /// Bending stiffness.
    pub stiffness: f64,
    /// Bending stiffness from each place on; without any it is `stiffness`.
    pub steps: Vec<[f64; 2]>,
    /// Joints.
    pub joints: Vec<Joint>,
    /// Tension, negative for compression.
    pub tension: f64,
    /// Uniform load.
    pub uniform: f64,
    /// Loads that vary linearly.
    pub linear: Vec<LinearLoad>,
    /// Point loads.
    pub point: Vec<PointLoad>,
    /// Couples.
    pub couple: Vec<CoupleLoad>,
    /// The foundation, if there is one.
    pub ground: Option<Foundation>,
    /// Stiffness of the foundation from each place on; without any it is rigid.
    pub soil: Vec<[f64; 2]>,
    /// [`None`] for the supports that are there if nothing is said of them.
    pub supports: Option<Vec<Support>>,
    /// The own shape, if the beam has one.
    pub shape: Option<Foundation>,
}

/// The units of a scene become smaller by these factors: by so much its numbers become larger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Unit along the beam.
    pub length: f64,
    /// Unit of depth.
    pub depth: f64,
    /// Unit of force.
    pub force: f64,
}

impl Units {
    /// No change.
    pub const SAME: Self = Self { length: 1.0, depth: 1.0, force: 1.0 };

    /// Whether all of them are powers of two, so that no digit of the data is rounded.
    #[must_use]
    pub fn exact(&self) -> bool {
        const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
        [self.length, self.depth, self.force].iter().all(|f| f.to_bits() & MANTISSA == 0)
    }
}

impl Draft {
    /// Beam and load of the example over some foundation.
    #[must_use]
    pub fn over(foundation: Foundation) -> Self {
        let ground = Some(foundation);
        Self { length: LENGTH, stiffness: STIFFNESS, uniform: UNIFORM, ground, ..Self::default() }
    }

    /// With point loads `(place, force)`.
    #[must_use]
    pub fn with_points(self, points: &[(f64, f64)]) -> Self {
        Self { point: points.iter().map(|&(at, force)| PointLoad { at, force }).collect(), ..self }
    }

    /// The beam.
    ///
    /// # Errors
    ///
    /// What is wrong with its numbers.
    pub fn beam(&self) -> Result<Beam, SceneError> {
        let beam =
            Beam::new(self.length, self.stiffness)?.with_joints(self.joints.clone())?.with_tension(self.tension)?;
        let beam = if self.steps.is_empty() { beam } else { beam.with_steps(self.steps.clone())? };
        let beam = match &self.supports {
            Some(supports) => beam.with_supports(supports.clone())?,
            None => beam,
        };
        match &self.shape {
            Some(shape) => beam.with_shape(shape.clone()),
            None => Ok(beam),
        }
    }

    /// The scene.
    ///
    /// # Errors
    ///
    /// What is wrong with its numbers.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let (beam, load, ground) = (self.beam()?, self.load()?, self.ground.clone());
        match &self.soil[..] {
            [] => Scene::new(beam, load, ground),
            [[0.0, k]] => Scene::above(beam, load, ground, Some(*k)),
            steps => Scene::above_steps(beam, load, ground, steps.to_vec()),
        }
    }

    /// The loads, whatever the beam is held by.
    ///
    /// # Errors
    ///
    /// What is wrong with their numbers, or with the length of the beam.
    pub fn load(&self) -> Result<Load, SceneError> {
        let beam = Beam::new(self.length, self.stiffness)?;
        Load::new(&beam, self.uniform, self.linear.clone(), self.point.clone())?
            .with_couples(&beam, self.couple.clone())
    }

    /// The supports, in the order in which the file has them.
    #[must_use]
    pub fn all_supports(&self) -> Vec<Support> {
        self.supports.clone().unwrap_or_else(|| vec![Support::simple(0.0), Support::simple(self.length)])
    }

    /// Where something is: ends, loads, points of the ground.
    #[must_use]
    pub fn places(&self) -> Vec<f64> {
        let loads = self.point.iter().map(|p| p.at).chain(self.linear.iter().flat_map(|q| [q.from, q.to]));
        [0.0, self.length].into_iter().chain(loads).chain(self.points().iter().map(|p| p[0])).collect()
    }

    /// The points of the ground, if that is what it is given by.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        match &self.ground {
            Some(Foundation::Polyline { points }) => points,
            _ => &[],
        }
    }

    /// The scene file.
    #[must_use]
    pub fn text(&self) -> String {
        let bending = if self.steps.is_empty() { number(self.stiffness) } else { in_steps(&self.steps) };
        let Self { length, uniform, linear, point, couple, ground, soil, supports, shape, .. } = self;
        let mut text = format!("[beam]\nlength = {}\nbending_stiffness = {}\n", number(*length), bending);
        // Writing to a string does not fail.
        if self.tension != 0.0 {
            let _ = writeln!(text, "tension = {}", number(self.tension));
        }
        if !self.joints.is_empty() {
            let _ = writeln!(text, "joints = [{}]", self.joints.iter().map(joint).collect::<Vec<_>>().join(", "));
        }
        if let Some(shape) = shape {
            let _ = writeln!(text, "shape = {{ {} }}", keys(shape));
        }
        if let Some(supports) = supports {
            let _ = writeln!(text, "supports = [{}]", supports.iter().map(support).collect::<Vec<_>>().join(", "));
        }
        let _ = writeln!(text, "[load]\nuniform = {}", number(*uniform));
        for part in linear {
            let [from, to, start, end] = [part.from, part.to, part.start, part.end].map(number);
            let _ = writeln!(text, "[[load.linear]]\nfrom = {from}\nto = {to}\nstart = {start}\nend = {end}");
        }
        for part in point {
            let [at, force] = [part.at, part.force].map(number);
            let _ = writeln!(text, "[[load.point]]\nat = {at}\nforce = {force}");
        }
        for part in couple {
            let [at, moment] = [part.at, part.moment].map(number);
            let _ = writeln!(text, "[[load.couple]]\nat = {at}\nmoment = {moment}");
        }
        if let Some(ground) = ground {
            let _ = writeln!(text, "[foundation]\n{}", keys(ground));
        }
        if ground.is_some() && !soil.is_empty() {
            let _ = writeln!(text, "stiffness = {}", in_steps(soil));
        }
        text
    }

    /// The same from right to left.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let length = self.length;
        let profile = |profile: &Option<Foundation>| profile.as_ref().map(|profile| turned(profile, length));
        let linear =
            |q: &LinearLoad| LinearLoad { from: length - q.to, to: length - q.from, start: q.end, end: q.start };
        let support = |s: &Support| Support { at: length - s.at, slope: s.slope.map(|slope| -slope), ..*s };
        Self {
            steps: back(&self.steps, length),
            soil: back(&self.soil, length),
            joints: self.joints.iter().map(|j| Joint { at: length - j.at, ..*j }).collect(),
            couple: self.couple.iter().map(|c| CoupleLoad { at: length - c.at, moment: -c.moment }).collect(),
            linear: self.linear.iter().map(linear).collect(),
            point: self.point.iter().map(|p| PointLoad { at: length - p.at, ..*p }).collect(),
            ground: profile(&self.ground),
            supports: self.supports.as_ref().map(|supports| supports.iter().map(support).collect()),
            shape: profile(&self.shape),
            ..self.clone()
        }
    }

    /// The same in other units; `EI` has the unit force · length³ / depth.
    #[must_use]
    pub fn in_units(&self, units: Units) -> Self {
        let Units { length, depth, force } = units;
        let (density, bending) = (force / length, force * length * length * length / depth);
        let linear = |q: &LinearLoad| LinearLoad {
            from: q.from * length,
            to: q.to * length,
            start: q.start * density,
            end: q.end * density,
        };
        let support = |s: &Support| Support {
            at: s.at * length,
            level: s.level * depth,
            slope: s.slope.map(|slope| slope * (depth / length)),
            stiffness: s.stiffness.map(|k| k * (force / depth)),
            turning_stiffness: s.turning_stiffness.map(|k| k * (bending / length)),
            ..*s
        };
        let profile = |profile: &Option<Foundation>| profile.as_ref().map(|profile| scaled(profile, length, depth));
        Self {
            length: self.length * length,
            stiffness: self.stiffness * bending,
            steps: self.steps.iter().map(|[x, stiffness]| [x * length, stiffness * bending]).collect(),
            joints: self
                .joints
                .iter()
                .map(|j| Joint { at: j.at * length, stiffness: j.stiffness.map(|k| k * (bending / length)) })
                .collect(),
            couple: self
                .couple
                .iter()
                .map(|c| CoupleLoad { at: c.at * length, moment: c.moment * (force * length) })
                .collect(),
            tension: self.tension * (force * length / depth),
            soil: self.soil.iter().map(|[x, k]| [x * length, k * (density / depth)]).collect(),
            uniform: self.uniform * density,
            linear: self.linear.iter().map(linear).collect(),
            point: self.point.iter().map(|p| PointLoad { at: p.at * length, force: p.force * force }).collect(),
            ground: profile(&self.ground),
            supports: self.supports.as_ref().map(|supports| supports.iter().map(support).collect()),
            shape: profile(&self.shape),
        }
    }
}

impl From<&Scene> for Draft {
    fn from(scene: &Scene) -> Self {
        let (beam, load) = (scene.beam(), scene.load());
        Self {
            length: beam.length(),
            stiffness: beam.bending_stiffness(),
            steps: beam.steps().to_vec(),
            joints: beam.joints().to_vec(),
            tension: beam.tension(),
            uniform: load.uniform(),
            linear: load.linear().to_vec(),
            point: load.point().to_vec(),
            couple: load.couple().to_vec(),
            ground: scene.foundation().cloned(),
            soil: match scene.ground_steps() {
                [] => scene.ground_stiffness().map(|k| [0.0, k]).into_iter().collect(),
                steps => steps.to_vec(),
            },
            supports: Some(beam.supports_as_given()),
            shape: beam.shape().cloned(),
        }
    }
}

/// A profile from 0 to a length, seen from the other end.
fn turned(profile: &Foundation, length: f64) -> Foundation {
    match profile {
        Foundation::Flat { .. } => profile.clone(),
        Foundation::Polynomial { coefficients } => {
            // By Horner's rule in powers of l − x.
            let turned = coefficients.iter().rev().fold(vec![0.0], |sum, c| {
                let mut next = vec![0.0; sum.len() + 1];
                for (j, s) in sum.iter().enumerate() {
                    next[j] += length * s;
                    next[j + 1] -= s;
                }
                next[0] += c;
                next
            });
            Foundation::Polynomial { coefficients: turned[..coefficients.len()].to_vec() }
        }
        &Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            let phase = -(phase + std::f64::consts::TAU * length / wavelength);
            Foundation::Cosine { mean, amplitude, wavelength, phase }
        }
        Foundation::Polyline { points } => {
            Foundation::Polyline { points: points.iter().rev().map(|&[x, u]| [length - x, u]).collect() }
        }
    }
}

/// A profile with its places multiplied by one factor and its depths by another.
#[must_use]
pub fn scaled(profile: &Foundation, length: f64, depth: f64) -> Foundation {
    match profile {
        Foundation::Flat { depth: u } => Foundation::Flat { depth: u * depth },
        Foundation::Polynomial { coefficients } => {
            let unit = std::iter::successors(Some(depth), |unit| Some(unit / length));
            Foundation::Polynomial { coefficients: coefficients.iter().zip(unit).map(|(c, unit)| c * unit).collect() }
        }
        &Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            let (mean, amplitude) = (mean * depth, amplitude * depth);
            Foundation::Cosine { mean, amplitude, wavelength: wavelength * length, phase }
        }
        Foundation::Polyline { points } => {
            Foundation::Polyline { points: points.iter().map(|&[x, u]| [x * length, u * depth]).collect() }
        }
    }
}

/// The keys of a profile in a scene file.
fn keys(profile: &Foundation) -> String {
    let list = |values: &[f64]| values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", ");
    match profile {
        Foundation::Flat { depth } => format!("depth = {}", number(*depth)),
        Foundation::Polynomial { coefficients } => format!("polynomial = [{}]", list(coefficients)),
        Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            let [mean, amplitude, wavelength, phase] = [mean, amplitude, wavelength, phase].map(|v| number(*v));
            format!("cosine = {{ mean = {mean}, amplitude = {amplitude}, wavelength = {wavelength}, phase = {phase} }}")
        }
        Foundation::Polyline { points } => {
            let points: Vec<String> = points.iter().map(|p| format!("[{}]", list(p))).collect();
            format!("points = [{}]", points.join(", "))
        }
    }
}

/// A number, or steps.
fn in_steps(steps: &[[f64; 2]]) -> String {
    let step = |[x, value]: &[f64; 2]| format!("[{}, {}]", number(*x), number(*value));
    match steps {
        [[0.0, value]] => number(*value),
        steps => format!("{{ steps = [{}] }}", steps.iter().map(step).collect::<Vec<_>>().join(", ")),
    }
}

/// Steps from right to left.
fn back(steps: &[[f64; 2]], length: f64) -> Vec<[f64; 2]> {
    let ends = steps.iter().skip(1).map(|step| step[0]).chain([length]);
    let mut back: Vec<[f64; 2]> = steps.iter().zip(ends).map(|([_, value], end)| [length - end, *value]).collect();
    back.reverse();
    back
}

/// An entry of `beam.joints`.
fn joint(joint: &Joint) -> String {
    let stiffness = joint.stiffness.map_or_else(String::new, |k| format!(", stiffness = {}", number(k)));
    format!("{{ at = {}{stiffness} }}", number(joint.at))
}

/// An entry of `beam.supports`.
fn support(support: &Support) -> String {
    let [at, level] = [support.at, support.level].map(number);
    let key =
        |key: &str, value: Option<f64>| value.map_or_else(String::new, |value| format!(", {key} = {}", number(value)));
    let (spring, turning) = (key("stiffness", support.stiffness), key("turning_stiffness", support.turning_stiffness));
    let built_in = if support.is_built_in() { ", built_in = true" } else { "" };
    let slope = key("slope", support.slope);
    let pushes = if support.pushes_only { ", pushes_only = true" } else { "" };
    format!("{{ at = {at}, level = {level}{spring}{turning}{built_in}{slope}{pushes} }}")
}

/// A number as TOML has it; reading it back gives the same bits.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:?}") }
}
