//! Couples at samples of a chain, which has one moment in each of its joints, and the axial force in its links.

use super::Samples;
use crate::theory::chain::ChainSample;
use crate::theory::piecewise::PiecewiseScene;

impl Samples {
    /// Adds `N B u` to the loads: by so much the axial force would press a beam that follows the profile.
    pub(super) fn pull(&self, given: &PiecewiseScene, samples: &mut [ChainSample]) {
        if given.tension == 0.0 {
            return;
        }
        let mut add = |i: usize, turn: f64| samples[i].load += given.tension * turn;
        for (i, ends) in self.x.windows(2).enumerate() {
            let last = given.cell_to(ends[1]).max(self.cell[i]);
            let [start, end] = given.turns([ends[0], ends[1]], [self.cell[i], last], !self.far[i]);
            add(i, start);
            add(i + 1, end);
            add(i, self.breakpoint(given, i).map_or(0.0, |at| given.breakpoints[at].kink));
        }
        add(0, given.derivative(0, 0.0, 1));
        add(self.far.len(), -given.derivative(given.cells.len() - 1, given.length, 1));
    }

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
