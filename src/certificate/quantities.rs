//! From a proven pair to other quantities than the deflection: energy, reactions, and the paper's structural stiffness.

use super::kernel::contact_node::EnclosedScene;
use super::kernel::distance::factor;
use super::kernel::interval::Interval;
use super::kernel::load::EnclosedLoad;
use super::kernel::polynomial::number;
use super::kernel::proof::{Pair, Piece};
use crate::scene::Load;

/// `J(v) = ½∫EI v''² dx − ∫q v dx − Σ P v` of a deflection, (17) with point loads. Pieces end where the load changes.
pub(super) fn energy(pieces: &[Piece], load: &EnclosedLoad, stiffness: f64) -> Interval {
    let mut sum = Interval::ZERO;
    for Piece { from, to, v, .. } in pieces {
        let width = Interval::exact(*to) - Interval::exact(*from);
        let bending = v.derivative().derivative().integral_of_square(width) * Interval::exact(0.5 * stiffness);
        sum = sum + bending - load.cell(*from, *to).integral_of_product(v, width);
        if let Some(force) = load.point(*from).filter(|_| 0.0 < *from) {
            sum = sum - force * v.at(Interval::ZERO);
        }
    }
    sum
}

/// What the two reactions lie between.
///
/// Where the clearance of `v̂` is larger than the bound on `|v̂ − v*|` the true beam does not touch either. If that is so up
/// to the distance `c` from a support, both moment fields have `M'' = −q` there, so that they differ by `κ x`, and
///
/// ```text
/// ½ ∫₀^c (κ x)²/EI dx ≤ gap:     |M'(0) − M*'(0)| = |κ| ≤ √( 6 EI gap / c³ )
/// ```
pub(crate) fn reactions(enclosed: &EnclosedScene<'_>, pair: &Pair) -> [Option<Interval>; 2] {
    let gap = pair.gap.hi();
    let share = factor(gap, enclosed.stiffness, enclosed.length).hi();
    [true, false].map(|left| {
        let clear = clear_from(enclosed, &pair.pieces, share, left);
        if clear <= 0.0 {
            return None;
        }
        let c = Interval::exact(clear);
        let turn = (number(6) * Interval::exact(enclosed.stiffness) * Interval::exact(gap) / (c * c * c)).sqrt();
        Some(pair.reactions[usize::from(!left)] + Interval::around_zero(turn.hi()))
    })
}

/// How far from a support the clearance is proven to be larger than `share · x (l − x)`.
fn clear_from(enclosed: &EnclosedScene<'_>, pieces: &[Piece], share: f64, left: bool) -> f64 {
    /// Parts of a piece; only how far the proof reaches depends on it.
    const PARTS: u32 = 16;
    let &EnclosedScene { foundation, length, .. } = enclosed;
    let mut reached = 0.0;
    let mut pieces: Vec<_> = pieces.iter().collect();
    if !left {
        pieces.reverse();
    }
    for piece in pieces {
        if piece.follows {
            return reached;
        }
        let mut ends: Vec<f64> =
            (0..=PARTS).map(|k| piece.from + (piece.to - piece.from) * (f64::from(k) / f64::from(PARTS))).collect();
        ends.extend(foundation.breaks(piece.from, piece.to));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mut parts: Vec<[f64; 2]> = ends.windows(2).map(|w| [w[0], w[1]]).collect();
        if !left {
            parts.reverse();
        }
        for [a, b] in parts {
            let v = piece.v.shifted(Interval::exact(a) - Interval::exact(piece.from));
            let h = foundation.cell(a, b).minus(&v).range(Interval::exact(b) - Interval::exact(a));
            let far = if left { b } else { length - a };
            if h.lo() <= (Interval::exact(share) * Interval::exact(far) * Interval::exact(length)).hi() {
                return reached;
            }
            reached = if left { b } else { (Interval::exact(length) - Interval::exact(a)).lo() };
        }
    }
    reached
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
    use crate::certificate::kernel::foundation::EnclosedFoundation;
    use crate::certificate::kernel::polynomial::Polynomial;
    use crate::scene::{Beam, Foundation, Load, Scene};

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

    /// Moments `κ x` up to the distance `c` from a support, and not beyond, store `κ² c³/6 EI`.
    #[test]
    fn reactions_are_as_good_as_the_beam_is_known_to_be_clear() {
        /// Chosen so that the proof ends within the beam: `√(2 gap/3 EI l)`.
        const SHARE: f64 = 0.0041;
        let gap = 1.5 * SHARE * SHARE * STIFFNESS * LENGTH;
        let sag = 0.07;
        let slopes = [piece([0.0, 7.0], &[0.0, sag / 7.0]), piece([7.0, LENGTH], &[sag, -sag / 13.0])];
        let pair = Pair {
            pieces: slopes.to_vec(),
            gap: Interval::exact(gap),
            reactions: [3.0, 4.0].map(Interval::exact),
            lifted: 0.0,
        };
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
        let load = Load::uniform_on(&beam, 1.0).expect("finite");
        let pieces = EnclosedLoad::of(&Scene::new(beam, load, None).expect("well posed"));
        let over = |pair: &Pair, depth: f64| {
            let flat = Foundation::Flat { depth };
            let foundation = EnclosedFoundation::on(&flat, LENGTH);
            reactions(&EnclosedScene { foundation, load: &pieces, stiffness: STIFFNESS, length: LENGTH }, pair)
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
        // Sixteen parts a piece; in each the least clearance has to be more than SHARE times its far end times the length.
        check(&pair, 0.4, [9.0 * 7.0 / 16.0, 5.0 * 13.0 / 16.0]);

        let mut lying = pair;
        lying.pieces[0].follows = true;
        let [left, right] = over(&lying, 0.4);
        assert!(
            left.is_none() && right.is_some(),
            "where the beam lies on the ground beside a support, nothing is known"
        );
    }
}
