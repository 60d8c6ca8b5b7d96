//! Theory of a beam under an axial force `N`, tension positive: the law of one part, and the buckling load.
//!
//! ```text
//! EI v'''' − N v'' = q,    H = V + N v'            the vertical force; reactions are its jumps
//! φ_a = (ℓ/EI)(s₁ M_a + s₂ M_b),    z = N ℓ²/EI = u²        rotations of the ends of a part against its chord under end moments
//! s₁ = (u coth u − 1)/u²,    s₂ = (1 − u/sinh u)/u²
//! ```
//!
//! Both are quotients of power series in `z` with positive coefficients; the denominator is `S = sinh u/u`. No digits cancel for
//! a small force, and compression only changes the sign of `z`.

use super::written::{as_written, rounded};
use super::{Beam, SceneError, Support};

/// The greatest `ℓ √(|N|/EI)` of a part of a beam. It limits `|z|` to 0.64, so that the first omitted term of each series is
/// below the rounding of its sum.
pub(crate) const LONGEST: f64 = 0.8;

/// Terms of each series: `z^TERMS/(2·TERMS + 1)!` is below 10⁻¹⁸ for `|z| ≤ 0.64`.
const TERMS: u32 = 9;

/// `s₁`, `s₂` and `1/S` of a part with this `z`.
pub(crate) fn end_rotations(z: f64) -> [f64; 3] {
    // p = z^n/(2n + 1)!
    let (mut sine, mut near, mut far, mut p) = (0.0, 0.0, 0.0, 1.0);
    for n in (0..TERMS).map(|n| 2.0 * f64::from(n)) {
        let next = p / ((n + 2.0) * (n + 3.0));
        sine += p;
        near += next * (n + 2.0);
        far += next;
        p = next * z;
    }
    [near / sine, far / sine, 1.0 / sine]
}

/// `s₁`, `s₂` and `1/S` of a part of any length. Beyond [`LONGEST`] the closed forms are used, which lose no digits there.
pub(crate) fn end_rotations_of_any(z: f64) -> [f64; 3] {
    if z.abs() <= LONGEST * LONGEST {
        return end_rotations(z);
    }
    let u = z.abs().sqrt();
    if z < 0.0 {
        let sine = libm::sin(u);
        return [(1.0 - u * libm::cos(u) / sine) / (u * u), (u / sine - 1.0) / (u * u), u / sine];
    }
    // In a long part, moments at one end do not affect the other end.
    let fall = u / libm::sinh(u);
    [(u / libm::tanh(u) - 1.0) / (u * u), (1.0 - fall) / (u * u), fall]
}

/// The end curvatures of the cubic whose end rotations equal those of a part under end moments `EI` and zero. Without an axial
/// force they are one and zero.
pub(crate) fn as_cubic(z: f64) -> [f64; 2] {
    let [near, far, _] = end_rotations_of_any(z);
    [4.0 * near - 2.0 * far, 4.0 * far - 2.0 * near]
}

/// `EI/ℓ²` times the deflection of a part under a unit moment at its first end, at the fractions `σ` and `ρ = 1 − σ` of its
/// length from the two ends. By reciprocity it is also the rotation of that end under a load at this position.
///
/// ```text
/// ρ (S(z) − S(z ρ²))/(z S(z))
/// ```
pub(crate) fn bow(z: f64, [sigma, rho]: [f64; 2]) -> f64 {
    let (square, mut power) = (rho * rho, 1.0);
    let (mut sine, mut sum, mut p) = (0.0, 0.0, 1.0);
    // `1 − ρ^2n` as a sum, which does not cancel near the end.
    let mut fall = 0.0;
    for n in (0..TERMS).map(|n| 2.0 * f64::from(n)) {
        let next = p / ((n + 2.0) * (n + 3.0));
        fall += power;
        power *= square;
        sine += p;
        sum += next * fall;
        p = next * z;
    }
    rho * sigma * (1.0 + rho) * sum / sine
}

