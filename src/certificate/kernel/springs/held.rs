//! The contributions of joints and elastic supports to the gap, and what holds a beam on an elastic foundation.

use super::groups::uncertainty;
use super::{Carrier, OnSprings, Sums};
use crate::certificate::kernel::contact_node::EnclosedSupport;
use crate::certificate::kernel::giving;
use crate::certificate::kernel::interval::Interval;
use crate::certificate::kernel::lines::lines;
use crate::certificate::kernel::polynomial::number;
use crate::certificate::kernel::reference::{Datum, Line};

impl OnSprings<'_> {
    /// Adds the joints at the right ends of pressed stretches. The joints of parts that hang are included in their spans.
    pub(super) fn turn(&self, moments: &[[Interval; 2]], sums: &mut Sums) {
        for (node, moment) in moments.iter().enumerate().filter(|(node, _)| self.is_pressed(*node, true)) {
            let Some(k) = self.enclosed.joint(self.x(node)).filter(|k| 0.0 < *k).map(Interval::exact) else { continue };
            let gap = [true, false].map(|left| self.enclosed.gap.jet(self.x(node), left)[1]);
            let slopes = [true, false].map(|left| self.sunk(node, left).map_or(Interval::WHOLE, |w| w[1]));
            let broken = if self.enclosed.gap.is_smooth_at(self.x(node)) { Interval::ZERO } else { gap[1] - gap[0] };
            let kink = slopes[1] - slopes[0] + broken;
            sums.square = sums.square + (k * kink + moment[0]).square() / k;
            sums.turned = sums.turned + k * kink.square();
        }
    }

    /// Adds elastic supports, by the forces and the moment jumps of the pair at each of them, and elastic supports that are treated as
    /// loads.
    pub(super) fn give(&self, moments: &[[Interval; 2]], shears: &[[Interval; 2]], sums: &mut Sums) -> Option<()> {
        let [gap, energy] = giving::of_loads(self.enclosed, &sums.pieces);
        (sums.square, sums.turned) = (sums.square + number(2) * gap, sums.turned + number(2) * energy);
        for (node, ([left, right], shear)) in moments.iter().zip(shears).enumerate() {
            let (x, load) = (self.x(node), self.enclosed.load);
            let Some(support) = self.enclosed.support(x) else { continue };
            let Some(gives) = support.gives else { continue };
            let (state, jump) = (self.end(node)?, *right - *left - load.couple(x));
            let mut force = shear[1] - shear[0] + load.point(x);
            if support.pushes() {
                sums.cut_off.force(x, force);
                force = force.positive_part();
            }
            sums.forces.push((x, force));
            sums.square = sums.square + number(2) * gives.misfit([force, jump], state);
            sums.turned = sums.turned + number(2) * gives.energy(state);
        }
        Some(())
    }

    /// The supports as data.
    pub(super) fn supports(&self, sums: &Sums) -> Vec<Datum> {
        let force = |x: f64| sums.forces.iter().find(|force| force.0.total_cmp(&x).is_eq());
        let of = |support: &EnclosedSupport| {
            self.enclosed.datum(support, force(support.x).map_or(Interval::ZERO, |force| force.1))
        };
        self.enclosed.supports.iter().map(of).filter(|datum| 0.0 < datum.presses).collect()
    }

    /// The gap; an upper bound of the force that one position carries of what is cut off; and what holds the beam, supports or pressed
    /// parts.
    pub(super) fn held(&self, sums: &Sums) -> Option<(f64, Interval, Vec<Line>)> {
        let far = self.held_by(sums, self.far_apart(sums))?;
        if sums.cut_off.pulls.is_empty() {
            return Some(far);
        }
        // Pressed parts next to the tension carry it with less bending.
        let near = self.neighbours(sums, far.0).and_then(|lines| self.held_by(sums, lines));
        Some(near.filter(|near| near.0 < far.0).unwrap_or(far))
    }

    /// Lines through supports, or through the two pressed parts that hold the beam best.
    fn far_apart(&self, sums: &Sums) -> Vec<Line> {
        let pressing = sums.carriers.iter().map(|c| c.place).filter(|place| 0.0 < place.presses);
        let mut places: Vec<Datum> = pressing.chain(self.supports(sums)).collect();
        let fixed = self.enclosed.supports.iter().filter(|s| s.slope.is_some()).map(|s| s.x);
        lines(self.enclosed, fixed, &mut places)
    }

    /// The same as [`OnSprings::held`], for given lines that carry what is cut off.
    ///
    /// A tension of the share `s` changes `√∫(Δp)²/k` by `s c` at a part with the cost `c`. All of them together, each on one line,
    /// change it by at most the sum of their shares on the line with the largest cost.
    fn held_by(&self, sums: &Sums, lines: Vec<Line>) -> Option<(f64, Interval, Vec<Line>)> {
        let enclosed = self.enclosed;
        let [moment, share] = sums.cut_off.carried(&lines, enclosed.stiffness, enclosed.soft());
        let same = |a: f64, b: f64| a.total_cmp(&b).is_eq();
        let carrier = |at: &Datum| {
            let first = sums.carriers.partition_point(|c| c.place.from < at.from);
            let here = sums.carriers[first..].iter().take_while(|c| same(c.place.from, at.from));
            here.filter(|_| at.presses.is_finite()).find(|c| same(c.place.to, at.to))
        };
        let cost = |place: &Datum| carrier(place).map_or(Interval::ZERO, |carrier| carrier.cost);
        let costs = lines.iter().map(|Line(a, b)| (cost(a) + cost(b)).hi());
        let changed = share * Interval::exact(costs.fold(0.0, f64::max));
        let gap = (sums.square.sqrt() + moment + sums.pull.sqrt() + changed).square() / number(2);
        let steady = Interval::exact(enclosed.steadiness());
        (0.0 < steady.lo()).then_some(())?;
        let gap = if steady == number(1) { gap.hi() } else { (gap / steady.square()).hi() };
        if lines.is_empty() && 0.0 < enclosed.tension {
            // A beam in tension is held by one position, like a string.
            return Some((gap, share, lines));
        }
        let known = |place: &Datum| {
            let Some(Carrier { sunk, stiffness, .. }) = carrier(place) else {
                // A compression-only support that is pressed acts as a spring.
                let is_pressed = gap < place.energy && share.hi() < place.presses;
                return (place.presses.is_infinite() || is_pressed).then_some(*place);
            };
            let off = uncertainty(gap, *stiffness);
            (off < *sunk && share.hi() < place.presses).then_some(Datum { uncertainty: off, ..*place })
        };
        let lines = lines.iter().map(|Line(left, right)| Some(Line(known(left)?, known(right)?)));
        let lines = lines.collect::<Option<Vec<_>>>().filter(|lines| !lines.is_empty())?;
        Some((gap, share, lines))
    }
}
