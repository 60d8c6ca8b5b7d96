//! A span: the beam between two neighbouring nodes, or between a node and a free end, in closed form.
//!
//! It is computed in the clearance `h = g − v`, not in `v`. At a contact `h` vanishes exactly, and `h'` too where the profile is
//! smooth, so even a tiny gap between two contacts is resolved to its last digits. With `f = g'''' − q`,
//!
//! ```text
//! h'''' = f + Σ (S_k δ''' + J_k δ'' − P_k δ)       steps S, kinks J and point loads P at the breakpoints inside
//! h''(a) = −(4 φ_a + 2 φ_b)/ℓ + G_a,     G_a = ∫ f w_a + Σ (−S w_a''' + J w_a'' − P w_a)
//! h''(b) =  (2 φ_a + 4 φ_b)/ℓ + G_b,     w_a = t (ℓ − t)²/ℓ²,  w_b = t² (ℓ − t)/ℓ²
//! ```
//!
//! with `φ = h' − (h(b) − h(a))/ℓ` at the two ends, `ℓ = b − a`, `t = x − a`. These are the slope-deflection equations with the
//! fixed-end moments `G`. Slopes are measured from the chord, because over a short span they differ from the chord by far less than
//! their size.

use super::cosine;
use super::divided::Answer;
use super::overhang::Overhang;
use super::piecewise::PiecewiseScene;
use super::way::{Prescribed, Way};

/// The condition at an end of a span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum EndCondition {
    /// On a smooth piece of the profile, or clamped to it: `h = h' = 0`.
    Resting,
    /// On a break of the profile: `v` and `v'` are prescribed.
    Edge {
        /// `h`: at the lower side of a step the height of the step.
        height: f64,
        /// `v`.
        level: f64,
        /// `v'` is the sum of these two numbers. The forces of contacts that are close together depend on its digits beyond the last
        /// digit of the first number.
        slope: [f64; 2],
    },
    /// At a support or a break of the profile that leaves the slope free, next to an overhang or at an end of the beam: `v` is
    /// prescribed, and `v''` follows from the overhang.
    Hinge {
        /// `h`.
        height: f64,
        /// `v`.
        level: f64,
        /// `v''`.
        curvature: f64,
    },
    /// A free end of the beam: `v'' = v''' = 0`.
    Free,
    /// Not an end: the span continues, and something changes here.
    Within,
}

impl EndCondition {
    /// `h`.
    pub(super) fn height(self) -> f64 {
        match self {
            Self::Resting | Self::Free | Self::Within => 0.0,
            Self::Edge { height, .. } | Self::Hinge { height, .. } => height,
        }
    }

    /// `v`, where the profile has the depth `depth`.
    pub(super) fn level(self, depth: f64) -> f64 {
        match self {
            Self::Resting | Self::Free | Self::Within => depth,
            Self::Edge { level, .. } | Self::Hinge { level, .. } => level,
        }
    }

    /// Whether the second derivative is prescribed, whatever the slopes are.
    pub(super) fn is_hinged(self) -> bool {
        matches!(self, Self::Hinge { .. } | Self::Free)
    }
}

/// One end of a span: its position, cell and condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    /// Position.
    pub(super) x: f64,
    /// The low-order part of the position at a smooth piece of the profile; not used at an edge, which cannot move.
    pub(super) low: f64,
    /// The cell of the span at this end.
    pub(super) cell: usize,
    /// The end condition.
    pub(super) hold: EndCondition,
}

impl End {
    /// An end without support.
    pub(super) fn free(x: f64, cell: usize) -> Self {
        Self { x, low: 0.0, cell, hold: EndCondition::Free }
    }

    /// An end in contact with a smooth piece of the profile.
    pub(super) fn resting(x: f64, cell: usize) -> Self {
        Self { x, low: 0.0, cell, hold: EndCondition::Resting }
    }

    /// A free end of the beam.
    pub(super) fn free_of(given: &PiecewiseScene, at_left: bool) -> Self {
        let (x, cell) = if at_left { (0.0, 0) } else { (given.length, given.cells.len() - 1) };
        Self::free(x, cell)
    }
}

