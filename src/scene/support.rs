//! Supports, and the conditions that they impose on the deflection.
//!
//! ```text
//! axis of the beam        w0 + v                      initial shape and deflection, both positive downwards
//! simple support at x_s   w0 + v = level              d_s = level − w0(x_s)
//! built in, in addition   w0' + v' = slope            φ_s = slope − w0'(x_s)
//! foundation              w0 + v ≤ u                  g = u − w0
//! compression-only, x_s   w0 + v ≤ level              g(x_s) = level − w0(x_s)
//! ```
//!
//! A rigid compression-only support is a [`Bearing`]: one more position at which the beam may touch. It acts like a single point
//! of the foundation.
//!
//! An elastic support carries a force or a moment in proportion to its settlement or rotation:
//!
//! ```text
//! spring, at x_s          R = k_s (w0 + v − level)        of either sign; a compression-only one has R ≥ 0 and lets the beam lift off
//! rotational spring       M jumps by −k_t (w0' + v' − slope)
//! ```
//!
//! Methods, beam theory and certificate therefore need `g`, `d_s` and `φ_s`, and neither `u` nor `w0`.

use super::error::{SceneError, finite, on_beam, positive};
use super::pieces;
use super::quantity::Quantity;
use super::{Beam, Foundation, Scene};

/// A support. It restrains the axis of the beam against vertical displacement, and against rotation if `slope` is given. A
/// compression-only support restrains only downward displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Position `x_s` \[length\].
    pub at: f64,
    /// The level at which it holds the axis, positive downwards \[length\].
    pub level: f64,
    /// The slope `w0' + v'` at which it holds the axis, positive if the axis goes down to the right; [`None`] for a simple
    /// support, which leaves the slope free.
    pub slope: Option<f64>,
    /// True for a compression-only support, without hold-down and possibly with initial clearance. It does not restrain rotation.
    pub pushes_only: bool,
    /// Stiffness against settlement from its level, `k_s` \[force / length\]; [`None`] for a rigid support.
    pub stiffness: Option<f64>,
    /// Stiffness against rotation from its slope, `k_t` \[force · length\]; [`None`] for a built-in support and for one that
    /// leaves the slope free.
    pub turning_stiffness: Option<f64>,
}

impl Support {
    /// A simple support at level 0.
    #[must_use]
    pub fn simple(at: f64) -> Self {
        Self { at, level: 0.0, slope: None, pushes_only: false, stiffness: None, turning_stiffness: None }
    }

    /// A compression-only support at level 0.
    #[must_use]
    pub fn pushing(at: f64) -> Self {
        Self { pushes_only: true, ..Self::simple(at) }
    }

    /// A built-in support with a horizontal axis at level 0.
    #[must_use]
    pub fn built_in(at: f64) -> Self {
        Self { slope: Some(0.0), ..Self::simple(at) }
    }

    /// An elastic support of stiffness `k_s` that is free of force at level 0 \[force / length\].
    #[must_use]
    pub fn spring(at: f64, stiffness: f64) -> Self {
        Self { stiffness: Some(stiffness), ..Self::simple(at) }
    }

    /// The same support with a rotational spring of stiffness `k_t` that is free of moment at this slope \[force · length\].
    #[must_use]
    pub fn turning(self, turning_stiffness: f64, slope: f64) -> Self {
        Self { slope: Some(slope), turning_stiffness: Some(turning_stiffness), ..self }
    }

    /// True for a built-in support, which prescribes the slope rigidly.
    #[must_use]
    pub fn is_built_in(&self) -> bool {
        self.slope.is_some() && self.turning_stiffness.is_none()
    }

    /// The same support at another level \[length\].
    #[must_use]
    pub fn at_level(self, level: f64) -> Self {
        Self { level, ..self }
    }
}

/// A rigid bilateral support in the form that all methods use: the deflection `v` that it prescribes, measured from the initial
/// shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// Position `x_s` \[length\].
    pub at: f64,
    /// `v(x_s) = d_s = level − w0(x_s)` \[length\].
    pub deflection: f64,
    /// `v'(x_s) = φ_s = slope − w0'(x_s)` where the beam is built in.
    pub slope: Option<f64>,
    /// `k_t` and `φ_s` of a rotational spring \[force · length, –\].
    pub turning: Option<[f64; 2]>,
    /// True to the left and to the right if the foundation on that side begins at the level of the support, within the rounding
    /// of its depth.
    pub at_level: [bool; 2],
    /// True where in addition the foundation begins in the direction of a built-in beam, so that the beam can follow it; for
    /// other supports equal to `at_level`.
    pub tangent: [bool; 2],
}

