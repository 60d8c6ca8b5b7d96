//! A span: the beam between two neighbouring contacts, or a support and a contact, in closed form.
//!
//! It is computed in the clearance `h = u − v`, not in `v`: at a contact `h` and, where the profile is smooth, `h'` vanish
//! exactly, so that even a tiny gap between two contacts is resolved to its last digits. With `g = u'''' − q`,
//!
//! ```text
//! h'''' = g + Σ (S_k δ''' + J_k δ'' − P_k δ)       steps S, kinks J and point loads P at the breakpoints inside
//! h''(a) = −(4 φ_a + 2 φ_b)/ℓ + G_a,     G_a = ∫ g w_a + Σ (−S w_a''' + J w_a'' − P w_a)
//! h''(b) =  (2 φ_a + 4 φ_b)/ℓ + G_b,     w_a = t (ℓ − t)²/ℓ²,  w_b = t² (ℓ − t)/ℓ²
//! ```
//!
//! with `φ = h' − (h(b) − h(a))/ℓ` at the two ends, `ℓ = b − a`, `t = x − a`: the slope-deflection equations, `G` the
//! fixed-end moments. Slopes count from the straight line through both ends, because over a short span they differ from it
//! by far less than they are.

use super::cosine;
use super::piecewise::PiecewiseScene;

/// How a span begins or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Hold {
    /// On a smooth piece of the profile, or clamped to it: `h = h' = 0`.
    Resting,
    /// On a break of the profile: `v` and `v'` are given.
    Edge {
        /// `h`: at the lower side of a step its height.
        height: f64,
        /// `v`.
        level: f64,
        /// `v'` is the sum of these two numbers. Contacts that are close together feel digits of it beyond the last one of
        /// the first number.
        slope: [f64; 2],
    },
    /// A simple support: `v = v'' = 0`.
    Support,
}

impl Hold {
    /// `h`, where the profile is `depth` deep.
    fn height(self, depth: f64) -> f64 {
        match self {
            Self::Resting => 0.0,
            Self::Edge { height, .. } => height,
            Self::Support => depth,
        }
    }

    /// `v`, where the profile is `depth` deep.
    fn level(self, depth: f64) -> f64 {
        match self {
            Self::Resting => depth,
            Self::Edge { level, .. } => level,
            Self::Support => 0.0,
        }
    }
}

/// One end of a span: where, in which cell, and how it is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    /// Where.
    pub(super) x: f64,
    /// What its place is beyond `x`, where it rests on a smooth piece of the profile; not used at an edge, which cannot move.
    pub(super) rest: f64,
    /// The cell of the span that ends there.
    pub(super) cell: usize,
    /// How it is held.
    pub(super) hold: Hold,
}

impl End {
    /// An end that rests on a smooth piece of the profile.
    pub(super) fn resting(x: f64, cell: usize) -> Self {
        Self { x, rest: 0.0, cell, hold: Hold::Resting }
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
}

impl Span {
    /// The span between two ends.
    ///
    /// The equations are the same in `v` with `v'''' = q`, and over many waves or cliffs of a profile they have to be solved
    /// in `v`: `h''` there is of the size of `u''`, and so would be the rounding of `v''`.
    pub(super) fn between(given: &PiecewiseScene, a: End, b: End) -> Self {
        let l = b.x - a.x;
        let profiles = [given.derivatives(a.cell, a.x), given.derivatives(b.cell, b.x)];
        let ends = [&a, &b];
        let heights = [0, 1].map(|i| ends[i].hold.height(profiles[i][0]));
        let levels = [0, 1].map(|i| ends[i].hold.level(profiles[i][0]));
        let chord = |at: [f64; 2]| 6.0 * at[0].abs().max(at[1].abs()) / (l * l);
        let in_clearance =
            chord(heights).max(profiles[0][2].abs().max(profiles[1][2].abs())).max(broken(given, &a, &b));
        let in_beam = chord(levels) < in_clearance;
        let rise = if in_beam {
            let beyond = |i: usize| if ends[i].hold == Hold::Resting { profiles[i][1] * ends[i].rest } else { 0.0 };
            levels[1] - levels[0] + (beyond(1) - beyond(0))
        } else {
            heights[1] - heights[0]
        };
        let incline = rise / l;
        let held = [0, 1].map(|i| match (ends[i].hold, in_beam) {
            (Hold::Resting, true) => Held::Slope(profiles[i][1] + profiles[i][2] * ends[i].rest - incline),
            (Hold::Resting, false) => Held::Slope(-incline),
            (Hold::Edge { slope: [slope, rest], .. }, true) => Held::Slope(slope - incline + rest),
            (Hold::Edge { slope: [slope, rest], .. }, false) => Held::Slope(profiles[i][1] - slope - rest - incline),
            (Hold::Support, true) => Held::Curvature(0.0),
            (Hold::Support, false) => Held::Curvature(profiles[i][2]),
        });
        let solved = solve(l, held, &fixed_end(given, &a, &b, if in_beam { Drive::Load } else { Drive::Clearance }));
        let mut at = [[0.0; 4]; 2];
        let mut beam = [[0.0; 4]; 2];
        for i in 0..2 {
            let [slope, curvature, third] = solved[i];
            let profile = &profiles[i];
            if in_beam {
                beam[i] = [levels[i], slope + incline, curvature, third];
                at[i] = difference(profile, &beam[i]);
            } else {
                at[i] = [heights[i], slope + incline, curvature, third];
                beam[i] = difference(profile, &at[i]);
            }
            // What is given is known without rounding.
            at[i][0] = heights[i];
            match ends[i].hold {
                Hold::Resting => at[i][1] = 0.0,
                Hold::Edge { slope: [slope, rest], .. } => {
                    (at[i][1], beam[i][1]) = (profile[1] - slope - rest, slope);
                }
                Hold::Support => (at[i][2], beam[i][2]) = (profile[2], 0.0),
            }
        }
        let [at_a, at_b] = at;
        let [beam_a, beam_b] = beam;
        Self { a, b, at_a, at_b, beam_a, beam_b }
    }