/// A span, given by the states at its two ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    /// Left end.
    pub(super) a: End,
    /// Right end.
    pub(super) b: End,
    /// `h, h', e h'', e h'''` at the left end.
    pub(super) at_a: [f64; 4],
    /// `h, h', e h'', e h'''` at the right end.
    pub(super) at_b: [f64; 4],
    /// `v, v', e v'', e v'''` at the left end.
    pub(super) beam_a: [f64; 4],
    /// `v, v', e v'', e v'''` at the right end.
    pub(super) beam_b: [f64; 4],
    /// `e` on the span.
    pub(super) stiffness: f64,
    /// For a part of a divided span, the response of the end moments of the whole span to its end slopes; [`None`] for an undivided
    /// span.
    pub(super) answer: Option<Answer>,
}

impl Span {
    /// The span between two ends with constant stiffness between them.
    pub(super) fn between(given: &PiecewiseScene, a: End, b: End) -> Self {
        let (l, way) = (b.x - a.x, Way::of(given, &a, &b));
        let e = given.cells[a.cell].stiffness;
        let of = if way.in_beam { Drive::Load } else { Drive::Clearance };
        let solved = solve([l, l / e], way.held, &fixed_end(given, &a, &b, of));
        let mut at = [[0.0; 4]; 2];
        let mut beam = [[0.0; 4]; 2];
        for i in 0..2 {
            let [slope, curvature, third] = solved[i];
            let profile = &way.profiles[i];
            if way.in_beam {
                beam[i] = [way.levels[i], slope + way.incline, curvature, third];
                at[i] = difference(profile, &beam[i]);
            } else {
                at[i] = [way.heights[i], slope + way.incline, curvature, third];
                beam[i] = difference(profile, &at[i]);
            }
            way.set_known(i, &mut at[i], &mut beam[i]);
        }
        let [at_a, at_b] = at;
        let [beam_a, beam_b] = beam;
        Self { a, b, at_a, at_b, beam_a, beam_b, stiffness: e, answer: None }
    }

    /// The overhang between a free end of the beam and the node `held`; `slope` is the slope of the beam at the node. With the distance
    /// `r` of a load from the node and the length `ℓ` of the overhang,
    ///
    /// ```text
    /// v'' = ∫q r,   |v'''| = ∫q at the node        v grows by ∫q r² (3ℓ − r)/6, v' by ∫q r²/2 towards the free end
    /// ```
    pub(super) fn overhang(given: &PiecewiseScene, held: End, slope: f64, at_left: bool) -> Self {
        let free = End::free_of(given, at_left);
        let length = (held.x - free.x).abs();
        let Overhang { force, moment, turn, sag } = Overhang::of(given, held.x, at_left);
        let e = given.cells[free.cell].stiffness;
        let [turn, sag] = [turn / e, sag / e];
        let profiles = [given.derivatives(held.cell, held.x), given.derivatives(free.cell, free.x)];
        // Sign of the outward direction: to the left or to the right.
        let sign = if at_left { 1.0 } else { -1.0 };
        let level = held.hold.level(profiles[0][0]);
        let beam_held = [level, slope, moment, sign * force];
        // A load exactly at the free end is the shear force next to it, and a couple there is the moment.
        let at_end = if at_left { given.breakpoints.first() } else { given.breakpoints.last() };
        let [shear, couple] = at_end.map_or([0.0; 2], |end| [end.acts.force(), end.acts.couple()]);
        let beam_free = [level - sign * slope * length + sag, slope - sign * turn, sign * couple, sign * shear];
        let mut at_held = difference(&profiles[0], &beam_held);
        at_held[0] = held.hold.height();
        if held.hold == EndCondition::Resting {
            at_held[1] = 0.0;
        }
        let at_free = difference(&profiles[1], &beam_free);
        if at_left {
            Self::of([free, held], [at_free, at_held], [beam_free, beam_held], e)
        } else {
            Self::of([held, free], [at_held, at_free], [beam_held, beam_free], e)
        }
    }

