//! A span: the beam between two neighbouring contacts, or a support and a contact, in closed form.
//!
//! It is computed in the clearance `h = u − v`, not in `v`: at a contact `h` and, where the profile is smooth, `h'` vanish
//! exactly, so that even a tiny gap between two contacts is resolved to its last digits. With `g = u'''' − q`,
//!
//! ```text
//! h'''' = g + Σ (S_k δ''' + J_k δ'' − P_k δ)       steps S, kinks J and point loads P at the joints inside
//! h''(a) = −6 (η_a − η_b)/ℓ² − (4 φ_a + 2 φ_b)/ℓ + G_a,     G_a = ∫ g w_a + Σ (−S w_a''' + J w_a'' − P w_a)
//! h''(b) =  6 (η_a − η_b)/ℓ² + (2 φ_a + 4 φ_b)/ℓ + G_b,     w_a = t (ℓ − t)²/ℓ²,  w_b = t² (ℓ − t)/ℓ²
//! ```
//!
//! with `η = h` and `φ = h'` at the two ends, `ℓ = b − a`, `t = x − a`: the slope-deflection equations, `G` the fixed-end
//! moments.

use super::cosine;
use super::given::Given;

/// How a span begins or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Hold {
    /// `h` and `h'` are given: a contact, or a support at which the beam is clamped.
    Clamped {
        /// `h`.
        height: f64,
        /// `h'`.
        slope: f64,
        /// `v'`, where it is that which is given: at an edge. Beside a cliff `u' − h'` would lose its digits.
        turn: Option<f64>,
        /// `v`, where a break of the profile is not as deep as what `h` counts from: at the edge of a deep step.
        level: Option<f64>,
    },
    /// `h` and `h''` are given: a simple support, `v = v'' = 0`.
    Hinged {
        /// `h`.
        height: f64,
        /// `h''`.
        curvature: f64,
    },
}

impl Hold {
    /// On a smooth piece of the profile, or clamped to it: `h = h' = 0`.
    pub(super) const RESTING: Self = Self::Clamped { height: 0.0, slope: 0.0, turn: None, level: None };

    /// The same for `v = u − h`, beside a profile that has been moved up by `h`.
    pub(super) fn of_beam(self, profile: &[f64; 4]) -> Self {
        match self {
            Self::Clamped { slope, turn, level, .. } => {
                Self::Clamped { height: profile[0], slope: turn.unwrap_or(profile[1] - slope), turn, level }
            }
            Self::Hinged { curvature, .. } => Self::Hinged { height: profile[0], curvature: profile[2] - curvature },
        }
    }

    /// `v`, beside a profile at `depth`.
    pub(super) fn level(self, depth: f64) -> f64 {
        match self {
            Self::Clamped { level: Some(level), .. } => level,
            _ => depth - self.height(),
        }
    }

    /// `h`.
    pub(super) fn height(self) -> f64 {
        match self {
            Self::Clamped { height, .. } | Self::Hinged { height, .. } => height,
        }
    }
}

/// One end of a span: where, in which cell, and how it is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    /// Where.
    pub(super) x: f64,
    /// What its place is beyond `x`.
    pub(super) rest: f64,
    /// The cell of the span that ends there.
    pub(super) cell: usize,
    /// How it is held.
    pub(super) hold: Hold,
}

impl End {
    /// An end that rests on a smooth piece of the profile.
    pub(super) fn resting(x: f64, cell: usize) -> Self {
        Self { x, rest: 0.0, cell, hold: Hold::RESTING }
    }
}

/// A span at its two ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    /// Left end.
    pub(super) a: End,
    /// Right end.
    pub(super) b: End,
    /// `h, h', h'', h'''` at the left end.
    pub(super) at_a: [f64; 4],
    /// `h, h', h'', h'''` at the right end.
    pub(super) at_b: [f64; 4],
    /// `v, v', v'', v'''` at the left end.
    pub(super) beam_a: [f64; 4],
    /// `v, v', v'', v'''` at the right end.
    pub(super) beam_b: [f64; 4],
    /// True if it was solved in `v`: the derivatives of `v` are the accurate ones then, those of `h` are differences.
    pub(super) in_beam: bool,
}