/// An elastic support in the form that all methods use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Position `x_s` \[length\].
    pub at: f64,
    /// `k_s` in `R = k_s (v − d_s)` \[force / length\].
    pub stiffness: f64,
    /// `d_s = level − w0(x_s)` \[length\].
    pub deflection: f64,
    /// `k_t` and `φ_s = slope − w0'(x_s)` of an additional rotational spring \[force · length, –\].
    pub turning: Option<[f64; 2]>,
    /// True if the beam may lift off.
    pub pushes_only: bool,
}

/// A rigid compression-only support in the form that all methods use: `v(x_s) ≤ d_s`, as for a foundation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// Position `x_s` \[length\].
    pub at: f64,
    /// `g(x_s) = d_s = level − w0(x_s)`, the gap above it while the beam is unloaded \[length\].
    pub gap: f64,
}

/// The smallest distance between two supports, relative to the length of the beam. Positions are known to half a unit in the last
/// place. The slope that two supports prescribe is the difference of their levels divided by their distance. It is then known to
/// at least six digits, as many as a certified deflection has unless more are requested.
pub(super) const LEAST_DISTANCE: f64 = f64::EPSILON / 1e-6;

/// `supports` from left to right, checked for a beam of this length. Each has its index in the given list, which errors also use.
pub(super) fn sorted(mut supports: Vec<Support>, length: f64) -> Result<Vec<(usize, Support)>, SceneError> {
    for (i, support) in supports.iter_mut().enumerate() {
        on_beam(Quantity::SupportAt(i), support.at, length)?;
        finite(Quantity::SupportLevel(i), support.level)?;
        finite(Quantity::SupportSlope(i), support.slope.unwrap_or(0.0))?;
        if support.pushes_only && support.slope.is_some() {
            return Err(SceneError::PushesBuiltIn { quantity: Quantity::SupportAt(i), at: support.at });
        }
        let springs = [
            support.stiffness.map(|k| positive(Quantity::SupportStiffness(i), k)),
            support.turning_stiffness.map(|k| positive(Quantity::SupportTurningStiffness(i), k)),
        ];
        for spring in springs.into_iter().flatten() {
            spring?;
        }
        if support.stiffness.is_some() && support.is_built_in() {
            return Err(SceneError::GivesBuiltIn { quantity: Quantity::SupportAt(i), at: support.at });
        }
        if support.turning_stiffness.is_some() {
            support.slope.get_or_insert(0.0);
        }
    }
    let mut sorted: Vec<(usize, Support)> = supports.into_iter().enumerate().collect();
    sorted.sort_by(|(_, a), (_, b)| a.at.total_cmp(&b.at));
    let least = LEAST_DISTANCE * length;
    if let Some(pair) = sorted.windows(2).find(|pair| pair[1].1.at - pair[0].1.at <= least) {
        // The support that comes later in the file is reported.
        let mut both = [pair[0], pair[1]];
        both.sort_by_key(|(i, _)| *i);
        let [(_, first), (i, second)] = both;
        let quantity = Quantity::SupportAt(i);
        return Err(SceneError::SupportsTooClose { quantity, value: second.at, other: first.at, least });
    }
    Ok(sorted)
}

