//! A scene as the elements see it: in shares of the length, over the least `EI`, read from its file by code of our own.

use serde_json::Value as Json;

/// Places closer than this share of the beam are one node: it is far above the rounding of `3 · 0.6`, and far below any result that is compared.
pub(super) const ONE_PLACE: f64 = 1e-11;

/// A number that the file is known to have.
fn number(value: &Json) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn or(table: &Json, key: &str, otherwise: f64) -> f64 {
    table.get(key).map_or(otherwise, number)
}

fn list(value: &Json) -> &[Json] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn pairs(value: &Json) -> Vec<[f64; 2]> {
    list(value).iter().map(|pair| [number(&pair[0]), number(&pair[1])]).collect()
}

/// A number, or steps: `(x, value)` from each place on.
fn steps(value: &Json) -> Vec<[f64; 2]> {
    if value.is_number() { vec![[0.0, number(value)]] } else { pairs(&value["steps"]) }
}

/// Of steps, the value at a place within one.
fn from_steps(steps: &[[f64; 2]], x: f64) -> f64 {
    steps[steps.partition_point(|step| step[0] <= x).max(1) - 1][1]
}

/// A support: what it holds, and how stiffly.
#[derive(Debug, Clone, Copy)]
pub(super) struct Support {
    pub(super) at: f64,
    pub(super) level: f64,
    /// Of a spring; none if it does not give.
    pub(super) stiffness: Option<f64>,
    pub(super) pushes_only: bool,
    /// The slope that it holds, with the stiffness of a turning spring.
    pub(super) turning: Option<(f64, Option<f64>)>,
}

/// The scene with lengths along the beam as shares of it and forces over `EI/l³`: deflections keep their unit.
#[derive(Debug, Clone)]
pub(super) struct Problem {
    length: f64,
    /// The least bending stiffness.
    stiffness: f64,
    bending: Vec<[f64; 2]>,
    ground: Option<Profile>,
    shape: Option<Profile>,
    uniform: f64,
    /// From, to, and the intensities there.
    linear: Vec<[f64; 4]>,
    forces: Vec<[f64; 2]>,
    couples: Vec<[f64; 2]>,
    /// Joints: where, and `k l/EI`, zero for a hinge.
    pub(super) joints: Vec<[f64; 2]>,
    pub(super) supports: Vec<Support>,
    /// `N l²/EI`.
    pub(super) tension: f64,
    /// Stiffness of the soil, `k l⁴/EI` from each place on.
    soil: Option<Vec<[f64; 2]>>,
    /// Where anything changes, supports, ends, and some places between: nodes of every mesh.
    pub(super) places: Vec<f64>,
}

impl Problem {
    /// Of a scene file.
    pub(super) fn read(text: &str) -> Self {
        let file: Json = toml::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"));
        let (beam, load, ground) = (&file["beam"], &file["load"], file.get("foundation"));
        let length = number(&beam["length"]);
        let bending = steps(&beam["bending_stiffness"]);
        let stiffness = bending.iter().fold(f64::INFINITY, |least, step| least.min(step[1]));
        let mut problem = Self {
            length,
            stiffness,
            bending: bending.iter().map(|[x, value]| [x / length, value / stiffness]).collect(),
            uniform: or(load, "uniform", 0.0),
            linear: list(&load["linear"])
                .iter()
                .map(|part| ["from", "to", "start", "end"].map(|key| number(&part[key])))
                .collect(),
            forces: list(&load["point"]).iter().map(|p| ["at", "force"].map(|key| number(&p[key]))).collect(),
            couples: list(&load["couple"]).iter().map(|c| ["at", "moment"].map(|key| number(&c[key]))).collect(),
            joints: list(&beam["joints"])
                .iter()
                .map(|joint| [number(&joint["at"]) / length, or(joint, "stiffness", 0.0) * length / stiffness])
                .collect(),
            shape: beam.get("shape").map(Profile::read),
            tension: or(beam, "tension", 0.0) * length * length / stiffness,
            soil: ground.and_then(|ground| ground.get("stiffness")).map(|k| {
                steps(k).iter().map(|[x, k]| [x / length, k * length * length * length * length / stiffness]).collect()
            }),
            ground: ground.map(Profile::read),
            supports: Vec::new(),
            places: Vec::new(),
        };
        problem.stand(beam.get("supports"));
        problem.place();
        problem
    }

