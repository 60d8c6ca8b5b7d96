//! What a moment field would have to pull with, and what it costs to cut that off.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::load::cells;
use super::polynomial::{Polynomial, number};

/// Parts into which a cell is cut before what it seems to pull with is taken for true.
const MOST_PARTS: usize = 400;

/// What was cut off.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TensionCutOff {
    /// At least `√(∫ m²/EI dx)` of its moments `m` on the simple beam.
    pub(crate) moments: Interval,
    /// At least the shear force of these moments at any place.
    pub(crate) shear: Interval,
    stiffness: Interval,
    length: Interval,
}

impl TensionCutOff {
    pub(crate) fn new(enclosed: &EnclosedScene<'_>) -> Self {
        let (stiffness, length) = (Interval::exact(enclosed.stiffness), Interval::exact(enclosed.length));
        Self { moments: Interval::ZERO, shear: Interval::ZERO, stiffness, length }
    }

    /// A concentrated force, cut off as far as it may be negative: its moments are a triangle with the height
    /// `f x (l − x)/l`, and `∫ m²/EI dx = (f x (l − x))²/3 EI l`.
    pub(crate) fn force(&mut self, x: f64, force: Interval) {
        if force.lo() < 0.0 {
            let x = Interval::exact(x);
            let lever = x * (self.length - x) / (number(3) * self.stiffness * self.length).sqrt();
            self.moments = self.moments + Interval::exact(-force.lo()) * lever;
            self.shear = self.shear + Interval::exact(-force.lo());
        }
    }

    /// The moment at a support, where foundation and support can only exert one that bends the beam upwards: the limit of a
    /// contact force that grows as it comes nearer to the support. It costs nothing in the limit, since the gap of a force at
    /// the distance `ε` is `M² ε / 6 EI`. What has the other sign is cut off: `m` falls to zero at the other support.
    pub(crate) fn couple(&mut self, moment: Interval) {
        if 0.0 < moment.hi() {
            let most = Interval::exact(moment.hi());
            self.moments = self.moments + most * (self.length / (number(3) * self.stiffness)).sqrt();
            self.shear = self.shear + most / self.length;
        }
    }

    /// A pressure of at least `least`, negative, on a part of the beam.
    fn pressure(&mut self, least: f64, width: Interval) {
        let force = Interval::exact(-least) * width;
        let lever = self.length * self.length / number(4) / (number(3) * self.stiffness * self.length).sqrt();
        self.moments = self.moments + force * lever;
        self.shear = self.shear + force;
    }
}

/// A zone: whether the beam can lie on the foundation all the way between two places, and what pulls there.
pub(crate) fn zone(enclosed: &EnclosedScene<'_>, from: f64, to: f64, cut_off: &mut TensionCutOff) -> Option<()> {
    if !enclosed.foundation.is_smooth_between(from, to) {
        return None;
    }
    for x in enclosed.load.breaks(from, to) {
        cut_off.force(x, enclosed.load.point(x).unwrap_or(Interval::ZERO));
    }
    let mut breaks = enclosed.foundation.breaks(from, to);
    breaks.extend(enclosed.load.breaks(from, to));
    for [from, to] in cells(from, to, breaks) {
        let fourth = enclosed.foundation.cell(from, to).derivative().derivative().derivative().derivative();
        let p = enclosed.load.cell(from, to).minus(&fourth.times(Interval::exact(enclosed.stiffness)));
        pulls(&p, Interval::exact(to) - Interval::exact(from), &mut MOST_PARTS.clone(), cut_off);
    }
    Some(())
}

/// Cuts off what a pressure may pull with for `0 ≤ s ≤ w`.
fn pulls(pressure: &Polynomial, width: Interval, parts: &mut usize, cut_off: &mut TensionCutOff) {
    let range = pressure.range(width);
    if 0.0 <= range.lo() {
        return;
    }
    *parts = parts.saturating_sub(1);
    if *parts == 0 || range.hi() <= 0.0 || -range.lo() <= 4.0 * pressure.uncertainty(width.hi()) {
        cut_off.pressure(range.lo(), width);
        return;
    }
    // Halves of the upper bound of the width: they overlap by rounding and leave nothing out.
    let half = Interval::exact(0.5 * width.hi());
    pulls(pressure, half, parts, cut_off);
    pulls(&pressure.shifted(half), half, parts, cut_off);
}

#[cfg(test)]
mod tests;
