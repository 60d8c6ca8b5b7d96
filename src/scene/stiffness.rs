//! How stiff a beam is along its length: bending stiffness in steps, and joints in which it turns.
//!
//! ```text
//! EI(x) = EI_i           from x_i on                      M = −EI v'' is continuous, v'' is not
//! M = −k_j [v']          at a joint of stiffness k_j      a hinge has k_j = 0: M = 0
//! ```

use super::error::{SceneError, on_beam, positive};
use super::quantity::Quantity;
use super::support::LEAST_DISTANCE;
use super::{Beam, Load, Support};

/// A place where the beam turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Where \[length\].
    pub at: f64,
    /// How stiff it is against turning, `k_j = −M/[v']`; [`None`] for a hinge \[force · length\].
    pub stiffness: Option<f64>,
}

/// A place that is not where it could be.
fn misplaced<T>(quantity: Quantity, value: f64, expected: &'static str) -> Result<T, SceneError> {
    Err(SceneError::Misplaced { quantity, value, expected })
}

/// Steps begin at 0, go forwards and begin before the end of the beam.
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
    /// A couple at a joint acts on one side of it or on the other, and which is not said.
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
    /// The same beam with another bending stiffness from each place on: `(x_i, EI_i)` \[length, force · length²\].
    ///
    /// # Errors
    ///
    /// No steps, steps that do not begin at 0, that go back or begin at the end of the beam, and a stiffness that is not positive.
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
    /// A joint at an end of the beam or beyond, at another one, or where the beam is built in, and a stiffness that is not positive.
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

    /// A support that holds the slope holds one, and so does not stand at a joint.
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

    /// Whether one of its joints is a hinge.
    pub(super) fn is_hinged(&self) -> bool {
        self.joints().iter().any(|joint| joint.stiffness.is_none())
    }

    /// `EI` between two places with no step between them \[force · length²\].
    pub(crate) fn stiffness_between(&self, from: f64, to: f64) -> f64 {
        let middle = 0.5 * (from + to);
        let next = self.steps().partition_point(|step| step[0] <= middle);
        next.checked_sub(1).map_or(self.bending_stiffness(), |i| self.steps()[i][1])
    }

    /// Whether hinges leave it free to move without bending, whatever these supports hold.
    pub(super) fn is_mechanism<'a>(&self, supports: impl Iterator<Item = &'a Support>) -> bool {
        0 < self.free_motions(supports)
    }

    /// In how many ways it may move without bending, whatever these supports hold: of the lines that it can be, with a corner in each
    /// hinge, those that are zero at all supports and have no slope where it is built in.
    pub(crate) fn free_motions<'a>(&self, supports: impl Iterator<Item = &'a Support>) -> usize {
        /// A pivot that is less is zero but for rounding: places over the length of the beam are known to some units in the last place.
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

    /// Where the bending stiffness changes, from left to right \[length\].
    pub(crate) fn changes(&self) -> impl Iterator<Item = f64> + '_ {
        self.steps().windows(2).filter(|two| two[0][1].total_cmp(&two[1][1]).is_ne()).map(|two| two[1][0])
    }
}