impl Foundation {
    /// Checks the conditions of a rigid foundation at the supports of `beam`. It must not be above a support, nor at the level of
    /// a compression-only one. It must not rise above the beam next to a built-in support, nor on both sides of a simple one.
    pub(super) fn check_at_supports(&self, beam: &Beam) -> Result<(), SceneError> {
        let length = beam.length();
        for support in beam.supports().iter().chain(beam.bearings()) {
            let &Support { at, level, slope, pushes_only, .. } = support;
            let depth = self.depth(at);
            let within = self.level_within(at, length);
            if pushes_only {
                if depth <= level + within {
                    return Err(SceneError::BearingInGround { at, depth, level });
                }
                continue;
            }
            if depth < level - within {
                return Err(SceneError::AboveSupport { at, depth, level });
            }
            let inside = 0.0 < at && at < length;
            let (sides, own) = (self.sides(at), beam.shape().map_or([[0.0; 2]; 2], |own| own.sides(at)));
            let Some(held) = slope.filter(|_| support.is_built_in()) else {
                let slopes = [0, 1].map(|side| sides[side][1] - own[side][1]);
                let own_size = beam.shape().map_or(0.0, |own| own.slope_size(at));
                let rounding = pieces::LEVEL * (self.slope_size(at) + own_size);
                if inside && sides.iter().all(|[depth, _]| *depth <= level + within) && slopes[1] < slopes[0] - rounding
                {
                    return Err(SceneError::ValleyAtSupport { at, slopes });
                }
                continue;
            };
            for (side, name, inside) in [(0, "left", 0.0 < at), (1, "right", at < length)] {
                let [depth, slope] = sides[side];
                let rise = if side == 0 { slope - held } else { held - slope };
                let rounding = pieces::LEVEL * (self.slope_size(at) + held.abs());
                if inside && depth <= level + within && rounding < rise {
                    return Err(SceneError::RisesAtBuiltIn { at, side: name, slope, held });
                }
            }
        }
        Ok(())
    }
}

impl Scene {
    /// The deflections and slopes that the rigid bilateral supports prescribe, from left to right.
    #[must_use]
    pub fn held(&self) -> Vec<Held> {
        self.beam().supports().iter().map(|support| self.held_by(support)).collect()
    }

    /// The elastic supports, from left to right.
    pub fn springs(&self) -> impl Iterator<Item = Spring> + '_ {
        self.beam().springs().iter().map(|support| {
            let &Support { at, pushes_only, stiffness, .. } = support;
            let Held { deflection, turning, .. } = self.held_by(support);
            Spring { at, stiffness: stiffness.unwrap_or(0.0), deflection, turning, pushes_only }
        })
    }

    /// The elastic compression-only supports.
    pub(crate) fn stops(&self) -> impl Iterator<Item = Spring> + '_ {
        self.springs().filter(|spring| spring.pushes_only)
    }

    /// The rigid compression-only supports at which the beam may touch, from left to right.
    pub(crate) fn bearings(&self) -> impl Iterator<Item = Bearing> + '_ {
        let own = |at: f64| self.beam().shape().map_or(0.0, |shape| shape.depth(at));
        self.beam()
            .bearings()
            .iter()
            .map(move |support| Bearing { at: support.at, gap: support.level - own(support.at) })
    }

    /// Whether a support is inside an elastic foundation, below its surface.
    pub(crate) fn stands_in_ground(&self, support: &Support) -> bool {
        self.depth(support.at) < support.level && self.is_grounded_beside(support.at) != [false; 2]
    }

    fn held_by(&self, support: &Support) -> Held {
        let &Support { at, level, .. } = support;
        let slope = support.slope.filter(|_| support.is_built_in());
        let [own, turn] =
            self.beam().shape().map_or([0.0; 2], |shape| shape.sides(at)[usize::from(at < self.beam().length())]);
        let [at_level, tangent] = self.foundation().map_or([[false; 2]; 2], |foundation| {
            let within = foundation.level_within(at, self.beam().length());
            // At an end of the beam with a step the smaller depth governs, and the foundation is on one side only.
            let [first, last] = [at <= 0.0, self.beam().length() <= at];
            let [left, right] = match first || last {
                true => [foundation.depth(at); 2],
                false => foundation.sides(at).map(|[depth, _]| depth),
            };
            let along = foundation.sides(at).map(|[_, ground]| {
                let rounding = pieces::LEVEL * (foundation.slope_size(at) + slope.unwrap_or(0.0).abs());
                slope.is_none_or(|slope| (ground - slope).abs() <= rounding)
            });
            // An elastic foundation may be above the support.
            let at_level = [!first && (left - level).abs() <= within, !last && (right - level).abs() <= within];
            [at_level, [at_level[0] && along[0], at_level[1] && along[1]]]
        });
        let turning = support.turning_stiffness.zip(support.slope).map(|(k, slope)| [k, slope - turn]);
        Held { at, deflection: level - own, slope: slope.map(|slope| slope - turn), turning, at_level, tangent }
    }
}