impl Span {
    /// The span between two ends.
    ///
    /// The equations are the same in `v` with `v'''' = q`, and over many waves or cliffs of a profile they have to be solved
    /// in `v`: `h''` there is of the size of `u''`, and so would be the rounding of `v''`.
    pub(super) fn between(given: &Given, a: End, b: End) -> Self {
        let l = b.x - a.x;
        let (profile_a, profile_b) = (given.derivatives(a.cell, a.x), given.derivatives(b.cell, b.x));
        let (height_a, height_b) = (a.hold.height(), b.hold.height());
        let (at_left, at_right) = (a.hold.level(profile_a[0]), b.hold.level(profile_b[0]));
        let chord = |left: f64, right: f64| 6.0 * left.abs().max(right.abs()) / (l * l);
        let in_clearance =
            chord(height_a, height_b).max(profile_a[2].abs().max(profile_b[2].abs())).max(broken(given, &a, &b));
        if chord(at_left, at_right) < in_clearance {
            // Depths count from that at the left end, so that contacts beside each other at a great depth lose nothing.
            let (from, to) = (given.cells[a.cell].shape, given.cells[b.cell].shape);
            let resting = height_a == 0.0 && height_b == 0.0 && from == to;
            let rise = if resting { given.shapes[from].rise(a.x, b.x) } else { at_right - at_left };
            // Of the profile moved up to the beam: its height is that of the beam then. To add the clearance and take it off
            // again would cost the digits of the beam over a cliff.
            let beyond = |u: &[f64; 4], rest: f64, height: f64| [height + u[1] * rest, u[1] + u[2] * rest, u[2], u[3]];
            let holds =
                [a.hold.of_beam(&beyond(&profile_a, a.rest, 0.0)), b.hold.of_beam(&beyond(&profile_b, b.rest, rise))];
            let [mut beam_a, mut beam_b] = solve(l, holds, &fixed_end(given, &a, &b, Drive::Load));
            (beam_a[0], beam_b[0]) = (at_left, at_right);
            let (mut at_a, mut at_b) = (difference(&profile_a, &beam_a), difference(&profile_b, &beam_b));
            for (end, at) in [(&a, &mut at_a), (&b, &mut at_b)] {
                // What is given is known without rounding.
                match end.hold {
                    Hold::Clamped { height, slope, .. } => (at[0], at[1]) = (height, slope),
                    Hold::Hinged { height, curvature } => (at[0], at[2]) = (height, curvature),
                }
            }
            return Self { a, b, at_a, at_b, beam_a, beam_b, in_beam: true };
        }
        let [at_a, at_b] = solve(l, [a.hold, b.hold], &fixed_end(given, &a, &b, Drive::Clearance));
        let (beam_a, beam_b) = (difference(&profile_a, &at_a), difference(&profile_b, &at_b));
        Self { a, b, at_a, at_b, beam_a, beam_b, in_beam: false }
    }

    /// Its length `ℓ`.
    pub(super) fn length(&self) -> f64 {
        self.b.x - self.a.x
    }
}

/// What kinks and steps inside a span do to `h''`, taken one by one: over a cliff that goes down and up again they are
/// huge and cancel, and so `h` is not what to compute there.
fn broken(given: &Given, a: &End, b: &End) -> f64 {
    let l = b.x - a.x;
    let joints = given.joints_between(a.cell, b.cell).iter();
    joints.fold(0.0_f64, |most, j| most.max((4.0 * j.kink.abs() + 6.0 * j.step.abs() / l) / l))
}

/// Which fourth derivative.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Drive {
    /// Of `h`: `u'''' − q`.
    Clearance,
    /// Of `v`: `q`.
    Load,
}

/// Fixed-end moments `G` and shear forces of the drive over a span.
struct FixedEnd {
    moment: [f64; 2],
    shear: [f64; 2],
}

/// `u − v` or `u − h`, with three derivatives.
pub(super) fn difference(u: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
    [u[0] - v[0], u[1] - v[1], u[2] - v[2], u[3] - v[3]]
}

