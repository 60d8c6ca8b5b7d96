//! Resultant and moments of loads in fractions.

use dashu_ratio::RBig;
use palkki::scene::Load;

use super::number::Number;

/// A 64-bit number, exactly; [`None`] if it is not finite.
#[must_use]
pub fn exactly(value: f64) -> Option<RBig> {
    RBig::try_from(value).ok()
}

/// `∫q` and `∫q (x − c)` about `c = about`, on a beam from 0 to `length`.
#[must_use]
pub fn resultant_and_moment(load: &Load, length: f64, about: f64) -> Option<[RBig; 2]> {
    let c = exactly(about)?;
    let half = RBig::fraction(1, 2);
    let (uniform, l) = (exactly(load.uniform())?, exactly(length)?);
    let mut force = &uniform * &l;
    let mut moment = &force * (&l * &half - &c);
    for part in load.linear() {
        let [from, to, start, end] = [part.from, part.to, part.start, part.end].map(exactly);
        let (from, to, start, end) = (from?, to?, start?, end?);
        let width = to - &from;
        // A rectangle as high as the start, and the triangle that is left.
        let (rectangle, triangle) = (&start * &width, (end - &start) * &width * &half);
        moment += &rectangle * (&from + &width * &half - &c) + &triangle * (from + width * RBig::fraction(2, 3) - &c);
        force += rectangle + triangle;
    }
    for part in load.point() {
        let (at, point) = (exactly(part.at)?, exactly(part.force)?);
        moment += &point * (at - &c);
        force += point;
    }
    Some([force, moment])
}
