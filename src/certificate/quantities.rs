//! From a proven pair to other quantities than the deflection: energy, reactions, and the paper's structural stiffness.

use super::kernel::contact_node::EnclosedScene;
use super::kernel::distance::{factor, on_part};
use super::kernel::interval::Interval;
use super::kernel::load::EnclosedLoad;
use super::kernel::polynomial::{Polynomial, number};
use super::kernel::proof::{Pair, Piece};
use super::largest::least_magnitude;
use crate::scene::Load;

/// `J(v) = ½∫EI v''² dx − ∫q v dx − Σ P v` of a deflection, (17) with point loads. Pieces end where the load changes.
pub(super) fn energy(pieces: &[Piece], load: &EnclosedLoad, stiffness: f64) -> Interval {
    let mut sum = Interval::ZERO;
    for Piece { from, to, v, .. } in pieces {
        let width = Interval::exact(*to) - Interval::exact(*from);
        let bent = v.derivative().derivative();
        let bending = bent.integral_of_product(&bent, width).not_negative() * Interval::exact(0.5 * stiffness);
        let done = Polynomial::new(&load.line(*from, [*from, *to])).integral_of_product(v, width)
            + load.point(*from) * v.at(Interval::ZERO);
        sum = sum + bending - done;
    }
    // At the right end no piece begins.
    if let Some(Piece { from, to, v, .. }) = pieces.last() {
        sum = sum - load.point(*to) * v.at(Interval::length(*from, *to));
    }
    sum
}

/// What the forces of the supports lie between, from left to right.
///
/// Where the clearance of `v̂` is larger than the bound on `|v̂ − v*|` the true beam does not touch either. If that is so up
/// to the distance `c` from a support, both moment fields have `M'' = −q` there, so that they differ by a line, and
///
/// ```text
/// ½ ∫₀^c (m + κ x)²/EI dx ≤ gap:     |M'(x) − M*'(x)| = |κ| ≤ √( 24 EI gap / c³ ),     √( 6 EI gap / c³ ) for m = 0
/// ```
///
/// If it is so all the way to a free end, nothing differs on that side, and beside a simple support `m = 0` on the other one.
pub(crate) fn reactions(enclosed: &EnclosedScene<'_>, pair: &Pair) -> Vec<Option<Interval>> {
    let supports = enclosed.supports;
    let bracket = |k: usize, reaction: Interval| {
        let x = supports[k].x;
        let before = k.checked_sub(1).map(|k| supports[k].x);
        let after = supports.get(k + 1).map(|support| support.x);
        let ends = [before.unwrap_or(0.0), after.unwrap_or(enclosed.length)];
        let reached = ends.map(|end| clear_from(enclosed, pair, x, end));
        let clear = reached.map(|reached| Interval::exact(reached) - Interval::exact(x));
        let given =
            [(before, 0), (after, 1)].map(|(next, side)| next.is_none() && (ends[side] - reached[side]).abs() <= 0.0);
        let mut turns = Interval::ZERO;
        for side in [0, 1] {
            let share = if given[1 - side] && supports[k].slope.is_none() { 6 } else { 24 };
            let c = Interval::exact(least_magnitude(clear[side]));
            let turn = number(share) * Interval::exact(enclosed.stiffness) * Interval::exact(pair.gap) / (c * c * c);
            match (given[side], c.lo() <= 0.0) {
                (true, _) => {}
                (false, true) => return None,
                (false, false) => turns = turns + turn.sqrt(),
            }
        }
        Some(reaction + Interval::around_zero(turns.hi()))
    };
    let known = pair.turns_about.is_none();
    pair.reactions.iter().enumerate().map(|(k, reaction)| if known { bracket(k, *reaction) } else { None }).collect()
}

/// How far from a support towards another place the beam is proven to be clear of the ground.
fn clear_from(enclosed: &EnclosedScene<'_>, pair: &Pair, support: f64, end: f64) -> f64 {
    /// Parts of a piece; only how far the proof reaches depends on it.
    const PARTS: u32 = 16;
    let factor = factor(pair.gap, enclosed.stiffness);
    let (from, to) = (support.min(end), support.max(end));
    let mut parts = Vec::new();
    for piece in pair.pieces.iter().filter(|piece| from <= piece.from && piece.to <= to) {
        let mut ends: Vec<f64> =
            (0..=PARTS).map(|k| piece.from + (piece.to - piece.from) * (f64::from(k) / f64::from(PARTS))).collect();
        ends.extend(enclosed.gap.breaks(piece.from, piece.to));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        parts.extend(ends.windows(2).map(|w| (piece, [w[0], w[1]])));
    }
    if end < support {
        parts.reverse();
    }
    let is_clear = |(piece, [a, b]): &(&Piece, [f64; 2])| {
        let v = piece.v.shifted(Interval::exact(*a) - Interval::exact(piece.from));
        let h = enclosed.gap.about(*a, [*a, *b]).minus(&v).range(Interval::exact(*b) - Interval::exact(*a));
        !piece.follows && on_part(pair, factor, [*a, *b]) < h.lo()
    };
    let clear = parts.iter().take_while(|part| is_clear(part)).last();
    clear.map_or(support, |(_, [a, b])| if end < support { *a } else { *b })
}

