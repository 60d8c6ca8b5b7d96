//! The elastic beam: bending stiffness, joints, axial force, initial shape and supports.

use std::sync::Arc;

use super::error::{SceneError, positive};
use super::quantity::{Profile, ProfileKey, Quantity};
use super::support::{Support, sorted};
use super::{Foundation, Joint, Scale, pieces};

/// An elastic beam from `x = 0` to `x = l`. By default it is straight and has two simple supports at its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    length: f64,
    /// The smallest bending stiffness along the beam.
    bending_stiffness: f64,
    /// Positions and the bending stiffness that begins at each; empty if the stiffness is uniform.
    steps: Vec<[f64; 2]>,
    joints: Vec<Joint>,
    tension: f64,
    supports: Vec<Support>,
    /// Rigid compression-only supports.
    bearings: Vec<Support>,
    /// Elastic supports.
    springs: Vec<Support>,
    /// For each support its index in the list as given: first `supports`, then `bearings`, then `springs`.
    given: Vec<usize>,
    shape: Option<Arc<Foundation>>,
}

impl Beam {
    /// The paper's beam: straight, of length `l` \[length\] and bending stiffness `EI` \[force · length²\], on two simple
    /// supports at its ends, both at level 0.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotPositive`] unless both are positive and finite.
    pub fn new(length: f64, bending_stiffness: f64) -> Result<Self, SceneError> {
        let length = positive(Quantity::Length, length)?;
        let bending_stiffness = positive(Quantity::BendingStiffness, bending_stiffness)?;
        let supports = vec![Support::simple(0.0), Support::simple(length)];
        let (steps, joints, bearings, springs) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (tension, given) = (0.0, vec![0, 1]);
        Ok(Self { length, bending_stiffness, steps, joints, tension, supports, bearings, springs, given, shape: None })
    }

