//! Witnesses that are wrong on purpose, above level ground on which a uniform load makes any beam follow the ground at the depth `d + q/k`.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::contact_node::EnclosedSupport;
use crate::certificate::kernel::distance::{anywhere, factor, on_part};
use crate::certificate::kernel::reference::Line;
use crate::certificate::quantities::energy;
use crate::scene::{Balance, Beam, CoupleLoad, Foundation, Load, Scene};

mod couples;

const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
const DEPTH: f64 = 0.4;
const GROUND: f64 = 40.0;
const SUNK: f64 = LOAD / GROUND;

/// Numbers between −1 and 1.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        // Knuth's constants for 64 bits.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let high = u32::try_from(self.0 >> 32).unwrap_or_default();
        f64::from(high) / f64::from(u32::MAX) * 2.0 - 1.0
    }
}

/// A support `(place, whether the beam is built in)` at the depth that the beam has there anyway, so that it exerts no force.
type Idle = (f64, bool);

/// A beam of a length with such supports, which a scene file has to have above the ground.
fn enclosed<R>(length: f64, supports: &[Idle], act: impl FnOnce(&EnclosedScene<'_>) -> R) -> R {
    turned(length, supports, None, act)
}

/// The same with a couple.
fn turned<R>(
    length: f64,
    supports: &[Idle],
    couple: Option<CoupleLoad>,
    act: impl FnOnce(&EnclosedScene<'_>) -> R,
) -> R {
    let beam = Beam::new(length, STIFFNESS).and_then(|beam| beam.with_supports(Vec::new())).expect("a beam");
    let load = Load::uniform_on(&beam, LOAD).and_then(|load| load.with_couples(&beam, couple.into_iter().collect()));
    let load = load.expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: DEPTH })).expect("well posed");
    let support = |&(x, built_in): &Idle| EnclosedSupport {
        x,
        deflection: Interval::exact(DEPTH + SUNK),
        slope: built_in.then_some(Interval::ZERO),
        at_level: [false; 2],
        tangent: [false; 2],
        is_fixed: built_in,
        gives: None,
    };
    let supports: Vec<_> = supports.iter().map(support).collect();
    in_intervals(&scene, Balance::Held, |enclosed| {
        let ground = [([0.0, length], GROUND)];
        act(&EnclosedScene { supports: &supports, ground: &ground, ..*enclosed })
    })
}

/// Pressed stretches between places. What they say is off by up to so much of the true penetration.
fn witness(places: &[f64], off: f64, random: &mut Noise) -> Vec<Stretch> {
    let mut noise = || SUNK * off * random.next();
    let stretches = places.windows(2).map(|w| {
        let sunk = vec![SUNK + noise(), noise(), noise()];
        let ends = [0, 1].map(|_| [SUNK + noise(), noise(), noise(), noise()]);
        Stretch { from: w[0], to: w[1], sunk, ends }
    });
    stretches.collect()
}

/// `J* = −q d l − q² l/2k`.
fn least_energy(length: f64) -> f64 {
    -LOAD * DEPTH * length - 0.5 * LOAD * SUNK * length
}

/// What beams are held by, and where stretches meet: runs of short ones inside, at free ends, at supports, and between two supports that are
/// next to each other.
fn cases() -> Vec<(&'static [Idle], Vec<f64>)> {
    let inside = vec![0.0, 2.5, 4.0, 4.0 + 1e-7, 4.0 + 2e-6, 6.0, 7.5, 10.0];
    let at_ends = vec![0.0, 1e-9, 1e-6, 3.0, 5.0, 7.0, 10.0 - 1e-8, 10.0];
    let near = vec![0.0, 2.0, 4.0 - 1e-8, 4.0, 4.0 + 3e-7, 7.0, 10.0];
    let ulp = vec![0.0, 2.0, 4.0, 4.0_f64.next_up(), 6.0, 8.0, 10.0];
    let two = vec![0.0, 2.0, 4.0 - 1e-4, 4.0, 4.0 + 1e-4, 7.0, 10.0];
    vec![
        (&[], inside.clone()),
        (&[], ulp),
        (&[], at_ends.clone()),
        (&[(0.0, false), (10.0, true)], at_ends),
        (&[(4.0, false)], near.clone()),
        (&[(4.0, true)], near),
        (&[(0.0, true), (10.0, false)], inside),
        (&[(4.0, false), (4.0 + 1e-4, false)], two),
    ]
}

