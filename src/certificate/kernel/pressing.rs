//! What a moment field would have to pull with, and what it costs to cut that off.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::polynomial::{Polynomial, number};
use super::proof::Piece;
use super::reference::{Line, OUTWARDS, near};

/// What was cut off of the contact load: forces and couples on parts of the beam, all as magnitudes.
#[derive(Debug, Clone, Default)]
pub(crate) struct PullCutOff {
    /// Part, force, couple.
    pub(super) pulls: Vec<([f64; 2], f64, f64)>,
    /// What moments in hinges cost under tension, which holds what they join.
    taut: Interval,
}

impl PullCutOff {
    /// A concentrated force, cut off as far as it may be negative.
    pub(crate) fn force(&mut self, x: f64, force: Interval) {
        if force.lo() < 0.0 {
            self.pulls.push(([x, x], -force.lo(), 0.0));
        }
    }

    /// What a pressure on a cell may pull with for `0 ≤ s ≤ w`.
    pub(crate) fn pressure(&mut self, pressure: &Polynomial, cell: [f64; 2], width: Interval) {
        pressure.negative(width, |below, [_, width], end| {
            let is_taken = end.contains(&true);
            self.pulls.extend(is_taken.then(|| (cell, (Interval::exact(below) * width).hi(), 0.0)));
            is_taken
        });
    }

    /// A jump of the moment, `M(x+) − M(x−)`. At a support the ground beside it, on its left and on its right, can make one, if
    /// it is level with the support and the beam follows it there: the limit of a contact force that grows as it comes nearer to
    /// the support, which pulls. It costs nothing in the limit, since the gap of a force at the distance `ε` is `M² ε / 6 EI`.
    /// From the left it is positive, from the right negative. Any other is cut off.
    pub(crate) fn couple(&mut self, x: f64, jump: Interval, [left, right]: [bool; 2]) {
        let not_made = [(left, jump.hi()), (right, -jump.lo())].into_iter().filter(|(made, _)| !made);
        let cut = not_made.fold(0.0, |most: f64, (_, jump)| most.max(jump));
        if 0.0 < cut {
            self.pulls.push(([x, x], 0.0, cut));
        }
    }

    /// A moment in a hinge: beside it, a couple on each of both parts that it joins.
    pub(crate) fn hinge(&mut self, enclosed: &EnclosedScene<'_>, x: f64, moment: Interval) {
        if let Some(turn) = enclosed.turn_of_hinge(x) {
            self.taut = self.taut + turn * Interval::exact(moment.magnitude());
        } else if 0.0 < moment.magnitude() {
            let beside = [x.next_down(), x.next_up()];
            self.pulls.extend(beside.map(|x| ([x, x], 0.0, moment.magnitude())));
        }
    }

    /// What is cut off is carried by one of the lines each: at least `√(∫ m²/EI dx)` of the moments `m` that this takes, and at
    /// least the force at any datum of a line.
    ///
    /// ```text
    /// √(∫ m²/EI dx) ≤ Σ f √c(x, x) + Σ C √((L + 3 a)/3 EI)
    /// ```
    pub(crate) fn carried(&self, lines: &[Line], stiffness: f64, soft: f64) -> [Interval; 2] {
        let root = (number(3) * Interval::exact(stiffness)).sqrt();
        let mut sums = [self.taut, Interval::ZERO];
        for &(part, force, couple) in &self.pulls {
            let takes = |of: f64, lever: f64| if 0.0 < of { of * lever } else { 0.0 };
            let bent =
                |line: &Line| takes(force, line.lever(part, soft)) + takes(couple, line.lever_of_couple(part, soft));
            let best = near(lines, part).iter().map(|l| (bent(l) * OUTWARDS, l)).min_by(|a, b| a.0.total_cmp(&b.0));
            let [lever, share] = best.map_or([f64::INFINITY; 2], |(m, line)| [m, line.share(part, force, couple)]);
            sums = [sums[0] + Interval::exact(lever) / root, sums[1] + Interval::exact(share)];
        }
        sums
    }
}

/// `q − EI g'''' + N g''` of a cell on which the beam lies on the ground, about an origin.
pub(crate) fn pressure(enclosed: &EnclosedScene<'_>, origin: f64, cell: [f64; 2]) -> Polynomial {
    let fourth = enclosed.gap.about(origin, cell).derivative().derivative().derivative().derivative();
    let stiffness = Interval::exact(enclosed.stiffness_between(cell));
    let pressure = Polynomial::new(&enclosed.load.line(origin, cell)).minus(&fourth.times(stiffness));
    if enclosed.tension == 0.0 {
        return pressure;
    }
    let bent = enclosed.gap.about(origin, cell).derivative().derivative();
    pressure.plus(&bent.times(Interval::exact(enclosed.tension)))
}

/// A zone, as pieces: the beam on the foundation all the way between two places, if it can lie there; and what pulls.
pub(crate) fn zone(enclosed: &EnclosedScene<'_>, ends: [f64; 2], cut_off: &mut PullCutOff) -> Option<Vec<Piece>> {
    let [from, to] = ends;
    enclosed.gap.is_smooth_between(from, to).then_some(())?;
    for x in enclosed.breaks(from, to) {
        let (mut force, mut couple) = (enclosed.load.point(x), enclosed.load.couple(x));
        if enclosed.changes.contains(&x) {
            let [before, behind] = [true, false].map(|left| {
                let (jet, stiffness) = (enclosed.gap.jet(x, left), enclosed.stiffness_beside(x, left));
                [stiffness * jet[2], stiffness * jet[3]]
            });
            (couple, force) = (couple + (before[0] - behind[0]), force + (before[1] - behind[1]));
        }
        cut_off.force(x, force);
        // The moment of a beam that follows the ground does not jump, nor does that turn in a joint.
        cut_off.couple(x, couple, [false; 2]);
        if enclosed.is_joint(x) && !enclosed.gap.jet(x, true)[2].is_zero() {
            return None;
        }
    }
    let piece = |[from, to]: [f64; 2]| {
        let (cell, width) = ([from, to], Interval::length(from, to));
        // From either end: a pressure that vanishes at one of them is known from there.
        let [p, other] = [pressure(enclosed, from, cell), pressure(enclosed, to, cell).mirrored()];
        let p = if p.range(width).lo() < other.range(width).lo() { &other } else { &p };
        cut_off.pressure(p, cell, width);
        Piece { from, to, v: enclosed.gap.about(from, cell), pressed: true }
    };
    Some(enclosed.cells(from, to, Vec::new()).into_iter().map(piece).collect())
}

#[cfg(test)]
mod tests;
