//! Sums of all loads and of their moments in twice the precision, with bounds for the rounding of the input.

use std::cmp::Ordering;

use crate::double::Double;
use crate::scene::{Concentrated, Scene};

/// A sum in twice the precision, with a bound on the error that the rounding of the input may cause.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sum {
    sum: Double,
    within: f64,
}

impl Sum {
    const NOTHING: Self = Self { sum: Double::ZERO, within: 0.0 };

    /// Half a unit in the last place, relative. The error of the sums themselves is of the order of its square.
    const ROUNDING: f64 = 0.5 * f64::EPSILON;

    /// `W = ∫q`.
    pub(super) fn of_forces(scene: &Scene) -> Self {
        let (mut sum, load, length) = (Self::NOTHING, scene.load(), scene.beam().length());
        let (uniform, l) = (Double::exact(load.uniform()), Double::exact(length));
        sum.add(uniform * l, 2.0 * (uniform * l).rounded().abs());
        for q in load.linear() {
            let (mean, width) =
                (Double::exact(q.start) + Double::exact(q.end), Double::exact(q.to) - Double::exact(q.from));
            let size = 0.5 * (q.start.abs() + q.end.abs());
            sum.add(mean * width * Double::exact(0.5), size * (width.rounded() + q.to + q.from));
        }
        for Concentrated { at: _, force, couple: _ } in load.concentrated() {
            sum.add(Double::exact(force), force.abs());
        }
        sum
    }

    /// `∫q (x − c)` with all couples. Six times this value is a sum of products.
    pub(super) fn of_moments(scene: &Scene, about: f64) -> Self {
        let (mut sum, load, length) = (Self::NOTHING, scene.load(), scene.beam().length());
        let (uniform, l, c) = (load.uniform(), Double::exact(length), Double::exact(about));
        let lever = l - c - c;
        let size = 3.0 * uniform.abs() * length;
        sum.add(
            Double::exact(3.0) * Double::exact(uniform) * l * lever,
            size * (2.0 * lever.rounded().abs() + length + about),
        );
        for q in load.linear() {
            let (start, end) = (Double::exact(q.start), Double::exact(q.end));
            let (width, lever) = (Double::exact(q.to) - Double::exact(q.from), Double::exact(q.from) - c);
            let (places, size) = (q.to + q.from + about, q.start.abs() + q.end.abs());
            sum.add(
                Double::exact(3.0) * (start + end) * width * lever + (start + end + end) * width * width,
                6.0 * size * width.rounded() * (places + width.rounded()),
            );
        }
        for Concentrated { at, force, couple } in load.concentrated() {
            let lever = Double::exact(at) - c;
            // A load at the reference position has no lever arm, whatever its last digit.
            let known = if lever.rounded() == 0.0 { 0.0 } else { lever.rounded().abs() + at + about };
            let moment = Double::exact(force) * lever + Double::exact(couple);
            sum.add(Double::exact(6.0) * moment, 6.0 * (force.abs() * known + couple.abs()));
        }
        Self { sum: sum.sum * Double::exact(1.0 / 6.0), within: sum.within / 6.0 }
    }

    /// Adds a term. `size` is the magnitude of the numbers that are known only to half a unit in the last place.
    fn add(&mut self, term: Double, size: f64) {
        self.sum = self.sum + term;
        self.within += Self::ROUNDING * size;
    }

    pub(super) fn negated(self) -> Self {
        Self { sum: Double::ZERO - self.sum, ..self }
    }

    pub(super) fn value(self) -> f64 {
        self.sum.rounded()
    }

    /// The sign; `Equal` if the sum cannot be distinguished from zero.
    pub(super) fn sign(self) -> Ordering {
        match self.value() {
            value if value.abs() <= self.within => Ordering::Equal,
            value => value.total_cmp(&0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, LinearLoad, Load};

    /// Moving both ends of a load by one unit in the last place causes twice the error that rounding allows.
    #[test]
    fn the_ends_of_a_load_are_known_but_for_rounding() {
        let beam = Beam::new(10.0, 1.0).expect("positive");
        let forces = |from: f64, to: f64| {
            let part = LinearLoad { from, to, start: 1.0, end: 1.0 };
            let load = Load::new(&beam, 0.0, vec![part], Vec::new()).expect("finite");
            Sum::of_forces(&Scene::new(beam.clone(), load, None).expect("finite"))
        };
        let (given, moved) = (forces(9.5, 9.75), forces(9.5_f64.next_down(), 9.75_f64.next_up()));
        let moves = (moved.sum - given.sum).rounded();
        assert!(0.0 < moves && moves <= 2.0 * given.within && given.within < 2.0 * moves, "{moves} within {given:?}");
    }
}