/// Whatever a witness says, `v̂` and its slope are continuous and satisfy the supports, and its energy is not less than `J*` and not more
/// than `J*` and the gap.
#[test]
fn a_wrong_witness_makes_a_pair() {
    /// Energies are sums of some dozens of roundings.
    const ROUNDING: f64 = 1e-12;
    let (mut random, mut found) = (Noise(7), 0);
    for (supports, places) in cases() {
        for off in [0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.3].repeat(20) {
            let witness = witness(&places, off, &mut random);
            enclosed(10.0, supports, |enclosed| {
                let Some(pair) = pair(enclosed, &witness) else { return };
                found += 1;
                for w in pair.pieces.windows(2) {
                    let width = Interval::length(w[0].from, w[0].to);
                    for (left, right) in [(w[0].v, w[1].v), (w[0].v.derivative(), w[1].v.derivative())] {
                        let jump = right.at(Interval::ZERO) - left.at(width);
                        assert!(jump.lo() <= 0.0 && 0.0 <= jump.hi(), "{supports:?}, {off}: {jump:?} at {}", w[1].from);
                    }
                }
                for (at, _) in supports {
                    let piece = pair.pieces.iter().find(|piece| *at <= piece.to).expect("a piece");
                    let v = piece.v.at(Interval::length(piece.from, *at)) - Interval::exact(DEPTH + SUNK);
                    assert!(v.lo() <= ROUNDING && -ROUNDING <= v.hi(), "{supports:?}, {off}: {v:?} at {at}");
                }
                let energy = energy(&pair.pieces, enclosed) + pair.ground.as_ref().expect("of springs").energy;
                let (least, rounding) = (least_energy(10.0), ROUNDING * least_energy(10.0).abs());
                assert!(least - rounding <= energy.hi(), "{supports:?}, {off}: {energy:?} for {least}");
                assert!(
                    energy.lo() <= least + pair.gap + rounding,
                    "{supports:?}, {off}: {energy:?} for {:e}",
                    pair.gap
                );
                let most = anywhere(&pair, STIFFNESS, 10.0) + ROUNDING;
                for piece in &pair.pieces {
                    let off = piece.v.at(Interval::ZERO) - Interval::exact(DEPTH + SUNK);
                    assert!(off.lo() <= most && -most <= off.hi(), "{supports:?}: {off:?} for {most:e}");
                }
            });
        }
    }
    assert!(600 < found, "only {found} witnesses prove anything");
}

/// Where the witness is right but for rounding, a stretch of a billionth of the beam costs nothing. A cubic between its two ends would have a
/// curvature of `1e-16/1e-18`.
#[test]
fn a_short_stretch_costs_nothing() {
    // Between two supports the slope of the beam is a quotient.
    for (supports, places) in
        cases().into_iter().filter(|(supports, _)| !supports.iter().any(|s| 4.0 < s.0 && s.0 < 5.0))
    {
        let witness = witness(&places, 4.0 * f64::EPSILON, &mut Noise(3));
        let gap = enclosed(10.0, supports, |enclosed| Some(pair(enclosed, &witness)?.gap));
        assert!(gap.is_some_and(|gap| gap <= 1e-20), "{supports:?}, {places:?}: {gap:?}");
    }
}

/// A long beam without supports: the bound by groups is true on each part, and a thousand times sharper than the one by two places.
#[test]
fn groups_of_parts_hold_a_long_beam() {
    const LENGTH: f64 = 2000.0;
    let places: Vec<f64> = (0..=4000).map(|i| 0.5 * f64::from(i)).collect();
    let mut random = Noise(11);
    for off in [1e-12, 1e-9, 1e-6, 1e-4, 1e-2] {
        let witness = witness(&places, off, &mut random);
        enclosed(LENGTH, &[], |enclosed| {
            let Some(mut pair) = pair(enclosed, &witness) else {
                assert!(1e-5 < off, "{off:e}: no pair");
                return;
            };
            let factor = factor(pair.gap, STIFFNESS);
            let error = |piece: &Piece| (piece.v.at(Interval::ZERO) - Interval::exact(DEPTH + SUNK)).magnitude();
            for Line(a, b) in &pair.zones {
                for Datum { from, to, uncertainty, .. } in [a, b] {
                    let inside = pair.pieces.iter().filter(|piece| *from <= piece.from && piece.to <= *to);
                    let least = inside.map(error).fold(f64::INFINITY, f64::min);
                    assert!(least <= uncertainty + 1e-12, "{off:e}: {least:e} for {uncertainty:e} in {from} to {to}");
                }
            }
            for piece in &pair.pieces {
                let most = on_part(&pair, factor, [piece.from, piece.to]) + 1e-12;
                assert!(error(piece) <= most, "{off:e}: {:e} for {most:e} at {}", error(piece), piece.from);
            }
            let by_groups = anywhere(&pair, STIFFNESS, LENGTH);
            pair.zones.clear();
            let by_two = anywhere(&pair, STIFFNESS, LENGTH);
            assert!(off > 1e-5 || 1e3 * by_groups < by_two, "{off:e}: {by_groups:e} for {by_two:e}");
        });
    }
}