    /// The supports, from left to right.
    fn stand(&mut self, supports: Option<&Json>) {
        let (length, near) = (self.length, ONE_PLACE * self.length);
        let simple = |at| Support { at, level: 0.0, stiffness: None, pushes_only: false, turning: None };
        let supports = supports.map(|supports| list(supports).iter());
        let given = supports.map(|supports| {
            let one = |support: &Json| {
                let at = number(&support["at"]);
                let slope =
                    (or(support, "slope", 0.0) - self.shape.as_ref().map_or(0.0, |shape| shape.slope(at))) * length;
                let turning = support.get("turning_stiffness").map(|k| Some(number(k) * length / self.stiffness));
                let turning = turning.or((support["built_in"] == true).then_some(None));
                let own = self.shape.as_ref().map_or(0.0, |shape| shape.depth(at, near));
                Support {
                    level: or(support, "level", 0.0) - own,
                    stiffness: support.get("stiffness").map(|k| number(k) * self.unit()),
                    pushes_only: support["pushes_only"] == true,
                    turning: turning.map(|stiffness| (slope, stiffness)),
                    ..simple(at / length)
                }
            };
            supports.map(one).collect()
        });
        self.supports = given.unwrap_or_else(|| {
            let own = |at| self.shape.as_ref().map_or(0.0, |shape| shape.depth(at, near));
            [0.0, length].map(|at| Support { level: -own(at), ..simple(at / length) }).to_vec()
        });
        self.supports.sort_by(|a, b| a.at.total_cmp(&b.at));
    }

    fn place(&mut self) {
        /// Places at even distances, so that a long beam without loads is compared as well.
        const BETWEEN: u32 = 16;
        let points = [&self.shape, &self.ground].into_iter().flatten().flat_map(Profile::points);
        let loads = self.linear.iter().flat_map(|part| [part[0], part[1]]);
        let acts = self.forces.iter().chain(&self.couples).map(|[at, _]| *at);
        let given = points.map(|point| point[0]).chain(loads).chain(acts).map(|x| x / self.length);
        let changes = self.bending.iter().chain(self.soil.iter().flatten()).chain(&self.joints).map(|step| step[0]);
        let supports = self.supports.iter().map(|support| support.at);
        let even = (0..=BETWEEN).map(|i| f64::from(i) / f64::from(BETWEEN));
        let mut places: Vec<f64> = given.chain(changes).chain(supports).chain(even).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|b, a| *b - *a < ONE_PLACE);
        self.places = places;
    }

    /// Length of the beam.
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// `EI` over the least one, within an element.
    pub(super) fn bending(&self, from: f64, to: f64) -> f64 {
        from_steps(&self.bending, 0.5 * (from + to))
    }

    /// Whether the ground is soil.
    pub(super) fn is_on_soil(&self) -> bool {
        self.soil.is_some()
    }

    /// Stiffness of the soil within an element, `k l⁴/EI`.
    pub(super) fn soil(&self, from: f64, to: f64) -> f64 {
        self.soil.as_ref().map_or(0.0, |soil| from_steps(soil, 0.5 * (from + to)))
    }

    /// The greatest one.
    pub(super) fn hardest_soil(&self) -> Option<f64> {
        self.soil.as_ref().map(|soil| soil.iter().fold(0.0, |most: f64, step| most.max(step[1])))
    }

    /// Whether it is no survey: fewer places than a survey of many readings has.
    pub(super) fn has_few_places(&self) -> bool {
        self.places.len() < 100
    }

    /// Whether rigid ground stands above a support that holds the beam.
    pub(super) fn contradicts(&self) -> bool {
        let above = |support: &Support| {
            !support.pushes_only && support.stiffness.is_none() && self.gap(support.at) < support.level
        };
        self.soil.is_none() && self.supports.iter().any(above)
    }

    /// `F l³/EI` of a force of 1.
    pub(super) fn unit(&self) -> f64 {
        self.length * self.length * self.length / self.stiffness
    }

    /// Intensity of the load, `q l⁴/EI`, at both ends of a stretch within which it is one line.
    pub(super) fn load(&self, from: f64, to: f64) -> [f64; 2] {
        let middle = 0.5 * (from + to) * self.length;
        let ends = [from, to].map(|x| {
            let parts = self.linear.iter().filter(|[from, to, ..]| *from < middle && middle < *to);
            let line =
                |[from, to, start, end]: &[f64; 4]| start + (end - start) / (to - from) * (x * self.length - from);
            self.uniform + parts.map(line).sum::<f64>()
        });
        ends.map(|q| q * self.length * self.unit())
    }

    /// What acts at places: where, and `F l³/EI` or `C l²/EI`.
    pub(super) fn forces(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.forces.iter().map(|[at, force]| (at / self.length, force * self.unit()))
    }

    /// Couples: where, and `C l²/EI`.
    pub(super) fn couples(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.couples.iter().map(|[at, moment]| (at / self.length, moment * self.unit() / self.length))
    }

    /// Whether the moment has two values at a place, or may have.
    pub(super) fn has_two_moments(&self, x: f64) -> bool {
        let is_here = |at: f64| (at - x).abs() < ONE_PLACE;
        let turned = self.supports.iter().filter(|support| support.turning.is_some()).map(|support| support.at);
        self.couples().map(|(at, _)| at).chain(turned).any(is_here)
    }

    /// The gap between ground and unloaded beam; at a step, or within rounding of one, the smaller one.
    pub(super) fn gap(&self, x: f64) -> f64 {
        let (at, near) = (x * self.length, ONE_PLACE * self.length);
        let shape = self.shape.as_ref().map_or(0.0, |shape| shape.depth(at, near));
        self.ground.as_ref().map_or(f64::INFINITY, |ground| ground.depth(at, near)) - shape
    }
}

