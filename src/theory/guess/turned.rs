//! Couples, springs and the axial force in the chain, which has one moment in each of its joints and the axial force in its links.

use super::Samples;
use crate::theory::chain::ChainSample;
use crate::theory::piecewise::PiecewiseScene;

impl Samples {
    /// Adds `N B u` to the loads: the load of the axial force on a beam that follows the profile.
    pub(super) fn pull(&self, given: &PiecewiseScene, samples: &mut [ChainSample]) {
        if given.tension == 0.0 {
            return;
        }
        let mut add = |i: usize, turn: f64| samples[i].load += given.tension * turn;
        for (i, ends) in self.x.windows(2).enumerate() {
            let last = given.cell_to(ends[1]).max(self.cell[i]);
            let [start, end] = given.rotations_to_chord([ends[0], ends[1]], [self.cell[i], last], !self.far[i]);
            add(i, start);
            add(i + 1, end);
            add(i, self.breakpoint(given, i).map_or(0.0, |at| given.breakpoints[at].kink));
        }
        add(0, given.derivative(0, 0.0, 1));
        add(self.far.len(), -given.derivative(given.cells.len() - 1, given.length, 1));
    }

    /// Adds the couples at samples: each neighbouring link takes an equal part as a pair of forces.
    pub(super) fn turn(&self, given: &PiecewiseScene, samples: &mut [ChainSample]) {
        let last = samples.len() - 1;
        for i in 0..=last {
            let couple = self.breakpoint(given, i).map_or(0.0, |at| given.breakpoints[at].acts.couple());
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

    /// Adds the springs at samples. Rotational springs count only at the ends of the beam: a first guess does not need the others.
    pub(super) fn on_springs(&self, given: &PiecewiseScene, samples: &mut [ChainSample]) {
        let last = samples.len() - 1;
        for (i, sample) in samples.iter_mut().enumerate() {
            let at = self.breakpoint(given, i);
            let [left, right] = at.map_or([0; 2], |at| given.cells_beside(at));
            let slope = |cell: usize| given.derivative(cell, self.x[i], 1);
            if let Some(spring) = at.and_then(|at| given.spring_at(at)) {
                let clearance = given.derivative(right, self.x[i], 0) - spring.level;
                sample.spring = [spring.stiffness, clearance];
            }
            match at.and_then(|at| given.turning_at(at)) {
                Some([k, without]) if i == 0 => {
                    (sample.turning, sample.bend) = (k, sample.sides[1] + (slope(right) - without));
                }
                Some([k, without]) if i == last => {
                    (sample.turning, sample.bend) = (k, sample.sides[0] - (slope(left) - without));
                }
                _ => {}
            }
        }
    }
}
