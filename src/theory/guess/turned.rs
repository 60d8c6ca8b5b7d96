//! Couples at samples of a chain, which has one moment in each of its joints.

use super::Samples;
use crate::theory::chain::ChainSample;
use crate::theory::piecewise::PiecewiseScene;

impl Samples {
    /// Adds the couples at samples: each link beside one takes its share as two forces.
    pub(super) fn turn(&self, given: &PiecewiseScene, samples: &mut [ChainSample]) {
        let last = samples.len() - 1;
        for i in 0..=last {
            let couple = self.breakpoint(given, i).map_or(0.0, |at| given.breakpoints[at].couple);
            if couple == 0.0 {
                continue;
            }
            let links = i.saturating_sub(1)..last.min(i + 1);
            #[expect(clippy::cast_precision_loss, reason = "one or two links")]
            let share = couple / links.len() as f64;
            for link in links {
                let force = share / (self.x[link + 1] - self.x[link]);
                samples[link].load += force;
                samples[link + 1].load -= force;
            }
        }
    }
}