/// The reason why a beam is not stable under its compression.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unstable {
    /// The supports do not hold the beam.
    #[error(
        "`beam.tension` is {}: compression needs a beam that its supports hold, by two of them or a built-in one, and that no hinge leaves \
         free to move",
        as_written(*tension)
    )]
    Unheld {
        /// The axial force \[force\].
        tension: f64,
    },
    /// The compression exceeds the buckling load.
    #[error("`beam.tension` is {}: the beam buckles at {} before it touches", as_written(*tension), rounded(*at))]
    Buckles {
        /// The axial force \[force\].
        tension: f64,
        /// The axial force at which it buckles \[force\].
        at: f64,
    },
    /// The beam is stable, but its model on a coarse grid is not.
    #[error("`beam.tension` is {}: on {intervals} intervals the beam buckles before; more intervals are needed", as_written(*tension))]
    OnGrid {
        /// The axial force \[force\].
        tension: f64,
        /// The number of intervals.
        intervals: usize,
    },
}

impl Unstable {
    /// The same error in another unit of force.
    pub(crate) fn times(self, unit: f64) -> Self {
        match self {
            Self::Unheld { tension } => Self::Unheld { tension: tension * unit },
            Self::Buckles { tension, at } => Self::Buckles { tension: tension * unit, at: at * unit },
            Self::OnGrid { tension, intervals } => Self::OnGrid { tension: tension * unit, intervals },
        }
    }
}

/// A part of a beam between two neighbouring supports, joints or changes of stiffness, or a fraction of it.
struct Part {
    length: f64,
    stiffness: f64,
}

impl Beam {
    /// The axial force `N` below which the beam buckles on its bilateral supports alone; not positive, accurate to 12 digits
    /// \[force\].
    ///
    /// The elimination of deflections and moments along the beam ([`end_rotations`]) has one negative pivot for each moment while the
    /// stiffness is positive definite (Sylvester's law of inertia), and more beyond the buckling load.
    pub(crate) fn buckles_at(&self) -> f64 {
        /// Number of bisections of the interval that contains the buckling load.
        const STEPS: u32 = 48;
        let (mut safe, mut buckled) = (0.0, self.bending_stiffness() / (self.length() * self.length()));
        while self.is_stable(-buckled) && buckled.is_finite() {
            (safe, buckled) = (buckled, 2.0 * buckled);
        }
        for _ in 0..STEPS {
            let middle = 0.5 * (safe + buckled);
            if self.is_stable(-middle) { safe = middle } else { buckled = middle }
        }
        -buckled
    }

    /// Whether the beam on its bilateral supports is stable under this axial force.
    pub(super) fn is_stable(&self, tension: f64) -> bool {
        let built_in = self.supports().iter().filter(|s| s.is_built_in()).map(|s| s.at);
        let mut from = 0.0;
        // Built-in supports divide the beam into independent sections.
        built_in.chain([self.length()]).all(|to| {
            let stable = to <= from || self.is_stable_between([from, to], tension);
            from = to;
            stable
        })
    }

    fn is_stable_between(&self, [from, to]: [f64; 2], tension: f64) -> bool {
        let mut places: Vec<f64> = self.holding().map(|s| s.at).chain(self.changes()).collect();
        places.extend(self.joints().iter().map(|joint| joint.at));
        places.retain(|x| from < *x && *x < to);
        places.extend([from, to]);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut chain = Elimination::default();
        for ends in places.windows(2) {
            let stiffness = self.stiffness_between(ends[0], ends[1]);
            let whole = ends[1] - ends[0];
            let parts = parts_of(whole, tension, stiffness);
            for i in 0..parts {
                let part = Part { length: whole / f64::from(parts), stiffness };
                let fixed = if i == 0 { self.fixed_at(ends[0]) } else { Fixed::default() };
                chain.node(fixed, Some(&part), tension);
            }
        }
        chain.node(self.fixed_at(to), None, tension);
        chain.negative <= chain.nodes
    }

