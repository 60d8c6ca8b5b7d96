//! A scene that is only numbers yet, good or bad, and the file that says so.

use std::fmt::Write as _;

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Support};

/// What a scene file could say; nothing of it is checked.
#[derive(Debug, Clone, Default)]
pub(crate) struct Draft {
    pub(crate) length: f64,
    pub(crate) stiffness: f64,
    pub(crate) uniform: f64,
    /// `from, to, start, end`.
    pub(crate) linear: Vec<[f64; 4]>,
    /// `at, force`.
    pub(crate) point: Vec<[f64; 2]>,
    pub(crate) ground: Ground,
    /// [`None`] for the supports that are there if nothing is said of them.
    pub(crate) supports: Option<Vec<Support>>,
    /// The own shape.
    pub(crate) shape: Ground,
}

/// What `[foundation]` and `beam.shape` could say.
#[derive(Debug, Clone, Default)]
pub(crate) enum Ground {
    #[default]
    None,
    Flat(f64),
    Polynomial(Vec<f64>),
    /// `mean, amplitude, wavelength, phase`.
    Cosine([f64; 4]),
    Points(Vec<[f64; 2]>),
}

impl Draft {
    /// The scene file.
    pub(crate) fn text(&self) -> String {
        let Self { length, stiffness, uniform, linear, point, ground, supports, shape } = self;
        let mut text = format!("[beam]\nlength = {}\nbending_stiffness = {}\n", number(*length), number(*stiffness));
        // Writing to a string does not fail.
        if let Some(keys) = shape.keys() {
            let _ = writeln!(text, "shape = {{ {keys} }}");
        }
        if let Some(supports) = supports {
            let _ = writeln!(text, "supports = [{}]", supports.iter().map(support).collect::<Vec<_>>().join(", "));
        }
        let _ = writeln!(text, "[load]\nuniform = {}", number(*uniform));
        for part in linear {
            let [from, to, start, end] = part.map(number);
            let _ = writeln!(text, "[[load.linear]]\nfrom = {from}\nto = {to}\nstart = {start}\nend = {end}");
        }
        for part in point {
            let [at, force] = part.map(number);
            let _ = writeln!(text, "[[load.point]]\nat = {at}\nforce = {force}");
        }
        if let Some(keys) = ground.keys() {
            let _ = writeln!(text, "[foundation]\n{keys}");
        }
        text
    }

    /// The same in other units, which have to be powers of two: `EI` in `F L³/U`.
    pub(crate) fn in_units(&self, length: f64, force: f64, depth: f64) -> Self {
        let density = force / length;
        let support = |s: &Support| Support {
            at: s.at * length,
            level: s.level * depth,
            slope: s.slope.map(|slope| slope * (depth / length)),
        };
        Self {
            length: self.length * length,
            stiffness: self.stiffness * (force * length * length * length / depth),
            uniform: self.uniform * density,
            linear: self
                .linear
                .iter()
                .map(|&[a, b, s, e]| [a * length, b * length, s * density, e * density])
                .collect(),
            point: self.point.iter().map(|&[at, f]| [at * length, f * force]).collect(),
            ground: self.ground.in_units(length, depth),
            supports: self.supports.as_ref().map(|supports| supports.iter().map(support).collect()),
            shape: self.shape.in_units(length, depth),
        }
    }

    /// The supports, in the order in which the file has them.
    pub(crate) fn all_supports(&self) -> Vec<Support> {
        self.supports.clone().unwrap_or_else(|| vec![Support::simple(0.0), Support::simple(self.length)])
    }

    /// The loads, if they are some.
    pub(crate) fn load(&self) -> Option<Load> {
        let beam = Beam::new(self.length, self.stiffness).ok()?;
        let linear = self.linear.iter().map(|&[from, to, start, end]| LinearLoad { from, to, start, end });
        let point = self.point.iter().map(|&[at, force]| PointLoad { at, force });
        Load::new(&beam, self.uniform, linear.collect(), point.collect()).ok()
    }
}

impl Ground {
    /// Its keys in a scene file; [`None`] if there is none.
    fn keys(&self) -> Option<String> {
        let list = |values: &[f64]| values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", ");
        Some(match self {
            Self::None => return None,
            Self::Flat(depth) => format!("depth = {}", number(*depth)),
            Self::Polynomial(c) => format!("polynomial = [{}]", list(c)),
            Self::Cosine(c) => {
                let [mean, amplitude, wavelength, phase] = c.map(number);
                format!(
                    "cosine = {{ mean = {mean}, amplitude = {amplitude}, wavelength = {wavelength}, phase = {phase} }}"
                )
            }
            Self::Points(points) => {
                let points: Vec<String> = points.iter().map(|p| format!("[{}]", list(p))).collect();
                format!("points = [{}]", points.join(", "))
            }
        })
    }

    fn in_units(&self, length: f64, depth: f64) -> Self {
        match self {
            Self::None => Self::None,
            Self::Flat(u) => Self::Flat(u * depth),
            Self::Polynomial(c) => {
                let unit = std::iter::successors(Some(depth), |unit| Some(unit / length));
                Self::Polynomial(c.iter().zip(unit).map(|(c, unit)| c * unit).collect())
            }
            Self::Cosine([mean, amplitude, wavelength, phase]) => {
                Self::Cosine([mean * depth, amplitude * depth, wavelength * length, *phase])
            }
            Self::Points(points) => Self::Points(points.iter().map(|&[x, u]| [x * length, u * depth]).collect()),
        }
    }

    /// As the library has it.
    pub(crate) fn profile(&self) -> Option<Foundation> {
        Some(match self.clone() {
            Self::None => return None,
            Self::Flat(depth) => Foundation::Flat { depth },
            Self::Polynomial(coefficients) => Foundation::Polynomial { coefficients },
            Self::Cosine([mean, amplitude, wavelength, phase]) => {
                Foundation::Cosine { mean, amplitude, wavelength, phase }
            }
            Self::Points(points) => Foundation::Polyline { points },
        })
    }
}

/// An entry of `beam.supports`.
fn support(support: &Support) -> String {
    let [at, level] = [support.at, support.level].map(number);
    let slope = support.slope.map_or_else(String::new, |slope| format!(", built_in = true, slope = {}", number(slope)));
    format!("{{ at = {at}, level = {level}{slope} }}")
}

/// A number as TOML has it; reading it back gives the same bits.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:?}") }
}
