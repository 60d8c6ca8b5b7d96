//! The exact beam between two places, in fractions: `EI v'''' = q`, with point loads and couples on the way: `M = −EI v''` jumps by a
//! couple.

use dashu_ratio::RBig;

use super::given::Given;
use super::polynomial::{Polynomial, derivative, exactly, jet};

/// `v` on the parts of a span, each about its left end.
pub(super) type Curve = Vec<([f64; 2], Polynomial)>;

/// `l` of a part.
pub(super) fn width([from, to]: [f64; 2]) -> RBig {
    exactly(to) - exactly(from)
}

/// `v''` at both ends of a span.
pub(super) fn bends(curve: &Curve) -> [RBig; 2] {
    let bend = |v: &Polynomial, s: RBig| jet(&derivative(v), &s)[1].clone();
    let ((_, first), (ends, last)) = (&curve[0], &curve[curve.len() - 1]);
    [bend(first, RBig::ZERO), bend(last, width(*ends))]
}

impl Given {
    /// The beam from `v, v', v'', v'''` at a place to another one, and what these are there.
    fn march(&self, [from, to]: [f64; 2], mut start: [RBig; 4]) -> (Curve, [RBig; 4]) {
        let mut curve = Curve::new();
        for ends in self.parts([from, to], true) {
            let [v, slope, bend, third] = start;
            let loaded = self.load(ends).into_iter().zip([24, 120]);
            let loaded = loaded.map(|(q, below)| q / (&self.stiffness * RBig::from(below)));
            let v: Polynomial =
                [v, slope, bend / RBig::from(2), third / RBig::from(6)].into_iter().chain(loaded).collect();
            let l = width(ends);
            let ([a, b], [c, d]) = (jet(&v, &l), jet(&derivative(&derivative(&v)), &l));
            let [force, couple] = if ends[1] < to { self.acting(ends[1]) } else { [RBig::ZERO, RBig::ZERO] };
            start = [a, b, c - couple / &self.stiffness, d + force / &self.stiffness];
            curve.push((ends, v));
        }
        (curve, start)
    }

    /// The beam between two places from `v` and `v'` at both of them, or at the one that is no free end.
    pub(super) fn span(&self, [from, to]: [f64; 2], ends: [Option<[RBig; 2]>; 2]) -> Curve {
        let (zero, two, six, twelve) = (|| RBig::ZERO, RBig::from(2), RBig::from(6), RBig::from(12));
        let l = width([from, to]);
        let tip = |x: f64| self.acting(x).map(|acts| acts / &self.stiffness);
        let start = match ends {
            [Some([v, slope]), right] => {
                let (_, [e, f, g, h]) = self.march([from, to], [v.clone(), slope.clone(), zero(), zero()]);
                let (bend, third) = if let Some([w, end]) = right {
                    let (rise, turn) = (w - e, end - f);
                    let bend = (&six * &rise / &l - &two * &turn) / &l;
                    (bend, (&six * &l * &turn - &twelve * &rise) / (&l * &l * &l))
                } else {
                    let [force, couple] = tip(to);
                    let third = zero() - h - force;
                    (couple - g - &third * &l, third)
                };
                [v, slope, bend, third]
            }
            [None, right] => {
                let [w, end] = right.unwrap_or([RBig::ZERO, RBig::ZERO]);
                let [force, couple] = tip(from);
                let bend = zero() - couple;
                let (_, [e, f, ..]) = self.march([from, to], [zero(), zero(), bend.clone(), force.clone()]);
                let slope = end - f;
                [w - e - &slope * &l, slope, bend, force]
            }
        };
        self.march([from, to], start).0
    }
}