/// The slope-deflection equations: value and three derivatives at both ends of a span of length `l`.
fn solve(l: f64, [a, b]: [Hold; 2], fixed: &FixedEnd) -> [[f64; 4]; 2] {
    let (height_a, height_b) = (a.height(), b.height());
    let chord = 6.0 * (height_a - height_b) / (l * l);
    // h'' at the ends for φ_a = φ_b = 0.
    let (rest_a, rest_b) = (fixed.moment[0] - chord, fixed.moment[1] + chord);
    let (slope_a, slope_b) = match (a, b) {
        (Hold::Clamped { slope: left, .. }, Hold::Clamped { slope: right, .. }) => (left, right),
        (Hold::Hinged { curvature, .. }, Hold::Clamped { slope, .. }) => {
            (0.25 * l * (rest_a - curvature) - 0.5 * slope, slope)
        }
        (Hold::Clamped { slope, .. }, Hold::Hinged { curvature, .. }) => {
            (slope, 0.25 * l * (curvature - rest_b) - 0.5 * slope)
        }
        (Hold::Hinged { curvature: left, .. }, Hold::Hinged { curvature: right, .. }) => {
            // 4 φ_a + 2 φ_b = ℓ (rest_a − left),  2 φ_a + 4 φ_b = ℓ (right − rest_b).
            let (first, second) = (l * (rest_a - left), l * (right - rest_b));
            ((2.0 * first - second) / 6.0, (2.0 * second - first) / 6.0)
        }
    };
    let curvature_a = match a {
        Hold::Clamped { .. } => rest_a - (4.0 * slope_a + 2.0 * slope_b) / l,
        Hold::Hinged { curvature, .. } => curvature,
    };
    let curvature_b = match b {
        Hold::Clamped { .. } => rest_b + (2.0 * slope_a + 4.0 * slope_b) / l,
        Hold::Hinged { curvature, .. } => curvature,
    };
    let across = (curvature_b - curvature_a) / l;
    [
        [height_a, slope_a, curvature_a, across - fixed.shear[0]],
        [height_b, slope_b, curvature_b, across + fixed.shear[1]],
    ]
}

/// `G_a`, `G_b` and `∫ g (ℓ − t)/ℓ`, `∫ g t/ℓ`, point loads included; kinks and steps turn the beam but carry no force.
fn fixed_end(given: &Given, a: &End, b: &End, of: Drive) -> FixedEnd {
    let l = b.x - a.x;
    let (mut moment, mut shear) = ([0.0; 2], [0.0; 2]);
    let mut add = |x: f64, force: f64| {
        let (s, r) = ((x - a.x) / l, (b.x - x) / l);
        moment[0] += force * s * r * r * l;
        moment[1] += force * s * s * r * l;
        shear[0] += force * r;
        shear[1] += force * s;
    };
    let wave = given.shapes[given.cells[a.cell].shape].wave();
    // The waves of a cosine follow in closed form.
    let drive = |cell, x| match of {
        Drive::Load => given.load(cell, x),
        Drive::Clearance if wave.is_some() => -given.load(cell, x),
        Drive::Clearance => given.drive(cell, x),
    };
    let sign = if of == Drive::Load { 1.0 } else { -1.0 };
    for cell in a.cell..=b.cell {
        let (lo, hi) = (given.cells[cell].lo.max(a.x), given.cells[cell].hi.min(b.x));
        if lo < hi {
            for (x, weight) in given.load_rule.points(lo, hi) {
                add(x, weight * drive(cell, x));
            }
        }
    }
    for joint in given.joints_between(a.cell, b.cell) {
        if joint.force != 0.0 {
            add(joint.x, sign * joint.force);
        }
    }
    if of == Drive::Load {
        return FixedEnd { moment, shear };
    }
    for joint in given.joints_between(a.cell, b.cell) {
        let s = (joint.x - a.x) / l;
        moment[0] += (joint.kink * (6.0 * s - 4.0) - 6.0 * joint.step / l) / l;
        moment[1] += (joint.kink * (2.0 - 6.0 * s) + 6.0 * joint.step / l) / l;
    }
    if let Some(wave) = wave {
        let (g, q) = cosine::fixed_end(wave.amplitude, wave.number, wave.angle(0.5 * (a.x + b.x)), l);
        for end in 0..2 {
            moment[end] += g[end];
            shear[end] += q[end];
        }
    }
    FixedEnd { moment, shear }
}