    /// The stiffnesses and releases at a position.
    fn fixed_at(&self, x: f64) -> Fixed {
        /// Effectively rigid compared with stiffnesses of order one.
        const RIGID: f64 = f64::from_bits(0x52b0_0000_0000_0000);
        let here = |at: f64| at.total_cmp(&x).is_eq();
        let support = self.holding().find(|support| here(support.at));
        let held = support.map_or(0.0, |support| support.stiffness.unwrap_or(RIGID));
        let turning = support.and_then(|support| support.turning_stiffness).unwrap_or(0.0);
        let is_built_in = support.is_some_and(Support::is_built_in);
        let end = (x <= 0.0 || self.length() <= x) && !is_built_in;
        let joint = self.joints().iter().find(|joint| here(joint.at));
        let joint = joint.map_or(0.0, |joint| joint.stiffness.map_or(RIGID, f64::recip));
        let free = [end && x <= 0.0, end && 0.0 < x].map(|end| if end { RIGID } else { 0.0 });
        Fixed { held, turning, free: [free[0], free[1] + joint] }
    }
}

/// The restraints and releases of a node: the stiffness against settlement and against rotation, and the rotational flexibility
/// before and behind the node.
#[derive(Debug, Clone, Copy, Default)]
struct Fixed {
    held: f64,
    turning: f64,
    free: [f64; 2],
}

/// The number of parts into which a stretch is divided so that none is longer than [`LONGEST`].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited just before")]
fn parts_of(length: f64, tension: f64, stiffness: f64) -> u32 {
    /// More parts than the memory for an exact solution allows; such a scene is rejected earlier.
    const MOST: f64 = 1e6;
    (length * (tension.abs() / stiffness).sqrt() / LONGEST).ceil().clamp(1.0, MOST) as u32
}

/// The elimination of `crate::qp::blocks` under an axial force; only the signs of the pivots are kept.
#[derive(Default)]
struct Elimination {
    b: f64,
    e: f64,
    g: f64,
    nodes: u32,
    negative: u32,
}

impl Elimination {
    /// Eliminates a node with the part to its right.
    fn node(&mut self, Fixed { held, turning, free: [before, behind] }: Fixed, part: Option<&Part>, tension: f64) {
        self.g += before;
        if 0.0 < turning {
            // Two moments at the node; the pivot of the first one is `−(g + 1/k)`.
            let share = 1.0 / (1.0 + turning * self.g);
            self.nodes += 1;
            self.negative += u32::from(0.0 < share);
            self.b += turning * share * self.e * self.e;
            (self.e, self.g) = (self.e * share, self.g * share);
        }
        let [c, n, w, off, left] = part.map_or([0.0; 5], |part| law(part.length, part.stiffness, tension));
        let (b, g) = (self.b + held, self.g + behind + w);
        let (a, h) = (b + n, c + self.e);
        let d = a * g + h * h;
        self.nodes += 1;
        self.negative += if 0.0 < d { 1 } else { 2 * u32::from(a < 0.0) };
        let e = self.e;
        self.b = (b * (c * c + n * g) + n * e * e) / d;
        self.e = (b * c * (g + off) + e * (c * e + left)) / d;
        self.g = w + (c * c * g + off * (c * h + c * e + left) - b * off * off) / d;
    }
}

/// `1/ℓ`, `N/ℓ`, `ℓ s₁/EI`, `ℓ s₂/EI` and `1/(ℓ² S)` of a part.
pub(crate) fn law(length: f64, stiffness: f64, tension: f64) -> [f64; 5] {
    let flexibility = length / stiffness;
    let [near, far, fall] = end_rotations(tension * length * flexibility);
    [1.0 / length, tension / length, flexibility * near, flexibility * far, fall / (length * length)]
}

impl Beam {
    /// The same beam under an axial force `N`, tension positive \[force\].
    ///
    /// # Errors
    ///
    /// [`SceneError::NotFinite`].
    pub fn with_tension(self, tension: f64) -> Result<Self, SceneError> {
        let tension = super::error::finite(super::Quantity::Tension, tension)?;
        Ok(self.tensioned(tension))
    }

    /// Checks that the beam is stable under its axial force.
    ///
    /// # Errors
    ///
    /// Compression of a beam that is not held by its supports or that buckles.
    pub(super) fn check_compression(&self) -> Result<(), Unstable> {
        let tension = self.tension();
        if 0.0 <= tension {
            return Ok(());
        }
        if !self.is_held() || self.is_mechanism(self.holding()) {
            return Err(Unstable::Unheld { tension });
        }
        if self.is_stable(tension) { Ok(()) } else { Err(Unstable::Buckles { tension, at: self.buckles_at() }) }
    }
}
