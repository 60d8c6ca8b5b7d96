//! One smooth piece of a foundation profile: its depth and all derivatives.

/// A full turn, `2π`.
const FULL: f64 = 2.0 * std::f64::consts::PI;

/// A smooth piece of the profile `u(x)`.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// `u = depth + slope (x − origin)`.
    Line {
        /// Position at which the depth is given.
        origin: f64,
        /// Depth at this position.
        depth: f64,
        /// Slope.
        slope: f64,
    },
    /// `u = Σ c_j x^j`: `c_0, c_1, …`
    Polynomial(Vec<f64>),
    /// `u = mean + amplitude cos(2π x / wavelength + phase)`.
    Cosine {
        /// Mean depth.
        mean: f64,
        /// Amplitude.
        amplitude: f64,
        /// Wavelength.
        wavelength: f64,
        /// Phase at `x = 0` \[rad\].
        phase: f64,
    },
    /// `g = u − w0` for a beam with an initial shape.
    Gap {
        /// `u`.
        ground: Box<Shape>,
        /// `w0`.
        own: Box<Shape>,
    },
}

/// The waves `A cos(ωx + φ)` of a cosine profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wave {
    /// `A`.
    pub(super) amplitude: f64,
    /// `ω`.
    pub(super) number: f64,
    wavelength: f64,
    phase: f64,
}

impl Wave {
    /// `ωx + φ`.
    pub(super) fn angle(&self, x: f64) -> f64 {
        FULL * (x / self.wavelength) + self.phase
    }
}

impl Shape {
    /// The waves of the piece: one for a cosine, two for the difference of two cosines.
    pub(super) fn waves(&self) -> [Option<Wave>; 2] {
        match *self {
            Self::Line { .. } | Self::Polynomial(_) => [None; 2],
            Self::Cosine { amplitude, wavelength, phase, .. } => {
                [Some(Wave { amplitude, number: FULL / wavelength, wavelength, phase }), None]
            }
            Self::Gap { ref ground, ref own } => {
                let [below, _] = ground.waves();
                let [own, _] = own.waves();
                [below, own.map(|wave| Wave { amplitude: -wave.amplitude, ..wave })]
            }
        }
    }

    /// The fourth derivative at `x` without the waves.
    pub(super) fn fourth_without_waves(&self, x: f64) -> f64 {
        match self {
            Self::Line { .. } | Self::Cosine { .. } => 0.0,
            Self::Polynomial(coefficients) if coefficients.len() < 5 => 0.0,
            Self::Polynomial(_) => {
                let mut taylor = [0.0; 5];
                self.taylor(x, &mut taylor);
                24.0 * taylor[4]
            }
            Self::Gap { ground, own } => ground.fourth_without_waves(x) - own.fourth_without_waves(x),
        }
    }

    /// A straight line through two points. Its origin is the shallower one, where a beam may touch it: next to a cliff of a million
    /// depths the rounding of the other end is a million times as large.
    pub(super) fn line([x0, u0]: [f64; 2], [x1, u1]: [f64; 2]) -> Self {
        let (origin, depth) = if u0.abs() <= u1.abs() { (x0, u0) } else { (x1, u1) };
        Self::Line { origin, depth, slope: (u1 - u0) / (x1 - x0) }
    }

    /// The degree of a polynomial; [`None`] for waves.
    pub(super) fn degree(&self) -> Option<usize> {
        match self {
            Self::Line { .. } => Some(1),
            Self::Polynomial(coefficients) => Some(coefficients.len().saturating_sub(1)),
            Self::Cosine { .. } => None,
            Self::Gap { ground, own } => Some(ground.degree()?.max(own.degree()?)),
        }
    }

    /// The degree of the polynomial part.
    pub(super) fn polynomial_degree(&self) -> usize {
        match self {
            Self::Gap { ground, own } => ground.polynomial_degree().max(own.polynomial_degree()),
            other => other.degree().unwrap_or(0),
        }
    }

