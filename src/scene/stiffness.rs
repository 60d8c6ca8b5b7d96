//! The stiffness of a beam along its length: bending stiffness in steps, and joints.
//!
//! ```text
//! EI(x) = EI_i           from x_i on                      M = −EI v'' is continuous, v'' is not
//! M = −k_j [v']          at a joint of stiffness k_j      a hinge has k_j = 0: M = 0
//! ```

use super::error::{SceneError, on_beam, positive};
use super::quantity::Quantity;
use super::support::LEAST_DISTANCE;
use super::{Beam, Load, Support};

/// A joint: a position at which the slope of the beam may jump.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Position \[length\].
    pub at: f64,
    /// Rotational stiffness `k_j = −M/[v']` \[force · length\]; [`None`] for a hinge.
    pub stiffness: Option<f64>,
}

/// The error for a position that is not allowed.
fn misplaced<T>(quantity: Quantity, value: f64, expected: &'static str) -> Result<T, SceneError> {
    Err(SceneError::Misplaced { quantity, value, expected })
}

/// Checks that the steps begin at 0, are in ascending order and begin before the end of the beam.
pub(super) fn check_places(
    steps: &[[f64; 2]],
    length: f64,
    of: Quantity,
    place: fn(usize) -> Quantity,
) -> Result<(), SceneError> {
    if steps.is_empty() {
        return Err(SceneError::NoSteps { of });
    }
    let mut before = None;
    for (i, [at, _]) in steps.iter().copied().enumerate() {
        let quantity = place(i);
        on_beam(quantity, at, length)?;
        match before {
            None if at != 0.0 => return misplaced(quantity, at, "be 0, where the beam begins"),
            Some(before) if at <= before => {
                return misplaced(quantity, at, "be greater than the place of the step before it");
            }
            _ if length <= at => return misplaced(quantity, at, "be less than the length of the beam"),
            _ => before = Some(at),
        }
    }
    Ok(())
}

impl Load {
    /// Returns an error for a couple at a joint: it would be unclear on which side of the joint the couple acts.
    pub(super) fn check_at_joints(&self, beam: &Beam) -> Result<(), SceneError> {
        let least = LEAST_DISTANCE * beam.length();
        for (i, couple) in self.couple().iter().enumerate() {
            if beam.joints().iter().any(|joint| (joint.at - couple.at).abs() <= least) {
                return Err(SceneError::CoupleAtJoint { quantity: Quantity::CoupleAt(i), value: couple.at });
            }
        }
        Ok(())
    }
}

impl Beam {
    /// The same beam with a bending stiffness that varies in steps, `(x_i, EI_i)` \[length, force · length²\].
    ///
    /// # Errors
    ///
    /// No steps, a first step that does not begin at 0, steps that are not in ascending order or begin at the end of the beam,
    /// and a stiffness that is not positive.
    pub fn with_steps(self, steps: Vec<[f64; 2]>) -> Result<Self, SceneError> {
        check_places(&steps, self.length(), Quantity::BendingStiffness, Quantity::StepAt)?;
        for (i, &[_, value]) in steps.iter().enumerate() {
            if !(0.0 < value && value.is_finite()) {
                return Err(SceneError::StepNotPositive { quantity: Quantity::StepStiffness(i), value });
            }
        }
        let least = steps.iter().fold(f64::INFINITY, |least, step| least.min(step[1]));
        Ok(self.stiff(least, steps))
    }

    /// The same beam with joints, in any order.
    ///
    /// # Errors
    ///
    /// A joint at an end of the beam or beyond it, at another joint, or at a support that restrains rotation, and a stiffness
    /// that is not positive.
    pub fn with_joints(self, joints: Vec<Joint>) -> Result<Self, SceneError> {
        let least = LEAST_DISTANCE * self.length();
        for (i, joint) in joints.iter().enumerate() {
            let (quantity, value) = (Quantity::JointAt(i), joint.at);
            on_beam(quantity, value, self.length())?;
            if value <= least || self.length() - value <= least {
                return misplaced(quantity, value, "lie inside the beam, and not at an end of it");
            }
            if let Some(stiffness) = joint.stiffness {
                positive(Quantity::JointStiffness(i), stiffness)?;
            }
            if let Some(other) = joints[..i].iter().find(|other| (other.at - value).abs() <= least) {
                return Err(SceneError::JointsTooClose { quantity, value, other: other.at });
            }
        }
        Ok(self.joined(joints)).and_then(Self::with_free_joints)
    }

