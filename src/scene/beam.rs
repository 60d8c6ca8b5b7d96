//! The beam: elastic, with its bending stiffness, its joints, its unloaded shape and its supports.

use std::sync::Arc;

use super::error::{SceneError, positive};
use super::quantity::{Profile, ProfileKey, Quantity};
use super::support::{Support, sorted};
use super::{Foundation, Joint, Scale, pieces};

/// An elastic beam from `x = 0` to `x = l`: straight and on two simple supports at its ends, unless it is said otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    length: f64,
    /// The least one.
    bending_stiffness: f64,
    /// From each place on another one; none if there is one from end to end.
    steps: Vec<[f64; 2]>,
    joints: Vec<Joint>,
    tension: f64,
    supports: Vec<Support>,
    /// Those that only push.
    bearings: Vec<Support>,
    /// Those that give.
    springs: Vec<Support>,
    /// Which of the supports as they were given each of them is, those that hold the beam first, then those that only push.
    given: Vec<usize>,
    shape: Option<Arc<Foundation>>,
}

impl Beam {
    /// A straight beam of length `l` \[length\] and bending stiffness `EI` \[force · length²\] on two simple supports at its
    /// ends, both at level 0: the paper's.
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

    /// The same beam on other supports, in any order; none at all is a beam that merely lies on the ground.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a support that is not on the beam, two (nearly) at one place, or one that is built in at a
    /// corner of the own shape.
    pub fn with_supports(self, supports: Vec<Support>) -> Result<Self, SceneError> {
        let all = sorted(supports, self.length)?;
        let (give, firm): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, support)| support.stiffness.is_some());
        let (push, hold): (Vec<_>, Vec<_>) = firm.into_iter().partition(|(_, support)| support.pushes_only);
        let given = hold.iter().chain(&push).chain(&give).map(|(given, _)| *given).collect();
        let [supports, bearings, springs] =
            [hold, push, give].map(|these| these.into_iter().map(|(_, support)| support).collect());
        Self { supports, bearings, springs, given, ..self }.with_free_joints()?.with_definite_slopes()
    }

    /// The same beam with an own shape `w0(x)`, the depth of its axis as long as nothing acts on it, positive downwards: any of
    /// the kinds that a foundation has.
    ///
    /// # Errors
    ///
    /// Those of [`Foundation::checked`] that are not about supports, a step, or a corner at a built-in support.
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

    /// A built-in support holds one slope, and so does not stand at a corner of the own shape.
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

    /// `EI`, in steps the least one \[force · length²\].
    #[must_use]
    pub fn bending_stiffness(&self) -> f64 {
        self.bending_stiffness
    }

    /// `(x_i, EI_i)`, the bending stiffness from each place on; empty if it is one from end to end \[length, force · length²\].
    #[must_use]
    pub fn steps(&self) -> &[[f64; 2]] {
        &self.steps
    }

    /// Its joints, in the order in which they were given.
    #[must_use]
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// `N`, the axial force, negative for compression \[force\].
    #[must_use]
    pub fn tension(&self) -> f64 {
        self.tension
    }

    /// The same beam under this axial force.
    pub(super) fn tensioned(self, tension: f64) -> Self {
        Self { tension, ..self }
    }

    /// The same beam with this least bending stiffness and these steps.
    pub(super) fn stiff(self, bending_stiffness: f64, steps: Vec<[f64; 2]>) -> Self {
        Self { bending_stiffness, steps, ..self }
    }

    /// The same beam with these joints.
    pub(super) fn joined(self, joints: Vec<Joint>) -> Self {
        Self { joints, ..self }
    }

    /// What holds it at a level, from left to right: without the supports that only push or give.
    #[must_use]
    pub fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// What holds it both ways, at a level or about it.
    pub(crate) fn holding(&self) -> impl Iterator<Item = &Support> {
        self.supports.iter().chain(self.springs.iter().filter(|support| !support.pushes_only))
    }

    /// Whether its supports hold it against moving and turning: two of them, or one that holds the slope.
    #[must_use]
    pub fn is_held(&self) -> bool {
        2 <= self.holding().count() || self.holding().any(|support| support.slope.is_some())
    }

    /// Whether a support at this place carries what stands on it, whatever the beam does.
    pub(crate) fn carries(&self, at: f64) -> bool {
        let here = self.supports.get(self.supports.partition_point(|support| support.at < at));
        self.is_held() && here.is_some_and(|support| support.at <= at)
    }

    /// The supports that only push, from left to right.
    #[must_use]
    pub fn bearings(&self) -> &[Support] {
        &self.bearings
    }

    /// The supports that give against sinking, from left to right; some of them may only push.
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

    /// The same in the order in which they were given, which the indices of a scene file count.
    #[must_use]
    pub fn supports_as_given(&self) -> Vec<Support> {
        let all = self.supports.iter().chain(&self.bearings).chain(&self.springs).copied();
        let mut supports: Vec<(usize, Support)> = self.given.iter().copied().zip(all).collect();
        supports.sort_by_key(|(given, _)| *given);
        supports.into_iter().map(|(_, support)| support).collect()
    }

    /// Its own shape `w0(x)` \[length\]; [`None`] if it is straight.
    #[must_use]
    pub fn shape(&self) -> Option<&Foundation> {
        self.shape.as_deref()
    }

    /// The same, to be kept.
    pub(crate) fn shared_shape(&self) -> Option<Arc<Foundation>> {
        self.shape.clone()
    }

    /// True for the paper's beam: straight, of one bending stiffness, without axial force, on two simple supports at its ends, both at level 0.
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

    /// The same beam in other units, all powers of two; `stiffness` is that of `EI`.
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

    /// A bound on the deflection that supports and own shape prescribe: `max |level|`, `max |w0|`, `|slope| l` \[length\].
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