    /// The rotation of the profile between its slope at `x` and the chord to `x + t`, `|(u(x + t) − u(x))/t − u'(x)|` with the sign of
    /// `u''`, with the digits of a small number. `even` leaves out the odd powers of its Taylor series.
    pub(super) fn bow(&self, x: f64, t: f64, even: bool) -> f64 {
        /// Number of terms for a cosine over a sixth of a wave: the truncated rest is below `0.53²²/22! < 10⁻²⁷` of it.
        const TERMS: usize = 22;
        let terms = match self {
            Self::Line { .. } => return 0.0,
            Self::Polynomial(coefficients) => coefficients.len().min(TERMS),
            Self::Cosine { .. } => TERMS,
            Self::Gap { ground, own } => return ground.bow(x, t, even) - own.bow(x, t, even),
        };
        let mut taylor = [0.0; TERMS];
        self.taylor(x, &mut taylor[..terms]);
        if even {
            taylor.iter_mut().skip(3).step_by(2).for_each(|c| *c = 0.0);
        }
        taylor[..terms].iter().skip(2).rev().fold(0.0, |sum, c| (sum + c) * t) * t.signum()
    }

    /// Whether [`Self::bow`] has all its digits over this length.
    pub(super) fn is_one_series_over(&self, length: f64) -> bool {
        match self {
            Self::Gap { ground, own } => ground.is_one_series_over(length) && own.is_one_series_over(length),
            _ => self.waves().into_iter().flatten().all(|wave| wave.number * length <= 1.0),
        }
    }

    /// Taylor coefficients `u^{(j)}(x) / j!` for all `j` below `out.len()`.
    pub(super) fn taylor(&self, x: f64, out: &mut [f64]) {
        out.fill(0.0);
        match self {
            Self::Line { origin, depth, slope } => {
                for (out, value) in out.iter_mut().zip([depth + slope * (x - origin), *slope]) {
                    *out = value;
                }
            }
            Self::Polynomial(coefficients) => shifted(coefficients, x, out),
            Self::Gap { ground, own } => {
                let mut of_own = vec![0.0; out.len()];
                own.taylor(x, &mut of_own);
                ground.taylor(x, out);
                out.iter_mut().zip(of_own).for_each(|(g, w)| *g -= w);
            }
            Self::Cosine { mean, amplitude, wavelength, phase } => {
                let wave = FULL / wavelength;
                let angle = FULL * (x / wavelength) + phase;
                let (sine, cosine) = (amplitude * libm::sin(angle), amplitude * libm::cos(angle));
                let mut factor = 1.0;
                for (j, c) in out.iter_mut().enumerate() {
                    *c = factor * [cosine, -sine, -cosine, sine][j % 4];
                    #[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
                    let next = (j + 1) as f64;
                    factor *= wave / next;
                }
                if let Some(first) = out.first_mut() {
                    *first += mean;
                }
            }
        }
    }
}

/// Coefficients of `Σ c_j (t + shift)^j` in powers of `t`, as many as `out` has room for.
pub(super) fn shifted(coefficients: &[f64], shift: f64, out: &mut [f64]) {
    // Repeated Horner scheme: pass i leaves coefficient i.
    if coefficients.len() <= out.len() {
        let n = coefficients.len();
        out[..n].copy_from_slice(coefficients);
        horner_passes(&mut out[..n], shift, n);
    } else {
        let mut work = coefficients.to_vec();
        horner_passes(&mut work, shift, out.len());
        let room = out.len();
        out.copy_from_slice(&work[..room]);
    }
}

/// `passes` passes of Horner's scheme, in place.
fn horner_passes(work: &mut [f64], shift: f64, passes: usize) {
    for i in 0..passes.min(work.len()) {
        for j in (i..work.len() - 1).rev() {
            work[j] += work[j + 1] * shift;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn taylor_coefficients_continue_the_profile() {
        // Sums of a few dozen terms of order 1; the series of the cosine is truncated at 0.5^22/22!.
        const ROUNDING: f64 = 1e-14;
        let polynomial = Shape::Polynomial(vec![1.0, -2.0, 0.5, 3.0, -1.0, 0.125]);
        let cosine = Shape::Cosine { mean: 0.3, amplitude: 1.5, wavelength: 2.0, phase: 0.4 };
        for shape in [polynomial, cosine] {
            let (mut there, mut here) = ([0.0; 22], [0.0; 22]);
            shape.taylor(1.0, &mut there);
            shape.taylor(1.2, &mut here);
            let mut continued = vec![0.0; 22];
            shifted(&there, 0.2, &mut continued);
            for j in 0..5 {
                assert!((continued[j] - here[j]).abs() <= ROUNDING * 1e3_f64.max(here[j].abs()), "order {j}");
            }
            let (mut few, mut many) = ([0.0; 3], [0.0; 22]);
            shape.taylor(0.7, &mut few);
            shape.taylor(0.7, &mut many);
            assert!(few.iter().zip(&many).all(|(a, b)| (a - b).abs() <= ROUNDING * a.abs()));
        }
    }
}