    /// Returns an error if a joint is at a support that restrains rotation: the slope is not unique there.
    pub(super) fn with_free_joints(self) -> Result<Self, SceneError> {
        let least = LEAST_DISTANCE * self.length();
        for (i, joint) in self.joints().iter().enumerate() {
            let stands = |at: f64| (at - joint.at).abs() <= least;
            if self.holding().any(|support| support.slope.is_some() && stands(support.at)) {
                return Err(SceneError::JointAtBuiltIn { quantity: Quantity::JointAt(i), value: joint.at });
            }
        }
        Ok(self)
    }

    /// Whether one of the joints is a hinge.
    pub(super) fn is_hinged(&self) -> bool {
        self.joints().iter().any(|joint| joint.stiffness.is_none())
    }

    /// `EI` between two positions with no step between them \[force · length²\].
    pub(crate) fn stiffness_between(&self, from: f64, to: f64) -> f64 {
        let middle = 0.5 * (from + to);
        let next = self.steps().partition_point(|step| step[0] <= middle);
        next.checked_sub(1).map_or(self.bending_stiffness(), |i| self.steps()[i][1])
    }

    /// Whether hinges leave the beam free to move without bending on these supports, all taken as bilateral.
    pub(super) fn is_mechanism<'a>(&self, supports: impl Iterator<Item = &'a Support>) -> bool {
        0 < self.free_motions(supports)
    }

    /// The number of independent motions without bending on these supports, all taken as bilateral. Such a motion is a polyline
    /// with corners at hinges that is zero at all supports and has no slope where rotation is restrained.
    pub(crate) fn free_motions<'a>(&self, supports: impl Iterator<Item = &'a Support>) -> usize {
        /// A smaller pivot counts as zero: positions divided by the length of the beam are known to some units in the last place.
        const ROUNDING: f64 = 1e-12;
        let hinges: Vec<f64> =
            self.joints().iter().filter(|j| j.stiffness.is_none()).map(|j| j.at / self.length()).collect();
        let line = |x: f64, turned: bool| {
            let corner = |hinge: &f64| {
                if x < *hinge {
                    0.0
                } else if turned {
                    1.0
                } else {
                    x - hinge
                }
            };
            let first = if turned { [0.0, 1.0] } else { [1.0, x] };
            first.into_iter().chain(hinges.iter().map(corner)).collect::<Vec<f64>>()
        };
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for support in supports {
            let x = support.at / self.length();
            rows.push(line(x, false));
            rows.extend(support.slope.map(|_| line(x, true)));
        }
        let (unknowns, mut held) = (hinges.len() + 2, 0);
        for column in 0..unknowns {
            let pivot = (held..rows.len()).max_by(|i, j| rows[*i][column].abs().total_cmp(&rows[*j][column].abs()));
            let Some(pivot) = pivot.filter(|i| ROUNDING < rows[*i][column].abs()) else { continue };
            rows.swap(held, pivot);
            let (done, others) = rows.split_at_mut(held + 1);
            for row in others {
                let factor = row[column] / done[held][column];
                row.iter_mut().zip(&done[held]).for_each(|(value, above)| *value -= factor * above);
            }
            held += 1;
        }
        unknowns - held
    }

    /// The positions at which the bending stiffness changes, from left to right \[length\].
    pub(crate) fn changes(&self) -> impl Iterator<Item = f64> + '_ {
        self.steps().windows(2).filter(|two| two[0][1].total_cmp(&two[1][1]).is_ne()).map(|two| two[1][0])
    }
}