    /// Its length `ℓ`.
    pub(super) fn length(&self) -> f64 {
        self.b.x - self.a.x
    }
}

/// What kinks and steps inside a span do to `h''`, taken one by one: over a cliff that goes down and up again they are
/// huge and cancel, and so `h` is not what to compute there.
fn broken(given: &PiecewiseScene, a: &End, b: &End) -> f64 {
    let l = b.x - a.x;
    let breakpoints = given.breakpoints_between(a.cell, b.cell).iter();
    breakpoints.fold(0.0_f64, |most, j| most.max((4.0 * j.kink.abs() + 6.0 * j.step.abs() / l) / l))
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

/// What is given at an end of a span.
#[derive(Debug, Clone, Copy)]
enum Held {
    /// The slope, counted from the straight line through both ends.
    Slope(f64),
    /// The second derivative.
    Curvature(f64),
}

/// The slope-deflection equations: slope, counted from the straight line through both ends, second and third derivative at
/// both ends of a span of length `l`.
fn solve(l: f64, [a, b]: [Held; 2], fixed: &FixedEnd) -> [[f64; 3]; 2] {
    let [rest_a, rest_b] = fixed.moment;
    let (slope_a, slope_b) = match (a, b) {
        (Held::Slope(left), Held::Slope(right)) => (left, right),
        (Held::Curvature(curvature), Held::Slope(slope)) => (0.25 * l * (rest_a - curvature) - 0.5 * slope, slope),
        (Held::Slope(slope), Held::Curvature(curvature)) => (slope, 0.25 * l * (curvature - rest_b) - 0.5 * slope),
        (Held::Curvature(left), Held::Curvature(right)) => {
            // 4 φ_a + 2 φ_b = ℓ (rest_a − left),  2 φ_a + 4 φ_b = ℓ (right − rest_b).
            let (first, second) = (l * (rest_a - left), l * (right - rest_b));
            ((2.0 * first - second) / 6.0, (2.0 * second - first) / 6.0)
        }
    };
    let curvature_a = match a {
        Held::Slope(_) => rest_a - (4.0 * slope_a + 2.0 * slope_b) / l,
        Held::Curvature(curvature) => curvature,
    };
    let curvature_b = match b {
        Held::Slope(_) => rest_b + (2.0 * slope_a + 4.0 * slope_b) / l,
        Held::Curvature(curvature) => curvature,
    };
    let across = (curvature_b - curvature_a) / l;
    [[slope_a, curvature_a, across - fixed.shear[0]], [slope_b, curvature_b, across + fixed.shear[1]]]
}

/// `G_a`, `G_b` and `∫ g (ℓ − t)/ℓ`, `∫ g t/ℓ`, point loads included; kinks and steps turn the beam but carry no force.
fn fixed_end(given: &PiecewiseScene, a: &End, b: &End, of: Drive) -> FixedEnd {
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
    for breakpoint in given.breakpoints_between(a.cell, b.cell) {
        if breakpoint.force != 0.0 {
            add(breakpoint.x, sign * breakpoint.force);
        }
    }
    if of == Drive::Load {
        return FixedEnd { moment, shear };
    }
    for breakpoint in given.breakpoints_between(a.cell, b.cell) {
        let s = (breakpoint.x - a.x) / l;
        moment[0] += (breakpoint.kink * (6.0 * s - 4.0) - 6.0 * breakpoint.step / l) / l;
        moment[1] += (breakpoint.kink * (2.0 - 6.0 * s) + 6.0 * breakpoint.step / l) / l;
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