/// A profile in the units of the file.
#[derive(Debug, Clone)]
enum Profile {
    Polynomial(Vec<f64>),
    /// Mean, amplitude, wavelength and phase.
    Wave([f64; 4]),
    Points(Vec<[f64; 2]>),
}

impl Profile {
    fn read(table: &Json) -> Self {
        if let Some(depth) = table.get("depth") {
            return Self::Polynomial(vec![number(depth)]);
        }
        if let Some(wave) = table.get("cosine") {
            return Self::Wave(["mean", "amplitude", "wavelength", "phase"].map(|key| or(wave, key, 0.0)));
        }
        match table.get("polynomial") {
            Some(coefficients) => Self::Polynomial(list(coefficients).iter().map(number).collect()),
            None => Self::Points(pairs(&table["points"])),
        }
    }

    /// Depth; the smallest one within `near` of the place.
    fn depth(&self, x: f64, near: f64) -> f64 {
        match self {
            Self::Polynomial(coefficients) => coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c),
            Self::Wave([mean, amplitude, wavelength, phase]) => {
                mean + amplitude * libm::cos(std::f64::consts::TAU * x / wavelength + phase)
            }
            Self::Points(points) => {
                let [from, to] =
                    [points.partition_point(|p| p[0] < x - near), points.partition_point(|p| p[0] <= x + near)];
                if from < to {
                    return points[from..to].iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
                }
                let ([a, u], [b, w]) = (points[from.saturating_sub(1)], points[from.min(points.len() - 1)]);
                if a < b { u + (w - u) * ((x - a) / (b - a)) } else { u }
            }
        }
    }

    /// Slope at a place where it has one.
    fn slope(&self, x: f64) -> f64 {
        match self {
            Self::Polynomial(coefficients) => {
                let terms = (1_u32..).zip(coefficients.iter().skip(1)).map(|(j, c)| f64::from(j) * c);
                terms.collect::<Vec<f64>>().iter().rev().fold(0.0, |sum, c| sum * x + c)
            }
            Self::Wave([_, amplitude, wavelength, phase]) => {
                let rate = std::f64::consts::TAU / wavelength;
                -amplitude * rate * libm::sin(rate * x + phase)
            }
            Self::Points(points) => {
                let next = points.partition_point(|p| p[0] <= x).clamp(1, points.len() - 1);
                (points[next][1] - points[next - 1][1]) / (points[next][0] - points[next - 1][0])
            }
        }
    }

    /// The points of a polyline.
    fn points(&self) -> &[[f64; 2]] {
        if let Self::Points(points) = self { points } else { &[] }
    }
}