/// The structural stiffness from bounds on the energy, and the load with its resultant `Q`.
///
/// The paper does not define `D`. A linear structure that its load pushes down by `w`, taken as the mean deflection under
/// the load, has `J* = −½ Q w` and the stiffness `D = Q / w`; hence
///
/// ```text
/// D = Q² / (−2 J*),      Q² / (−2 energy_lower) ≤ D ≤ Q² / (−2 energy_upper)
/// ```
///
/// For a beam that touches, this is the stiffness of the linear structure that takes up the same energy. The
/// complementary energy gives the lower bound and the potential energy the upper one.
#[must_use]
pub fn stiffness([lower, upper]: [f64; 2], load: &Load, length: f64) -> Option<[f64; 2]> {
    if !(lower.is_finite() && upper < 0.0) {
        return None;
    }
    let square = resultant(load, length).square();
    let half = |energy: f64| square / (Interval::exact(-2.0) * Interval::exact(energy));
    Some([half(lower).lo().max(0.0), half(upper).hi()])
}

/// `Q`, in which parts of a load may cancel.
fn resultant(load: &Load, length: f64) -> Interval {
    let exact = Interval::exact;
    let linear =
        load.linear().iter().map(|q| exact(0.5) * (exact(q.start) + exact(q.end)) * (exact(q.to) - exact(q.from)));
    let point = load.point().iter().map(|p| exact(p.force));
    linear.chain(point).fold(exact(load.uniform()) * exact(length), |sum, part| sum + part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::in_intervals;
    use crate::certificate::kernel::hold::{Hold, Place};
    use crate::certificate::kernel::polynomial::Polynomial;
    use crate::scene::{Balance, Beam, Foundation, LinearLoad, Load, PointLoad, Scene};

    const LENGTH: f64 = 20.0;
    const STIFFNESS: f64 = 70.0;
    /// A few dozen roundings.
    const ROUNDING: f64 = 1e-13;

    #[track_caller]
    fn sharp(bound: f64, value: f64) {
        assert!((value * (1.0 - ROUNDING)..=value * (1.0 + ROUNDING)).contains(&bound), "{bound}, not {value}");
    }

    fn piece([from, to]: [f64; 2], coefficients: &[f64]) -> Piece {
        let coefficients: Vec<Interval> = coefficients.iter().map(|c| Interval::exact(*c)).collect();
        Piece { from, to, v: Polynomial::new(&coefficients), follows: false }
    }

    /// `Q = 2·20 + ½ (1 + 4)(7 − 3) − 8 = 42` and `J* = −21`: `D = Q²/(−2 J*) = 42`.
    #[test]
    fn the_stiffness_counts_every_part_of_a_load() {
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
        let linear = vec![LinearLoad { from: 3.0, to: 7.0, start: 1.0, end: 4.0 }];
        let load = Load::new(&beam, 2.0, linear, vec![PointLoad { at: 9.0, force: -8.0 }]).expect("finite");
        stiffness([-21.0, -21.0], &load, LENGTH).expect("it bends").into_iter().for_each(|bound| sharp(bound, 42.0));
    }

    /// Moments `κ x` up to the distance `c` from a support, and not beyond, store `κ² c³/6 EI`.
    #[test]
    fn reactions_are_as_good_as_the_beam_is_known_to_be_clear() {
        /// Chosen so that the proof ends within the beam: `√(2 gap/3 EI l)`.
        const SHARE: f64 = 0.0041;
        let gap = 1.5 * SHARE * SHARE * STIFFNESS * LENGTH;
        let sag = 0.07;
        /// Parts that are clear: until `0.4 − v` is less than the bound.
        const CLEAR: [f64; 2] = [13.0 * 7.0 / 16.0, 8.0 * 13.0 / 16.0];
        let slopes = [piece([0.0, 7.0], &[0.0, sag / 7.0]), piece([7.0, LENGTH], &[sag, -sag / 13.0])];
        let pair = Pair {
            pieces: slopes.to_vec(),
            gap,
            reactions: [3.0, 4.0].map(Interval::exact).to_vec(),
            holds: vec![Hold(Place::at(0.0), Place::at(LENGTH))],
            turns_about: None,
            lifted: 0.0,
            ground: Interval::ZERO,
        };
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
        let load = Load::uniform_on(&beam, 1.0).expect("finite");
        let over = |pair: &Pair, depth: f64| {
            let flat = Some(Foundation::Flat { depth });
            let scene = Scene::new(beam.clone(), load.clone(), flat.filter(|_| depth.is_finite())).expect("well posed");
            in_intervals(&scene, Balance::Held, |enclosed| reactions(enclosed, pair))
        };
        let check = |pair: &Pair, depth: f64, clear: [f64; 2]| {
            for ((bracket, middle), c) in over(pair, depth).iter().zip([3.0, 4.0]).zip(clear) {
                let turn = (6.0 * STIFFNESS * gap / (c * c * c)).sqrt();
                let bracket = bracket.expect("the beam is clear of the ground beside both supports");
                sharp(bracket.hi(), middle + turn);
                sharp(middle - bracket.lo(), turn);
            }
        };
        check(&pair, f64::INFINITY, [LENGTH, LENGTH]);
        // Sixteen parts a piece; in each the least clearance has to be more than SHARE times the largest `x (l − x)`.
        check(&pair, 0.4, CLEAR);

        let mut lying = pair;
        lying.pieces[0].follows = true;
        let [left, right] = over(&lying, 0.4)[..] else { panic!("two supports") };
        assert!(
            left.is_none() && right.is_some(),
            "where the beam lies on the ground beside a support, nothing is known"
        );
    }
}
