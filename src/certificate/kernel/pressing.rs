//! The tension that a moment field would require from the foundation, and the cost of cutting it off.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::polynomial::{Polynomial, number};
use super::proof::Piece;
use super::reference::{Line, OUTWARDS, near};

/// The tension cut off from the contact load: forces and couples on parts of the beam, all as magnitudes.
#[derive(Debug, Clone, Default)]
pub(crate) struct PullCutOff {
    /// Part, force, couple.
    pub(super) pulls: Vec<([f64; 2], f64, f64)>,
    /// The cost of moments in hinges under an axial tension, which supports the hinge.
    taut: Interval,
}

impl PullCutOff {
    /// Cuts off the negative part of a concentrated force.
    pub(crate) fn force(&mut self, x: f64, force: Interval) {
        if force.lo() < 0.0 {
            self.pulls.push(([x, x], -force.lo(), 0.0));
        }
    }

    /// Cuts off the tension in a pressure on a cell, for `0 ≤ s ≤ w`.
    pub(crate) fn pressure(&mut self, pressure: &Polynomial, cell: [f64; 2], width: Interval) {
        pressure.negative(width, |below, [_, width], end| {
            let is_taken = end.contains(&true);
            self.pulls.extend(is_taken.then(|| (cell, (Interval::exact(below) * width).hi(), 0.0)));
            is_taken
        });
    }

    /// Cuts off a jump of the moment, `M(x+) − M(x−)`, that cannot occur. At a support the foundation on its left or on its right can
    /// cause a jump, if the foundation is level with the support and the beam follows it there. This jump is the limit of a growing
    /// contact force that approaches the support, while the support is in tension. It costs nothing in the limit, since the gap of a
    /// force at the distance `ε` is `M² ε / 6 EI`. A jump caused from the left is positive, one from the right negative. Any other jump
    /// is cut off.
    pub(crate) fn couple(&mut self, x: f64, jump: Interval, [left, right]: [bool; 2]) {
        let not_made = [(left, jump.hi()), (right, -jump.lo())].into_iter().filter(|(made, _)| !made);
        let cut = not_made.fold(0.0, |most: f64, (_, jump)| most.max(jump));
        if 0.0 < cut {
            self.pulls.push(([x, x], 0.0, cut));
        }
    }

    /// Cuts off a moment in a hinge, as a couple on each of the two parts next to it.
    pub(crate) fn hinge(&mut self, enclosed: &EnclosedScene<'_>, x: f64, moment: Interval) {
        if let Some(turn) = enclosed.turn_of_hinge(x) {
            self.taut = self.taut + turn * Interval::exact(moment.magnitude());
        } else if 0.0 < moment.magnitude() {
            let beside = [x.next_down(), x.next_up()];
            self.pulls.extend(beside.map(|x| ([x, x], 0.0, moment.magnitude())));
        }
    }

    /// Bounds the effect of the tension that is cut off, if one of the lines carries each part of it. Returns a bound of at least
    /// `√(∫ m²/EI dx)` for the moments `m` that this causes, and of at least the force at each datum of a line.
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

/// `q − EI g'''' + N g''` about an origin, on a cell where the beam is in contact with the foundation.
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

/// The pieces of a zone, where the beam is in contact with the foundation between two positions, and the tension there; [`None`] if the
/// beam cannot follow the foundation.
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
        // The moment of a beam that follows the foundation does not jump, and the beam does not rotate in a joint there.
        cut_off.couple(x, couple, [false; 2]);
        if enclosed.is_joint(x) && !enclosed.gap.jet(x, true)[2].is_zero() {
            return None;
        }
    }
    let piece = |[from, to]: [f64; 2]| {
        let (cell, width) = ([from, to], Interval::length(from, to));
        // The pressure is expanded from both ends: if it vanishes at an end, its sign is known from that end.
        let [p, other] = [pressure(enclosed, from, cell), pressure(enclosed, to, cell).mirrored()];
        let p = if p.range(width).lo() < other.range(width).lo() { &other } else { &p };
        cut_off.pressure(p, cell, width);
        Piece { from, to, v: enclosed.gap.about(from, cell), pressed: true }
    };
    Some(enclosed.cells(from, to, Vec::new()).into_iter().map(piece).collect())
}

#[cfg(test)]
mod tests;