    /// The span with these states of clearance and beam at its ends.
    pub(super) fn of(
        [a, b]: [End; 2],
        [at_a, at_b]: [[f64; 4]; 2],
        [beam_a, beam_b]: [[f64; 4]; 2],
        stiffness: f64,
    ) -> Self {
        Self { a, b, at_a, at_b, beam_a, beam_b, stiffness, answer: None }
    }

    /// The same span with unknown states.
    pub(super) fn unknown(self) -> Self {
        /// Not a number, so that every condition fails.
        const UNKNOWN: [f64; 4] = [f64::NAN; 4];
        Self { at_a: UNKNOWN, at_b: UNKNOWN, beam_a: UNKNOWN, beam_b: UNKNOWN, ..self }
    }

    /// Whether it ends at a free end of the beam.
    pub(super) fn is_overhang(&self) -> bool {
        self.a.hold == EndCondition::Free || self.b.hold == EndCondition::Free
    }

    /// Its length `ℓ`.
    pub(super) fn length(&self) -> f64 {
        self.b.x - self.a.x
    }
}

/// The fourth derivative in use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Drive {
    /// Of `h`: `e u'''' − q`.
    Clearance,
    /// Of `v`: `q`.
    Load,
}

/// The effect of the drive over a span at its ends.
pub(super) struct FixedEnd {
    /// Fixed-end moments `G`.
    pub(super) moment: [f64; 2],
    /// Shear forces of a span that is free to rotate at both ends.
    pub(super) shear: [f64; 2],
    /// Shear forces of a span that is clamped at both ends: `shear` and the difference of the moments over `ℓ`, without cancellation.
    pub(super) clamped: [f64; 2],
}

/// `u − v` or `u − h`, with three derivatives.
pub(super) fn difference(u: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
    [u[0] - v[0], u[1] - v[1], u[2] - v[2], u[3] - v[3]]
}

/// The slope-deflection equations for a span of length `l` with `flex = l/e`. Returns for each end the slope relative to the chord, and
/// the second and third derivatives times `e`.
fn solve([l, flex]: [f64; 2], [a, b]: [Prescribed; 2], fixed: &FixedEnd) -> [[f64; 3]; 2] {
    let [rest_a, rest_b] = fixed.moment;
    let (slope_a, slope_b) = match (a, b) {
        (Prescribed::Slope(left), Prescribed::Slope(right)) => (left, right),
        (Prescribed::Curvature(curvature), Prescribed::Slope(slope)) => {
            (0.25 * flex * (rest_a - curvature) - 0.5 * slope, slope)
        }
        (Prescribed::Slope(slope), Prescribed::Curvature(curvature)) => {
            (slope, 0.25 * flex * (curvature - rest_b) - 0.5 * slope)
        }
        (Prescribed::Curvature(left), Prescribed::Curvature(right)) => {
            // 4 φ_a + 2 φ_b = ℓ (rest_a − left),  2 φ_a + 4 φ_b = ℓ (right − rest_b).
            let (first, second) = (flex * (rest_a - left), flex * (right - rest_b));
            ((2.0 * first - second) / 6.0, (2.0 * second - first) / 6.0)
        }
    };
    let curvature_a = match a {
        Prescribed::Slope(_) => rest_a - (4.0 * slope_a + 2.0 * slope_b) / flex,
        Prescribed::Curvature(curvature) => curvature,
    };
    let curvature_b = match b {
        Prescribed::Slope(_) => rest_b + (2.0 * slope_a + 4.0 * slope_b) / flex,
        Prescribed::Curvature(curvature) => curvature,
    };
    let [third_a, third_b] = if let (Prescribed::Curvature(_), Prescribed::Curvature(_)) = (a, b) {
        let across = (curvature_b - curvature_a) / l;
        [across - fixed.shear[0], across + fixed.shear[1]]
    } else {
        // Not from both moments: for a load very close to one end they would leave the other end with its rounding.
        let turned = 6.0 * (slope_a + slope_b) / (l * flex);
        [turned - fixed.clamped[0], turned + fixed.clamped[1]]
    };
    [[slope_a, curvature_a, third_a], [slope_b, curvature_b, third_b]]
}

