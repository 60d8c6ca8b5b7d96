//! Forward errors: how far a floating-point answer is from the exact one of the same discrete problem.

use palkki::state::{ContactState, Nodes};

use super::clapeyron::{Problem, Solution};
use super::number::Number;

/// Errors, each as a share of the size beside it; NaN if the answer has no numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forward {
    /// Left end reaction, of itself.
    pub reaction: f64,
    /// Worst nodal contact force, of the sum of all loads.
    pub contact_force: f64,
    /// Worst nodal deflection, of the largest one.
    pub deflection: f64,
    /// Worst nodal bending moment, of the largest one.
    pub moment: f64,
    /// Energy, of itself.
    pub energy: f64,
}

impl Forward {
    /// Of `state`, which has nodal values.
    pub fn errors<T: Number>(problem: &Problem<T>, solution: &Solution<T>, state: &ContactState) -> Option<Self> {
        let Nodes { deflection, contact_force, moment, .. } = state.nodes.as_ref()?;
        let load = problem.loads.iter().fold(T::zero(), |sum, q| sum.plus(&q.magnitude()));
        let share = |found: f64, exact: &T| apart(found, exact) / exact.to_double().abs();
        Some(Self {
            reaction: share(state.reactions.left, &solution.left_reaction(&problem.loads[0])),
            contact_force: worst(contact_force, |i| solution.contact_force[i].clone())?[0] / load.to_double(),
            deflection: relative(worst(deflection, |i| solution.deflection(i))?),
            moment: relative(worst(moment, |i| solution.moment(i, &problem.spacing))?),
            energy: share(state.energy, &solution.energy(&problem.loads)),
        })
    }

    /// All of them, with their names.
    pub fn all(&self) -> [(&'static str, f64); 5] {
        [
            ("end reaction", self.reaction),
            ("contact force", self.contact_force),
            ("deflection", self.deflection),
            ("moment", self.moment),
            ("energy", self.energy),
        ]
    }
}

/// `|found − exact|`, the difference taken exactly; NaN if `found` is not finite.
pub fn apart<T: Number>(found: f64, exact: &T) -> f64 {
    if found.is_finite() { T::of(found).minus(exact).magnitude().to_double() } else { f64::NAN }
}

/// The largest difference at the interior nodes 1, 2, …, and the largest magnitude there.
fn worst<T: Number>(found: &[f64], exact: impl Fn(usize) -> T) -> Option<[f64; 2]> {
    let mut worst = [0.0_f64; 2];
    for (i, &found) in (1..).zip(found) {
        let exact = exact(i);
        let [difference, size] = [apart(found, &exact), exact.to_double().abs()];
        if difference.is_nan() {
            return None;
        }
        worst = [worst[0].max(difference), worst[1].max(size)];
    }
    Some(worst)
}

fn relative([difference, size]: [f64; 2]) -> f64 {
    difference / size
}