    /// The same beam on other supports, given in any order. Without supports the beam only rests on the foundation.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a support outside the beam, two supports at (nearly) the same position, or a support that
    /// prescribes the slope at a joint or at a corner of the initial shape.
    pub fn with_supports(self, supports: Vec<Support>) -> Result<Self, SceneError> {
        let all = sorted(supports, self.length)?;
        let (give, firm): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, support)| support.stiffness.is_some());
        let (push, hold): (Vec<_>, Vec<_>) = firm.into_iter().partition(|(_, support)| support.pushes_only);
        let given = hold.iter().chain(&push).chain(&give).map(|(given, _)| *given).collect();
        let [supports, bearings, springs] =
            [hold, push, give].map(|these| these.into_iter().map(|(_, support)| support).collect());
        Self { supports, bearings, springs, given, ..self }.with_free_joints()?.with_definite_slopes()
    }

    /// The same beam with an initial shape `w0(x)`: the depth of the axis of the unloaded beam, positive downwards. Every kind of
    /// profile that a foundation can have is allowed.
    ///
    /// # Errors
    ///
    /// Those of [`Foundation::checked`] that do not concern supports, a step, or a corner at a built-in support.
    pub fn with_shape(self, shape: Foundation) -> Result<Self, SceneError> {
        shape.check(Profile::Shape, self.length)?;
        if let Foundation::Polyline { points } = &shape {
            #[expect(clippy::float_cmp, reason = "a step is two points at exactly the same place")]
            if let Some(i) = (1..points.len()).find(|&i| points[i][0] == points[i - 1][0]) {
                let quantity = Quantity::Profile(Profile::Shape, ProfileKey::PolylineX(i));
                return Err(SceneError::StepInShape { quantity, value: points[i][0] });
            }
        }
        for at in [0.0, self.length] {
            if shape.depth(at).is_nan() {
                return Err(shape.overflow_of(Profile::Shape, at));
            }
        }
        Self { shape: Some(Arc::new(shape)), ..self }.with_definite_slopes()
    }

    /// Returns an error if a support prescribes the slope at a corner of the initial shape, where the slope is not unique.
    fn with_definite_slopes(self) -> Result<Self, SceneError> {
        if let Some(shape) = &self.shape {
            let inside = |s: &&Support| s.slope.is_some() && 0.0 < s.at && s.at < self.length;
            for support in self.supports.iter().chain(&self.springs).filter(inside) {
                let [[_, left], [_, right]] = shape.sides(support.at);
                if pieces::LEVEL * shape.slope_size(support.at) < (right - left).abs() {
                    return Err(SceneError::CornerAtBuiltIn { at: support.at });
                }
            }
        }
        Ok(self)
    }

    /// `l` \[length\].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// `EI` \[force · length²\]; the smallest value if it varies in steps.
    #[must_use]
    pub fn bending_stiffness(&self) -> f64 {
        self.bending_stiffness
    }

    /// `(x_i, EI_i)`, positions and the bending stiffness that begins at each \[length, force · length²\]; empty if it is
    /// uniform.
    #[must_use]
    pub fn steps(&self) -> &[[f64; 2]] {
        &self.steps
    }

    /// The joints, in the order in which they were given.
    #[must_use]
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// The axial force `N`, negative for compression \[force\].
    #[must_use]
    pub fn tension(&self) -> f64 {
        self.tension
    }

    /// The same beam under this axial force.
    pub(super) fn tensioned(self, tension: f64) -> Self {
        Self { tension, ..self }
    }

    /// The same beam with this smallest bending stiffness and these steps.
    pub(super) fn stiff(self, bending_stiffness: f64, steps: Vec<[f64; 2]>) -> Self {
        Self { bending_stiffness, steps, ..self }
    }

    /// The same beam with these joints.
    pub(super) fn joined(self, joints: Vec<Joint>) -> Self {
        Self { joints, ..self }
    }

    /// The rigid bilateral supports from left to right, without compression-only and elastic supports.
    #[must_use]
    pub fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// The bilateral supports, rigid and elastic.
    pub(crate) fn holding(&self) -> impl Iterator<Item = &Support> {
        self.supports.iter().chain(self.springs.iter().filter(|support| !support.pushes_only))
    }

    /// Whether the supports prevent rigid-body motion: at least two bilateral supports, or one that restrains rotation.
    #[must_use]
    pub fn is_held(&self) -> bool {
        2 <= self.holding().count() || self.holding().any(|support| support.slope.is_some())
    }

    /// Whether a rigid support at this position carries the loads directly above it in every state of the beam.
    pub(crate) fn carries(&self, at: f64) -> bool {
        let here = self.supports.get(self.supports.partition_point(|support| support.at < at));
        self.is_held() && here.is_some_and(|support| support.at <= at)
    }

    /// The rigid compression-only supports from left to right.
    #[must_use]
    pub fn bearings(&self) -> &[Support] {
        &self.bearings
    }

    /// The elastic supports from left to right; some of them may be compression-only.
    #[must_use]
    pub fn springs(&self) -> &[Support] {
        &self.springs
    }

    /// All supports from left to right.
    #[must_use]
    pub fn all_supports(&self) -> Vec<Support> {
        let mut all = [self.supports(), self.bearings(), self.springs()].concat();
        all.sort_by(|a, b| a.at.total_cmp(&b.at));
        all
    }

    /// All supports in the order in which they were given. The indices in a scene file refer to this order.
    #[must_use]
    pub fn supports_as_given(&self) -> Vec<Support> {
        let all = self.supports.iter().chain(&self.bearings).chain(&self.springs).copied();
        let mut supports: Vec<(usize, Support)> = self.given.iter().copied().zip(all).collect();
        supports.sort_by_key(|(given, _)| *given);
        supports.into_iter().map(|(_, support)| support).collect()
    }

    /// The initial shape `w0(x)` \[length\]; [`None`] if the beam is straight.
    #[must_use]
    pub fn shape(&self) -> Option<&Foundation> {
        self.shape.as_deref()
    }

    /// The initial shape as a shared pointer.
    pub(crate) fn shared_shape(&self) -> Option<Arc<Foundation>> {
        self.shape.clone()
    }

    /// True for the paper's beam: straight, of uniform bending stiffness, without joints and axial force, on two simple supports
    /// at its ends, both at level 0.
    #[must_use]
    pub fn is_simple(&self) -> bool {
        self.shape.is_none()
            && self.changes().next().is_none()
            && self.joints.is_empty()
            && self.tension == 0.0
            && self.bearings.is_empty()
            && self.springs.is_empty()
            && self.supports == [Support::simple(0.0), Support::simple(self.length)]
    }

    /// The same beam in other units, all powers of two; `stiffness` is the unit of `EI`.
    pub(super) fn scaled(&self, scale: &Scale, stiffness: f64) -> Result<Self, SceneError> {
        let &Scale { length, depth, .. } = scale;
        let support = |s: &Support| Support {
            at: pieces::place(s.at / length),
            level: s.level / depth,
            slope: s.slope.map(|slope| slope * (length / depth)),
            // Its unit is `F/U = E/L³`.
            stiffness: s.stiffness.map(|k| k * length / stiffness * length * length),
            turning_stiffness: s.turning_stiffness.map(|k| k / stiffness * length),
            ..*s
        };
        let steps = self.steps.iter().map(|&[at, value]| [pieces::place(at / length), value / stiffness]).collect();
        let joint = |joint: &Joint| Joint {
            at: joint.at / length,
            stiffness: joint.stiffness.map(|value| value / stiffness * length),
        };
        let beam = Self::new(self.length / length, self.bending_stiffness / stiffness)?
            .with_supports(self.supports_as_given().iter().map(support).collect())?
            .stiff(self.bending_stiffness / stiffness, steps)
            .joined(self.joints.iter().map(joint).collect())
            .tensioned(self.tension * length / stiffness * length);
        match &self.shape {
            Some(shape) => beam.with_shape(shape.scaled(length, depth)),
            None => Ok(beam),
        }
    }

    /// A bound on the deflection that supports and initial shape prescribe: `max |level|`, `max |w0|`, `|slope| l` \[length\].
    pub(super) fn given_deflection(&self) -> f64 {
        let levels = self
            .supports
            .iter()
            .chain(&self.bearings)
            .chain(&self.springs)
            .map(|s| s.level.abs().max(s.slope.map_or(0.0, |slope| slope.abs() * self.length)));
        levels.fold(self.shape.as_ref().map_or(0.0, |shape| shape.magnitude(self.length)), f64::max)
    }
}