/// Fixed-end moments and shear forces of the load over a span.
pub(super) fn fixed_end_of_load(given: &PiecewiseScene, a: &End, b: &End) -> ([f64; 2], [f64; 2]) {
    let FixedEnd { moment, shear, .. } = fixed_end(given, a, b, Drive::Load);
    (moment, shear)
}

/// `G_a`, `G_b` and `∫ f (ℓ − t)/ℓ`, `∫ f t/ℓ`, including point loads; kinks and steps rotate the beam but carry no force.
pub(super) fn fixed_end(given: &PiecewiseScene, a: &End, b: &End, of: Drive) -> FixedEnd {
    let l = b.x - a.x;
    let (mut moment, mut shear, mut clamped) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    // Distances from both ends: over a short span the rounding of their difference would exceed the rounding of a load.
    let mut add = |[from, to]: [f64; 2], force: f64| {
        let (s, r) = (from / l, to / l);
        moment[0] += force * s * r * r * l;
        moment[1] += force * s * s * r * l;
        shear[0] += force * r;
        shear[1] += force * s;
        clamped[0] += force * r * r * (1.0 + 2.0 * s);
        clamped[1] += force * s * s * (1.0 + 2.0 * r);
    };
    let waves = given.shapes[given.cells[a.cell].shape].waves();
    // The waves of a cosine have a closed form.
    let drive = |cell, lo, t| match of {
        Drive::Load => given.load_beyond(cell, lo, t),
        Drive::Clearance => given.drive_without_waves(cell, lo, t),
    };
    let sign = if of == Drive::Load { 1.0 } else { -1.0 };
    for (cell, [lo, hi]) in given.loaded([a.x, b.x], [a.cell, b.cell]) {
        for (t, weight) in given.load_rule.points(0.0, hi - lo) {
            add([(lo - a.x) + t, (b.x - lo) - t], weight * drive(cell, lo, t));
        }
    }
    given.forces_between(a.cell, b.cell).for_each(|j| add([j.x - a.x, b.x - j.x], sign * j.acts.force()));
    for j in given.forces_between(a.cell, b.cell) {
        let (s, r, couple) = ((j.x - a.x) / l, (b.x - j.x) / l, sign * j.acts.couple());
        moment = [moment[0] - couple * r * (r - 2.0 * s), moment[1] - couple * s * (2.0 * r - s)];
        shear = [shear[0] + couple / l, shear[1] - couple / l];
        clamped = [clamped[0] + 6.0 * couple * r * s / l, clamped[1] - 6.0 * couple * r * s / l];
    }
    if of == Drive::Load {
        return FixedEnd { moment, shear, clamped };
    }
    let e = given.cells[a.cell].stiffness;
    let flex = l / e;
    for breakpoint in given.breakpoints_between(a.cell, b.cell) {
        let s = (breakpoint.x - a.x) / l;
        moment[0] += (breakpoint.kink * (6.0 * s - 4.0) - 6.0 * breakpoint.step / l) / flex;
        moment[1] += (breakpoint.kink * (2.0 - 6.0 * s) + 6.0 * breakpoint.step / l) / flex;
        let turned = (breakpoint.kink * (12.0 * s - 6.0) - 12.0 * breakpoint.step / l) / (l * flex);
        clamped = [clamped[0] + turned, clamped[1] - turned];
    }
    for wave in waves.into_iter().flatten() {
        let (g, q) = cosine::fixed_end(e * wave.amplitude, wave.number, wave.angle(0.5 * (a.x + b.x)), l);
        for end in 0..2 {
            moment[end] += g[end];
            shear[end] += q[end];
            clamped[end] += q[end] + (g[end] - g[1 - end]) / l;
        }
    }
    FixedEnd { moment, shear, clamped }
}
