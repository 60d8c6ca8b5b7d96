//! The value of an event from both sides, and its uncertainty.
//!
//! If a force or a clearance grows slowly from zero, the contacts before an event satisfy their conditions to 12 digits for some
//! distance after it, and the contacts after it for some distance before it. Two margins vanish there. The margin that leaves its
//! tolerance sooner is steeper and gives the value. The difference between the two roots is the uncertainty.

use super::events::{At, Root, Search};
use super::last;

/// Distance from an event at which the scene is solved on both sides, as a share of the range: an event known better than this stays
/// as it is.
const KNOWN: f64 = 2e-10;

impl Search<'_> {
    /// The value of a root and its uncertainty.
    pub(super) fn settled(&self, root: &Root) -> (f64, f64) {
        let [start, end] = self.sweep.range;
        let least = KNOWN * (end - start).abs();
        let onward = (end - start).signum();
        let late = self.lasts(&root.before, root.value, onward * least);
        let early = self.lasts(&root.after, root.value, -onward * least);
        let honest = |uncertainty: f64| if uncertainty <= least { 0.0 } else { uncertainty };
        if late <= 0.0 && early <= 0.0 {
            return (root.value, honest(root.off));
        }
        let [first, last] = [root.value - onward * early, root.value + onward * late];
        // Beyond the range in which the contacts satisfy their conditions, a margin is negative.
        let beyond = |from: &At, reach: f64, way: f64| self.crossing(from, root.value + way * (2.0 * reach + least));
        let before = beyond(&root.before, late, onward);
        let after = beyond(&root.after, early, -onward);
        let (value, uncertainty) = match (before, after) {
            (Some(a), Some(b)) if (last - a).abs() <= (first - b).abs() => (a, (a - b).abs()),
            (Some(a), Some(b)) => (b, (a - b).abs()),
            (Some(one), None) | (None, Some(one)) => (one, (last - one).abs().max((first - one).abs())),
            (None, None) => (0.5 * (first + last), 0.5 * (last - first).abs()),
        };
        let inside = value.max(start.min(end)).min(start.max(end));
        (inside, honest(uncertainty.max(root.off)))
    }

    /// The distance beyond `value` over which the contacts of an answer stay valid; 0 if they do not. `step` is the first step tried.
    fn lasts(&self, at: &At, value: f64, step: f64) -> f64 {
        /// Factor from one step to the next: the last step is about a hundredth of the range.
        const LONGER: f64 = 4.0;
        /// Number of steps from [`KNOWN`] on: the last is `4¹²` times as long.
        const STEPS: usize = 13;
        /// Number of halvings: the end is then known to a thousandth of the last step.
        const HALVINGS: u32 = 12;
        let steps = std::iter::successors(Some(step), |step| Some(LONGER * step)).take(STEPS);
        let meets = |step: &f64| self.with_contacts_of(at, value + step).is_some();
        let Some(with) = steps.take_while(meets).last() else { return 0.0 };
        last((with, ()), LONGER * with, HALVINGS, |_, _| false, |step, ()| meets(&step).then_some(())).0.abs()
    }

    /// The value at which the contacts of an answer first violate a condition on the way to `to`, where they violate one.
    fn crossing(&self, from: &At, to: f64) -> Option<f64> {
        let violated = from.exact.violated_conditions(&self.sweep.scene(to).ok()?)?;
        let roots = violated.into_iter().filter_map(|condition| self.root(from, to, condition));
        roots.min_by(|a, b| (a - from.value).abs().total_cmp(&(b - from.value).abs()))
    }
}
