//! A scene that is only numbers yet, good or bad, and the file that says so.

use std::fmt::Write as _;

/// What a scene file could say; nothing of it is checked.
#[derive(Debug, Clone)]
pub(crate) struct Draft {
    pub(crate) length: f64,
    pub(crate) stiffness: f64,
    pub(crate) uniform: f64,
    /// `from, to, start, end`.
    pub(crate) linear: Vec<[f64; 4]>,
    /// `at, force`.
    pub(crate) point: Vec<[f64; 2]>,
    pub(crate) ground: Ground,
}

/// What `[foundation]` could say.
#[derive(Debug, Clone)]
pub(crate) enum Ground {
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
        let Self { length, stiffness, uniform, linear, point, ground } = self;
        let mut text = format!("[beam]\nlength = {}\nbending_stiffness = {}\n", number(*length), number(*stiffness));
        let list = |values: &[f64]| values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", ");
        // Writing to a string does not fail.
        let _ = writeln!(text, "[load]\nuniform = {}", number(*uniform));
        for part in linear {
            let [from, to, start, end] = part.map(number);
            let _ = writeln!(text, "[[load.linear]]\nfrom = {from}\nto = {to}\nstart = {start}\nend = {end}");
        }
        for part in point {
            let [at, force] = part.map(number);
            let _ = writeln!(text, "[[load.point]]\nat = {at}\nforce = {force}");
        }
        let _ = match ground {
            Ground::None => Ok(()),
            Ground::Flat(depth) => writeln!(text, "[foundation]\ndepth = {}", number(*depth)),
            Ground::Polynomial(c) => writeln!(text, "[foundation]\npolynomial = [{}]", list(c)),
            Ground::Cosine(c) => {
                let [mean, amplitude, wavelength, phase] = c.map(number);
                writeln!(
                    text,
                    "[foundation.cosine]\nmean = {mean}\namplitude = {amplitude}\nwavelength = {wavelength}\nphase = {phase}"
                )
            }
            Ground::Points(points) => {
                let points: Vec<String> = points.iter().map(|p| format!("[{}]", list(p))).collect();
                writeln!(text, "[foundation]\npoints = [{}]", points.join(", "))
            }
        };
        text
    }

    /// The same in other units, which have to be powers of two: `EI` in `F L³/U`.
    pub(crate) fn in_units(&self, length: f64, force: f64, depth: f64) -> Self {
        let (mut unit, mut coefficients) = (depth, Vec::new());
        if let Ground::Polynomial(c) = &self.ground {
            for c in c {
                coefficients.push(c * unit);
                unit /= length;
            }
        }
        let density = force / length;
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
            ground: match &self.ground {
                Ground::None => Ground::None,
                Ground::Flat(u) => Ground::Flat(u * depth),
                Ground::Polynomial(_) => Ground::Polynomial(coefficients),
                Ground::Cosine([mean, amplitude, wavelength, phase]) => {
                    Ground::Cosine([mean * depth, amplitude * depth, wavelength * length, *phase])
                }
                Ground::Points(points) => {
                    Ground::Points(points.iter().map(|&[x, u]| [x * length, u * depth]).collect())
                }
            },
        }
    }
}

/// A number as TOML has it; reading it back gives the same bits.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:?}") }
}
